//! Sets with a bound below their cost, before they are sized.
//!
//! Each set is tried at every centre distance. Its flanks there give the volume of teeth that a torque needs, its
//! planets the bearings that fit: together a bound below its cost.
//!
//! Flanks bear more the larger the module and the faster they run, and the fewer turns they make. So the modules
//! are in bands, and the flanks of the largest module stand for the band. The least of several loads has the
//! greatest of their speeds with the fewest of their turns. Between two neighbouring centre distances the better
//! value of both counts. A little room is left for teeth that more planets make otherwise, and for values between
//! centre distances that are better than both; it is no proof, so the tests compare the bounds with sizes.

mod bearings;

use crate::factor::{Side, Symbol};
use crate::load::load_sharing;
use crate::sizing::practice::priced;
use crate::sizing::task::widened;
use crate::sizing::trial::Trial;
use crate::sizing::{
    Design, Layout, Objective, SetOverload, SetStep, SetTeeth, Sizing, Space, length, structure, with_rest,
};
use crate::tolerance::RIM;
use crate::{Error, Quantity};
use bearings::Bearings;
use epicyclic_gears::involute::practice::{of_face_load, orbit_acceleration, orbit_rule};
use epicyclic_gears::life::Rolling;
use epicyclic_judge::{Range, Rule, Severity};
use epicyclic_units::Physical;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::f64::consts::TAU;
use std::ops::{Add, ControlFlow};
use uom::si::f64::Length;

/// Room of the flanks, as a share of the safety.
const ROOM: f64 = 0.02;

/// Largest module of a band over its smallest, at most.
const BAND: f64 = 2.0;

/// Steps of the centre distance in a module, in a trial.
const STEPS: f64 = 8.0;

/// Face width over diameter of the smaller gear in a trial.
const PROPORTION: f64 = 0.8;

/// Radial force of the teeth against the centrifugal one over the tangential force, at most: half the
/// difference of the tangents of the working pressure angles.
const AGAINST_PULL: f64 = 0.1;

/// Cost of a set or of several; the fields count in their order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Cost {
    /// Sets beyond usual practice.
    pub(crate) unusual: f64,
    /// Mass with the price of the rules that are missed and of the length, kg.
    pub(crate) price: f64,
    /// Length along the axis, m.
    pub(crate) length: f64,
    /// Mass that the objective counts, kg.
    pub(crate) mass: f64,
    /// Mass of gears, carriers and housing, kg.
    pub(crate) whole: f64,
    /// Rules that are missed.
    pub(crate) missed: u32,
}

impl Cost {
    /// Cost of a set, by the mass that counts and that of gears and structure, and by its length with what a metre
    /// of it counts in kg.
    pub(crate) fn of(missed: u32, [mass, whole]: [f64; 2], [length, of_length]: [f64; 2]) -> Self {
        let [unusual, price] = priced(missed, mass);
        Self { unusual, price: price + of_length * length, length, mass, whole, missed }
    }
}

impl Cost {
    /// Cost of several sets with rules that they miss together.
    pub(crate) fn with_missed(self, missed: u32) -> Self {
        let [unusual, price] = priced(missed, self.price);
        Self { unusual: self.unusual + unusual, price, missed: self.missed + missed, ..self }
    }
}

impl Eq for Cost {}

impl Ord for Cost {
    fn cmp(&self, other: &Self) -> Ordering {
        self.unusual.total_cmp(&other.unusual).then(self.price.total_cmp(&other.price))
    }
}

impl PartialOrd for Cost {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            unusual: self.unusual + other.unusual,
            price: self.price + other.price,
            length: self.length + other.length,
            mass: self.mass + other.mass,
            whole: self.whole + other.whole,
            missed: self.missed + other.missed,
        }
    }
}

