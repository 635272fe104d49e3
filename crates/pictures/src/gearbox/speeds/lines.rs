//! The lines of a set's links and planets over the radii of its gears.

use crate::gearbox::radii::{Radii, radii};
use epicyclic_train::set::SetKind;
use epicyclic_train::{Analysis, Gearbox, LinkId};

/// A line of the diagram between two points `[radius, velocity]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    pub(super) name: String,
    /// Link of the line; `None` for a planet.
    pub(super) link: Option<LinkId>,
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    /// Whether the size of a planet is not given.
    pub(super) is_assumed: bool,
}

/// Diagram of a set, radii in units of central gear 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SpeedDiagram {
    pub(super) lines: Vec<Line>,
    /// Radii with their names.
    pub(super) levels: Vec<(String, f64)>,
    /// Central gears and planets from radius to radius, each in its section, for the picture beside the
    /// diagram.
    pub(super) toothed_gears: Vec<(usize, [f64; 2])>,
    pub(super) planet_pins: Vec<(usize, f64)>,
    /// The largest radius.
    pub(super) height: f64,
}

impl SpeedDiagram {
    /// The speed diagram of a set in a gear all of whose speeds are known.
    pub(super) fn of(gearbox: &Gearbox, gear: &Analysis, set: usize) -> Self {
        let number = set + 1;
        let drawn = &gearbox.drawn_sets()[set];
        let (members, kind) = (drawn.links, drawn.kind);
        let speeds = members.map(|link| gear.speed(link).unwrap_or(0.0));
        if kind.is_pair() {
            return Self::of_pair(gearbox, set, [speeds[0], speeds[1]]);
        }
        let Radii { central_gears: [first, second], planets } = radii(gearbox, drawn);
        let carrier = planets.iter().map(|planet| planet.pin).fold(0.0, f64::max);
        let carrier = if carrier > 0.0 { carrier } else { first.max(second) };
        let line = |member: usize, letter: &str, radius: f64| Line {
            name: format!("{letter}{number}"),
            link: Some(members[member]),
            from: [0.0, 0.0],
            to: [radius, speeds[member] * radius],
            is_assumed: false,
        };
        let mut lines = vec![line(0, "a", first), line(1, "b", second), line(2, "H", carrier)];
        let mut levels = vec![(format!("a{number}"), first), (format!("b{number}"), second)];
        for planet in &planets {
            let name = format!("{}{number}", planet.letter);
            let on = |(member, radius): (usize, f64)| [radius, speeds[member] * radius];
            let pin = on((2, planet.pin));
            let mut points: Vec<[f64; 2]> = planet.contacts.iter().flatten().copied().map(on).collect();
            if let [[radius, velocity]] = points[..] {
                // The far side, as far beyond the pin as the contact is before it.
                points.push([2.0 * pin[0] - radius, 2.0 * pin[1] - velocity]);
            }
            // Through the pin and both contacts, whatever their order.
            points.push(pin);
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            if let [from, _, to] = points[..] {
                let name = if planet.is_assumed { format!("{name}*") } else { name.clone() };
                lines.push(Line { name, link: None, from, to, is_assumed: planet.is_assumed });
            }
            levels.push((if planets.len() == 1 { format!("H{number}") } else { name }, planet.pin));
        }
        let (toothed_gears, planet_pins) = match (kind, &planets[..]) {
            (SetKind::Simple, [planet]) => {
                (vec![(0, [0.0, first]), (0, [first, second])], vec![(0, planet.pin)])
            }
            (SetKind::DoublePlanet, [g, f]) => {
                let inner = [first, 2.0 * g.pin - first];
                let outer = [2.0 * f.pin - second, second];
                let is_one_section = inner[1] <= outer[0];
                let section = usize::from(!is_one_section);
                (vec![(0, [0.0, first]), (0, inner), (section, outer)], vec![(0, g.pin), (section, f.pin)])
            }
            _ => (vec![], vec![]),
        };
        let ends = lines.iter().flat_map(|line| [line.from[0], line.to[0]]);
        let height = ends.fold(first.max(second), f64::max);
        Self { lines, levels, toothed_gears, planet_pins, height }
    }

    /// A pair: central gear 1 about the axis, central gear 2 about its own at `1 + k` outside or `k − 1`
    /// below inside; both meet at 1.
    fn of_pair(gearbox: &Gearbox, set: usize, speeds: [f64; 2]) -> Self {
        let number = set + 1;
        let drawn = &gearbox.drawn_sets()[set];
        let members = drawn.links;
        let size = drawn.basic_ratio(gearbox).abs();
        let outside = drawn.kind == SetKind::ExternalPair;
        // Central gear 1 inside a ring is above the ring's axis.
        let (first, second) =
            if outside { (0.0, 1.0 + size) } else { ((size - 1.0).max(0.0), (1.0 - size).max(0.0)) };
        let contact = first + 1.0;
        let line = |member: usize, letter: &str, axis: f64| Line {
            name: format!("{letter}{number}"),
            link: Some(members[member]),
            from: [axis, 0.0],
            to: [contact, speeds[member] * (contact - axis)],
            is_assumed: false,
        };
        let name = |letter: &str| format!("axis {letter}{number}");
        Self {
            lines: vec![line(0, "a", first), line(1, "b", second)],
            levels: vec![(name("a"), first), ("contact".into(), contact), (name("b"), second)],
            toothed_gears: if outside { vec![(0, [first, contact]), (0, [contact, second])] } else { vec![] },
            planet_pins: vec![],
            height: contact.max(second).max(first),
        }
    }

