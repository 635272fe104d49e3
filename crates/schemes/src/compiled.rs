//! A gear compiled once for many solutions: what does not change with tooth counts and losses.
//!
//! Nodes, active rows and the state are settled at the gearbox's own ratios; [`CompiledGear::solve`]
//! then takes other ratios and losses of the same rows, allocates nothing, and does about three
//! eliminations of the size of the gear.

use crate::kernel::{NO_GROUP, Problem};
use crate::state::{Verdict, classify};
use crate::topology::{Topology, fractions, numbers};
use crate::{Error, Gear, Gearbox, LinkId, Named};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::row::StationaryRatio;

/// How many rows a gear may have that are not idle copies of others.
pub const MAX_ROWS: usize = 12;
/// How many meshes may be shared by rows.
pub const MAX_SHARED: usize = 4;
/// The node of what is one piece with the housing.
pub(crate) const RESTING: usize = 15;

/// Which way power runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From input to output: a torque of 1 enters at the input, with speed 1.
    Drive,
    /// From output to input: a torque of `i` enters at the output, with speed `1/i`.
    Overrun,
}

/// Ratio and losses of one row, as arguments of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowValues {
    /// Stationary ratio `i₀`.
    pub ratio: StationaryRatio,
    /// `η₀`, or what the row does not share with others.
    pub efficiency: MeshEfficiency,
}

/// A gear ready to be solved for any ratios and losses of its rows.
///
/// ```
/// use epicyclic_gears::efficiency::MeshEfficiency;
/// use epicyclic_gears::row::RowParameter;
/// use epicyclic_schemes::{CompiledGear, Direction, Gearbox, RowValues, Solution, row::RowSpec};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("scheme I")
///     .links(["D", "B", "T1"])
///     .row(RowSpec::simple("1", ["D", "T1", "B"], 3.0))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("1", ["K1"])
///     .build()?;
/// let gear = CompiledGear::new(&gearbox, gearbox.gear("1")?)?;
/// let mut solution = Solution::default();
/// for k in [2.0, 2.94, 4.0] {
///     let row = RowValues { ratio: RowParameter::new(k)?.into(), efficiency: MeshEfficiency::new(0.97)? };
///     gear.solve(&[row], &[], Direction::Drive, &mut solution)?;
///     assert!((solution.ratio() - (1.0 + k)).abs() < 1e-12);
///     let closed = (1.0 + 0.97 * k) / (1.0 + k);
///     assert!((solution.loaded().unwrap().efficiency - closed).abs() < 1e-12);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct CompiledGear {
    pub(crate) count: usize,
    /// Active rows by their place in the gearbox.
    pub(crate) rows: [u8; MAX_ROWS],
    pub(crate) nodes: [[u8; 3]; MAX_ROWS],
    pub(crate) groups: [u8; MAX_ROWS],
    pub(crate) output: usize,
    pub(crate) row_count: usize,
    /// Node of each link; `None` where its speed does not follow from the input's.
    link_nodes: Vec<Option<u8>>,
}

/// Everything [`CompiledGear::solve`] finds, in fixed arrays to be used again.
///
/// Speeds are multiples of the input's. Torques are those for one unit of power that enters: see
/// [`Direction`]. Rows are the gear's active ones, [`CompiledGear::active_rows`].
#[derive(Debug, Clone)]
pub struct Solution {
    pub(crate) speeds: [f64; MAX_ROWS + 1],
    pub(crate) output_speed: f64,
    pub(crate) relative_speed: [f64; MAX_ROWS],
    pub(crate) ideal_sun: [f64; MAX_ROWS],
    pub(crate) ideal_signs: [i8; MAX_ROWS],
    pub(crate) signs: [i8; MAX_ROWS],
    pub(crate) shared_signs: [i8; MAX_SHARED],
    pub(crate) loaded: Option<Loaded>,
}

impl Default for Solution {
    fn default() -> Self {
        Self {
            speeds: [0.0; MAX_ROWS + 1],
            output_speed: 0.0,
            relative_speed: [0.0; MAX_ROWS],
            ideal_sun: [0.0; MAX_ROWS],
            ideal_signs: [0; MAX_ROWS],
            signs: [0; MAX_ROWS],
            shared_signs: [0; MAX_SHARED],
            loaded: None,
        }
    }
}

