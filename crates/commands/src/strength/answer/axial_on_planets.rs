//! Axial forces that stay on planets, which no life of their bearings contains.

use super::axial;
use super::duty::WorkedStep;
use super::load::SetLoad;
use super::rated_set::RatedSet;
use crate::answer::Warning;
use crate::shared::gearbox::Gearbox;
use epicyclic_units::format::trimmed;

/// Significant digits of a force in a warning.
const FORCE_DIGITS: usize = 4;

/// Warning that planets with rated bearings keep an axial force over the duty, as stepped ones do: forces and
/// lives of their bearings leave it out.
pub(super) fn warning(subject: &Gearbox, set: &RatedSet<'_>, duty: &[WorkedStep<'_>]) -> Option<Warning> {
    let bearings = || subject.planet_bearings.iter().filter(|own| own.set == set.place);
    if !bearings().any(|own| own.load_rating.is_some()) {
        return None;
    }
    let loads = duty.iter().filter_map(|WorkedStep(entry, worked)| {
        SetLoad::of(set.place, worked.as_ref()?, Some(entry.speed.0)).ok()
    });
    let all = loads.flat_map(|load| axial::of(subject, set, "", None, &load));
    let on_planets = all.filter(|one| one.tilting_moment_n_m.is_some()).map(|one| one.axial_force_n.abs());
    let greatest = on_planets.fold(0.0, f64::max);
    (greatest > 0.0).then(|| Warning {
        name: "axial-force",
        message: format!(
            "set {}: helical teeth leave up to {} N along the axis on a planet; forces and lives of its bearings leave this force out",
            set.id,
            trimmed(greatest, FORCE_DIGITS)
        ),
    })
}
