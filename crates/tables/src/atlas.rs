//! The atlas: structures of two and three sets, their gears, and their ratios as functions of `k`.
//!
//! It holds every structure in the classes of [`classes`] and every set of engaged elements that gives it a
//! ratio. Every ratio is stored as a function, so no list of target ratios is needed. Three tables:
//!
//! | `structures` | type | holds |
//! |---|---|---|
//! | `structure` | int32 | its number, from 1 |
//! | `word` | text | the canonical word: sun-ring-carrier of each set |
//! | `sets`, `links` | int32 | how many sets, how many moving links |
//! | `engaged` | int32 | how many elements a gear engages |
//! | `core` | boolean | whether it is in class core, too |
//! | `automorphisms` | int32 | orders of its sets that give the same word |
//! | `elements` | list of text | its possible shift elements, each with those that lock the same: `1-a=1-b` |
//!
//! | `functions` | type | holds |
//! |---|---|---|
//! | `function` | int32 | its number, from 1 |
//! | `formula` | text | the ratio of input speed to output speed, `(1 + k₁)/k₁` |
//! | `k` | text | the numbers of the `k` on which it depends, `1 2` |
//! | `numerator`, `denominator` | list of int64 | coefficients |
//!
//! | `gears` | type | holds |
//! |---|---|---|
//! | `structure` | int32 | the structure |
//! | `engaged` | int64 | the engaged elements as bits: 1 for the first of `elements`, 2, 4, 8 … |
//! | `names` | text | the same by name: `b 1-c` |
//! | `function` | int32 | the ratio |
//!
//! The coefficients are those of 1, k₁, k₂, k₁·k₂, k₃, k₁·k₃, k₂·k₃, k₁·k₂·k₃. Engaged elements that stop the
//! input or the output, or leave a link loose, give no ratio and have no row.

use crate::columns::{Column, write};
use crate::error::Error;
use epicyclic_synthesis::gearbox::element_name;
use epicyclic_synthesis::motion::{Element, Motion, Speeds, elements};
use epicyclic_synthesis::ratio::{Polynomial, Ratio};
use epicyclic_synthesis::work::Share;
use epicyclic_synthesis::{Class, Kind, Structure};
use std::collections::{HashMap, HashSet};
use std::ops::ControlFlow;

/// The tables as Parquet, and their numbers of rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Atlas {
    /// The structures.
    pub structures: Table,
    /// The functions.
    pub functions: Table,
    /// The gears: engaged elements and function of each structure.
    pub gears: Table,
}

/// A table of the atlas.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// Table as Parquet.
    pub bytes: Vec<u8>,
    /// Number of rows.
    pub rows: usize,
}

/// The classes of the atlas: of two sets all sparse ones, and of three sets those with five links and, with
/// six and seven, those of class core. Class core of fewer links is part of all sparse.
///
/// # Errors
/// None: all of them are classes.
pub fn classes() -> Result<[Class; 5], epicyclic_synthesis::Error> {
    Ok([
        Class::new(Kind::AllSparse, 2, 4)?,
        Class::new(Kind::AllSparse, 2, 5)?,
        Class::new(Kind::AllSparse, 3, 5)?,
        Class::new(Kind::Core, 3, 6)?,
        Class::new(Kind::Core, 3, 7)?,
    ])
}

