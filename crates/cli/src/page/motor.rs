//! The page of a hydromotor.

use super::sheet::{Block, Section, Sheet};
use crate::failure::Failure;
use epicyclic_answers::motor::{Designed, answer, of_file};
use epicyclic_formats::Document;
use epicyclic_hydromotor::Motor;
use epicyclic_pictures::motor;
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_views::AsReport as _;
use uom::si::angle::degree;
use uom::si::area::square_millimeter;
use uom::si::f64::Angle;

/// Places of a plot over the angle.
const PLACES: u32 = 720;

pub(super) fn sheet(document: &Document, text: String) -> Result<Sheet, Failure> {
    let (title, designed) = of_file(document)?;
    let answer = answer(&designed)?;
    let Designed { motor, profile, angle, .. } = designed;
    let about = epicyclic_views::motor::title(&answer.numbers);
    let mut drawings = vec![
        Block::picture(
            motor::centrodes(&motor, angle)?,
            "Centrodes of stator, rotor and satellites, and how the stator's arcs are constructed.",
        ),
        Block::picture(
            motor::chambers(&motor, angle)?,
            "Chambers between neighbouring satellites, by their pressure.",
        ),
    ];
    if let Ok(profile) = &profile {
        drawings.insert(
            1,
            Block::picture(
                motor::teeth(profile, angle)?,
                "Teeth of all wheels, every satellite in mesh with both.",
            ),
        );
    }
    let plots = vec![
        Block::picture(
            flow(&motor)?.scene()?,
            "Flow of ideal ports over the angle of the rotor: a radian and a millimetre of width. The torque over width and pressure \
             is the same.",
        ),
        Block::picture(areas(&motor)?.scene()?, "Areas of the chambers over the angle of the rotor."),
    ];
    let sources = [
        "System (1), formulas (2) to (8) and the conditions on the numbers: the document rotary-hydromotor, with what it leaves out: \
         closure, the exact rotor, working data, teeth.",
    ];
    Ok(Sheet {
        title: title.unwrap_or_else(|| about.clone()),
        about,
        sections: vec![
            Section::new("Input", vec![Block::File(text)]),
            Section::new("Drawings", drawings),
            Section::new("Results and checks", vec![Block::Answer(answer.report())]),
            Section::new("Plots", plots),
            Section::new("Sources", vec![Block::List(sources.map(str::to_owned).to_vec())]),
        ],
    })
}

/// Angles through one turn of the rotor's lobe.
fn angles(motor: &Motor) -> impl Iterator<Item = f64> + use<> {
    let lobe = 360.0 / f64::from(motor.numbers().rotor_lobes());
    (0..=PLACES).map(move |i| lobe * f64::from(i) / f64::from(PLACES))
}

/// Flow over width a radian.
fn flow(motor: &Motor) -> Result<Plot, Failure> {
    let at = |angle: f64| {
        let flow = motor.flow_per_width(Angle::new::<degree>(angle))?;
        Ok([angle, flow.get::<square_millimeter>()])
    };
    let points = angles(motor).map(at).collect::<Result<_, epicyclic_hydromotor::Error>>()?;
    let mean = motor.ripple().mean.get::<square_millimeter>();
    let ends = angles(motor).map(|angle| [angle, mean]).collect();
    let ripple = 100.0 * motor.ripple().delta;
    Ok(Plot::new(format!("Flow, ripple {ripple:.2} %"), "angle of the rotor, deg", "flow, mm² a radian")
        .with(Curve::new("flow", points))
        .with(Curve::new("mean", ends)))
}

/// Area of each chamber.
fn areas(motor: &Motor) -> Result<Plot, Failure> {
    let samples = angles(motor).map(|angle| Ok((angle, motor.chambers(Angle::new::<degree>(angle))?)));
    let samples = samples.collect::<Result<Vec<_>, epicyclic_hydromotor::Error>>()?;
    let count = samples.first().map_or(0, |(_, chambers)| chambers.len());
    let curve = |index: usize| {
        let points = samples.iter().filter_map(|(angle, chambers)| {
            Some([*angle, chambers.get(index)?.area.get::<square_millimeter>()])
        });
        Curve::new(format!("chamber {index}"), points.collect())
    };
    let plot = Plot::new("Chambers", "angle of the rotor, deg", "area, mm²");
    Ok((0..count).map(curve).fold(plot, Plot::with))
}
