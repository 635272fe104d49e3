//! Losses that do not depend on the load: drag torques of seals, bearings, churning and open shift elements.
//!
//! A drag acts between two links and opposes their relative motion. Its torque is given as a curve over the
//! relative speed.
//!
//! ```text
//! M = M(|ω_1 − ω_2|)            linear between the points of the curve
//! T_1 = −M·sign(ω_1 − ω_2)      T_2 = −T_1
//! P = M·|ω_1 − ω_2|
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `M` | size of the torque, at least 0 | N·m |
//! | `ω_1`, `ω_2` | speeds of the links | rad/s |
//! | `T_1`, `T_2` | torques on the links | N·m |
//! | `P` | power lost | W |
//!
//! Speeds follow from the gear alone, so the drags at a speed are known torques. They enter the torque
//! balances of the links together with input and output, and load the meshes. The direction of power through
//! each mesh, and so its loss, takes them into account. A drag between links of equal speed does nothing. The
//! drag of a shift element acts while the element is not engaged.

use crate::error::DragFault;
use crate::power_flow::MeshPower;
use crate::tolerance::{LARGEST_LOAD, POWER, SPEED};
use crate::{Analysis, Error, Gearbox, LinkId, Place, State};
use epicyclic_numerics::values::largest_absolute;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Rule for the torque beyond the last point of a curve, and before its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Beyond {
    /// Nothing: such a speed is refused.
    #[default]
    Refused,
    /// The torque of the nearest point.
    Constant,
}

/// A torque over a relative speed.
#[derive(Debug, Clone, PartialEq)]
pub struct DragCurve {
    /// Speeds in rad/s, ascending, and torques in N·m.
    points: Vec<[f64; 2]>,
    beyond: Beyond,
}

impl DragCurve {
    /// A curve through points.
    ///
    /// # Errors
    /// [`DragFault::NoPoints`]; [`DragFault::Speed`] for a speed below 0 or not finite, [`DragFault::Torque`]
    /// for such a torque, [`DragFault::NotAscending`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_train::drag::{Beyond, DragCurve};
    /// use uom::si::angular_velocity::radian_per_second;
    /// use uom::si::f64::{AngularVelocity, Torque};
    /// use uom::si::torque::newton_meter;
    /// # fn main() -> Result<(), epicyclic_train::error::DragFault> {
    /// let (omega, n_m) = (AngularVelocity::new::<radian_per_second>, Torque::new::<newton_meter>);
    /// let curve = DragCurve::new(&[(omega(0.0), n_m(0.5)), (omega(100.0), n_m(1.5))], Beyond::Refused)?;
    /// assert_eq!(curve.at(omega(-50.0)), Some(n_m(1.0)));
    /// assert_eq!(curve.at(omega(101.0)), None);
    /// # Ok(())
    /// # }
    /// ```
    pub fn new(points: &[(AngularVelocity, Torque)], beyond: Beyond) -> Result<Self, DragFault> {
        if points.is_empty() {
            return Err(DragFault::NoPoints);
        }
        let points: Vec<[f64; 2]> = points.iter().map(|(speed, torque)| [speed.si(), torque.si()]).collect();
        let is_allowed = |value: f64| (0.0..=LARGEST_LOAD).contains(&value);
        for (place, [speed, torque]) in points.iter().enumerate() {
            if !is_allowed(*speed) {
                return Err(DragFault::Speed { place, speed: AngularVelocity::from_si(*speed) });
            }
            if !is_allowed(*torque) {
                return Err(DragFault::Torque { place, torque: Torque::from_si(*torque) });
            }
            if place > 0 && *speed <= points[place - 1][0] {
                return Err(DragFault::NotAscending { place });
            }
        }
        Ok(Self { points, beyond })
    }

    /// The torque at a relative speed of any sign; `None` outside the curve.
    #[must_use]
    pub fn at(&self, speed: AngularVelocity) -> Option<Torque> {
        let speed = speed.si().abs();
        let next = self.points.partition_point(|point| point[0] < speed);
        let point = |place: Option<usize>| place.and_then(|place| self.points.get(place)).copied();
        let value = match [point(next.checked_sub(1)), point(Some(next))] {
            [_, Some([at, torque])] if at == speed => torque,
            [Some(from), Some(to)] => from[1] + (to[1] - from[1]) * (speed - from[0]) / (to[0] - from[0]),
            [Some([_, torque]), None] | [None, Some([_, torque])] if self.beyond == Beyond::Constant => {
                torque
            }
            _ => return None,
        };
        Some(Torque::from_si(value))
    }

