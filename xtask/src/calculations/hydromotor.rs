//! Calculations of hydromotors with non-circular wheels.

use super::{Calculation, Refusal, Results};
use epicyclic_hydromotor::arcs::{Known, StatorArcs};
use epicyclic_hydromotor::centrode::{CurvePoint, Wheel};
use epicyclic_hydromotor::closure::{Family, Limit, closure};
use epicyclic_hydromotor::junction::junction;
use epicyclic_hydromotor::{Motor, MotorNumbers};
use epicyclic_units::{Number, Physical, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::PI;
use uom::si::curvature::radian_per_meter;
use uom::si::f64::{Angle, Length};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new(
            "hydromotor.numbers",
            "conditions on the lobes and teeth of a hydromotor",
            motor_numbers,
        ),
        Calculation::new(
            "hydromotor.arcs",
            "the stator's arcs from two of their six parameters",
            stator_arcs,
        ),
        Calculation::new(
            "hydromotor.closure",
            "which arcs close: the family, and one of its motors",
            closed_arcs,
        ),
        Calculation::new("hydromotor.junction", "formulas (2)-(8) of rotary-hydromotor", rotor_junction),
        Calculation::new("hydromotor.contact", "where a satellite touches both wheels", contact),
        Calculation::new(
            "hydromotor.rotor",
            "curvature of the rotor, and how nearly it consists of arcs",
            rotor,
        ),
        Calculation::new(
            "hydromotor.working",
            "chambers, displacement and ripple at the pitch points",
            working,
        ),
        Calculation::new(
            "hydromotor.lobes_and_ripple",
            "pulses and ripple of motors, and whether the nearest N/n to 1 has the least ripple",
            lobes_and_ripple,
        ),
    ]
}

/// Lobes and teeth.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NumbersGiven {
    /// Lobes of the stator, N.
    stator_lobes: u32,
    /// Lobes of the rotor, n.
    rotor_lobes: u32,
    /// Teeth of the stator, `Z_3`.
    stator_teeth: u32,
    /// Teeth of the rotor, `Z_1`, where they are to be checked; `n·Z_3/N` unless given.
    #[serde(default)]
    rotor_teeth: Option<u32>,
    /// Teeth of a satellite, `Z_s`.
    satellite_teeth: u32,
}

impl TryFrom<NumbersGiven> for MotorNumbers {
    type Error = Refusal;

    fn try_from(given: NumbersGiven) -> Result<Self, Refusal> {
        let (stator, rotor) = (given.stator_lobes, given.rotor_lobes);
        let (teeth, satellite) = (given.stator_teeth, given.satellite_teeth);
        Ok(match given.rotor_teeth {
            None => Self::new(stator, rotor, teeth, satellite)?,
            Some(rotor_teeth) => Self::with_rotor_teeth(stator, rotor, teeth, rotor_teeth, satellite)?,
        })
    }
}

/// Lobes and teeth of a motor.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ConditionsGiven {
    /// Lobes and teeth.
    numbers: NumbersGiven,
}

fn motor_numbers(given: &ConditionsGiven) -> Result<Results, Refusal> {
    let numbers = MotorNumbers::try_from(given.numbers)?;
    let mut results = Results::default();
    results
        .count("rotor_teeth", numbers.rotor_teeth())
        .count("teeth_per_lobe", numbers.teeth_per_lobe())
        .count("satellites", numbers.satellites())
        .number("lobe_ratio", numbers.lobe_ratio())
        .count("common_divisor", numbers.common_divisor())
        .answer("bearing_reactions_vanish", numbers.bearing_reactions_vanish());
    Ok(results)
}

