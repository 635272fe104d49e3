//! The right side of the equations of motion under a pattern, the energies beside it, and how far the pattern is from its end.
//!
//! The state is, in this order,
//!
//! | part | meaning | unit |
//! |---|---|---|
//! | `q̇` | speeds of the coordinates | rad/s |
//! | work | of each applied torque, `∫ T·ω dt` | J |
//! | heat | of each element, `∫ C·abs(s) dt` | J |
//! | loss | of each mesh, `∫ P·(1 − e) dt` | J |
//! | inner loss | of each applied torque, in its source | J |
//!
//! A *trigger* is what may end a pattern, with a margin that is positive until then.

use crate::course::Piece;
use crate::dense::{dot, largest};
use crate::model::{Kind, Model};
use crate::pattern::{Pattern, System, Way};
use crate::split::{Share, even, torques};
use crate::tolerance::TORQUE;

/// What may end a pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Trigger {
    /// An element slips no more.
    SlipEnds(usize),
    /// What an element holds exceeds its static capacity.
    Exceeds(usize),
    /// A one-way clutch would have to push.
    LetsGo(usize),
    /// A set with losses rolls no more.
    RollingEnds(usize),
    /// Power through a lossy mesh turns.
    Reverses(usize),
    /// Mesh friction holds no more.
    Starts,
    /// A torque over speed comes to the lower or upper end of a segment.
    Segment(usize, bool),
    /// A threshold is passed.
    Passes(usize),
}

/// Places of the parts of the state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parts {
    pub(crate) work: usize,
    pub(crate) heat: usize,
    pub(crate) loss: usize,
    pub(crate) inner: usize,
    pub(crate) size: usize,
}

impl Parts {
    pub(crate) fn of(model: &Model) -> Self {
        let work = model.mechanism.freedoms();
        let heat = work + model.torques.len();
        let loss = heat + model.elements.len();
        let inner = loss + model.mechanism.meshes.len();
        Self { work, heat, loss, inner, size: inner + model.torques.len() }
    }
}

/// The equations of motion under a pattern.
#[derive(Debug, Clone)]
pub(crate) struct Field<'m> {
    pub(crate) model: &'m Model,
    pub(crate) parts: Parts,
    pub(crate) pattern: Pattern,
    pub(crate) system: System,
    /// Pieces of the applied torques over time, and of the capacities.
    courses: Vec<Piece>,
    capacities: Vec<Piece>,
    /// Whether the capacity of an element is nothing in this piece.
    pub(crate) is_idle: Vec<bool>,
    /// On which side of each threshold the speed is.
    pub(crate) sides: Vec<f64>,
    pub(crate) triggers: Vec<Trigger>,
    pub(crate) margins: Vec<f64>,
    /// The least margins since they were last reset.
    pub(crate) low: Vec<f64>,
    /// The largest torque so far.
    pub(crate) torque_scale: f64,
    /// What was evaluated last: torques on nodes, `q̈`, `t`, `λ`, torques of elements on their first links, applied torques.
    pub(crate) nodes: Vec<f64>,
    pub(crate) accelerations: Vec<f64>,
    pub(crate) meshes: Vec<f64>,
    reactions: Vec<f64>,
    pub(crate) elements: Vec<f64>,
    pub(crate) applied: Vec<f64>,
}

impl<'m> Field<'m> {
    /// Everything open, at a time; `None` where nothing can be solved.
    pub(crate) fn new(model: &'m Model, t: f64) -> Option<Self> {
        let pattern = Pattern {
            elements: vec![Way::Open; model.elements.len()],
            sets: vec![Way::Open; model.mechanism.sets.len()],
            meshes: vec![1; model.mechanism.meshes.len()],
            segments: vec![0; model.torques.len()],
        };
        let system = System::new(model, &pattern)?;
        let mut made = Self {
            model,
            parts: Parts::of(model),
            pattern,
            system,
            courses: vec![],
            capacities: vec![],
            is_idle: vec![],
            sides: vec![0.0; model.thresholds.len()],
            triggers: vec![],
            margins: vec![],
            low: vec![],
            torque_scale: 0.0,
            nodes: vec![0.0; model.mechanism.nodes],
            accelerations: vec![0.0; model.mechanism.freedoms()],
            meshes: vec![0.0; model.mechanism.meshes.len()],
            reactions: vec![],
            elements: vec![0.0; model.elements.len()],
            applied: vec![0.0; model.torques.len()],
        };
        made.take_pieces(t);
        Some(made)
    }

