//! The choice of a gearbox, as tables.

mod best;
mod reached;
mod side_by_side;
pub mod teeth;
mod words;

pub(crate) use best::in_short;
pub(crate) use reached::{percent, speeds_reached};
pub(crate) use words::unmet;
pub use words::ways_out;

use crate::select::answer::candidate::{Candidate, Criterion, DirectDriveClutch, GearOperation, Verdict};
use crate::select::answer::required::Required;
use crate::select::answer::{Select, Unreachable};
use crate::shared::catalogue::GearName;
use crate::table::figure::{Figure, multiple, text};
use crate::table::quantities::column;
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, View};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

impl AsReport for Select {
    fn report(&self) -> Report {
        let told = self.candidates.iter().take_while(|one| one.accepted).count();
        let (accepted, rejected) = self.candidates.split_at(told);
        let mut parts = vec![];
        if !self.speeds.is_empty() {
            parts.push(Part::Records(speeds_reached(&self.speeds)));
        }
        // The list as CSV; tables show it in parts.
        parts.push(Part::Records(candidates(&self.candidates, vec![])));
        if !accepted.is_empty() {
            parts.push(Part::Records(candidates(accepted, accepted_views(self, accepted))));
        }
        if !rejected.is_empty() {
            parts.push(Part::Records(candidates(rejected, vec![rejected_view(self, rejected)])));
        }
        parts.push(Part::Text(words::why(self, accepted)));
        parts.extend(side_by_side::parts(&self.candidates));
        if let Some(one) = self.in_full() {
            parts.extend(best::parts(one));
        }
        Report { title: Some(title(&self.required)), parts, warnings: None }
    }
}

/// What is wanted.
fn title(required: &Required) -> String {
    let ratios: Vec<String> = required.ratios.iter().map(|ratio| trimmed(*ratio, 5)).collect();
    let (name, braked) =
        if ratios.len() == 1 { ("Ratio", "the braked gear") } else { ("Ratios", "the braked gears") };
    let tolerance = trimmed(100.0 * required.tolerance, 4);
    format!("{name} {} of {braked}, within {tolerance} %", ratios.join(" and "))
}

/// A mechanism by the source's name, or by the links of its members.
fn name(one: &Candidate) -> String {
    one.scheme.map_or_else(|| one.structure.clone(), str::to_owned)
}

fn name_of_unreachable(one: &Unreachable) -> String {
    one.scheme.map_or_else(|| one.structure.clone(), str::to_owned)
}

fn has_two_gears(all: &[Candidate]) -> bool {
    all.iter().any(|one| one.gears.len() > 1)
}

fn accepted_views(select: &Select, accepted: &[Candidate]) -> Vec<View> {
    let two = has_two_gears(accepted);
    let main: &[&str] = if two {
        &["no", "scheme", "ratio_1", "ratio_2", "k1", "k2", "efficiency_1", "efficiency_2"]
    } else {
        &["no", "scheme", "ratio_1", "k1", "efficiency_1"]
    };
    let heading = match select.accepted {
        1 => "The one that meets every required criterion".to_owned(),
        all if all == accepted.len() => {
            format!("The {all} that meet every required criterion, the best first")
        }
        all => format!("The best {} of {all} that meet every required criterion", accepted.len()),
    };
    let torques: &[&str] = if two {
        &[
            "no",
            "link_speed",
            "planet_speed",
            "clutch_slip",
            "circulating",
            "brake_torque_1",
            "brake_torque_2",
            "clutch",
            "clutch_torque",
        ]
    } else {
        &[
            "no",
            "link_speed",
            "planet_speed",
            "clutch_slip",
            "circulating",
            "brake_torque_1",
            "clutch",
            "clutch_torque",
        ]
    };
    vec![
        View { note: note(select, accepted), ..View::new(heading, &with_speeds(&select.required, main)) },
        View {
            note: objectives_note(&select.required, accepted.iter().any(|one| one.mixed_directions)),
            ..View::new(
                "Objectives",
                &["no", "efficiency", "speed", "k_distance", "ratio_error", size_column(accepted), "non_dominated"],
            )
        },
        View {
            note: "Slip: of the open direct-drive clutch. Circ.: circulating power over what enters. Torques: on the \
                   brakes, with losses, and on the direct-drive clutch chosen."
                .to_owned(),
            ..View::new("Largest speeds and circulating power, and torques, over the input's", torques)
        },
        View::new(
            "Criteria met",
            &[
                "no",
                "meets_ratio",
                "meets_k",
                "meets_efficiency",
                "meets_link_speed",
                "meets_planet_speed",
                "meets_clutch_slip",
                "meets_circulation",
                "meets_direction",
                "meets_drawable",
            ],
        ),
    ]
}

