//! Cutting speeds of chains and drums, in one rock and in others.

use super::list::in_words;
use super::{ChainCutter, Drum, Rock};
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_formats::{Dimension, Physical};
use epicyclic_schemes::DesignError;
use epicyclic_schemes::cutting::{chain_speed, drum_speed, matching_feed, speed_at_force};
use epicyclic_schemes::machines::recommended_speeds;
use epicyclic_views::figure::{Figure, column, quantity};
use epicyclic_views::report::{Column, Part, Records, Report, Row, Section, View};
use uom::si::f64::Velocity;

/// A chain cutter.
pub(super) fn chain(args: &ChainCutter) -> Result<Report, DesignError> {
    let speed = chain_speed(args.pick_spacing.0, args.feed.0, args.chip.0)?;
    report("Chain cutter, v = 1.07·l·v_n/h", speed, args.feed.0, &args.rock)
}

/// A drum or auger.
pub(super) fn drum(args: &Drum) -> Result<Report, DesignError> {
    let speed = drum_speed(args.diameter.0, args.feed.0, args.chip.0, args.picks)?;
    report("Drum, v = 5.24·D·v_n/(h·m)", speed, args.feed.0, &args.rock)
}

fn report(title: &'static str, speed: Velocity, feed: Velocity, rock: &Rock) -> Result<Report, DesignError> {
    let facts = Section {
        name: "cutting",
        title,
        columns: &[],
        rows: vec![
            Row::new("speed", "cutting speed", "v", [quantity(speed)]),
            Row {
                remark: format!("{} m/min", trimmed(60.0 * feed.si(), 5)),
                ..Row::new("feed", "feed", "v_n", [quantity(feed)])
            },
        ],
        note: "",
    };
    let mut parts = vec![Part::Facts(facts)];
    if let (Some(force), Some(others)) = (&rock.force, &rock.other_forces) {
        let mut speeds = vec![speed];
        let mut rows = vec![vec![column(Some(force.0)), column(Some(speed)), column(Some(feed))]];
        for other in others.values() {
            let there = speed_at_force(speed, force.0, other)?;
            let feed = matching_feed(feed, speed, there)?;
            rows.push(vec![column(Some(other)), column(Some(there)), column(Some(feed))]);
            speeds.push(there);
        }
        parts.push(Part::Records(rocks(rows)));
        parts.extend(range(&speeds)?.map(Part::Facts));
    }
    Ok(Report { title: None, parts, warnings: None })
}

fn rocks(rows: Vec<Vec<Figure>>) -> Records {
    let headed = |name, dimension: Dimension, what: &str| Column {
        heading: format!("{what}, {}", dimension.usual_unit().symbol),
        ..Column::quantity(name, dimension)
    };
    Records {
        name: "rocks",
        columns: vec![
            headed("force", Dimension::Force, "force"),
            headed("speed", Dimension::Speed, "speed"),
            headed("feed", Dimension::Speed, "feed"),
        ],
        rows,
        views: vec![View::new(
            "In this rock and in others, at one power and chip",
            &["force", "speed", "feed"],
        )],
        is_answer: false,
    }
}

/// Range of the speeds and how many of them are recommended; `None` where all are one.
fn range(speeds: &[Velocity]) -> Result<Option<Section>, DesignError> {
    let (mut least, mut greatest) = (speeds[0], speeds[0]);
    for speed in speeds {
        least = if *speed < least { *speed } else { least };
        greatest = if *speed > greatest { *speed } else { greatest };
    }
    if least == greatest {
        return Ok(None);
    }
    let d = (greatest / least).value;
    let recommended = recommended_speeds(d)?;
    let rows = vec![
        Row::new("range", "fastest over slowest", "d", [Figure::Multiple(d)]),
        Row {
            remark: in_words(recommended).to_owned(),
            ..Row::new("recommended", "speeds recommended", "", [Figure::Count(recommended.speeds)])
        },
    ];
    Ok(Some(Section { name: "range", title: "Range", columns: &[], rows, note: "" }))
}
