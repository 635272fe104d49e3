//! Full analysis of one gear.

use super::elements::{self, SlipAndTorque};
use super::planet_bearings::{self, PlanetBearing};
use super::records::{
    GearFacts, Kind, OneWayClutch, State, member_name, meshes, one_way_clutches, planet_name,
};
use super::{Input, OperatingPoint, Worked, pins, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::records::Fraction;
use crate::tolerance::ROUNDED;
use epicyclic_train::error::Terminal;
use epicyclic_train::power_flow::SetPower;
use epicyclic_train::{self as train, LoadCase, Operation, PlanetSet};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Power;

/// Full analysis of one gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OneGear {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Whether any set of the gearbox loses power.
    pub has_losses: bool,
    /// Speed and load of the input that were asked for.
    pub operating_point: OperatingPoint,
    /// Engaged elements, state, ratio and efficiencies of the gear.
    pub gear: GearFacts,
    /// Links with their speeds and powers.
    pub links: Vec<Link>,
    /// Planets with their speeds.
    pub planets: Vec<Planet>,
    /// Forces on the planet bearings; empty unless the size of a set is known or torques can be computed.
    pub planet_bearings: Vec<PlanetBearing>,
    /// Shift elements with their slips and torques.
    pub shift_elements: Vec<ShiftElement>,
    /// Behaviour of the one-way clutches in this gear.
    pub one_way_clutches: Vec<OneWayClutch>,
    /// Torques on the gearbox from outside; null if no torques can be computed.
    pub torques: Option<Torques>,
    /// Planetary sets with rolling power and loss.
    pub sets: Vec<Set>,
    /// Members of the sets with torque and power.
    pub members: Vec<Member>,
    /// Meshes with their powers.
    pub meshes: Vec<Mesh>,
    /// Powers of the whole gearbox; null if no torques can be computed.
    pub powers: Option<Powers>,
    /// Self-consistent sign patterns of the losses, the chosen one first.
    pub patterns: Vec<Pattern>,
    /// Judgement of the gearbox by rules of practice; empty in a report.
    pub judgement: Judgement,
    /// Warnings about the gear.
    pub warnings: Vec<Warning>,
}

/// Link with its speed and power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Link {
    /// Name of the link.
    pub link: String,
    /// Whether power enters at this link in this gear.
    pub is_input: bool,
    /// Whether power leaves at this link in this gear.
    pub is_output: bool,
    /// Members of sets that turn with this link.
    pub members: Vec<LinkMember>,
    /// Speed of the link relative to the input speed; null if unknown.
    pub speed_of_input: Option<f64>,
    /// Speed of the link in rad/s; null if unknown or no input speed is given.
    pub speed_rad_s: Option<f64>,
    /// Power through the link relative to the entering power; null if it cannot be computed.
    pub power_of_entering: Option<f64>,
    /// Power through the link in W; null unless speed and load are given and it can be computed.
    pub power_w: Option<f64>,
}

/// Member of a set, as part of a link.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LinkMember {
    /// Name of the set.
    pub set: String,
    /// Name of the member: `sun`, `ring`, `carrier`; followed by its own name if the set has several of a
    /// kind.
    pub member: String,
}

/// Planets of one kind with their speeds.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Planet {
    /// Name of the set.
    pub set: String,
    /// Name of the planet, or its number in the set.
    pub planet: String,
    /// Whether the tooth number of the planet is known; without it, its speeds cannot be computed.
    pub has_teeth: bool,
    /// Planet speed relative to the carrier, relative to the input speed; null if unknown.
    pub relative_speed_of_input: Option<f64>,
    /// Planet speed relative to the carrier in rad/s; null if unknown or no input speed is given.
    pub relative_speed_rad_s: Option<f64>,
    /// Planet speed relative to the input speed; null if unknown.
    pub speed_of_input: Option<f64>,
    /// Planet speed in rad/s; null if unknown or no input speed is given.
    pub speed_rad_s: Option<f64>,
}

/// Shift element in this gear; torques act on its first link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Name, kind and links of the shift element.
    #[serde(flatten)]
    pub element: elements::ShiftElement,
    /// Slip and torque of the shift element in this gear.
    #[serde(flatten)]
    pub does: SlipAndTorque,
}

/// Torques on the gearbox from outside.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Torques {
    /// Torques without losses, relative to the input torque.
    pub without_losses: TorquesOfInput,
    /// Torques with losses, relative to the input torque; null if they cannot be computed.
    pub with_losses: Option<TorquesOfInput>,
    /// Torques at the given load; null without a load or if the gear cannot carry it.
    pub at_load: Option<TorquesAtLoad>,
}

/// Torques relative to the input torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorquesOfInput {
    /// Torque on the input relative to the input torque: 1.
    pub input: f64,
    /// Torque on the output relative to the input torque.
    pub output: f64,
    /// Torque from the housing relative to the input torque, `−T_in − T_out`.
    pub housing: f64,
}

impl TorquesOfInput {
    fn of(case: &LoadCase) -> Self {
        let of_input = |torque: f64| torque / case.input;
        let output = of_input(case.output);
        Self { input: 1.0, output, housing: rest(1.0, output) }
    }
}

/// Torque of the housing, `−T_in − T_out`; 0 if only rounding leaves a difference.
fn rest(input: f64, output: f64) -> f64 {
    let rest = -input - output;
    if rest.abs() <= ROUNDED * input.abs().max(output.abs()) { 0.0 } else { rest }
}

