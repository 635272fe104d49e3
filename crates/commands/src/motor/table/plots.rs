//! Pressure, stress and efficiency of a motor as plots.

use crate::motor::answer::{EfficiencyMap, OverCycle};
use epicyclic_pictures::contours::Contours;
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_units::Dimension;

/// A curve, with gaps where there is no value.
fn points(cycle: &OverCycle, values: &[Option<f64>]) -> Vec<[f64; 2]> {
    let (degree, megapascal) =
        (Dimension::Angle.usual_unit().factor, Dimension::Pressure.usual_unit().factor);
    let values = values.iter().map(|value| value.unwrap_or(f64::NAN) / megapascal);
    cycle.phases_rad.iter().map(|phase| phase / degree).zip(values).map(<[f64; 2]>::from).collect()
}

/// Pressure in a chamber; nothing where it is not known.
pub(crate) fn pressure(cycle: &OverCycle) -> Option<Plot> {
    if cycle.chamber_pressures_pa.is_empty() {
        return None;
    }
    let plot = Plot::new(
        "Pressure in a chamber over its cycle",
        "angle of the rotor from the greatest chamber, deg",
        "over the low pressure, MPa",
    );
    Some(plot.with(Curve::new("chamber", points(cycle, &cycle.chamber_pressures_pa))))
}

/// Contact stress of a satellite; nothing without teeth or pressure.
pub(crate) fn stress(cycle: &OverCycle) -> Option<Plot> {
    if cycle.stator_contact_pa.is_empty() {
        return None;
    }
    let plot = Plot::new(
        "Contact stress at the pitch points of a satellite",
        "angle of the rotor from the satellite at a crest, deg",
        "MPa",
    );
    Some(
        plot.with(Curve::new("with the stator", points(cycle, &cycle.stator_contact_pa)))
            .with(Curve::new("with the rotor", points(cycle, &cycle.rotor_contact_pa))),
    )
}

/// Total efficiency as lines of equal value, with the greatest friction.
pub(crate) fn efficiency(map: &EfficiencyMap) -> Contours {
    let (rpm, megapascal) =
        (Dimension::AngularSpeed.usual_unit().factor, Dimension::Pressure.usual_unit().factor);
    let columns = 0..map.speeds_rad_s.len();
    let values = columns.flat_map(|place| map.total.iter().map(move |row| row.get(place).copied()));
    Contours {
        title: "Total efficiency, by the models and inputs given".to_owned(),
        across: "speed of the rotor, rpm".to_owned(),
        up: "pressure drop, MPa".to_owned(),
        columns: map.speeds_rad_s.iter().map(|speed| speed / rpm).collect(),
        rows: map.pressures_pa.iter().map(|pressure| pressure / megapascal).collect(),
        values: values.collect(),
    }
}
