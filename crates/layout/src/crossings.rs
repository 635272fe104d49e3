//! The check of a layout: every pair of straight lines, whatever made them.

use super::layout::{Layout, Point, Segment};
use epicyclic_train::LinkId;

/// Piece to which a line of a layout belongs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Line {
    /// A shaft, drum or web of a link.
    Link(LinkId),
    /// Central gear 1 (0), central gear 2 (1) or planet (2) of a set.
    Gear {
        /// Place of the set in the gearbox.
        set: usize,
        /// Index of the gear or planet in the set.
        member: usize,
    },
    /// The axis, crossed by a line below it or by a link on it that is no shaft end.
    Axis,
    /// The wall of the housing, touched or crossed.
    Housing,
}

/// Two lines of different pieces that meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The lines.
    pub lines: [Line; 2],
    /// A point they share.
    pub at: Point,
}

impl Layout {
    /// Lines of different links that meet, however little; empty for every layout returned by
    /// [`draw`](super::draw).
    ///
    /// Compared are all pairs of shafts, drums, webs, central gears and planets; central gears meet planets
    /// of their own set in the contact alone. Nothing may lie below the axis or reach beyond the housing, and
    /// only the links of input and output may touch the axis.
    #[must_use]
    pub fn crossings(&self) -> Vec<Crossing> {
        let lines = self.lines();
        let mut found = vec![];
        for (place, (line, link, segment)) in lines.iter().enumerate() {
            let (low, high) = (segment.from, segment.to);
            let shaft = [self.input.link, self.output.link].contains(link);
            if low.y < self.axis.from.y || (low.y == self.axis.from.y && !shaft) {
                found.push(Crossing { lines: [*line, Line::Axis], at: low });
            }
            let wall = self.housing.from.y;
            if high.y > wall || (high.y == wall && *link != LinkId::GROUND) {
                found.push(Crossing { lines: [*line, Line::Housing], at: high });
            }
            for (other, other_link, other_segment) in &lines[place + 1..] {
                let Some(at) = shared(segment, other_segment) else { continue };
                if link != other_link && !self.mesh(*line, *other, at) {
                    found.push(Crossing { lines: [*line, *other], at });
                }
            }
        }
        found
    }

    /// Every line with the link it turns with.
    fn lines(&self) -> Vec<(Line, LinkId, Segment)> {
        let links = self.links.iter().flat_map(|shape| {
            shape.segments.iter().map(|segment| (Line::Link(shape.link), shape.link, *segment))
        });
        let gears = self.sets.iter().flat_map(|stack| {
            let spans = [
                (stack.sun, stack.sun_mesh),
                (stack.ring_mesh, stack.ring),
                (stack.sun_mesh, stack.ring_mesh),
            ];
            [0, 1, 2].map(|member| {
                let (from, to) = spans[member];
                let at = |y| Point { x: stack.x, y };
                let line = Line::Gear { set: stack.set, member };
                (line, stack.members[member], Segment { from: at(from), to: at(to) })
            })
        });
        links.chain(gears).collect()
    }

    /// Whether two lines are gears in contact where they should be.
    fn mesh(&self, first: Line, second: Line, at: Point) -> bool {
        let (Line::Gear { set, member: a }, Line::Gear { set: other, member: b }) = (first, second) else {
            return false;
        };
        let Some(stack) = self.sets.iter().find(|stack| stack.set == set) else { return false };
        set == other
            && match (a.min(b), a.max(b)) {
                (0, 2) => at.y == stack.sun_mesh,
                (1, 2) => at.y == stack.ring_mesh,
                _ => false,
            }
    }
}

/// A point two lines share. All lines are parallel or at right angles to the axis, so it is enough
/// that their boxes meet.
fn shared(first: &Segment, second: &Segment) -> Option<Point> {
    let x = first.from.x.max(second.from.x);
    let y = first.from.y.max(second.from.y);
    (x <= first.to.x.min(second.to.x) && y <= first.to.y.min(second.to.y)).then_some(Point { x, y })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, Verdict, draw};

    #[test]
    fn a_line_moved_across_others_is_found() {
        let gearbox = crate::samples::scheme_one();
        let Verdict::Drawable(layout) = draw(&gearbox, Options::default()) else { panic!("I can be drawn") };
        let layout = *layout;
        assert_eq!(layout.crossings(), []);

        let brake = layout.brakes[0];
        let across = Segment {
            from: Point { x: layout.axis.from.x, y: brake.link_end.y },
            to: Point { x: layout.axis.to.x, y: brake.link_end.y },
        };
        let output = layout.links.iter().position(|shape| shape.link == layout.output.link).unwrap();
        let mut crossed = layout.clone();
        crossed.links[output].segments.push(across);
        let [crossing] = crossed.crossings()[..] else { panic!("one crossing: {:?}", crossed.crossings()) };
        assert!(crossing.lines.contains(&Line::Link(brake.link)));
        assert_eq!(crossing.at, brake.link_end);

        let mut sunk = layout.clone();
        sunk.links[output].segments[0].from.y = -1.0;
        assert!(sunk.crossings().iter().any(|crossing| crossing.lines.contains(&Line::Axis)));
        let mut raised = layout.clone();
        raised.links[output].segments[0].to.y = layout.housing.from.y;
        assert!(raised.crossings().iter().any(|crossing| crossing.lines.contains(&Line::Housing)));
    }
}