/// Two of the six parameters of system (1).
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ArcsGiven {
    /// Lobes and teeth.
    numbers: NumbersGiven,
    /// Module.
    module: Quantity<Length>,
    /// Distance of the centre of arc 1 from the axis.
    #[serde(default)]
    l: Option<Quantity<Length>>,
    /// Distance of the centre of arc 2 from the axis.
    #[serde(default)]
    a: Option<Quantity<Length>>,
    /// Radius of arc 1, `R₁`.
    #[serde(default)]
    r1: Option<Quantity<Length>>,
    /// Radius of arc 2, `R₂`.
    #[serde(default)]
    r2: Option<Quantity<Length>>,
    /// Angle of arc 1, `Γ`.
    #[serde(default)]
    gamma: Option<Quantity<Angle>>,
    /// Angle of arc 2, `B`.
    #[serde(default)]
    beta: Option<Quantity<Angle>>,
}

fn stator_arcs(given: &ArcsGiven) -> Result<Results, Refusal> {
    let numbers = MotorNumbers::try_from(given.numbers)?;
    let known: Vec<Known> = [
        given.l.map(|l| Known::TroughDistance(l.0)),
        given.a.map(|a| Known::CrestDistance(a.0)),
        given.r1.map(|r1| Known::TroughRadius(r1.0)),
        given.r2.map(|r2| Known::CrestRadius(r2.0)),
        given.gamma.map(|gamma| Known::TroughAngle(gamma.0)),
        given.beta.map(|beta| Known::CrestAngle(beta.0)),
    ]
    .into_iter()
    .flatten()
    .collect();
    let &[first, second] = known.as_slice() else {
        return Err(Refusal {
            name: "two-parameters".into(),
            message: format!(
                "{} of l, a, r1, r2, gamma and beta are given: two determine the arcs",
                known.len()
            ),
        });
    };
    let solutions = StatorArcs::with(numbers, given.module.0, [first, second])?;
    let mut results = Results::default();
    results.count("solutions", solutions.len() as i64);
    for (i, arcs) in solutions.iter().enumerate() {
        let prefix = if i == 0 { String::new() } else { format!("{}.", i + 1) };
        of_arcs(&mut results, &prefix, arcs);
        // What the four equations leave, each over its greatest term.
        let [l, a, r1, r2] =
            [arcs.trough_distance(), arcs.crest_distance(), arcs.trough_radius(), arcs.crest_radius()]
                .map(Physical::si);
        let [gamma, beta] = [arcs.trough_angle(), arcs.crest_angle()].map(Physical::si);
        let theta = PI / f64::from(numbers.stator_lobes());
        let share = PI * given.module.0.si() * f64::from(numbers.teeth_per_lobe()) / 2.0;
        let distance = (a * a + l * l - 2.0 * a * l * libm::cos(theta)).sqrt();
        let left = [
            (r1 + r2 - distance) / distance,
            (r1 * gamma + r2 * beta - share) / share,
            ((r1 + r2) / libm::sin(theta) - a / libm::sin(gamma)) * libm::sin(theta) / distance,
            beta - theta - gamma,
        ];
        results.answer(format!("{prefix}system_holds"), left.iter().all(|left| left.abs() < 1e-12));
    }
    Ok(results)
}

fn of_arcs(results: &mut Results, prefix: &str, arcs: &StatorArcs) {
    results
        .quantity(format!("{prefix}l"), arcs.trough_distance())
        .quantity(format!("{prefix}a"), arcs.crest_distance())
        .quantity(format!("{prefix}r1"), arcs.trough_radius())
        .quantity(format!("{prefix}r2"), arcs.crest_radius())
        .quantity(format!("{prefix}gamma"), arcs.trough_angle())
        .quantity(format!("{prefix}beta"), arcs.crest_angle());
}

/// A motor of two arcs.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MotorGiven {
    /// Lobes and teeth.
    numbers: NumbersGiven,
    /// Module.
    module: Quantity<Length>,
    /// Distance of the centre of arc 1 from the axis.
    l: Quantity<Length>,
}

impl MotorGiven {
    fn motor(&self) -> Result<Motor, Refusal> {
        Ok(Motor::of_two_arcs(self.numbers.try_into()?, self.module.0, self.l.0)?)
    }
}

