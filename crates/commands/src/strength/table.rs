//! The strength of teeth as tables.

mod compact;
mod planets;
mod words;

use crate::shared::judgement::table as judgement;
use crate::strength::answer::records::{
    DutyStep, LoadSharing, MeshName, NotRated, OverDuty, Overloaded, Rated, SharingBasis, Wear,
};
use crate::strength::answer::{SharedFlank, Strength};
use crate::table::columns::Table;
use crate::table::figure::{Figure, hours, text};
use crate::table::quantities::{optional, quantity};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, warned};
use epicyclic_units::Dimension;
use planets::{axial_forces, bearing_steps, bearings, bearings_missing};
use words::{OF_STEPS, extent, from};

/// Load cycles are shown in millions.
const MILLION: f64 = 1e6;

impl AsReport for Strength {
    fn report(&self) -> Report {
        let mut parts = vec![Part::Facts(self.facts())];
        parts.extend(tables(self));
        parts.extend(self.at_point.chunks(2).filter_map(at_point_factors).map(Part::Records));
        parts.extend(self.over_duty.chunks(2).filter_map(over_duty_factors).map(Part::Records));
        if !self.not_rated.is_empty() {
            parts.push(Part::Records(not_rated(&self.not_rated)));
        }
        parts.extend(judgement::parts(&self.judgement));
        let title = Some(match &self.governing {
            Some(governing) if self.not_rated.iter().any(|one| one.mesh.is_some()) => {
                format!("{}: of what could be rated {governing} governs.", self.gearbox)
            }
            Some(governing) => format!("{}: {governing} governs.", self.gearbox),
            None => format!("{}: no teeth are rated, but planet bearings.", self.gearbox),
        });
        Report { title, parts, warnings: warned(&self.warnings) }
    }
}

/// The duty and the safeties.
fn tables(strength: &Strength) -> Vec<Part> {
    let mut parts = vec![];
    if !strength.duty.is_empty() {
        parts.push(Part::Records(duty(&strength.duty)));
    }
    if !strength.at_point.is_empty() {
        parts.push(Part::Records(at_point(&strength.at_point)));
    }
    if !strength.over_duty.is_empty() {
        parts.push(Part::Records(over_duty(strength.over_duty.iter().map(Worn::from))));
    }
    if !strength.shared_flanks.is_empty() {
        parts.push(Part::Records(shared_flanks(&strength.shared_flanks)));
    }
    if !strength.overload.is_empty() {
        parts.push(Part::Records(overload(&strength.overload)));
    }
    if !strength.load_sharing.is_empty() {
        parts.push(Part::Records(load_sharing(&strength.load_sharing)));
    }
    if !strength.axial_forces.is_empty() {
        parts.push(Part::Records(axial_forces(&strength.axial_forces)));
    }
    if !strength.bearings.is_empty() {
        parts.push(Part::Records(bearings(&strength.bearings)));
        parts.extend(bearings_missing(&strength.bearings).map(Part::Records));
        if strength.bearings.iter().any(|bearing| bearing.modified.is_some()) {
            parts.push(Part::Records(bearing_steps(&strength.bearings)));
        }
    }
    parts
}

/// Report for a page, with all factors of a set in one table. At an operating point they are those of the
/// gear with the least safety over the required one.
pub(crate) fn for_page(strength: &Strength) -> Report {
    let mut parts = vec![Part::Facts(strength.facts())];
    parts.extend(tables(strength));
    if !strength.not_rated.is_empty() {
        parts.push(Part::Records(not_rated(&strength.not_rated)));
    }
    parts.extend(compact::factors(strength).into_iter().map(Part::Records));
    Report { title: None, parts, warnings: warned(&strength.warnings) }
}

/// The facts of an answer that all its tables share.
trait Facts {
    fn facts(&self) -> Section;
}

