//! Compiled gear for many solutions: the parts that do not change with tooth counts and losses.
//!
//! Nodes, active equations and the state are settled at the gearbox's own ratios; [`CompiledGear::solve`]
//! then takes other ratios and losses of the same sets, allocates nothing, and does about three
//! eliminations of the size of the gear. Gears of more than twelve equations take the general way of
//! `network`.

use crate::elimination::Scalar;
use crate::error::SetValue;
use crate::kernel::{MOST_EQUATIONS, MOST_SEGMENTS, Problem, narrow};
use crate::network::Network;
use crate::solution::{Direction, RESTING, Run, Solution};
use crate::state::{Verdict, classify};
use crate::tolerance::PIVOT;
use crate::topology::{Topology, bounded, fractions, traced};
use crate::{Error, Gear, Gearbox, LinkId};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::BasicRatio;

/// Ratios and losses of a gearbox, as arguments of a solution; see [`Gearbox::values`].
#[derive(Debug, Clone, PartialEq)]
pub struct Values {
    /// Basic ratios, set by set: one of a set with two central gears, `m − 1` of one with `m`, each from its
    /// gear of reference to another.
    pub ratios: Vec<BasicRatio>,
    /// Efficiencies, set by set: that of the whole set where it has two central gears; of a compound set one
    /// for each segment of meshes that carry power in the same direction.
    pub efficiencies: Vec<MeshEfficiency>,
}

impl Gearbox {
    /// The ratios and losses that it was described with.
    #[must_use]
    pub fn values(&self) -> Values {
        let ratio = |one: &crate::gearbox::Equation| BasicRatio::new(one.ratio).ok();
        let eta = |one: &crate::gearbox::Segment| MeshEfficiency::new(one.efficiency).ok();
        Values {
            ratios: self.equations.iter().filter_map(ratio).collect(),
            efficiencies: self.segments.iter().filter_map(eta).collect(),
        }
    }
}

/// A gear ready to be solved for any ratios and losses of its sets.
///
/// ```
/// use epicyclic_gears::efficiency::MeshEfficiency;
/// use epicyclic_gears::simple_set::RingToSunRatio;
/// use epicyclic_train::{CompiledGear, Direction, Gearbox, Solution, Values, set::SetSpec};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("scheme I")
///     .links(["D", "B", "T1"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("1", ["K1"])
///     .build()?;
/// let gear = CompiledGear::new(&gearbox, gearbox.gear("1")?)?;
/// let mut solution = Solution::default();
/// for k in [2.0, 2.94, 4.0] {
///     let ratios = vec![RingToSunRatio::new(k)?.into()];
///     let values = Values { ratios, efficiencies: vec![MeshEfficiency::new(0.97)?] };
///     gear.solve(&values, Direction::Drive, &mut solution)?;
///     assert!((solution.ratio() - (1.0 + k)).abs() < 1e-12);
///     let closed = (1.0 + 0.97 * k) / (1.0 + k);
///     assert!((solution.efficiency().unwrap() - closed).abs() < 1e-12);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CompiledGear {
    /// Active equations by their place in the gearbox.
    pub(crate) equations: Vec<usize>,
    pub(crate) nodes: Vec<[u16; 3]>,
    /// Segments by their place in the gearbox, with the active equations behind each.
    pub(crate) segments: Vec<usize>,
    pub(crate) runs: Vec<Run>,
    /// Whether each equation has its own segment.
    is_plain: bool,
    pub(crate) output: u16,
    equation_count: usize,
    segment_count: usize,
    /// Node of each link; `None` where its speed does not follow from the input's.
    link_nodes: Vec<Option<u16>>,
}

impl CompiledGear {
    /// Compiles a gear that is driven, or whose torques are indeterminate only where nothing is lost.
    ///
    /// # Errors
    /// [`Error::NotDriven`] in any other state, [`Error::ForeignGear`] for a gear of another gearbox.
    pub fn new(gearbox: &Gearbox, gear: &Gear) -> Result<Self, Error> {
        gearbox.check_gear(gear)?;
        let topology = Topology::new(gearbox, gear);
        let verdict = verdict(gearbox, &topology);
        if !verdict.solvable {
            return Err(Error::NotDriven { state: verdict.state.to_string() });
        }
        Ok(Self::of(gearbox, &topology, &verdict))
    }

    pub(crate) fn of(gearbox: &Gearbox, topology: &Topology, verdict: &Verdict) -> Self {
        // Speeds that nothing gives are held: an idle part carries no torque, so holding it changes
        // nothing but the number of equations.
        let mut slot = vec![RESTING; topology.count];
        let mut next = 1;
        for (node, slot) in slot.iter_mut().enumerate() {
            if Some(node) == topology.input {
                *slot = 0;
            } else if !verdict.chosen.contains(&node) {
                *slot = next;
                next += 1;
            }
        }
        let place = |node: Option<usize>| node.map_or(RESTING, |node| slot[node]);
        let equations = verdict.equations.clone();
        let mut segments = Vec::with_capacity(gearbox.segments.len());
        let mut runs = Vec::with_capacity(gearbox.segments.len());
        for (place, segment) in gearbox.segments.iter().enumerate() {
            let from = equations.partition_point(|&one| one < segment.behind.start);
            let to = equations.partition_point(|&one| one < segment.behind.end);
            if from < to {
                segments.push(place);
                runs.push(Run { from, to });
            }
        }
        let is_plain = runs.len() == equations.len()
            && runs.iter().enumerate().all(|(place, run)| *run == Run { from: place, to: place + 1 });
        Self {
            nodes: equations.iter().map(|&one| topology.equations[one].map(place)).collect(),
            equations,
            segments,
            runs,
            is_plain,
            output: place(topology.output),
            equation_count: gearbox.equations.len(),
            segment_count: gearbox.segments.len(),
            link_nodes: topology
                .node
                .iter()
                .map(|node| match node {
                    None => Some(RESTING),
                    Some(node) => verdict.speeds[*node].map(|_| slot[*node]),
                })
                .collect(),
        }
    }

