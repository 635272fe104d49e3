//! Checks of the profiles by ways that do not share their formulas.

use super::form::Teeth;
use super::limits::{Limit, LimitKind};
use super::*;
use crate::MotorNumbers;
use crate::centrode::tests::any_motor;
use crate::closure::Family;
use crate::quantity::{Quantity, WheelKind};
use epicyclic_units::Physical;
use proptest::prelude::*;
use std::f64::consts::TAU;
use uom::si::f64::{Angle, Length};

fn m(value: f64) -> Length {
    Length::from_si(value)
}

fn xy(point: Point) -> [f64; 2] {
    [point.x.si(), point.y.si()]
}

fn numbers(n: (u32, u32, u32, u32)) -> MotorNumbers {
    MotorNumbers::new(n.0, n.1, n.2, n.3).unwrap()
}

fn motor(n: (u32, u32, u32, u32), l: f64) -> Motor {
    Motor::of_two_arcs(numbers(n), m(1.0), m(l)).unwrap()
}

fn in_the_middle(n: (u32, u32, u32, u32)) -> Motor {
    let family = Family::new(numbers(n), m(1.0)).unwrap();
    let l = family.at_part(0.5).unwrap().trough_distance();
    Motor::of_two_arcs(family.numbers(), m(1.0), l).unwrap()
}

/// The motors for which the default form is made.
fn reference_motors() -> Vec<Motor> {
    let (five, six) = ((5, 3, 55, 10), (6, 4, 66, 10));
    vec![motor(five, 40.0), motor(five, 30.0), in_the_middle(five), motor(six, 40.0), in_the_middle(six)]
}

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [x * cos - y * sin, x * sin + y * cos]
}

fn failing(profile: &Profile) -> Vec<(LimitKind, Wheel)> {
    let limits = profile.limits();
    limits.iter().filter(|limit| !limit.holds()).map(|limit| (limit.kind, limit.wheel)).collect()
}

/// Distance of a point of the satellite's frame from the cutter: involutes, discs in the corners of the tip,
/// tip circle.
fn from_cutter(profile: &Profile, [x, y]: [f64; 2]) -> f64 {
    let teeth: &Teeth = &profile.teeth;
    let pitch = TAU / f64::from(profile.motor.numbers().satellite_teeth());
    let angle = (libm::atan2(y, x) - profile.satellite.offset).rem_euclid(pitch);
    let angle = angle.min(pitch - angle);
    let radius = libm::hypot(x, y);
    let tip = teeth.r + teeth.cutter_addendum;
    let mut least = f64::INFINITY;
    if radius > teeth.base {
        // The string of the involute, and how far it is unwound at the pitch circle.
        let string = (radius * radius - teeth.base * teeth.base).sqrt();
        let at_pitch = (teeth.r * teeth.r - teeth.base * teeth.base).sqrt();
        let winding = |string: f64| string / teeth.base - libm::atan(string / teeth.base);
        let half = teeth.half_space / teeth.r + winding(at_pitch) - winding(string);
        let distance = teeth.base * (angle - half);
        let end = teeth.roll_angle(teeth.round_radius) * teeth.base + teeth.fillet;
        if (0.0..=end).contains(&(string - distance)) {
            least = distance;
        }
    }
    let (sin, cos) = libm::sincos(angle - teeth.round_angle);
    least = least.min(libm::hypot(radius * cos - teeth.round_radius, radius * sin) - teeth.fillet);
    if angle <= teeth.round_angle { least.min(radius - tip) } else { least }
}

/// The least distance of a point of a wheel from the cutter over all places where it rolls past.
fn least_from_cutter(profile: &Profile, wheel: Wheel, point: [f64; 2]) -> f64 {
    let motor = &profile.motor;
    let at = |rotation: f64| {
        let place = motor.place_at(rotation);
        let turn = if wheel == Wheel::Rotor { rotation } else { 0.0 };
        let [x, y] = turned(point, turn);
        let [cx, cy] = place.centre;
        let spin = place.contact.theta3 - place.contact.mu - place.contact.s3 / profile.teeth.r;
        from_cutter(profile, turned([x - cx, y - cy], -spin))
    };
    let end = TAU / f64::from(motor.numbers().stator_lobes()) + motor.chamber_phase();
    let steps = 800;
    let phase = |i: i32| end * f64::from(i) / f64::from(steps);
    let (least, i) = (-steps / 4..=steps + steps / 4)
        .map(|i| (at(phase(i)), i))
        .fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
    let (mut low, mut high) = (phase(i - 1), phase(i + 1));
    for _ in 0..80 {
        let (one, other) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if at(one) < at(other) {
            high = other;
        } else {
            low = one;
        }
    }
    at(0.5 * (low + high)).min(least)
}