    /// Takes the pieces of all courses that begin at a time.
    pub(crate) fn take_pieces(&mut self, t: f64) {
        self.courses.clear();
        self.courses.extend(self.model.torques.iter().map(|one| one.law.piece(t)));
        self.capacities.clear();
        self.is_idle.clear();
        for element in &self.model.elements {
            let (piece, is_idle) = match &element.kind {
                Kind::Friction { capacity, .. } => (capacity.piece(t), capacity.is_zero(t)),
                Kind::OneWay => (Piece::ZERO, false),
            };
            self.capacities.push(piece);
            self.is_idle.push(is_idle);
        }
    }

    /// Capacity of a slipping element; it never falls below 0, which rounding at the end of a ramp would let it.
    pub(crate) fn capacity(&self, element: usize, t: f64) -> f64 {
        self.capacities[element].at(t).max(0.0)
    }

    /// The largest torque that a stuck element holds; none of a one-way clutch.
    pub(crate) fn static_capacity(&self, element: usize, t: f64) -> Option<f64> {
        match &self.model.elements[element].kind {
            Kind::Friction { static_ratio, .. } => Some(static_ratio * self.capacity(element, t)),
            Kind::OneWay => None,
        }
    }

    pub(crate) fn slip(&self, element: usize, y: &[f64]) -> f64 {
        dot(&self.model.elements[element].slip, y)
    }

    /// Derivative of the state.
    pub(crate) fn evaluate(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        let parts = self.parts;
        self.nodes.fill(0.0);
        for (place, one) in self.model.torques.iter().enumerate() {
            let speed = dot(&one.speed, y);
            let torque = one.law.at(&self.courses[place], self.pattern.segments[place], t, speed);
            if let Some(node) = one.place {
                self.nodes[node] += torque;
            }
            self.applied[place] = torque;
            dy[parts.work + place] = torque * speed;
            dy[parts.inner + place] = one.law.inner_loss(torque, speed);
        }
        for (place, one) in self.model.elements.iter().enumerate() {
            let mut heat = 0.0;
            self.elements[place] = 0.0;
            let sign = self.pattern.elements[place].sign();
            if sign != 0.0 {
                let torque = -sign * self.capacity(place, t);
                self.elements[place] = torque;
                push(&mut self.nodes, one.places, torque);
                heat = -torque * dot(&one.slip, y);
            }
            dy[parts.heat + place] = heat;
        }
        self.react(t);
        self.system.accelerations.times_into(&self.nodes, &mut self.accelerations);
        self.system.meshes.times_into(&self.nodes, &mut self.meshes);
        dy[..parts.work].copy_from_slice(&self.accelerations);
        for (place, mesh) in self.model.mechanism.meshes.iter().enumerate() {
            let loss = if mesh.is_lossy() {
                let power = -self.meshes[place] * dot(&mesh.rolling, y);
                power * (1.0 - self.pattern.part(&self.model.mechanism, place))
            } else {
                0.0
            };
            dy[parts.loss + place] = loss;
        }
    }

