//! A mechanism with what drives, loads and holds it.

use crate::Error;
use crate::course::Course;
use crate::mechanism::{Mechanism, Place};
use crate::torque_law::{Law, TorqueLaw};
use crate::units::rad_per_s;
use epicyclic_train::GROUND;
use uom::si::f64::{AngularVelocity, Torque};

/// A mechanism with sources, loads, shift elements and thresholds.
///
/// A friction element between two links carries, with `s = ω_1 − ω_2` and the capacity `C`,
///
/// ```text
/// slipping   T_1 = −C·sign s                       T_2 = −T_1
/// stuck      T_1 as s = 0 asks, |T_1| ≤ κ·C        κ ≥ 1: static over kinetic friction
/// ```
///
/// and a one-way clutch `T_1 ≥ 0` with `s = 0`, or none with `s > 0`. A load that opposes motion is a friction element with the housing.
///
/// One-way clutches of the gearbox are there from the start; its other shift elements are open until they are given a capacity.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(crate) mechanism: Mechanism,
    pub(crate) torques: Vec<Applied>,
    pub(crate) elements: Vec<Element>,
    pub(crate) thresholds: Vec<Threshold>,
}

/// A torque on a link.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Applied {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) law: Law,
    /// Speed of the link over the coordinates.
    pub(crate) speed: Vec<f64>,
}

/// What joins two links.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Element {
    pub(crate) name: String,
    pub(crate) places: [Place; 2],
    /// `ω_1 − ω_2` over the coordinates.
    pub(crate) slip: Vec<f64>,
    pub(crate) kind: Kind,
}

/// How an element carries torque.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Kind {
    /// Capacity while slipping, and `κ`.
    Friction {
        capacity: Course,
        static_ratio: f64,
    },
    OneWay,
}

/// A speed whose passing is an event.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Threshold {
    pub(crate) name: String,
    pub(crate) factors: Vec<f64>,
    pub(crate) speed: f64,
}

impl Model {
    /// A mechanism that nothing drives or holds yet.
    #[must_use]
    pub fn new(mechanism: Mechanism) -> Self {
        let mut made = Self { mechanism, torques: vec![], elements: vec![], thresholds: vec![] };
        let one_way: Vec<_> =
            made.mechanism.elements.iter().filter(|(.., is_one_way)| *is_one_way).cloned().collect();
        for (name, links, _) in one_way {
            // Its links are of the gearbox; one whose links are one piece never slips.
            let _ = made.join(&name, [&links[0], &links[1]], Kind::OneWay);
        }
        made
    }

    /// What moves.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Applies a torque to a link.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a link that is not there, [`Error::Duplicate`] for a name given twice.
    pub fn torque(&mut self, name: &str, link: &str, law: TorqueLaw) -> Result<(), Error> {
        self.check_name(name)?;
        let place = self.mechanism.place(link)?;
        let speed = self.mechanism.speed_factors(link)?;
        self.torques.push(Applied { name: name.to_owned(), place, law: law.0, speed });
        Ok(())
    }

    /// Loads a link with a torque of this size against its motion, which holds it at rest while it can: rolling resistance, a
    /// grade's friction, a tool in the ground.
    ///
    /// # Errors
    /// As [`friction`](Self::friction).
    pub fn resistance(&mut self, name: &str, link: &str, torque: Torque) -> Result<(), Error> {
        self.friction(name, [link, GROUND], Course::constant(torque)?, 1.0)
    }

    /// Joins two links, or a link and the housing, by friction of a capacity over time and a ratio of static over kinetic friction.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`]; [`Error::Value`] for a capacity below 0 and a ratio that is
    /// not finite or below 1.
    pub fn friction(
        &mut self,
        name: &str,
        links: [&str; 2],
        capacity: Course,
        static_ratio: f64,
    ) -> Result<(), Error> {
        if !(static_ratio >= 1.0 && static_ratio.is_finite()) {
            let field = format!("static over kinetic friction of {name}");
            return Err(Error::Value { field, value: static_ratio, allowed: "it is finite and at least 1" });
        }
        let capacity = capacity.into_capacity(name)?;
        self.join(name, links, Kind::Friction { capacity, static_ratio })
    }

    /// Gives a shift element of the gearbox a capacity over time.
    ///
    /// # Errors
    /// [`Error::Unknown`] for one that is not there, is one-way, or engaged for good; and as [`friction`](Self::friction).
    pub fn shift_element(&mut self, name: &str, capacity: Course, static_ratio: f64) -> Result<(), Error> {
        let found = self.mechanism.elements.iter().find(|(id, _, one_way)| id == name && !one_way);
        let unknown = || Error::Unknown { what: "shift element with a capacity", name: name.to_owned() };
        let links = found.ok_or_else(unknown)?.1.clone();
        self.friction(name, [&links[0], &links[1]], capacity, static_ratio)
    }

    /// Keeps the first link from turning slower than the second.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`].
    pub fn one_way_clutch(&mut self, name: &str, links: [&str; 2]) -> Result<(), Error> {
        self.join(name, links, Kind::OneWay)
    }

    /// Makes the passing of a speed by a link an event.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`]; [`Error::Value`] of a speed that is not finite.
    pub fn threshold(&mut self, name: &str, link: &str, speed: AngularVelocity) -> Result<(), Error> {
        self.check_name(name)?;
        let factors = self.mechanism.speed_factors(link)?;
        let speed = crate::course::finite("the speed of a threshold in rad/s", rad_per_s(speed))?;
        self.thresholds.push(Threshold { name: name.to_owned(), factors, speed });
        Ok(())
    }

    fn join(&mut self, name: &str, links: [&str; 2], kind: Kind) -> Result<(), Error> {
        self.check_name(name)?;
        let places = [self.mechanism.place(links[0])?, self.mechanism.place(links[1])?];
        if places[0] == places[1] {
            let [first, second] = links.map(ToOwned::to_owned);
            return Err(Error::OnePiece { element: name.to_owned(), first, second });
        }
        let [first, second] =
            [self.mechanism.speed_factors(links[0])?, self.mechanism.speed_factors(links[1])?];
        let slip = first.iter().zip(&second).map(|(one, other)| one - other).collect();
        self.elements.push(Element { name: name.to_owned(), places, slip, kind });
        Ok(())
    }

    fn check_name(&self, name: &str) -> Result<(), Error> {
        let mut names =
            self.torques.iter().map(|one| &one.name).chain(self.elements.iter().map(|one| &one.name));
        if names.any(|one| one == name) || self.thresholds.iter().any(|one| one.name == name) {
            return Err(Error::Duplicate { what: "torque, element or threshold", name: name.to_owned() });
        }
        Ok(())
    }
}
