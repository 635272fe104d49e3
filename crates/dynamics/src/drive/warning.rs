//! Warnings: findings to be checked in a drive that could be calculated.

use super::part::{BoredGear, Shaft};

/// A finding about a drive that does not stop the calculation.
#[derive(Debug, Clone, Copy, PartialEq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Warning {
    /// A given shaft is thinner than the formula requires.
    ShaftTooThin {
        /// The shaft.
        shaft: Shaft,
        /// Diameter of the shaft, mm.
        diameter_mm: f64,
        /// The diameter needed, mm.
        needed_mm: f64,
        /// Torsional stress of the shaft, MPa.
        stress_mpa: f64,
        /// The stress allowed, MPa.
        allowable_mpa: f64,
    },
    /// A given bearing does not go on the shaft.
    BearingTooNarrow {
        /// The shaft.
        shaft: Shaft,
        /// Designation of the bearing.
        bearing: &'static str,
        /// Bore of the bearing, mm.
        bore_mm: f64,
        /// The shaft's diameter, mm.
        diameter_mm: f64,
    },
    /// No bearing of the series goes on the shaft.
    NoBearing {
        /// The shaft.
        shaft: Shaft,
        /// Series from which the bearing is taken.
        series: u16,
        /// The shaft's diameter, mm.
        diameter_mm: f64,
    },
    /// A bearing whose dimensions were not found in a catalogue.
    UnverifiedBearing {
        /// The shaft.
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
        /// The gear.
        gear: BoredGear,
        /// Teeth of the gear.
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
    /// The tips of adjacent planets clear each other by less than the required gap.
    TipGapBelowWanted {
        /// Gap between the tip circles, mm.
        gap_mm: f64,
        /// The required gap, mm.
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
    /// The given tooth numbers miss the target ratio by more than its tolerance.
    RatioDeparts {
        /// Target ratio.
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
    /// The bearing on the planet pin does not go into the planet, which was taken as solid.
    PlanetBearingTooLarge {
        /// Designation of the bearing.
        bearing: &'static str,
        /// Outside diameter of the bearing, mm.
        outside_mm: f64,
        /// Diameter of the pin, mm.
        pin_mm: f64,
        /// Root diameter of the planet, mm.
        root_mm: f64,
    },
    /// A given bore of the planet is narrower than what is to go into it.
    PlanetBoreTooNarrow {
        /// The bore, mm.
        bore_mm: f64,
        /// Diameter of the planet pin, mm.
        pin_mm: f64,
        /// Designation and outside diameter, mm, of the bearing on it.
        bearing: Option<(&'static str, f64)>,
    },
    /// A given mass or inertia is many times that of the part's shape, or a small part of it.
    PartUnlikeShape {
        /// The part, by its shaft.
        part: Shaft,
        /// Whether the inertia is meant and not the mass.
        is_inertia: bool,
        /// The given mass, kg, or inertia, kg·m².
        given: f64,
        /// The mass of the shape, kg, or its inertia, kg·m².
        of_shape: f64,
    },
    /// The carrier was taken as massless.
    CarrierNeglected,
}

impl Warning {
    /// Name, which does not change: `shaft-too-thin`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.into()
    }
}
