//! Everything about one gear.

use super::overview::{as_published, engaged, fast_planets, in_words, published_figure, warnings};
use super::subject::Subject;
use super::{Input, Worked, pins, work};
use crate::failure::Failure;
use crate::figure::{Figure, column, multiple, quantity, text};
use crate::report::{Column, Part, Records, Report, Row, Section, View};
use epicyclic_formats::Dimension;
use epicyclic_schemes::{Analysis, Direction, Gearbox, LinkId, LoadCase, Operation};

const CASES: &[(&str, &str)] =
    &[("without_losses", "without losses"), ("with_losses", "with losses"), ("at_load", "at the load")];

/// The whole answer.
pub(super) fn report(subject: &Subject, name: &str, input: Input) -> Result<Report, Failure> {
    let gearbox = &subject.gearbox;
    let worked = work(gearbox, name, input)?;
    let scene = Scene { subject, gearbox, input, worked: &worked };
    let mut parts = vec![Part::Facts(scene.facts()), Part::Records(scene.links())];
    let planets = scene.planets();
    if !planets.rows.is_empty() {
        parts.push(Part::Records(planets));
    }
    parts.extend(pins::of_gear(subject, &worked, input)?.map(Part::Records));
    if !gearbox.controls().is_empty() {
        parts.push(Part::Records(scene.controls()));
    }
    if worked.analysis.ideal().is_some() {
        parts.push(Part::Facts(scene.terminals()));
        parts.push(Part::Records(scene.rows()));
        parts.push(Part::Facts(scene.powers()));
    }
    if worked.analysis.patterns().len() > 1 {
        parts.push(Part::Records(scene.patterns()));
    }
    Ok(Report {
        title: Some(format!("{}, gear {name}", gearbox.name())),
        parts,
        warnings: Some(scene.warnings()),
    })
}

struct Scene<'a> {
    subject: &'a Subject,
    gearbox: &'a Gearbox,
    input: Input,
    worked: &'a Worked,
}