    /// The first and the last speed.
    #[must_use]
    pub fn speeds(&self) -> [AngularVelocity; 2] {
        let last = self.points.len() - 1;
        [self.points[0][0], self.points[last][0]].map(AngularVelocity::from_si)
    }

    /// Points of the curve, by ascending speed.
    #[must_use]
    pub fn points(&self) -> impl DoubleEndedIterator<Item = (AngularVelocity, Torque)> + '_ {
        self.points.iter().map(|&[speed, size]| (AngularVelocity::from_si(speed), Torque::from_si(size)))
    }

    /// Rule for the torque outside the points of the curve.
    #[must_use]
    pub fn beyond(&self) -> Beyond {
        self.beyond
    }
}

/// A drag between two links.
#[derive(Debug, Clone, PartialEq)]
pub struct Drag {
    /// Name of the drag.
    pub name: String,
    /// The links.
    pub links: [LinkId; 2],
    /// The torque over the relative speed.
    pub curve: DragCurve,
    /// The shift element that it is of, by its place in
    /// [`Gearbox::shift_elements`](crate::Gearbox::shift_elements): it acts while that is not engaged. Any
    /// other drag acts always.
    pub shift_element: Option<usize>,
}

impl Gearbox {
    /// A drag between two links, by their names.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a link, [`Error::Drag`] for a link and itself.
    pub fn drag(&self, name: &str, links: [&str; 2], curve: DragCurve) -> Result<Drag, Error> {
        let links = self.drag_links(name, links).map_err(|mut faults| faults.swap_remove(0).1)?;
        Ok(Drag { name: name.to_owned(), links, curve, shift_element: None })
    }

    /// The links of a drag, by their names.
    ///
    /// # Errors
    /// Those of [`drag`](Self::drag), at least one, each with the index of its link; without an index if it
    /// is about both.
    pub fn drag_links(
        &self,
        name: &str,
        links: [&str; 2],
    ) -> Result<[LinkId; 2], Vec<(Option<usize>, Error)>> {
        match links.map(|link| self.link(link)) {
            [Some(first), Some(second)] if first == second => {
                let fault = DragFault::OneLink { link: links[0].to_owned() };
                Err(vec![(None, Error::Drag { drag: name.to_owned(), fault })])
            }
            [Some(first), Some(second)] => Ok([first, second]),
            found => {
                let unknown = (0..2).filter(|&end| found[end].is_none());
                let place = || Place::Drag(name.to_owned());
                Err(unknown.map(|end| (Some(end), self.unknown_link(links[end], place()))).collect())
            }
        }
    }

    /// The drag of a shift element while it is not engaged.
    ///
    /// # Errors
    /// [`Error::Unknown`] for the shift element.
    pub fn drag_of_shift_element(&self, id: &str, curve: DragCurve) -> Result<Drag, Error> {
        let place = self.shift_element(id, || Place::Drag(id.to_owned()))?;
        let links = self.shift_elements()[place].links();
        Ok(Drag { name: id.to_owned(), links, curve, shift_element: Some(place) })
    }
}

/// Known torque of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// Torque on the input from outside.
    Input(Torque),
    /// Torque on the output from outside: against its speed where a machine takes power there.
    Output(Torque),
}

/// A drag at work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DragAtWork {
    /// Speed of its first link less that of its second.
    pub slip: AngularVelocity,
    /// Size of its torque; 0 where it does not act.
    pub torque: Torque,
    /// Power that it takes.
    pub loss: Power,
}

/// A gear at a speed and a load with all its losses.
#[derive(Debug, Clone, PartialEq)]
pub struct WithDrags {
    /// Speed of the input.
    pub input_speed: AngularVelocity,
    /// Speed of the output.
    pub output_speed: AngularVelocity,
    /// Torque on the input from outside.
    pub input: Torque,
    /// Torque on the output from outside.
    pub output: Torque,
    /// The drags, in their order.
    pub drags: Vec<DragAtWork>,
    /// Power through each mesh of each set in W; `None` for a set in which a member's speed does not follow,
    /// which then carries no torque.
    pub meshes: Vec<Option<Vec<MeshPower>>>,
    /// One-way clutches that the gear relies on and that release, since they would need a torque below 0: no
    /// such operation exists. Places in [`Gearbox::shift_elements`](crate::Gearbox::shift_elements).
    pub released: Vec<usize>,
    /// The largest power inside: the measure for balances.
    pub largest: Power,
}

impl WithDrags {
    /// Power that enters at the input; negative where it leaves.
    #[must_use]
    pub fn input_power(&self) -> Power {
        Power::from_si(self.input.si() * self.input_speed.si())
    }

    /// Power that enters at the output; negative where it leaves.
    #[must_use]
    pub fn output_power(&self) -> Power {
        Power::from_si(self.output.si() * self.output_speed.si())
    }

