//! Diameters of a spur gear from its module, teeth and basic rack; centre distance of a pair.
//!
//! Uncorrected gears (no profile shift). Left out: interference, tip relief, and whether the tip of an
//! internal gear stays outside its base circle.

use epicyclic_units::Physical;
use uom::si::f64::Length;

use crate::checks::{positive, positive_length};
pub use crate::gear_kind::GearKind;
use crate::mesh::{Gear, Mesh};
pub use crate::rack::BasicRack;
use crate::tolerance::SAME;
use crate::{Error, Quantity, ToothCount};

/// A spur gear without profile shift, whose circles all exist.
///
/// ```text
/// d = m·z    d_b = d·cos α    external: d_a = d + 2·h_a*·m,  d_f = d − 2·(h_a* + c*)·m
///                             internal: d_a = d − 2·h_a*·m,  d_f = d + 2·(h_a* + c*)·m
/// ```
///
/// | symbol | accessor | meaning | unit |
/// |---|---|---|---|
/// | `m` | [`module`](Self::module) | module | mm |
/// | `z` | [`teeth`](Self::teeth) | teeth | 1 |
/// | `d` | [`pitch_diameter`](Self::pitch_diameter) | pitch diameter | mm |
/// | `d_a` | [`tip_diameter`](Self::tip_diameter) | tip diameter | mm |
/// | `d_f` | [`root_diameter`](Self::root_diameter) | root diameter | mm |
/// | `d_b` | [`base_diameter`](Self::base_diameter) | base diameter | mm |
///
/// # Source
/// excavator-dynamics, section 4.
///
/// # Example
/// ```
/// use epicyclic_gears::geometry::{BasicRack, GearKind, ToothedGear};
/// use epicyclic_gears::ToothCount;
/// use uom::si::{f64::Length, length::millimeter};
///
/// let rack = BasicRack { clearance: 0.2, ..BasicRack::default() };
/// let module = Length::new::<millimeter>(8.0);
/// let sun = ToothedGear::new(GearKind::External, module, ToothCount::new(20)?, rack)?;
/// assert!((sun.pitch_diameter().get::<millimeter>() - 160.0).abs() < 1e-9);
/// assert!((sun.tip_diameter().get::<millimeter>() - 176.0).abs() < 1e-9);
/// assert!((sun.root_diameter().get::<millimeter>() - 140.8).abs() < 1e-9);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToothedGear {
    kind: GearKind,
    module: Length,
    teeth: ToothCount,
    rack: BasicRack,
}

impl ToothedGear {
    /// A gear whose pitch, tip, root and base circles are all positive.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the module or `h_a*`, [`Error::Negative`] for `c*`, [`Error::OutOfRange`]
    /// for a pressure angle outside 0…90°, [`Error::NoRoot`] or [`Error::NoInternalTip`] for too few teeth.
    pub fn new(kind: GearKind, module: Length, teeth: ToothCount, rack: BasicRack) -> Result<Self, Error> {
        positive_length(Quantity::Module, module)?;
        positive(Quantity::AddendumCoefficient, rack.addendum, "")?;
        rack.check()?;
        let gear = Self { kind, module, teeth, rack };
        let z = teeth.get();
        match kind {
            GearKind::External if gear.root_in_modules() <= 0.0 => Err(Error::NoRoot {
                teeth: z,
                root_mm: gear.root_diameter().mm(),
                at_least: first_above(2.0 * (rack.addendum + rack.clearance)),
            }),
            GearKind::Internal if gear.tip_in_modules() <= 0.0 => Err(Error::NoInternalTip {
                teeth: z,
                tip_mm: gear.tip_diameter().mm(),
                at_least: first_above(2.0 * rack.addendum),
            }),
            GearKind::External | GearKind::Internal => Ok(gear),
        }
    }

    /// An external gear on the default [`BasicRack`].
    ///
    /// # Errors
    /// As [`ToothedGear::new`].
    pub fn external(module: Length, teeth: ToothCount) -> Result<Self, Error> {
        Self::new(GearKind::External, module, teeth, BasicRack::default())
    }

    /// An internal gear on the default [`BasicRack`].
    ///
    /// # Errors
    /// As [`ToothedGear::new`].
    pub fn internal(module: Length, teeth: ToothCount) -> Result<Self, Error> {
        Self::new(GearKind::Internal, module, teeth, BasicRack::default())
    }

