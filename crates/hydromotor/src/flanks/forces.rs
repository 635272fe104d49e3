//! Forces on the flanks with contacts at the pitch points, and the load of the rotor's bearing.
//!
//! # Who carries
//! With ideal ports a satellite parts high from low pressure exactly while it is within `π/N` of a crest,
//! where `f` is greatest, or of a trough. The chamber behind it grows from `Φ = −π/N` to `π/n`, and the one
//! in front from `π/N` on. By a crest a satellite is pushed forward, by a trough back; `2n` satellites are
//! loaded and `N − n` idle at any angle.
//!
//! # Flank forces
//! The pressure force is `F = σ·Δp·b·2·r·cos μ`, across the ray through the satellite's centre. It balances
//! with the forces in both lines of action. About the centre, where both have the arm `r·cos α`, they are
//! equal; along the ray they cancel; across it:
//!
//! ```text
//! 2·N·cos(α + σ·μ) = Δp·b·2·r·cos μ        N = Δp·b·r·cos μ/cos(α + σ·μ) = Δp·b·r/(cos α − σ·sin α·tan μ)
//! ```
//!
//! So `N` grows with `σ·μ`, and is greatest where the slope is steepest. From `α + σ·μ = 90°` on no force
//! holds the satellite.
//!
//! # The rotor
//! The pressures of the chambers act on the rotor's outline from contact to contact. From `A`
//! counter-clockwise to `B` they give the force `−p·b·(y_B − y_A, x_A − x_B)` and the torque
//! `½·p·b·(ρ_B² − ρ_A²)`. The flank forces act in the contacts. The torque is that of the volumes; the
//! bearing carries the rest of the forces. It vanishes if `N` and `n` have a common divisor, since the
//! pressures then repeat about the axis.

use crate::quantity::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Force, Length, Pressure, Torque};

use super::kernel::{direction, flank_number, greatest_of, pressure_angle, turned};
use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::modules::volume;
use crate::motor::Motor;
use crate::profile::Side;
use crate::ranges::{finite_angle, finite_pressure};
use crate::tolerance::BESIDE_JUMP;

/// Direction in which the pressure pushes a satellite.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", schemars(rename = "Push"))]
pub enum Push {
    /// Counter-clockwise, the way that the rotor turns: the satellite is near a crest.
    #[cfg_attr(feature = "names", serde(rename = "crest"))]
    Forward,
    /// Clockwise: the satellite is near a trough.
    #[cfg_attr(feature = "names", serde(rename = "trough"))]
    Back,
}

impl Push {
    pub(super) fn of(sigma: f64) -> Self {
        if sigma < 0.0 { Self::Back } else { Self::Forward }
    }
}

/// The forces on a satellite's flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlankForce {
    /// Number of the satellite.
    pub index: u32,
    /// Direction of the push; `None` while the satellite is idle.
    pub push: Option<Push>,
    /// `N`, the force between it and the stator and between it and the rotor; 0 while it is idle.
    pub force: Force,
    /// Angle of the line of action at the stator to the normal of the ray, `α + σ·μ`; `α` while it is idle.
    pub inclination: Angle,
}

/// The greatest flank force of the satellites by a crest, or by a trough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreatestFlankForce {
    /// Direction in which those satellites are pushed.
    pub push: Push,
    /// `N`.
    pub force: Force,
    /// Rotation of the rotor at which satellite 0 has it.
    pub rotation: Angle,
}

/// The load of the rotor's bearing: the force on the rotor that it carries, in the stator's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingLoad {
    /// Rotation of the rotor.
    pub rotation: Angle,
    /// Component along the axis through a stator crest.
    pub x: Force,
    /// Component across.
    pub y: Force,
    /// Magnitude.
    pub force: Force,
}

/// Contacts of all satellites at a rotation, and the chambers with high pressure.
struct Instant {
    contacts: Vec<Contact>,
    high: Vec<bool>,
}

impl Instant {
    /// The sign of the pressure force on a satellite for a positive pressure drop, 0 of none.
    fn sigma(&self, j: usize) -> f64 {
        let before = self.high[(j + self.high.len() - 1) % self.high.len()];
        f64::from(i8::from(before) - i8::from(self.high[j]))
    }
}

/// The bare numbers of a load.
pub(super) struct Load {
    pub(super) alpha: f64,
    width: Length,
    pressure_drop: Pressure,
}

impl Load {
    pub(super) fn new(alpha: Angle, width: Length, pressure_drop: Pressure) -> Result<Self, Error> {
        Ok(Self {
            alpha: pressure_angle(alpha)?,
            width: crate::machine::width(width)?,
            pressure_drop: finite_pressure(Quantity::PressureDrop, pressure_drop)?,
        })
    }

