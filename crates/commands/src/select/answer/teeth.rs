//! Choice of a gearbox over all tooth numbers of its one or two sets.

mod searched;
mod streamed;
mod wanted;

use super::candidate::{BrakedGear, Candidate, Objectives, Ranked};
use super::decisive;
use super::reached::{Asked, ReachedSpeed};
use super::required::{Required, finite};
use super::saved::Saved;
use crate::answer::Answer;
use crate::error::Error;
use crate::finite;
use crate::shared::judgement::answer::Judgement;
use crate::teeth::answer::shifted::{RequiredShifts, SetShifts};
use crate::tolerance::LEAST_MODULE_M;
use epicyclic_formats::gearbox::WrittenSize;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_schemes::catalogue::SchemeGear;
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::search::{Directions, Found, OneSetSearch, Progress, ToothSearch};
use epicyclic_selection::size::relative_ring_diameter_of_teeth;
use epicyclic_selection::{self as selection, Mechanism, Rating};
use epicyclic_units::Physical;
use schemars::JsonSchema;
pub use searched::Searched;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use std::sync::atomic::{AtomicUsize, Ordering};
use streamed::Designs;
pub use streamed::Streamed;
use uom::si::f64::Length;
pub use wanted::Wanted;

/// Maximum number of designs that an answer holds, at about 35 kB each; beyond it each design is computed
/// while it is written ([`Streamed`]).
pub const MOST_DESIGNS: usize = 10_000;

impl Wanted {
    fn asked(&self) -> Asked<'_> {
        let ratios = self.requirements.series.braked();
        Asked { speeds: &self.speeds, ratios, input: self.duty.input_speed }
    }

    fn shift(&self) -> Option<ProfileShift> {
        Some(self.shifts.as_ref()?.within(&self.bounds))
    }
}

/// Limits of the size of a set at the load factor; `None` sets no limit.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SizeLimits {
    /// Maximum pitch diameter of a ring.
    pub ring_diameter: Option<Length>,
    /// Minimum module.
    pub least_module: Option<Length>,
    /// Maximum module.
    pub greatest_module: Option<Length>,
}

impl SizeLimits {
    fn module(&self) -> Result<Option<RangeInclusive<Length>>, Error> {
        if self.least_module.is_none() && self.greatest_module.is_none() {
            return Ok(None);
        }
        let least = self.least_module.unwrap_or(Length::from_si(LEAST_MODULE_M));
        let greatest = self.greatest_module.unwrap_or(Length::from_si(1.0));
        if least > greatest {
            return Err(Error::ModuleRange { least_mm: least.mm(), greatest_mm: greatest.mm() });
        }
        Ok(Some(least..=greatest))
    }
}

/// Designs of one set or two with tooth numbers: the first non-dominated designs, the best first.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SelectTeeth {
    /// Number of the design that tables show in full; null if no design has that number.
    pub shown_in_full: Option<u32>,
    /// Speeds of that design, required and reached, the slowest first; empty without such a design.
    pub speeds: Vec<ReachedSpeed>,
    /// Judgement of the design shown in full, by rules of practice; without checks if no design is.
    pub judgement: Judgement,
    /// Requirements as a record.
    pub required: Required,
    /// Limits of the size of a set.
    pub size_limits: RequiredSize,
    /// Requirements of the profile shifts; absent for sets without profile shift.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile_shift: Option<RequiredShifts>,
    /// Extent of the search.
    pub searched: Searched,
    /// Number of designs listed.
    pub shown: usize,
    /// Listed designs.
    pub designs: Vec<Design>,
    /// Best design of each structure, the best first; a design of another structure may dominate it. For one
    /// set only designs on the front are included.
    pub best_of_structures: Vec<BestOfStructure>,
}

