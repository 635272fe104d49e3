//! Calculations of the motion of a gearbox: accelerations at the start, exact events, energies.

use super::{Calculation, Refusal, Results};
use epicyclic_dynamics::gearbox::{Masses, PlanetMass, PlanetMasses};
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::scenario::{
    CapacityEntry, HarmonicEntry, PlanetsEntry, TableFault, Texts, ThresholdEntry, TorqueEntry,
};
use epicyclic_motion::{Change, Course, Mechanism, Model, Run, Sample, Start, State, TorqueLaw};
use epicyclic_units::{Number, Physical, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use uom::si::f64::{Angle, AngularVelocity, Energy, MomentOfInertia, Time, Torque};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![Calculation::new(
        "motion.run",
        "motion of a gearbox or of shafts: inertias, accelerations, events, speeds at the end, energies",
        run,
    )]
}

/// Friction between two links, or a link and the housing; its capacity in one of three ways.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct FrictionGiven {
    /// Name; a shift element has its name in the gearbox.
    id: String,
    /// The two links that it joins. Default: the links of the shift element of that name.
    #[serde(default)]
    links: Option<[String; 2]>,
    /// Constant capacity.
    #[serde(default)]
    holding: Option<Quantity<Torque>>,
    /// Capacity over time.
    #[serde(default)]
    capacity: Option<CapacityEntry>,
    /// Capacity as a harmonic of time, 0 where the harmonic is negative.
    #[serde(default)]
    harmonic: Option<HarmonicEntry>,
    /// Static over kinetic friction, at least 1. Default 1.
    #[serde(default)]
    static_ratio: Option<Number>,
}

/// A mechanism with its masses, torques, friction and duration.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RunGiven {
    /// The gearbox, with the keys of a gearbox file. Default: bodies alone.
    #[serde(default)]
    gearbox: Option<GearboxFile>,
    /// Inertia of each link of the gearbox, without planets.
    #[serde(default)]
    inertias: BTreeMap<String, Quantity<MomentOfInertia>>,
    /// Bodies beside the gearbox, and their inertias.
    #[serde(default)]
    bodies: BTreeMap<String, Quantity<MomentOfInertia>>,
    /// Planets that have inertia, each with its mass and radius.
    #[serde(default)]
    planets: Vec<PlanetsEntry>,
    /// Shift elements that are engaged all the time.
    #[serde(default)]
    engaged: Vec<String>,
    /// Speeds at the start. Default: everything at rest.
    #[serde(default)]
    start: BTreeMap<String, Quantity<AngularVelocity>>,
    /// Torques on links, positive along the axis, with the keys of a scenario.
    #[serde(default)]
    torques: Vec<TorqueEntry>,
    /// Friction between links.
    #[serde(default)]
    elements: Vec<FrictionGiven>,
    /// Speeds whose passing is an event.
    #[serde(default)]
    thresholds: Vec<ThresholdEntry>,
    /// How long, from time 0.
    duration: Quantity<Time>,
}

fn refused(name: &str, message: impl Into<String>) -> Refusal {
    Refusal { name: name.into(), message: message.into() }
}

fn of_table(fault: TableFault) -> Refusal {
    match fault {
        TableFault::Entry(message) => refused("table", message),
        TableFault::Csv(error) => refused(error.name(), error.to_string()),
    }
}

fn harmonic(given: &HarmonicEntry) -> Result<Course, Refusal> {
    let mean = given.mean.map_or(Torque::from_si(0.0), |mean| mean.0);
    let phase = given.phase.map_or(Angle::from_si(0.0), |phase| phase.0);
    let speed = AngularVelocity::from_si(TAU * given.frequency.0.si());
    Ok(Course::harmonic(mean, given.amplitude.0, speed, phase)?)
}

impl RunGiven {
    fn mechanism(&self) -> Result<Mechanism, Refusal> {
        let Some(file) = &self.gearbox else {
            let bodies: Vec<(&str, MomentOfInertia)> =
                self.bodies.iter().map(|(name, inertia)| (name.as_str(), inertia.0)).collect();
            return Ok(Mechanism::shafts(&bodies)?);
        };
        let links = self.inertias.iter().map(|(link, inertia)| (link.clone(), inertia.0)).collect();
        let mut planets = vec![];
        for entry in &self.planets {
            planets.push((entry.set.clone(), masses(entry)?));
        }
        let engaged: Vec<&str> = self.engaged.iter().map(String::as_str).collect();
        let mut mechanism = Mechanism::of(&file.gearbox()?, &engaged, &Masses { links, planets })?;
        for (name, inertia) in &self.bodies {
            mechanism = mechanism.with_body(name, inertia.0)?;
        }
        Ok(mechanism)
    }

