//! Events that may end a pattern, and the margins to them.

use super::Field;
use crate::model::Kind;
use crate::pattern::Way;
use crate::table;
use crate::tolerance::{HOLD, RANK, TORQUE};
use epicyclic_numerics::linear::independent;
use epicyclic_numerics::values::dot;

/// Event that may end a pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Trigger {
    /// An element slips no more.
    SlipEnds(usize),
    /// The torque that an element holds exceeds its static capacity.
    Exceeds(usize),
    /// A one-way clutch would have to push.
    LetsGo(usize),
    /// A dog clutch that waits is slow enough.
    Meshes(usize),
    /// A set with losses rolls no more.
    RollingEnds(usize),
    /// Power through a lossy mesh turns.
    Reverses(usize),
    /// Mesh friction holds no more.
    Starts,
    /// A torque over speed comes to the lower or upper end of a segment.
    Segment(usize, bool),
    /// Friction over slip speed does.
    Curve(usize, bool),
    /// A drag comes to the lower or upper end of a segment of its curve.
    Drag(usize, bool),
    /// A shaft comes to the first or second end of what its flanks do.
    Flank(usize, bool),
    /// A converter comes to the end of its segment.
    Drive(usize, usize),
    /// A threshold is passed.
    Passes(usize),
}

impl Field<'_> {
    /// Finds the triggers under the pattern.
    pub(crate) fn find_triggers(&mut self) {
        self.find_yielding();
        self.triggers.clear();
        for (place, one) in self.model.elements.iter().enumerate() {
            match (self.pattern.elements[place], &one.kind) {
                (Way::Open, Kind::Dog { limit, .. }) => {
                    if self.waits[place] != 0.0 && limit.is_finite() {
                        self.triggers.push(Trigger::Meshes(place));
                    }
                }
                (Way::Open, _) | (_, Kind::Dog { .. }) => {}
                // Its slip does not change while the rest holds.
                (Way::Forward | Way::Backward, _) if self.yields[place] => {}
                (Way::Forward | Way::Backward, kind) => {
                    self.triggers.push(Trigger::SlipEnds(place));
                    if let Kind::Friction { curve, .. } = kind {
                        let [lower, upper] = table::ends(curve, self.pattern.curves[place]);
                        // What is below 0 ends with the slip.
                        if lower.is_some_and(|lower| lower > 0.0) {
                            self.triggers.push(Trigger::Curve(place, false));
                        }
                        if upper.is_some() {
                            self.triggers.push(Trigger::Curve(place, true));
                        }
                    }
                }
                (Way::Stuck, Kind::Friction { .. } | Kind::Drag) => {
                    self.triggers.push(Trigger::Exceeds(place));
                }
                (Way::Stuck, Kind::OneWay) => self.triggers.push(Trigger::LetsGo(place)),
            }
        }
        for set in 0..self.pattern.sets.len() {
            if self.pattern.sets[set].sign() != 0.0 {
                self.triggers.push(Trigger::RollingEnds(set));
                let meshes = self.model.mechanism.sets[set].meshes.clone();
                let lossy = meshes.filter(|&mesh| self.model.mechanism.meshes[mesh].is_lossy());
                self.triggers.extend(lossy.map(Trigger::Reverses));
            }
        }
        if !self.system.stuck_sets.is_empty() {
            self.triggers.push(Trigger::Starts);
        }
        for (place, one) in self.model.torques.iter().enumerate() {
            let ends = one.law.ends(self.pattern.segments[place]);
            for (is_upper, _) in [false, true].into_iter().zip(ends).filter(|(_, end)| end.is_some()) {
                self.triggers.push(Trigger::Segment(place, is_upper));
            }
        }
        for (place, one) in self.model.drags.iter().enumerate() {
            let ends = one.curve.ends(self.pattern.drags[place]);
            for (is_upper, _) in [false, true].into_iter().zip(ends).filter(|(_, end)| end.is_some()) {
                self.triggers.push(Trigger::Drag(place, is_upper));
            }
        }
        for (place, one) in self.model.shafts.iter().enumerate() {
            let ends = one.shaft.margins(self.pattern.flanks[place], 0.0, 0.0);
            for (is_second, _) in [false, true].into_iter().zip(ends).filter(|(_, end)| end.is_some()) {
                self.triggers.push(Trigger::Flank(place, is_second));
            }
        }
        for (place, one) in self.model.converters.iter().enumerate() {
            let zeros = vec![0.0; self.parts.work];
            let ends = one.margins(self.pattern.drives[place], &zeros, 0.0);
            self.triggers
                .extend((0..3).filter(|&end| ends[end].is_some()).map(|end| Trigger::Drive(place, end)));
        }
        self.triggers.extend((0..self.sides.len()).map(Trigger::Passes));
        self.margins.resize(self.triggers.len(), 0.0);
        self.stages.clear();
    }

    /// Finds the elements that yield: they carry what they can without slip, since mesh friction and what is
    /// stuck hold their links.
    fn find_yielding(&mut self) {
        self.yields.fill(false);
        if self.system.stuck_sets.is_empty() {
            return;
        }
        let model = self.model;
        let stuck = self.system.stuck.iter().map(|&place| model.elements[place].slip.as_slice());
        let sets = self.system.stuck_sets.iter().map(|&set| model.mechanism.sets[set].rolling.as_slice());
        let mut rows: Vec<&[f64]> = stuck.chain(sets).collect();
        let held = independent(&rows, RANK).kept.len();
        for (place, one) in model.elements.iter().enumerate() {
            if self.pattern.elements[place].sign() != 0.0 {
                rows.push(&one.slip);
                self.yields[place] = independent(&rows, RANK).kept.len() == held;
                rows.pop();
            }
        }
    }

    /// Margins of the triggers at what was evaluated last; [`Trigger::Starts`] is left to the caller.
    pub(crate) fn measure(&mut self, t: f64, y: &[f64]) {
        let guard = TORQUE * self.torque_scale;
        for place in 0..self.triggers.len() {
            self.margins[place] = self.margin(self.triggers[place], t, y, guard);
        }
    }

    fn margin(&self, trigger: Trigger, t: f64, y: &[f64], guard: f64) -> f64 {
        let mechanism = &self.model.mechanism;
        let hold = HOLD * self.speed_scale;
        let between = |ends: [Option<f64>; 2], is_upper: bool, at: f64| {
            let distance = |end: Option<f64>| end.map_or(f64::MAX, |end| at - end);
            hold + if is_upper { -distance(ends[1]) } else { distance(ends[0]) }
        };
        match trigger {
            Trigger::SlipEnds(place) => self.pattern.elements[place].sign() * self.slip(place, y),
            Trigger::Exceeds(place) => {
                let most = self.static_capacity(place, t).unwrap_or(f64::INFINITY);
                most - self.elements[place].abs() + guard
            }
            Trigger::LetsGo(place) => self.elements[place] + self.model.elements[place].dry + guard,
            Trigger::Meshes(place) => match &self.model.elements[place].kind {
                Kind::Dog { limit, .. } => self.waits[place] * self.slip(place, y) - limit,
                Kind::Friction { .. } | Kind::OneWay | Kind::Drag => f64::MAX,
            },
            Trigger::RollingEnds(set) => self.pattern.sets[set].sign() * dot(&mechanism.sets[set].rolling, y),
            Trigger::Reverses(place) => {
                let mesh = &mechanism.meshes[place];
                let rolling = self.pattern.sets[mesh.set].sign() * mesh.factor.signum();
                -self.meshes[place] * rolling * f64::from(self.pattern.meshes[place]) + guard
            }
            Trigger::Starts => 1.0,
            Trigger::Segment(place, is_upper) => {
                let one = &self.model.torques[place];
                between(one.law.ends(self.pattern.segments[place]), is_upper, dot(&one.speed, y))
            }
            Trigger::Curve(place, is_upper) => match &self.model.elements[place].kind {
                Kind::Friction { curve, .. } => {
                    let slip = self.pattern.elements[place].sign() * self.slip(place, y);
                    between(table::ends(curve, self.pattern.curves[place]), is_upper, slip)
                }
                Kind::OneWay | Kind::Dog { .. } | Kind::Drag => f64::MAX,
            },
            Trigger::Drag(place, is_upper) => {
                let one = &self.model.drags[place];
                between(one.curve.ends(self.pattern.drags[place]), is_upper, dot(&one.slip, y))
            }
            Trigger::Flank(place, is_second) => {
                let one = &self.model.shafts[place];
                let twist = y[self.parts.twist + place];
                let ends = one.shaft.margins(self.pattern.flanks[place], twist, dot(&one.rate, y));
                ends[usize::from(is_second)].unwrap_or(f64::MAX)
            }
            Trigger::Drive(place, end) => {
                let one = &self.model.converters[place];
                one.margins(self.pattern.drives[place], y, hold)[end].unwrap_or(f64::MAX)
            }
            Trigger::Passes(place) => {
                let one = &self.model.thresholds[place];
                self.sides[place] * (dot(&one.factors, y) - one.speed) + hold
            }
        }
    }
}
