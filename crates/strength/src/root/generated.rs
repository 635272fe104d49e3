//! The second way to the critical section: the fillet as the tool leaves it, point by point.
//!
//! Points of the envelope of the tool's tip arc are laid in the gear's plane, with the tooth's centre line
//! upright. Tangents, curvature and the line of the load come from differences of neighbouring points;
//! nothing is taken from the standard's formulas.

use super::factors::form_factor;
use super::section::{RootSection, Shaper, section};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::function::{angle_of_involute, involute};
use epicyclic_gears::involute::{InvoluteGear, Profile};
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

type Point = [f64; 2];

/// Turns a point so that a centre line at an angle from the y axis becomes upright.
fn upright([x, y]: Point, angle: f64) -> Point {
    [x * libm::cos(angle) - y * libm::sin(angle), x * libm::sin(angle) + y * libm::cos(angle)]
}

/// The fillet point where the tip arc about `centre` touches it: on the normal through the pitch point.
fn touched(centre: Point, pitch: Point, radius: f64) -> Point {
    let away = [centre[0] - pitch[0], centre[1] - pitch[1]];
    let length = libm::hypot(away[0], away[1]);
    [centre[0] + radius * away[0] / length, centre[1] + radius * away[1] / length]
}

/// The fillet of a spur gear cut by a rack, at a travel of the rack.
fn by_rack(gear: &InvoluteGear, travel: f64) -> Point {
    let profile = gear.profile();
    let alpha = profile.rack.pressure_angle.si();
    let depth = profile.rack.addendum + profile.rack.clearance;
    let rho = profile.fillet;
    let radius = gear.reference_diameter() / 2.0;
    let from_middle = FRAC_PI_4
        - depth * libm::tan(alpha)
        - ((1.0 - libm::sin(alpha)) * rho - profile.protuberance) / libm::cos(alpha);
    let centre = [travel, radius - depth + rho + gear.shift()];
    let point = touched(centre, [0.0, radius], rho);
    let tooth = (travel - from_middle) / radius + PI / gear.teeth().as_f64();
    upright(point, tooth)
}

/// The fillet of a ring cut by a shaper, at an angle of the shaper's tip arc.
fn by_shaper(ring: &InvoluteGear, shaper: Shaper, angle: f64) -> Point {
    let profile = ring.profile();
    let alpha = profile.rack.pressure_angle.si();
    let depth = profile.rack.addendum + profile.rack.clearance;
    let rho = profile.fillet;
    let (z, z0) = (ring.teeth().as_f64(), f64::from(shaper.teeth));
    let sum = ring.shift() + shaper.shift;
    let working = angle_of_involute(involute(alpha) - 2.0 * libm::tan(alpha) * sum / (z - z0)).unwrap();
    let stretch = libm::cos(alpha) / libm::cos(working);
    let (distance, pitch) = ((z - z0) / 2.0 * stretch, z / 2.0 * stretch);
    // The arc touches tip circle and flank: its centre lies on the involute moved inwards by the radius.
    let base = z0 / 2.0 * libm::cos(alpha);
    let centre_radius = z0 / 2.0 + shaper.shift + depth - rho;
    let along = (centre_radius * centre_radius - base * base).sqrt();
    let half = (FRAC_PI_2 + 2.0 * shaper.shift * libm::tan(alpha)) / z0 + involute(alpha);
    let own = half - (along + rho) / base + libm::atan(along / base);
    assert!(own >= 0.0, "the shaper has no room for the arc");
    let centre = [centre_radius * libm::sin(angle), distance + centre_radius * libm::cos(angle)];
    let point = touched(centre, [0.0, pitch], rho);
    upright(point, (angle - own) * z0 / z + PI / z)
}

/// Section on a curve of points that runs from the root to the flank, by bisection on the angle between
/// tangent and centre line. The tooth points upwards, of a ring downwards.
fn on(
    curve: impl Fn(f64) -> Point,
    up: f64,
    tangent_deg: f64,
    [mut low, mut high]: [f64; 2],
) -> (Point, f64) {
    let step = 1e-5;
    let tangent = |at: f64| {
        let ([x1, y1], [x2, y2]) = (curve(at - step), curve(at + step));
        libm::atan2(x2 - x1, up * (y2 - y1)).to_degrees()
    };
    assert!(tangent(low) > tangent_deg && tangent(high) < tangent_deg, "{} {}", tangent(low), tangent(high));
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if tangent(middle) > tangent_deg {
            low = middle;
        } else {
            high = middle;
        }
    }
    let wide = 1e-3;
    let [before, here, after] = [low - wide, low, low + wide].map(&curve);
    // The circle through three points.
    let side = |a: Point, b: Point| libm::hypot(a[0] - b[0], a[1] - b[1]);
    let area = ((here[0] - before[0]) * (after[1] - before[1])
        - (here[1] - before[1]) * (after[0] - before[0]))
        / 2.0;
    let radius = side(before, here) * side(here, after) * side(after, before) / (4.0 * area.abs());
    (here, radius)
}