    /// Places of the active equations, one a set with two central gears: those that settle speeds and
    /// torques.
    #[must_use]
    pub fn active(&self) -> &[usize] {
        &self.equations
    }

    /// Solves for these ratios and losses.
    ///
    /// # Errors
    /// [`Error::ValueCount`] unless there are as many as the gearbox has; [`Error::NotDriven`] where these
    /// ratios make the gear degenerate.
    pub fn solve(&self, values: &Values, direction: Direction, solution: &mut Solution) -> Result<(), Error> {
        let Values { ratios, efficiencies } = values;
        for (what, given, expected) in [
            (SetValue::BasicRatio, ratios.len(), self.equation_count),
            (SetValue::Efficiency, efficiencies.len(), self.segment_count),
        ] {
            if given != expected {
                return Err(Error::ValueCount { what, given, expected });
            }
        }
        if self.solve_numbers(|e| ratios[e].get(), |s| efficiencies[s].get(), direction, PIVOT, solution) {
            Ok(())
        } else {
            Err(Error::NotDriven {
                state: "these ratios leave its equations without a single solution".into(),
            })
        }
    }

    /// Pivots up to `least_pivot` have vanished; 0 for the ratios whose rank is proved.
    #[inline]
    pub(crate) fn solve_numbers(
        &self,
        i0: impl Fn(usize) -> f64,
        eta: impl Fn(usize) -> f64,
        direction: Direction,
        least_pivot: f64,
        solution: &mut Solution,
    ) -> bool {
        macro_rules! sizes {
            ($($n:literal)*) => {
                match (self.equations.len(), self.is_plain) {
                    $(
                        ($n, true) => self.problem::<$n, $n, true>(i0, eta, direction, least_pivot).solve(solution),
                        ($n, false) => {
                            self.problem::<$n, MOST_SEGMENTS, false>(i0, eta, direction, least_pivot).solve(solution)
                        }
                    )*
                    _ => self.network(i0, eta, least_pivot).solve_gear(usize::from(self.output), direction, solution),
                }
            };
        }
        sizes!(0 1 2 3 4 5 6 7 8 9 10 11 12)
    }

    /// The gear as the general solver takes it.
    pub(crate) fn network(
        &self,
        i0: impl Fn(usize) -> f64,
        eta: impl Fn(usize) -> f64,
        least_pivot: f64,
    ) -> Network {
        let node = |node: u16| (node != RESTING).then_some(usize::from(node));
        Network {
            nodes: self.nodes.iter().map(|nodes| nodes.map(node)).collect(),
            ratios: self.equations.iter().map(|&equation| i0(equation)).collect(),
            runs: self.runs.clone(),
            etas: self.segments.iter().map(|&segment| eta(segment)).collect(),
            count: self.equations.len() + 1,
            least_pivot,
        }
    }

    pub(crate) fn problem<const N: usize, const M: usize, const PLAIN: bool>(
        &self,
        i0: impl Fn(usize) -> f64,
        eta: impl Fn(usize) -> f64,
        direction: Direction,
        least_pivot: f64,
    ) -> Problem<'_, N, M, PLAIN> {
        const { assert!(N <= MOST_EQUATIONS) };
        let mut problem = Problem {
            nodes: [[0; 3]; N],
            i0: [0.0; N],
            eta: [1.0; M],
            runs: &self.runs,
            output: usize::from(narrow(self.output)),
            direction,
            least_pivot,
        };
        for ((j, &equation), nodes) in self.equations.iter().enumerate().zip(&self.nodes) {
            problem.nodes[j] = nodes.map(narrow);
            problem.i0[j] = i0(equation);
        }
        for (place, &segment) in self.segments.iter().enumerate() {
            problem.eta[place] = eta(segment);
        }
        problem
    }

    /// Speed of a link in a solution, as a multiple of the input's; `None` where it does not follow.
    #[must_use]
    pub fn link_speed(&self, solution: &Solution, link: LinkId) -> Option<f64> {
        let node = self.link_nodes.get(link.0).copied()??;
        Some(if node == RESTING { 0.0 } else { solution.speeds()[usize::from(node)] })
    }
}

/// State and relations of a gear, by the quickest way that proves them.
pub(crate) fn verdict(gearbox: &Gearbox, topology: &Topology) -> Verdict {
    fn of<S: Scalar>(gearbox: &Gearbox, topology: &Topology, ratios: Option<Vec<S>>) -> Option<Verdict> {
        classify(gearbox, topology, &ratios?)
    }
    of(gearbox, topology, Some(bounded(gearbox)))
        .or_else(|| of(gearbox, topology, fractions(gearbox)))
        .or_else(|| of(gearbox, topology, traced(gearbox)))
        .unwrap_or_else(|| unreachable!("a number is a rational, and rationals of any size do not overflow"))
}
