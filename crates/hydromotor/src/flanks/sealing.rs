//! Sealing of the flanks: the volume that the chambers take with the seals there, flow and ripple.
//!
//! # The swept area
//! The line that parts two chambers runs between the two contacts of a satellite: `K₃` with the stator and
//! `K₁` with the rotor. `e₃` and `e₁` are their distances from the pitch points along the lines of action.
//! Two parts of area pass the line per radian of the rotor. One is the rotor's sector under `K₁`, the other
//! is swept by the satellite between, which turns about `P` at `ρ₁/c` of the rotor's speed:
//!
//! ```text
//! f′ = ½·|OK₁|² + ½·(ρ₁/c)·(|PK₁|² − |PK₃|²)
//!    = ½·ρ₁·ρ₃ + (ρ₃·e₁² − ρ₁·e₃²)/(2·c)        c = ρ₃ − ρ₁ = 2·r·cos μ
//! ```
//!
//! The direction of the lines of action drops out, since `|OK₁|² = ρ₁² + 2·ρ₁·e₁·cos ψ + e₁²` and
//! `|PK₁|² = c² − 2·c·e₁·cos ψ + e₁²`.
//!
//! # The contacts
//! A satellite pushed forward presses on the stator's flanks at the front of the spaces and on the rotor's at
//! their back; pushed back the other way round. Front and back are seen along the tracks
//! ([`crate::profile`]). The contact on a flank that cuts the centrode at `s₀` is at `e = ±(s − s₀)·cos α`.
//! `s₀` is half a space, `π/4 + x·tan α + ½·(1 − q)·j` modules, from the middle of its space, for even and
//! odd `Z_s`. For `x = j = 0` that is `e = ±(s − s_c)·cos α − p_b/4`.
//!
//! Of two contacts in mesh one is assumed to seal; [`SealingContact`] chooses it. Where the next contact
//! takes over, `f′` has a kink if both are at `p_b/2`, and jumps if they are not. The satellite is assumed to
//! be in the middle of its backlash, which moves a contact by less than half of it.
//!
//! # Flow
//! `Q′ = b·Σ σ·f′` over the loaded satellites. It is smooth between changeovers of chambers, where it jumps,
//! passages of junctions, and changes of the sealing contacts, all at known phases. On each smooth piece the
//! extremes are ends, taken from within, or zeros of `dQ′/dφ` in closed form. So the result depends on
//! samples only through the number of zeros on a piece, which is divided into four parts. A zero is searched
//! for only where the tangents at both ends of its part reach beyond the extremes known so far.
//!
//! The mean of `f′ − f` over a pitch is `p_b²/24` for every satellite, since the mean of `e²` is `p_b²/12`:
//! it drops out of the displacement but for the change of the radii within a pitch.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Area, Length};

use super::kernel::{arc, windings};
use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::flow::Ripple;
use crate::modules::area;
use crate::motor::Motor;
use crate::profile::{Profile, Side};
use crate::quantity::Quantity;
use crate::ranges::{finite_angle, finite_modules};
use crate::tolerance::{BESIDE_JUMP, WITHIN};
use epicyclic_numerics::roots::bracketed;
use std::f64::consts::PI;

/// Parts of a smooth piece; zeros of the slope are searched for between their ends.
const PARTS: u32 = 4;

/// Weights of the values at the parts' ends in the integral over a piece (Boole), exact up to the fifth
/// power.
const BOOLE: [f64; 5] = [7.0 / 90.0, 32.0 / 90.0, 12.0 / 90.0, 32.0 / 90.0, 7.0 / 90.0];

/// Rule that chooses the sealing contact of two in mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum SealingContact {
    /// The one nearest to the pitch point, `|e| ≤ p_b/2`, even where the flank ends before.
    #[default]
    Nearest,
    /// The nearest of those whose flanks reach there: another takes over where a flank ends before `p_b/2`.
    NearestInMesh,
}