    /// Power that the meshes of a set take.
    #[must_use]
    pub fn loss_of_set(&self, set: usize) -> Power {
        let meshes = self.meshes.get(set).and_then(Option::as_ref);
        Power::from_si(meshes.into_iter().flatten().map(|mesh| mesh.enters - mesh.leaves).sum())
    }

    /// Power that all meshes take.
    #[must_use]
    pub fn mesh_loss(&self) -> Power {
        (0..self.meshes.len())
            .map(|set| self.loss_of_set(set))
            .fold(Power::from_si(0.0), |sum, loss| sum + loss)
    }

    /// Power that all drags take.
    #[must_use]
    pub fn drag_loss(&self) -> Power {
        Power::from_si(self.drags.iter().map(|drag| drag.loss.si()).sum())
    }

    /// Residual of the energy balance: powers that enter, less all losses, each computed from its own torque,
    /// force or speed. The residual is rounding alone, below 1e-9 of [`largest`](Self::largest).
    #[must_use]
    pub fn imbalance(&self) -> Power {
        self.input_power() + self.output_power() - self.mesh_loss() - self.drag_loss()
    }

    /// Power that leaves over power that enters, from input to output or back; `None` where all that enters
    /// is lost, or none does.
    #[must_use]
    pub fn efficiency(&self) -> Option<f64> {
        let (input, output) = (self.input_power().si(), self.output_power().si());
        let nothing = POWER * self.largest.si();
        if input > nothing && output < -nothing {
            Some(-output / input)
        } else if output > nothing && input < -nothing {
            Some(-input / output)
        } else {
            None
        }
    }
}

