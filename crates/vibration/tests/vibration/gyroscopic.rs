//! Modes in a turning frame: closed forms, motions of the housing's frame, and the eigenvalues of the
//! first-order system.

use crate::common::{body, degrees, groups, hz, lin_parker, n_m};
use epicyclic_vibration::{
    Centripetal, Freedom, Kind, Model, PlanetarySet, SetParts, Shape, Support, WhirlMode,
};
use nalgebra::{Complex, DMatrix, Schur};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::AngularVelocity;

fn rad_s(value: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(value)
}

fn whirl(model: &Model, parts: &SetParts, speed: f64) -> Vec<WhirlMode> {
    model.whirl_modes(rad_s(speed), Centripetal::WithBearingLoad, &parts.central()).unwrap()
}

fn omegas(modes: &[WhirlMode]) -> Vec<f64> {
    modes.iter().map(|mode| mode.omega.value).collect()
}

/// `G` and `K_Ω` written here from the acceleration in a turning frame, for models whose bodies are all
/// planar.
pub(crate) fn turning(
    model: &Model,
    carrier: usize,
    load: f64,
) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
    let size = model.size();
    let k = model.stiffness_matrix_n_per_m();
    let m = model.mass_matrix_diagonal_kg();
    let mut g = DMatrix::zeros(size, size);
    let mut k_omega = DMatrix::zeros(size, size);
    for body in 0..size / 3 {
        let (x, y) = (3 * body, 3 * body + 1);
        g[(x, y)] = -2.0 * m[x];
        g[(y, x)] = 2.0 * m[x];
        k_omega[(x, x)] = m[x];
        k_omega[(y, y)] = m[x];
    }
    k_omega[(3 * carrier + 2, 3 * carrier + 2)] = -load;
    (DMatrix::from_fn(size, size, |a, b| k[a][b]), DMatrix::from_diagonal(&m.into()), g, k_omega)
}

/// Load of planets of 0.66 kg on bearings of 1e8 N/m.
pub(crate) fn load(planets: f64, speed: f64) -> f64 {
    planets * 0.66 / (1.0 - 0.66 * speed * speed / 1e8)
}

/// A disc on a round support whirls at `ω_0 ± Ω` in a frame that turns at `Ω`: the same motion, seen from the
/// frame. The motion in the direction of the frame is the slower one there.
#[test]
fn a_disc_on_a_support_is_seen_at_its_frequency_plus_and_minus_the_speed() {
    let mut model = Model::new();
    let disc = model.body("disc", &body(2.0, 3.0, 0.1), Freedom::Planar).unwrap();
    model.support(disc, Support { radial: n_m(2e6), tangential: n_m(12e6) }).unwrap();
    for speed in [0.0, 10.0, 300.0, 999.0] {
        let modes = model.whirl_modes(rad_s(speed), Centripetal::default(), &[disc]).unwrap();
        for (mode, expected) in modes.iter().zip([1000.0 - speed, 1000.0 + speed, 2000.0]) {
            assert!((mode.omega.value - expected).abs() < 1e-10, "{} for {expected}", mode.omega.value);
        }
        // The sense in which a centre goes round: of cosine to sine.
        let sense = |mode: &WhirlMode| {
            let [[a, b, _], [c, d, _]] = [&mode.cosine, &mode.sine].map(|shape| shape.of(disc).unwrap());
            a * d - b * c
        };
        assert!(speed == 0.0 || (sense(&modes[0]) > 0.0 && sense(&modes[1]) < 0.0));
        let kinds: Vec<Kind> = modes.iter().map(|mode| mode.kind).collect();
        assert_eq!(kinds, [Kind::Translational, Kind::Translational, Kind::Rotational]);
    }
    let (set, parts) = lin_parker(3).planar().unwrap();
    let fault = |speed| set.whirl_modes(rad_s(speed), Centripetal::default(), &parts.central()).unwrap_err();
    assert_eq!(fault(13_000.0).name(), "above-critical");
    assert_eq!(fault(1e200).name(), "above-critical");
    let fault = model.whirl_modes(rad_s(1001.0), Centripetal::default(), &[disc]).unwrap_err();
    assert_eq!(fault.name(), "above-critical");
    assert_eq!(
        model.whirl_modes(rad_s(f64::NAN), Centripetal::default(), &[]).unwrap_err().name(),
        "out-of-range"
    );
}

