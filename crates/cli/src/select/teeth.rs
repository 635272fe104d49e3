//! The search over tooth numbers.

use super::{Args, candidates, duty, measures, nothing_found, refuse, structures, winner};
use crate::failure::Failure;
use crate::options;
use crate::output::{Format, complain};
use crate::progress::Progress;
use epicyclic_formats::Span;
use epicyclic_gears::synthesis::{Bounds as ToothBounds, ToothNumbers};
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::search::{Counts, Found, ToothDesign, ToothSearch};
use epicyclic_selection::{
    Candidate, Objectives, Order, Orders, RatioSeries, Requirements, Signs, Space, select_with,
};
use epicyclic_views::figure::{Figure, text};
use epicyclic_views::report::{Column, Part, Records, Report, View};
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::Length;
use uom::si::length::{meter, millimeter};

/// Designs that a search shows unless said otherwise.
const SHOWN: usize = 10;

/// The most that it shows: each takes some 35 kB while the answer is written.
const MOST_SHOWN: usize = 10_000;

/// Tooth numbers tried.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Tooth numbers, with --teeth")]
pub(super) struct Bounds {
    /// Teeth of the suns.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    sun: Span<u32>,

    /// Teeth of the planets.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    planet: Span<u32>,

    /// Teeth of the rings.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    ring: Span<u32>,

    /// Number of planets of a row, from 2 to 8.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "3..8")]
    planet_count: Span<u32>,
}

/// Runs the command.
pub(super) fn run(args: &Args, requirements: &Requirements, order: Order) -> Result<(), Failure> {
    if requirements.series.ratios().len() != 2 {
        return Err(Failure::Option {
            option: "--teeth",
            message: "two rows are searched, so three speeds or two ratios are due; `epicyclic teeth` finds the tooth \
                      numbers of one row"
                .to_owned(),
        });
    }
    let limit = args.limit.unwrap_or(SHOWN);
    if limit > MOST_SHOWN {
        let message = format!(
            "{limit} designs, each measured and written in full: at most {MOST_SHOWN}; narrow the ranges of teeth or the \
             tolerance to see what lies further back on the front"
        );
        return Err(Failure::Option { option: "--limit", message });
    }
    let search = ToothSearch {
        bounds: bounds(args)?,
        order,
        structures: structures(args),
        ring_diameter: args.size.ring_diameter.map(|diameter| diameter.0),
        module: module(args)?,
        ..ToothSearch::new(requirements.clone())
    };
    let shown = Progress::new();
    let found = search.best_watched(limit.max(1), &|progress| {
        shown.at(progress.done as f64 / progress.of.max(1) as f64);
        ControlFlow::Continue(())
    });
    drop(shown);
    let found = found.map_err(refuse)?;
    args.output.deliver_report(vec![], &report(args, requirements, &found, limit)?)?;
    if found.entries().is_empty() {
        return Err(nothing_found());
    }
    if args.output.format != Format::Table && found.entries().len() == limit {
        complain(&format!("note: the first {limit} designs of the front; --limit shows more"));
    }
    Ok(())
}

fn bounds(args: &Args) -> Result<ToothBounds, Failure> {
    let usual = ToothBounds::default();
    let given = &args.teeth_bounds;
    let closed =
        |option, span: Span<u32>, usual| span.within(usual).map_err(|error| Failure::Range { option, error });
    let k = args.criteria.k.within(usual.ring_to_sun_ratio.clone());
    Ok(ToothBounds {
        sun: options::of_wheel("--sun", given.sun, usual.sun)?,
        planet: options::of_wheel("--planet", given.planet, usual.planet)?,
        ring: options::of_wheel("--ring", given.ring, usual.ring)?,
        planets: closed("--planet-count", given.planet_count, usual.planets)?,
        ring_to_sun_ratio: k.map_err(|error| Failure::Range { option: "--k", error })?,
        ..ToothBounds::default()
    })
}

/// The limits of the module; one that is left out allows whatever a gear could have.
fn module(args: &Args) -> Result<Option<RangeInclusive<Length>>, Failure> {
    let (least, greatest) = (args.size.least_module, args.size.greatest_module);
    if least.is_none() && greatest.is_none() {
        return Ok(None);
    }
    let least = least.map_or(Length::new::<millimeter>(1e-3), |least| least.0);
    let greatest = greatest.map_or(Length::new::<meter>(1.0), |greatest| greatest.0);
    if least > greatest {
        let message = "the least module is above the greatest".to_owned();
        return Err(Failure::Option { option: "--least-module", message });
    }
    Ok(Some(least..=greatest))
}

/// An entry with the first of its designs, measured.
struct Measured {
    objectives: Objectives,
    first: ToothDesign,
    /// Designs with the same objectives beside the first.
    others: u64,
    candidate: Candidate,
}

