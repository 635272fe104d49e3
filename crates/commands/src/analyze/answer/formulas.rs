//! The ratios of gears as formulas, and the way to them.

use super::analysis;
use super::records::{GearFacts, Kind, ShiftElementKind, member_name};
use super::step_losses::StepLosses;
use super::step_torques::StepTorques;
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::shared::records::Fraction;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::formula::polynomial::Polynomial;
use epicyclic_train::formula::steps::{self, Factor as Number};
use epicyclic_train::formula::symbol::Symbol as Meaning;
use epicyclic_train::formula::{self as train, Formula};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{Analysis, Gearbox, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// The ratios of a gearbox, or of one gear of it, as formulas.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Formulas {
    /// Name of the gearbox.
    pub gearbox: String,
    /// The symbols that occur.
    pub symbols: Vec<Symbol>,
    /// The gears.
    pub gears: Vec<Gear>,
}

/// A symbol: the size of the basic ratio i₀ = (ω₁ − ω_H)/(ω₂ − ω_H) of two central gears 1 and 2 of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Symbol {
    /// As formulas write it.
    pub symbol: String,
    /// The set.
    pub set: String,
    /// How the set is made.
    pub kind: Kind,
    /// Central gear 1.
    pub first: String,
    /// Central gear 2.
    pub second: String,
    /// Whether i₀ is the symbol with the sign turned; else it is the symbol.
    pub is_negative: bool,
    /// Gears whose teeth multiply it.
    pub teeth_above: Vec<GearTeeth>,
    /// Gears whose teeth divide it.
    pub teeth_below: Vec<GearTeeth>,
    /// Its value, where the sizes of the sets are known.
    pub value: Option<f64>,
    /// The same, exactly, where the teeth are known.
    pub exact_value: Option<Fraction>,
}

/// A gear wheel of a set with its teeth.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearTeeth {
    /// Its name in the set.
    pub gear: String,
    /// Its teeth, where known.
    pub teeth: Option<u32>,
}

/// A gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// What it engages, its state, ratio and efficiencies.
    #[serde(flatten)]
    pub facts: GearFacts,
    /// Its ratio as a formula.
    pub formula: Option<RatioFormula>,
    /// Why there is none.
    pub no_formula: Option<NoFormula>,
    /// The way to the ratio, where it is asked for.
    pub steps: Option<Steps>,
}

/// A ratio as a formula: the product of the factors of the numerator over that of the denominator.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RatioFormula {
    /// As it is written.
    pub text: String,
    /// Factors of the numerator.
    pub numerator: Vec<Factor>,
    /// Factors of the denominator.
    pub denominator: Vec<Factor>,
    /// Its value at the gearbox's numbers, where they are known.
    pub value: Option<f64>,
    /// The same, exactly, where the teeth are known.
    pub exact_value: Option<Fraction>,
    /// Sets whose equations follow from those of the others: the formula holds at numbers for which they do.
    pub spare_sets: Vec<String>,
}

/// A factor: a sum of terms.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Factor {
    /// As it is written.
    pub text: String,
    /// Its terms.
    pub terms: Vec<Term>,
}

/// A term: a number times symbols.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Term {
    /// The number.
    pub coefficient: i64,
    /// The symbols.
    pub symbols: Vec<String>,
}

/// Why a gear has no formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NoFormula {
    /// The reason.
    pub reason: Reason,
    /// Where there are too many: symbols that it needs.
    pub symbols: Option<usize>,
    /// Symbols that a formula takes at most.
    pub most_symbols: usize,
}

/// The reason why there is no formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The gear has no ratio; its state says why.
    NoRatio,
    /// The formula needs more symbols than are taken.
    TooManySymbols,
    /// The gear has its ratio with these numbers alone.
    TheseNumbersAlone,
}

/// The way to a ratio.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Steps {
    /// Willis' equations of the sets that the output's speed needs.
    pub equations: Vec<Equation>,
    /// What holds links or ties them.
    pub conditions: Vec<Condition>,
    /// The equations, solved one after the other; the last one gives the output's speed.
    pub substitutions: Vec<Substitution>,
    /// Torques without losses, where they follow.
    pub torques: Option<StepTorques>,
    /// Torques and powers with losses, where any set has some and they follow.
    pub losses: Option<StepLosses>,
}

/// Willis' equation ω₁ − i₀·ω₂ − (1 − i₀)·ω_H = 0 with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Equation {
    /// The set.
    pub set: String,
    /// The symbol of its basic ratio.
    pub symbol: String,
    /// Links of central gear 1, central gear 2 and the carrier with the factors of their speeds.
    pub terms: Vec<Speed>,
}

/// The speed of a link with a factor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Speed {
    /// The link.
    pub link: String,
    /// The factor.
    pub factor: f64,
    /// The same, exactly, where the teeth are known.
    pub exact_factor: Option<Fraction>,
}

