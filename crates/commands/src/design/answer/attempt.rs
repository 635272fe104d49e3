//! Scheme, tooth numbers and sizes of a gearbox, chosen together.

use super::Wanted;
use super::loaded;
use super::making::{Load, MAKING, for_each_set, shared, warnings, with_load};
use super::records::{OtherScheme, SizesStep, TeethStep, TeethTaken};
use crate::answer::Warning;
use crate::error::Error;
use crate::select::answer::reached::{Asked, ReachedSpeed, largest_deviation};
use crate::select::answer::saved::Saved;
use crate::select::answer::teeth::{At, Watch};
use crate::shared::gearbox::{Choice, one};
use crate::size::answer::{self as size, sizing_of};
use crate::tolerance::OBJECTIVE;
use epicyclic_formats::Document;
use epicyclic_formats::yaml::to_string;
use epicyclic_gears::ToothCount;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_schemes::catalogue::SchemeGear;
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::every::{ToothedMechanism, designs, sets};
use epicyclic_selection::{Candidate, Mechanism};
use epicyclic_strength::lightest::{Costed, Found, Gearbox, Wanted as Searched, lightest};
use epicyclic_strength::sizing::Sizing;
use epicyclic_train::Gear;
use std::ops::ControlFlow;
use uom::si::f64::{AngularVelocity, Torque};

/// Parts of the tolerance within which all deviations count as equal, in increasing order. The next class is
/// searched only if no design of a class keeps to usual practice, and is taken only if its best design misses
/// less of it. So beyond a tenth of the tolerance, accuracy is never traded for mass.
pub(super) const CLASSES: [f64; 3] = [0.1, 1.0 / 3.0, 1.0];

/// Designs of a class that are compared, those nearest to the ratios.
const MOST_COMPARED: usize = 20_000;

/// Gearbox with tooth numbers and sizes, or how far the search for one came.
pub(super) struct Attempt {
    /// Mechanism of the design taken; `None` without one.
    pub(super) mechanism: Option<Mechanism>,
    pub(super) teeth: TeethStep,
    pub(super) sizes: Option<SizesStep>,
    /// Gearbox file with sizes; `None` unless every set has one.
    pub(super) file: Option<String>,
    /// Speeds reached with the chosen tooth numbers.
    pub(super) speeds: Vec<ReachedSpeed>,
    /// The best gearboxes of other schemes.
    pub(super) others: Vec<OtherScheme>,
    pub(super) warnings: Vec<Warning>,
}

impl Attempt {
    /// Chooses among all tooth designs of these mechanisms.
    pub(super) fn of(wanted: &Wanted, mechanisms: &[Mechanism], watch: &Watch) -> Result<Self, Error> {
        let goes_on = || watch(At { share: 0.0, searched: None });
        let search = Search::new(wanted, mechanisms, &goes_on)?;
        let chosen = search.chosen(&goes_on)?;
        let of = |costed: &Costed, number: usize| search.all[costed.place].taken(Some(costed), number);
        let number = wanted.tooth_design.unwrap_or(1).max(1);
        let mut teeth = TeethStep {
            tolerance: chosen.within,
            compared: chosen.compared as u64,
            sized: chosen.found.sized,
            complete: chosen.is_complete(),
            taken: None,
            next: None,
        };
        let best = &chosen.found.best;
        let taken = match best.get(number - 1) {
            Some(taken) => Some((taken.place, of(taken, number))),
            None if wanted.tooth_design.is_some() && !best.is_empty() => {
                return Err(Error::NoSuchDesign { design: number, designs: best.len() });
            }
            None => match &chosen.found.above {
                Some(above) => Some((above.place, of(above, 1))),
                // The nearest one shows what it lacks.
                None => chosen.nearest.map(|place| (place, search.all[place].taken(None, 1))),
            },
        };
        teeth.next = best.get(number).map(|next| of(next, number + 1));
        let others = chosen.found.of_other_groups.iter().map(|other| OtherScheme {
            scheme: name(search.all[other.place].of.mechanism),
            teeth: of(other, 1),
        });
        let others: Vec<OtherScheme> = others.collect();
        let Some((place, taken)) = taken else {
            let (sizes, file, speeds) = (None, None, vec![]);
            return Ok(Self { mechanism: None, teeth, sizes, file, speeds, others, warnings: vec![] });
        };
        teeth.taken = Some(taken);
        let design = &search.all[place];
        let document = search.document(&design.of)?;
        let size = size::answer(&one(&document, &Choice::default())?, &wanted.size, &goes_on)?;
        let is_whole = size.not_sized.is_empty() && size.mass_kg.is_some();
        let file = if is_whole { Some(size::saved(&document, &size)?) } else { None };
        let warnings = warnings(&size, file.as_deref(), &wanted.size)?;
        Ok(Self {
            mechanism: Some(design.of.mechanism),
            teeth,
            sizes: Some(SizesStep::of(size)),
            file,
            speeds: design.speeds.clone(),
            others,
            warnings,
        })
    }
}

