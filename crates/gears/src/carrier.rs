//! Mass and polar inertia of a planet carrier: flat arms with a hole each, around a hub ring.
//!
//! Left out: planet pins and bearings, second cheek plates, and the sliver between the flat end of an arm and
//! the round hub.

use std::f64::consts::PI;

use epicyclic_units::Physical;
use uom::si::f64::{Area, Length, MassDensity, MomentOfInertia};

use crate::checks::{length_from_to, positive_density, positive_length};
use crate::mass::{self, MassProperties};
use crate::quantity::Counted;
use crate::{Error, Quantity};

/// Round hole through an arm, on its centre line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// Radius `r_h`.
    pub radius: Length,
    /// Distance `e` of its centre from the outer end of the arm.
    pub from_outer_end: Length,
}

/// Flat rectangular arm that points away from the gearbox axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm {
    /// Length `L` along the radius.
    pub length: Length,
    /// Width `w` across it.
    pub width: Length,
    /// Thickness `t` along the axis.
    pub thickness: Length,
    /// The hole for the planet, if any.
    pub hole: Option<Hole>,
}

impl Arm {
    /// Length of an arm from the hub to some way beyond the planets' centres: `L = r_w + e − R`.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | `r_w` | `planet_radius` | radius of the planets' centres | m |
    /// | `e` | `beyond` | from there to the outer end, as of [`Hole::from_outer_end`] | m |
    /// | `R` | `hub_radius` | outside radius of the hub | m |
    ///
    /// Not above 0 where the hub reaches farther; [`Carrier::new`] refuses such an arm.
    ///
    /// # Source
    /// excavator-dynamics, carrier: 240 + 50 − 105 = 185 mm.
    #[must_use]
    pub fn length_from_hub(planet_radius: Length, beyond: Length, hub_radius: Length) -> Length {
        planet_radius + beyond - hub_radius
    }
}

/// Ring about the gearbox axis from which the arms start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hub {
    /// Outside radius `R`, where the arms begin.
    pub outer_radius: Length,
    /// Inside radius `r`; 0 for a solid hub.
    pub inner_radius: Length,
    /// Width `b_h` along the axis.
    pub width: Length,
}

/// A carrier of equal, equally spaced arms and a hub, all of one density.
///
/// ```text
/// arm:   V_a = t·(L·w − π·r_h²)    x_s = (L²·w/2 − π·r_h²·e)/(L·w − π·r_h²), from the outer end
///        J_a = ρ·t·{L·w·[(L² + w²)/12 + (R + L/2)²] − π·r_h²·[r_h²/2 + (R + L − e)²]}
/// hub:   J_h = ½·m_h·(R² + r²)
/// whole: m = N·m_a + m_h    J = N·J_a + J_h
/// ```
///
/// `N` is the number of arms; the other symbols are explained at the fields of [`Arm`], [`Hole`] and [`Hub`].
/// The inner end of an arm is at the hub's outside radius `R`. Inertias are about the gearbox axis, by the
/// parallel-axis theorem, holes included.
///
/// # Source
/// excavator-dynamics, section 5. Masses and centroid follow it (with its π = 3.14); the inertia does not:
/// see [`Carrier::published_inertia`].
///
/// # Example
/// ```
/// use epicyclic_gears::carrier::{Arm, Carrier, Hole, Hub};
/// use uom::si::f64::{Area, Length, MassDensity};
/// use uom::si::length::millimeter;
/// use uom::si::mass_density::kilogram_per_cubic_meter;
/// use uom::si::moment_of_inertia::kilogram_square_meter;
///
/// let mm = Length::new::<millimeter>;
/// let hole = Hole { radius: mm(30.0), from_outer_end: mm(50.0) };
/// let arm = Arm { length: mm(185.0), width: mm(80.0), thickness: mm(10.0), hole: Some(hole) };
/// let hub = Hub { outer_radius: mm(105.0), inner_radius: mm(95.0), width: mm(50.0) };
/// let carrier = Carrier::new(4, arm, hub, MassDensity::new::<kilogram_per_cubic_meter>(7900.0))?;
/// assert!((carrier.total().polar_inertia.get::<kilogram_square_meter>() - 0.171).abs() < 5e-4);
/// assert!((carrier.arm_centroid_from_outer_end().get::<millimeter>() - 102.53).abs() < 0.01);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carrier {
    arms: u32,
    arm: Arm,
    hub: MassProperties,
    hub_outer_radius: Length,
    hub_inner_radius: Length,
    density_kg_m3: f64,
}