/// The energy of a planet bearing at finite rotation of carrier and planet, in the turning frame with its
/// centrifugal potential.
#[test]
fn a_finite_rotation_of_a_turning_carrier_with_its_planets_costs_no_energy() {
    let (stiffness, mass, radius, speed) = (1e8, 0.66, 0.1, 400.0);
    let square: f64 = mass * speed * speed;
    // The planet's place at equilibrium: k·(r − r_c) = m·Ω²·r.
    let orbit = stiffness * radius / (stiffness - square);
    let energy = |carrier_angle: f64, planet: [f64; 2]| {
        let [x, y] = planet;
        let pin = [radius * libm::cos(carrier_angle), radius * libm::sin(carrier_angle)];
        0.5 * stiffness * ((x - pin[0]).powi(2) + (y - pin[1]).powi(2)) - 0.5 * square * (x * x + y * y)
    };
    let u = 1e-4;
    let second = |turn: f64| {
        let at = |sign: f64| energy(sign * turn * u / radius, [orbit, 0.0]);
        (at(1.0) - 2.0 * at(0.0) + at(-1.0)) / (u * u)
    };
    // Of the carrier alone: the bearing's stiffness, and that of its load.
    let of_load = square / (1.0 - square / stiffness);
    assert!(
        ((second(1.0) - stiffness) / of_load - 1.0).abs() < 1e-3,
        "{} for {of_load}",
        second(1.0) - stiffness
    );
    let together = |angle: f64| energy(angle, [orbit * libm::cos(angle), orbit * libm::sin(angle)]);
    assert!((together(0.3) - together(0.0)).abs() < 1e-10 * stiffness * radius * radius);
}

#[test]
fn at_rest_the_modes_are_those_of_the_set() {
    for planets in 3..=6 {
        let set = lin_parker(planets);
        let (model, parts) = set.planar().unwrap();
        let turning = whirl(&model, &parts, 0.0);
        let mut resting = Vec::new();
        for group in groups(&set) {
            resting.extend(vec![(group.kind, group.omega.value); group.multiplicity()]);
        }
        assert_eq!(turning.len(), resting.len());
        for (mode, (kind, omega)) in turning.iter().zip(resting) {
            assert_eq!(mode.kind, kind);
            assert!((mode.omega.value - omega).abs() <= 1e-9 * omega, "{} for {omega}", mode.omega.value);
        }
    }
}

#[test]
fn the_first_order_system_has_the_same_frequencies_and_nothing_that_grows() {
    let (set, speed) = (lin_parker(4), 800.0);
    let (model, parts) = set.planar().unwrap();
    let found = omegas(&whirl(&model, &parts, speed));
    let (k, m, g, k_omega) = turning(&model, 2, load(4.0, speed));
    let size = model.size();
    let scale = found[size - 1];
    let inverse = m.map_diagonal(|mass| 1.0 / mass);
    let inverse = DMatrix::from_diagonal(&inverse);
    let mut first_order = DMatrix::zeros(2 * size, 2 * size);
    first_order.view_mut((0, size), (size, size)).fill_with_identity();
    let stiff = &inverse * (k - k_omega * (speed * speed)) / (-scale * scale);
    first_order.view_mut((size, 0), (size, size)).copy_from(&stiff);
    first_order.view_mut((size, size), (size, size)).copy_from(&(&inverse * g * (-speed / scale)));
    let eigenvalues = Schur::try_new(first_order, f64::EPSILON, 10_000).unwrap().complex_eigenvalues();
    let mut other: Vec<f64> = eigenvalues.iter().map(|value| value.im.abs()).collect();
    other.sort_by(f64::total_cmp);
    for (pair, omega) in other.chunks(2).zip(&found) {
        // A zero mode is a double eigenvalue there, found to the root of rounding.
        let tolerance = if *omega == 0.0 { 1e-6 } else { 1e-11 };
        assert!(
            pair.iter().all(|value| (value - omega / scale).abs() < tolerance),
            "{pair:?}, {}",
            omega / scale
        );
    }
    assert!(eigenvalues.iter().all(|value| value.re.abs() < 1e-6));
}