/// Best design of a structure by the order of objectives.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BestOfStructure {
    /// Name of the scheme in the source; null if it has none.
    pub scheme: Option<&'static str>,
    /// Name of the structure, by the links of sun, ring and carrier of each set.
    pub structure: String,
    /// Tooth numbers of each set.
    pub tooth_numbers: Vec<SetTeeth>,
    /// Braked gears of the design.
    pub gears: Vec<BrakedGear>,
    /// Values of the objectives.
    pub objectives: Objectives,
    /// Whether the output turns in mixed directions: backward in a braked gear, forward in direct drive.
    pub mixed_directions: bool,
}

/// Limits of the size of a set at the load factor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RequiredSize {
    /// Maximum pitch diameter of a ring in m; null without limit.
    pub greatest_ring_diameter_m: Option<f64>,
    /// Minimum module in m; null without limit.
    pub least_module_m: Option<f64>,
    /// Maximum module in m; null without limit.
    pub greatest_module_m: Option<f64>,
}

/// Design with tooth numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Design {
    /// Tooth numbers of each set.
    pub tooth_numbers: Vec<SetTeeth>,
    /// Number of other tooth designs with equal objectives.
    pub others: u64,
    /// Design as a candidate; its ratios follow from the tooth numbers.
    pub candidate: Candidate,
}

/// Tooth numbers of a set, and the size that it needs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetTeeth {
    /// Tooth number of the sun.
    pub sun: u32,
    /// Tooth number of a planet.
    pub planet: u32,
    /// Tooth number of the ring.
    pub ring: u32,
    /// Number of planets.
    pub planets: u32,
    /// Relative size of the ring.
    pub size: f64,
    /// Pitch diameter of the ring required by the load factor, in m; null without a torque and a load factor.
    pub ring_diameter_m: Option<f64>,
    /// Module that follows from this diameter, in m; null without a torque and a load factor.
    pub module_m: Option<f64>,
    /// Profile shifts of the set; absent for a set without profile shift.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shifts: Option<SetShifts>,
}

impl Answer for SelectTeeth {
    const NAME: &'static str = "select-teeth";
}

/// Searches all tooth numbers for the first non-dominated designs; `watch` receives the progress from any
/// thread.
///
/// # Errors
/// [`Error::TooManyDesigns`], [`Error::ModuleRange`], [`Error::Selection`], [`Error::Duty`].
pub fn answer(wanted: &Wanted, watch: &Watch) -> Result<SelectTeeth, Error> {
    if wanted.most > MOST_DESIGNS {
        return Err(Error::TooManyDesigns { wanted: wanted.most, most: MOST_DESIGNS });
    }
    search(wanted, watch)?.answer()
}

/// Progress of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct At {
    /// Finished part of the search, from 0 to 1.
    pub share: f64,
    /// Extent of the search. For two sets it is known after the count, while `accepted` is still 0; for one
    /// set it grows during the search.
    pub searched: Option<Searched>,
}

/// Closure that receives the progress of a search from any thread, and may end the search.
pub type Watch<'a> = dyn Fn(At) -> ControlFlow<()> + Sync + 'a;

/// Results of a search, before the full figures of the designs are computed.
#[derive(Debug)]
pub struct Searches<'a> {
    wanted: &'a Wanted,
    searched: Searched,
    found: Vec<First>,
    /// First design of each structure.
    of_structures: Vec<First>,
}

/// Searches for the requested number of designs, which may exceed [`MOST_DESIGNS`].
///
/// # Errors
/// [`Error::ModuleRange`], [`Error::Selection`], [`Error::Duty`].
pub fn search<'a>(wanted: &'a Wanted, watch: &Watch) -> Result<Searches<'a>, Error> {
    wanted.duty.torque()?;
    let of_one_set = wanted.requirements.series.braked().len() == 1;
    let some = |directions: Directions| {
        let mut targets = wanted.requirements.targets().into_iter();
        targets.any(|ratios| wanted.requirements.allows_directions_of(&ratios) && directions.hold(&ratios))
    };
    let part = |directions: Directions, [from, to]: [f64; 2]| {
        let watch = |at: At| watch(At { share: from + (to - from) * at.share, ..at });
        let (found, of_structures, searched) = if of_one_set {
            of_one(wanted, directions, &watch)?
        } else {
            of_two(wanted, directions, &watch)?
        };
        Ok(Searches { wanted, searched, found, of_structures })
    };
    if some(Directions::Same) && some(Directions::Mixed) {
        // Designs with mixed directions follow all others.
        let mixed = |same: Searches<'a>| Ok(same.followed_by(part(Directions::Mixed, [0.5, 1.0])?));
        part(Directions::Same, [0.0, 0.5]).and_then(mixed)
    } else {
        part(Directions::Any, [0.0, 1.0])
    }
}