    fn model(&self) -> Result<Model, Refusal> {
        let mut model = Model::new(self.mechanism()?);
        for entry in &self.torques {
            match entry.resistance {
                Some(torque) => model.resistance(&entry.id, &entry.link, torque.0)?,
                None => model.torque(&entry.id, &entry.link, law(entry)?)?,
            }
        }
        for entry in &self.elements {
            let course = match (entry.holding, &entry.capacity, &entry.harmonic) {
                (Some(torque), None, None) => Course::constant(torque.0)?,
                (None, Some(table), None) => Course::table(&table.points(&Texts::new()).map_err(of_table)?)?,
                (None, None, Some(wave)) => harmonic(wave)?,
                _ => {
                    let message = format!("{}: give one of holding, capacity and harmonic", entry.id);
                    return Err(refused("capacity-in-one-way", message));
                }
            };
            let ratio = entry.static_ratio.map_or(1.0, Number::get);
            match &entry.links {
                Some([first, second]) => model.friction(&entry.id, [first, second], course, ratio)?,
                None => model.shift_element(&entry.id, course, ratio)?,
            }
        }
        for entry in &self.thresholds {
            model.threshold(&entry.id, &entry.link, entry.speed.0)?;
        }
        Ok(model)
    }

    fn start(&self) -> Start {
        if self.start.is_empty() {
            return Start::at_rest();
        }
        let speeds: Vec<(&str, AngularVelocity)> =
            self.start.iter().map(|(link, speed)| (link.as_str(), speed.0)).collect();
        Start::speeds(&speeds)
    }
}

fn masses(entry: &PlanetsEntry) -> Result<PlanetMasses, Refusal> {
    let lacks = |what: &str| refused("planets-unknown", format!("planets of {}: give {what}", entry.set));
    let each = entry.each.iter().map(|planet| {
        Ok(PlanetMass {
            mass: planet.mass.ok_or_else(|| lacks("the mass of each"))?.0,
            inertia: planet.inertia.0,
            radius: planet.radius.ok_or_else(|| lacks("the radius of the centre of each"))?.0,
        })
    });
    Ok(PlanetMasses {
        count: entry.count.ok_or_else(|| lacks("their count"))?,
        each: each.collect::<Result<_, Refusal>>()?,
    })
}

/// The law of a torque; resistances are no laws.
fn law(entry: &TorqueEntry) -> Result<TorqueLaw, Refusal> {
    let given: Vec<&str> =
        entry.laws().into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| key).collect();
    if given.len() != 1 {
        let all = entry.laws().map(|(key, _)| key).join(", ");
        return Err(refused("one-law", format!("{}: give one of {all}", entry.id)));
    }
    let no_texts = Texts::new();
    if let Some(torque) = entry.constant {
        return Ok(TorqueLaw::constant(torque.0)?);
    }
    if let Some(table) = &entry.over_time {
        return Ok(TorqueLaw::over_time(Course::table(&table.points(&no_texts).map_err(of_table)?)?));
    }
    if let Some(table) = &entry.over_speed {
        return Ok(TorqueLaw::over_speed(&table.points(&no_texts).map_err(of_table)?)?);
    }
    if let Some(law) = &entry.linear {
        return Ok(TorqueLaw::linear(law.at_rest.0, law.no_load.0)?);
    }
    if let Some(law) = &entry.viscous {
        return Ok(TorqueLaw::viscous(law.torque.0, law.at.0)?);
    }
    if let Some(law) = &entry.quadratic {
        return Ok(TorqueLaw::quadratic(law.torque.0, law.at.0)?);
    }
    if let Some(law) = &entry.kloss {
        return Ok(TorqueLaw::kloss(law.peak.0, law.peak_slip.get(), law.synchronous.0)?);
    }
    if let Some(wave) = &entry.harmonic {
        return Ok(TorqueLaw::over_time(harmonic(wave)?));
    }
    if let Some(law) = &entry.constant_power {
        return Ok(TorqueLaw::constant_power(law.power.0, law.limit.0)?);
    }
    Err(refused("law-of-no-case", format!("{}: cases have no torques by {}", entry.id, given[0])))
}

