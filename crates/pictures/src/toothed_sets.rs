//! Sets seen along their axis with every tooth in mesh: exact involutes and fillets.
//!
//! Gears that mesh with each other are drawn in one plane; the planes of a set, as those of stepped planets,
//! are side by side. Large gears lie behind small ones. Each gear has a layer of its own.

use crate::Error;
use epicyclic_drawing::{Align, Color, LayerId, Piece, Point, Scene, Shape, Style, Text};
use epicyclic_gears::involute::contour::Piece as OfGear;
use epicyclic_train::PlanetSet;
use epicyclic_train::in_mesh::{GearInMesh, InMesh, Mesh, Placed};
use epicyclic_train::planet_set::GearOf;
use epicyclic_units::Physical;
use uom::si::f64::Length;

/// A set to draw.
#[derive(Debug, Clone, PartialEq)]
pub struct ToothedSet<'s> {
    /// The set.
    pub set: &'s PlanetSet,
    /// Gears of the set in mesh.
    pub in_mesh: InMesh,
    /// Length of the unit of the gears in mesh; `None` where no module is stated: 1 mm is drawn for it.
    pub unit: Option<Length>,
}

impl ToothedSet<'_> {
    fn unit_mm(&self) -> f64 {
        self.unit.map_or(1.0, Length::mm)
    }
}

/// Largest distance of an outline from the exact curve, mm.
pub const DEVIATION_MM: f64 = 5e-4;

/// Largest distance of an outline from the exact curve in modules, for small gears.
const DEVIATION: f64 = 1e-3;

/// Parts of a degree, a shift, a module in millimetres and a millimetre to which figures are given.
const PART_OF_DEGREE: f64 = 1e4;
const PART_OF_SHIFT: f64 = 1e4;
const PART_OF_MODULE: f64 = 1e6;
const PART_OF_MM: f64 = 1e3;

/// Height of letters over half the width of the widest plane.
const LETTER: f64 = 0.06;

/// Widths of the lines of gears and circles, mm, of a plane up to half as wide as [`USUAL_MM`].
const LINES_MM: [f64; 2] = [0.13, 0.1];

/// Half the width of a plane whose lines have the usual width; those of larger planes are wider.
const USUAL_MM: f64 = 150.0;

/// Sets in rows, 1 mm of the drawing 1 mm of each; gears as their tools leave them, helical ones in their
/// transverse section.
///
/// # Errors
/// [`Error::Gear`] for outlines that cannot be followed, [`Error::Drawing`] for sets larger than a drawing.
pub fn scene(title: &str, sets: &[ToothedSet<'_>]) -> Result<Scene, Error> {
    let mut scene = Scene::new(title);
    let mut planes: Vec<Plane<'_>> = vec![];
    for toothed in sets {
        for (place, gears) in toothed.in_mesh.planes().into_iter().enumerate() {
            planes.push(Plane { toothed, place, gears });
        }
    }
    let widest = planes.iter().map(|plane| plane.size()[0]).fold(0.0, f64::max);
    let [line, thin] = LINES_MM.map(|width| width * (widest / USUAL_MM).max(1.0));
    let mut layers = vec![];
    for plane in &planes {
        layers.push(plane.layers(&mut scene, Style::line(line))?);
    }
    let circles = scene.layer(free_name(&scene, "working circles"), Style::centre_line().width(thin))?;
    let labels = scene.layer(free_name(&scene, "labels"), Style::line(thin))?;
    let letter = LETTER * widest;
    let columns = (planes.len() as f64).sqrt().ceil().max(1.0) as usize;
    let mut top = 0.0;
    for (row, layers) in planes.chunks(columns).zip(layers.chunks(columns)) {
        let tall = row.iter().map(|plane| plane.size()[1]).fold(0.0, f64::max);
        let (mut left, mut below) = (0.0, top);
        for (plane, layers) in row.iter().zip(layers) {
            let lines = plane.lines().into_iter().map(|line| Text::new(Point::default(), letter, line));
            let lines: Vec<Text> = lines.map(|line| line.align(Align::Middle)).collect();
            let wide = lines.iter().map(|line| 0.5 * line.width_mm()).fold(plane.size()[0], f64::max);
            let centre = Point::new(left + wide, top - tall);
            plane.draw(&mut scene, centre, layers, circles)?;
            let mut base = top - 2.0 * tall - letter;
            for line in lines {
                base -= 1.6 * letter;
                scene.add(labels, Text { at: Point::new(centre.x, base), ..line });
            }
            below = f64::min(below, base - 3.0 * letter);
            left += 2.0 * wide + 2.0 * letter;
        }
        top = below;
    }
    scene.check()?;
    Ok(scene)
}

/// A name that CAD programs take and no other layer has.
fn free_name(scene: &Scene, name: &str) -> String {
    let fit = |c: char| if c.is_alphanumeric() || " -+._".contains(c) { c } else { '_' };
    let name: String = name.chars().take(200).map(fit).collect();
    let name = name.trim();
    let is_free =
        |name: &String| scene.layers().iter().all(|layer| layer.name.to_lowercase() != name.to_lowercase());
    let numbered = (2..).map(|number: u32| format!("{name} {number}"));
    std::iter::once(name.to_owned()).chain(numbered).find(is_free).unwrap_or_default()
}

/// Gears of a set in one plane.
struct Plane<'p> {
    toothed: &'p ToothedSet<'p>,
    place: usize,
    gears: Vec<usize>,
}

