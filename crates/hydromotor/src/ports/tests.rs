use super::throttling::Through;
use super::timing::AtExtreme;
use super::trapped::Extreme;
use super::*;
use crate::MotorNumbers;
use crate::centrode::tests::any_motor;
use crate::chambers::polygon_area;
use epicyclic_numerics::roots::bracketed;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::{Angle, AngularVelocity, Area, Length, MassDensity, Pressure};

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn mm2(value: f64) -> Area {
    Area::from_mm2(value)
}

fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

fn deg(value: f64) -> Angle {
    Angle::from_degrees(value)
}

pub(super) fn hole(diameter: f64, pitch_radius: f64, angle: f64) -> PortShape {
    PortShape::Hole { diameter: mm(diameter), pitch_radius: mm(pitch_radius), angle: deg(angle) }
}

fn kidney(inner: f64, outer: f64, angle: f64, span: f64, corner: f64) -> PortShape {
    let [inner_radius, outer_radius, corner] = [inner, outer, corner].map(mm);
    PortShape::Kidney { inner_radius, outer_radius, angle: deg(angle), span: deg(span), corner }
}

/// 6×4, module 0.75 mm, l 30 mm.
pub(super) fn motor() -> Motor {
    Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10).unwrap(), mm(0.75), mm(30.0)).unwrap()
}

fn inside(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crosses = |a: &[f64; 2], b: &[f64; 2]| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
    };
    polygon.iter().zip(next).filter(|(a, b)| crosses(a, b)).count() % 2 == 1
}

/// A polygon on the outline of a port.
fn polygon(port: &Port, points: u32) -> Vec<[f64; 2]> {
    let pieces = port.pieces();
    pieces.iter().flat_map(|piece| (0..points).map(|i| piece.at(f64::from(i) / f64::from(points)))).collect()
}

