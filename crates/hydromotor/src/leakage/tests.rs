use super::*;
use crate::MotorNumbers;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::{
    Angle, DynamicViscosity, Length, MassDensity, Pressure, TemperatureCoefficient, TemperatureInterval,
};
use uom::si::volume_rate::liter_per_minute;

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn um(value: f64) -> Length {
    Length::from_um(value)
}

fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

fn fluid(viscosity: f64, turbulent: Option<TurbulentLaw>) -> GapFluid {
    GapFluid {
        viscosity: DynamicViscosity::from_si(viscosity),
        density: MassDensity::from_si(1000.0),
        turbulent,
    }
}

fn gaps(value: f64) -> EndGaps {
    EndGaps { satellite: um(value), rotor: um(value) }
}

fn motor() -> Motor {
    Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10).unwrap(), mm(0.75), mm(30.0)).unwrap()
}

/// Conductance of a disc with `2·pairs` contacts by finite differences in `ln r` and the angle, a quarter of
/// a period with `cells` of them; a bore of a radius lets nothing through.
fn by_differences(pairs: u32, sealed: f64, cells: usize, bore: Option<f64>) -> f64 {
    let sector = PI / (2.0 * f64::from(pairs));
    let step = sector / cells as f64;
    // The pressure falls inwards with r to the power of the pairs: e⁻⁷ of it is left.
    let depth = bore.map_or(7.0 / f64::from(pairs), |bore| -libm::log(bore));
    let rows = (depth / step).round() as usize;
    // Nodes i of the angle 0…cells, rows j inwards from the rim. Between the pressures, at the angle 0, the
    // pressure is 0.
    let width = cells + 1;
    let mut p = vec![0.0_f64; width * (rows + 1)];
    let on_electrode = |i: usize| i as f64 * step > 0.5 * sealed - 1e-9;
    for (i, p) in p.iter_mut().enumerate().take(width) {
        *p = if on_electrode(i) { 0.5 } else { 0.0 };
    }
    let omega = 2.0 / (1.0 + libm::sin(0.5 * PI / cells as f64));
    for _ in 0..30 * cells {
        let mut moved = 0.0_f64;
        for j in 0..=rows {
            for i in 1..width {
                if j == 0 && on_electrode(i) {
                    continue;
                }
                let at = |i: usize, j: usize| p[j * width + i];
                let right = if i + 1 < width { at(i + 1, j) } else { at(i - 1, j) };
                let outer = if j > 0 { at(i, j - 1) } else { at(i, 1) };
                let inner = if j < rows { at(i, j + 1) } else { at(i, j - 1) };
                let change = omega * (0.25 * (right + at(i - 1, j) + outer + inner) - at(i, j));
                p[j * width + i] += change;
                moved = moved.max(change.abs());
            }
        }
        if moved < 1e-10 {
            break;
        }
    }
    // Through one line from the centre to a contact, the end rows by half.
    let row = |j: usize| if j == 0 || j == rows { 0.5 } else { 1.0 };
    let through: f64 = (0..=rows).map(|j| row(j) * p[j * width + 1]).sum();
    2.0 * f64::from(pairs) * through
}

#[test]
fn conductances_are_those_computed_apart() {
    let of = |degrees: f64| disc_conductance(Angle::from_degrees(degrees)).unwrap();
    assert!((of(90.0) - 1.0).abs() < 1e-15);
    assert!((of(36.0) - 1.614_34).abs() < 5e-6);
    assert!((motor().rotor_face_conductance() - 6.7038).abs() < 5e-5);
    for bad in [0.0, 180.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(disc_conductance(Angle::from_degrees(bad)).is_err(), "{bad}");
    }
}