fn closed_arcs(given: &MotorGiven) -> Result<Results, Refusal> {
    let numbers = MotorNumbers::try_from(given.numbers)?;
    let family = Family::new(numbers, given.module.0)?;
    let arcs = family.at(given.l.0)?;
    let found = closure(numbers, &arcs)?;
    let mut results = Results::default();
    of_arcs(&mut results, "", &arcs);
    let closes = |residual: f64, reach: f64| residual.abs() <= reach;
    results
        .answer("closes", closes(found.residual_rad, 1e-12))
        .answer("closes_by_quadrature", closes(found.residual_by_quadrature_rad, 1e-11))
        // Of l and a, where the closure answers to both.
        .count("independent_parameters", if found.by_crest_distance == 0.0 { 2 } else { 1 })
        .number("slope", found.slope)
        .count("family.intervals", family.intervals().len() as i64);
    for (i, interval) in family.intervals().iter().enumerate() {
        for (name, end) in [("lower", interval.lower), ("upper", interval.upper)] {
            if let Some(arcs) = end.arcs() {
                results.quantity(format!("family.{i}.{name}"), arcs.trough_distance());
            }
            let limit = match end.limit {
                Limit::NoTroughArc => "no trough arc",
                Limit::RotorCusp => "rotor cusp",
                Limit::RadialFlank => "radial flank",
                Limit::GreatestRadius => "greatest radius",
            };
            results.text(format!("family.{i}.{name}_limit"), limit);
        }
    }
    Ok(results)
}

fn rotor_junction(given: &MotorGiven) -> Result<Results, Refusal> {
    let numbers = MotorNumbers::try_from(given.numbers)?;
    let motor = given.motor()?;
    let arcs = motor.arcs().ok_or_else(no_arcs)?;
    let found = junction(numbers, arcs)?;
    let half_lobe = |lobes: u32| Angle::from_si(PI / f64::from(lobes));
    let mut results = Results::default();
    results
        .number("b", found.b)
        .number("h", found.h)
        .number("k", found.k)
        .quantity("stator_radius", found.stator_radius)
        .quantity("stator_angle", found.stator_angle)
        .quantity("rotor_radius", found.rotor_radius)
        .quantity("rotor_angle", found.rotor_angle)
        .quantity("stator_angle_from_crest", half_lobe(numbers.stator_lobes()) - found.stator_angle)
        .quantity("rotor_angle_from_crest", half_lobe(numbers.rotor_lobes()) - found.rotor_angle);
    Ok(results)
}

fn no_arcs() -> Refusal {
    Refusal { name: "no-arcs".into(), message: "the motor has no two arcs".into() }
}

/// A place along a half-lobe.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum PlaceGiven {
    Crest,
    MiddleOfArc2,
    Junction,
    MiddleOfArc1,
    Trough,
}

/// A contact of a satellite.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ContactGiven {
    /// The motor.
    motor: MotorGiven,
    /// Where on the stator's half-lobe.
    place: PlaceGiven,
}

fn contact(given: &ContactGiven) -> Result<Results, Refusal> {
    let motor = given.motor.motor()?;
    let arcs = motor.arcs().ok_or_else(no_arcs)?;
    let crest_arc = arcs.crest_radius() * arcs.crest_angle().si();
    let trough_arc = arcs.trough_radius() * arcs.trough_angle().si();
    let rolled = match given.place {
        PlaceGiven::Crest => crest_arc * 0.0,
        PlaceGiven::MiddleOfArc2 => crest_arc * 0.5,
        PlaceGiven::Junction => crest_arc,
        PlaceGiven::MiddleOfArc1 => crest_arc + trough_arc * 0.5,
        PlaceGiven::Trough => crest_arc + trough_arc,
    };
    let contact = motor.contact_at_stator_arc(rolled)?;
    let mut results = Results::default();
    results
        .quantity("rotation", contact.rotation)
        .quantity("stator_angle", contact.stator_angle)
        .quantity("stator_radius", contact.stator_radius)
        .quantity("rotor_radius", contact.rotor_radius)
        .quantity("rotor_angle", contact.rotor_angle)
        .quantity("stator_arc", contact.stator_arc)
        .quantity("rotor_arc", contact.rotor_arc);
    Ok(results)
}

