//! Equivalent inertia of the moving links, referred to the driving shaft.
//!
//! ```text
//! J_pr = Σ n·(J·u² + m·r²·u_H²)
//! ```
//!
//! | symbol | field | meaning | unit |
//! |---|---|---|---|
//! | `n` | [`Link::count`] | how many alike | 1 |
//! | `J` | [`Link::inertia`] | inertia about the link's own axis | kg·m² |
//! | `u` | [`Link::speed_ratio`] | absolute speed of the link over that of the driving shaft | 1 |
//! | `m`, `r` | [`Orbit::mass`], [`Orbit::radius`] | mass that circles the main axis, its radius | kg, m |
//! | `u_H` | [`Orbit::speed_ratio`] | speed of that circling over that of the driving shaft | 1 |
//!
//! The ratios are constant, so `J_pr` is: gears without backlash, rigid links.
//!
//! # Source
//! excavator-dynamics, where it is called the reduced moment of inertia.

use crate::Error;
pub use crate::link_name::{LinkName, Property};
use epicyclic_units::Physical;
use uom::si::f64::{Length, Mass, MomentOfInertia};

/// A moving link, or several alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Name of the link.
    pub name: LinkName,
    /// Number of equal links.
    pub count: u32,
    /// Inertia of one about its own axis.
    pub inertia: MomentOfInertia,
    /// Absolute speed over that of the driving shaft, signed.
    pub speed_ratio: f64,
    /// The circle on which its centre of mass travels, where it does.
    pub orbit: Option<Orbit>,
}

/// A mass carried around the main axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// Mass of one link.
    pub mass: Mass,
    /// Radius of the circle of its centre.
    pub radius: Length,
    /// Speed of the circling (of the carrier) over that of the driving shaft, signed.
    pub speed_ratio: f64,
}

impl Link {
    /// A link that turns about the main axis.
    #[must_use]
    pub fn central(name: impl Into<LinkName>, inertia: MomentOfInertia, speed_ratio: f64) -> Self {
        Self { name: name.into(), count: 1, inertia, speed_ratio, orbit: None }
    }

    /// Share of the link in the equivalent inertia, of all equal links together.
    ///
    /// # Errors
    /// [`Error::Impossible`] for a negative or non-finite mass, inertia or radius,
    /// [`Error::NotFinite`] for a speed ratio that is not a number.
    pub fn equivalent_inertia(&self) -> Result<MomentOfInertia, Error> {
        let body = |what, value: f64| {
            if value >= 0.0 && value.is_finite() {
                Ok(value)
            } else {
                Err(Error::Impossible { link: self.name.clone(), what, value })
            }
        };
        let ratio = |what, value: f64| {
            if value.is_finite() {
                Ok(value)
            } else {
                Err(Error::NotFinite { link: self.name.clone(), what, value })
            }
        };
        let own = body(Property::Inertia, self.inertia.si())?
            * ratio(Property::SpeedRatio, self.speed_ratio)?.powi(2);
        let carried = match &self.orbit {
            None => 0.0,
            Some(orbit) => {
                body(Property::Mass, orbit.mass.si())?
                    * (body(Property::Radius, orbit.radius.si())?
                        * ratio(Property::OrbitSpeedRatio, orbit.speed_ratio)?)
                    .powi(2)
            }
        };
        Ok(MomentOfInertia::from_si(f64::from(self.count) * (own + carried)))
    }
}

