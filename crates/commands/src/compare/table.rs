//! Gearboxes side by side.

use crate::compare::answer::{
    Compared, ComparedFigure, ComparedGear, Comparison, Differs, FigureName, GearFigure, GearsBy, Value,
};
use crate::table::figure::{Figure, multiple, text};
use crate::table::quantities::column;
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Text, View, warned};
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
    let columns = [Column::words("figure", "")]
        .into_iter()
        .chain(letters.iter().map(|letter| Column::words("value", "").of(letter)))
        .chain([Column::number("difference", "difference")]);
    let row = |figure: &ComparedFigure| {
        let values = figure.values.iter().map(|value| placed(figure.figure, value.as_ref()));
        [text(words(figure.figure))]
            .into_iter()
            .chain(values)
            .chain([difference(figure.figure, figure.differs)])
            .collect()
    };
    let most = if letters.len() > 2 { ", where it is largest" } else { "" };
    Records {
        name: "whole",
        rows: comparison.figures.iter().map(row).collect(),
        views: vec![View {
            note: format!(
                "In brackets: the gear, or shift element or set and gear; of a step the gear that it leads to. Torques, speeds and \
                 powers over the input's. Difference: from {}{most}.",
                letters.first().map_or("", String::as_str)
            ),
            ..View::new("As a whole", &["figure", "value", "difference"])
        }],
        columns: columns.collect(),
        is_answer: false,
    }
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
    let columns = [Column::words("gear", "gear")]
        .into_iter()
        .chain(letters.iter().map(|letter| Column::number("value", "").of(letter)))
        .chain([Column::number("difference", "difference")]);
    let row = |gear: &ComparedGear| {
        let figure = figure_of(gear, name)?;
        figure.values.iter().flatten().next()?;
        let values = figure.values.iter().map(|of| of.map_or(Figure::None, |of| value(name, of)));
        Some(
            [text(named(gear))].into_iter().chain(values).chain([difference(name, figure.differs)]).collect(),
        )
    };
    let note =
        if explains_names { format!("Gear: those of {}.", letters.join(" | ")) } else { String::new() };
    Records {
        name: "gears",
        rows: comparison.gears.iter().filter_map(row).collect(),
        views: vec![View { note, ..View::new(title, &["gear", "value", "difference"]) }],
        columns: columns.collect(),
        is_answer: false,
    }
}

/// The largest torque and slip of each shift element.
fn shift_elements(comparison: &Comparison, letters: &[String]) -> Records {
    let rows = comparison.gearboxes.iter().zip(letters).flat_map(|(one, letter)| {
        one.shift_elements.iter().map(move |element| {
            let gear = |gear: &Option<String>| gear.as_ref().map_or(Figure::None, text);
            vec![
                text(letter),
                text(&element.element.shift_element),
                crate::analyze::table::kind_of(element.element.kind),
                multiple(element.torque_of_input),
                gear(&element.torque_gear),
                multiple(element.slip_of_input),
                gear(&element.slip_gear),
                column(Dimension::Torque, element.torque_n_m),
                column(Dimension::AngularSpeed, element.slip_rad_s),
            ]
        })
    });
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
    if at.torque_n_m.is_some() || at.power_w.is_some() {
        shown.push("torque");
    }
    if at.speed_rad_s.is_some() {
        shown.push("slip");
    }
    Records {
        name: "shift_elements",
        rows: rows.collect(),
        columns: vec![
            Column::words("gearbox", ""),
            Column::words("shift_element", "element"),
            Column::words("kind", "kind"),
            Column::number("torque_of_input", "T"),
            Column::words("torque_gear", "in gear"),
            Column::number("slip_of_input", "slip"),
            Column::words("slip_gear", "in gear"),
            Column::headed("torque", "T, N·m", Dimension::Torque),
            Column::headed("slip", "slip, rpm", Dimension::AngularSpeed),
        ],
        views: vec![View {
            note: "T, slip: over the input's torque, with losses, and its speed.".to_owned(),
            ..View::new("Shift elements: largest torque and slip", &shown)
        }],
        is_answer: false,
    }
}

/// For CSV: a line for each figure of the whole and of each gear.
fn all(comparison: &Comparison, letters: &[String]) -> Records {
    let names = ["gear", "figure"].map(|name| Column::words(name, name));
    let values = letters.iter().map(|letter| Column::number("value", "").of(letter));
    let differences = ["difference", "relative_difference"].map(|name| Column::number(name, name));
    let places =
        letters.iter().flat_map(|letter| ["gear", "part"].map(|what| Column::words(what, "").of(letter)));
    // A quantity in the unit that its name has.
    let number = |figure: FigureName, value: Option<f64>| match (value, dimension(figure)) {
        (None, _) => Figure::None,
        (Some(si), Some(dimension)) => Figure::Column { si, dimension },
        (Some(value), None) => Figure::Number(value),
    };
    let name = |name: Option<&String>| text(name.cloned().unwrap_or_default());
    let row = |gear: String,
               figure: FigureName,
               values: Vec<Option<f64>>,
               differs: Differs,
               places: Vec<Figure>| {
        let differences = [
            number(figure, differs.difference),
            differs.relative_difference.map_or(Figure::None, Figure::Number),
        ];
        let figures = values.into_iter().map(|value| number(figure, value)).chain(differences);
        let name = match dimension(figure) {
            Some(_) => text(words(figure)),
            None => Figure::choice(figure, words(figure)),
        };
        [text(gear), name].into_iter().chain(figures).chain(places).collect()
    };
    let whole = comparison.figures.iter().map(|figure| {
        let values = || figure.values.iter().map(Option::as_ref);
        let places = values().flat_map(|of| {
            [name(of.and_then(|of| of.gear.as_ref())), name(of.and_then(|of| of.part.as_ref()))]
        });
        let places = places.collect();
        row(
            String::new(),
            figure.figure,
            values().map(|of| of.map(|of| of.value)).collect(),
            figure.differs,
            places,
        )
    });
    let gears = comparison.gears.iter().flat_map(|gear| {
        gear.figures.iter().map(|figure| {
            let places = gear.gears.iter().flat_map(|own| [name(own.as_ref()), name(None)]).collect();
            row(named(gear), figure.figure, figure.values.clone(), figure.differs, places)
        })
    });
    Records {
        name: "figures",
        rows: whole.chain(gears).collect(),
        columns: names.into_iter().chain(values).chain(differences).chain(places).collect(),
        views: vec![],
        is_answer: true,
    }
}