    /// Torques of the stuck elements.
    fn react(&mut self, t: f64) {
        let kept = self.system.independent.kept.len();
        self.reactions.resize(self.system.reactions.rows, 0.0);
        self.system.reactions.times_into(&self.nodes, &mut self.reactions);
        let others = self.system.independent.others.len();
        if others > 0 {
            let stuck = &self.system.stuck;
            let of_kept = (0..kept).map(|place| Share {
                base: self.reactions[place],
                factors: self
                    .system
                    .independent
                    .others
                    .iter()
                    .map(|(_, made)| -made.get(place).copied().unwrap_or(0.0))
                    .collect(),
                capacity: self.static_capacity(stuck[self.system.independent.kept[place]], t),
            });
            let of_others = (0..others).map(|place| Share {
                base: 0.0,
                factors: (0..others).map(|one| f64::from(u8::from(one == place))).collect(),
                capacity: self.static_capacity(stuck[self.system.independent.others[place].0], t),
            });
            let shares: Vec<Share> = of_kept.chain(of_others).collect();
            // Where no split spares the one-way clutches, the independent elements alone show it.
            let y = even(&shares, others).unwrap_or_else(|| vec![0.0; others]);
            let found = torques(&shares, &y);
            for (place, torque) in found[kept..].iter().enumerate() {
                let element = stuck[self.system.independent.others[place].0];
                self.elements[element] = *torque;
                push(&mut self.nodes, self.model.elements[element].places, *torque);
            }
            self.reactions[..kept].copy_from_slice(&found[..kept]);
        }
        for (place, &kept) in self.system.independent.kept.iter().enumerate() {
            self.elements[self.system.stuck[kept]] = self.reactions[place];
        }
    }

    /// Which triggers there are under the pattern.
    pub(crate) fn find_triggers(&mut self) {
        self.triggers.clear();
        for (place, one) in self.model.elements.iter().enumerate() {
            match (self.pattern.elements[place], &one.kind) {
                (Way::Open, _) => {}
                (Way::Forward | Way::Backward, _) => self.triggers.push(Trigger::SlipEnds(place)),
                (Way::Stuck, Kind::Friction { .. }) => self.triggers.push(Trigger::Exceeds(place)),
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
        self.triggers.extend((0..self.sides.len()).map(Trigger::Passes));
        self.margins.resize(self.triggers.len(), 0.0);
        self.low.resize(self.triggers.len(), 0.0);
    }

    /// Margins of the triggers at what was evaluated last; [`Trigger::Starts`] is left to the caller.
    pub(crate) fn measure(&mut self, t: f64, y: &[f64]) {
        let guard = TORQUE * self.torque_scale;
        for place in 0..self.triggers.len() {
            let margin = self.margin(self.triggers[place], t, y, guard);
            self.margins[place] = margin;
            self.low[place] = self.low[place].min(margin);
        }
    }

    fn margin(&self, trigger: Trigger, t: f64, y: &[f64], guard: f64) -> f64 {
        let mechanism = &self.model.mechanism;
        match trigger {
            Trigger::SlipEnds(place) => self.pattern.elements[place].sign() * self.slip(place, y),
            Trigger::Exceeds(place) => {
                let most = self.static_capacity(place, t).unwrap_or(f64::INFINITY);
                most - self.elements[place].abs() + guard
            }
            Trigger::LetsGo(place) => self.elements[place] + guard,
            Trigger::RollingEnds(set) => self.pattern.sets[set].sign() * dot(&mechanism.sets[set].rolling, y),
            Trigger::Reverses(place) => {
                let mesh = &mechanism.meshes[place];
                let rolling = self.pattern.sets[mesh.set].sign() * mesh.factor.signum();
                -self.meshes[place] * rolling * f64::from(self.pattern.meshes[place]) + guard
            }
            Trigger::Starts => 1.0,
            Trigger::Segment(place, is_upper) => {
                let one = &self.model.torques[place];
                let ends = one.law.ends(self.pattern.segments[place]);
                let speed = dot(&one.speed, y);
                let distance = |end: Option<f64>| end.map_or(f64::INFINITY, |end| speed - end);
                if is_upper { -distance(ends[1]).min(f64::MAX) } else { distance(ends[0]) }
            }
            Trigger::Passes(place) => {
                let one = &self.model.thresholds[place];
                self.sides[place] * (dot(&one.factors, y) - one.speed)
            }
        }
    }

    /// The largest torque of what was evaluated last.
    pub(crate) fn largest_torque(&self) -> f64 {
        [&self.nodes, &self.meshes, &self.reactions, &self.elements]
            .into_iter()
            .fold(0.0, |most, values| most.max(largest(values)))
    }
}

/// A torque on the first of two places, its opposite on the second.
fn push(nodes: &mut [f64], places: [Option<usize>; 2], torque: f64) {
    for (place, torque) in places.into_iter().zip([torque, -torque]) {
        if let Some(node) = place {
            nodes[node] += torque;
        }
    }
}