/// Torques on the gearbox at a load.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorquesAtLoad {
    /// Torque on the input in N·m.
    pub input_n_m: f64,
    /// Torque on the output in N·m.
    pub output_n_m: f64,
    /// Torque from the housing in N·m, `−T_in − T_out`.
    pub housing_n_m: f64,
}

/// Direction of the rolling power in a set with two central gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RollingPower {
    /// No rolling power.
    None,
    /// From the first central gear to the second.
    FirstToSecond,
    /// From the second central gear to the first.
    SecondToFirst,
}

/// Planetary set. Only a set with two central gears has a basic ratio, an efficiency and one rolling power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Name of the set.
    pub set: String,
    /// Kind of the set.
    pub kind: Kind,
    /// Basic ratio i₀: with the carrier fixed, speed of the first central gear over that of the second. Null
    /// for more than two central gears.
    pub basic_ratio: Option<f64>,
    /// Exact basic ratio as a fraction; null unless the tooth numbers are known.
    pub exact_ratio: Option<Fraction>,
    /// Efficiency with the carrier fixed; null for more than two central gears.
    pub efficiency: Option<f64>,
    /// Direction of the rolling power; null if it cannot be computed or the set has more than two central
    /// gears.
    pub rolling_power_runs: Option<RollingPower>,
    /// Rolling power (power relative to the carrier) over the entering power, positive from the first central
    /// gear to the second. Null for more than two central gears.
    pub rolling_power_of_entering: Option<f64>,
    /// Loss of the set relative to the entering power; null if it cannot be computed.
    pub loss_of_entering: Option<f64>,
    /// Exponents of the efficiencies in Kreines' rule; one for a set with two central gears.
    pub kreines_exponents: Vec<i8>,
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
    /// Torque on the member without losses, relative to the input torque; null if it cannot be computed.
    pub ideal_torque_of_input: Option<f64>,
    /// Torque on the member with losses, relative to the input torque; null if it cannot be computed.
    pub torque_of_input: Option<f64>,
    /// Torque on the member at the given load, in N·m; null without a load or if it cannot be computed.
    pub torque_n_m: Option<f64>,
    /// Power of the member relative to the entering power, positive into the set; null if it cannot be
    /// computed.
    pub power_of_entering: Option<f64>,
    /// Circulating part of this power, relative to the entering power; null if it cannot be computed.
    pub circulating_of_entering: Option<f64>,
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
    /// Power into the mesh relative to the power that enters the gearbox; null if it cannot be computed.
    pub enters_of_entering: Option<f64>,
    /// Power out of the mesh relative to the power that enters the gearbox; null if it cannot be computed.
    pub leaves_of_entering: Option<f64>,
}

/// Powers of the whole gearbox, with losses.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Powers {
    /// End at which power enters.
    pub enters_at: Terminal,
    /// Powers relative to the entering power; null if no torque at that end moves the gear.
    pub of_entering: Option<PowersOfEntering>,
    /// Powers at the given speed and load; null unless both are given.
    pub at_load: Option<PowersAtLoad>,
}

/// Powers relative to the entering power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PowersOfEntering {
    /// Power that leaves; null if the gear is self-locking in this direction.
    pub leaving: Option<f64>,
    /// Power that must enter at the other end too, if the gear is self-locking in this direction; otherwise
    /// null.
    pub helping: Option<f64>,
    /// Power lost in the meshes.
    pub loss: f64,
    /// Circulating power.
    pub circulating: f64,
    /// Largest power of any member.
    pub largest: f64,
}

/// Powers at a given load and speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PowersAtLoad {
    /// Entering power in W.
    pub entering_w: f64,
    /// Leaving power in W.
    pub leaving_w: f64,
    /// Power lost in the meshes, in W.
    pub loss_w: f64,
    /// Circulating power in W.
    pub circulating_w: f64,
    /// Largest power of any member, in W.
    pub largest_w: f64,
}

/// Directions of the rolling power in all sets that are consistent with the losses they cause.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Pattern {
    /// Signs by set.
    pub sets: Vec<SetSigns>,
    /// Efficiency of the gear with this pattern.
    pub efficiency: f64,
    /// Whether this pattern is the result: the one that is continuous with vanishing losses.
    pub chosen: bool,
}

/// Directions of the rolling power in a set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetSigns {
    /// Name of the set.
    pub set: String,
    /// Sign of each group of meshes that carry power together: 1 away from the first gear, −1 towards it, 0
    /// none.
    pub signs: Vec<i8>,
}

impl Answer for OneGear {
    const NAME: &'static str = "analyze-gear";
}

/// Analyzes a gear at the given speed and load of the input.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::Load`] for a load that the gear cannot carry; [`Error::Gearbox`] for speeds
/// and loads that are not finite.
pub fn answer(subject: &Gearbox, gear: &str, input: Input) -> Result<OneGear, Error> {
    let gearbox = &subject.train;
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
        judgement: Judgement::default(),
        warnings: scene.warnings(subject, &facts),
        gear: facts,
    })
}

struct Scene<'a> {
    gearbox: &'a train::Gearbox,
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

    /// Operating point if both load and speed are given, so that powers are known.
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
            // With more than two central gears no single number describes the set; its members and meshes do.
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
            // A balance that differs from zero only by rounding is not a loss.
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

    fn warnings(&self, subject: &Gearbox, facts: &GearFacts) -> Vec<Warning> {
        let analysis = &self.worked.analysis;
        let mut all = warnings::of_gearbox(subject);
        all.extend(warnings::drags(subject));
        all.extend(warnings::tilted(subject, self.worked.operation.is_some()));
        all.extend(warnings::stepped(subject, self.worked.operation.is_some()));
        all.extend(pins::warning(subject, &[self.worked], &[]));
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
