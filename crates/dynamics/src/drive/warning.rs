//! What deserves a second look in a drive that could be calculated.

use super::part::{BoredGear, Shaft};
use std::fmt;

/// A finding about a drive that does not stop the calculation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// A given shaft is thinner than the formula asks for.
    ShaftTooThin {
        /// Which shaft.
        shaft: Shaft,
        /// Its diameter, mm.
        diameter_mm: f64,
        /// The diameter needed, mm.
        needed_mm: f64,
        /// Its torsional stress, MPa.
        stress_mpa: f64,
        /// The stress allowed, MPa.
        allowable_mpa: f64,
    },
    /// A given bearing does not go on the shaft.
    BearingTooNarrow {
        /// Which shaft.
        shaft: Shaft,
        /// Designation of the bearing.
        bearing: &'static str,
        /// Its bore, mm.
        bore_mm: f64,
        /// The shaft's diameter, mm.
        diameter_mm: f64,
    },
    /// No bearing of the series goes on the shaft.
    NoBearing {
        /// Which shaft.
        shaft: Shaft,
        /// Series sought in.
        series: u16,
        /// The shaft's diameter, mm.
        diameter_mm: f64,
    },
    /// A bearing whose dimensions were not found in a catalogue.
    UnverifiedBearing {
        /// Which shaft.
        shaft: Shaft,
        /// Designation of the bearing.
        bearing: &'static str,
    },
    /// An allowable stress outside 15…20 MPa.
    StressOutsideUsualRange {
        /// The stress given, MPa.
        allowable_mpa: f64,
    },
    /// A rack undercuts the gear.
    Undercut {
        /// Which gear.
        gear: BoredGear,
        /// Its teeth.
        teeth: u32,
        /// The fewest that are not undercut.
        at_least: u32,
    },
    /// The tips of adjacent planets touch or overlap.
    NoPlanetClearance {
        /// Number of planets.
        planets: u32,
        /// Gap between the tip circles, mm: 0 or less.
        gap_mm: f64,
        /// The most equally spaced planets that clear each other.
        most_planets: u32,
    },
    /// The tips of adjacent planets clear each other by less than was asked for.
    TipGapBelowWanted {
        /// Gap between the tip circles, mm.
        gap_mm: f64,
        /// The least gap wanted, mm.
        wanted_mm: f64,
    },
    /// The planets do not assemble at equal angles, and unequal ones were not allowed.
    UnequalSpacing {
        /// Number of planets.
        planets: u32,
        /// Angles at which a planet fits, `z_a + z_b`.
        slots: u64,
        /// Greatest deviation from equal spacing, degrees.
        deviation_deg: f64,
    },
    /// The given tooth numbers miss the wanted ratio by more than its tolerance.
    RatioDeparts {
        /// The ratio wanted.
        wanted: f64,
        /// The ratio they have.
        ratio: f64,
        /// Relative tolerance.
        tolerance: f64,
    },
    /// A ratio outside 3…10, the usual range of a single stage.
    RatioOutsideUsualRange {
        /// The ratio.
        ratio: f64,
    },
    /// The holes of the carrier's arms are not where the planets' pins are.
    PlanetPinOffCentre {
        /// Radius of the holes' centres, mm.
        hole_mm: f64,
        /// Centre distance of sun and planet, mm.
        centre_distance_mm: f64,
    },
    /// The carrier was taken as massless.
    CarrierNeglected,
}

impl Warning {
    /// Its name, which does not change: `shaft-too-thin`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::ShaftTooThin { .. } => "shaft-too-thin",
            Self::BearingTooNarrow { .. } => "bearing-too-narrow",
            Self::NoBearing { .. } => "no-bearing",
            Self::UnverifiedBearing { .. } => "unverified-bearing",
            Self::StressOutsideUsualRange { .. } => "stress-outside-usual-range",
            Self::Undercut { .. } => "undercut",
            Self::NoPlanetClearance { .. } => "neighbour-gap",
            Self::TipGapBelowWanted { .. } => "tip-gap-below-wanted",
            Self::UnequalSpacing { .. } => "unequal-spacing",
            Self::RatioDeparts { .. } => "ratio-departs",
            Self::RatioOutsideUsualRange { .. } => "ratio-outside-usual-range",
            Self::PlanetPinOffCentre { .. } => "pin-off-centre",
            Self::CarrierNeglected => "carrier-neglected",
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::ShaftTooThin { shaft, diameter_mm, needed_mm, stress_mpa, allowable_mpa } => write!(
                f,
                "the {shaft} of {diameter_mm:.1} mm is too thin: {stress_mpa:.1} MPa where {allowable_mpa:.1} MPa are \
                 allowed; at least {needed_mm:.1} mm needed"
            ),
            Self::BearingTooNarrow { shaft, bearing, bore_mm, diameter_mm } => write!(
                f,
                "bearing {bearing} with its bore of {bore_mm:.0} mm does not go on the {shaft} of {diameter_mm:.1} mm"
            ),
            Self::NoBearing { shaft, series, diameter_mm } => {
                write!(f, "no bearing of series {series} goes on the {shaft} of {diameter_mm:.1} mm")
            }
            Self::UnverifiedBearing { shaft, bearing } => {
                write!(
                    f,
                    "bearing {bearing} of the {shaft} was not found in a catalogue: check its dimensions"
                )
            }
            Self::StressOutsideUsualRange { allowable_mpa } => {
                write!(f, "an allowable stress of {allowable_mpa:.1} MPa is outside the usual 15 to 20 MPa")
            }
            Self::Undercut { gear, teeth, at_least } => {
                write!(f, "the {gear} with {teeth} teeth is undercut; {at_least} teeth are not")
            }
            Self::NoPlanetClearance { planets, gap_mm, most_planets } => write!(
                f,
                "{planets} planets do not clear each other: their tips overlap by {:.2} mm; at most {most_planets} do",
                -gap_mm
            ),
            Self::TipGapBelowWanted { gap_mm, wanted_mm } => write!(
                f,
                "the tips of adjacent planets clear each other by {gap_mm:.2} mm; {wanted_mm:.2} mm are wanted"
            ),
            Self::UnequalSpacing { planets, slots, deviation_deg } => write!(
                f,
                "{planets} planets do not assemble at equal angles (z_a + z_b = {slots} is no multiple); the least \
                 unequal spacing departs by {deviation_deg:.3}°"
            ),
            Self::RatioDeparts { wanted, ratio, tolerance } => write!(
                f,
                "the given teeth have the ratio {ratio:.4}, {:+.2} % off the wanted {wanted}; the tolerance is {:.2} %",
                100.0 * (ratio / wanted - 1.0),
                100.0 * tolerance
            ),
            Self::RatioOutsideUsualRange { ratio } => {
                write!(f, "a ratio of {ratio:.4} is outside the usual 3 to 10 of a single stage")
            }
            Self::PlanetPinOffCentre { hole_mm, centre_distance_mm } => write!(
                f,
                "the carrier's holes stand at a radius of {hole_mm:.2} mm, the planets at {centre_distance_mm:.2} mm"
            ),
            Self::CarrierNeglected => {
                f.write_str("the carrier was taken as massless: give its shape or its inertia")
            }
        }
    }
}
