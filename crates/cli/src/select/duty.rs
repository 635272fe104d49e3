//! A candidate at work: speeds, torques and powers of its gears at the input's speed and load.

use super::Args;
use super::winner::{Numbered, heading};
use crate::failure::Failure;
use epicyclic_formats::{Dimension, Physical, Quantity};
use epicyclic_selection::Requirements;
use epicyclic_train::{Error, Gearbox, InputLoad, Operation};
use epicyclic_views::figure::{Figure, column, text};
use epicyclic_views::report::{Column, Part, Records, View};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Power, Torque};
use uom::si::torque::newton_meter;

/// What is known of the input.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Duty")]
#[group(id = "duty")]
pub(super) struct Duty {
    /// Speed of the input, 1475 rpm: gives the speed of the output in each gear.
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    input: Option<Quantity<AngularVelocity>>,

    /// Power into the input, 75 kW; needs --input. Gives torques and losses in each gear.
    #[arg(long, requires = "input", conflicts_with = "torque", group = "load", allow_hyphen_values = true)]
    power: Option<Quantity<Power>>,

    /// Torque on the input, 500 N·m, in place of --power.
    #[arg(long, group = "load", allow_hyphen_values = true)]
    torque: Option<Quantity<Torque>>,
}

impl Duty {
    /// The torque on the input, given or from power and speed.
    pub(super) fn torque(&self) -> Result<Option<Torque>, Failure> {
        let positive = |option, value: f64, written: String| {
            let message = format!("{written}: a finite quantity above 0 is due");
            if value > 0.0 && value.is_finite() { Ok(()) } else { Err(Failure::Option { option, message }) }
        };
        if let Some(speed) = self.input {
            positive("--input", speed.0.si(), speed.to_string())?;
        }
        if let Some(torque) = self.torque {
            positive("--torque", torque.0.si(), torque.to_string())?;
            return Ok(Some(torque.0));
        }
        let (Some(power), Some(speed)) = (self.power, self.input) else { return Ok(None) };
        positive("--power", power.0.si(), power.to_string())?;
        let torque_n_m = power.0.si() / speed.0.si();
        positive("--power", torque_n_m, format!("{power} at {speed}, {torque_n_m} N·m"))?;
        Ok(Some(Torque::new::<newton_meter>(torque_n_m)))
    }
}

/// Speeds, torques and powers of these candidates; nothing where neither speed nor load is given.
pub(super) fn parts(
    args: &Args,
    requirements: &Requirements,
    all: &[Numbered],
) -> Result<Vec<Part>, Failure> {
    let (speed, torque) = (args.duty.input.map(|speed| speed.0), args.duty.torque()?);
    if speed.is_none() && torque.is_none() {
        return Ok(vec![]);
    }
    let (mut gears, mut members) = (vec![], vec![]);
    for &(no, one) in all {
        let gearbox = one.gearbox(requirements).map_err(super::refuse)?;
        for line in one.engagement_table() {
            let analysis = gearbox.analyze(line.gear)?;
            // Torques alone do not hang on the speed; powers are shown only where it is known.
            let turning = speed.unwrap_or(AngularVelocity::new::<radian_per_second>(1.0));
            let operation = match torque.map(|torque| analysis.at(turning, InputLoad::Torque(torque))) {
                None | Some(Err(Error::NotDriven { .. })) => None,
                Some(operation) => Some(operation?),
            };
            let circulating = analysis.driving().map(|case| case.power.circulating);
            let powered = operation.as_ref().filter(|_| speed.is_some());
            let mut row = vec![
                Figure::Count(no),
                text(line.gear),
                column(speed.map(|speed| speed / line.ratio)),
                column(operation.as_ref().map(|at| at.input)),
                column(operation.as_ref().map(|at| at.output)),
            ];
            row.extend(["K1", "K2", "L"].map(|id| shift_element(&gearbox, operation.as_ref(), id)));
            row.extend([
                column(powered.map(|at| at.entering)),
                column(powered.map(|at| at.entering - at.loss)),
                // What rounding leaves of a balance is no loss.
                column(
                    powered.map(
                        |at| if at.loss.abs() < at.entering * 1e-12 { Power::default() } else { at.loss },
                    ),
                ),
                column(powered.zip(circulating).map(|(at, of)| at.entering * of)),
            ]);
            gears.push(row);
            if let Some(at) = &operation {
                members.extend(of_members(no, line.gear, &gearbox, at));
            }
        }
    }
    let mut parts = vec![Part::Records(of_gears(gears, all, speed.is_some(), torque.is_some()))];
    if !members.is_empty() {
        parts.push(Part::Records(shafts(members, all)));
    }
    Ok(parts)
}

