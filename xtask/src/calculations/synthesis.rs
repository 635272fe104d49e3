//! Calculations of the synthesis of gearboxes from ratios.

use super::{Calculation, Refusal, Results};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::judge::judge;
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::{Found, Share, search};
use epicyclic_synthesis::search::Search;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Error, Kind, Structure, count};
use epicyclic_units::Number;
use schemars::JsonSchema;
use serde::Deserialize;
use std::ops::ControlFlow;

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new("synthesis.count", "how many structures a class has, in three ways", counted),
        Calculation::new(
            "synthesis.search",
            "gearboxes that have given ratios, in a whole class or in one structure",
            searched,
        ),
    ]
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        Self { name: "synthesis".into(), message: error.to_string() }
    }
}

/// Rule that the structures of a class keep.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum KindGiven {
    /// No member on the housing, input and output on members, all sets joined by links.
    Core,
    /// Every sparse structure: members may be on the housing, and links may be reached by shift elements
    /// alone.
    AllSparse,
}

/// A class of structures.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ClassGiven {
    /// Rule that its structures keep.
    kind: KindGiven,
    /// Number of planet sets.
    sets: u32,
    /// Number of moving links, input and output among them.
    links: u32,
}

impl ClassGiven {
    fn class(self) -> Result<Class, Refusal> {
        let kind = match self.kind {
            KindGiven::Core => Kind::Core,
            KindGiven::AllSparse => Kind::AllSparse,
        };
        Ok(Class::new(kind, self.sets as usize, self.links as usize)?)
    }
}

/// The class that is counted.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CountGiven {
    /// The class.
    class: ClassGiven,
}

fn counted(given: &CountGiven) -> Result<Results, Refusal> {
    let class = given.class.class()?;
    let counts = count::enumerated(class);
    let mut results = Results::default();
    results
        .count("structures", counts.structures as i64)
        .count("words", counts.words as i64)
        .answer("mass_formula_agrees", count::words(class) == counts.words)
        .answer("burnside_agrees", count::by_burnside(class) == counts.structures);
    Ok(results)
}

/// A gearbox that may be among those found: its structure and shift elements.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct KnownGiven {
    /// The structure: of each set sun, ring and carrier, 0 the housing, 1 the input, 2 the output, other
    /// links as letters: `a-b-c a-d-1`.
    structure: String,
    /// Shift elements: `a` of a brake, `1-f` of a clutch.
    elements: Vec<String>,
}

/// The wanted ratios, and the class of structures that is searched.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SearchGiven {
    /// The class that is searched.
    class: ClassGiven,
    /// Whether the structure of `known` alone is searched. Default: the whole class.
    #[serde(default)]
    only_known: bool,
    /// Ratios of the gears.
    ratios: Vec<Number>,
    /// How far each may be off, relative.
    tolerance: Number,
    /// Number of shift elements.
    elements: u32,
    /// Least and greatest ring-to-sun ratio of a set.
    k: [Number; 2],
    /// A gearbox that may be among those found.
    #[serde(default)]
    known: Option<KnownGiven>,
}

fn searched(given: &SearchGiven) -> Result<Results, Refusal> {
    let class = given.class.class()?;
    let around = |ratio: &Number| {
        let (ratio, reach) = (ratio.get(), given.tolerance.get() * ratio.get().abs());
        Bounds { least: ratio - reach, most: ratio + reach }
    };
    let [low, high] = given.k.map(Number::get);
    let gears = given.ratios.iter().map(around).collect();
    let wish = Wish::new(gears, given.elements as usize, vec![low..=high; class.sets()]);
    wish.check(class)?;
    let known = given.known.as_ref().map(known).transpose()?;
    let mut results = Results::default();
    let found = match (&known, given.only_known) {
        (Some((structure, _)), true) => {
            let mut search = Search::<u64>::new(wish.clone(), class.links());
            let solutions = search.structure(structure).into_iter();
            solutions.map(|solution| Found { structure: structure.clone(), solution }).collect()
        }
        (None, true) => {
            let message = "only_known: give known, whose structure is searched".to_owned();
            return Err(Refusal { name: "no-known-gearbox".into(), message });
        }
        (_, false) => {
            let answer = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(()))?;
            results
                .count("class_size", answer.class_size as i64)
                .count("undecided", answer.tally.undecided as i64)
                .count("reducible", answer.tally.reducible as i64);
            answer.found
        }
    };
    let mut structures: Vec<&Structure> = found.iter().map(|found| &found.structure).collect();
    structures.dedup();
    results.count("gearboxes", found.len() as i64).count("structures", structures.len() as i64);
    let mut all_within = true;
    for found in &found {
        let judged = judge(found, &wish, MeshEfficiency::IDEAL)?;
        all_within &= judged.ratios.iter().zip(&wish.gears).all(|(ratio, gear)| gear.contain(*ratio));
    }
    results.answer("solver_has_the_ratios_of_all", all_within);
    if let Some((structure, elements)) = &known {
        let place = found.iter().position(|found| is_known(found, structure, elements));
        results.answer("known_is_found", place.is_some());
        if let Some(place) = place {
            let judged = judge(&found[place], &wish, MeshEfficiency::IDEAL)?;
            for (set, k) in judged.refined.k.iter().enumerate() {
                results.number(format!("known.k{}", set + 1), *k);
            }
            for (gear, ratio) in judged.ratios.iter().enumerate() {
                results.number(format!("known.ratio.{}", gear + 1), *ratio);
            }
        }
    }
    Ok(results)
}

/// The structure with its shift elements as pairs of links.
fn known(given: &KnownGiven) -> Result<(Structure, Vec<Element>), Refusal> {
    let (structure, letters) = Structure::read(&given.structure)?;
    let pair = |name: &String| {
        let link = |letter: &str| {
            let place = letters.iter().position(|known| letter == known.to_string());
            place.and_then(|place| u8::try_from(place).ok()).ok_or_else(|| {
                let message =
                    format!("shift element {name}: no link of {} is called {letter}", given.structure);
                Refusal { name: "unknown-link".into(), message }
            })
        };
        // A brake joins its link with the housing, link 0.
        let mut pair = match name.split_once('-') {
            Some((one, other)) => [link(one)?, link(other)?],
            None => [0, link(name)?],
        };
        pair.sort_unstable();
        Ok(pair)
    };
    let elements = given.elements.iter().map(pair).collect::<Result<_, Refusal>>()?;
    Ok((structure, elements))
}

/// Whether a gearbox is the known one; an automorphism of the structure may have given another set of the
/// same elements.
fn is_known(found: &Found, structure: &Structure, elements: &[Element]) -> bool {
    found.structure == *structure
        && structure.automorphisms().iter().any(|order| {
            let names = structure.renaming(order);
            elements.iter().all(|pair| {
                let mut image = pair.map(|link| names[usize::from(link)]);
                image.sort_unstable();
                found.solution.elements.iter().any(|pairs| pairs.contains(&image))
            })
        })
}
