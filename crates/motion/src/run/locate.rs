//! Location of the first event in a step, and samples within a step.

use super::Runner;
use crate::decide::Moment;
use crate::field::Trigger;
use crate::record::Sample;
use crate::tolerance::{ROOT, SHORTEST, TOGETHER};

/// Into how many parts a step is cut when an event in it is looked for.
const PARTS: usize = 8;
/// Places in the step of the stages at which margins are known, in the order of
/// [`Field::stages`](crate::field::Field).
const PLACES: [f64; 12] = crate::step::PLACES;
/// Order of the stages along the step; the last one represents the two at its end.
const IN_ORDER: [usize; 11] = [0, 1, 2, 5, 3, 6, 4, 8, 7, 9, 11];
/// Distance outside of the step at which the vertex of a parabola through stages may seem to be.
const BEYOND: f64 = 0.02;
/// A margin this low over its range may touch 0 between two stages.
const TOUCH: f64 = 0.1;
/// Number of times that the place of a dip is narrowed by a third: to the square root of rounding, where a
/// minimum is as low as it gets.
const NARROWINGS: usize = 36;
/// Number of times that the distance to the start is halved to find where a margin was positive.
const HALVINGS: usize = 44;
/// Half the distance over which the slope of a margin is taken, over the step.
const SLOPE: f64 = 1e-4;