fn rotor(given: &MotorGiven) -> Result<Results, Refusal> {
    let motor = given.motor()?;
    let arcs = motor.arcs().ok_or_else(no_arcs)?;
    let rotor = motor.centrode(Wheel::Rotor);
    let junction = motor.contact_at_stator_arc(arcs.crest_radius() * arcs.crest_angle().si())?;
    let radius = |point: CurvePoint| Length::from_si(point.curvature.get::<radian_per_meter>().recip());
    let half_lobe = rotor.length() / (2.0 * f64::from(motor.numbers().rotor_lobes()));
    let hair = junction.rotor_arc * 1e-9;
    let fit = motor.two_arc_fit();
    let circles = motor.published_circles().ok_or_else(no_arcs)?;
    let mut results = Results::default();
    results
        .quantity("curvature_radius.crest", radius(rotor.at(half_lobe * 0.0)?))
        .quantity("curvature_radius.end_of_crest_image", radius(rotor.at(junction.rotor_arc - hair)?))
        .quantity("curvature_radius.start_of_trough_image", radius(rotor.at(junction.rotor_arc + hair)?))
        .quantity("curvature_radius.trough", radius(rotor.at(half_lobe)?))
        .quantity("best_arcs_deviation", fit.deviation)
        .quantity("published_circles.deviation", circles.deviation)
        .quantity("published_circles.kink", circles.kink)
        // Arcs would miss by rounding alone.
        .answer("consists_of_arcs", fit.deviation < motor.module() * 1e-9);
    Ok(results)
}

fn working(given: &MotorGiven) -> Result<Results, Refusal> {
    let motor = given.motor()?;
    let [least, greatest] = motor.chamber_extremes();
    let ripple = motor.ripple();
    let mut results = Results::default();
    results
        .quantity("least_chamber", least)
        .quantity("greatest_chamber", greatest)
        .quantity("chamber_change", greatest - least)
        .quantity("displacement_per_width", motor.displacement_per_width())
        .number("ripple", ripple.delta)
        .quantity("least_neighbour_distance", motor.least_neighbour_distance().0)
        .quantity("outer_diameter", motor.envelope().stator_outer);
    Ok(results)
}

/// Motors to compare, each at the same part of its family.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LobesAndRippleGiven {
    /// Lobes and teeth of each.
    motors: Vec<NumbersGiven>,
    /// Module.
    module: Quantity<Length>,
    /// Part of the family of each, from 0 to 1.
    part: Number,
}

fn lobes_and_ripple(given: &LobesAndRippleGiven) -> Result<Results, Refusal> {
    let mut results = Results::default();
    let mut compared = vec![];
    for numbers in &given.motors {
        let numbers = MotorNumbers::try_from(*numbers)?;
        let arcs = Family::new(numbers, given.module.0)?.at_part(given.part.get())?;
        let ripple = Motor::of_two_arcs(numbers, given.module.0, arcs.trough_distance())?.ripple().delta;
        let name = format!("{}x{}", numbers.rotor_lobes(), numbers.stator_lobes());
        results
            .number(format!("{name}.lobe_ratio"), numbers.lobe_ratio())
            .count(format!("{name}.pulses_per_cycle"), numbers.pulses_per_cycle())
            .count(format!("{name}.pulses_per_revolution"), numbers.pulses_per_revolution())
            .number(format!("{name}.ripple"), ripple);
        compared.push((numbers.lobe_ratio(), ripple));
    }
    let orders = compared.iter().all(|one| compared.iter().all(|other| one.0 >= other.0 || one.1 < other.1));
    results.answer("nearer_ratio_fluctuates_less", orders);
    Ok(results)
}
