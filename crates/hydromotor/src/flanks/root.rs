//! Bending at the roots of the teeth, after Lewis, and the pressure that a shape allows.
//!
//! # The model
//! A tooth is a cantilever. The force `N` acts at a point of its flank along the line of action. In the
//! section at `x` on the tooth's middle line, of thickness `s`, it bends with the moment `M` about the
//! section's middle:
//!
//! ```text
//! σ_F = 6·M/(b·s²)        greatest over the sections down to the root
//! ```
//!
//! The sections are those below the place where the line of action crosses the middle line: above it `N`
//! bends the tooth's tip the other way. At the place of greatest stress the parabola of equal strength from
//! that crossing touches the outline from within (Lewis). The sections are those of the generated outline:
//! flank, the fillet that the tool leaves, undercut if there is any. With `N ∝ Δp·b·m` the width and the
//! module drop out.
//!
//! The stress is nominal: the compression by the force's part along the tooth, shear and the notch of the
//! fillet are left out. The load is `N` of contacts at the pitch points, whole on one pair of flanks, at the
//! worst point of the path of contact given by [`LoadedPath`]. For the satellite this is a usual model. For
//! stator and rotor it is a comparison of shapes: the two flanks of their teeth differ, and their rims and
//! hollow roots carry in other ways. The values are reported; they certify nothing.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length, Pressure};

use super::forces::Push;
use super::kernel::{arc, flank_number, greatest_of, pressure_angle};
use super::stress::{LoadedPath, Places, Stretch, parted};
use crate::Error;
use crate::centrode::Wheel;
use crate::contact::{Conjugate, Contact};
use crate::motor::Motor;
use crate::profile::{Profile, Side};
use crate::quantity::Quantity;
use crate::ranges::{self, positive_pressure};

/// Number of points of the outline's fillet at which the section is evaluated: the stress is within a
/// thousandth of that of many more.
const POINTS: u32 = 24;

/// The greatest nominal bending stress at the roots of a wheel's teeth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RootStress {
    /// The wheel.
    pub wheel: Wheel,
    /// The stress.
    pub stress: Pressure,
    /// Direction in which the satellites are pushed.
    pub push: Push,
    /// Rotation of the rotor at which satellite 0 loads, or is, the wheel so.
    pub rotation: Angle,
    /// Point of load: `e` along the line of action from the pitch point, positive towards the satellite's
    /// base circle.
    pub offset: Length,
    /// Thickness of the section that is stressed most.
    pub thickness: Length,
    /// Tooth of the lobe, from the one after the first space on; of the satellite, whose teeth are alike, 0.
    pub tooth: u32,
}

/// Allowed stresses of the materials, and their modulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialLimits {
    /// Pressure of Hertz.
    pub contact: Pressure,
    /// Nominal bending stress at the root.
    pub root: Pressure,
    /// Effective modulus `E*`.
    pub modulus: Pressure,
}

/// Stress that limits the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Governing {
    /// The pressure of Hertz.
    Contact,
    /// The bending of this wheel's teeth.
    Root(Wheel),
}

/// The pressure drop that a shape allows; it depends on neither module nor width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AllowedPressure {
    /// The least of both.
    pub pressure: Pressure,
    /// By the pressures of Hertz.
    pub by_contact: Pressure,
    /// By the bending of the teeth.
    pub by_root: Pressure,
    /// Stress that limits the pressure.
    pub governing: Governing,
}

/// A stress over `Δp`, with its place.
#[derive(Debug, Clone, Copy)]
struct Worst {
    stress: f64,
    thickness: f64,
    sigma: f64,
    phase: f64,
    offset: f64,
    tooth: usize,
}