    /// The largest `|v|/height`: the widest point of a diagram drawn to one height.
    pub(super) fn widest(&self) -> f64 {
        let ends = self.lines.iter().flat_map(|line| [line.from, line.to]);
        ends.map(|[_, v]| v.abs() / self.height).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_gears::teeth::ToothCount;
    use epicyclic_train::set::SetSpec;

    /// A set of a kind between D, T1 and B, T1 held.
    fn gearbox(kind: SetKind, teeth: [u32; 4]) -> Gearbox {
        let [first, second, g, f] = teeth;
        let count = |z| ToothCount::new(z).unwrap();
        let set = SetSpec::teeth("1", kind, ["D", "T1", "B"], first, second).unwrap();
        let set = set.planet_teeth(count(g), (f > 0).then(|| count(f)));
        let builder = Gearbox::builder("one set").links(["D", "B", "T1"]).set(set).brake("K1", "T1");
        builder.input("D").output("B").gear("1", ["K1"]).build().unwrap()
    }

    /// The planet's line, drawn through the central gears' velocities, has the slope that the mechanics
    /// gives; the planet pin lies on it.
    #[test]
    fn a_planets_slope_is_its_speed() {
        for (kind, teeth) in [
            (SetKind::Simple, [20, 70, 25, 0]),
            (SetKind::SteppedSunRing, [20, 80, 30, 18]),
            (SetKind::SteppedSuns, [30, 24, 20, 26]),
            (SetKind::SteppedRings, [90, 80, 25, 22]),
            (SetKind::DoublePlanet, [30, 72, 16, 18]),
            (SetKind::MeshingSuns, [30, 24, 16, 18]),
        ] {
            let gearbox = gearbox(kind, teeth);
            let gear = gearbox.analyze("1").unwrap();
            let diagram = SpeedDiagram::of(&gearbox, &gear, 0);
            let planets: Vec<&Line> = diagram.lines.iter().filter(|line| line.link.is_none()).collect();
            let pins: Vec<f64> =
                radii(&gearbox, &gearbox.drawn_sets()[0]).planets.iter().map(|p| p.pin).collect();
            assert_eq!(planets.len(), gear.sets()[0].planets.len(), "{kind}");
            let carrier = gear.speed(gearbox.link("B").unwrap()).unwrap();
            for ((planet, pin), motion) in planets.iter().zip(pins).zip(&gear.sets()[0].planets) {
                let [[r, v], [further, faster]] = [planet.from, planet.to];
                let slope = (faster - v) / (further - r);
                let speed = motion.unwrap().speed.unwrap();
                assert!((slope - speed).abs() < 1e-9, "{kind}: {slope} {speed}");
                assert!(!planet.is_assumed, "{kind}");
                let on_line = v + slope * (pin - r);
                assert!((on_line - carrier * pin).abs() < 1e-9, "{kind}");
            }
        }
    }

    /// Of planets without teeth sizes are assumed that mesh: against the carrier they turn in opposite
    /// senses, as their sizes ask for.
    #[test]
    fn planets_of_assumed_size_are_marked_and_have_lines() {
        for kind in [
            SetKind::DoublePlanet,
            SetKind::MeshingSuns,
            SetKind::SteppedSunRing,
            SetKind::SteppedSuns,
            SetKind::SteppedRings,
        ] {
            let set = SetSpec::new("1", kind, ["D", "T1", "B"], 2.4);
            let builder = Gearbox::builder("one set").links(["D", "B", "T1"]).set(set).brake("K1", "T1");
            let gearbox = builder.input("D").output("B").gear("1", ["K1"]).build().unwrap();
            let gear = gearbox.analyze("1").unwrap();
            let diagram = SpeedDiagram::of(&gearbox, &gear, 0);
            let planets: Vec<&Line> = diagram.lines.iter().filter(|line| line.link.is_none()).collect();
            assert_eq!(planets.len(), if kind.is_stepped() { 1 } else { 2 }, "{kind}");
            assert!(planets.iter().all(|line| line.is_assumed && line.name.ends_with('*')), "{kind}");
            let carrier = gear.speed(gearbox.link("B").unwrap()).unwrap();
            // (ω − ω_H)·r of both, where they mesh.
            let rolls = planets.iter().map(|line| {
                let [[r, v], [further, faster]] = [line.from, line.to];
                0.5 * (faster - v - carrier * (further - r))
            });
            if !kind.is_stepped() {
                assert!(rolls.sum::<f64>().abs() < 1e-9, "{kind}");
            }
        }
    }

    /// The gears of a pair have one velocity in contact, outside each other and one in the other.
    #[test]
    fn a_pair_meets_in_its_contact() {
        for kind in [SetKind::ExternalPair, SetKind::InternalPair] {
            let set = SetSpec::teeth("1", kind, ["D", "B", "ground"], 20, 50).unwrap();
            let gearbox = Gearbox::builder("pair").links(["D", "B"]).set(set).input("D").output("B");
            let gearbox = gearbox.gear("1", [""; 0]).build().unwrap();
            let diagram = SpeedDiagram::of(&gearbox, &gearbox.analyze("1").unwrap(), 0);
            let [one, other] = [diagram.lines[0].to, diagram.lines[1].to];
            assert!((one[0] - other[0]).abs() < 1e-12 && (one[1] - other[1]).abs() < 1e-12, "{kind}");
        }
    }
}
