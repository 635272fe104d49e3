//! Lists of a motor: its checks, limits and clearances of its teeth, its chambers and satellites.

use crate::motor::answer::{Clearance, Motor, ToothLimit, Verdict};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::quantities::words;
use crate::table::report::Records;
use epicyclic_hydromotor::chambers::Phase;
use epicyclic_hydromotor::profile::Part;
use epicyclic_units::Dimension::{Angle, Area, Force, Length, Pressure};

fn verdict(verdict: Verdict) -> Figure {
    let words = match verdict {
        Verdict::Holds => "holds",
        Verdict::Near => "near",
        Verdict::Fails => "FAILS",
    };
    Figure::choice(verdict, words)
}

pub(crate) fn checks(motor: &Motor) -> Records {
    Table::new("checks", motor.checks.iter())
        .words("check", "centrode", |check| Figure::choice(check.check, check.check.words()))
        .quantity("value", "value", Length, |check| check.value_m)
        .quantity("limit", "above", Length, |check| check.limit_m)
        .words("verdict", "verdict", |check| verdict(check.verdict))
        .view("Curvatures and distances against satellites and tooth heights", "check value limit verdict")
        .records()
}

pub(crate) fn limits(limits: &[ToothLimit]) -> Records {
    Table::new("tooth_limits", limits.iter())
        .words("wheel", "teeth of", |limit| Figure::choice(limit.wheel, limit.wheel.words()))
        .words("limit", "limit", |limit| Figure::choice(limit.limit, limit.limit.words()))
        .quantity("value", "", Length, |limit| limit.value_m)
        .words("side", "", |limit| Figure::choice(limit.side, limit.side.words()))
        .quantity("bound", "", Length, |limit| limit.bound_m)
        .words("verdict", "verdict", |limit| verdict(limit.verdict))
        .quantity("at_arc", "at arc", Length, |limit| limit.at_arc_m)
        .view("Limits of the teeth", "wheel limit value side bound verdict")
        .records()
}

pub(crate) fn clearances(clearances: &[Clearance]) -> Records {
    let part = |part: Part| {
        let words = match part {
            Part::Tip => "tip",
            Part::Flank => "flank",
            Part::Fillet => "fillet",
            Part::Root => "root",
        };
        Figure::choice(part, words)
    };
    Table::new("clearances", clearances.iter())
        .words("between", "between", |clearance| Figure::choice(clearance.between, clearance.between.words()))
        .quantity("clearance", "least", Length, |clearance| clearance.clearance_m)
        .multiple("clearance_in_modules", "modules", |clearance| clearance.clearance_in_modules)
        .words("part", "at the wheel's", |clearance| clearance.part.map_or(Figure::None, part))
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
    let state = |state| {
        let words = match state {
            Phase::Filling => "fills, high pressure",
            Phase::Emptying => "empties, low pressure",
            Phase::AtExtreme => "changes over",
        };
        Figure::choice(state, words)
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
