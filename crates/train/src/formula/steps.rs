//! The way to a ratio: equations with their numbers, conditions, substitutions.
//!
//! The equations of the formula, with numbers in place of the symbols, are solved one after the other. The
//! next one is the one with the fewest unknown speeds: known speeds are put in, and one unknown speed is
//! expressed by the others. The output's speed comes last. Numbers are fractions if all teeth are known.

use super::Formula;
use super::symbol::Symbol;
use crate::elimination::{Bounded, Scalar};
use crate::{Gear, Gearbox, LinkId};
use epicyclic_gears::simple_set::Fraction;
use std::collections::BTreeMap;

/// A number of an equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Factor {
    /// Fraction of tooth counts.
    Exact(Fraction),
    /// Decimal number, if teeth are not known.
    Decimal(f64),
}

impl Factor {
    /// Value of the factor as a number.
    #[must_use]
    pub fn value(self) -> f64 {
        match self {
            Self::Exact(fraction) => Scalar::number(&fraction),
            Self::Decimal(number) => number,
        }
    }
}

/// Speeds of links, each with its factor; a link represents all links that turn as one with it.
pub type Sum = Vec<(LinkId, Factor)>;

/// Why links turn as one, or a link rests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// A shift element is engaged: its place in the gearbox.
    Engaged(usize),
    /// A connection is permanent: its place in the gearbox.
    Permanent(usize),
    /// A set ties two links.
    Set {
        /// Place of the set in the gearbox.
        set: usize,
        /// The links.
        links: [LinkId; 2],
        /// Whether two of its members turn as one and take the third along; else `i₀ = 1`.
        is_block: bool,
    },
}

/// One equation solved for one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Substitution {
    /// Place of its symbol in [`Formula::symbols`].
    pub symbol: usize,
    /// `Σ factor·ω = 0` under the conditions.
    pub under_conditions: Sum,
    /// Speeds that were known and are put in.
    pub known: Vec<(LinkId, Sum)>,
    /// `Σ factor·ω = 0`, with the known speeds put in.
    pub sum: Sum,
    /// The speed that it is solved for.
    pub unknown: LinkId,
    /// Right-hand side for the unknown speed; 0 if empty.
    pub equals: Sum,
}

/// The way to a ratio.
#[derive(Debug, Clone, PartialEq)]
pub struct Steps {
    /// `1, −i₀, i₀ − 1` of each symbol's equation, at its three links.
    pub equations: Vec<[Factor; 3]>,
    /// Conditions that make links turn as one or rest.
    pub conditions: Vec<Condition>,
    /// The equations, solved one after the other. The last one gives the output's speed.
    pub substitutions: Vec<Substitution>,
}

impl Steps {
    /// The way to the formula of a gear of this gearbox.
    #[must_use]
    pub fn new(gearbox: &Gearbox, gear: &Gear, formula: &Formula) -> Self {
        let symbols = formula.symbols();
        let exact = symbols
            .iter()
            .map(|symbol| symbol.exact().map(|k| signed(symbol, k)))
            .collect::<Option<Vec<_>>>();
        let exact = exact.and_then(|ratios| solved(gear, formula, &ratios, |number| Factor::Exact(*number)));
        let decimal = || {
            let ratio = |symbol: &Symbol| {
                let k = Bounded::<false>::rounded(symbol.value());
                if symbol.is_negative() { k.negative() } else { Some(k) }
            };
            let ratios = symbols.iter().map(ratio).collect::<Option<Vec<_>>>()?;
            solved(gear, formula, &ratios, |number| Factor::Decimal(number.number()))
        };
        let (equations, substitutions) = exact.or_else(decimal).unwrap_or_default();
        let conditions = conditions(gearbox, gear, formula);
        Self { equations, conditions, substitutions }
    }
}

/// Conditions that tie or hold links: all engaged elements, and of the rest those that the equations need.
fn conditions(gearbox: &Gearbox, gear: &Gear, formula: &Formula) -> Vec<Condition> {
    let permanent = gearbox.permanent().iter().enumerate();
    let permanent = permanent.map(|(place, links)| (Condition::Permanent(place), *links, None));
    let engaged = gear
        .engaged()
        .iter()
        .map(|&place| (Condition::Engaged(place), gearbox.shift_elements()[place].links(), None));
    let tied = formula.system().tied().iter().map(|tied| {
        let equation = &gearbox.equations[tied.equation];
        let condition = Condition::Set { set: equation.set, links: tied.links, is_block: tied.is_block };
        (condition, tied.links, Some(equation.links))
    });
    let mut all: Vec<(Condition, [LinkId; 2], Option<[LinkId; 3]>)> =
        permanent.chain(engaged).chain(tied).collect();
    let of_symbols = formula.symbols().iter().flat_map(Symbol::links);
    let needed: Vec<LinkId> = of_symbols.chain([gear.input(), gear.output(), LinkId::GROUND]).collect();
    // A condition that only adds a link that nothing else speaks of is left out, then those before it.
    loop {
        let speaks = |of: usize, link: &LinkId| {
            let (_, ends, members) = &all[of];
            ends.contains(link) || members.is_some_and(|members| members.contains(link))
        };
        let is_idle = |place: &usize| {
            let (condition, ends, _) = &all[*place];
            let is_alone = |link: &LinkId| {
                !needed.contains(link) && !(0..all.len()).any(|other| other != *place && speaks(other, link))
            };
            !matches!(condition, Condition::Engaged(_)) && ends.iter().any(is_alone)
        };
        let Some(idle) = (0..all.len()).find(is_idle) else { break };
        all.remove(idle);
    }
    all.into_iter().map(|(condition, ..)| condition).collect()
}

