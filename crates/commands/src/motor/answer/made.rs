//! Manufacturing data of a motor, checked (material, oil, gaps, friction, ports), and the results that
//! follow.

pub(crate) mod losses;
pub(crate) mod ports;

use crate::answer::Warning;
use crate::error::Error;
use epicyclic_formats::motor::{Keys, PortGroup};
use epicyclic_hydromotor::efficiency::LossInputs;
use epicyclic_hydromotor::flanks::{MaterialLimits, effective_modulus};
use epicyclic_hydromotor::friction::FrictionRange;
use epicyclic_hydromotor::leakage::{EndGaps, GapFluid, TurbulentLaw, warm_play};
use epicyclic_hydromotor::ports::timing::Timing;
use epicyclic_hydromotor::ports::{PortPlate, PortShape};
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::{Error as MotorError, Motor};
use epicyclic_units::{Number, Physical as _};
use losses::Losses;
use ports::MadePorts;
use uom::si::f64::{
    AngularVelocity, Area, DynamicViscosity, Length, MassDensity, Pressure, TemperatureCoefficient,
    TemperatureInterval,
};

/// Young's modulus of steel in GPa, the default.
const STEEL_GPA: f64 = 206.0;
/// Poisson's ratio of steel, the default.
const POISSON: f64 = 0.3;

/// Manufacturing data of a motor, in a file or in options; both use the same keys.
pub type Groups = Keys;

/// Results that follow from the manufacturing data.
#[derive(Debug, Clone)]
pub struct Made {
    /// Effective modulus of the teeth.
    pub(crate) modulus: Pressure,
    /// Limits of the material.
    pub(crate) limits: Option<MaterialLimits>,
    /// Ports as manufactured, with the angles at which they open and close.
    pub ports: Option<(PortPlate, Timing)>,
    pub(crate) port_figures: Option<MadePorts>,
    pub(crate) most_trapped: Option<Pressure>,
    pub(crate) bulk_modulus: Option<Pressure>,
    pub(crate) dead_area: Area,
    pub(crate) losses: Option<Losses>,
}

/// Operating point of a motor with its tooth form.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point {
    pub(crate) form: ToothForm,
    pub(crate) width: Option<Length>,
    pub(crate) pressure: Option<Pressure>,
    pub(crate) speed: Option<AngularVelocity>,
}

/// Checked quantities of the groups, as far as they are given.
pub(crate) struct Inputs {
    viscosity: Option<DynamicViscosity>,
    density: Option<MassDensity>,
    bulk_modulus: Option<Pressure>,
    turbulent: Option<TurbulentLaw>,
    gaps: Option<EndGaps>,
    bore_radius: Length,
    friction: Option<FrictionRange>,
    dead_area: Area,
    discharge: Option<f64>,
    most_trapped: Option<Pressure>,
}

fn refused(key: &'static str, message: impl Into<String>) -> Error {
    Error::MotorKey { key, message: message.into() }
}

impl Made {
    pub(crate) fn of(motor: &Motor, groups: &Groups, point: Point) -> Result<Self, Error> {
        let (modulus, limits) = material(groups)?;
        let inputs = Inputs::of(groups, point)?;
        let ports = groups.ports.as_ref().map(|group| {
            let plate = plate(motor, group)?;
            let timing = plate.timing()?;
            Ok::<_, Error>((plate, timing))
        });
        let ports = ports.transpose()?;
        let port_figures = ports.as_ref().map(|(plate, timing)| MadePorts::of(plate, timing, &inputs, point));
        let port_figures = port_figures.transpose()?;
        let losses = Losses::of(motor, ports.as_ref().map(|(plate, _)| plate), &inputs, point)?;
        let Inputs { most_trapped, bulk_modulus, dead_area, .. } = inputs;
        Ok(Self { modulus, limits, ports, port_figures, most_trapped, bulk_modulus, dead_area, losses })
    }

    /// Leakage, friction, efficiencies.
    #[must_use]
    pub fn losses(&self) -> Option<&Losses> {
        self.losses.as_ref()
    }

