//! Run of a model from event to event.
//!
//! Between events the pattern of holding and slipping is fixed and the right side smooth. Steps of
//! [`step`](crate::step) go up to the next kink of a course. If a margin is negative at any stage or at the
//! end of a step, the event is located within the step, on the dense output. The step is then repeated with
//! the length to the first event, so that the state there has the accuracy of a step and not that of the
//! interpolation.
//!
//! At an event the slips that vanish are set to 0 exactly, by the plastic [impact](impact) with the least
//! loss of kinetic energy. Here this only removes rounding, and the motion goes on from this state. Events
//! within `1e-10` of a step are one set, decided together.

mod impact;
mod locate;

use crate::Error;
use crate::decide::{Loosed, Moment, Unique, largest_speed};
use crate::field::{Field, Trigger};
use crate::model::{Kind, Model};
use crate::pattern::{Pattern, Way};
use crate::record::{Audit, Change, Event, Run, Sample, State, drag_states, states};
use crate::start::Start;
use crate::step::Stepper;
use crate::tolerance::{
    ACCUMULATION, AHEAD, MOST_STEPS, MOST_TOGETHER, RESTARTS, SHORTEST, SLIP, STEP_ERROR,
};
use epicyclic_numerics::values::{dot, largest_absolute};
use epicyclic_train::GROUND;
use epicyclic_units::Physical;
use std::collections::VecDeque;
use std::ops::ControlFlow;
use uom::si::f64::Time;

impl Model {
    /// Accelerations and torques at the start.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn at_start(&self, start: &Start) -> Result<Sample, Error> {
        let runner = Runner::new(self, start, 1.0, None)?;
        Ok(Sample::of(&runner.field, 0.0, &runner.stepper.y))
    }

    /// Calculates the motion from time 0 to an end, with samples at these intervals.
    ///
    /// # Errors
    /// - [`Error::Value`] for an end or interval that is not finite and above 0;
    /// - [`Error::InitialSpeeds`], [`Error::InitialOpen`], [`Error::InitialSlip`], [`Error::Unknown`] for an
    ///   invalid start;
    /// - [`Error::NotUnique`], [`Error::NoMotion`], [`Error::TooManyMeshes`], [`Error::TooManyAtRest`],
    ///   [`Error::DragSpeed`] for a motion that does not follow;
    /// - [`Error::Accumulating`], [`Error::StepTooShort`], [`Error::TooManySteps`] for one that does not go
    ///   on.
    pub fn run(&self, start: &Start, end: Time, sample_every: Option<Time>) -> Result<Run, Error> {
        self.run_watched(start, end, sample_every, &mut |_| ControlFlow::Continue(()))
    }

    /// Calculates the motion under a watch, which is called with the time of every step and may end the
    /// motion there. The result up to then is the same as without the watch.
    ///
    /// # Errors
    /// Errors of [`run`](Self::run).
    pub fn run_watched(
        &self,
        start: &Start,
        end: Time,
        sample_every: Option<Time>,
        watch: &mut Watch<'_>,
    ) -> Result<Run, Error> {
        let positive = |field: &str, value: f64| {
            if value > 0.0 && value.is_finite() {
                Ok(value)
            } else {
                Err(Error::Value { field: field.into(), value, allowed: "it is finite and above 0" })
            }
        };
        let end = positive("the end in s", end.si())?;
        let every =
            sample_every.map(|every| positive("the interval of samples in s", every.si())).transpose()?;
        let mut runner = Runner::new(self, start, end, every)?;
        let y = &runner.stepper.y;
        let before =
            [self.mechanism.kinetic_energy(&y[..runner.field.parts.work]), runner.field.elastic_energy(y)];
        runner.sample();
        runner.go(watch)?;
        runner.sample();
        let mechanism = &self.mechanism;
        let meshes = mechanism.meshes.iter().map(|mesh| (mesh.set, mesh.gears.clone())).collect();
        Ok(Run {
            links: mechanism.links.clone(),
            torques: self.torques.iter().map(|one| one.name.clone()).collect(),
            elements: self.elements[..self.own_elements()].iter().map(|one| one.name.clone()).collect(),
            sets: mechanism.sets.iter().map(|set| set.name.clone()).collect(),
            shafts: self.shafts.iter().map(|one| one.name.clone()).collect(),
            converters: self.converters.iter().map(|one| one.name.clone()).collect(),
            drags: self.drags.iter().map(|one| one.name.clone()).collect(),
            meshes,
            audit: Audit::of(&runner.field, &runner.stepper.y, runner.impacts, before),
            samples: runner.samples,
            events: runner.events,
            steps: runner.steps,
            transitions: runner.transitions,
        })
    }

    /// The next time at which a course has a kink.
    fn next_kink(&self, t: f64) -> f64 {
        let of_torques = self.torques.iter().filter_map(|one| one.law.course()?.next_kink(t));
        let of_elements = self.elements.iter().filter_map(|one| match &one.kind {
            Kind::Friction { capacity, .. } => capacity.next_kink(t),
            Kind::OneWay | Kind::Drag => None,
            Kind::Dog { program, .. } => program.iter().map(|(time, _)| *time).find(|&time| time > t),
        });
        of_torques.chain(of_elements).fold(f64::INFINITY, f64::min)
    }

    /// The longest step that the courses allow.
    fn longest_step(&self) -> f64 {
        let of_torques = self.torques.iter().filter_map(|one| Some(one.law.course()?.longest_step()));
        let of_elements = self.elements.iter().map(|one| match &one.kind {
            Kind::Friction { capacity, .. } => capacity.longest_step(),
            Kind::OneWay | Kind::Dog { .. } | Kind::Drag => f64::INFINITY,
        });
        of_torques.chain(of_elements).fold(f64::INFINITY, f64::min)
    }
}