/// Torques with losses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loaded {
    /// Torque on the sun of each active row.
    pub sun: [f64; MAX_ROWS],
    /// `î₀ = i₀·η₀^w` of each active row: the ring has `−î₀` and the carrier `î₀ − 1` times the
    /// sun's torque.
    pub effective: [f64; MAX_ROWS],
    /// Torque at the terminal where power leaves.
    pub other: f64,
    /// Power that leaves over power that enters.
    ///
    /// At or below zero the gear locks itself: it moves only if power enters at both ends.
    pub efficiency: f64,
}

impl Solution {
    /// Ratio `i = ω_in/ω_out`.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        1.0 / self.output_speed
    }

    /// Speed relative to the carrier of each active row's sun, `ω_a − ω_H`.
    #[must_use]
    pub fn relative_speeds(&self) -> &[f64; MAX_ROWS] {
        &self.relative_speed
    }

    /// Torque on the sun of each active row without losses.
    #[must_use]
    pub fn ideal_sun_torques(&self) -> &[f64; MAX_ROWS] {
        &self.ideal_sun
    }

    /// Sense of the relative power of each active row: 1 from sun to ring, −1 from ring to sun, 0
    /// none.
    #[must_use]
    pub fn signs(&self) -> &[i8; MAX_ROWS] {
        &self.signs
    }

    /// Torques with losses; `None` where no torque moves the gear against them.
    #[must_use]
    pub fn loaded(&self) -> Option<&Loaded> {
        self.loaded.as_ref()
    }
}

impl CompiledGear {
    /// Compiles a gear that is driven, or whose torques are indeterminate only where nothing is lost.
    ///
    /// # Errors
    /// [`Error::NotDriven`] in any other state, [`Error::TooMany`] beyond [`MAX_ROWS`] rows or
    /// [`MAX_SHARED`] shared meshes.
    pub fn new(gearbox: &Gearbox, gear: &Gear) -> Result<Self, Error> {
        let topology = Topology::new(gearbox, gear);
        let verdict = verdict(gearbox, &topology);
        if !verdict.solvable {
            return Err(Error::NotDriven { state: verdict.state.to_string() });
        }
        Self::of(gearbox, &topology, &verdict)
    }

    pub(crate) fn of(gearbox: &Gearbox, topology: &Topology, verdict: &Verdict) -> Result<Self, Error> {
        let limit = |what, count, limit| {
            if count > limit { Err(Error::TooMany { what, count, limit }) } else { Ok(()) }
        };
        limit(Named::Row, verdict.rows.len(), MAX_ROWS)?;
        limit(Named::Row, gearbox.rows.len(), usize::from(NO_GROUP))?;
        limit(Named::SharedMesh, gearbox.shared.len(), MAX_SHARED)?;
        // Speeds that nothing gives are held: an idle part carries no torque, so holding it changes
        // nothing but the number of equations.
        let mut slot = vec![RESTING as u8; topology.count];
        let mut next = 1;
        for (node, slot) in slot.iter_mut().enumerate() {
            if Some(node) == topology.input {
                *slot = 0;
            } else if !verdict.chosen.contains(&node) {
                *slot = next;
                next += 1;
            }
        }
        let place = |node: Option<usize>| node.map_or(RESTING as u8, |node| slot[node]);
        let mut compiled = Self {
            count: verdict.rows.len(),
            rows: [0; MAX_ROWS],
            nodes: [[RESTING as u8; 3]; MAX_ROWS],
            groups: [NO_GROUP; MAX_ROWS],
            output: usize::from(place(topology.output)),
            row_count: gearbox.rows.len(),
            link_nodes: topology
                .node
                .iter()
                .map(|node| match node {
                    None => Some(RESTING as u8),
                    Some(node) => verdict.speeds[*node].map(|_| slot[*node]),
                })
                .collect(),
        };
        for (active, &row) in verdict.rows.iter().enumerate() {
            compiled.rows[active] = row as u8;
            compiled.nodes[active] = topology.rows[row].map(place);
            compiled.groups[active] = gearbox.shared_group(row).map_or(NO_GROUP, |group| group as u8);
        }
        Ok(compiled)
    }