fn rejected_view(select: &Select, rejected: &[Candidate]) -> View {
    let heading = if rejected.len() == select.rejected {
        "Rejected".to_owned()
    } else {
        format!("Rejected, {} of {}", rejected.len(), select.rejected)
    };
    let columns: &[&str] = if has_two_gears(rejected) {
        &["no", "scheme", "ratio_1", "ratio_2", "k1", "k2", "because"]
    } else {
        &["no", "scheme", "ratio_1", "k1", "because"]
    };
    View::new(heading, columns)
}

fn note(select: &Select, accepted: &[Candidate]) -> String {
    let mut note = String::from("η: of the gears.");
    if select.required.input_speed_rad_s.is_some() {
        note += " n: of the output, rpm.";
    }
    if accepted.iter().any(|one| one.mixed_directions) {
        note += " A negative ratio: the output reverses against direct drive; such schemes are ranked last.";
    }
    if accepted.iter().any(|one| one.scheme.is_none()) {
        note += " A scheme that the source does not name is a.b.H of set 1, and of set 2 after the +.";
    }
    note
}

fn objectives_note(required: &Required, some_reverse: bool) -> String {
    let apart = if some_reverse { "; schemes that reverse are compared among themselves" } else { "" };
    format!(
        "Efficiency: the least of the gears. Speed: the largest of links, and of planets relative to their carriers. k: \
         distance of ln k from {} to {}. {} Non-dominated: no other is better in one and worse in none{apart}.",
        required.preferred_k.least,
        required.preferred_k.greatest,
        size_note(required)
    )
}

/// What a size is.
fn size_note(required: &Required) -> String {
    let what = match required.load_factor_pa {
        Some(_) => "Ring: the largest one's pitch diameter at the load factor",
        None => "Size: the largest ring, relative",
    };
    let alike = required.mesh_load_factors.iter().all(|factor| *factor == 1.0);
    format!("{what}{}.", if alike { ", if all planets carry alike (K_γ = 1)" } else { "" })
}

/// The column of sizes: lengths where the load is given.
fn size_column(all: &[Candidate]) -> &'static str {
    let is_length = all.iter().any(|one| one.objectives.ring_diameter_m.is_some());
    if is_length { "ring_diameter" } else { "size" }
}

/// What every list of designs says of each: name, ratios, ring-to-sun ratios, efficiencies, objectives.
fn common_columns() -> Vec<Column> {
    vec![
        Column::number("no", "no"),
        Column::words("scheme", "scheme"),
        Column::words("structure", "structure"),
        Column::number("wanted_ratio_1", "wanted"),
        Column::number("wanted_ratio_2", "wanted"),
        Column::number("ratio_1", "i₁"),
        Column::number("ratio_2", "i₂"),
        Column::number("k1", "k₁"),
        Column::number("k2", "k₂"),
        Column::number("efficiency_1", "η₁"),
        Column::number("efficiency_2", "η₂"),
        Column::headed("output_speed_1", "n₁", Dimension::AngularSpeed),
        Column::headed("output_speed_2", "n₂", Dimension::AngularSpeed),
        Column::quantity("output_torque_1", Dimension::Torque),
        Column::quantity("output_torque_2", Dimension::Torque),
        Column::quantity("brake_torque_at_load_1", Dimension::Torque),
        Column::quantity("brake_torque_at_load_2", Dimension::Torque),
        Column::quantity("clutch_torque_at_load", Dimension::Torque),
        Column::number("efficiency", "efficiency"),
        Column::number("speed", "speed"),
        Column::number("k_distance", "k"),
        Column::number("ratio_error", "ratio error"),
        Column::number("size", "size"),
        Column::headed("ring_diameter", "ring, mm", Dimension::Length),
        Column::words("mixed_directions", "mixed directions"),
    ]
}

fn common_figures(one: &Candidate) -> Vec<Figure> {
    let gear = |place: usize| one.gears.get(place);
    let k = |place: usize| multiple(one.sets.get(place).map(|set| set.k));
    let of = &one.objectives;
    vec![
        Figure::Count(one.no),
        text(name(one)),
        text(&one.structure),
        multiple(gear(0).map(|gear| gear.wanted_ratio)),
        multiple(gear(1).map(|gear| gear.wanted_ratio)),
        multiple(gear(0).map(|gear| gear.ratio)),
        multiple(gear(1).map(|gear| gear.ratio)),
        k(0),
        k(1),
        multiple(gear(0).and_then(|gear| gear.efficiency)),
        multiple(gear(1).and_then(|gear| gear.efficiency)),
        of_gear(one, 0, Dimension::AngularSpeed, |at| at.output_speed_rad_s),
        of_gear(one, 1, Dimension::AngularSpeed, |at| at.output_speed_rad_s),
        of_gear(one, 0, Dimension::Torque, |at| at.output_torque_n_m),
        of_gear(one, 1, Dimension::Torque, |at| at.output_torque_n_m),
        of_gear(one, 0, Dimension::Torque, |at| at.k1_torque_n_m),
        of_gear(one, 1, Dimension::Torque, |at| at.k2_torque_n_m),
        column(
            Dimension::Torque,
            one.operation
                .iter()
                .find(|at| at.gear == GearName::Direct)
                .and_then(|at| at.direct_drive_clutch_torque_n_m),
        ),
        Figure::Multiple(of.efficiency),
        Figure::Multiple(of.speed_of_input),
        Figure::Multiple(of.ring_to_sun_distance),
        Figure::Multiple(of.ratio_error),
        Figure::Multiple(of.size),
        length(of.ring_diameter_m),
        Figure::YesNo(one.mixed_directions),
    ]
}