/// Flow over width a radian of the rotor at the flanks, and its ripple.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlankRipple {
    /// Least, greatest, mean and ripple at the flanks.
    pub at_flanks: Ripple,
    /// Least, greatest, mean and ripple at the pitch points.
    pub at_pitch_points: Ripple,
    /// Least over mean at the flanks: the part of the mean torque that remains at the worst angle.
    pub least_over_mean: f64,
    /// Rotation of the rotor with the least flow, within the first period.
    pub least_at: Angle,
    /// Rotation of the rotor with the greatest flow, within the first period.
    pub greatest_at: Angle,
}

/// A contact on a flank that seals between two arc lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seal {
    /// `±1`: at the front or at the back of its space along the track.
    pub(super) sign: f64,
    /// `s₀`.
    pub(super) pitch: f64,
}

impl Seal {
    /// `e` at an arc length.
    pub(super) fn offset(&self, s: f64, cos: f64) -> f64 {
        self.sign * (s - self.pitch) * cos
    }
}

/// The flanks of a wheel that carry a push, and where each begins to seal.
struct Row {
    side: Side,
    sign: f64,
    lobe: f64,
    /// Arc length where the flank's turn begins, and its `s₀`; in order, over a lobe.
    turns: Vec<(f64, f64)>,
}

impl Row {
    fn new(profile: &Profile, side: Side, sigma: f64, rule: SealingContact) -> Self {
        let sign = side.carrying(sigma);
        let cos = profile.teeth().cos;
        let lobe = profile.lobe_length(side);
        let paths = profile.paths(side, sign);
        let turn = |i: usize| {
            let (here, shift) = (paths[i], if i == 0 { lobe } else { 0.0 });
            let before = paths[(i + paths.len() - 1) % paths.len()];
            let middle = here.pitch - 0.5 * PI;
            let start = match rule {
                SealingContact::Nearest => middle,
                SealingContact::NearestInMesh => {
                    // Arc lengths at which this flank begins and the one before ends its path.
                    let (enters, leaves) = (here.arcs(sign, cos)[0], before.arcs(sign, cos)[1] - shift);
                    if enters <= leaves { middle.clamp(enters, leaves) } else { middle }
                }
            };
            (start, here.pitch)
        };
        Self { side, sign, lobe, turns: (0..paths.len()).map(turn).collect() }
    }

    /// The contact that seals at an arc length.
    fn at(&self, s: f64) -> Seal {
        let first = self.turns[0].0;
        let lobes = ((s - first) / self.lobe).floor();
        let rest = s - lobes * self.lobe;
        let found = self.turns.partition_point(|turn| turn.0 <= rest).max(1) - 1;
        Seal { sign: self.sign, pitch: self.turns[found].1 + lobes * self.lobe }
    }

    /// Places between two contacts at which the sealing contact changes, by a quantity.
    fn changes(&self, motor: &Motor, by: By, ends: &[Contact; 2]) -> Vec<f64> {
        self.places(motor, by, ends, |turn| turn.0)
    }

    /// Places between two contacts at which the sealing contact passes the pitch point, by a quantity.
    fn passages(&self, motor: &Motor, by: By, ends: &[Contact; 2]) -> Vec<f64> {
        self.places(motor, by, ends, |turn| turn.1)
    }

    fn places(&self, motor: &Motor, by: By, ends: &[Contact; 2], of: fn(&(f64, f64)) -> f64) -> Vec<f64> {
        let own = arc(self.side);
        let [from, to] = [0, 1].map(|i| ends[i].get(own));
        let places = self.turns.iter().flat_map(|turn| windings(of(turn), self.lobe, [from, to]));
        let at = |s: f64| if by == own { s } else { motor.shape.at(own, s).get(by) };
        places.map(at).collect()
    }
}

/// The rows of both wheels for a push.
pub(super) struct Rows {
    rows: [Row; 2],
    cos: f64,
}