#[test]
fn modes_fulfil_the_equations_of_motion() {
    let mut set = lin_parker(4);
    for (planet, angle) in set.planets.iter_mut().zip([0.0, 80.0, 180.0, 260.0]) {
        planet.angle = degrees(angle);
    }
    let (model, parts) = set.planar().unwrap();
    let speed = 500.0;
    let (k, m, g, k_omega) = turning(&model, 2, load(4.0, speed));
    let complex = |matrix: &DMatrix<f64>| matrix.map(|part| Complex::new(part, 0.0));
    let stiff = complex(&(k - k_omega * (speed * speed)));
    let size = stiff.norm();
    for mode in whirl(&model, &parts, speed) {
        let flat =
            |shape: &Shape| model.bodies().flat_map(|body| shape.of(body).unwrap()).collect::<Vec<_>>();
        let (cosine, sine) = (flat(&mode.cosine), flat(&mode.sine));
        // q·exp(i·ω·t) with q = cosine − i·sine.
        let q =
            nalgebra::DVector::from_fn(cosine.len(), |place, _| Complex::new(cosine[place], -sine[place]));
        let omega = mode.omega.value;
        let residual = &stiff * &q + complex(&g) * &q * Complex::new(0.0, speed * omega)
            - complex(&m) * &q * Complex::new(omega * omega, 0.0);
        assert!(
            residual.norm() < 1e-11 * size * q.norm(),
            "{} at {omega}",
            residual.norm() / size / q.norm()
        );
        assert!(q.norm() > 0.0);
    }
}

/// Rotational and planet modes keep their kind and their multiplicity; double translational modes part.
#[test]
fn kinds_survive_a_turning_carrier() {
    let (model, parts) = lin_parker(5).planar().unwrap();
    let modes = whirl(&model, &parts, 600.0);
    let of = |kind| {
        modes.iter().filter(|mode| mode.kind == kind).map(|mode| hz(mode.frequency)).collect::<Vec<_>>()
    };
    let [rotational, translational, planet] = [Kind::Rotational, Kind::Translational, Kind::Planet].map(of);
    assert_eq!([rotational.len(), translational.len(), planet.len()], [6, 12, 6]);
    assert_eq!(rotational[0], 0.0);
    assert!(translational.windows(2).all(|pair| pair[1] - pair[0] > 1e-3), "{translational:?}");
}

/// Without the load of the bearings a set that can rotate freely loses its zero mode and diverges; held
/// against rotation it does not.
#[test]
fn the_published_terms_alone_let_a_free_set_diverge() {
    let modes = |set: &PlanetarySet| {
        let (model, parts) = set.planar().unwrap();
        model.whirl_modes(rad_s(100.0), Centripetal::AsPublished, &parts.central())
    };
    let mut set = lin_parker(4);
    assert_eq!(modes(&set).unwrap_err().name(), "above-critical");
    set.carrier.support.tangential = n_m(1e9);
    assert!(modes(&set).unwrap()[0].omega.value > 0.0);
}

#[test]
fn planets_that_pull_their_carrier_aside_are_refused() {
    let mut set = lin_parker(3);
    set.planets[1].angle = degrees(111.0);
    let (model, parts) = set.planar().unwrap();
    let fault = model.whirl_modes(rad_s(500.0), Centripetal::WithBearingLoad, &parts.central()).unwrap_err();
    assert_eq!(fault.name(), "unbalanced");
    assert!(
        fault.to_string().starts_with("the centrifugal forces on carrier have a resultant of 0.05"),
        "{fault}"
    );
    assert!(model.whirl_modes(rad_s(0.0), Centripetal::WithBearingLoad, &parts.central()).is_ok());
}