impl Facts for Strength {
    fn facts(&self) -> Section {
        let mut rows = vec![Row::new("edition", "edition, method B", "", [text(&self.edition)])];
        if let Some(at) = &self.operating_point {
            rows.push(Row::new(
                "torque",
                "torque on the input",
                "T",
                [optional(Dimension::Torque, at.torque_n_m)],
            ));
            rows.push(Row::new(
                "power",
                "power into the input",
                "P",
                [optional(Dimension::Power, at.power_w)],
            ));
            rows.push(Row::new(
                "speed",
                "speed of the input",
                "n",
                [optional(Dimension::AngularSpeed, at.speed_rad_s)],
            ));
            // Of torque and power one is given.
            rows.retain(|row| !matches!(row.cells[..], [Figure::Without(_)]));
        }
        rows.push(Row::new("life", "required life", "L", [quantity(Dimension::Time, self.life_s)]));
        rows.push(Row::new(
            "oil_viscosity",
            "viscosity of the oil",
            "ν_40",
            [quantity(Dimension::Viscosity, self.oil_viscosity_m2_s)],
        ));
        rows.push(Row::new(
            "required_flank",
            "required safety, flank",
            "",
            [Figure::Number(self.required.flank)],
        ));
        rows.push(Row::new(
            "required_root",
            "required safety, root",
            "",
            [Figure::Number(self.required.root)],
        ));
        Section { name: "load", title: "Load and requirements", columns: &[], rows, note: "" }
    }
}

fn duty(all: &[DutyStep]) -> Records {
    Table::new("duty", all.iter())
        .text("gear", "gear", |one| &one.gear)
        .share("share", "share of time", |one| one.share)
        .quantity("torque", "T", Dimension::Torque, |one| one.torque_n_m)
        .quantity("speed", "n", Dimension::AngularSpeed, |one| one.speed_rad_s)
        .view("Duty: torque on the input and its speed", "gear share torque speed")
        .records()
}

fn at_point(all: &[Rated]) -> Records {
    let is_helical = all.iter().any(|one| one.axial_force_n != 0.0);
    let forces = if is_helical { "F_t, F_a" } else { "F_t" };
    let note =
        format!("{forces}: of one mesh, without losses. n: of its first gear relative to the carrier.");
    Table::new("at_point", all.iter())
        .text("gear", "gear", |one| &one.gear)
        .text("set", "set", |one| &one.set)
        .words("mesh", "mesh", |one| one.mesh.to_string())
        .words("toothed_gear", "of", |one| one.toothed_gear.to_string())
        .text("material", "material", |one| &one.material)
        .printed("flank_safety", "S_H", 3, |one| one.flank_safety)
        .printed("root_safety", "S_F", 3, |one| one.root_safety)
        .headed("contact_stress", "σ_H", Dimension::Pressure, |one| one.contact_stress_pa)
        .headed("contact_limit", "σ_HG", Dimension::Pressure, |one| one.contact_limit_pa)
        .headed("root_stress", "σ_F", Dimension::Pressure, |one| one.root_stress_pa)
        .headed("root_limit", "σ_FG", Dimension::Pressure, |one| one.root_limit_pa)
        .quantity("tangential_force", "F_t", Dimension::Force, |one| one.tangential_force_n)
        .quantity("axial_force", "F_a", Dimension::Force, |one| one.axial_force_n)
        .only_if(is_helical)
        .quantity("mesh_torque", "T", Dimension::Torque, |one| one.mesh_torque_n_m)
        .quantity("mesh_speed", "n", Dimension::AngularSpeed, |one| one.mesh_speed_rad_s)
        .number("cycles", "N_L", |one| one.cycles)
        .number("million_cycles", "N_L, 10⁶", |one| one.cycles / MILLION)
        .for_people()
        .view(
            "Safeties of flanks and roots, stresses and limits in MPa",
            "gear set mesh toothed_gear flank_safety root_safety contact_stress \
                     contact_limit root_stress root_limit",
        )
        .view(
            "Materials and loads",
            "gear set mesh toothed_gear material tangential_force axial_force mesh_speed million_cycles",
        )
        .note(note)
        .records()
}

/// The factors of two gears, each with its values side by side; two of a name where the formulas differ, or
/// where only one gear has it.
fn by_formula<F>(
    [first, second]: [&[F]; 2],
    symbol: impl Fn(&F) -> &str,
    formula: impl Fn(&F) -> &Option<String>,
) -> Vec<(&F, [Option<&F>; 2])> {
    let mut rows = vec![];
    let mut rest = second;
    for one in first {
        // What the second has alone stands where it stands there.
        if let Some(place) = rest.iter().position(|other| symbol(other) == symbol(one)) {
            rows.extend(rest[..place].iter().map(|other| (other, [None, Some(other)])));
            let other = &rest[place];
            rest = &rest[place + 1..];
            if formula(one) == formula(other) {
                rows.push((one, [Some(one), Some(other)]));
            } else {
                rows.extend([(one, [Some(one), None]), (other, [None, Some(other)])]);
            }
        } else {
            rows.push((one, [Some(one), None]));
        }
    }
    rows.extend(rest.iter().map(|other| (other, [None, Some(other)])));
    rows
}

