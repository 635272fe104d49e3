//! The designs of a search for hydromotors with free tooth forms, as tables.

use crate::motor::answer::GoverningLimit;
use crate::motor::designs::table::{
    Duty, duty_columns, found_and_shown, hidden, number_columns, numbers, of_set, size_columns,
};
use crate::motor::forms::answer::{Crest, Design, Family, Flanks, Funnel, MotorForms, Objective};
use crate::table::figure::{Figure, count as many};
use crate::table::quantities::{column, words};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Row, Section, Text, View, headline, warned};
use epicyclic_units::Dimension::{Angle, Length, Pressure, Volume};

impl AsReport for MotorForms {
    fn report(&self) -> Report {
        let wanted = words(Volume, self.displacement_m3, 5);
        let designs = if self.found == 1 { "design" } else { "designs" };
        Report {
            title: Some(headline(
                format!(
                    "Hydromotors of {wanted} a revolution, tooth form free: {} non-dominated {designs}",
                    self.found
                ),
                &self.warnings,
            )),
            parts: vec![
                Part::Records(records(self)),
                Part::Facts(Section {
                    name: "funnel",
                    title: "Points, each a motor with a tooth form, and what became of them: the first reason counts",
                    columns: &[],
                    rows: funnel(&self.funnel),
                    note: "",
                }),
                Part::Text(Text::paragraph(completeness(self))),
            ],
            warnings: warned(&self.warnings),
        }
    }
}

/// How many were found, how many shown.
#[must_use]
pub fn count(search: &MotorForms) -> String {
    found_and_shown(search.found, search.designs.len())
}

/// What the answer claims of the points that are not listed.
fn completeness(search: &MotorForms) -> String {
    let objectives: Vec<String> = search.objectives.iter().map(objective).collect();
    let (points, objectives) = (search.funnel.points, objectives.join(", "));
    match search.resolution {
        None => format!(
            "Complete: of all {points} points the designs are the exact front in {objectives}, of points equal in all of them one."
        ),
        Some(resolution) => format!(
            "Complete to the resolution: for each of the {points} points that is admissible, tried or not, there is a design that it \
             surpasses in none of {objectives} by more than {}. Motors and forms between the places and steps are not tried.",
            Figure::Share(resolution).table()
        ),
    }
}

/// An objective in words: which ripple is meant.
fn objective(objective: &Objective) -> String {
    match objective {
        Objective::Ripple => "ripple at the pitch points".to_owned(),
        Objective::FlankRipple => "ripple at the flanks".to_owned(),
        other => other.to_string(),
    }
}

fn records(search: &MotorForms) -> Records {
    let mut columns = number_columns();
    columns.extend([
        Column::words("family", "family"),
        Column::words("place", "place").for_people(),
        Column::number("l_over_module", "l/m"),
        Column::number("second_amplitude", "ε₂"),
        Column::headed("pressure_angle", "α, °", Angle),
        Column::number("addendum", "h_a*"),
        Column::number("shift", "x"),
        Column::number("clearance", "c*"),
        Column::number("fillet", "ρ*"),
        Column::number("backlash", "j*"),
        Column::words("crest", "crest"),
        Column::number("displacement_by_volume", "q/V"),
        Column::number("ripple", "δ, pitch"),
        Column::number("least_radius_in_modules", "ϱ/m"),
        Column::number("contact_ratio", "contact"),
        Column::number("designs_of_the_set", "of set"),
        Column::number("flank_ripple", "δ, flanks"),
        Column::number("flank_least_over_mean", "least, flanks"),
        Column::headed("contact_on_path", "p_H, MPa", Pressure),
        Column::headed("root_on_path", "σ_F, MPa", Pressure),
        Column::headed("allowed_on_path", "Δp, MPa", Pressure),
        Column::headed("allowed_by_contact", "contact", Pressure),
        Column::headed("allowed_by_root", "root", Pressure),
        Column::words("governing", "limit"),
        Column::headed("module", "m, mm", Length),
        Column::headed("width", "b, mm", Length),
        Column::headed("outer_diameter", "Ø, mm", Length),
        Column::headed("l", "l, mm", Length),
    ]);
    columns.extend(duty_columns());
    Records {
        name: "designs",
        columns,
        rows: search.designs.iter().map(row).collect(),
        views: views(search),
        is_answer: true,
    }
}

