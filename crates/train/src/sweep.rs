//! States, ratios and efficiencies of the gears of a gearbox for many basic ratios of its sets.
//!
//! # Method
//! Where a gear has as many equations as speeds to settle, and no loop of connections, it is driven where
//! these equations are independent and the output turns. `proof` eliminates with a bound on the error of
//! every number: where each pivot is certainly not 0 and the output's speed has certain digits, nothing else
//! is needed for state and ratio, and the compiled gear gives the efficiency. Everything else, gears of
//! another form too, takes the way of [`Gearbox::analyze`] at these basic ratios. So a state is proved here
//! as it is there.
//!
//! # What is left out
//! The losses are those that the gearbox was described with: they do not change with `k`. Sets described gear
//! by gear keep their basic ratios.

mod proof;

use crate::compiled::CompiledGear;
use crate::elimination::decimal;
use crate::error::SetValue;
use crate::planet_set::Description;
use crate::set_kind::SetKind;
use crate::solution::{Direction, Solution};
use crate::state::{Known, Verdict};
use crate::tolerance::{BASIC_RATIO, SPREAD};
use crate::topology::Topology;
use crate::{Error, Gear, Gearbox, PlanetSet, State};
use proof::Proof;

/// The name of a [`State`], without the links that it concerns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum StateName {
    /// [`State::Driven`].
    Driven = 0,
    /// [`State::TorquesIndeterminate`].
    TorquesIndeterminate = 1,
    /// [`State::SelfLocking`].
    SelfLocking = 2,
    /// [`State::InputBlocked`].
    InputBlocked = 3,
    /// [`State::OutputAtRest`].
    OutputAtRest = 4,
    /// [`State::OutputFree`].
    OutputFree = 5,
    /// [`State::Underdetermined`].
    Underdetermined = 6,
}

impl From<&State> for StateName {
    fn from(state: &State) -> Self {
        match state {
            State::Driven => Self::Driven,
            State::TorquesIndeterminate { .. } => Self::TorquesIndeterminate,
            State::SelfLocking { .. } => Self::SelfLocking,
            State::InputBlocked { .. } => Self::InputBlocked,
            State::OutputAtRest { .. } => Self::OutputAtRest,
            State::OutputFree { .. } => Self::OutputFree,
            State::Underdetermined { .. } => Self::Underdetermined,
        }
    }
}

/// State, ratio and efficiency of one gear at some basic ratios.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swept {
    /// State of the gear.
    pub state: StateName,
    /// Ratio `i = ω_in/ω_out`; `None` where the output's speed does not follow from the input's.
    pub ratio: Option<f64>,
    /// Efficiency driven from the input; `None` where none follows, or where no torque moves the gear.
    pub efficiency: Option<f64>,
}

/// A set whose `k = |i₀|` varies.
#[derive(Debug, Clone)]
struct Varied {
    id: String,
    kind: SetKind,
    equation: usize,
}

/// A gear, compiled where its form allows it.
#[derive(Debug, Clone)]
struct Plan {
    gear: Gear,
    quick: Option<(Proof, CompiledGear)>,
}

/// Gears of a gearbox, ready to be solved for many basic ratios.
///
/// ```
/// use epicyclic_train::{Gearbox, set::SetSpec, sweep::{StateName, Sweep}};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("scheme I")
///     .links(["D", "B", "T1"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("1", ["K1"])
///     .build()?;
/// let mut sweep = Sweep::new(&gearbox, gearbox.gears(), &["1"])?;
/// let mut found = vec![];
/// for k in [2.0, 2.94, 4.0] {
///     sweep.solve(&[k], &mut found)?;
///     assert_eq!(found[0].state, StateName::Driven);
///     assert!((found[0].ratio.unwrap() - (1.0 + k)).abs() < 1e-12);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct Sweep {
    /// Gearbox of the sweep; its basic ratios are those of the last variant.
    gearbox: Gearbox,
    varied: Vec<Varied>,
    plans: Vec<Plan>,
    /// Basic ratios of the equations.
    ratios: Vec<f64>,
    has_losses: bool,
    solution: Solution,
}

impl Sweep {
    /// Prepares a sweep of these gears over `k` of the sets of these names.
    ///
    /// # Errors
    /// - [`Error::Unknown`] for a name that no set has;
    /// - [`Error::NotVaried`] for a set described gear by gear;
    /// - [`Error::VariedTwice`] for a set named twice;
    /// - [`Error::ForeignGear`] for a gear of another gearbox.
    pub fn new(gearbox: &Gearbox, gears: &[Gear], sets: &[&str]) -> Result<Self, Error> {
        let mut varied: Vec<Varied> = vec![];
        for &id in sets {
            let one = gearbox.varied(id)?;
            if varied.iter().any(|other| other.equation == one.equation) {
                return Err(Error::VariedTwice { set: id.to_owned() });
            }
            varied.push(one);
        }
        let plan = |gear: &Gear| {
            gearbox.check_gear(gear)?;
            Ok(Plan { gear: gear.clone(), quick: quick(gearbox, gear) })
        };
        Ok(Self {
            gearbox: gearbox.clone(),
            varied,
            plans: gears.iter().map(plan).collect::<Result<_, Error>>()?,
            ratios: gearbox.equations.iter().map(|one| one.ratio).collect(),
            has_losses: gearbox.sets.iter().any(PlanetSet::has_losses),
            solution: Solution::default(),
        })
    }

