//! Opening and closing of a chamber over its cycle.
//!
//! All chambers go through the same cycle, so that one represents all. The cycle is halved until a port is
//! proven open or closed throughout a stretch (`depth`), down to stretches of 1e-4 radians, 0.006°. The state
//! of such a short stretch follows from the area that is open in its middle. So nothing that lasts longer is
//! missed, be it an opening, a closure or a short circuit. The phase of a change is found by halving on.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Area};

use crate::Error;
use crate::contact::Conjugate;
use crate::modules::area;
use crate::ports::depth::Throughout;
use crate::ports::overlap::Region;
use crate::ports::{PortPlate, SIDES, of};
use crate::quantity::PortSide;
use crate::tolerance::{INSTANT, OPEN};
use epicyclic_numerics::extremes::golden;
use epicyclic_numerics::roots::bracketed;

/// Stretches of the cycle from which halving starts.
const STRETCHES: u32 = 16;

/// Stretches of rotation that are halved no more.
const SHORTEST: f64 = 1e-4;

/// Number of phases of the cycle in the search for the widest opening.
const PHASES: u32 = 120;

/// Steps of golden section between two of them.
const STEPS: u32 = 24;

/// A stretch of a chamber's cycle, by its phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Beginning of the stretch, from `−π/N − π/n` on.
    pub from: Angle,
    /// End of the stretch; beyond half a cycle if the stretch goes on through the least.
    pub to: Angle,
}

/// Extreme of a chamber's area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Extreme"))]
pub enum AtExtreme {
    /// The greatest area.
    Greatest,
    /// The least area.
    Least,
}

/// A stretch in which a chamber is closed to both pressures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closed {
    /// The stretch.
    pub stretch: Stretch,
    /// The extreme within it, if there is one.
    pub extreme: Option<AtExtreme>,
    /// The closed angle before the extreme and after it; of a stretch without one all of it is before.
    pub before: Angle,
    /// The closed angle after the extreme.
    pub after: Angle,
}

/// The widest opening of a chamber to a pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Widest {
    /// Area of the opening.
    pub area: Area,
    /// The phase of the chamber.
    pub phase: Angle,
}

/// The cycle of a chamber.
#[derive(Debug, Clone, PartialEq)]
pub struct Timing {
    /// Rotation of the rotor in which a chamber returns to the same state: `2π/N + 2π/n`.
    pub cycle: Angle,
    /// Stretches in which a chamber is open to the high pressure.
    pub high: Vec<Stretch>,
    /// Stretches in which a chamber is open to the low pressure.
    pub low: Vec<Stretch>,
    /// Stretches in which a chamber is open to both pressures: short circuits.
    pub short_circuits: Vec<Stretch>,
    /// Stretches in which a chamber is closed to both pressures.
    pub closed: Vec<Closed>,
    /// The widest openings to the high and to the low pressure.
    pub widest: [Widest; 2],
}

impl PortPlate {
    /// Opening and closing of a chamber over its cycle.
    ///
    /// # Errors
    /// [`Error::PortNeverOpens`], [`Error::PortNeverCloses`].
    pub fn timing(&self) -> Result<Timing, Error> {
        let cycle = 2.0 * self.motor.shape.trough().phase;
        let mut stretches = [vec![], vec![]];
        let mut widest = [(0.0, 0.0); 2];
        for side in SIDES {
            let (found, best) = self.open_stretches(side, cycle)?;
            stretches[of(side)] = found;
            widest[of(side)] = best;
        }
        let [high, low] = stretches;
        let (mut short_circuits, mut closed) = (vec![], vec![]);
        for (stretch, open) in states(&high, &low, cycle) {
            match open {
                [true, true] => short_circuits.push(stretch.quantity()),
                [false, false] => closed.push(stretch.closed(cycle)),
                _ => {}
            }
        }
        let [high, low] = [high, low].map(|all| all.into_iter().map(Span::quantity).collect());
        let widest = widest.map(|(value, phase)| Widest {
            area: area(value, self.motor.module()),
            phase: Angle::from_si(phase),
        });
        Ok(Timing { cycle: Angle::from_si(cycle), high, low, short_circuits, closed, widest })
    }

    /// Stretches in which a chamber is open to a pressure; the widest opening and its phase.
    fn open_stretches(&self, side: PortSide, cycle: f64) -> Result<(Vec<Span>, (f64, f64)), Error> {
        let least = OPEN * self.ports[of(side)].area();
        let is_open = |phase: f64| self.opening(side, phase) > least;
        let mut seen = vec![];
        for i in 0..STRETCHES {
            let [from, to] = [i, i + 1].map(|i| cycle * (f64::from(i) / f64::from(STRETCHES) - 0.5));
            self.look(side, [from, to], &is_open, &mut seen);
        }
        let count = seen.iter().filter(|(_, open)| *open).count();
        if count == 0 || count == seen.len() {
            return Err(self.never_changes(side, count == 0));
        }
        // Once more around from the first that is closed, so that every opening has its end.
        let first = seen.iter().position(|(_, open)| !open).unwrap_or(0);
        let around = seen[first..].iter().copied();
        let again = seen[..=first].iter().map(|&(phase, open)| (phase + cycle, open));
        let around: Vec<(f64, bool)> = around.chain(again).collect();
        let mut spans: Vec<Span> = vec![];
        let mut from = 0.0;
        for pair in around.windows(2).filter(|pair| pair[0].1 != pair[1].1) {
            let at = bracketed(pair[0].0, pair[1].0, |phase| if is_open(phase) { 1.0 } else { -1.0 });
            if pair[1].1 {
                from = at;
            } else {
                spans.push(Span { from, to: at }.within(cycle));
            }
        }
        Ok((spans, self.widest(side, cycle)))
    }

