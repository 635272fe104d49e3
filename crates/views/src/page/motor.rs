//! The page of a hydromotor.

use super::sheet::{Block, Section, Sheet};
use crate::{AsReport as _, Error};
use epicyclic_answers::motor::{Designed, Motor, OverAngle};
use epicyclic_answers::report::motor::MotorReport;
use epicyclic_drawing::Scene;
use epicyclic_formats::Dimension;
use epicyclic_pictures::motor;
use epicyclic_pictures::plot::{Curve, Plot};

/// Input, drawings, results, plots of a hydromotor; `file` is its file as it was written.
///
/// # Errors
/// [`Error::Picture`] for a motor too large for a drawing.
pub fn sheet(report: &MotorReport, designed: &Designed, file: String) -> Result<Sheet, Error> {
    let MotorReport { title, motor: answer, over_angle } = report;
    let Designed { motor, profile, angle, .. } = designed;
    let angle = *angle;
    let about = crate::motor::title(&answer.numbers);
    let mut drawings = vec![
        Block::picture(
            motor::centrodes(motor, angle)?,
            "Centrodes of stator, rotor and satellites, and how the stator's arcs are constructed.",
        ),
        Block::picture(
            motor::chambers(motor, angle)?,
            "Chambers between neighbouring satellites, by their pressure.",
        ),
    ];
    if let Ok(profile) = profile {
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
            picture(&flow(answer, over_angle))?,
            "Flow of ideal ports over the angle of the rotor: a radian and a millimetre of width. The torque over width and pressure \
             is the same.",
        ),
        Block::picture(picture(&areas(over_angle))?, "Areas of the chambers over the angle of the rotor."),
    ];
    let sources = [
        "System (1), formulas (2) to (8) and the conditions on the numbers: the document rotary-hydromotor, with what it leaves out: \
         closure, the exact rotor, working data, teeth.",
    ];
    Ok(Sheet {
        title: title.clone().unwrap_or_else(|| about.clone()),
        about,
        sections: vec![
            Section::new("Input", vec![Block::File(file)]),
            Section::new("Drawings", drawings),
            Section::new("Results and checks", vec![Block::Answer(answer.report())]),
            Section::new("Plots", plots),
            Section::new("Sources", vec![Block::List(sources.map(str::to_owned).to_vec())]),
        ],
    })
}

fn picture(plot: &Plot) -> Result<Scene, Error> {
    Ok(plot.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// Quantities in the units of drawings, one above each angle.
fn points(over_angle: &OverAngle, values: &[f64]) -> Vec<[f64; 2]> {
    let (degree, square_millimetre) =
        (Dimension::Angle.usual_unit().factor, Dimension::Area.usual_unit().factor);
    let angles = over_angle.angles_rad.iter().map(|angle| angle / degree);
    angles.zip(values).map(|(angle, value)| [angle, value / square_millimetre]).collect()
}

/// Flow over width a radian.
fn flow(answer: &Motor, over_angle: &OverAngle) -> Plot {
    let mean = vec![over_angle.mean_flow_per_width_m2; over_angle.angles_rad.len()];
    let ripple = 100.0 * answer.work.ripple;
    Plot::new(format!("Flow, ripple {ripple:.2} %"), "angle of the rotor, deg", "flow, mm² a radian")
        .with(Curve::new("flow", points(over_angle, &over_angle.flow_per_width_m2)))
        .with(Curve::new("mean", points(over_angle, &mean)))
}

/// Area of each chamber.
fn areas(over_angle: &OverAngle) -> Plot {
    let curve = |(index, areas): (usize, &Vec<f64>)| {
        Curve::new(format!("chamber {index}"), points(over_angle, areas))
    };
    let plot = Plot::new("Chambers", "angle of the rotor, deg", "area, mm²");
    over_angle.chamber_areas_m2.iter().enumerate().map(curve).fold(plot, Plot::with)
}