impl Profile {
    /// The greatest nominal bending stresses of stator, rotor and satellite over a revolution, in this order;
    /// a wheel is left out that no loaded satellite meets on such a path.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the pressure drop, [`Error::CannotHold`] where the flanks hold no
    /// satellite.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::flanks::LoadedPath;
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::{Length, Pressure}, length::millimeter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let profile = Profile::new(&motor, ToothForm::default())?;
    /// let stresses = profile.root_stresses(LoadedPath::Whole, Pressure::new::<megapascal>(20.0))?;
    /// assert_eq!(stresses.len(), 3);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn root_stresses(&self, path: LoadedPath, pressure_drop: Pressure) -> Result<Vec<RootStress>, Error> {
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let stress = |(wheel, worst): (Wheel, Worst)| RootStress {
            wheel,
            stress: Pressure::from_si(worst.stress * drop),
            push: Push::of(worst.sigma),
            rotation: Angle::from_si(worst.phase),
            offset: self.motor().length(worst.offset),
            thickness: self.motor().length(worst.thickness),
            tooth: worst.tooth as u32,
        };
        Ok(self.bent(path, POINTS)?.into_iter().map(stress).collect())
    }

    /// Worst places of stator, rotor and satellite, from outlines with `points` points per fillet.
    fn bent(&self, path: LoadedPath, points: u32) -> Result<Vec<(Wheel, Worst)>, Error> {
        let motor = self.motor();
        let (alpha, r) = (pressure_angle(self.form().pressure_angle)?, motor.shape.satellite_radius());
        // Refuses a motor that no flank holds before anything is compared.
        motor.greatest_flank_forces(self.form().pressure_angle, motor.module(), Pressure::from_si(1.0))?;
        let (own, by) = (self.satellite_tooth(points), motor.shape.explicit());
        let mut worst: [Option<Worst>; 3] = [None; 3];
        for (i, side) in Side::BOTH.into_iter().enumerate() {
            let teeth = self.wheel_teeth(side, points);
            for crest in [true, false] {
                let sigma = Motor::push(crest, 1.0);
                let stretches: Vec<Stretch> = self.stretches(side, sigma, crest);
                let mut ends = Places::new(motor, arc(side));
                let (pieces, flanks) = parted(&stretches, path, &motor.corners(crest), &mut ends);
                if flanks.is_empty() {
                    continue;
                }
                let places: Vec<(usize, f64)> =
                    flanks.iter().map(|stretch| self.tooth_of(side, stretch.sign, stretch.pitch)).collect();
                // On the wheel's tooth and on the satellite's, by one contact.
                let loads = |piece: usize, contact: &Contact| {
                    let (flank, (index, lobe)) = (flanks[piece], places[piece]);
                    let tooth = &teeth[index];
                    let on_wheel = self.wheel_loading_at(side, tooth, flank.sign, flank.pitch, lobe, contact);
                    let offset = flank.offset(contact.get(arc(side)), self.teeth().cos);
                    [(tooth, on_wheel), (&own, self.satellite_loading(offset))]
                };
                let tops = greatest_of(&pieces, 0.0, |piece, place| {
                    let contact = motor.shape.at(by, place);
                    let number = flank_number(r, alpha, &contact, sigma).unwrap_or(f64::NAN);
                    loads(piece, &contact).map(|(tooth, loading)| number * tooth.bending(loading))
                });
                let range = motor.loaded(crest);
                for (slot, (k, top)) in [i, 2].into_iter().zip(tops.into_iter().enumerate()) {
                    if worst[slot].is_none_or(|worst| top.value > worst.stress) {
                        let contact = motor.shape.at(by, top.place);
                        let (tooth, loading) = loads(top.piece, &contact)[k];
                        worst[slot] = Some(Worst {
                            stress: top.value,
                            thickness: tooth.weakest(loading).map_or(0.0, |section| section.thickness),
                            sigma,
                            phase: contact.phase.clamp(range[0], range[1]),
                            offset: flanks[top.piece].offset(contact.get(arc(side)), self.teeth().cos),
                            tooth: if slot == 2 { 0 } else { places[top.piece].0 },
                        });
                    }
                }
            }
        }
        let wheels = [Wheel::Stator, Wheel::Rotor, Wheel::Satellite];
        Ok(wheels.into_iter().zip(worst).filter_map(|(wheel, worst)| Some((wheel, worst?))).collect())
    }

    /// The pressure drop that the flanks allow, for given limits of the materials.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | `p_lim` | `limits.contact` | allowed pressure of Hertz | Pa |
    /// | `σ_lim` | `limits.root` | allowed nominal bending stress | Pa |
    /// | `E*` | `limits.modulus` | effective modulus | Pa |
    ///
    /// ```text
    /// Δp = p_lim²/(E*·max p_H²/(Δp·E*))        Δp = σ_lim/(max σ_F/Δp)
    /// ```
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a limit, [`Error::CannotHold`] where the flanks hold no satellite.
    pub fn allowed_pressure(
        &self,
        path: LoadedPath,
        limits: &MaterialLimits,
    ) -> Result<AllowedPressure, Error> {
        let contact = ranges::stress_limit(Quantity::ContactLimit, limits.contact)?;
        let root = ranges::stress_limit(Quantity::RootLimit, limits.root)?;
        let modulus = positive_pressure(Quantity::ContactModulus, limits.modulus)?.si();
        let by_contact = contact * contact / (modulus * self.greatest_severity(path)?);
        let (wheel, stress) = self
            .bent(path, POINTS)?
            .into_iter()
            .map(|(wheel, worst)| (wheel, worst.stress))
            .fold((Wheel::Satellite, 0.0), |worst, here| if here.1 > worst.1 { here } else { worst });
        let by_root = root / stress;
        let governing = if by_contact <= by_root { Governing::Contact } else { Governing::Root(wheel) };
        Ok(AllowedPressure {
            pressure: Pressure::from_si(by_contact.min(by_root)),
            by_contact: Pressure::from_si(by_contact),
            by_root: Pressure::from_si(by_root),
            governing,
        })
    }
}

#[cfg(test)]
mod tests;
