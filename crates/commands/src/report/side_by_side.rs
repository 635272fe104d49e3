//! The figures of every gear side by side: a line for each link, member or mesh, a column for each gear.

use crate::analyze::answer::gear::{Mesh, OneGear, Powers};
use crate::table::columns;
use crate::table::figure::{Figure, multiple};
use crate::table::quantities::column;
use crate::table::report::{Part, Report};
use epicyclic_units::Dimension;

/// Largest number of gears in a table; more gears get further tables.
const ABREAST: usize = 10;

/// Subject of a line and its figure in each gear.
struct Line {
    of: Vec<String>,
    figures: Vec<Figure>,
}

/// A table before its gears are parted.
struct Table {
    title: &'static str,
    note: &'static str,
    /// Headings of what each line is of.
    of: &'static [&'static str],
    lines: Vec<Line>,
}

/// Figures of every gear that the tables of all gears do not show.
pub(crate) fn report(gears: &[OneGear]) -> Report {
    let tables = [
        links(gears),
        powers_of_links(gears),
        planets(gears),
        torques(gears),
        members(gears),
        powers_of_members(gears),
        circulating(gears),
        meshes(gears),
        sets(gears),
        pins(gears),
        powers(gears),
    ];
    let names: Vec<&str> = gears.iter().map(|gear| gear.gear.gear.as_str()).collect();
    let parts = tables.into_iter().flat_map(|table| table.parts(&names)).collect();
    Report { parts, ..Report::default() }
}

impl Table {
    /// As many gears in each table as there is room for; lines and gears without figures are left out.
    fn parts(mut self, gears: &[&str]) -> Vec<Part> {
        let has_figures = |figure: &Figure| !matches!(figure, Figure::None);
        self.lines.retain(|line| line.figures.iter().any(has_figures));
        let has_any = |gear: &usize| self.lines.iter().any(|line| has_figures(&line.figures[*gear]));
        let shown: Vec<usize> = (0..gears.len()).filter(has_any).collect();
        let tables = shown.len().div_ceil(ABREAST).max(1);
        let abreast = shown.len().div_ceil(tables).max(1);
        shown.chunks(abreast).map(|shown| self.part(gears, shown)).collect()
    }

    fn part(&self, gears: &[&str], shown: &[usize]) -> Part {
        const OF: [&str; 3] = ["first", "second", "third"];
        let of = OF.iter().zip(self.of).enumerate();
        let table = columns::Table::new("gears", &self.lines)
            .each(of, |table, (place, (name, heading))| table.text(name, heading, |line| &line.of[place]))
            .each(shown, |table, gear| {
                table.number("gear", "", |line| line.figures[*gear].clone()).of(gears[*gear])
            });
        Part::Records(table.all(self.title).note(self.note).records())
    }
}

