//! Right side of the equations of motion under a pattern, with the energies and the margins to the pattern's
//! end.
//!
//! The state has these parts, in this order:
//!
//! | part | meaning | unit |
//! |---|---|---|
//! | `q̇` | speeds of the coordinates | rad/s |
//! | work | of each applied torque, `∫ T·ω dt` | J |
//! | heat | of each element, `∫ C·abs(s) dt`, without drags | J |
//! | loss | of each mesh, `∫ P·(1 − e) dt` | J |
//! | inner loss | of each applied torque, in its source | J |
//! | oil | heat of each converter | J |
//! | damping | heat of each shaft | J |
//! | drag | loss of each drag, `∫ M·abs(s) dt` | J |
//! | twist | of each shaft, `∫ (ω_1 − ω_2) dt` | rad |
//!
//! A *trigger* is an event that may end a pattern, with a margin that is positive until then.

mod triggers;

pub(crate) use triggers::Trigger;

use crate::converter::Drive;
use crate::course::Piece;
use crate::model::{Element, Kind, Model};
use crate::pattern::{Pattern, System, Way};
use crate::shaft::Flank;
use crate::split::{Share, even, torques};
use crate::table;
use epicyclic_numerics::values::{dot, largest_absolute};

/// Places of the parts of the state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parts {
    pub(crate) work: usize,
    pub(crate) heat: usize,
    pub(crate) loss: usize,
    pub(crate) inner: usize,
    pub(crate) oil: usize,
    pub(crate) damping: usize,
    pub(crate) drag: usize,
    pub(crate) twist: usize,
    pub(crate) size: usize,
}

impl Parts {
    pub(crate) fn of(model: &Model) -> Self {
        let work = model.mechanism.freedoms();
        let heat = work + model.torques.len();
        let loss = heat + model.elements.len();
        let inner = loss + model.mechanism.meshes.len();
        let oil = inner + model.torques.len();
        let damping = oil + model.converters.len();
        let drag = damping + model.shafts.len();
        let twist = drag + model.drags.len();
        Self { work, heat, loss, inner, oil, damping, drag, twist, size: twist + model.shafts.len() }
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
    /// Whether the capacity of an element is nothing in this piece, so that it is open but for drags.
    pub(crate) is_open: Vec<bool>,
    /// Whether an element has neither capacity nor dry friction of drags now.
    pub(crate) is_idle: Vec<bool>,
    /// Side of each threshold on which the speed is.
    pub(crate) sides: Vec<f64>,
    /// Sign of the slip of each dog clutch that waits to engage; else 0.
    pub(crate) waits: Vec<f64>,
    /// Whether an element that slips by its [`Way`] has no slip and gets none, see
    /// [`find_triggers`](Self::find_triggers).
    pub(crate) yields: Vec<bool>,
    pub(crate) triggers: Vec<Trigger>,
    pub(crate) margins: Vec<f64>,
    /// Margins at the stages of a step, one set of them after the other.
    pub(crate) stages: Vec<f64>,
    /// The largest torque and speed so far.
    pub(crate) torque_scale: f64,
    pub(crate) speed_scale: f64,
    /// Results of the last evaluation: torques on nodes, `q̈`, `t`, `λ`, torques of elements on their first
    /// links, applied torques.
    pub(crate) nodes: Vec<f64>,
    pub(crate) accelerations: Vec<f64>,
    pub(crate) meshes: Vec<f64>,
    reactions: Vec<f64>,
    pub(crate) elements: Vec<f64>,
    pub(crate) applied: Vec<f64>,
    /// Torques that shafts pass on, and torques on impellers and turbines.
    pub(crate) shafts: Vec<f64>,
    pub(crate) converters: Vec<[f64; 2]>,
    /// Torques of drags on their first links, without what stuck elements hold of them.
    pub(crate) drags: Vec<f64>,
}

impl<'m> Field<'m> {
    /// Everything open, at a time; `None` where nothing can be solved.
    pub(crate) fn new(model: &'m Model, t: f64) -> Option<Self> {
        let pattern = Pattern {
            elements: vec![Way::Open; model.elements.len()],
            sets: vec![Way::Open; model.mechanism.sets.len()],
            meshes: vec![1; model.mechanism.meshes.len()],
            segments: vec![0; model.torques.len()],
            curves: vec![0; model.elements.len()],
            drags: vec![0; model.drags.len()],
            flanks: vec![Flank::Firm; model.shafts.len()],
            drives: vec![Drive::Idle; model.converters.len()],
        };
        let system = System::new(model, &pattern)?;
        let mut made = Self {
            model,
            parts: Parts::of(model),
            pattern,
            system,
            courses: vec![],
            capacities: vec![],
            is_open: vec![],
            is_idle: vec![],
            sides: vec![0.0; model.thresholds.len()],
            waits: vec![0.0; model.elements.len()],
            yields: vec![false; model.elements.len()],
            triggers: vec![],
            margins: vec![],
            stages: vec![],
            torque_scale: 0.0,
            speed_scale: 0.0,
            nodes: vec![0.0; model.mechanism.nodes],
            accelerations: vec![0.0; model.mechanism.freedoms()],
            meshes: vec![0.0; model.mechanism.meshes.len()],
            reactions: vec![],
            elements: vec![0.0; model.elements.len()],
            applied: vec![0.0; model.torques.len()],
            shafts: vec![0.0; model.shafts.len()],
            converters: vec![[0.0; 2]; model.converters.len()],
            drags: vec![0.0; model.drags.len()],
        };
        made.take_pieces(t);
        Some(made)
    }