impl Scene<'_> {
    fn analysis(&self) -> &Analysis {
        &self.worked.analysis
    }

    fn operation(&self) -> Option<&Operation> {
        self.worked.operation.as_ref()
    }

    /// Driven from the output, because the load brakes.
    fn is_overrun(&self) -> bool {
        self.operation().is_some_and(|operation| operation.direction == Direction::Overrun)
    }

    /// Torques with losses in the sense in which power runs.
    fn case(&self) -> Option<&LoadCase> {
        if self.is_overrun() { self.analysis().overrun() } else { self.analysis().driving() }
    }

    /// A torque of the case as a multiple of the input's.
    fn of_input(&self, torque: impl Fn(&LoadCase) -> Option<f64>) -> Option<f64> {
        let case = self.case()?;
        torque(case).map(|torque| torque / case.input)
    }

    fn facts(&self) -> Section {
        let (analysis, gearbox) = (self.analysis(), self.gearbox);
        let gear = analysis.gear();
        let exact = analysis.exact_ratio().map(|ratio| ratio.to_string());
        let locks = analysis.is_self_locking().map_or(Figure::None, Figure::YesNo);
        let mut rows = vec![
            Row::new("gear", "gear", "", [text(gear.name())]),
            Row::new("engaged", "engaged", "", [Figure::Texts(engaged(gearbox, gear))]),
            Row::new("input", "input", "", [text(gearbox.link_name(gear.input()))]),
            Row::new("output", "output", "", [text(gearbox.link_name(gear.output()))]),
            Row::new(
                "state",
                "state",
                "",
                [Figure::Answer(analysis.state().name(), analysis.state().name())],
            ),
            Row::new(
                "state_links",
                "links concerned",
                "",
                [Figure::Texts(analysis.state().links().to_vec())],
            ),
            Row::new("ratio", "ratio", "i", [multiple(analysis.ratio())]),
            Row::new("exact_ratio", "exactly", "", [exact.map_or(Figure::None, Figure::Text)]),
        ];
        if let Some(published) = self.subject.published(gear.name()) {
            let way = if published.invert { "published, output over input" } else { "published" };
            rows.push(Row::new("published", way, "", [published_figure(published)]));
            if let Some(ratio) = analysis.ratio() {
                let agrees = if published.stands_for(ratio) { "agrees" } else { "differs" };
                let same = as_published(published, ratio);
                let remark = if published.unverified { ", not read in its source" } else { "" };
                rows.push(Row {
                    remark: format!("{agrees}{remark}"),
                    ..Row::new("as_published", "computed the same way", "", [multiple(Some(same))])
                });
            }
        }
        rows.extend([
            Row::new("efficiency", "efficiency", "η", [multiple(analysis.efficiency())]),
            Row::new(
                "kreines_efficiency",
                "the same by Kreines' rule",
                "",
                [multiple(analysis.kreines().map(|kreines| kreines.efficiency))],
            ),
            Row::new(
                "overrun_efficiency",
                "overrun efficiency",
                "",
                [multiple(analysis.overrun_efficiency())],
            ),
            Row::new("self_locking", "locks itself when overrun", "", [locks]),
        ]);
        Section { name: "gear", title: "Gear", columns: &[], rows, note: "" }
    }

    fn speed(&self, of_input: Option<f64>) -> Figure {
        column(self.input.speed.zip(of_input).map(|(speed, of)| speed * of))
    }

    /// Powers are known when both a load and a speed are.
    fn powered(&self) -> Option<&Operation> {
        self.operation().filter(|_| self.input.speed.is_some())
    }

    fn links(&self) -> Records {
        let mut columns: &[&'static str] = &["link", "members", "speed_of_input", "power_of_entering"];
        if self.input.speed.is_some() {
            columns = &["link", "members", "speed_of_input", "speed", "power_of_entering"];
        }
        if self.powered().is_some() {
            columns = &["link", "members", "speed_of_input", "speed", "power_of_entering", "power"];
        }
        let rows = (1..self.gearbox.links().len()).map(|link| {
            let speed = self.analysis().speeds()[link];
            vec![
                text(&self.gearbox.links()[link]),
                text(self.members(link)),
                multiple(speed),
                self.speed(speed),
                multiple(self.case().and_then(|case| case.power.links[link])),
                column(self.powered().and_then(|operation| operation.links[link])),
            ]
        });
        Records {
            name: "links",
            columns: vec![
                Column::words("link", "link"),
                Column::words("members", "members"),
                Column::number("speed_of_input", "ω/ω_in"),
                Column::quantity("speed", Dimension::AngularSpeed),
                Column::number("power_of_entering", "power"),
                Column::quantity("power", Dimension::Power),
            ],
            rows: rows.collect(),
            views: vec![View::new("Links: speed, and power through each over what enters", columns)],
            is_answer: false,
        }
    }

    /// What a link is made of: `sun P1, ring P2`.
    fn members(&self, link: usize) -> String {
        let names = ["sun", "ring", "carrier"];
        let gear = self.analysis().gear();
        let terminal = |which: LinkId, name: &'static str| (which.index() == link).then(|| name.to_owned());
        let terminals = [terminal(gear.input(), "input"), terminal(gear.output(), "output")];
        let of_rows = self.gearbox.sets().iter().flat_map(|row| {
            let members = row.members().into_iter().zip(names).filter(|(member, _)| member.index() == link);
            members.map(|(_, name)| format!("{name} {}", row.id())).collect::<Vec<_>>()
        });
        terminals.into_iter().flatten().chain(of_rows).collect::<Vec<_>>().join(", ")
    }

    fn planets(&self) -> Records {
        let mut rows = vec![];
        for (row, motion) in self.gearbox.sets().iter().zip(self.analysis().sets()) {
            for (place, planet) in motion.planets.iter().enumerate() {
                rows.push(vec![
                    text(row.id()),
                    Figure::Count(place as u32 + 1),
                    multiple(Some(planet.relative)),
                    self.speed(Some(planet.relative)),
                    multiple(planet.absolute),
                    self.speed(planet.absolute),
                ]);
            }
        }
        let shown: &[&'static str] = if self.input.speed.is_some() {
            &["row", "planet", "relative_of_input", "relative", "absolute_of_input", "absolute"]
        } else {
            &["row", "planet", "relative_of_input", "absolute_of_input"]
        };
        Records {
            name: "planets",
            columns: vec![
                Column::words("row", "row"),
                Column::number("planet", "planet"),
                Column::number("relative_of_input", "on its carrier"),
                Column::quantity("relative", Dimension::AngularSpeed),
                Column::number("absolute_of_input", "absolute"),
                Column::quantity("absolute", Dimension::AngularSpeed),
            ],
            rows,
            views: vec![View::new("Speeds of planets over the input's", shown)],
            is_answer: false,
        }
    }

    fn controls(&self) -> Records {
        let analysis = self.analysis();
        let rows = self.gearbox.controls().iter().enumerate().map(|(place, control)| {
            let is_engaged = analysis.gear().engaged().contains(&place);
            let [first, second] = control.links().map(|link| self.gearbox.link_name(link));
            let ideal = analysis.ideal().and_then(|case| case.controls[place]);
            vec![
                text(control.id()),
                text(format!("{first} - {second}")),
                if is_engaged {
                    Figure::Answer("engaged", "engaged")
                } else {
                    Figure::Answer("open", "open")
                },
                multiple(analysis.slips()[place]),
                self.speed(analysis.slips()[place]),
                multiple(ideal),
                multiple(self.of_input(|case| case.controls[place])),
                column(self.operation().and_then(|operation| operation.controls[place])),
            ]
        });
        let mut shown = vec!["control", "joins", "is", "slip_of_input"];
        shown.extend(self.input.speed.map(|_| "slip"));
        if analysis.ideal().is_some() {
            shown.extend(["ideal_torque_of_input", "torque_of_input"]);
        }
        shown.extend(self.operation().map(|_| "torque"));
        let note = if analysis.ideal().is_some() {
            "Slip: first link less second. T: torque on the first link over the input's torque, without losses and \
             with."
        } else {
            "Slip: first link less second."
        };
        Records {
            name: "controls",
            columns: vec![
                Column::words("control", "control"),
                Column::words("joins", "joins"),
                Column::words("is", "is"),
                Column::number("slip_of_input", "slip"),
                Column::quantity("slip", Dimension::AngularSpeed),
                Column::number("ideal_torque_of_input", "ideal T"),
                Column::number("torque_of_input", "T"),
                Column::quantity("torque", Dimension::Torque),
            ],
            rows: rows.collect(),
            views: vec![View { note: note.to_owned(), ..View::new("Controls", &shown) }],
            is_answer: false,
        }
    }

    fn terminals(&self) -> Section {
        let ideal = self.analysis().ideal();
        let row = |name, label, of: fn(&LoadCase) -> f64, at: fn(&Operation) -> uom::si::f64::Torque| {
            let mut cells = vec![multiple(ideal.map(of)), multiple(self.of_input(|case| Some(of(case))))];
            cells.extend(self.operation().map(|operation| quantity(at(operation))));
            Row::new(name, label, "", cells)
        };
        Section {
            name: "torques",
            title: "Torques on the gearbox, over the input's",
            columns: &CASES[..2 + usize::from(self.operation().is_some())],
            rows: vec![
                row("input", "at the input", |case| case.input, |at| at.input),
                row("output", "at the output", |case| case.output, |at| at.output),
                row("housing", "from the housing", |case| case.housing, |at| -at.input - at.output),
            ],
            note: "",
        }
    }

    fn rows(&self) -> Records {
        let analysis = self.analysis();
        let ideal = analysis.ideal();
        let kreines = analysis.kreines();
        let rows = self.gearbox.sets().iter().enumerate().map(|(place, row)| {
            let power = self.case().and_then(|case| case.power.rows[place]);
            let member = |of: Option<[f64; 3]>, member: usize| multiple(of.map(|of| of[member]));
            let ideal = ideal.and_then(|case| case.members[place]);
            let sign = self.case().map_or(0, |case| case.signs[place]);
            let mut cells = vec![
                text(row.id()),
                text(row.spec().kind.to_string()),
                multiple(Some(row.stationary_ratio().get())),
                row.exact_ratio().map_or(Figure::None, |ratio| Figure::Text(ratio.to_string())),
                Figure::Multiple(row.spec().loss.row_efficiency().get()),
                match sign {
                    0 => Figure::Answer("none", "none"),
                    1 => Figure::Answer("sun_to_ring", "sun to ring"),
                    _ => Figure::Answer("ring_to_sun", "ring to sun"),
                },
                kreines.map_or(Figure::None, |kreines| Figure::Number(f64::from(kreines.exponents[place]))),
            ];
            cells.extend((0..3).map(|which| member(ideal, which)));
            cells.extend((0..3).map(|which| {
                multiple(self.of_input(|case| case.members[place].map(|members| members[which])))
            }));
            cells.extend((0..3).map(|which| {
                column(self.operation().and_then(|at| at.members[place]).map(|members| members[which]))
            }));
            cells.extend((0..3).map(|which| member(power.map(|power| power.members), which)));
            cells.push(multiple(power.map(|power| power.relative)));
            cells.push(multiple(power.map(|power| power.loss)));
            cells
        });
        let mut views = vec![
            View::new(
                "Rows",
                &["row", "kind", "stationary_ratio", "exact_ratio", "efficiency", "relative_power_runs"],
            ),
            View::new(
                "Torques on the rows over the input's, without losses",
                &[
                    "row",
                    "ideal_sun_torque_of_input",
                    "ideal_ring_torque_of_input",
                    "ideal_carrier_torque_of_input",
                ],
            ),
        ];
        if self.subject.has_losses() {
            views.push(View::new(
                "Torques on the rows over the input's, with losses",
                &["row", "sun_torque_of_input", "ring_torque_of_input", "carrier_torque_of_input"],
            ));
        }
        if self.operation().is_some() {
            views.push(View::new(
                "Torques on the rows at the load, with losses, N·m",
                &["row", "sun_torque", "ring_torque", "carrier_torque"],
            ));
        }
        views.push(View {
            note: "Positive where power enters the row. Relative: what passes its meshes, seen from the carrier, \
                   from sun to ring."
                .to_owned(),
            ..View::new(
                "Powers of the rows over what enters, with losses",
                &["row", "sun_power", "ring_power", "carrier_power", "relative_power", "loss"],
            )
        });
        Records { name: "rows", columns: row_columns(), rows: rows.collect(), views, is_answer: false }
    }

    fn powers(&self) -> Section {
        let case = self.case();
        let of = |figure: fn(&LoadCase) -> f64| multiple(case.map(figure));
        let mut rows = vec![
            Row::new("leaving", "leaves", "", [of(|case| case.efficiency)]),
            Row::new("loss", "lost in the meshes", "", [of(|case| 1.0 - case.efficiency)]),
            Row::new("circulating", "circulates", "", [of(|case| case.power.circulating)]),
            Row::new("largest", "largest of any member", "", [of(|case| case.power.largest)]),
        ];
        if let Some(operation) = self.powered() {
            let entering = operation.entering;
            let at = |of: Option<f64>| of.map_or(Figure::None, |of| quantity(entering * of));
            rows[0].cells.push(at(case.map(|case| case.efficiency)));
            // What rounding leaves of a balance is no loss.
            let is_noise = operation.loss.abs() < entering.abs() * 1e-12;
            rows[1].cells.push(quantity(if is_noise { entering * 0.0 } else { operation.loss }));
            rows[2].cells.push(at(case.map(|case| case.power.circulating)));
            rows[3].cells.push(at(case.map(|case| case.power.largest)));
            let mut first = Row::new("entering", "enters", "", [Figure::Multiple(1.0), quantity(entering)]);
            if self.is_overrun() {
                first.remark = "at the output".to_owned();
            }
            rows.insert(0, first);
        }
        const COLUMNS: &[(&str, &str)] = &[("of_entering", "over what enters"), ("at_load", "at the load")];
        Section {
            name: "powers",
            title: "Powers, with losses",
            columns: &COLUMNS[..1 + usize::from(self.powered().is_some())],
            rows,
            note: "",
        }
    }

    fn patterns(&self) -> Records {
        let arrows = |signs: &[i8]| {
            let one = |(row, sign): (&epicyclic_schemes::set::Row, &i8)| match sign {
                0 => format!("{} 0", row.id()),
                1 => format!("{} +", row.id()),
                _ => format!("{} -", row.id()),
            };
            self.gearbox.sets().iter().zip(signs).map(one).collect::<Vec<_>>().join(", ")
        };
        let rows = self.analysis().patterns().iter().map(|pattern| {
            vec![
                text(arrows(&pattern.signs)),
                Figure::Multiple(pattern.efficiency),
                Figure::YesNo(pattern.chosen),
            ]
        });
        Records {
            name: "patterns",
            columns: vec![
                Column::words("signs", "rows"),
                Column::number("efficiency", "η"),
                Column::words("chosen", "chosen"),
            ],
            rows: rows.collect(),
            views: vec![View::new(
                "Ways in which the losses bear themselves out (+: from sun to ring)",
                &["signs", "efficiency", "chosen"],
            )],
            is_answer: false,
        }
    }

    fn warnings(&self) -> Vec<(&'static str, String)> {
        let analysis = self.analysis();
        let mut all = warnings(self.gearbox);
        all.extend(fast_planets(self.gearbox, analysis));
        if *analysis.state() != epicyclic_schemes::State::Driven {
            all.push(("state", in_words(analysis.state())));
        }
        if self.input.load.is_some() && self.operation().is_none() {
            all.push(("no-load", "no torques follow from the load in this state".to_owned()));
        }
        if let Some(kreines) = analysis.kreines().filter(|kreines| !kreines.reversed.is_empty()) {
            let rows = kreines.reversed.join(", ");
            all.push((
                "kreines",
                format!("Kreines' rule as printed does not hold: the losses reverse the power of row {rows}"),
            ));
        }
        if analysis.is_self_locking() == Some(true) {
            all.push(("self-locking", "the gear locks itself when driven from its output".to_owned()));
        }
        if analysis.ideal().is_some() && analysis.driving().is_none() {
            all.push(("locked", "no torque on the input moves the gear against its losses".to_owned()));
        }
        all
    }
}

