//! Tooth numbers of a simple set for a ratio.
//!
//! | module | is |
//! |---|---|
//! | [`arranged`] | tooth numbers of stepped, Wolfrom and Ravigneaux sets and of pairs |
//! | [`double_planet`] | tooth numbers of a double-planet set |
//! | [`shifted`] | tooth numbers of simple sets with profile shift |
//! | `gearbox` | a set as a gearbox |

pub mod arranged;
pub mod double_planet;
mod gearbox;
pub mod shifted;

use crate::answer::Answer;
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::judgement::whole::FoundRatio;
use crate::shared::records::{Fraction, Motion};
use crate::shared::tooth_checks::answer::{TeethLeftOut, ToothChecks};
use crate::teeth::options::Request;
use crate::tolerance::ROUNDED;
use epicyclic_gears::ToothCount;
pub use epicyclic_gears::mesh::USUAL_PLANET_GAP;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::{Bounds, Candidate, Ranked};
use epicyclic_train::Gearbox;
use epicyclic_train::set::{SetKind, SetSpec, Shifts};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Maximum number of sets in an answer, whose text is built as a whole in about 100 MB.
pub const MOST_SETS: usize = 100_000;

/// Combinations of teeth and planets that are gone through in a second, about.
pub(crate) const IN_A_SECOND: f64 = 1e7;

/// Sets of tooth numbers that give a ratio, the most exact first.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Teeth {
    /// Required ratio, input speed over output speed.
    pub ratio: f64,
    /// Driving, driven and fixed member.
    pub mode: Motion,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Number of sets found.
    pub found: u64,
    /// Sets of this ratio that are left out because a tooth check fails; null if no set is left out.
    pub left_out: Option<TeethLeftOut>,
    /// Number of sets listed.
    pub shown: usize,
    /// Listed sets of tooth numbers.
    pub tooth_numbers: Vec<ToothNumbers>,
    /// Tooth checks of one set, the first unless another is requested.
    pub tooth_checks: ToothChecks,
    /// Judgement of the same set by rules of practice.
    pub judgement: Judgement,
}

/// Tooth numbers of a simple set, with the properties that follow from them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothNumbers {
    /// Tooth number of the sun.
    pub sun: u32,
    /// Tooth number of a planet.
    pub planet: u32,
    /// Tooth number of the ring.
    pub ring: u32,
    /// Number of planets.
    pub planets: u32,
    /// Ratio, input speed over output speed.
    pub ratio: f64,
    /// Exact ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative deviation from the required ratio.
    pub ratio_error: f64,
    /// Maximum number of planets that clear each other at equal spacing.
    pub most_planets: u32,
    /// Whether the rack undercuts the sun.
    pub undercut_sun: bool,
    /// Whether the rack undercuts the planets.
    pub undercut_planet: bool,
    /// Whether the planets are equally spaced.
    pub equal_spacing: bool,
    /// Gap between the tip circles of neighbouring planets, in modules.
    pub planet_gap_in_modules: f64,
    /// Angle of each planet about the axis, in rad.
    pub planet_angles_rad: Vec<f64>,
    /// Imbalance: distance of the planets' common centre of mass from the axis over the radius of their
    /// centres.
    pub imbalance: f64,
}

impl Answer for Teeth {
    const NAME: &'static str = "teeth";
}

/// Answer that lists sets of one kind.
pub(super) trait SetList: Answer {
    /// Numbers of sets found and listed.
    fn counts(&self) -> (u64, usize);

    /// Listed set with this number, from 1, as a gearbox; `None` if there is no such set.
    fn gearbox(&self, number: usize, request: &Request) -> Result<Option<Gearbox>, Error>;

    /// Module of each mesh of this set over that of the first; empty where all are equal.
    fn module_ratios(&self, _number: usize) -> Vec<f64> {
        vec![]
    }

    /// Limits the list to its first sets.
    fn truncate(&mut self, most: usize);
}

macro_rules! set_lists {
    ($($answer:ty $(: $module_ratios:ident)?),*) => {$(
        impl SetList for $answer {
            fn counts(&self) -> (u64, usize) {
                (self.found, self.shown)
            }

            fn gearbox(&self, number: usize, request: &Request) -> Result<Option<Gearbox>, Error> {
                let set = number.checked_sub(1).and_then(|place| self.tooth_numbers.get(place));
                set.map(|set| set.gearbox(request)).transpose()
            }

            $(fn module_ratios(&self, number: usize) -> Vec<f64> {
                self.$module_ratios(number)
            })?

            fn truncate(&mut self, most: usize) {
                self.tooth_numbers.truncate(most);
                self.shown = self.tooth_numbers.len();
            }
        }
    )*};
}