/// Name of a mechanism in the source, or that of its structure.
fn name(mechanism: Mechanism) -> String {
    mechanism.scheme().map_or_else(|| mechanism.to_string(), |scheme| scheme.name().to_owned())
}

/// Tooth design with the speeds that it reaches.
struct Design {
    of: ToothedMechanism,
    speeds: Vec<ReachedSpeed>,
    /// Largest relative deviation of a speed or ratio.
    deviation: f64,
}

impl Design {
    fn taken(&self, costed: Option<&Costed>, number: usize) -> TeethTaken {
        let k: Vec<f64> = self.of.teeth.iter().map(ToothNumbers::ring_to_sun_ratio).collect();
        TeethTaken {
            number,
            mass_kg: costed.map(|costed| costed.mass_kg),
            rules_missed: costed.map(|costed| costed.rules_missed),
            sets: self
                .of
                .teeth
                .iter()
                .map(|set| [set.sun, set.planet, set.ring].map(ToothCount::get))
                .collect(),
            ratios: self.of.mechanism.ratios(&k),
        }
    }

    /// Whether the output turns against its input in some gear.
    fn reverses(&self) -> bool {
        self.of.wanted.iter().any(|ratio| *ratio < 0.0)
    }
}

/// Designs chosen within a part of the tolerance.
struct Chosen {
    /// Largest deviation of the designs compared.
    within: f64,
    compared: usize,
    /// Whether more designs lie within this deviation than were compared.
    is_cut: bool,
    /// The design nearest to the ratios that meets the criteria.
    nearest: Option<usize>,
    found: Found,
}

impl Chosen {
    fn is_complete(&self) -> bool {
        self.found.is_complete && !self.is_cut
    }

    /// Sets beyond usual practice and rules that the best design misses.
    fn misses(&self) -> Option<[u32; 2]> {
        self.found.best.first().map(|best| [best.unusual, best.rules_missed])
    }
}

/// Tooth designs with their loads.
struct Search<'a> {
    wanted: &'a Wanted,
    torque: Torque,
    speed: AngularVelocity,
    /// Designs whose gears all turn forward first, then those nearest to the ratios.
    all: Vec<Design>,
}

/// Designs that meet the criteria, with the loads of their sets.
struct Accepted {
    /// Place of the first design that is not looked at yet.
    next: usize,
    places: Vec<usize>,
    gearboxes: Vec<Gearbox>,
    /// A set of the first of these designs, with materials, factors, requirements and space.
    of_set: Option<Sizing>,
}

