//! Test of the stiffness matrix against the energy of finite positions, which is computed independently here.

use crate::common::lin_parker;
use epicyclic_vibration::PlanetarySet;

/// Energy of all springs at finite displacements: exact involutes on base circles, bearings that turn with
/// their carrier.
///
/// Flank positions along a line of action: a base circle of radius `r` unwinds `r·(θ − φ)`, with `φ` the
/// angle of the tangent point. The line of action is the common tangent of two base circles wherever their
/// centres are.
struct Finite {
    radii: [f64; 4],
    carrier: f64,
    meshes: [f64; 2],
    bearing: f64,
    supports: [[f64; 2]; 3],
    angles: Vec<f64>,
}

impl Finite {
    /// `q`: `x`, `y`, `u` of sun, ring, carrier, planets.
    fn energy(&self, q: &[[f64; 3]]) -> f64 {
        let [r_sun, r_ring, r_planet, _] = self.radii;
        let theta = |index: usize, radius: f64| q[index][2] / radius;
        let mut energy = 0.0;
        for (index, [radial, tangential]) in self.supports.iter().enumerate() {
            let [x, y, u] = q[index];
            energy += 0.5 * (radial * (x * x + y * y) + tangential * u * u);
        }
        for (n, psi) in self.angles.iter().enumerate() {
            let [x, y, _] = q[3 + n];
            let centre = [self.carrier * libm::cos(*psi) + x, self.carrier * libm::sin(*psi) + y];
            let turned = psi + theta(2, self.carrier);
            let pin =
                [q[2][0] + self.carrier * libm::cos(turned), q[2][1] + self.carrier * libm::sin(turned)];
            energy += 0.5 * self.bearing * ((centre[0] - pin[0]).powi(2) + (centre[1] - pin[1]).powi(2));

            let planet = theta(3 + n, r_planet);
            let line = |from: usize, sum: f64| {
                let [dx, dy] = [centre[0] - q[from][0], centre[1] - q[from][1]];
                let distance = libm::hypot(dx, dy);
                let alpha = libm::acos(sum / distance);
                // The angle from this planet's own place keeps the branch.
                let (sin, cos) = libm::sincos(*psi);
                let turn = libm::atan2(cos * dy - sin * dx, cos * dx + sin * dy);
                (distance * libm::sin(alpha), turn, alpha)
            };
            let a = r_sun + r_planet;
            let (length, turn, alpha) = line(0, a);
            let at_rest = libm::acos(a / self.carrier);
            let phi = turn - (alpha - at_rest);
            let grown = length - self.carrier * libm::sin(at_rest);
            let sun = r_sun * (theta(0, r_sun) - phi) + r_planet * (planet - phi) - grown;
            energy += 0.5 * self.meshes[0] * sun * sun;

            let a = r_ring - r_planet;
            let (length, turn, alpha) = line(1, a);
            let at_rest = libm::acos(a / self.carrier);
            let phi = turn + (alpha - at_rest);
            let grown = length - self.carrier * libm::sin(at_rest);
            let ring = grown + r_ring * (theta(1, r_ring) - phi) - r_planet * (planet - phi);
            energy += 0.5 * self.meshes[1] * ring * ring;
        }
        energy
    }
}

/// A set whose pressure angles differ, with planets at uneven angles: base radii follow from them.
fn uneven() -> (PlanetarySet, Finite) {
    let mut set = lin_parker(3);
    let (carrier, planet, alpha_s, alpha_r) = (0.1, 0.048, 24.6_f64, 19.0_f64);
    let (sun, ring) = (
        carrier * libm::cos(alpha_s.to_radians()) - planet,
        carrier * libm::cos(alpha_r.to_radians()) + planet,
    );
    set.sun.body = crate::common::body(0.4, 0.39, sun);
    set.ring.body = crate::common::body(2.35, 3.0, ring);
    set.ring_pressure_angle = crate::common::degrees(alpha_r);
    let angles = [12.0, 140.0, 251.0];
    for (one, angle) in set.planets.iter_mut().zip(angles) {
        one.body = crate::common::body(0.66, 0.61, planet);
        one.angle = crate::common::degrees(angle);
        one.sun_mesh = crate::common::n_m(4e8);
    }
    let finite = Finite {
        radii: [sun, ring, planet, carrier],
        carrier,
        meshes: [4e8, 5e8],
        bearing: 1e8,
        supports: [[1e8, 0.0], [1e8, 1e9], [1e8, 0.0]],
        angles: angles.map(f64::to_radians).to_vec(),
    };
    (set, finite)
}

#[test]
fn the_stiffness_is_the_second_derivative_of_the_energy_of_finite_positions() {
    let (set, finite) = uneven();
    let (model, _) = set.planar().unwrap();
    let matrix = model.stiffness_matrix_n_per_m();
    assert_eq!(matrix.len(), 18);
    let step = 1e-5;
    let at = |moves: &[(usize, f64)]| {
        let mut q = vec![[0.0; 3]; 6];
        for (place, by) in moves {
            q[place / 3][place % 3] += by;
        }
        finite.energy(&q)
    };
    let largest = matrix.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut worst = 0.0_f64;
    for (row, elements) in matrix.iter().enumerate() {
        for (column, element) in elements.iter().enumerate() {
            let signed = |a: f64, b: f64| at(&[(row, a * step), (column, b * step)]);
            let second = (signed(1.0, 1.0) - signed(1.0, -1.0) - signed(-1.0, 1.0) + signed(-1.0, -1.0))
                / (4.0 * step * step);
            worst = worst.max((second - element).abs() / largest);
        }
    }
    // The truncation is of the order (step/radius)²; a wrong sign would show as 1.
    assert!(worst < 1e-6, "{worst}");
}