/// Set with the results of its trials.
#[derive(Debug, Clone)]
pub(crate) struct TriedSet {
    pub(crate) teeth: SetTeeth,
    /// Ratio of its teeth.
    pub(crate) ratio: f64,
    /// Numbers of planets that have equal angles, by their index.
    placed: Vec<bool>,
    /// Reference diameter of the smaller gear of the sun mesh, in modules.
    smaller: f64,
    /// Largest bore of the planets, in modules.
    bore: f64,
    /// Largest radius of the planets' centres, in modules.
    radius: f64,
    /// Least centrifugal force of a planet over its face width and the square of the carrier's speed, for a
    /// module of 1 m, kg.
    pull: f64,
    /// The set at each centre distance.
    tried: Vec<Tried>,
}

impl TriedSet {
    /// The set without the rules that its trials miss.
    pub(crate) fn unjudged(&self) -> Self {
        let tried = self.tried.iter().map(|tried| Tried { missed: 0, ..tried.clone() });
        Self { tried: tried.collect(), ..self.clone() }
    }

    /// Number of duties under which it was tried.
    pub(crate) fn duties(&self) -> usize {
        self.tried.first().and_then(|tried| tried.volumes.first()).map_or(0, Vec::len)
    }
}

/// Load of a set, as its bound sees it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load {
    /// Place of the duty, among those of the trial, without higher speeds and more turns.
    pub(crate) duty: usize,
    /// Greatest torque of the sun, N·m.
    pub(crate) torque: f64,
    /// Wear of the planets' bearings over the life, by the torque and by the centrifugal force.
    pub(crate) wear: [[f64; 4]; 2],
    /// Greatest speed of the carrier, rad/s.
    pub(crate) carrier_speed: f64,
}

/// A set at one centre distance, whatever the module.
#[derive(Debug, Clone)]
struct Tried {
    missed: u32,
    /// Volume `m²·b` that the flanks need for each N·m of `T·K_γ/N`, for each band of modules under each duty,
    /// m³/(N·m).
    volumes: Vec<Vec<f64>>,
    /// Cross-section of all gears times density over `m²`, for each number of planets, kg/m³.
    sections: Vec<f64>,
    /// Outside diameter of the ring, of a pair that of the larger gear, in modules.
    ring: f64,
    /// Radius of the planets' centres, in modules.
    radius: f64,
}

/// Number of planets and module of a set.
#[derive(Debug, Clone, Copy)]
struct Choice {
    planets: u32,
    module: Length,
    /// Index of the narrowest face width whose flanks may hold.
    width: usize,
    bound: Cost,
}

/// Materials, requirements and space of sizes, the same for all sets.
pub(crate) struct Sets<'a> {
    /// A set whose teeth, duty and overloads are not used.
    pub(crate) of_set: &'a Sizing,
    /// `K_γ/N` of each number of planets; `None` outside its table.
    shares: Vec<Option<f64>>,
    modules: Vec<Length>,
    /// Largest module of each band.
    bands: Vec<Length>,
    widths: Vec<Length>,
    bearings: Bearings,
    /// Accelerations of the planets that each kind of bearings usually bears, in g.
    accelerations: Vec<Range>,
}

impl<'a> Sets<'a> {
    pub(crate) fn new(of_set: &'a Sizing) -> Self {
        let space = &of_set.space;
        let method = &of_set.methods[0];
        let given = method.given.of(Side::First, Symbol::LoadSharing);
        let share = |planets: &u32| {
            let sharing = given.map_or_else(|| load_sharing(*planets, method.floating).ok(), Some)?;
            Some(sharing / f64::from(*planets))
        };
        let sorted = |lengths: &[Length]| {
            let mut all = lengths.to_vec();
            all.sort_by(|one, other| one.si().total_cmp(&other.si()));
            all
        };
        let modules = sorted(&space.modules);
        let mut bands: Vec<Length> = vec![];
        for module in modules.iter().rev() {
            if bands.last().is_none_or(|largest| *module * BAND < *largest) {
                bands.push(*module);
            }
        }
        Self {
            of_set,
            shares: space.planets.iter().map(share).collect(),
            modules,
            bands,
            widths: sorted(&space.face_widths),
            bearings: Bearings::new(&space.bearings, of_set.is_helical()),
            accelerations: accelerations(of_set),
        }
    }

