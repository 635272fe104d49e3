//! Sets in mesh, read back from DXF: every gear is a closed line of arcs and splines on a layer of its own,
//! no further from the exact tooth than a micrometre.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use ::dxf::Drawing;
use ::dxf::entities::{EntityType, Spline};
use epicyclic_drawing::text::overlaps;
use epicyclic_drawing::{Scene, dxf};
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_gears::involute::curve::{Point, ToothCurve};
use epicyclic_gears::rack::BasicRack;
use epicyclic_pictures::toothed_sets::{ToothedSet, scene};
use epicyclic_train::Gearbox;
use std::f64::consts::TAU;
use std::io::Cursor;
use uom::si::f64::Length;
use uom::si::length::meter;

/// Largest distance from the exact curve, mm.
const MICROMETRE: f64 = 1e-3;

const RAVIGNEAUX: &str = "{ gearbox: Ravigneaux, input: small, output: ring, compound_sets: [{ id: set, carrier: arm,
  suns: { small: 31, large: 38 }, rings: { ring: 85 }, planet_gears: { short: [20], long: [23] }, planets: 3,
  module: 1.75 mm, helix_angle: 18 deg, profile_shifts: { ring: 0.2, large: 0.1, long: 0.1 },
  meshes: [{ gears: [small, short] }, { gears: [short, long] }, { gears: [large, long] }, { gears: [long, ring] }] }],
  brakes: [{ id: K, link: arm }], gears: [{ name: '1', engaged: [K] }] }";

const ROBOT: &str =
    "{ gearbox: robot, input: sun, output: arm, sets: [{ id: P, kind: stepped_sun_ring, sun: sun,
  ring: ground, carrier: arm, teeth: [18, 117], planet_teeth: [66, 33], planets: 3, module: 1 mm }],
  gears: [{ name: only }] }";

const RING_PAIR: &str =
    "{ gearbox: pair, input: x, output: y, sets: [{ id: a/b, kind: internal_pair, sun: x, ring: y,
  teeth: [17, 53], module: 4 mm, helix_angle: 12 deg, profile_shifts: [0.3, -0.1],
  tools: { gear 1: { protuberance: 0.05, stock: 0.02 }, gear 2: { shaper: { teeth: 23 } } } }],
  gears: [{ name: only }] }";

fn example(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
    std::fs::read_to_string(format!("{folder}{name}")).unwrap()
}

fn gearbox(text: &str) -> (GearboxFile, Gearbox) {
    let document = Document::parse_one("g.yaml", text.as_bytes()).unwrap();
    let file: GearboxFile = document.read().unwrap();
    let gearbox = file.gearbox().unwrap();
    (file, gearbox)
}

/// The sets of a gearbox as they are drawn.
fn sets<'g>(file: &GearboxFile, gearbox: &'g Gearbox) -> Vec<ToothedSet<'g>> {
    let toothed = |set: &'g epicyclic_train::PlanetSet| {
        let modules = file.stated_modules(set);
        let toothed = set.toothed(&BasicRack::default(), &modules).unwrap();
        let has_module = modules.iter().any(Option::is_some);
        let unit = has_module.then(|| Length::new::<meter>(1.0));
        ToothedSet { set, in_mesh: set.in_mesh(&toothed, &[], 3).unwrap(), unit }
    };
    gearbox.sets().iter().map(toothed).collect()
}

/// A point of a spline by the recursion of de Boor.
fn on_spline(spline: &Spline, t: f64) -> [f64; 2] {
    let knots = &spline.knot_values;
    let span =
        (3..spline.control_points.len()).rfind(|&i| knots[i] <= t && knots[i] < knots[i + 1]).unwrap_or(3);
    let mut points: Vec<[f64; 2]> =
        (0..4).map(|i| &spline.control_points[span - 3 + i]).map(|point| [point.x, point.y]).collect();
    for level in 1..4 {
        for i in (level..4).rev() {
            let [from, to] = [knots[span - 3 + i], knots[span + 1 + i - level]];
            let share = (t - from) / (to - from);
            points[i] = [0, 1].map(|axis| (1.0 - share) * points[i - 1][axis] + share * points[i][axis]);
        }
    }
    points[3]
}

/// Points of a spline, thirty to a stretch between knots.
fn samples(spline: &Spline) -> Vec<[f64; 2]> {
    let mut knots = spline.knot_values.clone();
    knots.dedup();
    let stretch = |ends: &[f64]| {
        let (from, to) = (ends[0], ends[1]);
        (0..30).map(move |i| from + (to - from) * f64::from(i) / 30.0)
    };
    knots.windows(2).flat_map(stretch).map(|t| on_spline(spline, t)).collect()
}

/// The exact half of a tooth by chords of 1e-6 modules.
fn exact(curve: &ToothCurve) -> Vec<[f64; 2]> {
    curve.half(1e-6).unwrap().into_iter().map(Point::coordinates).collect()
}

fn distance([x, y]: [f64; 2], chain: &[[f64; 2]]) -> f64 {
    let to_chord = |ends: &[[f64; 2]]| {
        let ([x1, y1], [x2, y2]) = (ends[0], ends[1]);
        let (dx, dy) = (x2 - x1, y2 - y1);
        let share = ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy).max(f64::MIN_POSITIVE);
        let share = share.clamp(0.0, 1.0);
        libm::hypot(x - x1 - share * dx, y - y1 - share * dy)
    };
    chain.windows(2).map(to_chord).fold(f64::INFINITY, f64::min)
}

