//! A circle with its axis, as SVG.

use epicyclic_drawing::{Point, Scene, Shape, Style, Text, svg};

fn main() -> Result<(), epicyclic_drawing::Error> {
    let mut scene = Scene::new("A circle and its axis");
    let outline = scene.layer("outline", Style::line(0.5))?;
    let axes = scene.layer("axes", Style::centre_line())?;
    scene.add(outline, Shape::Circle { centre: Point::new(0.0, 0.0), radius: 20.0 });
    scene.add(axes, Shape::line([-25.0, 0.0], [25.0, 0.0]));
    scene.add(outline, Text::new([0.0, 24.0], 3.5, "Ø 40"));
    println!("{}", svg::write(&scene)?);
    Ok(())
}
