//! A mechanism with what drives, loads and holds it.

use crate::Error;
use crate::converter::{Converter, Coupling};
use crate::course::Course;
use crate::drag::{Curve, Drag};
use crate::mechanism::{Mechanism, Place, not_negative};
use crate::shaft::{Joint, Shaft};
use crate::table;
use crate::tolerance::RANK;
use crate::torque_law::{Law, TorqueLaw};
use epicyclic_numerics::values::{dot, largest_absolute};
use epicyclic_train::GROUND;
use epicyclic_train::drag::DragCurve;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// A mechanism with sources, loads, shift elements and thresholds.
///
/// A friction element between two links carries, with `s = ω_1 − ω_2` and the capacity `C`:
///
/// ```text
/// slipping   T_1 = −C·sign s                       T_2 = −T_1
/// stuck      T_1 as s = 0 asks, |T_1| ≤ κ·C        κ ≥ 1: static over kinetic friction
/// ```
///
/// A one-way clutch has `T_1 ≥ 0` with `s = 0`, or no torque with `s > 0`. A load that opposes motion is a
/// friction element with the housing.
///
/// One-way clutches of the gearbox are part of the model from the start; its other shift elements are open
/// until they are given a capacity.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(crate) mechanism: Mechanism,
    pub(crate) torques: Vec<Applied>,
    /// Elements with names of their own, then those that carry the dry friction of drags alone.
    pub(crate) elements: Vec<Element>,
    pub(crate) drags: Vec<Drag>,
    pub(crate) thresholds: Vec<Threshold>,
    pub(crate) shafts: Vec<Joint>,
    pub(crate) converters: Vec<Coupling>,
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

/// Element that joins two links.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Element {
    pub(crate) name: String,
    pub(crate) places: [Place; 2],
    /// `ω_1 − ω_2` over the coordinates.
    pub(crate) slip: Vec<f64>,
    pub(crate) kind: Kind,
    /// Dry friction of drags that it carries beside its own: `M_0` of all.
    pub(crate) dry: f64,
    /// A dog clutch between the same links: while it is engaged, drags do nothing.
    pub(crate) beside: Option<usize>,
}

/// Kind of an element, by which it carries torque.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Kind {
    /// Capacity while slipping, `κ`, and the factor of the capacity over slip speed; 1 where that has no
    /// points.
    Friction {
        capacity: Course,
        static_ratio: f64,
        curve: Vec<[f64; 2]>,
    },
    OneWay,
    /// Times from which the clutch is to be engaged or open; the largest slip at which it engages.
    Dog {
        program: Vec<(f64, bool)>,
        limit: f64,
    },
    /// The dry friction of drags, and nothing else.
    Drag,
}

