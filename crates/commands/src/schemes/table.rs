//! The catalogue of schemes, as tables.

use crate::schemes::answer::{Connection, Gear, Parameters, Scheme, SchemeFormulas, Schemes};
use crate::shared::catalogue::{KRange, SetLinks, SetSpeeds};
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::{Figure, text};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, warned};
use epicyclic_schemes::catalogue::SchemeGear;
use epicyclic_schemes::structures::Role;
use epicyclic_units::format::trimmed;

fn span(k: KRange) -> String {
    format!("k from {} to {}", trimmed(k.least, 5), trimmed(k.greatest, 5))
}

/// The links of sun, ring and carrier of a set that may be missing.
fn in_a_row(set: Option<&SetLinks>) -> Option<String> {
    Some(set?.links().map(Role::symbol).join(" "))
}

impl AsReport for Schemes {
    fn report(&self) -> Report {
        let note = "a sun, b ring, H carrier: the shafts D and B, or T1 and T2, which are braked in gears 1 and 2. i: ratio \
                    of gear 1 of I, II, III, of gear 2 of the others, whose gear 1 is that of I, II or III. Gear 3 is \
                    direct drive.";
        let link =
            |of: &SchemeFormulas, set: usize, member: usize| Some(of.sets.get(set)?.links()[member].symbol());
        let records = Table::new("schemes", &self.schemes)
            .text("scheme", "scheme", |of| of.scheme)
            .words("set_1", "a₁ b₁ H₁", |of| in_a_row(of.sets.first()))
            .for_people()
            .words("set_2", "a₂ b₂ H₂", |of| in_a_row(of.sets.get(1)))
            .for_people()
            .words("sun_1", "a₁", |of| link(of, 0, 0))
            .words("ring_1", "b₁", |of| link(of, 0, 1))
            .words("carrier_1", "H₁", |of| link(of, 0, 2))
            .words("sun_2", "a₂", |of| link(of, 1, 0))
            .words("ring_2", "b₂", |of| link(of, 1, 1))
            .words("carrier_2", "H₂", |of| link(of, 1, 2))
            .text("ratio_formula", "i", |of| &of.ratio_formula)
            .text("efficiency_formula", "η", |of| &of.efficiency_formula)
            .multiple("least_ratio", "from", |of| of.least_ratio)
            .multiple("greatest_ratio", "to", |of| of.greatest_ratio)
            .view("Links and ratios", "scheme set_1 set_2 ratio_formula least_ratio greatest_ratio")
            .note(note)
            .view("Efficiency of the same gear", "scheme efficiency_formula")
            .the_answer()
            .records();
        let title = format!("Schemes; {}", span(self.k));
        Report { title: Some(title), parts: vec![Part::Records(records)], warnings: None }
    }
}

impl AsReport for Scheme {
    fn report(&self) -> Report {
        let mut parts =
            vec![Part::Facts(structure(&self.sets, self.connection)), Part::Records(formulas(self))];
        let mut warnings = None;
        if let Some(numbers) = &self.parameters {
            parts.push(Part::Facts(parameters(numbers)));
            parts.push(Part::Records(gears(&self.gears)));
            parts.push(Part::Records(speeds(&self.sets, &self.gears)));
            parts.extend(judgement::parts(&self.judgement));
            warnings = warned(&self.warnings);
        }
        Report { title: Some(format!("Scheme {}", self.scheme)), parts, warnings }
    }
}

fn structure(sets: &[SetLinks], connection: Option<Connection>) -> Section {
    let links = |set: &SetLinks| {
        let members = set.links().into_iter().zip(["a", "b", "H"]);
        text(members.map(|(link, member)| format!("{member}={link}")).collect::<Vec<_>>().join(" "))
    };
    let labels = [("set_1", "set 1: sun a, ring b, carrier H"), ("set_2", "set 2")];
    let mut rows: Vec<Row> = labels
        .into_iter()
        .zip(sets)
        .map(|((name, label), set)| Row::new(name, label, "", [links(set)]))
        .collect();
    rows.extend(connection.map(|connection| {
        let words = format!("set 2 connects T1 to {} by i_{}", connection.shaft, connection.motion);
        Row::new("connection", "in gear 2", "", [text(words)])
    }));
    Section { name: "structure", title: "Structure", columns: &[], rows, note: "" }
}

