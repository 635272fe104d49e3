//! The model of a scenario, with the place of every fault.

use super::parts::{Built, Element, ElementKind, Output, Scenario};
use super::program::Program;
use super::{ABOVE_0, AT_LEAST_0, INSTANTS, MOST_SAMPLES, placed, refused, root};
use crate::error::Error;
use crate::shared::fault::Named;
use epicyclic_dynamics::gearbox::{Masses, PlanetMass, PlanetMasses};
use epicyclic_formats::Path;
use epicyclic_formats::scenario::{
    DogEntry, ElementEntry, OverSpeedEntry, PlanetsEntry, PressureEntry, StartEntry, TableFault,
    ThrottleEntry, TorqueEntry, pairs,
};
use epicyclic_motion::{self as motion, Course, Mechanism, Model, Start, TorqueLaw};
use epicyclic_train::{GROUND, ShiftElement};
use epicyclic_units::{Number, Physical, Quantity};
use std::f64::consts::TAU;
use uom::si::f64::{Angle, AngularVelocity, Pressure, Time, Torque};

/// Sampling of a run.
pub(super) struct Sampling {
    /// Interval between the samples of the run.
    pub(super) inner: Time,
    /// Number of samples of the run per listed sample.
    pub(super) kept: usize,
}

impl Scenario<'_> {
    pub(super) fn built(&self) -> Result<Built, Error> {
        let mechanism = self.mechanism()?;
        for (place, entry) in self.file.elements.iter().enumerate() {
            self.shift_element(place, entry)?;
        }
        let program = Program::of(self)?;
        let mut model = Model::new(mechanism);
        let mut elements = self.one_way_clutches(&model);
        for (place, entry) in self.file.shafts.iter().enumerate() {
            self.add_shaft(&mut model, place, entry)?;
        }
        for (place, entry) in self.file.converters.iter().enumerate() {
            self.add_converter(&mut model, place, entry)?;
        }
        for (place, entry) in self.file.torques.iter().enumerate() {
            self.add_torque(&mut model, &mut elements, place, entry)?;
        }
        for (place, entry) in self.file.elements.iter().enumerate() {
            elements.push(self.element(&mut model, &program, place, entry)?);
        }
        for (place, threshold) in self.file.thresholds.iter().enumerate() {
            let path = root("thresholds").index(place);
            let added = model.threshold(&threshold.id, &threshold.link, threshold.speed.0);
            added.map_err(|why| placed(self.document, &named(path, &why), why))?;
        }
        let drags = self.add_drags(&mut model)?;
        let output = Output::of(self, &model, &elements, &drags);
        Ok(Built { start: self.start()?, model, elements, drags, shifts: program.shifts, output })
    }

    fn mechanism(&self) -> Result<Mechanism, Error> {
        let (document, gearbox) = (self.document, &self.subject.train);
        let mut masses = Masses::default();
        for (link, inertia) in &self.file.inertias {
            if link == GROUND {
                return Err(refused(
                    document,
                    &root("inertias").key(link),
                    &Named("housing", "the housing does not move"),
                ));
            }
            masses.links.push((link.clone(), inertia.0));
        }
        for (place, entry) in self.file.planets.iter().enumerate() {
            masses.planets.push((entry.set.clone(), self.planets(&root("planets").index(place), entry)?));
        }
        let engaged: Vec<&str> = self.file.engaged.iter().map(String::as_str).collect();
        let mut found = Mechanism::of(gearbox, &engaged, &masses).map_err(|why| {
            let of_planets = |set: &str| {
                let place = self.file.planets.iter().position(|one| one.set == set);
                place.map(|place| root("planets").index(place))
            };
            let path = match &why {
                motion::Error::Unknown { what: "shift element", name } => {
                    let place = self.file.engaged.iter().position(|one| one == name);
                    place.map(|place| root("engaged").index(place))
                }
                motion::Error::Unknown { name, .. } if self.file.inertias.contains_key(name) => {
                    Some(root("inertias").key(name))
                }
                motion::Error::Unknown { name, .. } | motion::Error::PlanetSpeed { set: name, .. } => {
                    of_planets(name)
                }
                motion::Error::Value { .. } => self.no_mass(),
                _ => None,
            };
            match path {
                Some(path) => placed(document, &path, why),
                None => self.of_run(why),
            }
        })?;
        for (body, inertia) in &self.file.bodies {
            let with = found.with_body(body, inertia.0);
            found = with.map_err(|why| placed(document, &root("bodies").key(body), why))?;
        }
        Ok(found)
    }

    /// Masses and inertias of a set's planets; values that are not given are taken from the gearbox.
    fn planets(&self, path: &Path, entry: &PlanetsEntry) -> Result<PlanetMasses, Error> {
        let known = self.subject.planet_bearings.iter().filter(|bearing| {
            self.subject.train.sets().get(bearing.set).is_some_and(|set| set.id() == entry.set)
        });
        let known: Vec<_> = known.collect();
        let lacks = |what: &str, path: &Path| {
            refused(
                self.document,
                path,
                &Named("planets-unknown", format!("the gearbox does not say {what}: write it here")),
            )
        };
        let count = entry.count.or(known.iter().find_map(|bearing| bearing.planets));
        let count = count.ok_or_else(|| lacks("how many planets there are, count", path))?;
        let mut each = vec![];
        for (place, planet) in entry.each.iter().enumerate() {
            let of_gearbox = known.iter().find(|bearing| bearing.planet == place);
            let path = path.clone().key("each").index(place);
            let mass = planet.mass.map(|mass| mass.0).or(of_gearbox.and_then(|one| one.mass));
            let radius = planet.radius.map(|radius| radius.0).or(of_gearbox.and_then(|one| one.radius));
            each.push(PlanetMass {
                mass: mass.ok_or_else(|| lacks("the mass of this planet", &path))?,
                inertia: planet.inertia.0,
                radius: radius.ok_or_else(|| lacks("the radius of this planet's centre", &path))?,
            });
        }
        Ok(PlanetMasses { count, each })
    }

    /// One-way clutches of the gearbox that belong to the model.
    fn one_way_clutches(&self, model: &Model) -> Vec<Element> {
        let gearbox = &self.subject.train;
        let engaged = |id: &str| self.file.engaged.iter().any(|one| one == id);
        let all = gearbox.shift_elements().iter().filter(|one| one.is_one_way() && !engaged(one.id()));
        let all = all.map(|one| (one.id(), one.links().map(|link| gearbox.link_name(link).to_owned())));
        // A one-way clutch between links that are one piece never slips, so the model leaves it out.
        let slips =
            |links: &[String; 2]| !model.mechanism().is_one_piece(&links[0], &links[1]).unwrap_or(true);
        all.filter(|(_, links)| slips(links))
            .map(|(id, links)| Element::new(id, ElementKind::OneWayClutch, links, None))
            .collect()
    }

    fn add_torque(
        &self,
        model: &mut Model,
        elements: &mut Vec<Element>,
        place: usize,
        entry: &TorqueEntry,
    ) -> Result<(), Error> {
        let path = root("torques").index(place);
        let given: Vec<&str> =
            entry.laws().into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| key).collect();
        let [law] = given[..] else {
            let all = entry.laws().map(|(key, _)| key).join(", ");
            let message = match given[..] {
                [] => format!("a law is due, one of {all}"),
                _ => format!("one law is due: give one of {}", given.join(", ")),
            };
            return Err(refused(self.document, &path, &Named("one-law", message)));
        };
        let at_law = path.clone().key(law);
        if let Some(torque) = entry.resistance {
            let added = model.resistance(&entry.id, &entry.link, torque.0);
            added.map_err(|why| placed(self.document, &either(path, at_law.clone(), &why), why))?;
            let course = Course::constant(torque.0).map_err(|why| placed(self.document, &at_law, why))?;
            let links = [entry.link.clone(), GROUND.to_owned()];
            elements.push(Element::new(&entry.id, ElementKind::Resistance, links, Some(course)));
            return Ok(());
        }
        let law = self.law(entry, &at_law)?;
        let added = model.torque(&entry.id, &entry.link, law);
        added.map_err(|why| placed(self.document, &named(path, &why), why))
    }

    fn law(&self, entry: &TorqueEntry, path: &Path) -> Result<TorqueLaw, Error> {
        let law = if let Some(torque) = entry.constant {
            TorqueLaw::constant(torque.0)
        } else if let Some(table) = &entry.over_time {
            let points = table.points(self.texts).map_err(|fault| self.of_table(path, fault))?;
            Course::table(&points).map(TorqueLaw::over_time)
        } else if let Some(table) = &entry.over_speed {
            let points = table.points(self.texts).map_err(|fault| self.of_table(path, fault))?;
            TorqueLaw::over_speed(&points)
        } else if let Some(law) = &entry.linear {
            TorqueLaw::linear(law.at_rest.0, law.no_load.0)
        } else if let Some(law) = &entry.viscous {
            TorqueLaw::viscous(law.torque.0, law.at.0)
        } else if let Some(law) = &entry.quadratic {
            TorqueLaw::quadratic(law.torque.0, law.at.0)
        } else if let Some(law) = &entry.kloss {
            TorqueLaw::kloss(law.peak.0, law.peak_slip.get(), law.synchronous.0)
        } else if let Some(law) = &entry.harmonic {
            let mean = law.mean.map_or(Torque::from_si(0.0), |mean| mean.0);
            let phase = law.phase.map_or(Angle::from_si(0.0), |phase| phase.0);
            let speed = AngularVelocity::from_si(TAU * law.frequency.0.si());
            Course::harmonic(mean, law.amplitude.0, speed, phase).map(TorqueLaw::over_time)
        } else if let Some(law) = &entry.constant_power {
            TorqueLaw::constant_power(law.power.0, law.limit.0)
        } else if let Some(law) = &entry.throttle {
            return self.throttle(law, path);
        } else {
            return Err(refused(self.document, path, &Named("one-law", "a law is due")));
        };
        law.map_err(|why| placed(self.document, &self.of_points(path, &why), why))
    }

    fn throttle(&self, law: &ThrottleEntry, path: &Path) -> Result<TorqueLaw, Error> {
        let curve = |key: &str, table: &OverSpeedEntry| {
            let path = path.clone().key(key);
            let points = table.points(self.texts).map_err(|fault| self.of_table(&path, fault))?;
            let checked = TorqueLaw::over_speed(&points);
            checked.map_err(|why| placed(self.document, &self.of_points(&path, &why), why))?;
            Ok::<_, Error>(points)
        };
        let (closed, full) = (curve("closed", &law.closed)?, curve("full", &law.full)?);
        let openings = pairs(("times", &law.times), ("openings", &law.openings))
            .map_err(|message| refused(self.document, path, &Named("table", message)))?;
        let openings: Vec<(Time, f64)> =
            openings.into_iter().map(|(time, opening)| (time.0, opening.get())).collect();
        TorqueLaw::map(&closed, &full, &openings)
            .map_err(|why| placed(self.document, &self.of_points(path, &why), why))
    }

    fn of_table(&self, path: &Path, fault: TableFault) -> Error {
        match fault {
            TableFault::Entry(message) => refused(self.document, path, &Named("table", message)),
            TableFault::Csv(error) => error.into(),
        }
    }

    /// Brake or clutch with the name in an entry.
    fn shift_element(&self, place: usize, entry: &ElementEntry) -> Result<&ShiftElement, Error> {
        let slips = || self.subject.train.shift_elements().iter().filter(|one| !one.is_one_way());
        slips().find(|one| one.id() == entry.id).ok_or_else(|| {
            let names: Vec<&str> = slips().map(ShiftElement::id).collect();
            let message =
                format!("no brake or clutch is called {}: there are {}", entry.id, names.join(", "));
            let path = root("elements").index(place).key("id");
            refused(self.document, &path, &Named("no-shift-element", message))
        })
    }

    fn element(
        &self,
        model: &mut Model,
        program: &Program,
        place: usize,
        entry: &ElementEntry,
    ) -> Result<Element, Error> {
        let document = self.document;
        let path = root("elements").index(place);
        let found = self.shift_element(place, entry)?;
        if self.file.engaged.contains(&entry.id) {
            let message = format!("{} is in `engaged`, where it never slips", entry.id);
            return Err(refused(document, &path.key("id"), &Named("engaged-twice", message)));
        }
        if entry.conductance.is_some() && entry.heat_capacity.is_none() {
            let why = Named("no-heat-capacity", "it is with a heat_capacity");
            return Err(refused(document, &path.key("conductance"), &why));
        }
        for (key, value) in [
            ("friction_area", entry.friction_area.map(|one| one.0.si())),
            ("heat_capacity", entry.heat_capacity.map(|one| one.0.si())),
        ] {
            if value.is_some_and(|value| value <= 0.0) {
                return Err(refused(document, &path.key(key), &ABOVE_0));
            }
        }
        let conductance = entry.conductance.map_or(0.0, |one| one.0.si());
        if conductance < 0.0 {
            return Err(refused(document, &path.key("conductance"), &AT_LEAST_0));
        }
        let links = found.links().map(|link| self.subject.train.link_name(link).to_owned());
        let (key, course) = match (&entry.holding, &entry.capacity, &entry.pressure, &entry.dog) {
            (None, None, None, Some(dog)) => {
                self.add_dog(model, &path, entry, dog)?;
                return Ok(Element::new(&entry.id, ElementKind::DogClutch, links, None));
            }
            (Some(_), None, None, None) => {
                let place = root("shifts");
                let place = if self.has(&place) { place } else { path.clone().key("holding") };
                ("holding", program.course(entry).map_err(|why| (place, why)))
            }
            (None, Some(table), None, None) => {
                let path = path.clone().key("capacity");
                let points = table.points(self.texts).map_err(|fault| self.of_table(&path, fault))?;
                ("capacity", Course::table(&points).map_err(|why| (self.of_points(&path, &why), why)))
            }
            (None, None, Some(pressure), None) => {
                let path = path.clone().key("pressure");
                let course = self.by_pressure(&path, pressure)?;
                ("pressure", course.map_err(|why| (self.of_points(&path, &why), why)))
            }
            _ => {
                let why = Named("one-capacity", "give one of holding, capacity, pressure and dog");
                return Err(refused(document, &path, &why));
            }
        };
        let course = course.map_err(|(path, why)| placed(document, &path, why))?;
        let ratio = entry.static_ratio.map_or(1.0, Number::get);
        model.shift_element(&entry.id, course.clone(), ratio).map_err(|why| {
            let key = match &why {
                motion::Error::Value { field, .. } if field.starts_with("static") => "static_ratio",
                motion::Error::Value { .. } => key,
                _ => "id",
            };
            placed(document, &path.clone().key(key), why)
        })?;
        if let Some(curve) = &entry.friction_over_slip {
            let path = path.key("friction_over_slip");
            let points = pairs(("speeds", &curve.speeds), ("factors", &curve.factors))
                .map_err(|message| refused(document, &path, &Named("table", message)))?;
            let points: Vec<_> = points.into_iter().map(|(speed, factor)| (speed.0, factor.get())).collect();
            model
                .friction_over_slip(&entry.id, &points)
                .map_err(|why| placed(document, &self.of_points(&path, &why), why))?;
        }
        let kind = if found.is_brake() { ElementKind::Brake } else { ElementKind::Clutch };
        Ok(Element {
            friction_area_m2: entry.friction_area.map(|one| one.0.si()),
            heat_capacity_j_per_k: entry.heat_capacity.map(|one| one.0.si()),
            conductance_w_per_k: conductance,
            ..Element::new(&entry.id, kind, links, Some(course))
        })
    }

    /// Adds a dog clutch, which has no friction.
    fn add_dog(
        &self,
        model: &mut Model,
        path: &Path,
        entry: &ElementEntry,
        dog: &DogEntry,
    ) -> Result<(), Error> {
        let document = self.document;
        for (key, is_given) in [
            ("friction_over_slip", entry.friction_over_slip.is_some()),
            ("static_ratio", entry.static_ratio.is_some()),
            ("friction_area", entry.friction_area.is_some()),
            ("heat_capacity", entry.heat_capacity.is_some()),
        ] {
            if is_given {
                return Err(refused(
                    document,
                    &path.clone().key(key),
                    &Named("dog-clutch", "a dog clutch has no friction: leave it out"),
                ));
            }
        }
        let times = |all: &[Quantity<Time>], is_engaged: bool| -> Vec<(Time, bool)> {
            all.iter().map(|time| (time.0, is_engaged)).collect()
        };
        let mut program = times(&dog.engage, true);
        program.extend(times(&dog.release, false));
        program.sort_by(|one, other| one.0.si().total_cmp(&other.0.si()));
        let path = path.clone().key("dog");
        model.shift_dog_clutch(&entry.id, &program, dog.largest_slip.map(|slip| slip.0)).map_err(|why| {
            let path =
                if matches!(why, motion::Error::Value { .. }) { path.key("largest_slip") } else { path };
            placed(document, &path, why)
        })
    }

    /// Torque capacity from a pressure: `μ·z·r_m·A·(p − p_kiss)`, with kinks where the pressure passes the
    /// kiss point.
    fn by_pressure(
        &self,
        path: &Path,
        entry: &PressureEntry,
    ) -> Result<Result<Course, motion::Error>, Error> {
        let points = entry.points(self.texts).map_err(|fault| self.of_table(path, fault))?;
        let positive = |key: &str, value: f64| {
            let refuse = || refused(self.document, &path.clone().key(key), &ABOVE_0);
            if value > 0.0 { Ok(value) } else { Err(refuse()) }
        };
        let not_negative = |key: &str, value: f64| {
            let refuse = || refused(self.document, &path.clone().key(key), &AT_LEAST_0);
            if value >= 0.0 { Ok(value) } else { Err(refuse()) }
        };
        let factor = positive("coefficient", entry.coefficient.get())?
            * positive("surfaces", f64::from(entry.surfaces))?
            * positive("mean_radius", entry.mean_radius.0.si())?
            * positive("piston_area", entry.piston_area.0.si())?;
        let kiss = not_negative("kiss_point", entry.kiss_point.map_or(0.0, |one| one.0.si()))?;
        let fill = not_negative("fill_time", entry.fill_time.map_or(0.0, |one| one.0.si()))?;
        if let Some(place) = points.iter().position(|(_, pressure)| pressure.si() < 0.0) {
            let message = format!("a pressure of {} Pa: it must be at least 0", points[place].1.si());
            let path = self.point(path, "pressures", place);
            return Err(refused(self.document, &path, &Named("negative", message)));
        }
        Ok(capacity(&points, fill, kiss, factor))
    }

    fn start(&self) -> Result<Start, Error> {
        let twists = self.file.shafts.iter().filter_map(|one| Some((one.id.as_str(), one.twist?.0)));
        let twists: Vec<(&str, Angle)> = twists.collect();
        let Some(start) = &self.file.start else { return Ok(Start::at_rest().twisted(&twists)) };
        let gearbox = &self.subject.train;
        let mut speeds: Vec<(&str, AngularVelocity)> = vec![];
        for (link, speed) in &start.speeds {
            speeds.push((link, speed.0));
        }
        if let Some(input) = start.input_speed {
            let path = root("start").key("input_speed");
            let Some(gear) = &self.file.gear else {
                let why = Named("no-gear", "it is the speed in a gear: give the key gear, too");
                return Err(refused(self.document, &path, &why));
            };
            let analysis =
                gearbox.analyze(gear).map_err(|why| refused(self.document, &root("gear"), &why))?;
            for link in gearbox.link_ids() {
                let name = gearbox.link_name(link);
                let is_given = start.speeds.contains_key(name) || name == GROUND;
                if let Some(speed) = analysis.speed(link).filter(|_| !is_given) {
                    speeds.push((name, input.0 * speed));
                }
            }
        }
        if speeds.is_empty() {
            let message = "give input_speed or speeds, or leave start out: then everything is at rest";
            return Err(refused(self.document, &root("start"), &Named("no-speeds", message)));
        }
        Ok(Start::speeds(&speeds).together(&self.on_shafts(start)).twisted(&twists))
    }

    /// Pairs of a body without a given speed and the other end of its first shaft, which turn together at the
    /// start.
    fn on_shafts(&self, start: &StartEntry) -> Vec<[&str; 2]> {
        let mut free: Vec<&String> =
            self.file.bodies.keys().filter(|body| !start.speeds.contains_key(*body)).collect();
        let mut pairs = vec![];
        for entry in &self.file.shafts {
            let [first, second] = &entry.links;
            for (body, other) in [(first, second), (second, first)] {
                if let Some(place) = free.iter().position(|one| *one == body) {
                    free.remove(place);
                    pairs.push([body.as_str(), other]);
                    break;
                }
            }
        }
        pairs
    }

    /// Sampling as fine as requested, and with at least [`INSTANTS`] instants.
    pub(super) fn sampling(&self) -> Result<Sampling, Error> {
        let duration = self.file.duration.0.si();
        if duration <= 0.0 {
            return Err(refused(self.document, &root("duration"), &ABOVE_0));
        }
        let path = root("sample_every");
        let every = self.file.sample_every.map_or(duration / 200.0, |every| every.0.si());
        if every <= 0.0 {
            return Err(refused(self.document, &path, &ABOVE_0));
        }
        let samples = duration / every;
        if samples > MOST_SAMPLES {
            let message = format!("{samples:.0} samples: at most {MOST_SAMPLES} are told");
            return Err(refused(self.document, &path, &Named("too-many-samples", message)));
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 2000")]
        let kept = (INSTANTS / samples).ceil().max(1.0) as usize;
        Ok(Sampling { inner: Time::from_si(every / kept as f64), kept })
    }
}

