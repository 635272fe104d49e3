//! The rules for gearboxes and hydromotors: what each looks at, its bounds, their source, a remedy.
//!
//! Limits that are said to be of usual practice have no printed source: engineers hold to them, and a design
//! beyond them is asked for its reason.

use crate::Severity::{Error, Remark, Warning};
use crate::{Bounds, Range};
use strum::VariantArray;

/// Rule of practice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, VariantArray, strum::IntoStaticStr, strum::EnumString)]
#[strum(serialize_all = "kebab-case")]
pub enum Rule {
    /// Face width over the reference diameter of the smaller gear of a mesh.
    FaceWidth,
    /// Greatest specific sliding of a mesh, by amount.
    SpecificSliding,
    /// Profile shift coefficient of a sun.
    SunShift,
    /// Profile shift coefficient of a planet.
    PlanetShift,
    /// Profile shift coefficient of a ring, positive inwards.
    RingShift,
    /// Profile shift coefficient of a gear on a fixed axis.
    GearShift,
    /// Sum of the shifts of an external mesh.
    ShiftSum,
    /// Working pressure angle of an external mesh, transverse; the bounds move with the pressure angle.
    ExternalAngle,
    /// Working pressure angle of an internal mesh, transverse; the bounds move with the pressure angle.
    InternalAngle,
    /// Thickness of the tips of case-hardened teeth, in modules.
    HardenedTips,
    /// Transverse contact ratio of spur gears.
    SpurContact,
    /// Total contact ratio of helical gears.
    HelicalContact,
    /// Clearance between tips and roots, in modules.
    RootClearance,
    /// Greatest common divisor of the teeth of a mesh.
    HuntingTooth,
    /// Rim of a ring below its roots, in modules.
    RingRim,
    /// Rim of a planet below its roots, in modules.
    PlanetRim,
    /// Gap between the tips of neighbouring planets, in modules.
    NeighbourGap,
    /// Gap between the tips of neighbouring planets, in mm.
    NeighbourGapLength,
    /// Speed of a planet on its pin times the mean diameter of its bearing, in mm/min.
    PinSpeed,
    /// Speed times mean diameter of a bearing full of rollers, without a cage, in mm/min.
    FullPinSpeed,
    /// Acceleration of the planets about the axis, in g.
    OrbitAcceleration,
    /// Acceleration of planets on caged needles about the axis, in g.
    NeedleAcceleration,
    /// Pitch-line speed of spur gears, in m/s.
    SpurSpeed,
    /// Pitch-line speed of helical gears, in m/s.
    HelicalSpeed,
    /// Life of a planet bearing, in h.
    BearingLife,
    /// Static safety of a planet bearing.
    BearingStaticSafety,
    /// Greatest load of a ball bearing of a planet, in kN.
    BallLoad,
    /// Equivalent load of a planet bearing over its load rating.
    BearingLeastLoad,
    /// Load of a plain bearing of a planet over the load that it may bear.
    PlainLoad,
    /// Oil film of a plain bearing over the least one with which mixed friction is away.
    OilFilm,
    /// Heat of a plain bearing, which nothing here calculates.
    PlainHeat,
    /// Dynamic factor `K_v`.
    DynamicFactor,
    /// Distance of the reference speed `N` from resonance at 1.
    Resonance,
    /// Load sharing factor `K_γ`.
    LoadSharing,
    /// Face load factor `K_Hβ`.
    FaceLoad,
    /// Safety of a flank.
    FlankSafety,
    /// Safety of a root.
    RootSafety,
    /// Circulating power over the power that enters.
    CirculatingPower,
    /// Efficiency of a stage.
    StageEfficiency,
    /// Temperature of the oil, in °C.
    OilTemperature,
    /// Deviation of a ratio from the one asked for, over that.
    RatioDeviation,
    /// Direction of the output: 1 as asked for, -1 against it.
    Direction,
    /// Scuffing of the flanks, which nothing here calculates.
    Scuffing,
    /// Micropitting of the flanks, which nothing here calculates.
    Micropitting,
    /// Pressure drop of a hydromotor, in MPa, against the one that its material allows.
    AllowedPressure,
    /// Pressure drop of a hydromotor with oil, in MPa.
    MotorPressure,
    /// Greatest contact stress of the flanks of a hydromotor, in MPa, where its material states no limits.
    ContactStress,
    /// Ripple of flow and torque of a hydromotor, over their mean.
    Ripple,
    /// Change of the pressure in a chamber of a hydromotor that no port is open to, in MPa.
    TrappedPressure,
    /// Axial gap at a face of a wheel of a hydromotor, in µm.
    AxialGap,
    /// Volumetric efficiency of a hydromotor.
    VolumetricEfficiency,
    /// Clearance between parts of a hydromotor, in modules; below 0 they overlap.
    Overlap,
    /// Least area of a chamber of a hydromotor, in mm².
    ChamberArea,
}

