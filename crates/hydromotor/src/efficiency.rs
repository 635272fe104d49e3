//! Volumetric, mechanical and total efficiency over speed and pressure.
//!
//! ```text
//! inlet flow   Q_in = q·ω/(2π) + Q_gaps + V_dead·ω/(2π)        η_v = q·ω/(2π·Q_in)
//! torque       M = q·Δp/(2π) − M_flanks − M_gaps − P_ports/ω    η_m = 2π·M/(q·Δp)
//! total        η = η_v·η_m = M·ω/(Q_in·Δp)
//! ```
//!
//! | term | is | of |
//! |---|---|---|
//! | `q` | geometry | [`crate::chambers`] |
//! | `Q_gaps` | a model, of the gaps and the viscosity given | [`crate::leakage`] |
//! | `V_dead` | a model, of the bulk modulus and the dead area given | [`crate::ports::trapped`] |
//! | `M_flanks` | a model, of the friction coefficient given as a range | [`crate::friction`] |
//! | `M_gaps` | a model, of the gaps and the viscosity given | [`crate::friction`] |
//! | `P_ports` | a model, of the discharge coefficient; 0 without ports | [`crate::ports::throttling`] |
//!
//! Gaps, fluid, friction and discharge coefficient are inputs without defaults: none is measured here, and no
//! result is validated against a made motor. The models leave out flank leaks, bearings, seals, churning and
//! changing viscosity; these make a made motor worse than the map.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Area, Length, Power, Pressure, Torque, VolumeRate};

use crate::Error;
use crate::friction::FrictionRange;
use crate::leakage::{EndGaps, GapFluid, Leakage};
use crate::motor::Motor;
use crate::ports::PortPlate;
use crate::ports::throttling::Through;
use crate::quantity::{PortSide, Quantity};
use crate::ranges::{positive, positive_pressure};
use std::f64::consts::TAU;

/// Inputs of the losses, none of them with a default.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LossInputs<'a> {
    /// Pressure angle of the teeth.
    pub pressure_angle: Angle,
    /// Width of the motor.
    pub width: Length,
    /// Gaps at the end faces; 0 of an ideal face that neither leaks nor drags.
    pub gaps: EndGaps,
    /// Radius of the rotor's bore, within which its face has no gap; 0 of none.
    pub bore_radius: Length,
    /// The fluid in the gaps.
    pub fluid: GapFluid,
    /// Bulk modulus of the fluid; none of one that does not give way.
    pub bulk_modulus: Option<Pressure>,
    /// Dead volume of a chamber over the width.
    pub dead_area: Area,
    /// Friction coefficient of the flanks.
    pub friction: FrictionRange,
    /// Ports with their discharge coefficient; none of ports that do not throttle.
    pub ports: Option<(&'a PortPlate, f64)>,
}

/// Origin of a figure: given or calculated, and the basis of the calculation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// Calculated from the geometry of the motor.
    Geometry,
    /// By a model from inputs that nobody measured here.
    Model,
    /// Given by the user.
    Input,
}

/// A figure of an [`OperatingPoint`] or of [`LossInputs`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // each is the field of that name
pub enum Figure {
    Speed,
    PressureDrop,
    IdealFlow,
    IdealTorque,
    Gaps,
    Fluid,
    BulkModulus,
    DeadArea,
    Friction,
    DischargeCoefficient,
    Leakage,
    Charge,
    FlankFriction,
    GapDrag,
    Throttling,
    Volumetric,
    Mechanical,
    Total,
}

impl Figure {
    /// Origin of the figure.
    #[must_use]
    pub const fn origin(self) -> Origin {
        match self {
            Self::Speed
            | Self::PressureDrop
            | Self::Gaps
            | Self::Fluid
            | Self::BulkModulus
            | Self::DeadArea
            | Self::Friction
            | Self::DischargeCoefficient => Origin::Input,
            Self::IdealFlow | Self::IdealTorque => Origin::Geometry,
            Self::Leakage
            | Self::Charge
            | Self::FlankFriction
            | Self::GapDrag
            | Self::Throttling
            | Self::Volumetric
            | Self::Mechanical
            | Self::Total => Origin::Model,
        }
    }
}