/// A run on its way.
struct Runner<'m> {
    model: &'m Model,
    field: Field<'m>,
    stepper: Stepper,
    unique: Unique,
    end: f64,
    /// Interval of samples, and how many of them there are.
    every: Option<f64>,
    sampled: usize,
    longest: f64,
    /// The next step to be tried.
    h: f64,
    speed_scale: f64,
    energy_scale: f64,
    /// The largest twist of each shaft so far.
    twist_scales: Vec<f64>,
    scales: Vec<f64>,
    /// Room for derivatives.
    rates: Vec<f64>,
    impacts: f64,
    samples: Vec<Sample>,
    events: Vec<Event>,
    /// Times of the last events, with what fired them.
    recent: VecDeque<(f64, Vec<Trigger>)>,
    steps: usize,
    transitions: usize,
}

/// Function that is called with the time of every step.
type Watch<'a> = dyn FnMut(Time) -> ControlFlow<()> + 'a;

/// Data before a transition: the pattern, states of the elements and of the drags.
struct Before(Pattern, Vec<State>, Vec<Option<State>>);

/// End of a stretch.
enum Stretch {
    /// Before its end, as the one who watches wants.
    Left,
    /// The stretch reached a kink, or the end of the run.
    Reached,
    /// The stretch was ended by these triggers.
    Fired(Vec<Trigger>),
}

impl<'m> Runner<'m> {
    fn new(model: &'m Model, start: &Start, end: f64, every: Option<f64>) -> Result<Self, Error> {
        let q = start.coordinates(&model.mechanism)?;
        let field = Field::new(model, 0.0).ok_or(Error::NoFreedom)?;
        let mut stepper = Stepper::new(field.parts.size);
        stepper.y[..q.len()].copy_from_slice(&q);
        stepper.y[field.parts.twist..].copy_from_slice(&start.twists(&model.shafts)?);
        let longest = model.longest_step();
        let size = field.parts.size;
        let mut made = Self {
            model,
            field,
            stepper,
            unique: Unique::default(),
            end,
            every,
            sampled: 0,
            longest,
            h: end / 16.0,
            speed_scale: 0.0,
            energy_scale: 0.0,
            twist_scales: model.shafts.iter().map(|one| 0.5 * one.shaft.backlash).collect(),
            scales: vec![1.0; size],
            rates: vec![0.0; size],
            impacts: 0.0,
            samples: vec![],
            events: vec![],
            recent: VecDeque::new(),
            steps: 0,
            transitions: 0,
        };
        made.speed_scale = largest_speed(&made.field, &made.stepper.y);
        made.field.place(&made.stepper.y);
        made.engage_at_start()?;
        made.check_drags()?;
        made.project(&[]);
        made.impacts = 0.0;
        made.decide(&[])?;
        for (side, one) in made.field.sides.iter_mut().zip(&model.thresholds) {
            let distance = dot(&one.factors, &made.stepper.y) - one.speed;
            // On the threshold it is the acceleration that tells the side.
            let rate = dot(&one.factors, &made.field.accelerations);
            *side = if distance == 0.0 { rate.signum() } else { distance.signum() };
        }
        Ok(made)
    }

    fn go(&mut self, watch: &mut Watch<'_>) -> Result<(), Error> {
        loop {
            let stop = self.model.next_kink(self.stepper.t).min(self.end);
            match self.advance(stop, watch)? {
                Stretch::Reached if stop >= self.end => return Ok(()),
                Stretch::Left => return Ok(()),
                Stretch::Reached => self.transit(&[])?,
                Stretch::Fired(fired) => self.transit(&fired)?,
            }
        }
    }

