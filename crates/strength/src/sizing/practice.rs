//! Usual practice in a search: how far gears, widths and bearings of a design keep to it.
//!
//! Designs come in ranks: those that keep all rules, then those with warnings. Remarks do not count. Errors
//! leave designs out. The rules are those of [`practice`](epicyclic_gears::involute::practice) for gears and
//! meshes, [`Rule::FaceWidth`] for each external mesh, [`Rule::HardenedTips`], and [`Rule::BallLoad`].

use super::task::{Body, Layout, Task};
use crate::material::Class;
use epicyclic_gears::involute::practice::{of_mesh, of_shift, shift_rule};
use epicyclic_judge::{Limits, Rule, Severity};
use epicyclic_units::Physical;

/// A layout under the rules.
#[derive(Debug, Clone)]
pub(super) struct Practice {
    /// The worst that its gears and meshes have.
    pub(super) geometry: Option<Severity>,
    /// Reference diameter of the smaller gear of each external mesh, by family, m.
    diameters: Vec<Vec<f64>>,
}

impl Practice {
    pub(super) fn of(task: &Task, layout: &Layout, limits: &Limits) -> Self {
        let is_of_pair = task.planets.is_empty();
        let shifts = layout.gears.iter().zip(&task.gears).enumerate().map(|(place, (gear, sized))| {
            let own = task.meshes.iter().zip(&layout.pairs).filter(|(mesh, _)| mesh.gears.contains(&place));
            let rule = shift_rule(gear, sized.body != Body::Central, is_of_pair);
            let verdict = of_shift(limits, rule, gear, own.map(|(_, pair)| pair));
            // Shifts that a file states are asked for.
            if task.has_stated_shifts { verdict.no_worse_than(Severity::Warning) } else { verdict }
        });
        let meshes = layout.pairs.iter().flat_map(|pair| of_mesh(limits, pair)).map(|(_, verdict)| verdict);
        let hard = layout
            .gears
            .iter()
            .zip(&task.gears)
            .filter(|(_, sized)| sized.gear.material.class == Class::CaseHardened);
        let tips = hard.map(|(gear, _)| limits.judge(Rule::HardenedTips, gear.tip_thickness()));
        let geometry = shifts.chain(meshes).chain(tips).filter_map(|verdict| verdict.severity).max();
        let mut diameters = vec![vec![]; task.face_widths.len()];
        for (mesh, pair) in task.meshes.iter().zip(&layout.pairs).filter(|(_, pair)| !pair.is_internal()) {
            let family = task.gears[mesh.gears[0]].family;
            let [one, other] = pair.gears().map(|gear| gear.reference_diameter());
            diameters[family].push(one.min(other) * layout.modules[family].si());
        }
        Self { geometry, diameters }
    }

    /// The worst that face widths have, and whether a wider one may be better.
    pub(super) fn of_widths(&self, limits: &Limits, widths: &[f64]) -> (Option<Severity>, bool) {
        let ratios = self.diameters.iter().zip(widths);
        let ratios = ratios.flat_map(|(own, width)| own.iter().map(move |diameter| width / diameter));
        let missed = ratios.map(|ratio| limits.judge(Rule::FaceWidth, ratio)).filter(|one| !one.holds());
        missed.fold((None, false), |(worst, is_narrow), one| {
            (worst.max(one.severity), is_narrow || one.value < one.limit)
        })
    }
}

/// Whether a ball bearing carries more than is usual.
pub(super) fn is_overloaded(limits: &Limits, load_n: f64) -> bool {
    limits.judge(Rule::BallLoad, load_n / 1e3).severity >= Some(Severity::Warning)
}

/// Rank of a design by its worst verdict: 0 without warnings.
pub(super) fn rank(worst: Option<Severity>) -> f64 {
    if worst >= Some(Severity::Warning) { 1.0 } else { 0.0 }
}
