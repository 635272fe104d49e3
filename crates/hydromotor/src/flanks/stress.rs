//! Pressure of Hertz at the contacts of the flanks.
//!
//! Along the line of action the satellite's involute has the radius of curvature `r·sin α − e`, and the
//! wheel's flank `sin α/κ + e`. Per unit of arc length the flank's normal turns by `κ` as its point moves on
//! by `sin α + κ·e` (the envelope in [`crate::profile`]). `κ` is the wheel's curvature there, positive where
//! it bulges towards the satellite:
//!
//! ```text
//! 1/ρ_rel = 1/(r·sin α − e) + κ/(sin α + κ·e)        p_H² = N·E*/(π·b·ρ_rel)
//! 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂
//! ```
//!
//! `N` is that of contacts at the pitch points, on one pair of flanks alone. With
//! `N = Δp·b·r·cos μ/cos(α + σ·μ)` width and module drop out: `p_H²/(Δp·E*)` depends on the shape alone. At
//! the pitch point and `μ = 0` it is `(2/sin 2α)·(1 + r·κ)/π`.
//!
//! # The path
//! A flank meets the satellite from `e₋` to `e₊` ([`crate::profile`]): from the satellite's tip, or the
//! beginning of its own flank, to its tip, or the beginning of the satellite's involute. Where the next flank
//! is in mesh too, two pairs share the load; their shares are not calculated. Values on the whole path, each
//! with the whole load, are bounds for rigid teeth; the load in single contact is not shared.
//!
//! # Left out
//! Friction, lubrication, edges of tips, the third contact, dynamic loads. The values are reported; they
//! certify nothing.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length, Pressure};

use super::forces::Push;
use super::kernel::{arc, flank_number, greatest_of, pressure_angle, windings};
use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::motor::Motor;
use crate::profile::{FlankPath, Profile, Side};
use crate::quantity::Quantity;
use crate::ranges::{finite_angle, finite_modules, positive_pressure};
use crate::tolerance::{BESIDE_JUMP, WITHIN};
use std::f64::consts::PI;

/// A mesh of a satellite.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mesh {
    /// Mesh with the stator.
    Stator,
    /// Mesh with the rotor.
    Rotor,
}

impl Mesh {
    /// Meshes of a satellite, that with the stator first.
    pub const BOTH: [Self; 2] = [Self::Stator, Self::Rotor];

    pub(super) fn side(self) -> Side {
        match self {
            Self::Stator => Side::Stator,
            Self::Rotor => Side::Rotor,
        }
    }
}

/// Part of the path of contact for a stress, with the whole load on one pair of flanks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LoadedPath {
    /// The whole path: a bound for rigid teeth, whichever pair carries.
    #[default]
    Whole,
    /// Places with one pair alone in mesh, and the pitch point: no load is shared there.
    SingleContact,
}

/// The greatest pressure of Hertz of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakPressure {
    /// The pressure; infinite where a path reaches a cusp.
    pub pressure: Pressure,
    /// Rotation of the rotor at which satellite 0 has it.
    pub rotation: Angle,
    /// `e`, from the pitch point along the line of action, positive towards the satellite's base circle.
    pub offset: Length,
}

/// The pressures of Hertz of the satellites that are pushed one way in one mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStress {
    /// The mesh.
    pub mesh: Mesh,
    /// Direction in which the satellites are pushed.
    pub push: Push,
    /// The greatest with the contact at the pitch point, at any angle.
    pub at_pitch_point: PeakPressure,
    /// The greatest with one pair alone in mesh; `None` if always two are.
    pub in_single_contact: Option<PeakPressure>,
    /// The greatest on the whole path with the whole load on one pair; `None` if no flank of a loaded
    /// satellite has a path.
    pub on_path: Option<PeakPressure>,
}

/// `p_H²/(Δp·E*)` at an offset.
pub(super) fn severity(
    side: Side,
    r: f64,
    alpha: f64,
    contact: &Contact,
    sigma: f64,
    e: f64,
) -> Result<f64, Error> {
    let number = flank_number(r, alpha, contact, sigma)?;
    let bulge = match side {
        Side::Stator => -contact.kappa3,
        Side::Rotor => contact.kappa1,
    };
    let (own, wheel) = (r * libm::sin(alpha) - e, libm::sin(alpha) + bulge * e);
    if own <= 0.0 || wheel <= 0.0 {
        return Ok(f64::INFINITY);
    }
    Ok((number * (1.0 / own + bulge / wheel) / PI).max(0.0))
}

