//! The options of gears with several inputs: speeds and torques of links, ranges of speeds.

use crate::analyze::answer::inputs::Wanted;
use crate::analyze::answer::inputs::map::MapPlaces;
use crate::failure::Failure;
use epicyclic_units::visible::one_line;
use epicyclic_units::{Physical, Quantity};
use std::str::FromStr;
use uom::si::f64::{AngularVelocity, Torque};

/// Values of links: `engine=2000 rpm, mg1=-500 rpm`.
#[derive(Debug, Clone, PartialEq)]
pub struct Assignments<T>(pub Vec<(String, T)>);

impl<T: FromStr<Err: ToString>> FromStr for Assignments<T> {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let one = |part: &str| {
            let (link, value) = part.split_once('=').ok_or_else(|| {
                format!("{}: write a link and its value, as engine=2000rpm", one_line(part))
            })?;
            let value = value
                .trim()
                .parse()
                .map_err(|error: T::Err| format!("{}: {}", one_line(link), error.to_string()))?;
            Ok((link.trim().to_owned(), value))
        };
        let all: Vec<(String, T)> =
            written.split([',', ';']).map(str::trim).map(one).collect::<Result<_, String>>()?;
        match (0..all.len()).find(|&place| all[..place].iter().any(|(link, _)| *link == all[place].0)) {
            Some(place) => Err(format!("{}: given twice; give one value", one_line(&all[place].0))),
            None => Ok(Self(all)),
        }
    }
}

impl<T: Physical> Assignments<Quantity<T>> {
    fn values(&self) -> Vec<(String, T)> {
        self.0.iter().map(|(link, value)| (link.clone(), value.0)).collect()
    }
}

/// What several links of a gear do.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Several {
    /// Speeds of links of a gear that keeps freedoms, as many as it keeps: engine=2000rpm, mg1=3000rpm.
    #[arg(long, value_name = "LINK=SPEED, …", requires = "gear", conflicts_with_all = ["torque", "power", "speed"])]
    pub speeds: Option<Assignments<Quantity<AngularVelocity>>>,

    /// Torques at links where power enters or leaves; those of the other ends follow: engine=100N·m.
    #[arg(long, value_name = "LINK=TORQUE, …", requires = "gear", conflicts_with_all = ["torque", "power", "speed"])]
    pub torques: Option<Assignments<Quantity<Torque>>>,

    /// The state over ranges of two speeds, a line a place: engine=800rpm..4000rpm/9,
    /// mg1=-5000rpm..5000rpm/11.
    #[arg(long, value_name = "LINK=FROM..TO/PLACES, …", requires = "gear", conflicts_with_all = ["speeds", "torque", "power", "speed"])]
    pub map: Option<Assignments<MapPlaces>>,
}

impl Several {
    /// Whether any of it is given.
    pub(super) fn is_given(&self) -> bool {
        self.speeds.is_some() || self.torques.is_some() || self.map.is_some()
    }

    /// Speeds and torques of one point.
    pub(super) fn wanted(&self) -> Wanted {
        Wanted { speeds: self.speeds.as_ref().map(Assignments::values), torques: self.torques() }
    }

    /// The torques given.
    pub(super) fn torques(&self) -> Option<Vec<(String, Torque)>> {
        self.torques.as_ref().map(Assignments::values)
    }

    /// The ranges of a map, if one is asked for.
    pub(super) fn map(&self) -> Result<Option<[(String, MapPlaces); 2]>, Failure> {
        let Some(map) = &self.map else { return Ok(None) };
        let [first, second] = &map.0[..] else {
            let message = format!("{} ranges are given: two are due", map.0.len());
            return Err(Failure::invalid("--map", message));
        };
        Ok(Some([first.clone(), second.clone()]))
    }
}
