//! Tests of the pressures of Hertz.

use super::*;
use crate::MotorNumbers;
use crate::flanks::forces::tests::{alpha, mm, motor, mpa};
use crate::flanks::sealing::tests::any_profile;
use crate::flanks::slow;
use crate::profile::ToothForm;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::Angle;
use uom::si::pressure::gigapascal;

pub(in crate::flanks) fn steel(e: f64) -> Pressure {
    effective_modulus([Pressure::new::<gigapascal>(e); 2], [0.3; 2]).unwrap()
}

/// Steel of 210 GPa. The derivation calls `e = 1.34` the inner end of single contact: of the default form it
/// is about the rotor's tip, 1.3340 to 1.3569, and single contact ends at 0.9519, a base pitch from the
/// satellite's tip.
#[test]
fn the_pressures_of_the_derivation_are_met() {
    let cases = [
        ((5, 3, 55, 10), Mesh::Rotor, Push::Forward, 1973.0, 2754.0),
        ((6, 4, 66, 10), Mesh::Stator, Push::Back, 1900.0, 2767.0),
    ];
    for (numbers, mesh, push, at_pitch, inner) in cases {
        let motor = motor(numbers, 1.0, 40.0);
        let profile = Profile::new(&motor, ToothForm::default()).unwrap();
        let stresses = profile.contact_stresses(mpa(20.0), steel(210.0)).unwrap();
        let stress = stresses.iter().find(|stress| stress.mesh == mesh && stress.push == push).unwrap();
        let found = stress.at_pitch_point.pressure.mpa();
        assert!((found - at_pitch).abs() < 0.5, "{found}");
        // A hair within the loaded range.
        let rotation = stress.at_pitch_point.rotation + Angle::from_si(1e-9);
        let at = |e| {
            motor.contact_pressure(alpha(), mesh, rotation, mm(e), mpa(20.0), steel(210.0)).unwrap().mpa()
        };
        assert!(
            (at(0.0) - at_pitch).abs() < 0.5 && (at(1.34) - inner).abs() < 0.5,
            "{} {}",
            at(0.0),
            at(1.34)
        );
        let single = stress.in_single_contact.unwrap().offset.mm();
        assert!((single - 0.9519).abs() < 5e-5, "{single}");
    }
}

/// `p_H² = Δp·E*·(2/sin 2α)·(1 + r·κ)/π` at a crest, where the slope vanishes.
#[test]
fn at_a_crest_the_closed_form_holds() {
    let motor = motor((5, 3, 55, 10), 2.0, 80.0);
    let modulus = steel(206.0);
    let kappa = 1.0
        / motor
            .centrode(crate::centrode::Wheel::Rotor)
            .at(mm(0.0))
            .unwrap()
            .curvature
            .get::<uom::si::curvature::radian_per_meter>();
    let radius = 5.0 * 2e-3;
    let sin = libm::sin((50.0_f64).to_radians());
    let closed = (20e6 * modulus.value * 2.0 / sin * (1.0 + radius / kappa) / PI).sqrt();
    let found = motor
        .contact_pressure(alpha(), Mesh::Rotor, Angle::from_si(0.0), mm(0.0), mpa(20.0), modulus)
        .unwrap();
    assert!((found.value - closed).abs() < 1e-9 * closed, "{found:?} {closed}");
}

