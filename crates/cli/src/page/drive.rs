//! The page of a planetary drive.

use super::sheet::{Block, Section, Sheet};
use crate::drive;
use crate::failure::Failure;
use epicyclic_dynamics::drive::{DriveDesign, Start};
use epicyclic_formats::Document;
use epicyclic_pictures::gear_set::GearSet;
use epicyclic_pictures::plot::{Curve, Plot};
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::time::second;

pub(super) fn sheet(document: &Document, text: String) -> Result<Sheet, Failure> {
    let (title, design) = drive::calculate(document)?;
    let picture = |scene: Result<_, epicyclic_drawing::Error>| scene.map_err(Failure::from);
    let gear_set = &design.gear_set;
    let angles = design.teeth.spacing.angles();
    let set = GearSet {
        sun: &gear_set.sun,
        planet: &gear_set.planet,
        ring: &gear_set.ring,
        centre_distance: gear_set.centre_distance,
        angles: &angles,
    };
    let mut plots = vec![Block::picture(
        picture(efficiency_over_ratio(&design).scene())?,
        "Efficiency of such a drive over its ratio, the meshes' efficiencies as given; the mark is this drive.",
    )];
    if let Some(start) = start(&design) {
        plots.push(Block::picture(
            picture(start.scene())?,
            "Start from rest under constant torques: the sun's speed until it reaches the nominal one.",
        ));
    }
    let teeth = design.teeth.numbers;
    let about = format!(
        "Planetary drive {}-{}-{} with {} planets, ratio {:.4}, efficiency {:.4}",
        teeth.sun, teeth.planet, teeth.ring, teeth.planets, design.teeth.ratio, design.efficiency.overall
    );
    Ok(Sheet {
        title: title.clone().unwrap_or_else(|| "Planetary drive".to_owned()),
        about,
        sections: vec![
            Section::new("Input", vec![Block::File(text)]),
            Section::new(
                "Drawing",
                vec![Block::picture(
                    picture(set.scene())?,
                    "The gear set along its axis, to scale: tip, pitch and root circles, planets at their assembly angles.",
                )],
            ),
            Section::new("Results and checks", vec![Block::Answer(drive::answer(title, &design))]),
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

/// `η = (1 + k·η₀)/(1 + k)` over `U = 1 + k`.
fn efficiency_over_ratio(design: &DriveDesign) -> Plot {
    let basic = design.efficiency.basic;
    let most = (1.5 * design.teeth.ratio).max(10.0);
    let points = (0..=100).map(|i| 2.2 + (most - 2.2) * f64::from(i) / 100.0);
    let points = points.map(|ratio| [ratio, (1.0 + (ratio - 1.0) * basic) / ratio]).collect();
    Plot::new("Efficiency over ratio", "ratio U", "efficiency η")
        .with(Curve::new(format!("η₀ = {basic:.4}"), points))
        .mark("this drive", design.teeth.ratio)
}

/// Speed of the sun from rest, without and with losses; `None` where it never starts.
fn start(design: &DriveDesign) -> Option<Plot> {
    let speed = design.speeds.sun.get::<revolution_per_minute>();
    let time = |start: Start| match start {
        Start::After(time) => Some(time.get::<second>()),
        Start::InBalance | Start::Held | Start::Backward(_) => None,
    };
    let starts = [
        ("without losses", time(design.without_losses.start)),
        ("with mesh losses", time(design.with_losses.start)),
    ];
    let longest = starts.iter().filter_map(|(_, time)| *time).reduce(f64::max)?;
    let curve = |(name, time): (&str, Option<f64>)| match time {
        Some(time) => Curve::new(name, vec![[0.0, 0.0], [time, speed], [longest, speed]]),
        None => Curve::new(format!("{name}: does not start"), vec![[0.0, 0.0], [longest, 0.0]]),
    };
    let plot = Plot::new("Start", "time, s", "speed of the sun, rpm");
    Some(starts.into_iter().map(curve).fold(plot, Plot::with))
}