    /// Takes the pieces of all courses that begin at a time.
    pub(crate) fn take_pieces(&mut self, t: f64) {
        self.courses.clear();
        self.courses.extend(self.model.torques.iter().map(|one| one.law.piece(t)));
        self.capacities.clear();
        self.is_open.clear();
        for element in &self.model.elements {
            let (piece, is_open) = match &element.kind {
                Kind::Friction { capacity, .. } => (capacity.piece(t), capacity.is_zero(t)),
                Kind::OneWay | Kind::Dog { .. } => (Piece::ZERO, false),
                Kind::Drag => (Piece::ZERO, true),
            };
            self.capacities.push(piece);
            self.is_open.push(is_open);
        }
        self.find_idle();
    }

    /// Finds what is idle, with the dog clutches as they are engaged.
    pub(crate) fn find_idle(&mut self) {
        let Self { model, pattern, is_open, is_idle, .. } = self;
        let engaged = |place: Option<usize>| place.is_some_and(|dog| pattern.elements[dog] == Way::Stuck);
        let rests = |one: &Element| one.dry == 0.0 || engaged(one.beside);
        is_idle.clear();
        is_idle.extend(model.elements.iter().zip(is_open).map(|(one, is_open)| *is_open && rests(one)));
    }

    /// Capacity of a slipping element, where its slip is not looked at; it never falls below 0, which
    /// rounding at the end of a ramp would let it.
    fn capacity(&self, element: usize, t: f64) -> f64 {
        self.capacities[element].at(t).max(0.0)
    }

    /// Factor of the capacity at the size of a slip.
    fn curve(&self, element: usize, slip: f64) -> f64 {
        match &self.model.elements[element].kind {
            Kind::Friction { curve, .. } if !curve.is_empty() => {
                table::value(curve, self.pattern.curves[element], slip)
            }
            _ => 1.0,
        }
    }

    /// The largest torque that a stuck element holds, with the dry friction of drags; none of a one-way or
    /// dog clutch.
    pub(crate) fn static_capacity(&self, element: usize, t: f64) -> Option<f64> {
        self.own_capacity(element, t).map(|own| own + self.model.elements[element].dry)
    }

    /// Capacity of an element without drags.
    pub(crate) fn own_capacity(&self, element: usize, t: f64) -> Option<f64> {
        match &self.model.elements[element].kind {
            Kind::Friction { static_ratio, curve, .. } => {
                let at_rest = if curve.is_empty() {
                    1.0
                } else {
                    table::value(curve, table::segment(curve, 0.0, true), 0.0)
                };
                Some(static_ratio * at_rest * self.capacity(element, t))
            }
            Kind::OneWay | Kind::Dog { .. } => None,
            Kind::Drag => Some(0.0),
        }
    }

    /// The least torque that a one-way clutch carries.
    fn least(&self, element: usize) -> Option<f64> {
        let one = &self.model.elements[element];
        matches!(one.kind, Kind::OneWay).then_some(-one.dry)
    }

    pub(crate) fn is_dog(&self, element: usize) -> bool {
        matches!(self.model.elements[element].kind, Kind::Dog { .. })
    }