/// Part of a polygon within a convex one, counter-clockwise (Sutherland and Hodgman).
fn clipped(subject: &[[f64; 2]], window: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut left = subject.to_vec();
    for (a, b) in window.iter().zip(window.iter().cycle().skip(1)) {
        let side = |p: &[f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        let mut next = vec![];
        for (p, q) in left.iter().zip(left.iter().cycle().skip(1)) {
            let (at_p, at_q) = (side(p), side(q));
            if at_p >= 0.0 {
                next.push(*p);
            }
            if (at_p >= 0.0) != (at_q >= 0.0) {
                let part = at_p / (at_p - at_q);
                next.push([0, 1].map(|i| p[i] + part * (q[i] - p[i])));
            }
        }
        left = next;
    }
    left
}

fn outline_of(motor: &Motor, rotation: f64, chamber: u32, steps: u32) -> Vec<[f64; 2]> {
    let scale = motor.module().si();
    let points = motor.chamber_outline(Angle::from_si(rotation), chamber, steps).unwrap();
    points.iter().map(|p| [p.x.si() / scale, p.y.si() / scale]).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn a_hole_shares_with_a_chamber_what_clipped_polygons_do(
        motor in any_motor(), rotation in -9.0..9.0, chamber in 0..20_u32, part in 0.0..1.0, size in 0.05..1.2,
    ) {
        // About any place between the wheels, also across them; where satellites run into each other or a
        // wheel's hollow, or reach across a neighbour's ray, no chamber is bounded.
        let heights = crate::checks::ToothHeights { addendum: 0.0, dedendum: 1.0 };
        prop_assume!(motor.checks(heights).unwrap().iter().all(crate::checks::Check::holds));
        prop_assume!(rays_part_chambers(&motor).is_ok());
        let [from, to] = [0, 1].map(|i| motor.place(rotation, chamber + i).contact.theta3);
        let (crest, trough) = (motor.shape.within(By::Phase, 0.0), motor.shape.trough());
        let distance = 0.5 * (crest.rho1 + trough.rho3);
        let port = Port::Hole(size * motor.shape.satellite_radius(), distance, from + part * (to - from));
        let shared = Region::new(&motor, rotation, chamber).shared(&port);
        let polygons = |steps| polygon_area(&clipped(&outline_of(&motor, rotation, chamber, steps), &polygon(&port, steps)));
        let (coarse, fine) = (polygons(200), polygons(400));
        let extrapolated = fine + (fine - coarse) / 3.0;
        // As for the chambers' own polygons: the junction of the arcs falls between two points and reduces
        // the gain.
        prop_assert!((shared - extrapolated).abs() < 1e-4 * motor.shape.satellite_radius().powi(2), "{shared} {extrapolated}");
    }

    #[test]
    fn a_kidney_shares_with_a_chamber_what_points_of_a_grid_say(
        rotation in -9.0..9.0_f64, turn in -30.0..30.0_f64, span in 10.0..40.0, corner in 0.0..1.0, chamber in 0..10_u32,
    ) {
        let motor = motor();
        let port = Port::new(kidney(17.2, 22.0, turn, span, corner * 1.2), motor.module(), 6).unwrap();
        let [inner, outer] = port.radii();
        let walls = outline_of(&motor, rotation, chamber, 60);
        const COUNT: u32 = 160;
        let (dr, dt) = ((outer - inner) / f64::from(COUNT), deg(span).si() / f64::from(COUNT));
        for port in (0..6).map(|k| port.turned(TAU / 6.0 * f64::from(k))) {
            let outline = polygon(&port, 40);
            let mut counted = 0.0;
            for i in 0..COUNT {
                let rho = inner + dr * (f64::from(i) + 0.5);
                for j in 0..COUNT {
                    let theta = port.reach()[0] + dt * (f64::from(j) + 0.5) - deg(0.5 * span).si();
                    let point = [rho * libm::cos(theta), rho * libm::sin(theta)];
                    if inside(&walls, point) && inside(&outline, point) {
                        counted += rho * dr * dt;
                    }
                }
            }
            let shared = Region::new(&motor, rotation, chamber).shared(&port);
            // Cells on the boundary, about four rows of them, count half by chance.
            prop_assert!((shared - counted).abs() < 4e-3 * port.area(), "{shared} {counted}");
        }
    }

    #[test]
    fn a_hole_between_the_wheels_is_shared_out_among_chambers_and_satellites(rotation in -9.0..9.0, turn in -30.0..30.0, diameter in 0.2..3.9) {
        let motor = motor();
        let port = Port::new(hole(diameter, 19.64, turn), motor.module(), 6).unwrap();
        let Port::Hole(radius, distance, angle) = port else { unreachable!() };
        let r = motor.shape.satellite_radius();
        let centre = [distance * libm::cos(angle), distance * libm::sin(angle)];
        let chambers: f64 = (0..10).map(|j| Region::new(&motor, rotation, j).shared(&port)).sum();
        // The lens of two circles.
        let lens = |apart: f64| if apart >= r + radius {
            0.0
        } else if apart <= r - radius {
            PI * radius * radius
        } else {
            let [one, other] = [(radius, r), (r, radius)].map(|(a, b): (f64, f64)| {
                let x = ((apart * apart + a * a - b * b) / (2.0 * apart)).clamp(-a, a);
                a * a * libm::acos(x / a) - x * (a * a - x * x).sqrt()
            });
            one + other
        };
        let satellites: f64 = (0..10).map(|j| {
            let at = motor.place(rotation, j).centre;
            lens(libm::hypot(at[0] - centre[0], at[1] - centre[1]))
        }).sum();
        prop_assert!((chambers + satellites - PI * radius * radius).abs() < 1e-10, "{chambers} {satellites}");
    }
}

use std::f64::consts::PI;

#[test]
fn outlines_are_closed_and_have_the_ports_area() {
    let motor = motor();
    for corner in [0.0, 0.5, 1.5] {
        let port = Port::new(kidney(18.0, 21.0, -14.0, 12.0, corner), motor.module(), 6).unwrap();
        let pieces = port.pieces();
        for (one, next) in pieces.iter().zip(pieces.iter().cycle().skip(1)) {
            let (a, b) = (one.at(1.0), next.at(0.0));
            assert!(libm::hypot(a[0] - b[0], a[1] - b[1]) < 1e-12, "{corner} {one:?} {next:?}");
        }
        // By a grid in polar coordinates.
        let (mut sum, count) = (0.0, 800);
        let [inner, outer] = port.radii();
        let (dr, dt) = ((outer - inner) / f64::from(count), deg(12.0).si() / f64::from(count));
        for i in 0..count {
            let rho = inner + dr * (f64::from(i) + 0.5);
            for j in 0..count {
                let theta = deg(-20.0).si() + dt * (f64::from(j) + 0.5);
                if port.contains([rho * libm::cos(theta), rho * libm::sin(theta)]) {
                    sum += rho * dr * dt;
                }
            }
        }
        assert!((sum / port.area() - 1.0).abs() < 2e-4, "{corner}: {sum} {}", port.area());
    }
    let plate = PortPlate::new(&motor, kidney(18.0, 21.0, -14.0, 12.0, 1.5), hole(4.0, 19.7, 15.0)).unwrap();
    let outlines = plate.outlines();
    assert_eq!(outlines.len(), 12);
    // Round ends: two straight sides of no length are left out.
    assert_eq!(outlines[0].vertices.len(), 6);
    assert_eq!(outlines[1].vertices.len(), 2);
    assert_eq!(outlines[1].vertices[0].bulge, libm::tan(PI / 4.0));
}

#[test]
fn the_chambers_at_their_extremes_are_those_of_differences() {
    // A'' as computed apart: -170.1 and 156.7 mm². The areas are those of the polygons of crate::chambers.
    let [least, greatest] = motor().extremes_of_chambers();
    assert!((greatest.bend.mm2() + 170.1).abs() < 0.05);
    assert!((least.bend.mm2() - 156.7).abs() < 0.05);
    assert!((greatest.area.mm2() - 80.37).abs() < 5e-3);
    assert!((least.area.mm2() - 26.51).abs() < 5e-3);
    for (extreme, rotation) in [(greatest, -PI / 4.0), (least, PI / 6.0)] {
        let area = |steps, rotation| polygon_area(&outline_of(&motor(), rotation, 0, steps)) * 0.5625;
        let exact = |rotation| area(4000, rotation) + (area(4000, rotation) - area(2000, rotation)) / 3.0;
        assert!((exact(rotation) - extreme.area.mm2()).abs() < 1e-3);
        let h = 2e-2;
        let bend = (exact(rotation + h) + exact(rotation - h) - 2.0 * exact(rotation)) / (h * h);
        assert!((bend / extreme.bend.mm2() - 1.0).abs() < 1e-2, "{bend}");
    }
}

#[test]
fn trapped_pressures_and_angles_are_those_computed_apart() {
    let modulus = mpa(1400.0);
    let at = |area, bend| Extreme { area: mm2(area), bend: mm2(bend) };
    let trapped = |extreme: Extreme| extreme.trapped_pressure(deg(1.38), modulus, mm2(0.0)).unwrap().mpa();
    let alone =
        |extreme: Extreme| extreme.precompression_angle(mpa(25.0), modulus, mm2(0.0)).unwrap().degrees();
    // With the areas of that computation, 80.43 and 27.84 mm².
    assert!((trapped(at(80.43, -170.1)) - 0.86).abs() < 5e-3);
    assert!((trapped(at(27.84, 156.7)) - 2.3).abs() < 0.05);
    assert!((alone(at(27.84, 156.7)) - 4.6).abs() < 0.05);
    // With the motor's own, 80.37 and 26.51 mm².
    let [least, greatest] = motor().extremes_of_chambers();
    assert!((trapped(greatest) - 0.86).abs() < 5e-3);
    assert!((trapped(least) - 2.40).abs() < 5e-3);
    assert!((alone(least) - 4.45).abs() < 5e-3);
    // The angle and the pressure are each other's inverse, with any dead volume.
    let dead = mm2(12.0);
    let closed = least.precompression_angle(mpa(3.0), modulus, dead).unwrap();
    let back = least.trapped_pressure(closed, modulus, dead).unwrap();
    assert!((back.mpa() - 3.0).abs() < 1e-12);
    assert!(closed > least.precompression_angle(mpa(3.0), modulus, mm2(0.0)).unwrap());
    assert!(least.trapped_pressure(deg(-1.0), modulus, dead).is_err());
    assert!(least.trapped_pressure(deg(1.0), mpa(0.0), dead).is_err());
    assert!(least.trapped_pressure(deg(1.0), modulus, mm2(-1.0)).is_err());
    assert!(at(0.0, 1.0).trapped_pressure(deg(1.0), modulus, dead).is_err());
    assert!(at(1.0, 0.0).precompression_angle(mpa(1.0), modulus, dead).is_err());
}

#[test]
fn the_dead_volume_takes_about_a_hundredth_of_the_displacement() {
    let motor = motor();
    let q = motor.displacement(mm(25.0)).unwrap();
    let charge =
        |dead: f64| motor.dead_volume_charge(mm(25.0), mpa(25.0), mpa(1400.0), mm2(dead)).unwrap() / q;
    // 24·26.513·25/1400 over 1292.617; with a least area of 27.84 it is the .92 % computed apart.
    assert!((charge(0.0).value - 0.00879).abs() < 5e-6);
    assert!((charge(27.84 - 26.513).value - 0.0092).abs() < 5e-5);
    assert!(motor.dead_volume_charge(mm(0.0), mpa(25.0), mpa(1400.0), mm2(0.0)).is_err());
    assert!(motor.dead_volume_charge(mm(1.0), mpa(f64::NAN), mpa(1400.0), mm2(0.0)).is_err());
}

#[test]
fn greatest_ideal_holes_never_close_a_chamber_nor_join_the_pressures() {
    let plate = PortPlate::of_ideal_holes(&motor(), 1.0).unwrap();
    let timing = plate.timing().unwrap();
    assert_eq!((timing.short_circuits.len(), timing.closed.len()), (0, 0), "{timing:?}");
    assert!((timing.cycle.degrees() - 150.0).abs() < 1e-9);
    let [high, low] = [&timing.high, &timing.low].map(|all| {
        assert_eq!(all.len(), 1);
        [all[0].from.degrees(), all[0].to.degrees()]
    });
    // High while it grows, low while it shrinks.
    assert!((high[0] + 75.0).abs() < 1e-3 && high[1].abs() < 1e-3, "{high:?}");
    assert!(low[0].abs() < 1e-3 && (low[1] - 75.0).abs() < 1e-3, "{low:?}");
}

#[test]
fn a_smaller_hole_closes_where_a_satellite_just_covers_it() {
    let motor = motor();
    let plate = PortPlate::of_ideal_holes(&motor, 0.9).unwrap();
    let timing = plate.timing().unwrap();
    assert_eq!(timing.closed.len(), 2);
    // By distance: a satellite covers the hole while their centres are nearer than the difference of the
    // radii.
    let Port::Hole(radius, distance, angle) = plate.ports[0] else { unreachable!() };
    let r = motor.shape.satellite_radius();
    let off = |phase: f64| {
        let [x, y] = motor.place_at(phase).centre;
        libm::hypot(x - distance * libm::cos(angle), y - distance * libm::sin(angle)) - (r - radius)
    };
    // The front satellite covers it before the chamber behind is greatest, while it runs from -π/n to -π/N.
    let (early, late) = (-PI / 4.0, -PI / 6.0);
    let (covers, frees) =
        (bracketed(early - 0.2, 0.5 * (early + late), off), bracketed(0.5 * (early + late), late + 0.2, off));
    // It uncovers the hole to the chamber in front, of phase Φ + π/n ... and the one behind, of Φ − π/n.
    let high = timing.high[0];
    let opens = frees - PI / 4.0;
    let closes = covers + PI / 4.0;
    let cycle = timing.cycle.si();
    let near = |a: f64, b: f64| {
        let off = (a - b).rem_euclid(cycle);
        off.min(cycle - off) < 1e-6
    };
    let (from, to) = (high.from.si(), high.to.si());
    assert!(
        (near(from, opens) && near(to, closes))
            || (near(from, frees + PI / 4.0) && near(to, covers - PI / 4.0))
            || (near(from, covers + PI / 4.0) || near(to, frees - PI / 4.0)),
        "{from} {to} {opens} {closes} {covers} {frees}"
    );
    for closed in &timing.closed {
        // Mirrored ports close as long before as after.
        assert!((closed.before - closed.after).abs() < Angle::from_degrees(1e-4), "{closed:?}");
    }
    let trapped = plate.trapped(&timing, mpa(1400.0), mm2(0.0)).unwrap();
    let extremes = motor.extremes_of_chambers();
    for (trapped, closed) in trapped.iter().zip(&timing.closed) {
        let (extreme, sign) = match trapped.extreme.unwrap() {
            AtExtreme::Least => (extremes[0], 1.0),
            AtExtreme::Greatest => (extremes[1], -1.0),
        };
        // The parabola against the exact area: third order in a few degrees.
        let parabola = sign * extreme.trapped_pressure(closed.before, mpa(1400.0), mm2(0.0)).unwrap();
        assert!((trapped.change / parabola).value - 1.0 < 0.02, "{trapped:?} {parabola:?}");
        assert!((trapped.change / parabola).value - 1.0 > -0.02, "{trapped:?} {parabola:?}");
    }
}

#[test]
fn a_hole_too_large_joins_both_pressures() {
    let plate = PortPlate::new(&motor(), hole(5.6, 19.66, -15.12), hole(5.0, 19.66, 15.12)).unwrap();
    let timing = plate.timing().unwrap();
    // About both extremes, and where the hole shows in front of a satellite beside the rotor.
    assert!(timing.short_circuits.len() == 3 && timing.closed.is_empty(), "{timing:?}");
    for stretch in &timing.short_circuits {
        // Both are open there, by points of a grid in the polygons of port and chamber.
        let middle = 0.5 * (stretch.from + stretch.to);
        let walls = outline_of(&plate.motor, plate.rotation_of(3, middle).si(), 3, 2000);
        for side in SIDES {
            let seen = (0..6).any(|crest| {
                polygon(&plate.port(side, crest), 2000).iter().any(|&point| inside(&walls, point))
            });
            assert!(seen, "{stretch:?} {side}");
        }
    }
}

#[test]
fn openings_are_those_of_the_phase() {
    let plate =
        PortPlate::new(&motor(), kidney(17.5, 21.5, -14.0, 12.0, 0.5), hole(4.0, 19.7, 15.0)).unwrap();
    for (chamber, phase) in [(0, -0.6), (4, 0.2), (9, 0.7)] {
        let phase = Angle::from_si(phase);
        let open = plate.openings(plate.rotation_of(chamber, phase)).unwrap();
        for side in SIDES {
            let of_chamber = open.iter().filter(|open| open.chamber == chamber && open.side == side);
            let sum: f64 = of_chamber.map(|open| open.area.si()).sum();
            let single = plate.opening_at(side, phase).unwrap().si();
            assert!((sum - single).abs() < 1e-15, "{sum} {single}");
        }
    }
    assert!(
        plate.openings(Angle::from_si(f64::NAN)).is_err()
            && plate.opening_at(PortSide::Low, Angle::from_si(f64::NAN)).is_err()
    );
    // From the hole's centre across to the kidney's end at -8°, less the hole's radius.
    let land = 19.7 * libm::sin(deg(23.0).si()) - 2.0;
    assert!((plate.land().mm() - land).abs() < 1e-12);
}

#[test]
fn the_drop_grows_with_the_square_of_speed_and_falls_with_that_of_the_coefficient() {
    let plate = PortPlate::of_ideal_holes(&motor(), 0.95).unwrap();
    let through = |speed, discharge| Through {
        width: mm(25.0),
        speed: AngularVelocity::from_si(speed),
        density: MassDensity::from_si(870.0),
        discharge,
    };
    let throttling = |speed, discharge| plate.throttling(PortSide::High, through(speed, discharge)).unwrap();
    let one = throttling(20.0, 0.6);
    // By hand from the openings at the rotation named.
    let open = plate.openings(one.rotation).unwrap();
    let sum: f64 = open.iter().filter(|open| open.side == PortSide::High).map(|open| open.area.si()).sum();
    let flow = motor().flow_per_width(one.rotation).unwrap().si() * 0.025 * 20.0;
    let drop = 0.5 * 870.0 * (flow / (0.6 * sum)).powi(2);
    assert!((one.drop.value / drop - 1.0).abs() < 1e-12 && one.greatest_drop >= one.drop);
    assert!((one.smallest_opening.si() / sum - 1.0).abs() < 1e-12);
    assert!(((throttling(40.0, 0.6).power / one.power).value - 8.0).abs() < 1e-9);
    assert!(((throttling(20.0, 0.3).greatest_drop / one.greatest_drop).value - 4.0).abs() < 1e-9);
    for bad in [
        through(0.0, 0.6),
        through(1.0, 0.0),
        through(1.0, 1.1),
        Through { width: mm(0.0), ..through(1.0, 0.6) },
    ] {
        assert!(plate.throttling(PortSide::Low, bad).is_err());
    }
}

#[test]
fn bad_ports_are_refused() {
    let numbers = MotorNumbers::new(2, 1, 92, 8).unwrap();
    let arcs = crate::closure::arcs_at(numbers, mm(1.0), mm(36.516_425)).unwrap();
    let steep = Motor::of_closed_arcs(numbers, arcs);
    let port = hole(1.0, 22.0, -40.0);
    let refusal = PortPlate::new(&steep, port, port.mirrored()).unwrap_err();
    assert!(
        matches!(refusal, Error::SteepCentrode { slope_deg, most_deg: 45.0 } if slope_deg > 45.0),
        "{refusal}"
    );
    let motor = motor();
    let good = hole(4.0, 19.7, 15.0);
    let error = |shape| PortPlate::new(&motor, shape, good).unwrap_err();
    let named = |error: &Error, quantity| match *error {
        Error::NotPositive { quantity: own, .. }
        | Error::NotFinite { quantity: own, .. }
        | Error::OutOfRange { quantity: own, .. } => own == quantity,
        _ => false,
    };
    for (shape, quantity) in [
        (hole(0.0, 19.7, -15.0), Quantity::HoleDiameter),
        (hole(4.0, f64::NAN, -15.0), Quantity::PitchCircleRadius),
        (hole(4.0, 19.7, f64::INFINITY), Quantity::PortAngle),
        (kidney(0.0, 21.0, -15.0, 10.0, 0.0), Quantity::KidneyInnerRadius),
        (kidney(18.0, 17.0, -15.0, 10.0, 0.0), Quantity::KidneyOuterRadius),
        (kidney(18.0, f64::NAN, -15.0, 10.0, 0.0), Quantity::KidneyOuterRadius),
        (kidney(18.0, 21.0, f64::NAN, 10.0, 0.0), Quantity::PortAngle),
        (kidney(18.0, 21.0, -15.0, 0.0, 0.0), Quantity::KidneySpan),
        (kidney(18.0, 21.0, -15.0, 60.0, 0.0), Quantity::KidneySpan),
        (kidney(18.0, 21.0, -15.0, f64::NAN, 0.0), Quantity::KidneySpan),
        (kidney(18.0, 21.0, -15.0, 10.0, 1.6), Quantity::KidneyCorner),
        (kidney(18.0, 21.0, -15.0, 2.0, 1.0), Quantity::KidneyCorner),
        (kidney(18.0, 21.0, -15.0, 10.0, -0.1), Quantity::KidneyCorner),
        (kidney(18.0, 21.0, -15.0, 10.0, f64::NAN), Quantity::KidneyCorner),
    ] {
        let error = error(shape);
        assert!(named(&error, quantity), "{shape:?} {error}");
    }
    assert!(matches!(error(hole(4.0, 40.0, -15.0)), Error::PortOutside { .. }));
    assert!(matches!(error(hole(4.0, 10.0, -15.0)), Error::PortOutside { .. }));
    assert_eq!(error(hole(4.0, 19.7, 14.0)), Error::PortsOverlap);
    assert_eq!(error(hole(0.5, 19.7, 15.0)), Error::PortsOverlap);
    assert!(PortPlate::of_ideal_holes(&motor, 1.1).is_err());
    let timing = |high| PortPlate::new(&motor, high, good).unwrap().timing().unwrap_err();
    // In the stator, outside its trough.
    let covered = timing(hole(0.2, 22.5, -30.0));
    assert!(matches!(covered, Error::PortNeverOpens { side: PortSide::High, .. }), "{covered}");
    let open = timing(kidney(16.0, 24.0, 45.0, 48.0, 0.0));
    assert!(matches!(open, Error::PortNeverCloses { .. }), "{open}");
}
