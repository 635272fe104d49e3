//! Greatest and least speed of a bucket wheel.

use super::Rotor;
use super::list::in_words;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_formats::{Dimension, Physical, Quantity};
use epicyclic_schemes::DesignError;
use epicyclic_schemes::machines::recommended_speeds;
use epicyclic_schemes::rotor::{
    discharge, greatest_speed, least_speed, optimal_speed, speed_range, standard_gravity,
};
use epicyclic_views::figure::{Figure, column, quantity};
use epicyclic_views::report::{Column, Part, Records, Report, Row, Section, View};
use uom::si::f64::{Angle, AngularVelocity};

/// The whole answer.
pub(super) fn report(args: &Rotor) -> Result<Report, DesignError> {
    let optimal = optimal_speed(
        args.boom_radius.0,
        args.slewing.0,
        args.chip_width.0,
        args.buckets,
        args.boom_angle.0,
    )?;
    let greatest = greatest_speed(optimal)?;
    let found = discharges(args)?;
    let discharge = found.iter().map(|(value, _)| *value).fold(f64::INFINITY, f64::min);
    let least = least_speed(discharge, standard_gravity(), args.wheel_radius.0)?;
    let d = speed_range(greatest, least)?;
    let row = |name, label, symbol, speed: AngularVelocity| Row {
        remark: format!("{} rad/s", trimmed(speed.si(), 5)),
        ..Row::new(name, label, symbol, [quantity(speed)])
    };
    let rows = vec![
        row("optimal", "a bucket a chip", "ω_po", optimal),
        row("greatest", "greatest", "ω_max", greatest),
        row("least", "least", "ω_min", least),
    ];
    let mut facts =
        vec![Part::Facts(Section { name: "wheel", title: "Bucket wheel", columns: &[], rows, note: "" })];
    let computed: Vec<Vec<Figure>> = found
        .iter()
        .filter_map(|(value, chute)| {
            let counts = Figure::YesNo(*value == discharge);
            Some(vec![column(Some((*chute)?.0)), Figure::Multiple(*value), counts])
        })
        .collect();
    if !computed.is_empty() {
        facts.push(Part::Records(discharge_table(computed)));
    }
    let mut range = vec![Row::new("range", "greatest over least", "d", [Figure::Multiple(d)])];
    if let Ok(recommended) = recommended_speeds(d) {
        range.push(Row {
            remark: in_words(recommended).to_owned(),
            ..Row::new("recommended", "speeds recommended", "", [Figure::Count(recommended.speeds)])
        });
    }
    let note = if d > 1.0 {
        ""
    } else {
        "The wheel would have to turn faster to throw than it may to empty: no speed does."
    };
    facts.push(Part::Facts(Section { name: "range", title: "Range", columns: &[], rows: range, note }));
    Ok(Report { title: None, parts: facts, warnings: None })
}

fn discharge_table(rows: Vec<Vec<Figure>>) -> Records {
    Records {
        name: "discharges",
        columns: vec![
            Column { heading: "chute at, deg".to_owned(), ..Column::quantity("chute", Dimension::Angle) },
            Column::number("discharge", "Ω"),
            Column::words("counts", "counts"),
        ],
        rows,
        views: vec![View::new("Discharge parameter: the smaller counts", &["chute", "discharge", "counts"])],
        is_answer: false,
    }
}

/// Ω, with the chute's angle where it was computed from one.
type Discharge = (f64, Option<Quantity<Angle>>);

fn discharges(args: &Rotor) -> Result<Vec<Discharge>, DesignError> {
    if let Some(given) = args.discharge {
        return Ok(vec![(given.get(), None)]);
    }
    let (Some(release), Some(chutes), Some(ratio)) = (&args.release, &args.chute, args.radius_ratio) else {
        unreachable!("the options require each other")
    };
    let of = |chute: &Quantity<_>| Ok((discharge(release.0, chute.0, ratio.get())?, Some(*chute)));
    chutes.0.iter().map(of).collect()
}
