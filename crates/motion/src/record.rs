//! Result of a run: samples, events, energies.

use crate::field::Field;
use crate::pattern::Way;
use crate::shaft::Contact;
use epicyclic_numerics::values::{dot, largest_absolute};
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularAcceleration, AngularVelocity, Energy, Power, Time, Torque};

/// State of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// The element carries nothing; a dog clutch is not engaged.
    Open,
    /// The element slips with `ω_1 > ω_2`; a one-way clutch overruns.
    Forward,
    /// The element slips with `ω_1 < ω_2`.
    Backward,
    /// The element holds its links together.
    Stuck,
}

impl From<Way> for State {
    fn from(way: Way) -> Self {
        match way {
            Way::Open => Self::Open,
            Way::Forward => Self::Forward,
            Way::Backward => Self::Backward,
            Way::Stuck => Self::Stuck,
        }
    }
}

/// State of an element; one that yields has no slip.
fn state(field: &Field, place: usize) -> State {
    if field.yields[place] { State::Stuck } else { field.pattern.elements[place].into() }
}

/// States of the elements; one without capacity is open, whatever drags hold.
pub(crate) fn states(field: &Field) -> Vec<State> {
    let of = |place: usize| if field.is_open[place] { State::Open } else { state(field, place) };
    (0..field.model.own_elements()).map(of).collect()
}

/// States of the drags whose dry friction has an element of its own; `None` for the others.
pub(crate) fn drag_states(field: &Field) -> Vec<Option<State>> {
    let of = |(place, sign): (usize, f64)| {
        let turned = |state| match state {
            State::Forward if sign < 0.0 => State::Backward,
            State::Backward if sign < 0.0 => State::Forward,
            state => state,
        };
        (field.is_open[place] && !field.is_idle[place]).then(|| turned(state(field, place)))
    };
    field.model.drags.iter().map(|drag| drag.carrier.and_then(of)).collect()
}

/// Torques of elements without drags, and of drags, on their first links. What sticks is the element's up to
/// what it holds.
fn shared(field: &Field, t: f64) -> (Vec<f64>, Vec<f64>) {
    let model = field.model;
    let mut drags = field.drags.clone();
    // What drags hold of the torque of each element.
    let dry = |place: usize| {
        let (one, torque) = (&model.elements[place], field.elements[place]);
        match field.pattern.elements[place] {
            _ if one.dry == 0.0 => 0.0,
            Way::Open => 0.0,
            way @ (Way::Forward | Way::Backward) => -way.sign() * one.dry,
            Way::Stuck => {
                torque
                    - match field.own_capacity(place, t) {
                        Some(own) => torque.clamp(-own, own),
                        None => torque.max(0.0),
                    }
            }
        }
    };
    for (drag, on) in model.drags.iter().zip(&mut drags) {
        let Some((place, sign)) = drag.carrier else { continue };
        if field.pattern.elements[place] == Way::Stuck {
            *on += sign * dry(place) * drag.curve.dry / model.elements[place].dry;
        }
    }
    let own = (0..model.own_elements()).map(|place| field.elements[place] - dry(place));
    (own.collect(), drags)
}

/// Speeds, accelerations and torques at a time, in the order of [`Run`]'s names.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Time of the sample.
    pub time: Time,
    /// Speed of each link.
    pub speeds: Vec<AngularVelocity>,
    /// Acceleration of each link.
    pub accelerations: Vec<AngularAcceleration>,
    /// Applied torques on their links.
    pub torques: Vec<Torque>,
    /// Torque of each element on its first link, without drags.
    pub elements: Vec<Torque>,
    /// State of each element.
    pub states: Vec<State>,
    /// Heat of each element from the start on.
    pub heats: Vec<Energy>,
    /// Whether the torques of the stuck elements follow; otherwise they are the even split, see
    /// [`Model`](crate::Model).
    pub is_split_unique: bool,
    /// Torques on the members of each set from outside it, the carrier last, without what the planets' mass
    /// takes.
    pub sets: Vec<Vec<Torque>>,
    /// Power into each mesh from its first gear, relative to the carrier.
    pub mesh_powers: Vec<Power>,
    /// Torque that each shaft passes on from its first link to its second.
    pub shafts: Vec<Torque>,
    /// Twist of each shaft.
    pub twists: Vec<Angle>,
    /// Contact at the ends of each shaft.
    pub contacts: Vec<Contact>,
    /// Torques of each converter on the links of its impeller and turbine.
    pub converters: Vec<[Torque; 2]>,
    /// Torque of each drag on its first link.
    pub drags: Vec<Torque>,
    /// Loss of each drag from the start on.
    pub drag_losses: Vec<Energy>,
}