    /// Takes the segments, flanks and converters that go with these speeds and twists.
    pub(crate) fn place(&mut self, y: &[f64]) {
        for (place, one) in self.model.torques.iter().enumerate() {
            self.pattern.segments[place] = one.law.segment(dot(&one.speed, y), true);
        }
        for (place, one) in self.model.elements.iter().enumerate() {
            if let Kind::Friction { curve, .. } = &one.kind {
                self.pattern.curves[place] = table::segment(curve, dot(&one.slip, y).abs(), true);
            }
        }
        for (place, one) in self.model.drags.iter().enumerate() {
            self.pattern.drags[place] = one.curve.segment(dot(&one.slip, y));
        }
        for (place, one) in self.model.shafts.iter().enumerate() {
            self.pattern.flanks[place] = one.shaft.flank(y[self.parts.twist + place], dot(&one.rate, y));
        }
        for (place, one) in self.model.converters.iter().enumerate() {
            self.pattern.drives[place] = one.drive(y);
        }
    }

    /// Torque that mesh friction adds to the root of a set that it holds, and takes from the carrier.
    pub(crate) fn held_torque(&self, set: usize) -> f64 {
        let place = self.system.stuck_sets.iter().position(|&one| one == set);
        place.map_or(0.0, |place| self.reactions[self.system.independent.kept.len() + place])
    }

    /// Elastic energy of the shafts.
    pub(crate) fn elastic_energy(&self, y: &[f64]) -> f64 {
        let twists = &y[self.parts.twist..];
        self.model.shafts.iter().zip(twists).map(|(one, &twist)| one.shaft.energy(twist)).sum()
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
                let slip = dot(&one.slip, y);
                let own = -sign * self.capacity(place, t) * self.curve(place, sign * slip);
                let torque = own - sign * one.dry;
                self.elements[place] = torque;
                push(&mut self.nodes, one.places, torque);
                heat = -own * slip;
            }
            dy[parts.heat + place] = heat;
        }
        for (place, one) in self.model.drags.iter().enumerate() {
            let slip = dot(&one.slip, y);
            let smooth = -one.curve.at(self.pattern.drags[place], slip);
            push(&mut self.nodes, one.places, smooth);
            // The dry part is on the links by what carries it.
            let way = one.carrier.map_or(0.0, |(carrier, sign)| sign * self.pattern.elements[carrier].sign());
            let torque = smooth - way * one.curve.dry;
            self.drags[place] = torque;
            dy[parts.drag + place] = -torque * slip;
        }
        for (place, one) in self.model.shafts.iter().enumerate() {
            let (flank, twist) = (self.pattern.flanks[place], y[parts.twist + place]);
            let rate = dot(&one.rate, y);
            let torque = one.shaft.torque(flank, twist, rate);
            push(&mut self.nodes, one.places, -torque);
            self.shafts[place] = torque;
            dy[parts.damping + place] = one.shaft.heat(flank, twist, rate);
            dy[parts.twist + place] = rate;
        }
        for (place, one) in self.model.converters.iter().enumerate() {
            let (torques, heat) = one.torques(self.pattern.drives[place], y);
            for (node, torque) in one.places.into_iter().zip(torques) {
                if let Some(node) = node {
                    self.nodes[node] += torque;
                }
            }
            self.converters[place] = torques;
            dy[parts.oil + place] = heat;
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
        self.reactions.resize(self.system.reactions.rows(), 0.0);
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
                least: self.least(stuck[self.system.independent.kept[place]]),
            });
            let of_others = (0..others).map(|place| Share {
                base: 0.0,
                factors: (0..others).map(|one| f64::from(u8::from(one == place))).collect(),
                capacity: self.static_capacity(stuck[self.system.independent.others[place].0], t),
                least: self.least(stuck[self.system.independent.others[place].0]),
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

    /// The largest torque of what was evaluated last.
    pub(crate) fn largest_torque(&self) -> f64 {
        [&self.nodes, &self.meshes, &self.reactions, &self.elements]
            .into_iter()
            .fold(0.0, |most, values| most.max(largest_absolute(values)))
    }
}

/// A torque on the first of two places, its opposite on the second.
pub(crate) fn push(nodes: &mut [f64], places: [Option<usize>; 2], torque: f64) {
    for (place, torque) in places.into_iter().zip([torque, -torque]) {
        if let Some(node) = place {
            nodes[node] += torque;
        }
    }
}
