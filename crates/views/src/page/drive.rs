//! The page of a planetary drive.

use super::sheet::{Block, Section, Sheet};
use crate::units::rpm;
use crate::{AsReport as _, Error};
use epicyclic_answers::drive::{Drive, Gear};
use epicyclic_answers::report::drive::DriveReport;
use epicyclic_formats::Physical as _;
use epicyclic_pictures::gear_set::{Circles, GearSet};
use epicyclic_pictures::plot::{Curve, Plot};
use uom::si::f64::{Angle, Length};

/// Input, drawing, results, plots of a drive; `file` is its file as it was written.
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
    Ok(Sheet {
        title: drive.title.clone().unwrap_or_else(|| "Planetary drive".to_owned()),
        about,
        sections: vec![
            Section::new("Input", vec![Block::File(file)]),
            Section::new(
                "Drawing",
                vec![Block::picture(
                    picture(set.scene())?,
                    "The gear set along its axis, to scale: tip, pitch and root circles, planets at their assembly angles.",
                )],
            ),
            Section::new("Results and checks", vec![Block::Answer(drive.report())]),
            Section::new("Plots", plots),
            Section::new(
                "What is left out",
                vec![Block::List(
                    [
                        "Losses outside the meshes: bearings, seals, churning oil.",
                        "Uneven load of the planets; profile shift; strength of teeth; life of bearings.",
                        "Torques that change while the drive starts.",
                    ]
                    .map(str::to_owned)
                    .to_vec(),
                )],
            ),
            Section::new(
                "Sources",
                vec![Block::List(
                    [
                        "Method of the travel drive: the document excavator-dynamics, formulas (1) to (12), with the corrections listed in the project's book.",
                        "Efficiency: M. A. Kreines' rule, equal to the balance of torques.",
                    ]
                    .map(str::to_owned)
                    .to_vec(),
                )],
            ),
        ],
    })
}

fn efficiency_over_ratio(report: &DriveReport) -> Plot {
    let (drive, over) = (&report.drive, &report.efficiency_over_ratio);
    let points = over.ratios.iter().zip(&over.efficiencies).map(|(ratio, efficiency)| [*ratio, *efficiency]);
    Plot::new("Efficiency over ratio", "ratio U", "efficiency η")
        .with(Curve::new(format!("η₀ = {:.4}", drive.efficiencies.basic), points.collect()))
        .mark("this drive", drive.tooth_numbers.ratio)
}

/// Speed of the sun from rest, without and with losses; `None` where it never starts.
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
    let plot = Plot::new("Start", "time, s", "speed of the sun, rpm");
    Some(starts.into_iter().map(curve).fold(plot, Plot::with))
}
