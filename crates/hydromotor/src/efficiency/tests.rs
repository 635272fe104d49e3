use super::*;
use crate::MotorNumbers;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Area, DynamicViscosity, Length, MassDensity, Pressure};

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

fn omega(value: f64) -> AngularVelocity {
    AngularVelocity::from_si(value)
}

fn motor() -> Motor {
    Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10).unwrap(), mm(0.75), mm(30.0)).unwrap()
}

fn inputs<'a>(gap: f64, friction: [f64; 2]) -> LossInputs<'a> {
    let gap = Length::from_um(gap);
    LossInputs {
        pressure_angle: Angle::from_degrees(25.0),
        width: mm(25.0),
        gaps: EndGaps { satellite: gap, rotor: gap },
        bore_radius: mm(4.0),
        fluid: GapFluid {
            viscosity: DynamicViscosity::from_si(0.04),
            density: MassDensity::from_si(870.0),
            turbulent: None,
        },
        bulk_modulus: None,
        dead_area: Area::from_mm2(0.0),
        friction: FrictionRange::new(friction[0], friction[1]).unwrap(),
        ports: None,
    }
}

#[test]
fn without_gaps_friction_and_compression_nothing_is_lost() {
    let point = motor().operating_point(inputs(0.0, [0.0, 0.0]), omega(20.0), mpa(25.0)).unwrap();
    assert_eq!((point.volumetric, point.mechanical, point.total), (1.0, [1.0; 2], [1.0; 2]));
    // The force balance: the mean of the torque over a revolution.
    let theoretical = motor().theoretical_torque(mm(25.0), mpa(25.0)).unwrap();
    assert!(((point.torque[0] - theoretical) / theoretical).value.abs() < 1e-14);
    assert_eq!(point.inlet_flow, point.ideal_flow);
}

#[test]
fn without_gaps_the_oil_alone_gives_way() {
    let soft = LossInputs { bulk_modulus: Some(mpa(1400.0)), ..inputs(0.0, [0.0, 0.0]) };
    let point = motor().operating_point(soft, omega(20.0), mpa(25.0)).unwrap();
    // 24·26.513·25/1400 over 1292.617.
    assert!((point.volumetric - 1.0 / 1.00879).abs() < 1e-5, "{}", point.volumetric);
    let dead = LossInputs { dead_area: Area::from_mm2(10.0), ..soft };
    assert!(motor().operating_point(dead, omega(20.0), mpa(25.0)).unwrap().volumetric < point.volumetric);
}

#[test]
fn powers_balance() {
    let plate = PortPlate::of_ideal_holes(&motor(), 0.95).unwrap();
    let all = LossInputs {
        bulk_modulus: Some(mpa(1400.0)),
        ports: Some((&plate, 0.6)),
        ..inputs(10.0, [0.04, 0.1])
    };
    let (speed, drop) = (30.0, 20e6);
    let point = motor().operating_point(all, omega(speed), mpa(20.0)).unwrap();
    let entering = point.inlet_flow.value * drop;
    for i in 0..2 {
        let leaving = point.torque[i].value * speed;
        let lost = (point.leakage.total + point.charge).value * drop
            + (point.flank_friction[i] + point.gap_drag).value * speed
            + point.throttling.value;
        assert!(((entering - leaving - lost) / entering).abs() < 1e-12);
        assert!((point.total[i] - leaving / entering).abs() < 1e-12);
    }
    // Each by its own function.
    let through =
        |speed| Through { width: mm(25.0), speed: omega(speed), density: all.fluid.density, discharge: 0.6 };
    let of = |side| plate.throttling(side, through(speed)).unwrap().power.value;
    let both = of(PortSide::High) + of(PortSide::Low);
    assert!((point.throttling.value / both - 1.0).abs() < 1e-12);
    let drag = motor().gap_drag(all.gaps, all.fluid.viscosity, all.bore_radius, omega(speed)).unwrap();
    assert!((point.gap_drag.value / (drag.satellites + drag.rotor).value - 1.0).abs() < 1e-12);
    let friction =
        motor().mean_friction_torque(all.pressure_angle, mm(25.0), mpa(20.0), all.friction).unwrap();
    assert!((point.flank_friction[0].value / friction[1].value - 1.0).abs() < 1e-12);
    assert!((point.flank_friction[1].value / friction[0].value - 1.0).abs() < 1e-12);
}

