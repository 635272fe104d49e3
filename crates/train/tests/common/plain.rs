//! The plain general way: every link a speed, every set and connection an equation, nalgebra.

#![allow(dead_code, reason = "each test binary uses its own part")]
#![allow(clippy::unwrap_used, reason = "fixtures of tests")]

use epicyclic_train::{Gear, Gearbox, LinkId, PlanetSet};
use nalgebra::{DMatrix, DVector};

/// Equations of sets with these ratios of their first central gear to each other, of permanent connections
/// and engaged shift elements.
pub(crate) fn equations(gearbox: &Gearbox, gear: &Gear, ratios: &[f64]) -> DMatrix<f64> {
    let links = gearbox.links().len();
    let engaged = gear.engaged().iter().map(|&c| gearbox.shift_elements()[c].links());
    let joined: Vec<[LinkId; 2]> = gearbox.permanent().iter().copied().chain(engaged).collect();
    let mut matrix = DMatrix::zeros(ratios.len() + joined.len(), links);
    let pairs =
        gearbox.sets().iter().flat_map(|set| (1..set.centrals().len()).map(move |other| (set, other)));
    for (r, ((set, other), &i)) in pairs.zip(ratios).enumerate() {
        let links = [set.members()[0], set.members()[other], set.carrier()];
        for (link, factor) in links.iter().zip([1.0, -i, i - 1.0]) {
            matrix[(r, link.index())] += factor;
        }
    }
    for (e, [first, second]) in joined.iter().enumerate() {
        matrix[(ratios.len() + e, first.index())] += 1.0;
        matrix[(ratios.len() + e, second.index())] -= 1.0;
    }
    matrix.remove_column(0)
}

pub(crate) fn ratios(gearbox: &Gearbox) -> Vec<f64> {
    let of_set = |set: &PlanetSet| {
        (1..set.centrals().len()).map(|other| set.ratio_between(0, other)).collect::<Vec<_>>()
    };
    gearbox.sets().iter().flat_map(of_set).collect()
}

fn unit(links: usize, link: LinkId) -> DMatrix<f64> {
    let mut row = DMatrix::zeros(1, links);
    row[(0, link.index() - 1)] = 1.0;
    row
}

fn stacked(matrix: &DMatrix<f64>, more: &[&DMatrix<f64>]) -> DMatrix<f64> {
    let rows = matrix.nrows() + more.len();
    let mut all = DMatrix::zeros(rows, matrix.ncols());
    all.rows_mut(0, matrix.nrows()).copy_from(matrix);
    for (place, row) in more.iter().enumerate() {
        all.rows_mut(matrix.nrows() + place, 1).copy_from(*row);
    }
    all
}

pub(crate) fn rank(matrix: &DMatrix<f64>) -> usize {
    if matrix.nrows() == 0 { 0 } else { matrix.clone().svd(false, false).rank(1e-9) }
}

/// Motion of a gear, from the ranks of the speeds alone.
#[derive(Debug, PartialEq)]
pub(crate) enum Motion {
    InputBlocked,
    OutputAtRest,
    Open,
    Follows,
}

pub(crate) fn motion(gearbox: &Gearbox, gear: &Gear) -> Motion {
    let matrix = equations(gearbox, gear, &ratios(gearbox));
    let links = matrix.ncols();
    let (input, output) = (unit(links, gear.input()), unit(links, gear.output()));
    let base = rank(&matrix);
    if rank(&stacked(&matrix, &[&input])) == base {
        Motion::InputBlocked
    } else if rank(&stacked(&matrix, &[&output])) == base {
        Motion::OutputAtRest
    } else if rank(&stacked(&matrix, &[&input, &output])) == base + 2 {
        Motion::Open
    } else {
        Motion::Follows
    }
}

/// Speeds, ideal torques, signs, torques with losses.
pub(crate) struct Plain {
    pub(crate) speeds: DVector<f64>,
    pub(crate) suns: DVector<f64>,
    pub(crate) output_torque: f64,
    pub(crate) efficiency: f64,
    pub(crate) signs: Vec<i8>,
}

/// Solves a gear with as many equations as links; `None` where that is not so.
///
/// The torques obey the transposed system: `Cᵀ·t = T_in·e_in + T_out·e_out`, so with the equation of
/// the input appended as a last row, `[C; e_in]ᵀ·(t; −T_in) = T_out·e_out`.
pub(crate) fn solve(gearbox: &Gearbox, gear: &Gear, ratios: &[f64], etas: &[f64]) -> Option<Plain> {
    let sets = gearbox.sets().len();
    let system = |ratios: &[f64]| {
        let matrix = equations(gearbox, gear, ratios);
        let input = unit(matrix.ncols(), gear.input());
        stacked(&matrix, &[&input])
    };
    let matrix = system(ratios);
    if matrix.nrows() != matrix.ncols() {
        return None;
    }
    let last = matrix.nrows() - 1;
    let mut one = DVector::zeros(matrix.nrows());
    one[last] = 1.0;
    let speeds = matrix.clone().lu().solve(&one)?;
    let speed = |link: LinkId| if link.index() == 0 { 0.0 } else { speeds[link.index() - 1] };
    let output_speed = speed(gear.output());
    if output_speed == 0.0 {
        return None;
    }
    let torques = |matrix: DMatrix<f64>| {
        let mut out = DVector::zeros(matrix.nrows());
        out[gear.output().index() - 1] = 1.0;
        let per_output = matrix.transpose().lu().solve(&out)?;
        let output_torque = -1.0 / per_output[last];
        Some((per_output * output_torque, output_torque))
    };
    let (ideal, _) = torques(matrix)?;
    let relative: Vec<f64> = gearbox
        .sets()
        .iter()
        .enumerate()
        .map(|(r, set)| ideal[r] * (speed(set.members()[0]) - speed(set.carrier())))
        .collect();
    let largest = relative.iter().fold(1.0_f64, |m, p| m.max(p.abs()));
    let sign = |p: &f64| if p.abs() <= 1e-11 * largest { 0 } else { p.signum() as i8 };
    let signs: Vec<i8> = relative.iter().map(sign).collect();
    let effective: Vec<f64> = (0..sets).map(|r| ratios[r] * etas[r].powi(i32::from(signs[r]))).collect();
    let (loaded, output_torque) = torques(system(&effective))?;
    let efficiency = -output_torque * output_speed;
    Some(Plain { speeds, suns: loaded.rows(0, sets).into(), output_torque, efficiency, signs })
}
