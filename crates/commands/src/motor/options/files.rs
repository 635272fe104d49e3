//! Contents of the files: drawings as SVG, DXF, PDF and PNG, centrodes as points.

use super::Files;
use crate::desk::Content;
use crate::draw::answer::FileFormat;
use crate::drawing_file;
use crate::error::Error;
use crate::failure::Failure;
use crate::motor::answer::{Designed, centrodes};
use crate::motor::table as motor;
use crate::motor::table::View;
use crate::output::OutputArgs;
use epicyclic_drawing::Scene;
use std::path::PathBuf;

/// The drawings that are asked for.
pub(crate) struct Wanted(Vec<(PathBuf, FileFormat)>);

/// A drawing in --output goes before those that have options of their own.
pub(crate) fn wanted(files: &Files, output: &OutputArgs) -> Wanted {
    let own = output.drawing().map(|(file, format)| (file.to_owned(), format));
    let svg = files.svg.clone().map(|file| (file, FileFormat::Svg));
    let dxf = files.dxf.clone().map(|file| (file, FileFormat::Dxf));
    Wanted(own.into_iter().chain(svg).chain(dxf).collect())
}

impl Wanted {
    /// Whether there is no drawing.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// A drawing in each of the files.
    pub(crate) fn drawn(&self, scene: &Scene, files: &Files) -> Result<Vec<Content>, Failure> {
        let content = |(file, format): &(PathBuf, FileFormat)| {
            Ok((file.clone(), drawing_file::content(scene, *format, files.dpi)?))
        };
        self.0.iter().map(content).collect()
    }

    /// Refuses options for drawings if no drawing is requested.
    pub(crate) fn check(&self, files: &Files) -> Result<(), Failure> {
        if files.view.is_some() {
            self.needed_by("--view")?;
        }
        drawing_file::check_dpi(files.dpi, self.0.iter().map(|(_, format)| *format))
    }

    /// Refuses an option where nothing is drawn.
    pub(crate) fn needed_by(&self, option: &'static str) -> Result<(), Failure> {
        if self.is_empty() {
            let message = "it is for drawings; give --svg or --dxf, or an --output that ends in .svg, .dxf, .pdf or .png";
            return Err(Failure::conflict(option, message));
        }
        Ok(())
    }
}

/// Every file that is asked for, before any is written.
pub(crate) fn content(
    files: &Files,
    wanted: &Wanted,
    designed: &Designed,
    refuse: &dyn Fn(Error) -> Failure,
) -> Result<Vec<Content>, Failure> {
    let mut written = vec![];
    if !wanted.is_empty() {
        let view = files.view.unwrap_or(View::Motor);
        let scene = scene(view, designed).map_err(|failure| match failure {
            Failure::Picture(epicyclic_pictures::Error::Motor(error)) => refuse(error.into()),
            failure => failure,
        })?;
        written = wanted.drawn(&scene, files)?;
    }
    if let Some(file) = &files.csv {
        let points = centrodes(&designed.motor, files.points).map_err(refuse)?;
        written.push((file.clone(), motor::centrodes_csv(&points)?.into_bytes()));
    }
    Ok(written)
}

pub(crate) fn scene(view: View, designed: &Designed) -> Result<Scene, Failure> {
    motor::scene(view, designed).map_err(|error| match error {
        crate::table::text::Error::NoTeeth(_) => {
            Failure::named("no-teeth", "--view teeth", error.to_string())
        }
        crate::table::text::Error::Answer(error) if matches!(*error, Error::NoArcs) => {
            Failure::of_option("--view construction", &*error)
        }
        crate::table::text::Error::Lacking(_) => {
            Failure::named("nothing-to-draw", "--view", error.to_string())
        }
        error => error.into(),
    })
}