impl<'a> Searches<'a> {
    /// Appends the designs of another search over the same tooth numbers.
    fn followed_by(mut self, more: Self) -> Self {
        self.found.extend(more.found);
        self.found.truncate(self.wanted.most);
        for first in more.of_structures {
            if self.of_structures.iter().all(|other| other.mechanism != first.mechanism) {
                self.of_structures.push(first);
            }
        }
        self.searched.structures += more.searched.structures;
        self.searched.designs += more.searched.designs;
        self.searched.tried += more.searched.tried;
        self.searched.accepted += more.searched.accepted;
        self.searched.left_out = self.searched.left_out.or(more.searched.left_out);
        self
    }

    /// Extent of the search.
    #[must_use]
    pub const fn searched(&self) -> &Searched {
        &self.searched
    }

    /// Number of designs listed.
    #[must_use]
    pub fn shown(&self) -> usize {
        self.found.len().min(self.wanted.most)
    }

    /// Place of the design that tables show in full.
    fn in_full(&self) -> Option<usize> {
        self.wanted.nth.checked_sub(1).filter(|place| *place < self.shown())
    }

    /// Listed designs; the figures of each are computed when it is requested.
    pub fn designs(&self) -> impl Iterator<Item = Result<Design, Error>> + '_ {
        (0..self.shown()).map(|place| Ok(self.design(place)?.0))
    }

    /// Design by its number, from 1; `None` if there is no such number.
    ///
    /// # Errors
    /// No error is known for a design that was found.
    pub fn told(&self, no: usize) -> Result<Option<Design>, Error> {
        let place = no.checked_sub(1).filter(|place| *place < self.found.len());
        place.map(|place| Ok(self.design(place)?.0)).transpose()
    }

    /// Design by its number, from 1, as a gearbox; `None` if there is no such number.
    ///
    /// # Errors
    /// No error is known for a design that was found.
    pub fn saved(&self, no: usize) -> Result<Option<Saved>, Error> {
        let place = no.checked_sub(1).filter(|place| *place < self.found.len());
        place.map(|place| Ok(self.saved_design(place)?.1)).transpose()
    }

    /// Speeds of the design at a place, required and reached, the slowest first.
    pub(crate) fn speeds(&self, place: usize) -> Vec<ReachedSpeed> {
        let first = &self.found[place];
        let k: Vec<f64> = first.teeth.iter().map(ToothNumbers::ring_to_sun_ratio).collect();
        let gears = SchemeGear::BRAKED.into_iter();
        let ratios = first.wanted.iter().copied().zip(first.mechanism.ratios(&k));
        self.wanted.asked().reached(gears.zip(ratios).map(|(gear, (wanted, ratio))| (gear, wanted, ratio)))
    }

    /// Judgement of the design at a place by rules of practice.
    fn judged(&self, place: usize) -> Result<Judgement, Error> {
        let (_, candidate) = self.design(place)?;
        let (_, saved) = self.saved_design(place)?;
        Ok(saved.judged(&candidate, &self.wanted.requirements))
    }

    /// Design at a place with its full figures, and as a gearbox.
    pub(crate) fn saved_design(&self, place: usize) -> Result<(Design, Saved), Error> {
        let (design, candidate) = self.design(place)?;
        let (requirements, teeth) = (&self.wanted.requirements, &self.found[place].teeth);
        let width = requirements.rating.face_width_ratio;
        let sizes = design.tooth_numbers.iter().filter_map(|set| size(set, width)).collect();
        let shifts = design.tooth_numbers.iter().map(|set| set.shifts);
        let teeth: Vec<(ToothNumbers, Option<SetShifts>)> = teeth.iter().copied().zip(shifts).collect();
        let saved = Saved::of(&candidate, requirements, &teeth, sizes)?;
        Ok((design, saved))
    }

    /// Answer with all listed designs.
    ///
    /// # Errors
    /// No error is known for designs that were found.
    pub fn answer(&self) -> Result<SelectTeeth, Error> {
        Ok(SelectTeeth { designs: self.designs().collect::<Result<_, _>>()?, ..self.without_designs()? })
    }

    /// Answer whose designs are computed during writing; the callback receives the written part, from 0 to 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the key of a number that is infinite or NaN; for a number of a design the
    /// error occurs during writing.
    pub fn streamed(&'a self, told: &'a dyn Fn(f64)) -> Result<Streamed<'a>, Error> {
        let head = self.without_designs()?;
        finite::check(&head)?;
        let SelectTeeth {
            shown_in_full,
            speeds,
            judgement,
            required,
            size_limits,
            profile_shift,
            searched,
            shown,
            best_of_structures,
            ..
        } = head;
        let designs = Designs { of: self, told };
        Ok(Streamed {
            shown_in_full,
            speeds,
            judgement,
            required,
            size_limits,
            profile_shift,
            searched,
            shown,
            designs,
            best_of_structures,
        })
    }

    fn without_designs(&self) -> Result<SelectTeeth, Error> {
        let Wanted { requirements, order, limits, duty, .. } = self.wanted;
        Ok(SelectTeeth {
            shown_in_full: self.in_full().map(|place| u32::try_from(place + 1).unwrap_or(u32::MAX)),
            speeds: self.in_full().map(|place| self.speeds(place)).unwrap_or_default(),
            judgement: self.in_full().map(|place| self.judged(place)).transpose()?.unwrap_or_default(),
            required: Required::of(requirements, *order, duty)?,
            size_limits: RequiredSize {
                greatest_ring_diameter_m: limits.ring_diameter.map(Physical::si),
                least_module_m: limits.least_module.map(Physical::si),
                greatest_module_m: limits.greatest_module.map(Physical::si),
            },
            profile_shift: self.wanted.shifts.as_ref().map(RequiredShifts::of),
            searched: self.searched.clone(),
            shown: self.shown(),
            designs: vec![],
            best_of_structures: self
                .of_structures
                .iter()
                .map(|first| self.best(first))
                .collect::<Result<_, _>>()?,
        })
    }

    fn best(&self, first: &First) -> Result<BestOfStructure, Error> {
        let (design, _) = self.designed(first, 1)?;
        let Candidate { scheme, structure, gears, objectives, mixed_directions, .. } = design.candidate;
        let tooth_numbers = design.tooth_numbers;
        Ok(BestOfStructure { scheme, structure, tooth_numbers, gears, objectives, mixed_directions })
    }

    fn design(&self, place: usize) -> Result<(Design, selection::Candidate), Error> {
        self.designed(&self.found[place], u32::try_from(place + 1).unwrap_or(u32::MAX))
    }

    fn designed(&self, first: &First, no: u32) -> Result<(Design, selection::Candidate), Error> {
        let wanted = self.wanted;
        let requirements = &wanted.requirements;
        let mut candidate = selection::Candidate::of_teeth(
            first.mechanism,
            &first.teeth,
            &first.wanted,
            requirements,
            Some(&drawable_direct_clutches),
        )?;
        // The values are those of the comparison, each rounded to its grid.
        let circulation = candidate.objectives.circulation;
        candidate.objectives = selection::Objectives { circulation, ..first.objectives };
        let shift = wanted.shift();
        let teeth = first.teeth.iter().enumerate();
        let tooth_numbers = teeth
            .map(|(set, teeth)| SetTeeth::of(teeth, set, &candidate, &requirements.rating, shift.as_ref()))
            .collect::<Result<_, _>>()?;
        let behind = decisive(wanted.order, &self.found[0].measured(), &first.measured());
        let ranked = Ranked { no, candidate: &candidate, non_dominated: true };
        let of = Candidate::of(&ranked, behind, requirements, &wanted.duty)?;
        Ok((Design { tooth_numbers, others: first.others, candidate: of }, candidate))
    }
}