/// A motor at a speed and a pressure. Of two values the first is with the greatest friction, the second with
/// the least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// Speed of the rotor.
    pub speed: AngularVelocity,
    /// High less low pressure.
    pub pressure_drop: Pressure,
    /// `q·ω/(2π)`.
    pub ideal_flow: VolumeRate,
    /// `q·Δp/(2π)`.
    pub ideal_torque: Torque,
    /// Leakage through the end gaps, with Reynolds numbers.
    pub leakage: Leakage,
    /// Flow that brings the chambers to the high pressure.
    pub charge: VolumeRate,
    /// Flow into the motor.
    pub inlet_flow: VolumeRate,
    /// Friction of the flanks.
    pub flank_friction: [Torque; 2],
    /// Drag of the end gaps.
    pub gap_drag: Torque,
    /// Power lost in the ports of both pressures.
    pub throttling: Power,
    /// Torque at the shaft; below 0 if the losses exceed the torque of the pressure.
    pub torque: [Torque; 2],
    /// `η_v`.
    pub volumetric: f64,
    /// `η_m`; below 0 with the torque.
    pub mechanical: [f64; 2],
    /// `η_v·η_m`.
    pub total: [f64; 2],
}

/// Operating points over speed and pressure.
#[derive(Debug, Clone, PartialEq)]
pub struct EfficiencyMap {
    /// The speeds, as given.
    pub speeds: Vec<AngularVelocity>,
    /// The pressure drops, as given.
    pub pressure_drops: Vec<Pressure>,
    /// A row for each pressure drop, with a point for each speed.
    pub rows: Vec<Vec<OperatingPoint>>,
}

/// Figures that do not change with speed and pressure, in SI units.
struct Constant {
    displacement: f64,
    /// Power of throttling over the cube of the speed.
    throttling: f64,
    /// Flank friction over the pressure, with the greatest and the least coefficient.
    flanks: [f64; 2],
    /// Drag over the speed.
    drag: f64,
    /// Charge of a revolution over the pressure.
    charge: f64,
}

