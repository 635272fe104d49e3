//! The page of a planetary drive.

use crate::drive::answer::{Drive, Gear};
use crate::page::paper::PLOT_MM;
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::report::answer::drive::DriveReport;
use crate::table::figure::{Figure, rpm};
use crate::table::quantities::{optional, quantity};
use crate::table::report::{AsReport as _, Report};
use crate::table::report::{Part, Row, Section as Facts};
use crate::table::text::Error;
use epicyclic_pictures::gear_set::{Circles, GearSet};
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_units::Dimension::{self, AngularSpeed, Inertia, Power, Time, Torque};
use epicyclic_units::Physical as _;
use uom::si::f64::{Angle, Length};

/// Builds the page of a drive: key figures, drawing, results and plots; `file` is the text of its file.
///
/// # Errors
/// [`Error::Picture`] for a drive too large for a drawing.
pub fn sheet(report: &DriveReport, file: String) -> Result<Sheet, Error> {
    let drive = &report.drive;
    let picture =
        |scene: Result<_, epicyclic_drawing::Error>| scene.map_err(|error| Error::Picture(error.into()));
    let angles: Vec<Angle> =
        drive.tooth_numbers.planet_angles_rad.iter().map(|angle| Angle::from_si(*angle)).collect();
    let (set, numbers) = (&drive.gear_set, &drive.tooth_numbers);
    let circles = |teeth, gear: &Gear| Circles {
        teeth,
        pitch_diameter: Length::from_si(gear.pitch_diameter_m),
        tip_diameter: Length::from_si(gear.tip_diameter_m),
        root_diameter: Length::from_si(gear.root_diameter_m),
    };
    let set = GearSet {
        sun: circles(numbers.sun, &set.sun),
        planet: circles(numbers.planet, &set.planet),
        ring: circles(numbers.ring, &set.ring),
        centre_distance: Length::from_si(set.centre_distance_m),
        angles: &angles,
    };
    let mut plots = vec![Block::picture(
        picture(efficiency_over_ratio(report).scene())?,
        "Efficiency of such a drive over its ratio, the meshes' efficiencies as given; the mark is this drive.",
    )];
    if let Some(start) = start(drive) {
        plots.push(Block::picture(
            picture(start.scene())?,
            "Start from rest under constant torques: the sun's speed until it reaches the nominal one.",
        ));
    }
    let about = format!(
        "Planetary drive {}-{}-{} with {} planets, ratio {:.4}, efficiency {:.4}",
        numbers.sun, numbers.planet, numbers.ring, numbers.planets, numbers.ratio, drive.efficiencies.overall
    );
    let drawing = Block::picture(
        picture(set.scene())?,
        "The gear set along its axis, to scale: tip, pitch and root circles, planets at their assembly angles.",
    );
    let list = |points: &[&str]| vec![Block::List(points.iter().map(|point| (*point).to_owned()).collect())];
    Ok(Sheet {
        title: drive.title.clone().unwrap_or_else(|| "Planetary drive".to_owned()),
        about,
        answer: vec![in_short(drive), drawing],
        arrangement: Arrangement::Columns,
        objections: drive.warnings.iter().map(|warning| warning.message.clone()).collect(),
        sections: vec![
            Section::new(
                "Results and checks",
                vec![Block::Answer(Report { warnings: None, ..drive.report() })],
            ),
            Section::new("Plots", plots),
            Section::new(
                "What is left out",
                list(&[
                    "Losses outside the meshes: bearings, seals, churning oil.",
                    "Uneven load of the planets; profile shift; strength of teeth; life of bearings.",
                    "Torques that change while the drive starts.",
                ]),
            ),
            Section::new(
                "Sources",
                list(&[
                    "Method of the travel drive: the document excavator-dynamics, formulas (1) to (12), with the corrections listed in the project's book.",
                    "Efficiency: M. A. Kreines' rule, equal to the balance of torques.",
                ]),
            ),
        ],
        input: file,
    })
}

/// Key figures of the drive.
fn in_short(drive: &Drive) -> Block {
    let (numbers, start) = (&drive.tooth_numbers, &drive.start.with_losses);
    let teeth = [numbers.sun, numbers.planet, numbers.ring].map(|teeth| teeth.to_string()).join(" / ");
    let one = |label, symbol, figure| Row::new("", label, symbol, [figure]);
    let rows = vec![
        one("power in", "N₁", quantity(Power, drive.powers.input_w)),
        one("power out", "N_H", quantity(Power, drive.powers.output_w)),
        one("speed of the sun", "ω₁", quantity(AngularSpeed, drive.speeds.sun_rad_s)),
        one("speed of the carrier", "ω_H", quantity(AngularSpeed, drive.speeds.carrier_rad_s)),
        one("torque on the sun", "T₁", quantity(Torque, drive.torques.sun_n_m)),
        one("torque of the carrier", "T_H", quantity(Torque, drive.torques.carrier_n_m)),
        one("ratio", "U", Figure::Number(numbers.ratio)),
        one("teeth of sun, planet, ring", "z", Figure::Text(teeth)),
        one("planets", "N", Figure::Count(numbers.planets)),
        one("module", "m", quantity(Dimension::Length, drive.gear_set.module_m)),
        one("face width", "b", quantity(Dimension::Length, drive.gear_set.face_width_m)),
        one("efficiency", "η", Figure::Number(drive.efficiencies.overall)),
        one("equivalent inertia at the sun", "J", quantity(Inertia, drive.equivalent_inertia.total_kg_m2)),
        one("time to full speed", "t", optional(Time, start.starting_time_s)),
    ];
    let section = Facts { name: "", title: "The drive", columns: &[], rows, note: "" };
    Block::Answer(Report { parts: vec![Part::Facts(section)], ..Report::default() })
}

fn efficiency_over_ratio(report: &DriveReport) -> Plot {
    let (drive, over) = (&report.drive, &report.efficiency_over_ratio);
    let points = over.ratios.iter().zip(&over.efficiencies).map(|(ratio, efficiency)| [*ratio, *efficiency]);
    Plot::new("Efficiency over ratio", "ratio U", "efficiency η")
        .with(Curve::new(format!("η₀ = {:.4}", drive.efficiencies.basic), points.collect()))
        .mark("this drive", drive.tooth_numbers.ratio)
        .sized(PLOT_MM)
}

/// Plot of the sun's speed from rest, without and with losses; `None` if the drive never starts.
fn start(drive: &Drive) -> Option<Plot> {
    let speed = rpm(drive.speeds.sun_rad_s);
    let starts = [
        ("without losses", drive.start.without_losses.starting_time_s),
        ("with mesh losses", drive.start.with_losses.starting_time_s),
    ];
    let longest = starts.iter().filter_map(|(_, time)| *time).reduce(f64::max)?;
    let curve = |(name, time): (&str, Option<f64>)| match time {
        Some(time) => Curve::new(name, vec![[0.0, 0.0], [time, speed], [longest, speed]]),
        None => Curve::new(format!("{name}: does not start"), vec![[0.0, 0.0], [longest, 0.0]]),
    };
    let plot = Plot::new("Start", "time, s", "speed of the sun, rpm").sized(PLOT_MM);
    Some(starts.into_iter().map(curve).fold(plot, Plot::with))
}