/// A form that pleases most satellites.
fn mild(alpha_deg: f64, crest: Crest) -> ToothForm {
    ToothForm {
        pressure_angle: Angle::from_degrees(alpha_deg),
        addendum: 0.7,
        clearance: 0.2,
        shift: 0.1,
        crest,
        ..ToothForm::default()
    }
}

#[test]
fn the_cutter_touches_every_point_of_flank_fillet_and_root_and_enters_none() {
    let cosine = Motor::of_cosine_law(numbers((8, 6, 88, 10)), m(1.0)).unwrap();
    let odd = in_the_middle((5, 3, 55, 9));
    let share = ToothForm { satellite_share: 0.25, ..ToothForm::default() };
    for (motor, form) in [
        (motor((5, 3, 55, 10), 40.0), ToothForm::default()),
        (cosine, share),
        (odd, mild(26.0, Crest::Tooth)),
    ] {
        let profile = Profile::new(&motor, form).unwrap();
        for (wheel, z) in
            [(Wheel::Stator, motor.numbers().stator_teeth()), (Wheel::Rotor, motor.numbers().rotor_teeth())]
        {
            let outline = profile.outline(wheel, 16 * z).unwrap();
            let lobe = motor.numbers().teeth_per_lobe() as usize * 16;
            for (i, segment) in outline.segments.iter().enumerate() {
                let end = outline.segments.get(i + 1).map_or(outline.points.len(), |next| next.start);
                for k in (segment.start..end.min(lobe)).step_by(5) {
                    // The rotor's track runs clockwise: the mirrored lobe is the one that contact goes along.
                    let [x, y] = xy(outline.points[k]);
                    let point = if wheel == Wheel::Rotor { [x, -y] } else { [x, y] };
                    let least = least_from_cutter(&profile, wheel, point);
                    if segment.part == Part::Tip {
                        assert!(least > -1e-9);
                    } else {
                        assert!(least.abs() < 1e-9, "{wheel:?} {:?} {k} {least:e}", segment.part);
                    }
                }
            }
        }
    }
}

#[test]
fn along_the_arcs_the_flanks_are_involutes_of_round_wheels() {
    // On arc 2 an internal gear of pitch radius R₂ about O₂, on arc 1 an external one of R₁ about O₁.
    let motor = motor((5, 3, 55, 10), 40.0);
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    let arcs = motor.arcs().unwrap();
    let teeth = profile.teeth;
    let [l, a, r1, r2] =
        [arcs.trough_distance(), arcs.crest_distance(), arcs.trough_radius(), arcs.crest_radius()]
            .map(Physical::si);
    let junction = r2 * arcs.crest_angle().si();
    let trough = 0.5 * profile.track(Side::Stator).lobe();
    let (sin, cos) = libm::sincos(PI / 5.0);
    let mut seen = [0, 0];
    for flank in profile.cuts[0].flanks.iter().flatten() {
        for i in 0..=20 {
            let s = flank.tip + (flank.end - flank.tip) * f64::from(i) / 20.0;
            let (arc, [cx, cy], string) = if s.abs() < junction {
                (0, [a, 0.0], r2 * teeth.sin - flank.roll(s) * teeth.cos)
            } else if (s - trough).abs() < trough - junction {
                (1, [l * cos, l * sin], r1 * teeth.sin + flank.roll(s) * teeth.cos)
            } else {
                continue;
            };
            let curve = cut::Curve::Flank { sign: flank.sign, pitch: flank.pitch };
            let [x, y] = cut::point(&teeth, curve, &profile.track(Side::Stator).at(s));
            let base = teeth.cos * [r2, r1][arc];
            assert!((libm::hypot(x - cx, y - cy) - libm::hypot(base, string)).abs() < 1e-11, "{arc}");
            seen[arc] += 1;
        }
    }
    assert!(seen[0] > 100 && seen[1] > 30, "{seen:?}");
}