    pub(super) fn sign(&self) -> f64 {
        if self.pressure_drop < Pressure::default() { -1.0 } else { 1.0 }
    }

    /// Force of a number of `Δp·b·m`, by the drop's magnitude.
    pub(super) fn force(&self, motor: &Motor, number: f64) -> Force {
        motor.length(number) * self.width * self.pressure_drop.abs()
    }
}

impl Motor {
    fn instant(&self, rotation: f64) -> Instant {
        let count = self.numbers().satellites();
        let contacts: Vec<Contact> =
            (0..count).map(|j| self.shape.at(By::Phase, self.phase(rotation, j))).collect();
        let flow = |j: usize| contacts[j % contacts.len()].flow();
        let high = (0..contacts.len()).map(|j| flow(j + 1) > flow(j)).collect();
        Instant { contacts, high }
    }

    /// The forces on the flanks of all satellites after a rotation, with ideal ports and contacts at the
    /// pitch points.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | `α` | `pressure_angle` | pressure angle of the teeth, 10° to 40° | rad |
    /// | `b` | `width` | width of the wheels | m |
    /// | `Δp` | `pressure_drop` | high less low pressure; negative, every push is reversed | Pa |
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for the pressure angle, [`Error::NotPositive`] for the width,
    /// [`Error::NotFinite`] for the others, [`Error::CannotHold`] where the flanks hold no satellite.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{Angle, Length, Pressure};
    /// use uom::si::{angle::degree, force::newton, length::millimeter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(1.0), mm(40.0))?;
    /// let (alpha, rotation) = (Angle::new::<degree>(25.0), Angle::new::<degree>(0.0));
    /// let forces = motor.flank_forces(alpha, rotation, mm(10.0), Pressure::new::<megapascal>(20.0))?;
    /// // 5.51689·Δp·b·m on the satellite at the crest.
    /// assert!((forces[0].force.get::<newton>() - 1103.378).abs() < 1e-3);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn flank_forces(
        &self,
        pressure_angle: Angle,
        rotation: Angle,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<Vec<FlankForce>, Error> {
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        let instant = self.instant(finite_angle(Quantity::Rotation, rotation)?);
        let r = self.shape.satellite_radius();
        let on_satellite = |(index, contact): (u32, &Contact)| {
            let sigma = load.sign() * instant.sigma(index as usize);
            let number = if sigma == 0.0 { 0.0 } else { flank_number(r, load.alpha, contact, sigma)? };
            Ok(FlankForce {
                index,
                push: (sigma != 0.0).then(|| Push::of(sigma)),
                force: load.force(self, number),
                inclination: Angle::from_si(load.alpha + sigma * contact.mu),
            })
        };
        (0..).zip(&instant.contacts).map(on_satellite).collect()
    }

