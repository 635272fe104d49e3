//! Ratios of the gears as formulas, with the steps that lead to them.

use super::analysis;
use super::records::{GearFacts, Kind, ShiftElementKind, member_name};
use super::step_losses::StepLosses;
use super::step_torques::StepTorques;
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::records::Fraction;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::formula::polynomial::Polynomial;
use epicyclic_train::formula::steps::{self, Factor as Number};
use epicyclic_train::formula::symbol::Symbol as Meaning;
use epicyclic_train::formula::{self, Formula};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{self as train, Analysis, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// Ratios of all gears of a gearbox, or of one, as formulas.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Formulas {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Symbols that occur in the formulas.
    pub symbols: Vec<Symbol>,
    /// Gears with their formulas.
    pub gears: Vec<Gear>,
    /// Judgement of the gearbox by rules of practice; empty without numbers.
    pub judgement: Judgement,
}

/// Symbol for the absolute value of the basic ratio i₀ = (ω₁ − ω_H)/(ω₂ − ω_H) of two central gears 1 and 2
/// of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Symbol {
    /// Symbol as the formulas write it.
    pub symbol: String,
    /// Name of the set.
    pub set: String,
    /// Kind of the set.
    pub kind: Kind,
    /// Name of central gear 1.
    pub first: String,
    /// Name of central gear 2.
    pub second: String,
    /// Whether i₀ is the negative of the symbol; otherwise i₀ equals the symbol.
    pub is_negative: bool,
    /// Gears whose tooth numbers form the numerator.
    pub teeth_above: Vec<GearTeeth>,
    /// Gears whose tooth numbers form the denominator.
    pub teeth_below: Vec<GearTeeth>,
    /// Value of the symbol; null if the ratio of the set is not known.
    pub value: Option<f64>,
    /// Exact value of the symbol as a fraction; null unless the tooth numbers are known.
    pub exact_value: Option<Fraction>,
}

/// Gear of a set with its tooth number.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearTeeth {
    /// Name of the gear in its set.
    pub gear: String,
    /// Tooth number; null if it is not known.
    pub teeth: Option<u32>,
}

/// Gear of the gearbox with its ratio as a formula.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// Engaged elements, state, ratio and efficiencies of the gear.
    #[serde(flatten)]
    pub facts: GearFacts,
    /// Ratio of the gear as a formula; null if there is no formula.
    pub formula: Option<RatioFormula>,
    /// Reason why the gear has no formula; null if it has one.
    pub no_formula: Option<NoFormula>,
    /// Steps that lead to the ratio; null unless they were asked for.
    pub steps: Option<Steps>,
}

/// Ratio as a formula: the product of the numerator's factors over the product of the denominator's.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RatioFormula {
    /// Formula as text.
    pub text: String,
    /// Factors of the numerator.
    pub numerator: Vec<Factor>,
    /// Factors of the denominator.
    pub denominator: Vec<Factor>,
    /// Value of the formula with the numbers of the gearbox; null if they are not known.
    pub value: Option<f64>,
    /// Exact value of the formula as a fraction; null unless the tooth numbers are known.
    pub exact_value: Option<Fraction>,
    /// Redundant sets, whose equations follow from those of the others. The formula holds only for numbers
    /// for which they do.
    pub spare_sets: Vec<String>,
}

/// Factor of a formula: a sum of terms.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Factor {
    /// Factor as text.
    pub text: String,
    /// Terms of the sum.
    pub terms: Vec<Term>,
}

/// Term of a factor: a number times symbols.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Term {
    /// Coefficient of the term.
    pub coefficient: i64,
    /// Symbols that multiply the coefficient.
    pub symbols: Vec<String>,
}

/// Reason why a gear has no formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NoFormula {
    /// Kind of the reason.
    pub reason: Reason,
    /// Number of symbols that the formula needs, if these are too many; otherwise null.
    pub symbols: Option<usize>,
    /// Maximum number of symbols in a formula.
    pub most_symbols: usize,
}

/// Kinds of reasons why a gear has no formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The gear has no ratio; its state says why.
    NoRatio,
    /// The formula needs more symbols than the limit.
    TooManySymbols,
    /// The gear has its ratio only with these particular numbers.
    TheseNumbersAlone,
}

/// Steps of the calculation of a ratio.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Steps {
    /// Willis equations of the sets that determine the output speed.
    pub equations: Vec<Equation>,
    /// Conditions by which links are held or joined.
    pub conditions: Vec<Condition>,
    /// Equations solved one after the other; the last one gives the output speed.
    pub substitutions: Vec<Substitution>,
    /// Torques without losses; null if they cannot be computed.
    pub torques: Option<StepTorques>,
    /// Torques and powers with losses; null if no set has losses or they cannot be computed.
    pub losses: Option<StepLosses>,
}