impl Rows {
    pub(super) fn new(profile: &Profile, sigma: f64, rule: SealingContact) -> Self {
        let rows = Side::BOTH.map(|side| Row::new(profile, side, sigma, rule));
        Self { rows, cos: profile.teeth().cos }
    }

    /// The contacts that seal on stator and rotor.
    pub(super) fn at(&self, contact: &Contact) -> [Seal; 2] {
        [self.rows[0].at(contact.s3), self.rows[1].at(contact.s1)]
    }

    /// `e₃` and `e₁`.
    pub(super) fn offsets(&self, seals: &[Seal; 2], contact: &Contact) -> [f64; 2] {
        [seals[0].offset(contact.s3, self.cos), seals[1].offset(contact.s1, self.cos)]
    }

    /// Ends of the smooth pieces of a range of phases, by a quantity.
    pub(super) fn pieces(&self, motor: &Motor, by: By, range: [f64; 2]) -> Vec<f64> {
        let ends = range.map(|phase| motor.shape.at(By::Phase, phase));
        let changes = self.rows.iter().flat_map(|row| row.changes(motor, by, &ends));
        let range = [0, 1].map(|i| ends[i].get(by));
        motor.smooth_ends_by(by, range, changes.collect::<Vec<_>>())
    }
}

/// `f′` with contacts at offsets.
pub(super) fn sealed(contact: &Contact, [e3, e1]: [f64; 2]) -> f64 {
    let Contact { rho3, rho1, .. } = *contact;
    contact.flow() + (rho3 * e1 * e1 - rho1 * e3 * e3) / (2.0 * (rho3 - rho1))
}

/// `df′/dΦ`, as the contacts run along their flanks by `rates` a unit of arc length.
fn sealed_slope(contact: &Contact, r: f64, [e3, e1]: [f64; 2], rates: [f64; 2]) -> f64 {
    let Contact { rho3, rho1, kappa3, mu, .. } = *contact;
    let (sin, cos) = libm::sincos(mu);
    // ds₃/dΦ and ds₁/ds₃, as in `Contact::slope`.
    let ds3 = rho1 / (2.0 * cos * (1.0 - r * kappa3));
    let stretch = 1.0 + 2.0 * r * (cos / rho3 - kappa3);
    let ds1 = stretch * ds3;
    let c = rho3 - rho1;
    let (by_rho3, by_rho1) = (sin * ds3, sin * ds1);
    let product = rho3 * e1 * e1 - rho1 * e3 * e3;
    let by_product = by_rho3 * e1 * e1 + 2.0 * rho3 * e1 * rates[1] * ds1
        - by_rho1 * e3 * e3
        - 2.0 * rho1 * e3 * rates[0] * ds3;
    let flow_slope = 0.5 * sin * (rho3 * stretch + rho1) * ds3;
    flow_slope + (by_product - product * (by_rho3 - by_rho1) / c) / (2.0 * c)
}

/// The flow on a smooth piece: every loaded satellite with its contacts.
pub(super) struct Piece<'a> {
    motor: &'a Motor,
    cos: f64,
    pub(super) times: f64,
    loaded: Vec<(u32, f64, [Seal; 2])>,
}

/// Contacts of the satellites at a rotation, as far as they have been asked for.
type Known = Vec<Option<Contact>>;

