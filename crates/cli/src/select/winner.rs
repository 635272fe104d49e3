//! A candidate in full: its speeds, its options for the direct-drive clutch, its engagement table.

use super::candidates::name;
use epicyclic_schemes::direct_drive::DirectClutch;
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::Role;
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::{Candidate, GearReport, Mechanism, Requirements};
use epicyclic_views::figure::{Figure, multiple, text};
use epicyclic_views::report::{Column, Part, Records, View, wrapped};

/// A candidate with its number in the list.
pub(super) type Numbered<'a> = (u32, &'a Candidate);

/// The direct-drive clutch chosen: of those that slip within the limit and can be drawn the one of the least torque.
pub(super) fn direct_clutch(one: &Candidate) -> Option<&DirectClutch> {
    one.direct_clutches.get(one.direct_clutch)
}

/// The parts that show candidates in full.
pub(super) fn parts(requirements: &Requirements, all: &[Numbered]) -> Vec<Part> {
    let mut parts: Vec<Part> = vec![];
    if let [(_, one)] = all {
        parts.extend(standing(requirements, one.mechanism));
    }
    parts.push(Part::Records(speeds(all)));
    parts.push(Part::Records(direct_clutches(all)));
    parts.push(Part::Records(engagements(all)));
    parts
}

/// Whether the source has the winner, and why not.
fn standing(requirements: &Requirements, mechanism: Mechanism) -> Option<Part> {
    let Mechanism::TwoSets(structure) = mechanism else { return None };
    let standing = Standing::of(structure, &requirements.limits.ring_to_sun);
    let words = wrapped("In the source:", &format!("{}: {standing}", name(mechanism)));
    (!matches!(standing, Standing::Listed(_))).then_some(Part::Words(words))
}

fn speeds(all: &[Numbered]) -> Records {
    let mut rows = vec![];
    for &(no, one) in all {
        let mut line = |member: String, link: Option<Role>, of: &dyn Fn(&GearReport) -> Option<f64>| {
            let gears = [one.gears.first().and_then(of), one.gears.get(1).and_then(of)];
            let link = link.map_or_else(String::new, |role| role.symbol().to_owned());
            let cells = [Figure::Count(no), Figure::Text(member), Figure::Text(link)];
            rows.push(cells.into_iter().chain(gears.map(multiple)).collect());
        };
        for (row, roles) in one.mechanism.sets().iter().enumerate() {
            for (member, &role) in ["a", "b", "H"].into_iter().zip(roles) {
                let of =
                    |gear: &GearReport| gear.links.iter().find(|(link, _)| *link == role).map(|(_, s)| *s);
                line(format!("{member}{}", row + 1), Some(role), &of);
            }
            line(format!("g{}", row + 1), None, &|gear| gear.planets.get(row)?.absolute);
            line(format!("g{0} on H{0}", row + 1), None, &|gear| Some(gear.planets.get(row)?.relative));
        }
    }
    let shown: &[&str] = if all.iter().all(|(_, one)| one.gears.len() == 1) {
        &["member", "link", "gear_1"]
    } else {
        &["member", "link", "gear_1", "gear_2"]
    };
    Records {
        name: "speeds",
        columns: vec![
            Column::number("candidate", "no"),
            Column::words("member", "member"),
            Column::words("link", "link"),
            Column::number("gear_1", "gear 1"),
            Column::number("gear_2", "gear 2"),
        ],
        rows,
        views: vec![View::new(heading("speeds over the input's; g planet", all), shown)],
        is_answer: false,
    }
}

pub(super) fn heading(what: &str, all: &[Numbered]) -> String {
    all.first().map_or_else(String::new, |(_, one)| format!("{}: {what}", name(one.mechanism)))
}

fn direct_clutches(all: &[Numbered]) -> Records {
    let mut rows = vec![];
    for &(no, one) in all {
        let chosen = direct_clutch(one);
        let drawable = drawable_direct_clutches(one.mechanism).unwrap_or_default();
        for clutch in &one.direct_clutches {
            rows.push(vec![
                Figure::Count(no),
                text(format!("{}-{}", clutch.pair[0], clutch.pair[1])),
                Figure::Multiple(clutch.torque),
                Figure::Multiple(clutch.slip[0]),
                if one.gears.len() == 1 { Figure::None } else { Figure::Multiple(clutch.slip[1]) },
                Figure::YesNo(drawable.contains(&clutch.pair)),
                Figure::YesNo(chosen.is_some_and(|chosen| chosen.pair == clutch.pair)),
            ]);
        }
    }
    let two = all.iter().any(|(_, one)| one.gears.len() > 1);
    let shown: &[&str] = if two {
        &["joins", "torque", "slip_1", "slip_2", "drawable", "chosen"]
    } else {
        &["joins", "torque", "slip_1", "drawable", "chosen"]
    };
    Records {
        name: "locks",
        columns: vec![
            Column::number("candidate", "no"),
            Column::words("joins", "joins"),
            Column::number("torque", "T"),
            Column::number("slip_1", "slip in 1"),
            Column::number("slip_2", "slip in 2"),
            Column::words("drawable", "drawable"),
            Column::words("chosen", "chosen"),
        ],
        rows,
        views: vec![View::new(heading("ways to lock for direct drive", all), shown)],
        is_answer: false,
    }
}

fn engagements(all: &[Numbered]) -> Records {
    let mut rows = vec![];
    for &(no, one) in all {
        for line in one.engagement_table() {
            let at = |shift_element| Figure::Mark(line.engaged == shift_element);
            rows.push(vec![
                Figure::Count(no),
                text(line.gear),
                Figure::Multiple(line.ratio),
                at("K1"),
                if one.gears.len() == 1 { Figure::None } else { at("K2") },
                at("L"),
                if line.reverses {
                    Figure::Answer("backward", "backward")
                } else {
                    Figure::Answer("forward", "forward")
                },
            ]);
        }
    }
    let two = all.iter().any(|(_, one)| one.gears.len() > 1);
    let shown: &[&str] = if two {
        &["gear", "ratio", "k1_engaged", "k2_engaged", "lock_engaged", "output"]
    } else {
        &["gear", "ratio", "k1_engaged", "lock_engaged", "output"]
    };
    Records {
        name: "shifts",
        columns: vec![
            Column::number("candidate", "no"),
            Column::words("gear", "gear"),
            Column::number("ratio", "i"),
            Column::words("k1_engaged", "K1"),
            Column::words("k2_engaged", "K2"),
            Column::words("lock_engaged", "lock"),
            Column::words("output", "output"),
        ],
        rows,
        views: vec![View::new(heading("shift table, the slowest output first", all), shown)],
        is_answer: false,
    }
}