/// Torque of a control; none of one that the mechanism lacks.
fn shift_element(gearbox: &Gearbox, operation: Option<&Operation>, id: &str) -> Figure {
    let place = gearbox.shift_elements().iter().position(|shift_element| shift_element.id() == id);
    column(operation.zip(place).and_then(|(at, place)| at.shift_elements[place]))
}

fn of_members(no: u32, gear: &str, gearbox: &Gearbox, at: &Operation) -> Vec<Vec<Figure>> {
    let of_row = |(place, row): (usize, &epicyclic_train::PlanetSet)| {
        let torques = at.members[place].as_ref();
        let mut cells = vec![Figure::Count(no), text(gear), text(row.id())];
        cells.extend((0..3).map(|member| column(torques.map(|torques| torques[member]))));
        cells
    };
    gearbox.sets().iter().enumerate().map(of_row).collect()
}

fn headed(name: &'static str, heading: &str, dimension: Dimension) -> Column {
    Column { heading: heading.to_owned(), ..Column::quantity(name, dimension) }
}

fn of_gears(rows: Vec<Vec<Figure>>, all: &[Numbered], turns: bool, loaded: bool) -> Records {
    let two = all.iter().any(|(_, one)| one.gears.len() > 1);
    let mut torques = vec!["gear", "input_torque", "output_torque", "k1_torque"];
    torques.extend(two.then_some("k2_torque"));
    torques.push("lock_torque");
    let mut views = vec![];
    if turns {
        let mut shown = vec!["gear", "output_speed"];
        if loaded {
            shown.extend(["entering", "leaving", "loss", "circulating"]);
        }
        let title = if loaded { "output, rpm, and powers with losses, kW" } else { "output, rpm" };
        views.push(View::new(heading(title, all), &shown));
    }
    if loaded {
        views.push(View {
            note:
                "With losses. On the gearbox at input and output; of each brake and of the lock on its first \
                   link."
                    .to_owned(),
            ..View::new(heading("torques of shafts, brakes and lock, N·m", all), &torques)
        });
    }
    Records {
        name: "operation",
        columns: vec![
            Column::number("candidate", "no"),
            Column::words("gear", "gear"),
            headed("output_speed", "output", Dimension::AngularSpeed),
            headed("input_torque", "input", Dimension::Torque),
            headed("output_torque", "output", Dimension::Torque),
            headed("k1_torque", "K1", Dimension::Torque),
            headed("k2_torque", "K2", Dimension::Torque),
            headed("lock_torque", "lock", Dimension::Torque),
            headed("entering", "enters", Dimension::Power),
            headed("leaving", "leaves", Dimension::Power),
            headed("loss", "lost", Dimension::Power),
            headed("circulating", "circulates", Dimension::Power),
        ],
        rows,
        views,
        is_answer: false,
    }
}

fn shafts(rows: Vec<Vec<Figure>>, all: &[Numbered]) -> Records {
    Records {
        name: "member_torques",
        columns: vec![
            Column::number("candidate", "no"),
            Column::words("gear", "gear"),
            Column::words("row", "row"),
            headed("sun_torque", "sun", Dimension::Torque),
            headed("ring_torque", "ring", Dimension::Torque),
            headed("carrier_torque", "carrier", Dimension::Torque),
        ],
        rows,
        views: vec![View::new(
            heading("torques on the members of the rows, N·m", all),
            &["gear", "row", "sun_torque", "ring_torque", "carrier_torque"],
        )],
        is_answer: false,
    }
}
