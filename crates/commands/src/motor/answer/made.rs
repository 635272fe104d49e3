//! Manufacturing data of a motor, checked (material, oil, gaps, friction, ports), and the results that
//! follow.

pub(crate) mod losses;
pub(crate) mod ports;

use super::faults::Faults;
use crate::answer::Warning;
use crate::error::Error;
use epicyclic_formats::motor::{GapsGroup, Keys, MaterialGroup, PortGroup, PortsGroup};
use epicyclic_hydromotor::efficiency::LossInputs;
use epicyclic_hydromotor::flanks::{MaterialLimits, effective_modulus};
use epicyclic_hydromotor::friction::FrictionRange;
use epicyclic_hydromotor::leakage::{EndGaps, GapFluid, TurbulentLaw, warm_play};
use epicyclic_hydromotor::ports::timing::Timing;
use epicyclic_hydromotor::ports::{PortPlate, PortShape};
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::quantity::Quantity;
use epicyclic_hydromotor::{Error as MotorError, Motor, machine, ranges};
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
    /// Axial gaps at operating temperature.
    pub(crate) gaps: Option<EndGaps>,
}

/// Operating point of a motor with its tooth form.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point {
    pub(crate) form: ToothForm,
    pub(crate) width: Option<Length>,
    pub(crate) pressure: Option<Pressure>,
    pub(crate) speed: Option<AngularVelocity>,
}

/// Quantities of the groups, each checked by itself, as far as they are given.
pub(crate) struct Inputs {
    modulus: Pressure,
    limits: Option<MaterialLimits>,
    viscosity: Option<DynamicViscosity>,
    density: Option<MassDensity>,
    bulk_modulus: Option<Pressure>,
    turbulent: Option<TurbulentLaw>,
    gaps: Option<EndGaps>,
    bore_radius: Length,
    friction: Option<FrictionRange>,
    holes: Option<Holes>,
    dead_area: Area,
    discharge: Option<f64>,
    most_trapped: Option<Pressure>,
}

/// Ports as described.
#[derive(Clone, Copy)]
enum Holes {
    /// Round holes at the ideal places, of this part of the greatest diameter.
    Ideal(f64),
    /// Ports at high and at low pressure.
    Shapes { high: PortShape, low: PortShape },
}

fn refused(key: &'static str, message: impl Into<String>) -> Error {
    Error::MotorKey { key, message: message.into() }
}

impl Made {
    /// Results of these inputs.
    ///
    /// # Errors
    /// All independent faults of the calculations.
    pub(crate) fn of(motor: &Motor, inputs: &Inputs, point: Point) -> Result<Self, Faults> {
        let mut faults = Faults::default();
        let ports = inputs.holes.and_then(|holes| faults.keep(plate(motor, holes)));
        let port_figures = ports
            .as_ref()
            .and_then(|(plate, timing)| faults.keep(MadePorts::of(plate, timing, inputs, point)));
        let plate = ports.as_ref().map(|(plate, _)| plate);
        let losses = faults.keep(Losses::of(motor, plate, inputs, point)).flatten();
        let &Inputs { modulus, limits, most_trapped, bulk_modulus, dead_area, gaps, .. } = inputs;
        faults.or(Self {
            modulus,
            limits,
            ports,
            port_figures,
            most_trapped,
            bulk_modulus,
            dead_area,
            losses,
            gaps,
        })
    }

    /// Leakage, friction, efficiencies.
    #[must_use]
    pub fn losses(&self) -> Option<&Losses> {
        self.losses.as_ref()
    }

    /// Warnings about the ports as manufactured.
    pub(crate) fn port_warnings(&self) -> Vec<Warning> {
        self.port_figures.as_ref().map(MadePorts::warnings).unwrap_or_default()
    }
}

/// Effective modulus of steel teeth.
pub(crate) fn steel() -> Result<Pressure, Error> {
    Ok(effective_modulus([Pressure::from_si(STEEL_GPA * 1e9); 2], [POISSON; 2])?)
}