/// Absolute zero in °C.
const ABSOLUTE_ZERO_C: f64 = -273.15;

const PRACTICE: &str = "usual practice";

/// Source of a limit that is stated in place of the usual one.
pub(crate) const STATED: &str = "what is stated";

impl Rule {
    /// Every rule.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// Name in output for programs, and of the limit in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The quantity in words.
    #[must_use]
    pub const fn what(self) -> &'static str {
        match self {
            Self::FaceWidth => "face width over the diameter of the smaller gear",
            Self::SpecificSliding => "specific sliding",
            Self::SunShift | Self::PlanetShift | Self::RingShift | Self::GearShift => "profile shift",
            Self::ShiftSum => "sum of the profile shifts",
            Self::ExternalAngle | Self::InternalAngle => "working pressure angle",
            Self::HardenedTips => "thickness of case-hardened tips",
            Self::SpurContact => "contact ratio",
            Self::HelicalContact => "total contact ratio",
            Self::RootClearance => "clearance between tips and roots",
            Self::HuntingTooth => "common divisor of the teeth",
            Self::RingRim | Self::PlanetRim => "rim below the roots",
            Self::NeighbourGap | Self::NeighbourGapLength => "gap between neighbouring planets",
            Self::PinSpeed => "bearing speed n·d_m",
            Self::FullPinSpeed => "speed n·d_m of a bearing full of rollers",
            Self::OrbitAcceleration | Self::NeedleAcceleration => {
                "acceleration of the planets about the axis"
            }
            Self::SpurSpeed | Self::HelicalSpeed => "pitch-line speed",
            Self::BearingLife => "bearing life",
            Self::BearingStaticSafety => "static safety of the bearing",
            Self::BallLoad => "load of a ball bearing",
            Self::BearingLeastLoad => "equivalent load of the bearing over its load rating",
            Self::PlainLoad => "load of the plain bearing over its load rating",
            Self::OilFilm => "oil film of the plain bearing over the least one",
            Self::PlainHeat => "heat of plain bearings",
            Self::DynamicFactor => "dynamic factor K_v",
            Self::Resonance => "distance of the reference speed N from 1",
            Self::LoadSharing => "load sharing factor K_gamma",
            Self::FaceLoad => "face load factor K_H_beta",
            Self::FlankSafety => "safety of the flank",
            Self::RootSafety => "safety of the root",
            Self::CirculatingPower => "circulating power over the power that enters",
            Self::StageEfficiency => "efficiency of a stage",
            Self::OilTemperature => "oil temperature",
            Self::RatioDeviation => "deviation of the ratio from the one asked for",
            Self::Direction => "direction of the output over the one asked for",
            Self::Scuffing => "scuffing",
            Self::Micropitting => "micropitting",
            Self::AllowedPressure | Self::MotorPressure => "pressure drop",
            Self::ContactStress => "contact stress",
            Self::Ripple => "ripple of flow and torque",
            Self::TrappedPressure => "change of the pressure in a closed chamber",
            Self::AxialGap => "axial gap",
            Self::VolumetricEfficiency => "volumetric efficiency",
            Self::Overlap => "clearance between parts of the motor",
            Self::ChamberArea => "least area of a chamber",
        }
    }

    /// Unit of the value; empty for a plain number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::HardenedTips
            | Self::RootClearance
            | Self::RingRim
            | Self::PlanetRim
            | Self::NeighbourGap
            | Self::Overlap => "modules",
            Self::NeighbourGapLength => "mm",
            Self::ExternalAngle | Self::InternalAngle => "°",
            Self::PinSpeed | Self::FullPinSpeed => "mm/min",
            Self::OrbitAcceleration | Self::NeedleAcceleration => "g",
            Self::SpurSpeed | Self::HelicalSpeed => "m/s",
            Self::BallLoad => "kN",
            Self::BearingLife => "h",
            Self::OilTemperature => "°C",
            Self::AllowedPressure | Self::MotorPressure | Self::ContactStress | Self::TrappedPressure => {
                "MPa"
            }
            Self::AxialGap => "µm",
            Self::ChamberArea => "mm²",
            _ => "",
        }
    }

    /// The usual bounds; open where the limit [follows from the gearbox](Self::own_limit).
    #[must_use]
    pub const fn bounds(self) -> Bounds {
        use Bounds as Of;
        let none = Of::of(Remark, Range::OPEN);
        match self {
            Self::FaceWidth => Of::of(Remark, Range::between(0.5, 1.1))
                .and(Warning, Range::between(0.4, 1.2))
                .and(Error, Range::at_most(2.0)),
            Self::SpecificSliding => Of::of(Remark, Range::at_most(2.0)).and(Warning, Range::at_most(3.0)),
            // A shift 0.2 outside the usual range is worth a remark only: sets without any shift are common.
            Self::SunShift => shift([0.2, 0.65], [0.0, 0.85]),
            Self::PlanetShift => shift([-0.2, 0.55], [-0.4, 0.85]),
            Self::RingShift => shift([-0.6, 0.5], [-0.8, 0.7]),
            Self::GearShift => shift([-0.2, 0.85], [-0.6, 0.95]),
            Self::ShiftSum => Of::of(Warning, Range::between(0.0, 1.45)),
            Self::ExternalAngle => Of::of(Warning, Range::between(20.0, 28.5)),
            Self::InternalAngle => Of::of(Warning, Range::between(15.0, 22.0)),
            Self::HardenedTips => Of::of(Warning, Range::at_least(0.4)),
            Self::SpurContact => Of::of(Remark, Range::at_least(1.3))
                .and(Warning, Range::at_least(1.2))
                .and(Error, Range::at_least(1.1)),
            Self::HelicalContact => Of::of(Error, Range::at_least(1.2)),
            Self::RootClearance => Of::of(Warning, Range::at_least(0.15)).and(Error, Range::at_least(0.05)),
            Self::HuntingTooth => Of::of(Remark, Range::at_most(1.0)),
            Self::RingRim => Of::of(Remark, Range::at_least(3.5)).and(Error, Range::at_least(1.75)),
            Self::PlanetRim => Of::of(Remark, Range::at_least(2.7)).and(Error, Range::at_least(1.13)),
            Self::NeighbourGap => Of::of(Warning, Range::at_least(0.5)),
            Self::NeighbourGapLength => Of::of(Warning, Range::at_least(1.0)),
            Self::PinSpeed => Of::of(Warning, Range::at_most(5e5)),
            Self::FullPinSpeed => Of::of(Warning, Range::at_most(2e5)),
            Self::OrbitAcceleration => Of::of(Warning, Range::at_most(150.0)),
            Self::NeedleAcceleration => Of::of(Warning, Range::at_most(3000.0)),
            Self::SpurSpeed => Of::of(Remark, Range::at_most(15.0)).and(Warning, Range::at_most(20.0)),
            Self::HelicalSpeed => Of::of(Remark, Range::at_most(15.0)).and(Warning, Range::at_most(50.0)),
            Self::BallLoad => Of::of(Warning, Range::at_most(10.0)),
            Self::BearingStaticSafety => Of::of(Warning, Range::at_least(1.5)),
            Self::BearingLeastLoad => Of::of(Warning, Range::at_least(0.02)),
            Self::PlainLoad => Of::of(Error, Range::at_most(1.0)),
            Self::OilFilm => Of::of(Warning, Range::at_least(1.0)),
            Self::DynamicFactor => Of::of(Warning, Range::at_most(1.3)).and(Error, Range::at_most(2.0)),
            Self::Resonance => Of::of(Warning, Range::at_least(0.15)),
            Self::CirculatingPower => Of::of(Warning, Range::at_most(0.5)),
            Self::StageEfficiency => {
                Of::of(Remark, Range::at_least(0.97)).and(Warning, Range::at_least(0.95))
            }
            Self::OilTemperature => Of::of(Warning, Range::at_most(90.0)).and(Error, Range::at_most(110.0)),
            Self::RatioDeviation => Of::of(Warning, Range::at_most(0.03)),
            Self::Direction => Of::of(Error, Range::at_least(1.0)),
            Self::MotorPressure => Of::of(Warning, Range::at_most(25.0)),
            Self::ContactStress => Of::of(Warning, Range::at_most(1600.0)),
            Self::Ripple => Of::of(Remark, Range::at_most(0.05)).and(Warning, Range::at_most(0.1)),
            Self::AxialGap => Of::of(Warning, Range::between(5.0, 15.0)),
            Self::VolumetricEfficiency => Of::of(Warning, Range::at_least(0.85)),
            Self::Overlap | Self::ChamberArea => Of::of(Error, Range::at_least(0.0)),
            Self::AllowedPressure
            | Self::TrappedPressure
            | Self::BearingLife
            | Self::LoadSharing
            | Self::FaceLoad
            | Self::FlankSafety
            | Self::RootSafety
            | Self::PlainHeat
            | Self::Scuffing
            | Self::Micropitting => none,
        }
    }

    /// Severity of a value beyond a limit that follows from the gearbox or motor, and this limit in words.
    #[must_use]
    pub const fn own_limit(self) -> Option<(crate::Severity, &'static str)> {
        match self {
            Self::BearingLife => Some((Error, "at least the required `life`")),
            Self::FlankSafety | Self::RootSafety => Some((Error, "at least the safety of `required`")),
            Self::LoadSharing => Some((Warning, "at least the usual factor of the number of planets")),
            Self::FaceLoad => Some((Warning, "at least 1 + 0.4·(b/d_1)²")),
            Self::RatioDeviation => Some((Error, "at most the tolerance asked for")),
            Self::AllowedPressure => Some((Warning, "at most the pressure that the material allows")),
            Self::TrappedPressure => Some((Warning, "at most `most_trapped`, or the pressure drop")),
            _ => None,
        }
    }

    /// Whether a range may be [stated](crate::Limits::state) for a gearbox in place of the usual one. Rules
    /// without values have none, nor those of searches and hydromotors, nor limits that follow from the
    /// gearbox.
    #[must_use]
    pub const fn is_statable(self) -> bool {
        let is_other = matches!(
            self,
            Self::Direction
                | Self::PlainHeat
                | Self::Scuffing
                | Self::Micropitting
                | Self::MotorPressure
                | Self::ContactStress
                | Self::Ripple
                | Self::AxialGap
                | Self::VolumetricEfficiency
                | Self::Overlap
                | Self::ChamberArea
        );
        self.own_limit().is_none() && !is_other
    }

    /// Values that the quantity can have.
    #[must_use]
    pub const fn values(self) -> Range {
        match self {
            Self::SunShift
            | Self::PlanetShift
            | Self::RingShift
            | Self::GearShift
            | Self::ShiftSum
            | Self::Overlap => Range::OPEN,
            Self::OilTemperature => Range::at_least(ABSOLUTE_ZERO_C),
            Self::ExternalAngle | Self::InternalAngle => Range::between(0.0, 90.0),
            Self::StageEfficiency | Self::VolumetricEfficiency => Range::between(0.0, 1.0),
            Self::HuntingTooth | Self::DynamicFactor => Range::at_least(1.0),
            Self::Direction => Range::between(-1.0, 1.0),
            _ => Range::at_least(0.0),
        }
    }

    /// Whether every value lies above the least of [`values`](Self::values).
    #[must_use]
    pub const fn is_above_least(self) -> bool {
        matches!(
            self,
            Self::FaceWidth
                | Self::SpurContact
                | Self::HelicalContact
                | Self::ExternalAngle
                | Self::InternalAngle
                | Self::OilTemperature
                | Self::StageEfficiency
        )
    }

    /// Whether a range leaves any of the [`values`](Self::values).
    #[must_use]
    pub fn leaves_values(self, range: Range) -> bool {
        let values = self.values();
        range.least <= range.most && if self.is_above_least() { range.most > values.least } else { true }
    }

    /// Whether the ratio of value and limit says how much is left.
    #[must_use]
    pub const fn has_margin(self) -> bool {
        match self {
            // A sign, and what a search chooses within its tolerance.
            Self::Direction | Self::RatioDeviation => false,
            // Chosen by the designer, often 0 or at an end of the range on purpose; a divisor only counts.
            Self::SunShift
            | Self::PlanetShift
            | Self::RingShift
            | Self::GearShift
            | Self::ShiftSum
            | Self::ExternalAngle
            | Self::InternalAngle
            | Self::HuntingTooth => false,
            // Stated values, not results.
            Self::LoadSharing | Self::FaceLoad => false,
            // Near 1 in every gearbox, however good or bad.
            Self::StageEfficiency | Self::DynamicFactor | Self::VolumetricEfficiency => false,
            // 0 °C is an arbitrary zero.
            Self::OilTemperature => false,
            Self::Scuffing | Self::Micropitting => false,
            _ => true,
        }
    }

    /// Who states the bounds.
    #[must_use]
    pub const fn source(self) -> &'static str {
        match self {
            Self::RingRim | Self::PlanetRim => "the rim factor of ISO 6336-3",
            Self::RootClearance => "the basic rack of ISO 53",
            Self::DynamicFactor | Self::Resonance => "ISO 6336-1",
            Self::LoadSharing => "ISO 6336-1:2019 and IEC 61400-4",
            Self::FaceLoad => "the textbook rule 1 + 0.4·(b/d_1)²",
            Self::FlankSafety
            | Self::RootSafety
            | Self::BearingLife
            | Self::RatioDeviation
            | Self::Direction => "what is required",
            Self::AllowedPressure => "the limits of the material",
            Self::Overlap | Self::ChamberArea => "the shape of the parts",
            Self::PinSpeed
            | Self::FullPinSpeed
            | Self::BearingStaticSafety
            | Self::BearingLeastLoad
            | Self::PlainLoad => "makers of bearings",
            Self::OilFilm => "ISO 7902",
            _ => PRACTICE,
        }
    }

    /// Remedy for a value that is too large, or too small.
    #[must_use]
    pub const fn remedy(self, is_too_large: bool) -> &'static str {
        match self {
            Self::FaceWidth if is_too_large => {
                "narrower gears of larger diameter, or more planets or stages where the diameter is bounded"
            }
            Self::FaceWidth => "wider gears of smaller diameter: smaller modules",
            Self::SpecificSliding => {
                "more teeth on the smaller gear, or another centre distance; where shifts are stated, those that `size` picks for equal sliding"
            }
            Self::SunShift | Self::PlanetShift | Self::RingShift | Self::GearShift => {
                "another centre distance, or other tooth numbers"
            }
            Self::ShiftSum | Self::ExternalAngle | Self::InternalAngle => "another centre distance",
            Self::HardenedTips => "less profile shift, or shorter tips",
            Self::SpurContact | Self::HelicalContact => "less profile shift, longer tips, or finer teeth",
            Self::RootClearance => "shorter tips (`tip_alterations`)",
            Self::HuntingTooth => "tooth numbers without a common divisor",
            Self::RingRim => "a larger outside diameter of the ring",
            Self::PlanetRim => "a smaller bore, or more planet teeth",
            Self::NeighbourGap | Self::NeighbourGapLength => "fewer planets, or shorter tips",
            Self::PinSpeed | Self::FullPinSpeed => "a smaller bearing, or a slower planet: more planet teeth",
            Self::OrbitAcceleration | Self::NeedleAcceleration => {
                "a smaller carrier radius, or a slower carrier"
            }
            Self::SpurSpeed => "helical teeth, or smaller gears",
            Self::HelicalSpeed => "smaller gears",
            Self::BearingLife => "a bearing with a larger load rating, wider planets, or more of them",
            Self::BearingStaticSafety => "a bearing with a larger static load rating",
            Self::BallLoad => "roller or needle bearings",
            Self::BearingLeastLoad => "a smaller bearing",
            Self::PlainLoad => "a larger bore of wider planets, or more of them",
            Self::OilFilm => "thicker oil, or a larger bore of wider planets",
            Self::DynamicFactor => "finer accuracy, or a lower speed",
            Self::Resonance => "other tooth numbers or another speed",
            Self::LoadSharing => "state what the factor was measured with, or the usual value",
            Self::FaceLoad => "narrower gears, or state the usual value",
            Self::FlankSafety | Self::RootSafety => "a larger module, wider gears, or a stronger material",
            Self::CirculatingPower => "another scheme: circulating power loads teeth and costs power",
            Self::StageEfficiency => "better meshes, or another scheme",
            Self::OilTemperature => "a cooler, or a larger housing",
            Self::RatioDeviation => "other tooth numbers",
            Self::Direction => "another scheme, or one external mesh more",
            Self::PlainHeat => "calculate its heat and flow of oil by ISO 7902",
            Self::Scuffing => "rate it by ISO/TS 6336-20 or -21",
            Self::Micropitting => "rate it by ISO/TS 6336-22",
            Self::AllowedPressure | Self::ContactStress => "a larger module, or less pressure",
            Self::MotorPressure => "less pressure: more displacement",
            Self::Ripple => "other numbers of lobes, or another place in the family",
            Self::TrappedPressure => "open the ports earlier, or give the chamber more dead volume",
            Self::AxialGap if is_too_large => "smaller gaps: they leak",
            Self::AxialGap => "larger gaps: the wheels jam",
            Self::VolumetricEfficiency => "smaller gaps, or thicker oil",
            Self::Overlap => "less tooth height, or another place in the family",
            Self::ChamberArea => "another place in the family",
        }
    }
}

/// Bounds of a profile shift: ranges for remarks and warnings; beyond 1 teeth lose their form.
const fn shift(usual: [f64; 2], warned: [f64; 2]) -> Bounds {
    Bounds::of(Remark, Range::between(usual[0], usual[1]))
        .and(Warning, Range::between(warned[0], warned[1]))
        .and(Error, Range::between(-1.0, 1.0))
}
