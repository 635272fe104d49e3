//! Gearboxes for the tests: the catalogue's fourteen and those of `examples/real-transmissions.yaml`; pictures as pixels.

#![allow(dead_code, reason = "each test file uses its part")]
#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_drawing::text::overlaps;
use epicyclic_drawing::{Color, Scene, Shape, dxf, svg};
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_layout as drawability;
use epicyclic_layout::{Layout, Verdict};
use epicyclic_schemes::catalogue::{ThreeSpeed, TwoSpeed};
use epicyclic_train::Gearbox;
use epicyclic_train::set::MeshLoss;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

pub(crate) fn catalogue() -> Vec<Gearbox> {
    let k = |k| RingToSunRatio::new(k).unwrap();
    let eta = MeshEfficiency::new(0.97).unwrap();
    let two = TwoSpeed::ALL.into_iter().map(|scheme| scheme.gearbox(k(2.6), eta).unwrap());
    let three = ThreeSpeed::ALL.into_iter().map(|scheme| scheme.gearbox(k(2.15), k(3.1), eta).unwrap());
    two.chain(three).collect()
}

pub(crate) fn in_service() -> Vec<Gearbox> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/real-transmissions.yaml");
    let bytes = std::fs::read(file).unwrap();
    let document = Document::parse_one("real-transmissions.yaml", &bytes).unwrap();
    let all = document.read::<TransmissionsFile>().unwrap().transmissions;
    let loss = MeshLoss::Set(MeshEfficiency::new(0.97).unwrap());
    all.iter()
        .map(|one| one.gearbox().unwrap().to_builder().map_sets(|set| set.with_loss(loss)).build().unwrap())
        .collect()
}

/// The gearboxes of the examples that are whole gearboxes, and can be drawn.
pub(crate) fn examples() -> Vec<Gearbox> {
    let names = [
        "ravigneaux",
        "wolfrom",
        "wolfrom-self-locking",
        "simpson",
        "lepelletier",
        "six-speed-6hp",
        "power-split",
        "scheme-ii-3",
        "sized-gearbox",
        "unlisted-scheme",
        "closed-by-planetary-gear",
        "closed-by-ordinary-train",
        "every-gearbox-key",
    ];
    let read = |name: &str| {
        let file = format!("{}/../../examples/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
        let document = Document::parse_one(name, &std::fs::read(file).unwrap()).unwrap();
        document.read::<GearboxFile>().unwrap().gearbox().unwrap()
    };
    names.into_iter().map(read).collect()
}

pub(crate) fn layout(gearbox: &Gearbox) -> Layout {
    match drawability::draw(gearbox, drawability::Options::default()) {
        Verdict::Drawable(layout) => *layout,
        Verdict::SelfCrossing(witness) => {
            unreachable!("{}: {}", gearbox.name(), witness.describe(gearbox))
        }
    }
}

/// Labels that meet something, in words.
pub(crate) fn met(scene: &Scene) -> Vec<String> {
    let words = |at: usize| match &scene.items()[at].shape {
        Shape::Text(text) => text.content.clone(),
        other => format!("{other:?}"),
    };
    overlaps(scene).into_iter().map(|met| format!("{} - {}", words(met.label), words(met.with))).collect()
}

/// The scene holds no overlap and both writers take it.
pub(crate) fn check(scene: &Scene) {
    assert_eq!(met(scene), [""; 0], "{}", scene.title());
    svg::write(scene).unwrap();
    dxf::write(scene).unwrap();
    keep(scene);
}

/// The picture as a file for the eye, where `EPICYCLIC_PICTURES` names a folder.
fn keep(scene: &Scene) {
    if let Ok(folder) = std::env::var("EPICYCLIC_PICTURES") {
        let name: String =
            scene.title().chars().map(|c| if c.is_alphanumeric() || c == '-' { c } else { '_' }).collect();
        std::fs::write(format!("{folder}/{name}.svg"), svg::write(scene).unwrap()).unwrap();
    }
}

/// Pixels to a millimetre.
const SCALE: f64 = 4.0;

pub(crate) struct Picture {
    pixels: Pixmap,
    left: f64,
    top: f64,
}

impl Picture {
    pub(crate) fn of(scene: &Scene) -> Self {
        let tree = Tree::from_str(&svg::write(scene).unwrap(), &Options::default()).unwrap();
        let bounds = scene.bounds().grown(svg::MARGIN_MM);
        let scale = (SCALE * 25.4 / 96.0) as f32;
        let size = |size: f32| (size * scale).ceil() as u32;
        let mut pixels = Pixmap::new(size(tree.size().width()), size(tree.size().height())).unwrap();
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
        Self { pixels, left: bounds.left, top: bounds.top }
    }

    pub(crate) fn at(&self, x: f64, y: f64) -> Color {
        let pixel = |mm: f64| (mm * SCALE) as u32;
        let color = self.pixels.pixel(pixel(x - self.left), pixel(self.top - y)).unwrap();
        Color::new(color.red(), color.green(), color.blue())
    }

    /// How many pixels have a colour.
    pub(crate) fn count(&self, color: Color) -> usize {
        let same =
            |p: &&resvg::tiny_skia::PremultipliedColorU8| Color::new(p.red(), p.green(), p.blue()) == color;
        self.pixels.pixels().iter().filter(same).count()
    }
}
