//! The moving links of any planetary gearbox in a gear, from which the equivalent inertia follows.
//!
//! Speeds come from the solver of [`epicyclic_train`], whatever the structure; this module adds the masses.
//! Gears of an ordinary pair turn with the links that carry them.

use crate::Error;
use crate::equivalent_inertia::{Link, LinkName, Orbit};
use epicyclic_train::Gearbox;
use uom::si::f64::{Length, Mass, MomentOfInertia};

/// Moving masses of a gearbox.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Masses {
    /// Inertia of each link about the main axis, by the link's name; planets not included.
    pub links: Vec<(String, MomentOfInertia)>,
    /// The planets of each set, by the set's name.
    pub planets: Vec<(String, PlanetMasses)>,
}

/// The planets of a set: one entry for each planet on its own axis (two of a double planet).
#[derive(Debug, Clone, PartialEq)]
pub struct PlanetMasses {
    /// Number of planets, or of pairs, around the axis.
    pub count: u32,
    /// The planet, or the planets of a pair in the order of the set's gears.
    pub each: Vec<PlanetMass>,
}

/// One planet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanetMass {
    /// Mass of the planet.
    pub mass: Mass,
    /// Inertia about its own axis.
    pub inertia: MomentOfInertia,
    /// Radius of its centre.
    pub radius: Length,
}

/// The moving links of a gearbox in a gear, speeds as multiples of the input's.
///
/// ```
/// use epicyclic_dynamics::gearbox::{Masses, moving_links};
/// use epicyclic_dynamics::equivalent_inertia::equivalent_inertia;
/// use epicyclic_train::{Gearbox, set::SetSpec};
/// use uom::si::f64::MomentOfInertia;
/// use uom::si::moment_of_inertia::kilogram_square_meter;
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("conveyor")
///     .links(["D", "B", "T1"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("slow", ["K1"])
///     .build()?;
/// let drum = MomentOfInertia::new::<kilogram_square_meter>(16.0);
/// let masses = Masses { links: vec![("B".into(), drum)], ..Masses::default() };
/// let links = moving_links(&gearbox, "slow", &masses)?;
/// assert_eq!(equivalent_inertia(&links)?.get::<kilogram_square_meter>(), 1.0);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::Gearbox`] for an unknown gear; [`Error::UnknownPart`] for an unknown link or set, or a number of
/// planets that the set does not have; [`Error::NoSpeed`] for a link whose speed does not follow from the
/// input's in this gear.
pub fn moving_links(gearbox: &Gearbox, gear: &str, masses: &Masses) -> Result<Vec<Link>, Error> {
    let analysis = gearbox.analyze(gear)?;
    let no_speed = |part: &str| Error::NoSpeed { part: part.into(), state: analysis.state().clone() };
    let unknown = |part: &str| Error::UnknownPart { part: part.into(), gearbox: gearbox.name().into() };
    let mut links = Vec::new();
    for (name, inertia) in &masses.links {
        let link = gearbox.link(name).ok_or_else(|| unknown(name))?;
        let speed = analysis.speed(link).ok_or_else(|| no_speed(name))?;
        links.push(Link::central(name.as_str(), *inertia, speed));
    }
    for (name, planets) in &masses.planets {
        let set = gearbox.sets().iter().position(|set| set.id() == name).ok_or_else(|| unknown(name))?;
        let motion = &analysis.sets()[set];
        let carrier = motion.carrier().ok_or_else(|| no_speed(name))?;
        if planets.each.len() > motion.planets.len() {
            return Err(unknown(&format!("planet {} of set {name}", motion.planets.len() + 1)));
        }
        for (planet, moving) in planets.each.iter().zip(&motion.planets) {
            // A bevel planet turns about an axis across: its own spin and the carrier's are apart.
            let speed = moving.and_then(|moving| moving.speed).ok_or_else(|| no_speed(name))?;
            let orbit = Orbit { mass: planet.mass, radius: planet.radius, speed_ratio: carrier };
            links.push(Link {
                name: LinkName::PlanetsOf(name.clone()),
                count: planets.count,
                inertia: planet.inertia,
                speed_ratio: speed,
                orbit: Some(orbit),
            });
        }
    }
    Ok(links)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equivalent_inertia::equivalent_inertia;
    use epicyclic_train::set::SetSpec;
    use epicyclic_units::Physical;

    /// Scheme II-3 in its second gear, where both sets work.
    fn second_gear_of_ii_3() -> Gearbox {
        Gearbox::builder("II-3")
            .links(["D", "B", "T1", "T2"])
            .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15))
            .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354))
            .brake("K1", "T1")
            .brake("K2", "T2")
            .input("D")
            .output("B")
            .gear("1", ["K1"])
            .gear("2", ["K2"])
            .gear("none", [""; 0])
            .build()
            .unwrap()
    }

    fn masses() -> Masses {
        let planet = PlanetMass {
            mass: Mass::from_si(4.0),
            inertia: MomentOfInertia::from_si(0.02),
            radius: Length::from_si(0.1),
        };
        let links = [("D", 0.1), ("T1", 0.3)].map(|(name, j)| (name.to_owned(), MomentOfInertia::from_si(j)));
        let planets = PlanetMasses { count: 3, each: vec![planet] };
        Masses { links: links.into(), planets: vec![("1".into(), planets)] }
    }

    #[test]
    fn the_equivalent_inertia_of_a_gear_of_two_sets_by_hand() {
        let links = moving_links(&second_gear_of_ii_3(), "2", &masses()).unwrap();
        // Set 2 with its carrier at rest: ω_T1 = −2.354·ω_B; set 1: ω_T1 + 2.15·1 = 3.15·ω_B.
        let b = 2.15 / (3.15 + 2.354);
        let t1 = -2.354 * b;
        let planet = b - (t1 - b) * 2.0 / 1.15;
        let by_hand = 0.1 + 0.3 * t1 * t1 + 3.0 * (0.02 * planet * planet + 4.0 * (0.1 * b) * (0.1 * b));
        assert!((equivalent_inertia(&links).unwrap().si() - by_hand).abs() < 1e-14);
    }

    #[test]
    fn what_is_not_there_or_does_not_follow_is_named() {
        let gearbox = second_gear_of_ii_3();
        assert!(matches!(moving_links(&gearbox, "9", &masses()), Err(Error::Gearbox(_))));
        let stray = Masses { links: vec![("T9".into(), MomentOfInertia::from_si(1.0))], ..Masses::default() };
        assert!(matches!(moving_links(&gearbox, "2", &stray), Err(Error::UnknownPart { .. })));
        assert!(matches!(moving_links(&gearbox, "none", &masses()), Err(Error::NoSpeed { .. })));
        let mut three = masses();
        three.planets[0].1.each = vec![three.planets[0].1.each[0]; 3];
        assert!(matches!(moving_links(&gearbox, "2", &three), Err(Error::UnknownPart { .. })));
    }
}
