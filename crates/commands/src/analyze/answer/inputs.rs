//! Gears with several inputs: speeds and torques of several links, at one point or over a [`map`] of two
//! speeds.

pub mod map;

use super::records::{ShiftElementKind, links_of, member_name, meshes, planet_name};
use super::{analysis, engaged, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
pub use crate::refusal::Given;
use crate::shared::fault::Fault as _;
use crate::shared::gearbox::Subject;
use crate::tolerance::ROUNDED;
use epicyclic_formats::gearbox::gear_place;
use epicyclic_train::inputs::{MultiLoad, MultiState, Terminal as End};
use epicyclic_train::{self as train, Gear, Gearbox, InputsFault, LinkId};
use epicyclic_units::{Physical, Quantity};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use uom::si::f64::{AngularVelocity, Torque};

/// What several links of a gear do.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wanted {
    /// Speeds by link; without any, those that the file states of the gear.
    pub speeds: Option<Vec<(String, AngularVelocity)>>,
    /// Torques by link; without any, and without speeds, those that the file states of the gear.
    pub torques: Option<Vec<(String, Torque)>>,
}

/// A gear with several inputs at given speeds, and at torques where they are given.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Inputs {
    /// Name of the gearbox.
    pub gearbox: String,
    /// The gear.
    pub gear: InputsGear,
    /// Links: speed and power.
    pub links: Vec<Link>,
    /// Planets: speeds.
    pub planets: Vec<Planet>,
    /// Shift elements: slip and torque.
    pub shift_elements: Vec<ShiftElement>,
    /// Where power enters and leaves; none without torques.
    pub terminals: Vec<Terminal>,
    /// Torque from the housing; none without torques.
    pub housing_torque_n_m: Option<f64>,
    /// Members of the sets: torque and power.
    pub members: Vec<Member>,
    /// Meshes: power.
    pub meshes: Vec<Mesh>,
    /// Powers of the whole; none without torques.
    pub powers: Option<Powers>,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

/// A gear that keeps freedoms.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct InputsGear {
    /// Its name.
    pub gear: String,
    /// Shift elements engaged.
    pub engaged: Vec<String>,
    /// Link of the gear's input.
    pub input: String,
    /// Link of the gear's output.
    pub output: String,
    /// How many speeds settle all others.
    pub freedoms: usize,
}

/// A link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Link {
    /// Its name.
    pub link: String,
    /// Its speed.
    pub speed_rad_s: Option<f64>,
    /// Whether its speed is given.
    pub given: bool,
    /// Power through it.
    pub power_w: Option<f64>,
}

/// Planets of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Planet {
    /// The set.
    pub set: String,
    /// The planet: its name, or its number in the set.
    pub planet: String,
    /// Speed relative to the carrier.
    pub relative_speed_rad_s: Option<f64>,
    /// Speed.
    pub speed_rad_s: Option<f64>,
}

/// A shift element.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Its name.
    pub shift_element: String,
    /// What it is.
    pub kind: ShiftElementKind,
    /// The two links that it joins; `ground` is the housing.
    pub links: [String; 2],
    /// Whether it is engaged.
    pub engaged: bool,
    /// Slip: speed of the first link less that of the second.
    pub slip_rad_s: Option<f64>,
    /// Torque on the first link.
    pub torque_n_m: Option<f64>,
}

/// A link where power enters or leaves.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Terminal {
    /// The link.
    pub link: String,
    /// Torque on it from outside.
    pub torque_n_m: f64,
    /// Power that enters there; negative where it leaves.
    pub power_w: f64,
}

/// A member of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Member {
    /// The set.
    pub set: String,
    /// The member: `sun`, `ring`, `carrier`; with its name where a set has several of a kind.
    pub member: String,
    /// The link that it is part of.
    pub link: String,
    /// Torque on it.
    pub torque_n_m: f64,
    /// Power, positive where it enters the set.
    pub power_w: Option<f64>,
}

/// A mesh, in the direction of its power as seen from the carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Mesh {
    /// The set.
    pub set: String,
    /// The gear that drives.
    pub from: String,
    /// The gear that is driven.
    pub to: String,
    /// Efficiency of the mesh.
    pub efficiency: f64,
    /// Power that enters the mesh.
    pub enters_w: Option<f64>,
    /// Power that leaves the mesh.
    pub leaves_w: Option<f64>,
}

/// Powers of the whole, with losses.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Powers {
    /// What enters.
    pub entering_w: f64,
    /// What leaves.
    pub leaving_w: f64,
    /// What the meshes take.
    pub loss_w: f64,
    /// What circulates.
    pub circulating_w: f64,
    /// What leaves over what enters.
    pub efficiency: Option<f64>,
}

impl Answer for Inputs {
    const NAME: &'static str = "analyze-inputs";
}