/// What holds a link or ties two.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Condition {
    /// What does it.
    pub by: By,
    /// What shift element it is.
    pub kind: Option<ShiftElementKind>,
    /// Name of the shift element or set.
    pub name: Option<String>,
    /// The two links, whose speeds are equal; `ground` is the housing.
    pub links: [String; 2],
}

/// What ties links.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum By {
    /// An engaged shift element.
    ShiftElement,
    /// A permanent connection.
    PermanentConnection,
    /// A set of which two members turn as one, and so all.
    Block,
    /// A set with a basic ratio of 1.
    BasicRatioOfOne,
}

/// An equation solved for a speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Substitution {
    /// The set.
    pub set: String,
    /// The symbol of its basic ratio.
    pub symbol: String,
    /// The equation under the conditions, a link standing for all that turn as one with it: the sum of these
    /// is 0.
    pub under_conditions: Vec<Speed>,
    /// Speeds known before, which are put in.
    pub known: Vec<Known>,
    /// The equation then: the sum of these is 0.
    pub terms: Vec<Speed>,
    /// The link whose speed it is solved for.
    pub unknown: String,
    /// That speed as a sum; 0 where there are no terms.
    pub equals: Vec<Speed>,
}

/// A speed that is known.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Known {
    /// The link.
    pub link: String,
    /// Its speed as a sum; 0 where there are no terms.
    pub equals: Vec<Speed>,
}

impl Answer for Formulas {
    const NAME: &'static str = "analyze-formulas";
}

/// The formulas of all gears, or of one; with steps the way to each.
///
/// # Errors
/// [`Error::NoGear`] for a gear that there is not.
pub fn answer(subject: &Subject<'_>, gear: Option<&str>, with_steps: bool) -> Result<Formulas, Error> {
    let gearbox = &subject.gearbox;
    let names = || gearbox.gears().iter().map(epicyclic_train::Gear::name).collect();
    let names: Vec<&str> = gear.map_or_else(names, |gear| vec![gear]);
    let mut all: Vec<Meaning> = vec![];
    let mut gears = vec![];
    for name in names {
        let analysis = analysis(gearbox, name)?;
        let found = Formula::new(&analysis);
        if let Ok(formula) = &found {
            // The steps need what cancels in the formula, too.
            let occurs = |place: &usize| with_steps || formula.occurring().any(|one| one == *place);
            let meanings = (0..formula.symbols().len()).filter(occurs).map(|place| &formula.symbols()[place]);
            let new: Vec<Meaning> = meanings.filter(|one| !all.contains(one)).cloned().collect();
            all.extend(new);
        }
        gears.push(Gear::of(subject, &analysis, found.as_ref(), with_steps));
    }
    all.sort_by_key(Meaning::equation);
    let symbols = all.iter().map(|meaning| Symbol::of(gearbox, meaning)).collect();
    Ok(Formulas { gearbox: gearbox.name().to_owned(), symbols, gears })
}

impl Formulas {
    /// The same of sets whose sizes are not known: formulas and symbols alone.
    #[must_use]
    pub fn without_numbers(mut self) -> Self {
        for symbol in &mut self.symbols {
            (symbol.value, symbol.exact_value) = (None, None);
        }
        for gear in &mut self.gears {
            let facts = &mut gear.facts;
            (facts.ratio, facts.exact_ratio, facts.published) = (None, None, None);
            (facts.efficiency, facts.kreines_efficiency, facts.back_driving_efficiency) = (None, None, None);
            if let Some(formula) = &mut gear.formula {
                (formula.value, formula.exact_value) = (None, None);
            }
        }
        self
    }
}

impl Symbol {
    fn of(gearbox: &Gearbox, meaning: &Meaning) -> Self {
        let set = &gearbox.sets()[meaning.set()];
        let teeth = |gears: &[GearOf]| -> Vec<GearTeeth> {
            let one = |gear: &GearOf| GearTeeth {
                gear: set.gear_name(*gear),
                teeth: set.teeth(*gear).map(ToothCount::get),
            };
            gears.iter().map(one).collect()
        };
        let [first, second] = meaning.centrals().map(|central| member_name(set, central));
        let [above, below] = meaning.teeth().map(teeth);
        Self {
            symbol: meaning.name(),
            set: set.id().to_owned(),
            kind: Kind::of(set),
            first,
            second,
            is_negative: meaning.is_negative(),
            teeth_above: above,
            teeth_below: below,
            value: Some(meaning.value()),
            exact_value: meaning.exact().map(Fraction::of),
        }
    }
}