    /// Steps up to a time, or to the first event before it.
    fn advance(&mut self, stop: f64, watch: &mut Watch<'_>) -> Result<Stretch, Error> {
        let shortest = SHORTEST * self.end;
        loop {
            if watch(Time::from_si(self.stepper.t)).is_break() {
                return Ok(Stretch::Left);
            }
            let left = stop - self.stepper.t;
            if left <= shortest {
                self.stepper.t = stop;
                return Ok(Stretch::Reached);
            }
            let wanted = self.h.min(self.longest);
            let is_last = wanted >= left;
            let h = if is_last { left } else { wanted };
            if h < shortest {
                return Err(Error::StepTooShort { time_s: self.stepper.t, step_s: shortest });
            }
            if self.steps >= MOST_STEPS {
                return Err(Error::TooManySteps { most: MOST_STEPS, time_s: self.stepper.t });
            }
            self.steps += 1;
            self.attempt(h);
            let error = self.error();
            let factor = if error > 0.0 { 0.9 * libm::pow(error, -0.125) } else { 6.0 };
            if error.is_nan() || error > 1.0 {
                self.h = h * if error.is_finite() { factor.max(0.2) } else { 0.2 };
                continue;
            }
            if let Some(fired) = self.locate() {
                self.h = h * factor.clamp(0.2, 6.0);
                self.accept();
                return Ok(Stretch::Fired(fired));
            }
            self.sample_within(1.0);
            self.accept();
            let next = h * factor.clamp(0.2, 6.0);
            // A step cut short by a kink says little about the next.
            self.h = if is_last { next.max(self.h) } else { next };
            if is_last {
                self.stepper.t = stop;
                return Ok(Stretch::Reached);
            }
        }
    }

    fn attempt(&mut self, h: f64) {
        let Self { field, stepper, .. } = self;
        field.stages.clear();
        stepper.attempt(h, |t, y, dy| {
            field.evaluate(t, y, dy);
            field.measure(t, y);
            field.stages.extend_from_slice(&field.margins);
        });
    }

    /// Error of the step tried, over the largest speed, energy and twist up to its end.
    fn error(&mut self) -> f64 {
        let parts = self.field.parts;
        let end = &self.stepper.end;
        let speed = self.speed_scale.max(largest_absolute(&end[..parts.work]));
        let energy = self.energy_scale.max(self.largest_energy(end));
        let scale = |largest: f64| if largest > 0.0 { STEP_ERROR * largest } else { 1.0 };
        self.scales[..parts.work].fill(scale(speed));
        self.scales[parts.work..parts.twist].fill(scale(energy));
        for (shaft, most) in self.twist_scales.iter().enumerate() {
            self.scales[parts.twist + shaft] = scale(most.max(end[parts.twist + shaft].abs()));
        }
        self.stepper.error(&self.scales)
    }

    fn largest_energy(&self, y: &[f64]) -> f64 {
        let parts = self.field.parts;
        let kinetic = self.model.mechanism.kinetic_energy(&y[..parts.work]);
        largest_absolute(&y[parts.work..parts.twist]).max(kinetic).max(self.field.elastic_energy(y))
    }

    /// Goes to the end of the step tried.
    fn accept(&mut self) {
        self.stepper.accept();
        let y = &self.stepper.y;
        self.speed_scale = self.speed_scale.max(largest_speed(&self.field, y));
        self.energy_scale = self.energy_scale.max(self.largest_energy(y));
        for (most, twist) in self.twist_scales.iter_mut().zip(&y[self.field.parts.twist..]) {
            *most = most.max(twist.abs());
        }
        self.field.torque_scale = self.field.torque_scale.max(self.field.largest_torque());
    }