/// Computes [`severity`] of one mesh and push at many places, if all hold the satellite; NaN elsewhere.
struct Severity {
    side: Side,
    r: f64,
    sigma: f64,
    /// Sine of the pressure angle.
    sin: f64,
    cos: f64,
}

impl Severity {
    fn new(side: Side, r: f64, alpha: f64, sigma: f64) -> Self {
        let (sin, cos) = libm::sincos(alpha);
        Self { side, r, sigma, sin, cos }
    }

    fn of(&self, contact: &Contact, e: f64) -> f64 {
        let (mu_sin, mu_cos) = libm::sincos(contact.mu);
        let carrying = self.cos * mu_cos - self.sigma * self.sin * mu_sin;
        if carrying <= WITHIN {
            return f64::NAN;
        }
        let bulge = match self.side {
            Side::Stator => -contact.kappa3,
            Side::Rotor => contact.kappa1,
        };
        let (own, wheel) = (self.r * self.sin - e, self.sin + bulge * e);
        if own <= 0.0 || wheel <= 0.0 {
            return f64::INFINITY;
        }
        (self.r * mu_cos / carrying * (1.0 / own + bulge / wheel) / PI).max(0.0)
    }
}

/// Places by the explicit quantity of a shape, found from the arc length. Each is found once, since stretches
/// share their ends.
pub(super) struct Places<'a> {
    motor: &'a Motor,
    arc: By,
    known: Vec<(f64, f64)>,
}

impl<'a> Places<'a> {
    pub(super) fn new(motor: &'a Motor, arc: By) -> Self {
        Self { motor, arc, known: Vec::new() }
    }

    pub(super) fn of(&mut self, s: f64) -> f64 {
        let by = self.motor.shape.explicit();
        if by == self.arc {
            return s;
        }
        if let Some(&(_, place)) = self.known.iter().find(|known| known.0 == s) {
            return place;
        }
        let place = self.motor.shape.at(self.arc, s).get(by);
        self.known.push((s, place));
        place
    }
}

/// A place of the greatest severity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Peak {
    pub(super) severity: f64,
    pub(super) phase: f64,
    pub(super) offset: f64,
}

/// One flank while it carries: its path and the arc lengths of contact, whole and alone.
pub(super) struct Stretch {
    pub(super) sign: f64,
    pub(super) pitch: f64,
    pub(super) whole: [f64; 2],
    pub(super) alone: [f64; 2],
}

/// The parts of stretches on a path between the corners of a load, by the quantity in which the shape is
/// explicit, each with its stretch.
pub(super) fn parted<'s>(
    stretches: &'s [Stretch],
    path: LoadedPath,
    corners: &[Contact],
    places: &mut Places<'_>,
) -> (Vec<[f64; 2]>, Vec<&'s Stretch>) {
    let by = places.motor.shape.explicit();
    let (mut pieces, mut flanks) = (Vec::new(), Vec::new());
    for stretch in stretches {
        let [from, to] = stretch.on(path);
        if from >= to {
            continue;
        }
        let [from, to] = [from, to].map(|s| places.of(s));
        let mut start = from;
        for corner in corners.iter().map(|contact| contact.get(by)) {
            if corner > start && corner < to {
                pieces.push([start, corner]);
                start = corner;
            }
        }
        pieces.push([start, to]);
        flanks.resize(pieces.len(), stretch);
    }
    (pieces, flanks)
}

impl Stretch {
    pub(super) fn on(&self, path: LoadedPath) -> [f64; 2] {
        match path {
            LoadedPath::Whole => self.whole,
            LoadedPath::SingleContact => self.alone,
        }
    }

    /// `e` at an arc length.
    pub(super) fn offset(&self, s: f64, cos: f64) -> f64 {
        self.sign * (s - self.pitch) * cos
    }
}

impl Motor {
    /// Contacts of a satellite by a crest, or by a trough, at the ends of its loaded range, where its load
    /// has corners, and in the middle.
    pub(super) fn corners(&self, crest: bool) -> Vec<Contact> {
        let phases = self.smooth_ends(self.loaded(crest), [0.0, self.shape.trough().phase]);
        phases.into_iter().map(|phase| self.shape.at(By::Phase, phase)).collect()
    }
}