fn word(state: State) -> &'static str {
    match state {
        State::Open => "open",
        State::Forward => "slips forward",
        State::Backward => "slips backward",
        State::Stuck => "holds",
    }
}

fn in_words(change: &Change) -> String {
    match change {
        Change::Element { name, to, .. } => format!("{name} {}", word(*to)),
        Change::Set { name, .. } => format!("{name} rolls otherwise"),
        Change::Shaft { name, .. } => format!("{name} changes its contact"),
        Change::Drag { name, .. } => format!("{name} changes"),
        Change::Threshold { name, is_rising } => {
            format!("{name} is passed {}", if *is_rising { "upwards" } else { "downwards" })
        }
        _ => "another change".to_owned(),
    }
}

fn run(given: &RunGiven) -> Result<Results, Refusal> {
    let model = given.model()?;
    let start = given.start();
    let mut results = Results::default();
    results.count("freedoms", model.mechanism().freedoms() as i64);
    let begin = model.at_start(&start)?;
    let run = model.run(&start, given.duration.0, None)?;
    for link in run.links.iter().skip(1) {
        // A link that stands still has no inertia to refer to.
        if let Ok(inertia) = model.mechanism().equivalent_inertia(link)
            && inertia.si().is_finite()
        {
            results.quantity(format!("equivalent_inertia.{link}"), inertia);
        }
    }
    sample(&mut results, "start", &run, &begin);
    results.count("events", run.events.len() as i64);
    let mut before = Time::from_si(0.0);
    for (place, event) in run.events.iter().enumerate() {
        let name = format!("event.{}", place + 1);
        let changes: Vec<String> = event.changes.iter().map(in_words).collect();
        results
            .text(name.clone(), changes.join(", "))
            .quantity(format!("{name}.time"), event.after.time)
            .quantity(format!("{name}.since_the_last"), event.after.time - before);
        sample(&mut results, &name, &run, &event.after);
        before = event.after.time;
    }
    sample(&mut results, "end", &run, run.end());
    energies(&mut results, &run);
    Ok(results)
}

/// Speeds, accelerations and torques at a time.
fn sample(results: &mut Results, prefix: &str, run: &Run, sample: &Sample) {
    for (place, link) in run.links.iter().enumerate().skip(1) {
        results
            .quantity(format!("{prefix}.speed.{link}"), sample.speeds[place])
            .quantity(format!("{prefix}.acceleration.{link}"), sample.accelerations[place]);
    }
    for (place, element) in run.elements.iter().enumerate() {
        results
            .quantity(format!("{prefix}.torque.{element}"), sample.elements[place])
            .text(format!("{prefix}.state.{element}"), word(sample.states[place]));
    }
    for (set, torques) in run.sets.iter().zip(&sample.sets) {
        for (place, torque) in torques.iter().enumerate() {
            results.quantity(format!("{prefix}.set.{set}.{}", place + 1), *torque);
        }
    }
}

fn energies(results: &mut Results, run: &Run) {
    let audit = &run.audit;
    let sum = |energies: &[Energy]| energies.iter().fold(Energy::from_si(0.0), |sum, one| sum + *one);
    results
        .quantity("energy.start", audit.before)
        .quantity("energy.end", audit.after)
        .quantity("mesh_losses", sum(&audit.mesh_losses))
        // A sum of several ten thousand steps is not exact; a wrong energy is further off by far.
        .answer("energies_balance", audit.residual().abs() < 1e-10);
    for (torque, work) in run.torques.iter().zip(&audit.work) {
        results.quantity(format!("work.{torque}"), *work);
    }
    for (torque, loss) in run.torques.iter().zip(&audit.inner_losses) {
        results.quantity(format!("inner_loss.{torque}"), *loss);
    }
    for (element, heat) in run.elements.iter().zip(&audit.heat) {
        results.quantity(format!("heat.{element}"), *heat);
    }
}