    /// Takes what comes after a kink or an event.
    fn transit(&mut self, fired: &[Trigger]) -> Result<(), Error> {
        let t = self.stepper.t;
        self.transitions += usize::from(!fired.is_empty());
        self.watch_accumulation(fired)?;
        let before = Before(self.field.pattern.clone(), states(&self.field), drag_states(&self.field));
        let held = self.field.elements.clone();
        let just_before = self.now();
        let mut loosed: Vec<Loosed> = vec![];
        let mut changes = vec![];
        let mut passing = vec![];
        for trigger in fired {
            match *trigger {
                Trigger::Exceeds(place) | Trigger::LetsGo(place) => {
                    loosed.push((place, Way::of(-held[place])));
                }
                Trigger::Segment(place, true) => self.field.pattern.segments[place] += 1,
                Trigger::Segment(place, false) => self.field.pattern.segments[place] -= 1,
                Trigger::Curve(place, true) => self.field.pattern.curves[place] += 1,
                Trigger::Curve(place, false) => self.field.pattern.curves[place] -= 1,
                Trigger::Drag(place, is_upper) => self.pass_point(place, is_upper)?,
                Trigger::Flank(place, is_second) => {
                    let twist = &mut self.stepper.y[self.field.parts.twist + place];
                    let flank = &mut self.field.pattern.flanks[place];
                    (*flank, *twist) = self.model.shafts[place].shaft.next(*flank, is_second, *twist);
                }
                Trigger::Drive(place, end) => {
                    let drive = &mut self.field.pattern.drives[place];
                    *drive = self.model.converters[place].next(*drive, end, &self.stepper.y);
                }
                Trigger::Passes(place) => passing.push(place),
                // Its torque is nothing under either direction: only this tells which is next.
                Trigger::Reverses(mesh) => self.field.pattern.meshes[mesh] *= -1,
                Trigger::SlipEnds(_) | Trigger::RollingEnds(_) | Trigger::Starts | Trigger::Meshes(_) => {}
            }
        }
        for (place, way) in &mut loosed {
            if matches!(self.model.elements[*place].kind, Kind::OneWay) {
                *way = Way::Forward;
            }
        }
        self.field.take_pieces(t);
        if self.engage(fired) {
            self.follow_jump(&mut changes);
            self.check_drags()?;
        }
        self.project(fired);
        self.decide(&loosed)?;
        let is_alone = passing.len() == fired.len();
        changes.extend(passing.into_iter().filter_map(|place| self.pass_on(place, is_alone)));
        self.note_changes(&before, &mut changes);
        if !changes.is_empty() {
            let after = Sample::of(&self.field, t, &self.stepper.y);
            self.events.push(Event { changes, before: just_before, after });
        }
        Ok(())
    }

    fn note_changes(&self, Before(before, was, did): &Before, changes: &mut Vec<Change>) {
        let after = &self.field.pattern;
        for ((one, &from), to) in self.model.elements.iter().zip(was).zip(states(&self.field)) {
            if from != to {
                changes.push(Change::Element { name: one.name.clone(), from, to });
            }
        }
        for ((one, from), to) in self.model.drags.iter().zip(did).zip(drag_states(&self.field)) {
            if let (Some(from), Some(to)) = (*from, to)
                && from != to
            {
                changes.push(Change::Drag { name: one.name.clone(), from, to });
            }
        }
        for (place, one) in self.model.mechanism.sets.iter().enumerate() {
            // Of sets at rest that roll together only one is held, whichever comes first.
            let [from, to] = [before, after].map(|pattern| {
                if pattern.sets[place].sign() == 0.0 { Way::Stuck } else { pattern.sets[place] }
            });
            if from != to {
                changes.push(Change::Set { name: one.name.clone(), from: from.into(), to: to.into() });
            }
        }
        for (place, one) in self.model.shafts.iter().enumerate().filter(|(_, one)| one.shaft.backlash > 0.0) {
            let [from, to] = [before, after].map(|pattern| pattern.flanks[place].contact(0.0));
            if from != to {
                changes.push(Change::Shaft { name: one.name.clone(), from, to });
            }
        }
    }

    fn decide(&mut self, loosed: &[Loosed]) -> Result<(), Error> {
        let ahead = AHEAD * self.end;
        self.field.find_idle();
        let moment = Moment {
            t: self.stepper.t,
            y: &self.stepper.y,
            speed_scale: self.speed_scale,
            loosed,
            ahead,
            held: None,
        };
        self.field.decide(&moment, &mut self.unique)?;
        let Self { field, stepper, .. } = self;
        stepper.begin(|t, y, dy| field.evaluate(t, y, dy));
        Ok(())
    }

    /// Takes the next segment of a drag's curve; refuses a speed for which the curve has no torque.
    fn pass_point(&mut self, place: usize, is_upper: bool) -> Result<(), Error> {
        let curve = &self.model.drags[place].curve;
        let segment = &mut self.field.pattern.drags[place];
        let before = *segment;
        *segment = if is_upper { before + 1 } else { before - 1 };
        if curve.is_outside(before) || curve.is_outside(*segment) { Err(self.outside(place)) } else { Ok(()) }
    }

