//! Volume, mass and polar inertia of rings and of gears with half-filled tooth zones.
//!
//! Bodies of revolution of one density about their own axis; web holes, hubs and fillets are left out.

use std::f64::consts::PI;
use std::ops::{Add, Mul};

use epicyclic_units::Physical;
use uom::si::f64::{Length, Mass, MassDensity, MomentOfInertia, Volume};

use crate::checks::{length_from_to, positive_density, positive_length, positive_mass, shown_mm};
use crate::geometry::{GearKind, ToothedGear};
use crate::{Error, Quantity};

/// Fraction of the annulus between root and tip circle that the teeth fill: a tooth takes as much as a space.
pub const TOOTH_FILL: f64 = 0.5;

/// Volume, mass and polar moment of inertia of a body about one axis.
///
/// Bodies about the same axis add; a number multiplies equal bodies about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    /// Volume `V`.
    pub volume: Volume,
    /// Mass `m = ρ·V`.
    pub mass: Mass,
    /// Polar moment of inertia `J = ∫ r²·dm` about the axis, kg·m².
    pub polar_inertia: MomentOfInertia,
}

impl MassProperties {
    /// Mass properties from the integrals over the volume `V` and the second polar moment `∫ r²·dV` of a body
    /// of one density.
    pub(crate) fn from_volume_integrals(volume_m3: f64, r2_volume_m5: f64, density_kg_m3: f64) -> Self {
        Self {
            volume: Volume::from_si(volume_m3),
            mass: Mass::from_si(density_kg_m3 * volume_m3),
            polar_inertia: MomentOfInertia::from_si(density_kg_m3 * r2_volume_m5),
        }
    }
}

impl Add for MassProperties {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            volume: self.volume + other.volume,
            mass: self.mass + other.mass,
            polar_inertia: self.polar_inertia + other.polar_inertia,
        }
    }
}

impl Mul<f64> for MassProperties {
    type Output = Self;

    fn mul(self, count: f64) -> Self {
        Self {
            volume: self.volume * count,
            mass: self.mass * count,
            polar_inertia: self.polar_inertia * count,
        }
    }
}

/// A ring about its axis; a disc when the bore is 0.
///
/// ```text
/// V = π·b·(R² − r²)    m = ρ·V    J = ½·π·ρ·b·(R⁴ − r⁴) = ½·m·(R² + r²)
/// ```
///
/// | symbol | argument | meaning | unit |
/// |---|---|---|---|
/// | `2R`, `2r` | `outside_diameter`, `bore_diameter` | diameters | mm |
/// | `b` | `width` | width | mm |
/// | `ρ` | `density` | density | kg/m³ |
///
/// # Errors
/// [`Error::NotPositive`] for diameter, width or density; [`Error::OutOfRange`] unless 0 ≤ r < R.
///
/// # Source
/// excavator-dynamics (5), (7).
///
/// # Example
/// ```
/// use epicyclic_gears::mass;
/// use uom::si::f64::{Length, MassDensity};
/// use uom::si::{length::millimeter, mass::kilogram, mass_density::kilogram_per_cubic_meter};
///
/// let mm = Length::new::<millimeter>;
/// let steel = MassDensity::new::<kilogram_per_cubic_meter>(7900.0);
/// let hub = mass::ring(mm(210.0), mm(190.0), mm(50.0), steel)?;
/// assert!((hub.mass.get::<kilogram>() - 2.48).abs() < 0.005);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn ring(
    outside_diameter: Length,
    bore_diameter: Length,
    width: Length,
    density: MassDensity,
) -> Result<MassProperties, Error> {
    let outside_m = positive_length(Quantity::OutsideDiameter, outside_diameter)?;
    let bore_m = length_from_to(Quantity::BoreDiameter, bore_diameter, 0.0, outside_m)?;
    let width_m = positive_length(Quantity::Width, width)?;
    Ok(ring_of(outside_m, bore_m, width_m, 1.0, positive_density(density)?))
}