#[test]
fn conductances_are_those_of_finite_differences() {
    for sealed in [TAU / 10.0, 0.25 * TAU, TAU / 20.0] {
        // The corners where rim and sealed angle meet make the error of the first order: two grids remove it.
        let [coarse, fine] = [40, 80].map(|cells| by_differences(1, sealed, cells, None));
        let by_grids = 2.0 * fine - coarse;
        assert!((by_grids / conductance(sealed) - 1.0).abs() < 0.01, "{sealed}: {by_grids}");
    }
    // The rotor of 6×4 with 44 teeth, and with a bore of half its radius, which lets less through by less
    // than a hundredth.
    let cells = 77;
    let whole = by_differences(4, TAU / 44.0, cells, None);
    let exact = 2.0 * (0.5 * TAU / 44.0 / (PI / 8.0) * 77.0_f64).round() * PI / 8.0 / 77.0;
    assert!((exact - TAU / 44.0).abs() < 1e-12);
    assert!((whole / 6.7038 - 1.0).abs() < 0.01, "{whole}");
    let bored = by_differences(4, TAU / 44.0, cells, Some(0.5));
    assert!(bored < whole && bored > 0.99 * whole, "{bored} {whole}");
}

#[test]
fn eight_satellites_leak_what_was_computed_apart() {
    let leakage = motor().end_leakage(gaps(10.0), fluid(0.04, None), mpa(25.0)).unwrap();
    assert_eq!(leakage.loaded_satellites, 8);
    assert!((leakage.satellites.get::<liter_per_minute>() - 0.081).abs() < 5e-4);
    // By hand: 2·6.7038·(10⁻⁵)³·25·10⁶/(12·.04) m³/s.
    let rotor = 2.0 * 6.7038 * 1e-15 * 25e6 / 0.48 * 6e4;
    assert!((leakage.rotor.flow.get::<liter_per_minute>() / rotor - 1.0).abs() < 1e-5);
    assert!(((leakage.total - leakage.satellites - leakage.rotor.flow) / leakage.total).value.abs() < 1e-12);
    // Mean velocity over 7.5 mm by hand, twice the gap as diameter.
    let velocity = 0.5 * leakage.satellite.flow.value / (7.5e-3 * 1e-5);
    assert!((leakage.satellite.reynolds / (1000.0 * velocity * 2e-5 / 0.04) - 1.0).abs() < 1e-12);
    assert_eq!(leakage.satellite.regime, Regime::Laminar);
    let none = motor().end_leakage(gaps(0.0), fluid(0.04, None), mpa(25.0)).unwrap();
    assert_eq!((none.total.value, none.rotor.reynolds), (0.0, 0.0));
}

#[test]
fn water_needs_a_turbulent_law() {
    let refused = motor().end_leakage(gaps(20.0), fluid(0.001, None), mpa(25.0)).unwrap_err();
    let Error::NotLaminar { wheel: WheelKind::Satellite, reynolds, gap_most_um, .. } = refused else {
        panic!("{refused}")
    };
    assert!(reynolds > LAMINAR);
    // The gap that it names is just laminar.
    let at = |gap: f64| {
        let gaps = EndGaps { satellite: um(gap), rotor: um(0.0) };
        motor().end_leakage(gaps, fluid(0.001, None), mpa(25.0))
    };
    assert!((at(0.999_999 * gap_most_um).unwrap().satellite.reynolds / LAMINAR - 1.0).abs() < 1e-5);
    assert!(at(1.000_001 * gap_most_um).is_err());
    let turbulent = |factor, exponent| {
        let law = Some(TurbulentLaw { factor, exponent });
        motor().end_leakage(gaps(20.0), fluid(0.001, law), mpa(25.0))
    };
    let leakage = turbulent(0.316, 0.25).unwrap();
    assert_eq!(leakage.satellite.regime, Regime::Turbulent);
    // The law by its own numbers.
    let flow = leakage.satellite;
    let velocity = 0.5 * flow.flow.value / (20e-6 * 7.5e-3);
    let lambda = 0.316 * libm::pow(flow.reynolds, -0.25);
    let drop = lambda * 7.5e-3 / conductance(TAU / 10.0) * 1000.0 * velocity * velocity / (4.0 * 20e-6);
    assert!((drop / 25e6 - 1.0).abs() < 1e-12, "{drop}");
    for (factor, exponent) in [(0.0, 0.25), (f64::NAN, 0.25), (0.3, -0.1), (0.3, 1.1), (0.3, f64::NAN)] {
        assert!(turbulent(factor, exponent).is_err());
    }
}

