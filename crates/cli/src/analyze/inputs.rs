//! Gears with several inputs: speeds and torques of several links, at one point or over a map.

use super::overview::{engaged, warnings};
use super::subject::Subject;
use super::{planet_bearings, shared};
use crate::failure::Failure;
use epicyclic_formats::gearbox::gear_place;
use epicyclic_formats::visible::one_line;
use epicyclic_formats::{Dimension, Document, Physical, Problem, Quantity};
use epicyclic_train::inputs::{MultiLoad, MultiState};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{Error, Gear, Gearbox, LinkId};
use epicyclic_views::figure::{Figure, column, multiple, quantity, text};
use epicyclic_views::report::{Column, Part, Records, Report, Row, Section, View};
use std::str::FromStr;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Values of links: `engine=2000 rpm, mg1=-500 rpm`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Assignments<T>(Vec<(String, T)>);

impl<T: FromStr<Err: ToString>> FromStr for Assignments<T> {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let one = |part: &str| {
            let (link, value) = part.split_once('=').ok_or_else(|| {
                format!("{}: write a link and its value, as engine=2000rpm", one_line(part))
            })?;
            let value = value
                .trim()
                .parse()
                .map_err(|error: T::Err| format!("{}: {}", one_line(link), error.to_string()))?;
            Ok((link.trim().to_owned(), value))
        };
        written.split([',', ';']).map(str::trim).map(one).collect::<Result<_, String>>().map(Self)
    }
}

/// A range of speeds with as many places: `800rpm..4000rpm/9`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Steps {
    from: AngularVelocity,
    to: AngularVelocity,
    places: u32,
}

/// More places in a direction than anyone reads.
const MOST_PLACES: u32 = 1000;

impl FromStr for Steps {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form =
            || format!("{}: write a range and how many places, as 800rpm..4000rpm/9", one_line(written));
        let (range, places) = written.rsplit_once('/').ok_or_else(form)?;
        let (from, to) = range.split_once("..").ok_or_else(form)?;
        let speed = |text: &str| {
            let speed: Result<Quantity<AngularVelocity>, _> = text.trim().parse();
            speed.map(|speed| speed.0).map_err(|error| error.to_string())
        };
        let places: u32 = places.trim().parse().map_err(|_| form())?;
        if !(2..=MOST_PLACES).contains(&places) {
            return Err(format!("{places} places: 2 to {MOST_PLACES} are allowed"));
        }
        Ok(Self { from: speed(from)?, to: speed(to)?, places })
    }
}

/// What several links of a gear do.
#[derive(Debug, clap::Args)]
pub(crate) struct Several {
    /// Speeds of links of a gear that keeps freedoms, as many as it keeps: engine=2000rpm, mg1=3000rpm.
    #[arg(long, value_name = "LINK=SPEED, …", requires = "gear", conflicts_with_all = ["torque", "power", "speed"])]
    speeds: Option<Assignments<Quantity<AngularVelocity>>>,

    /// Torques at links where power enters or leaves; those of the other ends follow: engine=100N·m.
    #[arg(long, value_name = "LINK=TORQUE, …", requires = "gear", conflicts_with_all = ["torque", "power", "speed"])]
    torques: Option<Assignments<Quantity<Torque>>>,

    /// The state over ranges of two speeds, a line a place: engine=800rpm..4000rpm/9, mg1=-5000rpm..5000rpm/11.
    #[arg(long, value_name = "LINK=FROM..TO/PLACES, …", requires = "gear", conflicts_with_all = ["speeds", "torque", "power", "speed"])]
    map: Option<Assignments<Steps>>,
}

impl Several {
    /// Whether any of it is given.
    pub(super) fn is_given(&self) -> bool {
        self.speeds.is_some() || self.torques.is_some() || self.map.is_some()
    }
}

/// Speeds and torques of links, from options or a file.
struct Given {
    speeds: Vec<(LinkId, AngularVelocity)>,
    torques: Vec<(LinkId, Torque)>,
}

/// Whether the file states speeds of this gear.
pub(super) fn in_file(subject: &Subject, gear: &str) -> bool {
    subject.inputs(gear).is_some_and(|inputs| !inputs.speeds.is_empty())
}