set_lists!(Teeth, double_planet::DoublePlanetTeeth, shifted::ShiftedTeeth, arranged::ArrangedSets: of_meshes);

/// Finds all sets of tooth numbers for a ratio.
///
/// # Errors
/// [`Error::Gear`] if nothing is found, or for an impossible bound; [`Error::TooMany`].
pub(super) fn answer(
    request: &Request,
    bounds: &Bounds,
    done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Teeth, Error> {
    let mode = request.simple_mode()?;
    let Listed { ratio, tolerance, found, left_out, sets, tooth_checks, judgement } = listed(
        request,
        &bounds.rack,
        |ratio, tolerance, most| bounds.first_for_ratio(ratio, mode, tolerance, most, done),
        |one| ToothNumbers::of(one, &bounds.rack),
        ToothNumbers::gearbox,
    )?;
    Ok(Teeth {
        ratio,
        mode: Motion::of(mode),
        tolerance,
        found,
        left_out,
        shown: sets.len(),
        tooth_numbers: sets,
        tooth_checks,
        judgement,
    })
}

/// Sets of one kind that a search found, as records, with what answers of all kinds have in common.
struct Listed<Set> {
    ratio: f64,
    tolerance: f64,
    found: u64,
    left_out: Option<TeethLeftOut>,
    sets: Vec<Set>,
    tooth_checks: ToothChecks,
    judgement: Judgement,
}

/// Searches sets by ratio, tolerance and maximum number of sets, and checks the one requested.
fn listed<Found, Set>(
    request: &Request,
    rack: &BasicRack,
    search: impl FnOnce(f64, f64, usize) -> Result<Ranked<Found>, epicyclic_gears::Error>,
    record: impl Fn(&Found) -> Set,
    gearbox: fn(&Set, &Request) -> Result<Gearbox, Error>,
) -> Result<Listed<Set>, Error> {
    let (ratio, tolerance) = (request.ratio.get(), request.tolerance.0.si());
    let most = request.limit.unwrap_or(usize::MAX);
    let Ranked { found, first, left_out } = search(ratio, tolerance, most.min(MOST_SETS))?;
    // The list is refused only if it would be longer; a large maximum alone is harmless.
    if most > MOST_SETS && found > MOST_SETS as u64 {
        return Err(Error::TooMany { found, most: MOST_SETS });
    }
    let sets: Vec<Set> = first.iter().map(record).collect();
    let number = if (1..=sets.len()).contains(&request.checked) { request.checked } else { 1 };
    let (mut tooth_checks, mut judgement) = (ToothChecks::default(), Judgement::default());
    if let Some(set) = sets.get(number - 1) {
        let gearbox = gearbox(set, request)?;
        judgement = judged(&gearbox, ratio, tolerance)?;
        let checks = gearbox.set_checks(rack, |_| vec![]);
        tooth_checks = ToothChecks::of(checks, |_| true);
        // The single set of its gearbox gets the number that it has in the list.
        tooth_checks.checks.iter_mut().for_each(|check| check.set = number.to_string());
    }
    let left_out = left_out.as_deref().map(TeethLeftOut::of);
    Ok(Listed { ratio, tolerance, found, left_out, sets, tooth_checks, judgement })
}

/// Judgement of a set that has the ratio within the tolerance, without shifts unless they are stated.
fn judged(gearbox: &Gearbox, wanted: f64, tolerance: f64) -> Result<Judgement, Error> {
    let unshifted = |set: SetSpec| match (&set.tooth_shape.shifts, set.kind) {
        (None, SetKind::Simple) => set.shifted(Shifts { profile: vec![0.0; 3], tips: None }),
        _ => set,
    };
    let stated = gearbox.to_builder().map_sets(unshifted).build()?;
    let found = gearbox.analyze(gearbox::NAME)?.ratio();
    let ratio = found.map(|found| FoundRatio { gear: gearbox::NAME.to_owned(), wanted, tolerance, found });
    Ok(Judgement::of_found(&stated, &[], ratio.as_slice()))
}

/// Sets in series that have a ratio impossible for one set within the same bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stages {
    /// Number of sets in series.
    pub sets: u32,
    /// Absolute ratio of each set if all are equal.
    pub ratio: f64,
    /// Mode of the other sets, if one set alone reverses the direction of rotation.
    pub others: Option<Mode>,
}

/// Maximum number of sets in series that [`stages`] tries.
const MOST_STAGES: u32 = 4;

