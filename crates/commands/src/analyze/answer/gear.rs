//! Everything about one gear.

use super::elements::{self, SlipAndTorque};
use super::planet_bearings::{self, PlanetBearing};
use super::records::{
    GearFacts, Kind, OneWayClutch, State, member_name, meshes, one_way_clutches, planet_name,
};
use super::{Input, OperatingPoint, Worked, pins, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::shared::records::Fraction;
use crate::tolerance::ROUNDED;
use epicyclic_train::power_flow::SetPower;
use epicyclic_train::{self as train, Gearbox, LoadCase, Operation, PlanetSet};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Power;

/// A gear in full.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OneGear {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Whether any of its sets loses power.
    pub has_losses: bool,
    /// Speed and load of the input that were asked for.
    pub operating_point: OperatingPoint,
    /// What the gear engages, its state, ratio and efficiencies.
    pub gear: GearFacts,
    /// Links: speed and power.
    pub links: Vec<Link>,
    /// Planets: speeds.
    pub planets: Vec<Planet>,
    /// Planet bearings, where a force or a torque of theirs follows.
    pub planet_bearings: Vec<PlanetBearing>,
    /// Shift elements: slip and torque.
    pub shift_elements: Vec<ShiftElement>,
    /// What the one-way clutches do.
    pub one_way_clutches: Vec<OneWayClutch>,
    /// Torques on the gearbox from outside; none where no torques follow.
    pub torques: Option<Torques>,
    /// Planet sets: rolling power and loss.
    pub sets: Vec<Set>,
    /// Members of the sets: torque and power.
    pub members: Vec<Member>,
    /// Meshes: power.
    pub meshes: Vec<Mesh>,
    /// Powers of the whole; none where no torques follow.
    pub powers: Option<Powers>,
    /// Self-consistent sign patterns of the losses, the chosen one first.
    pub patterns: Vec<Pattern>,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

/// A link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Link {
    /// Its name.
    pub link: String,
    /// Whether power enters here in this gear.
    pub is_input: bool,
    /// Whether power leaves here in this gear.
    pub is_output: bool,
    /// Members of sets that turn with it.
    pub members: Vec<LinkMember>,
    /// Its speed over the input's.
    pub speed_of_input: Option<f64>,
    /// Its speed.
    pub speed_rad_s: Option<f64>,
    /// Power through it over what enters.
    pub power_of_entering: Option<f64>,
    /// Power through it.
    pub power_w: Option<f64>,
}

/// A member of a set, as part of a link.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LinkMember {
    /// The set.
    pub set: String,
    /// The member: `sun`, `ring`, `carrier`; with its name where a set has several of a kind.
    pub member: String,
}

/// Planets of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Planet {
    /// The set.
    pub set: String,
    /// The planet: its name, or its number in the set.
    pub planet: String,
    /// Whether its teeth are known, without which no speed follows.
    pub has_teeth: bool,
    /// Speed relative to the carrier, over the input's speed.
    pub relative_speed_of_input: Option<f64>,
    /// Speed relative to the carrier.
    pub relative_speed_rad_s: Option<f64>,
    /// Speed over the input's.
    pub speed_of_input: Option<f64>,
    /// Speed.
    pub speed_rad_s: Option<f64>,
}

/// A shift element; torques act on its first link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// What it is.
    #[serde(flatten)]
    pub element: elements::ShiftElement,
    /// What it does in this gear.
    #[serde(flatten)]
    pub does: SlipAndTorque,
}

/// Torques on the gearbox from outside.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Torques {
    /// Without losses, over the input's.
    pub without_losses: TorquesOfInput,
    /// With losses, over the input's.
    pub with_losses: Option<TorquesOfInput>,
    /// At the load.
    pub at_load: Option<TorquesAtLoad>,
}

/// Torques over the input's.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorquesOfInput {
    /// On the input.
    pub input: f64,
    /// On the output.
    pub output: f64,
    /// From the housing.
    pub housing: f64,
}

impl TorquesOfInput {
    fn of(case: &LoadCase) -> Self {
        let of_input = |torque: f64| torque / case.input;
        let output = of_input(case.output);
        Self { input: 1.0, output, housing: rest(1.0, output) }
    }
}

/// What is left for the housing, `−T_in − T_out`; nothing where rounding alone leaves it.
fn rest(input: f64, output: f64) -> f64 {
    let rest = -input - output;
    if rest.abs() <= ROUNDED * input.abs().max(output.abs()) { 0.0 } else { rest }
}

/// Torques at a load.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorquesAtLoad {
    /// On the input.
    pub input_n_m: f64,
    /// On the output.
    pub output_n_m: f64,
    /// From the housing.
    pub housing_n_m: f64,
}

