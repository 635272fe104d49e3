//! Options for the choice of a gearbox of two or three speeds: its speeds, its ratios and its criteria, and
//! the refusal of wrong ones.

use crate::failure::Failure;
use crate::shared::lists::{List, Quantities};
use crate::shared::options;
use crate::shared::ratios::PlainRatios;
use epicyclic_formats::Span;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::RatioSeries;
use epicyclic_selection::quantity::{KRange, Limited, Rated};
use epicyclic_selection::{Limits, Orders, Rating, Requirements, Signs, Space};
use epicyclic_units::{Number, Physical, Quantity};
use std::ops::RangeInclusive;
use uom::si::f64::{AngularVelocity, Ratio, Velocity};

/// Speeds or ratios of the gearbox, and the mechanisms to choose among.
#[derive(Debug, Clone, clap::Args)]
pub struct Speeds {
    /// Speeds of the machine, the slowest first.
    #[arg(long, conflicts_with = "ratios", allow_hyphen_values = true, value_parser = of_machine)]
    pub speeds: Option<Quantities<Velocity>>,

    /// Ratios of the gears, input speed over output speed, in place of speeds: '2.5, 1.5' or '2,5; 1,5'. One or
    /// two are gears beside direct drive, with a minus where the output reverses; design takes more, as a list
    /// of all gears.
    #[arg(long, allow_hyphen_values = true)]
    pub ratios: Option<PlainRatios>,

    /// All 111 structures of two sets (or the 6 of one), and not only the source's.
    #[arg(long)]
    pub all_structures: bool,
}

/// Reads speeds of the machine; the refusal of speeds of a shaft names the option for these.
fn of_machine(text: &str) -> Result<Quantities<Velocity>, String> {
    text.parse().map_err(|error: String| match text.parse::<Quantities<AngularVelocity>>() {
        Ok(_) => format!(
            "{text}: speeds of a shaft; due are those of the machine, as '0.8 m/s, 1.6 m/s', of which the fastest is direct drive. For speeds of \
             the output write --ratios, input speed over output speed"
        ),
        Err(_) => error,
    })
}

/// How the ratios are taken.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Ratios")]
pub struct RatioOptions {
    /// Which brake gives which ratio.
    #[arg(long, value_enum, default_value_t = Orders::Either)]
    pub brakes: Orders,

    /// Which signs the ratios may have; direct drive is positive. Default: as-given where a ratio has a
    /// minus, otherwise alike.
    #[arg(long, value_enum)]
    pub signs: Option<Signs>,
}

/// Defaults of the criteria: least efficiency, speeds over that of the input, ring-to-sun ratios.
const USUAL_LEAST_EFFICIENCY: f64 = 0.9;
const USUAL_SPEED: f64 = 2.0;
const USUAL_K: [f64; 2] = [1.3, 10.0];

/// Ring-to-sun ratios that are usually preferred.
const USUAL_PREFERENCE: [f64; 2] = [2.5, 3.0];

/// Criteria of a design.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Criteria")]
pub struct Criteria {
    /// Ring-to-sun ratios allowed.
    #[arg(long, value_name = "RANGE", default_value = "1.3..10")]
    pub k: Span<f64>,

    /// Ring-to-sun ratios preferred.
    #[arg(long, value_name = "RANGE", default_value = "2.5..3")]
    pub prefer: Span<f64>,

    /// Efficiency of each set with its carrier fixed, 0.97 or 97%.
    #[arg(long, value_name = "NUMBER", default_value = "0.9702", allow_hyphen_values = true)]
    pub efficiency: Quantity<Ratio>,

    /// Least efficiency of a gear.
    #[arg(long, value_name = "NUMBER", default_value = "0.9", allow_hyphen_values = true)]
    pub least_efficiency: Quantity<Ratio>,

    /// Greatest speed of a link over the input's.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_hyphen_values = true)]
    pub link_speed: Number,

    /// Greatest speed of a planet relative to its carrier over the input's.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_hyphen_values = true)]
    pub planet_speed: Number,

    /// Greatest slip of the open direct-drive clutch over the input's speed.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_hyphen_values = true)]
    pub clutch_slip: Number,

    /// Greatest circulating power of a gear over what enters, 0.5 or 50%. Not given: more than half is an
    /// objection.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub circulation: Option<Quantity<Ratio>>,

    /// Accept schemes that are not drawable: a link would cross another.
    #[arg(long)]
    pub allow_crossing: bool,
}

impl Criteria {
    /// Efficiency of each set with its carrier fixed.
    pub(crate) fn set_efficiency(&self) -> Result<MeshEfficiency, Failure> {
        let efficiency = MeshEfficiency::new(self.efficiency.0.si());
        efficiency.map_err(|error| Failure::of_option("--efficiency", &error))
    }

    /// Whether other ring-to-sun ratios than the usual ones are preferred.
    pub(crate) fn has_own_preference(&self) -> bool {
        self.prefer.ends() != USUAL_PREFERENCE.map(Some)
    }

    /// Options that are stricter than by default, each with what would relax it.
    pub(crate) fn stricter(&self) -> Vec<&'static str> {
        let own = [self.link_speed, self.planet_speed, self.clutch_slip].map(Number::get);
        let [link, planet, slip] = own.map(|limit| limit < USUAL_SPEED);
        let [least_k, most_k] = self.k.ends().map(Option::unwrap_or_default);
        let is_narrow = least_k > USUAL_K[0] || (most_k > 0.0 && most_k < USUAL_K[1]);
        let all = [
            ("a lower --least-efficiency", self.least_efficiency.0.si() > USUAL_LEAST_EFFICIENCY),
            ("a larger --circulation", self.circulation.is_some()),
            ("a larger --link-speed", link),
            ("a larger --planet-speed", planet),
            ("a larger --clutch-slip", slip),
            ("a wider --k", is_narrow),
        ];
        all.into_iter().filter(|(_, is_stricter)| *is_stricter).map(|(relaxed, _)| relaxed).collect()
    }

    /// The ring-to-sun ratios allowed, within these.
    pub(crate) fn k(&self, usual: RangeInclusive<f64>) -> Result<RangeInclusive<f64>, Failure> {
        self.k.closed(usual).map_err(|error| Failure::Range { option: "--k", error })
    }
}