    /// External or internal.
    #[must_use]
    pub const fn kind(&self) -> GearKind {
        self.kind
    }

    /// Module `m`.
    #[must_use]
    pub const fn module(&self) -> Length {
        self.module
    }

    /// Teeth `z`.
    #[must_use]
    pub const fn teeth(&self) -> ToothCount {
        self.teeth
    }

    /// The basic rack it is cut by.
    #[must_use]
    pub const fn rack(&self) -> BasicRack {
        self.rack
    }

    /// Pitch diameter `d = m·z`.
    #[must_use]
    pub fn pitch_diameter(&self) -> Length {
        self.module * (2.0 * self.circles().pitch_radius())
    }

    /// Tip diameter `d_a`: the largest of an external gear, the smallest of an internal one.
    #[must_use]
    pub fn tip_diameter(&self) -> Length {
        self.module * self.tip_in_modules()
    }

    /// Root diameter `d_f`: the bottom of the tooth spaces.
    #[must_use]
    pub fn root_diameter(&self) -> Length {
        self.module * self.root_in_modules()
    }

    /// Base diameter `d_b = d·cos α`, from which the involute unwinds.
    #[must_use]
    pub fn base_diameter(&self) -> Length {
        self.pitch_diameter() * libm::cos(self.rack.pressure_angle.si())
    }

    /// Circles of the gear, in modules.
    #[must_use]
    pub fn circles(&self) -> Gear {
        Gear::new(self.kind, self.teeth.as_f64())
    }

    fn tip_in_modules(&self) -> f64 {
        2.0 * self.circles().tip_radius(&self.rack)
    }

    fn root_in_modules(&self) -> f64 {
        2.0 * self.circles().root_radius(&self.rack)
    }
}

/// Centre distance `a` of two gears in mesh without profile shift.
///
/// ```text
/// external pair: a = m·(z₁ + z₂)/2        internal pair: a = m·(z_internal − z_external)/2
/// ```
///
/// The order of the gears does not matter.
///
/// # Errors
/// [`Error::ModulesDiffer`], [`Error::PressureAnglesDiffer`], [`Error::BothInternal`],
/// [`Error::InternalNotLarger`].
///
/// # Source
/// excavator-dynamics (1): coaxiality is this distance, equal for sun–planet and planet–ring.
///
/// # Example
/// ```
/// use epicyclic_gears::geometry::{centre_distance, ToothedGear};
/// use epicyclic_gears::ToothCount;
/// use uom::si::{f64::Length, length::millimeter};
///
/// let module = Length::new::<millimeter>(8.0);
/// let sun = ToothedGear::external(module, ToothCount::new(20)?)?;
/// let planet = ToothedGear::external(module, ToothCount::new(40)?)?;
/// let ring = ToothedGear::internal(module, ToothCount::new(100)?)?;
/// assert!((centre_distance(&sun, &planet)?.get::<millimeter>() - 240.0).abs() < 1e-9);
/// assert!((centre_distance(&ring, &planet)?.get::<millimeter>() - 240.0).abs() < 1e-9);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn centre_distance(first: &ToothedGear, second: &ToothedGear) -> Result<Length, Error> {
    let (first_mm, second_mm) = (first.module.mm(), second.module.mm());
    if !same(first_mm, second_mm) {
        return Err(Error::ModulesDiffer { first_mm, second_mm });
    }
    let (first_deg, second_deg) = (first.rack.pressure_angle.degrees(), second.rack.pressure_angle.degrees());
    if !same(first_deg, second_deg) {
        return Err(Error::PressureAnglesDiffer { first_deg, second_deg });
    }
    let (z1, z2) = (first.teeth, second.teeth);
    let internal_pair = |internal: ToothCount, external: ToothCount| {
        if internal > external {
            return Ok(Mesh::internal(internal.as_f64(), external.as_f64()));
        }
        Err(Error::InternalNotLarger { internal: internal.get(), external: external.get() })
    };
    let mesh = match (first.kind, second.kind) {
        (GearKind::External, GearKind::External) => Mesh::external(z1.as_f64(), z2.as_f64()),
        (GearKind::Internal, GearKind::External) => internal_pair(z1, z2)?,
        (GearKind::External, GearKind::Internal) => internal_pair(z2, z1)?,
        (GearKind::Internal, GearKind::Internal) => {
            return Err(Error::BothInternal { first: z1.get(), second: z2.get() });
        }
    };
    Ok(first.module * mesh.centre_distance())
}