#[test]
fn the_default_passes_every_limit_and_meshes_with_half_its_backlash() {
    for motor in reference_motors() {
        let profile = Profile::new(&motor, ToothForm::default()).unwrap();
        assert_eq!(failing(&profile), []);
        let clearances = profile.clearances(60).unwrap();
        let expected = 0.5 * profile.teeth.backlash * profile.teeth.cos;
        for nearest in [clearances.stator, clearances.rotor] {
            let clearance = nearest.clearance.si();
            assert!((clearance - expected).abs() < 1e-8, "{clearance} {expected}");
            assert_eq!(nearest.part, Part::Flank);
        }
        assert!(clearances.free());
    }
}

#[test]
fn what_a_limit_of_distance_leaves_is_the_clearance() {
    for motor in reference_motors() {
        for form in [ToothForm::default(), mild(24.0, Crest::Space)] {
            let profile = Profile::new(&motor, form).unwrap();
            let limits = profile.limits();
            let left = |kind: LimitKind| {
                let [limit] = limits.iter().filter(|limit| limit.kind == kind).collect::<Vec<_>>()[..] else {
                    panic!("one limit {kind:?}")
                };
                (limit.value - limit.bound).si()
            };
            let clearances = profile.clearances(6).unwrap();
            assert!((left(LimitKind::Wheels) - clearances.wheels.si()).abs() < 1e-12);
            assert!((left(LimitKind::Neighbours) - clearances.neighbours.0.si()).abs() < 1e-12);
        }
    }
}

#[test]
fn whoever_is_thinner_the_clearance_is_the_same() {
    let motor = motor((5, 3, 55, 10), 40.0);
    for satellite_share in [0.0, 0.4] {
        let form = ToothForm { satellite_share, backlash: 0.03, ..ToothForm::default() };
        let profile = Profile::new(&motor, form).unwrap();
        let clearances = profile.clearances(40).unwrap();
        let expected = 0.015 * profile.teeth.cos;
        for nearest in [clearances.stator, clearances.rotor] {
            assert!((nearest.clearance.si() - expected).abs() < 1e-8);
        }
    }
}

#[test]
fn a_whole_revolution_comes_no_nearer_than_half_a_lobe() {
    for (n, form) in [
        ((5, 3, 55, 10), ToothForm::default()),
        ((5, 3, 55, 9), mild(27.0, Crest::Tooth)),
        ((5, 3, 55, 10), ToothForm::full_depth()),
    ] {
        let motor = in_the_middle(n);
        let profile = Profile::new(&motor, form).unwrap();
        let short = profile.clearances(80).unwrap();
        let least = [short.stator, short.rotor].map(|nearest| nearest.clearance.si());
        let mut seen = [f64::INFINITY; 2];
        for i in 0..40 {
            let rotation = Angle::from_si(TAU * (f64::from(i) + 0.3) / 40.0);
            for satellite in profile.clearances_at(rotation).unwrap() {
                for (nearest, seen) in satellite.iter().zip(&mut seen) {
                    *seen = seen.min(nearest.clearance.si());
                }
            }
        }
        for (least, seen) in least.iter().zip(seen) {
            // 40·8 states of the revolution, against a sampled and refined minimum.
            assert!(seen > least - 1e-4 && seen < least + 0.02, "{n:?} {least} {seen}");
        }
        // The state found is one of the revolution.
        let there = profile.clearances_at(short.rotor.rotation).unwrap()[0][1];
        assert!((there.clearance - short.rotor.clearance).abs() < m(1e-6));
    }
}