/// Effective modulus and limits of the material.
fn material(
    group: Option<&MaterialGroup>,
    faults: &mut Faults,
) -> Option<(Pressure, Option<MaterialLimits>)> {
    let Some(group) = group else { return Some((faults.keep(steel())?, None)) };
    let usual = Pressure::from_si(STEEL_GPA * 1e9);
    let youngs = group.youngs_modulus.map_or(usual, |modulus| modulus.0);
    let poisson = group.poissons_ratio.map_or(POISSON, Number::get);
    let is_sound = [
        faults.keep(effective_modulus([youngs; 2], [POISSON; 2])),
        faults.keep(effective_modulus([usual; 2], [poisson; 2])),
    ];
    let (contact, root) = (group.contact_limit.map(|limit| limit.0), group.root_limit.map(|limit| limit.0));
    for (quantity, limit) in [(Quantity::ContactLimit, contact), (Quantity::RootLimit, root)] {
        limit.and_then(|limit| faults.keep(ranges::stress_limit(quantity, limit)));
    }
    match (contact, root) {
        (Some(_), None) => faults.push(refused(
            "material.contact_limit",
            "the allowed pressure needs both limits: give root_limit, too",
        )),
        (None, Some(_)) => faults.push(refused(
            "material.root_limit",
            "the allowed pressure needs both limits: give contact_limit, too",
        )),
        _ => {}
    }
    if is_sound.contains(&None) {
        return None;
    }
    let modulus = faults.keep(effective_modulus([youngs; 2], [poisson; 2]))?;
    let limits = contact.zip(root).map(|(contact, root)| MaterialLimits { contact, root, modulus });
    Some((modulus, limits))
}

/// The plate of the ports, with the angles at which they open and close.
fn plate(motor: &Motor, holes: Holes) -> Result<(PortPlate, Timing), MotorError> {
    let plate = match holes {
        Holes::Ideal(part) => PortPlate::of_ideal_holes(motor, part),
        Holes::Shapes { high, low } => PortPlate::new(motor, high, low),
    }?;
    let timing = plate.timing()?;
    Ok((plate, timing))
}

