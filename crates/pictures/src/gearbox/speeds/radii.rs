//! Radii of a set's gears, and the lines of its links and planets over them.

use epicyclic_train::drawn::DrawnSet;
use epicyclic_train::set::SetKind;
use epicyclic_train::{Analysis, Gearbox, LinkId};

/// A line of the diagram between two points `[radius, velocity]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    pub(super) name: String,
    /// Its link; none of a planet.
    pub(super) link: Option<LinkId>,
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    /// Whether a planet's speed is its real one.
    pub(super) has_ray: bool,
}

/// What is drawn of a set, radii in units of central gear 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SpeedDiagram {
    pub(super) lines: Vec<Line>,
    /// Radii with their names.
    pub(super) levels: Vec<(String, f64)>,
    /// Central gears and planets from radius to radius, for the picture beside the diagram.
    pub(super) toothed_gears: Vec<[f64; 2]>,
    pub(super) planet_pins: Vec<f64>,
    /// The largest radius.
    pub(super) height: f64,
}

/// Radii of central gears 1 and 2, and of the planet pins.
#[derive(Debug, Clone, PartialEq)]
struct Radii {
    central_gears: [f64; 2],
    planet_pins: Vec<f64>,
}

/// `None` for the planet pins' radii where the set's kind or missing teeth leave them open.
fn radii(gearbox: &Gearbox, set: &DrawnSet) -> Radii {
    let size = set.basic_ratio(gearbox).abs();
    match set.kind {
        SetKind::Simple => Radii { central_gears: [1.0, size], planet_pins: vec![0.5 * (1.0 + size)] },
        // One beside the other, of equal sizes: a quarter and three quarters of the way.
        SetKind::DoublePlanet => {
            let planet_pins = [0.25, 0.75].map(|part| 1.0 + part * (size - 1.0));
            Radii { central_gears: [1.0, size], planet_pins: planet_pins.to_vec() }
        }
        kind if kind.is_stepped() => {
            stepped(gearbox, set).unwrap_or(Radii { central_gears: [1.0, size], planet_pins: vec![] })
        }
        _ => Radii { central_gears: [1.0, size], planet_pins: vec![] },
    }
}