/// Lines of what the gears have in common, in the order in which each first comes; `figure` is nothing where
/// a gear lacks it.
fn lines<'a, T: 'a, const N: usize>(
    gears: &'a [OneGear],
    all: impl Fn(&'a OneGear) -> &'a [T],
    of: impl Fn(&T) -> [String; N],
    figure: impl Fn(&T) -> Figure,
) -> Vec<Line> {
    let mut lines: Vec<Line> = vec![];
    for (place, gear) in gears.iter().enumerate() {
        for one in all(gear) {
            let name = of(one);
            let line = match lines.iter_mut().position(|line| line.of == name) {
                Some(known) => &mut lines[known],
                None => {
                    lines.push(Line { of: name.to_vec(), figures: vec![Figure::None; gears.len()] });
                    let last = lines.len() - 1;
                    &mut lines[last]
                }
            };
            line.figures[place] = figure(one);
        }
    }
    lines
}

/// Whether any of it is known in units.
fn has<'a, T: 'a>(
    gears: &'a [OneGear],
    all: impl Fn(&'a OneGear) -> &'a [T],
    of: impl Fn(&T) -> Option<f64>,
) -> bool {
    gears.iter().flat_map(all).any(|one| of(one).is_some())
}

fn made_of(link: &crate::analyze::answer::gear::Link) -> [String; 2] {
    let members: Vec<String> =
        link.members.iter().map(|member| format!("{} {}", member.member, member.set)).collect();
    [link.link.clone(), members.join(", ")]
}

fn links(gears: &[OneGear]) -> Table {
    let is_known = has(gears, |gear| &gear.links, |link| link.speed_rad_s);
    Table {
        title: if is_known { "Speed of the links, rpm" } else { "Speed of the links over the input's" },
        note: "",
        of: &["link", "members"],
        lines: lines(
            gears,
            |gear| &gear.links,
            made_of,
            |link| match is_known {
                true => column(Dimension::AngularSpeed, link.speed_rad_s),
                false => multiple(link.speed_of_input),
            },
        ),
    }
}

fn powers_of_links(gears: &[OneGear]) -> Table {
    let is_known = has(gears, |gear| &gear.links, |link| link.power_w);
    Table {
        title: if is_known {
            "Power through the links, kW"
        } else {
            "Power through the links over what enters"
        },
        note: "",
        of: &["link"],
        lines: lines(
            gears,
            |gear| &gear.links,
            |link| [link.link.clone()],
            |link| match is_known {
                true => column(Dimension::Power, link.power_w),
                false => multiple(link.power_of_entering),
            },
        ),
    }
}

fn planets(gears: &[OneGear]) -> Table {
    let is_known = has(gears, |gear| &gear.planets, |planet| planet.relative_speed_rad_s);
    let all = gears.iter().flat_map(|gear| &gear.planets);
    Table {
        title: if is_known {
            "Speed of the planets relative to their carriers, rpm"
        } else {
            "Speed of the planets relative to their carriers, over the input's"
        },
        note: if all.into_iter().all(|planet| planet.has_teeth) {
            ""
        } else {
            "Of planets without teeth no speed follows."
        },
        of: &["set", "planet"],
        lines: lines(
            gears,
            |gear| &gear.planets,
            |planet| [planet.set.clone(), planet.planet.clone()],
            |planet| match is_known {
                true => column(Dimension::AngularSpeed, planet.relative_speed_rad_s),
                false => multiple(planet.relative_speed_of_input),
            },
        ),
    }
}

/// A line of figures, one of each gear.
fn line(of: &str, gears: &[OneGear], figure: impl Fn(&OneGear) -> Figure) -> Line {
    Line { of: vec![of.to_owned()], figures: gears.iter().map(figure).collect() }
}

fn torques(gears: &[OneGear]) -> Table {
    let at_load = |gear: &OneGear| gear.torques.as_ref().and_then(|torques| torques.at_load.clone());
    if gears.iter().any(|gear| at_load(gear).is_some()) {
        let torque = |si: Option<f64>| column(Dimension::Torque, si);
        return Table {
            title: "Torques on the gearbox, N·m",
            note: "With losses. From the housing: what it must be held with.",
            of: &["at"],
            lines: vec![
                line("input", gears, |gear| torque(at_load(gear).map(|load| load.input_n_m))),
                line("output", gears, |gear| torque(at_load(gear).map(|load| load.output_n_m))),
                line("housing", gears, |gear| torque(at_load(gear).map(|load| load.housing_n_m))),
            ],
        };
    }
    let ideal = |gear: &OneGear| gear.torques.as_ref().map(|torques| torques.without_losses.clone());
    let real = |gear: &OneGear| gear.torques.as_ref().and_then(|torques| torques.with_losses.clone());
    let mut lines = vec![
        line("output, without losses", gears, |gear| multiple(ideal(gear).map(|torques| torques.output))),
        line("housing, without losses", gears, |gear| multiple(ideal(gear).map(|torques| torques.housing))),
    ];
    if gears.iter().any(|gear| gear.has_losses) {
        lines.extend([
            line("output, with losses", gears, |gear| multiple(real(gear).map(|torques| torques.output))),
            line("housing, with losses", gears, |gear| multiple(real(gear).map(|torques| torques.housing))),
        ]);
    }
    Table {
        title: "Torques on the gearbox over the input's",
        note: "From the housing: what it must be held with. Where the meshes hold a gear: the torques at which it just moves, helped along.",
        of: &["at"],
        lines,
    }
}

fn member(member: &crate::analyze::answer::gear::Member) -> [String; 3] {
    [member.set.clone(), member.member.clone(), member.link.clone()]
}

fn members(gears: &[OneGear]) -> Table {
    let is_known = has(gears, |gear| &gear.members, |member| member.torque_n_m);
    let is_lossy = gears.iter().any(|gear| gear.has_losses);
    Table {
        title: match (is_known, is_lossy) {
            (true, _) => "Torque on the members of the sets, N·m",
            (false, true) => "Torque on the members of the sets over the input's, with losses",
            (false, false) => "Torque on the members of the sets over the input's",
        },
        note: "",
        of: &["set", "member", "link"],
        lines: lines(
            gears,
            |gear| &gear.members,
            member,
            |member| match (is_known, is_lossy) {
                (true, _) => column(Dimension::Torque, member.torque_n_m),
                (false, true) => multiple(member.torque_of_input),
                (false, false) => multiple(member.ideal_torque_of_input),
            },
        ),
    }
}

fn powers_of_members(gears: &[OneGear]) -> Table {
    Table {
        title: "Power of the members over what enters the gear",
        note: "Positive where it enters the set.",
        of: &["set", "member"],
        lines: lines(
            gears,
            |gear| &gear.members,
            |member| [member.set.clone(), member.member.clone()],
            |member| multiple(member.power_of_entering),
        ),
    }
}

/// Members that carry power round, and how much.
fn circulating(gears: &[OneGear]) -> Table {
    let carries = |member: &Option<f64>| member.filter(|power| power.abs() > crate::tolerance::CIRCULATES);
    Table {
        title: "The part of it that circulates",
        note: "",
        of: &["set", "member"],
        lines: lines(
            gears,
            |gear| &gear.members,
            |member| [member.set.clone(), member.member.clone()],
            |member| multiple(carries(&member.circulating_of_entering)),
        ),
    }
}

/// Table of the meshes. Every gear has the same meshes in the same order; a mesh is named by the direction of
/// its power in the first gear.
fn meshes(gears: &[OneGear]) -> Table {
    let first: &[Mesh] = gears.first().map_or(&[], |gear| &gear.meshes);
    let line = |(place, mesh): (usize, &Mesh)| {
        let into = |gear: &OneGear| {
            let of_gear = gear.meshes.get(place)?;
            let sign = if of_gear.from == mesh.from { 1.0 } else { -1.0 };
            // No −0.0 where nothing passes.
            of_gear.enters_of_entering.map(|power| sign * power + 0.0)
        };
        let between = format!("{} to {}", mesh.from, mesh.to);
        Line {
            of: vec![mesh.set.clone(), between, Figure::Multiple(mesh.efficiency).table()],
            figures: gears.iter().map(|gear| multiple(into(gear))).collect(),
        }
    };
    Table {
        title: "Power into the meshes over what enters the gear, seen from the carriers",
        note: "η: of the mesh; η times what enters leaves. Negative where the power runs the other way.",
        of: &["set", "mesh", "η"],
        lines: first.iter().enumerate().map(line).collect(),
    }
}

fn sets(gears: &[OneGear]) -> Table {
    Table {
        title: "Loss of the sets over what enters the gear",
        note: "",
        of: &["set"],
        // The only set loses what the gear does.
        lines: if gears.iter().any(|gear| gear.has_losses && gear.sets.len() > 1) {
            lines(gears, |gear| &gear.sets, |set| [set.set.clone()], |set| multiple(set.loss_of_entering))
        } else {
            vec![]
        },
    }
}

/// Torques of the pins where no size of theirs is known; the tables of all gears have the forces of others.
fn pins(gears: &[OneGear]) -> Table {
    let is_sized = has(gears, |gear| &gear.planet_bearings, |one| one.carrier_radius_m);
    Table {
        title: "Torque of the planet pins on the carrier, each, over the input's",
        note: "",
        of: &["set", "planet"],
        lines: if is_sized {
            vec![]
        } else {
            lines(
                gears,
                |gear| &gear.planet_bearings,
                |one| [one.set.clone(), one.planet.clone()],
                |one| multiple(one.carrier_torque_each_of_input),
            )
        },
    }
}

fn powers(gears: &[OneGear]) -> Table {
    let of = |gear: &OneGear, power: fn(&Powers) -> Option<f64>| gear.powers.as_ref().and_then(power);
    let at_load = |name: &str, power: fn(&Powers) -> Option<f64>| {
        line(name, gears, |gear| column(Dimension::Power, of(gear, power)))
    };
    if gears.iter().any(|gear| of(gear, |powers| powers.at_load.as_ref().map(|load| load.loss_w)).is_some()) {
        return Table {
            title: "Powers, with losses, kW",
            note: "",
            of: &["power"],
            lines: vec![
                at_load("enters", |powers| Some(powers.at_load.as_ref()?.entering_w)),
                at_load("leaves", |powers| Some(powers.at_load.as_ref()?.leaving_w)),
                at_load("lost in the meshes", |powers| Some(powers.at_load.as_ref()?.loss_w)),
                at_load("circulates", |powers| Some(powers.at_load.as_ref()?.circulating_w)),
                at_load("largest of any member", |powers| Some(powers.at_load.as_ref()?.largest_w)),
            ],
        };
    }
    let share =
        |name: &str, power: fn(&Powers) -> Option<f64>| line(name, gears, |gear| multiple(of(gear, power)));
    Table {
        title: "Powers over what enters, with losses",
        note: "",
        of: &["power"],
        lines: vec![
            share("enters at the other end too", |powers| powers.of_entering.as_ref()?.helping),
            share("lost in the meshes", |powers| Some(powers.of_entering.as_ref()?.loss)),
            share("circulates", |powers| Some(powers.of_entering.as_ref()?.circulating)),
            share("largest of any member", |powers| Some(powers.of_entering.as_ref()?.largest)),
            line("efficiency by Kreines' rule", gears, |gear| multiple(gear.gear.kreines_efficiency)),
        ],
    }
}