/// Path of the key of an entry that caused a fault.
fn named(path: Path, why: &motion::Error) -> Path {
    match why {
        motion::Error::Unknown { .. } => path.key("link"),
        motion::Error::Duplicate { .. } => path.key("id"),
        _ => path,
    }
}

/// Path of the key that caused a fault: the key of the law if its value is wrong, otherwise that of the
/// entry.
fn either(path: Path, law: Path, why: &motion::Error) -> Path {
    if matches!(why, motion::Error::Value { .. }) { law } else { named(path, why) }
}

/// Torque capacity that is 0 while the piston fills and below the kiss point, and above it proportional to
/// the pressure.
fn capacity(points: &[(Time, Pressure)], fill: f64, kiss: f64, factor: f64) -> Result<Course, motion::Error> {
    let plain: Vec<[f64; 2]> =
        points.iter().map(|(time, pressure)| [time.si(), pressure.si() - kiss]).collect();
    // Points out of order are refused with the numbers as given, before kinks are added.
    Course::table(&points.iter().map(|(time, _)| (*time, Torque::from_si(0.0))).collect::<Vec<_>>())?;
    let mut all: Vec<[f64; 2]> = vec![];
    for &[t, over] in &plain {
        if let Some(&[before, was]) = all.last()
            && was * over < 0.0
            && t > before
        {
            all.push([before + (t - before) * was / (was - over), 0.0]);
        }
        all.push([t, over]);
    }
    let filled = plain.first().map_or(0.0, |first| first[0] + fill);
    if fill > 0.0 {
        let at = |t: f64| {
            let after = all.partition_point(|point| point[0] <= t);
            match (after.checked_sub(1).map(|one| all[one]), all.get(after)) {
                (Some([from, value]), Some(next)) => {
                    value + (next[1] - value) * (t - from) / (next[0] - from)
                }
                (Some(last), None) => last[1],
                (None, _) => all.first().map_or(0.0, |first| first[1]),
            }
        };
        let then = at(filled);
        all.retain(|point| point[0] > filled);
        all.insert(0, [filled, then]);
        all.insert(0, [filled, 0.0]);
    }
    let torque = |over: f64| Torque::from_si(factor * over.max(0.0));
    Course::table(&all.iter().map(|&[t, over]| (Time::from_si(t), torque(over))).collect::<Vec<_>>())
}
