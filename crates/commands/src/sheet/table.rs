//! Data sheets of gears as tables.

use crate::shared::judgement::table as judgement;
use crate::shared::tool::ToolKind;
use crate::sheet::answer::DataSheets;
use crate::sheet::answer::records::{
    AtOutput, GearInMesh, GearSheet, Hand, LeftOut, Limits, MeshSheet, SetSheet,
};
use crate::table::columns::Table;
use crate::table::figure::{Figure, text};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, warned};
use epicyclic_units::Dimension;

/// An end of limits.
type End = fn(Limits) -> f64;

const UPPER: End = |of| of.upper;
const LOWER: End = |of| of.lower;

/// Decimals of a length in mm: micrometres.
const MICROMETRES: usize = 3;

impl AsReport for DataSheets {
    fn report(&self) -> Report {
        let mut parts: Vec<Part> = self.sets.iter().flat_map(set).map(Part::Records).collect();
        if !self.at_output.is_empty() {
            parts.push(Part::Records(at_output(&self.at_output)));
        }
        if !self.left_out.is_empty() {
            parts.push(Part::Records(left_out(&self.left_out)));
        }
        parts.extend(judgement::parts(&self.judgement));
        Report {
            title: Some(format!("{}: data sheets of gears", self.gearbox)),
            parts,
            warnings: warned(&self.warnings),
        }
    }
}

/// The same as parts of a page, one for each set; what it warns of the page has already.
pub(crate) fn for_page(sheets: &DataSheets) -> Vec<Report> {
    let report = |parts| Report { title: None, parts, warnings: None };
    let sets = sheets.sets.iter().map(|one| report(set(one).into_iter().map(Part::Records).collect()));
    let rest = (!sheets.left_out.is_empty()).then(|| report(vec![Part::Records(left_out(&sheets.left_out))]));
    let output =
        (!sheets.at_output.is_empty()).then(|| report(vec![Part::Records(at_output(&sheets.at_output))]));
    sets.chain(output).chain(rest).collect()
}

/// Backlash and stiffness at the output.
fn at_output(all: &[AtOutput]) -> Records {
    let backlash = |limits: Option<Limits>, end: End| limits.map_or(Figure::None, |of| angle(end(of)));
    let is_whole = all.iter().all(|one| one.missing.is_empty());
    let shown = ["gear", "least_backlash", "greatest_backlash", "stiffness", "missing"];
    let note = "While the input is held: angle by which the output turns freely, with allowances and deviations; stiffness of the meshes alone, by ISO 6336-1 for steel gears.";
    Table::new("at_output", all.iter())
        .text("gear", "gear", |one| &one.gear)
        .number("least_backlash", "backlash, °", |one| backlash(one.backlash_rad, LOWER))
        .number("greatest_backlash", "to, °", |one| backlash(one.backlash_rad, UPPER))
        .number("stiffness", "N·m/rad", |one| one.stiffness_n_m)
        .words("missing", "missing", |one| (!one.missing.is_empty()).then(|| one.missing.join(", ")))
        .view_of("At the output", &shown[..if is_whole { 4 } else { 5 }])
        .note(note)
        .records()
}