#[test]
fn standard_teeth_undercut_the_satellite_and_overlap() {
    let profile = Profile::new(&motor((5, 3, 55, 10), 40.0), ToothForm::full_depth()).unwrap();
    let failing = failing(&profile);
    assert!(failing.contains(&(LimitKind::Undercut, Wheel::Satellite)), "{failing:?}");
    assert!(failing.contains(&(LimitKind::SatelliteRoot, Wheel::Stator)), "{failing:?}");
    // Its rack would have to end r·sin² α = 0.585 modules below the pitch line, and ends at 1.1513.
    let limits = profile.limits();
    let undercut: &Limit = limits
        .iter()
        .find(|limit| limit.kind == LimitKind::Undercut && limit.wheel == Wheel::Satellite)
        .unwrap();
    let sin = libm::sin(20.0_f64.to_radians());
    assert!((undercut.bound.si() - 5.0 * sin).abs() < 1e-12);
    assert!((undercut.value.si() - (1.25 - 0.15 * (1.0 - sin)) / sin).abs() < 1e-12);
    assert!(undercut.margin() < m(0.0));
    assert!(!profile.clearances(60).unwrap().free());
}

#[test]
fn an_undercut_flank_ends_where_the_fillet_leaves_it() {
    let motor = motor((6, 4, 66, 10), 30.0);
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    assert!(failing(&profile).contains(&(LimitKind::Undercut, Wheel::Stator)));
    assert!(profile.cuts[0].flanks.iter().flatten().any(|flank| flank.undercut && flank.end != flank.fillet));
    outline_holds_together(&profile);
}

/// A flank that ends before its tip ends in a cusp. There the point is over its foot at the height of the
/// addendum less the missing height.
#[test]
fn a_flank_that_ends_before_its_tip_ends_in_a_cusp() {
    use super::cut::{Curve, point, regularity};
    let mut ended = 0;
    for motor in reference_motors() {
        for alpha_deg in [15.0, 18.0, 21.0] {
            let form = ToothForm { addendum: 1.1, fillet: 0.0, ..mild(alpha_deg, Crest::Tooth) };
            let Ok(profile) = Profile::new(&motor, form) else { continue };
            for side in [Side::Stator, Side::Rotor] {
                let (track, teeth) = (profile.track(side), &profile.teeth);
                for flank in profile.cut(side).flanks.iter().flatten().filter(|flank| flank.missing > 0.0) {
                    let frame = track.at(flank.tip);
                    assert!(regularity(teeth, flank, &frame).abs() < 1e-9, "{flank:?}");
                    let tip = point(teeth, Curve::Flank { sign: flank.sign, pitch: flank.pitch }, &frame);
                    let foot = track.at(flank.foot);
                    let [x, y] = [tip[0] - foot.at[0], tip[1] - foot.at[1]];
                    let [along, height] = [
                        x * foot.along[0] + y * foot.along[1],
                        libm::hypot(x, y) + flank.missing - teeth.wheel_addendum,
                    ];
                    assert!(along.abs() < 1e-9 && height.abs() < 1e-9, "{flank:?}: {along:e} {height:e}");
                    ended += 1;
                }
            }
        }
    }
    assert!(ended > 5, "{ended}");
}

fn outline_holds_together(profile: &Profile) {
    for side in Side::BOTH {
        let (cut, track) = (profile.cut(side), profile.track(side));
        let lobe = track.lobe();
        let shifted = cut.pieces[0].shifted(lobe);
        for (one, next) in cut.pieces.iter().zip(cut.pieces[1..].iter().chain([&shifted])) {
            let [ax, ay] = cut::point(&profile.teeth, one.curve, &track.at(one.to));
            let [bx, by] = cut::point(&profile.teeth, next.curve, &track.at(next.from));
            assert!(libm::hypot(ax - bx, ay - by) < 1e-9, "{side:?} {:?} {:?}", one.part, next.part);
        }
    }
    let least = profile.motor.numbers().satellite_teeth().max(40);
    for wheel in [Wheel::Stator, Wheel::Rotor, Wheel::Satellite] {
        let outline = profile.outline(wheel, 40 * least).unwrap();
        assert!(outline.points.len() >= 40 * least as usize);
        let next = outline.points.iter().cycle().skip(1);
        let turn: f64 = outline
            .points
            .iter()
            .zip(next)
            .map(|(a, b)| {
                let ([ax, ay], [bx, by]) = (xy(*a), xy(*b));
                libm::atan2(ax * by - ay * bx, ax * bx + ay * by)
            })
            .sum();
        assert!((turn - TAU).abs() < 1e-9, "{wheel:?} {turn}");
        assert!(outline.segments.windows(2).all(|pair| pair[0].start < pair[1].start));
        assert_eq!(outline.segments[0].start, 0);
    }
}

