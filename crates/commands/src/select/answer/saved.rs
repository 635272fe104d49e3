//! Design as a gearbox, for a file that `analyze`, `draw` and `report` read.

use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::judgement::whole::FoundRatio;
use crate::shared::number::short;
use crate::shared::saved::names;
use crate::teeth::answer::shifted::SetShifts;
use epicyclic_formats::gearbox::{NotWritable, WrittenSize, written_with_sizes};
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_selection::{Candidate, GearReport, Requirements};
use epicyclic_train::set::{Gearing, SetSpec};
use epicyclic_train::{GearSpec, Gearbox};

/// Design as a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Saved {
    /// Name of the scheme in the source, or that of the structure.
    pub scheme: String,
    /// Gearbox with its brakes K1 and K2, the chosen direct-drive clutch, and its gears, the slowest first:
    /// forward gears `1`, `2`, … and reverse `R`.
    pub gearbox: Gearbox,
    /// Module and face width of each set at the load factor; empty if unknown.
    pub sizes: Vec<WrittenSize>,
}

impl Saved {
    /// Converts a candidate. If it has teeth, `teeth` holds the tooth numbers of each set, with its profile
    /// shifts if any.
    pub(crate) fn of(
        candidate: &Candidate,
        requirements: &Requirements,
        teeth: &[(ToothNumbers, Option<SetShifts>)],
        sizes: Vec<WrittenSize>,
    ) -> Result<Self, Error> {
        let scheme = candidate
            .mechanism
            .scheme()
            .map_or_else(|| candidate.mechanism.to_string(), |scheme| scheme.name().to_owned());
        let mut of_sets = teeth.iter();
        let gearbox = candidate.gearbox(requirements)?;
        // Ratios follow the order of the gears: braked, then direct.
        let ratios: Vec<f64> = candidate.gears.iter().map(|gear| gear.ratio).chain([1.0]).collect();
        let names = names(&ratios);
        let mut falling: Vec<usize> = (0..ratios.len()).collect();
        // Forward gears come first, then reverse gears, each from the slowest.
        falling.sort_by(|one, other| {
            let of = |gear: &usize| (ratios[*gear] < 0.0, -ratios[*gear].abs());
            let ((one, slow), (other, slower)) = (of(one), of(other));
            one.cmp(&other).then(slow.total_cmp(&slower))
        });
        let engaged = |gear: usize| {
            let of = gearbox.gears()[gear].engaged().iter();
            of.map(|&place| gearbox.shift_elements()[place].id().to_owned()).collect()
        };
        let mut gears = falling.iter().map(|&gear| (names[gear].clone(), engaged(gear)));
        let gearbox = gearbox
            .to_builder()
            .map_gears(|gear| match gears.next() {
                None => gear,
                Some((name, engaged)) => GearSpec { name, engaged, ..gear },
            })
            .map_sets(|set| match of_sets.next() {
                None => match set.gearing {
                    Gearing::BasicRatio(k) => SetSpec { gearing: Gearing::BasicRatio(short(k)), ..set },
                    Gearing::Teeth(..) => set,
                },
                Some((of, shifts)) => {
                    let set = SetSpec { gearing: Gearing::Teeth(of.sun, of.ring), ..set }
                        .planet_teeth(of.planet, None)
                        .planet_count(of.planets);
                    match shifts {
                        None => set,
                        Some(shifts) => shifts.put_into(set),
                    }
                }
            })
            .build()?;
        Ok(Self { scheme, gearbox, sizes })
    }

    /// Judgement of the gearbox by rules of practice, with the ratios of the candidate's braked gears.
    pub(crate) fn judged(&self, candidate: &Candidate, requirements: &Requirements) -> Judgement {
        let ratio = |gear: &GearReport| FoundRatio {
            gear: gear.gear.name().to_owned(),
            wanted: gear.wanted,
            tolerance: requirements.tolerance,
            found: gear.ratio,
        };
        let ratios: Vec<FoundRatio> = candidate.gears.iter().map(ratio).collect();
        Judgement::of_found(&self.gearbox, &self.sizes, &ratios)
    }

    /// Gearbox file below these lines of comment.
    ///
    /// # Errors
    /// No error is known, because every set of a design has a short form.
    pub fn file(&self, comment: &[String]) -> Result<String, NotWritable> {
        written_with_sizes(&self.gearbox, &self.sizes, comment)
    }
}