fn signed(symbol: &Symbol, k: Fraction) -> Fraction {
    if symbol.is_negative() { -k } else { k }
}

type Speeds<S> = BTreeMap<usize, S>;

/// Adds a multiple of speeds; terms that vanish are removed.
fn subtract<S: Scalar>(from: &mut Speeds<S>, factor: &S, speeds: &Speeds<S>) -> Option<()> {
    for (node, share) in speeds {
        let before = from.remove(node).unwrap_or_else(S::zero);
        let after = before.minus(&factor.times(share)?)?;
        if !after.is_zero() {
            from.insert(*node, after);
        }
    }
    Some(())
}

/// Equations with their numbers and substitutions; `None` where a number outgrows its kind.
fn solved<S: Scalar>(
    gear: &Gear,
    formula: &Formula,
    ratios: &[S],
    factor: impl Fn(&S) -> Factor,
) -> Option<(Vec<[Factor; 3]>, Vec<Substitution>)> {
    let system = formula.system();
    let topology = system.topology();
    let (input, output) = (topology.input?, topology.output?);
    // The input's or output's name, else the first that the equations use.
    let named: Vec<LinkId> = [gear.input(), gear.output()]
        .into_iter()
        .chain(formula.symbols().iter().flat_map(Symbol::links))
        .collect();
    let link = |node: usize| {
        let found = named.iter().find(|link| topology.node[link.index()] == Some(node));
        found.copied().unwrap_or(LinkId::GROUND)
    };
    let sum = |speeds: &Speeds<S>| -> Sum {
        speeds.iter().map(|(node, share)| (link(*node), factor(share))).collect()
    };
    let mut equations = vec![];
    let mut left: Vec<(usize, Speeds<S>)> = vec![];
    for (place, (symbol, ratio)) in formula.symbols().iter().zip(ratios).enumerate() {
        let factors = [S::one(), ratio.negative()?, ratio.minus(&S::one())?];
        let mut speeds = Speeds::new();
        for (link, share) in symbol.links().into_iter().zip(&factors) {
            if let Some(node) = topology.node[link.index()] {
                subtract(&mut speeds, &share.negative()?, &Speeds::from([(node, S::one())]))?;
            }
        }
        equations.push(factors.map(|share| factor(&share)));
        left.push((place, speeds));
    }
    let mut known: BTreeMap<usize, Speeds<S>> = BTreeMap::new();
    let mut substitutions = vec![];
    while !left.is_empty() && known.get(&output).is_none_or(|speeds| speeds.keys().any(|node| *node != input))
    {
        let unknown = |speeds: &Speeds<S>, known: &BTreeMap<usize, Speeds<S>>| {
            let mut count: Vec<usize> = vec![];
            for node in speeds.keys().filter(|node| **node != input) {
                match known.get(node) {
                    None => count.push(*node),
                    Some(by) => count.extend(by.keys().filter(|node| **node != input)),
                }
            }
            count.sort_unstable();
            count.dedup();
            count
        };
        // The output's speed last, where there is a choice.
        let rank = |(_, speeds): &&(usize, Speeds<S>)| {
            let unknown = unknown(speeds, &known);
            (unknown.len(), unknown.contains(&output))
        };
        let next = left.iter().min_by_key(rank).map(|(place, _)| *place)?;
        let at = left.iter().position(|(place, _)| *place == next)?;
        let (symbol, mut speeds) = left.remove(at);
        let under_conditions = sum(&speeds);
        let put_in: Vec<usize> = speeds.keys().copied().filter(|node| known.contains_key(node)).collect();
        let told = put_in.iter().map(|node| (link(*node), sum(&known[node]))).collect();
        for node in &put_in {
            let share = speeds.remove(node)?;
            subtract(&mut speeds, &share.negative()?, &known[node])?;
        }
        let Some(solve_for) =
            speeds.keys().copied().filter(|node| *node != input).min_by_key(|node| *node == output)
        else {
            continue;
        };
        let written = sum(&speeds);
        let share = speeds.remove(&solve_for)?;
        let mut equals = Speeds::new();
        for (node, other) in &speeds {
            equals.insert(*node, other.over(&share)?.negative()?);
        }
        for by in known.values_mut() {
            if let Some(share) = by.remove(&solve_for) {
                subtract(by, &share.negative()?, &equals)?;
            }
        }
        substitutions.push(Substitution {
            symbol,
            under_conditions,
            known: told,
            sum: written,
            unknown: link(solve_for),
            equals: sum(&equals),
        });
        known.insert(solve_for, equals);
    }
    Some((equations, substitutions))
}