fn report(args: &Args, requirements: &Requirements, found: &Found, limit: usize) -> Result<Report, Failure> {
    let measured = found
        .entries()
        .iter()
        .take(limit)
        .filter_map(|entry| {
            let (first, count) = found.first_design(entry)?;
            let others = count.saturating_sub(1);
            Some(measure(requirements, &first).map(|candidate| {
                candidate.map(|candidate| Measured { objectives: entry.objectives, first, others, candidate })
            }))
        })
        .filter_map(Result::transpose)
        .collect::<Result<Vec<Measured>, Failure>>()?;
    let mut parts = vec![Part::Records(designs(requirements, &measured))];
    if let Some(first) = measured.first() {
        if args.output.format == Format::Table {
            parts.push(Part::Words(counts(found.counts(), measured.len())));
            parts.extend(winner::parts(requirements, &[(1, &first.candidate)]));
            parts.extend(duty::parts(args, requirements, &[(1, &first.candidate)])?);
        } else {
            let all: Vec<winner::Numbered> = (1..).zip(measured.iter().map(|one| &one.candidate)).collect();
            parts.extend(winner::parts(requirements, &all));
            parts.extend(duty::parts(args, requirements, &all)?);
        }
    } else {
        parts =
            vec![Part::Words(format!("No design meets every criterion.\n\n{}", counts(found.counts(), 0)))];
    }
    Ok(Report { title: Some(candidates::title(requirements)), parts, warnings: None })
}

/// The design judged as it is: the ratios that its teeth give are the ones wanted.
fn measure(requirements: &Requirements, design: &ToothDesign) -> Result<Option<Candidate>, Failure> {
    let direct_clutch = [epicyclic_schemes::structures::Role::D, epicyclic_schemes::structures::Role::B];
    let gearbox = design.structure.gearbox(design.k, requirements.eta0, direct_clutch)?;
    let ratios = ["1", "2"]
        .into_iter()
        .map(|gear| Ok(gearbox.analyze(gear)?.ratio()))
        .collect::<Result<Option<Vec<f64>>, Failure>>()?;
    let Some(ratios) = ratios else { return Ok(None) };
    let exactly = Requirements {
        series: RatioSeries::new(&ratios).map_err(refuse)?,
        orders: Orders::AsGiven,
        signs: Signs::AsGiven,
        ..requirements.clone()
    };
    let space = Space::Structures(vec![design.structure]);
    let found =
        select_with(&exactly, &space, Order::default(), Some(&drawable_direct_clutches)).map_err(refuse)?;
    Ok(found.accepted.into_iter().chain(found.rejected).next())
}

fn counts(counts: Counts, shown: usize) -> String {
    let searched = format!(
        "{} tooth sets a row, {} structures with their ratios: {:.2e} designs, none left out; {} pairs of row \
         parameters were tried in full, {} meet every criterion.",
        counts.tooth_sets, counts.patches, counts.designs as f64, counts.tried, counts.feasible
    );
    let shown = match shown {
        0 => String::new(),
        1 => " Shown is the first of the front.".to_owned(),
        shown => format!(" Shown are the first {shown} of the front."),
    };
    epicyclic_views::report::wrapped("", &(searched + &shown))
}

fn designs(requirements: &Requirements, all: &[Measured]) -> Records {
    let views = vec![
        View {
            note: "Rows: teeth of sun, planet, ring x planets. Others: designs with the same objectives."
                .to_owned(),
            ..View::new("Designs, the best first", &["no", "scheme", "row_1", "row_2", "others"])
        },
        View::new(
            "Ratios and efficiencies",
            &["no", "ratio_1", "ratio_2", "k1", "k2", "efficiency_1", "efficiency_2"],
        ),
        View {
            note: format!(
                "On the front: no other design is better in one and worse in none. {}",
                candidates::size_note(requirements)
            ),
            ..View::new(
                "Objectives",
                &["no", "efficiency", "speed", "parameter", "error", candidates::size_column(requirements)],
            )
        },
    ];
    Records {
        name: "designs",
        columns: [
            vec![
                Column::number("no", "no"),
                Column::words("scheme", "scheme"),
                Column::words("structure", "structure"),
                Column::words("row_1", "row 1"),
                Column::words("row_2", "row 2"),
                Column::number("others", "others"),
            ],
            measures::columns(),
            vec![Column::words("mixes_senses", "mixed signs")],
        ]
        .into_iter()
        .flatten()
        .collect(),
        rows: all.iter().enumerate().map(|(place, one)| row(requirements, place, one)).collect(),
        views,
        is_answer: true,
    }
}

fn row(requirements: &Requirements, place: usize, one: &Measured) -> Vec<Figure> {
    let first = &one.first;
    let teeth = |row: usize| first.pairs.first().map_or_else(String::new, |pair| shown(&pair[row]));
    let mut figures = vec![
        Figure::Count(place as u32 + 1),
        text(candidates::name(one.candidate.mechanism)),
        text(first.structure.to_string()),
        text(teeth(0)),
        text(teeth(1)),
        Figure::Count(u32::try_from(one.others).unwrap_or(u32::MAX)),
    ];
    figures.extend(measures::figures(requirements, &one.candidate.gears, &first.k, &one.objectives));
    figures.push(Figure::YesNo(one.candidate.mixes_directions()));
    figures
}

/// `20 17 54 x4`: sun, planet, ring, planets.
fn shown(set: &ToothNumbers) -> String {
    format!("{} {} {} x{}", set.sun.get(), set.planet.get(), set.ring.get(), set.planets)
}