/// Number of sets in series that have a ratio impossible for one set. Each set has the root of the ratio,
/// within its part of the tolerance.
///
/// A mode with negative ratios and the carrier at rest applies to one set; the carriers of the other sets
/// turn.
///
/// # Errors
/// Errors for impossible bounds.
pub(super) fn stages(request: &Request, bounds: &Bounds) -> Result<Option<Stages>, Error> {
    let (ratio, mode, tolerance) = (request.ratio.get(), request.simple_mode()?, request.tolerance.0.si());
    let is_negative = mode.fixed() == Member::Carrier;
    if is_negative != (ratio < 0.0) {
        return Ok(None);
    }
    let others = match is_negative {
        false => None,
        true if ratio.abs() < 1.0 => Some(Mode::new(Member::Carrier, Member::Sun)?),
        true => Some(Mode::new(Member::Sun, Member::Carrier)?),
    };
    for sets in 2..=MOST_STAGES {
        let of_each = libm::pow(ratio.abs(), 1.0 / f64::from(sets));
        let has = |ratio: f64, mode: Mode| match bounds.first_for_ratio(
            ratio,
            mode,
            tolerance / f64::from(sets),
            1,
            |_| ControlFlow::Continue(()),
        ) {
            Ok(_) => Ok(true),
            Err(epicyclic_gears::Error::NoToothNumbers { .. }) => Ok(false),
            Err(error) => Err(error),
        };
        if has(of_each * ratio.signum(), mode)? && others.map_or(Ok(true), |others| has(of_each, others))? {
            return Ok(Some(Stages { sets, ratio: of_each, others }));
        }
    }
    Ok(None)
}

impl ToothNumbers {
    /// Set as a gearbox without losses. Its links are its members, and the fixed one is the housing.
    ///
    /// # Errors
    /// No error is known for a set that an answer to this request lists.
    pub fn gearbox(&self, request: &Request) -> Result<Gearbox, Error> {
        let members = gearbox::members(request.simple_mode()?);
        let set = SetSpec::teeth(gearbox::NAME, SetKind::Simple, members, self.sun, self.ring)?;
        gearbox::built(
            request,
            set.planet_teeth(ToothCount::new(self.planet)?, None).planet_count(self.planets),
        )
    }

    fn of(found: &Candidate, rack: &BasicRack) -> Self {
        let imbalance = found.spacing.imbalance();
        Self {
            sun: found.teeth.sun.get(),
            planet: found.teeth.planet.get(),
            ring: found.teeth.ring.get(),
            planets: found.teeth.planets,
            ratio: found.ratio,
            exact_ratio: Fraction::of(found.exact_ratio),
            ratio_error: found.ratio_error,
            most_planets: found.most_planets,
            undercut_sun: found.undercut_sun,
            undercut_planet: found.undercut_planet,
            equal_spacing: found.spacing.is_equal(),
            planet_gap_in_modules: found
                .teeth
                .planet_circle(rack)
                .gap_to_alike(found.spacing.half_gap_sine()),
            planet_angles_rad: found.spacing.angles().into_iter().map(Physical::si).collect(),
            imbalance: if imbalance < ROUNDED { 0.0 } else { imbalance },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::request;

    #[test]
    fn several_sets_have_a_ratio_that_one_has_not() {
        let sun_to_carrier = [Member::Sun, Member::Carrier];
        let stages_within = |ratio: f64, [input, output]: [Member; 2], bounds: &Bounds| {
            let mode = Mode::new(input, output).unwrap();
            let request =
                Request { mode: Some(mode.to_string()), ..request(["--ratio", &ratio.to_string()]).unwrap() };
            stages(&request, bounds).unwrap()
        };
        let found = |ratio: f64, mode| stages_within(ratio, mode, &Bounds::default()).unwrap();
        let two = found(24.0, sun_to_carrier);
        assert!(two.sets == 2 && (two.ratio - 24.0_f64.sqrt()).abs() < 1e-12 && two.others.is_none());
        assert_eq!(found(400.0, sun_to_carrier).sets, 3);
        let negative = found(-24.0, [Member::Sun, Member::Ring]);
        assert_eq!((negative.sets, negative.others.unwrap().to_string()), (2, "aH^b".to_owned()));
        let faster = found(-1.0 / 24.0, [Member::Ring, Member::Sun]);
        assert_eq!((faster.sets, faster.others.unwrap().to_string()), (2, "Ha^b".to_owned()));
        // A mode with the other sign, and bounds with which no number of sets helps.
        assert_eq!(stages_within(-24.0, sun_to_carrier, &Bounds::default()), None);
        let narrow = Bounds { ring_to_sun_ratio: 5.0..=5.0, ..Bounds::default() };
        assert_eq!(stages_within(7.0, sun_to_carrier, &narrow), None);
    }
}