fn formulas(scheme: &Scheme) -> Records {
    Table::new("formulas", scheme.formulas.iter())
        .words("gear", "gear", |gear| gear.gear.name())
        .words("braked", "braked", |gear| gear.braked.map_or("-", |link| link.symbol()))
        .text("ratio_formula", "i", |gear| &gear.ratio_formula)
        .text("efficiency_formula", "η", |gear| &gear.efficiency_formula)
        .multiple("least_ratio", "from", |gear| gear.least_ratio)
        .multiple("greatest_ratio", "to", |gear| gear.greatest_ratio)
        .view(
            format!("Ratios, for {}", span(scheme.k)),
            "gear braked ratio_formula least_ratio greatest_ratio",
        )
        .view("Efficiencies", "gear efficiency_formula")
        .records()
}

fn parameters(of: &Parameters) -> Section {
    let mut rows = vec![Row::new("k1", "ring-to-sun ratio of set 1", "k₁", [Figure::Multiple(of.k1)])];
    rows.extend(of.k2.map(|k2| Row::new("k2", "of set 2", "k₂", [Figure::Multiple(k2)])));
    rows.push(Row::new(
        "set_efficiency",
        "efficiency of a set, carrier fixed",
        "η₀",
        [Figure::Multiple(of.set_efficiency)],
    ));
    Section { name: "parameters", title: "Parameters", columns: &[], rows, note: "" }
}

fn gears(gears: &[Gear]) -> Records {
    let note = "Torques and circulating power, with losses, over the input's; η back: back-driving efficiency. K1, K2: \
                   brakes on T1, T2; L: direct-drive clutch between D and B.";
    Table::new("gears", gears.iter())
        .words("gear", "gear", |gear| gear.gear.name())
        .multiple("ratio", "i", |gear| gear.ratio)
        .multiple("efficiency", "η", |gear| gear.efficiency)
        .multiple("back_driving_efficiency", "η back", |gear| gear.back_driving_efficiency)
        .multiple("output_torque_of_input", "T_B", |gear| gear.output_torque_of_input)
        .words("engaged", "engaged", |gear| gear.engaged.name())
        .multiple("engaged_torque_of_input", "its T", |gear| gear.engaged_torque_of_input)
        .multiple("circulating_of_input", "circulating", |gear| gear.circulating_of_input)
        .view(
            "Gears",
            "gear ratio efficiency back_driving_efficiency output_torque_of_input engaged \
                     engaged_torque_of_input circulating_of_input",
        )
        .note(note)
        .records()
}

/// What a line of the table of speeds says: its name, the member's link, and the speed.
pub(crate) type SpeedLine = (String, Option<&'static str>, fn(&SetSpeeds) -> Option<f64>);

/// The lines of the table of speeds of a set, as the source's tables 3.1 and 3.2 have them.
pub(crate) fn speed_lines(set: usize, links: &SetLinks) -> [SpeedLine; 5] {
    let link = |place: usize| Some(links.links()[place].symbol());
    [
        (format!("a{set}"), link(0), |speeds| speeds.sun_of_input),
        (format!("b{set}"), link(1), |speeds| speeds.ring_of_input),
        (format!("H{set}"), link(2), |speeds| speeds.carrier_of_input),
        (format!("g{set}"), None, |speeds| speeds.planet_of_input),
        (format!("g{set} on H{set}"), None, |speeds| speeds.relative_planet_of_input),
    ]
}

fn speeds(sets: &[SetLinks], gears: &[Gear]) -> Records {
    let rows = sets.iter().enumerate().flat_map(|(place, links)| {
        speed_lines(place + 1, links).map(|(member, link, of)| (place, member, link, of))
    });
    Table::new("speeds", rows)
        .text("member", "member", |(_, member, ..)| member)
        .text("link", "link", |(_, _, link, _)| link.unwrap_or_default())
        .each(gears, |table, gear| {
            let (key, heading) = match gear.gear {
                SchemeGear::First => ("gear_1", "gear 1"),
                SchemeGear::Second => ("gear_2", "gear 2"),
                SchemeGear::Direct => ("direct", "direct"),
            };
            table.multiple(key, heading, |(place, .., of)| gear.sets.get(*place).and_then(of))
        })
        .all("Speeds over the input's; g planet, on H relative to its carrier")
        .records()
}