/// A gear with several inputs at one point.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::NoLink`] and [`Error::Inputs`] for given speeds and torques,
/// [`Error::Document`] with the place for those of the file.
pub fn answer(subject: &Subject<'_>, gear: &str, wanted: &Wanted) -> Result<Inputs, Error> {
    let task = Task::new(subject, gear)?;
    let speeds = match (&wanted.speeds, subject.inputs(gear)) {
        (Some(given), _) => task.links(Origin::Question(Given::Speeds), given)?,
        (None, Some(inputs)) => task.links(Origin::File(Given::Speeds), &stated(&inputs.speeds))?,
        (None, None) => vec![],
    };
    let torques = task.torques(wanted.torques.as_deref(), wanted.speeds.is_none())?;
    let at =
        if wanted.speeds.is_some() { Origin::Question(Given::Speeds) } else { Origin::File(Given::Speeds) };
    let state = task.state(&speeds, &torques, at, wanted.torques.is_some())?;
    Ok(task.inputs(&speeds, &state))
}

/// Where values come from.
#[derive(Clone, Copy)]
enum Origin {
    Question(Given),
    /// The gear in the file, under the key of these.
    File(Given),
}

fn stated<T: Physical>(values: &BTreeMap<String, Quantity<T>>) -> Vec<(String, T)> {
    values.iter().map(|(link, value)| (link.clone(), value.0)).collect()
}

struct Task<'a> {
    subject: &'a Subject<'a>,
    gearbox: &'a Gearbox,
    gear: Gear,
}

impl<'a> Task<'a> {
    fn new(subject: &'a Subject<'a>, gear: &str) -> Result<Self, Error> {
        let gearbox = &subject.gearbox;
        Ok(Self { subject, gearbox, gear: analysis(gearbox, gear)?.gear().clone() })
    }

    /// A fault of the question as it is, one of the file with its place there.
    fn refuse(&self, at: Origin, fault: impl FnOnce(Given) -> Error) -> Error {
        match at {
            Origin::Question(given) => fault(given),
            Origin::File(given) => {
                let key = if given == Given::Torques { "torques" } else { "speeds" };
                let Subject { document, base, .. } = self.subject;
                let place = gear_place(document, base, self.gear.name(), key);
                document.error(&place, fault(given).problem()).into()
            }
        }
    }

    fn link(&self, name: &str, at: Origin) -> Result<LinkId, Error> {
        self.gearbox.link(name).ok_or_else(|| {
            let fault = |given| Error::NoLink {
                given,
                name: name.to_owned(),
                links: self.gearbox.links()[1..].to_vec(),
            };
            self.refuse(at, fault)
        })
    }

    fn links<T: Copy>(&self, at: Origin, values: &[(String, T)]) -> Result<Vec<(LinkId, T)>, Error> {
        values.iter().map(|(name, value)| Ok((self.link(name, at)?, *value))).collect()
    }

    /// The torques given, else those of the file where its speeds or a map are asked for: other speeds ask
    /// another question.
    fn torques(
        &self,
        given: Option<&[(String, Torque)]>,
        or_of_file: bool,
    ) -> Result<Vec<(LinkId, Torque)>, Error> {
        match (given, self.subject.inputs(self.gear.name())) {
            (Some(given), _) => self.links(Origin::Question(Given::Torques), given),
            (None, Some(inputs)) if or_of_file => {
                self.links(Origin::File(Given::Torques), &stated(&inputs.torques))
            }
            _ => Ok(vec![]),
        }
    }

    fn state(
        &self,
        speeds: &[(LinkId, AngularVelocity)],
        torques: &[(LinkId, Torque)],
        at: Origin,
        own_torques: bool,
    ) -> Result<MultiState, Error> {
        self.gearbox.with_inputs(&self.gear, speeds, torques).map_err(|error| match error {
            train::Error::Inputs(fault) => {
                let at = match fault {
                    InputsFault::Torques { .. } | InputsFault::DependentTorques { .. } if own_torques => {
                        Origin::Question(Given::Torques)
                    }
                    InputsFault::Torques { .. } | InputsFault::DependentTorques { .. } => {
                        Origin::File(Given::Torques)
                    }
                    _ => at,
                };
                self.refuse(at, |given| Error::Inputs { given, fault })
            }
            error => error.into(),
        })
    }

    fn inputs(&self, speeds: &[(LinkId, AngularVelocity)], state: &MultiState) -> Inputs {
        let load = state.load.as_ref();
        let mut all = warnings::of_gearbox(self.subject);
        all.extend(self.one_way(state));
        Inputs {
            gearbox: self.gearbox.name().to_owned(),
            gear: InputsGear {
                gear: self.gear.name().to_owned(),
                engaged: engaged(self.gearbox, &self.gear),
                input: self.gearbox.link_name(self.gear.input()).to_owned(),
                output: self.gearbox.link_name(self.gear.output()).to_owned(),
                freedoms: state.freedoms,
            },
            links: self.links_at(speeds, state),
            planets: self.planets(state),
            shift_elements: self.shift_elements(state),
            terminals: load.map_or_else(Vec::new, |load| self.terminals(load)),
            housing_torque_n_m: load.map(|load| load.housing.si()),
            members: load.map_or_else(Vec::new, |load| self.members(load)),
            meshes: load.map_or_else(Vec::new, |load| self.meshes(load)),
            powers: load.map(powers),
            warnings: all,
        }
    }

