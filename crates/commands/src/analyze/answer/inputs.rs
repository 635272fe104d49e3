//! Gears with several inputs: speeds and torques of several links, at one point or over a [`map`] of two
//! speeds.

pub mod map;

use super::records::{ShiftElementKind, links_of, member_name, meshes, planet_name};
use super::{analysis, engaged, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
pub use crate::refusal::Given;
use crate::shared::fault::Fault as _;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::tolerance::ROUNDED;
use epicyclic_formats::gearbox::gear_place;
use epicyclic_train::inputs::{MultiLoad, MultiState, Terminal as End};
use epicyclic_train::{self as train, Gear, InputsFault, LinkId};
use epicyclic_units::{Physical, Quantity};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use uom::si::f64::{AngularVelocity, Torque};

/// Given speeds and torques of several links of a gear.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wanted {
    /// Speeds by link; if `None`, those that the file gives for the gear.
    pub speeds: Option<Vec<(String, AngularVelocity)>>,
    /// Torques by link; if `None` and no speeds are given, those that the file gives for the gear.
    pub torques: Option<Vec<(String, Torque)>>,
}

/// Gear with several inputs at given speeds and, if given, torques.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Inputs {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Gear that keeps several degrees of freedom.
    pub gear: InputsGear,
    /// Links with their speeds and powers.
    pub links: Vec<Link>,
    /// Planets with their speeds.
    pub planets: Vec<Planet>,
    /// Shift elements with their slips and torques.
    pub shift_elements: Vec<ShiftElement>,
    /// Links where power enters or leaves; empty without torques.
    pub terminals: Vec<Terminal>,
    /// Torque from the housing in N·m; null without torques.
    pub housing_torque_n_m: Option<f64>,
    /// Members of the sets with torque and power; empty without torques.
    pub members: Vec<Member>,
    /// Meshes with their powers; empty without torques.
    pub meshes: Vec<Mesh>,
    /// Powers of the whole gearbox; null without torques.
    pub powers: Option<Powers>,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the gear.
    pub warnings: Vec<Warning>,
}

/// Gear that keeps several degrees of freedom.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct InputsGear {
    /// Name of the gear.
    pub gear: String,
    /// Names of the engaged shift elements.
    pub engaged: Vec<String>,
    /// Link at the input of the gear.
    pub input: String,
    /// Link at the output of the gear.
    pub output: String,
    /// Number of degrees of freedom: the speeds that determine all others.
    pub freedoms: usize,
}

/// Link with its speed and power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Link {
    /// Name of the link.
    pub link: String,
    /// Speed of the link in rad/s; null if it does not follow from the given speeds.
    pub speed_rad_s: Option<f64>,
    /// Whether the speed of the link is given.
    pub given: bool,
    /// Power through the link in W; null if it cannot be computed.
    pub power_w: Option<f64>,
}

/// Planets of one kind with their speeds.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Planet {
    /// Name of the set.
    pub set: String,
    /// Name of the planet, or its number in the set.
    pub planet: String,
    /// Planet speed relative to the carrier in rad/s; null if unknown.
    pub relative_speed_rad_s: Option<f64>,
    /// Planet speed in rad/s; null if unknown.
    pub speed_rad_s: Option<f64>,
}

/// Shift element with its slip and torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Name of the shift element.
    pub shift_element: String,
    /// Kind of the shift element: brake or clutch, one-way or not.
    pub kind: ShiftElementKind,
    /// The two links that it joins; `ground` is the housing.
    pub links: [String; 2],
    /// Whether the gear engages the shift element.
    pub engaged: bool,
    /// Slip in rad/s: speed of the first link minus speed of the second; null if unknown.
    pub slip_rad_s: Option<f64>,
    /// Torque on the first link in N·m; null if it cannot be computed.
    pub torque_n_m: Option<f64>,
}

/// Link where power enters or leaves.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Terminal {
    /// Name of the link.
    pub link: String,
    /// Torque on the link from outside in N·m.
    pub torque_n_m: f64,
    /// Power that enters at the link in W; negative if it leaves.
    pub power_w: f64,
}

/// Member of a set with its torque and power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Member {
    /// Name of the set.
    pub set: String,
    /// Name of the member: `sun`, `ring`, `carrier`; followed by its own name if the set has several of a
    /// kind.
    pub member: String,
    /// Link to which the member belongs.
    pub link: String,
    /// Torque on the member in N·m.
    pub torque_n_m: f64,
    /// Power of the member in W, positive into the set; null if it cannot be computed.
    pub power_w: Option<f64>,
}