impl Piece<'_> {
    /// Every loaded satellite at a rotation: its contact, the sign of its push, and `e₃` and `e₁`.
    pub(super) fn contacts(&self, rotation: f64) -> impl Iterator<Item = (Contact, f64, [f64; 2])> + '_ {
        self.loaded.iter().map(move |&(j, sigma, seals)| {
            let contact = self.motor.shape.at(By::Phase, self.motor.phase(rotation, j));
            let offsets = [seals[0].offset(contact.s3, self.cos), seals[1].offset(contact.s1, self.cos)];
            (contact, sigma, offsets)
        })
    }

    /// `Q′/b` and its slope.
    fn at(&self, rotation: f64) -> (f64, f64) {
        self.with(|j| (self.motor.shape.at(By::Phase, self.motor.phase(rotation, j)), None))
    }

    /// `Q′/b` and its slope, with contacts that the choice of the seals knows already.
    fn known(&self, rotation: f64, known: &mut Known) -> (f64, f64) {
        self.with(|j| (*contact_of(self.motor, known, rotation, j), None))
    }

    /// `Q′/b` and its slope at an end, with contacts that the neighbouring piece may know already. Quantities
    /// that jump there are taken at the place `within`.
    fn at_end(&self, end: f64, within: f64, known: &mut Known) -> (f64, f64) {
        self.with(|j| {
            let motor = self.motor;
            let jumps = motor.is_kink(motor.phase(end, j));
            let inner = jumps.then(|| motor.shape.at(By::Phase, motor.phase(within, j)));
            (*contact_of(motor, known, end, j), inner)
        })
    }

    /// `Q′/b` and its slope with the given contact of each satellite, and another for its curvatures.
    fn with(&self, mut contact: impl FnMut(u32) -> (Contact, Option<Contact>)) -> (f64, f64) {
        let r = self.motor.shape.satellite_radius();
        let (mut flow, mut slope) = (0.0, 0.0);
        for &(j, sigma, seals) in &self.loaded {
            let (contact, inner) = contact(j);
            let offsets = [seals[0].offset(contact.s3, self.cos), seals[1].offset(contact.s1, self.cos)];
            let rates = seals.map(|seal| seal.sign * self.cos);
            flow += sigma * sealed(&contact, offsets);
            slope += sigma * sealed_slope(&inner.unwrap_or(contact), r, offsets, rates);
        }
        (self.times * flow, self.times * slope)
    }
}

/// The contact of a satellite at a rotation.
fn contact_of<'a>(motor: &Motor, known: &'a mut Known, rotation: f64, j: u32) -> &'a Contact {
    known[j as usize].get_or_insert_with(|| motor.shape.at(By::Phase, motor.phase(rotation, j)))
}

/// The flow of a profile piece by piece.
pub(super) struct Flow<'a> {
    profile: &'a Profile,
    /// Rows of both wheels, for satellites by a crest and by a trough.
    rows: [Rows; 2],
    ends: Vec<f64>,
}

