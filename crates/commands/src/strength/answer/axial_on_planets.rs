//! Axial forces that stay on planets, and couples of their steps, which no life of their bearings contains.

use super::axial;
use super::duty::WorkedStep;
use super::load::SetLoad;
use super::rated_set::RatedSet;
use crate::analyze::answer::warnings::STEP_COUPLE;
use crate::answer::Warning;
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_units::format::trimmed;

/// Significant digits of a force or moment in a warning.
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

/// Warning that the steps of planets with rated bearings, which lie side by side, tilt them over the duty: lives of
/// their bearings leave this moment out.
pub(super) fn couple(
    subject: &Gearbox,
    file: &GearboxFile,
    set: &RatedSet<'_>,
    duty: &[WorkedStep<'_>],
) -> Option<Warning> {
    let data = file.set_data(set.set)?;
    let is_left_out = |planet: &usize| {
        let own = data.planets.get(*planet);
        set.set.is_stepped(*planet)
            && own.is_some_and(|own| own.bearing.is_some() && own.bearing_span.is_none())
    };
    let stepped: Vec<usize> = (0..set.set.planets().len()).filter(is_left_out).collect();
    if stepped.is_empty() {
        return None;
    }
    let widths = data.face_widths.iter().copied().collect::<Option<Vec<_>>>()?;
    let teeth = (&set.toothed, subject.is_behind(set.set));
    let moments =
        duty.iter().filter_map(|step| step.1.as_ref()?.member_torques(set.place)).flat_map(|torques| {
            let of = |planet: &usize| set.set.step_couple(*planet, teeth, &torques, &widths);
            stepped.iter().filter_map(of).map(|[out, along]| libm::hypot(out, along)).collect::<Vec<_>>()
        });
    let greatest = moments.fold(0.0, f64::max);
    (greatest > 0.0).then(|| Warning {
        name: STEP_COUPLE,
        message: format!(
            "set {}: the steps of a planet, side by side, tilt it by up to {} N·m; lives of its bearings leave this moment out, and contain it with `bearing_span`",
            set.id,
            trimmed(greatest, FORCE_DIGITS)
        ),
    })
}