    /// Load of a duty, by the first duty of the trial.
    pub(crate) fn load(&self, teeth: SetTeeth, duty: &[SetStep]) -> Load {
        let fastest = duty.iter().map(|step| step.carrier_speed.si().abs()).fold(0.0, f64::max);
        Load { duty: 0, torque: greatest(duty), wear: self.wear(teeth, duty), carrier_speed: fastest }
    }

    /// Wear of the bearings of a set's planets over a duty, by the torque and by the centrifugal force.
    fn wear(&self, teeth: SetTeeth, duty: &[SetStep]) -> [[f64; 4]; 2] {
        let SetTeeth::Simple([sun, planet, _]) = teeth else { return Default::default() };
        let millions = self.of_set.life.si() / TAU / 1e6 * sun.as_f64() / planet.as_f64();
        let torque = |step: &SetStep| step.sun_torque.si().abs();
        let square = |step: &SetStep| step.carrier_speed.si().powi(2);
        let forces: [&dyn Fn(&SetStep) -> f64; 2] = [&torque, &square];
        forces.map(|force| {
            let greatest = duty.iter().map(force).fold(0.0, f64::max);
            if greatest == 0.0 {
                return [0.0; 4];
            }
            self.bearings.wear(
                &duty
                    .iter()
                    .map(|step| (step.share * step.sun_speed.si().abs() * millions, force(step) / greatest)),
            )
        })
    }

    /// Tries a set under several duties; `None` if its teeth have no room for one another, whatever the size.
    pub(crate) fn tried(
        &self,
        teeth: SetTeeth,
        duties: Vec<Vec<SetStep>>,
    ) -> Result<Option<TriedSet>, Error> {
        let ratio = teeth.ratio();
        let of_set = self.of_set;
        let helix = of_set.profiles.shared().helix_angle.si();
        let smaller = teeth.gears()[0].min(teeth.gears()[1]).as_f64() / libm::cos(helix);
        let planets = &of_set.space.planets;
        let is_placed = |planets: u32| of_set.assembles(teeth, planets);
        let first = planets.iter().zip(&self.shares).filter(|(of, share)| share.is_some() && is_placed(**of));
        let Some((first, Some(share))) = first.min_by_key(|(of, _)| **of) else { return Ok(None) };
        let largest = *self.bands.first().ok_or(Error::NothingToSearch { quantity: Quantity::Module })?;
        // Steps meet the ends of the reach of spur teeth; one more covers those of helical teeth.
        let beyond = if helix == 0.0 { 0.0 } else { 1.0 / STEPS };
        let space = Space {
            modules: vec![largest],
            planets: vec![*first],
            centre_distance_step: largest / STEPS,
            reach: of_set.space.reach + beyond,
            largest_ring: None,
            ..of_set.space.clone()
        };
        let duties: Vec<Vec<SetStep>> = duties.into_iter().map(with_rest).collect();
        let sizing = Sizing { teeth, duty: duties[0].clone(), overloads: vec![], space, ..of_set.clone() };
        let sizes: Vec<[Length; 2]> =
            self.bands.iter().map(|module| [*module, *module * (PROPORTION * smaller)]).collect();
        let square = largest.si() * largest.si();
        let tried = |trial: Trial| {
            let of_band = |([module, face], flanks): (&[Length; 2], &Vec<f64>)| {
                let volume = |(duty, safety): (&Vec<SetStep>, &f64)| {
                    let needed = of_set.required_contact / (safety * (1.0 + ROOM));
                    module.si() * module.si() * face.si() * needed * needed / (greatest(duty) * share)
                };
                duties.iter().zip(flanks).map(volume).collect()
            };
            Tried {
                missed: trial.missed(),
                volumes: sizes.iter().zip(&trial.flanks).map(of_band).collect(),
                sections: trial.sections.iter().map(|section| section / square).collect(),
                ring: (trial.ring / largest).si(),
                radius: (trial.radius / largest).si(),
            }
        };
        let trials = sizing.trials(&sizes, &duties, planets)?;
        let greatest_of = |of: fn(&Trial) -> Length| {
            trials.iter().map(|trial| (of(trial) / largest).si()).fold(0.0, f64::max)
        };
        // It moves the roots of the planets by its double at most.
        let bore = greatest_of(|trial| trial.bore) + 2.0 * beyond;
        let radius = greatest_of(|trial| trial.radius) + beyond;
        let pull = |trial: &Trial| trial.planet * trial.radius.si() / (square * largest.si());
        // Planets of a stated mass are not those of the trial.
        let least = if of_set.planet_mass.is_some() { 0.0 } else { f64::INFINITY };
        let pull = trials.iter().map(pull).fold(least, f64::min);
        let tried: Vec<Tried> = trials.into_iter().map(tried).collect();
        let placed = planets.iter().map(|planets| is_placed(*planets)).collect();
        Ok((!tried.is_empty()).then_some(TriedSet {
            teeth,
            ratio,
            placed,
            smaller,
            bore,
            radius,
            pull,
            tried,
        }))
    }

