//! What goes into the files: drawings as SVG and DXF, centrodes as points.

use super::design::refuse;
use super::{Files, View};
use crate::failure::Failure;
use crate::writing::Content;
use epicyclic_answers::motor::{Designed, centrodes};
use epicyclic_drawing::{Scene, dxf, svg};
use epicyclic_views::motor;

/// Every file that is asked for, before any is written.
pub(super) fn content(files: &Files, designed: &Designed) -> Result<Vec<Content>, Failure> {
    let mut written = vec![];
    if files.svg.is_some() || files.dxf.is_some() {
        let scene = scene(files.view, designed).map_err(|failure| match failure {
            Failure::Picture(epicyclic_pictures::Error::Motor(error)) => refuse(error.into()),
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
        let points = centrodes(&designed.motor, files.points).map_err(refuse)?;
        written.push((file.clone(), motor::centrodes_csv(&points)?.into_bytes()));
    }
    Ok(written)
}

pub(super) fn scene(view: View, designed: &Designed) -> Result<Scene, Failure> {
    let view = match view {
        View::Centrodes => motor::View::Centrodes,
        View::Teeth => motor::View::Teeth,
        View::Motor => motor::View::Motor,
        View::Chambers => motor::View::Chambers,
        View::Dimensions => motor::View::Dimensions,
    };
    motor::scene(view, designed).map_err(|error| match error {
        epicyclic_views::Error::NoTeeth(_) => {
            Failure::Option { option: "--view teeth", message: error.to_string() }
        }
        error => error.into(),
    })
}
