//! Gearboxes side by side.

use crate::compare::answer::{
    Compared, ComparedGear, Comparison, Differs, FigureName, GearFigure, GearsBy, Value,
};
use crate::table::columns::Table;
use crate::table::figure::{Figure, text};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Text, warned};
use epicyclic_units::Dimension;

impl AsReport for Comparison {
    fn report(&self) -> Report {
        let letters = letters(self.gearboxes.len());
        let from =
            |one: &Compared| if one.from == one.gearbox { String::new() } else { format!(" ({})", one.from) };
        let legend = self.gearboxes.iter().zip(&letters);
        let legend = legend.map(|(one, letter)| format!("  {letter}: {}{}", one.gearbox, from(one)));
        let mut parts = vec![Part::Text(Text {
            heading: Some("Gearboxes".to_owned()),
            lines: legend.collect(),
            ..Text::default()
        })];
        parts.push(Part::Records(whole(self, &letters)));
        let beside = match self.gears_by {
            GearsBy::Name => "Gears of one name stand beside each other.",
            GearsBy::Ratio => {
                "The gears have different names: those of like ratio, within a fifth, stand beside each other."
            }
        };
        parts.push(Part::Text(Text::paragraph(beside)));
        let shown = OF_GEAR.iter().filter(|(figure, _)| is_told(self, *figure));
        let names_stand_alone = self.gears_by == GearsBy::Ratio;
        parts.extend(shown.map(|(figure, title)| {
            let with_names = names_stand_alone && *figure == FigureName::Ratio;
            Part::Records(gears(self, &letters, *figure, title, with_names))
        }));
        parts.push(Part::Records(shift_elements(self, &letters)));
        parts.push(Part::Records(all(self, &letters)));
        let judged = self.gearboxes.iter().zip(&letters);
        let judged = judged.filter(|(one, _)| !one.judgement.checks.is_empty());
        let judged: Vec<String> =
            judged.map(|(one, letter)| format!("{letter}: {}", one.judgement.summary())).collect();
        if !judged.is_empty() {
            parts.push(Part::Text(Text {
                heading: Some("Rules of practice".to_owned()),
                paragraphs: judged,
                ..Text::default()
            }));
        }
        Report { title: None, parts, warnings: warned(&self.warnings) }
    }
}

/// A, B, …, Z, A1, B1, …
fn letters(count: usize) -> Vec<String> {
    let letter = |place: usize| {
        let letter = char::from(b'A' + (place % 26) as u8);
        if place < 26 { letter.to_string() } else { format!("{letter}{}", place / 26) }
    };
    (0..count).map(letter).collect()
}

/// What is told gear by gear, in the order of the tables.
const OF_GEAR: &[(FigureName, &str)] = &[
    (FigureName::Ratio, "Ratios"),
    (FigureName::Step, "Steps"),
    (FigureName::Efficiency, "Efficiencies"),
    (FigureName::CirculatingPower, "Circulating power over what enters"),
    (FigureName::PlanetSpeed, "Largest planet speeds, relative to the carriers over the input's"),
    (FigureName::OutputSpeedRadS, "Speeds of the output, rpm"),
    (FigureName::OutputTorqueNM, "Torques on the gearbox at the output, N·m"),
    (FigureName::LossW, "Power lost, kW"),
];

/// What a figure at the operating point measures.
const fn dimension(figure: FigureName) -> Option<Dimension> {
    match figure {
        FigureName::OutputSpeedRadS => Some(Dimension::AngularSpeed),
        FigureName::OutputTorqueNM => Some(Dimension::Torque),
        FigureName::LossW => Some(Dimension::Power),
        _ => None,
    }
}

fn words(figure: FigureName) -> &'static str {
    match figure {
        FigureName::Sets => "planet sets",
        FigureName::Members => "members of the sets",
        FigureName::Links => "links that can turn",
        FigureName::Brakes => "brakes",
        FigureName::Clutches => "clutches",
        FigureName::OneWayClutches => "one-way clutches",
        FigureName::Gears => "gears",
        FigureName::Spread => "spread",
        FigureName::LargestStep => "largest step",
        FigureName::SmallestStep => "smallest step",
        FigureName::SingleTransitions => "single-transition shifts",
        FigureName::DoubleTransitions => "double-transition shifts",
        FigureName::MultipleTransitions => "multiple-transition shifts",
        FigureName::LowestEfficiency => "lowest efficiency",
        FigureName::LargestCirculatingPower => "largest circulating power",
        FigureName::LargestLinkSpeed => "largest speed of a link",
        FigureName::LargestPlanetSpeed => "largest planet speed",
        FigureName::LargestBrakeTorque => "largest torque of a brake",
        FigureName::LargestClutchTorque => "largest torque of a clutch",
        FigureName::LargestBrakeSlip => "largest slip of a brake",
        FigureName::LargestClutchSlip => "largest slip of a clutch",
        FigureName::Ratio => "ratio",
        FigureName::Step => "step",
        FigureName::Efficiency => "efficiency",
        FigureName::CirculatingPower => "circulating power",
        FigureName::LinkSpeed => "speed of a link",
        FigureName::PlanetSpeed => "planet speed",
        FigureName::OutputSpeedRadS => "output_speed_rpm",
        FigureName::OutputTorqueNM => "output_torque_n_m",
        FigureName::LossW => "loss_kw",
    }
}