/// Radii of a stepped set: its planet pin lies at `r_1·(1 ± z_g/z_1)` and at `r_2·(1 ± z_f/z_2)`, `+` outside a sun, `−` inside a ring.
fn stepped(gearbox: &Gearbox, set: &DrawnSet) -> Option<Radii> {
    let [first, second] = set.teeth(gearbox)?;
    let [g, f] = set.planet_teeth(gearbox);
    let (g, f) = (g?.as_f64(), f?.as_f64());
    let [outside_first, outside_second] = match set.kind {
        SetKind::SteppedSunRing => [1.0, -1.0],
        SetKind::SteppedSuns => [1.0, 1.0],
        _ => [-1.0, -1.0],
    };
    let planet_pin = 1.0 + outside_first * g / first.as_f64();
    let second_radius = planet_pin / (1.0 + outside_second * f / second.as_f64());
    (planet_pin > 0.0 && second_radius > 0.0)
        .then(|| Radii { central_gears: [1.0, second_radius], planet_pins: vec![planet_pin] })
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
        let Radii { central_gears: [first, second], planet_pins } = radii(gearbox, drawn);
        let carrier = planet_pins.iter().copied().fold(0.0, f64::max);
        let carrier = if carrier > 0.0 { carrier } else { first.max(second) };
        let line = |member: usize, letter: &str, radius: f64| Line {
            name: format!("{letter}{number}"),
            link: Some(members[member]),
            from: [0.0, 0.0],
            to: [radius, speeds[member] * radius],
            has_ray: true,
        };
        let mut lines = vec![line(0, "a", first), line(1, "b", second), line(2, "H", carrier)];
        let mut levels = vec![(format!("a{number}"), first), (format!("b{number}"), second)];
        let planet = |name: String, ends: [[f64; 2]; 2], has_ray: bool| Line {
            name,
            link: None,
            from: ends[0],
            to: ends[1],
            has_ray,
        };
        let on = |member: usize, radius: f64| [radius, speeds[member] * radius];
        match planet_pins[..] {
            [planet_pin] => {
                // Through the planet pin and both contacts, whatever their order.
                let mut points = [on(0, first), on(1, second), on(2, planet_pin)];
                points.sort_by(|a, b| a[0].total_cmp(&b[0]));
                lines.push(planet(format!("g{number}"), [points[0], points[2]], true));
                levels.push((format!("H{number}"), planet_pin));
            }
            [one, other] => {
                let contact = f64::midpoint(first, second);
                // Velocity of the contact between the planets, from the one and its planet pin.
                let v = 2.0 * speeds[2] * one - speeds[0] * first;
                lines.push(planet(format!("g{number}"), [on(0, first), [contact, v]], false));
                lines.push(planet(format!("f{number}"), [[contact, v], on(1, second)], false));
                levels.extend([(format!("g{number}"), one), (format!("f{number}"), other)]);
            }
            _ => {}
        }
        let toothed_gears = match (kind, &planet_pins[..]) {
            (SetKind::Simple, _) => vec![[0.0, first], [first, second]],
            (SetKind::DoublePlanet, _) => {
                let contact = f64::midpoint(first, second);
                vec![[0.0, first], [first, contact], [contact, second]]
            }
            _ => vec![],
        };
        let drawn_pins = if toothed_gears.is_empty() { vec![] } else { planet_pins.clone() };
        let height = planet_pins.iter().copied().fold(first.max(second), f64::max);
        Self { lines, levels, toothed_gears, planet_pins: drawn_pins, height }
    }

    /// A pair: central gear 1 about the axis, central gear 2 about its own at `1 + k` outside or `k − 1` below inside; both meet at 1.
    fn of_pair(gearbox: &Gearbox, set: usize, speeds: [f64; 2]) -> Self {
        let number = set + 1;
        let drawn = &gearbox.drawn_sets()[set];
        let members = drawn.links;
        let size = drawn.basic_ratio(gearbox).abs();
        let outside = drawn.kind == SetKind::ExternalPair;
        // Central gear 1 inside a ring stands above the ring's axis.
        let (first, second) =
            if outside { (0.0, 1.0 + size) } else { ((size - 1.0).max(0.0), (1.0 - size).max(0.0)) };
        let contact = first + 1.0;
        let line = |member: usize, letter: &str, axis: f64| Line {
            name: format!("{letter}{number}"),
            link: Some(members[member]),
            from: [axis, 0.0],
            to: [contact, speeds[member] * (contact - axis)],
            has_ray: true,
        };
        let name = |letter: &str| format!("axis {letter}{number}");
        Self {
            lines: vec![line(0, "a", first), line(1, "b", second)],
            levels: vec![(name("a"), first), ("contact".into(), contact), (name("b"), second)],
            toothed_gears: if outside { vec![[first, contact], [contact, second]] } else { vec![] },
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

    /// The planet's line, drawn through the central gears' velocities, has the slope that the mechanics gives; the planet pin lies on it.
    #[test]
    fn a_planets_slope_is_its_speed() {
        for (kind, teeth) in [
            (SetKind::Simple, [20, 70, 25, 0]),
            (SetKind::SteppedSunRing, [20, 80, 30, 18]),
            (SetKind::SteppedSuns, [30, 24, 20, 26]),
            (SetKind::SteppedRings, [90, 80, 25, 22]),
        ] {
            let gearbox = gearbox(kind, teeth);
            let gear = gearbox.analyze("1").unwrap();
            let diagram = SpeedDiagram::of(&gearbox, &gear, 0);
            let planet = diagram.lines.iter().find(|line| line.link.is_none()).unwrap();
            let [[r, v], [further, faster]] = [planet.from, planet.to];
            let slope = (faster - v) / (further - r);
            let speed = gear.sets()[0].planets[0].unwrap().speed.unwrap();
            assert!((slope - speed).abs() < 1e-9, "{kind}: {slope} {speed}");
            let carrier = diagram.lines.iter().find(|line| line.name == "H1").unwrap();
            let on_line = v + slope * (carrier.to[0] - r);
            assert!((on_line - carrier.to[1]).abs() < 1e-9, "{kind}");
        }
    }

    /// Both planets of a pair in mesh have one velocity where they touch, and their planet pins lie on their lines.
    #[test]
    fn planets_in_mesh_agree_where_they_touch() {
        let gearbox = gearbox(SetKind::DoublePlanet, [30, 72, 16, 18]);
        let gear = gearbox.analyze("1").unwrap();
        let diagram = SpeedDiagram::of(&gearbox, &gear, 0);
        let carrier = gear.speed(gearbox.link("B").unwrap()).unwrap();
        let planets: Vec<&Line> = diagram.lines.iter().filter(|line| line.link.is_none()).collect();
        assert_eq!(planets[0].to, planets[1].from);
        for (line, planet_pin) in planets.iter().zip(&diagram.planet_pins) {
            let middle = f64::midpoint(line.from[1], line.to[1]);
            assert!((middle - carrier * planet_pin).abs() < 1e-9);
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
