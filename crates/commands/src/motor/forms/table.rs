//! The designs of a search for hydromotors with free tooth forms, as tables.

use crate::motor::answer::GoverningLimit;
use crate::motor::designs::table::{Duty, Numbers, hidden, numbered, of_set, size_columns, with_duty};
use crate::motor::forms::answer::{Allowed, Crest, Design, Family, Flanks, Funnel, MotorForms, Objective};
use crate::motor::table::facts;
use crate::shared::judgement::table as judgement;
use crate::table::figure::{Figure, count as many};
use crate::table::quantities::words;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Text, View, headline, warned};
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
                facts(
                    "funnel",
                    "Points, each a motor with a tooth form, and what became of them: the first reason counts",
                    funnel(&self.funnel),
                    "",
                ),
                Part::Text(Text::paragraph(completeness(self))),
            ]
            .into_iter()
            .chain(judgement::parts_of_designs(&self.judgement))
            .collect(),
            warnings: warned(&self.warnings),
        }
    }
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
    let table = numbered(&search.designs, |design| Numbers {
        design: design.design,
        lobes: [design.stator_lobes, design.rotor_lobes],
        teeth: [design.stator_teeth, design.rotor_teeth, design.satellite_teeth],
    })
    .words("family", "family", |design| Figure::choice(design.family, family(design.family)))
    .words("place", "place", |design| match design.family {
        Family::Arcs => design.l_over_module,
        Family::Cosine => None,
        Family::SecondHarmonic => design.second_amplitude,
    })
    .for_people()
    .number("l_over_module", "l/m", |design| design.l_over_module)
    .number("second_amplitude", "ε₂", |design| design.second_amplitude)
    .headed("pressure_angle", "α, °", Angle, |design| design.form.pressure_angle_rad)
    .number("addendum", "h_a*", |design| design.form.addendum)
    .number("shift", "x", |design| design.form.shift)
    .number("clearance", "c*", |design| design.form.clearance)
    .number("fillet", "ρ*", |design| design.form.fillet)
    .number("backlash", "j*", |design| design.form.backlash)
    .words("crest", "crest", |design| match design.form.crest {
        crest @ Crest::Space => Figure::choice(crest, "space"),
        crest @ Crest::Tooth => Figure::choice(crest, "tooth"),
    })
    .multiple("displacement_by_volume", "q/V", |design| design.displacement_by_volume)
    .share("ripple", "δ, pitch", |design| design.ripple)
    .multiple("least_radius_in_modules", "ϱ/m", |design| design.least_radius_in_modules)
    .multiple("contact_ratio", "contact", |design| design.contact_ratio)
    .number("designs_of_the_set", "of set", |design| design.designs_of_the_set)
    .share("flank_ripple", "δ, flanks", |design| Some(design.flanks.as_ref()?.ripple))
    .share("flank_least_over_mean", "least, flanks", |design| Some(design.flanks.as_ref()?.least_over_mean))
    .quantity("contact_on_path", "p_H", Pressure, |design| design.flanks.as_ref()?.contact_on_path_pa)
    .quantity("root_on_path", "σ_F", Pressure, |design| design.flanks.as_ref()?.root_on_path_pa)
    .quantity("allowed_on_path", "Δp", Pressure, |design| Some(allowed(design)?.on_path_pa))
    .headed("allowed_by_contact", "contact", Pressure, |design| Some(allowed(design)?.by_contact_pa))
    .headed("allowed_by_root", "root", Pressure, |design| Some(allowed(design)?.by_root_pa))
    .words("governing", "limit", |design| {
        allowed(design).map(|allowed| Figure::choice(allowed.governing, governing(allowed.governing)))
    })
    .quantity("module", "m", Length, |design| design.size.module_m)
    .quantity("width", "b", Length, |design| design.size.width_m)
    .quantity("outer_diameter", "Ø", Length, |design| design.size.outer_diameter_m)
    .quantity("l", "l", Length, |design| design.size.l_m);
    with_duty(table, |design| duty(design)).views(views(search)).the_answer().records()
}

/// The pressure drop that the material allows.
fn allowed(design: &Design) -> Option<&Allowed> {
    design.flanks.as_ref()?.allowed.as_ref()
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
        rows.push(refused(row(one.reason.name(), one.reason.words(), one.motors), "motors refused"));
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