fn is_count(figure: FigureName) -> bool {
    use FigureName as F;
    matches!(
        figure,
        F::Sets
            | F::Members
            | F::Links
            | F::Brakes
            | F::Clutches
            | F::OneWayClutches
            | F::Gears
            | F::SingleTransitions
            | F::DoubleTransitions
            | F::MultipleTransitions
    )
}

/// Where a part of a whole is compared, the difference itself says more than its part of the first.
fn is_part_of_1(figure: FigureName) -> bool {
    use FigureName as F;
    matches!(figure, F::Efficiency | F::LowestEfficiency | F::CirculatingPower | F::LargestCirculatingPower)
}

/// A difference as it is marked.
fn difference(figure: FigureName, differs: Differs) -> Figure {
    let Some(by) = differs.difference else { return Figure::None };
    if is_count(figure) {
        return text(format!("{by:+.0}"));
    }
    match differs.relative_difference.filter(|_| !is_part_of_1(figure)) {
        Some(relative) => text(format!("{:+.2} %", 100.0 * relative)),
        None => text(format!("{by:+.4}")),
    }
}

fn value(figure: FigureName, value: f64) -> Figure {
    match dimension(figure) {
        Some(dimension) => Figure::Column { si: value, dimension },
        None if is_count(figure) => Figure::Number(value),
        None => Figure::Multiple(value),
    }
}

/// The value, and in which gear and part it is.
fn placed(figure: FigureName, of: Option<&Value>) -> Figure {
    let Some(of) = of else { return Figure::None };
    let place = match (&of.part, &of.gear) {
        (Some(part), Some(gear)) => format!(" ({part} in {gear})"),
        (None, Some(gear)) => format!(" ({gear})"),
        (Some(part), None) => format!(" ({part})"),
        (None, None) => String::new(),
    };
    text(value(figure, of.value).table() + &place)
}

/// The gearboxes as a whole.
fn whole(comparison: &Comparison, letters: &[String]) -> Records {
    let most = if letters.len() > 2 { ", where it is largest" } else { "" };
    let note = format!(
        "In brackets: the gear, or shift element or set and gear; of a step the gear that it leads to. Torques, speeds and \
         powers over the input's. Difference: from {}{most}.",
        letters.first().map_or("", String::as_str)
    );
    Table::new("whole", &comparison.figures)
        .text("figure", "", |one| words(one.figure))
        .each(letters.iter().enumerate(), |table, (place, letter)| {
            table.words("value", "", |one| placed(one.figure, one.values[place].as_ref())).of(letter)
        })
        .number("difference", "difference", |one| difference(one.figure, one.differs))
        .all("As a whole")
        .note(note)
        .records()
}

fn figure_of(gear: &ComparedGear, name: FigureName) -> Option<&GearFigure> {
    gear.figures.iter().find(|figure| figure.figure == name)
}

/// Whether any gear has a value of it that is not nothing.
fn is_told(comparison: &Comparison, name: FigureName) -> bool {
    let figures = comparison.gears.iter().filter_map(|gear| figure_of(gear, name));
    figures.flat_map(|figure| figure.values.iter().flatten()).any(|value| *value != 0.0)
}

/// What gears are called: by one name, or by that of each gearbox.
fn named(gear: &ComparedGear) -> String {
    let mut names: Vec<&str> = gear.gears.iter().map(|gear| gear.as_deref().unwrap_or("-")).collect();
    names.dedup();
    match names[..] {
        [one] => one.to_owned(),
        _ => gear.gears.iter().map(|gear| gear.as_deref().unwrap_or("-")).collect::<Vec<_>>().join(" | "),
    }
}

