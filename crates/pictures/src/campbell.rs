//! A Campbell diagram: natural frequencies over the speed, orders of excitation as rays, and where they meet.

use crate::plot::{Axis, LETTERS_MM};
use epicyclic_drawing::{Align, Bounds, Color, Dash, Error, Scene, Shape, Style, Text};
pub use epicyclic_vibration::Kind;

/// Width and height of the field where no other is given.
pub const SIZE_MM: [f64; 2] = [150.0, 110.0];
/// Room between labels.
const ROOM_MM: f64 = 0.5;
/// Radius of the dot of a resonance.
const DOT_MM: f64 = 0.9;

/// Kinds of branches with their colours and dashes, in the order of the legend.
const KINDS: [(&str, Color, Dash); 4] = [
    ("rotational", Color::new(0, 90, 160), Dash::Solid),
    ("translational", Color::new(200, 80, 0), Dash::Dashed),
    ("planet", Color::new(20, 120, 50), Dash::DashDot),
    ("mixed", Color::new(120, 60, 140), Dash::Solid),
];

/// A natural frequency over the speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// Kind of the mode.
    pub kind: Kind,
    /// Frequencies, in the unit of the axis, at the speeds.
    pub frequencies: Vec<f64>,
}

/// An order of excitation.
#[derive(Debug, Clone, PartialEq)]
pub struct Ray {
    /// Short name of the order.
    pub name: String,
    /// Frequency over speed, in the units of the axes.
    pub slope: f64,
}

/// Frequencies over the speed. Those above what the orders reach are left out.
///
/// ```
/// use epicyclic_pictures::campbell::{Branch, Campbell, Kind, Ray};
///
/// let picture = Campbell {
///     title: "A set".into(),
///     across: "speed, rpm".into(),
///     up: "frequency, Hz".into(),
///     speeds: vec![0.0, 3000.0],
///     branches: vec![Branch { kind: Kind::Rotational, frequencies: vec![700.0, 701.0] }],
///     rays: vec![Ray { name: "1".into(), slope: 0.4 }],
///     meetings: vec![[1751.0, 700.6]],
///     size_mm: epicyclic_pictures::campbell::SIZE_MM,
///     is_untitled: false,
/// };
/// let image = epicyclic_drawing::svg::write(&picture.scene()?)?;
/// assert!(image.contains("rotational"));
/// # Ok::<(), epicyclic_drawing::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// Title of the picture.
    pub title: String,
    /// Quantity on the horizontal axis, with its unit.
    pub across: String,
    /// Quantity on the vertical axis, with its unit.
    pub up: String,
    /// Speeds of the branches.
    pub speeds: Vec<f64>,
    /// Natural frequencies.
    pub branches: Vec<Branch>,
    /// Orders of excitation.
    pub rays: Vec<Ray>,
    /// Speed and frequency of each resonance.
    pub meetings: Vec<[f64; 2]>,
    /// Width and height of the field in millimetres.
    pub size_mm: [f64; 2],
    /// Whether the title is left out because the surrounding page gives it.
    pub is_untitled: bool,
}

