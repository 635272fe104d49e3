//! The designs of a search for hydromotors, as tables.

use crate::motor::designs::table::{Duty, Numbers, hidden, numbered, of_set, size_columns, with_duty};
use crate::motor::search::answer::{Design, MotorSearch, SpacingError, TeethLimits};
use crate::motor::table::facts;
use crate::shared::judgement::table as judgement;
use crate::table::figure::{Figure, count as many};
use crate::table::quantities::words;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, View, headline, warned};
use epicyclic_hydromotor::checks::Subject;
use epicyclic_units::Dimension::{Length, Pressure, Volume};

/// The objectives, of which the error is stated.
const OBJECTIVES: &[(&str, &str)] = &[
    ("displacement_by_volume", "q/V"),
    ("ripple", "δ, pitch"),
    ("least_radius", "radius"),
    ("flank_ripple", "δ, flanks"),
    ("least_torque", "least"),
];

impl AsReport for MotorSearch {
    fn report(&self) -> Report {
        let wanted = words(Volume, self.displacement_m3, 5);
        let designs = if self.found == 1 { "design" } else { "designs" };
        Report {
            title: Some(headline(
                format!("Hydromotors of {wanted} a revolution: {} non-dominated {designs}", self.found),
                &self.warnings,
            )),
            parts: vec![
                Part::Records(records(self)),
                facts(
                    "funnel",
                    "Motors tried, and why the others were refused: the first reason counts",
                    funnel(self),
                    "",
                ),
                Part::Facts(Section {
                    name: "between_places",
                    title: "Between the places tried a motor may be better than a listed one, by estimate",
                    columns: OBJECTIVES,
                    rows: vec![
                        spacing("spacing_error", "at most, in every objective", &self.spacing_error),
                        spacing("refinement_gain", "refinement found better by", &self.refinement_gain),
                    ],
                    note: "",
                }),
            ]
            .into_iter()
            .chain(judgement::parts_of_designs(&self.judgement))
            .collect(),
            warnings: warned(&self.warnings),
        }
    }
}

fn spacing(name: &'static str, label: &'static str, error: &SpacingError) -> Row {
    let values = [
        error.displacement_by_volume,
        error.ripple,
        error.least_radius,
        error.flank_ripple,
        error.least_torque,
    ];
    Row::new(name, label, "", values.map(share))
}

