//! Speeds of mining machines, as tables.

use crate::machine::answer::{
    ChainCutter, Cutting, Drum, Machine, MachineSpeeds, Machines, Rock, Rotor, Series, SpeedRange,
};
use crate::table::columns::Table;
use crate::table::figure::{Figure, text};
use crate::table::quantities::quantity;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, Text};
use epicyclic_schemes::ratio_series::Regime;
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

fn report(parts: Vec<Part>) -> Report {
    Report { title: None, parts, warnings: None }
}

impl AsReport for Machines {
    fn report(&self) -> Report {
        let mut parts = vec![Part::Records(machines(&self.machines))];
        if self.machines.len() > 1 {
            parts.push(Part::Text(Text::paragraph(format!(
                "{} of {} bucket wheels with a number of steps have the number that table 2.1 recommends. The table is drawn up for \
                 bucket wheels, and applied to no other machine. At the ends of its intervals, and for d above 4, the number is this program's choice.",
                self.as_recommended, self.bucket_wheels_with_steps
            ))));
        }
        report(parts)
    }
}

fn machines(machines: &[Machine]) -> Records {
    Table::new("machines", machines)
        .text("machine", "machine", |machine| machine.machine)
        .text("kind", "drive", |machine| machine.kind)
        .text("table", "table", |machine| machine.table)
        .printed("range", "d", 2, |machine| machine.range)
        .number("speeds", "speeds", |machine| machine.speeds.map_or(text("stepless"), Figure::Count))
        .number("recommended", "recommended", |machine| machine.recommended)
        .words("as_recommended", "agree", |machine| machine.as_recommended)
        .words("recommendation_is_printed", "printed", |machine| machine.recommendation_is_printed)
        .view(
            "Machines: range d of the fastest speed over the slowest, and numbers of speeds",
            "machine kind range speeds recommended as_recommended",
        )
        .the_answer()
        .records()
}

/// A range of speeds, and how many of them it asks for.
fn range_rows(label: &'static str, range: &SpeedRange) -> Vec<Row> {
    let mut rows = vec![Row::new("range", label, "d", [Figure::Multiple(range.range)])];
    rows.extend(range.recommended.map(|speeds| Row {
        remark: match range.recommendation_is_printed {
            Some(false) => "this program's choice: the source leaves this range open".to_owned(),
            _ => "table 2.1, for bucket wheels alone".to_owned(),
        },
        ..Row::new("recommended", "speeds recommended", "", [Figure::Count(speeds)])
    }));
    rows
}

fn facts(name: &'static str, title: &'static str, rows: Vec<Row>) -> Section {
    Section { name, title, columns: &[], rows, note: "" }
}

impl AsReport for MachineSpeeds {
    fn report(&self) -> Report {
        let speeds = &self.speeds;
        let count = u32::try_from(speeds.speeds).unwrap_or(u32::MAX);
        let rows = vec![
            Row::new("speeds", "speeds wanted", "λ", [Figure::Count(count)]),
            Row::new("first_step", "fastest over the next", "q", [Figure::Multiple(speeds.first_step)]),
            Row::new(
                "geometric_step",
                "step of a geometric series",
                "",
                [Figure::Multiple(speeds.geometric_step)],
            ),
        ];
        report(vec![
            Part::Facts(facts("speeds", "Speeds", rows)),
            Part::Facts(facts("range", "Range", range_rows("fastest over slowest", &self.range))),
            Part::Records(series(&self.series)),
        ])
    }
}