impl Motor {
    /// Computes the motor at a speed and a pressure.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for speed and pressure drop; [`Error::OtherMotor`] for ports of another motor.
    /// The errors of the inputs are those of [`Motor::end_leakage`], [`Motor::mean_friction_torque`],
    /// [`Motor::gap_drag`], [`Motor::dead_volume_charge`] and [`PortPlate::throttling`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::efficiency::LossInputs;
    /// use epicyclic_hydromotor::friction::FrictionRange;
    /// use epicyclic_hydromotor::leakage::{EndGaps, GapFluid};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{Angle, AngularVelocity, Area, DynamicViscosity, Length, MassDensity, Pressure};
    /// use uom::si::{angle::degree, angular_velocity::revolution_per_minute};
    /// use uom::si::{area::square_millimeter, dynamic_viscosity::pascal_second};
    /// use uom::si::length::{micrometer, millimeter};
    /// use uom::si::{mass_density::kilogram_per_cubic_meter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(0.75), mm(30.0))?;
    /// let gap = Length::new::<micrometer>(10.0);
    /// let inputs = LossInputs {
    ///     pressure_angle: Angle::new::<degree>(25.0),
    ///     width: mm(25.0),
    ///     gaps: EndGaps { satellite: gap, rotor: gap },
    ///     bore_radius: mm(0.0),
    ///     fluid: GapFluid {
    ///         viscosity: DynamicViscosity::new::<pascal_second>(0.04),
    ///         density: MassDensity::new::<kilogram_per_cubic_meter>(870.0),
    ///         turbulent: None,
    ///     },
    ///     bulk_modulus: Some(Pressure::new::<megapascal>(1400.0)),
    ///     dead_area: Area::new::<square_millimeter>(0.0),
    ///     friction: FrictionRange::new(0.05, 0.12)?,
    ///     ports: None,
    /// };
    /// let speed = AngularVelocity::new::<revolution_per_minute>(200.0);
    /// let point = motor.operating_point(inputs, speed, Pressure::new::<megapascal>(25.0))?;
    /// assert!(point.volumetric < 1.0 && point.mechanical[0] < point.mechanical[1] && point.total[1] < 1.0);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn operating_point(
        &self,
        inputs: LossInputs<'_>,
        speed: AngularVelocity,
        pressure_drop: Pressure,
    ) -> Result<OperatingPoint, Error> {
        let constant = self.constant(&inputs)?;
        self.point(&inputs, &constant, speed, pressure_drop)
    }

    /// Operating points over speeds and pressure drops.
    ///
    /// # Errors
    /// As [`Motor::operating_point`]; the first fault ends the map.
    pub fn efficiency_map(
        &self,
        inputs: LossInputs<'_>,
        speeds: &[AngularVelocity],
        pressure_drops: &[Pressure],
    ) -> Result<EfficiencyMap, Error> {
        let constant = self.constant(&inputs)?;
        let row = |drop: &Pressure| {
            speeds.iter().map(|speed| self.point(&inputs, &constant, *speed, *drop)).collect::<Result<_, _>>()
        };
        Ok(EfficiencyMap {
            speeds: speeds.to_vec(),
            pressure_drops: pressure_drops.to_vec(),
            rows: pressure_drops.iter().map(row).collect::<Result<_, _>>()?,
        })
    }

    fn constant(&self, inputs: &LossInputs<'_>) -> Result<Constant, Error> {
        // Friction and charge are proportional to the pressure, drag to the speed and throttling to its cube:
        // unit values give the factors once for the whole map.
        let one = Pressure::from_si(1.0);
        let displacement = self.displacement(inputs.width)?.si();
        let [low, high] =
            self.mean_friction_torque(inputs.pressure_angle, inputs.width, one, inputs.friction)?;
        let drag = self.gap_drag(
            inputs.gaps,
            inputs.fluid.viscosity,
            inputs.bore_radius,
            AngularVelocity::from_si(1.0),
        )?;
        let charge = match inputs.bulk_modulus {
            Some(modulus) => self.dead_volume_charge(inputs.width, one, modulus, inputs.dead_area)?.si(),
            None => 0.0,
        };
        let throttling = match inputs.ports {
            Some((plate, discharge)) => {
                // Ports of another motor would throttle at other angles, and the result would look plausible.
                if plate.motor() != self {
                    return Err(Error::OtherMotor);
                }
                let through = Through {
                    width: inputs.width,
                    speed: AngularVelocity::from_si(1.0),
                    density: inputs.fluid.density,
                    discharge,
                };
                let of = |side| plate.throttling(side, through).map(|throttling| throttling.power.si());
                of(PortSide::High)? + of(PortSide::Low)?
            }
            None => 0.0,
        };
        Ok(Constant {
            displacement,
            throttling,
            flanks: [high, low].map(Physical::si),
            drag: (drag.satellites + drag.rotor).si(),
            charge,
        })
    }

    fn point(
        &self,
        inputs: &LossInputs<'_>,
        constant: &Constant,
        speed: AngularVelocity,
        pressure_drop: Pressure,
    ) -> Result<OperatingPoint, Error> {
        let omega = positive(Quantity::Speed, speed.si(), "rad/s")?;
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let leakage = self.end_leakage(inputs.gaps, inputs.fluid, pressure_drop)?;
        let ideal_flow = constant.displacement * omega / TAU;
        let charge = constant.charge * drop * omega / TAU;
        let inlet = ideal_flow + leakage.total.si() + charge;
        let ideal_torque = constant.displacement * drop / TAU;
        let drag = constant.drag * omega;
        let throttling = constant.throttling * omega.powi(3);
        let flanks = constant.flanks.map(|flanks| flanks * drop);
        let torque = flanks.map(|flanks| ideal_torque - flanks - drag - throttling / omega);
        let volumetric = ideal_flow / inlet;
        let mechanical = torque.map(|torque| torque / ideal_torque);
        Ok(OperatingPoint {
            speed,
            pressure_drop,
            ideal_flow: VolumeRate::from_si(ideal_flow),
            ideal_torque: Torque::from_si(ideal_torque),
            leakage,
            charge: VolumeRate::from_si(charge),
            inlet_flow: VolumeRate::from_si(inlet),
            flank_friction: flanks.map(Torque::from_si),
            gap_drag: Torque::from_si(drag),
            throttling: Power::from_si(throttling),
            torque: torque.map(Torque::from_si),
            volumetric,
            mechanical,
            total: mechanical.map(|mechanical| mechanical * volumetric),
        })
    }
}

#[cfg(test)]
mod tests;