impl Profile {
    /// The stretches of all flanks of a wheel that carry satellites pushed by `sigma`, by a crest or by a
    /// trough.
    pub(super) fn stretches(&self, side: Side, sigma: f64, crest: bool) -> Vec<Stretch> {
        let sign = side.carrying(sigma);
        let (cos, lobe, motor) = (self.teeth().cos, self.lobe_length(side), self.motor());
        let arc = arc(side);
        let [from, to] = motor.loaded(crest).map(|phase| motor.shape.at(By::Phase, phase).get(arc));
        let paths = self.paths(side, sign);
        let ends = |path: &FlankPath| path.arcs(sign, cos);
        let count = paths.len();
        let mut stretches = Vec::new();
        for (i, path) in paths.iter().enumerate() {
            let whole = ends(path);
            let before = ends(&paths[(i + count - 1) % count])[1] - if i == 0 { lobe } else { 0.0 };
            let after = ends(&paths[(i + 1) % count])[0] + if i + 1 == count { lobe } else { 0.0 };
            let alone = [whole[0].max(before), whole[1].min(after)];
            // The flank of every lobe whose path reaches into the range.
            for place in
                windings(path.pitch, lobe, [from + path.pitch - whole[1], to + path.pitch - whole[0]])
            {
                let shift = place - path.pitch;
                let within = |[a, b]: [f64; 2]| [(a + shift).max(from), (b + shift).min(to)];
                stretches.push(Stretch { sign, pitch: place, whole: within(whole), alone: within(alone) });
            }
        }
        stretches
    }

    /// The worst at the pitch point, in single contact and on the whole path, of the satellites by a crest or
    /// by a trough.
    pub(super) fn peaks(&self, side: Side, sigma: f64, crest: bool) -> Result<[Option<Peak>; 3], Error> {
        let motor = self.motor();
        let (alpha, r) = (pressure_angle(self.form().pressure_angle)?, motor.shape.satellite_radius());
        let (arc, by) = (arc(side), motor.shape.explicit());
        let range = motor.loaded(crest);
        let ends = motor.corners(crest);
        // Refuses a motor that no flank holds before anything is compared.
        for contact in &ends {
            flank_number(r, alpha, contact, sigma)?;
        }
        for phase in motor.steepest().into_iter().flat_map(|place| [place, -place]) {
            if (range[0]..=range[1]).contains(&phase) {
                flank_number(r, alpha, &motor.shape.at(By::Phase, phase), sigma)?;
            }
        }
        let at = Severity::new(side, r, alpha, sigma);
        let phase_of = |place: f64| motor.shape.at(by, place).phase.clamp(range[0], range[1]);
        let mut best = [None; 3];
        let pieces: Vec<[f64; 2]> = ends.windows(2).map(|pair| [0, 1].map(|i| pair[i].get(by))).collect();
        let [top] = greatest_of(&pieces, BESIDE_JUMP, |_, place| [at.of(&motor.shape.at(by, place), 0.0)]);
        best[0] = Some(Peak { severity: top.value, phase: phase_of(top.place), offset: 0.0 });
        let stretches = self.stretches(side, sigma, crest);
        let mut places = Places::new(motor, arc);
        for (slot, path) in [(1, LoadedPath::SingleContact), (2, LoadedPath::Whole)] {
            let (pieces, flanks) = parted(&stretches, path, &ends, &mut places);
            if pieces.is_empty() {
                continue;
            }
            let offset =
                |piece: usize, contact: &Contact| flanks[piece].offset(contact.get(arc), self.teeth().cos);
            let [top] = greatest_of(&pieces, BESIDE_JUMP, |piece, place| {
                let contact = motor.shape.at(by, place);
                [at.of(&contact, offset(piece, &contact))]
            });
            let offset = offset(top.piece, &motor.shape.at(by, top.place));
            best[slot] = Some(Peak { severity: top.value, phase: phase_of(top.place), offset });
        }
        Ok(best)
    }

