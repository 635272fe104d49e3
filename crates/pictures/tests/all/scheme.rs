//! Schemes of the catalogue and of gearboxes in service: no label meets anything.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{Picture, catalogue, check, crossed, examples, gears, in_service, layout, met, whole_examples};
use epicyclic_drawing::{Color, Scene, Shape};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_layout as drawability;
use epicyclic_layout::Verdict;
use epicyclic_pictures::gearbox::Error;
use epicyclic_pictures::gearbox::scheme::{ALONG_MM, Options, Show, UP_MM, narrow, scene};
use epicyclic_schemes::structures::{Role, Structure};
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::{Gearbox, LinkId};

const ENGAGED: Color = Color::new(214, 48, 32);
const RESTING: Color = Color::new(165, 165, 165);
const POWER: Color = Color::new(30, 95, 170);
const CIRCULATING: Color = Color::new(240, 140, 20);

fn all() -> impl Iterator<Item = Gearbox> {
    catalogue().into_iter().chain(in_service()).chain(examples())
}

/// Sets of every gearbox are side by side.
#[test]
fn all_sets_stand_in_one_band() {
    let bands = |gearbox: &Gearbox| layout(gearbox).cost(gearbox).bands;
    let in_one = |all: Vec<Gearbox>| [all.iter().filter(|gearbox| bands(gearbox) == 1).count(), all.len()];
    assert_eq!([catalogue(), in_service(), whole_examples()].map(in_one), [[14, 14], [5, 5], [15, 15]]);
}

/// A Ravigneaux set has one ring and one long planet over both suns, a Wolfrom drive one sun under both
/// rings.
#[test]
fn sets_with_planets_in_common_are_drawn_as_one() {
    let one_of = |name: &str| all().find(|gearbox| gearbox.name() == name).unwrap();
    let cases = [
        ("Ravigneaux four-speed", "long planet and the ring", ["b2", "a2"]),
        ("Ford AOD", "long planet and the ring", ["b2", "a2"]),
        ("Lepelletier six-speed", "long planet and the ring", ["b3", "a3"]),
        ("Wolfrom 51 to 1", "stepped planet and the sun", ["a2", "b2"]),
        ("Wolfrom 408 to 1", "stepped planet and the sun", ["a2", "b2"]),
    ];
    for (name, words, [hidden, shown]) in cases {
        let gearbox = one_of(name);
        let scene = scene(&gearbox, &layout(&gearbox), Show::Structure, &Options::default()).unwrap();
        let texts: Vec<&str> = scene
            .items()
            .iter()
            .filter_map(|item| match &item.shape {
                Shape::Text(text) => Some(text.content.as_str()),
                _ => None,
            })
            .collect();
        assert!(texts.iter().any(|text| text.contains(words)), "{name}: {texts:?}");
        assert!(texts.contains(&shown) && !texts.contains(&hidden), "{name}: {texts:?}");
    }
}

/// In second gear all power of the four-speed goes from the small sun through the meshes to the ring: none
/// along the carrier, none around.
#[test]
fn halves_of_one_set_show_no_power_that_only_passes_between_them() {
    let gearbox =
        whole_examples().into_iter().find(|gearbox| gearbox.name() == "Ravigneaux four-speed").unwrap();
    let (layout, gear) = (layout(&gearbox), gearbox.analyze("2").unwrap());
    let scene = scene(&gearbox, &layout, Show::Power(&gear), &Options::default()).unwrap();
    let pin = layout.sets[0].planet * UP_MM;
    let mut widths = vec![];
    for item in scene.items() {
        let Shape::Line { from, to } = item.shape else { continue };
        let Some(style) = item.style.filter(|style| style.color == POWER) else { continue };
        assert!((from.y, to.y) != (pin, pin), "the carrier passes no power: {from:?} {to:?}");
        widths.push(style.width_mm);
    }
    // No line is wider than the input's.
    let input = widths.iter().copied().fold(0.0, f64::max);
    assert!(widths.iter().all(|width| *width <= input) && (input - 2.2).abs() < 1e-9, "{widths:?}");
}

#[test]
fn no_label_of_a_structure_meets_anything() {
    for gearbox in all() {
        let layout = layout(&gearbox);
        for whole in [false, true] {
            let title = whole.then(|| format!("{}, whole", gearbox.name()));
            let options = Options { whole, title, ..Options::default() };
            check(&scene(&gearbox, &layout, Show::Structure, &options).unwrap());
        }
    }
}

#[test]
fn no_label_of_a_gear_meets_anything() {
    for gearbox in all() {
        let layout = layout(&gearbox);
        for analysis in gears(&gearbox) {
            let title = format!("{} gear {}", gearbox.name(), analysis.gear().name());
            for (show, title) in [
                (Show::Gear(&analysis), format!("{title} state")),
                (Show::Power(&analysis), format!("{title} power")),
            ] {
                let options = Options { title: Some(title), ..Options::default() };
                check(&scene(&gearbox, &layout, show, &options).unwrap());
            }
        }
    }
}