fn views(search: &MotorForms) -> Vec<View> {
    let shapes = View {
        note: format!(
            "Place: l over the module, or ε₂ of the second harmonic. q/V: displacement over the cylinder about the stator's centrode. \
             δ: ripple of flow and torque, satellites sealing at the pitch points, and at the flanks. ϱ: least curvature radius of both \
             centrodes.{}",
            hidden(search.hidden)
        ),
        ..View::new(
            "Designs",
            &[
                "design",
                "lobes",
                "teeth",
                "family",
                "place",
                "displacement_by_volume",
                "ripple",
                "flank_ripple",
                "least_radius_in_modules",
            ],
        )
    };
    let forms = View {
        note: format!(
            "Lengths in modules. Crest: what lies in the middle of the stator's crests. Contact: the shortest path of contact of \
             any flank over the base pitch.{}",
            of_set(search.first_of_each_set)
        ),
        ..View::new(
            "Teeth",
            &[
                "design",
                "pressure_angle",
                "addendum",
                "shift",
                "clearance",
                "fillet",
                "backlash",
                "crest",
                "contact_ratio",
                "designs_of_the_set",
            ],
        )
    };
    let of_flanks = flank_columns(search);
    let stresses = if of_flanks.contains(&"contact_on_path") {
        " Stresses of rigid teeth with all load on one pair of flanks on its whole path: bounds, for comparison."
    } else {
        ""
    };
    let allowed = if of_flanks.contains(&"allowed_on_path") {
        " Δp: what the limits of the material allow so, and by which."
    } else {
        ""
    };
    let flanks = View {
        note: format!(
            "Ripple δ, and least torque over the mean, with satellites that seal at the flanks.{stresses}{allowed}"
        ),
        ..View::new("Flanks under load", &of_flanks)
    };
    let sizes = size_columns(
        &["design", "module", "width", "outer_diameter", "l", "displacement"],
        search.designs.first().map(duty).as_ref(),
        search.designs.iter().any(|design| design.modules_m.len() > 1),
    );
    let sizes = View {
        note: "Of the modules that serve, the one whose width is nearest to half the diameter. Ø of the stator's centrode; teeth \
               and housing come on top. Torque and power without losses, satellites sealing at the pitch points."
            .to_owned(),
        ..View::new("Sizes", &sizes)
    };
    vec![shapes, forms, flanks, sizes]
}

/// What any of the designs has.
fn flank_columns(search: &MotorForms) -> Vec<&'static str> {
    let has = |figure: &dyn Fn(&Flanks) -> bool| {
        search.designs.iter().filter_map(|design| design.flanks.as_ref()).any(figure)
    };
    let mut columns = vec!["design", "flank_ripple", "flank_least_over_mean"];
    if has(&|flanks| flanks.contact_on_path_pa.is_some() || flanks.root_on_path_pa.is_some()) {
        columns.extend(["contact_on_path", "root_on_path"]);
    }
    if has(&|flanks| flanks.allowed.is_some()) {
        columns.extend(["allowed_on_path", "governing"]);
    }
    columns
}

fn duty(design: &Design) -> Duty<'_> {
    let size = &design.size;
    Duty {
        displacement_m3: size.displacement_m3,
        torque_n_m: size.torque_n_m,
        least_torque_n_m: size.least_torque_n_m,
        flow_m3_s: size.flow_m3_s,
        power_w: size.power_w,
        modules_m: &design.modules_m,
    }
}

