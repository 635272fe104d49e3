//! Masses and inertias against direct integration of the shapes; no parallel-axis theorem, no powers of
//! radii.

use std::f64::consts::TAU;

use epicyclic_gears::ToothCount;
use epicyclic_gears::carrier::{Arm, Carrier, Hole, Hub};
use epicyclic_gears::geometry::{BasicRack, GearKind, ToothedGear};
use epicyclic_gears::mass::{self, GearBody, MassProperties, TOOTH_FILL};
use proptest::prelude::*;
use uom::si::f64::{Length, MassDensity};
use uom::si::length::{meter, millimeter};
use uom::si::mass::kilogram;
use uom::si::mass_density::kilogram_per_cubic_meter;
use uom::si::moment_of_inertia::kilogram_square_meter;

/// Three-point Gauss–Legendre: exact up to the fifth power, and no integrand here goes beyond the third.
fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (f64::midpoint(from, to), (to - from) / 2.0);
    let offset = half * 0.6_f64.sqrt();
    half * (5.0 * f(middle - offset) + 8.0 * f(middle) + 5.0 * f(middle + offset)) / 9.0
}

/// `∫ dm` and `∫ r²·dm` of a body of revolution whose sections are filled by `fill` between the radii.
fn revolved(from: f64, to: f64, fill: f64, width: f64, density: f64) -> [f64; 2] {
    let shell = |r: f64| density * fill * width * TAU * r;
    [integral(from, to, shell), integral(from, to, |r| shell(r) * r * r)]
}

/// `∫ f dA` over a rectangle.
fn over_rectangle(x: [f64; 2], y: [f64; 2], f: impl Fn(f64, f64) -> f64) -> f64 {
    integral(x[0], x[1], |x| integral(y[0], y[1], |y| f(x, y)))
}

/// `∫ f dA` over a disc: Gauss along the radius, equal steps around, exact for the low harmonics that occur.
fn over_disc(centre_x: f64, radius: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
    const STEPS: u32 = 16;
    integral(0.0, radius, |r| {
        let around = |step| {
            let (sin, cos) = libm::sincos(TAU * f64::from(step) / f64::from(STEPS));
            f(centre_x + r * cos, r * sin)
        };
        r * TAU / f64::from(STEPS) * (0..STEPS).map(around).sum::<f64>()
    })
}

fn mm(value: f64) -> Length {
    Length::new::<millimeter>(value)
}

fn density(value: f64) -> MassDensity {
    MassDensity::new::<kilogram_per_cubic_meter>(value)
}

fn in_si(found: MassProperties) -> [f64; 2] {
    [found.mass.get::<kilogram>(), found.polar_inertia.get::<kilogram_square_meter>()]
}

fn sum(first: [f64; 2], second: [f64; 2]) -> [f64; 2] {
    [first[0] + second[0], first[1] + second[1]]
}