/// First design of an entry of the front.
#[derive(Debug, Clone)]
struct First {
    mechanism: Mechanism,
    wanted: Vec<f64>,
    /// Tooth numbers of each set.
    teeth: Vec<ToothNumbers>,
    objectives: selection::Objectives,
    /// Number of further designs of the entry.
    others: u64,
}

impl First {
    /// Whether the design mixes directions of rotation, and its objectives.
    fn measured(&self) -> (bool, selection::Objectives) {
        (self.wanted.iter().any(|ratio| *ratio < 0.0), self.objectives)
    }
}

fn of_one(
    wanted: &Wanted,
    directions: Directions,
    watch: &Watch,
) -> Result<(Vec<First>, Vec<First>, Searched), Error> {
    let search = OneSetSearch {
        directions,
        sets: wanted.space.sets(),
        bounds: wanted.bounds.clone(),
        shift: wanted.shift(),
        order: wanted.order,
        ring_diameter: wanted.limits.ring_diameter,
        module: wanted.limits.module()?,
        ..OneSetSearch::new(wanted.requirements.clone())
    };
    let found = search.front_watched(|share| watch(At { share, searched: None }))?;
    let first = |entry: &selection::front::Entry| {
        let designs = found.designs(entry);
        let count: usize = designs.iter().map(|design| design.teeth.len()).sum();
        let first = designs.into_iter().next()?;
        Some(First {
            mechanism: Mechanism::OneSet(first.set),
            wanted: vec![first.wanted],
            teeth: first.teeth.first().copied().into_iter().collect(),
            objectives: entry.objectives,
            others: count.saturating_sub(1) as u64,
        })
    };
    let mut of_structures: Vec<First> = vec![];
    for entry in found.entries() {
        for design in found.designs(entry) {
            let mechanism = Mechanism::OneSet(design.set);
            if of_structures.iter().all(|other| other.mechanism != mechanism) {
                of_structures.push(First {
                    mechanism,
                    wanted: vec![design.wanted],
                    teeth: design.teeth.first().copied().into_iter().collect(),
                    objectives: entry.objectives,
                    others: design.teeth.len().saturating_sub(1) as u64,
                });
            }
        }
    }
    let searched = Searched::of(found.counts(), found.left_out());
    Ok((found.entries().iter().take(wanted.most).filter_map(first).collect(), of_structures, searched))
}

