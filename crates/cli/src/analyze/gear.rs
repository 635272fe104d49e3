//! Everything about one gear.

use super::overview::{
    as_published, contradictions, duty, engaged, fast_planets, in_words, moving, published_figure,
    self_locking, warnings,
};
use super::subject::Subject;
use super::{Input, Worked, planet_bearings, shared, work};
use crate::failure::Failure;
use epicyclic_formats::Dimension;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{
    Analysis, Direction, Gearbox, LinkId, LoadCase, Operation, PlanetSet, ShiftElement, State,
};
use epicyclic_views::figure::{Figure, column, multiple, quantity, text};
use epicyclic_views::report::{Column, Part, Records, Report, Row, Section, View};

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
    parts.extend(planet_bearings::of_gear(subject, &worked, input)?.map(Part::Records));
    if !gearbox.shift_elements().is_empty() {
        parts.push(Part::Records(scene.shift_elements()));
    }
    if gearbox.shift_elements().iter().any(ShiftElement::is_one_way) {
        parts.push(Part::Records(scene.one_way_clutches()));
    }
    if worked.analysis.ideal().is_some() {
        parts.push(Part::Facts(scene.terminals()));
        parts.push(Part::Records(scene.sets()));
        parts.push(Part::Records(scene.members()));
        parts.push(Part::Records(scene.meshes()));
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
    worked: &'a Worked<'a>,
}

