//! The designs of a search as an answer: shapes, sizes, and what else is to be said of them.

use super::super::lists::subject;
use super::funnel::{self, count};
use super::{Teeth, shown_size, teeth};
use epicyclic_formats::quantity::format::{self, trimmed};
use epicyclic_formats::{Dimension, Physical};
use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::search::{Design, Found, MotorSearch};
use epicyclic_views::figure::{Figure, column, text};
use epicyclic_views::report::{Column, Part, Records, Report, Section, View};

/// The whole answer; `hidden` designs are not shown, `all` were there before teeth were asked for.
pub(super) fn report(
    search: &MotorSearch,
    found: &Found,
    shown: &[(usize, &Design)],
    hidden: usize,
    all: usize,
) -> Report {
    let wanted = format::quantity(search.demand.displacement, 5);
    let count = match found.designs.len() {
        1 => "1 design".to_owned(),
        more => format!("{more} designs"),
    };
    let mut parts = vec![Part::Records(designs(found, shown, hidden)), Part::Records(sizes(shown))];
    parts.push(Part::Facts(Section {
        name: "funnel",
        title: "Motors tried, and where the others fell: the first reason counts",
        columns: &[],
        rows: funnel::rows(found, all),
        note: "",
    }));
    parts.push(Part::Facts(Section {
        name: "spacing_error",
        title: "Between the places tried a motor may be better than a listed one, by estimate",
        columns: funnel::SPACING,
        rows: vec![
            funnel::spacing("most", "at most, in every objective", found.spacing_error),
            funnel::spacing("refinement_gain", "refinement found better by", found.refinement_gain),
        ],
        note: "",
    }));
    Report {
        title: Some(format!("Hydromotors of {wanted} a revolution: {count} that no other surpasses")),
        parts,
        warnings: None,
    }
}

fn designs(found: &Found, shown: &[(usize, &Design)], hidden: usize) -> Records {
    let row = |&(place, design): &(usize, &Design)| {
        let numbers = design.numbers;
        let modules: Vec<String> =
            design.dimensions.iter().map(|size| trimmed(1e3 * size.module.si(), 4)).collect();
        let l_over_module =
            shown_size(design).map_or(f64::NAN, |size| size.trough_distance.si() / size.module.si());
        vec![
            count(place + 1),
            text(format!("{}×{}", numbers.stator_lobes(), numbers.rotor_lobes())),
            Figure::Count(numbers.stator_lobes()),
            Figure::Count(numbers.rotor_lobes()),
            text(format!(
                "{}/{}/{}",
                numbers.stator_teeth(),
                numbers.rotor_teeth(),
                numbers.satellite_teeth()
            )),
            Figure::Count(numbers.stator_teeth()),
            Figure::Count(numbers.rotor_teeth()),
            Figure::Count(numbers.satellite_teeth()),
            Figure::Multiple(l_over_module),
            Figure::Multiple(design.displacement_by_volume),
            Figure::Share(design.ripple),
            Figure::Multiple(design.least_radius),
            match teeth(design) {
                Teeth::Hold => Figure::Answer("hold", "hold"),
                Teeth::Fail => Figure::Answer("fail", "fail"),
                Teeth::None => Figure::Answer("none", "none"),
            },
            Figure::Answer(subject(design.nearest_check).0, short(design.nearest_check)),
            Figure::Share(design.nearest_margin),
            count(found.designs.iter().filter(|other| other.numbers == numbers).count()),
            Figure::Texts(modules),
            Figure::Share(design.spacing_error.displacement_by_volume),
            Figure::Share(design.spacing_error.ripple),
            Figure::Share(design.spacing_error.least_radius),
        ]
    };
    let hidden = match hidden {
        0 => String::new(),
        1 => " 1 more: --limit shows it.".to_owned(),
        hidden => format!(" {hidden} more: --limit shows them."),
    };
    Records {
        name: "designs",
        columns: vec![
            Column::number("design", "no"),
            Column::words("lobes", "N×n"),
            Column::number("stator_lobes", "N"),
            Column::number("rotor_lobes", "n"),
            Column::words("teeth", "Z₃/Z₁/Z_s"),
            Column::number("stator_teeth", "Z₃"),
            Column::number("rotor_teeth", "Z₁"),
            Column::number("satellite_teeth", "Z_s"),
            Column::number("l_over_module", "l/m"),
            Column::number("displacement_by_volume", "q/V"),
            Column::number("ripple", "ripple"),
            Column::number("least_radius_in_modules", "ϱ/m"),
            Column::words("teeth_limits", "teeth"),
            Column::words("nearest_check", "nearest limit"),
            Column::number("nearest_margin", "spare"),
            Column::number("designs_of_the_set", "of set"),
            Column::words("modules_mm", "modules, mm"),
            Column::number("spacing_error_displacement_by_volume", ""),
            Column::number("spacing_error_ripple", ""),
            Column::number("spacing_error_least_radius", ""),
        ],
        rows: shown.iter().map(row).collect(),
        views: vec![View {
            note: format!(
                "q/V: displacement over the cylinder about the stator's centrode. ϱ: least curvature radius of \
                 both centrodes. Teeth: whether the default form keeps its limits (hold, fail) or gives no teeth (none); the search does \
                 not ask, --with-teeth leaves out what fails. \
                 Of set: designs of these numbers, of which the first is shown unless --every is given.{hidden}"
            ),
            ..View::new(
                "Designs",
                &[
                    "design",
                    "lobes",
                    "teeth",
                    "displacement_by_volume",
                    "ripple",
                    "least_radius_in_modules",
                    "nearest_check",
                    "teeth_limits",
                    "designs_of_the_set",
                ],
            )
        }],
        is_answer: true,
    }
}