/// Mass properties of a ring in which only the fraction `fill` is material, evenly at every radius.
fn ring_of(outside_m: f64, bore_m: f64, width_m: f64, fill: f64, density_kg_m3: f64) -> MassProperties {
    let (outer, inner) = (outside_m / 2.0, bore_m / 2.0);
    let area = PI * (outer.powi(2) - inner.powi(2));
    let second_moment = PI / 2.0 * (outer.powi(4) - inner.powi(4));
    MassProperties::from_volume_integrals(
        fill * width_m * area,
        fill * width_m * second_moment,
        density_kg_m3,
    )
}

/// A gear as two rings: the tooth zone, [`TOOTH_FILL`] of it material, and the solid body.
///
/// ```text
/// external: V_f = ½·π·b·(r_a² − r_f²)    V_O = π·b·(r_f² − r_bore²)
///           J = ½·ρ·π·b·[(r_a⁴ + r_f⁴)/2 − r_bore⁴]
/// internal: V_f = ½·π·b·(r_f² − r_a²)    V_O = π·b·(r_rim² − r_f²)
///           J = ½·ρ·π·b·[r_rim⁴ − (r_a⁴ + r_f⁴)/2]
/// both:     V = V_f + V_O    m = ρ·V
/// ```
///
/// | symbol | argument | meaning | unit |
/// |---|---|---|---|
/// | `r_a`, `r_f` | `gear` | tip and root radius | mm |
/// | `b` | `face_width` | face width | mm |
/// | `r_bore` | `bore_diameter` | radius of the hole, 0 for none | mm |
/// | `r_rim` | `rim_diameter` | outside radius of a ring gear | mm |
/// | `ρ` | `density` | density | kg/m³ |
///
/// # Source
/// excavator-dynamics (4)–(7); it takes π = 3.14, so its volumes and masses are 3.14/π of these. The inertia
/// is that of the same shape, not its formula (8): see [`published_gear_inertia`].
///
/// # Example
/// ```
/// use epicyclic_gears::geometry::{BasicRack, GearKind, ToothedGear};
/// use epicyclic_gears::mass::GearBody;
/// use epicyclic_gears::ToothCount;
/// use uom::si::f64::{Length, MassDensity};
/// use uom::si::length::millimeter;
/// use uom::si::mass_density::kilogram_per_cubic_meter;
/// use uom::si::moment_of_inertia::kilogram_square_meter;
///
/// let mm = Length::new::<millimeter>;
/// let rack = BasicRack { clearance: 0.2, ..BasicRack::default() };
/// let sun = ToothedGear::new(GearKind::External, mm(8.0), ToothCount::new(20)?, rack)?;
/// let steel = MassDensity::new::<kilogram_per_cubic_meter>(7900.0);
/// let body = GearBody::external(&sun, mm(60.0), mm(110.0), steel)?;
/// assert!((body.total().polar_inertia.get::<kilogram_square_meter>() - 0.0247).abs() < 5e-5);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct GearBody {
    /// The teeth, `V_f`.
    pub tooth_zone: MassProperties,
    /// The solid part, `V_O`.
    pub body: MassProperties,
}

impl GearBody {
    /// An external gear with a bore; a `bore_diameter` of 0 is a solid gear.
    ///
    /// # Errors
    /// [`Error::WrongGearKind`] for an internal gear, [`Error::NotPositive`] for width or density,
    /// [`Error::OutOfRange`] unless the bore lies below the root diameter.
    pub fn external(
        gear: &ToothedGear,
        face_width: Length,
        bore_diameter: Length,
        density: MassDensity,
    ) -> Result<Self, Error> {
        expect_kind(gear, GearKind::External)?;
        let (tip_m, root_m) = (gear.tip_diameter().si(), gear.root_diameter().si());
        let width_m = positive_length(Quantity::FaceWidth, face_width)?;
        let bore_m = length_from_to(Quantity::BoreDiameter, bore_diameter, 0.0, root_m)?;
        let density_kg_m3 = positive_density(density)?;
        Ok(Self {
            tooth_zone: ring_of(tip_m, root_m, width_m, TOOTH_FILL, density_kg_m3),
            body: ring_of(root_m, bore_m, width_m, 1.0, density_kg_m3),
        })
    }