impl<'a> Flow<'a> {
    pub(super) fn new(profile: &'a Profile, rule: SealingContact) -> Self {
        let motor = profile.motor();
        let rows = [1.0, -1.0].map(|sigma| Rows::new(profile, sigma, rule));
        let period = motor.period();
        let mut ends = vec![0.0, 0.5 * period, period];
        for (rows, crest) in rows.iter().zip([true, false]) {
            let places = rows.pieces(motor, By::Phase, motor.loaded(crest));
            ends.extend(places.iter().map(|phase| phase.rem_euclid(period)));
        }
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|late, early| *late - *early < WITHIN * period);
        Self { profile, rows, ends }
    }

    /// The pieces of a period between all changes and all passages of the pitch points by contacts that seal.
    pub(super) fn pieces_of_arms(&self) -> Vec<([f64; 2], Piece<'a>)> {
        let motor = self.profile.motor();
        let period = motor.period();
        let mut ends = self.ends.clone();
        for (rows, crest) in self.rows.iter().zip([true, false]) {
            let range = motor.loaded(crest);
            let contacts = range.map(|phase| motor.shape.at(By::Phase, phase));
            let passages = rows.rows.iter().flat_map(|row| row.passages(motor, By::Phase, &contacts));
            ends.extend(passages.map(|phase| phase.rem_euclid(period)));
        }
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|late, early| *late - *early < WITHIN * period);
        let piece = |pair: &[f64]| {
            let mut known = vec![None; self.satellites() as usize];
            ([pair[0], pair[1]], self.piece(0.5 * (pair[0] + pair[1]), &mut known))
        };
        ends.windows(2).map(piece).collect()
    }

    /// Satellites among which the pressures do not repeat.
    fn satellites(&self) -> u32 {
        let numbers = self.profile.motor().numbers();
        numbers.satellites() / numbers.common_divisor()
    }

    /// The piece about a rotation, at which no chamber changes over and no contact changes.
    fn piece(&self, rotation: f64, known: &mut Known) -> Piece<'a> {
        let motor = self.profile.motor();
        let loaded = (0..self.satellites()).filter_map(|j| {
            let sigma = motor.pushed(motor.phase(rotation, j), 1.0)?;
            let rows = &self.rows[usize::from(sigma < 0.0)];
            Some((j, sigma, rows.at(contact_of(motor, known, rotation, j))))
        });
        let loaded = loaded.collect();
        let times = f64::from(motor.numbers().common_divisor());
        Piece { motor, cos: self.profile.teeth().cos, times, loaded }
    }

    /// `Q′/b` at any rotation; where it jumps, the value behind the jump.
    fn at(&self, rotation: f64) -> f64 {
        let period = self.profile.motor().period();
        let rest = rotation.rem_euclid(period);
        let last = self.ends.len() - 2;
        let piece = (self.ends.partition_point(|&end| end <= rest).max(1) - 1).min(last);
        let mut known = vec![None; self.satellites() as usize];
        self.piece(0.5 * (self.ends[piece] + self.ends[piece + 1]), &mut known).at(rest).0
    }

    /// Least and greatest value with their places, and the integral, over a period.
    fn extremes(&self) -> Extremes {
        let mut found =
            Extremes { least: (f64::INFINITY, 0.0), greatest: (f64::NEG_INFINITY, 0.0), volume: 0.0 };
        let (mut pieces, mut flat) = (Vec::with_capacity(self.ends.len()), Vec::new());
        let nothing: Known = vec![None; self.satellites() as usize];
        let (mut at_end, mut middle) = (nothing.clone(), nothing.clone());
        for pair in self.ends.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(PARTS);
            let hair = BESIDE_JUMP * (to - from);
            let within = |i: u32| place(i).clamp(from + hair, to - hair);
            middle.fill(None);
            let piece = self.piece(place(PARTS / 2), &mut middle);
            let mut before = piece.at_end(from, within(0), &mut at_end);
            found.meet(from, before.0);
            let mut integral = BOOLE[0] * before.0;
            for i in 1..=PARTS {
                let here = if i == PARTS / 2 {
                    piece.known(place(i), &mut middle)
                } else if i == PARTS {
                    at_end.fill(None);
                    piece.at_end(to, within(PARTS), &mut at_end)
                } else {
                    piece.at(place(i))
                };
                found.meet(place(i), here.0);
                integral += BOOLE[i as usize] * here.0;
                if before.1 * here.1 < 0.0 {
                    flat.push((pieces.len(), [within(i - 1), within(i)], [before, here]));
                }
                before = here;
            }
            pieces.push(piece);
            found.volume += (to - from) * integral;
        }
        for (piece, [from, to], [before, here]) in flat {
            let piece: &Piece<'_> = &pieces[piece];
            // As far as the tangents at both ends reach across: an extreme between them lies within.
            let reach = [before.0 + before.1 * (to - from), here.0 - here.1 * (to - from)];
            let can = if before.1 > 0.0 {
                reach[0].max(reach[1]) > found.greatest.0
            } else {
                reach[0].min(reach[1]) < found.least.0
            };
            if can {
                let place = bracketed(from, to, |place| piece.at(place).1);
                found.meet(place, piece.at(place).0);
            }
        }
        found
    }
}

/// Least and greatest flow with their rotations, and the volume of a period.
pub(super) struct Extremes {
    pub(super) least: (f64, f64),
    pub(super) greatest: (f64, f64),
    pub(super) volume: f64,
}