impl Sample {
    /// Sample of the last evaluation of a field.
    pub(crate) fn of(field: &Field, t: f64, y: &[f64]) -> Self {
        let mechanism = &field.model.mechanism;
        let of_links = |values: &[f64]| -> Vec<f64> {
            let of = |node: &Option<usize>| node.map_or(0.0, |node| dot(mechanism.speeds.row(node), values));
            mechanism.node.iter().map(of).collect()
        };
        let torques = |values: &[f64]| values.iter().map(|&value| Torque::from_si(value)).collect();
        let sets = mechanism.sets.iter().enumerate().map(|(place, set)| {
            let mut bodies: Vec<f64> = vec![0.0; set.centrals.iter().max().map_or(0, |most| most + 1)];
            let held = field.held_torque(place);
            let mut carrier = -held;
            if let Some(root) = set.centrals.first().and_then(|&body| bodies.get_mut(body)) {
                *root += held;
            }
            for mesh in set.meshes.clone() {
                let one = &mechanism.meshes[mesh];
                let first = field.meshes[mesh];
                let second = -first * one.ratio * field.pattern.part(mechanism, mesh);
                carrier -= first + second;
                for (body, on) in one.bodies.into_iter().zip([first, second]) {
                    if let Some(sum) = bodies.get_mut(body) {
                        *sum += on;
                    }
                }
            }
            let centrals = set.centrals.iter().map(|&body| bodies[body]);
            centrals.chain([carrier]).map(|on| Torque::from_si(-on)).collect()
        });
        let mesh_power = |(mesh, one): (usize, &crate::mechanism::MeshForce)| {
            Power::from_si(-field.meshes[mesh] * dot(&one.rolling, y))
        };
        let energies =
            |from: usize, to: usize| y[from..to].iter().map(|&value| Energy::from_si(value)).collect();
        let (elements, drags) = shared(field, t);
        let twists = &y[field.parts.twist..field.parts.size];
        Self {
            time: Time::from_si(t),
            speeds: of_links(y).into_iter().map(AngularVelocity::from_si).collect(),
            accelerations: of_links(&field.accelerations)
                .into_iter()
                .map(AngularAcceleration::from_si)
                .collect(),
            torques: torques(&field.applied),
            states: states(field),
            heats: energies(field.parts.heat, field.parts.heat + elements.len()),
            elements: torques(&elements),
            is_split_unique: field.system.independent.others.is_empty(),
            sets: sets.collect(),
            mesh_powers: mechanism.meshes.iter().enumerate().map(mesh_power).collect(),
            shafts: torques(&field.shafts),
            twists: twists.iter().map(|&twist| Angle::from_si(twist)).collect(),
            contacts: twists
                .iter()
                .zip(&field.pattern.flanks)
                .map(|(&twist, flank)| flank.contact(twist))
                .collect(),
            converters: field.converters.iter().map(|on| on.map(Torque::from_si)).collect(),
            drags: torques(&drags),
            drag_losses: energies(field.parts.drag, field.parts.twist),
        }
    }
}

/// Change at an event.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Change {
    /// An element does something else from now on.
    Element {
        /// Name of the element.
        name: String,
        /// State before.
        from: State,
        /// State after.
        to: State,
    },
    /// A set with losses rolls otherwise: forward where its first central gear is faster than the carrier,
    /// stuck where it is a block.
    Set {
        /// Name of the set.
        name: String,
        /// Rolling before.
        from: State,
        /// Rolling after.
        to: State,
    },
    /// The ends of a shaft with backlash come into contact, or part.
    Shaft {
        /// Name of the shaft.
        name: String,
        /// Contact before.
        from: Contact,
        /// Contact after.
        to: Contact,
    },
    /// Links that drag on each other by dry friction alone begin to turn against each other, or stop.
    Drag {
        /// Name of the drag.
        name: String,
        /// State before.
        from: State,
        /// State after.
        to: State,
    },
    /// A threshold is passed.
    Threshold {
        /// Name of the threshold.
        name: String,
        /// Whether the speed rises.
        is_rising: bool,
    },
}

/// Something that happens at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Changes, all at once.
    pub changes: Vec<Change>,
    /// Everything right before it: torques jump where elements lock, and speeds where dog clutches engage.
    pub before: Sample,
    /// Everything right after it.
    pub after: Sample,
}

/// Energies from the start to the end.
#[derive(Debug, Clone, PartialEq)]
pub struct Audit {
    /// Work of each applied torque; below 0 of a load.
    pub work: Vec<Energy>,
    /// Heat of each element, without drags.
    pub heat: Vec<Energy>,
    /// Loss of each drag.
    pub drags: Vec<Energy>,
    /// Loss of each mesh.
    pub mesh_losses: Vec<Energy>,
    /// Loss within each source, beside its work: heat of the rotor of a Kloss motor.
    pub inner_losses: Vec<Energy>,
    /// Heat of the oil of each converter.
    pub converters: Vec<Energy>,
    /// Heat of the damper of each shaft.
    pub damping: Vec<Energy>,
    /// Kinetic energy that impacts took: of dog clutches; friction elements lock without slip, and theirs is
    /// rounding.
    pub impacts: Energy,
    /// Kinetic energy at the start.
    pub before: Energy,
    /// Kinetic energy at the end.
    pub after: Energy,
    /// Elastic energy of the shafts at the start.
    pub elastic_before: Energy,
    /// Elastic energy of the shafts at the end.
    pub elastic_after: Energy,
}