    /// Warnings about the ports as manufactured.
    pub(crate) fn port_warnings(&self) -> Vec<Warning> {
        self.port_figures.as_ref().map(|ports| ports.warnings(self.most_trapped)).unwrap_or_default()
    }
}

/// Effective modulus of steel teeth.
pub(crate) fn steel() -> Result<Pressure, Error> {
    material(&Groups::default()).map(|(modulus, _)| modulus)
}

/// Effective modulus and limits of the material.
fn material(groups: &Groups) -> Result<(Pressure, Option<MaterialLimits>), Error> {
    let group = groups.material.as_ref();
    let youngs =
        group.and_then(|one| one.youngs_modulus).map_or(Pressure::from_si(STEEL_GPA * 1e9), |one| one.0);
    let poisson = group.and_then(|one| one.poissons_ratio).map_or(POISSON, Number::get);
    let modulus = effective_modulus([youngs; 2], [poisson; 2])?;
    let limits = match group.map(|one| (one.contact_limit, one.root_limit)) {
        Some((Some(contact), Some(root))) => {
            Some(MaterialLimits { contact: contact.0, root: root.0, modulus })
        }
        Some((Some(_), None)) => {
            return Err(refused(
                "material.contact_limit",
                "the allowed pressure needs both limits: give root_limit, too",
            ));
        }
        Some((None, Some(_))) => {
            return Err(refused(
                "material.root_limit",
                "the allowed pressure needs both limits: give contact_limit, too",
            ));
        }
        _ => None,
    };
    Ok((modulus, limits))
}

fn plate(motor: &Motor, group: &epicyclic_formats::motor::PortsGroup) -> Result<PortPlate, Error> {
    match (group.part, &group.high) {
        (Some(_), Some(_)) => Err(refused("ports.high", "give either part, of the ideal holes, or high")),
        (None, None) => {
            Err(refused("ports", "give part, of the ideal holes, or high, the port at high pressure"))
        }
        (Some(_), None) if group.low.is_some() => {
            Err(refused("ports.low", "holes by part are at the ideal places: give high in its place"))
        }
        (Some(part), None) => Ok(PortPlate::of_ideal_holes(motor, part.get())?),
        (None, Some(high)) => {
            let high = shape(high, "ports.high")?;
            let low = match &group.low {
                Some(low) => shape(low, "ports.low")?,
                None => high.mirrored(),
            };
            Ok(PortPlate::new(motor, high, low)?)
        }
    }
}

/// Shape of a port: a hole or a kidney.
fn shape(group: &PortGroup, key: &'static str) -> Result<PortShape, Error> {
    let PortGroup { angle, diameter, pitch_radius, inner_radius, outer_radius, span, corner_radius } = group;
    let is_kidney =
        inner_radius.is_some() || outer_radius.is_some() || span.is_some() || corner_radius.is_some();
    match (diameter, pitch_radius, inner_radius, outer_radius, span) {
        (Some(diameter), Some(radius), ..) if !is_kidney => {
            Ok(PortShape::Hole { diameter: diameter.0, pitch_radius: radius.0, angle: angle.0 })
        }
        (None, None, Some(inner), Some(outer), Some(span)) => Ok(PortShape::Kidney {
            inner_radius: inner.0,
            outer_radius: outer.0,
            angle: angle.0,
            span: span.0,
            corner: corner_radius.map_or(0.5 * (outer.0 - inner.0), |corner| corner.0),
        }),
        _ => Err(refused(
            key,
            "a hole has diameter and pitch_radius, a kidney inner_radius, outer_radius and span",
        )),
    }
}

