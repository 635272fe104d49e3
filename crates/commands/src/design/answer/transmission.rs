//! Gearboxes for a list of gears: structures, tooth numbers and sizes.
//!
//! Structures are those of [`synthesize`](crate::synthesize), from the fewest sets and shift elements up: at
//! first with members on shafts alone, then with members on the housing and double-planet sets. The best
//! structures of the first families get tooth numbers: of simple sets the lightest, chosen together with the
//! sizes by [`lightest`]; the gears get sizes that hold over the duty. Of the gearboxes with sizes the one
//! with the fewest warnings is taken, then the lightest. Where none keeps the limit of the whole mass, the next
//! structures follow.

use super::assumed::{AssumedLoad, assumed};
use super::front::{front, largest_ring};
use super::larger::Compared;
use super::limits::OrderLimits;
use super::loaded;
use super::making::{Load, MAKING, for_each_set, shared, warnings, with_duty};
use super::masses::Masses;
use super::records::SizesStep;
use super::transmission_records::{GearReached, GearboxOfRing, GearboxWithTeeth};
use super::ways_out::{RelaxedLimit, WayOut};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::basis::{Basis, BasisKey};
use crate::shared::gearbox::{Choice, Gearbox as Subject, one};
use crate::shared::records::Fraction;
use crate::shared::saved::names;
use crate::size::answer::{self as size, Size, sizing_of};
use crate::size::options::Request as SizeRequest;
use crate::strength::answer::missing::{MissingKeys, Purpose};
use crate::synthesize::answer::teeth::{TeethOfSet, TeethOfSets, TeethWanted};
use crate::synthesize::answer::{
    Gear as SearchedGear, Kept, Searching, Solution, Wanted as Search, saved, solve,
};
use epicyclic_formats::wanted_ratio::{Wanted as Ratio, WantedRatio};
use epicyclic_formats::yaml::to_string;
use epicyclic_formats::{Document, gearbox::written};
use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_strength::lightest::{Gearbox, Wanted as Searched, lightest};
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::limits::Limits;
use epicyclic_synthesis::rank::Objective;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::shifts::Shifts;
use epicyclic_synthesis::teeth::{Aim, Alike};
use epicyclic_synthesis::usable::Usable;
use epicyclic_train::Gear;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::{AngularVelocity, Torque};

/// Structures that get tooth numbers, the best of their families.
const STRUCTURES: usize = 3;

/// Structures that get tooth numbers at most, in their order, until one keeps the limit of the whole mass.
const STRUCTURES_WITHIN: usize = 12;

/// Tooth numbers of a structure that get sizes.
const TEETH: usize = 2;

/// Tooth numbers of a structure with double-planet sets that get sizes at most, until one keeps the limit of the
/// whole mass.
const TEETH_WITHIN: usize = 6;

/// Tooth numbers of a structure that these are taken from, those nearest to the ratios.
pub(crate) const NEAREST: usize = 60;

/// Teeth of planets that leave room for their bearings at a usual module.
const PLANET: f64 = 32.0;

/// Order for a list of gears.
#[derive(Debug, Clone)]
pub struct WantedTransmission {
    /// Ratio of each gear, input speed over output speed; below 0 of reverse.
    pub ratios: Vec<f64>,
    /// Allowed relative deviation of a ratio.
    pub tolerance: f64,
    /// Bounds of tooth numbers and numbers of planets.
    pub bounds: Bounds,
    /// Ring over sun of simple sets.
    pub k: RangeInclusive<f64>,
    /// Limits of speeds and slips over the input's speed.
    pub limits: Limits,
    /// Limits of efficiency and circulating power.
    pub usable: Usable,
    /// Efficiency of each set with its carrier fixed.
    pub efficiency: MeshEfficiency,
    /// Speed of the input.
    pub speed: AngularVelocity,
    /// Torque on the input in every gear.
    pub torque: Torque,
    /// Shares of the time of the gears; empty for equal shares.
    pub shares: Vec<f64>,
    /// Greatest torque during the life over the nominal torque.
    pub overload: Option<f64>,
    /// Steps of the duty in each gear: share of its time, torque and speed over these.
    pub spectrum: Vec<[f64; 3]>,
    /// Limits of the whole gearbox.
    pub order: OrderLimits,
    /// Whether gearboxes with smaller rings are asked for.
    pub is_front_asked: bool,
    /// Materials, factors, oil and life.
    pub basis: Basis,
    /// Search space of sizes.
    pub size: SizeRequest,
}

