//! Radii of a set's gears, in units of central gear 1.

use epicyclic_train::Gearbox;
use epicyclic_train::drawn::DrawnSet;
use epicyclic_train::set::SetKind;

/// A planet in the section through its own pin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Planet {
    pub(super) letter: &'static str,
    /// Radius of the pin about the axis.
    pub(super) pin: f64,
    /// Member in mesh, its radius, and the planet's; the second of a planet with one mesh is its far side.
    pub(super) contacts: [Option<(usize, f64)>; 2],
    pub(super) is_assumed: bool,
}

/// Radii of central gears 1 and 2, and the planets, in units of central gear 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Radii {
    pub(super) central_gears: [f64; 2],
    pub(super) planets: Vec<Planet>,
}

/// No planets of a set whose planets turn about other axes.
pub(super) fn radii(gearbox: &Gearbox, set: &DrawnSet) -> Radii {
    let size = set.basic_ratio(gearbox).abs();
    let teeth = set.teeth(gearbox);
    let [g, f] = set.planet_teeth(gearbox).map(|z| Some(z?.as_f64() / teeth?[0].as_f64()));
    match set.kind {
        SetKind::Simple => {
            let contacts = [Some((0, 1.0)), Some((1, size))];
            let planet = Planet { letter: "g", pin: 0.5 * (1.0 + size), contacts, is_assumed: false };
            Radii { central_gears: [1.0, size], planets: vec![planet] }
        }
        SetKind::DoublePlanet => {
            let outwards = |pin: f64| (pin > 1.0).then_some(pin - 1.0);
            let inwards = |pin: f64| (pin < size).then_some(size - pin);
            // If one planet is given, the other gets the same pin radius. If none is given, both are equal,
            // one outside the other.
            let radius = [
                g.or_else(|| outwards(size - f?)).unwrap_or(0.25 * (size - 1.0)),
                f.or_else(|| inwards(1.0 + g?)).unwrap_or(0.25 * (size - 1.0)),
            ];
            meshing([1.0, size], [1.0 + radius[0], size - radius[1]], [g, f])
        }
        SetKind::MeshingSuns => {
            let usual = 0.5 * size.min(1.0);
            let radius = [g.or(f), f.or(g)].map(|radius| radius.unwrap_or(usual));
            meshing([1.0, size], [1.0 + radius[0], size + radius[1]], [g, f])
        }
        kind if kind.is_stepped() => stepped(gearbox, set, size),
        _ => Radii { central_gears: [1.0, size], planets: vec![] },
    }
}

/// Two planets in mesh, each with its central gear in its own section.
fn meshing(central_gears: [f64; 2], pins: [f64; 2], given: [Option<f64>; 2]) -> Radii {
    let planet = |member: usize, letter| Planet {
        letter,
        pin: pins[member],
        contacts: [Some((member, central_gears[member])), None],
        is_assumed: given[member].is_none(),
    };
    Radii { central_gears, planets: vec![planet(0, "g"), planet(1, "f")] }
}

/// Radii of a stepped set: its planet pin lies at `r_1·(1 ± z_g/z_1)` and at `r_2·(1 ± z_f/z_2)`, `+` outside
/// a sun, `−` inside a ring. Without teeth, steps are assumed that give the basic ratio
/// `i₀ = ±(z_g/z_1)·(z_2/z_f)`.
fn stepped(gearbox: &Gearbox, set: &DrawnSet, size: f64) -> Radii {
    let [outside_first, outside_second] = match set.kind {
        SetKind::SteppedSunRing => [1.0, -1.0],
        SetKind::SteppedSuns => [1.0, 1.0],
        _ => [-1.0, -1.0],
    };
    let given = || {
        let ([first, second], [g, f]) = (set.teeth(gearbox)?, set.planet_teeth(gearbox));
        Some([g?.as_f64() / first.as_f64(), f?.as_f64() / second.as_f64()])
    };
    let of = |[one, other]: [f64; 2]| {
        let pin = 1.0 + outside_first * one;
        let second = pin / (1.0 + outside_second * other);
        (pin > 0.0 && second > 0.0).then_some((pin, second))
    };
    let (parts, is_assumed) = match given().filter(|parts| of(*parts).is_some()) {
        Some(parts) => (parts, false),
        None => {
            let one = 0.5 * size.min(1.0);
            ([one, one / size], true)
        }
    };
    let Some((pin, second)) = of(parts) else { return Radii { central_gears: [1.0, size], planets: vec![] } };
    let contacts = [Some((0, 1.0)), Some((1, second))];
    Radii { central_gears: [1.0, second], planets: vec![Planet { letter: "g", pin, contacts, is_assumed }] }
}