/// In which direction rolling power runs in a set with two central gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RollingPower {
    /// There is none.
    None,
    /// From the first central gear to the second.
    FirstToSecond,
    /// From the second central gear to the first.
    SecondToFirst,
}

/// A planet set. Basic ratio, efficiency and rolling power are told of sets with two central gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Its name.
    pub set: String,
    /// How it is made.
    pub kind: Kind,
    /// Basic ratio i₀: with the carrier fixed, speed of the first central gear over that of the second.
    pub basic_ratio: Option<f64>,
    /// The same, exactly, where the teeth are known.
    pub exact_ratio: Option<Fraction>,
    /// Efficiency with the carrier fixed.
    pub efficiency: Option<f64>,
    /// In which direction the rolling power runs.
    pub rolling_power_runs: Option<RollingPower>,
    /// Rolling power, seen from the carrier, over what enters; positive from the first central gear to the
    /// second.
    pub rolling_power_of_entering: Option<f64>,
    /// Loss over what enters.
    pub loss_of_entering: Option<f64>,
    /// Exponents of the efficiencies in Kreines' rule, one of a set with two central gears.
    pub kreines_exponents: Vec<i8>,
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
    /// Torque on it without losses, over the input's.
    pub ideal_torque_of_input: Option<f64>,
    /// Torque on it with losses, over the input's.
    pub torque_of_input: Option<f64>,
    /// Torque on it at the load.
    pub torque_n_m: Option<f64>,
    /// Power over what enters the gear; positive where it enters the set.
    pub power_of_entering: Option<f64>,
    /// The part of it that circulates.
    pub circulating_of_entering: Option<f64>,
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
    /// Power that enters the mesh, over what enters the gear.
    pub enters_of_entering: Option<f64>,
    /// Power that leaves the mesh, over what enters the gear.
    pub leaves_of_entering: Option<f64>,
}

/// Powers of the whole, with losses.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Powers {
    /// Where power enters.
    pub enters_at: Terminal,
    /// Over what enters there; none where no torque there moves the gear.
    pub of_entering: Option<PowersOfEntering>,
    /// At the load and speed.
    pub at_load: Option<PowersAtLoad>,
}

/// An end of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Terminal {
    /// Its input.
    Input,
    /// Its output.
    Output,
}

/// Powers over what enters.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PowersOfEntering {
    /// What leaves; none of a gear that is self-locking in this direction.
    pub leaving: Option<f64>,
    /// Of a gear that is self-locking in this direction: what must enter at the other end too.
    pub helping: Option<f64>,
    /// What the meshes take.
    pub loss: f64,
    /// What circulates.
    pub circulating: f64,
    /// Largest power of any member.
    pub largest: f64,
}

/// Powers at a load and speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PowersAtLoad {
    /// What enters.
    pub entering_w: f64,
    /// What leaves.
    pub leaving_w: f64,
    /// What the meshes take.
    pub loss_w: f64,
    /// What circulates.
    pub circulating_w: f64,
    /// Largest power of any member.
    pub largest_w: f64,
}

/// Directions of the rolling power in all sets that are consistent with the losses they bring.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Pattern {
    /// By set.
    pub sets: Vec<SetSigns>,
    /// Efficiency of the gear by this pattern.
    pub efficiency: f64,
    /// Whether it is the one that is continuous with vanishing losses, and so the answer.
    pub chosen: bool,
}

/// Directions of the rolling power in a set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetSigns {
    /// The set.
    pub set: String,
    /// Of each group of meshes that carry power together: 1 away from the first gear, -1 towards it, 0 none.
    pub signs: Vec<i8>,
}

impl Answer for OneGear {
    const NAME: &'static str = "analyze-gear";
}

/// A gear with the input as asked.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::Load`] for a load that the gear cannot take; [`Error::Gearbox`] for speeds and
/// loads that are no numbers.
pub fn answer(subject: &Subject<'_>, gear: &str, input: Input) -> Result<OneGear, Error> {
    let gearbox = &subject.gearbox;
    let worked = Worked::new(gearbox, gear, input)?;
    let scene = Scene { gearbox, worked: &worked };
    let facts = GearFacts::of(subject, &worked.analysis);
    Ok(OneGear {
        gearbox: gearbox.name().to_owned(),
        has_losses: subject.has_losses(),
        operating_point: OperatingPoint::of(input),
        links: scene.links(),
        planets: scene.planets(),
        planet_bearings: planet_bearings::of_gear(subject, &worked)?,
        shift_elements: scene.shift_elements(),
        one_way_clutches: one_way_clutches(gearbox, &worked.analysis),
        torques: scene.torques(),
        sets: scene.sets(),
        members: scene.members(),
        meshes: scene.meshes(),
        powers: scene.powers(),
        patterns: scene.patterns(),
        warnings: scene.warnings(subject, &facts),
        gear: facts,
    })
}

