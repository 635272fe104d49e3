//! Speed diagrams, levers and ladders of the catalogue and of gearboxes in service: no label meets anything.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{Picture, catalogue, check, examples, gears, in_service, met};
use epicyclic_drawing::{Color, Shape};
use epicyclic_pictures::gearbox::levers::{Lever, levers as levers_of};
use epicyclic_pictures::gearbox::{Error, ladder, levers, speeds};
use epicyclic_train::Gearbox;
use epicyclic_train::set::SetSpec;

fn all() -> impl Iterator<Item = Gearbox> {
    catalogue().into_iter().chain(in_service()).chain(examples())
}

#[test]
fn no_label_of_a_speed_plan_meets_anything() {
    for gearbox in all() {
        for gear in gears(&gearbox) {
            let title = format!("{} gear {} speeds", gearbox.name(), gear.gear().name());
            check(&speeds::scene(&gearbox, &gear, Some(&title)).unwrap());
        }
    }
}

/// For a page: no wider than asked, and no higher than a page.
#[test]
fn a_narrow_speed_diagram_keeps_its_width() {
    for gearbox in all() {
        for gear in gears(&gearbox) {
            let scene = speeds::narrow(&gearbox, &gear, 220.0).unwrap();
            assert_eq!(met(&scene), [""; 0], "{}", scene.title());
            let bounds = scene.bounds();
            assert!(bounds.width() < 225.0 && bounds.height() < 270.0, "{}: {bounds:?}", scene.title());
        }
    }
}

#[test]
fn no_label_of_a_lever_meets_anything() {
    for gearbox in all() {
        check(&levers::scene(&gearbox, None, Some(&format!("{} levers", gearbox.name()))).unwrap());
        assert_eq!(met(&levers::bare(&gearbox, None).unwrap()), [""; 0], "{}", gearbox.name());
        for gear in gears(&gearbox) {
            let title = format!("{} gear {} levers", gearbox.name(), gear.gear().name());
            check(&levers::scene(&gearbox, Some(&gear), Some(&title)).unwrap());
        }
    }
}

#[test]
fn no_label_of_a_ladder_meets_anything() {
    for gearbox in all().filter(|gearbox| gears(gearbox).iter().any(|gear| gear.ratio().is_some())) {
        let title = format!("{} ladder", gearbox.name());
        check(&ladder::scene(&gearbox, &gears(&gearbox), Some(&title)).unwrap());
        assert_eq!(met(&ladder::bare(&gearbox, &gears(&gearbox)).unwrap()), [""; 0], "{title}");
    }
}

/// In every gear the speeds of a lever's links lie on a line over their places, joined levers included.
#[test]
fn speeds_are_linear_along_each_lever() {
    let mut joined = 0;
    for gearbox in all() {
        for gear in gears(&gearbox) {
            for Lever { nodes, sets } in levers_of(&gearbox) {
                joined += usize::from(sets.len() > 1);
                let [(one, at), (other, further), ..] = nodes[..] else { continue };
                let speed = |link| gear.speed(link).unwrap();
                let slope = (speed(other) - speed(one)) / (further - at);
                for (link, place) in nodes {
                    let on_line = speed(one) + slope * (place - at);
                    assert!((on_line - speed(link)).abs() < 1e-9 * (1.0 + slope.abs()), "{}", gearbox.name());
                }
            }
        }
    }
    assert!(joined > 20, "{joined}");
}

/// A simple set: sun and ring on both sides of the carrier, at k and 1.
#[test]
fn a_simple_set_divides_its_lever_as_one_to_k() {
    let gearbox = &catalogue()[0];
    let [lever] = &levers_of(gearbox)[..] else { unreachable!("one set, one lever") };
    let places: Vec<(&str, f64)> =
        lever.nodes.iter().map(|&(link, at)| (gearbox.link_name(link), at)).collect();
    assert_eq!(places, [("D", 2.6), ("T1", -1.0), ("B", 0.0)]);
}

/// Lines of scheme I drawn to scale: the sun's line ends at v = 1·1, the ring's at 0, and their heights are
/// as 1 to k.
#[test]
fn the_plan_of_scheme_one_is_to_scale() {
    let gearbox = &catalogue()[0];
    let scene = speeds::scene(gearbox, &gearbox.analyze("1").unwrap(), None).unwrap();
    let layer = scene.layers().iter().position(|layer| layer.name == "lines").unwrap();
    let lines: Vec<_> = scene
        .items()
        .iter()
        .filter(|item| {
            scene.style(item).width_mm > 0.0 && format!("{:?}", item.layer).contains(&layer.to_string())
        })
        .filter_map(|item| match item.shape {
            Shape::Line { from, to } => Some((to.x - from.x, to.y - from.y)),
            _ => None,
        })
        .collect();
    let [sun, ring, carrier, planet] = lines[..4] else {
        unreachable!("four lines and their rays: {lines:?}")
    };
    assert!((ring.1 / sun.1 - 2.6).abs() < 1e-9);
    assert!(ring.0.abs() < 1e-9 && sun.0 > 1.0);
    // The planet pin at (1 + k)/2, its velocity the mean of both contacts'.
    assert!((carrier.1 / sun.1 - 1.8).abs() < 1e-9 && (carrier.0 / sun.0 - 0.5).abs() < 1e-9);
    // Each line has a parallel ray.
    for line in [sun, carrier, planet] {
        let parallel = lines[4..].iter().filter(|ray| (ray.0 * line.1 - ray.1 * line.0).abs() < 1e-6);
        assert_eq!(parallel.count(), 1, "{line:?} {lines:?}");
    }
}

#[test]
fn rungs_stand_at_the_logarithm_of_their_ratio() {
    let gearbox = &in_service()[0];
    let scene = ladder::scene(gearbox, &gears(gearbox), None).unwrap();
    let mut rungs: Vec<f64> = scene
        .items()
        .iter()
        .filter_map(|item| match item.shape {
            Shape::Line { from, to } if from.y == to.y && to.x - from.x == 33.0 => Some(from.y),
            _ => None,
        })
        .collect();
    rungs.sort_by(f64::total_cmp);
    assert_eq!(rungs.len(), 9);
    // 8HP from 2/3 to 33/7 on a scale from 0.5 to 5.
    assert!((rungs[0] - 100.0 * libm::log10(2.0 / 3.0 / 0.5_f64)).abs() < 1e-9);
    assert!((rungs[8] - 100.0 * libm::log10(33.0 / 7.0 / 0.5_f64)).abs() < 1e-9);
    // The reverse gear is red.
    let picture = Picture::of(&scene);
    assert!(picture.count(Color::new(200, 60, 20)) > 100);
}

#[test]
fn gears_without_speeds_are_refused_by_name() {
    let gearbox = Gearbox::builder("open")
        .links(["D", "B", "T1"])
        .set(SetSpec::simple("1", ["D", "T1", "B"], 2.94))
        .brake("K1", "T1")
        .input("D")
        .output("B")
        .gear("neutral", [""; 0])
        .build()
        .unwrap();
    let neutral = gearbox.analyze("neutral").unwrap();
    let refused = speeds::scene(&gearbox, &neutral, None).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "gear neutral is underdetermined: the speeds of B, T1 do not follow, and a picture of it needs all"
    );
    assert_eq!(levers::scene(&gearbox, Some(&neutral), None).unwrap_err(), refused);
    assert_eq!(
        ladder::scene(&gearbox, &[neutral], None).unwrap_err(),
        Error::NoRatio { gearbox: "open".into(), gears: 1 }
    );
    assert!(levers::scene(&gearbox, None, None).is_ok());
}
