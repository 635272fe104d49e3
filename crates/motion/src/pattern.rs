//! Pattern of elements that hold or slip and of directions of power, and the equations of motion under it.
//!
//! ```text
//! J·B·q̈ − C(e)·t − Dᵀ·λ = T      one row a body: nodes and planets
//! D_stuck·q̈ = 0                  one row a stuck element or set
//! ```
//!
//! `t` are the torques of the meshes on their first gears, `C(e)` spreads them over gears and carrier, `λ`
//! are the torques of stuck elements and sets. The system is square, and its determinant is that of the
//! loaded mass matrix times one that the signs of `e` do not touch. It has the same sign for all patterns of
//! power directions exactly if the motion is unique for every torque. This is the column W-property: R.
//! Sznajder and M. S. Gowda, Linear Algebra Appl. 223/224 (1995) 695–715, theorem 2.

use crate::converter::Drive;
use crate::mechanism::Mechanism;
use crate::model::{Element, Model};
use crate::shaft::Flank;
use crate::tolerance::{PIVOT, RANK};
use epicyclic_numerics::linear::{Independent, Matrix, Triangles, independent};

/// Way of an element, or of the rolling of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Way {
    /// No friction: a capacity of 0, a set without losses, or one that other elements hold as a block. A
    /// one-way clutch that overruns is `Forward`.
    Open,
    /// Slip above 0, or about to be.
    Forward,
    /// Slip below 0, or about to be.
    Backward,
    /// No slip.
    Stuck,
}

impl Way {
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Open | Self::Stuck => 0.0,
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }

    /// The way of a slip that is not 0.
    pub(crate) fn of(slip: f64) -> Self {
        if slip > 0.0 { Self::Forward } else { Self::Backward }
    }
}

/// An assumption about everything that has several ways.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Pattern {
    pub(crate) elements: Vec<Way>,
    pub(crate) sets: Vec<Way>,
    /// `w` of each mesh: 1 where power flows from its first gear to its second.
    pub(crate) meshes: Vec<i8>,
    /// Segments of torques over speed, and of friction over slip speed.
    pub(crate) segments: Vec<usize>,
    pub(crate) curves: Vec<usize>,
    /// Segments of the curves of drags.
    pub(crate) drags: Vec<usize>,
    pub(crate) flanks: Vec<Flank>,
    pub(crate) drives: Vec<Drive>,
}

impl Pattern {
    /// `e` of a mesh.
    pub(crate) fn part(&self, mechanism: &Mechanism, mesh: usize) -> f64 {
        let one = &mechanism.meshes[mesh];
        match self.sets[one.set] {
            Way::Open | Way::Stuck => 1.0,
            Way::Forward | Way::Backward if self.meshes[mesh] >= 0 => one.efficiency,
            Way::Forward | Way::Backward => 1.0 / one.efficiency,
        }
    }

    /// Places of the stuck elements.
    pub(crate) fn stuck(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.elements.len()).filter(|&place| self.elements[place] == Way::Stuck)
    }
}

/// The equations of motion under a pattern, solved for torques on the nodes.
#[derive(Debug, Clone)]
pub(crate) struct System {
    /// `q̈` over torques on the nodes.
    pub(crate) accelerations: Matrix,
    /// `t` of the meshes.
    pub(crate) meshes: Matrix,
    /// `λ` of the independent stuck elements, then of the stuck sets.
    pub(crate) reactions: Matrix,
    /// Stuck elements.
    pub(crate) stuck: Vec<usize>,
    /// Stuck elements that are independent.
    pub(crate) independent: Independent,
    /// Stuck sets.
    pub(crate) stuck_sets: Vec<usize>,
}

/// Adds `factor` at a place that is not the housing.
fn add(matrix: &mut Matrix, place: Option<usize>, column: usize, factor: f64) {
    if let Some(row) = place {
        matrix.row_mut(row)[column] += factor;
    }
}

