//! Request for sizes: the space of the search.

use crate::error::Error;
use crate::output::NO_HEADING;
use crate::shared::application::Application;
use crate::shared::bearing_type::BearingType;
use crate::shared::lists::Quantities;
use epicyclic_formats::{RangeError, Span};
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::life::Rolling;
use epicyclic_gears::mesh::USUAL_PLANET_GAP;
use epicyclic_judge as judge;
use epicyclic_strength::sizing::bearing::Bearing;
use epicyclic_strength::sizing::{Objective, STANDARD_MODULES_MM, Space};
use epicyclic_strength::{self as strength, Quantity as Of};
use epicyclic_units::{Module, Number, Physical as _, Quantity};
use std::ops::RangeInclusive;
use uom::si::f64::Length;

/// Maximum distance of centre distances from the natural one, in modules.
const REACH: f64 = 1.0;

/// Numbers of planets unless others are asked for.
const PLANETS: RangeInclusive<u32> = 3..=6;

/// Greatest module of the standard series in mm that is used unless others are requested.
const GREATEST_MODULE_MM: f64 = 20.0;

/// Rims of planets and rings in modules unless others are asked for or stated.
const USUAL_RIMS: [f64; 2] = [3.0, 3.5];

/// Request for sizes of the sets of a gearbox: the space of the search.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Sizes")]
pub struct Request {
    /// Modules. Default: series I of ISO 54 to 20 mm, of designs to 50 mm where none of these holds.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub modules: Option<Quantities<Module>>,

    /// Face widths. Default: 10 to 80 mm in steps of 5 mm, to 200 mm of 10 mm, to 600 mm of 25 mm.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub face_widths: Option<Quantities<Length>>,

    /// Numbers of planets, from 1 to 8. Default: 3..6; with --application what is usual.
    #[arg(long, value_name = "RANGE", value_parser = planets)]
    pub planets: Option<RangeInclusive<u32>>,

    /// Step of the centre distances, which are its multiples within one module of the natural one. Default:
    /// 0.5 mm, with modules below 1 mm 0.1 mm; of several kinds of planets a quarter of the module.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub centre_distance_step: Option<Quantity<Length>>,

    /// The greatest face width over the reference diameter of the smallest sun, of a pair of the smaller
    /// gear. Default: no bound.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub width_ratio: Option<Number>,

    /// The greatest outside diameter of a ring, with its rim. Default: no bound.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub max_ring: Option<Quantity<Length>>,

    /// What picks the shifts, of which the sums are fixed.
    #[arg(long, value_enum, default_value_t = Aim::BalancedSliding)]
    pub aim: Aim,

    /// Least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth.
    #[arg(long, value_name = "MODULES", default_value = "0.2", allow_hyphen_values = true)]
    pub tip_thickness: Number,

    /// Least rim of the planets between root circle and bearing, in modules. Default: 3, within `planet-rim` of
    /// `limits` in the file.
    #[arg(long, value_name = "MODULES", allow_hyphen_values = true)]
    pub planet_rim: Option<Number>,

    /// Rim of the ring outside its root circle, in modules. Default: 3.5, within `ring-rim` of `limits` in the
    /// file.
    #[arg(long, value_name = "MODULES", allow_hyphen_values = true)]
    pub ring_rim: Option<Number>,

    /// Kinds of bearings to choose from. Default: balls, rollers; with --application what is usual. Designs
    /// take rollers-in-bore as well where none of these holds, or where it saves a fifth of the mass.
    #[arg(long, value_enum, value_name = "KINDS", value_delimiter = ',', conflicts_with_all = ["bearings", "no_bearings"])]
    pub bearing_type: Option<Vec<BearingType>>,

    /// Bearings side by side in a planet, at most: 1 or 2; a pair is rated by ISO 281 as one double-row
    /// bearing.
    #[arg(long, value_name = "N", default_value = "2", value_parser = clap::value_parser!(u32).range(1..=2))]
    pub bearing_rows: u32,

    /// Seek no bearings: the planets are solid.
    #[arg(long, conflicts_with = "bearings")]
    pub no_bearings: bool,

    /// Purpose of the gearbox: usual K_A, life, safeties, materials, kinds of bearings and numbers of
    /// planets, for what is not stated.
    #[arg(long, value_enum, help_heading = NO_HEADING)]
    pub application: Option<Application>,