    /// An internal gear (ring gear) inside a plain rim.
    ///
    /// # Errors
    /// [`Error::WrongGearKind`] for an external gear, [`Error::NotPositive`] for width, rim or density,
    /// [`Error::NotAbove`] unless the rim diameter lies above the root diameter.
    pub fn internal(
        gear: &ToothedGear,
        face_width: Length,
        rim_diameter: Length,
        density: MassDensity,
    ) -> Result<Self, Error> {
        expect_kind(gear, GearKind::Internal)?;
        let (tip_m, root_m) = (gear.tip_diameter().si(), gear.root_diameter().si());
        let width_m = positive_length(Quantity::FaceWidth, face_width)?;
        let rim_m = positive_length(Quantity::RimDiameter, rim_diameter)?;
        if rim_m <= root_m {
            let [value, low] = [rim_diameter, gear.root_diameter()].map(shown_mm);
            return Err(Error::NotAbove { quantity: Quantity::RimDiameter, value, low, unit: "mm" });
        }
        let density_kg_m3 = positive_density(density)?;
        Ok(Self {
            tooth_zone: ring_of(root_m, tip_m, width_m, TOOTH_FILL, density_kg_m3),
            body: ring_of(rim_m, root_m, width_m, 1.0, density_kg_m3),
        })
    }

    /// Teeth and body together.
    #[must_use]
    pub fn total(&self) -> MassProperties {
        self.tooth_zone + self.body
    }
}

fn expect_kind(gear: &ToothedGear, wanted: GearKind) -> Result<(), Error> {
    if gear.kind() == wanted { Ok(()) } else { Err(Error::WrongGearKind { given: gear.kind(), wanted }) }
}

/// The two readings of formula (8) of excavator-dynamics, whose print is damaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FormulaEight {
    /// `(J₁ + J₂)/2 − J₃`: comes near the published results, hence its likely meaning.
    Likely,
    /// `(J₁ − J₂ + 3·J₃)/2`: what the printed tokens say; its results contradict the published ones.
    Literal,
}

/// Inertia of a gear by formula (8) of excavator-dynamics. **Physically wrong**: use [`GearBody`] instead.
///
/// ```text
/// J_i = ½·m·r_i²     likely: J = (J₁ + J₂)/2 − J₃     literal: J = (J₁ − J₂ + 3·J₃)/2
/// ```
///
/// | symbol | argument | meaning | unit |
/// |---|---|---|---|
/// | `m` | `gear_mass` | mass of the gear itself, bore already taken out | kg |
/// | `2r₁`, `2r₂`, `2r₃` | `tip_diameter`, `root_diameter`, `bore_diameter` | diameters | mm |
///
/// The mean of `J₁` and `J₂` takes the whole mass for a solid disc. Subtracting `½·m·r₃²` for the bore then
/// counts the bore twice, because the mass `m` already lacks it. At equal mass a bore moves material
/// outwards: `J/m` of a ring is `½·(R² + r²)`, more than that of a disc. The formula is kept because the
/// document's downstream figures come from it. The print gives kg·m⁴; the unit is kg·m².
///
/// # Errors
/// [`Error::NotPositive`] for mass or tip diameter; [`Error::OutOfRange`] unless bore < root < tip.
///
/// # Source
/// excavator-dynamics (8); published: 0.00818 and 0.3, from which the likely reading differs by its truncated
/// terms.
///
/// # Example
/// ```
/// use epicyclic_gears::mass::{published_gear_inertia, FormulaEight};
/// use uom::si::f64::{Length, Mass};
/// use uom::si::{length::millimeter, mass::kilogram, moment_of_inertia::kilogram_square_meter};
///
/// let (mm, mass) = (Length::new::<millimeter>, Mass::new::<kilogram>(4.949));
/// let of = |reading| published_gear_inertia(reading, mass, mm(176.0), mm(140.8), mm(110.0));
/// assert!((of(FormulaEight::Likely)?.get::<kilogram_square_meter>() - 0.00823).abs() < 5e-6);
/// assert!((of(FormulaEight::Literal)?.get::<kilogram_square_meter>() - 0.0147).abs() < 5e-5);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn published_gear_inertia(
    reading: FormulaEight,
    gear_mass: Mass,
    tip_diameter: Length,
    root_diameter: Length,
    bore_diameter: Length,
) -> Result<MomentOfInertia, Error> {
    let mass_kg = positive_mass(gear_mass)?;
    let tip_m = positive_length(Quantity::TipDiameter, tip_diameter)?;
    let root_m = length_from_to(Quantity::RootDiameter, root_diameter, 0.0, tip_m)?;
    let bore_m = length_from_to(Quantity::BoreDiameter, bore_diameter, 0.0, root_m)?;
    let [j1, j2, j3] = [tip_m, root_m, bore_m].map(|diameter_m| mass_kg * (diameter_m / 2.0).powi(2) / 2.0);
    Ok(MomentOfInertia::from_si(match reading {
        FormulaEight::Likely => (j1 + j2) / 2.0 - j3,
        FormulaEight::Literal => (j1 - j2 + 3.0 * j3) / 2.0,
    }))
}