#[test]
fn the_satellites_distance_is_that_of_its_outline() {
    for form in [ToothForm::default(), ToothForm::full_depth()] {
        let profile = Profile::new(&motor((5, 3, 55, 10), 40.0), form).unwrap();
        let points: Vec<[f64; 2]> =
            profile.outline(Wheel::Satellite, 20_000).unwrap().points.into_iter().map(xy).collect();
        for i in 0..400 {
            let radius = 3.5 + 3.0 * (f64::from(i) * 0.618).fract();
            let point = turned([radius, 0.0], f64::from(i) * 0.37);
            let near = points
                .iter()
                .map(|[x, y]| libm::hypot(x - point[0], y - point[1]))
                .fold(f64::INFINITY, f64::min);
            let wound: f64 = points
                .iter()
                .zip(points.iter().cycle().skip(1))
                .map(|(a, b)| {
                    let (ax, ay, bx, by) =
                        (a[0] - point[0], a[1] - point[1], b[0] - point[0], b[1] - point[1]);
                    libm::atan2(ax * by - ay * bx, ax * bx + ay * by)
                })
                .sum();
            let expected = if wound > 3.0 { -near } else { near };
            let distance = profile.satellite.distance(point);
            assert!((distance - expected).abs() < 2e-3, "{i} {radius} {distance} {expected}");
        }
    }
}

#[test]
fn the_satellites_outline_is_at_no_distance_from_itself() {
    for form in [ToothForm::default(), ToothForm::full_depth(), mild(24.0, Crest::Tooth)] {
        let profile = Profile::new(&motor((5, 3, 55, 10), 40.0), form).unwrap();
        for point in profile.outline(Wheel::Satellite, 7000).unwrap().points {
            let distance = profile.satellite.distance(xy(point));
            assert!(distance.abs() < 1e-12, "{distance:e}");
        }
    }
}

#[test]
fn a_tip_that_keeps_the_involute_may_run_into_the_fillet() {
    let motor = motor((4, 2, 48, 11), 48.565);
    let form = ToothForm {
        pressure_angle: Angle::from_degrees(25.16),
        addendum: 0.8183,
        clearance: 0.2077,
        shift: 0.0857,
        backlash: 0.0931,
        satellite_share: 0.7,
        fillet: 0.1009,
        crest: Crest::Tooth,
    };
    let profile = Profile::new(&motor, form).unwrap();
    assert_eq!(failing(&profile), [(LimitKind::SatelliteRoot, Wheel::Stator)]);
    // The path keeps the involute; the corner of the tip, as measured along its way, does not keep the
    // distance of the flanks.
    let limits = profile.limits();
    let limit = limits.iter().find(|limit| !limit.holds()).unwrap();
    let flank = profile.cut(Side::Stator).flanks[0][1];
    assert!(flank.roll(flank.tip) * profile.teeth.cos < limit.bound.si() - 0.01);
    let nearest = profile.clearances(600).unwrap().stator;
    let excess = nearest.clearance.si() - 0.5 * profile.teeth.backlash * profile.teeth.cos;
    assert!((limit.margin().si() - excess).abs() < 1e-8, "{:?} {excess:e}", limit.margin());
    assert!(excess < -4e-5, "{excess:e}");
    // Lower tips stay clear.
    let lower = Profile::new(&motor, ToothForm { addendum: 0.78, ..form }).unwrap();
    assert_eq!(failing(&lower), []);
}

