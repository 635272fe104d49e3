//! Construction of a stator of two arcs, and of the point where its rotor's arcs meet, by the document's
//! algorithm (1)–(8).

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::shape::Interval;
use crate::motor::answer::{Designed, Numbers};
use crate::shared::number::{maybe_si, plain, power_of_ten_above, si};
use crate::tolerance::{CLOSED, rounded};
use epicyclic_hydromotor::arcs::{Known, StatorArcs};
use epicyclic_hydromotor::closure::{self, Family};
use epicyclic_hydromotor::place::Place;
use epicyclic_hydromotor::{self as hydromotor, MotorNumbers, junction};
use epicyclic_units::Physical as _;
use epicyclic_units::format;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::PI;
use uom::si::f64::{Angle, Length};

/// Arcs of the stator by system (1), closure of their rotor, and junction of the rotor's arcs by (2)–(8).
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorConstruction {
    /// Numbers of lobes and teeth, and the module.
    pub numbers: Numbers,
    /// Arcs of the stator.
    pub arcs: ConstructedArcs,
    /// Closure of the rotor.
    pub closure: Misfit,
    /// Junction of the arcs on stator and rotor.
    pub junction: Junction,
    /// Equations used here that differ from those printed in the document.
    pub departures: Vec<Departure>,
    /// Warnings: a rotor that does not close, has a cusp, or reaches into the stator.
    pub warnings: Vec<Warning>,
}

/// Arcs of the stator by system (1). Angles are at the centres of the arcs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConstructedArcs {
    /// Distance of `O₁`, the centre of arc 1, from the axis, in m.
    pub l_m: f64,
    /// Distance of `O₂`, the centre of arc 2, from the axis, in m.
    pub a_m: f64,
    /// Angle `θ₃ = π/N` of one of the `2N` congruent pieces of the stator, in rad.
    pub theta3_rad: f64,
    /// Length `L/(2N)` of a piece of the stator, in m.
    pub piece_length_m: f64,
    /// Radius of arc 1 in m.
    pub r1_m: f64,
    /// Radius of arc 2 in m.
    pub r2_m: f64,
    /// Angle of arc 1 in rad.
    pub gamma_rad: f64,
    /// Angle of arc 2 in rad.
    pub beta_rad: f64,
    /// Greatest relative residual of the four equations, rounded up to a power of ten.
    pub holds_within: f64,
}

/// Closure of a rotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Misfit {
    /// Angle that a half-lobe of a closed rotor spans, `π/n`, in rad.
    pub due_rad: f64,
    /// Angle that this half-lobe spans, in rad.
    pub span_rad: f64,
    /// Closure error of a half-lobe in rad: the angle of a closed rotor minus its own; negative if
    /// neighbouring half-lobes overlap.
    pub open_rad: f64,
    /// Closure error by quadrature of the rolling, in rad.
    pub open_by_quadrature_rad: f64,
    /// Whether the rotor closes: its error is at most what the digits of `l` and `a` leave, 10⁻⁵ rad.
    pub closes: bool,
    /// Closure error of a half-lobe in rad caused by an error of 0.01 modules in `a`.
    pub opened_by_a_hundredth_module_rad: f64,
    /// Distance `a` in m with which the rotor closes at this `l`; null if none exists.
    pub a_that_closes_m: Option<f64>,
    /// Distance `l` in m with which the rotor closes at this `a`; null if none exists.
    pub l_that_closes_m: Option<f64>,
    /// Ranges of the distance `l` for which a motor of these numbers closes; empty if none exists.
    pub family: Vec<Interval>,
}

/// Junction `P` of the stator's arcs and its image `P₁` on the rotor. Polar angles are from the troughs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Junction {
    /// Auxiliary quantity `b` of (3).
    pub b: f64,
    /// Auxiliary quantity `h` of (6).
    pub h: f64,
    /// Auxiliary quantity `k` of (7).
    pub k: f64,
    /// Distance `OP` of (4): of `P` from the axis, in m.
    pub op_m: f64,
    /// Angle `T` of (8): polar angle of `P` on the stator, in rad.
    pub t_rad: f64,
    /// Distance `OP₁` of (2): of `P₁` from the axis, in m.
    pub op1_m: f64,
    /// Angle `Π` of (5): polar angle of `P₁` on the rotor, in rad.
    pub pi_rad: f64,
}