/// The factors of a mesh over the duty, those of its gears side by side; none where none are told.
fn over_duty_factors(both: &[OverDuty]) -> Option<Records> {
    let [first, second] = both else { return None };
    if first.factors.is_empty() {
        return None;
    }
    let rows =
        by_formula([&first.factors, &second.factors], |factor| &factor.symbol, |factor| &factor.formula);
    let [one, other] = [first, second].map(|of| of.toothed_gear.to_string());
    let table = Table::new("factors", rows)
        .text("set", "set", |_| &first.set)
        .words("mesh", "mesh", |_| first.mesh.to_string())
        .text("symbol", "factor", |(factor, _)| &factor.symbol)
        .number("first", &one, |(_, [factor, _])| factor.map(extent))
        .for_people()
        .number("second", &other, |(_, [_, factor])| factor.map(extent))
        .for_people()
        .number("first_least", "least", |(_, [factor, _])| Some(factor.as_ref()?.least))
        .number("second_least", "least", |(_, [_, factor])| Some(factor.as_ref()?.least))
        .number("first_greatest", "greatest", |(_, [factor, _])| Some(factor.as_ref()?.greatest))
        .number("second_greatest", "greatest", |(_, [_, factor])| Some(factor.as_ref()?.greatest))
        .words("formula", "from", |(factor, _)| from(factor.formula.as_deref()))
        .view(
            format!("Factors over the duty: set {}, mesh {}", first.set, first.mesh),
            "symbol first second formula",
        );
    Some(table.note(OF_STEPS).records())
}

/// The factors of a mesh, those of its gears side by side; none where none are told.
fn at_point_factors(both: &[Rated]) -> Option<Records> {
    let [first, second] = both else { return None };
    if first.factors.is_empty() {
        return None;
    }
    let rows =
        by_formula([&first.factors, &second.factors], |factor| &factor.symbol, |factor| &factor.formula);
    let [one, other] = [first, second].map(|of| of.toothed_gear.to_string());
    let title = format!("Factors: gear {}, set {}, mesh {}", first.gear, first.set, first.mesh);
    let table = Table::new("factors", rows)
        .text("gear", "gear", |_| &first.gear)
        .text("set", "set", |_| &first.set)
        .words("mesh", "mesh", |_| first.mesh.to_string())
        .text("symbol", "factor", |(factor, _)| &factor.symbol)
        .printed("first", &one, 4, |(_, [factor, _])| Some(factor.as_ref()?.value))
        .printed("second", &other, 4, |(_, [_, factor])| Some(factor.as_ref()?.value))
        .words("formula", "from", |(factor, _)| from(factor.formula.as_deref()));
    Some(table.view(title, "symbol first second formula").records())
}

/// A gear of a mesh over a duty, as it stands in a table.
pub(crate) struct Worn<'a> {
    pub(crate) set: &'a str,
    pub(crate) mesh: &'a MeshName,
    pub(crate) toothed_gear: &'a str,
    pub(crate) material: &'a str,
    pub(crate) flank: Option<&'a Wear>,
    pub(crate) root: Option<&'a Wear>,
}

impl<'a> From<&'a OverDuty> for Worn<'a> {
    fn from(one: &'a OverDuty) -> Self {
        let OverDuty { set, mesh, toothed_gear, material, flank, root, .. } = one;
        let [flank, root] = [flank, root].map(Option::as_ref);
        Self { set, mesh, toothed_gear, material, flank, root }
    }
}

pub(crate) fn over_duty<'a>(all: impl IntoIterator<Item = Worn<'a>>) -> Records {
    let damage = |wear: &Wear| {
        wear.damage.map_or(Figure::answer("above_static_limit", "above static"), Figure::Number)
    };
    Table::new("over_duty", all)
        .text("set", "set", |one| one.set)
        .words("mesh", "mesh", |one| one.mesh.to_string())
        .words("toothed_gear", "of", |one| one.toothed_gear.to_string())
        .printed("flank_safety", "S_H", 3, |one| Some(one.flank?.safety))
        .number("flank_damage", "damage", |one| one.flank.map(damage))
        .quantity("flank_life", "", Dimension::Time, |one| one.flank?.life_s)
        .number("flank_hours", "hours", |one| one.flank?.life_s.map(hours))
        .for_people()
        .printed("root_safety", "S_F", 3, |one| Some(one.root?.safety))
        .number("root_damage", "damage", |one| one.root.map(damage))
        .quantity("root_life", "", Dimension::Time, |one| one.root?.life_s)
        .number("root_hours", "hours", |one| one.root?.life_s.map(hours))
        .for_people()
        .text("material", "material", |one| one.material)
        .view(
            "Over the duty: flanks, then roots",
            "set mesh toothed_gear flank_safety flank_damage flank_hours root_safety root_damage root_hours",
        )
        .note("Damage in the required life by Miner's rule, 1 at its end; hours until then, none where nothing does damage.")
        .view("Materials", "set mesh toothed_gear material")
        .records()
}