/// The whole answer.
pub(super) fn report(
    subject: &Subject,
    document: &Document,
    name: &str,
    several: &Several,
) -> Result<Report, Failure> {
    let gearbox = &subject.gearbox;
    let gear = super::analysis(gearbox, name)?.gear().clone();
    let task = Task { subject, document, gearbox, gear: &gear };
    let given = task.given(several)?;
    if let Some(map) = &several.map {
        return task.map(map, &given.torques);
    }
    let at = if several.speeds.is_some() { Origin::Option("--speeds") } else { Origin::File("speeds") };
    let state = task.state(&given.speeds, &given.torques, at, several.torques.is_some())?;
    Ok(task.point(&given, &state))
}

/// Where a fault is told.
#[derive(Clone, Copy)]
enum Origin {
    Option(&'static str),
    File(&'static str),
}

struct Task<'a> {
    subject: &'a Subject,
    document: &'a Document,
    gearbox: &'a Gearbox,
    gear: &'a Gear,
}

impl Task<'_> {
    fn refuse(&self, at: Origin, message: String) -> Failure {
        match at {
            Origin::Option(option) => Failure::Option { option, message },
            Origin::File(key) => {
                let place = gear_place(self.document, &self.subject.base, self.gear.name(), key);
                self.document.error(&place, Problem::Refused { message }).into()
            }
        }
    }

    fn link(&self, name: &str, at: Origin) -> Result<LinkId, Failure> {
        self.gearbox.link(name).ok_or_else(|| {
            let links = self.gearbox.links()[1..].join(", ");
            self.refuse(at, format!("no link is called `{name}`: there are {links}"))
        })
    }