impl<'a> Search<'a> {
    fn new(
        wanted: &'a Wanted,
        mechanisms: &[Mechanism],
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let selection = &wanted.selection;
        let torque = selection.duty.torque()?.ok_or(Error::NoLoad)?;
        let speed = selection.duty.input_speed.ok_or(Error::LoadWithoutSpeed)?;
        let ratios = selection.requirements.series.braked();
        let asked = Asked { speeds: &selection.speeds, ratios, input: selection.duty.input_speed };
        let sets = sets(&wanted.bounds, wanted.ring_offsets.clone().unwrap_or(0..=0));
        let of_mechanism =
            |mechanism: &Mechanism| designs(*mechanism, &sets, &selection.requirements, goes_on);
        let with_speeds = |of: ToothedMechanism| {
            let k: Vec<f64> = of.teeth.iter().map(ToothNumbers::ring_to_sun_ratio).collect();
            let ratios = of.wanted.iter().copied().zip(of.mechanism.ratios(&k));
            let gears = SchemeGear::BRAKED.into_iter().zip(ratios);
            let speeds = asked.reached(gears.map(|(gear, (wanted, ratio))| (gear, wanted, ratio)));
            let deviation = largest_deviation(&speeds);
            Design { of, speeds, deviation }
        };
        let mut all: Vec<Design> = mechanisms.iter().flat_map(of_mechanism).map(with_speeds).collect();
        if goes_on().is_break() {
            return Err(epicyclic_strength::Error::Cancelled.into());
        }
        all.sort_by(|one, other| {
            one.reverses().cmp(&other.reverses()).then(one.deviation.total_cmp(&other.deviation))
        });
        Ok(Self { wanted, torque, speed, all })
    }