    /// What is least: the mass of the gears, the outside diameter of the rings, or the mass of the whole with
    /// carriers and housing, by a rule. Default: mass; of design whole.
    #[arg(long, value_enum)]
    pub minimise: Option<Objective>,

    /// Rank designs beyond usual practice with all others: wide or narrow gears, much sliding, unusual shifts,
    /// fast gears and bearings, balls under large loads. Without it those with fewer warnings come first, and
    /// those that practice refuses are left out.
    #[arg(long)]
    pub beyond_practice: bool,

    /// How many designs of each set are shown.
    #[arg(long, value_name = "N", default_value = "3")]
    pub most: usize,

    /// Whether modules that are not stated go beyond the usual ones.
    #[arg(skip)]
    pub has_large_modules: bool,

    /// Price of the length in kg/m, which counts beside the objective.
    #[arg(skip)]
    pub length_price: f64,

    /// Whether the given `K_Hβ` is a usual one, which grows with the face width.
    #[arg(skip)]
    pub widens_face_load: bool,

    /// How much of the space is searched.
    #[arg(skip)]
    pub effort: Effort,

    /// Bearings of the planets to choose from, in place of those of the tables.
    #[arg(skip)]
    pub bearings: Option<Vec<Bearing>>,
}

/// How much of the space a search of sizes goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Effort {
    /// The whole space, with the design that misses least where none holds.
    #[default]
    Full,
    /// The whole space, without a design that misses.
    Found,
    /// Face widths and centre distances far apart, unless they are given, without a design that misses.
    Coarse,
}

/// Values between two of a coarse space.
const COARSE: usize = 4;

impl Request {
    pub(crate) fn space(&self) -> Space {
        let space = self.whole_space();
        if self.effort != Effort::Coarse {
            return space;
        }
        let step = if self.centre_distance_step.is_some() { 1.0 } else { COARSE as f64 };
        let thin = |widths: Vec<Length>| match self.face_widths {
            Some(_) => widths,
            None => widths.into_iter().step_by(COARSE).collect(),
        };
        Space {
            face_widths: thin(space.face_widths),
            centre_distance_step: step * space.centre_distance_step,
            ..space
        }
    }

    fn whole_space(&self) -> Space {
        let usual = self.application;
        let modules = self.modules.as_ref().map_or_else(
            || usual.and_then(Application::modules).unwrap_or_else(|| self.usual_modules()),
            |modules| modules.values().into_iter().map(Module::length).collect(),
        );
        let is_fine = modules.iter().any(|module| module.mm() < 1.0);
        let step = || Length::from_mm(if is_fine { 0.1 } else { 0.5 });
        Space {
            modules,
            face_widths: self.face_widths.as_ref().map_or_else(
                || usual.and_then(Application::face_widths).unwrap_or_else(usual_face_widths),
                Quantities::values,
            ),
            planets: self.planet_counts().collect(),
            centre_distance_step: self.centre_distance_step.map_or_else(step, |step| step.0),
            reach: REACH,
            width_ratio: self.width_ratio.map(Number::get),
            largest_ring: self.max_ring.map(|ring| ring.0),
            length_price: self.length_price,
            bearings: self.bearings().into(),
        }
    }

    /// Modules of series I of ISO 54 that are allowed unless others are requested.
    fn usual_modules(&self) -> Vec<Length> {
        let is_usual = |module: &f64| self.has_large_modules || *module <= GREATEST_MODULE_MM;
        STANDARD_MODULES_MM.into_iter().filter(is_usual).map(Length::from_mm).collect()
    }

    /// Numbers of planets to choose from.
    pub(crate) fn planet_counts(&self) -> RangeInclusive<u32> {
        let usual = self.application.map_or(PLANETS, Application::planets);
        self.planets.clone().unwrap_or(usual)
    }

    /// Kinds of bearings to choose from.
    pub(crate) fn bearing_kinds(&self) -> &[BearingType] {
        let usual = self.application.map_or(&BearingType::USUAL[..], Application::bearings);
        self.bearing_type.as_deref().unwrap_or(usual)
    }

    /// Whether the planets may have plain bearings.
    pub(crate) fn has_plain_bearings(&self) -> bool {
        !self.no_bearings && self.bearings.is_none() && self.bearing_kinds().contains(&BearingType::Plain)
    }