/// The curvatures are those of circles through three neighbouring points of the drawn flanks.
#[test]
fn the_relative_curvature_is_that_of_the_drawn_flanks() {
    let motor = motor((5, 3, 55, 10), 1.0, 40.0);
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    let bend = |[a, b, c]: [[f64; 2]; 3]| {
        let (ux, uy, vx, vy) = (b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]);
        let sides = libm::hypot(ux, uy) * libm::hypot(vx, vy) * libm::hypot(c[0] - b[0], c[1] - b[1]);
        (2.0 * (ux * vy - uy * vx) / sides).abs()
    };
    let (r, a) = (5.0, 25.0_f64.to_radians());
    for side in Side::BOTH {
        let teeth = profile.wheel_teeth(side, 12);
        for (crest, sigma) in [(true, 1.0), (false, -1.0)] {
            for stretch in profile.stretches(side, sigma, crest) {
                let [from, to] = stretch.whole;
                let (index, lobe) = profile.tooth_of(side, stretch.sign, stretch.pitch);
                let s = 0.4 * from + 0.6 * to;
                let e = stretch.sign * (s - stretch.pitch) * libm::cos(a);
                let drawn = |s: f64| {
                    profile.wheel_loading(side, &teeth[index], stretch.sign, stretch.pitch - lobe, s - lobe).0
                };
                let h = 1e-4;
                let kink = motor.shape.at(arc(side), s);
                let wheel = bend([s - h, s, s + h].map(drawn));
                let own = bend([e - h, e, e + h].map(|e| profile.satellite_loading(e).0));
                let bulge = if side == Side::Stator { -kink.kappa3 } else { kink.kappa1 };
                let relative = own + wheel * bulge.signum();
                let number = flank_number(r, a, &kink, sigma).unwrap();
                let found = severity(side, r, a, &kink, sigma, e).unwrap() * PI / number;
                assert!((relative - found).abs() < 1e-4 * found, "{side:?} {s} {e} {relative} {found}");
            }
        }
    }
}

#[test]
fn no_pressure_on_a_path_exceeds_the_greatest() {
    let motor = motor((6, 4, 66, 10), 1.0, 40.0);
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    for stress in profile.contact_stresses(mpa(20.0), steel(206.0)).unwrap() {
        let (side, forward) = (stress.mesh.side(), stress.push == Push::Forward);
        let greatest = stress.on_path.unwrap();
        let mut seen = 0.0_f64;
        for stretch in profile.stretches(side, if forward { 1.0 } else { -1.0 }, forward) {
            for i in 1..200 {
                let s = stretch.whole[0] + (stretch.whole[1] - stretch.whole[0]) * f64::from(i) / 200.0;
                let contact = motor.shape.at(arc(side), s);
                let e = stretch.sign * (s - stretch.pitch) * profile.teeth().cos;
                let at = motor
                    .contact_pressure(
                        alpha(),
                        stress.mesh,
                        Angle::from_si(contact.phase),
                        mm(e),
                        mpa(20.0),
                        steel(206.0),
                    )
                    .unwrap();
                assert!(at <= greatest.pressure * (1.0 + 1e-9), "{at:?} {greatest:?}");
                seen = seen.max((at / greatest.pressure).value);
            }
        }
        assert!(seen > 0.98, "{seen}");
        let alone = stress.in_single_contact.unwrap();
        assert!(alone.pressure <= greatest.pressure && stress.at_pitch_point.pressure <= alone.pressure);
    }
}