    /// The greatest pressures of Hertz over a revolution, of both meshes and both pushes.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | `Δp` | `pressure_drop` | high less low pressure, above 0 | Pa |
    /// | `E*` | `modulus` | effective modulus of the pair of materials, [`effective_modulus`] | Pa |
    ///
    /// # Errors
    /// [`Error::NotPositive`] for either, [`Error::CannotHold`] where the flanks hold no satellite.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::flanks::{Mesh, effective_modulus};
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{Length, Pressure};
    /// use uom::si::{length::millimeter, pressure::{gigapascal, megapascal}};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let profile = Profile::new(&motor, ToothForm::default())?;
    /// let steel = effective_modulus([Pressure::new::<gigapascal>(206.0); 2], [0.3; 2])?;
    /// let stresses = profile.contact_stresses(Pressure::new::<megapascal>(20.0), steel)?;
    /// assert_eq!(stresses.len(), 4);
    /// assert!(stresses.iter().any(|stress| stress.mesh == Mesh::Rotor));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn contact_stresses(
        &self,
        pressure_drop: Pressure,
        modulus: Pressure,
    ) -> Result<Vec<ContactStress>, Error> {
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let modulus = positive_pressure(Quantity::ContactModulus, modulus)?.si();
        let peak = |peak: Peak| PeakPressure {
            pressure: Pressure::from_si((peak.severity * drop * modulus).sqrt()),
            rotation: Angle::from_si(peak.phase),
            offset: self.motor().length(peak.offset),
        };
        let mut stresses = Vec::with_capacity(4);
        for mesh in Mesh::BOTH {
            for crest in [true, false] {
                let sigma = Motor::push(crest, 1.0);
                let [at_pitch, alone, whole] = self.peaks(mesh.side(), sigma, crest)?;
                let Some(at_pitch) = at_pitch else { continue };
                stresses.push(ContactStress {
                    mesh,
                    push: Push::of(sigma),
                    at_pitch_point: peak(at_pitch),
                    in_single_contact: alone.map(peak),
                    on_path: whole.map(peak),
                });
            }
        }
        Ok(stresses)
    }

    /// The greatest `p_H²/(Δp·E*)` of all meshes.
    pub(super) fn greatest_severity(&self, path: LoadedPath) -> Result<f64, Error> {
        let mut greatest = 0.0_f64;
        for side in Side::BOTH {
            for crest in [true, false] {
                let [at_pitch, alone, whole] = self.peaks(side, Motor::push(crest, 1.0), crest)?;
                let peaks = match path {
                    LoadedPath::Whole => [at_pitch, whole],
                    LoadedPath::SingleContact => [at_pitch, alone],
                };
                greatest = peaks.into_iter().flatten().map(|peak| peak.severity).fold(greatest, f64::max);
            }
        }
        Ok(greatest)
    }
}

impl Motor {
    /// The pressure of Hertz between a satellite and a wheel with the contact at `e`; `rotation` since the
    /// satellite stood between two crests. Nothing while it is idle.
    ///
    /// # Errors
    /// As [`Profile::contact_stresses`], and [`Error::OutOfRange`] for an offset beyond the centres of
    /// curvature of either flank.
    pub fn contact_pressure(
        &self,
        pressure_angle_of_teeth: Angle,
        mesh: Mesh,
        rotation: Angle,
        offset: Length,
        pressure_drop: Pressure,
        modulus: Pressure,
    ) -> Result<Pressure, Error> {
        let alpha = pressure_angle(pressure_angle_of_teeth)?;
        let phase = finite_angle(Quantity::Rotation, rotation)?;
        let e = finite_modules(Quantity::ContactOffset, offset, self.module())?;
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let modulus = positive_pressure(Quantity::ContactModulus, modulus)?.si();
        let Some(sigma) = self.pushed(phase, 1.0) else { return Ok(Pressure::default()) };
        let contact = self.shape.at(By::Phase, phase);
        let (r, side) = (self.shape.satellite_radius(), mesh.side());
        let value = severity(side, r, alpha, &contact, sigma, e)?;
        if !value.is_finite() {
            let bulge = match side {
                Side::Stator => -contact.kappa3,
                Side::Rotor => contact.kappa1,
            };
            let cusp = -libm::sin(alpha) / bulge;
            let (low, high) = if bulge > 0.0 { (cusp, f64::INFINITY) } else { (f64::NEG_INFINITY, cusp) };
            let high = high.min(r * libm::sin(alpha));
            return Err(Error::OutOfRange {
                quantity: Quantity::ContactOffset,
                value: e,
                low,
                high,
                unit: "modules",
            });
        }
        Ok(Pressure::from_si((value * drop * modulus).sqrt()))
    }
}

/// Effective modulus of a pair of materials, `1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂`.
///
/// # Errors
/// [`Error::NotPositive`] for a modulus, [`Error::OutOfRange`] unless Poisson's ratios lie from 0 to 0.5.
pub fn effective_modulus(moduli: [Pressure; 2], poisson: [f64; 2]) -> Result<Pressure, Error> {
    let mut compliance = 0.0;
    for (modulus, nu) in moduli.into_iter().zip(poisson) {
        let modulus = positive_pressure(Quantity::ElasticModulus, modulus)?.si();
        if !(0.0..=0.5).contains(&nu) {
            return Err(Error::OutOfRange {
                quantity: Quantity::PoissonRatio,
                value: nu,
                low: 0.0,
                high: 0.5,
                unit: "",
            });
        }
        compliance += (1.0 - nu * nu) / modulus;
    }
    Ok(Pressure::from_si(1.0 / compliance))
}

#[cfg(test)]
pub(super) mod tests;
