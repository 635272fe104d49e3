//! Forced vibration: against a direct solution of the equations of motion, and in the limits of low and high
//! frequency.

use crate::common::{body, lin_parker, n_m};
use crate::gyroscopic::{load, turning};
use epicyclic_vibration::response::{Displacement, Response};
use epicyclic_vibration::{Axis, Centripetal, Error, Freedom, Model, SetParts, Support};
use nalgebra::{Complex, DMatrix, DVector, Normed};
use std::f64::consts::TAU;
use uom::si::angle::radian;
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{Angle, AngularVelocity, Length};
use uom::si::force::newton;
use uom::si::length::meter;

fn at(omega: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(omega)
}

/// Transmission errors of the meshes of the sun with the phases of `teeth`.
fn errors(parts: &SetParts, teeth: f64) -> Vec<Displacement> {
    let count = parts.sun_meshes.len() as f64;
    let of = |(index, spring): (usize, &epicyclic_vibration::SpringId)| Displacement {
        spring: *spring,
        amplitude: Length::new::<meter>(5e-6),
        phase: Angle::new::<radian>(teeth * TAU * index as f64 / count),
    };
    parts.sun_meshes.iter().enumerate().map(of).collect()
}

/// `(K + i·ω·C − ω²·M)·q = F` by elimination; the damping matrix from the matrix square root,
/// `C = 2·ζ·M^½·(M^-½·K·M^-½)^½·M^½`, not from modes one by one.
///
/// In axes that turn with a carrier of four planets at a speed `(K − Ω²·K_Ω + i·ω·(C + Ω·G) − ω²·M)·q = F`.
fn direct(
    model: &Model,
    displacements: &[Displacement],
    omega: f64,
    zeta: f64,
    speed: f64,
) -> Vec<Complex<f64>> {
    let size = model.size();
    let rows = model.stiffness_matrix_n_per_m();
    let stiffness = DMatrix::from_fn(size, size, |row, column| rows[row][column]);
    let masses = DVector::from_vec(model.mass_matrix_diagonal_kg());
    let roots = masses.map(f64::sqrt);
    let scaled = DMatrix::from_fn(size, size, |row, column| rows[row][column] / (roots[row] * roots[column]));
    // Denman and Beavers' iteration for the root of a positive definite matrix.
    let mut y = scaled;
    let mut z = DMatrix::identity(size, size);
    for _ in 0..40 {
        let (y_inverse, z_inverse) = (y.clone().try_inverse().unwrap(), z.clone().try_inverse().unwrap());
        (y, z) = ((y + z_inverse) * 0.5, (z + y_inverse) * 0.5);
    }
    let damping = DMatrix::from_fn(size, size, |row, column| {
        2.0 * zeta * roots[row] * y[(row, column)] * roots[column]
    });
    let (_, _, g, k_omega) = turning(model, 2, load(4.0, speed));
    let system = DMatrix::from_fn(size, size, |row, column| {
        let mass = if row == column { masses[row] } else { 0.0 };
        let at = (row, column);
        Complex::new(
            stiffness[at] - speed * speed * k_omega[at] - omega * omega * mass,
            omega * (damping[at] + speed * g[at]),
        )
    });
    // The drive as the force that the displacement of a spring alone has at the coordinates: K of this spring
    // on a unit of it.
    let mut drive = DVector::from_element(size, Complex::new(0.0, 0.0));
    let springs: Vec<_> = model.springs().collect();
    for displacement in displacements {
        assert!(springs.contains(&displacement.spring));
        let (sine, cosine) = libm::sincos(displacement.phase.get::<radian>());
        let error = Complex::new(5e-6 * cosine, 5e-6 * sine);
        for place in 0..size {
            drive[place] += error * gradient(model, displacement.spring, place) * 5e8;
        }
    }
    system.lu().solve(&drive).unwrap().iter().copied().collect()
}

/// Elongation of a spring per unit of a coordinate.
fn gradient(model: &Model, spring: epicyclic_vibration::SpringId, place: usize) -> f64 {
    // Modes are a basis: b = Σ (bᵀ·φ)·M·φ.
    let modes = model.modes().unwrap().modes;
    let masses = model.mass_matrix_diagonal_kg();
    let along = |mode: &epicyclic_vibration::Mode| {
        let q: Vec<f64> = model.bodies().flat_map(|body| mode.shape.of(body).unwrap()).collect();
        model.elongation(spring, &mode.shape).unwrap() * masses[place] * q[place]
    };
    modes.iter().map(along).sum()
}

fn flat(model: &Model, response: &Response) -> Vec<Complex<f64>> {
    model
        .bodies()
        .flat_map(|body| {
            let (cosine, sine) = (response.cosine.of(body).unwrap(), response.sine.of(body).unwrap());
            [0, 1, 2].map(|axis| Complex::new(cosine[axis], -sine[axis]))
        })
        .collect()
}