    fn links_at(&self, speeds: &[(LinkId, AngularVelocity)], state: &MultiState) -> Vec<Link> {
        let one = |place: usize| Link {
            link: self.gearbox.links()[place].clone(),
            speed_rad_s: state.speeds[place].map(Physical::si),
            given: speeds.iter().any(|(link, _)| link.index() == place),
            power_w: state.load.as_ref().and_then(|load| load.power.links[place]),
        };
        (1..self.gearbox.links().len()).map(one).collect()
    }

    fn planets(&self, state: &MultiState) -> Vec<Planet> {
        let mut all = vec![];
        for (set, motion) in self.gearbox.sets().iter().zip(&state.sets) {
            for (place, planet) in motion.planets.iter().enumerate() {
                all.push(Planet {
                    set: set.id().to_owned(),
                    planet: planet_name(set, place),
                    relative_speed_rad_s: planet.map(|planet| planet.relative),
                    speed_rad_s: planet.and_then(|planet| planet.speed),
                });
            }
        }
        all
    }

    fn shift_elements(&self, state: &MultiState) -> Vec<ShiftElement> {
        let one = |(place, element): (usize, &train::ShiftElement)| {
            let torque = state.load.as_ref().and_then(|load| load.shift_elements[place]);
            ShiftElement {
                shift_element: element.id().to_owned(),
                kind: ShiftElementKind::of(element),
                links: links_of(self.gearbox, element),
                engaged: self.gear.engaged().contains(&place),
                slip_rad_s: state.slips[place].map(Physical::si),
                torque_n_m: torque.map(Physical::si),
            }
        };
        self.gearbox.shift_elements().iter().enumerate().map(one).collect()
    }

    fn terminals(&self, load: &MultiLoad) -> Vec<Terminal> {
        let one = |end: &End| Terminal {
            link: self.gearbox.link_name(end.link).to_owned(),
            torque_n_m: end.torque.si(),
            power_w: end.power.si(),
        };
        load.terminals.iter().map(one).collect()
    }

    fn members(&self, load: &MultiLoad) -> Vec<Member> {
        let mut all = vec![];
        for (place, set) in self.gearbox.sets().iter().enumerate() {
            let power = load.power.sets[place].as_ref();
            for (member, link) in set.members().iter().enumerate() {
                all.push(Member {
                    set: set.id().to_owned(),
                    member: member_name(set, member),
                    link: self.gearbox.link_name(*link).to_owned(),
                    torque_n_m: load.members[place][member],
                    power_w: power.map(|power| power.members[member]),
                });
            }
        }
        all
    }

    fn meshes(&self, load: &MultiLoad) -> Vec<Mesh> {
        let all = meshes(self.gearbox, |set| load.meshes(self.gearbox, set)).into_iter();
        let one = |mesh: super::records::MeshFigures| Mesh {
            set: mesh.set,
            from: mesh.from,
            to: mesh.to,
            efficiency: mesh.efficiency,
            enters_w: mesh.enters,
            leaves_w: mesh.leaves,
        };
        all.map(one).collect()
    }

    /// One-way clutches that would not let these speeds or torques be.
    fn one_way(&self, state: &MultiState) -> Vec<Warning> {
        let load = state.load.as_ref();
        let torques =
            load.into_iter().flat_map(|load| load.terminals.iter().map(|end| end.torque.si().abs()));
        let nothing_n_m = ROUNDED * torques.fold(0.0, f64::max);
        let of = |(place, element): (usize, &train::ShiftElement)| {
            let is_engaged = self.gear.engaged().contains(&place);
            let torque = load.and_then(|load| load.shift_elements[place]).map(Physical::si);
            let clutch = element.id();
            let message = if is_engaged {
                (torque? < -nothing_n_m).then(|| {
                    format!("the one-way clutch {clutch} would overrun at these torques: the one on its first link is reversed")
                })
            } else {
                (state.slips[place]?.si() < 0.0).then(|| {
                    format!(
                        "the one-way clutch {clutch} would hold at these speeds: its first link turns slower than its second"
                    )
                })
            };
            message.map(|message| Warning { name: "one-way-clutch", message })
        };
        let clutches = self.gearbox.shift_elements().iter().enumerate();
        clutches.filter(|(_, element)| element.is_one_way()).filter_map(of).collect()
    }
}

fn powers(load: &MultiLoad) -> Powers {
    let sum = |is_positive: bool| -> f64 {
        let powers = load.terminals.iter().map(|end| end.power.si());
        powers.filter(|power| (*power > 0.0) == is_positive).map(f64::abs).sum()
    };
    Powers {
        entering_w: sum(true),
        leaving_w: sum(false),
        loss_w: load.loss.si(),
        circulating_w: load.power.circulating,
        efficiency: load.efficiency,
    }
}