#[test]
fn what_leaves_no_teeth_is_refused() {
    let motor = motor((5, 3, 55, 10), 40.0);
    let refuse = |form: ToothForm| Profile::new(&motor, form).unwrap_err();
    let standard = ToothForm::default;
    let flat = ToothForm { pressure_angle: Angle::from_degrees(5.0), ..standard() };
    assert_eq!(refuse(flat).to_string(), "pressure angle is 5°; it must lie between 10 and 40°");
    let nan = ToothForm { pressure_angle: Angle::from_degrees(f64::NAN), ..standard() };
    assert!(matches!(refuse(nan), Error::NotFinite { .. }));
    let high = ToothForm { addendum: 1.5, ..standard() };
    let Error::PointedTip { wheel: WheelKind::Satellite, most, .. } = refuse(high) else {
        panic!("{}", refuse(high))
    };
    assert!(Profile::new(&motor, ToothForm { addendum: most + 1e-6, ..standard() }).is_err());
    let above = ToothForm { clearance: 0.45, ..standard() };
    assert!(matches!(refuse(above), Error::PointedTip { wheel: WheelKind::WheelCutter, .. }));
    let round = ToothForm { fillet: 0.4, ..standard() };
    let Error::FilletTooLarge { most, .. } = refuse(round) else { panic!("{}", refuse(round)) };
    assert!(Profile::new(&motor, ToothForm { fillet: most - 1e-9, ..standard() }).is_ok());
    for (form, quantity) in [
        (ToothForm { addendum: -0.1, ..standard() }, Quantity::Addendum),
        (ToothForm { clearance: 1.5, ..standard() }, Quantity::Clearance),
        (ToothForm { shift: 0.9, ..standard() }, Quantity::ProfileShift),
        (ToothForm { backlash: -0.1, ..standard() }, Quantity::Backlash),
        (ToothForm { satellite_share: 1.1, ..standard() }, Quantity::BacklashShare),
        (ToothForm { fillet: f64::INFINITY, ..standard() }, Quantity::Fillet),
    ] {
        assert!(matches!(refuse(form), Error::OutOfRange { quantity: name, .. } if name == quantity));
    }
    let profile = Profile::new(&motor, standard()).unwrap();
    assert!(profile.outline(Wheel::Stator, 0).is_err() && profile.outline(Wheel::Rotor, u32::MAX).is_err());
    assert!(profile.clearances(0).is_err() && profile.clearances_at(Angle::from_si(f64::NAN)).is_err());
}

fn any_form() -> impl Strategy<Value = ToothForm> {
    (15.0..32.0, 0.3..1.1, 0.0..0.4, -0.3..0.5, 0.0..0.1, 0.0..1.0, 0.0..0.3, any::<bool>()).prop_map(
        |(alpha, addendum, clearance, shift, backlash, satellite_share, fillet, tooth)| ToothForm {
            pressure_angle: Angle::from_degrees(alpha),
            addendum,
            clearance,
            shift,
            backlash,
            satellite_share,
            fillet,
            crest: if tooth { Crest::Tooth } else { Crest::Space },
        },
    )
}

/// Forms that mostly keep their limits on most motors.
fn moderate_form() -> impl Strategy<Value = ToothForm> {
    (any_form(), 23.0..28.0, 0.5..0.85, 0.2..0.3, 0.05..0.25, 0.0..0.12).prop_map(
        |(form, alpha, addendum, clearance, shift, fillet)| ToothForm {
            pressure_angle: Angle::from_degrees(alpha),
            addendum,
            clearance,
            shift,
            fillet,
            ..form
        },
    )
}