fn series(all: &[Series]) -> Records {
    let printed = |series: &Series| match &series.printed {
        None => text(""),
        Some(printed) if printed.serves => text("the same"),
        Some(printed) => Figure::Numbers(printed.ratios.clone()),
    };
    Table::new("series", all)
        .number("direct", "direct drive", |series| series.direct)
        .words("regime", "regime", |series| match series.regime {
            Regime::Reduction => "reduction",
            Regime::Overdrive => "overdrive",
            Regime::Combined => "combined",
        })
        .words("ratios", "ratios", |series| Figure::Numbers(series.ratios.clone()))
        .words("printed", "as printed", |series| printed(series))
        .for_people()
        .words("printed_number", "number", |series| Some(series.printed.as_ref()?.number))
        .words("printed_ratios", "ratios as printed", |series| {
            Some(Figure::Numbers(series.printed.as_ref()?.ratios.clone()))
        })
        .words("printed_serves", "serves", |series| Some(series.printed.as_ref()?.serves))
        .view("Ratios", "direct regime ratios printed")
        .note(
            "Ratios: the fastest speed first. Direct drive: its place among them. The source calls the \
             combined regime undesirable. Its series are for speeds in geometric progression; where one \
             does not give these speeds, the last column shows it.",
        )
        .records()
}

impl AsReport for ChainCutter {
    fn report(&self) -> Report {
        cutter("Chain cutter, v = 1.07·l·v_n/h", &self.cutting, &self.rocks, self.range.as_ref())
    }
}

impl AsReport for Drum {
    fn report(&self) -> Report {
        cutter("Drum, v = 5.24·D·v_n/(h·m)", &self.cutting, &self.rocks, self.range.as_ref())
    }
}

fn cutter(title: &'static str, cutting: &Cutting, rocks: &[Rock], range: Option<&SpeedRange>) -> Report {
    let rows = vec![
        Row::new("speed", "cutting speed", "v", [quantity(Dimension::Speed, cutting.speed_m_s)]),
        Row {
            remark: format!("{} m/min", trimmed(60.0 * cutting.feed_m_s, 5)),
            ..Row::new("feed", "feed", "v_n", [quantity(Dimension::Speed, cutting.feed_m_s)])
        },
    ];
    let mut parts = vec![Part::Facts(facts("cutting", title, rows))];
    if !rocks.is_empty() {
        parts.push(Part::Records(in_rocks(rocks)));
    }
    parts.extend(
        range.map(|range| Part::Facts(facts("range", "Range", range_rows("fastest over slowest", range)))),
    );
    report(parts)
}

fn in_rocks(rocks: &[Rock]) -> Records {
    Table::new("rocks", rocks)
        .quantity("force", "force", Dimension::Force, |rock| rock.force_n)
        .quantity("speed", "speed", Dimension::Speed, |rock| rock.speed_m_s)
        .quantity("feed", "feed", Dimension::Speed, |rock| rock.feed_m_s)
        .view("In this rock and in others, at the same power and chip", "force speed feed")
        .records()
}

impl AsReport for Rotor {
    fn report(&self) -> Report {
        let row = |name, label, symbol, speed_rad_s: f64| Row {
            remark: format!("{} rad/s", trimmed(speed_rad_s, 5)),
            ..Row::new(name, label, symbol, [quantity(Dimension::AngularSpeed, speed_rad_s)])
        };
        let rows = vec![
            row("optimal", "one bucket per chip", "ω_po", self.wheel.optimal_rad_s),
            row("greatest", "greatest", "ω_max", self.wheel.greatest_rad_s),
            row("least", "least", "ω_min", self.wheel.least_rad_s),
        ];
        let mut parts = vec![Part::Facts(facts("wheel", "Bucket wheel", rows))];
        if self.discharges.iter().any(|one| one.chute_rad.is_some()) {
            parts.push(Part::Records(discharges(self)));
        }
        let mut range = facts("range", "Range", range_rows("greatest over least", &self.range));
        if self.range.range <= 1.0 {
            range.note =
                "No speed serves: the wheel would have to turn faster to throw than it may to empty.";
        }
        parts.push(Part::Facts(range));
        report(parts)
    }
}

fn discharges(rotor: &Rotor) -> Records {
    Table::new("discharges", rotor.discharges.iter())
        .headed("chute", "chute at, deg", Dimension::Angle, |one| one.chute_rad)
        .multiple("discharge", "Ω", |one| one.discharge)
        .words("counts", "counts", |one| one.counts)
        .view("Discharge parameter: the smaller counts", "chute discharge counts")
        .records()
}