impl Inputs {
    fn of(groups: &Groups, point: Point) -> Result<Self, Error> {
        let oil = groups.oil.as_ref();
        let density = oil.and_then(|oil| oil.density).map(|density| density.0);
        let viscosity = match oil.map(|oil| (oil.viscosity, oil.dynamic_viscosity)) {
            Some((Some(_), Some(_))) => {
                return Err(refused("oil.dynamic_viscosity", "give either viscosity or dynamic_viscosity"));
            }
            Some((Some(kinematic), None)) => match density {
                Some(density) => Some(kinematic.0 * density),
                None => {
                    return Err(refused("oil.viscosity", "the kinematic viscosity needs the density, too"));
                }
            },
            Some((None, dynamic)) => dynamic.map(|viscosity| viscosity.0),
            None => None,
        };
        let turbulent = oil.and_then(|oil| oil.turbulence.as_ref());
        let turbulent =
            turbulent.map(|law| TurbulentLaw { factor: law.factor.get(), exponent: law.exponent.get() });
        let friction = groups.friction.map(|range| {
            let ends = range.closed(0.0..=1.0).map_err(|why| refused("friction", why.to_string()))?;
            Ok::<_, Error>(FrictionRange::new(*ends.start(), *ends.end())?)
        });
        let dead = groups.ports.as_ref().and_then(|ports| ports.dead_volume);
        let dead_area = match (dead, point.width) {
            (None, _) => Area::from_si(0.0),
            (Some(volume), Some(width)) => volume.0 / width,
            (Some(_), None) => {
                return Err(refused("ports.dead_volume", "it needs the width of the wheels, too"));
            }
        };
        Ok(Self {
            viscosity,
            density,
            bulk_modulus: oil.and_then(|oil| oil.bulk_modulus).map(|modulus| modulus.0),
            turbulent,
            gaps: groups.gaps.as_ref().map(|gaps| warm_gaps(gaps, point.width)).transpose()?,
            bore_radius: groups
                .gaps
                .as_ref()
                .and_then(|gaps| gaps.rotor_bore)
                .map_or_else(Length::default, |bore| 0.5 * bore.0),
            friction: friction.transpose()?,
            dead_area,
            discharge: groups.ports.as_ref().and_then(|ports| ports.discharge).map(Number::get),
            most_trapped: groups.ports.as_ref().and_then(|ports| ports.most_trapped).map(|most| most.0),
        })
    }

    /// Oil in the gaps, or the missing keys of its data.
    fn fluid(&self) -> Result<GapFluid, Vec<&'static str>> {
        match (self.viscosity, self.density) {
            (Some(viscosity), Some(density)) => {
                Ok(GapFluid { viscosity, density, turbulent: self.turbulent })
            }
            (None, Some(_)) => Err(vec!["oil.viscosity"]),
            (Some(_), None) => Err(vec!["oil.density"]),
            (None, None) => Err(vec!["oil.viscosity", "oil.density"]),
        }
    }
}

/// Axial gaps at the operating temperature, reduced by thermal expansion.
fn warm_gaps(gaps: &epicyclic_formats::motor::GapsGroup, width: Option<Length>) -> Result<EndGaps, Error> {
    let cold =
        EndGaps { satellite: gaps.satellites.0, rotor: gaps.rotor.map_or(gaps.satellites.0, |gap| gap.0) };
    let (expansion, warmer): (TemperatureCoefficient, TemperatureInterval) =
        match (gaps.expansion, gaps.temperature_rise) {
            (None, None) => return Ok(cold),
            (Some(expansion), Some(warmer)) => (expansion.0, warmer.0),
            (Some(_), None) => return Err(refused("gaps.expansion", "it is with a temperature_rise")),
            (None, Some(_)) => return Err(refused("gaps.temperature_rise", "it is with an expansion")),
        };
    let Some(width) = width else {
        return Err(refused("gaps.temperature_rise", "it needs the width of the wheels, too"));
    };
    let warm = |gap: Length| -> Result<Length, MotorError> {
        // A given gap is half of the play between two faces.
        if gap == Length::default() {
            Ok(gap)
        } else {
            Ok(0.5 * warm_play(2.0 * gap, expansion, width, warmer)?)
        }
    };
    Ok(EndGaps { satellite: warm(cold.satellite)?, rotor: warm(cold.rotor)? })
}
