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
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, View};
use epicyclic_schemes::catalogue::SchemeGear;
use epicyclic_units::Dimension::{AngularSpeed, Length, Torque};
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
        parts.extend(judgement::parts(&self.judgement));
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

/// The columns that a list has of each candidate: name, ratios, ring-to-sun ratios, efficiencies, objectives.
fn of_candidate<Row>(table: Table<Row>, of: impl Fn(&Row) -> &Candidate) -> Table<Row> {
    let direct = |gear: &&GearOperation| gear.gear == SchemeGear::Direct;
    table
        .number("no", "no", |row| of(row).no)
        .words("scheme", "scheme", |row| name(of(row)))
        .text("structure", "structure", |row| &of(row).structure)
        .multiple("wanted_ratio_1", "wanted", |row| Some(of(row).gears.first()?.wanted_ratio))
        .multiple("wanted_ratio_2", "wanted", |row| Some(of(row).gears.get(1)?.wanted_ratio))
        .multiple("ratio_1", "i₁", |row| Some(of(row).gears.first()?.ratio))
        .multiple("ratio_2", "i₂", |row| Some(of(row).gears.get(1)?.ratio))
        .multiple("k1", "k₁", |row| Some(of(row).sets.first()?.k))
        .multiple("k2", "k₂", |row| Some(of(row).sets.get(1)?.k))
        .multiple("efficiency_1", "η₁", |row| of(row).gears.first()?.efficiency)
        .multiple("efficiency_2", "η₂", |row| of(row).gears.get(1)?.efficiency)
        .headed("output_speed_1", "n₁", AngularSpeed, |row| operation(of(row), 0)?.output_speed_rad_s)
        .headed("output_speed_2", "n₂", AngularSpeed, |row| operation(of(row), 1)?.output_speed_rad_s)
        .quantity("output_torque_1", "", Torque, |row| operation(of(row), 0)?.output_torque_n_m)
        .quantity("output_torque_2", "", Torque, |row| operation(of(row), 1)?.output_torque_n_m)
        .quantity("brake_torque_at_load_1", "", Torque, |row| operation(of(row), 0)?.k1_torque_n_m)
        .quantity("brake_torque_at_load_2", "", Torque, |row| operation(of(row), 1)?.k2_torque_n_m)
        .quantity("clutch_torque_at_load", "", Torque, |row| {
            of(row).operation.iter().find(direct)?.direct_drive_clutch_torque_n_m
        })
        .multiple("efficiency", "efficiency", |row| of(row).objectives.efficiency)
        .multiple("speed", "speed", |row| of(row).objectives.speed_of_input)
        .multiple("k_distance", "k", |row| of(row).objectives.ring_to_sun_distance)
        .multiple("ratio_error", "ratio error", |row| of(row).objectives.ratio_error)
        .multiple("size", "size", |row| of(row).objectives.size)
        .quantity("ring_diameter", "ring", Length, |row| of(row).objectives.ring_diameter_m)
        .words("mixed_directions", "mixed directions", |row| of(row).mixed_directions)
}

/// A braked gear at the speed and load of the input, where these are given.
fn operation(one: &Candidate, place: usize) -> Option<&GearOperation> {
    let gear = one.gears.get(place)?.gear;
    one.operation.iter().find(|at| at.gear == gear)
}

/// These columns, and those of the output's speeds where that of the input is given.
fn with_speeds(required: &Required, columns: &[&'static str]) -> Vec<&'static str> {
    let speeds = ["output_speed_1", "output_speed_2"];
    let given = usize::from(required.input_speed_rad_s.is_some()) * required.ratios.len().min(2);
    columns.iter().copied().chain(speeds.into_iter().take(given)).collect()
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
    let value = |one: &Candidate, criterion| verdict(one, criterion)?.value;
    let met = |one: &Candidate, criterion| Some(verdict(one, criterion)?.met);
    of_candidate(Table::new("candidates", all), |one| one)
        .words("accepted", "accepted", |one| one.accepted)
        .words("non_dominated", "non-dominated", |one| one.non_dominated)
        .multiple("link_speed", "link", |one| value(one, Criterion::LinkSpeed))
        .multiple("planet_speed", "planet", |one| value(one, Criterion::PlanetSpeed))
        .multiple("clutch_slip", "slip", |one| value(one, Criterion::ClutchSlip))
        .multiple("circulating", "circ.", |one| one.objectives.circulating_of_entering)
        .multiple("brake_torque_1", "T of K1", |one| one.gears.first()?.brake_torque_of_input)
        .multiple("brake_torque_2", "T of K2", |one| one.gears.get(1)?.brake_torque_of_input)
        .words("clutch", "clutch", |one| chosen(one).map(joined))
        .for_people()
        .words("clutch_link_1", "clutch", |one| Some(chosen(one)?.links[0].symbol()))
        .words("clutch_link_2", "clutch", |one| Some(chosen(one)?.links[1].symbol()))
        .multiple("clutch_torque", "its T", |one| Some(chosen(one)?.torque_of_input))
        .words("meets_ratio", "ratio", |one| met(one, Criterion::RatioError))
        .words("meets_k", "k", |one| met(one, Criterion::RingToSunRatio))
        .words("meets_efficiency", "η", |one| met(one, Criterion::Efficiency))
        .words("meets_link_speed", "link", |one| met(one, Criterion::LinkSpeed))
        .words("meets_planet_speed", "planet", |one| met(one, Criterion::PlanetSpeed))
        .words("meets_clutch_slip", "slip", |one| met(one, Criterion::ClutchSlip))
        .words("meets_circulation", "circ.", |one| met(one, Criterion::Circulation))
        .words("meets_direction", "same direction", |one| met(one, Criterion::SameDirection))
        .words("meets_drawable", "drawable", |one| met(one, Criterion::Drawable))
        .words("because", "because", |one| words::objections(one))
        .the_answer_if(views.is_empty())
        .views(views)
        .records()
}