impl Gear {
    fn of(
        subject: &Subject<'_>,
        analysis: &Analysis<'_>,
        found: Result<&Formula, &train::NoFormula>,
        with_steps: bool,
    ) -> Self {
        let gearbox = &subject.gearbox;
        let steps = |formula: &Formula| Steps::of(gearbox, analysis, formula);
        Self {
            facts: GearFacts::of(subject, analysis),
            formula: found.ok().map(|formula| RatioFormula::of(gearbox, formula)),
            no_formula: found.err().map(NoFormula::of),
            steps: found.ok().filter(|_| with_steps).map(steps),
        }
    }
}

impl RatioFormula {
    fn of(gearbox: &Gearbox, formula: &Formula) -> Self {
        let name = |symbol: usize| formula.symbols()[symbol].name();
        let factors = |factors: Vec<Polynomial>| -> Vec<Factor> {
            let term = |(coefficient, symbols): (i64, Vec<usize>)| Term {
                coefficient,
                symbols: symbols.into_iter().map(name).collect(),
            };
            let factor = |factor: &Polynomial| Factor {
                text: factor.text(&name),
                terms: factor.terms().into_iter().map(term).collect(),
            };
            factors.iter().map(factor).collect()
        };
        Self {
            text: formula.text(),
            numerator: factors(formula.ratio().numerator()),
            denominator: factors(formula.ratio().denominator()),
            value: Some(formula.value()),
            exact_value: formula.exact_value().map(Fraction::of),
            spare_sets: formula.spare().iter().map(|&set| gearbox.sets()[set].id().to_owned()).collect(),
        }
    }
}

impl NoFormula {
    fn of(why: &train::NoFormula) -> Self {
        let (reason, symbols) = match why {
            train::NoFormula::TooLarge { symbols, .. } => (Reason::TooManySymbols, Some(*symbols)),
            train::NoFormula::NoRatio(_) => (Reason::NoRatio, None),
            _ => (Reason::TheseNumbersAlone, None),
        };
        Self { reason, symbols, most_symbols: epicyclic_train::tolerance::MOST_SYMBOLS }
    }
}

impl Steps {
    fn of(gearbox: &Gearbox, analysis: &Analysis<'_>, formula: &Formula) -> Self {
        let steps = steps::Steps::new(gearbox, analysis.gear(), formula);
        let link = |link: LinkId| gearbox.link_name(link).to_owned();
        let speed = |(of, number): &(LinkId, Number)| Speed {
            link: link(*of),
            factor: number.value(),
            exact_factor: match number {
                Number::Exact(exact) => Some(Fraction::of(*exact)),
                Number::Decimal(_) => None,
            },
        };
        let sum = |sum: &steps::Sum| -> Vec<Speed> { sum.iter().map(speed).collect() };
        let set = |symbol: &Meaning| gearbox.sets()[symbol.set()].id().to_owned();
        let equation = |(symbol, numbers): (&Meaning, &[Number; 3])| Equation {
            set: set(symbol),
            symbol: symbol.name(),
            terms: symbol.links().into_iter().zip(*numbers).map(|term| speed(&term)).collect(),
        };
        let substitution = |one: &steps::Substitution| {
            let symbol = &formula.symbols()[one.symbol];
            let known = |(of, equals): &(LinkId, steps::Sum)| Known { link: link(*of), equals: sum(equals) };
            Substitution {
                set: set(symbol),
                symbol: symbol.name(),
                under_conditions: sum(&one.under_conditions),
                known: one.known.iter().map(known).collect(),
                terms: sum(&one.sum),
                unknown: link(one.unknown),
                equals: sum(&one.equals),
            }
        };
        Self {
            equations: formula.symbols().iter().zip(&steps.equations).map(equation).collect(),
            conditions: steps.conditions.iter().map(|condition| Condition::of(gearbox, *condition)).collect(),
            substitutions: steps.substitutions.iter().map(substitution).collect(),
            torques: StepTorques::of(gearbox, analysis),
            losses: StepLosses::of(gearbox, analysis),
        }
    }
}

impl Condition {
    fn of(gearbox: &Gearbox, condition: steps::Condition) -> Self {
        let (by, kind, name, links) = match condition {
            steps::Condition::Engaged(place) => {
                let element = &gearbox.shift_elements()[place];
                let kind = ShiftElementKind::of(element);
                (By::ShiftElement, Some(kind), Some(element.id()), element.links())
            }
            steps::Condition::Permanent(place) => {
                (By::PermanentConnection, None, None, gearbox.permanent()[place])
            }
            steps::Condition::Set { set, links, is_block } => {
                let by = if is_block { By::Block } else { By::BasicRatioOfOne };
                (by, None, Some(gearbox.sets()[set].id()), links)
            }
        };
        let links = links.map(|link| gearbox.link_name(link).to_owned());
        Self { by, kind, name: name.map(str::to_owned), links }
    }
}
