use super::*;
use crate::numbers::Bounds;
use epicyclic_units::Physical;
use proptest::prelude::*;
use std::sync::LazyLock;
use uom::si::f64::Length;

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn family(n3: u32, n1: u32, z3: u32, zs: u32) -> Family {
    Family::new(MotorNumbers::new(n3, n1, z3, zs).unwrap(), mm(1.0)).unwrap()
}

#[test]
fn the_vectors_of_the_source_close() {
    let vectors = [
        (family(5, 3, 55, 10), 40.0, 15.306_310_08, 16.103_796_1, 12.941_649_9),
        (family(5, 3, 55, 10), 30.0, 13.825_567_97, 6.293_931_0, 14.200_926_0),
        (family(6, 4, 66, 10), 40.0, 18.996_754_05, 10.984_516_9, 14.407_271_8),
    ];
    for (family, l, a, r1, r2) in vectors {
        let arcs = family.at(mm(l)).unwrap().arcs;
        assert!((arcs.a - a).abs() < 5e-9 && (arcs.r1 - r1).abs() < 5e-8 && (arcs.r2 - r2).abs() < 5e-8);
    }
}

#[test]
fn the_ends_of_the_family_are_where_it_says() {
    let five = family(5, 3, 55, 10);
    let [interval] = five.intervals() else { panic!("one interval") };
    let arcs = |end: &End| end.arcs().unwrap().arcs;
    let (lower, upper) = (arcs(&interval.lower), arcs(&interval.upper));
    assert!(lower.r1 == 0.0 && interval.lower.limit == Limit::NoTroughArc);
    assert!(least_stretch(&upper, 5.0).abs() < 1e-9 && interval.upper.limit == Limit::RotorCusp);
    for (end, inward) in [(lower.l, 1e-9), (upper.l, -1e-9)] {
        assert!(five.at(mm(end * (1.0 + inward))).is_ok());
        let beyond = mm(end * (1.0 - inward));
        let refused = five.at(beyond).unwrap_err();
        assert!(
            matches!(&refused, Error::OutsideFamily { intervals_mm, .. } if intervals_mm == &[(lower.l, upper.l)])
        );
        assert_eq!(arcs_at(five.numbers(), mm(1.0), beyond).unwrap_err(), refused);
    }
}

#[test]
fn a_family_can_go_on_to_the_greatest_radius_of_a_machine() {
    let flat = family(3, 2, 45, 7);
    let upper = flat.intervals()[0].upper;
    // 100 · 45/2 modules.
    assert_eq!(upper.limit, Limit::GreatestRadius);
    assert!((upper.arcs().unwrap().arcs.l - 2250.0).abs() < 1e-9);
    assert!(flat.at(mm(2249.9)).is_ok() && arcs_at(flat.numbers(), mm(1.0), mm(2249.9)).is_ok());
    for l in [2250.1, 1e8] {
        let message = flat.at(mm(l)).unwrap_err().to_string();
        assert!(message.ends_with(" to 2250.000000 mm"), "{message}");
        assert_eq!(arcs_at(flat.numbers(), mm(1.0), mm(l)).unwrap_err().to_string(), message);
    }
}

#[test]
fn a_family_can_have_a_gap() {
    let family = family(3, 1, 108, 13);
    let limits: Vec<_> =
        family.intervals().iter().map(|interval| (interval.lower.limit, interval.upper.limit)).collect();
    let wanted = [(Limit::NoTroughArc, Limit::RadialFlank), (Limit::RadialFlank, Limit::RotorCusp)];
    assert_eq!(limits, wanted);
    let radial = family.intervals()[0].upper.arcs().unwrap().arcs;
    assert!(flank(&radial, 6.5).abs() < 1e-9);
    assert!(family.at(mm(40.0)).is_ok() && family.at(mm(46.0)).is_err() && family.at(mm(52.0)).is_ok());
    assert!(family.at(mm(46.0)).unwrap_err().to_string().contains(" mm or from "));
}