/// Equation used here that the document prints differently, or not at all.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Departure {
    /// Number of the equation, or the statement.
    pub equation: &'static str,
    /// Equation as the document prints it.
    pub printed: &'static str,
    /// Equation as it is used here.
    pub used: &'static str,
}

/// Departures in the order of the document; the cases of `rotary-hydromotor` give their reasons.
const DEPARTURES: [Departure; 7] = [
    Departure { equation: "(1)", printed: "R₁·Γ + R₂·B = L/(2n)", used: "L/(2N), as in θ₃ = π/N" },
    Departure {
        equation: "l and a",
        printed: "two independent parameters",
        used: "one: the rotor closes with one a at each l",
    },
    Departure { equation: "(2)", printed: "O₁P₁ = …", used: "OP₁, from the rotor's centre O" },
    Departure {
        equation: "(4)", printed: "OP = l² + R₁² − 2·l·R₁·cos Γ", used: "OP² = …, the root is lost"
    },
    Departure {
        equation: "(6)",
        printed: "h = (…)/(…), the terms are lost",
        used: "h = ((b + 1)/(b − 1))^½",
    },
    Departure {
        equation: "(7)", printed: "k = b … (b² − 1)", used: "k = (b − R₁/l)·(b² − 1)^−½"
    },
    Departure {
        equation: "(8)",
        printed: "T = arccos …, the argument is lost",
        used: "T = arccos((l − R₁·cos Γ)/OP)",
    },
];

impl Answer for MotorConstruction {
    const NAME: &'static str = "motor-construction";
}

/// Stator of two arcs, which need not close.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constructed {
    /// Numbers of lobes and teeth.
    pub numbers: MotorNumbers,
    /// Arcs of the stator.
    pub arcs: StatorArcs,
}

impl Constructed {
    /// Stator whose arcs have the distances `l` and `a`.
    ///
    /// # Errors
    /// [`Error::Motor`] for an impossible module or distance; [`Error::NoConstruction`] if no arcs have both
    /// distances.
    pub fn of_distances(numbers: MotorNumbers, module: Length, l: Length, a: Length) -> Result<Self, Error> {
        let known = [Known::TroughDistance(l), Known::CrestDistance(a)];
        match StatorArcs::with(numbers, module, known) {
            Ok(arcs) => arcs
                .first()
                .map(|arcs| Self { numbers, arcs: *arcs })
                .ok_or_else(|| unreachable!("arcs that are found are one pair or more")),
            Err(why @ hydromotor::Error::NoArcs { .. }) => Err(refusal(numbers, module, l, why)),
            Err(why) => Err(why.into()),
        }
    }

    /// Stator of the motor at a place of its family.
    ///
    /// # Errors
    /// [`Error::Motor`] for numbers with which no motor closes and a place outside the family;
    /// [`Error::NoArcs`] for a rotor by the cosine law.
    pub fn of_place(numbers: MotorNumbers, module: Length, place: Place) -> Result<Self, Error> {
        let (_, arcs) = place.arcs(numbers, module)?.ok_or(Error::NoArcs)?;
        Ok(Self { numbers, arcs })
    }

    /// Stator of a motor.
    ///
    /// # Errors
    /// [`Error::NoArcs`] for a rotor by the cosine law.
    pub fn of_motor(designed: &Designed) -> Result<Self, Error> {
        let arcs = *designed.motor.arcs().ok_or(Error::NoArcs)?;
        Ok(Self { numbers: designed.motor.numbers(), arcs })
    }
}

/// Error for distances that give no arcs, or arcs on which no satellite rolls, with the values that would
/// work.
fn refusal(numbers: MotorNumbers, module: Length, l: Length, why: hydromotor::Error) -> Error {
    let closing = match Family::new(numbers, module).and_then(|family| family.at(l)) {
        Ok(arcs) => {
            format!("at this l the rotor closes with a = {}", format::quantity(arcs.crest_distance(), 6))
        }
        Err(none) => none.to_string(),
    };
    Error::NoConstruction { why, closing }
}

