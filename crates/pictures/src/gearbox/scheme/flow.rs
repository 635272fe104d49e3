//! The power in each piece of a link's shafts, drums and webs.
//!
//! A link of a layout is a tree of straight pieces between the places of its gears, shift elements and shaft
//! ends. The power that passes a piece is therefore the power that enters the link on one side of it,
//! `Σ T·ω`.

use super::halves;
use epicyclic_layout::Layout;
use epicyclic_layout::layout::Point;
use epicyclic_train::drawn::DrawnPower;
use epicyclic_train::{Analysis, Gearbox, LinkId, LoadCase};

/// A piece of a link between two places of interest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub(super) link: LinkId,
    pub(super) from: Point,
    pub(super) to: Point,
    /// Power from `from` to `to` over what enters; `None` where it does not follow.
    pub(super) power: Option<f64>,
    /// The part of it that circulates.
    pub(super) circulating: f64,
}

/// Power that enters a link at a place, and the part of it that circulates.
struct Entry {
    link: LinkId,
    at: Point,
    power: Option<f64>,
    circulating: f64,
}

/// The first of the links that are one piece with a link for ever.
pub(in crate::gearbox) fn piece_of(gearbox: &Gearbox, link: LinkId) -> LinkId {
    let mut found = vec![link];
    let mut next = 0;
    while let Some(&link) = found.get(next) {
        for pair in gearbox.permanent() {
            for [one, other] in [*pair, [pair[1], pair[0]]] {
                if one == link && !found.contains(&other) {
                    found.push(other);
                }
            }
        }
        next += 1;
    }
    found.into_iter().min().unwrap_or(link)
}

