//! Results of a search in a share of a class, as a table: one row for each solution.
//!
//! | column | type | holds |
//! |---|---|---|
//! | `search` | int32 | which of the searches of the part, from 1 |
//! | `place` | int64 | the place of the structure in its share, from 0 |
//! | `structure` | text | its canonical word, `1-a-2 b-2-c` |
//! | `elements` | list of text | each shift element with those that lock the same: `1-a=1-b` |
//! | `k` | list of double | ring-to-sun ratios with which all gears are within their bounds, as found |
//! | `equal` | list of int64 | the sets, from 1, whose `k` were asked to be equal |
//! | `formulas` | list of text | each gear's ratio |
//! | `coefficients` | list of int64 | formulas as bits, four words a gear |
//! | `engaged` | list of text | the elements that each gear engages, every choice: `b 1-c or b a-c` |
//!
//! The four words of `coefficients` mark the coefficients that are 1 and those that are −1, first of the
//! numerator, then of the denominator.
//!
//! The file's metadata holds a checksum of the whole file (`epicyclic.checksum`), the version of the program
//! and the share. For each search it holds the exact question, the structures that were searched, and the
//! counts. Work that is not complete has the same form, and the search is continued from there.

use crate::columns::{Column, Read, write};
use crate::error::Error;
use crate::seal;
use epicyclic_synthesis::Structure;
use epicyclic_synthesis::asked::Asked;
use epicyclic_synthesis::equal::Equal;
use epicyclic_synthesis::gearbox::{element_name, element_of_name};
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::ratio::{Polynomial, Ratio};
use epicyclic_synthesis::search::{Gear, Solution};
use epicyclic_synthesis::tally::Tally;
use epicyclic_synthesis::work::{Found, Share, Work};
use parquet::record::{Field, Row, RowAccessor as _};
use std::ops::Range;

/// Results of searches in a share of their classes.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The version of the program.
    pub version: String,
    /// The share.
    pub share: Share,
    /// Question of each search, and the work done.
    pub searches: Vec<(Asked, Work)>,
}

const VERSION: &str = "epicyclic.version";
const SHARE: &str = "epicyclic.share";
const SEARCHES: &str = "epicyclic.searches";

/// Parts the pairs of links that lock the same.
const SAME: &str = "=";
/// Parts choices of elements.
const OR: &str = " or ";