    /// Every number of planets that a set may have, by its index, with every module.
    fn places(&self, set: &TriedSet) -> impl Iterator<Item = (usize, Length)> {
        let is_placed = |place: &usize| set.placed[*place] && self.shares[*place].is_some();
        let planets = (0..set.placed.len()).filter(is_placed);
        planets.flat_map(|place| self.modules.iter().map(move |module| (place, *module)))
    }

    /// The choice with the least bound of a number of planets and a module; `None` if nothing can hold under the
    /// load, and where no bound would be below a known one.
    fn choice(
        &self,
        set: &TriedSet,
        load: Load,
        (place, module): (usize, Length),
        known: Option<Cost>,
    ) -> Option<Choice> {
        let share = self.shares[place]?;
        // Torque of the sun over which that of the carrier is; a pair has none.
        let of_carrier = if set.teeth.is_pair() { 0.0 } else { set.ratio };
        let band = self.bands.partition_point(|largest| *largest >= module) - 1;
        let force = load.torque * share * of_carrier / (set.radius * module.si());
        let least = self.width_of_bearings(set, (module, band), (force, share), load)?;
        let mut best: Option<(Cost, usize)> = None;
        for tried in &set.tried {
            let volume = tried.volumes[band][load.duty] * load.torque * share;
            let acceleration = orbit_acceleration(tried.radius * module.si(), load.carrier_speed);
            let missed = self.of_orbit(acceleration);
            let known = best.map(|(cost, _)| cost).into_iter().chain(known).min();
            let own = self.at(set, tried, (place, module, missed), [volume, least], known);
            best = best.into_iter().chain(own).min();
        }
        let (bound, width) = best?;
        Some(Choice { planets: self.of_set.space.planets[place], module, width, bound })
    }

    /// Width of the narrowest bearing that may live long enough under a force of the teeth and the pull of
    /// the planets: these are as wide as bearings and flanks need. Of plain bearings the pull is left out.
    fn width_of_bearings(
        &self,
        set: &TriedSet,
        (module, band): (Length, usize),
        (force, share): (f64, f64),
        load: Load,
    ) -> Option<f64> {
        let (module, [of_torque, of_pull]) = (module.si(), load.wear);
        let bore = set.bore * module;
        let volumes = set.tried.iter().map(|tried| tried.volumes[band][load.duty]);
        let face = volumes.fold(f64::INFINITY, f64::min) * load.torque * share / (module * module);
        let rolling = || {
            let mut least = self.bearings.width(bore, force, of_torque)?;
            loop {
                let pull = set.pull * module.powi(3) * least.max(face) * load.carrier_speed.powi(2);
                let wider = self.bearings.width(bore, (pull - AGAINST_PULL * force).max(0.0), of_pull)?;
                if wider <= least {
                    return Some(least);
                }
                // Wider planets are heavier.
                least = wider;
            }
        };
        rolling().into_iter().chain(self.bearings.plain_width(bore, force)).reduce(f64::min)
    }