fn shared_flanks(all: &[SharedFlank]) -> Records {
    let damage =
        |of: Option<f64>| of.map_or(Figure::answer("above_static_limit", "above static"), Figure::Number);
    let meshes =
        |one: &SharedFlank| one.meshes.iter().map(MeshName::to_string).collect::<Vec<_>>().join(", ");
    Table::new("shared_flanks", all.iter())
        .text("set", "set", |one| &one.set)
        .text("toothed_gear", "gear", |one| &one.toothed_gear)
        .words("meshes", "meshes", |one| meshes(one))
        .printed("flank_safety", "S_H", 3, |one| one.flank_safety)
        .number("flank_damage", "damage", |one| damage(one.flank_damage))
        .printed("root_safety", "S_F", 3, |one| one.root_safety)
        .number("root_damage", "damage", |one| damage(one.root_damage))
        .all("Several meshes on one flank together")
        .note("Sum of the damages of these meshes in the required life, 1 at its end; S: factor on all their stresses at which the sum is 1. The tables above rate each mesh alone.")
        .records()
}

fn overload(all: &[Overloaded]) -> Records {
    Table::new("overload", all.iter())
        .text("gear", "gear", |one| &one.gear)
        .quantity("torque", "T", Dimension::Torque, |one| one.torque_n_m)
        .text("set", "set", |one| &one.set)
        .words("mesh", "mesh", |one| one.mesh.to_string())
        .words("toothed_gear", "of", |one| one.toothed_gear.to_string())
        .printed("flank_safety", "S_H", 3, |one| one.flank_safety)
        .number("required_flank", "required", |one| one.required.flank)
        .printed("root_safety", "S_F", 3, |one| one.root_safety)
        .number("required_root", "required", |one| one.required.root)
        .all("Against the overload")
        .note("Static safeties, K_A and K_v being 1. T: on the input.")
        .records()
}

/// How planets share the load where the file does not give it.
fn load_sharing(all: &[LoadSharing]) -> Records {
    let note = "K_γ of IEC 61400-4, by the number of planets. `floating` of a set says whether a member floats; `K_gamma` gives the factor itself.";
    Table::new("load_sharing", all.iter())
        .text("set", "set", |one| &one.set)
        .number("planets", "planets", |one| one.planets)
        .printed("mesh_load_factor", "K_γ", 3, |one| one.mesh_load_factor)
        .words("basis", "since", |one| {
            let words = match one.basis {
                SharingBasis::Floating => "a member floats",
                SharingBasis::Rigid => "no member floats",
                SharingBasis::Assumed => "a floating member is assumed",
            };
            Figure::choice(one.basis, words)
        })
        .view("Load sharing of the planets", "set planets mesh_load_factor basis")
        .note(note)
        .records()
}

fn not_rated(all: &[NotRated]) -> Records {
    let part = ["mesh", "toothed_gear", "place"];
    let shown = if all.iter().any(|one| one.mesh.is_some()) { &part[..] } else { &[] };
    let shown: Vec<&'static str> =
        ["set", "gears"].into_iter().chain(shown.iter().copied()).chain(["reason"]).collect();
    Table::new("not_rated", all.iter())
        .text("set", "set", |one| &one.set)
        .words(
            "gears",
            "gears",
            |one| {
                if one.gears.is_empty() { text("all") } else { one.gears.clone().into() }
            },
        )
        .words("mesh", "mesh", |one| one.mesh.as_ref().map(MeshName::to_string))
        .words("toothed_gear", "of", |one| one.toothed_gear.clone())
        .words("place", "part", |one| one.place.map(|place| place.to_string()))
        .words("reason", "why", |one| one.why())
        .view_of("Not rated", &shown)
        .records()
}