#[test]
fn numbers_without_a_family_are_refused() {
    let numbers = MotorNumbers::new(5, 3, 55, 3).unwrap();
    assert!(matches!(Family::new(numbers, mm(1.0)), Err(Error::NoFamily { .. })));
    assert!(matches!(Family::new(numbers, mm(0.0)), Err(Error::NotPositive { .. })));
    assert!(five_at_part(0.0).is_err() && five_at_part(1.0).is_err() && five_at_part(f64::NAN).is_err());
}

fn five_at_part(part: f64) -> Result<StatorArcs, Error> {
    family(5, 3, 55, 10).at_part(part)
}

/// The claim that brackets every root: on a grid over all shapes, the rotor's half-lobe widens with `a`.
#[test]
fn the_residual_rises_with_the_crest_distance() {
    let mut evaluated = 0;
    let mut least = f64::INFINITY;
    for lobes in 2..=10_u32 {
        let theta3 = PI / f64::from(lobes);
        // In units of the stator's mean radius: 2πR/(2N) = θ₃.
        let half_length = theta3;
        // 2r is at most the gap of the round motor with the greatest difference of lobes.
        let widest = f64::from((lobes - 1).min(3)) / f64::from(lobes) / 2.0;
        for size in 1..=24 {
            let r = widest * f64::from(size) / 24.0;
            for flat in 0..=40 {
                // 1/l from nearly 0 to 1/(2r), beyond which the rotor has no least radius.
                let l = (1e-4 + (0.5 / r - 1e-4) * f64::from(flat) / 40.0).recip();
                let top = half_length / libm::sin(theta3);
                for part in 1..120 {
                    let a = top * f64::from(part) / 120.0;
                    let arcs = Arcs::of_distances(theta3, half_length, l, a);
                    if arcs.r1 <= 0.0 || arcs.r2 <= r || arcs.least <= 2.0 * r {
                        continue;
                    }
                    let by_l = Dual { value: l, by_l: 1.0, by_a: 0.0 };
                    let by_a = Dual { value: a, by_l: 0.0, by_a: 1.0 };
                    let span = rotor_span(&Arcs::of_distances(theta3, half_length, by_l, by_a), r);
                    evaluated += 1;
                    least = least.min(span.by_a / a);
                    assert!(span.by_a > 0.0, "N {lobes}, r {r}, l {l}, a {a}: {}", span.by_a);
                }
            }
        }
    }
    assert!(evaluated > 100_000, "{evaluated}, least {least}");
}

/// Every admissible set of the default bounds: the family by its ends and the family by a scan that knows no
/// monotonicity are the same.
#[test]
fn a_scan_finds_the_same_roots_and_no_others() {
    let sets = Bounds::default().all().unwrap();
    let mut families = 0;
    for numbers in sets.iter().step_by(7) {
        let kernel = Kernel::of(*numbers);
        let family = Family::new(*numbers, mm(1.0)).ok();
        families += usize::from(family.is_some());
        let mean = f64::from(numbers.stator_teeth()) / 2.0;
        for step in 1..40 {
            let l = 2.2 * mean / f64::from(step) * 4.0;
            let top = kernel.half_length / libm::sin(kernel.theta3);
            let at = |i: u32| top * f64::from(i) / 400.0;
            let residual = |a: f64| {
                let arcs = kernel.arcs(l, a);
                let valid = arcs.r1 > 0.0 && arcs.r2 > kernel.r && arcs.least > 2.0 * kernel.r;
                if valid { rotor_span(&arcs, kernel.r) - kernel.wanted } else { f64::NAN }
            };
            let roots: Vec<f64> = (0..400)
                .filter(|&i| residual(at(i)) * residual(at(i + 1)) < 0.0)
                .map(|i| bracketed(at(i), at(i + 1), residual))
                .filter(|&a| kernel.is_regular(&kernel.arcs(l, a)))
                .collect();
            let known = family.as_ref().and_then(|family| family.at(mm(l)).ok()).map(|arcs| arcs.arcs.a);
            // Within a step of the domain's edge the scan sees no sign change.
            let near_edge = known
                .is_some_and(|a| residual(a - top / 400.0).is_nan() || residual(a + top / 400.0).is_nan());
            assert!(roots.len() <= 1, "{numbers:?} {l}: {roots:?}");
            match (known, roots.first()) {
                (Some(known), Some(root)) => assert!((known - root).abs() < 1e-9 * mean),
                (Some(_), None) => assert!(near_edge, "{numbers:?} at {l}: the scan misses {known:?}"),
                (None, Some(root)) => panic!("{numbers:?}: the family misses a = {root} at l = {l}"),
                (None, None) => {}
            }
        }
    }
    assert!(families > 100, "{families} of {}", sets.len() / 7);
}