/// Checks schemes for a page: compressed to about the required width, with room for all labels.
#[test]
fn a_narrow_scheme_keeps_its_width_and_no_label_meets_anything() {
    for gearbox in all() {
        let layout = layout(&gearbox);
        for analysis in gears(&gearbox) {
            for show in [Show::Structure, Show::Power(&analysis)] {
                let drawn = narrow(&gearbox, &layout, show, None, 100.0).unwrap();
                assert_eq!(met(&drawn), [""; 0], "{}", drawn.title());
                assert_eq!(crossed(&drawn), [""; 0], "{}", drawn.title());
                let width = drawn.bounds().width();
                assert!(width <= 103.0, "{}: {width}", drawn.title());
            }
        }
    }
}

/// Labels of all drawable structures of two sets, with input and output on one side or two.
#[test]
fn no_label_of_any_two_set_structure_meets_anything() {
    let eta = MeshEfficiency::new(0.97).unwrap();
    let mut drawn = 0;
    for structure in Structure::all() {
        let gearbox = structure.gearbox([2.15, 3.1], eta, [Role::D, Role::B]).unwrap();
        for same_side in [false, true] {
            let how = drawability::Options { same_side, attempts: 20 };
            let Verdict::Drawable(layout) = drawability::draw(&gearbox, how) else { continue };
            drawn += 1;
            let gear = gearbox.analyze(gearbox.gears()[0].name()).unwrap();
            for show in [Show::Structure, Show::Gear(&gear), Show::Power(&gear)] {
                let scene = scene(&gearbox, &layout, show, &Options::default()).unwrap();
                assert_eq!(met(&scene), [""; 0], "{structure} {same_side}");
                assert_eq!(crossed(&scene), [""; 0], "{structure} {same_side}");
            }
        }
    }
    assert!(drawn > 100, "{drawn}");
}

fn in_gear(gearbox: &Gearbox, gear: &str, power: bool) -> Scene {
    let analysis = gearbox.analyze(gear).unwrap();
    let show = if power { Show::Power(&analysis) } else { Show::Gear(&analysis) };
    scene(gearbox, &layout(gearbox), show, &Options::default()).unwrap()
}

#[test]
fn engaged_brakes_are_filled_and_open_ones_are_not() {
    for gearbox in catalogue() {
        let layout = layout(&gearbox);
        for gear in gearbox.gears().iter().filter(|gear| gear.name() != "direct") {
            let picture = Picture::of(&in_gear(&gearbox, gear.name(), false));
            for mark in &layout.brakes {
                // Between the plates, beside the link's own line.
                let x = ALONG_MM * mark.link_end.x + 1.5;
                let y = UP_MM * f64::midpoint(mark.link_end.y, mark.housing.y);
                let expected =
                    if gear.engaged().contains(&mark.shift_element) { ENGAGED } else { Color::WHITE };
                assert_eq!(picture.at(x, y), expected, "{} {}", gearbox.name(), gear.name());
            }
        }
        let closed = Picture::of(&in_gear(&gearbox, "direct", false));
        let clutch = layout.clutches[0];
        let y = UP_MM * f64::midpoint(clutch.lower.1.y, clutch.upper.1.y);
        assert_eq!(closed.at(ALONG_MM * clutch.lower.1.x, y), ENGAGED, "{}", gearbox.name());
    }
}

#[test]
fn what_rests_is_grey() {
    let gearbox = &catalogue()[0];
    let layout = layout(gearbox);
    let structure = Picture::of(&scene(gearbox, &layout, Show::Structure, &Options::default()).unwrap());
    // But for a few pixels at the edges of black lines.
    assert!(structure.count(RESTING) < 50);
    assert!(structure.count(Color::BLACK) > 1000);
    let picture = Picture::of(&in_gear(gearbox, "1", false));
    assert!(picture.count(RESTING) > 100);
    // The input's shaft turns.
    assert_eq!(picture.at(ALONG_MM * (layout.input.at.x + 0.3), 0.0), Color::BLACK);
}

/// Widths of the lines of one colour on a layer.
fn widths(scene: &Scene, name: &str, color: Color) -> Vec<f64> {
    let layer = |item: &epicyclic_drawing::scene::Item| format!("{:?}", item.layer);
    let place = scene.layers().iter().position(|layer| layer.name == name).unwrap();
    let lines = scene.items().iter().filter(|item| {
        layer(item) == format!("LayerId({place})") && matches!(item.shape, Shape::Line { .. })
    });
    lines
        .map(|item| scene.style(item))
        .filter(|style| style.color == color)
        .map(|style| style.width_mm)
        .collect()
}