fn of_two(
    wanted: &Wanted,
    directions: Directions,
    watch: &Watch,
) -> Result<(Vec<First>, Vec<First>, Searched), Error> {
    let search = ToothSearch {
        directions,
        bounds: wanted.bounds.clone(),
        shift: wanted.shift(),
        order: wanted.order,
        structures: wanted.space.structures(),
        ring_diameter: wanted.limits.ring_diameter,
        module: wanted.limits.module()?,
        ..ToothSearch::new(wanted.requirements.clone())
    };
    // The search runs once for all structures and once more for each structure, so this part counts half.
    let told = |share: f64, progress: Progress| {
        let is_counted = progress.counts.tooth_sets > 0;
        watch(At { share: share.min(1.0), searched: is_counted.then(|| Searched::of(progress.counts, None)) })
    };
    let share = |progress: Progress| progress.done as f64 / progress.of.max(1) as f64;
    let watch = |progress: Progress| told(0.5 * share(progress), progress);
    // For many designs the first ones take nearly as long as the whole front.
    let found = if wanted.most > MOST_DESIGNS {
        search.front_watched(&watch)?
    } else {
        search.best_watched(wanted.most.max(1), &watch)?
    };
    let first = |found: &Found, entry: &selection::front::Entry| {
        let (first, count) = found.first_design(entry)?;
        Some(First {
            mechanism: Mechanism::TwoSets(first.structure),
            wanted: first.wanted.to_vec(),
            teeth: first.pairs.first().map(|pair| pair.to_vec()).unwrap_or_default(),
            objectives: entry.objectives,
            others: count.saturating_sub(1),
        })
    };
    let searched = Searched::of(found.counts(), found.left_out());
    let pieces = AtomicUsize::new(0);
    let of_all = search.structures.len().max(1) as f64;
    let each = search.best_of_each_watched(&|progress| {
        let structures =
            pieces.fetch_add(usize::from(progress.done == progress.of), Ordering::Relaxed) as f64;
        told(0.5 + 0.5 * (structures / of_all).min(1.0), progress)
    })?;
    let of_structures = each.iter().filter_map(|one| first(one, one.entries().first()?)).collect();
    let found = found.entries().iter().take(wanted.most).filter_map(|entry| first(&found, entry)).collect();
    Ok((found, of_structures, searched))
}