/// A figure of a braked gear at the speed and load of the input, where these are given.
fn of_gear(
    one: &Candidate,
    place: usize,
    dimension: Dimension,
    of: impl Fn(&GearOperation) -> Option<f64>,
) -> Figure {
    let gear = one.gears.get(place).map(|gear| gear.gear);
    let at = one.operation.iter().find(|at| Some(at.gear) == gear);
    column(dimension, at.and_then(of))
}

/// These columns, and those of the output's speeds where that of the input is given.
fn with_speeds(required: &Required, columns: &[&'static str]) -> Vec<&'static str> {
    let speeds = ["output_speed_1", "output_speed_2"];
    let given = usize::from(required.input_speed_rad_s.is_some()) * required.ratios.len().min(2);
    columns.iter().copied().chain(speeds.into_iter().take(given)).collect()
}

fn length(metres: Option<f64>) -> Figure {
    metres.map_or(Figure::None, |si| Figure::Column { si, dimension: Dimension::Length })
}

fn chosen(one: &Candidate) -> Option<&DirectDriveClutch> {
    one.direct_drive_clutches.iter().find(|clutch| clutch.chosen)
}

fn joined(clutch: &DirectDriveClutch) -> String {
    format!("{}-{}", clutch.links[0], clutch.links[1])
}

fn verdict(one: &Candidate, criterion: Criterion) -> Option<&Verdict> {
    one.criteria.iter().find(|verdict| verdict.criterion == criterion)
}

/// All candidates side by side.
fn candidates(all: &[Candidate], views: Vec<View>) -> Records {
    let mut columns = common_columns();
    columns.extend([
        Column::words("accepted", "accepted"),
        Column::words("non_dominated", "non-dominated"),
        Column::number("link_speed", "link"),
        Column::number("planet_speed", "planet"),
        Column::number("clutch_slip", "slip"),
        Column::number("circulating", "circ."),
        Column::number("brake_torque_1", "T of K1"),
        Column::number("brake_torque_2", "T of K2"),
        Column::words("clutch", "clutch").for_people(),
        Column::words("clutch_link_1", "clutch"),
        Column::words("clutch_link_2", "clutch"),
        Column::number("clutch_torque", "its T"),
        Column::words("meets_ratio", "ratio"),
        Column::words("meets_k", "k"),
        Column::words("meets_efficiency", "η"),
        Column::words("meets_link_speed", "link"),
        Column::words("meets_planet_speed", "planet"),
        Column::words("meets_clutch_slip", "slip"),
        Column::words("meets_circulation", "circ."),
        Column::words("meets_direction", "same direction"),
        Column::words("meets_drawable", "drawable"),
        Column::words("because", "because"),
    ]);
    Records {
        name: "candidates",
        columns,
        rows: all.iter().map(row).collect(),
        is_answer: views.is_empty(),
        views,
    }
}

fn row(one: &Candidate) -> Vec<Figure> {
    let value = |criterion| multiple(verdict(one, criterion).and_then(|verdict| verdict.value));
    let met = |criterion| verdict(one, criterion).map_or(Figure::None, |verdict| Figure::YesNo(verdict.met));
    let brake = |place: usize| multiple(one.gears.get(place).and_then(|gear| gear.brake_torque_of_input));
    let clutch = chosen(one);
    let link = |place: usize| clutch.map_or(Figure::None, |clutch| text(clutch.links[place].name()));
    let mut figures = common_figures(one);
    figures.extend([
        Figure::YesNo(one.accepted),
        Figure::YesNo(one.non_dominated),
        value(Criterion::LinkSpeed),
        value(Criterion::PlanetSpeed),
        value(Criterion::ClutchSlip),
        Figure::Multiple(one.objectives.circulating_of_entering),
        brake(0),
        brake(1),
        clutch.map_or(Figure::None, |clutch| text(joined(clutch))),
        link(0),
        link(1),
        multiple(clutch.map(|clutch| clutch.torque_of_input)),
        met(Criterion::RatioError),
        met(Criterion::RingToSunRatio),
        met(Criterion::Efficiency),
        met(Criterion::LinkSpeed),
        met(Criterion::PlanetSpeed),
        met(Criterion::ClutchSlip),
        met(Criterion::Circulation),
        met(Criterion::SameDirection),
        met(Criterion::Drawable),
        text(words::objections(one)),
    ]);
    figures
}