/// Willis equation ω₁ − i₀·ω₂ − (1 − i₀)·ω_H = 0 with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Equation {
    /// Name of the set.
    pub set: String,
    /// Symbol of the basic ratio of the set.
    pub symbol: String,
    /// Links of central gear 1, central gear 2 and the carrier, with the factors of their speeds.
    pub terms: Vec<Speed>,
}

/// Speed of a link with a factor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Speed {
    /// Name of the link.
    pub link: String,
    /// Factor of the speed.
    pub factor: f64,
    /// Exact factor as a fraction; null unless the tooth numbers are known.
    pub exact_factor: Option<Fraction>,
}

/// Condition that holds a link or joins two links.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Condition {
    /// Part that holds or joins the links.
    pub by: By,
    /// Kind of the shift element; null if the condition comes from another part.
    pub kind: Option<ShiftElementKind>,
    /// Name of the shift element or set; null for a permanent connection.
    pub name: Option<String>,
    /// Names of the two links, whose speeds are equal; `ground` is the housing.
    pub links: [String; 2],
}

/// Kinds of parts that hold or join links.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum By {
    /// Engaged shift element.
    ShiftElement,
    /// Permanent connection.
    PermanentConnection,
    /// Set with two members that turn together, so that all its members do.
    Block,
    /// Set with a basic ratio of 1.
    BasicRatioOfOne,
}

/// Equation solved for one speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Substitution {
    /// Name of the set.
    pub set: String,
    /// Symbol of the basic ratio of the set.
    pub symbol: String,
    /// Equation under the conditions: the sum of these terms is 0. Links that turn together are replaced by
    /// one of them.
    pub under_conditions: Vec<Speed>,
    /// Known speeds that are substituted.
    pub known: Vec<Known>,
    /// Equation after the substitution: the sum of these terms is 0.
    pub terms: Vec<Speed>,
    /// Link for whose speed the equation is solved.
    pub unknown: String,
    /// Result for this speed as a sum of terms; 0 if there are no terms.
    pub equals: Vec<Speed>,
}

/// Known speed of a link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Known {
    /// Name of the link.
    pub link: String,
    /// Speed of the link as a sum of terms; 0 if there are no terms.
    pub equals: Vec<Speed>,
}

impl Answer for Formulas {
    const NAME: &'static str = "analyze-formulas";
}

/// Derives the formulas of all gears, or of one; `with_steps` adds the steps that lead to each.
///
/// # Errors
/// [`Error::NoGear`] for a gear that does not exist.
pub fn answer(subject: &Gearbox, gear: Option<&str>, with_steps: bool) -> Result<Formulas, Error> {
    let gearbox = &subject.train;
    let names = || gearbox.gears().iter().map(epicyclic_train::Gear::name).collect();
    let names: Vec<&str> = gear.map_or_else(names, |gear| vec![gear]);
    let mut all: Vec<Meaning> = vec![];
    let mut gears = vec![];
    for name in names {
        let analysis = analysis(gearbox, name)?;
        let found = Formula::new(&analysis);
        if let Ok(formula) = &found {
            // The steps also need the symbols that cancel in the formula.
            let occurs = |place: &usize| with_steps || formula.occurring().any(|one| one == *place);
            let meanings = (0..formula.symbols().len()).filter(occurs).map(|place| &formula.symbols()[place]);
            let new: Vec<Meaning> = meanings.filter(|one| !all.contains(one)).cloned().collect();
            all.extend(new);
        }
        gears.push(Gear::of(subject, &analysis, found.as_ref(), with_steps));
    }
    all.sort_by_key(Meaning::equation);
    let symbols = all.iter().map(|meaning| Symbol::of(gearbox, meaning)).collect();
    Ok(Formulas { gearbox: gearbox.name().to_owned(), symbols, gears, judgement: Judgement::default() })
}

impl Formulas {
    /// Removes all numbers, for sets whose tooth numbers are not known: formulas and symbols remain.
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
    fn of(gearbox: &train::Gearbox, meaning: &Meaning) -> Self {
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
        subject: &Gearbox,
        analysis: &Analysis<'_>,
        found: Result<&Formula, &formula::NoFormula>,
        with_steps: bool,
    ) -> Self {
        let gearbox = &subject.train;
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
    fn of(gearbox: &train::Gearbox, formula: &Formula) -> Self {
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
    fn of(why: &formula::NoFormula) -> Self {
        let (reason, symbols) = match why {
            formula::NoFormula::TooLarge { symbols, .. } => (Reason::TooManySymbols, Some(*symbols)),
            formula::NoFormula::NoRatio(_) => (Reason::NoRatio, None),
            _ => (Reason::TheseNumbersAlone, None),
        };
        Self { reason, symbols, most_symbols: epicyclic_train::tolerance::MOST_SYMBOLS }
    }
}

impl Steps {
    fn of(gearbox: &train::Gearbox, analysis: &Analysis<'_>, formula: &Formula) -> Self {
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
    fn of(gearbox: &train::Gearbox, condition: steps::Condition) -> Self {
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