#[cfg(test)]
mod tests {
    use uom::si::volume::cubic_millimeter;

    use super::*;
    use crate::ToothCount;
    use crate::geometry::BasicRack;

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
    }

    const STEEL: f64 = 7900.0;

    #[allow(clippy::approx_constant)] // the document calculates with this π
    const DOCUMENT_PI: f64 = 3.14;

    fn density(value_kg_m3: f64) -> MassDensity {
        MassDensity::from_si(value_kg_m3)
    }

    fn gear(kind: GearKind, teeth: u32) -> ToothedGear {
        let rack = BasicRack { clearance: 0.2, ..BasicRack::default() };
        ToothedGear::new(kind, mm(8.0), ToothCount::new(teeth).unwrap(), rack).unwrap()
    }

    fn excavator_gear(teeth: u32, bore_mm: f64) -> GearBody {
        GearBody::external(&gear(GearKind::External, teeth), mm(60.0), mm(bore_mm), density(STEEL)).unwrap()
    }

    #[test]
    fn disc_and_ring_by_hand() {
        // R = 1 m, b = 1/π m, ρ = 2: V = 1 m³, m = 2 kg, J = ½·2·1 = 1 kg·m².
        let disc = ring(mm(2000.0), mm(0.0), mm(1000.0 / PI), density(2.0)).unwrap();
        assert!((disc.mass.si() - 2.0).abs() < 1e-12);
        assert!((disc.polar_inertia.si() - 1.0).abs() < 1e-12);
        // r = ½ m: m = 2·¾ = 1.5 kg, J = ½·1.5·(1 + ¼) = 0.9375 kg·m².
        let ring = ring(mm(2000.0), mm(1000.0), mm(1000.0 / PI), density(2.0)).unwrap();
        assert!((ring.mass.si() - 1.5).abs() < 1e-12);
        assert!((ring.polar_inertia.si() - 0.9375).abs() < 1e-12);
    }

    #[test]
    fn volumes_of_the_excavator_drive_follow_with_its_pi() {
        for (teeth, bore_mm, tooth_zone, body) in
            [(20, 110.0, 262_614.52, 363_830.544), (40, 130.0, 527_881.72, 3_465_648.144)]
        {
            let gear = excavator_gear(teeth, bore_mm);
            let as_printed = |volume: Volume| volume.get::<cubic_millimeter>() * DOCUMENT_PI / PI;
            // Printed 262614.52 and 527881.72 are truncated from ….528 and ….728.
            assert!((0.0..0.01).contains(&(as_printed(gear.tooth_zone.volume) - tooth_zone)));
            assert!((as_printed(gear.body.volume) - body).abs() <= 0.0005);
        }
    }

    #[test]
    fn inertias_of_the_shapes_of_the_excavator_drive() {
        // ½·7900·π·0.06·[(0.088⁴ + 0.0704⁴)/2 − 0.055⁴] and so for the planet, to half a unit of the last
        // digit.
        for (teeth, bore_mm, expected) in [(20, 110.0, 0.024_657), (40, 130.0, 0.473_75)] {
            let found = excavator_gear(teeth, bore_mm).total().polar_inertia.si();
            assert!((found / expected - 1.0).abs() < 3e-5, "{found} is not {expected}");
        }
    }

    #[test]
    fn a_bore_raises_inertia_per_mass_where_formula_eight_lowers_it() {
        let per_mass = |bore_mm| {
            let total = excavator_gear(20, bore_mm).total();
            let (tip, root) = (mm(176.0), mm(140.8));
            let published =
                published_gear_inertia(FormulaEight::Likely, total.mass, tip, root, mm(bore_mm)).unwrap();
            [total.polar_inertia, published].map(|j| (j / total.mass).value)
        };
        let (solid, bored) = (per_mass(0.0), per_mass(110.0));
        assert!(bored[0] > solid[0] && bored[1] < solid[1]);
    }

    #[test]
    fn refused_bodies_say_why() {
        let (external, internal) = (gear(GearKind::External, 20), gear(GearKind::Internal, 100));
        let refused = ring(mm(100.0), mm(100.0), mm(10.0), density(STEEL));
        assert!(matches!(refused, Err(Error::OutOfRange { quantity: Quantity::BoreDiameter, .. })));
        let refused = ring(mm(100.0), mm(50.0), mm(10.0), density(0.0));
        assert!(matches!(
            refused,
            Err(Error::NotPositive { quantity: Quantity::Density, unit: "kg/m³", .. })
        ));
        let refused = ring(mm(100.0), mm(50.0), mm(f64::NAN), density(STEEL));
        assert!(matches!(refused, Err(Error::NotPositive { quantity: Quantity::Width, .. })));
        let refused = GearBody::external(&external, mm(60.0), mm(140.8), density(STEEL));
        assert!(matches!(refused, Err(Error::OutOfRange { quantity: Quantity::BoreDiameter, .. })));
        let refused = GearBody::internal(&internal, mm(60.0), mm(819.2), density(STEEL));
        assert!(matches!(refused, Err(Error::NotAbove { quantity: Quantity::RimDiameter, .. })));
        let refused = GearBody::external(&internal, mm(60.0), mm(0.0), density(STEEL));
        assert_eq!(
            refused,
            Err(Error::WrongGearKind { given: GearKind::Internal, wanted: GearKind::External })
        );
        let refused = GearBody::internal(&external, mm(60.0), mm(900.0), density(STEEL));
        assert_eq!(
            refused,
            Err(Error::WrongGearKind { given: GearKind::External, wanted: GearKind::Internal })
        );
        let eight = |kg, tip, root, bore| {
            published_gear_inertia(FormulaEight::Likely, Mass::from_si(kg), mm(tip), mm(root), mm(bore))
        };
        assert!(matches!(
            eight(0.0, 3.0, 2.0, 1.0),
            Err(Error::NotPositive { quantity: Quantity::Mass, .. })
        ));
        assert!(matches!(
            eight(1.0, 3.0, 3.0, 1.0),
            Err(Error::OutOfRange { quantity: Quantity::RootDiameter, .. })
        ));
        assert!(matches!(
            eight(1.0, 3.0, 2.0, 2.0),
            Err(Error::OutOfRange { quantity: Quantity::BoreDiameter, .. })
        ));
    }
}