fn records(search: &MotorSearch) -> Records {
    let judged = if search.made {
        "On each the teeth of the form keep their limits, and ideal ports can be made."
    } else {
        "Teeth: whether the form keeps its limits (hold, fail) or gives no teeth (none); teeth and ports were not judged."
    };
    let has_contact = search.made && search.designs.iter().any(|design| design.contact_stress_pa.is_some());
    let contact = if has_contact {
        " σ_H: greatest contact stress of steel teeth where one pair of flanks carries alone."
    } else {
        ""
    };
    let (hidden, of_set) = (hidden(search.hidden), of_set(search.first_of_each_set));
    let mut shape_columns = vec![
        "design",
        "lobes",
        "teeth",
        "displacement_by_volume",
        "ripple",
        "flank_ripple",
        "least_radius_in_modules",
        "nearest",
    ];
    shape_columns.extend((!search.made).then_some("teeth_limits"));
    shape_columns.extend(has_contact.then_some("contact_stress"));
    let shapes = View {
        note: format!(
            "q/V: displacement over the cylinder about the stator's centrode. δ: ripple of flow and torque, satellites \
             sealing at the pitch points, and at the flanks. ϱ: least curvature radius of both centrodes. {judged}{contact}{hidden}"
        ),
        ..View::new("Designs", &shape_columns)
    };
    let none = if search.designs.iter().any(|design| design.at_flanks.is_none()) {
        " Without teeth there is nothing at the flanks (-)."
    } else {
        ""
    };
    let flanks = View {
        note: format!(
            "Ripple δ of flow and torque, and their least over the mean, with satellites that seal at the pitch points, and with \
             satellites that seal at the flanks of the form.{none}{of_set}"
        ),
        ..View::new(
            "Satellites sealing at the pitch points, and at the flanks",
            &[
                "design",
                "ripple",
                "least_over_mean",
                "flank_ripple",
                "flank_least_over_mean",
                "designs_of_the_set",
            ],
        )
    };
    let sizes = size_columns(
        &["design", "module", "width", "outer_diameter", "l", "a"],
        search.designs.first().map(duty).as_ref(),
        search.designs.iter().any(|design| design.modules_m.len() > 1),
    );
    let sizes = View {
        note: "Of the modules that serve, the one whose width is nearest to half the diameter. Ø of the stator's \
               centrode; teeth and housing come on top. Torque and power without losses, satellites sealing at the pitch points."
            .to_owned(),
        ..View::new("Sizes", &sizes)
    };
    let table = numbered(&search.designs, |design| Numbers {
        design: design.design,
        lobes: [design.stator_lobes, design.rotor_lobes],
        teeth: [design.stator_teeth, design.rotor_teeth, design.satellite_teeth],
    })
    .multiple("l_over_module", "l/m", |design| design.l_over_module)
    .multiple("displacement_by_volume", "q/V", |design| design.displacement_by_volume)
    .share("ripple", "δ, pitch", |design| design.ripple)
    .share("least_over_mean", "least, pitch", |design| design.least_over_mean)
    .share("flank_ripple", "δ, flanks", |design| Some(design.at_flanks.as_ref()?.ripple))
    .share("flank_least_over_mean", "least, flanks", |design| {
        Some(design.at_flanks.as_ref()?.least_over_mean)
    })
    .words("without_flanks", "", |design| design.without_flanks.clone())
    .multiple("least_radius_in_modules", "ϱ/m", |design| design.least_radius_in_modules)
    .words("teeth_limits", "teeth", |design| match design.teeth_limits {
        TeethLimits::Hold => "hold",
        TeethLimits::Fail => "fail",
        TeethLimits::None => "none",
    })
    .quantity("contact_stress", "σ_H", Pressure, |design| design.contact_stress_pa)
    .words("nearest_check", "nearest limit", |design| {
        Figure::choice(design.nearest_check, short(design.nearest_check))
    })
    .words("nearest", "nearest limit", |design| short(design.nearest_check))
    .for_people()
    .share("nearest_margin", "spare", |design| design.nearest_margin)
    .number("designs_of_the_set", "of set", |design| design.designs_of_the_set)
    .share("spacing_error_displacement_by_volume", "", |design| design.spacing_error.displacement_by_volume)
    .share("spacing_error_ripple", "", |design| design.spacing_error.ripple)
    .share("spacing_error_least_radius", "", |design| design.spacing_error.least_radius)
    .share("spacing_error_flank_ripple", "", |design| design.spacing_error.flank_ripple)
    .share("spacing_error_least_torque", "", |design| design.spacing_error.least_torque)
    .quantity("module", "m", Length, |design| design.size.module_m)
    .quantity("width", "b", Length, |design| design.size.width_m)
    .quantity("outer_diameter", "Ø", Length, |design| design.size.outer_diameter_m)
    .quantity("l", "l", Length, |design| design.size.l_m)
    .quantity("a", "a", Length, |design| design.size.a_m)
    .quantity("r1", "R₁", Length, |design| design.size.r1_m)
    .quantity("r2", "R₂", Length, |design| design.size.r2_m);
    with_duty(table, |design| duty(design)).views(vec![shapes, flanks, sizes]).the_answer().records()
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

fn share(value: Option<f64>) -> Figure {
    value.map_or(Figure::None, Figure::Share)
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

fn funnel(search: &MotorSearch) -> Vec<Row> {
    let funnel = &search.funnel;
    let row = |name, label, value: u64| Row::new(name, label, "", [many(value)]);
    let mut rows = vec![
        row("sets", "sets of lobes and teeth", funnel.sets as u64),
        row("outside_limits", "… outside limits of the rotor", funnel.outside_limits as u64),
        row("without_family", "… with which no motor closes", funnel.without_family as u64),
        row("places", "motors at even places", funnel.places as u64),
        row("refined", "motors added by refinement", funnel.refined as u64),
    ];
    for refused in funnel.refused.iter().filter(|refused| refused.motors > 0) {
        let (name, label) = (refused.reason.name(), refused.reason.words());
        rows.push(Row { remark: "refused".to_owned(), ..row(name, label, refused.motors) });
    }
    rows.push(row("accepted", "motors that pass", funnel.accepted as u64));
    rows.push(row("front", "… that no other surpasses", funnel.front as u64));
    rows.push(row("apart", "designs, alike ones once", funnel.apart as u64));
    rows
}