    /// Bound and narrowest face width of a set at a centre distance whose flanks need a volume, and whose
    /// bearings a width; `None` if it cannot hold, and where it would not be below a known bound.
    fn at(
        &self,
        set: &TriedSet,
        tried: &Tried,
        (planets, module, missed): (usize, Length, u32),
        [volume, least]: [f64; 2],
        known: Option<Cost>,
    ) -> Option<(Cost, usize)> {
        let largest = self.of_set.space.largest_ring;
        if largest.is_some_and(|largest| module * tried.ring > largest * (1.0 + RIM)) {
            return None;
        }
        let module = module.si();
        let flanks = volume / (module * module);
        let first = self.widths.partition_point(|width| width.si() < least.max(flanks));
        let holds = |width: &usize| {
            let width = self.widths[*width].si();
            width >= flanks * self.wider_load(width / (module * set.smaller))
        };
        let width = (first..self.widths.len()).find(holds)?;
        let face = self.widths.get(width)?.si();
        let gears = tried.sections[planets] * module * module * face;
        let ring = tried.ring * module;
        let masses = self.of_set.objective.masses(gears, structure(ring, face));
        let cost = |missed| Cost::of(missed, masses, [length(ring, face), self.of_set.space.length_price]);
        let missed = tried.missed + missed;
        // Most are too heavy, whatever the rules say of their width.
        if known.is_some_and(|known| known < cost(missed)) {
            return None;
        }
        let missed = missed + self.of_width(face / (module * set.smaller))?;
        Some((cost(missed), width))
    }

    /// Whether planets miss the rules of their orbit on every kind of bearings.
    fn of_orbit(&self, acceleration: f64) -> u32 {
        u32::from(!self.accelerations.iter().any(|range| range.contains(acceleration)))
    }

    /// `K_Hβ` that is given.
    fn face_load(&self) -> Option<f64> {
        self.of_set.methods[0].given.of(Side::First, Symbol::FaceContact)
    }

    /// `K_Hβ` of a face width over the diameter of the smaller gear, over the given one.
    fn wider_load(&self, ratio: f64) -> f64 {
        let given = self.face_load().filter(|_| self.of_set.widens_face_load);
        given.map_or(1.0, |given| widened(given, ratio) / given)
    }

    /// Rules missed by a face that is too wide; `None` if practice refuses it. A face that is too narrow may
    /// become wider.
    fn of_width(&self, ratio: f64) -> Option<u32> {
        let Some(limits) = &self.of_set.practice else { return Some(0) };
        let given = self.face_load().filter(|_| !self.of_set.widens_face_load);
        let of_load = given.map(|given| of_face_load(limits, ratio, given).severity);
        let of_width = limits.judge(Rule::FaceWidth, ratio);
        let of_width = Some(of_width).filter(|of| of.value > of.limit);
        let missed = [of_width.and_then(|of| of.severity), of_load.flatten()];
        let missed = missed.map(|severity| severity >= Some(Severity::Warning));
        let is_refused =
            of_width.is_some_and(|of| of.severity == Some(Severity::Error) || of.is_against_stated);
        (!is_refused).then(|| missed.into_iter().map(u32::from).sum())
    }

    /// The bound below the cost of a set under a load; `None` if nothing can hold.
    pub(crate) fn bound(&self, set: &TriedSet, load: Load) -> Option<Cost> {
        let least = |known: Option<Cost>, place| {
            let own = self.choice(set, load, place, known).map(|choice| choice.bound);
            known.into_iter().chain(own).min()
        };
        self.places(set).fold(None, least)
    }