const fn short(check: Subject) -> &'static str {
    match check {
        Subject::StatorBulge => "stator bulge",
        Subject::StatorHollow => "stator hollow",
        Subject::RotorBulge => "rotor bulge",
        Subject::RotorHollow => "rotor hollow",
        Subject::RotorLeastRadius => "rotor body",
        Subject::Neighbours => "neighbours",
    }
}

fn sizes(shown: &[(usize, &Design)]) -> Records {
    let row = |&(place, design): &(usize, &Design)| {
        let size = shown_size(design);
        let modules: Vec<String> =
            design.dimensions.iter().map(|size| trimmed(1e3 * size.module.si(), 4)).collect();
        vec![
            count(place + 1),
            column(size.map(|size| size.module)),
            column(size.map(|size| size.width)),
            column(size.map(|size| size.outer_diameter)),
            column(size.map(|size| size.trough_distance)),
            column(size.map(|size| size.crest_distance)),
            column(size.map(|size| size.trough_radius)),
            column(size.map(|size| size.crest_radius)),
            column(size.map(|size| size.displacement)),
            column(size.and_then(|size| size.torque)),
            column(size.and_then(|size| size.least_torque)),
            column(size.and_then(|size| size.flow)),
            column(size.and_then(|size| size.power)),
            Figure::Texts(modules),
        ]
    };
    let length = |name, heading: &str| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, Dimension::Length)
    };
    let other = |name, heading: &str, dimension| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, dimension)
    };
    let mut columns = vec!["design", "module", "width", "outer_diameter", "l", "a"];
    let first = shown.first().and_then(|(_, design)| shown_size(design));
    let several = shown.iter().any(|(_, design)| design.dimensions.len() > 1);
    if first.is_some_and(|size| size.torque.is_some()) {
        columns.push("torque");
        columns.push("least_torque");
    }
    if first.is_some_and(|size| size.flow.is_some()) {
        columns.push("flow");
    }
    if first.is_some_and(|size| size.power.is_some()) {
        columns.push("power");
    }
    if several && columns.len() < 9 {
        columns.push("modules_mm");
    }
    Records {
        name: "sizes",
        columns: vec![
            Column::number("design", "no"),
            length("module", "m, mm"),
            length("width", "b, mm"),
            length("outer_diameter", "Ø, mm"),
            length("l", "l, mm"),
            length("a", "a, mm"),
            length("r1", "R₁, mm"),
            length("r2", "R₂, mm"),
            other("displacement", "q, cm³", Dimension::Volume),
            other("torque", "M, N·m", Dimension::Torque),
            other("least_torque", "least", Dimension::Torque),
            other("flow", "l/min", Dimension::VolumeRate),
            other("power", "kW", Dimension::Power),
            Column::words("modules_mm", "all m, mm"),
        ],
        rows: shown.iter().map(row).collect(),
        views: vec![View {
            note: "Of the modules that serve, the one whose width is nearest to half the diameter. Ø of the \
                   stator's centrode; teeth and housing come on top. Torque and power without losses."
                .to_owned(),
            ..View::new("Sizes", &columns)
        }],
        is_answer: false,
    }
}