/// Every width on the links of II-3 in gear 2 is a power of the analysis times the width of what enters, and
/// the input's is that.
#[test]
fn widths_are_powers() {
    let gearbox = catalogue().into_iter().find(|gearbox| gearbox.name() == "II-3").unwrap();
    let gear = gearbox.analyze("2").unwrap();
    let case = gear.driving().unwrap();
    let scene = in_gear(&gearbox, "2", true);
    let found = widths(&scene, "links", POWER);
    assert!(found.len() > 8);
    let mut powers: Vec<f64> = case.power.sets.iter().flatten().flat_map(|set| set.members.clone()).collect();
    powers.extend([1.0, case.efficiency]);
    for width in &found {
        let power = width / 2.2;
        assert!(powers.iter().any(|p| (p.abs() - power).abs() < 1e-9), "{power} {powers:?}");
    }
    assert!(found.iter().any(|width| (width - 2.2).abs() < 1e-12));
    assert!(found.iter().any(|width| (width - 2.2 * case.efficiency).abs() < 1e-9));
}

/// In every gear of every gearbox all powers of the links follow, so each link is a tree; and only
/// circulating power is orange.
#[test]
fn powers_of_all_pieces_follow() {
    for gearbox in all() {
        for analysis in gears(&gearbox) {
            let gear = analysis.gear();
            let scene = in_gear(&gearbox, gear.name(), true);
            let says = |words: &str| {
                scene
                    .items()
                    .iter()
                    .any(|item| matches!(&item.shape, Shape::Text(text) if text.content.contains(words)))
            };
            assert!(!says("does not follow"), "{} {}", gearbox.name(), gear.name());
            let circulating = analysis.driving().unwrap().power.circulating;
            let orange = Picture::of(&scene).count(CIRCULATING);
            assert_eq!(circulating > 1e-6, orange > 0, "{} {} {circulating}", gearbox.name(), gear.name());
        }
    }
}

#[test]
fn the_whole_scheme_is_its_own_mirror_image() {
    let gearbox = &catalogue()[4];
    let whole = Options { whole: true, ..Options::default() };
    let layout = layout(gearbox);
    let picture = Picture::of(&scene(gearbox, &layout, Show::Structure, &whole).unwrap());
    for shape in layout.links.iter().filter(|shape| shape.link != LinkId::GROUND) {
        for segment in &shape.segments {
            let x = ALONG_MM * f64::midpoint(segment.from.x, segment.to.x);
            let y = UP_MM * f64::midpoint(segment.from.y, segment.to.y);
            assert_eq!([picture.at(x, y), picture.at(x, -y)], [Color::BLACK; 2], "{} {}", x, y);
        }
    }
}

/// A gearbox of one set of a kind, all of whose members reach out.
fn one(kind: SetKind) -> Gearbox {
    let count = |z| ToothCount::new(z).unwrap();
    let members = if kind.is_pair() { ["D", "B", "ground"] } else { ["D", "T1", "B"] };
    let set = SetSpec::teeth("1", kind, members, 24, 72).unwrap().planet_teeth(count(20), Some(count(26)));
    let builder = Gearbox::builder(&kind.to_string()).links(["D", "B"]).set(set).input("D").output("B");
    if kind.is_pair() {
        return builder.gear("1", [""; 0]).build().unwrap();
    }
    builder.links(["T1"]).brake("K1", "T1").clutch("L", "D", "B").gear("1", ["K1"]).build().unwrap()
}

#[test]
fn every_kind_of_set_has_a_sign() {
    use SetKind::{
        Bevel, DoublePlanet, ExternalPair, InternalPair, MeshingSuns, Simple, SteppedRings, SteppedSunRing,
        SteppedSuns,
    };
    let kinds = [
        Simple,
        DoublePlanet,
        SteppedSunRing,
        SteppedSuns,
        SteppedRings,
        MeshingSuns,
        Bevel,
        ExternalPair,
        InternalPair,
    ];
    let mut gears = vec![];
    for kind in kinds {
        let gearbox = one(kind);
        check(&in_gear(&gearbox, "1", false));
        check(&in_gear(&gearbox, "1", true));
        let structure = scene(&gearbox, &layout(&gearbox), Show::Structure, &Options::default()).unwrap();
        gears.push(widths(&structure, "gears", Color::BLACK).iter().filter(|width| **width == 0.7).count());
    }
    // Rims, and the fork of two planets: 4 of a single planet, 6 of two and 3 lines of its fork on each side,
    // 6 of a stepped one.
    assert_eq!(gears[0], 4);
    assert!(gears[1] > gears[0] && gears[2] == 6, "{gears:?}");
    assert_eq!(gears[7..], [2, 2]);
}

#[test]
fn gears_without_powers_are_refused_by_name() {
    let gearbox = one(SetKind::Simple).to_builder().gear("blocked", ["K1", "L"]).build().unwrap();
    let layout = layout(&gearbox);
    let blocked = gearbox.analyze("blocked").unwrap();
    let refused = scene(&gearbox, &layout, Show::Power(&blocked), &Options::default());
    assert!(matches!(refused, Err(Error::NoPower { gear, .. }) if gear == "blocked"));
    assert!(scene(&gearbox, &layout, Show::Gear(&blocked), &Options::default()).is_ok());
}