/// Along the family `a` and `R₁` grow with `l` and the rotor's crest sharpens, in every set of the default
/// bounds.
#[test]
fn a_family_is_ordered_by_its_distance() {
    for numbers in Bounds::default().all().unwrap().iter().step_by(5) {
        let Ok(family) = Family::new(*numbers, mm(1.0)) else { continue };
        let r = f64::from(numbers.satellite_teeth()) / 2.0;
        let shape = |part: f64| {
            let arcs = family.at_part(part).unwrap().arcs;
            (arcs.r1, arcs.a, -least_stretch(&arcs, r))
        };
        let shapes: Vec<_> = (1..32).map(|i| shape(f64::from(i) / 32.0)).collect();
        let regular =
            |i: u32| Kernel::of(*numbers).is_regular(&family.at_part(f64::from(i) / 32.0).unwrap().arcs);
        assert!((1..32).all(regular), "{numbers:?}");
        for pair in shapes.windows(2) {
            assert!(pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1 && pair[0].2 < pair[1].2, "{numbers:?}");
        }
    }
}

/// The place found is as close to the least as a parabola allows, or anywhere below 0.
#[test]
fn what_falls_and_then_rises_is_lowest_at_its_bottom() {
    for (low, high) in [(0.0, 1.0), (-3.0, 5.0), (1e-9, 2e-3)] {
        for share in [0.0, 0.02, 0.31, 0.5, 0.77, 0.99, 1.0] {
            let bottom: f64 = low + share * (high - low);
            let parabola = |x: f64| 1.0 + ((x - bottom) / (high - low)).powi(2);
            let found = super::lowest(low, high, parabola);
            assert!((found - bottom).abs() < 1e-7 * (high - low), "{bottom}: {found}");
            let steep = |x: f64| if x < bottom { 9.0 * (bottom - x) } else { 0.1 * (x - bottom) };
            let found = super::lowest(low, high, |x| 1.0 + steep(x));
            assert!((found - bottom).abs() < 1e-7 * (high - low), "{bottom}: {found}");
            let found = super::lowest(low, high, |x| parabola(x) - 1.001);
            assert!(parabola(found) < 1.001, "{bottom}: {found}");
        }
    }
}

#[test]
fn both_branches_of_the_integral_occur() {
    // K < |M| on arc 2 for 0 < R₂ − a < 2r, K > |M| beyond either end.
    let arcs = family(5, 3, 55, 10).at(mm(30.0)).unwrap().arcs;
    assert!(arcs.r2 > arcs.a && arcs.r2 < arcs.a + 10.0);
    let arcs = family(5, 3, 55, 10).at(mm(40.0)).unwrap().arcs;
    assert!(arcs.r2 < arcs.a);
}

/// Numbers with a family, found once for all tests: most tests take less time than this search.
static WITH_A_FAMILY: LazyLock<Vec<MotorNumbers>> = LazyLock::new(|| {
    let all = Bounds::default().all().unwrap().into_iter();
    all.filter(|numbers| Family::new(*numbers, mm(1.0)).is_ok()).collect()
});

/// Random numbers with a family, and a part of it.
pub(crate) fn any_motor() -> impl Strategy<Value = (MotorNumbers, f64)> {
    (proptest::sample::select(WITH_A_FAMILY.as_slice()), 0.01..0.99)
}

