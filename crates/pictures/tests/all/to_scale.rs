//! Schemes with heights by pitch radii: heights are radii, nothing crosses, no label meets anything.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{catalogue, check, crossed, examples, gears, in_service, layout, met, sized};
use epicyclic_drawing::{Scene, Shape};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout as drawability;
use epicyclic_layout::{Layout, Verdict};
use epicyclic_pictures::gearbox::Error;
use epicyclic_pictures::gearbox::scheme::{Options, Scale, Show, UP_MM, scene, to_scale};
use epicyclic_schemes::structures::{Role, Structure};
use epicyclic_train::Gearbox;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::set::{SetKind, SetSpec};
use uom::si::f64::Length;
use uom::si::length::millimeter;

fn all() -> impl Iterator<Item = (Gearbox, Vec<PlanetBearing>)> {
    let without = catalogue().into_iter().chain(in_service()).chain(examples());
    without.map(|gearbox| (gearbox, vec![])).chain(sized())
}

fn scaled(gearbox: &Gearbox, bearings: &[PlanetBearing]) -> (Layout, Scale) {
    to_scale(gearbox, &layout(gearbox), bearings)
        .unwrap_or_else(|error| unreachable!("{}: {error}", gearbox.name()))
}

fn words(scene: &Scene) -> Vec<&str> {
    let texts = scene.items().iter().filter_map(|item| match &item.shape {
        Shape::Text(text) => Some(text.content.as_str()),
        _ => None,
    });
    texts.collect()
}

fn near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= 1e-9 * b.abs(), "{what}: {a} instead of {b}");
}

#[test]
fn nothing_crosses_and_no_label_meets_anything() {
    for (gearbox, bearings) in all() {
        let (layout, scale) = scaled(&gearbox, &bearings);
        assert_eq!(layout.crossings(), [], "{}", gearbox.name());
        let options = |title: String, whole| Options {
            title: Some(title),
            whole,
            scale: Some(scale.clone()),
            ..Options::default()
        };
        for whole in [false, true] {
            let title = format!("{} to scale{}", gearbox.name(), if whole { " whole" } else { "" });
            check(&scene(&gearbox, &layout, Show::Structure, &options(title, whole)).unwrap());
        }
        for gear in gears(&gearbox) {
            let title = format!("{} to scale gear {}", gearbox.name(), gear.gear().name());
            check(
                &scene(&gearbox, &layout, Show::Gear(&gear), &options(format!("{title} state"), false))
                    .unwrap(),
            );
            check(
                &scene(&gearbox, &layout, Show::Power(&gear), &options(format!("{title} power"), false))
                    .unwrap(),
            );
        }
    }
}

/// Tests every drawable structure of two sets, with input and output on one side or two.
#[test]
fn no_two_set_structure_crosses_to_scale() {
    let eta = MeshEfficiency::new(0.97).unwrap();
    let mut drawn = 0;
    for structure in Structure::all() {
        let gearbox = structure.gearbox([2.15, 3.1], eta, [Role::D, Role::B]).unwrap();
        for same_side in [false, true] {
            let how = drawability::Options { same_side, attempts: 20 };
            let Verdict::Drawable(layout) = drawability::draw(&gearbox, how) else { continue };
            drawn += 1;
            let (layout, scale) = to_scale(&gearbox, &layout, &[]).unwrap();
            assert_eq!(layout.crossings(), [], "{structure} {same_side}");
            for (stack, k) in layout.sets.iter().zip([2.15, 3.1]) {
                near(stack.ring_mesh / stack.sun_mesh, k, gearbox.name());
            }
            let options = Options { scale: Some(scale), ..Options::default() };
            let scene = scene(&gearbox, &layout, Show::Structure, &options).unwrap();
            assert_eq!(met(&scene), [""; 0], "{structure} {same_side}");
            assert_eq!(crossed(&scene), [""; 0], "{structure} {same_side}");
        }
    }
    assert!(drawn > 100, "{drawn}");
}

/// Of sets with a sun and a ring both heights are as their radii, and between sets with teeth and one module
/// as the teeth.
#[test]
fn heights_are_as_radii() {
    let (mut compared, mut between, mut left_out) = (0, 0, vec![]);
    for (gearbox, bearings) in all() {
        let (layout, _) = scaled(&gearbox, &bearings);
        let mut suns = vec![];
        for (set, stack) in gearbox.drawn_sets().iter().zip(&layout.sets) {
            let name = gearbox.name();
            let size = set.basic_ratio(&gearbox).abs();
            // A disc of 40 teeth in a ring of 41 hardly orbits; the picture says that it is not to scale.
            if set.kind == SetKind::Simple && 0.5 * (size - 1.0) < size / 32.0 {
                left_out.push(gearbox.sets()[set.set].id().to_owned());
                continue;
            }
            if matches!(set.kind, SetKind::Simple | SetKind::DoublePlanet) {
                near(stack.ring_mesh / stack.sun_mesh, size, name);
                compared += 1;
            }
            if set.kind == SetKind::Simple {
                near(stack.planet / stack.sun_mesh, 0.5 * (1.0 + size), name);
            }
            if let (Some([first, _]), false) = (set.teeth(&gearbox), set.kind == SetKind::Bevel)
                && bearings.is_empty()
                && !matches!(set.kind, SetKind::SteppedRings)
            {
                let contact = if set.kind.is_pair() { stack.planet } else { stack.sun_mesh };
                suns.push(contact / first.as_f64());
            }
        }
        for pair in suns.windows(2) {
            near(pair[0], pair[1], gearbox.name());
            between += 1;
        }
    }
    assert!(compared > 60 && between > 20, "{compared} {between}");
    assert!(left_out.iter().all(|id| id == "reducer") && left_out.len() == 2, "{left_out:?}");
}

