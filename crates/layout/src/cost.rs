//! Cost of a drawing: a measure of how hard it is to read.

use super::layout::{Layout, Point, SetStack};
use super::scheme::Scheme;
use epicyclic_train::{Gearbox, LinkId};

/// A corner, over a unit of length.
pub(super) const BEND: f64 = 6.0;
/// A wall of the housing between sets.
pub(super) const WALL: f64 = 24.0;
/// Two sets against the order of the power.
pub(super) const BACKWARDS: f64 = 1.5;
/// A further band of sets costs more than all else.
const BAND: f64 = 1e4;

/// Cost of a drawing by its bends, walls, length and order; see [`Layout::cost`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Number of different heights of planets.
    pub bands: usize,
    /// Ends of level lines of links where the link turns: all but shaft ends and planet pins.
    pub bends: usize,
    /// Upright walls of the housing.
    pub walls: usize,
    /// Length of all lines of links, in grid units.
    pub length: f64,
    /// Pairs of sets in which the one nearer to the output is on the left.
    pub backwards: usize,
}

impl Cost {
    /// Weighted sum of the costs: 10⁴ for each band more than the first, 6 for a corner, 24 for a wall, 1 for
    /// a unit of length. A pair of sets against the order of the power counts 1.5.
    #[must_use]
    pub fn total(&self) -> f64 {
        let many = |count: usize, each: f64| count as f64 * each;
        many(self.bands.saturating_sub(1), BAND)
            + many(self.bends, BEND)
            + many(self.walls, WALL)
            + self.length
            + many(self.backwards, BACKWARDS)
    }
}

impl Layout {
    /// Cost of the drawing. [`draw`](super::draw) searches for the fewest bands and then for the least
    ///
    /// ```text
    /// 6·bends + 24·walls + length + 1.5·backwards
    /// ```
    ///
    /// A crossing is never allowed. A set is nearer to the output than another if fewer sets and shift
    /// elements lie between its links and the output, and more between its links and the input.
    #[must_use]
    pub fn cost(&self, gearbox: &Gearbox) -> Cost {
        let mut heights: Vec<f64> = self.sets.iter().map(|stack| stack.planet).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup();
        let is_pin = |link: LinkId, at: Point| {
            self.sets.iter().any(|stack| stack.members[2] == link && stack.planet == at.y && stack.x == at.x)
        };
        let is_end = |link: LinkId, at: Point| {
            [self.input, self.output].iter().any(|end| end.link == link && end.at == at)
        };
        let (mut bends, mut walls, mut length) = (0, 0, 0.0);
        for shape in &self.links {
            for segment in &shape.segments {
                length += (segment.to.x - segment.from.x) + (segment.to.y - segment.from.y);
                if segment.from.y == segment.to.y {
                    let ends = [segment.from, segment.to].into_iter();
                    bends += ends.filter(|&at| !is_pin(shape.link, at) && !is_end(shape.link, at)).count();
                } else if shape.link == LinkId::GROUND {
                    walls += 1;
                }
            }
        }
        let stages = Scheme::new(gearbox, &[]).stages();
        let stage = |stack: &SetStack| {
            let set = gearbox.drawn_sets()[stack.set].set;
            (stages[set], set)
        };
        let pairs = self.sets.iter().flat_map(|a| self.sets.iter().map(move |b| (a, b)));
        let backwards = pairs.filter(|(a, b)| stage(a) < stage(b) && a.x > b.x).count();
        Cost { bands: heights.len(), bends, walls, length, backwards }
    }
}

#[cfg(test)]
mod tests {
    use super::Cost;

    /// A second band, 3 corners, a wall, 4.5 units of lines and two pairs of sets against the power.
    #[test]
    fn the_total_is_the_stated_sum() {
        let cost = Cost { bands: 2, bends: 3, walls: 1, length: 4.5, backwards: 2 };
        assert_eq!(cost.total(), 1e4 + 6.0 * 3.0 + 24.0 + 4.5 + 1.5 * 2.0);
        let one_band = Cost { bands: 1, bends: 99, walls: 9, length: 999.0, backwards: 9 };
        assert!(one_band.total() < cost.total());
    }
}
