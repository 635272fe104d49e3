//! A candidate in full: its speeds, its options for the direct-drive clutch, its engagement table, its duty.

use super::{joined, name, words};
use crate::schemes::table::speed_lines;
use crate::select::answer::candidate::{Candidate, Engagement};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::{Part, Records, Report, Text, View};
use epicyclic_schemes::catalogue::SchemeElement;
use epicyclic_units::Dimension;

/// The parts that show a candidate in full.
pub(super) fn parts(one: &Candidate) -> Vec<Part> {
    let source = one.source.as_ref().and_then(|source| words::in_source(one, source));
    let mut parts: Vec<Part> = source.into_iter().map(|words| Part::Text(Text::paragraph(words))).collect();
    parts.extend([speeds(one), direct_drive_clutches(one), engagement_table(one)].map(Part::Records));
    if !one.operation.is_empty() {
        parts.push(Part::Records(of_gears(one)));
    }
    if one.operation.iter().any(|gear| !gear.sets.is_empty()) {
        parts.push(Part::Records(of_members(one)));
    }
    parts
}

/// A candidate in one table: gears with their shift elements, ratios, efficiencies, and what the output does.
pub(crate) fn in_short(one: &Candidate) -> Report {
    let braked = |line: &Engagement| one.gears.iter().find(|gear| gear.gear == line.gear);
    let at = |line: &Engagement| one.operation.iter().find(|gear| gear.gear == line.gear);
    let shown = ["gear", "engaged", "ratio", "efficiency", "output_speed", "output_torque"];
    let has_torque = one.operation.iter().any(|gear| gear.output_torque_n_m.is_some());
    let shown = &shown[..4 + usize::from(!one.operation.is_empty()) + usize::from(has_torque)];
    let ks = one.sets.iter().enumerate();
    let ks: Vec<String> = ks.map(|(place, set)| format!("k{} = {:.4}", place + 1, set.k)).collect();
    let note = format!("{}. rpm, N·m: of the output.", ks.join(", "));
    let note = if one.operation.is_empty() { format!("{}.", ks.join(", ")) } else { note };
    let records = Table::new("gears", &one.engagement_table)
        .text("gear", "gear", |line| line.gear.name())
        .text("engaged", "engaged", |line| line.engaged.name())
        .multiple("ratio", "i", |line| line.ratio)
        .multiple("efficiency", "η", |line| braked(line).map_or(Some(1.0), |gear| gear.efficiency))
        .quantity("output_speed", "", Dimension::AngularSpeed, |line| at(line)?.output_speed_rad_s)
        .quantity("output_torque", "", Dimension::Torque, |line| at(line)?.output_torque_n_m)
        .view_of(heading("gears", one), shown)
        .note(note)
        .records();
    Report { parts: vec![Part::Records(records)], ..Report::default() }
}

fn heading(what: &str, one: &Candidate) -> String {
    format!("{}: {what}", name(one))
}

fn has_two_gears(one: &Candidate) -> bool {
    one.gears.len() > 1
}