/// Radii of a stepped set: sun 20 and planet 30 have their axes at 25 modules, the step 18 reaches a ring of
/// (50 + 18)/2.
#[test]
fn a_stepped_planet_has_both_its_radii() {
    let set = SetSpec::teeth("1", SetKind::SteppedSunRing, ["D", "T1", "B"], 20, 68).unwrap();
    let count = |z| epicyclic_gears::teeth::ToothCount::new(z).unwrap();
    let set = set.planet_teeth(count(30), Some(count(18)));
    let builder = Gearbox::builder("stepped").links(["D", "B", "T1"]).set(set).brake("K1", "T1");
    let gearbox = builder.input("D").output("B").gear("1", ["K1"]).build().unwrap();
    let stack = scaled(&gearbox, &[]).0.sets[0];
    near(stack.planet / stack.sun_mesh, 25.0 / 10.0, "pin");
    near(stack.ring_mesh / stack.sun_mesh, 34.0 / 10.0, "ring");
}

/// Suns and ring of a Ravigneaux set have the proportion of their teeth, the rings of a Wolfrom drive the
/// proportion that the common pin leaves them.
#[test]
fn gears_of_one_set_keep_their_proportion() {
    let of = |name: &str| all().find(|(gearbox, _)| gearbox.name() == name).unwrap().0;
    let ravigneaux = of("Ravigneaux four-speed");
    let layout = scaled(&ravigneaux, &[]).0;
    let [double, simple] = [layout.sets[0], layout.sets[1]];
    near(double.sun_mesh / simple.sun_mesh, 30.0 / 36.0, "suns");
    near(double.ring_mesh / double.sun_mesh, 72.0 / 30.0, "ring");
    assert_eq!((double.ring_mesh, double.planet), (simple.ring_mesh, simple.planet));
    near(double.planet / double.ring_mesh, 27.0 / 36.0, "long planet");

    // Planet 34/30: pin at (32 + 34)/2 = 33 first modules. The second ring's module follows from 33 = m·(96 −
    // 30)/2: it is 1, and its radius 48.
    let wolfrom = of("Wolfrom 51 to 1");
    let layout = scaled(&wolfrom, &[]).0;
    let [first, second] = [layout.sets[0], layout.sets[1]];
    near(first.ring_mesh / first.sun_mesh, 100.0 / 32.0, "first ring");
    near(second.ring_mesh / second.sun_mesh, 96.0 / 32.0, "second ring");
    near(first.planet / first.sun_mesh, 33.0 / 16.0, "pin");
    assert_eq!(first.planet, second.planet);
}

/// Two sets of modules 4 mm and 2 mm: the second is half as large, and the scale bar is as long as it says.
#[test]
fn modules_scale_whole_sets() {
    let (gearbox, _) = sized().into_iter().find(|(gearbox, _)| gearbox.name() == "II-3 with sizes").unwrap();
    let size = |module: f64| epicyclic_train::planet_bearings::SetSize {
        module: Some(Length::new::<millimeter>(module)),
        ..Default::default()
    };
    let bearings = |modules: [f64; 2]| -> Vec<PlanetBearing> {
        let of = |set: usize| gearbox.planet_bearings(set, &size(modules[set])).unwrap().unwrap();
        [0, 1].into_iter().flat_map(of).collect()
    };
    let (layout, scale) = scaled(&gearbox, &bearings([4.0, 2.0]));
    let [first, second] = [layout.sets[0], layout.sets[1]];
    near(first.sun_mesh / second.sun_mesh, (4.0 * 42.0) / (2.0 * 38.0), "suns");
    let options = Options { scale: Some(scale), ..Options::default() };
    let drawn = scene(&gearbox, &layout, Show::Structure, &options).unwrap();
    let words = words(&drawn);
    let said = words.iter().find_map(|text| text.strip_suffix(" mm")).unwrap();
    let length: f64 = said.parse().unwrap();
    // The sun of set 1 has 84 mm.
    let millimetre = UP_MM * first.sun_mesh / 84.0;
    let bars = drawn.items().iter().filter_map(|item| match item.shape {
        Shape::Line { from, to } if from.x == to.x && from.y == 0.0 => Some(to.y),
        _ => None,
    });
    assert!(bars.into_iter().any(|bar| (bar - length * millimetre).abs() < 1e-9), "{length}");
    assert!(words.iter().any(|text| text.contains("widths are not")), "{words:?}");
}

#[test]
fn without_a_radius_there_is_no_scale() {
    let set = SetSpec::teeth("1", SetKind::Bevel, ["D", "T1", "B"], 16, 16).unwrap();
    let builder = Gearbox::builder("bevel").links(["D", "B", "T1"]).set(set).brake("K1", "T1");
    let gearbox = builder.input("D").output("B").gear("1", ["K1"]).build().unwrap();
    let refused = to_scale(&gearbox, &layout(&gearbox), &[]);
    assert!(matches!(refused, Err(Error::NoRadii { gearbox }) if gearbox == "bevel"));
}
