//! A drawing in the half-plane: sets as stacks, links as straight lines, shift elements as short gaps.

use epicyclic_train::LinkId;

/// Half the gap of a clutch, and the whole gap of a brake, in grid units.
pub const GAP: f64 = 0.15;
/// Half the height of a planet in grid units.
pub const PLANET: f64 = 0.5;

/// A point of the half-plane: `x` along the axis to the right, `y` away from it, in grid units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Position along the axis.
    pub x: f64,
    /// Distance from the axis.
    pub y: f64,
}

/// A straight line, along the axis or at right angles to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Left or lower end.
    pub from: Point,
    /// Right or upper end.
    pub to: Point,
}

/// Everything that turns as one piece with a link.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkShape {
    /// The link; of permanently joined links the first. For the housing the lines are those that project from
    /// its wall.
    pub link: LinkId,
    /// Shafts, drums and webs. They meet at ends and in tees and never cross one another.
    pub segments: Vec<Segment>,
}

/// A set in section above the axis: first central gear, planet, second central gear upwards at one place.
///
/// For sets with a sun and a ring this is the picture itself. The central gears of the other kinds are
/// stacked in the same order, central gear 1, planet, central gear 2: see
/// [what is idealised](super#idealised).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetStack {
    /// Place of the set in [`Gearbox::drawn_sets`](epicyclic_train::Gearbox::drawn_sets).
    pub set: usize,
    /// Links of central gear 1, central gear 2 and carrier as they are drawn.
    pub members: [LinkId; 3],
    /// Place along the axis.
    pub x: f64,
    /// Shaft or web that carries central gear 1.
    pub sun: f64,
    /// Contact of central gear 1 and planet.
    pub sun_mesh: f64,
    /// The planet pin.
    pub planet: f64,
    /// Contact of planet and central gear 2.
    pub ring_mesh: f64,
    /// Drum or web that carries central gear 2.
    pub ring: f64,
}

/// A clutch: a gap between two links that it closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClutchMark {
    /// Index of the shift element in [`Gearbox::shift_elements`](epicyclic_train::Gearbox::shift_elements);
    /// higher numbers are additional direct-drive clutches.
    pub shift_element: usize,
    /// Link and its end below the gap.
    pub lower: (LinkId, Point),
    /// Link and its end above the gap.
    pub upper: (LinkId, Point),
}

/// A brake: a gap between a link and the housing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrakeMark {
    /// Place of the shift element in [`Gearbox::shift_elements`](epicyclic_train::Gearbox::shift_elements).
    pub shift_element: usize,
    /// The link it holds.
    pub link: LinkId,
    /// End of the link at the gap.
    pub link_end: Point,
    /// Point of the housing, or of its projection, across the gap.
    pub housing: Point,
}

/// Shaft end at which power enters or leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftEnd {
    /// The link.
    pub link: LinkId,
    /// Outer end of the shaft.
    pub at: Point,
}

/// A drawing of a gearbox without a crossing.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Sets, in their order in the gearbox.
    pub sets: Vec<SetStack>,
    /// Links that have anything to draw.
    pub links: Vec<LinkShape>,
    /// Clutches. One between links that are one piece anyway is not drawn.
    pub clutches: Vec<ClutchMark>,
    /// Brakes.
    pub brakes: Vec<BrakeMark>,
    /// Links where power enters or leaves in some gear only, led to the housing.
    pub take_offs: Vec<ShaftEnd>,
    /// Input end.
    pub input: ShaftEnd,
    /// Output end.
    pub output: ShaftEnd,
    /// The axis: `y = 0`, from the left end to the right.
    pub axis: Segment,
    /// Inner wall of the housing, parallel to the axis above everything.
    pub housing: Segment,
}

/// Segments by link, those on one line that touch made one.
pub(super) fn shapes(mut pieces: Vec<(LinkId, Segment)>) -> Vec<LinkShape> {
    let level = |s: &Segment| s.from.y == s.to.y;
    let key = |s: &Segment| if level(s) { [0.0, s.from.y, s.from.x] } else { [1.0, s.from.x, s.from.y] };
    pieces.sort_by(|(a, s), (b, t)| {
        let by = key(s).iter().zip(key(t)).map(|(p, q)| p.total_cmp(&q)).find(|o| o.is_ne());
        a.cmp(b).then(by.unwrap_or(std::cmp::Ordering::Equal))
    });
    let mut shapes: Vec<LinkShape> = vec![];
    for (link, segment) in pieces {
        if shapes.last().is_none_or(|shape| shape.link != link) {
            shapes.push(LinkShape { link, segments: vec![] });
        }
        let Some(shape) = shapes.last_mut() else { continue };
        if let Some(last) = shape.segments.last_mut()
            && level(last) == level(&segment)
        {
            let (same_line, touches) = if level(last) {
                (last.from.y == segment.from.y, segment.from.x <= last.to.x)
            } else {
                (last.from.x == segment.from.x, segment.from.y <= last.to.y)
            };
            if same_line && touches {
                last.to.x = last.to.x.max(segment.to.x);
                last.to.y = last.to.y.max(segment.to.y);
                continue;
            }
        }
        shape.segments.push(segment);
    }
    shapes
}