impl Audit {
    /// `stored after − stored before − (work − heat − drags − mesh losses − converters − damping − impacts)`,
    /// over the largest of these energies; what is stored is kinetic and elastic.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let sum = |of: &[Energy]| of.iter().map(|one| one.si()).sum::<f64>();
        let stored = self.after.si() - self.before.si() + self.elastic_after.si() - self.elastic_before.si();
        let of_joints = sum(&self.converters) + sum(&self.damping);
        let lost = sum(&self.heat) + sum(&self.drags) + sum(&self.mesh_losses) + of_joints;
        let balance = sum(&self.work) - lost - self.impacts.si();
        let single = [&self.before, &self.after, &self.elastic_before, &self.elastic_after, &self.impacts];
        let lists = [&self.work, &self.heat, &self.drags, &self.mesh_losses, &self.converters, &self.damping];
        let all = lists.into_iter().flatten().chain(single);
        let largest = largest_absolute(all.map(|one| one.si()));
        if largest == 0.0 { 0.0 } else { (stored - balance) / largest }
    }

    pub(crate) fn of(field: &Field, y: &[f64], impacts: f64, [before, elastic_before]: [f64; 2]) -> Self {
        let parts = field.parts;
        let energies =
            |from: usize, to: usize| y[from..to].iter().map(|&value| Energy::from_si(value)).collect();
        Self {
            work: energies(parts.work, parts.heat),
            heat: energies(parts.heat, parts.heat + field.model.own_elements()),
            drags: energies(parts.drag, parts.twist),
            mesh_losses: energies(parts.loss, parts.inner),
            inner_losses: energies(parts.inner, parts.oil),
            converters: energies(parts.oil, parts.damping),
            damping: energies(parts.damping, parts.drag),
            impacts: Energy::from_si(impacts),
            before: Energy::from_si(before),
            after: Energy::from_si(field.model.mechanism.kinetic_energy(&y[..parts.work])),
            elastic_before: Energy::from_si(elastic_before),
            elastic_after: Energy::from_si(field.elastic_energy(y)),
        }
    }
}

/// A motion from start to end.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Names of the links; the first is the housing.
    pub links: Vec<String>,
    /// Names of the applied torques.
    pub torques: Vec<String>,
    /// Names of the elements.
    pub elements: Vec<String>,
    /// Names of the sets.
    pub sets: Vec<String>,
    /// Names of the shafts.
    pub shafts: Vec<String>,
    /// Names of the converters.
    pub converters: Vec<String>,
    /// Names of the drags.
    pub drags: Vec<String>,
    /// Meshes: the place of the set, and the gears at the ends. Meshes in a row over planets without inertia
    /// are one.
    pub meshes: Vec<(usize, [String; 2])>,
    /// Samples at the start, at the times requested, and at the end.
    pub samples: Vec<Sample>,
    /// Events, in order of time.
    pub events: Vec<Event>,
    /// Energies.
    pub audit: Audit,
    /// Steps that were calculated.
    pub steps: usize,
    /// Number of changes of a mode: events, reversals of mesh power, kinks of tables over speed.
    pub transitions: usize,
}

impl Run {
    /// The last sample.
    ///
    /// # Panics
    /// Never: every run has its start and end.
    #[must_use]
    pub fn end(&self) -> &Sample {
        &self.samples[self.samples.len() - 1]
    }

    /// Place of a link among the speeds of a sample.
    #[must_use]
    pub fn link(&self, name: &str) -> Option<usize> {
        self.links.iter().position(|link| link == name)
    }

    /// Place of an element.
    #[must_use]
    pub fn element(&self, name: &str) -> Option<usize> {
        self.elements.iter().position(|element| element == name)
    }

    /// Place of a shaft.
    #[must_use]
    pub fn shaft(&self, name: &str) -> Option<usize> {
        self.shafts.iter().position(|shaft| shaft == name)
    }

    /// Place of a converter.
    #[must_use]
    pub fn converter(&self, name: &str) -> Option<usize> {
        self.converters.iter().position(|converter| converter == name)
    }

    /// Place of an applied torque.
    #[must_use]
    pub fn torque(&self, name: &str) -> Option<usize> {
        self.torques.iter().position(|torque| torque == name)
    }

    /// Speed of a link at the end.
    #[must_use]
    pub fn end_speed(&self, link: &str) -> Option<AngularVelocity> {
        Some(self.end().speeds[self.link(link)?])
    }

    /// Heat of an element.
    #[must_use]
    pub fn heat(&self, element: &str) -> Option<Energy> {
        Some(self.audit.heat[self.element(element)?])
    }
}