/// Mesh in the direction of its power relative to the carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Mesh {
    /// Name of the set.
    pub set: String,
    /// Name of the driving gear.
    pub from: String,
    /// Name of the driven gear.
    pub to: String,
    /// Efficiency of the mesh.
    pub efficiency: f64,
    /// Power into the mesh in W; null if it cannot be computed.
    pub enters_w: Option<f64>,
    /// Power out of the mesh in W; null if it cannot be computed.
    pub leaves_w: Option<f64>,
}

/// Powers of the whole gearbox, with losses.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Powers {
    /// Entering power in W, over all links.
    pub entering_w: f64,
    /// Leaving power in W, over all links.
    pub leaving_w: f64,
    /// Power lost in the meshes, in W.
    pub loss_w: f64,
    /// Circulating power in W.
    pub circulating_w: f64,
    /// Efficiency: leaving power over entering power; null if it is not defined.
    pub efficiency: Option<f64>,
}

impl Answer for Inputs {
    const NAME: &'static str = "analyze-inputs";
}

/// Analyzes a gear with several inputs at one point.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::NoLink`] and [`Error::Inputs`] for given speeds and torques;
/// [`Error::Document`] with the place for speeds and torques of the file.
pub fn answer(subject: &Gearbox, gear: &str, wanted: &Wanted) -> Result<Inputs, Error> {
    let task = Task::new(subject, gear)?;
    let speeds = match (&wanted.speeds, subject.inputs(gear)) {
        (Some(given), _) => task.links(Origin::Question(Given::Speeds), given)?,
        (None, Some(inputs)) => task.links(Origin::File(Given::Speeds), &stated(&inputs.speeds))?,
        (None, None) => vec![],
    };
    // The file gives its torques for its own speeds, so they are only used together.
    let torques = task.torques(wanted.torques.as_deref(), wanted.speeds.is_none())?;
    let at =
        if wanted.speeds.is_some() { Origin::Question(Given::Speeds) } else { Origin::File(Given::Speeds) };
    let state = task.state(&speeds, &torques, at, wanted.torques.is_some())?;
    Ok(task.inputs(&speeds, &state))
}

/// Origin of values: the question or the file.
#[derive(Clone, Copy)]
enum Origin {
    Question(Given),
    /// The gear in the file, under the key for these values.
    File(Given),
}

fn stated<T: Physical>(values: &BTreeMap<String, Quantity<T>>) -> Vec<(String, T)> {
    values.iter().map(|(link, value)| (link.clone(), value.0)).collect()
}

#[derive(Debug)]
struct Task<'a> {
    subject: &'a Gearbox,
    gearbox: &'a train::Gearbox,
    gear: Gear,
}

impl<'a> Task<'a> {
    fn new(subject: &'a Gearbox, gear: &str) -> Result<Self, Error> {
        let gearbox = &subject.train;
        Ok(Self { subject, gearbox, gear: analysis(gearbox, gear)?.gear().clone() })
    }

    /// Error for a fault: as it is for given values, with its place for values of the file.
    fn refuse(&self, at: Origin, fault: impl FnOnce(Given) -> Error) -> Error {
        match at {
            Origin::Question(given) => fault(given),
            Origin::File(given) => {
                let key = if given == Given::Torques { "torques" } else { "speeds" };
                let Gearbox { document, base, .. } = self.subject;
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

    /// Torques that were given, otherwise those of the file. The file's torques belong to the file's speeds
    /// or to a map; at other given speeds they do not apply.
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
            judgement: Judgement::default(),
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

    /// Warnings about one-way clutches that contradict these speeds or torques.
    fn one_way(&self, state: &MultiState) -> Vec<Warning> {
        let load = state.load.as_ref();
        let torques =
            load.into_iter().flat_map(|load| load.terminals.iter().map(|end| end.torque.si().abs()));
        // The limit scales with the load, because the clutch torque is a difference of larger torques.
        let nothing_n_m = ROUNDED * torques.fold(0.0, f64::max);
        let of = |(place, element): (usize, &train::ShiftElement)| {
            let is_engaged = self.gear.engaged().contains(&place);
            let torque = load.and_then(|load| load.shift_elements[place]).map(Physical::si);
            let clutch = element.id();
            let message = if is_engaged {
                // By convention a one-way clutch transmits only positive torque on its first link.
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