/// Inertia that all links present at the driving shaft, `J_pr`.
///
/// ```
/// use epicyclic_dynamics::equivalent_inertia::{Link, equivalent_inertia};
/// use uom::si::f64::MomentOfInertia;
/// use uom::si::moment_of_inertia::kilogram_square_meter;
/// # fn main() -> Result<(), epicyclic_dynamics::Error> {
/// let kg_m2 = MomentOfInertia::new::<kilogram_square_meter>;
/// let links = [Link::central("rotor", kg_m2(0.5), 1.0), Link::central("drum", kg_m2(18.0), 1.0 / 6.0)];
/// assert_eq!(equivalent_inertia(&links)?.get::<kilogram_square_meter>(), 1.0);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`Link::equivalent_inertia`].
pub fn equivalent_inertia(links: &[Link]) -> Result<MomentOfInertia, Error> {
    links.iter().try_fold(MomentOfInertia::from_si(0.0), |sum, link| Ok(sum + link.equivalent_inertia()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::{MovingBody, kinetic_energy};
    use epicyclic_units::Physical;
    use proptest::prelude::*;
    use uom::si::f64::{AngularVelocity, Length, Mass, MomentOfInertia, Velocity};

    #[test]
    fn a_planet_counts_with_its_orbit() {
        let planets = Link {
            name: "planets".into(),
            count: 3,
            inertia: MomentOfInertia::from_si(0.5),
            speed_ratio: -2.0,
            orbit: Some(Orbit { mass: Mass::from_si(4.0), radius: Length::from_si(0.5), speed_ratio: 0.5 }),
        };
        // 3·(0.5·4 + 4·0.25·0.25)
        assert!((planets.equivalent_inertia().unwrap().si() - 6.75).abs() < 1e-15);
    }

    #[test]
    fn impossible_bodies_are_refused() {
        let with = |j: f64, u: f64| {
            Link::central("drum", MomentOfInertia::from_si(j), u).equivalent_inertia().unwrap_err()
        };
        assert!(matches!(with(-1.0, 1.0), Error::Impossible { what: Property::Inertia, .. }));
        assert!(matches!(with(1.0, f64::NAN), Error::NotFinite { what: Property::SpeedRatio, .. }));
        let thrown = Link {
            orbit: Some(Orbit { mass: Mass::from_si(-1.0), radius: Length::from_si(1.0), speed_ratio: 1.0 }),
            ..Link::central("stone", MomentOfInertia::from_si(0.0), 1.0)
        };
        assert!(matches!(thrown.equivalent_inertia(), Err(Error::Impossible { what: Property::Mass, .. })));
    }

    prop_compose! {
        fn any_link()(
            count in 1..6_u32, j in 0.0..5.0, u in -8.0..8.0,
            orbit in proptest::option::of((0.0..50.0, 0.0..0.8, -3.0..3.0)),
        ) -> Link {
            let orbit = orbit.map(|(m, r, u)| Orbit { mass: Mass::from_si(m), radius: Length::from_si(r), speed_ratio: u });
            Link { name: "link".into(), count, inertia: MomentOfInertia::from_si(j), speed_ratio: u, orbit }
        }
    }

    /// The bodies of a link as they move, by absolute speeds.
    fn bodies(link: &Link, omega: f64) -> impl Iterator<Item = MovingBody> {
        let speed = AngularVelocity::from_si(link.speed_ratio * omega);
        let body = match link.orbit {
            None => MovingBody::turning(link.inertia, speed),
            Some(orbit) => MovingBody {
                inertia: link.inertia,
                speed,
                mass: orbit.mass,
                centre_speed: Velocity::from_si(omega * orbit.speed_ratio * orbit.radius.si()),
            },
        };
        std::iter::repeat_n(body, link.count as usize)
    }

    proptest! {
        #[test]
        fn any_mechanism_has_the_energy_of_its_equivalent_inertia(
            links in proptest::collection::vec(any_link(), 1..12),
            omega in -400.0..400.0,
        ) {
            let bodies: Vec<MovingBody> = links.iter().flat_map(|link| bodies(link, omega)).collect();
            let summed = kinetic_energy(&bodies).si();
            let equivalent = 0.5 * equivalent_inertia(&links).unwrap().si() * omega * omega;
            prop_assert!((summed - equivalent).abs() <= 1e-12 * equivalent);
        }
    }
}