impl Plane<'_> {
    fn gear(&self, gear: usize) -> &GearInMesh {
        &self.toothed.in_mesh.gears[gear]
    }

    fn placed(&self) -> impl Iterator<Item = &Placed> {
        self.toothed.in_mesh.placed().filter(|placed| self.gears.contains(&placed.gear))
    }

    /// Outer radius of a gear, mm.
    fn outside(&self, gear: usize) -> f64 {
        self.toothed.unit_mm() * self.gear(gear).outer_radius()
    }

    /// Half the width and half the height of the plane, mm.
    fn size(&self) -> [f64; 2] {
        let reach = |placed: &Placed, axis: usize| {
            self.toothed.unit_mm() * placed.centre[axis].abs() + self.outside(placed.gear)
        };
        [0, 1].map(|axis| self.placed().map(|placed| reach(placed, axis)).fold(0.0, f64::max))
    }

    /// A layer for each of the gears, with this line.
    fn layers(&self, scene: &mut Scene, line: Style) -> Result<Vec<LayerId>, Error> {
        let mut layers = vec![];
        for gear in &self.gears {
            let gear = self.gear(*gear);
            let fill = match gear.of {
                _ if gear.is_ring() => Color::new(226, 226, 230),
                GearOf::Planet(..) => Color::new(214, 228, 242),
                GearOf::Central(_) => Color::new(246, 226, 206),
            };
            let set = self.toothed.set;
            let name = free_name(scene, &format!("{} {}", set.id(), set.gear_name(gear.of)));
            layers.push(scene.layer(name, line.fill(fill))?);
        }
        Ok(layers)
    }

    /// Draws the gears about a centre, each on its layer.
    fn draw(
        &self,
        scene: &mut Scene,
        centre: Point,
        layers: &[LayerId],
        circles: LayerId,
    ) -> Result<(), Error> {
        let unit = self.toothed.unit_mm();
        let mut gears: Vec<(usize, LayerId)> =
            self.gears.iter().copied().zip(layers.iter().copied()).collect();
        let order = |(gear, _): (usize, LayerId)| (!self.gear(gear).is_ring(), -self.outside(gear));
        gears.sort_by(|one, other| {
            order(*one).partial_cmp(&order(*other)).unwrap_or(std::cmp::Ordering::Equal)
        });
        let mut has_ring = false;
        for (gear, layer) in gears {
            let own = self.gear(gear);
            let module = unit * own.module;
            let style = scene.layer_style(layer);
            let pieces = own.curve.contour(DEVIATION.min(DEVIATION_MM / module))?;
            for placed in self.placed().filter(|placed| placed.gear == gear) {
                let at = Point::new(centre.x + unit * placed.centre[0], centre.y + unit * placed.centre[1]);
                let place = |[x, y]: [f64; 2]| Point::new(at.x + module * x, at.y + module * y);
                let piece = |piece: &OfGear| match piece.turned(placed.turn_rad) {
                    OfGear::Arc { radius, angles: [from, to] } => Piece::Arc {
                        centre: at,
                        radius: module * radius,
                        start_rad: from,
                        sweep_rad: to - from,
                    },
                    OfGear::Cubic(points) => Piece::Cubic(points.map(place)),
                };
                let outline = Shape::Contour(pieces.iter().map(piece).collect());
                if !own.is_ring() {
                    scene.add(layer, outline);
                } else if has_ring {
                    // Another ring in the plane must not hide the first.
                    scene.add_styled(layer, Style { fill: None, ..style }, outline);
                } else {
                    scene.add(layer, Shape::Circle { centre: at, radius: self.outside(gear) });
                    scene.add_styled(layer, style.fill(Color::WHITE), outline);
                    has_ring = true;
                }
                scene.add(circles, Shape::Circle { centre: at, radius: unit * own.working_radius });
            }
        }
        Ok(())
    }

    /// The set, its gears, and modules and centre distances of its meshes.
    fn lines(&self) -> Vec<String> {
        let ToothedSet { set, in_mesh, unit: stated } = self.toothed;
        let unit = self.toothed.unit_mm();
        let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
        let number = |value: f64, digits: f64| rounded(value, digits).to_string().replace('-', "−");
        let planes = in_mesh.planes().len();
        let of = if planes > 1 { format!(", plane {} of {planes}", self.place + 1) } else { String::new() };
        let mut lines = vec![format!("set {}{of}", set.id())];
        for gear in &self.gears {
            let own = self.gear(*gear).curve.gear();
            let count = self.placed().filter(|placed| placed.gear == *gear).count();
            let times = if count > 1 { format!("{count} × ") } else { String::new() };
            let name = set.gear_name(self.gear(*gear).of);
            let shift = match own.shift() {
                0.0 => String::new(),
                shift => format!(", x = {}", number(shift, PART_OF_SHIFT)),
            };
            lines.push(format!("{times}{name}: z = {}{shift}", own.teeth()));
        }
        // Gears of one plane have one module and one helix angle.
        let meshes: Vec<&Mesh> =
            in_mesh.meshes.iter().filter(|mesh| self.gears.contains(&mesh.gears[0])).collect();
        if let Some(mesh) = meshes.first() {
            let module = number(unit * mesh.module, PART_OF_MODULE);
            let helix = rounded(mesh.pair.gears()[0].profile().helix_angle.degrees(), PART_OF_DEGREE);
            let unstated = if stated.is_none() { ", no module is stated" } else { "" };
            lines.push(if helix == 0.0 {
                format!("m = {module} mm{unstated}")
            } else {
                format!("m_n = {module} mm, β = {helix}°{unstated}")
            });
        }
        let distance = |mesh: &&Mesh| unit * mesh.module * mesh.pair.centre_distance();
        let mut distances: Vec<String> =
            meshes.iter().map(|mesh| number(distance(mesh), PART_OF_MM)).collect();
        distances.dedup();
        lines.push(format!("a = {} mm", distances.join(", ")));
        lines
    }
}