proptest! {
    #[test]
    fn the_turbulent_law_contains_the_laminar_one(gap in 25.0..60.0, drop in 20.0..40.0) {
        let law = Some(TurbulentLaw { factor: 96.0, exponent: 1.0 });
        let leakage = motor().end_leakage(gaps(gap), fluid(0.001, law), mpa(drop)).unwrap();
        prop_assert_eq!(leakage.rotor.regime, Regime::Turbulent);
        let laminar = motor().rotor_face_conductance() * 2.0 * (gap * 1e-6).powi(3) * drop * 1e6 / 0.012;
        prop_assert!((leakage.rotor.flow.value / laminar - 1.0).abs() < 1e-12);
    }

    #[test]
    fn leakage_grows_with_the_cube_of_the_gap_and_with_the_pressure(gap in 1.0..9.0, drop in 1.0..12.0) {
        let total = |gap, drop| motor().end_leakage(gaps(gap), fluid(0.04, None), mpa(drop)).unwrap().total.value;
        prop_assert!((total(2.0 * gap, drop) / total(gap, drop) - 8.0).abs() < 1e-9);
        prop_assert!((total(gap, 2.0 * drop) / total(gap, drop) - 2.0).abs() < 1e-9);
    }

    #[test]
    fn a_conductance_and_its_complement_are_inverse(sealed in 0.01..3.1) {
        // Sealed and open parts change places, as the potential and its conjugate do.
        prop_assert!((conductance(sealed) * conductance(PI - sealed) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_warmer_satellite_takes_up_the_play() {
    let expansion = TemperatureCoefficient::from_si(12e-6);
    let play = |warmer: f64| warm_play(um(20.0), expansion, mm(25.0), TemperatureInterval::from_si(warmer));
    // 12·10⁻⁶·25 mm = .3 µm a kelvin.
    assert!((play(20.0).unwrap().um() - 14.0).abs() < 1e-9);
    assert!((play(-10.0).unwrap().um() - 23.0).abs() < 1e-9);
    let Err(Error::PlayClosed { most_k, closed_um, .. }) = play(70.0) else { panic!() };
    assert!((most_k - 20.0 / 0.3).abs() < 1e-9 && (closed_um - 21.0).abs() < 1e-9);
    assert!(play(f64::NAN).is_err());
    assert!(warm_play(um(0.0), expansion, mm(25.0), TemperatureInterval::from_si(1.0)).is_err());
    assert!(warm_play(um(1.0), expansion, mm(0.0), TemperatureInterval::from_si(1.0)).is_err());
    let endless = TemperatureCoefficient::from_si(f64::INFINITY);
    assert!(warm_play(um(1.0), endless, mm(1.0), TemperatureInterval::from_si(1.0)).is_err());
}

#[test]
fn bad_inputs_are_refused() {
    let motor = motor();
    assert!(motor.end_leakage(gaps(-1.0), fluid(0.04, None), mpa(25.0)).is_err());
    assert!(motor.end_leakage(gaps(f64::NAN), fluid(0.04, None), mpa(25.0)).is_err());
    let rotor = EndGaps { satellite: um(1.0), rotor: um(-1.0) };
    let error = motor.end_leakage(rotor, fluid(0.04, None), mpa(25.0)).unwrap_err();
    assert!(matches!(error, Error::OutOfRange { quantity: Quantity::RotorGap, .. }));
    assert!(motor.end_leakage(gaps(1.0), fluid(0.0, None), mpa(25.0)).is_err());
    assert!(motor.end_leakage(gaps(1.0), fluid(0.04, None), mpa(0.0)).is_err());
    let weightless = GapFluid { density: MassDensity::from_si(0.0), ..fluid(0.04, None) };
    assert!(motor.end_leakage(gaps(1.0), weightless, mpa(25.0)).is_err());
    assert!(disc_conductance(Angle::from_si(1.0)).is_ok());
}