/// Pieces of all links but the housing; without a load their powers are `None`.
pub(super) fn pieces(
    gearbox: &Gearbox,
    layout: &Layout,
    load: Option<(&Analysis<'_>, &LoadCase)>,
) -> Vec<Piece> {
    let entries = entries(gearbox, layout, load);
    let mut all = vec![];
    for shape in layout.links.iter().filter(|shape| shape.link != LinkId::GROUND) {
        let own: Vec<&Entry> = entries.iter().filter(|entry| entry.link == shape.link).collect();
        let ends = shape.segments.iter().flat_map(|segment| [segment.from, segment.to]);
        let mut places: Vec<Point> = vec![];
        for place in ends.chain(own.iter().map(|entry| entry.at)) {
            if !places.contains(&place) {
                places.push(place);
            }
        }
        let mut edges: Vec<[usize; 2]> = vec![];
        for segment in &shape.segments {
            let along = |p: &Point| (p.x - segment.from.x) + (p.y - segment.from.y);
            let on = |p: &Point| {
                (segment.from.x..=segment.to.x).contains(&p.x)
                    && (segment.from.y..=segment.to.y).contains(&p.y)
            };
            let mut here: Vec<usize> = (0..places.len()).filter(|&place| on(&places[place])).collect();
            here.sort_by(|a, b| along(&places[*a]).total_cmp(&along(&places[*b])));
            edges.extend(here.windows(2).map(|pair| [pair[0], pair[1]]));
        }
        let at_place = |place: &Point| own.iter().filter(|entry| entry.at == *place).copied().collect();
        let entering: Vec<Vec<&Entry>> = places.iter().map(at_place).collect();
        for (place, edge) in edges.iter().enumerate() {
            let behind = behind(&edges, place, places.len());
            let (power, circulating) = match (&behind, load) {
                (Some(behind), Some(_)) => passed(&entering, behind),
                _ => (None, 0.0),
            };
            let [from, to] = edge.map(|end| places[end]);
            all.push(Piece { link: shape.link, from, to, power, circulating });
        }
    }
    all
}

/// Whether each place lies on the near side of a piece; `None` where both sides are also joined elsewhere.
fn behind(edges: &[[usize; 2]], without: usize, places: usize) -> Option<Vec<bool>> {
    let [start, far] = edges[without];
    let mut inside = vec![false; places];
    let mut waiting = vec![start];
    while let Some(place) = waiting.pop() {
        if std::mem::replace(&mut inside[place], true) {
            continue;
        }
        for (_, [a, b]) in edges.iter().enumerate().filter(|(edge, _)| *edge != without) {
            if *a == place {
                waiting.push(*b);
            } else if *b == place {
                waiting.push(*a);
            }
        }
    }
    (!inside[far]).then_some(inside)
}

/// Power that passes from the places behind to the others: the power that enters behind. Where that is not
/// known, it is the negative of the power that enters on the other side.
fn passed(entering: &[Vec<&Entry>], behind: &[bool]) -> (Option<f64>, f64) {
    let side = |wanted: bool| {
        let entries = entering.iter().zip(behind).filter(move |(_, is)| **is == wanted);
        entries.flat_map(|(entries, _)| entries.iter().map(|entry| entry.power)).sum::<Option<f64>>()
    };
    let power = side(true).or_else(|| side(false).map(|power| -power));
    let round = entering.iter().zip(behind).filter(|(_, is)| **is);
    (power, round.flat_map(|(entries, _)| entries.iter().map(|entry| entry.circulating)).sum())
}

fn entries(gearbox: &Gearbox, layout: &Layout, load: Option<(&Analysis<'_>, &LoadCase)>) -> Vec<Entry> {
    let mut entries = vec![];
    let pairs = halves::pairs(gearbox, layout);
    let of_set = |set: usize| load.and_then(|(gear, case)| gear.drawn_power(case, set));
    for stack in &layout.sets {
        for (member, y) in [stack.sun, stack.ring, stack.planet].into_iter().enumerate() {
            // The common part of two halves of one set passes on the power of the whole, at one of its two
            // places.
            let of: Vec<usize> = match pairs.iter().find_map(|pair| pair.hands_on(stack.set, member)) {
                Some(sets) => sets,
                None => vec![stack.set],
            };
            let powers: Option<Vec<_>> = of.into_iter().map(of_set).collect();
            let sum = |of: fn(&DrawnPower, usize) -> f64| {
                powers.as_ref().map(|powers| powers.iter().map(|power| of(power, member)).sum::<f64>())
            };
            entries.push(Entry {
                link: stack.members[member],
                at: Point { x: stack.x, y },
                power: sum(|power, member| -power.members[member]),
                circulating: sum(|power, member| -power.circulating[member]).unwrap_or(0.0),
            });
        }
    }
    for mark in &layout.clutches {
        let first =
            gearbox.shift_elements().get(mark.shift_element).map(|shift_element| shift_element.links()[0]);
        let first = first.map(|link| piece_of(gearbox, link));
        let power =
            load.and_then(|(gear, case)| shift_element_power(gearbox, gear, case, mark.shift_element));
        let round = load.map(|(_, case)| case.power.circulating_shift_element(mark.shift_element));
        for (link, at) in [mark.lower, mark.upper] {
            let sign = if Some(link) == first { 1.0 } else { -1.0 };
            let circulating = sign * round.unwrap_or(0.0);
            entries.push(Entry { link, at, power: power.map(|power| sign * power), circulating });
        }
    }
    for mark in &layout.brakes {
        entries.push(Entry { link: mark.link, at: mark.link_end, power: Some(0.0), circulating: 0.0 });
    }
    let shafts = [layout.input, layout.output];
    for shaft in shafts.iter().chain(&layout.take_offs) {
        let power = load.map(|(gear, case)| {
            let ends = [(gear.gear().input(), case.input), (gear.gear().output(), case.output)];
            let here = ends.iter().filter(|(link, _)| piece_of(gearbox, *link) == shaft.link);
            here.map(|(link, torque)| gear.speed(*link).map(|speed| speed * torque)).sum::<Option<f64>>()
        });
        entries.push(Entry { link: shaft.link, at: shaft.at, power: power.flatten(), circulating: 0.0 });
    }
    entries
}

/// Power that a shift element gives to its first link.
pub(super) fn shift_element_power(
    gearbox: &Gearbox,
    gear: &Analysis,
    case: &LoadCase,
    shift_element: usize,
) -> Option<f64> {
    let torque = (*case.shift_elements.get(shift_element)?)?;
    if torque == 0.0 {
        return Some(0.0);
    }
    Some(torque * gear.speed(gearbox.shift_elements()[shift_element].links()[0])?)
}