    /// Refuses speeds for which the curves of drags have no torque, if the speeds are not those of a step.
    fn check_drags(&self) -> Result<(), Error> {
        let zero = SLIP * self.speed_scale;
        let is_refused = |&place: &usize| {
            let one = &self.model.drags[place];
            one.curve.is_outside(self.field.pattern.drags[place])
                && dot(&one.slip, &self.stepper.y).abs() > zero
        };
        match (0..self.model.drags.len()).find(is_refused) {
            Some(place) => Err(self.outside(place)),
            None => Ok(()),
        }
    }

    fn outside(&self, place: usize) -> Error {
        let one = &self.model.drags[place];
        let [from_rad_s, to_rad_s] = one.curve.range();
        Error::DragSpeed {
            drag: one.name.clone(),
            place,
            slip_rad_s: dot(&one.slip, &self.stepper.y).abs(),
            from_rad_s,
            to_rad_s,
            time_s: self.stepper.t,
        }
    }

    /// Refuses events that accumulate.
    fn watch_accumulation(&mut self, fired: &[Trigger]) -> Result<(), Error> {
        if fired.is_empty() {
            return Ok(());
        }
        let t = self.stepper.t;
        self.recent.push_back((t, fired.to_vec()));
        if self.recent.len() <= MOST_TOGETHER {
            return Ok(());
        }
        self.recent.pop_front();
        let within = self.recent.front().map_or(f64::INFINITY, |(first, _)| t - first);
        let starts = self.recent.iter().filter(|(_, fired)| fired.contains(&Trigger::Starts)).count();
        let allowed = if 4 * starts >= MOST_TOGETHER { RESTARTS } else { ACCUMULATION };
        if within >= allowed * self.end {
            return Ok(());
        }
        let fired: Vec<Trigger> = self.recent.iter().flat_map(|(_, fired)| fired).copied().collect();
        let mut parts: Vec<String> = fired.iter().map(|&trigger| self.name_of(trigger)).collect();
        parts.sort();
        parts.dedup();
        let mut links: Vec<String> = fired.iter().flat_map(|&trigger| self.links_of(trigger)).collect();
        links.sort();
        links.dedup();
        Err(Error::Accumulating { time_s: t, events: MOST_TOGETHER, within_s: within, parts, links })
    }

    fn name_of(&self, trigger: Trigger) -> String {
        let model = self.model;
        match trigger {
            Trigger::SlipEnds(place)
            | Trigger::Exceeds(place)
            | Trigger::LetsGo(place)
            | Trigger::Meshes(place)
            | Trigger::Curve(place, _) => model.elements[place].name.clone(),
            Trigger::Drag(place, _) => model.drags[place].name.clone(),
            Trigger::Flank(place, _) => model.shafts[place].name.clone(),
            Trigger::Drive(place, _) => model.converters[place].name.clone(),
            Trigger::RollingEnds(set) => model.mechanism.sets[set].name.clone(),
            Trigger::Reverses(mesh) => model.mechanism.sets[model.mechanism.meshes[mesh].set].name.clone(),
            Trigger::Starts => "mesh friction at rest".into(),
            Trigger::Segment(place, _) => model.torques[place].name.clone(),
            Trigger::Passes(place) => model.thresholds[place].name.clone(),
        }
    }

    /// Links of what a trigger is of.
    fn links_of(&self, trigger: Trigger) -> Vec<String> {
        let model = self.model;
        let sets = &model.mechanism.sets;
        let places = match trigger {
            Trigger::SlipEnds(place)
            | Trigger::Exceeds(place)
            | Trigger::LetsGo(place)
            | Trigger::Meshes(place)
            | Trigger::Curve(place, _) => model.elements[place].places,
            Trigger::Drag(place, _) => model.drags[place].places,
            Trigger::Flank(place, _) => model.shafts[place].places,
            Trigger::Drive(place, _) => model.converters[place].places,
            Trigger::RollingEnds(set) => [sets[set].root, sets[set].carrier],
            Trigger::Reverses(mesh) => {
                let set = &sets[model.mechanism.meshes[mesh].set];
                [set.root, set.carrier]
            }
            Trigger::Segment(place, _) => [model.torques[place].place; 2],
            Trigger::Starts | Trigger::Passes(_) => return vec![],
        };
        places.map(|place| place.map_or(GROUND, |node| model.mechanism.node_name(node)).to_owned()).into()
    }

    /// Sample at the current state of the run.
    fn now(&mut self) -> Sample {
        let Self { field, stepper, .. } = self;
        stepper.begin(|t, y, dy| field.evaluate(t, y, dy));
        Sample::of(&self.field, self.stepper.t, &self.stepper.y)
    }

    /// A sample of where the run is.
    fn sample(&mut self) {
        let sample = self.now();
        self.samples.push(sample);
    }
}