impl Part {
    /// Whether all its structures were searched.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.searches.iter().all(|(_, work)| work.is_complete())
    }

    /// Writes the part as Parquet.
    ///
    /// # Errors
    /// [`Error::Parquet`], which memory alone can cause.
    pub fn to_parquet(&self) -> Result<Vec<u8>, Error> {
        let mut told = vec![
            (seal::KEY.to_owned(), seal::OPEN.to_owned()),
            (VERSION.to_owned(), self.version.clone()),
            (SHARE.to_owned(), self.share.to_string()),
            (SEARCHES.to_owned(), self.searches.len().to_string()),
        ];
        for (number, (asked, work)) in (1..).zip(&self.searches) {
            let mut tell = |name: &str, value: String| told.push((key(number, name), value));
            tell("class_size", work.class_size.to_string());
            tell("structures", work.structures.to_string());
            let done = work.done.iter().map(|range| format!("{}..{}", range.start, range.end));
            tell("done", done.collect::<Vec<_>>().join(" "));
            for (name, count) in Tally::NAMES.iter().zip(work.tally.counts()) {
                tell(&format!("counted.{name}"), count.to_string());
            }
            for (name, value) in asked {
                tell(&format!("{ASKED}{name}"), value.clone());
            }
        }
        let rows: Vec<(usize, &(usize, Found))> = (1..)
            .zip(&self.searches)
            .flat_map(|(number, (_, work))| work.found.iter().map(move |found| (number, found)))
            .collect();
        let mut bytes = write("part", &columns(&rows), &told)?;
        seal::seal(&mut bytes)?;
        Ok(bytes)
    }

    /// Reads a part from Parquet.
    ///
    /// # Errors
    /// [`Error::Unsealed`] and [`Error::Damaged`] for bytes that are no part or were changed, before anything
    /// is read. [`Error::Parquet`] and [`Error::NoPart`] for a table of something else with such a checksum.
    pub fn from_parquet(bytes: Vec<u8>) -> Result<Self, Error> {
        // The checksum comes first: a damaged table might still be read as another search.
        seal::check(&bytes)?;
        let table = Read::new(bytes)?;
        let fault = |what: &str| Error::NoPart(format!("not part of a search: no {what} in its metadata"));
        let version = table.told(VERSION).ok_or_else(|| fault(VERSION))?.to_owned();
        let share = table.told(SHARE).and_then(|share| share.parse().ok()).ok_or_else(|| fault(SHARE))?;
        let count: usize =
            table.told(SEARCHES).and_then(|count| count.parse().ok()).ok_or_else(|| fault(SEARCHES))?;
        let mut searches = Vec::new();
        for number in 1..=count {
            let told = |name: &str| {
                let key = key(number, name);
                table.told(&key).ok_or_else(|| fault(&key))
            };
            let number_told = |name: &str| {
                let fault = |_| Error::NoPart(format!("damaged: {name} of search {number} is no number"));
                told(name)?.parse::<usize>().map_err(fault)
            };
            let mut counts = [0; Tally::NAMES.len()];
            for (name, count) in Tally::NAMES.iter().zip(&mut counts) {
                *count = number_told(&format!("counted.{name}"))? as u64;
            }
            let asked = table
                .told_below(&key(number, ASKED))
                .map(|(name, value)| (name.to_owned(), value.to_owned()))
                .collect();
            let work = Work {
                class_size: number_told("class_size")?,
                structures: number_told("structures")?,
                done: ranges(told("done")?).ok_or_else(|| fault("done"))?,
                found: Vec::new(),
                tally: Tally::of_counts(counts),
            };
            searches.push((asked, work));
        }
        for (place, row) in table.rows.iter().enumerate() {
            let damaged = || Error::NoPart(format!("damaged: row {} is no solution", place + 1));
            let number = (row.len() == COLUMNS).then(|| row.get_int(0)).transpose()?;
            let number = number
                .and_then(|number| usize::try_from(number).ok())
                .and_then(|number| number.checked_sub(1));
            let (_, work) = number.and_then(|number| searches.get_mut(number)).ok_or_else(damaged)?;
            work.found.push(solution(row).ok_or_else(damaged)?);
        }
        Ok(Self { version, share, searches })
    }
}

const ASKED: &str = "asked.";

/// Columns of a part.
const COLUMNS: usize = 9;

fn key(search: usize, name: &str) -> String {
    format!("epicyclic.{search}.{name}")
}

fn ranges(text: &str) -> Option<Vec<Range<usize>>> {
    let range = |range: &str| {
        let (start, end) = range.split_once("..")?;
        Some(start.parse().ok()?..end.parse().ok()?)
    };
    text.split_whitespace().map(range).collect()
}