    /// Places in [`Gearbox::rows`] of the rows that settle speeds and torques; the others are idle.
    #[must_use]
    pub fn active_rows(&self) -> &[u8] {
        &self.rows[..self.count]
    }

    /// Solves for these ratios and losses, one entry a row of the gearbox, and the efficiencies of
    /// the shared meshes.
    ///
    /// # Errors
    /// [`Error::RowCount`] unless there is one entry a row; [`Error::NotDriven`] where these ratios
    /// make the gear degenerate.
    pub fn solve(
        &self,
        rows: &[RowValues],
        shared: &[MeshEfficiency],
        direction: Direction,
        solution: &mut Solution,
    ) -> Result<(), Error> {
        if rows.len() != self.row_count {
            return Err(Error::RowCount { given: rows.len(), expected: self.row_count });
        }
        let mut shared_eta = [1.0; MAX_SHARED];
        for (eta, given) in shared_eta.iter_mut().zip(shared) {
            *eta = given.get();
        }
        let shared_eta = &shared_eta[..shared.len().min(MAX_SHARED)];
        let solved = self.solve_numbers(
            |r| rows[r].ratio.get(),
            |r| rows[r].efficiency.get(),
            shared_eta,
            direction,
            solution,
        );
        if solved {
            Ok(())
        } else {
            Err(Error::NotDriven {
                state: "these ratios leave its equations without a single solution".into(),
            })
        }
    }

    #[inline]
    pub(crate) fn solve_numbers(
        &self,
        i0: impl Fn(usize) -> f64,
        eta: impl Fn(usize) -> f64,
        shared: &[f64],
        direction: Direction,
        solution: &mut Solution,
    ) -> bool {
        macro_rules! sizes {
            ($($n:literal)*) => {
                match self.count {
                    $($n => self.problem::<$n>(i0, eta, shared, direction).solve(solution),)*
                    _ => false,
                }
            };
        }
        sizes!(0 1 2 3 4 5 6 7 8 9 10 11 12)
    }

    pub(crate) fn problem<'a, const N: usize>(
        &self,
        i0: impl Fn(usize) -> f64,
        eta: impl Fn(usize) -> f64,
        group_eta: &'a [f64],
        direction: Direction,
    ) -> Problem<'a, N> {
        let mut problem = Problem {
            nodes: [[0; 3]; N],
            i0: [0.0; N],
            eta: [0.0; N],
            group: [NO_GROUP; N],
            group_eta,
            output: self.output,
            direction,
        };
        for j in 0..N {
            let row = usize::from(self.rows[j]);
            problem.nodes[j] = self.nodes[j];
            problem.i0[j] = i0(row);
            problem.eta[j] = eta(row);
            problem.group[j] = self.groups[j];
        }
        if group_eta.is_empty() {
            problem.group = [NO_GROUP; N];
        }
        problem
    }

    /// Speed of a link in a solution, as a multiple of the input's; `None` where it does not follow.
    #[must_use]
    pub fn link_speed(&self, solution: &Solution, link: LinkId) -> Option<f64> {
        let node = usize::from(self.link_nodes.get(link.0).copied()??);
        Some(if node == RESTING { 0.0 } else { solution.speeds[node] })
    }

    /// Speeds of the members of an active row.
    pub(crate) fn member_speeds(&self, solution: &Solution, active: usize) -> [f64; 3] {
        self.nodes[active]
            .map(|node| if usize::from(node) == RESTING { 0.0 } else { solution.speeds[usize::from(node)] })
    }
}

/// State and relations of a gear: over fractions where all teeth are known and the numbers hold,
/// else over floats.
pub(crate) fn verdict(gearbox: &Gearbox, topology: &Topology) -> Verdict {
    fractions(gearbox)
        .and_then(|ratios| classify(gearbox, topology, &ratios))
        .or_else(|| classify(gearbox, topology, &numbers(gearbox)))
        .unwrap_or_else(|| unreachable!("elimination over floats has no overflow to report"))
}
