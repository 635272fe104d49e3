//! The ratios of gears as formulas, and the way to them.

use super::shared::{exact, state};
use crate::analyze::answer::formulas::{
    By, Condition, Equation, Formulas, Gear, GearTeeth, NoFormula, Reason, Speed, Steps, Substitution, Symbol,
};
use crate::analyze::answer::records::ShiftElementKind;
use crate::analyze::answer::step_losses::{MeshSteps, StepLosses};
use crate::analyze::answer::step_torques::{MemberTorque, StepTorques, TorqueFrom};
use crate::analyze::answer::warnings::state_in_words;
use crate::shared::judgement::table as judgement;
use crate::shared::records::Fraction;
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Text};
use epicyclic_units::format::trimmed;

/// Significant digits of a decimal in an equation.
const DIGITS: usize = 6;

/// Significant digits of a ratio beside its fraction.
const RATIO_DIGITS: usize = 5;

/// What the symbols have in common.
const BASIC_RATIO: &str = "  i₀ = (ω_1 − ω_H)/(ω_2 − ω_H): central gears 1 and 2 of a set, H its carrier";

/// The housing.
const GROUND: &str = "ground";

impl AsReport for Formulas {
    fn report(&self) -> Report {
        let mut parts = vec![Part::Text(Text {
            heading: Some("Ratios, input speed over output speed".to_owned()),
            lines: self.gears.iter().map(ratio).collect(),
            ..Text::default()
        })];
        let spare: Vec<String> = self.gears.iter().filter_map(spare).collect();
        if !spare.is_empty() {
            parts.push(Part::Text(Text::list("Sets that a formula does without", spare)));
        }
        parts.push(Part::Records(gears(&self.gears)));
        if !self.symbols.is_empty() {
            parts.push(Part::Text(Text {
                heading: Some("Symbols".to_owned()),
                lines: self.symbols.iter().map(symbol).chain([BASIC_RATIO.to_owned()]).collect(),
                ..Text::default()
            }));
            parts.push(Part::Records(symbols(&self.symbols)));
        }
        for gear in &self.gears {
            if let Some(steps) = &gear.steps {
                parts.push(Part::Text(way(self, gear, steps)));
                parts.push(Part::Records(substitutions(gear, steps)));
                parts.push(Part::Records(member_torques(gear, steps)));
            }
        }
        parts.extend(judgement::parts(&self.judgement));
        Report { title: Some(self.gearbox.clone()), parts, warnings: None }
    }
}

/// `22/7 = 3.1429`.
fn value(number: f64, exact: Option<Fraction>) -> String {
    match exact {
        Some(exact) if exact.denominator == 1 => signed(&exact.to_string()),
        Some(exact) => format!("{} = {}", signed(&exact.to_string()), decimal(number, RATIO_DIGITS)),
        None => decimal(number, RATIO_DIGITS),
    }
}

fn decimal(number: f64, digits: usize) -> String {
    signed(&trimmed(number, digits))
}

/// With the sign that formulas have.
fn signed(number: &str) -> String {
    number.replace('-', "−")
}

fn ratio(gear: &Gear) -> String {
    let name = &gear.facts.gear;
    match (&gear.formula, &gear.no_formula) {
        (Some(formula), _) => {
            let value = formula.value.map(|number| value(number, formula.exact_value));
            let value = value.filter(|value| formula.text != *value);
            let value = value.map_or_else(String::new, |value| format!(" = {value}"));
            format!("  {name}: i = {}{value}", formula.text)
        }
        (None, Some(why)) => format!("  {name}: {}", no_formula(gear, *why)),
        (None, None) => format!("  {name}"),
    }
}

fn no_formula(gear: &Gear, why: NoFormula) -> String {
    match why.reason {
        Reason::NoRatio => state_in_words(&gear.facts),
        Reason::TooManySymbols => format!(
            "the ratio depends on {} basic ratios, and a formula has at most {}; --gear without --formula has its value",
            why.symbols.unwrap_or_default(),
            why.most_symbols
        ),
        Reason::TheseNumbersAlone => {
            "the ratio exists with these numbers alone: there is no formula".to_owned()
        }
    }
}

fn spare(gear: &Gear) -> Option<String> {
    let formula = gear.formula.as_ref().filter(|formula| !formula.spare_sets.is_empty())?;
    let sets = formula.spare_sets.join(", ");
    Some(format!(
        "{}: {sets}; the speeds follow without, and the formula holds at numbers that agree with it",
        gear.facts.gear
    ))
}