/// A line of a table: key, words, symbol, figures.
struct Line(&'static str, &'static str, &'static str, Vec<Figure>);

fn table(
    name: &'static str,
    set: &str,
    title: &str,
    note: &str,
    headings: &[String],
    lines: Vec<Line>,
) -> Records {
    // As many as the gears in mesh of the largest compound set that anyone has written; more are left to
    // JSON.
    let keys = [
        "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
        "eleventh", "twelfth",
    ];
    // What no gear has says nothing.
    let is_said = |Line(.., figures): &Line| !figures.iter().all(|figure| matches!(figure, Figure::None));
    Table::new(name, lines.into_iter().filter(is_said))
        .words("set", "set", |_| set)
        .words("quantity", "", |Line(key, words, ..)| Figure::answer(*key, *words))
        .text("symbol", "", |Line(_, _, symbol, _)| symbol)
        .for_people()
        .each(headings.iter().zip(keys).enumerate(), |table, (place, (heading, key))| {
            table.number(key, heading, |Line(.., figures)| figures.get(place).cloned())
        })
        .view_of(title, &[&["quantity", "symbol"], &keys[..headings.len().min(keys.len())]].concat())
        .note(note)
        .records()
}

fn length(si: f64) -> Figure {
    Figure::Measured { si, dimension: Dimension::Length, decimals: MICROMETRES }
}

fn lengths(si: Option<f64>) -> Figure {
    si.map_or(Figure::None, length)
}

fn angle(si: f64) -> Figure {
    Figure::Measured { si, dimension: Dimension::Angle, decimals: MICROMETRES }
}

fn angles(si: Option<f64>) -> Figure {
    si.map_or(Figure::None, angle)
}

fn set(set: &SetSheet) -> Vec<Records> {
    vec![common(set), gears(set), meshes(set), in_mesh(set)]
}

/// What only helical teeth have of their own.
fn of_helix(set: &SetSheet, figure: impl FnOnce() -> Figure) -> Figure {
    if set.helix_angle_rad == Some(0.0) { Figure::None } else { figure() }
}

fn common(set: &SetSheet) -> Records {
    let limits = set.centre_distance_deviations_m;
    let helical = |figure: fn(&SetSheet) -> Figure| vec![of_helix(set, || figure(set))];
    let lines = vec![
        Line("module", "normal module, mm", "m_n", vec![lengths(set.module_m)]),
        Line("pressure_angle", "normal pressure angle, °", "α_n", vec![angle(set.pressure_angle_rad)]),
        Line("helix_angle", "helix angle, °", "β", vec![angles(set.helix_angle_rad)]),
        Line(
            "base_helix_angle",
            "helix angle, base cylinder, °",
            "β_b",
            helical(|set| angles(set.base_helix_angle_rad)),
        ),
        Line(
            "transverse_module",
            "transverse module, mm",
            "m_t",
            helical(|set| lengths(set.transverse_module_m)),
        ),
        Line(
            "transverse_pressure_angle",
            "transverse pressure angle, °",
            "α_t",
            helical(|set| angles(set.transverse_pressure_angle_rad)),
        ),
        Line("addendum", "addendum of the rack, modules", "h_aP*", vec![Figure::Number(set.addendum)]),
        Line("clearance", "clearance of the rack, modules", "c_P*", vec![Figure::Number(set.clearance)]),
        Line("planets", "planets", "N", vec![set.planets.map_or(Figure::None, Figure::Count)]),
        Line("face_width", "face width, mm", "b", vec![lengths(set.face_width_m)]),
        Line("centre_distance", "centre distance, mm", "a", vec![lengths(set.centre_distance_m)]),
        Line(
            "centre_distance_upper",
            "upper deviation, mm",
            "A_as",
            vec![lengths(limits.map(|of| of.upper))],
        ),
        Line(
            "centre_distance_lower",
            "lower deviation, mm",
            "A_ai",
            vec![lengths(limits.map(|of| of.lower))],
        ),
    ];
    table("set", &set.set, &format!("Set {}", set.set), "", &[String::new()], lines)
}

fn gears(set: &SetSheet) -> Records {
    let each = |of: &dyn Fn(&GearSheet) -> Figure| set.gears.iter().map(of).collect::<Vec<_>>();
    let limit = |of: fn(&GearSheet) -> Option<Limits>, end: End| each(&|gear| lengths(of(gear).map(end)));
    let allowance = |end: fn(&Limits) -> f64| {
        let of = |all: &Vec<Limits>| all.iter().map(|of| length(end(of))).collect();
        set.thickness_allowances_m.as_ref().map_or_else(Vec::new, of)
    };
    let shaper_teeth = each(&|gear| gear.shaper_teeth.map_or(Figure::None, Figure::Count));
    let shaper_addendum =
        each(&|gear| gear.shaper_addendum.map_or(Figure::None, |addendum| Figure::Printed(addendum, 4)));
    let shaper_shift =
        each(&|gear| gear.shaper_shift.map_or(Figure::None, |shift| Figure::Printed(shift, 4)));
    let lines = vec![
        Line("teeth", "teeth", "z", each(&|gear| Figure::Count(gear.teeth))),
        Line("hand", "hand of the helix", "", each(&|gear| gear.hand.map_or(Figure::None, hand))),
        Line("lead", "lead", "p_z", each(&|gear| lengths(gear.lead_m))),
        Line(
            "profile_shift",
            "profile shift coefficient",
            "x",
            each(&|gear| Figure::Printed(gear.profile_shift, 4)),
        ),
        Line(
            "least_shift",
            "least without undercut",
            "x_min",
            each(&|gear| gear.least_shift.map_or(Figure::None, |shift| Figure::Printed(shift, 4))),
        ),
        Line("tip_alteration", "tip alteration", "k·m_n", each(&|gear| length(gear.tip_alteration_m))),
        Line(
            "reference_diameter",
            "reference diameter",
            "d",
            each(&|gear| length(gear.reference_diameter_m)),
        ),
        Line(
            "face_width",
            "face width",
            "b",
            // One of all gears stands with the set.
            each(&|gear| if set.face_width_m.is_some() { Figure::None } else { lengths(gear.face_width_m) }),
        ),
        Line("base_diameter", "base diameter", "d_b", each(&|gear| length(gear.base_diameter_m))),
        Line("tip_diameter", "tip diameter", "d_a", each(&|gear| length(gear.tip_diameter_m))),
        Line("root_diameter", "root diameter", "d_f", each(&|gear| length(gear.root_diameter_m))),
        Line("form_diameter", "root form diameter", "d_Ff", each(&|gear| length(gear.form_diameter_m))),
        Line("thickness", "tooth thickness, reference", "s_n", each(&|gear| length(gear.thickness_m))),
        Line(
            "transverse_thickness",
            "the same, transverse",
            "s_t",
            each(&|gear| of_helix(set, || length(gear.transverse_thickness_m))),
        ),
        Line("thickness_upper", "upper allowance", "E_sns", allowance(|of| of.upper)),
        Line("thickness_lower", "lower allowance", "E_sni", allowance(|of| of.lower)),
        Line("tip_thickness", "tooth thickness, tip", "s_an", each(&|gear| length(gear.tip_thickness_m))),
        Line(
            "spanned_teeth",
            "teeth spanned, ring: spaces",
            "k",
            each(&|gear| Figure::Count(gear.spanned_teeth)),
        ),
        Line("span", "span", "W_k", each(&|gear| length(gear.span_m))),
        Line("span_upper", "span, upper limit", "", limit(|gear| gear.span_limits_m, UPPER)),
        Line("span_lower", "span, lower limit", "", limit(|gear| gear.span_limits_m, LOWER)),
        Line("span_face_width", "span, least face width", "", each(&|gear| lengths(gear.span_face_width_m))),
        Line("ball_diameter", "ball diameter", "D_M", each(&|gear| length(gear.ball_diameter_m))),
        Line("over_balls", "measure over balls", "M_dK", each(&|gear| lengths(gear.over_balls_m))),
        Line(
            "over_balls_upper",
            "over balls, upper limit",
            "",
            limit(|gear| gear.over_balls_limits_m, UPPER),
        ),
        Line(
            "over_balls_lower",
            "over balls, lower limit",
            "",
            limit(|gear| gear.over_balls_limits_m, LOWER),
        ),
        Line("material", "material", "", each(&|gear| gear.material.as_ref().map_or(Figure::None, text))),
        Line("tool", "cut by", "", each(&tool)),
        Line("shaper_teeth", "teeth of the shaper", "z_0", shaper_teeth),
        Line("shaper_shift", "its profile shift coefficient", "x_0", shaper_shift),
        Line("shaper_addendum", "its addendum, modules", "h_aP0*", shaper_addendum),
        Line(
            "fillet",
            "corner radius of the tool, modules",
            "ρ*",
            each(&|gear| Figure::Printed(gear.fillet, 2)),
        ),
    ];
    table(
        "gears",
        &set.set,
        &format!("Gears of set {}, lengths in mm", set.set),
        "Root and form circles are those that the tools leave; (usual): the file states no tool. Spans and measures over balls without allowances but where limits are \
         told; over two balls, of a ring between them.",
        &set.gears.iter().map(|gear| gear.toothed_gear.clone()).collect::<Vec<_>>(),
        lines,
    )
}

fn hand(hand: Hand) -> Figure {
    Figure::choice(
        hand,
        match hand {
            Hand::OfSun => "either",
            Hand::Opposite => "opposite",
        },
    )
}

fn tool(gear: &GearSheet) -> Figure {
    let words = match (gear.tool, gear.tool_stated) {
        (ToolKind::Rack, true) => "hob",
        (ToolKind::Rack, false) => "hob (usual)",
        (ToolKind::Shaper, true) => "shaper",
        (ToolKind::Shaper, false) => "shaper (usual)",
        (ToolKind::Form, true) => "form tool",
        (ToolKind::Form, false) => "form tool (usual)",
    };
    Figure::choice(gear.tool, words)
}

fn meshes(set: &SetSheet) -> Records {
    let each = |of: &dyn Fn(&MeshSheet) -> Figure| set.meshes.iter().map(of).collect::<Vec<_>>();
    let limit = |of: fn(&MeshSheet) -> Option<Limits>, end: End| each(&|mesh| lengths(of(mesh).map(end)));
    let ratio = |value: f64| Figure::Printed(value, 3);
    let several = |of_set: Option<f64>, own: fn(&MeshSheet) -> Figure| {
        if of_set.is_some() { vec![] } else { each(&own) }
    };
    let lines = vec![
        Line("module", "normal module", "m_n", several(set.module_m, |mesh| length(mesh.module_m))),
        Line(
            "helix_angle",
            "helix angle, °",
            "β",
            several(set.helix_angle_rad, |mesh| angle(mesh.helix_angle_rad)),
        ),
        Line(
            "centre_distance",
            "centre distance",
            "a",
            several(set.centre_distance_m, |mesh| length(mesh.centre_distance_m)),
        ),
        Line(
            "working_angle",
            "working pressure angle, °",
            "α_wt",
            each(&|mesh| angle(mesh.working_angle_rad)),
        ),
        Line(
            "contact_ratio",
            "transverse contact ratio",
            "ε_α",
            each(&|mesh| Figure::Printed(mesh.contact_ratio, 3)),
        ),
        Line(
            "overlap_ratio",
            "overlap ratio",
            "ε_β",
            each(&|mesh| of_helix(set, || mesh.overlap_ratio.map_or(Figure::None, ratio))),
        ),
        Line(
            "total_contact_ratio",
            "total contact ratio",
            "ε_γ",
            each(&|mesh| of_helix(set, || mesh.total_contact_ratio.map_or(Figure::None, ratio))),
        ),
        Line("backlash", "backlash without allowances", "j_wt", each(&|mesh| length(mesh.backlash_m))),
        Line(
            "backlash_upper",
            "circumferential backlash, greatest",
            "j_wt",
            limit(|mesh| mesh.backlash_limits_m, UPPER),
        ),
        Line(
            "backlash_lower",
            "circumferential backlash, least",
            "j_wt",
            limit(|mesh| mesh.backlash_limits_m, LOWER),
        ),
        Line(
            "normal_upper",
            "normal backlash, greatest",
            "j_bn",
            limit(|mesh| mesh.normal_backlash_limits_m, UPPER),
        ),
        Line(
            "normal_lower",
            "normal backlash, least",
            "j_bn",
            limit(|mesh| mesh.normal_backlash_limits_m, LOWER),
        ),
        Line(
            "common_factor",
            "common factor of the teeth",
            "",
            each(&|mesh| Figure::Count(mesh.common_factor)),
        ),
        Line(
            "turns_to_same_teeth",
            "turns until two teeth meet again",
            "",
            each(&|mesh| Figure::Count(mesh.turns_to_same_teeth)),
        ),
    ];
    table(
        "meshes",
        &set.set,
        &format!("Meshes of set {}, lengths in mm", set.set),
        "Turns: of the first gear, seen from the carrier. A common factor of 1 is a hunting tooth: every tooth meets every tooth of the mate.",
        &set.meshes.iter().map(|mesh| mesh.mesh.to_string()).collect::<Vec<_>>(),
        lines,
    )
}

fn in_mesh(set: &SetSheet) -> Records {
    let all: Vec<&GearInMesh> = set.meshes.iter().flat_map(|mesh| &mesh.gears).collect();
    let names = || set.meshes.iter().map(|mesh| &mesh.mesh);
    let headings: Vec<String> = set
        .meshes
        .iter()
        .flat_map(|mesh| mesh.gears.iter().map(|gear| mesh.mesh.gear_among(&gear.toothed_gear, names())))
        .collect();
    let each = |of: &dyn Fn(&GearInMesh) -> Figure| all.iter().map(|gear| of(gear)).collect::<Vec<_>>();
    let sliding = |value: Option<f64>| value.map_or(Figure::None, |value| Figure::Printed(value, 3));
    let lines = vec![
        Line("working_diameter", "working diameter", "d_w", each(&|gear| length(gear.working_diameter_m))),
        Line(
            "active_root_diameter",
            "active root diameter",
            "d_Nf",
            each(&|gear| length(gear.active_root_diameter_m)),
        ),
        Line("tip_clearance", "tip clearance", "c", each(&|gear| length(gear.tip_clearance_m))),
        Line("sliding_at_tip", "specific sliding, tip", "ζ", each(&|gear| sliding(gear.sliding_at_tip))),
        Line("sliding_at_root", "specific sliding, root", "ζ", each(&|gear| sliding(gear.sliding_at_root))),
    ];
    table(
        "in_mesh",
        &set.set,
        &format!("Gears in mesh of set {}, lengths in mm", set.set),
        "",
        &headings,
        lines,
    )
}

fn left_out(all: &[LeftOut]) -> Records {
    Table::new("left_out", all.iter())
        .text("set", "set", |one| &one.set)
        .words("reason", "why", |one| one.why())
        .view("Without data sheet", "set reason")
        .records()
}