    /// Phases in their order, and whether a chamber is open to a pressure there: between two that are alike
    /// it does not change for longer than [`SHORTEST`].
    fn look(
        &self,
        side: PortSide,
        [from, to]: [f64; 2],
        is_open: &impl Fn(f64) -> bool,
        seen: &mut Vec<(f64, bool)>,
    ) {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        match self.throughout(side, middle, half) {
            Throughout::Unsure if 2.0 * half > SHORTEST => {
                self.look(side, [from, middle], is_open, seen);
                self.look(side, [middle, to], is_open, seen);
            }
            Throughout::Unsure => seen.push((middle, is_open(middle))),
            sure => seen.extend([from, to].map(|phase| (phase, sure == Throughout::Open))),
        }
    }

    /// State of the ports of a pressure towards a chamber for all phases that differ from one by no more than
    /// `half`.
    fn throughout(&self, side: PortSide, phase: f64, half: f64) -> Throughout {
        let region = Region::new(&self.motor, phase - 0.5 * self.motor.chamber_phase(), 0);
        let mut all = Throughout::Closed;
        for crest in 0..self.motor.numbers().stator_lobes() {
            match region.throughout(&self.port(side, crest), half) {
                Throughout::Open => return Throughout::Open,
                Throughout::Unsure => all = Throughout::Unsure,
                Throughout::Closed => {}
            }
        }
        all
    }

    /// The widest opening to a pressure and its phase.
    fn widest(&self, side: PortSide, cycle: f64) -> (f64, f64) {
        let step = cycle / f64::from(PHASES);
        let looked_at = (0..PHASES).map(|i| {
            let phase = cycle * ((f64::from(i) + 0.5) / f64::from(PHASES) - 0.5);
            (self.opening(side, phase), phase)
        });
        let best = looked_at.fold((0.0, 0.0), |best, next| if next.0 > best.0 { next } else { best });
        let (phase, less) = golden(best.1 - step, best.1 + step, STEPS, |phase| -self.opening(side, phase));
        if -less > best.0 { (-less, phase) } else { best }
    }

    fn never_changes(&self, side: PortSide, is_closed: bool) -> Error {
        let ideal = self.motor.ports();
        let port = match side {
            PortSide::High => ideal.high[0],
            PortSide::Low => ideal.low[0],
        };
        let (radius_mm, angle_deg) = (port.centre_radius.mm(), port.angle.degrees());
        if is_closed {
            Error::PortNeverOpens { side, radius_mm, angle_deg }
        } else {
            let most_mm = port.greatest_diameter.mm().max(0.0);
            Error::PortNeverCloses { side, most_mm, radius_mm, angle_deg }
        }
    }
}

/// A stretch in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    from: f64,
    to: f64,
}

impl Span {
    /// Returns the stretch moved by whole cycles to begin within half a cycle of the greatest.
    fn within(self, cycle: f64) -> Self {
        let by = cycle * (self.from / cycle + 0.5).floor();
        Self { from: self.from - by, to: self.to - by }
    }

    fn has(&self, phase: f64, cycle: f64) -> bool {
        (phase - self.from).rem_euclid(cycle) < self.to - self.from
    }

    fn quantity(self) -> Stretch {
        Stretch { from: Angle::from_si(self.from), to: Angle::from_si(self.to) }
    }

    fn closed(self, cycle: f64) -> Closed {
        let extremes = [
            (AtExtreme::Least, -0.5 * cycle),
            (AtExtreme::Greatest, 0.0),
            (AtExtreme::Least, 0.5 * cycle),
            (AtExtreme::Greatest, cycle),
        ];
        let within = extremes.into_iter().find(|(_, phase)| *phase >= self.from && *phase <= self.to);
        let (extreme, at) = within.map_or((None, self.to), |(extreme, phase)| (Some(extreme), phase));
        Closed {
            stretch: self.quantity(),
            extreme,
            before: Angle::from_si(at - self.from),
            after: Angle::from_si(self.to - at),
        }
    }
}

/// The stretches between all changes, joined where the state is the same, with whether each pressure is open.
fn states(high: &[Span], low: &[Span], cycle: f64) -> Vec<(Span, [bool; 2])> {
    let mut ends: Vec<f64> = high
        .iter()
        .chain(low)
        .flat_map(|span| [span.from, span.to])
        .map(|end| (end + 0.5 * cycle).rem_euclid(cycle) - 0.5 * cycle)
        .collect();
    ends.sort_by(f64::total_cmp);
    let Some(&first) = ends.first() else { return vec![] };
    ends.push(first + cycle);
    let mut states: Vec<(Span, [bool; 2])> = vec![];
    for pair in ends.windows(2) {
        if pair[1] - pair[0] < INSTANT {
            continue;
        }
        let middle = 0.5 * (pair[0] + pair[1]);
        let open = [high, low].map(|spans| spans.iter().any(|span| span.has(middle, cycle)));
        match states.last_mut() {
            Some((span, last)) if *last == open => span.to = pair[1],
            _ => states.push((Span { from: pair[0], to: pair[1] }, open)),
        }
    }
    // The first and the last may be one.
    if states.len() > 1 && states[0].1 == states[states.len() - 1].1 {
        let (span, _) = states.remove(0);
        if let Some((last, _)) = states.last_mut() {
            last.to = span.to + cycle;
        }
    }
    states
}

#[cfg(test)]
mod tests;