fn gears(gears: &[Gear]) -> Records {
    Table::new("gears", gears.iter())
        .text("gear", "gear", |gear| &gear.facts.gear)
        .words("engaged", "engaged", |gear| gear.facts.engaged.clone())
        .words("state", "state", |gear| state(gear.facts.state))
        .multiple("ratio", "i", |gear| gear.facts.ratio)
        .words("formula", "formula", |gear| Some(&*gear.formula.as_ref()?.text))
        .multiple("value", "value", |gear| gear.formula.as_ref()?.value)
        .number("exact_value", "exact", |gear| Some(exact(gear.formula.as_ref()?.exact_value)))
        .records()
}

/// What a symbol is: `k₁ of P1: i₀ = −k₁ from sun to ring; k₁ = z_ring/z_sun = 96/48 = 2`.
fn symbol(symbol: &Symbol) -> String {
    let Symbol { symbol: name, set, first, second, .. } = symbol;
    let sign = if symbol.is_negative { "−" } else { "" };
    let teeth = in_teeth(symbol);
    // Teeth without a common divisor are the fraction already.
    let reduced = symbol.exact_value.filter(|exact| teeth.ends_with(&format!(" = {exact}")));
    let exact = symbol.exact_value.filter(|_| reduced.is_none());
    let value = symbol.value.map_or_else(String::new, |number| format!(" = {}", value(number, exact)));
    format!("  {name} of {set}: i₀ = {sign}{name} from {first} to {second}; {name} = {teeth}{value}")
}

fn symbols(symbols: &[Symbol]) -> Records {
    Table::new("symbols", symbols.iter())
        .text("symbol", "symbol", |symbol| &symbol.symbol)
        .text("set", "set", |symbol| &symbol.set)
        .text("first", "1", |symbol| &symbol.first)
        .text("second", "2", |symbol| &symbol.second)
        .words("is_negative", "negative", |symbol| symbol.is_negative)
        .words("in_teeth", "in teeth", |symbol| in_teeth(symbol))
        .multiple("value", "value", |symbol| symbol.value)
        .number("exact_value", "exact", |symbol| exact(symbol.exact_value))
        .records()
}

/// `z_ring/z_sun = 96/48`.
fn in_teeth(symbol: &Symbol) -> String {
    let product =
        |gears: &[GearTeeth], one: &dyn Fn(&GearTeeth) -> Option<String>| -> Option<(String, bool)> {
            let parts = gears.iter().map(one).collect::<Option<Vec<_>>>()?;
            Some((if parts.is_empty() { "1".to_owned() } else { parts.join("·") }, parts.len() > 1))
        };
    let quotient = |one: &dyn Fn(&GearTeeth) -> Option<String>| {
        let (above, _) = product(&symbol.teeth_above, one)?;
        let (below, is_product) = product(&symbol.teeth_below, one)?;
        Some(if is_product { format!("{above}/({below})") } else { format!("{above}/{below}") })
    };
    let named = quotient(&|gear| Some(format!("z_{}", subscript(&gear.gear)))).unwrap_or_default();
    match quotient(&|gear| gear.teeth.map(|teeth| teeth.to_string())) {
        Some(numbers) => format!("{named} = {numbers}"),
        None => named,
    }
}

/// A name below a symbol: in brackets where it is more than one word.
fn subscript(name: &str) -> String {
    if name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.')) {
        name.to_owned()
    } else {
        format!("({name})")
    }
}

fn speed_of(link: &str) -> String {
    format!("ω_{}", subscript(link))
}