    fn links<'v, T: Copy + 'v>(
        &self,
        values: impl Iterator<Item = (&'v String, T)>,
        at: Origin,
    ) -> Result<Vec<(LinkId, T)>, Failure> {
        values.map(|(name, value)| Ok((self.link(name, at)?, value))).collect()
    }

    /// What the options give, else what the file does.
    fn given(&self, several: &Several) -> Result<Given, Failure> {
        let inputs = self.subject.inputs(self.gear.name());
        let speeds = match (&several.speeds, inputs) {
            (Some(given), _) => {
                let given = given.0.iter().map(|(link, speed)| (link, speed.0));
                self.links(given, Origin::Option("--speeds"))?
            }
            (None, Some(inputs)) if several.map.is_none() => {
                let given = inputs.speeds.iter().map(|(link, speed)| (link, speed.0));
                self.links(given, Origin::File("speeds"))?
            }
            _ => vec![],
        };
        let torques = match (&several.torques, inputs) {
            (Some(given), _) => {
                let given = given.0.iter().map(|(link, torque)| (link, torque.0));
                self.links(given, Origin::Option("--torques"))?
            }
            // Speeds of one's own ask another question.
            (None, Some(inputs)) if several.speeds.is_none() => {
                let given = inputs.torques.iter().map(|(link, torque)| (link, torque.0));
                self.links(given, Origin::File("torques"))?
            }
            _ => vec![],
        };
        Ok(Given { speeds, torques })
    }

    fn state(
        &self,
        speeds: &[(LinkId, AngularVelocity)],
        torques: &[(LinkId, Torque)],
        at: Origin,
        own_torques: bool,
    ) -> Result<MultiState, Failure> {
        use epicyclic_train::InputsFault as Fault;
        self.gearbox.with_inputs(self.gear, speeds, torques).map_err(|error| match &error {
            Error::Inputs(Fault::Torques { .. } | Fault::DependentTorques { .. }) => {
                let at = if own_torques { Origin::Option("--torques") } else { Origin::File("torques") };
                self.refuse(at, error.to_string())
            }
            Error::Inputs(_) => self.refuse(at, error.to_string()),
            _ => error.into(),
        })
    }

    fn point(&self, given: &Given, state: &MultiState) -> Report {
        let mut parts = vec![Part::Facts(self.facts(state)), Part::Records(self.links_of(state, given))];
        if state.sets.iter().any(|set| !set.planets.is_empty()) {
            parts.push(Part::Records(self.planets(state)));
        }
        if !self.gearbox.shift_elements().is_empty() {
            parts.push(Part::Records(self.shift_elements(state)));
        }
        if let Some(load) = &state.load {
            parts.push(Part::Records(self.terminals(load)));
            parts.push(Part::Records(self.members(load)));
            parts.push(Part::Records(self.meshes(load)));
            parts.push(Part::Facts(powers(load)));
        } else {
            let words =
                "--torques engine=100N·m, or torques of the gear in the file, adds torques and powers.\n";
            parts.push(Part::Words(words.to_owned()));
        }
        let mut all = warnings(self.subject);
        all.extend(self.one_way(state));
        Report {
            title: Some(format!("{}, gear {}", self.gearbox.name(), self.gear.name())),
            parts,
            warnings: Some(all),
        }
    }

    fn facts(&self, state: &MultiState) -> Section {
        let name = |link| self.gearbox.link_name(link).to_owned();
        Section {
            name: "gear",
            title: "Gear",
            columns: &[],
            rows: vec![
                Row::new("gear", "gear", "", [text(self.gear.name())]),
                Row::new("engaged", "engaged", "", [Figure::Texts(engaged(self.gearbox, self.gear))]),
                Row::new("input", "input", "", [text(name(self.gear.input()))]),
                Row::new("output", "output", "", [text(name(self.gear.output()))]),
                Row::new("freedoms", "freedoms", "", [Figure::Count(state.freedoms as u32)]),
            ],
            note: "",
        }
    }

    fn links_of(&self, state: &MultiState, given: &Given) -> Records {
        let rows = (1..self.gearbox.links().len()).map(|place| {
            let is_given = given.speeds.iter().any(|(link, _)| link.index() == place);
            let through = state.load.as_ref().and_then(|load| load.power.links[place]);
            vec![
                text(&self.gearbox.links()[place]),
                column(state.speeds[place]),
                Figure::YesNo(is_given),
                column(through.map(<Power as Physical>::from_si)),
            ]
        });
        let mut shown = vec!["link", "speed", "given"];
        shown.extend(state.load.as_ref().map(|_| "power"));
        Records {
            name: "links",
            columns: vec![
                Column::words("link", "link"),
                Column::quantity("speed", Dimension::AngularSpeed),
                Column::words("given", "given"),
                Column::quantity("power", Dimension::Power),
            ],
            rows: rows.collect(),
            views: vec![View::new("Links: speed, and power through each", &shown)],
            is_answer: true,
        }
    }

    fn planets(&self, state: &MultiState) -> Records {
        let speed = <AngularVelocity as Physical>::from_si;
        let mut rows = vec![];
        for (set, motion) in self.gearbox.sets().iter().zip(&state.sets) {
            for (place, planet) in motion.planets.iter().enumerate() {
                rows.push(vec![
                    text(set.id()),
                    text(planet_bearings::planet_name(set, place)),
                    column(planet.map(|planet| speed(planet.relative))),
                    column(planet.and_then(|planet| planet.absolute).map(speed)),
                ]);
            }
        }
        Records {
            name: "planets",
            columns: vec![
                Column::words("set", "set"),
                Column::words("planet", "planet"),
                Column {
                    heading: "on its carrier, rpm".into(),
                    ..Column::quantity("relative", Dimension::AngularSpeed)
                },
                Column {
                    heading: "absolute, rpm".into(),
                    ..Column::quantity("absolute", Dimension::AngularSpeed)
                },
            ],
            rows,
            views: vec![View::new("Speeds of planets", &["set", "planet", "relative", "absolute"])],
            is_answer: false,
        }
    }

    fn shift_elements(&self, state: &MultiState) -> Records {
        let rows = self.gearbox.shift_elements().iter().enumerate().map(|(place, shift_element)| {
            let [first, second] = shift_element.links().map(|link| self.gearbox.link_name(link));
            let is_engaged = self.gear.engaged().contains(&place);
            vec![
                text(shift_element.id()),
                text(format!("{first} - {second}")),
                shared::state(is_engaged),
                column(state.slips[place]),
                column(state.load.as_ref().and_then(|load| load.shift_elements[place])),
            ]
        });
        let mut shown = vec!["control", "joins", "is", "slip"];
        shown.extend(state.load.as_ref().map(|_| "torque"));
        Records {
            name: "controls",
            columns: vec![
                Column::words("control", "element"),
                Column::words("joins", "joins"),
                Column::words("is", "is"),
                Column::quantity("slip", Dimension::AngularSpeed),
                Column::quantity("torque", Dimension::Torque),
            ],
            rows: rows.collect(),
            views: vec![View {
                note: "Slip: first link less second. Torque: on the first link.".to_owned(),
                ..View::new("Shift elements", &shown)
            }],
            is_answer: false,
        }
    }

    fn terminals(&self, load: &MultiLoad) -> Records {
        let rows = load.terminals.iter().map(|end| {
            vec![text(self.gearbox.link_name(end.link)), column(Some(end.torque)), column(Some(end.power))]
        });
        let housing = vec![text(epicyclic_train::GROUND), column(Some(load.housing)), Figure::None];
        Records {
            name: "terminals",
            columns: vec![
                Column::words("link", "link"),
                Column::quantity("torque", Dimension::Torque),
                Column::quantity("power", Dimension::Power),
            ],
            rows: rows.chain([housing]).collect(),
            views: vec![View {
                note: "Torque on the gearbox from outside; power positive where it enters.".to_owned(),
                ..View::new("Where power enters and leaves", &["link", "torque", "power"])
            }],
            is_answer: false,
        }
    }

    fn members(&self, load: &MultiLoad) -> Records {
        let mut rows = vec![];
        for (place, set) in self.gearbox.sets().iter().enumerate() {
            let power = load.power.sets[place].as_ref();
            for (member, link) in set.members().iter().enumerate() {
                let name = if member == set.centrals().len() {
                    "carrier".to_owned()
                } else {
                    set.gear_name(GearOf::Central(member))
                };
                rows.push(vec![
                    text(set.id()),
                    text(name),
                    text(self.gearbox.link_name(*link)),
                    column(Some(<Torque as Physical>::from_si(load.members[place][member]))),
                    column(power.map(|power| <Power as Physical>::from_si(power.members[member]))),
                ]);
            }
        }
        Records {
            name: "members",
            columns: vec![
                Column::words("set", "set"),
                Column::words("member", "member"),
                Column::words("link", "link"),
                Column::quantity("torque", Dimension::Torque),
                Column::quantity("power", Dimension::Power),
            ],
            rows,
            views: vec![View {
                note: "Power positive where it enters the set.".to_owned(),
                ..View::new("Members of the sets", &["set", "member", "link", "torque", "power"])
            }],
            is_answer: false,
        }
    }

    fn meshes(&self, load: &MultiLoad) -> Records {
        let watts = |power: Option<f64>| column(power.map(<Power as Physical>::from_si));
        let rows = shared::meshes(self.gearbox, |set| load.meshes(self.gearbox, set), watts);
        Records {
            name: "meshes",
            columns: vec![
                Column::words("set", "set"),
                Column::words("from", "from"),
                Column::words("to", "to"),
                Column::number("efficiency", "η"),
                Column { heading: "enters, kW".into(), ..Column::quantity("enters", Dimension::Power) },
                Column { heading: "leaves, kW".into(), ..Column::quantity("leaves", Dimension::Power) },
            ],
            rows,
            views: vec![View::new(
                "Power through the meshes, seen from the carriers",
                &["set", "from", "to", "efficiency", "enters", "leaves"],
            )],
            is_answer: false,
        }
    }

    /// One-way clutches that would not let these speeds be.
    fn one_way(&self, state: &MultiState) -> Vec<(&'static str, String)> {
        let of = |(place, shift_element): (usize, &epicyclic_train::ShiftElement)| {
            let is_engaged = self.gear.engaged().contains(&place);
            let slip = state.slips[place].map(Physical::si)?;
            (shift_element.is_one_way() && !is_engaged && slip < 0.0).then(|| {
                let message = format!(
                    "the one-way clutch {} would hold at these speeds: its first link turns slower than its second",
                    shift_element.id()
                );
                ("one-way-clutch", message)
            })
        };
        self.gearbox.shift_elements().iter().enumerate().filter_map(of).collect()
    }

    /// A line for each place of a grid of speeds.
    fn map(&self, map: &Assignments<Steps>, torques: &[(LinkId, Torque)]) -> Result<Report, Failure> {
        let at = Origin::Option("--map");
        let [(first, across), (second, up)] = &map.0[..] else {
            return Err(self.refuse(at, format!("{} ranges are given: two are due", map.0.len())));
        };
        let ends = [self.link(first, at)?, self.link(second, at)?];
        let place = |steps: &Steps, i: u32| {
            steps.from + (steps.to - steps.from) * (f64::from(i) / f64::from(steps.places - 1))
        };
        let names: Vec<&'static str> = vec!["link", "speed", "torque", "power"];
        let mut rows = vec![];
        for i in 0..across.places {
            for j in 0..up.places {
                let speeds = [(ends[0], place(across, i)), (ends[1], place(up, j))];
                let state = self.state(&speeds, torques, at, true);
                // At a place where the losses hold the gear there are speeds alone.
                let state = match state {
                    Err(_)
                        if !torques.is_empty()
                            && self.gearbox.with_inputs(self.gear, &speeds, &[]).is_ok() =>
                    {
                        self.gearbox.with_inputs(self.gear, &speeds, &[])?
                    }
                    state => state?,
                };
                for link in 1..self.gearbox.links().len() {
                    let end = state
                        .load
                        .as_ref()
                        .and_then(|load| load.terminals.iter().find(|end| end.link.index() == link));
                    let through = state.load.as_ref().and_then(|load| load.power.links[link]);
                    rows.push(vec![
                        column(Some(speeds[0].1)),
                        column(Some(speeds[1].1)),
                        text(&self.gearbox.links()[link]),
                        column(state.speeds[link]),
                        column(end.map(|end| end.torque)),
                        column(through.map(<Power as Physical>::from_si)),
                        multiple(state.load.as_ref().and_then(|load| load.efficiency)),
                    ]);
                }
            }
        }
        let mut shown = vec!["first_speed", "second_speed"];
        shown.extend(if torques.is_empty() { &names[..2] } else { &names[..] });
        let headed = |name, heading: &str| Column {
            heading: format!("{heading}, rpm"),
            ..Column::quantity(name, Dimension::AngularSpeed)
        };
        let records = Records {
            name: "map",
            columns: vec![
                headed("first_speed", first),
                headed("second_speed", second),
                Column::words("link", "link"),
                Column::quantity("speed", Dimension::AngularSpeed),
                Column::quantity("torque", Dimension::Torque),
                Column::quantity("power", Dimension::Power),
                Column::number("efficiency", "η"),
            ],
            rows,
            views: vec![View {
                note:
                    "Torque: from outside, of links where power enters or leaves. Power: through each link."
                        .to_owned(),
                ..View::new("Map over two speeds", &shown)
            }],
            is_answer: true,
        };
        Ok(Report {
            title: Some(format!("{}, gear {}", self.gearbox.name(), self.gear.name())),
            parts: vec![Part::Records(records)],
            warnings: Some(warnings(self.subject)),
        })
    }
}

fn powers(load: &MultiLoad) -> Section {
    let watts = <Power as Physical>::from_si;
    let sum = |positive: bool| -> f64 {
        let powers = load.terminals.iter().map(|end| end.power.si());
        powers.filter(|power| (*power > 0.0) == positive).map(f64::abs).sum()
    };
    Section {
        name: "powers",
        title: "Powers, with losses",
        columns: &[],
        rows: vec![
            Row::new("entering", "enters", "", [quantity(watts(sum(true)))]),
            Row::new("leaving", "leaves", "", [quantity(watts(sum(false)))]),
            Row::new("loss", "lost in the meshes", "", [quantity(load.loss)]),
            Row::new("circulating", "circulates", "", [quantity(watts(load.power.circulating))]),
            Row::new("efficiency", "efficiency", "η", [multiple(load.efficiency)]),
        ],
        note: "",
    }
}
