//! All candidates side by side.

use super::winner::Numbered;
use super::{Args, duty, measures, why, winner};
use crate::failure::Failure;
use crate::output::Format;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_schemes::direct_drive::DirectClutch;
use epicyclic_selection::{
    Candidate, Criterion, Mechanism, Objective, Order, Requirements, Selection, Unreachable,
};
use epicyclic_views::figure::{Figure, multiple, text};
use epicyclic_views::report::{Column, Part, Records, Report, View, wrapped};
use std::fmt::Write as _;

/// Designs shown in a table unless said otherwise.
pub(super) const SHOWN_IN_TABLE: usize = 10;

/// Candidates in the order in which they are shown: the accepted, best first, then the rejected.
pub(super) struct Ranked<'a> {
    pub(super) all: Vec<&'a Candidate>,
    pub(super) accepted: usize,
    /// Places in `all` of what is on the front.
    pub(super) front: Vec<usize>,
}

impl<'a> Ranked<'a> {
    fn new(found: &'a Selection) -> Self {
        let best = found.best.iter().map(|&place| &found.accepted[place]);
        let on_front = |place: &usize| found.front.iter().any(|entry| entry.members.contains(place));
        let front = (0..found.best.len()).filter(|&rank| on_front(&found.best[rank])).collect();
        Self { all: best.chain(&found.rejected).collect(), accepted: found.accepted.len(), front }
    }
}

/// The whole answer.
pub(super) fn report(
    args: &Args,
    requirements: &Requirements,
    order: Order,
    found: &Selection,
) -> Result<Report, Failure> {
    let ranked = Ranked::new(found);
    let limit = match (args.limit, args.output.format) {
        (Some(limit), _) => limit,
        (None, Format::Table) => SHOWN_IN_TABLE,
        (None, _) => usize::MAX,
    };
    let accepted = ranked.accepted.min(limit);
    let rejected = (ranked.all.len() - ranked.accepted).min(limit);
    let shown: Vec<usize> = (0..accepted).chain(ranked.accepted..ranked.accepted + rejected).collect();
    let mut parts = vec![];
    let is_table = args.output.format == Format::Table;
    if is_table {
        parts.extend(lists(requirements, &ranked, accepted, rejected));
        parts.push(Part::Words(why::words(order, &ranked, found, accepted)));
        if let Some(best) = ranked.all.first().filter(|_| ranked.accepted > 0) {
            parts.extend(winner::parts(requirements, &[(1, best)]));
            parts.extend(duty::parts(args, requirements, &[(1, best)])?);
        }
    } else {
        parts.push(Part::Records(candidates(requirements, &ranked, &shown, vec![])));
        let all: Vec<Numbered> = shown.iter().map(|&place| (place as u32 + 1, ranked.all[place])).collect();
        parts.extend(winner::parts(requirements, &all));
        parts.extend(duty::parts(args, requirements, &all)?);
        parts.push(Part::Records(verdicts(&all)));
        parts.push(Part::Records(unreachable(&found.unreachable)));
    }
    Ok(Report { title: Some(title(requirements)), parts, warnings: None })
}

/// What is wanted.
pub(super) fn title(requirements: &Requirements) -> String {
    let ratios: Vec<String> = requirements.series.ratios().iter().map(|ratio| trimmed(*ratio, 5)).collect();
    let (name, braked) =
        if ratios.len() == 1 { ("Ratio", "the braked gear") } else { ("Ratios", "the braked gears") };
    let tolerance = trimmed(100.0 * requirements.tolerance, 4);
    format!("{name} {} of {braked}, within {tolerance} %", ratios.join(" and "))
}

/// A mechanism by the source's name, or by the links of its members.
pub(super) fn name(mechanism: Mechanism) -> String {
    mechanism.scheme().map_or_else(|| mechanism.to_string(), str::to_owned)
}