#[test]
fn superposed_modes_are_the_direct_solution() {
    let mut set = lin_parker(4);
    // Nothing turns freely, so that the stiffness is positive definite.
    for central in [&mut set.sun, &mut set.carrier] {
        central.support.tangential = n_m(1e8);
    }
    let (model, parts) = set.planar().unwrap();
    let modes = model.modes().unwrap();
    for teeth in [1.0, 2.0, 4.0] {
        let drive = errors(&parts, teeth);
        for hertz in [100.0, 727.0, 1500.0, 1808.0, 5000.0, 13_000.0] {
            let omega = TAU * hertz;
            let found = flat(&model, &model.response(&modes, &drive, at(omega), 0.02).unwrap());
            let wanted = direct(&model, &drive, omega, 0.02, 0.0);
            let size = wanted.iter().map(Normed::norm).fold(0.0, f64::max);
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found - wanted).norm() < 1e-8 * size, "{teeth} {hertz}: {found} {wanted}");
            }
        }
    }
}

#[test]
fn the_response_of_a_turning_set_is_the_direct_solution() {
    let mut set = lin_parker(4);
    for central in [&mut set.sun, &mut set.carrier] {
        central.support.tangential = n_m(1e8);
    }
    let (model, parts) = set.planar().unwrap();
    let modes = model.modes().unwrap();
    for teeth in [1.0, 2.0, 3.0, 4.0] {
        let drive = errors(&parts, teeth);
        for hertz in [100.0, 727.0, 1500.0, 1808.0, 5000.0, 13_000.0] {
            let omega = TAU * hertz;
            let of = |speed: f64| {
                let load = Centripetal::WithBearingLoad;
                flat(
                    &model,
                    &model.turning_response(&modes, &drive, at(omega), 0.02, at(speed), load).unwrap(),
                )
            };
            let most = |all: &[Complex<f64>]| all.iter().map(Normed::norm).fold(0.0, f64::max);
            let apart = |one: &[Complex<f64>], other: &[Complex<f64>]| {
                let apart = one.iter().zip(other).map(|(one, other)| (one - other).norm());
                apart.fold(0.0, f64::max) / most(other)
            };
            for speed in [300.0, -300.0, 900.0] {
                let wanted = direct(&model, &drive, omega, 0.02, speed);
                assert!(apart(&of(speed), &wanted) < 1e-8, "{teeth} {hertz} {speed}");
            }
            // At rest the superposition of modes.
            let resting = flat(&model, &model.response(&modes, &drive, at(omega), 0.02).unwrap());
            assert!(apart(&of(0.0), &resting) < 1e-9, "{teeth} {hertz}");
            // One and three periods around four planets drive opposite whirls: turning the other way
            // exchanges them, and the speed changes both.
            if teeth == 1.0 {
                assert!(
                    apart(&of(300.0), &resting) > 1e-4 && apart(&of(-300.0), &of(300.0)) > 1e-4,
                    "{hertz}"
                );
            }
        }
    }
}

/// A disc on a round support, driven along `x` of axes that turn: with `z = x + i·y`,
/// `m·(z̈ + 2·i·Ω·ż − Ω²·z) + k·z = k·a·cos(ω·t)`, so that
/// `z = k·a/2·(exp(i·ω·t)/(k − m·(ω + Ω)²) + exp(−i·ω·t)/(k − m·(ω − Ω)²))`.
#[test]
fn a_disc_in_turning_axes_follows_its_closed_form() {
    let mut model = Model::new();
    let disc = model.body("disc", &body(2.0, 3.0, 0.1), Freedom::Translation).unwrap();
    let support = model.support(disc, Support { radial: n_m(2e6), ..Support::default() }).unwrap();
    let modes = model.modes().unwrap();
    let a = 1e-5;
    let drive =
        [Displacement { spring: support[0], amplitude: Length::new::<meter>(a), phase: Angle::default() }];
    for (omega, speed) in [(500.0, 100.0), (500.0, -100.0), (980.0, 50.0), (1500.0, 300.0)] {
        let load = Centripetal::default();
        let response = model.turning_response(&modes, &drive, at(omega), 0.0, at(speed), load).unwrap();
        let [forwards, backwards] =
            [omega + speed, omega - speed].map(|seen| 1e6 * a * 2.0 / 2.0 / (2e6 - 2.0 * seen * seen));
        let [[x, ..], [x_sine, ..]] = [&response.cosine, &response.sine].map(|shape| shape.of(disc).unwrap());
        let [[_, y_cosine, _], [_, y, _]] =
            [&response.cosine, &response.sine].map(|shape| shape.of(disc).unwrap());
        let size = forwards.abs() + backwards.abs();
        assert!((x - (forwards + backwards)).abs() < 1e-10 * size, "{x} {forwards} {backwards}");
        assert!((y - (forwards - backwards)).abs() < 1e-10 * size, "{y} {forwards} {backwards}");
        assert!(x_sine.abs() + y_cosine.abs() < 1e-10 * size);
    }
    // At one of the frequencies that the axes see, without damping.
    let load = Centripetal::default();
    let resonant = model.turning_response(&modes, &drive, at(900.0), 0.0, at(100.0), load).unwrap_err();
    assert_eq!(resonant.name(), "out-of-range", "{resonant}");
    let refused = model.turning_response(&modes, &drive, at(900.0), 0.1, at(f64::NAN), load).unwrap_err();
    assert!(refused.to_string().starts_with("speed of the frame"), "{refused}");
}