impl SelectTeeth {
    /// Design that tables show in full.
    #[must_use]
    pub fn in_full(&self) -> Option<&Design> {
        self.designs.get(usize::try_from(self.shown_in_full?).ok()?.checked_sub(1)?)
    }
}

/// Module and face width of a set whose ring has the diameter required by the load factor. The face width is
/// a multiple of the pitch diameter of the smaller of sun and planet.
fn size(set: &SetTeeth, face_width_ratio: f64) -> Option<WrittenSize> {
    let module = set.module_m?;
    let width = face_width_ratio * module * f64::from(set.sun.min(set.planet));
    Some(WrittenSize { modules: vec![Length::from_si(module)], face_width: Some(Length::from_si(width)) })
}

impl SetTeeth {
    fn of(
        teeth: &ToothNumbers,
        set: usize,
        candidate: &selection::Candidate,
        rating: &Rating,
        shift: Option<&ProfileShift>,
    ) -> Result<Self, Error> {
        let torque =
            |gear: &selection::GearReport| gear.sun_torques.get(set).map_or(0.0, |torque| torque.abs());
        let torque = candidate.gears.iter().map(torque).fold(0.0, f64::max);
        let size = relative_ring_diameter_of_teeth(teeth, shift, torque, rating)?;
        let ring_diameter_m = rating.unit().map(|unit| unit.si() * size);
        Ok(Self {
            sun: teeth.sun.get(),
            planet: teeth.planet.get(),
            ring: teeth.ring.get(),
            planets: teeth.planets,
            size,
            ring_diameter_m,
            module_m: ring_diameter_m.map(|diameter| diameter / f64::from(teeth.ring.get())).and_then(finite),
            shifts: shift.map(|shift| SetShifts::of(shift, teeth)).transpose()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::{to_json, write_json};
    use crate::select::answer::duty::Duty;
    use epicyclic_gears::synthesis::Bounds;
    use epicyclic_schemes::RatioSeries;
    use epicyclic_selection::{Order, Requirements, Space};
    use uom::si::f64::{Pressure, Torque};
    use uom::si::length::millimeter;
    use uom::si::pressure::megapascal;
    use uom::si::torque::newton_meter;

    fn wanted(ratios: &[f64]) -> Wanted {
        let mut requirements = Requirements::new(RatioSeries::of_braked_gears(ratios).unwrap());
        let torque = Torque::new::<newton_meter>(500.0);
        requirements.rating.load = Some((torque, Pressure::new::<megapascal>(2.0)));
        Wanted {
            requirements,
            order: Order::default(),
            space: Space::Catalogue,
            bounds: Bounds { ring: 12..=60, ..Bounds::default() },
            shifts: None,
            limits: SizeLimits::default(),
            nth: 1,
            most: 3,
            speeds: vec![],
            duty: Duty::default(),
        }
    }

    #[test]
    fn the_largest_ring_of_a_design_is_its_size() {
        let found = answer(&wanted(&[1.465, 2.56]), &|_| ControlFlow::Continue(())).unwrap();
        assert!(found.shown > 0);
        for design in &found.designs {
            let largest = design.tooth_numbers.iter().map(|set| set.size).fold(0.0, f64::max);
            assert!((largest / design.candidate.objectives.size - 1.0).abs() < 1e-9);
            let ratio = &design.candidate.criteria[0];
            assert!((ratio.value.unwrap() - design.candidate.objectives.ratio_error).abs() < 1e-9);
            for set in &design.tooth_numbers {
                let diameter = set.module_m.unwrap() * f64::from(set.ring);
                assert!((diameter / set.ring_diameter_m.unwrap() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn limits_of_the_module_hold_for_what_is_told() {
        let module = Length::new::<millimeter>(3.2);
        let limits = SizeLimits { least_module: Some(module), ..SizeLimits::default() };
        let found =
            answer(&Wanted { limits, ..wanted(&[1.465, 2.56]) }, &|_| ControlFlow::Continue(())).unwrap();
        let told = found.designs.iter().flat_map(|design| &design.tooth_numbers);
        assert!(told.clone().count() > 0 && told.clone().all(|set| set.module_m.unwrap() >= 3.2e-3));
        let limits = SizeLimits { greatest_module: Some(module / 2.0), ..limits };
        let refused = answer(&Wanted { limits, ..wanted(&[1.465, 2.56]) }, &|_| ControlFlow::Continue(()));
        assert!(matches!(refused, Err(Error::ModuleRange { .. })));
    }

    /// Streamed answers equal whole ones, for both kinds of search, and for the whole front and its first
    /// part.
    #[test]
    fn what_is_streamed_is_the_whole_answer() {
        for ratios in [&[3.9375][..], &[1.465, 2.56]] {
            let mut few = wanted(ratios);
            few.limits = SizeLimits::default();
            few.most = MOST_DESIGNS;
            let whole = search(&few, &|_| ControlFlow::Continue(())).unwrap();
            let text = to_json(&whole.answer().unwrap()).unwrap();
            assert!(whole.shown() > 1 && whole.shown() < MOST_DESIGNS, "{}", whole.shown());
            let all = Wanted { most: usize::MAX, ..few.clone() };
            let found = search(&all, &|_| ControlFlow::Continue(())).unwrap();
            let (mut bytes, last) = (vec![], std::cell::Cell::new(0.0));
            write_json(&found.streamed(&|share| last.set(share)).unwrap(), &mut bytes).unwrap();
            assert!(String::from_utf8(bytes).unwrap() == text && last.get() == 1.0);
            assert!(matches!(
                answer(&all, &|_| ControlFlow::Continue(())),
                Err(Error::TooManyDesigns { .. })
            ));
        }
    }

    #[test]
    fn one_ratio_is_a_matter_of_one_set() {
        let found = answer(&wanted(&[3.9375]), &|_| ControlFlow::Continue(())).unwrap();
        assert!(found.shown == 3 && found.searched.structures == 6, "{:?}", found.searched);
        for design in &found.designs {
            let [teeth] = design.tooth_numbers[..] else { panic!("{design:?}") };
            let [gear] = &design.candidate.gears[..] else { panic!("{design:?}") };
            let k = f64::from(teeth.ring) / f64::from(teeth.sun);
            assert_eq!(design.candidate.sets[0].k, k);
            assert!(design.candidate.accepted && (gear.ratio.abs() / 3.9375 - 1.0).abs() <= 0.1);
            assert!((teeth.size / design.candidate.objectives.size - 1.0).abs() < 1e-9);
        }
    }
}