fn lists(requirements: &Requirements, ranked: &Ranked, accepted: usize, rejected: usize) -> Vec<Part> {
    let mut parts = vec![];
    let two = requirements.series.ratios().len() == 2;
    let main: &[&str] = if two {
        &["no", "scheme", "ratio_1", "ratio_2", "k1", "k2", "efficiency_1", "efficiency_2"]
    } else {
        &["no", "scheme", "ratio_1", "k1", "efficiency_1"]
    };
    if accepted > 0 {
        let heading = match ranked.accepted {
            1 => "The one that meets every criterion".to_owned(),
            all if all == accepted => format!("The {all} that meet every criterion, the best first"),
            all => format!("The best {accepted} of {all} that meet every criterion"),
        };
        let views = vec![
            View { note: note(requirements, ranked), ..View::new(heading, main) },
            View {
                note: objectives_note(requirements),
                ..View::new("Objectives", &["no", "efficiency", "speed", "parameter", "error", size_column(requirements), "front"])
            },
            View {
                note: "Slip: of the open locking clutch. Torques: on the brakes, with losses, and on the clutch that \
                       locks with the least."
                    .to_owned(),
                ..View::new(
                    "Largest speeds, and torques, over the input's",
                    &["no", "largest_link", "largest_planet", "slip", "brake_1", "brake_2", "lock", "lock_torque"],
                )
            },
            View::new("Criteria met", &[
                "no", "meets_ratio", "meets_k", "meets_efficiency", "meets_link", "meets_planet", "meets_slip",
                "meets_sense", "meets_drawing",
            ]),
        ];
        parts.push(Part::Records(candidates(
            requirements,
            ranked,
            &(0..accepted).collect::<Vec<_>>(),
            views,
        )));
    }
    if rejected > 0 {
        let all = ranked.all.len() - ranked.accepted;
        let heading =
            if all == rejected { "Rejected".to_owned() } else { format!("Rejected, {rejected} of {all}") };
        let shown: Vec<usize> = (ranked.accepted..ranked.accepted + rejected).collect();
        let columns: &[&str] = if two {
            &["scheme", "ratio_1", "ratio_2", "k1", "k2", "because"]
        } else {
            &["scheme", "ratio_1", "k1", "because"]
        };
        parts.push(Part::Records(candidates(
            requirements,
            ranked,
            &shown,
            vec![View::new(heading, columns)],
        )));
    }
    parts
}

fn note(requirements: &Requirements, ranked: &Ranked) -> String {
    let mut note = String::from("η: of the gears");
    if requirements.limits.same_direction
        || ranked.all[..ranked.accepted].iter().all(|one| !one.mixes_directions())
    {
        note += ".";
    } else {
        note += ". A negative ratio: the output reverses against direct drive.";
    }
    if ranked.all[..ranked.accepted].iter().any(|one| one.mechanism.scheme().is_none()) {
        note += " Without a name of the source a scheme is a.b.H of row 1, and of row 2 after the +.";
    }
    note
}

fn objectives_note(requirements: &Requirements) -> String {
    let (low, high) = (requirements.limits.preferred.start(), requirements.limits.preferred.end());
    format!(
        "Efficiency: the least of the gears. Speed: the largest of links and of planets on their carriers. Parameter: \
         distance of ln k from {low} to {high}. {} Front: no other is better in one and worse in none.",
        size_note(requirements)
    )
}

/// What a size is.
pub(super) fn size_note(requirements: &Requirements) -> &'static str {
    match requirements.rating.load {
        Some(_) => "Ring: the largest one's pitch diameter at the load factor.",
        None => "Size: the largest ring, relative.",
    }
}

/// The column of sizes: lengths where the load is given.
pub(super) fn size_column(requirements: &Requirements) -> &'static str {
    if requirements.rating.load.is_some() { "ring_diameter" } else { "size" }
}

fn candidates(requirements: &Requirements, ranked: &Ranked, shown: &[usize], views: Vec<View>) -> Records {
    let criterion = |name, heading: &str| Column::words(name, heading);
    Records {
        name: "candidates",
        columns: [
            vec![
                Column::number("no", "no"),
                Column::words("scheme", "scheme"),
                Column::words("structure", "structure"),
                Column::words("accepted", "accepted"),
                Column::number("wanted_1", "wanted"),
                Column::number("wanted_2", "wanted"),
            ],
            measures::columns(),
            vec![
                Column::words("front", "front"),
                Column::number("largest_link", "link"),
                Column::number("largest_planet", "planet"),
                Column::number("slip", "slip"),
                Column::number("brake_1", "T of K1"),
                Column::number("brake_2", "T of K2"),
                Column::words("lock", "lock"),
                Column::number("lock_torque", "its T"),
                Column::words("mixes_senses", "mixed signs"),
                criterion("meets_ratio", "ratio"),
                criterion("meets_k", "k"),
                criterion("meets_efficiency", "η"),
                criterion("meets_link", "link"),
                criterion("meets_planet", "planet"),
                criterion("meets_slip", "slip"),
                criterion("meets_sense", "one sense"),
                criterion("meets_drawing", "drawable"),
                Column::words("because", "because"),
            ],
        ]
        .into_iter()
        .flatten()
        .collect(),
        rows: shown.iter().map(|&place| row(requirements, ranked, place)).collect(),
        views,
        is_answer: true,
    }
}