/// The severities of [`Profile::peaks`] the plain way: along the wheel's own arc, by golden sections, the
/// ends of the pieces a `hair` within.
fn plain_peaks(profile: &Profile, side: Side, sigma: f64, crest: bool, hair: f64) -> [Option<f64>; 3] {
    let motor = profile.motor();
    let alpha = pressure_angle(profile.form().pressure_angle).unwrap();
    let (r, arc, range) = (motor.shape.satellite_radius(), arc(side), motor.loaded(crest));
    let at = |contact: &Contact, e: f64| severity(side, r, alpha, contact, sigma, e).unwrap_or(f64::NAN);
    let ends = motor.smooth_ends(range, [0.0, motor.shape.trough().phase]);
    let pieces: Vec<[f64; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let (_, _, value) =
        slow::greatest_of(&pieces, hair, |_, phase| at(&motor.shape.at(By::Phase, phase), 0.0));
    let mut best = [Some(value), None, None];
    let kinks: Vec<f64> =
        ends[1..ends.len() - 1].iter().map(|&phase| motor.shape.at(By::Phase, phase).get(arc)).collect();
    let stretches = profile.stretches(side, sigma, crest);
    for slot in [1, 2] {
        let (mut pieces, mut flanks) = (Vec::new(), Vec::new());
        for stretch in &stretches {
            let [from, to] = if slot == 1 { stretch.alone } else { stretch.whole };
            if from >= to {
                continue;
            }
            let mut ends = vec![from];
            ends.extend(kinks.iter().copied().filter(|&kink| kink > from && kink < to));
            ends.push(to);
            pieces.extend(ends.windows(2).map(|pair| [pair[0], pair[1]]));
            flanks.resize(pieces.len(), stretch);
        }
        let offset =
            |piece: usize, s: f64| flanks[piece].sign * (s - flanks[piece].pitch) * profile.teeth().cos;
        if !pieces.is_empty() {
            best[slot] = Some(
                slow::greatest_of(&pieces, hair, |piece, s| at(&motor.shape.at(arc, s), offset(piece, s))).2,
            );
        }
    }
    best
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// A hair within is another hair along the arc: between a wide one and none, which follows from a wide
    /// and a narrow one, and equal where the greatest is not at an end.
    #[test]
    fn the_peaks_are_those_of_the_plain_way(profile in any_profile(), crest in any::<bool>()) {
        let sigma = Motor::push(crest, 1.0);
        for side in Side::BOTH {
            let Ok(fast) = profile.peaks(side, sigma, crest) else { continue };
            let hairs = [1e-6, 1e-9];
            let [wide, narrow] = hairs.map(|hair| plain_peaks(&profile, side, sigma, crest, hair));
            for ((fast, wide), narrow) in fast.into_iter().zip(wide).zip(narrow) {
                prop_assert!(fast.is_some() == wide.is_some() && wide.is_some() == narrow.is_some());
                let (Some(fast), Some(wide), Some(narrow)) = (fast, wide, narrow) else { continue };
                if fast.severity.is_finite() && narrow.is_finite() {
                    // Twice the rise of a straight line on the rest of the way.
                    let end = narrow + 2.0 * (narrow - wide).max(0.0) * hairs[1] / hairs[0];
                    let within = wide * (1.0 - 1e-9)..=end * (1.0 + 1e-9);
                    prop_assert!(within.contains(&fast.severity), "{side:?} {fast:?} {within:?}");
                } else {
                    prop_assert!(!(fast.severity.is_finite() && wide.is_infinite()));
                }
            }
        }
    }

    #[test]
    fn pressures_do_not_depend_on_the_module(module in 0.3..20.0, drop in 1.0..50.0) {
        let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
        let of = |module: f64| {
            let motor = Motor::of_two_arcs(numbers, mm(module), mm(40.0 * module)).unwrap();
            Profile::new(&motor, ToothForm::default()).unwrap().contact_stresses(mpa(drop), steel(206.0)).unwrap()
        };
        for (one, other) in of(1.0).into_iter().zip(of(module)) {
            let (one, other) = (one.on_path.unwrap(), other.on_path.unwrap());
            prop_assert!((one.pressure / other.pressure).value - 1.0 < 1e-9);
            prop_assert!((one.offset * module / other.offset).value - 1.0 < 1e-6);
        }
    }
}

#[test]
fn bad_materials_and_places_are_refused() {
    let gpa = Pressure::new::<gigapascal>;
    assert!((steel(210.0).get::<gigapascal>() - 210.0 / 1.82).abs() < 1e-9);
    assert!(matches!(
        effective_modulus([gpa(210.0), gpa(0.0)], [0.3; 2]),
        Err(Error::NotPositive { quantity: Quantity::ElasticModulus, .. })
    ));
    assert!(matches!(
        effective_modulus([gpa(210.0); 2], [0.3, 0.6]),
        Err(Error::OutOfRange { quantity: Quantity::PoissonRatio, .. })
    ));
    let motor = motor((5, 3, 55, 10), 1.0, 40.0);
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    assert!(
        profile.contact_stresses(mpa(-1.0), gpa(1.0)).is_err()
            && profile.contact_stresses(mpa(1.0), gpa(0.0)).is_err()
    );
    let at = |e| motor.contact_pressure(alpha(), Mesh::Rotor, Angle::from_si(0.0), mm(e), mpa(1.0), gpa(1.0));
    assert!(at(1.0).is_ok());
    assert!(matches!(at(2.2), Err(Error::OutOfRange { quantity: Quantity::ContactOffset, .. })));
    assert!(matches!(at(-4.0), Err(Error::OutOfRange { quantity: Quantity::ContactOffset, .. })));
}