/// Inertia of a carrier as excavator-dynamics likely calculated it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PublishedInertia {
    /// Inertia of all arms, `N·(m_a·L²/12 + m_a·x²)`.
    pub arms: MomentOfInertia,
    /// The hub, `¼·m_h·(R² − r²)`.
    pub hub: MomentOfInertia,
}

impl PublishedInertia {
    /// Arms and hub together.
    #[must_use]
    pub fn total(&self) -> MomentOfInertia {
        self.arms + self.hub
    }
}

impl Carrier {
    /// A carrier whose holes lie inside its arms and whose arms do not overlap.
    ///
    /// # Errors
    /// [`Error::TooFew`] for no arms; [`Error::NotPositive`] for a dimension or the density;
    /// [`Error::OutOfRange`] in three cases:
    ///
    /// - a hole breaks out of its arm;
    /// - the hub's inside radius is not below its outside radius;
    /// - three or more arms are wider than `2·R·tan(π/N)`, where adjacent arms would overlap.
    pub fn new(arms: u32, arm: Arm, hub: Hub, density: MassDensity) -> Result<Self, Error> {
        if arms == 0 {
            return Err(Error::TooFew { what: Counted::Arms, count: arms, at_least: 1 });
        }
        let length_m = positive_length(Quantity::ArmLength, arm.length)?;
        let width_m = positive_length(Quantity::ArmWidth, arm.width)?;
        positive_length(Quantity::ArmThickness, arm.thickness)?;
        let outer_m = positive_length(Quantity::HubOutsideRadius, hub.outer_radius)?;
        length_from_to(Quantity::HubInsideRadius, hub.inner_radius, 0.0, outer_m)?;
        if let Some(hole) = arm.hole {
            let radius_m = positive_length(Quantity::HoleRadius, hole.radius)?;
            length_from_to(Quantity::HoleRadius, hole.radius, 0.0, length_m.min(width_m) / 2.0)?;
            length_from_to(Quantity::HoleDistance, hole.from_outer_end, radius_m, length_m - radius_m)?;
        }
        if arms >= 3 {
            length_from_to(
                Quantity::ArmWidth,
                arm.width,
                0.0,
                2.0 * outer_m * libm::tan(PI / f64::from(arms)),
            )?;
        }
        Ok(Self {
            arms,
            arm,
            hub: mass::ring(hub.outer_radius * 2.0, hub.inner_radius * 2.0, hub.width, density)?,
            hub_outer_radius: hub.outer_radius,
            hub_inner_radius: hub.inner_radius,
            density_kg_m3: positive_density(density)?,
        })
    }

    /// One arm about the gearbox axis.
    #[must_use]
    pub fn arm(&self) -> MassProperties {
        let (plate, hole) = self.plate_and_hole();
        let (area, second_moment) = (plate.area - hole.area, plate.second_moment() - hole.second_moment());
        let thickness_m = self.arm.thickness.si();
        MassProperties::from_volume_integrals(
            thickness_m * area,
            thickness_m * second_moment,
            self.density_kg_m3,
        )
    }

    /// Mass properties of all arms about the gearbox axis.
    #[must_use]
    pub fn arms(&self) -> MassProperties {
        self.arm() * f64::from(self.arms)
    }

    /// The hub about the gearbox axis.
    #[must_use]
    pub const fn hub(&self) -> MassProperties {
        self.hub
    }

    /// Arms and hub together.
    #[must_use]
    pub fn total(&self) -> MassProperties {
        self.arms() + self.hub
    }

    /// Area of an arm without its hole, and that of the hole.
    #[must_use]
    pub fn arm_areas(&self) -> [Area; 2] {
        let (plate, hole) = self.plate_and_hole();
        [Area::from_si(plate.area), Area::from_si(hole.area)]
    }

    /// Distance `x_s` of an arm's centroid from its outer end.
    #[must_use]
    pub fn arm_centroid_from_outer_end(&self) -> Length {
        self.hub_outer_radius + self.arm.length - self.arm_centroid_radius()
    }