impl Scene<'_> {
    fn analysis(&self) -> &Analysis<'_> {
        &self.worked.analysis
    }

    fn operation(&self) -> Option<&Operation> {
        self.worked.operation.as_ref()
    }

    /// Driven from the output, because the load brakes.
    fn is_back_driven(&self) -> bool {
        self.operation().is_some_and(|operation| operation.direction == Direction::BackDrive)
    }

    /// Torques with losses in the sense in which power runs.
    fn case(&self) -> Option<&LoadCase> {
        if self.is_back_driven() { self.analysis().back_driving() } else { self.analysis().driving() }
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
            Row::new("efficiency", "efficiency", "η", [moving(analysis.efficiency())]),
            Row::new(
                "kreines_efficiency",
                "the same by Kreines' rule",
                "",
                [moving(analysis.kreines().map(|kreines| kreines.efficiency))],
            ),
            Row::new(
                "overrun_efficiency",
                "back-driving efficiency",
                "",
                [moving(analysis.back_driving_efficiency())],
            ),
            Row::new("self_locking", "self-locking", "", [self_locking(analysis)]),
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
                text(self.made_of(link)),
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
    fn made_of(&self, link: usize) -> String {
        let gear = self.analysis().gear();
        let terminal = |which: LinkId, name: &'static str| (which.index() == link).then(|| name.to_owned());
        let terminals = [terminal(gear.input(), "input"), terminal(gear.output(), "output")];
        let of_sets = self.gearbox.sets().iter().flat_map(|set| {
            let members = set.members().iter().enumerate().filter(|(_, member)| member.index() == link);
            members.map(|(place, _)| format!("{} {}", set.member_name(place), set.id())).collect::<Vec<_>>()
        });
        terminals.into_iter().flatten().chain(of_sets).collect::<Vec<_>>().join(", ")
    }

    fn planets(&self) -> Records {
        let mut rows = vec![];
        for (set, motion) in self.gearbox.sets().iter().zip(self.analysis().sets()) {
            for (place, planet) in motion.planets.iter().enumerate() {
                let relative = planet.map(|planet| planet.relative);
                let absolute = planet.and_then(|planet| planet.absolute);
                rows.push(vec![
                    text(set.id()),
                    text(planet_bearings::planet_name(set, place)),
                    multiple(relative),
                    self.speed(relative),
                    multiple(absolute),
                    self.speed(absolute),
                ]);
            }
        }
        let shown: &[&'static str] = if self.input.speed.is_some() {
            &["set", "planet", "relative_of_input", "relative", "absolute_of_input", "absolute"]
        } else {
            &["set", "planet", "relative_of_input", "absolute_of_input"]
        };
        let is_missing =
            |set: &PlanetSet| (0..set.planets().len()).any(|planet| set.planet_factor(planet).is_none());
        let without: Vec<&str> =
            self.gearbox.sets().iter().filter(|set| is_missing(set)).map(PlanetSet::id).collect();
        let missing = if without.is_empty() {
            String::new()
        } else {
            format!("Planet teeth are missing, and with them speeds: set {}.", without.join(", "))
        };
        Records {
            name: "planets",
            columns: vec![
                Column::words("set", "set"),
                Column::words("planet", "planet"),
                Column::number("relative_of_input", "on its carrier"),
                Column::quantity("relative", Dimension::AngularSpeed),
                Column::number("absolute_of_input", "absolute"),
                Column::quantity("absolute", Dimension::AngularSpeed),
            ],
            rows,
            views: vec![View { note: missing, ..View::new("Speeds of planets over the input's", shown) }],
            is_answer: false,
        }
    }

    fn shift_elements(&self) -> Records {
        let analysis = self.analysis();
        let rows = self.gearbox.shift_elements().iter().enumerate().map(|(place, shift_element)| {
            let is_engaged = analysis.gear().engaged().contains(&place);
            let [first, second] = shift_element.links().map(|link| self.gearbox.link_name(link));
            let ideal = analysis.ideal().and_then(|case| case.shift_elements[place]);
            vec![
                text(shift_element.id()),
                text(format!("{first} - {second}")),
                shared::state(is_engaged),
                multiple(analysis.slips()[place]),
                self.speed(analysis.slips()[place]),
                multiple(ideal),
                multiple(self.of_input(|case| case.shift_elements[place])),
                column(self.operation().and_then(|operation| operation.shift_elements[place])),
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
            note: if self.is_held() {
                "With losses: the torques at which it just moves, the output helped along. With less there the meshes \
                 hold it, whatever the input's torque."
            } else {
                ""
            },
        }
    }

    /// Whether no torque at the input moves it.
    fn is_held(&self) -> bool {
        matches!(self.analysis().state(), State::SelfLocking { .. })
    }

    fn sets(&self) -> Records {
        let kreines = self.analysis().kreines();
        let rows = self.gearbox.sets().iter().enumerate().map(|(place, set)| {
            let power = self.case().and_then(|case| case.power.sets[place].as_ref());
            let signs = self.case().map_or(&[][..], |case| case.signs_of(self.gearbox, place));
            // Of a set with more than two central gears no one number says it: its members and meshes do.
            let is_short = set.short().is_some();
            vec![
                text(set.id()),
                text(set.kind_name()),
                if is_short { multiple(Some(set.basic_ratio().get())) } else { Figure::None },
                set.exact_ratio()
                    .filter(|_| is_short)
                    .map_or(Figure::None, |ratio| Figure::Text(ratio.to_string())),
                if is_short { Figure::Multiple(set.efficiency()) } else { Figure::None },
                match signs {
                    [0] => Figure::Answer("none", "none"),
                    [1] => Figure::Answer("first_to_second", "first to second"),
                    [-1] => Figure::Answer("second_to_first", "second to first"),
                    _ => Figure::None,
                },
                kreines.map_or(Figure::None, |kreines| {
                    Figure::Texts(kreines.exponents[place].iter().map(ToString::to_string).collect())
                }),
                multiple(
                    power.filter(|_| is_short).map(epicyclic_train::power_flow::SetPower::rolling_power),
                ),
                multiple(power.map(|power| power.loss)),
            ]
        });
        Records {
            name: "sets",
            columns: vec![
                Column::words("set", "set"),
                Column::words("kind", "kind"),
                Column::number("basic_ratio", "i₀"),
                Column::number("exact_ratio", "exact"),
                Column::number("efficiency", "η₀"),
                Column::words("rolling_power_runs", "rolling power runs"),
                Column::words("kreines_exponents", "x"),
                Column::number("rolling_power", "rolling"),
                Column::number("loss", "loss"),
            ],
            rows: rows.collect(),
            views: vec![View {
                note: "Rolling: power through the meshes, seen from the carrier, over what enters; from the first \
                       central gear to the second. i₀, η₀: of sets with two central gears."
                    .to_owned(),
                ..View::new(
                    "Planet sets",
                    &[
                        "set",
                        "kind",
                        "basic_ratio",
                        "exact_ratio",
                        "efficiency",
                        "rolling_power",
                        "loss",
                    ],
                )
            }],
            is_answer: false,
        }
    }

    /// Torques and powers of every member of every set.
    fn members(&self) -> Records {
        let ideal = self.analysis().ideal();
        let mut rows = vec![];
        for (place, set) in self.gearbox.sets().iter().enumerate() {
            let power = self.case().and_then(|case| case.power.sets[place].as_ref());
            let at = self.operation().and_then(|at| at.members[place].as_ref());
            for (member, link) in set.members().iter().enumerate() {
                let of = |case: &LoadCase| case.members[place].as_ref().map(|torques| torques[member]);
                let name = if member == set.centrals().len() {
                    "carrier".to_owned()
                } else {
                    set.gear_name(GearOf::Central(member))
                };
                rows.push(vec![
                    text(set.id()),
                    text(name),
                    text(self.gearbox.link_name(*link)),
                    multiple(ideal.and_then(of)),
                    multiple(self.of_input(of)),
                    column(at.map(|torques| torques[member])),
                    multiple(power.map(|power| power.members[member])),
                    multiple(self.case().map(|case| case.power.circulating_member(place, member))),
                ]);
            }
        }
        let mut shown = vec!["set", "member", "link", "ideal_torque_of_input"];
        if self.subject.has_losses() {
            shown.push("torque_of_input");
        }
        shown.extend(self.operation().map(|_| "torque"));
        shown.push("power_of_entering");
        if self.case().is_some_and(|case| case.power.circulating > 0.0) {
            shown.push("circulating_of_entering");
        }
        Records {
            name: "members",
            columns: vec![
                Column::words("set", "set"),
                Column::words("member", "member"),
                Column::words("link", "link"),
                Column::number("ideal_torque_of_input", "ideal T"),
                Column::number("torque_of_input", "T"),
                Column::quantity("torque", Dimension::Torque),
                Column::number("power_of_entering", "power"),
                Column::number("circulating_of_entering", "circulating"),
            ],
            rows,
            views: vec![View {
                note:
                    "T: over the input's torque, without losses and with. Power: over what enters the gear; \
                       positive where it enters the set."
                        .to_owned(),
                ..View::new("Members of the sets", &shown)
            }],
            is_answer: false,
        }
    }

    /// Power through every mesh.
    fn meshes(&self) -> Records {
        let power = |set| self.case().and_then(|case| case.meshes(self.gearbox, set));
        let rows = shared::meshes(self.gearbox, power, multiple);
        Records {
            name: "meshes",
            columns: vec![
                Column::words("set", "set"),
                Column::words("from", "from"),
                Column::words("to", "to"),
                Column::number("efficiency", "η"),
                Column::number("enters_of_entering", "enters"),
                Column::number("leaves_of_entering", "leaves"),
            ],
            rows,
            views: vec![View {
                note: "In the sense of the power.".to_owned(),
                ..View::new(
                    "Power through the meshes over what enters the gear, seen from the carriers",
                    &["set", "from", "to", "efficiency", "enters_of_entering", "leaves_of_entering"],
                )
            }],
            is_answer: false,
        }
    }

    /// What the one-way clutches do.
    fn one_way_clutches(&self) -> Records {
        let rows = self.analysis().one_way_clutches().into_iter().map(|one| {
            vec![
                text(self.gearbox.shift_elements()[one.shift_element].id()),
                Figure::YesNo(one.is_relied_on),
                duty(one.drive),
                duty(one.coast),
            ]
        });
        Records {
            name: "one_way_clutches",
            columns: vec![
                Column::words("clutch", "clutch"),
                Column::words("relied_on", "relied on"),
                Column::words("drive", "on drive"),
                Column::words("coast", "on coast"),
            ],
            rows: rows.collect(),
            views: vec![View::new("One-way clutches", &["clutch", "relied_on", "drive", "coast"])],
            is_answer: false,
        }
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
        if self.is_held() {
            rows[0] = Row::new("helping", "enters at the output too", "", [of(|case| -case.efficiency)]);
        }
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
            if self.is_back_driven() {
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
        let arrows = |signs: &[Vec<i8>]| {
            let one = |sign: &i8| match sign {
                0 => "0",
                1 => "+",
                _ => "-",
            };
            let of_set = |(set, signs): (&PlanetSet, &Vec<i8>)| {
                format!("{} {}", set.id(), signs.iter().map(one).collect::<String>())
            };
            self.gearbox.sets().iter().zip(signs).map(of_set).collect::<Vec<_>>().join(", ")
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
                Column::words("signs", "sets"),
                Column::number("efficiency", "η"),
                Column::words("chosen", "chosen"),
            ],
            rows: rows.collect(),
            views: vec![View::new(
                "Self-consistent sign patterns of the losses (+: from the first gear to the others)",
                &["signs", "efficiency", "chosen"],
            )],
            is_answer: false,
        }
    }

    fn warnings(&self) -> Vec<(&'static str, String)> {
        let analysis = self.analysis();
        let mut all = warnings(self.subject);
        all.extend(fast_planets(self.gearbox, analysis));
        if *analysis.state() != State::Driven {
            all.push(("state", in_words(analysis.state())));
        }
        if self.input.load.is_some() && self.operation().is_none() {
            all.push(("no-load", "no torques follow from the load in this state".to_owned()));
        }
        all.extend(contradictions(self.gearbox, analysis));
        if let Some(kreines) = analysis.kreines().filter(|kreines| !kreines.reversed.is_empty()) {
            let rows = kreines.reversed.join(", ");
            all.push((
                "kreines",
                format!("Kreines' rule as printed does not hold: the losses reverse the power of set {rows}"),
            ));
        }
        if analysis.is_self_locking() == Some(true) {
            all.push(("self-locking", "the gear is self-locking when driven from its output".to_owned()));
        }
        all
    }
}