impl Campbell {
    /// The scene.
    ///
    /// # Errors
    /// As [`Scene::layer`] and [`Scene::check`]; not for any finite values.
    pub fn scene(&self) -> Result<Scene, Error> {
        let mut scene = Scene::new(self.title.clone());
        let grid = scene.layer("grid", Style::line(0.1).color(Color::new(215, 215, 215)))?;
        let rays = scene.layer("orders", Style::line(0.25).color(Color::GREY))?;
        let branches = scene.layer("branches", Style::line(0.45))?;
        let dots = scene.layer("resonances", Style::filled(Color::new(190, 0, 30)))?;
        let frame = scene.layer("frame", Style::line(0.25))?;
        let labels = scene.layer("labels", Style::line(0.1))?;
        let [width, height] = self.size_mm;
        let across = Axis::new(self.speeds.iter().copied(), width, false);
        let fastest = self.speeds.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
        let reached = self.rays.iter().fold(0.0_f64, |most, ray| most.max(ray.slope * fastest));
        let all = || self.branches.iter().flat_map(|branch| branch.frequencies.iter().copied());
        let top = if reached > 0.0 { 1.05 * reached } else { 1.05 * all().fold(0.0, f64::max) };
        let up = Axis::new([0.0, top].into_iter(), height, false);
        for tick in across.ticks() {
            let x = across.place(tick);
            scene.add(grid, Shape::line([x, 0.0], [x, height]));
            scene.add(labels, Text::new([x, -3.5], LETTERS_MM, across.label(tick)));
        }
        let mut widest = 0.0_f64;
        for tick in up.ticks() {
            let y = up.place(tick);
            let text = Text::new([-1.5, y], LETTERS_MM, up.label(tick)).align(Align::Right);
            widest = widest.max(text.width_mm());
            scene.add(grid, Shape::line([0.0, y], [width, y]));
            scene.add(labels, text);
        }
        if !self.is_untitled {
            let title = Text::new([0.5 * width, height + 5.0], 1.2 * LETTERS_MM, self.title.clone());
            scene.add(labels, title);
        }
        scene.add(labels, Text::new([0.5 * width, -8.5], LETTERS_MM, self.across.clone()));
        let caption = Text::new([-widest - 5.0, 0.5 * height], LETTERS_MM, self.up.clone());
        scene.add(labels, caption.turned(std::f64::consts::FRAC_PI_2));
        let mut named: Vec<Bounds> = vec![];
        // The steepest first: its name has the most room.
        let mut order: Vec<&Ray> = self.rays.iter().collect();
        order.sort_by(|one, other| other.slope.total_cmp(&one.slope));
        for ray in order {
            let at = |speed: f64| [across.place(speed), up.place(ray.slope * speed.abs())];
            let mut points: Vec<[f64; 2]> = self.speeds.iter().map(|speed| at(*speed)).collect();
            // A ray has its corner where the speed changes its sign.
            if let Some(place) = self.speeds.windows(2).position(|pair| pair[0] * pair[1] < 0.0) {
                points.insert(place + 1, at(0.0));
            }
            scene.add(rays, Shape::polyline(points.iter().copied()));
            let Some(end) = points.last() else { continue };
            let text =
                Text::new([width + 1.5, end[1]], 0.85 * LETTERS_MM, ray.name.clone()).align(Align::Left);
            let room = text.bounds().grown(ROOM_MM);
            if !named.iter().any(|other| other.overlaps(room)) {
                named.push(room);
                scene.add(labels, text);
            }
        }
        for branch in &self.branches {
            let (_, color, dash) = KINDS[branch.kind as usize];
            let at = |(speed, frequency): (&f64, &f64)| [across.place(*speed), up.place(*frequency)];
            let points: Vec<[f64; 2]> = self.speeds.iter().zip(&branch.frequencies).map(at).collect();
            for piece in points.split(|[_, y]| *y > height || *y < 0.0).filter(|piece| piece.len() > 1) {
                let style = Style::line(0.45).color(color).dash(dash);
                scene.add_styled(branches, style, Shape::polyline(piece.iter().copied()));
            }
        }
        for [speed, frequency] in &self.meetings {
            let centre = [across.place(*speed), up.place(*frequency)].into();
            scene.add(dots, Shape::Circle { centre, radius: DOT_MM });
        }
        scene.add(frame, Shape::rectangle([0.0, 0.0], self.size_mm));
        let mut x = 0.0;
        for (place, (name, color, dash)) in KINDS.into_iter().enumerate() {
            if !self.branches.iter().any(|branch| branch.kind as usize == place) {
                continue;
            }
            scene.add_styled(
                branches,
                Style::line(0.45).color(color).dash(dash),
                Shape::line([x, -14.0], [x + 9.0, -14.0]),
            );
            let text = Text::new([x + 11.0, -14.0], LETTERS_MM, name).align(Align::Left);
            x += 11.0 + text.width_mm() + 6.0;
            scene.add(labels, text);
        }
        if !self.meetings.is_empty() {
            scene.add(dots, Shape::Circle { centre: [x + 1.0, -14.0].into(), radius: DOT_MM });
            scene.add(labels, Text::new([x + 3.5, -14.0], LETTERS_MM, "resonance").align(Align::Left));
        }
        scene.check()?;
        Ok(scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::text::overlaps;

    fn picture(speeds: &[f64]) -> Campbell {
        let branch = |kind, low: f64| Branch {
            kind,
            frequencies: speeds.iter().map(|speed| low + 0.01 * speed.abs()).collect(),
        };
        let ray = |name: &str, slope| Ray { name: name.to_owned(), slope };
        Campbell {
            title: "a set".to_owned(),
            across: "speed, rpm".to_owned(),
            up: "frequency, Hz".to_owned(),
            speeds: speeds.to_vec(),
            branches: vec![
                branch(Kind::Rotational, 400.0),
                branch(Kind::Translational, 700.0),
                branch(Kind::Planet, 950.0),
                branch(Kind::Mixed, 90_000.0),
            ],
            rays: vec![ray("meshes 1", 0.4), ray("meshes 2", 0.8), ray("turn", 0.001), ray("pass", 0.0015)],
            meetings: vec![[1025.6, 410.3]],
            size_mm: SIZE_MM,
            is_untitled: false,
        }
    }

    fn of_layer<'s>(scene: &'s Scene, layer: &'s str) -> impl Iterator<Item = &'s Shape> {
        scene.items().iter().filter(move |item| scene.layer_of(item).name == layer).map(|item| &item.shape)
    }

    #[test]
    fn labels_stand_free_and_nothing_leaves_the_field() {
        let both_ways = vec![-3000.0, -500.0, 1000.0, 3000.0];
        for (speeds, branches) in [(vec![0.0, 1500.0, 3000.0], 3), (both_ways, 3), (vec![500.0, 600.0], 1)] {
            let scene = picture(&speeds).scene().unwrap();
            assert_eq!(overlaps(&scene), vec![], "{speeds:?}");
            for shape in of_layer(&scene, "orders") {
                let bounds = shape.bounds();
                let inside = bounds.left >= -1e-9 && bounds.right <= SIZE_MM[0] + 1e-9;
                assert!(inside && bounds.bottom >= -1e-9 && bounds.top <= SIZE_MM[1], "{bounds:?}");
            }
            // Branches above all orders are left out, but for their sample below the field.
            let drawn = of_layer(&scene, "branches").filter(|shape| shape.bounds().bottom > 0.0).count();
            assert_eq!(drawn, branches, "{speeds:?}");
        }
    }

    #[test]
    fn a_ray_passes_through_the_resonance() {
        let picture = picture(&[0.0, 3000.0]);
        let scene = picture.scene().unwrap();
        let Some(Shape::Circle { centre, .. }) = of_layer(&scene, "resonances").next() else { panic!() };
        let Some(Shape::Polyline { vertices, .. }) = of_layer(&scene, "orders").nth(1) else { panic!() };
        let [from, to] = [vertices[0].at, vertices[1].at];
        let up = from.y + (to.y - from.y) * (centre.x - from.x) / (to.x - from.x);
        assert!((up - centre.y).abs() < 0.01, "{up} {}", centre.y);
    }
}
