//! When a chamber opens and closes over its cycle.
//!
//! All chambers go through the same cycle, so that one stands for all. Its openings are looked at for 360 phases of the cycle; where a state
//! changes between two, the phase of the change is found by halving. What opens and closes again within less than a step may be
//! missed.

use uom::si::f64::{Angle, Area};

use crate::Error;
use crate::contact::Conjugate;
use crate::ports::{PortPlate, SIDES, of};
use crate::quantity::PortSide;
use crate::roots::bracketed;
use crate::tolerance::{INSTANT, OPEN};
use crate::units::{angle, area, in_degrees, millimetres};

/// Phases of the cycle that are looked at.
const PHASES: u32 = 360;

/// A stretch of a chamber's cycle, by its phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Where it begins, from `−π/N − π/n` on.
    pub from: Angle,
    /// Where it ends; beyond half a cycle where the stretch goes on through the least.
    pub to: Angle,
}

/// Where a chamber is at an extreme.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AtExtreme {
    /// At its greatest.
    Greatest,
    /// At its least.
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
    /// Its area.
    pub area: Area,
    /// The phase of the chamber, one of those looked at.
    pub phase: Angle,
}

/// The cycle of a chamber.
#[derive(Debug, Clone, PartialEq)]
pub struct Timing {
    /// Rotation of the rotor in which a chamber comes to the same state: `2π/N + 2π/n`.
    pub cycle: Angle,
    /// Where a chamber is open to the high pressure.
    pub high: Vec<Stretch>,
    /// Where it is open to the low one.
    pub low: Vec<Stretch>,
    /// Where it is open to both: short circuits.
    pub short_circuits: Vec<Stretch>,
    /// Where it is closed to both.
    pub closed: Vec<Closed>,
    /// The widest openings to the high and to the low pressure.
    pub widest: [Widest; 2],
}

impl PortPlate {
    /// When a chamber opens and closes.
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
        let widest = widest
            .map(|(value, phase)| Widest { area: area(value, self.motor.module()), phase: angle(phase) });
        Ok(Timing { cycle: angle(cycle), high, low, short_circuits, closed, widest })
    }

    /// Where a chamber is open to a pressure; the widest opening and its phase.
    fn open_stretches(&self, side: PortSide, cycle: f64) -> Result<(Vec<Span>, (f64, f64)), Error> {
        let least = OPEN * self.ports[of(side)].area();
        let phase = |i: u32| cycle * ((f64::from(i) + 0.5) / f64::from(PHASES) - 0.5);
        let openings: Vec<f64> = (0..PHASES).map(|i| self.opening(side, phase(i))).collect();
        let is_open = |i: u32| openings[(i % PHASES) as usize] > least;
        let widest = (0..PHASES).fold((0.0, 0.0), |best: (f64, f64), i| {
            let opening = openings[i as usize];
            if opening > best.0 { (opening, phase(i)) } else { best }
        });
        let count = (0..PHASES).filter(|&i| is_open(i)).count();
        if count == 0 || count == PHASES as usize {
            let ideal = self.motor.ports();
            let port = match side {
                PortSide::High => ideal.high[0],
                PortSide::Low => ideal.low[0],
            };
            let (radius_mm, angle_deg) = (millimetres(port.centre_radius), in_degrees(port.angle));
            return Err(if count == 0 {
                Error::PortNeverOpens { side, radius_mm, angle_deg }
            } else {
                let most_mm = millimetres(port.greatest_diameter).max(0.0);
                Error::PortNeverCloses { side, most_mm, radius_mm, angle_deg }
            });
        }
        let change = |i: u32| {
            let step = |phase: f64| if self.opening(side, phase) > least { 1.0 } else { -1.0 };
            bracketed(phase(i), phase(i) + cycle / f64::from(PHASES), step)
        };
        let opens = (0..PHASES).filter(|&i| !is_open(i) && is_open(i + 1));
        let spans = opens.map(|i| {
            let closes = (i + 1..).find(|&j| !is_open(j + 1)).unwrap_or(i + 1);
            let from = change(i);
            let to = change(closes % PHASES) + if closes >= PHASES { cycle } else { 0.0 };
            Span { from, to }.within(cycle)
        });
        Ok((spans.collect(), widest))
    }
}

/// A stretch in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    from: f64,
    to: f64,
}

impl Span {
    /// The same beginning within half a cycle of the greatest.
    fn within(self, cycle: f64) -> Self {
        let by = cycle * (self.from / cycle + 0.5).floor();
        Self { from: self.from - by, to: self.to - by }
    }

    fn has(&self, phase: f64, cycle: f64) -> bool {
        (phase - self.from).rem_euclid(cycle) < self.to - self.from
    }

    fn quantity(self) -> Stretch {
        Stretch { from: angle(self.from), to: angle(self.to) }
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
            before: angle(at - self.from),
            after: angle(self.to - at),
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
