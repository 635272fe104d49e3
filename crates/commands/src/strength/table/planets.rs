//! Planets: axial forces of helical teeth, bearings.

use crate::strength::answer::records::{AxialForce, BearingOverDuty, Thrusts};
use crate::table::columns::Table;
use crate::table::figure::{Figure, hours};
use crate::table::report::Records;
use epicyclic_units::Dimension;

pub(super) fn axial_forces(all: &[AxialForce]) -> Records {
    let of_steps = all.iter().any(|one| one.step.is_some());
    let shown: &[&'static str] = if of_steps {
        &["set", "step", "gear", "body", "mesh_axial_force", "axial_force", "thrusts", "tilting_moment"]
    } else {
        &["set", "gear", "body", "mesh_axial_force", "axial_force", "thrusts", "tilting_moment"]
    };
    let largest =
        |one: &&AxialForce| one.meshes.iter().map(|mesh| mesh.axial_force_n.abs()).fold(0.0, f64::max);
    let note = "F_a: the largest of one mesh; ΣF_a: of all meshes of the body, above 0 along the thumb of a right hand whose fingers point along the positive rotation; \
                without losses and load factors. M: by which they tilt a planet or a gear of a pair. Lives of planet bearings contain M where `bearing_span` is given.";
    Table::new("axial_forces", all.iter())
        .text("set", "set", |one| &one.set)
        .text("gear", "gear", |one| &one.gear)
        .number("step", "step", |one| one.step)
        .text("body", "on", |one| &one.body)
        .quantity("mesh_axial_force", "F_a", Dimension::Force, largest)
        .quantity("axial_force", "ΣF_a", Dimension::Force, |one| one.axial_force_n)
        .words("thrusts", "meshes", |one| {
            one.thrusts.map(|thrusts| {
                let words = match thrusts {
                    Thrusts::Cancel => "cancel",
                    Thrusts::PartlyCancel => "partly cancel",
                    Thrusts::Add => "add",
                };
                Figure::choice(thrusts, words)
            })
        })
        .quantity("tilting_moment", "M", Dimension::Torque, |one| one.tilting_moment_n_m)
        .view_of("Axial forces of helical teeth", shown)
        .note(note)
        .records()
}

pub(super) fn bearings(all: &[BearingOverDuty]) -> Records {
    let modified = |one: &BearingOverDuty| one.modified.and_then(|modified| modified.life_s);
    let has_spans = all.iter().any(|one| one.span_m.is_some());
    let has_films = all.iter().any(|one| one.film_ratio.is_some());
    let note = format!(
        "K_γ: of the forces of the meshes. F: the greatest of duty and overloads. f_s: static load rating over it. {}L_10: basic life, L_nm: modified life over the duty, of the bearings stated.",
        if has_films {
            "p: greatest load of the duty over diameter and width of a plain bearing; h_0/h_lim: its oil film over the least one, oil of 70 °C unless working_viscosity is stated; it has no life. "
        } else {
            ""
        }
    );
    let table = Table::new("bearings", all.iter())
        .text("set", "set", |one| &one.set)
        .text("planet", "planet", |one| &one.planet)
        .words("rolling", "of", |one| Figure::choice(one.rolling, one.rolling.replace('_', " ")))
        .quantity("load_rating", "C", Dimension::Force, |one| one.load_rating_n)
        .printed("load_sharing", "K_γ", 2, |one| one.load_sharing)
        .quantity("span", "s", Dimension::Length, |one| one.span_m)
        .only_if(has_spans)
        .quantity("greatest_force", "F", Dimension::Force, |one| one.greatest_force_n)
        .quantity("greatest_row_force", "F_row", Dimension::Force, |one| one.greatest_row_force_n)
        .only_if(has_spans)
        .printed("static_safety", "f_s", 3, |one| one.static_safety)
        .number("pressure", "p, N/mm²", |one| one.pressure_pa.map(|pressure| pressure / 1e6))
        .only_if(has_films)
        .printed("film_ratio", "h_0/h_lim", 2, |one| one.film_ratio)
        .only_if(has_films)
        .quantity("basic_life", "", Dimension::Time, |one| one.basic_life_s)
        .number("basic_hours", "L_10, h", |one| one.basic_life_s.map(hours))
        .for_people()
        .share("reliability", "of", |one| Some(one.modified?.reliability))
        .quantity("modified_life", "", Dimension::Time, |one| modified(one))
        .number("modified_hours", "L_nm, h", |one| modified(one).map(hours))
        .for_people()
        .view(
            "Planet bearings over the duty",
            "set planet rolling load_rating load_sharing greatest_force static_safety pressure film_ratio basic_hours reliability \
             modified_hours",
        )
        .note(&note);
    if !has_spans {
        return table.records();
    }
    table
        .view("Rows of planet bearings", "set planet span greatest_row_force")
        .note("s: distance of both rows, which the tilting moment of helical teeth loads unequally. F_row: the greatest of a row; with s, f_s is the static load rating over twice it, and lives contain the moment.")
        .records()
}

/// Keys missing for a bearing, or the reason why nothing follows; `None` where every bearing is judged.
pub(super) fn bearings_missing(all: &[BearingOverDuty]) -> Option<Records> {
    let lacking: Vec<_> = all.iter().filter(|one| !one.missing.is_empty()).collect();
    if lacking.is_empty() {
        return None;
    }
    let table = Table::new("bearings_missing", lacking)
        .text("set", "set", |one| &one.set)
        .text("planet", "planet", |one| &one.planet)
        .words("missing", "missing", |one| one.missing.join(", "));
    Some(table.all("Planet bearings: what is missing").records())
}

pub(super) fn bearing_steps(all: &[BearingOverDuty]) -> Records {
    Table::new(
        "bearing_steps",
        all.iter()
            .filter(|one| one.modified.is_some())
            .flat_map(|one| one.steps.iter().map(move |step| (one, step))),
    )
    .text("set", "set", |(one, _)| &one.set)
    .text("planet", "planet", |(one, _)| &one.planet)
    .text("gear", "gear", |(_, step)| &step.gear)
    .quantity("force", "F", Dimension::Force, |(_, step)| step.force_n)
    .quantity("speed", "n", Dimension::AngularSpeed, |(_, step)| step.speed_rad_s)
    .number("viscosity_ratio", "κ", |(_, step)| step.viscosity_ratio)
    .number("modification", "a_ISO", |(_, step)| step.modification)
    .view(
        "Planet bearings in the steps of the duty",
        "set planet gear force speed viscosity_ratio modification",
    )
    .note("n: of the planet on its pin. κ: viscosity of the oil over the one needed.")
    .records()
}
