//! Gearboxes for the tests: the catalogue's fourteen and those of `examples/real-transmissions.yaml`;
//! pictures as pixels.

#![allow(dead_code, reason = "each test file uses its part")]
#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_drawing::scene::Item;
use epicyclic_drawing::text::{distance, line_meets, overlaps};
use epicyclic_drawing::{Bounds, Color, Point, Scene, Shape, dxf, svg};
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::{Document, Path};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_layout as drawability;
use epicyclic_layout::{Layout, Verdict};
use epicyclic_schemes::catalogue::{ThreeSpeed, TwoSpeed};
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::planet_set::Description;
use epicyclic_train::set::MeshLoss;
use epicyclic_train::{Analysis, Gearbox};
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

/// The gearboxes of `examples/` and of the cases that can be drawn, with losses.
pub(crate) fn examples() -> Vec<Gearbox> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let folders = ["examples", "spec-cases/real-gearboxes", "spec-cases/multispeed-gearboxes"];
    let read = |folder| std::fs::read_dir(format!("{root}/{folder}")).unwrap();
    let mut files: Vec<_> = folders.into_iter().flat_map(read).map(|file| file.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|end| end == "yaml"));
    files.sort();
    let mut found = vec![];
    for path in files {
        let documents = Document::parse_all("file.yaml", &std::fs::read(&path).unwrap()).unwrap();
        for document in documents {
            let at = if document.value().get("gearbox").is_some() {
                Path::root()
            } else {
                Path::root().key("given").key("gearbox")
            };
            // Cases of other calculations have none, and some cases are of faults in one.
            let Ok(described) = document.read_at::<GearboxFile>(&at) else { continue };
            let Ok(gearbox) = described.gearbox() else { continue };
            if matches!(drawability::draw(&gearbox, drawability::Options::default()), Verdict::Drawable(_)) {
                found.push(with_losses(&gearbox));
            }
        }
    }
    assert!(found.len() > 15, "{}", found.len());
    found
}

/// The gearboxes of the examples whose files say sizes, with their planet bearings.
pub(crate) fn sized() -> Vec<(Gearbox, Vec<PlanetBearing>)> {
    let read = |name: &str| {
        let file = format!("{}/../../examples/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
        let document = Document::parse_one(name, &std::fs::read(file).unwrap()).unwrap();
        let described = document.read::<GearboxFile>().unwrap();
        let gearbox = with_losses(&described.gearbox().unwrap());
        let bearings = described.planet_bearings(&gearbox).unwrap();
        (gearbox, bearings)
    };
    ["sized-gearbox", "every-gearbox-key"].map(read).into()
}

/// The gears of a gearbox in which all speeds follow, and the power flow.
pub(crate) fn gears(gearbox: &Gearbox) -> Vec<Analysis<'_>> {
    let analyses = gearbox.gears().iter().map(|gear| gearbox.analyze(gear.name()).unwrap());
    analyses.filter(|gear| gear.speeds().iter().all(Option::is_some) && gear.driving().is_some()).collect()
}

fn with_losses(gearbox: &Gearbox) -> Gearbox {
    let (eta, each) = (MeshEfficiency::new(0.97).unwrap(), MeshEfficiency::new(0.985).unwrap());
    let change = |description: Description| match description {
        Description::Short(spec) => spec.with_loss(MeshLoss::Set(eta)).into(),
        Description::Compound(spec) => spec.with_mesh_efficiency(each).into(),
    };
    gearbox.to_builder().map_descriptions(change).build().unwrap()
}

/// The gearboxes of the examples that are whole gearboxes, and can be drawn.
pub(crate) fn whole_examples() -> Vec<Gearbox> {
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
        "drags",
        "travel-drive-duty",
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

/// Leaders that run through a label or a sign, in words: gears, plates and what is between two plates, nodes
/// of levers.
pub(crate) fn crossed(scene: &Scene) -> Vec<String> {
    let layer = |item: &Item| scene.layer_of(item).name.clone();
    let line = |item: &Item| match item.shape {
        Shape::Line { from, to } => Some((from, to)),
        _ => None,
    };
    let is_leader = |item: &&Item| {
        let style = scene.style(item);
        layer(item) == "labels" && style.width_mm == 0.18 && style.color == Color::GREY
    };
    // Of a scheme; brakes of levers have none.
    let is_scheme = scene.layers().iter().any(|layer| layer.name == "links");
    let plates: Vec<(Point, Point)> = scene
        .items()
        .iter()
        .filter(|item| layer(item) == "shift elements" || layer(item) == "gears")
        .filter_map(line)
        .filter(|(from, to)| is_scheme && from.y == to.y)
        .collect();
    let mut found = vec![];
    for leader in scene.items().iter().filter(is_leader) {
        let Some((at, end)) = line(leader) else { continue };
        let mut through = |what: &str| found.push(format!("a leader from {at:?} runs through {what}"));
        let length = libm::hypot(end.x - at.x, end.y - at.y);
        let part = (0.8 / length).min(1.0);
        let off = Point::new(at.x + part * (end.x - at.x), at.y + part * (end.y - at.y));
        for item in scene.items().iter().filter(|item| *item != leader) {
            if let Shape::Text(text) = &item.shape {
                if line_meets(&leader.shape, text.bounds()) {
                    through(&text.content);
                }
            } else if ["gears", "shift elements", "levers"].contains(&layer(item).as_str())
                && distance(off, end, &item.shape) < 0.1
            {
                through(&format!("{:?}", item.shape));
            }
        }
        // Two plates or rims above each other with nothing but a gap between.
        for (low, left) in
            plates.iter().zip(1..).flat_map(|(low, at)| plates[at..].iter().map(move |next| (low, next)))
        {
            let gap = (left.0.y - low.0.y).abs();
            if (0.5..6.0).contains(&gap) && left.0.x == low.0.x && left.1.x == low.1.x {
                let between = Bounds::of([low.0, low.1, left.0, left.1]);
                if line_meets(&leader.shape, between) {
                    through(&format!("the gap {between:?}"));
                }
            }
        }
    }
    found
}

/// The scene holds no overlap, no leader runs through a sign, and both writers take it.
pub(crate) fn check(scene: &Scene) {
    assert_eq!(met(scene), [""; 0], "{}", scene.title());
    assert_eq!(crossed(scene), [""; 0], "{}", scene.title());
    svg::write(scene).unwrap();
    prints(scene);
    keep(scene);
}

/// Every layer and every entity of the DXF drawing has a colour that prints on white and is seen on black.
pub(crate) fn prints(scene: &Scene) {
    let text = dxf::write(scene).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let colors = lines.chunks(2).filter(|pair| pair[0].trim() == "62").map(|pair| pair[1]);
    let colors: Vec<u16> = colors.map(|color| color.trim().parse().unwrap()).collect();
    assert!(colors.len() > scene.layers().len(), "{}", scene.title());
    for color in colors {
        let contrast = dxf::contrast(color).unwrap_or([0.0; 2]);
        assert!(contrast.iter().all(|both| *both >= dxf::LEAST_CONTRAST), "{}: {color}", scene.title());
    }
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

    /// Number of pixels of a colour.
    pub(crate) fn count(&self, color: Color) -> usize {
        let same =
            |p: &&resvg::tiny_skia::PremultipliedColorU8| Color::new(p.red(), p.green(), p.blue()) == color;
        self.pixels.pixels().iter().filter(same).count()
    }
}