/// The left side, with parts `e` of the meshes, these elements and these sets stuck.
fn left(mechanism: &Mechanism, part: impl Fn(usize) -> f64, elements: &[&Element], sets: &[usize]) -> Matrix {
    let (n, bodies, meshes) = (mechanism.freedoms(), mechanism.inertias.len(), mechanism.meshes.len());
    let size = bodies + elements.len() + sets.len();
    let mut matrix = Matrix::zeros(size, n + meshes + elements.len() + sets.len());
    for (body, inertia) in mechanism.inertias.iter().enumerate() {
        let speeds = mechanism.speeds.row(body);
        matrix.row_mut(body)[..n].iter_mut().zip(speeds).for_each(|(entry, speed)| *entry = inertia * speed);
    }
    for (place, mesh) in mechanism.meshes.iter().enumerate() {
        let loaded = mesh.ratio * part(place);
        add(&mut matrix, mesh.ends[0], n + place, -1.0);
        add(&mut matrix, mesh.ends[1], n + place, loaded);
        add(&mut matrix, mesh.carrier, n + place, 1.0 - loaded);
    }
    let held = elements.iter().map(|one| (one.places, &one.slip));
    let sets = sets.iter().map(|&set| &mechanism.sets[set]);
    let rolling = sets.map(|set| ([set.root, set.carrier], &set.rolling));
    for (place, (ends, slip)) in held.chain(rolling).enumerate() {
        add(&mut matrix, ends[0], n + meshes + place, -1.0);
        add(&mut matrix, ends[1], n + meshes + place, 1.0);
        matrix.row_mut(bodies + place)[..n].copy_from_slice(slip);
    }
    matrix
}

impl System {
    /// `None` where the equations have no unique solution.
    pub(crate) fn new(model: &Model, pattern: &Pattern) -> Option<Self> {
        let mechanism = &model.mechanism;
        let stuck: Vec<usize> = pattern.stuck().collect();
        let rows: Vec<&[f64]> = stuck.iter().map(|&place| model.elements[place].slip.as_slice()).collect();
        let independent = independent(&rows, RANK);
        let kept: Vec<&Element> =
            independent.kept.iter().map(|&place| &model.elements[stuck[place]]).collect();
        let stuck_sets: Vec<usize> =
            (0..pattern.sets.len()).filter(|&set| pattern.sets[set] == Way::Stuck).collect();
        let matrix = left(mechanism, |mesh| pattern.part(mechanism, mesh), &kept, &stuck_sets);
        let triangles = Triangles::new(matrix, PIVOT)?;
        let (n, nodes, meshes) = (mechanism.freedoms(), mechanism.nodes, mechanism.meshes.len());
        let size = mechanism.inertias.len() + kept.len() + stuck_sets.len();
        let mut made = Self {
            accelerations: Matrix::zeros(n, nodes),
            meshes: Matrix::zeros(meshes, nodes),
            reactions: Matrix::zeros(kept.len() + stuck_sets.len(), nodes),
            stuck,
            independent,
            stuck_sets,
        };
        let mut unit = vec![0.0; size];
        for node in 0..nodes {
            unit[node] = 1.0;
            let found = triangles.solution(&unit);
            unit[node] = 0.0;
            let (accelerations, rest) = found.split_at(n);
            let (of_meshes, reactions) = rest.split_at(meshes);
            for (matrix, values) in [
                (&mut made.accelerations, accelerations),
                (&mut made.meshes, of_meshes),
                (&mut made.reactions, reactions),
            ] {
                values.iter().enumerate().for_each(|(row, value)| matrix.row_mut(row)[node] = *value);
            }
        }
        Some(made)
    }

    /// Determinant under these stuck elements and sets, and parts of the meshes; 0 where it vanishes.
    pub(crate) fn determinant_with(
        model: &Model,
        stuck: &[usize],
        independent: &Independent,
        stuck_sets: &[usize],
        part: impl Fn(usize) -> f64,
    ) -> f64 {
        let kept: Vec<&Element> =
            independent.kept.iter().map(|&place| &model.elements[stuck[place]]).collect();
        Triangles::new(left(&model.mechanism, part, &kept, stuck_sets), PIVOT)
            .map_or(0.0, |triangles| triangles.determinant())
    }
}
