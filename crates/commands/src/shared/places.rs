//! Ranges of values with a number of places: `500rpm..3000rpm/6`.

use crate::error::Error;
use epicyclic_units::visible::one_line;
use epicyclic_units::{Physical, Quantity};
use std::str::FromStr;
use uom::si::f64::{AngularVelocity, Torque};

/// Equally spaced places from one value to another, both ends included; at most `MOST`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places<T, const MOST: u32 = 200> {
    from: T,
    to: T,
    places: u32,
}

impl<T: Physical, const MOST: u32> Places<T, MOST> {
    /// Range of values with this number of places.
    ///
    /// # Errors
    /// [`Error::Places`] for fewer than 2 places or more than `MOST`, [`Error::EqualEnds`].
    pub fn new(from: T, to: T, places: u32) -> Result<Self, Error> {
        if !(2..=MOST).contains(&places) {
            Err(Error::Places { places, most: MOST })
        } else if from.si() == to.si() {
            Err(Error::EqualEnds)
        } else {
            Ok(Self { from, to, places })
        }
    }

    /// First and last value.
    pub(crate) const fn ends(&self) -> [T; 2] {
        [self.from, self.to]
    }

    /// Number of places.
    pub(crate) const fn count(&self) -> usize {
        self.places as usize
    }

    /// Values in increasing index order.
    pub(crate) fn values(&self) -> impl Iterator<Item = T> + use<T, MOST> {
        let (from, to, steps) = (self.from.si(), self.to.si(), f64::from(self.places - 1));
        (0..self.places).map(move |step| T::from_si(from + (to - from) * (f64::from(step) / steps)))
    }
}

impl<T: Physical, const MOST: u32> FromStr for Places<T, MOST> {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form =
            || format!("{}: write a range and how many places, as 500rpm..3000rpm/6", one_line(written));
        let (range, places) = written.rsplit_once('/').ok_or_else(form)?;
        let (from, to) = range.split_once("..").ok_or_else(form)?;
        let value = |text: &str| {
            let value: Result<Quantity<T>, _> = text.trim().parse();
            value.map(|value| value.0).map_err(|error| error.to_string())
        };
        let places = places.trim().parse().map_err(|_| form())?;
        Self::new(value(from)?, value(to)?, places).map_err(|error| error.to_string())
    }
}

/// Speeds and torques on the input, of a map of the efficiency.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Grid {
    /// A map of one gear over these speeds of the input: 500rpm..3000rpm/6, both ends and how many places;
    /// with --torques.
    #[arg(long, value_name = "FROM..TO/PLACES", requires_all = ["gear", "torques"])]
    pub speeds: Option<Places<AngularVelocity>>,

    /// Torques on the input of the map: 10N·m..100N·m/10.
    #[arg(long, value_name = "FROM..TO/PLACES", requires = "speeds")]
    pub torques: Option<Places<Torque>>,
}

impl Grid {
    /// Whether any of it is given.
    pub(crate) fn is_given(&self) -> bool {
        self.speeds.is_some() || self.torques.is_some()
    }

    /// Speeds and torques; each needs the other one, as clap checks.
    pub(crate) fn places(&self) -> Option<(Places<AngularVelocity>, Places<Torque>)> {
        self.speeds.zip(self.torques)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_has_two_places_at_least() {
        let speed = AngularVelocity::from_si(1.0);
        let places = |places| Places::<_, 1000>::new(speed, 2.0 * speed, places);
        assert!(places(2).is_ok() && places(1000).is_ok());
        assert!(matches!(places(1), Err(Error::Places { places: 1, most: 1000 })));
        assert!(places(1001).is_err());
    }
}