    /// Number of gears.
    #[must_use]
    pub fn gears(&self) -> usize {
        self.plans.len()
    }

    /// Solves the gears for these `k` of the varied sets; gears and `k` are in the order in which both were
    /// given.
    ///
    /// # Errors
    /// - [`Error::ValueCount`] unless there is one `k` per set;
    /// - [`Error::RingToSunRatio`] for a `k` that the kind of its set cannot have;
    /// - [`Error::Spread`] for basic ratios whose product is above the largest allowed.
    pub fn solve(&mut self, k: &[f64], found: &mut Vec<Swept>) -> Result<(), Error> {
        if k.len() != self.varied.len() {
            let (given, expected) = (k.len(), self.varied.len());
            return Err(Error::ValueCount { what: SetValue::BasicRatio, given, expected });
        }
        for (one, &k) in self.varied.iter().zip(k) {
            let least = if one.kind == SetKind::Simple { 1.0 } else { 0.0 };
            if !((1.0 / BASIC_RATIO..=BASIC_RATIO).contains(&k) && k > least) {
                return Err(Error::RingToSunRatio { set: one.id.clone(), kind: one.kind, k });
            }
            self.ratios[one.equation] = one.kind.sign() * k;
        }
        let spread = self.ratios.iter().map(|i| 1.0 + i.abs().max(1.0 / i.abs())).product::<f64>();
        if spread > SPREAD {
            let of = |i: &f64| libm::log10(1.0 + i.abs().max(1.0 / i.abs()));
            return Err(Error::Spread { exponent: self.ratios.iter().map(of).sum() });
        }
        found.clear();
        for plan in &self.plans {
            let quick = plan.quick.as_ref().and_then(|quick| {
                swept(quick, &self.gearbox, &self.ratios, self.has_losses, &mut self.solution)
            });
            let one = match quick {
                Some(one) => one,
                None => full(&mut self.gearbox, &plan.gear, &self.ratios)?,
            };
            found.push(one);
        }
        Ok(())
    }
}

impl Gearbox {
    fn varied(&self, id: &str) -> Result<Varied, Error> {
        let place = self.sets.iter().position(|set| set.id() == id).ok_or_else(|| Error::Unknown {
            what: crate::Named::Set,
            name: id.to_owned(),
            place: crate::Place::Gearbox(self.name.clone()),
            suggestion: crate::names::nearest(id, self.sets.iter().map(PlanetSet::id)),
        })?;
        match self.sets[place].description() {
            Description::Short(spec) => {
                Ok(Varied { id: id.to_owned(), kind: spec.kind, equation: self.equations_of(place).start })
            }
            Description::Compound(_) => Err(Error::NotVaried { set: id.to_owned() }),
        }
    }
}

/// The quick way, where the gear's form allows it whatever the ratios are.
fn quick(gearbox: &Gearbox, gear: &Gear) -> Option<(Proof, CompiledGear)> {
    let topology = Topology::new(gearbox, gear);
    let count = gearbox.equations.len();
    let input = topology.input?;
    topology.output?;
    if topology.count != count + 1 || !topology.is_forest {
        return None;
    }
    let proof = Proof::new(&topology, input)?;
    // Verdict of the elimination if the equations are independent; otherwise it is not used.
    let verdict = Verdict {
        state: State::Driven,
        speeds: vec![Some(0.0); topology.count],
        equations: (0..count).collect(),
        chosen: vec![],
        known: Known::All,
        solvable: true,
    };
    Some((proof, CompiledGear::of(gearbox, &topology, &verdict)))
}

fn swept(
    (proof, compiled): &(Proof, CompiledGear),
    gearbox: &Gearbox,
    ratios: &[f64],
    has_losses: bool,
    solution: &mut Solution,
) -> Option<Swept> {
    let ratio = Some(proof.output_speed(ratios)?.recip());
    if !has_losses {
        return Some(Swept { state: StateName::Driven, ratio, efficiency: Some(1.0) });
    }
    let eta = |segment: usize| gearbox.segments[segment].efficiency;
    if !compiled.solve_numbers(|equation| ratios[equation], eta, Direction::Drive, 0.0, solution) {
        return None;
    }
    let efficiency = solution.efficiency();
    let moves = efficiency.is_some_and(|efficiency| efficiency > 0.0);
    let state = if moves { StateName::Driven } else { StateName::SelfLocking };
    Some(Swept { state, ratio, efficiency })
}

/// The way of every analysis.
#[cold]
fn full(gearbox: &mut Gearbox, gear: &Gear, ratios: &[f64]) -> Result<Swept, Error> {
    for (one, &ratio) in gearbox.equations.iter_mut().zip(ratios) {
        if one.ratio != ratio {
            (one.ratio, one.rational, one.exact) = (ratio, decimal(ratio), None);
        }
    }
    let analysis = gearbox.analyze_gear(gear)?;
    Ok(Swept {
        state: StateName::from(analysis.state()),
        ratio: analysis.ratio(),
        efficiency: analysis.efficiency(),
    })
}