proptest! {
    #[test]
    fn every_motor_closes(motor in any_motor(), module in 0.3..20.0) {
        let (numbers, part) = motor;
        let family = Family::new(numbers, mm(module)).unwrap();
        let arcs = family.at_part(part).unwrap();
        let closure = closure(numbers, &arcs).unwrap();
        prop_assert!(closure.residual_rad.abs() <= 1e-12, "{:e}", closure.residual_rad);
        prop_assert!(closure.residual_by_quadrature_rad.abs() <= 1e-11, "{:e}", closure.residual_by_quadrature_rad);
        let direct = arcs_at(numbers, mm(module), arcs.trough_distance()).unwrap();
        prop_assert_eq!(direct, arcs);
    }

    #[test]
    fn either_distance_names_the_motor(motor in any_motor(), module in 0.3..20.0) {
        let family = Family::new(motor.0, mm(module)).unwrap();
        let arcs = family.at_part(motor.1).unwrap();
        let back = family.at_crest_distance(arcs.crest_distance()).unwrap();
        // As arc 1 becomes straight, a hardly changes with l.
        prop_assert!((back.arcs.a - arcs.arcs.a).abs() < 1e-9 * arcs.arcs.a, "{:e}", back.arcs.a - arcs.arcs.a);
        prop_assert!((back.arcs.l.recip() - arcs.arcs.l.recip()).abs() < 1e-6 * family.intervals()[0].lower.inverse());
        let refused = family.at_crest_distance(arcs.crest_distance() * 1e3);
        let named = matches!(refused, Err(Error::OutsideFamilyByCrest { intervals_mm, .. }) if !intervals_mm.is_empty());
        prop_assert!(named);
    }

    #[test]
    fn the_sensitivity_is_that_of_differences(motor in any_motor()) {
        let (numbers, part) = motor;
        let arcs = Family::new(numbers, mm(1.0)).unwrap().at_part(part.min(0.9)).unwrap();
        let found = closure(numbers, &arcs).unwrap();
        let kernel = Kernel::of(numbers);
        let Arcs { l, a, .. } = arcs.arcs;
        let span = |l: f64, a: f64| rotor_span(&kernel.arcs(l, a), kernel.r);
        let by_a = (span(l, a + 1e-5) - span(l, a - 1e-5)) / 2e-5;
        let h = 1e-5 * l;
        let by_l = (span(l + h, a) - span(l - h, a)) / (2.0 * h);
        prop_assert!((found.by_crest_distance - by_a).abs() < 1e-6 * by_a.abs().max(0.01));
        prop_assert!((found.by_trough_distance - by_l).abs() < 1e-6 * by_l.abs().max(0.01));
    }

    /// No radius of a motor exceeds 100 times the stator's.
    #[test]
    fn no_radius_is_beyond_a_machine(motor in any_motor(), beside_end in 0.0..1e-6) {
        let family = Family::new(motor.0, mm(1.0)).unwrap();
        for part in [motor.1, 1.0 - 1e-9 - beside_end] {
            let arcs = family.at_part(part).unwrap().arcs;
            let stator = arcs.a + arcs.r2;
            prop_assert!(arcs.r1.max(arcs.r2) <= 100.0 * stator, "{} {} {stator}", arcs.r1, arcs.r2);
        }
    }

    #[test]
    fn any_finite_distance_is_accepted_or_refused(
        set in (2..11_u32, 1..4_u32, 1..40_u32, 1..60_u32), l in any::<f64>(), m in any::<f64>(), near in 0.0..300.0,
    ) {
        let (lobes, fewer, per_lobe, satellite) = set;
        if let Ok(numbers) = MotorNumbers::new(lobes, lobes.saturating_sub(fewer), lobes * per_lobe, satellite) {
            let _ = arcs_at(numbers, mm(m), mm(l));
            let _ = arcs_at(numbers, mm(1.0), mm(l));
            let _ = arcs_at(numbers, mm(1.0), mm(near));
        }
    }
}