fn columns(rows: &[(usize, &(usize, Found))]) -> [(&'static str, Column); COLUMNS] {
    fn all<T>(rows: &[(usize, &(usize, Found))], of: impl Fn(&Found) -> T) -> Vec<T> {
        rows.iter().map(|(_, (_, found))| of(found)).collect()
    }
    let number = |number: usize| i32::try_from(number).unwrap_or(i32::MAX);
    let place = |place: usize| i64::try_from(place).unwrap_or(i64::MAX);
    let elements = |found: &Found| {
        let names = |pairs: &Vec<Element>| pairs.iter().map(|pair| element_name(*pair)).collect::<Vec<_>>();
        found.solution.elements.iter().map(|pairs| names(pairs).join(SAME)).collect()
    };
    let coefficients = |found: &Found| {
        let words = |gear: &Gear| {
            let Ratio { numerator, denominator } = gear.ratio;
            [numerator.plus, numerator.minus, denominator.plus, denominator.minus].map(u64::cast_signed)
        };
        found.solution.gears.iter().flat_map(words).collect()
    };
    // Elements that lock the same are named by the first of them.
    let engaged = |found: &Found| {
        let names: Vec<String> = found.solution.elements.iter().map(|pairs| element_name(pairs[0])).collect();
        let choice = |choice: &Vec<usize>| {
            choice.iter().map(|element| names[*element].as_str()).collect::<Vec<_>>().join(" ")
        };
        let choices = |gear: &Gear| gear.engaged.iter().map(choice).collect::<Vec<_>>().join(OR);
        found.solution.gears.iter().map(choices).collect()
    };
    let equal = |found: &Found| found.solution.equal.sets().map(|set| set as i64 + 1).collect();
    let formulas = |found: &Found| found.solution.gears.iter().map(|gear| gear.ratio.to_string()).collect();
    [
        ("search", Column::Int(rows.iter().map(|(search, _)| number(*search)).collect())),
        ("place", Column::Long(rows.iter().map(|(_, (at, _))| place(*at)).collect())),
        ("structure", Column::Text(all(rows, |found| found.structure.to_string()))),
        ("elements", Column::Texts(all(rows, elements))),
        ("k", Column::Doubles(all(rows, |found| found.solution.k.clone()))),
        ("equal", Column::Longs(all(rows, equal))),
        ("formulas", Column::Texts(all(rows, formulas))),
        ("coefficients", Column::Longs(all(rows, coefficients))),
        ("engaged", Column::Texts(all(rows, engaged))),
    ]
}

/// A row as a solution.
fn solution(row: &Row) -> Option<(usize, Found)> {
    if row.len() != COLUMNS {
        return None;
    }
    let list = |column: usize| Some(row.get_list(column).ok()?.elements());
    let texts = |column: usize| {
        let text = |field: &Field| if let Field::Str(text) = field { Some(text.clone()) } else { None };
        list(column)?.iter().map(text).collect::<Option<Vec<String>>>()
    };
    let place = usize::try_from(row.get_long(1).ok()?).ok()?;
    let structure: Structure = row.get_string(2).ok()?.parse().ok()?;
    let pairs = |names: &String| names.split(SAME).map(element_of_name).collect::<Option<Vec<Element>>>();
    let elements = texts(3)?.iter().map(pairs).collect::<Option<Vec<_>>>()?;
    let names: Vec<String> = elements.iter().map(|pairs| element_name(pairs[0])).collect();
    let double = |field: &Field| if let Field::Double(value) = field { Some(*value) } else { None };
    let k = list(4)?.iter().map(double).collect::<Option<Vec<f64>>>()?;
    let word =
        |field: &Field| if let Field::Long(value) = field { Some(value.cast_unsigned()) } else { None };
    let set = |word: u64| usize::try_from(word).ok()?.checked_sub(1).filter(|set| *set < k.len());
    let equal = list(5)?.iter().map(|field| set(word(field)?)).collect::<Option<Equal>>()?;
    let words = list(7)?.iter().map(word).collect::<Option<Vec<u64>>>()?;
    let ratio = |words: &[u64]| {
        let [above, above_minus, below, below_minus] = words.try_into().ok()?;
        Some(Ratio {
            numerator: Polynomial { plus: above, minus: above_minus },
            denominator: Polynomial { plus: below, minus: below_minus },
        })
    };
    let ratios = words.chunks(4).map(ratio).collect::<Option<Vec<Ratio>>>()?;
    let choice = |choice: &str| {
        choice.split(' ').map(|name| names.iter().position(|known| known == name)).collect::<Option<_>>()
    };
    let choices = |text: &String| text.split(OR).map(choice).collect::<Option<Vec<Vec<usize>>>>();
    let engaged = texts(8)?.iter().map(choices).collect::<Option<Vec<_>>>()?;
    if engaged.len() != ratios.len() || k.len() != structure.sets().len() {
        return None;
    }
    let gears = ratios.into_iter().zip(engaged).map(|(ratio, engaged)| Gear { ratio, engaged }).collect();
    Some((place, Found { structure, solution: Solution { elements, k, equal, gears } }))
}