/// Gearbox for a list of gears, with sufficient strength.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Transmission {
    /// Gears, required and reached.
    pub gears: Vec<GearReached>,
    /// Allowed relative deviation of a ratio.
    pub tolerance: f64,
    /// Speed of the input in rad/s.
    pub input_speed_rad_s: f64,
    /// Structures found, of the fewest sets and shift elements that give any.
    pub structures: usize,
    /// Gearboxes with tooth numbers, the one taken first.
    pub gearboxes: Vec<GearboxWithTeeth>,
    /// Assumed values by key.
    pub basis: Vec<BasisKey>,
    /// Assumptions that are no keys of the file.
    pub assumed: Vec<BasisKey>,
    /// Limits of the whole gearbox, and what exceeds them.
    pub limits: OrderLimits,
    /// Masses of the whole and of its parts; null if a set has no size.
    pub masses: Option<Masses>,
    /// Sizes of the gearbox taken, with their strength over the duty; null if no structure was found.
    pub sizes: Option<SizesStep>,
    /// Limits to relax for a scheme of the catalogue, each with the gearbox that is then found; empty for a
    /// list of gears.
    pub ways_out: Vec<WayOut>,
    /// Gearboxes with smaller and smaller rings, each the best that its limit of the rings leaves; null if not asked
    /// for, or without a gearbox.
    pub front: Option<Vec<GearboxOfRing>>,
    /// Gearbox file with sizes; null if a set has none.
    pub file: Option<String>,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

impl Answer for Transmission {
    const NAME: &'static str = "design-transmission";
}

/// Class of structures: numbers of sets, of shift elements engaged, and of double-planet sets.
type Class = (Kind, usize, [RangeInclusive<usize>; 2]);

/// Classes in their order. Larger ones take hours.
const CLASSES: [Class; 6] = [
    (Kind::Core, 1, [1..=3, 0..=1]),
    (Kind::AllSparse, 1, [1..=2, 0..=1]),
    (Kind::Core, 2, [1..=3, 0..=0]),
    (Kind::AllSparse, 2, [1..=2, 0..=1]),
    (Kind::Core, 3, [1..=3, 0..=0]),
    (Kind::AllSparse, 3, [2..=2, 0..=1]),
];

/// Shift elements at most.
const MOST_ELEMENTS: usize = 5;

/// Ring over sun of simple sets unless others are asked for. Below, planets are too small for their bearings.
pub(crate) const K: RangeInclusive<f64> = 1.8..=4.5;

/// Ring over sun of double-planet sets.
const K_DOUBLE: RangeInclusive<f64> = 1.8..=4.5;

/// Gearbox with sizes.
struct Sized {
    of: GearboxWithTeeth,
    gears: Vec<GearReached>,
    document: Document,
    size: Size,
    /// Mass of the whole if it is above its limit, in kg; or else 0.
    above_kg: f64,
}

