use super::*;
use crate::centrode::tests::any_motor;
use crate::checks::{Check, ToothHeights};
use crate::contact::By;
use crate::ports::outline::Port;
use crate::ports::tests::{hole, motor};
use crate::ports::{PortShape, land, rays_part_chambers};
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::Angle;

/// Holes and kidneys about the ideal places of a motor, from too small to too large.
fn any_shape() -> impl Strategy<Value = [f64; 6]> {
    [0.2..1.4, -0.3..0.3, -0.5..0.5, 0.2..0.9, 0.0..1.0, 0.0..1.0]
}

fn shape(motor: &crate::Motor, side: PortSide, [size, out, turn, span, corner, kind]: [f64; 6]) -> PortShape {
    let ideal = motor.ports();
    let port = [ideal.high[0], ideal.low[0]][of(side)];
    let diameter = (size * port.greatest_diameter).max(0.1 * motor.satellite_radius());
    let (pitch_radius, angle) =
        (port.centre_radius + out * diameter, port.angle + Angle::from_si(turn * 0.1));
    if kind < 0.5 {
        return PortShape::Hole { diameter, pitch_radius, angle };
    }
    let inner_radius = pitch_radius - 0.5 * diameter;
    let span = span * 3.0 / f64::from(motor.numbers().stator_lobes()) * Angle::from_degrees(60.0);
    let most = (0.5 * diameter).min(0.3 * libm::sin(0.5 * span.si()) * inner_radius);
    PortShape::Kidney {
        inner_radius,
        outer_radius: pitch_radius + 0.5 * diameter,
        angle,
        span,
        corner: corner * most,
    }
}

