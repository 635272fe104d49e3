//! What goes into the files: drawings as SVG and DXF, centrodes as points.

use super::design::{Drawn, refuse};
use super::{Files, View};
use crate::failure::Failure;
use crate::writing::Content;
use epicyclic_drawing::{Scene, dxf, svg};
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_pictures::motor;
use uom::si::angle::degree;
use uom::si::curvature::radian_per_millimeter;
use uom::si::length::millimeter;

/// The most points of a half-lobe.
const MOST_POINTS: u32 = 100_000;

/// Every file that is asked for, before any is written.
pub(super) fn content(files: &Files, drawn: &Drawn) -> Result<Vec<Content>, Failure> {
    let mut written = vec![];
    if files.svg.is_some() || files.dxf.is_some() {
        let scene = scene(files.view, drawn).map_err(|failure| match failure {
            Failure::Picture(epicyclic_pictures::Error::Motor(error)) => refuse(error),
            failure => failure,
        })?;
        if let Some(file) = &files.svg {
            written.push((file.clone(), svg::write(&scene)?.into_bytes()));
        }
        if let Some(file) = &files.dxf {
            written.push((file.clone(), dxf::write(&scene)?.into_bytes()));
        }
    }
    if let Some(file) = &files.csv {
        if !(1..=MOST_POINTS).contains(&files.points) {
            let message = format!("{} points of a half-lobe: from 1 to {MOST_POINTS}", files.points);
            return Err(Failure::Option { option: "--points", message });
        }
        written.push((file.clone(), centrodes(&drawn.motor, files.points)?.into_bytes()));
    }
    Ok(written)
}

pub(super) fn scene(view: View, drawn: &Drawn) -> Result<Scene, Failure> {
    Ok(match view {
        View::Centrodes => motor::centrodes(&drawn.motor, drawn.angle),
        View::Motor => motor::whole(&drawn.motor, drawn.angle),
        View::Chambers => motor::chambers(&drawn.motor, drawn.angle),
        View::Teeth => match &drawn.profile {
            Ok(profile) => motor::teeth(profile, drawn.angle),
            Err(error) => {
                let message = format!("the motor has no teeth of this form: {error}");
                return Err(Failure::Option { option: "--view teeth", message });
            }
        },
    }?)
}

/// Points of both centrodes, evenly spaced along each half-lobe, counter-clockwise from a crest on the x axis.
fn centrodes(motor: &Motor, points: u32) -> Result<String, Failure> {
    let numbers = motor.numbers();
    let wheels =
        [("stator", Wheel::Stator, numbers.stator_lobes()), ("rotor", Wheel::Rotor, numbers.rotor_lobes())];
    let mut rows = vec![];
    for (name, wheel, lobes) in wheels {
        let curve = motor.centrode(wheel);
        let count = 2 * u64::from(lobes) * u64::from(points);
        for i in 0..count {
            #[allow(clippy::cast_precision_loss)] // far below 2⁵³
            let point = curve.at(curve.length() * (i as f64 / count as f64)).map_err(refuse)?;
            let values = [
                point.arc_length.get::<millimeter>(),
                point.x.get::<millimeter>(),
                point.y.get::<millimeter>(),
                point.polar_radius.get::<millimeter>(),
                point.polar_angle.get::<degree>(),
                point.tangent.get::<degree>(),
                point.curvature.get::<radian_per_millimeter>(),
            ];
            let mut row = vec![name.to_owned()];
            row.extend(values.map(|value| trimmed(value, 12)));
            rows.push(row);
        }
    }
    let header = [
        "wheel",
        "arc_length_mm",
        "x_mm",
        "y_mm",
        "polar_radius_mm",
        "polar_angle_deg",
        "tangent_deg",
        "curvature_per_mm",
    ];
    Ok(epicyclic_views::text::csv(&header, rows)?)
}