fn ask(profile: &Profile, rotation: f64) {
    let _ = profile.limits();
    for wheel in [Wheel::Stator, Wheel::Rotor, Wheel::Satellite] {
        let outline = profile.outline(wheel, 1).unwrap();
        assert!(outline.points.iter().all(|point| point.x.is_finite() && point.y.is_finite()));
    }
    let _ = (profile.clearances(1), profile.clearances_at(Angle::from_si(rotation)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn the_teeth_of_all_satellites_mesh_at_once(motor in any_motor(), rotation in -9.0..9.0, tooth: bool) {
        let [stator_phase, rotor_phase] =
            phases(if tooth { Crest::Tooth } else { Crest::Space }, motor.numbers().satellite_teeth());
        let z = f64::from(motor.numbers().satellite_teeth());
        for satellite in motor.satellites(Angle::from_si(rotation)).unwrap() {
            for (wheel, at, phase) in
                [(Wheel::Stator, satellite.on_stator, stator_phase), (Wheel::Rotor, satellite.on_rotor, rotor_phase)]
            {
                // Pitches from a tooth of the satellite to the contact, and from a space of the wheel,
                // counted back from its outline.
                let ([x, y], [cx, cy]) = (xy(at), xy(satellite.centre));
                let on_satellite = libm::atan2(y - cy, x - cx) - satellite.rotation.si();
                let teeth = on_satellite * z / TAU - stator_phase / PI;
                let turn = if wheel == Wheel::Rotor { rotation } else { 0.0 };
                let [x, y] = turned([x, y], -turn);
                let arc = motor.centrode(wheel).at_polar_angle(Angle::from_si(libm::atan2(y, x))).unwrap().arc_length.si();
                let along = if wheel == Wheel::Rotor { -arc } else { arc };
                let mismatch = teeth - (along - phase) / PI;
                prop_assert!((mismatch - mismatch.round()).abs() < 1e-9, "{wheel:?} {mismatch}");
            }
        }
    }

    #[test]
    fn outlines_hold_together(motor in any_motor(), form in any_form()) {
        if let Ok(profile) = Profile::new(&motor, form)
            && profile.limits().iter().all(|limit| limit.holds() || matches!(limit.kind,
                LimitKind::ContactPath | LimitKind::SatelliteRoot | LimitKind::WheelRoot | LimitKind::Neighbours | LimitKind::Wheels))
        {
            outline_holds_together(&profile);
        }
    }

    #[test]
    fn kept_limits_mean_free_teeth(motor in any_motor(), form in moderate_form()) {
        // A short path of contact makes no overlap; there may then be no flanks in contact.
        let free = |limit: &Limit| limit.holds() || limit.kind == LimitKind::ContactPath;
        if let Ok(profile) = Profile::new(&motor, form) && profile.limits().iter().all(free) {
            let clearances = profile.clearances(24).unwrap();
            let expected = 0.5 * profile.teeth.backlash * profile.teeth.cos;
            for nearest in [clearances.stator, clearances.rotor] {
                let excess = nearest.clearance.si() - expected;
                prop_assert!(excess > -1e-6, "{nearest:?} {excess:e}");
            }
        }
    }

    #[test]
    fn an_undercut_wheel_is_as_free(motor in any_motor(), form in moderate_form()) {
        // The satellite is the cutter less the backlash, whatever the cutter does to the wheel.
        let free = |limit: &Limit| limit.holds() || [LimitKind::Undercut, LimitKind::WheelRoot, LimitKind::ContactPath, LimitKind::TipThickness].contains(&limit.kind);
        if let Ok(profile) = Profile::new(&motor, form) && profile.limits().iter().all(free) {
            outline_holds_together(&profile);
            let clearances = profile.clearances(24).unwrap();
            let expected = 0.5 * profile.teeth.backlash * profile.teeth.cos;
            for nearest in [clearances.stator, clearances.rotor] {
                let excess = nearest.clearance.si() - expected;
                // The known error of the module: up to 1e-4 modules of the part that the cutter removes may
                // remain.
                prop_assert!(excess > -1e-3, "{nearest:?} {excess:e}");
            }
        }
    }

    #[test]
    fn no_finite_form_panics(
        motor in any_motor(), form in any_form(), which in 0..7_usize, x in any::<f64>(), rotation in any::<f64>(),
    ) {
        let mut odd = form;
        for x in [x, x.abs() % 2.0] {
            match which {
                0 => odd.pressure_angle = Angle::from_degrees(x * 20.0),
                1 => odd.addendum = x,
                2 => odd.clearance = x,
                3 => odd.shift = x,
                4 => odd.backlash = x,
                5 => odd.satellite_share = x,
                _ => odd.fillet = x,
            }
            if let Ok(profile) = Profile::new(&motor, odd) {
                ask(&profile, rotation);
            }
        }
        if let Ok(profile) = Profile::new(&motor, form) {
            ask(&profile, rotation);
        }
    }
}
