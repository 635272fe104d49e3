//! A stage of a train: its loads, the bound below its mass, its size.

use super::Order;
use super::bearings::Bearings;
use crate::factor::{Side, Symbol};
use crate::load::load_sharing;
use crate::sizing::practice::priced;
use crate::sizing::trial::Trial;
use crate::sizing::{Design, Layout, Objective, SetOverload, SetStep, Sizing, Space, structure};
use crate::tolerance::RIM;
use crate::{Error, Quantity};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::practice::of_face_load;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_judge::{Rule, Severity};
use epicyclic_units::Physical;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::ops::{Add, ControlFlow};
use uom::si::f64::Length;

/// Room for the factors of the flanks that change with the size, as a share of the safety.
const ROOM: f64 = 0.1;

/// Steps of the centre distance in a module, in a trial.
const STEPS: f64 = 8.0;

/// Face width over diameter of the smaller gear in a trial.
const PROPORTION: f64 = 0.8;

/// Load of the flanks in N/m² by which a trial gets its module.
const LOAD: f64 = 5e6;

/// Quotient of neighbouring speeds for which flanks are tried.
const BETWEEN_SPEEDS: f64 = 4.0;

/// Cost of a stage or a train; the fields count in their order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Cost {
    /// Stages beyond usual practice.
    pub(super) unusual: f64,
    /// Mass with the price of the rules that are missed, kg.
    pub(super) price: f64,
    /// Mass that the objective counts, kg.
    pub(super) mass: f64,
    /// Rules that are missed.
    pub(super) missed: u32,
}

impl Cost {
    fn of(missed: u32, mass: f64) -> Self {
        let [unusual, price] = priced(missed, mass);
        Self { unusual, price, mass, missed }
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
            mass: self.mass + other.mass,
            missed: self.missed + other.missed,
        }
    }
}

/// Set with the results of its trials.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    pub(super) teeth: [ToothCount; 3],
    /// `1 + z_r/z_s`
    pub(super) ratio: f64,
    /// Numbers of planets that have equal angles, by their index.
    placed: Vec<bool>,
    /// Teeth of the smaller gear of the sun mesh.
    smaller: f64,
    /// Largest bore of the planets, in modules.
    bore: f64,
    /// Largest radius of the planets' centres, in modules.
    radius: f64,
    /// The set at each centre distance.
    tried: Vec<Tried>,
}

/// A set at one centre distance, whatever the module.
#[derive(Debug, Clone)]
struct Tried {
    missed: u32,
    /// Volume `m²·b` that the flanks need for each N·m of `T·K_γ/N`, at each speed, m³/(N·m).
    volumes: Vec<f64>,
    /// Cross-section of all gears times density over `m²`, for each number of planets, kg/m³.
    sections: Vec<f64>,
    /// Outside diameter of the ring, in modules.
    ring: f64,
}

/// Number of planets and module of a stage.
#[derive(Debug, Clone, Copy)]
struct Choice {
    planets: u32,
    module: Length,
    /// Index of the narrowest face width whose flanks may hold.
    width: usize,
    bound: Cost,
}

/// The order as its stages see it.
pub(super) struct Stages<'a> {
    pub(super) order: &'a Order,
    /// Greatest torque of the duty, N·m.
    torque: f64,
    /// `K_γ/N` of each number of planets; `None` outside its table.
    shares: Vec<Option<f64>>,
    modules: Vec<Length>,
    widths: Vec<Length>,
    bearings: Bearings,
    /// Products of the ratios before a stage for which flanks are tried, ascending.
    products: Vec<f64>,
}

impl<'a> Stages<'a> {
    pub(super) fn new(order: &'a Order) -> Self {
        let space = &order.of_stage.space;
        let method = &order.of_stage.methods[0];
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
        let most = *order.ratio.end();
        let speeds = std::iter::successors(Some(1.0), |product| {
            Some(product * BETWEEN_SPEEDS).filter(|_| *product < most)
        });
        Self {
            order,
            torque: order.duty.iter().map(|step| step.torque.si().abs()).fold(0.0, f64::max),
            shares: space.planets.iter().map(share).collect(),
            modules: sorted(&space.modules),
            widths: sorted(&space.face_widths),
            bearings: Bearings::new(order),
            products: speeds.collect(),
        }
    }

