//! Lists of a motor: its checks, limits and clearances of its teeth, its chambers and satellites.

use crate::motor::answer::Between;
use crate::motor::answer::{ChamberState, Clearance, Motor, ToothLimit, Verdict};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::quantities::words;
use crate::table::report::Records;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::profile::Part;
use epicyclic_hydromotor::profile::limits::{Bound, LimitKind};
use epicyclic_units::Dimension::{Angle, Area, Force, Length, Pressure};

fn verdict(verdict: Verdict) -> Figure {
    match verdict {
        Verdict::Holds => Figure::answer("holds", "holds"),
        Verdict::Near => Figure::answer("near", "near"),
        Verdict::Fails => Figure::answer("fails", "FAILS"),
    }
}

/// The name of a check.
pub(crate) const fn subject(subject: Subject) -> &'static str {
    match subject {
        Subject::StatorBulge => "stator_bulge",
        Subject::StatorHollow => "stator_hollow",
        Subject::RotorBulge => "rotor_bulge",
        Subject::RotorHollow => "rotor_hollow",
        Subject::RotorLeastRadius => "rotor_least_radius",
        Subject::Neighbours => "neighbours",
    }
}

pub(crate) fn checks(motor: &Motor) -> Records {
    Table::new("checks", motor.checks.iter())
        .words("check", "centrode", |check| Figure::answer(subject(check.check), check.check.words()))
        .quantity("value", "value", Length, |check| check.value_m)
        .quantity("limit", "above", Length, |check| check.limit_m)
        .words("verdict", "verdict", |check| verdict(check.verdict))
        .view("Curvatures and distances against satellites and tooth heights", "check value limit verdict")
        .records()
}

pub(crate) fn limits(limits: &[ToothLimit]) -> Records {
    let kind = |kind| match kind {
        LimitKind::Undercut => "undercut",
        LimitKind::TipCusp => "tip_cusp",
        LimitKind::SatelliteRoot => "satellite_root",
        LimitKind::WheelRoot => "wheel_root",
        LimitKind::TipThickness => "tip_thickness",
        LimitKind::ContactPath => "contact_path",
        LimitKind::RootCurve => "root_curve",
        LimitKind::TipCurve => "tip_curve",
        LimitKind::Neighbours => "neighbours",
        LimitKind::Wheels => "wheels",
    };
    let wheel = |wheel| match wheel {
        Wheel::Stator => "stator",
        Wheel::Rotor => "rotor",
        Wheel::Satellite => "satellite",
    };
    let side = |side| match side {
        Bound::AtLeast => "at_least",
        Bound::AtMost => "at_most",
    };
    Table::new("tooth_limits", limits.iter())
        .words("wheel", "teeth of", |limit| Figure::answer(wheel(limit.wheel), limit.wheel.words()))
        .words("limit", "limit", |limit| Figure::answer(kind(limit.limit), limit.limit.words()))
        .quantity("value", "", Length, |limit| limit.value_m)
        .words("side", "", |limit| Figure::answer(side(limit.side), limit.side.words()))
        .quantity("bound", "", Length, |limit| limit.bound_m)
        .words("verdict", "verdict", |limit| verdict(limit.verdict))
        .quantity("at_arc", "at arc", Length, |limit| limit.at_arc_m)
        .view("Limits of the teeth", "wheel limit value side bound verdict")
        .records()
}

pub(crate) fn clearances(clearances: &[Clearance]) -> Records {
    let between = |between| match between {
        Between::Stator => "stator",
        Between::Rotor => "rotor",
        Between::Neighbours => "neighbours",
        Between::Wheels => "wheels",
    };
    let part = |part| match part {
        None => Figure::None,
        Some(Part::Tip) => Figure::answer("tip", "tip"),
        Some(Part::Flank) => Figure::answer("flank", "flank"),
        Some(Part::Fillet) => Figure::answer("fillet", "fillet"),
        Some(Part::Root) => Figure::answer("root", "root"),
    };
    Table::new("clearances", clearances.iter())
        .words("between", "between", |clearance| {
            Figure::answer(between(clearance.between), clearance.between.words())
        })
        .quantity("clearance", "least", Length, |clearance| clearance.clearance_m)
        .multiple("clearance_in_modules", "modules", |clearance| clearance.clearance_in_modules)
        .words("part", "at the wheel's", |clearance| part(clearance.part))
        .quantity("rotation", "rotor at", Angle, |clearance| clearance.rotation_rad)
        .quantity("x", "x", Length, |clearance| clearance.x_m)
        .quantity("y", "y", Length, |clearance| clearance.y_m)
        .view(
            "Clearances of the teeth over a revolution, satellites amid their backlash",
            "between clearance clearance_in_modules part rotation",
        )
        .note("Flanks in mesh keep their distance all along.")
        .records()
}

pub(crate) fn chambers(motor: &Motor) -> Records {
    let state = |state| match state {
        ChamberState::Filling => Figure::answer("filling", "fills, high pressure"),
        ChamberState::Emptying => Figure::answer("emptying", "empties, low pressure"),
        ChamberState::ChangingOver => Figure::answer("changing_over", "changes over"),
    };
    let note = "Counter-clockwise from the x axis, which runs through a crest of the stator; running \
                   counter-clockwise.";
    Table::new("chambers", motor.chambers.iter())
        .number("chamber", "chamber", |chamber| chamber.chamber)
        .quantity("area", "area", Area, |chamber| chamber.area_m2)
        .headed("growth_per_radian", "growth, mm²/rad", Area, |chamber| chamber.growth_per_radian_m2)
        .words("state", "state", |chamber| state(chamber.state))
        .view(
            format!("Chambers, rotor turned by {}", words(Angle, motor.angle_rad, 6)),
            "chamber area growth_per_radian state",
        )
        .note(note)
        .records()
}

pub(crate) fn satellites(motor: &Motor) -> Records {
    let has_forces = motor.satellites.iter().any(|satellite| satellite.force_n.is_some());
    let has_flanks = motor.satellites.iter().any(|satellite| satellite.flank_force_n.is_some());
    let note = if has_forces {
        "Force of the pressures, positive counter-clockwise across the ray from the axis. Low pressure counts as 0."
    } else {
        ""
    };
    Table::new("satellites", &motor.satellites)
        .number("satellite", "satellite", |satellite| satellite.satellite)
        .quantity("x", "x", Length, |satellite| satellite.x_m)
        .quantity("y", "y", Length, |satellite| satellite.y_m)
        .headed("rotation", "turned, deg", Angle, |satellite| satellite.rotation_rad)
        .quantity("pressure_behind", "behind", Pressure, |satellite| satellite.pressure_behind_pa)
        .only_if(has_forces)
        .quantity("pressure_in_front", "in front", Pressure, |satellite| satellite.pressure_in_front_pa)
        .only_if(has_forces)
        .quantity("force", "force", Force, |satellite| satellite.force_n)
        .only_if(has_forces)
        .headed("flank_force", "on a flank", Force, |satellite| satellite.flank_force_n)
        .only_if(has_flanks)
        .all(format!("Satellites, rotor turned by {}", words(Angle, motor.angle_rad, 6)))
        .note(note)
        .records()
}