/// Compares two exact results but for rounding; thin rings lose a few digits in differences of powers.
fn agree(found: MassProperties, integrated: [f64; 2]) -> Result<(), TestCaseError> {
    for (found, integrated) in in_si(found).into_iter().zip(integrated) {
        prop_assert!((found / integrated - 1.0).abs() < 1e-9, "{found} against {integrated}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn rings(outer in 20.0_f64..2000.0, bore in 0.0_f64..0.99, width in 1.0_f64..300.0, rho in 500.0_f64..20_000.0) {
        let found = mass::ring(mm(outer), mm(outer * bore), mm(width), density(rho)).unwrap();
        let radius = outer * 5e-4;
        agree(found, revolved(radius * bore, radius, 1.0, width * 1e-3, rho))?;
    }

    #[test]
    fn external_gears(z in 5_u32..200, module in 0.5_f64..20.0, bore in 0.0_f64..0.99, width in 1.0_f64..300.0, rho in 500.0_f64..20_000.0) {
        let gear = ToothedGear::external(mm(module), ToothCount::new(z).unwrap()).unwrap();
        let bore = gear.root_diameter() * bore;
        let body = GearBody::external(&gear, mm(width), bore, density(rho)).unwrap();
        let [tip, root, bore] = [gear.tip_diameter(), gear.root_diameter(), bore].map(|d| d.get::<meter>() / 2.0);
        let teeth = revolved(root, tip, TOOTH_FILL, width * 1e-3, rho);
        let solid = revolved(bore, root, 1.0, width * 1e-3, rho);
        agree(body.tooth_zone, teeth)?;
        agree(body.body, solid)?;
        agree(body.total(), sum(teeth, solid))?;
    }

    #[test]
    fn internal_gears(z in 3_u32..400, module in 0.5_f64..20.0, rim in 1.01_f64..2.0, width in 1.0_f64..300.0, rho in 500.0_f64..20_000.0) {
        let rack = BasicRack { clearance: 0.2, ..BasicRack::default() };
        let gear = ToothedGear::new(GearKind::Internal, mm(module), ToothCount::new(z).unwrap(), rack).unwrap();
        let rim = gear.root_diameter() * rim;
        let body = GearBody::internal(&gear, mm(width), rim, density(rho)).unwrap();
        let [tip, root, rim] = [gear.tip_diameter(), gear.root_diameter(), rim].map(|d| d.get::<meter>() / 2.0);
        let teeth = revolved(tip, root, TOOTH_FILL, width * 1e-3, rho);
        agree(body.total(), sum(teeth, revolved(root, rim, 1.0, width * 1e-3, rho)))?;
    }

    #[test]
    fn carriers(
        arms in 1_u32..8, length in 20.0_f64..500.0, width in 5.0_f64..60.0, thickness in 2.0_f64..60.0,
        hole in 0.05_f64..0.95, place in 0.05_f64..0.95, hub_outer in 80.0_f64..400.0, hub_bore in 0.0_f64..0.95,
        hub_width in 5.0_f64..200.0, rho in 500.0_f64..20_000.0,
    ) {
        let radius = hole * length.min(width) / 2.0;
        let from_outer_end = radius + place * (length - 2.0 * radius);
        let hole = Hole { radius: mm(radius), from_outer_end: mm(from_outer_end) };
        let arm = Arm { length: mm(length), width: mm(width), thickness: mm(thickness), hole: Some(hole) };
        let hub = Hub { outer_radius: mm(hub_outer), inner_radius: mm(hub_outer * hub_bore), width: mm(hub_width) };
        let carrier = Carrier::new(arms, arm, hub, density(rho)).unwrap();

        let [length, width, thickness, radius, from_outer_end, hub_outer, hub_width] =
            [length, width, thickness, radius, from_outer_end, hub_outer, hub_width].map(|value_mm| value_mm * 1e-3);
        let over_arm = |f: &dyn Fn(f64, f64) -> f64| {
            let plate = over_rectangle([hub_outer, hub_outer + length], [-width / 2.0, width / 2.0], f);
            rho * thickness * (plate - over_disc(hub_outer + length - from_outer_end, radius, f))
        };
        let one_arm = [over_arm(&|_, _| 1.0), over_arm(&|x, y| x * x + y * y)];
        agree(carrier.arm(), one_arm)?;
        let centroid = over_arm(&|x, _| x) / one_arm[0];
        prop_assert!((carrier.arm_centroid_radius().get::<meter>() / centroid - 1.0).abs() < 1e-9);
        prop_assert!(((carrier.arm_centroid_radius() + carrier.arm_centroid_from_outer_end()).get::<meter>()
            - hub_outer - length).abs() < 1e-12);
        let hub = revolved(hub_outer * hub_bore, hub_outer, 1.0, hub_width, rho);
        let all_arms = one_arm.map(|one| one * f64::from(arms));
        agree(carrier.total(), sum(all_arms, hub))?;
    }
}
