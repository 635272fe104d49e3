//! The construction of a hydromotor's arcs and of the junction on its rotor, as tables.

use crate::motor::construction::answer::{ConstructedArcs, Departure, Junction, Misfit, MotorConstruction};
use crate::motor::table::{facts, family, numbers, one, title};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::quantities::{optional, remarked};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, headline, warned};
use epicyclic_units::Dimension::{Angle, Length};

impl AsReport for MotorConstruction {
    fn report(&self) -> Report {
        let section = |name, title, rows| facts(name, title, rows, "");
        let title = format!("Construction. {}", title(&self.numbers));
        Report {
            title: Some(headline(title, &self.warnings)),
            parts: vec![
                section("numbers", "Numbers and their conditions", numbers(&self.numbers)),
                section("arcs", "Stator of two arcs, by system (1)", arcs(&self.arcs)),
                section(
                    "closure",
                    "Closure of the rotor, which the document leaves out",
                    misfit(&self.closure),
                ),
                section("junction", "Where the rotor's arcs meet, by (2)-(8)", junction(&self.junction)),
                Part::Records(departures(&self.departures)),
            ],
            warnings: warned(&self.warnings),
        }
    }
}

fn number(name: &'static str, label: &'static str, symbol: &'static str, value: f64) -> Row {
    Row::new(name, label, symbol, [Figure::Number(value)])
}

fn arcs(arcs: &ConstructedArcs) -> Vec<Row> {
    vec![
        one("l", "centre of arc 1 (troughs) from the axis", "l", Length, arcs.l_m),
        one("a", "centre of arc 2 (crests) from the axis", "a", Length, arcs.a_m),
        one("theta3", "angle of a half-lobe of the stator", "θ₃ = π/N", Angle, arcs.theta3_rad),
        one("piece_length", "length of a half-lobe of the stator", "L/(2N)", Length, arcs.piece_length_m),
        one("r1", "radius of arc 1", "R₁", Length, arcs.r1_m),
        one("r2", "radius of arc 2", "R₂", Length, arcs.r2_m),
        one("gamma", "angle of arc 1 at its centre", "Γ", Angle, arcs.gamma_rad),
        one("beta", "angle of arc 2 at its centre", "B", Angle, arcs.beta_rad),
        number("holds_within", "the four equations hold within", "", arcs.holds_within),
    ]
}

fn misfit(misfit: &Misfit) -> Vec<Row> {
    let open = match misfit {
        Misfit { closes: true, .. } => "closes",
        Misfit { open_rad, .. } if *open_rad > 0.0 => "a gap",
        _ => "overlaps the next",
    };
    let mut rows = vec![
        one("due", "a half-lobe of the rotor must span", "π/n", Angle, misfit.due_rad),
        one("span", "it spans", "", Angle, misfit.span_rad),
        remarked(one("open", "it stays open by", "", Angle, misfit.open_rad), open),
        one("open_by_quadrature", "the same by quadrature", "", Angle, misfit.open_by_quadrature_rad),
        remarked(
            number(
                "opened_by_a_hundredth_module_rad",
                "opened by 0.01 modules of error in a",
                "",
                misfit.opened_by_a_hundredth_module_rad,
            ),
            "rad a half-lobe",
        ),
        Row::new(
            "a_that_closes",
            "at this l it closes with",
            "a",
            [optional(Length, misfit.a_that_closes_m)],
        ),
        Row::new(
            "l_that_closes",
            "at this a it closes with",
            "l",
            [optional(Length, misfit.l_that_closes_m)],
        ),
    ];
    rows.extend(family(&misfit.family));
    rows
}

fn junction(junction: &Junction) -> Vec<Row> {
    let rows = [
        (one("op1", "junction of the rotor: distance from the axis", "OP₁", Length, junction.op1_m), "(2)"),
        (number("b", "helper", "b", junction.b), "(3)"),
        (one("op", "junction of the stator: distance from the axis", "OP", Length, junction.op_m), "(4)"),
        (one("pi", "junction of the rotor: angle from its trough", "Π", Angle, junction.pi_rad), "(5)"),
        (number("h", "helper", "h", junction.h), "(6)"),
        (number("k", "helper", "k", junction.k), "(7)"),
        (one("t", "junction of the stator: angle from its trough", "T", Angle, junction.t_rad), "(8)"),
    ];
    rows.map(|(row, equation)| remarked(row, equation)).into()
}

fn departures(departures: &[Departure]) -> Records {
    Table::new("departures", departures)
        .text("equation", "of", |departure| departure.equation)
        .text("printed", "the document prints", |departure| departure.printed)
        .text("used", "used here", |departure| departure.used)
        .all("Departures from the document")
        .records()
}