    /// Distance `x` of an arm's centroid from the gearbox axis.
    #[must_use]
    pub fn arm_centroid_radius(&self) -> Length {
        let (plate, hole) = self.plate_and_hole();
        Length::from_si((plate.area * plate.radius - hole.area * hole.radius) / (plate.area - hole.area))
    }

    /// The inertia that excavator-dynamics publishes, by the way it likely took. **Physically wrong**: use
    /// [`Carrier::total`] instead.
    ///
    /// ```text
    /// J = N·(m_a·L²/12 + m_a·x²) + ¼·m_h·(R² − r²)
    /// ```
    ///
    /// The arm is taken for a thin rod `L` of the bored arm's mass about its centroid `x`: the width is
    /// neglected, and the rod does not have the bored arm's own inertia. The hub's term has ¼ for ½ and a
    /// minus where a ring has a plus (`½·m_h·(R² + r²)`): twenty times too little. The document prints only
    /// the results, 0.143 + 0.00124 = 0.144 kg·m².
    ///
    /// # Source
    /// excavator-dynamics, section 5, inferred from the printed results.
    #[must_use]
    pub fn published_inertia(&self) -> PublishedInertia {
        let (length_m, x) = (self.arm.length.si(), self.arm_centroid_radius().si());
        let (outer, inner) = (self.hub_outer_radius.si(), self.hub_inner_radius.si());
        PublishedInertia {
            arms: MomentOfInertia::from_si(self.arms().mass.si() * (length_m.powi(2) / 12.0 + x.powi(2))),
            hub: MomentOfInertia::from_si(self.hub.mass.si() / 4.0 * (outer.powi(2) - inner.powi(2))),
        }
    }

    fn plate_and_hole(&self) -> (Figure, Figure) {
        let (inner_end, length_m, width_m) =
            (self.hub_outer_radius.si(), self.arm.length.si(), self.arm.width.si());
        let plate = Figure {
            area: length_m * width_m,
            radius: inner_end + length_m / 2.0,
            own_gyration2: (length_m.powi(2) + width_m.powi(2)) / 12.0,
        };
        let hole = self.arm.hole.map_or(Figure::default(), |hole| {
            let radius_m = hole.radius.si();
            Figure {
                area: PI * radius_m.powi(2),
                radius: inner_end + length_m - hole.from_outer_end.si(),
                own_gyration2: radius_m.powi(2) / 2.0,
            }
        });
        (plate, hole)
    }
}

/// A plane figure on the centre line of an arm, SI.
#[derive(Default)]
struct Figure {
    area: f64,
    /// Distance of its centroid from the gearbox axis.
    radius: f64,
    /// Square of its polar radius of gyration about its centroid.
    own_gyration2: f64,
}

impl Figure {
    /// `∫ r²·dA` about the gearbox axis.
    fn second_moment(&self) -> f64 {
        self.area * (self.own_gyration2 + self.radius.powi(2))
    }
}

#[cfg(test)]
mod tests {
    use uom::si::volume::cubic_millimeter;