    /// The best designs within the limit of the whole mass: a class of larger deviations, and designs that reverse,
    /// only where they miss less of usual practice, or where no other design holds. Without one the lightest above
    /// the limit is that of all classes.
    fn chosen(&self, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Chosen, Error> {
        let tolerance = self.wanted.selection.requirements.tolerance;
        let forward = self.all.partition_point(|design| !design.reverses());
        let (mut chosen, mut above, mut are_complete) = (None::<Chosen>, None::<Costed>, true);
        for range in [0..forward, forward..self.all.len()] {
            let own = &self.all[range.clone()];
            let mut accepted =
                Accepted { next: range.start, places: vec![], gearboxes: vec![], of_set: None };
            for part in CLASSES {
                let within = part * tolerance;
                let count = own.partition_point(|design| design.deviation <= within + OBJECTIVE);
                let (compared, before) = (count.min(MOST_COMPARED), accepted.places.len());
                self.accept(range.start + compared, &mut accepted, goes_on)?;
                // The same designs have the same best one.
                if accepted.places.len() == before
                    && chosen.as_ref().is_some_and(|chosen| chosen.nearest.is_some())
                {
                    continue;
                }
                let (nearest, found) = (accepted.places.first().copied(), self.best(&accepted, goes_on)?);
                let next = Chosen { within, compared, is_cut: count > compared, nearest, found };
                are_complete &= next.is_complete();
                let lightest = |one: &Costed, other: &Costed| one.whole_kg.total_cmp(&other.whole_kg);
                above = above.into_iter().chain(next.found.above).min_by(lightest);
                let is_better = match (chosen.as_ref(), next.misses()) {
                    (Some(chosen), Some(next)) => chosen.misses().is_none_or(|misses| next < misses),
                    // A wider class has the same nearest design.
                    (Some(chosen), None) => {
                        chosen.misses().is_none()
                            && (chosen.nearest.is_none() || chosen.nearest == next.nearest)
                    }
                    (None, _) => true,
                };
                if is_better {
                    chosen = Some(next);
                }
                let is_usual =
                    chosen.as_ref().and_then(Chosen::misses).is_some_and(|[unusual, _]| unusual == 0);
                if tolerance == 0.0 || is_usual {
                    break;
                }
            }
            if chosen.as_ref().is_some_and(|chosen| chosen.misses().is_some()) {
                break;
            }
        }
        let mut chosen = chosen.expect("there are classes");
        if chosen.found.best.is_empty() {
            (chosen.found.above, chosen.found.is_complete) = (above, are_complete);
        }
        Ok(chosen)
    }

    /// Adds the designs before a place that meet the criteria.
    fn accept(
        &self,
        to: usize,
        accepted: &mut Accepted,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<(), Error> {
        let requirements = &self.wanted.selection.requirements;
        while accepted.next < to {
            if goes_on().is_break() {
                return Err(epicyclic_strength::Error::Cancelled.into());
            }
            let place = accepted.next;
            accepted.next += 1;
            let design = &self.all[place].of;
            let candidate = self.candidate(design)?;
            if !candidate.is_accepted() {
                continue;
            }
            if accepted.of_set.is_none() {
                let document = self.document(design)?;
                accepted.of_set = Some(sizing_of(&one(&document, &Choice::default())?, &self.wanted.size)?);
            }
            let saved = Saved::of(&candidate, requirements, &[], vec![])?;
            let is_alike = |other: &usize| {
                let other = &self.all[*other].of;
                other.mechanism == design.mechanism && other.wanted == design.wanted
            };
            let (group, rules_missed) = match accepted.places.iter().position(is_alike) {
                Some(first) => (accepted.gearboxes[first].group, accepted.gearboxes[first].rules_missed),
                None => {
                    let [errors, warnings, _] = saved.judged(&candidate, requirements).misses();
                    (place, u32::try_from(errors + warnings).unwrap_or(u32::MAX))
                }
            };
            let gears = saved.gearbox.gears().iter().map(Gear::name).collect();
            let shares = shared(gears, &self.wanted.shares)?;
            let teeth: Vec<_> =
                design.teeth.iter().map(|teeth| [teeth.sun, teeth.planet, teeth.ring]).collect();
            let overload = accepted.of_set.as_ref().and_then(|set| set.overloads.first());
            let load = (self.load(), self.wanted.size.application);
            let (sets, others_kg) = loaded::sets(&saved.gearbox, &teeth, &shares, load, overload)?;
            accepted.places.push(place);
            accepted.gearboxes.push(Gearbox { group, sets, rules_missed, others_kg });
        }
        Ok(())
    }

    /// The best of these designs within the limit of the whole mass.
    fn best(&self, accepted: &Accepted, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Found, Error> {
        let Accepted { places, gearboxes, of_set, .. } = accepted;
        let Some(of_set) = of_set else { return Ok(Found::default()) };
        let most = self.wanted.tooth_design.unwrap_or(1) + 1;
        let whole_kg = self.wanted.limits.whole_kg;
        let mut found = lightest(of_set, gearboxes, Searched { most, whole_kg }, goes_on)?;
        for costed in found.best.iter_mut().chain(&mut found.of_other_groups).chain(&mut found.above) {
            costed.place = places[costed.place];
        }
        Ok(found)
    }

    fn candidate(&self, design: &ToothedMechanism) -> Result<Candidate, Error> {
        let requirements = &self.wanted.selection.requirements;
        let ToothedMechanism { mechanism, wanted, teeth, .. } = design;
        Ok(Candidate::of_teeth(*mechanism, teeth, wanted, requirements, Some(&drawable_direct_clutches))?)
    }

    /// Load of the input in every gear.
    fn load(&self) -> Load<'_> {
        let overload = self.wanted.overload;
        Load { torque: self.torque, speed: self.speed, overload, spectrum: &self.wanted.spectrum }
    }

    /// Gearbox file of a design with its duty and the data for its strength. The number of planets and the
    /// profile shifts are left to the sizing.
    fn document(&self, design: &ToothedMechanism) -> Result<Document, Error> {
        let candidate = self.candidate(design)?;
        let teeth: Vec<_> = design.teeth.iter().map(|teeth| (*teeth, None)).collect();
        let saved = Saved::of(&candidate, &self.wanted.selection.requirements, &teeth, vec![])?;
        let text = saved.file(&[]).map_err(|error| Error::Json(error.to_string()))?;
        let mut file = Document::parse_one(MAKING, text.as_bytes())?.value().clone();
        for_each_set(&mut file, |set| {
            for key in ["planets", "profile_shifts", "tip_alterations"] {
                set.remove(key);
            }
        });
        let gears = shared(saved.gearbox.gears().iter().map(Gear::name).collect(), &self.wanted.shares)?;
        with_load(&mut file, &self.wanted.basis, &gears, self.load());
        if let Some(file) = file.as_mapping_mut() {
            file.insert("gearbox".into(), saved.scheme.as_str().into());
        }
        let text = to_string(&file).map_err(|error| Error::Json(error.to_string()))?;
        Ok(Document::parse_one(MAKING, text.as_bytes())?)
    }
}