fn row_columns() -> Vec<Column> {
    let torque =
        |name| Column { heading: heading(name).to_owned(), ..Column::quantity(name, Dimension::Torque) };
    let number = |name| Column::number(name, heading(name));
    let mut columns = vec![
        Column::words("row", "row"),
        Column::words("kind", "kind"),
        Column::number("stationary_ratio", "i₀"),
        Column::number("exact_ratio", "exact"),
        Column::number("efficiency", "η₀"),
        Column::words("relative_power_runs", "relative power runs"),
        Column::number("kreines_exponent", "x"),
    ];
    columns.extend(
        ["ideal_sun_torque_of_input", "ideal_ring_torque_of_input", "ideal_carrier_torque_of_input"]
            .map(number),
    );
    columns.extend(["sun_torque_of_input", "ring_torque_of_input", "carrier_torque_of_input"].map(number));
    columns.extend(["sun_torque", "ring_torque", "carrier_torque"].map(torque));
    columns.extend(["sun_power", "ring_power", "carrier_power"].map(number));
    columns.extend([Column::number("relative_power", "relative"), Column::number("loss", "loss")]);
    columns
}

/// The member that a key names.
fn heading(name: &str) -> &'static str {
    ["sun", "ring", "carrier"].into_iter().find(|member| name.contains(member)).unwrap_or("")
}