/// Those columns that there are: of a single set none of gear 2.
fn those(one: &Candidate, all: &[&'static str], of_gear_2: &str) -> Vec<&'static str> {
    all.iter().copied().filter(|name| has_two_gears(one) || *name != of_gear_2).collect()
}

fn speeds(one: &Candidate) -> Records {
    let rows = one.sets.iter().enumerate().flat_map(|(place, set)| {
        speed_lines(place + 1, &set.links).map(|(member, link, of)| (place, member, link, of))
    });
    Table::new("speeds", rows)
        .text("member", "member", |(_, member, ..)| member)
        .text("link", "link", |(_, _, link, _)| link.unwrap_or_default())
        .multiple("gear_1", "gear 1", |(place, .., of)| of(one.gears.first()?.sets.get(*place)?))
        .multiple("gear_2", "gear 2", |(place, .., of)| of(one.gears.get(1)?.sets.get(*place)?))
        .view_of(
            heading("speeds over the input's; g planet, on H relative to its carrier", one),
            &those(one, &["member", "link", "gear_1", "gear_2"], "gear_2"),
        )
        .records()
}

fn direct_drive_clutches(one: &Candidate) -> Records {
    Table::new("direct_drive_clutches", one.direct_drive_clutches.iter())
        .words("joins", "joins", |clutch| joined(clutch))
        .multiple("torque", "T", |clutch| clutch.torque_of_input)
        .multiple("slip_1", "slip in 1", |clutch| clutch.slips_of_input.first().copied())
        .multiple("slip_2", "slip in 2", |clutch| clutch.slips_of_input.get(1).copied())
        .words("drawable", "drawable", |clutch| clutch.drawable)
        .words("chosen", "chosen", |clutch| clutch.chosen)
        .view_of(
            heading("options for the direct-drive clutch", one),
            &those(one, &["joins", "torque", "slip_1", "slip_2", "drawable", "chosen"], "slip_2"),
        )
        .records()
}

fn engagement_table(one: &Candidate) -> Records {
    let engages = |line: &Engagement, element| Figure::Mark(line.engaged == element);
    Table::new("engagement_table", &one.engagement_table)
        .text("gear", "gear", |line| line.gear.name())
        .multiple("ratio", "i", |line| line.ratio)
        .words("k1", "K1", |line| engages(line, SchemeElement::FirstBrake))
        .words("k2", "K2", |line| engages(line, SchemeElement::SecondBrake))
        .words("direct_drive_clutch", "direct-drive clutch", |line| {
            engages(line, SchemeElement::DirectClutch)
        })
        .words("output", "output", |line| if line.reverses { "backward" } else { "forward" })
        .view_of(
            heading("engagement table, the slowest output first", one),
            &those(one, &["gear", "ratio", "k1", "k2", "direct_drive_clutch", "output"], "k2"),
        )
        .records()
}

fn of_gears(one: &Candidate) -> Records {
    let turns = one.operation.iter().any(|gear| gear.output_speed_rad_s.is_some());
    let is_loaded = one.operation.iter().any(|gear| gear.input_torque_n_m.is_some());
    let mut views = vec![];
    if turns {
        let mut shown = vec!["gear", "output_speed"];
        if is_loaded {
            shown.extend(["entering", "leaving", "loss", "circulating"]);
        }
        let title = if is_loaded { "output, rpm, and powers with losses, kW" } else { "output, rpm" };
        views.push(View::new(heading(title, one), &shown));
    }
    if is_loaded {
        let shown = those(
            one,
            &[
                "gear",
                "input_torque",
                "output_torque",
                "k1_torque",
                "k2_torque",
                "direct_drive_clutch_torque",
            ],
            "k2_torque",
        );
        views.push(View {
            note: "With losses. On the gearbox at input and output; of each brake and of the direct-drive clutch on its \
                   first link."
                .to_owned(),
            ..View::new(heading("torques of shafts, brakes and direct-drive clutch, N·m", one), &shown)
        });
    }
    Table::new("operation", one.operation.iter())
        .words("gear", "gear", |gear| gear.gear.name())
        .headed("output_speed", "output", Dimension::AngularSpeed, |gear| gear.output_speed_rad_s)
        .headed("input_torque", "input", Dimension::Torque, |gear| gear.input_torque_n_m)
        .headed("output_torque", "output", Dimension::Torque, |gear| gear.output_torque_n_m)
        .headed("k1_torque", "K1", Dimension::Torque, |gear| gear.k1_torque_n_m)
        .headed("k2_torque", "K2", Dimension::Torque, |gear| gear.k2_torque_n_m)
        .headed("direct_drive_clutch_torque", "direct drive", Dimension::Torque, |gear| {
            gear.direct_drive_clutch_torque_n_m
        })
        .headed("entering", "enters", Dimension::Power, |gear| gear.entering_w)
        .headed("leaving", "leaves", Dimension::Power, |gear| gear.leaving_w)
        .headed("loss", "lost", Dimension::Power, |gear| gear.loss_w)
        .headed("circulating", "circulates", Dimension::Power, |gear| gear.circulating_w)
        .views(views)
        .records()
}

fn of_members(one: &Candidate) -> Records {
    let rows = one.operation.iter().flat_map(|gear| (1_u32..).zip(&gear.sets).map(move |of| (gear, of)));
    Table::new("member_torques", rows)
        .text("gear", "gear", |(gear, _)| gear.gear.name())
        .words("set", "set", |(_, (set, _))| *set)
        .headed("sun_torque", "sun", Dimension::Torque, |(_, (_, of))| of.sun_torque_n_m)
        .headed("ring_torque", "ring", Dimension::Torque, |(_, (_, of))| of.ring_torque_n_m)
        .headed("carrier_torque", "carrier", Dimension::Torque, |(_, (_, of))| of.carrier_torque_n_m)
        .all(heading("torques on the members of the sets, N·m", one))
        .records()
}