fn row(design: &Design) -> Vec<Figure> {
    let (form, size) = (&design.form, &design.size);
    let flanks = design.flanks.as_ref();
    let allowed = flanks.and_then(|flanks| flanks.allowed.as_ref());
    let number = |value: Option<f64>| value.map_or(Figure::None, Figure::Number);
    let share = |value: Option<f64>| value.map_or(Figure::None, Figure::Share);
    let mut row = numbers(
        design.design,
        [design.stator_lobes, design.rotor_lobes],
        [design.stator_teeth, design.rotor_teeth, design.satellite_teeth],
    );
    row.extend([
        Figure::choice(design.family, family(design.family)),
        match design.family {
            Family::Arcs => number(design.l_over_module),
            Family::Cosine => Figure::None,
            Family::SecondHarmonic => number(design.second_amplitude),
        },
        number(design.l_over_module),
        number(design.second_amplitude),
        column(Angle, Some(form.pressure_angle_rad)),
        Figure::Number(form.addendum),
        Figure::Number(form.shift),
        Figure::Number(form.clearance),
        Figure::Number(form.fillet),
        Figure::Number(form.backlash),
        match form.crest {
            Crest::Space => Figure::choice(form.crest, "space"),
            Crest::Tooth => Figure::choice(form.crest, "tooth"),
        },
        Figure::Multiple(design.displacement_by_volume),
        Figure::Share(design.ripple),
        Figure::Multiple(design.least_radius_in_modules),
        Figure::Multiple(design.contact_ratio),
        many(design.designs_of_the_set),
        share(flanks.map(|flanks| flanks.ripple)),
        share(flanks.map(|flanks| flanks.least_over_mean)),
        column(Pressure, flanks.and_then(|flanks| flanks.contact_on_path_pa)),
        column(Pressure, flanks.and_then(|flanks| flanks.root_on_path_pa)),
        column(Pressure, allowed.map(|allowed| allowed.on_path_pa)),
        column(Pressure, allowed.map(|allowed| allowed.by_contact_pa)),
        column(Pressure, allowed.map(|allowed| allowed.by_root_pa)),
        allowed
            .map_or(Figure::None, |allowed| Figure::choice(allowed.governing, governing(allowed.governing))),
        column(Length, Some(size.module_m)),
        column(Length, Some(size.width_m)),
        column(Length, Some(size.outer_diameter_m)),
        column(Length, size.l_m),
    ]);
    row.extend(duty(design).figures());
    row
}

const fn family(family: Family) -> &'static str {
    match family {
        Family::Arcs => "arcs",
        Family::Cosine => "cosine",
        Family::SecondHarmonic => "2nd harmonic",
    }
}

const fn governing(limit: GoverningLimit) -> &'static str {
    match limit {
        GoverningLimit::Contact => "contact",
        GoverningLimit::StatorRoot => "stator's roots",
        GoverningLimit::RotorRoot => "rotor's roots",
        GoverningLimit::SatelliteRoot => "satellites' roots",
    }
}

fn funnel(funnel: &Funnel) -> Vec<Row> {
    let row = |name, label, value: u64| Row::new(name, label, "", [many(value)]);
    let refused = |row: Row, remark: &str| Row { remark: remark.to_owned(), ..row };
    let mut rows = vec![
        row("sets", "sets of lobes and teeth", funnel.sets as u64),
        row("outside_limits", "… outside limits of the rotor", funnel.outside_limits as u64),
        row("without_motors", "… with which no motor closes", funnel.without_motors as u64),
        row("motors", "motors at places of their families", funnel.motors as u64),
    ];
    for one in funnel.motors_refused.iter().filter(|one| one.motors > 0) {
        rows.push(refused(row(one.reason.name(), one.reason.words(), one.motors as u64), "motors refused"));
    }
    rows.push(row("forms", "tooth forms", funnel.forms as u64));
    rows.push(row("points", "points: motors × forms", funnel.points));
    if funnel.points_of_refused_motors > 0 {
        rows.push(row("points_of_refused_motors", "… of refused motors", funnel.points_of_refused_motors));
    }
    for one in funnel.refused.iter().filter(|one| one.points > 0) {
        rows.push(refused(row(one.reason.name(), one.reason.words(), one.points), "refused"));
    }
    rows.push(refused(row("as_good", "left out: a design is as good", funnel.as_good), "or little contact"));
    rows.push(row("admissible", "admissible", funnel.admissible));
    rows.push(row("front", "… that no other surpasses", funnel.front as u64));
    rows
}