impl Extremes {
    pub(super) fn meet(&mut self, place: f64, value: f64) {
        if value < self.least.0 {
            self.least = (value, place);
        }
        if value > self.greatest.0 {
            self.greatest = (value, place);
        }
    }
}

impl Motor {
    /// Area that a satellite sweeps per radian of the rotor, `f′`, with contacts at `e₃` and `e₁` along the
    /// lines of action from the pitch points. Both are positive towards the satellite's base circle;
    /// `rotation` counts from the place of the satellite between two crests.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{angle::radian, area::square_millimeter, f64::{Angle, Length}, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(1.0), mm(40.0))?;
    /// let swept = |e3, e1| motor.sealed_sweep(Angle::new::<radian>(0.3), mm(e3), mm(e1));
    /// let change = swept(0.8, 0.3)? - swept(0.0, 0.0)?;
    /// assert!((change.get::<square_millimeter>() + 0.603780).abs() < 1e-6);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn sealed_sweep(
        &self,
        rotation: Angle,
        stator_offset: Length,
        rotor_offset: Length,
    ) -> Result<Area, Error> {
        let contact = self.shape.at(By::Phase, finite_angle(Quantity::Rotation, rotation)?);
        let e3 = finite_modules(Quantity::StatorOffset, stator_offset, self.module())?;
        let e1 = finite_modules(Quantity::RotorOffset, rotor_offset, self.module())?;
        Ok(area(sealed(&contact, [e3, e1]), self.module()))
    }
}

impl Profile {
    /// Flow over width a radian of the rotor with the flanks as seals, for a pressure that drives the rotor
    /// counter-clockwise; the other way it is that at the opposite rotation. Where it jumps, the value behind
    /// the jump.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn flank_flow_per_width(&self, rule: SealingContact, rotation: Angle) -> Result<Area, Error> {
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let flow = Flow::new(self, rule);
        Ok(area(flow.at(rotation), self.motor().module()))
    }

    /// Flow over width at the flanks at many rotations, as
    /// [`flank_flow_per_width`](Self::flank_flow_per_width) at each.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn flank_flows_per_width(
        &self,
        rule: SealingContact,
        rotations: &[Angle],
    ) -> Result<Vec<Area>, Error> {
        let flow = Flow::new(self, rule);
        let at = |&rotation: &Angle| {
            let rotation = finite_angle(Quantity::Rotation, rotation)?;
            Ok(area(flow.at(rotation), self.motor().module()))
        };
        rotations.iter().map(at).collect()
    }

    /// Rotations within a period `2π/lcm(N, n)` at which the flow at the flanks has a kink or jumps, both
    /// ends of the period included.
    #[must_use]
    pub fn flank_changes(&self, rule: SealingContact) -> Vec<Angle> {
        Flow::new(self, rule).ends.into_iter().map(Angle::from_si).collect()
    }

    /// The ripple of flow and torque with the flanks as seals, beside that at the pitch points.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::flanks::SealingContact;
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(1.0), mm(40.0))?;
    /// let ripple = Profile::new(&motor, ToothForm::default())?.flank_ripple(SealingContact::Nearest);
    /// assert!(ripple.at_flanks.delta > ripple.at_pitch_points.delta);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn flank_ripple(&self, rule: SealingContact) -> FlankRipple {
        let Extremes { least, greatest, volume } = Flow::new(self, rule).extremes();
        let motor = self.motor();
        let mean = volume / motor.period();
        let of = |value| area(value, motor.module());
        FlankRipple {
            at_flanks: Ripple {
                least: of(least.0),
                greatest: of(greatest.0),
                mean: of(mean),
                delta: (greatest.0 - least.0) / mean,
            },
            at_pitch_points: motor.ripple(),
            least_over_mean: least.0 / mean,
            least_at: Angle::from_si(least.1),
            greatest_at: Angle::from_si(greatest.1),
        }
    }
}

#[cfg(test)]
pub(super) mod tests;