fn same(first: f64, second: f64) -> bool {
    (first - second).abs() <= SAME * first.abs().max(second.abs())
}

/// The first whole number of teeth above `modules`.
fn first_above(modules: f64) -> u32 {
    // A float cast to an integer saturates, so an absurd coefficient gives u32::MAX teeth.
    (modules.floor() as u32).saturating_add(1)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    use super::*;

    fn teeth(count: u32) -> ToothCount {
        ToothCount::new(count).unwrap()
    }

    fn rack(clearance: f64) -> BasicRack {
        BasicRack { clearance, ..BasicRack::default() }
    }

    fn gear(kind: GearKind, count: u32) -> ToothedGear {
        ToothedGear::new(kind, Length::from_mm(8.0), teeth(count), rack(0.2)).unwrap()
    }

    fn assert_mm(actual: Length, expected_mm: f64) {
        // 1 nm: rounding of millimetres to metres and back, nothing physical.
        assert!((actual.mm() - expected_mm).abs() < 1e-6, "{actual:?} is not {expected_mm} mm");
    }

    #[test]
    fn diameters_of_the_excavator_drive() {
        for (kind, z, pitch, tip, root) in [
            (GearKind::External, 20, 160.0, 176.0, 140.8),
            (GearKind::External, 40, 320.0, 336.0, 300.8),
            (GearKind::Internal, 100, 800.0, 784.0, 819.2),
        ] {
            let gear = gear(kind, z);
            assert_mm(gear.pitch_diameter(), pitch);
            assert_mm(gear.tip_diameter(), tip);
            assert_mm(gear.root_diameter(), root);
        }
        // 160·cos 20° by table: 160·0.9396926208.
        assert_mm(gear(GearKind::External, 20).base_diameter(), 150.350_819);
    }

    #[test]
    fn default_rack_has_a_quarter_module_of_clearance() {
        let sun = ToothedGear::external(Length::from_mm(8.0), teeth(20)).unwrap();
        assert_mm(sun.root_diameter(), 140.0);
        let ring = ToothedGear::internal(Length::from_mm(8.0), teeth(100)).unwrap();
        assert_mm(ring.root_diameter(), 820.0);
    }

    #[test]
    fn refused_gears_say_why() {
        let z = teeth(20);
        let of = |module_mm, rack| ToothedGear::new(GearKind::External, Length::from_mm(module_mm), z, rack);
        for bad in [0.0, -8.0, f64::NAN, f64::INFINITY] {
            let refused = of(bad, rack(0.2));
            assert!(matches!(
                refused,
                Err(Error::NotPositive { quantity: Quantity::Module, unit: "mm", .. })
            ));
            let refused = of(8.0, BasicRack { addendum: bad, ..BasicRack::default() });
            assert!(matches!(
                refused,
                Err(Error::NotPositive { quantity: Quantity::AddendumCoefficient, .. })
            ));
        }
        assert!(matches!(
            of(8.0, rack(-0.1)),
            Err(Error::Negative { quantity: Quantity::ClearanceCoefficient, .. })
        ));
        for bad in [0.0, 90.0, f64::NAN] {
            let rack = BasicRack { pressure_angle: Angle::from_degrees(bad), ..BasicRack::default() };
            assert!(matches!(
                of(8.0, rack),
                Err(Error::OutOfRange { quantity: Quantity::PressureAngle, .. })
            ));
        }
        let two = ToothedGear::external(Length::from_mm(8.0), teeth(2));
        assert!(matches!(two, Err(Error::NoRoot { teeth: 2, at_least: 3, root_mm }) if root_mm < 0.0));
        let two = ToothedGear::internal(Length::from_mm(8.0), teeth(2));
        assert!(
            matches!(two, Err(Error::NoInternalTip { teeth: 2, at_least: 3, tip_mm }) if tip_mm.abs() < 1e-9)
        );
    }

    /// Two spellings of a module differ by rounding; what differs by more is another module.
    #[test]
    fn modules_and_pressure_angles_are_the_same_to_a_part_in_1e12() {
        let with = |module: f64, alpha: f64| {
            let rack = BasicRack { pressure_angle: Angle::from_degrees(alpha), ..BasicRack::default() };
            ToothedGear::new(GearKind::External, Length::from_mm(module), teeth(20), rack).unwrap()
        };
        let one = with(8.0, 20.0);
        assert!(centre_distance(&one, &with(8.0 * (1.0 + 5e-13), 20.0 * (1.0 - 5e-13))).is_ok());
        let other = with(8.0 * (1.0 + 4e-12), 20.0);
        assert!(matches!(centre_distance(&one, &other), Err(Error::ModulesDiffer { .. })));
        let other = with(8.0, 20.0 * (1.0 + 4e-12));
        assert!(matches!(centre_distance(&one, &other), Err(Error::PressureAnglesDiffer { .. })));
    }

    #[test]
    fn refused_pairs_say_why() {
        let (sun, ring) = (gear(GearKind::External, 20), gear(GearKind::Internal, 100));
        let finer = ToothedGear::new(GearKind::External, Length::from_mm(6.0), teeth(40), rack(0.2)).unwrap();
        assert!(matches!(centre_distance(&sun, &finer), Err(Error::ModulesDiffer { .. })));
        let steeper = BasicRack { pressure_angle: Angle::from_degrees(25.0), ..BasicRack::default() };
        let steeper = ToothedGear::new(GearKind::External, Length::from_mm(8.0), teeth(40), steeper).unwrap();
        assert!(matches!(centre_distance(&sun, &steeper), Err(Error::PressureAnglesDiffer { .. })));
        assert_eq!(centre_distance(&ring, &ring), Err(Error::BothInternal { first: 100, second: 100 }));
        let planet = gear(GearKind::External, 100);
        let refused = Err(Error::InternalNotLarger { internal: 100, external: 100 });
        assert_eq!(centre_distance(&planet, &ring), refused);
    }

    proptest! {
        #[test]
        fn circles_are_in_order(z in 3_u32..400, m_mm in 0.1_f64..40.0, clearance in 0.0_f64..0.4, alpha in 10.0_f64..35.0) {
            let rack = BasicRack { addendum: 1.0, clearance, pressure_angle: Angle::from_degrees(alpha) };
            let module = Length::from_mm(m_mm);
            if let Ok(gear) = ToothedGear::new(GearKind::External, module, teeth(z), rack) {
                prop_assert!(gear.root_diameter().si() > 0.0);
                prop_assert!(gear.root_diameter() < gear.pitch_diameter());
                prop_assert!(gear.pitch_diameter() < gear.tip_diameter());
                prop_assert!(gear.base_diameter() < gear.pitch_diameter());
            }
            let ring = ToothedGear::new(GearKind::Internal, module, teeth(z), rack).unwrap();
            prop_assert!(ring.tip_diameter().si() > 0.0);
            prop_assert!(ring.tip_diameter() < ring.pitch_diameter());
            prop_assert!(ring.pitch_diameter() < ring.root_diameter());
        }

        /// At the standard centre distance tip and opposite root are `c*·m` apart, external and internal
        /// alike.
        #[test]
        fn clearance_is_left_between_tip_and_root(z in 5_u32..100, more in 1_u32..200, m_mm in 0.1_f64..40.0, clearance in 0.0_f64..0.4) {
            let of = |kind, z| ToothedGear::new(kind, Length::from_mm(m_mm), teeth(z), rack(clearance)).unwrap();
            let (pinion, mate) = (of(GearKind::External, z), of(GearKind::External, z + more));
            let gap = centre_distance(&pinion, &mate).unwrap() - (pinion.tip_diameter() + mate.root_diameter()) / 2.0;
            prop_assert!(((gap / pinion.module()).value - clearance).abs() < 1e-9);
            let ring = of(GearKind::Internal, z + more);
            let distance = centre_distance(&pinion, &ring).unwrap();
            prop_assert_eq!(distance, centre_distance(&ring, &pinion).unwrap());
            let gap = (ring.root_diameter() - pinion.tip_diameter()) / 2.0 - distance;
            prop_assert!(((gap / pinion.module()).value - clearance).abs() < 1e-9);
        }
    }
}