    /// Loads of a set with the least torque and the least speed of a range of products of ratios before it.
    fn loads(&self, ratio: f64, [least, most]: [f64; 2]) -> (Vec<SetStep>, Vec<SetOverload>) {
        let step = |step: &super::InputStep| {
            let speed = step.speed / most;
            SetStep {
                share: step.share,
                sun_torque: step.torque * least,
                sun_speed: speed * (1.0 - 1.0 / ratio),
                carrier_speed: speed / ratio,
            }
        };
        let overload = |one: &SetOverload| SetOverload { sun_torque: one.sun_torque * least, ..*one };
        let of_stage = &self.order.of_stage;
        (self.order.duty.iter().map(step).collect(), of_stage.overloads.iter().map(overload).collect())
    }

    /// Tries a set; `None` if its teeth have no room for one another, whatever the size.
    pub(super) fn stage(&self, teeth: [ToothCount; 3]) -> Result<Option<Stage>, Error> {
        let [sun, planet, ring] = teeth;
        let ratio = 1.0 + ring.as_f64() / sun.as_f64();
        let smaller = sun.min(planet).as_f64();
        let of_stage = &self.order.of_stage;
        let planets = &of_stage.space.planets;
        let is_placed = |planets: u32| {
            of_stage.least_planet_angle.is_some()
                || PlanetSpacing::least_unequal(sun, ring, planets).is_equal()
        };
        let first = planets.iter().zip(&self.shares).filter(|(of, share)| share.is_some() && is_placed(**of));
        let Some((first, Some(share))) = first.min_by_key(|(of, _)| **of) else { return Ok(None) };
        // A torque in the middle of those that the stage may have.
        let middling = self.torque * libm::sqrt(self.order.ratio.end() / ratio).max(1.0) * share;
        let diameter = libm::cbrt(2.0 * middling / (PROPORTION * LOAD));
        let off = |module: &&Length| libm::log(module.si() * smaller / diameter).abs();
        let module = self.modules.iter().min_by(|one, other| off(one).total_cmp(&off(other)));
        let module = *module.ok_or(Error::NothingToSearch { quantity: Quantity::Module })?;
        let face = module * (PROPORTION * smaller);
        let space = Space {
            modules: vec![module],
            planets: vec![*first],
            centre_distance_step: module / STEPS,
            largest_ring: None,
            ..of_stage.space.clone()
        };
        let duties: Vec<Vec<SetStep>> =
            self.products.iter().map(|product| self.loads(ratio, [*product; 2]).0).collect();
        let sizing = Sizing { teeth, duty: duties[0].clone(), overloads: vec![], space, ..of_stage.clone() };
        let square = module.si() * module.si();
        let tried = |trial: Trial| {
            let volume = |(product, safety): (&f64, &f64)| {
                let needed = of_stage.required_contact / (safety * (1.0 + ROOM));
                square * face.si() * needed * needed / (self.torque * product * share)
            };
            Tried {
                missed: trial.missed,
                volumes: self.products.iter().zip(&trial.flanks).map(volume).collect(),
                sections: trial.sections.iter().map(|section| section / square).collect(),
                ring: (trial.ring / module).si(),
            }
        };
        let trials = sizing.trials(face, &duties, planets)?;
        let largest = |of: fn(&Trial) -> Length| {
            trials.iter().map(|trial| (of(trial) / module).si()).fold(0.0, f64::max)
        };
        let (bore, radius) = (largest(|trial| trial.bore), largest(|trial| trial.radius));
        let tried: Vec<Tried> = trials.into_iter().map(tried).collect();
        let placed = planets.iter().map(|planets| is_placed(*planets)).collect();
        Ok((!tried.is_empty()).then_some(Stage { teeth, ratio, placed, smaller, bore, radius, tried }))
    }

    /// Every number of planets and module that may hold where the product of the ratios before the stage
    /// lies in a range.
    fn choices<'s>(&'s self, stage: &'s Stage, [least, most]: [f64; 2]) -> impl Iterator<Item = Choice> + 's {
        // Fewer cycles bear more.
        let speed = self.products.partition_point(|product| *product < most).min(self.products.len() - 1);
        let torque = self.torque * least;
        let planets =
            self.order.of_stage.space.planets.iter().zip(&self.shares).zip(&stage.placed).enumerate();
        let planets = planets.filter_map(|(place, ((planets, share), placed))| {
            Some((place, *planets, (*share)?)).filter(|_| *placed)
        });
        let [sun, planet, ring] = stage.teeth.map(ToothCount::as_f64);
        let turns = (1.0 - 1.0 / stage.ratio) * sun / (planet * most);
        let wear = self.bearings.wear(turns);
        planets.flat_map(move |(place, planets, share)| {
            self.modules.iter().filter_map(move |module| {
                let force = torque * share * (sun + ring) / (stage.radius * module.si() * sun);
                let least = self.bearings.width(stage.bore * module.si(), force, wear)?;
                let tried = stage.tried.iter().filter_map(|tried| {
                    self.at(stage, tried, (place, *module), [tried.volumes[speed] * torque * share, least])
                });
                let (bound, width) = tried.min()?;
                Some(Choice { planets, module: *module, width, bound })
            })
        })
    }

