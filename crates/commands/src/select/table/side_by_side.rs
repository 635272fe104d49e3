//! Speeds of all members of several candidates, side by side.

use super::name;
use crate::schemes::table::speed_lines;
use crate::select::answer::candidate::Candidate;
use crate::table::figure::multiple;
use crate::table::report::{Part, Text};

/// Candidates beside each other: two gears of each leave room for three.
const BESIDE: usize = 3;

/// The most candidates that are shown.
const MOST: usize = 6;

/// Letters of the longest name that fits above a column.
const LONGEST: usize = 6;

/// Tables of the speeds of the first candidates, the accepted before the rejected; none of one alone.
pub(super) fn parts(all: &[Candidate]) -> Vec<Part> {
    let shown = &all[..all.len().min(MOST)];
    if shown.len() < 2 {
        return vec![];
    }
    let rejected = if shown.iter().all(|one| one.accepted) { "" } else { "; x rejected" };
    let heading = "Speeds of the candidates side by side, over the input's".to_owned();
    let note = format!("g planet, on H relative to its carrier; after the scheme the gear{rejected}.");
    let mut first = Some((heading, note));
    let tables = shown.chunks(BESIDE).map(|some| {
        let table = table(some, |one| label(one, shown));
        let (heading, note) = first.take().unzip();
        Part::Text(Text { heading, paragraphs: note.into_iter().collect(), table, ..Text::default() })
    });
    tables.collect()
}

fn table(some: &[Candidate], label: impl Fn(&Candidate) -> String) -> Vec<Vec<String>> {
    let columns = || some.iter().flat_map(|one| one.gears.iter().zip(1..).map(move |gear| (one, gear)));
    let head = columns()
        .map(|(one, (_, gear))| format!("{}/{gear}{}", label(one), if one.accepted { "" } else { " x" }));
    let mut rows = vec![std::iter::once("member".to_owned()).chain(head).collect()];
    let sets = some.iter().map(|one| &one.sets).max_by_key(|sets| sets.len());
    for (place, set) in sets.into_iter().flatten().enumerate() {
        for (member, _, of) in speed_lines(place + 1, &set.links) {
            let speeds = columns().map(|(_, (gear, _))| {
                let speed = multiple(gear.sets.get(place).and_then(of)).in_column(4);
                // The minus of others stands before the digits.
                if speed.starts_with('-') { speed } else { format!(" {speed}") }
            });
            rows.push(std::iter::once(member).chain(speeds).collect());
        }
    }
    rows
}

/// The scheme; the number of the candidate where the name is long or comes twice.
fn label(one: &Candidate, all: &[Candidate]) -> String {
    let own = name(one);
    let is_one = all.iter().filter(|other| name(other) == own).count() == 1;
    if is_one && own.len() <= LONGEST { own } else { format!("no {}", one.no) }
}