fn is_in(stretches: &[Stretch], phase: f64, cycle: f64) -> bool {
    stretches.iter().any(|stretch| {
        let (from, to) = (stretch.from.si(), stretch.to.si());
        (phase - from).rem_euclid(cycle) < to - from
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// An opening that brute force finds at thousands of phases, and the timing does not, is shorter than
    /// promised.
    #[test]
    fn nothing_that_lasts_is_missed(motor in any_motor(), high in any_shape(), low in any_shape(), offset in 0.0..1.0) {
        let heights = ToothHeights { addendum: 0.0, dedendum: 1.0 };
        prop_assume!(motor.checks(heights).unwrap().iter().all(Check::holds) && rays_part_chambers(&motor).is_ok());
        let [high, low] = [(PortSide::High, high), (PortSide::Low, low)].map(|(side, of)| shape(&motor, side, of));
        let Ok(plate) = PortPlate::new(&motor, high, low) else { return Err(TestCaseError::reject("no such ports")) };
        let timing = plate.timing();
        let cycle = 2.0 * motor.shape.trough().phase;
        const COUNT: u32 = 1500;
        for side in SIDES {
            let least = OPEN * plate.ports[of(side)].area();
            let stretches = match (&timing, side) {
                (Ok(timing), PortSide::High) => timing.high.clone(),
                (Ok(timing), PortSide::Low) => timing.low.clone(),
                // Named for the pressure that never opens, or never closes.
                (Err(Error::PortNeverOpens { side: named, .. }), _) if *named == side => vec![],
                (Err(Error::PortNeverCloses { side: named, .. }), _) if *named == side => {
                    vec![Stretch { from: Angle::from_si(0.0), to: Angle::from_si(2.0 * cycle) }]
                }
                (Err(Error::PortNeverOpens { .. } | Error::PortNeverCloses { .. }), _) => continue,
                (Err(error), _) => panic!("{error}"),
            };
            let is_other = |phase: f64| (plate.opening(side, phase) > least) != is_in(&stretches, phase, cycle);
            for i in 0..COUNT {
                let phase = cycle * ((f64::from(i) + offset) / f64::from(COUNT) - 0.5);
                // A state that lasts for longer reaches half as far to one side at least.
                let lasts = is_other(phase) && [-0.5, 0.5].iter().any(|part| is_other(phase + part * SHORTEST));
                prop_assert!(!lasts, "{side} {phase} {stretches:?}");
            }
        }
    }

    #[test]
    fn the_land_is_that_between_many_points(high in any_shape(), low in any_shape()) {
        let motor = motor();
        let [one, other] = [(PortSide::High, high), (PortSide::Low, low)]
            .map(|(side, of)| Port::new(shape(&motor, side, of), motor.module(), 6));
        let (Ok(one), Ok(other)) = (one, other) else { return Err(TestCaseError::reject("no such ports")) };
        const COUNT: u32 = 400;
        let points = |port: &Port| -> Vec<[f64; 2]> {
            let pieces = port.pieces();
            pieces.iter().flat_map(|piece| (0..COUNT).map(|i| piece.at(f64::from(i) / f64::from(COUNT)))).collect()
        };
        let (of_one, of_other) = (points(&one), points(&other));
        let exact = land::between(&one, &other);
        let inside = of_one.iter().any(|&point| other.contains(point)) || of_other.iter().any(|&point| one.contains(point));
        let nearest = of_one.iter().flat_map(|a| of_other.iter().map(move |b| libm::hypot(a[0] - b[0], a[1] - b[1])));
        let seen = if inside { 0.0 } else { nearest.fold(f64::INFINITY, f64::min) };
        let step = |port: &Port| port.pieces().iter().fold(0.0, |most: f64, piece| most.max(piece.length())) / f64::from(COUNT);
        prop_assert!(exact <= seen + 1e-12 && seen <= exact + step(&one) + step(&other), "{exact} {seen}");
    }
}

/// A third short circuit, where a hole shows in front of a satellite beside the rotor, begins with some size
/// of the hole. It is found while it is shorter than a step of 360 phases.
#[test]
fn a_short_circuit_that_has_just_begun_is_found() {
    let motor = motor();
    let short = |diameter: f64| -> Vec<f64> {
        let plate = PortPlate::new(&motor, hole(diameter, 19.66, -15.12), hole(5.0, 19.66, 15.12)).unwrap();
        let timing = plate.timing().unwrap();
        timing.short_circuits.iter().map(|stretch| (stretch.to - stretch.from).si()).collect()
    };
    let (mut without, mut with) = (5.2, 5.6);
    assert_eq!(short(with).len(), 3);
    for _ in 0..12 {
        let middle = 0.5 * (without + with);
        if short(middle).len() > 2 { with = middle } else { without = middle }
    }
    let least = short(with).into_iter().fold(f64::INFINITY, f64::min);
    assert!(least < 2.0 * motor.shape.trough().phase / 1000.0, "{least}");
}

/// A hole outside the stator that reaches over the edge by less than the places of its outline are apart.
#[test]
fn a_sliver_beside_a_wall_is_seen() {
    let motor = motor();
    let half = motor.shape.trough().phase;
    let region = Region::new(&motor, half - 0.5 * motor.chamber_phase(), 0);
    let [from, to] = region.ends();
    let middle = 0.5 * (from + to);
    for (over, turn) in [(1e-3, 0.0), (1e-3, 0.013), (1e-4, 0.007), (0.02, 0.003)] {
        let radius = 2.0;
        let at = motor.shape.at(By::StatorAngle, middle + turn).rho3;
        let distance = at + radius - over;
        let port = Port::Hole(radius, distance, middle + turn);
        let seen = region.shared(&port);
        const COUNT: u32 = 200_000;
        let reach = 0.9 * libm::asin(radius / distance);
        let step = 2.0 * reach / f64::from(COUNT);
        let expected: f64 = (0..COUNT)
            .map(|i| {
                let off = step * (f64::from(i) + 0.5) - reach;
                let wall = motor.shape.at(By::StatorAngle, middle + turn + off).rho3;
                let foot = distance * libm::cos(off);
                let across = distance * libm::sin(off);
                let edge = foot - (radius * radius - across * across).max(0.0).sqrt();
                0.5 * (wall * wall - edge * edge).max(0.0) * step
            })
            .sum();
        assert!(
            expected > 0.0 && (seen / expected - 1.0).abs() < 1e-4,
            "{over} {turn}: {seen:e} {expected:e}"
        );
    }
}