/// Point at which the load at a diameter crosses the centre line, and its angle, from points of the flank.
fn load(gear: &InvoluteGear, diameter: f64) -> (f64, f64) {
    let flank = |diameter: f64| {
        let angle = gear.thickness_at(diameter) / diameter;
        [diameter / 2.0 * libm::sin(angle), diameter / 2.0 * libm::cos(angle)]
    };
    let step = 1e-4;
    let ([x1, y1], [x2, y2]) = (flank(diameter - step), flank(diameter + step));
    let [x, y] = flank(diameter);
    // The normal of the flank runs to the centre line.
    let slope = -(x2 - x1) / (y2 - y1);
    (y - x * slope, libm::atan(slope).abs())
}

fn gear(kind: GearKind, teeth: u32, shift: f64, fillet: f64) -> InvoluteGear {
    let profile = Profile { fillet, ..Profile::default() };
    InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), profile, shift).unwrap()
}

fn generated(gear: &InvoluteGear, contact_ratio: f64, shaper: Option<Shaper>) -> RootSection {
    let base_pitch = PI * gear.base_diameter() / gear.teeth().as_f64();
    let to_tip = gear.curvature_radius(gear.tip_diameter());
    let (sign, (point, fillet)) = match shaper {
        None => (1.0, on(|travel| by_rack(gear, travel), 1.0, 30.0, [0.02, 4.0])),
        Some(shaper) => (-1.0, on(|angle| by_shaper(gear, shaper, angle), -1.0, 60.0, [0.01, 0.2])),
    };
    let radius = to_tip - sign * base_pitch * (contact_ratio - 1.0);
    let (crossing, load_angle_rad) = load(gear, libm::hypot(gear.base_diameter(), 2.0 * radius));
    RootSection { thickness: 2.0 * point[0].abs(), arm: (crossing - point[1]).abs(), fillet, load_angle_rad }
}

#[test]
fn the_generated_fillet_of_a_hobbed_gear_is_the_standards() {
    for (teeth, shift, contact_ratio) in
        [(18, 0.389, 1.37), (36, 0.5039, 1.618), (17, 0.0, 1.5), (60, -0.3, 1.7), (14, 0.5, 1.3)]
    {
        for protuberance in [0.0, 0.12] {
            let profile = Profile { fillet: 0.3, protuberance, ..Profile::default() };
            let gear = InvoluteGear::new(GearKind::External, ToothCount::new(teeth).unwrap(), profile, shift)
                .unwrap();
            let by_formula = section(&gear, contact_ratio, None).unwrap();
            let by_points = generated(&gear, contact_ratio, None);
            let close = |one: f64, other: f64| (one - other).abs() < 1e-5 * one.abs();
            assert!(close(by_formula.thickness, by_points.thickness), "{by_formula:?} {by_points:?}");
            assert!(close(by_formula.arm, by_points.arm), "{by_formula:?} {by_points:?}");
            assert!(
                close(by_formula.load_angle_rad, by_points.load_angle_rad),
                "{by_formula:?} {by_points:?}"
            );
            // The radius comes from second differences.
            assert!(
                (by_formula.fillet / by_points.fillet - 1.0).abs() < 1e-3,
                "{by_formula:?} {by_points:?}"
            );
        }
    }
}

/// The standard takes a virtual rack for the shaper: the true section is thicker by a hundredth, its fillet
/// sharper.
#[test]
fn the_generated_fillet_of_a_shaped_ring_is_near_the_standards() {
    for (teeth, shift, shaper) in [(93, 0.1171, 30), (72, 0.0, 20), (120, 0.2, 40)] {
        let ring = gear(GearKind::Internal, teeth, shift, 0.3);
        let shaper = Shaper { teeth: shaper, shift: 0.0 };
        let by_formula = section(&ring, 1.618, Some(shaper)).unwrap();
        let by_points = generated(&ring, 1.618, Some(shaper));
        let deviation = |one: f64, other: f64| (one / other - 1.0).abs();
        assert!(deviation(by_formula.thickness, by_points.thickness) < 0.02, "{by_formula:?} {by_points:?}");
        assert!(deviation(by_formula.arm, by_points.arm) < 0.01, "{by_formula:?} {by_points:?}");
        assert!(deviation(by_formula.load_angle_rad, by_points.load_angle_rad) < 1e-5);
        assert!(deviation(by_formula.fillet, by_points.fillet) < 0.06, "{by_formula:?} {by_points:?}");
        let alpha = 20_f64.to_radians();
        assert!(deviation(form_factor(&by_formula, alpha), form_factor(&by_points, alpha)) < 0.035);
    }
}