fn row(requirements: &Requirements, ranked: &Ranked, place: usize) -> Vec<Figure> {
    let one = ranked.all[place];
    let of_gear = |gear: usize, of: fn(&epicyclic_selection::GearReport) -> Option<f64>| {
        multiple(one.gears.get(gear).and_then(of))
    };
    let value =
        |criterion| one.verdicts.iter().find(|verdict| verdict.criterion == criterion).map(|v| v.value);
    let met = |criterion| match one.verdicts.iter().find(|verdict| verdict.criterion == criterion) {
        None => Figure::None,
        Some(verdict) => Figure::YesNo(verdict.met),
    };
    let objectives = &one.objectives;
    let clutch = winner::direct_clutch(one);
    let mut figures = vec![
        Figure::Count(place as u32 + 1),
        text(name(one.mechanism)),
        text(one.mechanism.to_string()),
        Figure::YesNo(place < ranked.accepted),
        of_gear(0, |gear| Some(gear.wanted)),
        of_gear(1, |gear| Some(gear.wanted)),
    ];
    figures.extend(measures::figures(requirements, &one.gears, &one.k, objectives));
    figures.extend([
        Figure::YesNo(ranked.front.contains(&place)),
        multiple(value(Criterion::LinkSpeed)),
        multiple(value(Criterion::PlanetSpeed)),
        multiple(clutch.map(slip)),
        of_gear(0, |gear| gear.brake_torque),
        of_gear(1, |gear| gear.brake_torque),
        text(
            clutch.map_or_else(|| "-".to_owned(), |clutch| format!("{}-{}", clutch.pair[0], clutch.pair[1])),
        ),
        multiple(clutch.map(|clutch| clutch.torque)),
        Figure::YesNo(one.mixes_directions()),
        met(Criterion::Ratio),
        met(Criterion::RingToSun),
        met(Criterion::Efficiency),
        met(Criterion::LinkSpeed),
        met(Criterion::PlanetSpeed),
        met(Criterion::ClutchSlip),
        met(Criterion::SameDirection),
        met(Criterion::Drawable),
        text(objections(one)),
    ]);
    figures
}

/// The largest slip of an open direct-drive clutch.
fn slip(clutch: &DirectClutch) -> f64 {
    clutch.slip.iter().fold(0.0, |largest, slip| largest.max(slip.abs()))
}

/// Required criteria that a candidate does not meet, in words.
pub(super) fn objections(one: &Candidate) -> String {
    let mut words = String::new();
    for verdict in one.objections().filter(|verdict| verdict.required) {
        let [least, greatest] = verdict.limits.map(|limit| trimmed(limit, 4));
        let value = trimmed(verdict.value, 4);
        let objection = match verdict.criterion {
            Criterion::SameDirection | Criterion::Drawable => verdict.place.clone(),
            Criterion::Ratio => format!(
                "ratio of {} {} % off, {} allowed",
                verdict.place,
                trimmed(100.0 * verdict.value, 3),
                trimmed(100.0 * verdict.limits[1], 3),
            ),
            Criterion::RingToSun => {
                format!("k = {value} of {} outside {least} to {greatest}", verdict.place)
            }
            Criterion::Efficiency => format!("efficiency {value} in {}, least {least}", verdict.place),
            criterion => format!("{criterion} {value} ({}), greatest {greatest}", verdict.place),
        };
        let _ = write!(words, "{}{objection}", if words.is_empty() { "" } else { "; " });
    }
    words
}

fn verdicts(all: &[Numbered]) -> Records {
    let mut rows = vec![];
    for &(no, one) in all {
        for verdict in &one.verdicts {
            rows.push(vec![
                Figure::Count(no),
                text(verdict.criterion.to_string()),
                Figure::YesNo(verdict.met),
                Figure::YesNo(verdict.required),
                Figure::Multiple(verdict.value),
                Figure::Multiple(verdict.limits[0]),
                // JSON has no infinity.
                if verdict.limits[1].is_finite() {
                    Figure::Multiple(verdict.limits[1])
                } else {
                    Figure::None
                },
                text(&verdict.place),
            ]);
        }
    }
    Records {
        name: "verdicts",
        columns: vec![
            Column::number("candidate", "candidate"),
            Column::words("criterion", "criterion"),
            Column::words("met", "met"),
            Column::words("required", "required"),
            Column::number("value", "value"),
            Column::number("least", "least"),
            Column::number("greatest", "greatest"),
            Column::words("place", "place"),
        ],
        rows,
        views: vec![],
        is_answer: false,
    }
}

fn unreachable(all: &[Unreachable]) -> Records {
    let row = |one: &Unreachable| {
        vec![
            text(name(one.mechanism)),
            text(one.mechanism.to_string()),
            Figure::Numbers(one.wanted.clone()),
            one.needed.clone().map_or(Figure::None, Figure::Numbers),
            text(&one.reason),
        ]
    };
    Records {
        name: "unreachable",
        columns: vec![
            Column::words("scheme", "scheme"),
            Column::words("structure", "structure"),
            Column::words("wanted", "wanted"),
            Column::words("needed_k", "needed k"),
            Column::words("because", "because"),
        ],
        rows: all.iter().map(row).collect(),
        views: vec![],
        is_answer: false,
    }
}

/// An objective's value of a candidate.
pub(super) fn value(objective: Objective, one: &Candidate) -> f64 {
    let of = &one.objectives;
    match objective {
        Objective::Efficiency => of.efficiency,
        Objective::Speed => of.speed,
        Objective::RingToSun => of.ring_to_sun,
        Objective::RatioError => of.ratio_error,
        Objective::Size => of.size,
    }
}

/// A line of a list in a table of words.
pub(super) fn item(words: &str) -> String {
    wrapped(" -", words)
}
