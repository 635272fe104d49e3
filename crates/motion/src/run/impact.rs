//! Jumps of the speeds: impacts of dog clutches, and slips that vanish set to 0.
//!
//! ```text
//! Δq̇ = M⁻¹·Dᵀ·Λ      D·(q̇ + Δq̇) = 0
//! ```
//!
//! This is the plastic impact: of all that end these slips by impulses `Λ` of what joins them, it takes the
//! least kinetic energy, and every momentum that these impulses leave alone is kept. One-way clutches take
//! part where they would slip backwards otherwise, with `Λ ≥ 0`; since `M` is positive definite exactly one
//! set of them does (least squares under linear inequalities).

use super::Runner;
use crate::Error;
use crate::field::Trigger;
use crate::model::Kind;
use crate::pattern::Way;
use crate::record::Change;
use crate::tolerance::{ACCELERATION, PIVOT, RANK, SLIP};
use epicyclic_numerics::linear::{Matrix, Triangles, independent};
use epicyclic_numerics::values::{dot, largest_absolute};

/// A change of speeds, with the impulses of the rows that were kept.
struct Jump {
    speeds: Vec<f64>,
    /// Rows with their impulses.
    impulses: Vec<(usize, f64)>,
}

impl Runner<'_> {
    /// Sets slips that vanish to 0.
    pub(super) fn project(&mut self, fired: &[Trigger]) {
        let (mut elements, mut sets) = self.field.at_rest(&self.stepper.y, self.speed_scale);
        for trigger in fired {
            match *trigger {
                Trigger::SlipEnds(place) if !elements.contains(&place) => elements.push(place),
                Trigger::RollingEnds(set) if !sets.contains(&set) => sets.push(set),
                _ => {}
            }
        }
        let model = self.model;
        let rows = elements.iter().map(|&place| model.elements[place].slip.as_slice());
        let sets = sets.iter().map(|&set| model.mechanism.sets[set].rolling.as_slice());
        let rows: Vec<&[f64]> = rows.chain(sets).collect();
        if let Some(jump) = self.jump(&rows) {
            self.take_jump(&jump);
        }
    }

    /// Engages and opens dog clutches as their programs and slips say; whether there was an impact.
    pub(super) fn engage(&mut self, fired: &[Trigger]) -> bool {
        let t = self.stepper.t;
        let mut any = false;
        for place in 0..self.model.elements.len() {
            let Kind::Dog { limit, .. } = self.model.elements[place].kind else { continue };
            let is_wanted = self.model.elements[place].kind.is_wanted(t);
            let slip = self.field.slip(place, &self.stepper.y);
            let way = &mut self.field.pattern.elements[place];
            self.field.waits[place] = 0.0;
            if !is_wanted {
                *way = Way::Open;
            } else if *way != Way::Stuck {
                if slip.abs() <= limit || fired.contains(&Trigger::Meshes(place)) {
                    *way = Way::Stuck;
                    any = true;
                } else {
                    self.field.waits[place] = slip.signum();
                }
            }
        }
        if any {
            self.collide();
        }
        any
    }

    /// The impact of all engaged dog clutches and of the one-way clutches that take part.
    fn collide(&mut self) {
        let model = self.model;
        let n = model.elements.len();
        let dogs: Vec<usize> = (0..n)
            .filter(|&place| self.field.is_dog(place) && self.field.pattern.elements[place] == Way::Stuck)
            .collect();
        let one_ways: Vec<usize> =
            (0..n).filter(|&place| matches!(model.elements[place].kind, Kind::OneWay)).collect();
        let zero = SLIP * self.speed_scale;
        let mut best: Option<(f64, Jump)> = None;
        let subsets = 1_u64 << one_ways.len().min(20);
        let mut order: Vec<u64> = (0..subsets).collect();
        order.sort_by_key(|subset| subset.count_ones());
        for subset in order {
            let taken = (0..one_ways.len()).filter(|bit| subset >> bit & 1 == 1).map(|bit| one_ways[bit]);
            let all: Vec<usize> = dogs.iter().copied().chain(taken).collect();
            let rows: Vec<&[f64]> = all.iter().map(|&place| model.elements[place].slip.as_slice()).collect();
            let Some(jump) = self.jump(&rows) else { continue };
            // Impulses that pull, and one-way clutches that slip backwards, are against it.
            let mut worst = 0.0_f64;
            for &(row, impulse) in jump.impulses.iter().filter(|(row, _)| *row >= dogs.len()) {
                worst = worst.max(-impulse * self.mobility(&model.elements[all[row]].slip));
            }
            for &place in &one_ways {
                let after: Vec<f64> =
                    self.stepper.y.iter().zip(&jump.speeds).map(|(speed, change)| speed + change).collect();
                worst = worst.max(-dot(&model.elements[place].slip, &after));
            }
            if best.as_ref().is_none_or(|(least, _)| worst < *least) {
                best = Some((worst, jump));
            }
            if worst <= zero {
                break;
            }
        }
        if let Some((_, jump)) = best {
            self.take_jump(&jump);
        }
    }

    /// The jump that ends these slips; none where they are 0 already.
    fn jump(&self, rows: &[&[f64]]) -> Option<Jump> {
        let n = self.field.parts.work;
        let kept = independent(rows, RANK).kept;
        let slips: Vec<f64> = kept.iter().map(|&row| -dot(rows[row], &self.stepper.y)).collect();
        if slips.iter().all(|slip| *slip == 0.0) {
            return Some(Jump { speeds: vec![0.0; n], impulses: vec![] });
        }
        let masses = Triangles::new(self.model.mechanism.masses(), PIVOT)?;
        let columns: Vec<Vec<f64>> = kept.iter().map(|&row| masses.solution(rows[row])).collect();
        let mut mobility = Matrix::zeros(kept.len(), kept.len());
        for (place, &row) in kept.iter().enumerate() {
            for (entry, column) in mobility.row_mut(place).iter_mut().zip(&columns) {
                *entry = dot(rows[row], column);
            }
        }
        let impulses = Triangles::new(mobility, PIVOT)?.solution(&slips);
        let mut speeds = vec![0.0; n];
        for (impulse, column) in impulses.iter().zip(&columns) {
            speeds.iter_mut().zip(column).for_each(|(speed, change)| *speed += impulse * change);
        }
        Some(Jump { speeds, impulses: kept.into_iter().zip(impulses).collect() })
    }

    /// Change of a slip by an impulse of its own: what compares impulses with slips.
    fn mobility(&self, row: &[f64]) -> f64 {
        Triangles::new(self.model.mechanism.masses(), PIVOT)
            .map_or(0.0, |masses| dot(row, &masses.solution(row)))
    }

    fn take_jump(&mut self, jump: &Jump) {
        if jump.impulses.is_empty() {
            return;
        }
        let mechanism = &self.model.mechanism;
        let n = self.field.parts.work;
        let before = mechanism.kinetic_energy(&self.stepper.y[..n]);
        self.stepper.y.iter_mut().zip(&jump.speeds).for_each(|(speed, change)| *speed += change);
        self.impacts += before - mechanism.kinetic_energy(&self.stepper.y[..n]);
    }

    /// Updates the field after a jump of speeds: segments, flanks and converters, and the thresholds that
    /// were passed.
    pub(super) fn follow_jump(&mut self, changes: &mut Vec<Change>) {
        self.field.place(&self.stepper.y);
        for place in 0..self.model.thresholds.len() {
            let one = &self.model.thresholds[place];
            if self.field.sides[place] * (dot(&one.factors, &self.stepper.y) - one.speed) < 0.0 {
                changes.push(self.pass(place));
            }
        }
    }

    /// Passes a threshold, unless something else at that moment stops or turns the speed there.
    pub(super) fn pass_on(&mut self, place: usize, is_alone: bool) -> Option<Change> {
        let factors = &self.model.thresholds[place].factors;
        let scale = largest_absolute(&self.field.accelerations);
        let rate = self.field.sides[place] * dot(factors, &self.field.accelerations);
        (is_alone || rate < -ACCELERATION * scale).then(|| self.pass(place))
    }

    fn pass(&mut self, place: usize) -> Change {
        self.field.sides[place] *= -1.0;
        let is_rising = self.field.sides[place] > 0.0;
        Change::Threshold { name: self.model.thresholds[place].name.clone(), is_rising }
    }

    /// Dog clutches that are engaged at the start.
    pub(super) fn engage_at_start(&mut self) -> Result<(), Error> {
        for (place, one) in self.model.elements.iter().enumerate() {
            if one.kind.is_wanted(0.0) {
                let slip = self.field.slip(place, &self.stepper.y);
                let Kind::Dog { limit, .. } = one.kind else { continue };
                if slip.abs() <= SLIP * self.speed_scale {
                    self.field.pattern.elements[place] = Way::Stuck;
                } else if slip.abs() <= limit {
                    return Err(Error::InitialDog { element: one.name.clone(), slip });
                } else {
                    self.field.waits[place] = slip.signum();
                }
            }
        }
        Ok(())
    }
}
