//! The teeth of a motor: their limits, and how near they come over a revolution.

use super::design::{Drawn, refuse};
use super::facts::modules;
use super::lists::{Warnings, verdict};
use crate::failure::Failure;
use epicyclic_formats::Dimension;
use epicyclic_formats::quantity::format;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::profile::clearance::Nearest;
use epicyclic_hydromotor::profile::limits::{Bound, LimitKind};
use epicyclic_hydromotor::profile::{Part as ToothPart, Profile};
use epicyclic_views::figure::{Figure, column};
use epicyclic_views::report::{Column, Part, Records, View, wrapped};
use uom::si::f64::{Angle, Length};

/// Rotations of half a period at which clearances are looked for, besides the refined one.
const STEPS: u32 = 180;

pub(super) fn parts(drawn: &Drawn, warnings: &mut Warnings) -> Result<Vec<Part>, Failure> {
    match &drawn.profile {
        Ok(profile) => {
            Ok(vec![Part::Records(limits(profile, warnings)), Part::Records(clearances(profile, warnings)?)])
        }
        Err(error) => {
            let message = format!("no teeth of this form on this motor: {error}");
            let words = format!("Teeth: none\n{}", wrapped("", &error.to_string()));
            warnings.push(("no-teeth", message));
            Ok(vec![Part::Words(words)])
        }
    }
}

const fn kind(kind: LimitKind) -> (&'static str, &'static str) {
    match kind {
        LimitKind::Undercut => ("undercut", "undercut: path to its start"),
        LimitKind::TipCusp => ("tip-cusp", "cusp at the tip: path to it"),
        LimitKind::SatelliteRoot => ("satellite-root", "reach into the satellite: path"),
        LimitKind::WheelRoot => ("wheel-root", "reach of the satellite: path"),
        LimitKind::TipThickness => ("tip-thickness", "thickness of the thinnest tip"),
        LimitKind::ContactPath => ("contact-path", "shortest path of contact"),
        LimitKind::RootCurve => ("root-curve", "root curve without cusps"),
        LimitKind::TipCurve => ("tip-curve", "tip curve without cusps"),
        LimitKind::Neighbours => ("neighbours", "satellites' centres, distance"),
        LimitKind::Wheels => ("wheels", "stator above the rotor"),
    }
}

const fn wheel(wheel: Wheel) -> (&'static str, &'static str) {
    match wheel {
        Wheel::Stator => ("stator", "stator"),
        Wheel::Rotor => ("rotor", "rotor"),
        Wheel::Satellite => ("satellite", "satellite"),
    }
}

fn limits(profile: &Profile, warnings: &mut Warnings) -> Records {
    let mut rows = vec![];
    for limit in profile.limits() {
        let ((name, words), (whose, _)) = (kind(limit.kind), wheel(limit.wheel));
        let sense = match limit.sense {
            Bound::AtLeast => Figure::Answer("at-least", "at least"),
            Bound::AtMost => Figure::Answer("at-most", "at most"),
        };
        if !limit.holds() {
            let [value, bound] = [limit.value, limit.bound].map(|length| format::quantity(length, 4));
            let side = sense.table();
            warnings.push((name, format!("teeth of the {whose}: {words}: {value}, allowed {side} {bound}")));
        }
        let (key, shown) = wheel(limit.wheel);
        rows.push(vec![
            Figure::Answer(key, shown),
            Figure::Answer(name, words),
            column(Some(limit.value)),
            sense,
            column(Some(limit.bound)),
            verdict(limit.holds(), limit.margin(), limit.bound),
            column(limit.at),
        ]);
    }
    let quantity = |name, heading: &str| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, Dimension::Length)
    };
    Records {
        name: "tooth_limits",
        columns: vec![
            Column::words("wheel", "teeth of"),
            Column::words("limit", "limit"),
            quantity("value", "mm"),
            Column::words("side", ""),
            quantity("bound", "mm"),
            Column::words("verdict", "verdict"),
            quantity("at_arc", "at arc, mm"),
        ],
        rows,
        views: vec![View::new(
            "Limits of the teeth",
            &["wheel", "limit", "value", "side", "bound", "verdict"],
        )],
        is_answer: false,
    }
}

fn clearances(profile: &Profile, warnings: &mut Warnings) -> Result<Records, Failure> {
    let found = profile.clearances(STEPS).map_err(refuse)?;
    let module = profile.motor().module();
    let part = |part: ToothPart| match part {
        ToothPart::Tip => Figure::Answer("tip", "tip"),
        ToothPart::Flank => Figure::Answer("flank", "flank"),
        ToothPart::Fillet => Figure::Answer("fillet", "fillet"),
        ToothPart::Root => Figure::Answer("root", "root"),
    };
    let mut rows = vec![];
    let mut add = |name: &'static str,
                   words,
                   clearance: Length,
                   part,
                   at: Option<Angle>,
                   point: [Option<Length>; 2]| {
        if clearance < Length::default() {
            let overlap = format::quantity(-clearance, 4);
            warnings.push(("overlap", format!("{words}: they overlap by {overlap}")));
        }
        rows.push(vec![
            Figure::Answer(name, words),
            column(Some(clearance)),
            Figure::Multiple(modules(clearance, module)),
            part,
            column(at),
            column(point[0]),
            column(point[1]),
        ]);
    };
    let mut wheel = |name, words, nearest: &Nearest| {
        // Flanks in mesh are equally near all along: where rounding finds them nearest says nothing.
        let in_mesh = nearest.part == ToothPart::Flank && nearest.clearance >= Length::default();
        let [x, y] = [nearest.at.x, nearest.at.y].map(|x| (!in_mesh).then_some(x));
        let rotation = (!in_mesh).then_some(nearest.rotation);
        add(name, words, nearest.clearance, part(nearest.part), rotation, [x, y]);
    };
    wheel("stator", "satellites and stator", &found.stator);
    wheel("rotor", "satellites and rotor", &found.rotor);
    let (distance, rotation) = found.neighbours;
    add(
        "neighbours",
        "tips of neighbouring satellites",
        distance,
        Figure::None,
        Some(rotation),
        [None, None],
    );
    add("wheels", "tips of rotor and stator", found.wheels, Figure::None, None, [None, None]);
    let quantity = |name, heading: &str, dimension| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, dimension)
    };
    Ok(Records {
        name: "clearances",
        columns: vec![
            Column::words("between", "between"),
            quantity("clearance", "least, mm", Dimension::Length),
            Column::number("clearance_in_modules", "modules"),
            Column::words("part", "at the wheel's"),
            quantity("rotation", "rotor at, deg", Dimension::Angle),
            quantity("x", "x, mm", Dimension::Length),
            quantity("y", "y, mm", Dimension::Length),
        ],
        rows,
        views: vec![View {
            note: "Flanks in mesh keep their distance all along.".to_owned(),
            ..View::new(
                "Clearances of the teeth over a revolution, satellites amid their backlash",
                &["between", "clearance", "clearance_in_modules", "part", "rotation"],
            )
        }],
        is_answer: false,
    })
}
