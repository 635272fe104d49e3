//! Errors of the catalogue and of the machine side: requirements that no scheme meets.
//!
//! Errors of gearboxes are those of [`epicyclic_train::Error`].

use crate::quantity::{ConnectionPart, FlightFault, Quantity, SeriesParameter};
use epicyclic_gears::with_unit;

/// An invalid input, or requirements that nothing meets.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A name that no scheme bears.
    #[error("no scheme is called `{name}`: there are {}", known.join(", "))]
    UnknownScheme {
        /// The name given.
        name: String,
        /// The names there are.
        known: Vec<&'static str>,
    },
    /// A boom slewed by a right angle or more, which advances into no chip.
    #[error("a slewing angle of {}: it is above -90 and below 90 deg", with_unit(*degrees, "deg"))]
    BoomAngle {
        /// The angle.
        degrees: f64,
    },
    /// A name that no structure bears in any spelling.
    #[error(
        "no structure is called `{name}`: one is a.b.H+a.b.H, the links D, B, T1, T2 of sun, ring and carrier of both sets{}",
        nearest.as_deref().map_or_else(String::new, |nearest| format!("; did you mean `{nearest}`?"))
    )]
    UnknownStructure {
        /// The name given.
        name: String,
        /// The nearest canonical spelling.
        nearest: Option<String>,
    },
    /// Links that make no structure.
    #[error(
        "`{name}` is no structure: each set has three different links of D, B, T1, T2, and the two sets lack different ones"
    )]
    NotAStructure {
        /// The name given.
        name: String,
    },
    /// An invalid range of ring-to-sun ratios.
    #[error("ring-to-sun ratios from {low} to {high}: a range has 1 < low ≤ high")]
    RingToSunRange {
        /// The lower end given.
        low: f64,
        /// The upper end given.
        high: f64,
    },
    /// A ratio that no ring-to-sun ratio gives.
    #[error(
        "{scheme} does not give i = {ratio}: with k above 1 it gives {low:.4} to {high:.4}, ends excluded"
    )]
    RatioOutOfReach {
        /// The scheme, and the gear where it has several.
        scheme: String,
        /// Target ratio.
        ratio: f64,
        /// Lower end of what it gives.
        low: f64,
        /// Upper end of what it gives.
        high: f64,
    },
    /// An invalid ratio of a connection: 0, 1, or not finite.
    #[error(
        "i = {ratio} of the {what}: the ratios of gears 1 and 2 are finite and not 0, and that of gear 1 is not 1"
    )]
    ConnectionRatio {
        /// The gear or the connection.
        what: ConnectionPart,
        /// The ratio given.
        ratio: f64,
    },
    /// Too few or too many speeds.
    #[error("{count} speed{}: the series of the source have 2 to 4", if *count == 1 { "" } else { "s" })]
    SpeedCount {
        /// How many were given.
        count: usize,
    },
    /// Speeds that do not rise, or not all above 0.
    #[error("speed {place} is {speed} m/s after {before} m/s: speeds are finite, above 0, and rise")]
    SpeedsOutOfOrder {
        /// Index of the speed, from 1.
        place: usize,
        /// The speed.
        speed: f64,
        /// The previous speed, or 0.
        before: f64,
    },
    /// A speed range or step that leaves nothing to shift.
    #[error("{what} = {value}: a range of speeds is above 1")]
    SpeedRange {
        /// `d` or `q`.
        what: SeriesParameter,
        /// The value given.
        value: f64,
    },
    /// A middle speed outside the range.
    #[error("q = {q} with d = {d}: fastest over middle speed lies above 1 and below d")]
    MiddleSpeed {
        /// Fastest over middle.
        q: f64,
        /// Fastest over slowest.
        d: f64,
    },
    /// Too few or too many ratios of braked gears.
    #[error("{count} ratio{}: beside direct drive one set gives 1, two sets give 2, and a series has at most 3", if *count == 1 { "" } else { "s" })]
    RatioCount {
        /// How many were given.
        count: usize,
    },
    /// A ratio that no braked gear has.
    #[error("ratio {ratio}: finite and not 0, and not 1, which is direct drive")]
    Ratio {
        /// The ratio given.
        ratio: f64,
    },
    /// Two gears of one ratio.
    #[error("two gears of ratio {ratio}: the ratios of a gearbox are different")]
    EqualRatios {
        /// The common ratio.
        ratio: f64,
    },
    /// A place for direct drive outside the series.
    #[error("direct drive in place {place} of {count} speeds: places count from 1, the fastest")]
    DirectPlace {
        /// The place given.
        place: usize,
        /// How many speeds there are.
        count: usize,
    },
    /// A quantity that must be above 0.
    #[error("{quantity} = {value} {unit}: it is a finite number above 0")]
    NotPositive {
        /// The quantity.
        quantity: Quantity,
        /// The value given.
        value: f64,
        /// Unit of the value.
        unit: &'static str,
    },
    /// Angles between which nothing flies.
    #[error("no flight from τ₁ = {release_deg}° to τ* = {chute_deg}° at ε = {radius_ratio}: {why}")]
    NoFlight {
        /// Angle of release.
        release_deg: f64,
        /// Angle of the chute's edge.
        chute_deg: f64,
        /// Radius of the chute's edge over that of the wheel.
        radius_ratio: f64,
        /// The reason.
        why: FlightFault,
    },
    /// A machine that the tables do not list.
    #[error("no machine `{name}` in tables 1.1 and 1.2{}", nearest.as_deref().map_or_else(String::new, |n| format!("; did you mean `{n}`?")))]
    UnknownMachine {
        /// The name given.
        name: String,
        /// The nearest listed.
        nearest: Option<String>,
    },
    /// An error of a gear set.
    #[error(transparent)]
    GearSet(#[from] epicyclic_gears::Error),
    /// An error of the solver.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
}

impl Error {
    /// Name of the fault, which does not change with the message: `unknown-scheme`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::GearSet(error) => error.name(),
            Self::Gearbox(error) => error.name(),
            named => named.into(),
        }
    }
}