    /// Sizes a set for a duty and overloads whose bound is that of a load; `None` if nothing holds. If they are
    /// the least of many, the cost is a bound below that of each.
    pub(crate) fn size(
        &self,
        set: &TriedSet,
        (load, is_least): (Load, bool),
        (duty, overloads): (Vec<SetStep>, Vec<SetOverload>),
        known: &mut Geometries,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Option<Cost>, Error> {
        use Rule::{BearingLeastLoad, FullPinSpeed, HelicalSpeed, OilFilm, PinSpeed, SpurSpeed};
        let mut practice = self.of_set.practice.clone();
        if let Some(limits) = practice.as_mut().filter(|_| is_least) {
            // More load may hold what the least load misses, and less speed what the greatest misses.
            for rule in [BearingLeastLoad, SpurSpeed, HelicalSpeed, PinSpeed, FullPinSpeed, OilFilm] {
                limits.state(rule, Range::OPEN);
            }
        }
        let choices = self.places(set).filter_map(|place| self.choice(set, load, place, None));
        let mut choices: Vec<Choice> = choices.collect();
        choices.sort_by_key(|choice| choice.bound);
        let of_set = self.of_set;
        let duty = with_rest(duty);
        let mut sizing = Sizing { teeth: set.teeth, duty, overloads, practice, ..of_set.clone() };
        let mut best: Option<Cost> = None;
        for choice in choices {
            // The others have no lower bound.
            if best.is_some_and(|best| best <= choice.bound) {
                break;
            }
            sizing.space.modules = vec![choice.module];
            sizing.space.planets = vec![choice.planets];
            sizing.space.face_widths = self.widths[choice.width..].to_vec();
            let key = (set.teeth, choice.planets, choice.module.si().to_bits());
            let geometries = match known.entry(key) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(place) => place.insert(sizing.geometries(goes_on)?),
            };
            let cost = |design: Design| {
                let masses = of_set.objective.masses(design.mass.si(), design.structure.si());
                let length = [design.length.si(), of_set.space.length_price];
                Cost::of(design.rules_missed, masses, length)
            };
            best = sizing.best_of(geometries, goes_on)?.map(cost).into_iter().chain(best).min();
        }
        Ok(best)
    }
}

/// Accelerations that each kind of bearings usually bears; any where practice does not count.
fn accelerations(of_set: &Sizing) -> Vec<Range> {
    let Some(limits) = &of_set.practice else { return vec![Range::OPEN] };
    let bearings = &of_set.space.bearings;
    let alone = bearings.is_empty().then_some(of_set.planet_pin.rolling);
    let mut kinds: Vec<Rolling> = vec![];
    for rolling in bearings.iter().map(|bearing| bearing.rolling).chain(alone) {
        if !kinds.contains(&rolling) {
            kinds.push(rolling);
        }
    }
    let range = |rolling| orbit_rule(rolling).map_or(Range::OPEN, |rule| limits.bounds(rule).required());
    kinds.into_iter().map(range).collect()
}

/// Greatest torque of a duty, N·m.
pub(crate) fn greatest(duty: &[SetStep]) -> f64 {
    duty.iter().map(|step| step.sun_torque.si().abs()).fold(0.0, f64::max)
}

/// Layouts by teeth, number of planets and module, in bits.
pub(crate) type Geometries = HashMap<(SetTeeth, u32, u64), Vec<Layout>>;

impl Objective {
    /// Mass that counts, of the ring, which does not add up over sets, that of the gears; and mass of gears and
    /// structure.
    fn masses(self, gears: f64, structure: f64) -> [f64; 2] {
        let whole = gears + structure;
        match self {
            Self::Mass | Self::Ring => [gears, whole],
            Self::Whole => [whole; 2],
        }
    }
}