/// The atlas of some classes of at most three sets, unless `goes_on`, which is called now and then, breaks.
///
/// # Errors
/// [`Error::Cancelled`]; [`Error::Sets`] for a class of more; [`Error::Parquet`], which memory alone can
/// cause.
pub fn atlas(
    classes: &[Class],
    version: &str,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Atlas, Error> {
    let mut rows = Rows::default();
    for class in classes {
        if class.sets() > MOST_SETS {
            return Err(Error::Sets { sets: class.sets(), most: MOST_SETS });
        }
        let all = |class: Class| {
            let structures = Share::WHOLE.structures(class, 0, &|| goes_on().is_break());
            structures.map(|(structures, _)| structures).ok_or(Error::Cancelled)
        };
        let core: HashSet<Structure> = match Class::new(Kind::Core, class.sets(), class.links()) {
            Ok(class) => all(class)?.into_iter().collect(),
            Err(_) => HashSet::new(),
        };
        let pairs = elements(class.links());
        let mut motion = Motion::new(class.links() - class.sets());
        for structure in all(*class)? {
            if goes_on().is_break() {
                return Err(Error::Cancelled);
            }
            rows.add(*class, &structure, core.contains(&structure), &pairs, &mut motion);
        }
    }
    rows.tables(version)
}

/// The most sets: a polynomial is a word of eight bits.
const MOST_SETS: usize = 3;

#[derive(Default)]
struct Rows {
    words: Vec<String>,
    sets: Vec<i32>,
    links: Vec<i32>,
    engaged: Vec<i32>,
    core: Vec<bool>,
    automorphisms: Vec<i32>,
    elements: Vec<Vec<String>>,
    ratios: Vec<Ratio>,
    /// The place of a ratio, and of what speeds give it.
    numbers: HashMap<Ratio, i32>,
    by_speeds: HashMap<Speeds<u8>, Option<i32>>,
    gear_structure: Vec<i32>,
    gear_engaged: Vec<i64>,
    gear_names: Vec<String>,
    gear_function: Vec<i32>,
}

fn count(number: usize) -> i32 {
    i32::try_from(number).unwrap_or(i32::MAX)
}

impl Rows {
    fn add(
        &mut self,
        class: Class,
        structure: &Structure,
        core: bool,
        pairs: &[Element],
        motion: &mut Motion<u8>,
    ) {
        motion.take(structure, pairs);
        let (mut kept, mut same): (Vec<usize>, Vec<Vec<Element>>) = (Vec::new(), Vec::new());
        for (place, pair) in pairs.iter().enumerate() {
            // Elements that lock the same are listed once; each alone would repeat every gear.
            match kept.iter().position(|other| motion.tie_the_same(place, *other)) {
                Some(element) => same[element].push(*pair),
                None => {
                    kept.push(place);
                    same.push(vec![*pair]);
                }
            }
        }
        motion.keep(&kept);
        self.words.push(structure.to_string());
        self.sets.push(count(class.sets()));
        self.links.push(count(class.links()));
        self.engaged.push(count(class.engaged()));
        self.core.push(core);
        self.automorphisms.push(count(structure.automorphisms().len()));
        let name = |pairs: &Vec<Element>| pairs.iter().map(|pair| element_name(*pair)).collect::<Vec<_>>();
        self.elements.push(same.iter().map(|pairs| name(pairs).join("=")).collect());
        let names: Vec<String> = same.iter().map(|pairs| element_name(pairs[0])).collect();
        let number = count(self.words.len());
        motion.for_each_gear(&mut |first, last| {
            let from = first.last().map_or(0, |element| element + 1);
            for (element, speeds) in (from..).zip(last) {
                let Some(function) = self.function(*speeds) else { continue };
                let engaged: Vec<usize> = first.iter().copied().chain([element]).collect();
                self.gear_structure.push(number);
                self.gear_engaged.push(engaged.iter().fold(0, |all, element| all | 1i64 << element));
                let names: Vec<&str> = engaged.iter().map(|element| names[*element].as_str()).collect();
                self.gear_names.push(names.join(" "));
                self.gear_function.push(function);
            }
        });
    }

    fn function(&mut self, speeds: Speeds<u8>) -> Option<i32> {
        let Self { ratios, numbers, by_speeds, .. } = self;
        // Many structures give the same speeds, and each ratio of speeds is reduced only once.
        *by_speeds.entry(speeds).or_insert_with(|| {
            let ratio = Ratio::of(speeds)?;
            Some(*numbers.entry(ratio).or_insert_with(|| {
                ratios.push(ratio);
                count(ratios.len())
            }))
        })
    }

    fn tables(self, version: &str) -> Result<Atlas, Error> {
        let told = [("epicyclic.version".to_owned(), version.to_owned())];
        let numbers = |rows: usize| Column::Int((1..=count(rows)).collect());
        let table = |name: &str, columns: &[(&str, Column)], rows: usize| {
            Ok::<_, Error>(Table { bytes: write(name, columns, &told)?, rows })
        };
        let (structures, functions, gears) = (self.words.len(), self.ratios.len(), self.gear_structure.len());
        let coefficients = |polynomial: Polynomial| {
            (0..1 << MOST_SETS).map(|product| i64::from(polynomial.coefficient(product))).collect()
        };
        let variables = |ratio: &Ratio| {
            let set = |set: &usize| ratio.variables() >> (set - 1) & 1 == 1;
            (1..=MOST_SETS).filter(set).map(|set| set.to_string()).collect::<Vec<_>>().join(" ")
        };
        let all = |of: &dyn Fn(&Ratio) -> Vec<i64>| Column::Longs(self.ratios.iter().map(of).collect());
        Ok(Atlas {
            functions: table(
                "functions",
                &[
                    ("function", numbers(functions)),
                    ("formula", Column::Text(self.ratios.iter().map(Ratio::to_string).collect())),
                    ("k", Column::Text(self.ratios.iter().map(variables).collect())),
                    ("numerator", all(&|ratio| coefficients(ratio.numerator))),
                    ("denominator", all(&|ratio| coefficients(ratio.denominator))),
                ],
                functions,
            )?,
            structures: table(
                "structures",
                &[
                    ("structure", numbers(structures)),
                    ("word", Column::Text(self.words)),
                    ("sets", Column::Int(self.sets)),
                    ("links", Column::Int(self.links)),
                    ("engaged", Column::Int(self.engaged)),
                    ("core", Column::Flag(self.core)),
                    ("automorphisms", Column::Int(self.automorphisms)),
                    ("elements", Column::Texts(self.elements)),
                ],
                structures,
            )?,
            gears: table(
                "gears",
                &[
                    ("structure", Column::Int(self.gear_structure)),
                    ("engaged", Column::Long(self.gear_engaged)),
                    ("names", Column::Text(self.gear_names)),
                    ("function", Column::Int(self.gear_function)),
                ],
                gears,
            )?,
        })
    }
}