/// Computes the construction of a stator.
///
/// # Errors
/// [`Error::NoConstruction`] for arcs on which no satellite rolls.
pub fn construction(constructed: &Constructed) -> Result<MotorConstruction, Error> {
    let Constructed { numbers, arcs } = constructed;
    let (l, module) = (arcs.trough_distance(), arcs.module());
    let refused = |why| refusal(*numbers, module, l, why);
    let found = junction::junction(*numbers, arcs).map_err(refused)?;
    let closure = Misfit::of(*numbers, arcs)?;
    Ok(MotorConstruction {
        numbers: Numbers::of(*numbers, module),
        warnings: warnings(*numbers, arcs, &closure),
        arcs: ConstructedArcs::of(arcs),
        closure,
        junction: Junction {
            b: plain(found.b),
            h: plain(found.h),
            k: plain(found.k),
            op_m: si(found.stator_radius),
            t_rad: si(found.stator_angle),
            op1_m: si(found.rotor_radius),
            pi_rad: si(found.rotor_angle),
        },
        departures: DEPARTURES.to_vec(),
    })
}

impl ConstructedArcs {
    fn of(arcs: &StatorArcs) -> Self {
        let missed = arcs.system_misses().map(f64::abs).into_iter().fold(0.0, f64::max);
        Self {
            l_m: si(arcs.trough_distance()),
            a_m: si(arcs.crest_distance()),
            theta3_rad: si(arcs.piece_angle()),
            piece_length_m: si(arcs.piece_length()),
            r1_m: si(arcs.trough_radius()),
            r2_m: si(arcs.crest_radius()),
            gamma_rad: si(arcs.trough_angle()),
            beta_rad: si(arcs.crest_angle()),
            holds_within: power_of_ten_above(missed, CLOSED),
        }
    }
}

impl Misfit {
    fn of(numbers: MotorNumbers, arcs: &StatorArcs) -> Result<Self, Error> {
        let closed = closure::closure(numbers, arcs)?;
        let family = Family::new(numbers, arcs.module()).ok();
        let at = |arcs: fn(&Family, Length) -> Result<StatorArcs, hydromotor::Error>, place| {
            family.as_ref().and_then(|family| arcs(family, place).ok())
        };
        let due = PI / f64::from(numbers.rotor_lobes());
        Ok(Self {
            due_rad: due,
            span_rad: due + closed.residual_rad,
            open_rad: rounded(si(closed.open())),
            open_by_quadrature_rad: rounded(-closed.residual_by_quadrature_rad),
            closes: closed.closes(),
            opened_by_a_hundredth_module_rad: plain(0.01 * closed.by_crest_distance),
            a_that_closes_m: maybe_si(
                at(Family::at, arcs.trough_distance()).map(|arcs| arcs.crest_distance()),
            ),
            l_that_closes_m: maybe_si(
                at(Family::at_crest_distance, arcs.crest_distance()).map(|arcs| arcs.trough_distance()),
            ),
            family: family.iter().flat_map(Interval::all).collect(),
        })
    }
}

fn warnings(numbers: MotorNumbers, arcs: &StatorArcs, misfit: &Misfit) -> Vec<Warning> {
    let mut warnings = vec![];
    if !misfit.closes {
        let how = if misfit.open_rad > 0.0 { "stays open" } else { "overlaps the next" };
        let open = format::quantity(Angle::from_si(misfit.open_rad.abs()), 4);
        let message = format!("the rotor does not close: a half-lobe {how} by {open}");
        warnings.push(Warning { name: "open", message });
    }
    // With cusps the motor would be refused for reasons that only follow from the cusps.
    if !closure::is_smooth(numbers, arcs) {
        let message = "the rotor gets cusps, or the flanks become radial".to_owned();
        warnings.push(Warning { name: "not-smooth", message });
    } else if misfit.closes
        && let Err(why) = hydromotor::Motor::of_two_arcs(numbers, arcs.module(), arcs.trough_distance())
    {
        warnings.push(Warning { name: "no-motor", message: why.to_string() });
    }
    warnings
}