impl Analysis<'_> {
    /// The gear at this input speed and load with the losses of its meshes and these drags.
    ///
    /// ```
    /// use epicyclic_gears::efficiency::MeshEfficiency;
    /// use epicyclic_train::drag::{Beyond, Drag, DragCurve, Load};
    /// use epicyclic_train::{Gearbox, LinkId, set::{MeshLoss, SetSpec}};
    /// use uom::si::angular_velocity::radian_per_second;
    /// use uom::si::f64::{AngularVelocity, Torque};
    /// use uom::si::torque::newton_meter;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let loss = MeshLoss::Set(MeshEfficiency::new(0.97)?);
    /// let gearbox = Gearbox::builder("conveyor")
    ///     .links(["D", "B", "T1"])
    ///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0).with_loss(loss))
    ///     .brake("K1", "T1")
    ///     .input("D")
    ///     .output("B")
    ///     .gear("slow", ["K1"])
    ///     .build()?;
    /// let (omega, n_m) = (AngularVelocity::new::<radian_per_second>, Torque::new::<newton_meter>);
    /// let seal = Drag {
    ///     name: "seal".into(),
    ///     links: [gearbox.link("D").unwrap(), LinkId::GROUND],
    ///     curve: DragCurve::new(&[(omega(0.0), n_m(2.0))], Beyond::Constant)?,
    ///     shift_element: None,
    /// };
    /// let work = gearbox.analyze("slow")?.with_drags(omega(100.0), Load::Input(n_m(500.0)), &[seal])?;
    /// // 2 N·m stay in the seal; of the rest the meshes leave (1 + 3·0.97)/4.
    /// assert!((work.output.get::<newton_meter>() + 498.0 * 3.91).abs() < 1e-9);
    /// assert!((work.efficiency().unwrap() - 498.0 / 500.0 * 3.91 / 4.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::NotDriven`] in any other state, [`Error::OperatingPoint`] for a speed or load that is not
    /// finite; [`Error::Drag`] for a relative speed outside a curve or that does not follow;
    /// [`Error::Inputs`] where losses hold the gear or sets share a torque that nothing settles.
    pub fn with_drags(
        &self,
        input_speed: AngularVelocity,
        load: Load,
        drags: &[Drag],
    ) -> Result<WithDrags, Error> {
        let not_driven = || Error::NotDriven { state: self.state().to_string() };
        let of_input = |link: LinkId| self.speed(link).map(|speed| speed * input_speed.si());
        let ends = [self.gear.input, self.gear.output];
        let [Some(_), Some(output_speed)] = ends.map(of_input) else { return Err(not_driven()) };
        if *self.kinematic_state() != State::Driven {
            return Err(not_driven());
        }
        let (known, given) = match load {
            Load::Input(torque) => (0, torque),
            Load::Output(torque) => (1, torque),
        };
        let enters = given.si() * [input_speed.si(), output_speed][known] * [1.0, -1.0][known] > 0.0;
        if enters && matches!(self.state(), State::SelfLocking { .. }) {
            return Err(not_driven());
        }
        let at_work = drags.iter().map(|drag| self.drag(drag, of_input)).collect::<Result<Vec<_>, _>>()?;

        // Torques of the drags on the nodes. Those at the ends join the load there.
        let node = |link: LinkId| self.topology.node[link.index()];
        let mut on_node: Vec<(LinkId, usize, f64)> = vec![];
        for (drag, at) in drags.iter().zip(&at_work) {
            let on_first = -at.torque.si() * at.slip.si().signum();
            for (link, torque) in drag.links.into_iter().zip([on_first, -on_first]) {
                let Some(place) = node(link).filter(|_| torque != 0.0) else { continue };
                match on_node.iter_mut().find(|(_, other, _)| *other == place) {
                    Some((.., sum)) => *sum += torque,
                    None => on_node.push((link, place, torque)),
                }
            }
        }
        let mut take = |end: LinkId| {
            let found = on_node.iter().position(|(_, place, _)| Some(*place) == node(end));
            found.map_or(0.0, |found| on_node.swap_remove(found).2)
        };
        let own = take(ends[known]);
        let of_other = take(ends[1 - known]);
        let mut torques = vec![(ends[known], Torque::from_si(given.si() + own))];
        torques.extend(on_node.iter().map(|(link, _, own)| (*link, Torque::from_si(*own))));
        let state = self.gearbox.with_inputs(&self.gear, &[(ends[0], input_speed)], &torques)?;
        let found = state.load.ok_or_else(not_driven)?;
        // Its terminals have the input first, its output second; where they are one link, the second stands
        // for both.
        let of_terminal = |end: LinkId| {
            let one = found.terminals.iter().find(|terminal| terminal.link == end);
            one.map_or(0.0, |terminal| terminal.torque.si())
        };
        let mut at_ends = [given, given];
        at_ends[1 - known] = Torque::from_si(of_terminal(ends[1 - known]) - of_other);
        let members = found.members.iter().flatten().copied();
        let largest_torque = largest_absolute(torques.iter().map(|(_, torque)| torque.si()).chain(members));
        let lets_go = |place: &usize| {
            self.gearbox.shift_elements()[*place].is_one_way()
                && found.shift_elements[*place].is_some_and(|torque| torque.si() < -POWER * largest_torque)
        };
        let mut found_at = WithDrags {
            input_speed,
            output_speed: AngularVelocity::from_si(output_speed),
            input: at_ends[0],
            output: at_ends[1],
            meshes: vec![],
            released: self.gear.engaged().iter().copied().filter(lets_go).collect(),
            largest: Power::from_si(found.power.largest),
            drags: at_work,
        };
        let others = found_at.drags.iter().map(|drag| drag.loss);
        let others = others.chain([found_at.input_power(), found_at.output_power()]);
        found_at.largest = others.fold(found_at.largest, |most, power| most.max(power.abs()));
        // Rounding alone leaves power in an idle mesh.
        let nothing = POWER * found_at.largest.si();
        let busy = |mesh: MeshPower| if mesh.enters > nothing { mesh } else { MeshPower::default() };
        let meshes = (0..self.gearbox.sets().len()).map(|set| found.meshes(self.gearbox, set));
        let meshes = meshes.map(|of_set| Some(of_set?.into_iter().map(busy).collect()));
        found_at.meshes = meshes.collect();
        Ok(found_at)
    }

    fn drag(&self, drag: &Drag, speed: impl Fn(LinkId) -> Option<f64>) -> Result<DragAtWork, Error> {
        let refuse = |fault| Error::Drag { drag: drag.name.clone(), fault };
        let idle = DragAtWork {
            slip: AngularVelocity::from_si(0.0),
            torque: Torque::from_si(0.0),
            loss: Power::from_si(0.0),
        };
        if drag.shift_element.is_some_and(|element| self.gear.engaged().contains(&element)) {
            return Ok(idle);
        }
        let of_link = |link: LinkId| {
            speed(link)
                .ok_or_else(|| refuse(DragFault::Adrift { link: self.gearbox.link_name(link).to_owned() }))
        };
        let [first, second] = [of_link(drag.links[0])?, of_link(drag.links[1])?];
        let slip = first - second;
        if slip.abs() <= SPEED * first.abs().max(second.abs()) {
            return Ok(idle);
        }
        let slip = AngularVelocity::from_si(slip);
        let outside = || refuse(DragFault::Outside { slip: slip.abs(), speeds: drag.curve.speeds() });
        let found = drag.curve.at(slip).ok_or_else(outside)?;
        Ok(DragAtWork { slip, torque: found, loss: Power::from_si(found.si() * slip.si().abs()) })
    }
}