    /// Bound and narrowest face width of a set at a centre distance whose flanks need a volume, and whose
    /// bearings a width.
    fn at(
        &self,
        stage: &Stage,
        tried: &Tried,
        (planets, module): (usize, Length),
        [volume, least]: [f64; 2],
    ) -> Option<(Cost, usize)> {
        let largest = self.order.of_stage.space.largest_ring;
        if largest.is_some_and(|largest| module * tried.ring > largest * (1.0 + RIM)) {
            return None;
        }
        let module = module.si();
        let width = self.widths.partition_point(|width| width.si() < least.max(volume / (module * module)));
        let face = self.widths.get(width)?.si();
        let missed = tried.missed + self.of_width(face / (module * stage.smaller))?;
        let gears = tried.sections[planets] * module * module * face;
        let mass = self.order.of_stage.objective.mass(gears, structure(tried.ring * module, face));
        Some((Cost::of(missed, mass), width))
    }

    /// Rules missed by a face that is too wide; `None` if practice refuses it. A face that is too narrow may
    /// become wider.
    fn of_width(&self, ratio: f64) -> Option<u32> {
        let Some(limits) = &self.order.of_stage.practice else { return Some(0) };
        let given = self.order.of_stage.methods[0].given.of(Side::First, Symbol::FaceContact);
        let of_load = given.map(|given| of_face_load(limits, ratio, given).severity);
        let of_width = limits.judge(Rule::FaceWidth, ratio);
        let of_width = of_width.severity.filter(|_| of_width.value > of_width.limit);
        let missed = [of_width, of_load.flatten()].map(|severity| severity >= Some(Severity::Warning));
        (of_width != Some(Severity::Error)).then(|| missed.into_iter().map(u32::from).sum())
    }

    /// The bound below the cost of a stage where the product of the ratios before it lies in a range; `None`
    /// if nothing can hold.
    pub(super) fn bound(&self, stage: &Stage, before: [f64; 2]) -> Option<Cost> {
        self.choices(stage, before).map(|choice| choice.bound).min()
    }

    /// Sizes a stage for the least torque and the fewest turns behind products of ratios in a range; `None`
    /// if nothing holds.
    pub(super) fn size(
        &self,
        stage: &Stage,
        before: [f64; 2],
        known: &mut Geometries,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Option<Cost>, Error> {
        let mut choices: Vec<Choice> = self.choices(stage, before).collect();
        choices.sort_by_key(|choice| choice.bound);
        let (duty, overloads) = self.loads(stage.ratio, before);
        let of_stage = &self.order.of_stage;
        let mut sizing = Sizing { teeth: stage.teeth, duty, overloads, ..of_stage.clone() };
        let mut best: Option<Cost> = None;
        for choice in choices {
            if best.is_some_and(|best| best <= choice.bound) {
                break;
            }
            sizing.space.modules = vec![choice.module];
            sizing.space.planets = vec![choice.planets];
            sizing.space.face_widths = self.widths[choice.width..].to_vec();
            let key = (stage.teeth, choice.planets, choice.module.si().to_bits());
            let geometries = match known.entry(key) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(place) => place.insert(sizing.geometries(goes_on)?),
            };
            let cost = |design: Design| {
                let mass = of_stage.objective.mass(design.mass.si(), design.structure.si());
                Cost::of(design.rules_missed, mass)
            };
            best = sizing.best_of(geometries, goes_on)?.map(cost).into_iter().chain(best).min();
        }
        Ok(best)
    }
}

/// Layouts by teeth, number of planets and module, in bits.
pub(super) type Geometries = HashMap<([ToothCount; 3], u32, u64), Vec<Layout>>;

impl Objective {
    /// Mass that counts; of the ring, which does not add up over stages, that of the gears.
    fn mass(self, gears: f64, structure: f64) -> f64 {
        match self {
            Self::Mass | Self::Ring => gears,
            Self::Whole => gears + structure,
        }
    }
}