    /// Whether teeth of this pressure angle hold every loaded satellite: `α + σ·μ` stays below a right angle.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{angle::degree, f64::{Angle, Length}, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(1.0), mm(40.0))?;
    /// assert!(motor.held_by(Angle::new::<degree>(25.0)));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn held_by(&self, pressure_angle: Angle) -> bool {
        let (width, drop) = (self.module(), Pressure::from_si(1.0));
        self.greatest_flank_forces(pressure_angle, width, drop).is_ok()
    }

    /// The greatest flank forces over a revolution: of the satellites by a crest, and of those by a trough.
    ///
    /// Exact: `N` grows with `σ·μ`, and the steepest slopes are ends of the loaded ranges, junctions of the
    /// arcs, or roots of `κ₃ = cos μ/ρ₃`.
    ///
    /// # Errors
    /// As [`flank_forces`](Self::flank_forces).
    pub fn greatest_flank_forces(
        &self,
        pressure_angle: Angle,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<[GreatestFlankForce; 2], Error> {
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        let steepest = self.steepest();
        let of = |crest: bool| {
            let sigma = Self::push(crest, load.sign());
            let [from, to] = self.loaded(crest);
            // The half of the range on the half-lobe from crest to trough, where μ is not above 0.
            let (low, high) = if crest { (0.0, to) } else { (from, self.shape.trough().phase) };
            let within = steepest.iter().copied().filter(|place| (low..=high).contains(place));
            let slope = |phase: f64| -self.shape.within(By::Phase, phase).mu;
            let (place, _) = within
                .chain([low, high])
                .map(|phase| (phase, slope(phase)))
                .fold((0.0, f64::NEG_INFINITY), |best, here| if here.1 > best.1 { here } else { best });
            // Beyond the trough, or before the crest, μ is as great and positive.
            let phase = match (crest, sigma > 0.0) {
                (_, false) => place,
                (true, true) => -place,
                (false, true) => 2.0 * self.shape.trough().phase - place,
            };
            let contact = self.shape.at(By::Phase, phase);
            let number = flank_number(self.shape.satellite_radius(), load.alpha, &contact, sigma)?;
            Ok(GreatestFlankForce {
                push: Push::of(sigma),
                force: load.force(self, number),
                rotation: Angle::from_si(phase),
            })
        };
        Ok([of(true)?, of(false)?])
    }

    /// Force over `Δp·b·m` and torque over `Δp·b·m²` on the rotor, of pressures and flanks.
    fn on_rotor(&self, rotation: f64, alpha: f64) -> Result<([f64; 2], f64), Error> {
        let instant = self.instant(rotation);
        let r = self.shape.satellite_radius();
        let count = instant.contacts.len();
        let at = |j: usize| {
            let contact = &instant.contacts[j % count];
            turned([contact.rho1, 0.0], contact.theta3)
        };
        let (mut sum, mut torque) = ([0.0; 2], 0.0);
        for j in 0..count {
            let [[ax, ay], [bx, by]] = [at(j), at(j + 1)];
            if instant.high[j] {
                sum = [sum[0] - (by - ay), sum[1] + (bx - ax)];
                torque += 0.5 * (bx * bx + by * by - ax * ax - ay * ay);
            }
            let sigma = instant.sigma(j);
            if sigma != 0.0 {
                let contact = &instant.contacts[j];
                let number = flank_number(r, alpha, contact, sigma)?;
                let [x, y] = turned(direction(Side::Rotor, sigma, alpha, contact.mu), contact.theta3);
                let [x, y] = [-number * x, -number * y];
                sum = [sum[0] + x, sum[1] + y];
                torque += ax * y - ay * x;
            }
        }
        Ok((sum, torque))
    }

    /// The torque on the rotor by the forces on it: the pressures on its outline and the flank forces. It is
    /// that of the volumes, [`torque`](Self::torque), got without them.
    ///
    /// # Errors
    /// As [`flank_forces`](Self::flank_forces).
    pub fn torque_by_forces(
        &self,
        pressure_angle: Angle,
        rotation: Angle,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<Torque, Error> {
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        // Reversed pressures reverse the pushes and with them the flanks that carry.
        let rotation = load.sign() * finite_angle(Quantity::Rotation, rotation)?;
        let (_, number) = self.on_rotor(rotation, load.alpha)?;
        Ok((volume(number, self.module(), load.width) * pressure_drop).into())
    }

    /// The force on the rotor that its bearing carries, after a rotation.
    ///
    /// # Errors
    /// As [`flank_forces`](Self::flank_forces).
    pub fn bearing_load(
        &self,
        pressure_angle: Angle,
        rotation: Angle,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<BearingLoad, Error> {
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        self.bearing(finite_angle(Quantity::Rotation, rotation)?, &load)
    }

    fn bearing(&self, rotation: f64, load: &Load) -> Result<BearingLoad, Error> {
        // With reversed pressures everything is the mirror image, in the stator's crest, of the opposite
        // rotation.
        let mirror = load.sign();
        let ([x, y], _) = self.on_rotor(mirror * rotation, load.alpha)?;
        let force = |number| load.force(self, number);
        Ok(BearingLoad {
            rotation: Angle::from_si(rotation),
            x: force(x),
            y: force(mirror * y),
            force: force(libm::hypot(x, y)),
        })
    }

    /// The greatest load of the rotor's bearing over a revolution.
    ///
    /// The load is evaluated on each smooth piece of the period `2π/lcm(N, n)`, between changeovers of
    /// chambers, where it jumps, and passages of junctions. If the load vanishes throughout, the rotation
    /// is 0. For a greatest load right before or behind a jump the rotation is slightly within the piece.
    ///
    /// # Errors
    /// As [`flank_forces`](Self::flank_forces).
    pub fn greatest_bearing_load(
        &self,
        pressure_angle: Angle,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<BearingLoad, Error> {
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        // Wherever the flanks hold at the steepest slope they hold throughout.
        self.greatest_flank_forces(pressure_angle, width, pressure_drop)?;
        if self.numbers().common_divisor() > 1 {
            // None but rounding at any angle.
            return self.bearing(0.0, &load);
        }
        let period = self.period();
        let kinks = self.shape.kink().into_iter().flat_map(|kink| [kink, -kink]);
        let more = kinks.map(|kink| kink.rem_euclid(period)).chain([0.5 * period]);
        let mut ends: Vec<f64> = more.chain([0.0, period]).collect();
        ends.sort_by(f64::total_cmp);
        let value = |_, place: f64| {
            [self.on_rotor(place, load.alpha).map_or(f64::NAN, |([x, y], _)| libm::hypot(x, y))]
        };
        let pieces: Vec<[f64; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let [top] = greatest_of(&pieces, BESIDE_JUMP, value);
        self.bearing(load.sign() * top.place, &load)
    }
}

#[cfg(test)]
pub(super) mod tests;
