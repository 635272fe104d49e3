//! A scene of lines, arcs, polylines and text on layers, written as SVG, DXF, PDF and PNG.
//!
//! | module | is |
//! |---|---|
//! | [`scene`] | the scene: layers, shapes, size |
//! | [`style`] | colours, line widths and dashes |
//! | [`text`] | text, the room that it takes, labels that overlap |
//! | [`svg`] | the scene as an SVG image, one unit a millimetre |
//! | [`dxf`] | the scene as a DXF drawing in millimetres, for CAD |
//! | `pdf` | with the feature `print`: the scene as a PDF page of its size |
//! | `png` | with the feature `print`: the scene as pixels |
//!
//! Coordinates are millimetres, `x` to the right and `y` **up**; angles are radians, counter-clockwise.
//! Nothing here knows a gear or opens a file.
//!
//! # Example
//!
//! ```
//! use epicyclic_drawing::{Point, Scene, Shape, Style, Text, dxf, svg};
//!
//! let mut scene = Scene::new("A circle and its axis");
//! let outline = scene.layer("outline", Style::line(0.5))?;
//! let axes = scene.layer("axes", Style::centre_line())?;
//! scene.add(outline, Shape::Circle { centre: Point::new(0.0, 0.0), radius: 20.0 });
//! scene.add(axes, Shape::line([-25.0, 0.0], [25.0, 0.0]));
//! scene.add(outline, Text::new([0.0, 24.0], 3.5, "Ø 40"));
//! assert!(svg::write(&scene)?.contains("<circle"));
//! assert!(dxf::write(&scene)?.contains("CIRCLE"));
//! # Ok::<(), epicyclic_drawing::Error>(())
//! ```

mod bounds;
pub mod dxf;
mod error;
#[cfg(feature = "print")]
mod glyphs;
mod label;
#[cfg(feature = "print")]
pub mod pdf;
#[cfg(feature = "print")]
pub mod png;
pub mod scene;
pub mod style;
pub mod svg;
pub mod text;
mod tolerance;

pub use bounds::{Bounds, Point};
pub use error::Error;
pub use label::{Align, Text};
pub use scene::{LayerId, Piece, Scene, Shape, Vertex};
pub use style::{Color, Dash, Style};