impl Speeds {
    /// The mechanisms to choose among.
    pub(crate) fn space(&self) -> Space {
        if self.all_structures { Space::All } else { Space::Catalogue }
    }

    /// The speeds of the machine; none where ratios are given.
    pub(crate) fn of_machine(&self) -> Vec<Velocity> {
        self.speeds.iter().flat_map(List::values).collect()
    }
}

impl RatioOptions {
    /// The signs: those given where one is negative, since it was written for a purpose.
    pub(crate) fn signs(&self, wanted: &Speeds) -> Signs {
        let mut ratios = wanted.ratios.iter().flat_map(|ratios| &ratios.0);
        match self.signs {
            Some(signs) => signs,
            None if ratios.any(|ratio| ratio.get() < 0.0) => Signs::AsGiven,
            None => Signs::Alike,
        }
    }
}

/// Returns the requirements given by the options.
pub(crate) fn requirements(
    wanted: &Speeds,
    tolerance: Quantity<Ratio>,
    taken: &RatioOptions,
    criteria: &Criteria,
    same_direction: bool,
    rating: Rating,
) -> Result<Requirements, Failure> {
    let series = match (&wanted.speeds, &wanted.ratios) {
        (Some(speeds), _) => RatioSeries::of_speeds(&speeds.values(), 1),
        (None, ratios) => {
            let ratios: Vec<f64> =
                ratios.iter().flat_map(|ratios| &ratios.0).map(|ratio| ratio.get()).collect();
            RatioSeries::of_braked_gears(&ratios)
        }
    };
    let range =
        |option, span: Span<f64>, usual| span.closed(usual).map_err(|error| Failure::Range { option, error });
    let usual = Limits::default();
    let eta0 = criteria.set_efficiency()?;
    Ok(Requirements {
        tolerance: tolerance.0.si(),
        orders: taken.brakes,
        signs: taken.signs(wanted),
        limits: Limits {
            ring_to_sun: range("--k", criteria.k, usual.ring_to_sun)?,
            preferred: range("--prefer", criteria.prefer, usual.preferred)?,
            efficiency: criteria.least_efficiency.0.si(),
            link_speed: criteria.link_speed.get(),
            planet_speed: criteria.planet_speed.get(),
            clutch_slip: criteria.clutch_slip.get(),
            circulation: criteria.circulation.map_or(usual.circulation, |share| share.0.si()),
            same_direction,
            drawable: !criteria.allow_crossing,
        },
        eta0,
        rating,
        ..Requirements::new(series.map_err(|error| refuse_selection(error.into()))?)
    })
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse_selection(error: epicyclic_selection::Error) -> Failure {
    use epicyclic_schemes::Error as S;
    use epicyclic_selection::Error as E;
    let option = match &error {
        E::SpeedCount { .. } => "--speeds, --ratios",
        E::Scheme(S::SpeedCount { .. } | S::SpeedsOutOfOrder { .. }) => "--speeds",
        E::RatioCount { .. }
        | E::OneRatio { .. }
        | E::Scheme(S::RatioCount { .. } | S::Ratio { .. } | S::EqualRatios { .. }) => "--ratios",
        E::Tolerance { .. } => "--tolerance",
        E::RingToSunRange { what: KRange::Preferred, .. } => "--prefer",
        E::RingToSunRange { .. } => "--k",
        E::Limit { what: Limited::Efficiency, .. } => "--least-efficiency",
        E::Limit { what: Limited::LinkSpeed, .. } => "--link-speed",
        E::Limit { what: Limited::PlanetSpeed, .. } => "--planet-speed",
        E::Limit { what: Limited::ClutchSlip, .. } => "--clutch-slip",
        E::Limit { what: Limited::Circulation, .. } => "--circulation",
        E::Limit { what: Limited::Module, .. } => "--least-module, --greatest-module",
        E::Limit { what: Limited::RingDiameter, .. } | E::SizeWithoutTorque => "--ring-diameter",
        E::Rating { what: Rated::MeshLoadFactor, .. } => "--mesh-load-factors",
        E::Rating { what: Rated::FaceWidthRatio, .. } => "--face-width-ratio",
        E::Rating { what: Rated::LoadFactor, .. } => "--load-factor",
        E::PlanetNumber { .. } => "--planets",
        E::TooManyToothSets { .. } => "--sun, --planet, --ring, --k",
        E::TooManyWindows { .. } => "--sun, --planet, --ring, --k, --all-structures",
        E::TooManyNear { .. } | E::TooManyPairs { .. } | E::FrontTooLarge { .. } => {
            "--sun, --planet, --ring, --k, --tolerance"
        }
        E::GearSet(error) => match options::of_teeth(error, "--planet-count") {
            Some(option) => option,
            None => return Failure::Selection(E::GearSet(error.clone())),
        },
        E::RepeatedObjective { .. } | E::UnknownObjective { .. } | E::NoObjectiveOfTeeth { .. } => "--order",
        _ => return Failure::Selection(error),
    };
    Failure::of_option(option, &error)
}