/// Designs a gearbox for a list of gears. `goes_on` is called now and then, and may end the search.
///
/// # Errors
/// [`Error::Shares`] unless there is one share per gear; [`Error::Synthesis`] for ratios that cannot be;
/// errors of [`size`](SizeRequest::answer), which refer to the unfinished gearbox.
pub fn answer(
    wanted: &WantedTransmission,
    goes_on: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Transmission, Error> {
    // Shares that cannot be are refused before the search.
    let gears = names(&wanted.ratios);
    shared(gears.iter().map(String::as_str).collect(), &wanted.shares)?;
    let (count, found) = structures(wanted, goes_on)?;
    let found: Vec<&(Solution, Kept)> = found.iter().collect();
    let with = |size: SizeRequest, found: &[&(Solution, Kept)]| {
        let own = WantedTransmission { size, ..wanted.clone() };
        of_structures(&own, (count, found), goes_on)
    };
    let (mut best, mut taken_size) = (with(wanted.size.clone(), &found)?, wanted.size.clone());
    let compared = |of: &Transmission| {
        let missed = of.gearboxes.first().and_then(|best| u32::try_from(best.warnings).ok());
        Compared::new(missed, of.masses, &of.warnings)
    };
    let usual = compared(&best);
    let is_open = !best.gearboxes.is_empty() && usual.is_open();
    if let Some(size) = wanted.size.larger().filter(|_| is_open) {
        // Other sizes of a gearbox that holds; those of all structures take longest.
        let taken = best.gearboxes.first().filter(|_| best.file.is_some());
        let is_taken = |(of, _): &&&(Solution, Kept)| {
            taken.is_none_or(|taken| {
                (&of.structure, &of.shift_elements) == (&taken.structure, &taken.shift_elements)
            })
        };
        let of_taken: Vec<_> = found.iter().filter(is_taken).copied().collect();
        let mut larger = with(size.clone(), &of_taken)?;
        if usual.gives_way_to(compared(&larger)) {
            larger.limits = larger.limits.with(best.limits, larger.file.is_some());
            (best, taken_size) = (larger, size);
        }
    }
    if best.file.is_some() && wanted.is_front_asked {
        best.front = Some(front(largest_ring(best.sizes.as_ref()), |most| {
            let limit = RelaxedLimit::of_rings(most);
            limit.relax_size(&mut taken_size);
            let own = with(taken_size.clone(), &found)?;
            Ok(own.of_ring(limit).map(|point| (point.clone(), point.ring_diameter_m)))
        })?);
    }
    Ok(best)
}

impl Transmission {
    /// The gearbox taken under a limit of the rings; `None` without one.
    fn of_ring(&self, limit: RelaxedLimit) -> Option<GearboxOfRing> {
        self.file.as_ref()?;
        let taken = self.gearboxes.first()?;
        let teeth = |of: &TeethOfSet| {
            [Some(of.sun), Some(of.planet), of.outer_planet, Some(of.ring)].into_iter().flatten().collect()
        };
        Some(GearboxOfRing {
            limits: vec![limit],
            structure: taken.structure.clone(),
            teeth: taken.sets.iter().map(teeth).collect(),
            greatest_deviation: taken.greatest_deviation,
            ring_diameter_m: taken.ring_diameter_m?,
            whole_kg: self.masses.map(|masses| masses.whole_kg),
            warnings: taken.warnings,
        })
    }
}

/// Designs a gearbox of one of these structures, of so many that have the ratios, with the sizes of the order.
fn of_structures(
    wanted: &WantedTransmission,
    (structures, found): (usize, &[&(Solution, Kept)]),
    goes_on: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Transmission, Error> {
    let mut all: Vec<Sized> = vec![];
    // A limit of the mass that none of the best keeps may be kept by the next ones.
    let is_done = |all: &[Sized]| wanted.order.whole_kg.is_none() || all.iter().any(Sized::is_within);
    for families in found.chunks(STRUCTURES) {
        for (solution, kept) in families {
            for (count, place) in best_teeth(wanted, (solution, kept), goes_on)?.into_iter().enumerate() {
                if count >= TEETH && is_done(&all) {
                    break;
                }
                all.push(Sized::of(wanted, (solution, kept), place, goes_on)?);
            }
        }
        if is_done(&all) {
            break;
        }
    }
    all.sort_by(|one, other| one.rank().partial_cmp(&other.rank()).expect("masses are numbers"));
    let gearboxes = all.iter().map(|sized| sized.of.clone()).collect();
    let load = AssumedLoad {
        spectrum: &wanted.spectrum,
        gears: wanted.ratios.len(),
        shares: &wanted.shares,
        overload: wanted.overload,
    };
    let of_set = BasisKey::of_number("efficiency", wanted.efficiency.get());
    let mut transmission = Transmission {
        gears: asked(wanted),
        tolerance: wanted.tolerance,
        input_speed_rad_s: wanted.speed.si(),
        structures,
        gearboxes,
        basis: wanted.basis.told().into_iter().chain([of_set]).collect(),
        assumed: assumed(&wanted.basis, &wanted.size, &load)?,
        limits: wanted.order,
        masses: None,
        sizes: None,
        ways_out: vec![],
        front: None,
        file: None,
        warnings: vec![],
    };
    if let Some(taken) = all.into_iter().next() {
        let sizes = SizesStep::of(taken.size.clone());
        let (file, masses) = taken.made(wanted, &sizes)?;
        transmission.warnings = warnings(&taken.size, file.as_deref(), &wanted.size)?;
        if transmission.limits.allow(masses.as_ref(), &sizes) {
            (transmission.file, transmission.masses) = (file, masses);
        }
        transmission.warnings.extend(wanted.order.warning());
        transmission.gears = taken.gears;
        transmission.sizes = Some(sizes);
    }
    Ok(transmission)
}

impl WantedTransmission {
    /// Load of the input in every gear.
    fn load(&self) -> Load<'_> {
        let Self { torque, speed, overload, ref spectrum, .. } = *self;
        Load { torque, speed, overload, spectrum }
    }
}

/// The gears as they are required.
fn asked(wanted: &WantedTransmission) -> Vec<GearReached> {
    let of = |(gear, ratio): (String, &f64)| GearReached {
        gear,
        asked_ratio: *ratio,
        ratio: None,
        asked_output_speed_rad_s: wanted.speed.si() / ratio,
        output_speed_rad_s: None,
        engaged: vec![],
        efficiency: None,
    };
    names(&wanted.ratios).into_iter().zip(&wanted.ratios).map(of).collect()
}

/// Number of structures that have the ratios, and the best of the first families with their tooth numbers.
/// Shifts that exchange one element for one come first.
fn structures(
    wanted: &WantedTransmission,
    goes_on: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<(usize, Vec<(Solution, Kept)>), Error> {
    let mut are_toothless = false;
    for neighbours in [true, false] {
        // Few gears have thousands of large structures, none of them simpler than the small ones.
        let classes = CLASSES.iter().filter(|(_, sets, _)| *sets < wanted.ratios.len());
        for class in classes {
            let search = search(wanted, class, Shifts { neighbours, skips: false })?;
            let of_class = |_: &Searching, _| goes_on();
            let (synthesis, kept) = match solve(&search, &of_class) {
                // Ratios that no structure of these classes can have.
                Err(Error::Synthesis(_)) => continue,
                found => found?,
            };
            if !synthesis.complete && goes_on().is_break() {
                return Err(epicyclic_strength::Error::Cancelled.into());
            }
            let is_of_use = |one: &Solution| one.beyond_limit.is_none() && one.missing_gears.is_empty();
            let all = synthesis.solutions.into_iter().zip(kept);
            let found: Vec<_> = all.filter(|(solution, _)| is_of_use(solution)).collect();
            if found.iter().any(|(_, kept)| !kept.teeth.is_empty()) {
                return Ok((synthesis.found, found));
            }
            are_toothless |= !found.is_empty();
        }
        // What has no teeth within the bounds has none with other shifts either.
        if are_toothless {
            break;
        }
    }
    Ok((0, vec![]))
}

fn search(
    wanted: &WantedTransmission,
    (kind, sets, [engaged, double_planets]): &Class,
    shifts: Shifts,
) -> Result<Search, Error> {
    let gear =
        |ratio: &f64| WantedRatio { wanted: Ratio::Around { ratio: *ratio, within: None }, optional: false };
    Ok(Search {
        gears: wanted.ratios.iter().map(gear).collect(),
        tolerance: wanted.tolerance,
        kind: *kind,
        sets: *sets..=*sets,
        elements: 1..=MOST_ELEMENTS.min(wanted.ratios.len()),
        engaged: engaged.clone(),
        links: 0..=usize::MAX,
        open: 0..=usize::MAX,
        k: wanted.k.clone(),
        double_planets: double_planets.clone(),
        k_double: K_DOUBLE,
        equal_k: 1,
        rules: Rules { shifts, ..Rules::default() },
        limits: wanted.limits.clone(),
        drawable: false,
        shares: None,
        usable: Some(wanted.usable),
        efficiency: wanted.efficiency,
        most: if wanted.order.whole_kg.is_some() { STRUCTURES_WITHIN } else { STRUCTURES },
        all_gearboxes: false,
        also: None,
        order: vec![Objective::Drawable, Objective::Shifts, Objective::Efficiency],
        objectives: Objective::ALL.to_vec(),
        teeth: Some(TeethWanted {
            bounds: wanted.bounds.clone(),
            shifts: None,
            alike: Alike { rings: 1, suns: 1, sets: 1 },
            aim: Aim::Deviation,
            most: NEAREST,
        }),
        explain: None,
    })
}

/// Places of the tooth numbers that get sizes: the lightest of simple sets; with double-planet sets those
/// with usual planets.
fn best_teeth(
    wanted: &WantedTransmission,
    (solution, kept): (&Solution, &Kept),
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Vec<usize>, Error> {
    let choices: Vec<&TeethOfSets> = solution.teeth.iter().flat_map(|teeth| &teeth.choices).collect();
    let mut places: Vec<usize> = (0..choices.len()).collect();
    places.sort_by(|one, other| off_usual(&choices[*one].sets).total_cmp(&off_usual(&choices[*other].sets)));
    let are_simple = |teeth: &TeethOfSets| teeth.sets.iter().all(|set| set.outer_planet.is_none());
    if let Some(first) = places.first().filter(|_| choices.iter().all(|teeth| are_simple(teeth))) {
        let of_set = sizing_of(&subject(wanted, kept, *first)?, &wanted.size)?;
        let mut gearboxes = vec![];
        for (place, teeth) in choices.iter().enumerate() {
            let gearbox = gearbox(wanted, kept, place)?;
            let gears = shared(gearbox.gears().iter().map(Gear::name).collect(), &wanted.shares)?;
            let teeth = teeth.sets.iter().map(|set| {
                let [sun, planet, ring] = [set.sun, set.planet, set.ring].map(ToothCount::new);
                Ok([sun?, planet?, ring?])
            });
            let teeth = teeth.collect::<Result<Vec<_>, epicyclic_gears::Error>>()?;
            let load = (wanted.load(), wanted.size.application);
            let (sets, others_kg) = loaded::sets(&gearbox, &teeth, &gears, load, of_set.overloads.first())?;
            gearboxes.push(Gearbox { group: 0, sets, rules_missed: 0, others_kg });
        }
        let whole_kg = wanted.order.whole_kg;
        let found = lightest(&of_set, &gearboxes, Searched { most: TEETH, whole_kg }, goes_on)?;
        let best = if found.best.is_empty() { found.above.as_slice() } else { &found.best[..] };
        match best {
            [] => places.truncate(TEETH),
            best => places = best.iter().map(|best| best.place).collect(),
        }
    }
    places.truncate(if wanted.order.whole_kg.is_some() { TEETH_WITHIN } else { TEETH });
    Ok(places)
}

/// Gearbox with the tooth numbers at a place.
fn gearbox(
    wanted: &WantedTransmission,
    kept: &Kept,
    place: usize,
) -> Result<epicyclic_train::Gearbox, Error> {
    let count = match wanted.ratios.len() {
        1 => "1 gear".to_owned(),
        gears => format!("{gears} gears"),
    };
    saved::gearbox(kept, &count, Some(&kept.teeth[place]))
}

/// The gearbox with the tooth numbers at a place, its duty, materials and factors.
fn subject(wanted: &WantedTransmission, kept: &Kept, place: usize) -> Result<Subject, Error> {
    let gearbox = gearbox(wanted, kept, place)?;
    let text = written(&gearbox, &[]).map_err(|error| Error::Json(error.to_string()))?;
    let mut file = Document::parse_one(MAKING, text.as_bytes())?.value().clone();
    // The numbers of planets are left to the sizing.
    for_each_set(&mut file, |set| {
        set.remove("planets");
    });
    let gears = shared(gearbox.gears().iter().map(Gear::name).collect(), &wanted.shares)?;
    with_duty(&mut file, &wanted.basis, &gears, wanted.load());
    let file = to_string(&file).map_err(|error| Error::Json(error.to_string()))?;
    let document = Document::parse_one(MAKING, file.as_bytes())?;
    let subject = one(&document, &Choice::default())?;
    // Sets of each kind have their own gears and meshes that materials and factors are of.
    let missing = MissingKeys::of(&subject, &document.read()?, &wanted.basis, Purpose::Sizes)?;
    Ok(missing.assumed(&wanted.basis)?.map_or(subject, |(whole, _)| whole))
}

/// How far planets are from usual tooth numbers.
fn off_usual(sets: &[TeethOfSet]) -> f64 {
    let planets = sets.iter().flat_map(|set| [Some(set.planet), set.outer_planet]).flatten();
    planets.map(|teeth| libm::log(f64::from(teeth) / PLANET).abs()).sum()
}

impl Sized {
    /// Sizes a gearbox with its tooth numbers at a place.
    fn of(
        wanted: &WantedTransmission,
        (solution, kept): (&Solution, &Kept),
        place: usize,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let mut choices = solution.teeth.iter().flat_map(|teeth| &teeth.choices);
        let teeth = choices.nth(place).expect("places are those of choices");
        let subject = subject(wanted, kept, place)?;
        let size = size::answer(&subject, &wanted.size, goes_on)?;
        let reached = |((mut asked, own), ratio): ((GearReached, &SearchedGear), &Fraction)| {
            let ratio = ratio.numerator as f64 / ratio.denominator as f64;
            // The structure has the efficiency of the ratio that is asked for.
            let gear = subject.train.gears().iter().find(|gear| gear.name() == asked.gear);
            let analysis = gear.and_then(|gear| subject.train.analyze_gear(gear).ok());
            asked.ratio = Some(ratio);
            asked.output_speed_rad_s = Some(wanted.speed.si() / ratio);
            asked.engaged.clone_from(&own.engaged);
            asked.efficiency = analysis.and_then(|analysis| analysis.efficiency());
            asked
        };
        let gears: Vec<GearReached> =
            asked(wanted).into_iter().zip(&solution.gears).zip(&teeth.ratios).map(reached).collect();
        let forward = gears.iter().filter(|gear| gear.asked_ratio > 0.0).filter_map(|gear| gear.efficiency);
        let rings = size.sets.iter().map(|set| set.found.first()?.ring_diameter_m);
        let [errors, warnings, _] = size.judgement.misses();
        let is_whole = size.not_sized.is_empty();
        let of = GearboxWithTeeth {
            structure: solution.structure.clone(),
            shift_elements: solution.shift_elements.clone(),
            multiple_shifts: solution.multiple_shifts,
            forward_efficiency: forward.reduce(f64::min).unwrap_or(solution.forward_efficiency),
            sets: teeth.sets.clone(),
            greatest_deviation: teeth.greatest_deviation,
            warnings: errors + warnings,
            mass_kg: size.mass_kg.filter(|_| is_whole),
            ring_diameter_m: rings.flatten().reduce(f64::max).filter(|_| is_whole),
        };
        let mut sized = Self { of, gears, document: subject.document, size, above_kg: 0.0 };
        if let Some(most) = wanted.order.whole_kg {
            let (_, masses) = sized.made(wanted, &SizesStep::of(sized.size.clone()))?;
            let whole = masses.map(|masses| masses.whole_kg);
            sized.above_kg = whole.filter(|whole| *whole > most).unwrap_or_default();
        }
        Ok(sized)
    }

    /// Gearbox file with sizes and the masses of the whole; `None` if a set has no size.
    fn made(
        &self,
        wanted: &WantedTransmission,
        sizes: &SizesStep,
    ) -> Result<(Option<String>, Option<Masses>), Error> {
        if self.of.mass_kg.is_none() {
            return Ok((None, None));
        }
        let file = size::saved(&self.document, &self.size)?;
        let masses = Masses::of(&file, sizes, (wanted.size.application, wanted.overload))?;
        Ok((Some(file), masses))
    }

    /// Whether all sets have sizes and the whole mass keeps its limit.
    fn is_within(&self) -> bool {
        self.of.mass_kg.is_some() && self.above_kg == 0.0
    }

    /// Whether a set has no size, mass above the limit, errors and warnings, mass.
    fn rank(&self) -> (bool, f64, usize, f64) {
        let GearboxWithTeeth { warnings, mass_kg, .. } = self.of;
        let mass = self.size.with_structure_kg.unwrap_or_default();
        (mass_kg.is_none(), self.above_kg, warnings, mass)
    }
}