/// One figure gear by gear.
fn gears(
    comparison: &Comparison,
    letters: &[String],
    name: FigureName,
    title: &str,
    explains_names: bool,
) -> Records {
    let rows = comparison.gears.iter().filter_map(|gear| {
        let figure = figure_of(gear, name)?;
        figure.values.iter().any(Option::is_some).then_some((gear, figure))
    });
    let note =
        if explains_names { format!("Gear: those of {}.", letters.join(" | ")) } else { String::new() };
    Table::new("gears", rows)
        .words("gear", "gear", |(gear, _)| named(gear))
        .each(letters.iter().enumerate(), |table, (place, letter)| {
            table.number("value", "", |(_, of)| of.values[place].map(|of| value(name, of))).of(letter)
        })
        .number("difference", "difference", |(_, figure)| difference(name, figure.differs))
        .all(title)
        .note(note)
        .records()
}

/// The largest torque and slip of each shift element.
fn shift_elements(comparison: &Comparison, letters: &[String]) -> Records {
    let rows = comparison.gearboxes.iter().zip(letters);
    let rows = rows.flat_map(|(one, letter)| one.shift_elements.iter().map(move |element| (letter, element)));
    let at = &comparison.operating_point;
    let mut shown = vec![
        "gearbox",
        "shift_element",
        "kind",
        "torque_of_input",
        "torque_gear",
        "slip_of_input",
        "slip_gear",
    ];
    shown.extend((at.torque_n_m.is_some() || at.power_w.is_some()).then_some("torque"));
    shown.extend(at.speed_rad_s.map(|_| "slip"));
    Table::new("shift_elements", rows)
        .text("gearbox", "", |(letter, _)| letter)
        .text("shift_element", "element", |(_, one)| &one.element.shift_element)
        .words("kind", "kind", |(_, one)| crate::analyze::table::kind_of(one.element.kind))
        .multiple("torque_of_input", "T", |(_, one)| one.torque_of_input)
        .words("torque_gear", "in gear", |(_, one)| one.torque_gear.clone())
        .multiple("slip_of_input", "slip", |(_, one)| one.slip_of_input)
        .words("slip_gear", "in gear", |(_, one)| one.slip_gear.clone())
        .quantity("torque", "T", Dimension::Torque, |(_, one)| one.torque_n_m)
        .quantity("slip", "slip", Dimension::AngularSpeed, |(_, one)| one.slip_rad_s)
        .view_of("Shift elements: largest torque and slip", &shown)
        .note("T, slip: over the input's torque, with losses, and its speed.")
        .records()
}

/// For CSV: a line for each figure of the whole and of each gear.
fn all(comparison: &Comparison, letters: &[String]) -> Records {
    // A quantity in the unit that its name has.
    let number = |figure: FigureName, value: f64| match dimension(figure) {
        Some(dimension) => Figure::Column { si: value, dimension },
        None => Figure::Number(value),
    };
    let name = |figure: FigureName| match dimension(figure) {
        Some(_) => text(words(figure)),
        None => Figure::choice(figure, words(figure)),
    };
    let place = |of: &Option<Value>| match of {
        Some(of) => (Some(of.value), of.gear.clone(), of.part.clone()),
        None => (None, None, None),
    };
    let whole = comparison.figures.iter().map(|one| {
        (String::new(), one.figure, one.differs, one.values.iter().map(place).collect::<Vec<_>>())
    });
    let gears = comparison.gears.iter().flat_map(|gear| {
        gear.figures.iter().map(move |one| {
            let values = one.values.iter().zip(&gear.gears);
            let values = values.map(|(value, gear)| (*value, gear.clone(), None));
            (named(gear), one.figure, one.differs, values.collect())
        })
    });
    Table::new("figures", whole.chain(gears))
        .text("gear", "gear", |(gear, ..)| gear)
        .words("figure", "figure", |(_, figure, ..)| name(*figure))
        .each(letters.iter().enumerate(), |table, (place, letter)| {
            table.number("value", "", |(_, of, _, all)| all[place].0.map(|one| number(*of, one))).of(letter)
        })
        .number("difference", "difference", |(_, of, differs, _)| {
            differs.difference.map(|by| number(*of, by))
        })
        .number("relative_difference", "relative_difference", |(_, _, differs, _)| {
            differs.relative_difference
        })
        .each(letters.iter().enumerate(), |table, (place, letter)| {
            table
                .words("gear", "", |(.., all)| all[place].1.clone())
                .of(letter)
                .words("part", "", |(.., all)| all[place].2.clone())
                .of(letter)
        })
        .the_answer()
        .records()
}