struct Scene<'a> {
    gearbox: &'a Gearbox,
    worked: &'a Worked<'a>,
}

impl Scene<'_> {
    fn operation(&self) -> Option<&Operation> {
        self.worked.operation.as_ref()
    }

    fn is_back_driven(&self) -> bool {
        self.worked.is_back_driven()
    }

    fn case(&self) -> Option<&LoadCase> {
        self.worked.case()
    }

    /// Powers are known when both a load and a speed are.
    fn powered(&self) -> Option<&Operation> {
        self.operation().filter(|_| self.worked.input.speed.is_some())
    }

    fn links(&self) -> Vec<Link> {
        let analysis = &self.worked.analysis;
        let gear = analysis.gear();
        let one = |link: usize| {
            let speed = analysis.speeds()[link];
            let power = self.powered().and_then(|operation| operation.links[link]);
            Link {
                link: self.gearbox.links()[link].clone(),
                is_input: gear.input().index() == link,
                is_output: gear.output().index() == link,
                members: self.members_of(link),
                speed_of_input: speed,
                speed_rad_s: self.worked.speed_rad_s(speed),
                power_of_entering: self.case().and_then(|case| case.power.links[link]),
                power_w: power.map(Physical::si),
            }
        };
        (1..self.gearbox.links().len()).map(one).collect()
    }

    fn members_of(&self, link: usize) -> Vec<LinkMember> {
        let of_set = |set: &PlanetSet| {
            let members = set.members().iter().enumerate().filter(|(_, member)| member.index() == link);
            let one = |(place, _)| LinkMember { set: set.id().to_owned(), member: member_name(set, place) };
            members.map(one).collect::<Vec<_>>()
        };
        self.gearbox.sets().iter().flat_map(of_set).collect()
    }

    fn planets(&self) -> Vec<Planet> {
        let mut all = vec![];
        for (set, motion) in self.gearbox.sets().iter().zip(self.worked.analysis.sets()) {
            for (place, planet) in motion.planets.iter().enumerate() {
                let relative = planet.map(|planet| planet.relative);
                let absolute = planet.and_then(|planet| planet.speed);
                all.push(Planet {
                    set: set.id().to_owned(),
                    planet: planet_name(set, place),
                    has_teeth: set.planet_factor(place).is_some(),
                    relative_speed_of_input: relative,
                    relative_speed_rad_s: self.worked.speed_rad_s(relative),
                    speed_of_input: absolute,
                    speed_rad_s: self.worked.speed_rad_s(absolute),
                });
            }
        }
        all
    }

    fn shift_elements(&self) -> Vec<ShiftElement> {
        let one = |(place, element): (usize, &train::ShiftElement)| ShiftElement {
            element: elements::ShiftElement::of(self.gearbox, element),
            does: SlipAndTorque::of(self.worked, place),
        };
        self.gearbox.shift_elements().iter().enumerate().map(one).collect()
    }

    fn torques(&self) -> Option<Torques> {
        let at_load = |operation: &Operation| TorquesAtLoad {
            input_n_m: operation.input.si(),
            output_n_m: operation.output.si(),
            housing_n_m: rest(operation.input.si(), operation.output.si()),
        };
        Some(Torques {
            without_losses: TorquesOfInput::of(self.worked.analysis.ideal()?),
            with_losses: self.case().map(TorquesOfInput::of),
            at_load: self.operation().map(at_load),
        })
    }

    fn sets(&self) -> Vec<Set> {
        let kreines = self.worked.analysis.kreines();
        let one = |(place, set): (usize, &PlanetSet)| {
            let power = self.case().and_then(|case| case.power.sets[place].as_ref());
            // Of a set with more than two central gears no one number says it: its members and meshes do.
            let is_short = set.short().is_some();
            let runs = match self.case().map_or(&[][..], |case| case.signs_of(self.gearbox, place)) {
                [0] => Some(RollingPower::None),
                [1] => Some(RollingPower::FirstToSecond),
                [-1] => Some(RollingPower::SecondToFirst),
                _ => None,
            };
            Set {
                set: set.id().to_owned(),
                kind: Kind::of(set),
                basic_ratio: is_short.then(|| set.basic_ratio().get()),
                exact_ratio: set.exact_ratio().filter(|_| is_short).map(Fraction::of),
                efficiency: is_short.then(|| set.efficiency()),
                rolling_power_runs: runs,
                rolling_power_of_entering: power.filter(|_| is_short).map(SetPower::rolling_power),
                loss_of_entering: power.map(|power| power.loss),
                kreines_exponents: kreines.map_or_else(Vec::new, |kreines| kreines.exponents[place].clone()),
            }
        };
        self.gearbox.sets().iter().enumerate().map(one).collect()
    }

    fn members(&self) -> Vec<Member> {
        let mut all = vec![];
        for (place, set) in self.gearbox.sets().iter().enumerate() {
            let power = self.case().and_then(|case| case.power.sets[place].as_ref());
            let at = self.operation().and_then(|at| at.members[place].as_ref());
            for (member, link) in set.members().iter().enumerate() {
                let of = |case: &LoadCase| case.members[place].as_ref().map(|torques| torques[member]);
                let circulating = |case: &LoadCase| case.power.circulating_member(place, member);
                all.push(Member {
                    set: set.id().to_owned(),
                    member: member_name(set, member),
                    link: self.gearbox.link_name(*link).to_owned(),
                    ideal_torque_of_input: self.worked.analysis.ideal().and_then(of),
                    torque_of_input: self.worked.of_input(of),
                    torque_n_m: at.map(|torques| torques[member].si()),
                    power_of_entering: power.map(|power| power.members[member]),
                    circulating_of_entering: self.case().map(circulating),
                });
            }
        }
        all
    }

    fn meshes(&self) -> Vec<Mesh> {
        let power = |set| self.case().and_then(|case| case.meshes(self.gearbox, set));
        let all = meshes(self.gearbox, power).into_iter();
        let one = |mesh: super::records::MeshFigures| Mesh {
            set: mesh.set,
            from: mesh.from,
            to: mesh.to,
            efficiency: mesh.efficiency,
            enters_of_entering: mesh.enters,
            leaves_of_entering: mesh.leaves,
        };
        all.map(one).collect()
    }

    fn powers(&self) -> Option<Powers> {
        self.worked.analysis.ideal()?;
        let of_entering = |case: &LoadCase| PowersOfEntering {
            leaving: Some(case.efficiency).filter(|leaving| *leaving > 0.0),
            helping: Some(-case.efficiency).filter(|helping| *helping >= 0.0),
            loss: 1.0 - case.efficiency,
            circulating: case.power.circulating,
            largest: case.power.largest,
        };
        let at_load = |(operation, case): (&Operation, &LoadCase)| {
            let entering: Power = operation.entering;
            // What rounding leaves of a balance is no loss.
            let is_noise = operation.loss.abs() < entering.abs() * ROUNDED;
            PowersAtLoad {
                entering_w: entering.si(),
                leaving_w: (entering * case.efficiency).si(),
                loss_w: if is_noise { 0.0 } else { operation.loss.si() },
                circulating_w: (entering * case.power.circulating).si(),
                largest_w: (entering * case.power.largest).si(),
            }
        };
        Some(Powers {
            enters_at: if self.is_back_driven() { Terminal::Output } else { Terminal::Input },
            of_entering: self.case().map(of_entering),
            at_load: self.powered().zip(self.case()).map(at_load),
        })
    }

    fn patterns(&self) -> Vec<Pattern> {
        let one = |pattern: &train::efficiency::Pattern| {
            let sets = self.gearbox.sets().iter().zip(&pattern.signs);
            let sets = sets.map(|(set, signs)| SetSigns { set: set.id().to_owned(), signs: signs.clone() });
            Pattern { sets: sets.collect(), efficiency: pattern.efficiency, chosen: pattern.chosen }
        };
        self.worked.analysis.patterns().iter().map(one).collect()
    }

    fn warnings(&self, subject: &Subject<'_>, facts: &GearFacts) -> Vec<Warning> {
        let analysis = &self.worked.analysis;
        let mut all = warnings::of_gearbox(subject);
        all.extend(warnings::drags(subject));
        all.extend(warnings::tilted(subject));
        all.extend(pins::warning(subject, &[self.worked]));
        if facts.state != State::Driven {
            all.push(Warning { name: "state", message: warnings::state_in_words(facts) });
        }
        all.extend(warnings::released(self.gearbox, &[self.worked]));
        if self.worked.input.load.is_some() && self.operation().is_none() && self.worked.released.is_empty() {
            let message = "no torques follow from the load in this state".to_owned();
            all.push(Warning { name: "no-load", message });
        }
        all.extend(warnings::contradictions(self.gearbox, &[analysis]));
        if let Some(kreines) = analysis.kreines().filter(|kreines| !kreines.reversed.is_empty()) {
            let sets = kreines.reversed.join(", ");
            let message = format!(
                "Kreines' rule as printed does not hold: the losses reverse the power in these sets: {sets}"
            );
            all.push(Warning { name: "kreines", message });
        }
        all.extend(warnings::self_locking(&[analysis]));
        all
    }
}