/// `2·ω_a − 3·ω_b`, the housing left out; 0 of nothing.
fn sum<'t>(terms: impl IntoIterator<Item = (String, &'t str)>) -> String {
    let mut text = String::new();
    for (factor, link) in terms.into_iter().filter(|(_, link)| *link != GROUND) {
        let (is_negative, factor) = match factor.strip_prefix('−') {
            Some(size) => (true, size),
            None => (false, factor.as_str()),
        };
        text += match (text.is_empty(), is_negative) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        if factor != "1" {
            text += factor;
            text.push('·');
        }
        text += &speed_of(link);
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

fn number(speed: &Speed) -> String {
    match speed.exact_factor {
        Some(exact) => signed(&exact.to_string()),
        None => decimal(speed.factor, DIGITS),
    }
}

fn speeds(terms: &[Speed]) -> String {
    sum(terms.iter().filter(|term| term.factor != 0.0).map(|term| (number(term), term.link.as_str())))
}

/// The way to the ratio of a gear, in words and equations.
fn way(formulas: &Formulas, gear: &Gear, steps: &Steps) -> Text {
    let facts = &gear.facts;
    let [input, output] = [&facts.input, &facts.output].map(|link| speed_of(link));
    let mut lines = vec![];
    if !steps.equations.is_empty() {
        lines.push("  Willis' equations, ω_1 − i₀·ω_2 − (1 − i₀)·ω_H = 0; the housing rests".to_owned());
        for equation in &steps.equations {
            let is_negative =
                formulas.symbols.iter().any(|symbol| symbol.symbol == equation.symbol && symbol.is_negative);
            lines.push(format!("    {}: {} = 0", equation.set, with_symbol(equation, is_negative)));
            lines.push(format!("      {} = 0", speeds(&equation.terms)));
        }
    }
    if !steps.conditions.is_empty() {
        lines.push("  Conditions".to_owned());
        lines.extend(steps.conditions.iter().map(condition));
    }
    if !steps.substitutions.is_empty() {
        lines.push("  Substitution".to_owned());
        steps.substitutions.iter().for_each(|one| lines.extend(substitution(one)));
    }
    lines.push("  Result".to_owned());
    let from_last = steps.substitutions.last().and_then(|last| match &last.equals[..] {
        [share] => {
            let inverse = |exact: Fraction| Fraction {
                numerator: exact.denominator * exact.numerator.signum(),
                denominator: exact.numerator.abs(),
            };
            Some(value(1.0 / share.factor, share.exact_factor.map(inverse)))
        }
        _ => None,
    });
    // Without equations input and output turn as one.
    lines.push(format!("    i = {input}/{output} = {}", from_last.unwrap_or_else(|| "1".to_owned())));
    if let Some(formula) = gear.formula.as_ref().filter(|_| !steps.substitutions.is_empty()) {
        let value = formula
            .value
            .map_or_else(String::new, |number| format!(" = {}", value(number, formula.exact_value)));
        lines.push(format!("    the formula gives {}{value}", formula.text));
    }
    match &steps.torques {
        Some(torques) => lines.extend(balance(torques)),
        None => lines.push("  Torques do not follow from the input's alone.".to_owned()),
    }
    match &steps.losses {
        Some(losses) => lines.extend(of_losses(losses)),
        None if steps.torques.is_some() => {
            lines.push("  Without losses η = 1; --efficiency 0.97 gives each set some.".to_owned());
        }
        None => {}
    }
    Text { heading: Some(format!("Gear {}: the way to its ratio", facts.gear)), lines, ..Text::default() }
}

/// Willis' equation with its symbol: `ω_a + k₁·ω_b − (1 + k₁)·ω_H`.
fn with_symbol(equation: &Equation, is_negative: bool) -> String {
    let symbol = &equation.symbol;
    let factors = if is_negative {
        ["1".to_owned(), symbol.clone(), format!("−(1 + {symbol})")]
    } else {
        ["1".to_owned(), format!("−{symbol}"), format!("−(1 − {symbol})")]
    };
    sum(factors.into_iter().zip(equation.terms.iter().map(|term| term.link.as_str())))
}

fn condition(condition: &Condition) -> String {
    let name = condition.name.as_deref().unwrap_or_default();
    let what = match (condition.by, condition.kind) {
        (By::ShiftElement, Some(ShiftElementKind::Brake)) => format!("brake {name}"),
        (By::ShiftElement, Some(ShiftElementKind::OneWayBrake | ShiftElementKind::OneWayClutch)) => {
            format!("one-way clutch {name}")
        }
        (By::ShiftElement, _) => format!("clutch {name}"),
        (By::PermanentConnection, _) => "permanent connection".to_owned(),
        (By::Block, _) => format!("two members of {name} turn as one, and so all"),
        (By::BasicRatioOfOne, _) => format!("i₀ = 1 in {name}"),
    };
    let [first, second] = condition.links.each_ref().map(String::as_str);
    let equation = match (first, second) {
        (GROUND, link) | (link, GROUND) => format!("{} = 0", speed_of(link)),
        _ => format!("{} = {}", speed_of(first), speed_of(second)),
    };
    format!("    {what}: {equation}")
}

/// The lines of an equation that is solved.
fn substitution(one: &Substitution) -> Vec<String> {
    let mut lines = vec![format!("    {}: {} = 0", one.set, speeds(&one.under_conditions))];
    if !one.known.is_empty() {
        let known =
            one.known.iter().map(|known| format!("{} = {}", speed_of(&known.link), speeds(&known.equals)));
        let known = known.collect::<Vec<_>>().join(", ");
        lines.push(format!("      with {known}: {} = 0", speeds(&one.terms)));
    }
    lines.push(format!("      {} = {}", speed_of(&one.unknown), speeds(&one.equals)));
    lines
}

/// Torques of the members, and their balance on each link.
fn balance(torques: &StepTorques) -> Vec<String> {
    let mut lines = vec![
        "  Torques on the members over the input's, without losses; in each equation".to_owned(),
        "  T_1 : T_2 : T_H = 1 : −i₀ : i₀ − 1".to_owned(),
    ];
    for of_set in torques.members.chunk_by(|one, other| one.set == other.set) {
        let one = |torque: &MemberTorque| {
            format!("{} {}", torque.member, decimal(torque.torque_of_input, RATIO_DIGITS))
        };
        let all = of_set.iter().map(one).collect::<Vec<_>>().join(", ");
        lines.push(format!("    {}: {all}", of_set[0].set));
    }
    lines.push("  Balance of each link, with the reactions of the members".to_owned());
    for link in &torques.links {
        let mut sum = String::new();
        for torque in &link.torques {
            let of = torque.torque_of_input;
            sum += match (sum.is_empty(), of < 0.0) {
                (true, false) => "",
                (true, true) => "−",
                (false, false) => " + ",
                (false, true) => " − ",
            };
            let from = match torque.from {
                TorqueFrom::Input => "input".to_owned(),
                TorqueFrom::Output => "output".to_owned(),
                TorqueFrom::ShiftElement => torque.name.clone().unwrap_or_default(),
                TorqueFrom::Set => {
                    [&torque.name, &torque.member].map(|part| part.clone().unwrap_or_default()).join(" ")
                }
            };
            sum += &format!("{} ({from})", decimal(of.abs(), RATIO_DIGITS));
        }
        lines.push(format!("    {}: {sum} = 0", link.links.join(", ")));
    }
    lines
}

/// Torques, rolling powers and losses of the sets, and the efficiency.
fn of_losses(losses: &StepLosses) -> Vec<String> {
    let number = |value: f64| decimal(value, RATIO_DIGITS);
    if losses.sets.is_empty() {
        return vec!["  No set carries torque: no losses, η = 1.".to_owned()];
    }
    let mut lines = vec![
        "  With losses, driven from the input: torques over the input's, rolling powers".to_owned(),
        "  P = T·(ω − ω_H) over what enters, which sum up to what the meshes take".to_owned(),
    ];
    for set in &losses.sets {
        let eta = set.efficiency.map_or_else(String::new, |eta| format!("η₀ = {}, ", number(eta)));
        let ratio = match set.exponent {
            Some(1) => "rolling power from gear 1 to 2\n      T_1 : T_2 : T_H = 1 : −i₀·η₀ : i₀·η₀ − 1",
            Some(-1) => "rolling power from gear 2 to 1\n      T_1 : T_2 : T_H = 1 : −i₀/η₀ : i₀/η₀ − 1",
            Some(_) => "no rolling power\n      T_1 : T_2 : T_H = 1 : −i₀ : i₀ − 1",
            None => "each mesh passes on its efficiency",
        };
        lines.extend(format!("    {}: {eta}{ratio}", set.set).split('\n').map(str::to_owned));
        for member in &set.members {
            let (torque, speed) = (member.torque_of_input, member.relative_speed_of_input);
            let power = member.rolling_power_of_entering;
            let power = if speed == 0.0 {
                String::new()
            } else {
                format!(", P = T·({}) = {}", number(speed), number(power))
            };
            lines.push(format!("      {}: T = {}{power}", member.member, number(torque)));
        }
        let rolls = |mesh: &&MeshSteps| mesh.enters_of_entering > 0.0;
        for MeshSteps { from, to, efficiency, enters_of_entering, leaves_of_entering } in
            set.meshes.iter().filter(rolls)
        {
            lines.push(format!(
                "      mesh {from} to {to}: {}·{} = {}",
                number(*enters_of_entering),
                number(*efficiency),
                number(*leaves_of_entering)
            ));
        }
        lines.push(format!("      loss {}", number(set.loss_of_entering)));
    }
    let all: Vec<String> = losses.sets.iter().map(|set| number(set.loss_of_entering)).collect();
    lines.push("  Efficiency".to_owned());
    let sum = if all.len() > 1 { format!("({})", all.join(" + ")) } else { all.concat() };
    lines.push(format!("    η = 1 − {sum} = {}", number(losses.efficiency)));
    lines
}

/// The solved equations, for programs.
fn substitutions(gear: &Gear, steps: &Steps) -> Records {
    Table::new("substitutions", steps.substitutions.iter())
        .text("gear", "gear", |_| &gear.facts.gear)
        .text("unknown", "unknown", |one| &one.unknown)
        .text("set", "set", |one| &one.set)
        .text("symbol", "symbol", |one| &one.symbol)
        .words("terms", "terms", |one| speeds(&one.terms))
        .words("equals", "equals", |one| speeds(&one.equals))
        .records()
}

/// The torques of the members, for programs.
fn member_torques(gear: &Gear, steps: &Steps) -> Records {
    Table::new("torques", steps.torques.iter().flat_map(|torques| &torques.members))
        .text("gear", "gear", |_| &gear.facts.gear)
        .text("set", "set", |one| &one.set)
        .text("member", "member", |one| &one.member)
        .multiple("torque_of_input", "T", |one| one.torque_of_input)
        .records()
}