impl Runner<'_> {
    /// Finds the triggers that fire first in the step tried, which is then repeated up to there; `None` if
    /// nothing fires.
    pub(super) fn locate(&mut self) -> Option<Vec<Trigger>> {
        let has_start = self.field.triggers.contains(&Trigger::Starts);
        let touching = self.touching();
        if !has_start && touching.is_empty() && self.field.stages.iter().all(|margin| *margin >= 0.0) {
            return None;
        }
        self.densify();
        let mut state = vec![0.0; self.field.parts.size];
        let mut places: Vec<f64> = (1..=PARTS).map(|part| part as f64 / PARTS as f64).collect();
        for trigger in touching {
            places.extend(self.dip(trigger, &mut state));
        }
        places.sort_by(f64::total_cmp);
        let mut before = 0.0;
        let mut good: Vec<f64> = vec![f64::INFINITY; self.field.triggers.len()];
        for place in places {
            self.margins_at(place, &mut state);
            let margins = &self.field.margins;
            let fired: Vec<usize> = (0..margins.len()).filter(|&one| margins[one] < 0.0).collect();
            if fired.is_empty() {
                before = place;
                good.copy_from_slice(margins);
                continue;
            }
            let margins = margins.clone();
            let roots: Vec<(usize, f64)> = fired
                .into_iter()
                .map(|one| (one, self.root(one, [before, place], [good[one], margins[one]], &mut state)))
                .collect();
            return Some(self.stop_at(&roots, &mut state));
        }
        None
    }

    /// Triggers whose margins come so near to 0 at a stage that they may be below it between two.
    ///
    /// A step is short enough for its error to be `1e-11`. Over it a margin has the shape of a parabola, or
    /// of a polynomial that bends little more. The stages are at most 0.27 of the step apart. A parabola that
    /// touches 0 between two of them is at the nearer one at most `0.134²/0.6² = 0.05` of its range over the
    /// stages.
    ///
    /// So two kinds of margins are checked: those below 0 at a stage before the last, and those below twice
    /// the value above. Of the latter only those count whose parabola through the lowest stage and its
    /// neighbours has its vertex in the step, not far above 0.
    fn touching(&self) -> Vec<usize> {
        let triggers = self.field.triggers.len();
        let near = |&trigger: &usize| {
            let at = |stage: usize| self.field.stages[stage * triggers + trigger];
            let mut lowest = 0;
            let mut high = 0.0_f64;
            for (place, &stage) in IN_ORDER.iter().enumerate() {
                if at(stage) < at(IN_ORDER[lowest]) {
                    lowest = place;
                }
                high = high.max(at(stage));
            }
            let low = at(IN_ORDER[lowest]);
            if low < 0.0 {
                // What is below 0 at the end is found from there.
                return lowest + 1 < IN_ORDER.len();
            }
            if low >= TOUCH * (high - low) || high == f64::MAX {
                return false;
            }
            let middle = lowest.clamp(1, IN_ORDER.len() - 2);
            let points =
                [middle - 1, middle, middle + 1].map(|place| [PLACES[IN_ORDER[place]], at(IN_ORDER[place])]);
            let (vertex, least) = parabola(points);
            vertex > -BEYOND && vertex < 1.0 + BEYOND && least < 0.25 * low + TOUCH * TOUCH * high
        };
        if self.field.stages.is_empty() { vec![] } else { (0..triggers).filter(near).collect() }
    }

    /// Place in the step at which a margin is lowest, if it is below 0 there.
    fn dip(&mut self, trigger: usize, state: &mut [f64]) -> Option<f64> {
        let mut margin = |place: f64| self.margin_at(trigger, place, state);
        let parts = 2 * PARTS;
        let mut least = (f64::INFINITY, 0.0);
        for part in 1..=parts {
            let place = part as f64 / parts as f64;
            let found = margin(place);
            if found < least.0 {
                least = (found, place);
            }
        }
        let width = 1.0 / parts as f64;
        let (mut from, mut to) = ((least.1 - width).max(0.0), (least.1 + width).min(1.0));
        for _ in 0..NARROWINGS {
            if least.0 < 0.0 {
                return Some(least.1);
            }
            let thirds = [from + (to - from) / 3.0, to - (to - from) / 3.0];
            let found = thirds.map(&mut margin);
            let lower = usize::from(found[1] < found[0]);
            if found[lower] < least.0 {
                least = (found[lower], thirds[lower]);
            }
            if lower == 0 { to = thirds[1] } else { from = thirds[0] }
        }
        None
    }

    /// Repeats the step up to the first of these events; what fires there.
    fn stop_at(&mut self, roots: &[(usize, f64)], state: &mut [f64]) -> Vec<Trigger> {
        let first = roots.iter().map(|(_, place)| *place).fold(f64::INFINITY, f64::min);
        let lead = roots.iter().find(|(_, place)| *place == first).map_or(0, |(one, _)| *one);
        let together = roots.iter().filter(|(_, place)| *place <= first + TOGETHER);
        let fired = together.map(|(one, _)| self.field.triggers[*one]).collect();
        let whole = self.stepper.h;
        if first * whole <= SHORTEST * self.end {
            // At the start of the step: the state is as it was.
            self.sample_within(0.0);
            self.stepper.end.copy_from_slice(&self.stepper.y);
            self.stepper.h = 0.0;
            let Self { field, stepper, .. } = self;
            let (t, y) = (stepper.t, stepper.y.clone());
            stepper.begin(|t, y, dy| field.evaluate(t, y, dy));
            field.measure(t, &y);
            return fired;
        }
        let ends = [(first - SLOPE).max(0.0), (first + SLOPE).min(1.0)];
        let [low, high] = ends.map(|place| self.margin_at(lead, place, state));
        let slope = (high - low) / (ends[1] - ends[0]);
        self.sample_within(first);
        let mut place = first;
        for _ in 0..4 {
            self.attempt(place * whole);
            let step = -self.field.margins[lead] / slope;
            // Of what has no slope, and of what the dense output has found well enough, the place stays.
            if !step.is_finite()
                || step.abs() > SLOPE
                || step.abs() <= ROOT
                || self.field.triggers[lead] == Trigger::Starts
            {
                break;
            }
            place = (place + step).clamp(0.0, 1.0);
        }
        fired
    }

    fn densify(&mut self) {
        let Self { field, stepper, .. } = self;
        stepper.densify(|t, y, dy| field.evaluate(t, y, dy));
    }

    /// Puts the margins at a part of the step, on the dense output, into those of the field.
    fn margins_at(&mut self, place: f64, state: &mut [f64]) {
        let t = self.stepper.t + place * self.stepper.h;
        self.stepper.at(place, state);
        self.field.evaluate(t, state, &mut self.rates);
        self.field.measure(t, state);
        if let Some(start) = self.field.triggers.iter().position(|one| *one == Trigger::Starts) {
            let moment =
                Moment { t, y: state, speed_scale: self.speed_scale, loosed: &[], ahead: 0.0, held: None };
            if self.field.would_start(&moment, &mut self.unique) {
                self.field.margins[start] = -1.0;
            }
        }
    }

    /// Margin of one trigger at a part of the step.
    fn margin_at(&mut self, trigger: usize, place: f64, state: &mut [f64]) -> f64 {
        self.margins_at(place, state);
        self.field.margins[trigger]
    }

    /// Place at which a margin ends between two parts of the step, the second negative, by regula falsi that
    /// halves if it is slow. The first margin is positive, or at the start of a stretch, where a margin
    /// begins with 0.
    fn root(
        &mut self,
        trigger: usize,
        [mut from, mut to]: [f64; 2],
        [mut above, mut below]: [f64; 2],
        state: &mut [f64],
    ) -> f64 {
        if from == 0.0 {
            let mut near = to;
            let found = (0..HALVINGS).find_map(|_| {
                near *= 0.5;
                let margin = self.margin_at(trigger, near, state);
                if margin < 0.0 {
                    (to, below) = (near, margin);
                }
                (margin > 0.0).then_some(margin)
            });
            let Some(margin) = found else { return 0.0 };
            (from, above) = (near, margin);
        }
        let mut is_halved = false;
        while to - from > ROOT {
            let width = to - from;
            let chord = from + width * above / (above - below);
            // A chord that lands on an end would not close the other.
            let inner = chord.clamp(from + 0.25 * ROOT, to - 0.25 * ROOT);
            let middle = if is_halved { 0.5 * (from + to) } else { inner };
            if middle <= from || middle >= to {
                break;
            }
            let margin = self.margin_at(trigger, middle, state);
            if margin > 0.0 {
                (from, above) = (middle, margin);
                // So that the far end moves, too.
                below *= 0.5;
            } else if margin < 0.0 {
                (to, below) = (middle, margin);
                above *= 0.5;
            } else {
                return middle;
            }
            is_halved = to - from > 0.5 * width;
        }
        to
    }

    /// Samples within the step tried, up to a part of it, from the dense output.
    pub(super) fn sample_within(&mut self, part: f64) {
        let Some(every) = self.every else { return };
        let (t, h) = (self.stepper.t, self.stepper.h);
        let mut is_dense = false;
        loop {
            let next = (self.sampled + 1) as f64 * every;
            if next > t + part * h || next >= self.end || h == 0.0 {
                return;
            }
            if !is_dense {
                self.densify();
                is_dense = true;
            }
            let mut state = vec![0.0; self.field.parts.size];
            self.margins_at(((next - t) / h).clamp(0.0, 1.0), &mut state);
            self.samples.push(Sample::of(&self.field, next, &state));
            self.sampled += 1;
        }
    }
}

/// Vertex of the parabola through three points, and its value there.
fn parabola([a, b, c]: [[f64; 2]; 3]) -> (f64, f64) {
    let first = (b[1] - a[1]) / (b[0] - a[0]);
    let second = ((c[1] - b[1]) / (c[0] - b[0]) - first) / (c[0] - a[0]);
    let vertex = 0.5 * (a[0] + b[0] - first / second);
    (vertex, a[1] + (vertex - a[0]) * (first + second * (vertex - b[0])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_are_taken_along_the_step() {
        assert!(IN_ORDER.windows(2).all(|pair| PLACES[pair[0]] < PLACES[pair[1]]));
        assert_eq!(PLACES[11], 1.0);
    }

    #[test]
    fn a_parabola_by_hand() {
        // 3 + 2·(x − 0.4)²
        let at = |x: f64| [x, 3.0 + 2.0 * (x - 0.4) * (x - 0.4)];
        let (vertex, least) = parabola([at(0.1), at(0.3), at(0.9)]);
        assert!((vertex - 0.4).abs() < 1e-14 && (least - 3.0).abs() < 1e-14);
    }
}