#[test]
fn every_input_changes_the_point() {
    let plate = PortPlate::of_ideal_holes(&motor(), 0.95).unwrap();
    let base = inputs(10.0, [0.04, 0.1]);
    let soft = LossInputs { bulk_modulus: Some(mpa(1400.0)), ..base };
    let at = |inputs, speed, drop| motor().operating_point(inputs, omega(speed), mpa(drop)).unwrap();
    let um = Length::from_um;
    let fluid = |viscosity: f64, density: f64| GapFluid {
        viscosity: DynamicViscosity::from_si(viscosity),
        density: MassDensity::from_si(density),
        turbulent: None,
    };
    for other in [
        LossInputs { pressure_angle: Angle::from_degrees(22.0), ..base },
        LossInputs { width: mm(26.0), ..base },
        LossInputs { gaps: EndGaps { satellite: um(9.0), ..base.gaps }, ..base },
        LossInputs { gaps: EndGaps { rotor: um(9.0), ..base.gaps }, ..base },
        LossInputs { bore_radius: mm(5.0), ..base },
        LossInputs { fluid: fluid(0.05, 870.0), ..base },
        LossInputs { fluid: fluid(0.04, 900.0), ..base },
        soft,
        LossInputs { friction: FrictionRange::new(0.04, 0.11).unwrap(), ..base },
        LossInputs { ports: Some((&plate, 0.6)), ..base },
    ] {
        assert_ne!(at(other, 20.0, 25.0), at(base, 20.0, 25.0));
    }
    let deeper = LossInputs { dead_area: Area::from_mm2(5.0), ..soft };
    assert_ne!(at(deeper, 20.0, 25.0), at(soft, 20.0, 25.0));
    let ports = |discharge| LossInputs { ports: Some((&plate, discharge)), ..base };
    assert_ne!(at(ports(0.6), 20.0, 25.0), at(ports(0.7), 20.0, 25.0));
    assert_ne!(at(base, 21.0, 25.0), at(base, 20.0, 25.0));
    assert_ne!(at(base, 20.0, 24.0), at(base, 20.0, 25.0));
}

#[test]
fn a_map_has_the_points_of_single_calls() {
    let base = inputs(10.0, [0.04, 0.1]);
    let (speeds, drops) = ([5.0, 20.0, 60.0].map(omega), [10.0, 25.0].map(mpa));
    let map = motor().efficiency_map(base, &speeds, &drops).unwrap();
    assert_eq!((map.rows.len(), map.rows[0].len()), (2, 3));
    for (row, drop) in map.rows.iter().zip(drops) {
        for (point, speed) in row.iter().zip(speeds) {
            assert_eq!(*point, motor().operating_point(base, speed, drop).unwrap());
        }
        // Leaks weigh less, drag more at speed.
        assert!(row[0].volumetric < row[1].volumetric && row[1].volumetric < row[2].volumetric);
        assert!(row[0].mechanical > row[1].mechanical && row[1].mechanical > row[2].mechanical);
    }
    assert!(motor().efficiency_map(base, &[omega(0.0)], &drops).is_err());
    assert!(motor().efficiency_map(base, &speeds, &[mpa(0.0)]).is_err());
    assert_eq!(Figure::Total.origin(), Origin::Model);
    assert_eq!(Figure::Friction.origin(), Origin::Input);
    assert_eq!(Figure::IdealFlow.origin(), Origin::Geometry);
}

#[test]
fn ports_of_another_motor_are_refused() {
    let other = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10).unwrap(), mm(1.0), mm(40.0)).unwrap();
    let plate = PortPlate::of_ideal_holes(&other, 0.95).unwrap();
    let foreign = LossInputs { ports: Some((&plate, 0.6)), ..inputs(10.0, [0.0, 0.1]) };
    assert_eq!(motor().operating_point(foreign, omega(1.0), mpa(1.0)).unwrap_err(), Error::OtherMotor);
}