fn holes(group: &PortsGroup, faults: &mut Faults) -> Option<Holes> {
    let refused = match (group.part, &group.high) {
        (Some(_), Some(_)) => refused("ports.high", "give either part, of the ideal holes, or high"),
        (None, None) => refused("ports", "give part, of the ideal holes, or high, the port at high pressure"),
        (Some(_), None) if group.low.is_some() => {
            refused("ports.low", "holes by part are at the ideal places: give high in its place")
        }
        (Some(part), None) => return Some(Holes::Ideal(part.get())),
        (None, Some(high)) => {
            let high = faults.keep(shape(high, "ports.high"));
            let low = match &group.low {
                Some(low) => faults.keep(shape(low, "ports.low")),
                None => high.map(PortShape::mirrored),
            };
            return Some(Holes::Shapes { high: high?, low: low? });
        }
    };
    faults.push(refused);
    None
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
    /// Checks every value that is given, whichever motor it is of.
    ///
    /// # Errors
    /// All independent faults.
    pub(crate) fn of(groups: &Groups, point: Point) -> Result<Self, Faults> {
        let mut faults = Faults::default();
        let width = point.width.and_then(|width| faults.keep(machine::width(width)));
        if point.pressure.is_some_and(|pressure| pressure.value <= 0.0) {
            faults.push(Error::PressureDrop);
        }
        if point.speed.is_some_and(|speed| speed.value <= 0.0) {
            faults.push(Error::RotorSpeed);
        }
        faults.extend(point.form.faults());
        let material = material(groups.material.as_ref(), &mut faults);
        let oil = groups.oil.as_ref();
        let density = oil.and_then(|oil| oil.density).map(|density| density.0);
        let is_dense = density.is_none_or(|density| faults.keep(ranges::density(density)).is_some());
        let viscosity = match oil.map(|oil| (oil.viscosity, oil.dynamic_viscosity)) {
            Some((Some(_), Some(_))) => {
                faults.push(refused("oil.dynamic_viscosity", "give either viscosity or dynamic_viscosity"));
                None
            }
            Some((Some(kinematic), None)) => {
                if density.is_none() {
                    faults.push(refused("oil.viscosity", "the kinematic viscosity needs the density, too"));
                }
                // Of a wrong density the dynamic viscosity would be wrong, too.
                density.filter(|_| is_dense).map(|density| kinematic.0 * density)
            }
            Some((None, dynamic)) => dynamic.map(|viscosity| viscosity.0),
            None => None,
        };
        viscosity.and_then(|viscosity| faults.keep(ranges::viscosity(viscosity)));
        let bulk_modulus = oil.and_then(|oil| oil.bulk_modulus).map(|modulus| modulus.0);
        bulk_modulus.and_then(|modulus| faults.keep(ranges::bulk_modulus(modulus)));
        let turbulent = oil.and_then(|oil| oil.turbulence.as_ref()).map(|law| {
            let (factor, exponent) = (law.factor.get(), law.exponent.get());
            faults.keep(ranges::turbulent_factor(factor));
            faults.keep(ranges::turbulent_exponent(exponent));
            TurbulentLaw { factor, exponent }
        });
        let friction = groups.friction.and_then(|range| {
            let ends = range.closed(0.0..=1.0).map_err(|why| refused("friction", why.to_string()));
            let ends = faults.keep(ends)?;
            faults.keep(FrictionRange::new(*ends.start(), *ends.end()))
        });
        let gaps = groups.gaps.as_ref();
        let bore_radius = gaps.and_then(|gaps| gaps.rotor_bore).map(|bore| 0.5 * bore.0).unwrap_or_default();
        let gaps = gaps.and_then(|gaps| {
            let given = [(Quantity::SatelliteGap, Some(gaps.satellites)), (Quantity::RotorGap, gaps.rotor)];
            let given = given.into_iter().filter_map(|(quantity, gap)| Some((quantity, gap?.0)));
            let refused: Vec<MotorError> =
                given.filter_map(|(quantity, gap)| ranges::gap(quantity, gap).err()).collect();
            if refused.is_empty() {
                faults.keep(warm_gaps(gaps, point.width, width))?
            } else {
                faults.extend(refused);
                None
            }
        });
        let ports = groups.ports.as_ref();
        let holes = ports.and_then(|ports| holes(ports, &mut faults));
        let discharge = ports.and_then(|ports| ports.discharge).map(Number::get);
        discharge.and_then(|discharge| faults.keep(ranges::discharge_coefficient(discharge)));
        let dead_area = match (ports.and_then(|ports| ports.dead_volume), width) {
            (Some(volume), Some(width)) => volume.0 / width,
            (Some(_), None) if point.width.is_none() => {
                faults.push(refused("ports.dead_volume", "it needs the width of the wheels, too"));
                Area::default()
            }
            _ => Area::default(),
        };
        faults.keep(ranges::dead_area(dead_area));
        let most_trapped = ports.and_then(|ports| ports.most_trapped).map(|most| most.0);
        // Without faults of the material both of its values are there.
        let (modulus, limits) = material.unwrap_or_default();
        faults.or(Self {
            modulus,
            limits,
            viscosity,
            density,
            bulk_modulus,
            turbulent,
            gaps,
            bore_radius,
            friction,
            holes,
            dead_area,
            discharge,
            most_trapped,
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

/// Axial gaps at the operating temperature, reduced by thermal expansion; `None` if that needs the width,
/// which has a fault.
fn warm_gaps(
    gaps: &GapsGroup,
    given_width: Option<Length>,
    width: Option<Length>,
) -> Result<Option<EndGaps>, Error> {
    let cold =
        EndGaps { satellite: gaps.satellites.0, rotor: gaps.rotor.map_or(gaps.satellites.0, |gap| gap.0) };
    let (expansion, warmer): (TemperatureCoefficient, TemperatureInterval) =
        match (gaps.expansion, gaps.temperature_rise) {
            (None, None) => return Ok(Some(cold)),
            (Some(expansion), Some(warmer)) => (expansion.0, warmer.0),
            (Some(_), None) => return Err(refused("gaps.expansion", "it is with a temperature_rise")),
            (None, Some(_)) => return Err(refused("gaps.temperature_rise", "it is with an expansion")),
        };
    let Some(width) = width else {
        return match given_width {
            Some(_) => Ok(None),
            None => Err(refused("gaps.temperature_rise", "it needs the width of the wheels, too")),
        };
    };
    let warm = |gap: Length| -> Result<Length, MotorError> {
        // A given gap is half of the play between two faces.
        if gap == Length::default() {
            Ok(gap)
        } else {
            Ok(0.5 * warm_play(2.0 * gap, expansion, width, warmer)?)
        }
    };
    Ok(Some(EndGaps { satellite: warm(cold.satellite)?, rotor: warm(cold.rotor)? }))
}