    use super::*;

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
    }

    #[allow(clippy::approx_constant)] // the document calculates with this π
    const DOCUMENT_PI: f64 = 3.14;

    fn steel() -> MassDensity {
        MassDensity::from_si(7900.0)
    }

    fn arm() -> Arm {
        let hole = Some(Hole { radius: mm(30.0), from_outer_end: mm(50.0) });
        Arm { length: mm(185.0), width: mm(80.0), thickness: mm(10.0), hole }
    }

    fn hub() -> Hub {
        Hub { outer_radius: mm(105.0), inner_radius: mm(95.0), width: mm(50.0) }
    }

    fn assert_inertia(actual: MomentOfInertia, expected_kg_m2: f64, half_unit: f64) {
        let actual = actual.si();
        assert!((actual - expected_kg_m2).abs() <= half_unit, "{actual} is not {expected_kg_m2}");
    }

    #[test]
    fn one_plain_arm_by_hand() {
        // A 1 m × 1 m plate from 1 m to 2 m, no hole, 1 kg/m², hub thin and far lighter:
        // J = 1·[(1 + 1)/12 + 1.5²] = 29/12 kg·m².
        let arm = Arm { length: mm(1000.0), width: mm(1000.0), thickness: mm(1000.0), hole: None };
        let hub = Hub { outer_radius: mm(1000.0), inner_radius: mm(0.0), width: mm(1000.0) };
        let unit = MassDensity::from_si(1.0);
        let carrier = Carrier::new(1, arm, hub, unit).unwrap();
        assert_inertia(carrier.arm().polar_inertia, 29.0 / 12.0, 1e-12);
        assert_inertia(carrier.hub().polar_inertia, PI / 2.0, 1e-12);
        assert!((carrier.arm_centroid_from_outer_end() - mm(500.0)).abs() < mm(1e-9));
    }

    #[test]
    fn carrier_of_the_excavator_drive() {
        let carrier = Carrier::new(4, arm(), hub(), steel()).unwrap();
        // The document's π = 3.14 enters the arm through its hole only.
        let printed_arm_mm3 = 119_740.0 + 10.0 * 900.0 * (DOCUMENT_PI - PI);
        assert!((carrier.arm().volume.get::<cubic_millimeter>() - printed_arm_mm3).abs() < 1e-6);
        assert!((carrier.arm().mass.si() - 0.9458).abs() < 5e-5);
        assert!((carrier.hub().mass.si() - 2.4819).abs() < 5e-5);
        assert!((carrier.arm_centroid_from_outer_end() - mm(102.53)).abs() < mm(0.01));
        assert_inertia(carrier.arms().polar_inertia, 0.146, 5e-4);
        assert_inertia(carrier.hub().polar_inertia, 0.0249, 5e-5);
        assert_inertia(carrier.total().polar_inertia, 0.171, 5e-4);
    }

    #[test]
    fn published_inertia_follows_from_the_likely_way_only() {
        let published = Carrier::new(4, arm(), hub(), steel()).unwrap().published_inertia();
        // 0.1437 from the mass 0.9458 kg; 0.1436 from the printed, truncated 0.945 kg.
        assert_inertia(published.arms, 0.1437, 5e-5);
        assert_inertia(published.hub, 0.00124, 5e-6);
        // Printed 0.144 is the sum of the truncated 0.143 and 0.00124; untruncated it is 0.145.
        assert_inertia(published.total(), 0.145, 5e-4);
    }

    #[test]
    fn refused_carriers_say_why() {
        let of = |arms, arm, hub| Carrier::new(arms, arm, hub, steel());
        assert_eq!(of(0, arm(), hub()), Err(Error::TooFew { what: Counted::Arms, count: 0, at_least: 1 }));
        let refused = |arm| match of(4, arm, hub()) {
            Err(Error::NotPositive { quantity, .. } | Error::OutOfRange { quantity, .. }) => quantity,
            other => panic!("{other:?}"),
        };
        assert_eq!(refused(Arm { length: mm(0.0), ..arm() }), Quantity::ArmLength);
        assert_eq!(refused(Arm { width: mm(f64::NAN), ..arm() }), Quantity::ArmWidth);
        assert_eq!(refused(Arm { thickness: mm(-1.0), ..arm() }), Quantity::ArmThickness);
        // Four arms around R = 105 touch when 210 mm wide.
        assert_eq!(refused(Arm { width: mm(210.1), ..arm() }), Quantity::ArmWidth);
        assert!(of(4, Arm { width: mm(209.9), ..arm() }, hub()).is_ok());
        let with_hole =
            |radius, e| Arm { hole: Some(Hole { radius: mm(radius), from_outer_end: mm(e) }), ..arm() };
        assert_eq!(refused(with_hole(0.0, 50.0)), Quantity::HoleRadius);
        assert_eq!(refused(with_hole(40.0, 50.0)), Quantity::HoleRadius);
        assert_eq!(refused(with_hole(30.0, 29.0)), Quantity::HoleDistance);
        assert_eq!(refused(with_hole(30.0, 156.0)), Quantity::HoleDistance);
        let thin = Hub { inner_radius: mm(105.0), ..hub() };
        assert!(matches!(
            of(4, arm(), thin),
            Err(Error::OutOfRange { quantity: Quantity::HubInsideRadius, .. })
        ));
        let flat = Hub { width: mm(0.0), ..hub() };
        assert!(matches!(of(4, arm(), flat), Err(Error::NotPositive { .. })));
        let weightless = Carrier::new(4, arm(), hub(), MassDensity::from_si(0.0));
        assert!(matches!(weightless, Err(Error::NotPositive { quantity: Quantity::Density, .. })));
    }
}
