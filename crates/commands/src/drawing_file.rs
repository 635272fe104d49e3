//! A drawing as a file: its format by the end of its name, and its content.

use crate::draw::answer::FileFormat;
use crate::failure::Failure;
use epicyclic_drawing::{Scene, dxf, svg};
#[cfg(feature = "print")]
use epicyclic_drawing::{pdf, png};
use epicyclic_units::Number;
use std::path::Path;

/// Pixels to an inch of an image, where none are given.
#[cfg(feature = "print")]
const DPI: f64 = 300.0;

/// The end of a file's name, in small letters.
pub(crate) fn end_of(file: &Path) -> Option<String> {
    file.extension().map(|end| end.to_string_lossy().to_lowercase())
}

/// The format that the end of a name asks for; `None` where it is no drawing's.
pub(crate) fn format_of(end: &str) -> Option<FileFormat> {
    match end {
        "svg" => Some(FileFormat::Svg),
        "dxf" => Some(FileFormat::Dxf),
        "pdf" => Some(FileFormat::Pdf),
        "png" => Some(FileFormat::Png),
        _ => None,
    }
}

/// Returns the format of a file that an option names; SVG if the name has no extension.
pub(crate) fn format_by_name(file: &Path, option: &'static str) -> Result<FileFormat, Failure> {
    let Some(end) = end_of(file) else { return Ok(FileFormat::Svg) };
    format_of(&end).ok_or_else(|| {
        let message = format!("a drawing ends in .svg, .dxf, .pdf or .png, not .{end}");
        Failure::invalid(option, message)
    })
}

/// Refuses a resolution where no file has pixels.
pub(crate) fn check_dpi(
    dpi: Option<Number>,
    mut formats: impl Iterator<Item = FileFormat>,
) -> Result<(), Failure> {
    if dpi.is_some() && formats.all(|format| format != FileFormat::Png) {
        let message = "it is for images of pixels; let --output end in .png".to_owned();
        return Err(Failure::conflict("--dpi", message));
    }
    Ok(())
}

/// Writes a scene in the given format. `dpi` applies to PNG only.
pub(crate) fn content(scene: &Scene, format: FileFormat, dpi: Option<Number>) -> Result<Vec<u8>, Failure> {
    let content = match format {
        FileFormat::Svg => svg::write(scene).map(String::into_bytes),
        FileFormat::Dxf => dxf::write(scene).map(String::into_bytes),
        #[cfg(feature = "print")]
        FileFormat::Pdf => pdf::write(scene),
        #[cfg(feature = "print")]
        FileFormat::Png => png::write(scene, dpi.map_or_else(|| DPI.min(png::most_dpi(scene)), Number::get)),
        #[cfg(not(feature = "print"))]
        FileFormat::Pdf | FileFormat::Png => {
            let _ = dpi;
            let message = "this build of the program draws SVG and DXF alone".to_owned();
            return Err(Failure::named("not-in-this-build", "--output", message));
        }
    };
    content.map_err(|error| match error {
        epicyclic_drawing::Error::Pixels { .. } | epicyclic_drawing::Error::Resolution { .. } => {
            Failure::invalid("--dpi", error.to_string())
        }
        error => error.into(),
    })
}