    /// Whether the planets may have bearings of tables, but no plain ones.
    pub(crate) fn lacks_plain_bearings(&self) -> bool {
        !self.no_bearings && self.bearings.is_none() && !self.has_plain_bearings()
    }

    /// The request with larger sizes where it states none: modules beyond the usual ones, and rollers in
    /// the bores of planets, where the largest bearings of a table may be too small. `None` if there is
    /// nothing larger.
    pub(crate) fn larger(&self) -> Option<Self> {
        let kinds = self.bearing_kinds();
        let is_open = self.bearing_type.is_none() && self.bearings.is_none() && !self.no_bearings;
        let has_larger = is_open && !kinds.contains(&BearingType::RollersInBore);
        let has_modules = self.modules.is_none() && !self.has_large_modules;
        let bearing_type = if has_larger {
            Some([kinds, &[BearingType::RollersInBore]].concat())
        } else {
            self.bearing_type.clone()
        };
        (has_larger || has_modules).then(|| Self { bearing_type, has_large_modules: true, ..self.clone() })
    }

    /// Bearings to choose from, alone and as pairs.
    fn bearings(&self) -> Vec<Bearing> {
        let kinds = self.bearing_kinds();
        let single = match &self.bearings {
            _ if self.no_bearings => vec![],
            Some(bearings) => bearings.clone(),
            None => kinds.iter().flat_map(|kind| kind.listed()).cloned().collect(),
        };
        // A plain bearing is as wide as its planet.
        let is_one = |bearing: &&Bearing| self.bearing_rows > 1 && bearing.rolling != Rolling::Plain;
        let pairs: Vec<Bearing> = single.iter().filter(is_one).map(Bearing::pair).collect();
        [single, pairs].concat()
    }

    /// Least rim of planets and rim of rings in modules: of an option, or the usual ones within limits that
    /// are stated.
    pub(crate) fn rims(&self, limits: &judge::Limits) -> [f64; 2] {
        let usual =
            |rule, usual: f64| limits.stated(rule).map_or(usual, |of| usual.max(of.least).min(of.most));
        let of = |own: Option<Number>, rule, rim| own.map_or_else(|| usual(rule, rim), Number::get);
        [
            of(self.planet_rim, judge::Rule::PlanetRim, USUAL_RIMS[0]),
            of(self.ring_rim, judge::Rule::RingRim, USUAL_RIMS[1]),
        ]
    }

    /// The objective.
    pub(crate) fn objective(&self) -> Objective {
        self.minimise.unwrap_or_default()
    }

    /// The limits of practice to judge by, if they count.
    pub(crate) fn practice(&self, limits: &judge::Limits) -> Option<judge::Limits> {
        (!self.beyond_practice).then(|| limits.clone())
    }

    pub(crate) fn limits(&self) -> Limits {
        Limits { tip_thickness: self.tip_thickness.get(), planet_gap: USUAL_PLANET_GAP, ..Limits::default() }
    }

    /// Refuses an empty or impossible space, whatever the file contains.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.space().check()?;
        let unit = "modules";
        let [planet_rim, ring_rim] = self.rims(&judge::Limits::default());
        let (quantity, value) = (Of::LeastRim, planet_rim);
        if !(value.is_finite() && value >= 0.0) {
            return Err(strength::Error::Negative { quantity, value, unit }.into());
        }
        // A ring without a rim has no root to rate.
        let (quantity, value) = (Of::RingRimInModules, ring_rim);
        if !(value.is_finite() && value > 0.0) {
            return Err(strength::Error::NotPositive { quantity, value, unit }.into());
        }
        Ok(self.limits().check()?)
    }
}

/// Face widths that are allowed unless others are requested.
fn usual_face_widths() -> Vec<Length> {
    let [fine, middle, coarse] = [(2..=16, 5.0), (9..=20, 10.0), (9..=24, 25.0)]
        .map(|(counts, step)| counts.map(move |count: u32| Length::from_mm(step * f64::from(count))));
    fine.chain(middle).chain(coarse).collect()
}

/// Numbers of planets within those that sizes are known for.
fn planets(text: &str) -> Result<RangeInclusive<u32>, String> {
    let range: Span<u32> = text.parse().map_err(|error: RangeError| error.to_string())?;
    range.within(1..=8).map_err(|error| error.to_string())
}