/// Arcs and splines of a layer.
type Lines<'d> = (Vec<&'d ::dxf::entities::Arc>, Vec<&'d Spline>);

fn of_layer<'d>(drawing: &'d Drawing, layer: &str) -> Lines<'d> {
    let (mut arcs, mut splines) = (vec![], vec![]);
    for entity in drawing.entities().filter(|entity| entity.common.layer == layer) {
        match &entity.specific {
            EntityType::Arc(arc) => arcs.push(arc),
            EntityType::Spline(spline) => splines.push(spline),
            EntityType::Circle(_) => {}
            other => panic!("{layer}: {other:?}"),
        }
    }
    (arcs, splines)
}

fn on_circle(arc: &::dxf::entities::Arc, degrees: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [arc.center.x + arc.radius * cos, arc.center.y + arc.radius * sin]
}

/// Greatest distance of the lines of a layer from the exact tooth, mm.
fn check_layer((arcs, splines): &Lines<'_>, curve: &ToothCurve, module_mm: f64, copies: usize) -> f64 {
    let teeth = curve.gear().teeth().get() as usize;
    let [tip, root] = [curve.tip_radius(), curve.root_radius()].map(|radius| module_mm * radius);
    let tips: Vec<_> = arcs.iter().filter(|arc| (arc.radius - tip).abs() < 1e-6).collect();
    let roots = arcs.iter().filter(|arc| (arc.radius - root).abs() < 1e-6).count();
    assert_eq!((tips.len(), roots, arcs.len()), (copies * teeth, copies * teeth, 2 * copies * teeth));
    // Every end meets another.
    let spline_ends = splines.iter().flat_map(|spline| {
        let points = &spline.control_points;
        [&points[0], &points[points.len() - 1]].map(|point| [point.x, point.y])
    });
    let arc_ends =
        arcs.iter().flat_map(|arc| [arc.start_angle, arc.end_angle].map(|angle| on_circle(arc, angle)));
    let ends: Vec<[f64; 2]> = arc_ends.chain(spline_ends).collect();
    for (place, [x, y]) in ends.iter().enumerate() {
        let meets =
            |(other, [x2, y2]): (usize, &[f64; 2])| other != place && libm::hypot(x2 - x, y2 - y) < 1e-6;
        assert_eq!(ends.iter().enumerate().filter(|end| meets(*end)).count(), 1, "a gap or a fork");
    }
    let chain = exact(curve);
    let pitch = TAU / curve.gear().teeth().as_f64();
    let mut worst: f64 = 0.0;
    // All teeth are turned copies of one: some of them tell.
    for spline in splines.iter().step_by(41) {
        for [x, y] in samples(spline) {
            // The gear whose centre is nearest, and its tooth from a tip.
            let from = |arc: &&&::dxf::entities::Arc| libm::hypot(x - arc.center.x, y - arc.center.y);
            let near = tips.iter().min_by(|one, other| from(one).total_cmp(&from(other))).unwrap();
            let sweep = (near.end_angle - near.start_angle).rem_euclid(360.0);
            let tooth = (near.start_angle + 0.5 * sweep).to_radians();
            let (radius, angle) = (from(near), libm::atan2(y - near.center.y, x - near.center.x) - tooth);
            let angle = (angle - (angle / pitch).round() * pitch).abs();
            let point = [libm::cos(angle), libm::sin(angle)].map(|along| along * radius / module_mm);
            worst = worst.max(module_mm * distance(point, &chain));
        }
    }
    worst
}

fn read_back(scene: &Scene) -> Drawing {
    Drawing::load(&mut Cursor::new(dxf::write(scene).unwrap().into_bytes())).unwrap()
}

#[test]
fn every_gear_is_a_layer_of_arcs_and_splines_within_a_micrometre() {
    let texts = [
        RAVIGNEAUX.to_owned(),
        ROBOT.to_owned(),
        RING_PAIR.to_owned(),
        example("wolfrom.yaml"),
        example("wind-gearbox.yaml"),
    ];
    for text in texts {
        let (file, gearbox) = gearbox(&text);
        let sets = sets(&file, &gearbox);
        let scene = scene(gearbox.name(), &sets).unwrap();
        assert_eq!(overlaps(&scene), [], "{}", gearbox.name());
        let drawing = read_back(&scene);
        let mut layers = 0;
        for ToothedSet { set, in_mesh, unit } in &sets {
            for (index, gear) in in_mesh.gears.iter().enumerate() {
                let layer = format!("{} {}", set.id(), set.gear_name(gear.of)).replace('/', "_");
                let copies = in_mesh.placed().filter(|placed| placed.gear == index).count();
                let module = gear.module * unit.map_or(1.0, |unit| 1e3 * unit.get::<meter>());
                let worst = check_layer(&of_layer(&drawing, &layer), &gear.curve, module, copies);
                assert!(worst > 0.0 && worst <= MICROMETRE, "{layer}: {worst} mm");
                layers += 1;
            }
        }
        // The others are circles, labels and the layer that every drawing has.
        assert_eq!(drawing.layers().count(), layers + 3, "{}", gearbox.name());
    }
}