impl Kind {
    /// Whether this is a dog clutch that shall be engaged at a time.
    pub(crate) fn is_wanted(&self, t: f64) -> bool {
        let Self::Dog { program, .. } = self else { return false };
        let passed = program.partition_point(|(time, _)| *time <= t);
        passed.checked_sub(1).is_some_and(|last| program[last].1)
    }
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
        let mut made = Self {
            mechanism,
            torques: vec![],
            elements: vec![],
            drags: vec![],
            thresholds: vec![],
            shafts: vec![],
            converters: vec![],
        };
        let one_way: Vec<_> =
            made.mechanism.elements.iter().filter(|(.., is_one_way)| *is_one_way).cloned().collect();
        for (name, links, _) in one_way {
            // Its links are of the gearbox; one whose links are one piece never slips.
            let _ = made.join(&name, [&links[0], &links[1]], Kind::OneWay);
        }
        made
    }

    /// Mechanism of the model.
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

    /// Loads a link with a torque of this size against its motion, which holds it at rest while it can:
    /// rolling resistance, a grade's friction, a tool in the ground.
    ///
    /// # Errors
    /// As [`friction`](Self::friction).
    pub fn resistance(&mut self, name: &str, link: &str, torque: Torque) -> Result<(), Error> {
        self.friction(name, [link, GROUND], Course::constant(torque)?, 1.0)
    }

    /// Joins two links, or a link and the housing, by friction of a capacity over time and a ratio of static
    /// over kinetic friction.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`]; [`Error::Value`] for a capacity below 0
    /// and a ratio that is not finite or below 1.
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
        self.join(name, links, Kind::Friction { capacity, static_ratio, curve: vec![] })
    }

    /// Gives a shift element of the gearbox a capacity over time.
    ///
    /// # Errors
    /// [`Error::Unknown`] for one that is not there, is one-way, or engaged for good; and as
    /// [`friction`](Self::friction).
    pub fn shift_element(&mut self, name: &str, capacity: Course, static_ratio: f64) -> Result<(), Error> {
        let links = self.shift_links(name)?;
        self.friction(name, [&links[0], &links[1]], capacity, static_ratio)
    }

    /// Keeps the first link from turning slower than the second.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`].
    pub fn one_way_clutch(&mut self, name: &str, links: [&str; 2]) -> Result<(), Error> {
        self.join(name, links, Kind::OneWay)
    }

    /// Lets the capacity of a friction element depend on its slip speed: it is multiplied by a factor, linear
    /// between points in order of speed and level beyond them. The factor at 0 holds for stuck elements, too,
    /// beside `κ`.
    ///
    /// # Errors
    /// [`Error::Unknown`] of an element that is not there or carries no friction; [`Error::NoPoints`];
    /// [`Error::Order`] of speeds that do not ascend; [`Error::Value`] of a number that is not finite or
    /// below 0.
    pub fn friction_over_slip(&mut self, name: &str, points: &[(AngularVelocity, f64)]) -> Result<(), Error> {
        let field = || format!("friction over slip speed of {name}");
        let found = self.elements.iter_mut().find(|one| one.name == name).map(|one| &mut one.kind);
        let Some(Kind::Friction { curve, .. }) = found else {
            return Err(Error::Unknown { what: "friction element", name: name.to_owned() });
        };
        if points.is_empty() {
            return Err(Error::NoPoints { field: field() });
        }
        let points: Vec<[f64; 2]> = points.iter().map(|(speed, factor)| [speed.si(), *factor]).collect();
        for (place, [speed, factor]) in points.iter().enumerate() {
            not_negative(format!("a speed in rad/s of the {}", field()), *speed)?;
            not_negative(format!("a factor of the {}", field()), *factor)?;
            if place > 0 && *speed <= points[place - 1][0] {
                return Err(Error::Order {
                    field: field(),
                    place: place + 1,
                    value: *speed,
                    before: points[place - 1][0],
                    unit: "rad/s",
                    allowed: "speeds ascend",
                });
            }
        }
        *curve = points;
        Ok(())
    }

    /// The factor of a friction element's capacity at a slip speed of either sign; 1 of one whose friction
    /// depends on none, and of other elements.
    #[must_use]
    pub fn friction_factor(&self, name: &str, slip: AngularVelocity) -> f64 {
        let speed = slip.si().abs();
        match self.elements.iter().find(|one| one.name == name).map(|one| &one.kind) {
            Some(Kind::Friction { curve, .. }) if !curve.is_empty() => {
                table::value(curve, table::segment(curve, speed, true), speed)
            }
            _ => 1.0,
        }
    }

    /// Joins two links by an elastic, damped shaft with backlash: links of the gearbox, the housing, or
    /// further [bodies](Mechanism::with_body).
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`].
    pub fn shaft(&mut self, name: &str, links: [&str; 2], shaft: Shaft) -> Result<(), Error> {
        let (places, [first, second]) = self.between(name, links)?;
        let rate = first.iter().zip(&second).map(|(one, other)| one - other).collect();
        self.shafts.push(Joint { name: name.to_owned(), places, rate, shaft });
        Ok(())
    }

    /// Joins an impeller and a turbine by a torque converter; its reactor is held by the housing.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`].
    pub fn converter(&mut self, name: &str, links: [&str; 2], converter: Converter) -> Result<(), Error> {
        let (places, speeds) = self.between(name, links)?;
        self.converters.push(Coupling { name: name.to_owned(), places, speeds, converter });
        Ok(())
    }

    /// Joins two links, or a link and the housing, by a dog clutch. The clutch is engaged or open from each
    /// of these times on, and open before.
    ///
    /// The clutch engages as soon as its slip is at most `limit`; without a limit it engages at any slip. It
    /// engages by an impact, which ends the slip at once and keeps the momentum, `Δq̇ = M⁻¹·Dᵀ·Λ`. `Λ` are
    /// the impulses of all dog clutches that are engaged and of the one-way clutches that would slip
    /// backwards. Friction, meshes' losses, shafts and converters have finite torques and no part in it. The
    /// kinetic energy lost is in [`Audit::impacts`](crate::Audit::impacts). Once engaged the clutch carries
    /// any torque.
    ///
    /// # Errors
    /// - [`Error::Unknown`], [`Error::Duplicate`], [`Error::OnePiece`];
    /// - [`Error::NoPoints`] without times;
    /// - [`Error::Order`] for times that do not ascend;
    /// - [`Error::Value`] for a time that is not finite, and for a limit that is not finite or below 0.
    pub fn dog_clutch(
        &mut self,
        name: &str,
        links: [&str; 2],
        program: &[(Time, bool)],
        limit: Option<AngularVelocity>,
    ) -> Result<(), Error> {
        let field = || format!("the program of {name}");
        if program.is_empty() {
            return Err(Error::NoPoints { field: field() });
        }
        let program: Vec<(f64, bool)> =
            program.iter().map(|&(time, is_engaged)| (time.si(), is_engaged)).collect();
        for (place, &(time, _)) in program.iter().enumerate() {
            crate::course::finite(&format!("a time in s of {}", field()), time)?;
            if place > 0 && time <= program[place - 1].0 {
                return Err(Error::Order {
                    field: field(),
                    place: place + 1,
                    value: time,
                    before: program[place - 1].0,
                    unit: "s",
                    allowed: "times ascend",
                });
            }
        }
        let limit = limit.map_or(Ok(f64::INFINITY), |limit| {
            not_negative(format!("the largest slip in rad/s at which {name} engages"), limit.si())
        })?;
        self.join(name, links, Kind::Dog { program, limit })
    }

    /// Makes a shift element of the gearbox a dog clutch.
    ///
    /// # Errors
    /// [`Error::Unknown`] for one that is not there, is one-way, or engaged for good; and as
    /// [`dog_clutch`](Self::dog_clutch).
    pub fn shift_dog_clutch(
        &mut self,
        name: &str,
        program: &[(Time, bool)],
        limit: Option<AngularVelocity>,
    ) -> Result<(), Error> {
        let links = self.shift_links(name)?;
        self.dog_clutch(name, [&links[0], &links[1]], program, limit)
    }

    /// Adds a drag between two links, or a link and the housing, by a curve over their relative speed. A
    /// torque at rest other than 0 is dry friction: an element between the same links then holds that much
    /// more, otherwise the drag sticks alone. Links that never turn against each other do not drag. Drags
    /// must be added after the elements between the same links.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a link that is not there.
    ///
    /// # Example
    /// A flywheel that its seal brings to rest: `ω = ω_0 − M·t/J`.
    ///
    /// ```
    /// use epicyclic_motion::{Mechanism, Model, Start};
    /// use epicyclic_train::{GROUND, drag::{Beyond, DragCurve}};
    /// use uom::si::f64::{AngularVelocity, MomentOfInertia, Time, Torque};
    /// use uom::si::angular_velocity::radian_per_second;
    /// use uom::si::moment_of_inertia::kilogram_square_meter;
    /// use uom::si::{energy::joule, time::second, torque::newton_meter};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let omega = AngularVelocity::new::<radian_per_second>;
    /// let wheel = [("wheel", MomentOfInertia::new::<kilogram_square_meter>(2.0))];
    /// let mut model = Model::new(Mechanism::shafts(&wheel)?);
    /// let curve = DragCurve::new(&[(omega(0.0), Torque::new::<newton_meter>(4.0))], Beyond::Constant)?;
    /// model.drag("seal", ["wheel", GROUND], &curve)?;
    /// let run = model.run(&Start::speeds(&[("wheel", omega(30.0))]), Time::new::<second>(20.0), None)?;
    /// assert!((run.events[0].after.time.get::<second>() - 15.0).abs() < 1e-9);
    /// assert!((run.audit.drags[0].get::<joule>() - 900.0).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    pub fn drag(&mut self, name: &str, links: [&str; 2], curve: &DragCurve) -> Result<(), Error> {
        let places = [self.mechanism.place(links[0])?, self.mechanism.place(links[1])?];
        let [first, second] =
            [self.mechanism.speed_factors(links[0])?, self.mechanism.speed_factors(links[1])?];
        let slip: Vec<f64> = first.iter().zip(&second).map(|(one, other)| one - other).collect();
        let curve = Curve::new(curve);
        let mut carrier = None;
        if curve.dry > 0.0 && largest_absolute(&slip) > RANK {
            carrier = Some(self.carrier(name, places, &slip));
        }
        if let Some((place, _)) = carrier {
            self.elements[place].dry += curve.dry;
        }
        self.drags.push(Drag { name: name.to_owned(), places, slip, curve, carrier });
        Ok(())
    }

    /// The drag of a shift element of the gearbox, which acts whenever its links turn against each other.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a shift element that is not there or is engaged for good.
    pub fn shift_drag(&mut self, name: &str, curve: &DragCurve) -> Result<(), Error> {
        let found = self.mechanism.elements.iter().find(|(id, ..)| id == name);
        let unknown = || Error::Unknown { what: "shift element that may be open", name: name.to_owned() };
        let [first, second] = found.ok_or_else(unknown)?.1.clone();
        self.drag(name, [&first, &second], curve)
    }

    /// Finds the element that carries dry friction of this slip, and the sign of its own slip when this is
    /// above 0. It is a friction element or a one-way clutch of the same slip, else a new element.
    fn carrier(&mut self, name: &str, places: [Place; 2], slip: &[f64]) -> (usize, f64) {
        let size = largest_absolute(slip);
        let sign_of = |one: &Element| {
            let sign = dot(&one.slip, slip).signum();
            let apart = one.slip.iter().zip(slip).map(|(one, other)| one - sign * other);
            let are_one = one.places == places || one.places == [places[1], places[0]];
            (are_one && largest_absolute(apart) <= RANK * size).then_some(sign)
        };
        let is_dog = |one: &Element| matches!(one.kind, Kind::Dog { .. });
        let beside = self.elements.iter().position(|one| is_dog(one) && sign_of(one).is_some());
        let with = self.elements.iter().enumerate().filter(|(_, one)| !is_dog(one));
        let found = with.filter_map(|(place, one)| Some((place, sign_of(one)?))).next();
        let (place, sign) = found.unwrap_or((self.elements.len(), 1.0));
        if found.is_none() {
            let (name, slip) = (name.to_owned(), slip.to_vec());
            self.elements.push(Element { name, places, slip, kind: Kind::Drag, dry: 0.0, beside });
        }
        self.elements[place].beside = beside;
        (place, sign)
    }

    /// Makes the passing of a speed by a link an event.
    ///
    /// # Errors
    /// [`Error::Unknown`], [`Error::Duplicate`]; [`Error::Value`] of a speed that is not finite.
    pub fn threshold(&mut self, name: &str, link: &str, speed: AngularVelocity) -> Result<(), Error> {
        self.check_name(name)?;
        let factors = self.mechanism.speed_factors(link)?;
        let speed = crate::course::finite("the speed of a threshold in rad/s", speed.si())?;
        self.thresholds.push(Threshold { name: name.to_owned(), factors, speed });
        Ok(())
    }

    /// Links of a shift element of the gearbox that is neither one-way nor engaged for good.
    fn shift_links(&self, name: &str) -> Result<[String; 2], Error> {
        let found = self.mechanism.elements.iter().find(|(id, _, one_way)| id == name && !one_way);
        let unknown = || Error::Unknown { what: "shift element with a capacity", name: name.to_owned() };
        Ok(found.ok_or_else(unknown)?.1.clone())
    }

    fn join(&mut self, name: &str, links: [&str; 2], kind: Kind) -> Result<(), Error> {
        let (places, [first, second]) = self.between(name, links)?;
        let mut slip: Vec<f64> = first.iter().zip(&second).map(|(one, other)| one - other).collect();
        // Links that the sets hold together: what is left is the rounding of their speeds.
        if largest_absolute(&slip) <= RANK * largest_absolute(&first).max(largest_absolute(&second)) {
            slip.fill(0.0);
        }
        self.insert(Element { name: name.to_owned(), places, slip, kind, dry: 0.0, beside: None });
        Ok(())
    }

    /// Puts an element before those of drags.
    fn insert(&mut self, element: Element) {
        let place = self.own_elements();
        self.elements.insert(place, element);
        for (carrier, _) in self.drags.iter_mut().filter_map(|drag| drag.carrier.as_mut()) {
            *carrier += usize::from(*carrier >= place);
        }
    }

    /// Number of elements that are not of drags alone.
    pub(crate) fn own_elements(&self) -> usize {
        self.elements.iter().take_while(|one| !matches!(one.kind, Kind::Drag)).count()
    }

    /// Places of two links that are to be joined, and their speeds over the coordinates.
    fn between(&self, name: &str, links: [&str; 2]) -> Result<([Place; 2], [Vec<f64>; 2]), Error> {
        self.check_name(name)?;
        let places = [self.mechanism.place(links[0])?, self.mechanism.place(links[1])?];
        if places[0] == places[1] {
            let [first, second] = links.map(ToOwned::to_owned);
            return Err(Error::OnePiece { element: name.to_owned(), first, second });
        }
        Ok((places, [self.mechanism.speed_factors(links[0])?, self.mechanism.speed_factors(links[1])?]))
    }

    fn check_name(&self, name: &str) -> Result<(), Error> {
        let first = self.torques.iter().map(|one| &one.name).chain(self.elements.iter().map(|one| &one.name));
        let second =
            self.shafts.iter().map(|one| &one.name).chain(self.converters.iter().map(|one| &one.name));
        let mut names = first.chain(second).chain(self.thresholds.iter().map(|one| &one.name));
        if names.any(|one| one == name) {
            return Err(Error::Duplicate { what: "torque, element or threshold", name: name.to_owned() });
        }
        Ok(())
    }
}
