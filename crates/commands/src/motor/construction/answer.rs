//! The construction of a stator of two arcs and of the point where its rotor's arcs meet: the document's
//! algorithm, (1)–(8).

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::design::{Place, closed_arcs};
use crate::motor::answer::shape::Interval;
use crate::motor::answer::{Designed, Numbers};
use crate::shared::number::{maybe_si, plain, power_of_ten_above, si};
use crate::tolerance::{CLOSED, rounded};
use epicyclic_hydromotor::arcs::{Known, StatorArcs};
use epicyclic_hydromotor::closure::{self, Family};
use epicyclic_hydromotor::{self as hydromotor, MotorNumbers, junction};
use epicyclic_units::Physical as _;
use epicyclic_units::format;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::PI;
use uom::si::f64::{Angle, Length};

/// The stator's arcs by system (1), how nearly their rotor closes, and the junction of the rotor's arcs by
/// (2)–(8).
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorConstruction {
    /// Lobes, teeth, module.
    pub numbers: Numbers,
    /// The stator's arcs.
    pub arcs: ConstructedArcs,
    /// How nearly the rotor closes.
    pub closure: Misfit,
    /// The junction of the arcs on stator and rotor.
    pub junction: Junction,
    /// Where the equations used here are not those of the document as it is printed.
    pub departures: Vec<Departure>,
    /// A rotor that does not close, has a cusp, or reaches into the stator.
    pub warnings: Vec<Warning>,
}

/// The stator's two arcs by system (1). Angles are at the centres of the arcs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConstructedArcs {
    /// Distance of `O₁`, the centre of arc 1, from the axis.
    pub l_m: f64,
    /// Distance of `O₂`, the centre of arc 2, from the axis.
    pub a_m: f64,
    /// Angle `θ₃ = π/N` of one of the `2N` congruent pieces of the stator.
    pub theta3_rad: f64,
    /// Length `L/(2N)` of such a piece.
    pub piece_length_m: f64,
    /// Radius of arc 1.
    pub r1_m: f64,
    /// Radius of arc 2.
    pub r2_m: f64,
    /// Angle of arc 1.
    pub gamma_rad: f64,
    /// Angle of arc 2.
    pub beta_rad: f64,
    /// The greatest difference of both sides of the four equations, over the right side, rounded up to a
    /// power of ten.
    pub holds_within: f64,
}

/// How nearly a rotor closes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Misfit {
    /// Angle that a half-lobe of a closed rotor spans, `π/n`.
    pub due_rad: f64,
    /// Angle that this half-lobe spans.
    pub span_rad: f64,
    /// How far a half-lobe stays open: what it must span less what it spans; negative where neighbouring
    /// half-lobes overlap.
    pub open_rad: f64,
    /// The opening again, by quadrature of the rolling.
    pub open_by_quadrature_rad: f64,
    /// Whether it closes: is open by no more than the digits of `l` and `a` leave, 10⁻⁵ rad.
    pub closes: bool,
    /// Opening of a half-lobe by an error of 0.01 modules in `a`.
    pub opened_by_a_hundredth_module_rad: f64,
    /// The `a` with which the rotor closes at this `l`; null if no `a` closes it.
    pub a_that_closes_m: Option<f64>,
    /// The `l` with which the rotor closes at this `a`; null if no `l` closes it.
    pub l_that_closes_m: Option<f64>,
    /// Distances `l` for which a motor of these numbers closes; empty where none does.
    pub family: Vec<Interval>,
}

/// The junction `P` of the stator's arcs and its image `P₁` on the rotor. Polar angles are from the troughs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Junction {
    /// Helper `b` of (3).
    pub b: f64,
    /// Helper `h` of (6).
    pub h: f64,
    /// Helper `k` of (7).
    pub k: f64,
    /// Distance `OP` of (4): of `P` from the axis.
    pub op_m: f64,
    /// Angle `T` of (8): polar angle of `P` on the stator.
    pub t_rad: f64,
    /// Distance `OP₁` of (2): of `P₁` from the axis.
    pub op1_m: f64,
    /// Angle `Π` of (5): polar angle of `P₁` on the rotor.
    pub pi_rad: f64,
}

/// An equation that is used here and printed otherwise, or not at all, in the document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Departure {
    /// Which equation or statement.
    pub equation: &'static str,
    /// The equation as the document prints it.
    pub printed: &'static str,
    /// The equation as it is used here.
    pub used: &'static str,
}

/// The departures, in the order of the document; the cases of `rotary-hydromotor` have their reasons.
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

/// A stator of two arcs, which need not close.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constructed {
    /// Lobes and teeth.
    pub numbers: MotorNumbers,
    /// The arcs.
    pub arcs: StatorArcs,
}

impl Constructed {
    /// The stator whose arcs have both distances `l` and `a`.
    ///
    /// # Errors
    /// [`Error::Motor`] for a module or distance that cannot be; [`Error::NoConstruction`] where no arcs
    /// have both distances.
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

    /// The stator of the motor at a place of its family.
    ///
    /// # Errors
    /// [`Error::Motor`] for numbers with which no motor closes and a place outside the family;
    /// [`Error::NoArcs`] for a rotor by the cosine law.
    pub fn of_place(numbers: MotorNumbers, module: Length, place: Place) -> Result<Self, Error> {
        let (_, arcs) = closed_arcs(numbers, module, place)?.ok_or(Error::NoArcs)?;
        Ok(Self { numbers, arcs })
    }

    /// The stator of a motor.
    ///
    /// # Errors
    /// [`Error::NoArcs`] for a rotor by the cosine law.
    pub fn of_motor(designed: &Designed) -> Result<Self, Error> {
        let arcs = *designed.motor.arcs().ok_or(Error::NoArcs)?;
        Ok(Self { numbers: designed.motor.numbers(), arcs })
    }
}

/// Why arcs with these distances are none, or no satellite rolls on them, with what would do.
fn refusal(numbers: MotorNumbers, module: Length, l: Length, why: hydromotor::Error) -> Error {
    let closing = match Family::new(numbers, module).and_then(|family| family.at(l)) {
        Ok(arcs) => {
            format!("at this l the rotor closes with a = {}", format::quantity(arcs.crest_distance(), 6))
        }
        Err(none) => none.to_string(),
    };
    Error::NoConstruction { why, closing }
}

/// The construction of a stator.
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
    // A motor of a curve with cusps is refused for reasons that follow from these.
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