/// One mass on one spring: the magnification of a textbook.
#[test]
fn one_mass_follows_its_closed_form() {
    let mut model = Model::new();
    let mass = model.body("mass", &body(2.0, 3.0, 0.1), Freedom::Rotation).unwrap();
    let spring = model.spring("spring", n_m(1200.0), &[(mass, Axis::Rotation, 1.0)]).unwrap();
    let modes = model.modes().unwrap();
    let amplitude = Length::new::<meter>(1e-3);
    let drive = [Displacement { spring, amplitude, phase: Angle::default() }];
    for (ratio, zeta) in [(0.1, 0.05), (1.0, 0.05), (2.0, 0.3), (1.0, 0.01)] {
        let omega_0 = (1200.0_f64 / 3.0).sqrt();
        let response = model.response(&modes, &drive, at(ratio * omega_0), zeta).unwrap();
        let (cosine, sine) = (response.cosine.of(mass).unwrap()[2], response.sine.of(mass).unwrap()[2]);
        let wanted = 1e-3 / ((1.0 - ratio * ratio).powi(2) + (2.0 * zeta * ratio).powi(2)).sqrt();
        assert!((libm::hypot(cosine, sine) / wanted - 1.0).abs() < 1e-12, "{ratio} {zeta}");
        // What holds the mass: k·(q − e) = m·ω²·q less the damping.
        let (re, im) = (1200.0 * (cosine - 1e-3), -1200.0 * sine);
        assert!((response.forces[0].get::<newton>() / libm::hypot(re, im) - 1.0).abs() < 1e-12);
    }
    let resonant = model.response(&modes, &drive, modes.modes[0].omega, 0.0).unwrap_err();
    assert!(matches!(resonant, Error::OutOfRange { .. }), "{resonant}");
}

/// A kind of mode that the phases do not excite stays at rest at its own frequency; an excited one does not.
#[test]
fn phases_choose_what_resonates() {
    let (model, parts) = lin_parker(4).planar().unwrap();
    let modes = model.modes().unwrap();
    let groups = model.groups(&parts.central()).unwrap();
    for group in groups.iter().filter(|group| !group.is_zero()) {
        let most = |teeth: f64, zeta: f64| {
            let response = model.response(&modes, &errors(&parts, teeth), group.omega, zeta).unwrap();
            response.forces.iter().fold(0.0_f64, |most, force| most.max(force.get::<newton>()))
        };
        for (teeth, kind) in [
            (4.0, epicyclic_vibration::Kind::Rotational),
            (1.0, epicyclic_vibration::Kind::Translational),
            (2.0, epicyclic_vibration::Kind::Planet),
        ] {
            // A tenth of the damping raises a resonance tenfold, and nothing else.
            let growth = most(teeth, 1e-5) / most(teeth, 1e-4);
            if group.kind == kind {
                assert!(growth > 3.0, "{teeth} {:?} {growth}", group.kind);
            } else {
                assert!(growth < 1.1, "{teeth} {:?} {growth}", group.kind);
            }
        }
    }
}

#[test]
fn nothing_is_driven_without_a_frequency_or_with_too_much_damping() {
    let (model, parts) = lin_parker(3).planar().unwrap();
    let modes = model.modes().unwrap();
    for (omega, zeta, field) in
        [(0.0, 0.1, "frequency"), (f64::NAN, 0.1, "frequency"), (1.0, 1.1, "damping ratio")]
    {
        let refused = model.response(&modes, &errors(&parts, 1.0), at(omega), zeta).unwrap_err();
        assert!(refused.to_string().starts_with(field), "{refused}");
    }
    let other = lin_parker(4).planar().unwrap().0.modes().unwrap();
    assert_eq!(model.response(&other, &errors(&parts, 1.0), at(1.0), 0.1).unwrap_err().name(), "count");
}
