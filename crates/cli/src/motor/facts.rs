//! The figures of a motor: numbers and conditions, closure, rotor, working data, ports, size.

use super::design::{Chosen, Drawn, refuse};
use super::{lists, teeth};
use crate::failure::Failure;
use epicyclic_formats::quantity::format;
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::arcs::StatorArcs;
use epicyclic_hydromotor::closure::{Family, Limit, closure};
use epicyclic_hydromotor::numbers::MOST_LOBE_DIFFERENCE;
use epicyclic_views::figure::{Figure, optional, quantity};
use epicyclic_views::report::{Part, Report, Row, Section, wrapped};
use uom::si::f64::{Force, Length};
use uom::si::ratio::ratio;

const NEGLECTED: &str = "Leaks, friction and what they cost of flow, torque and power; the compression \
                         of the fluid, and the real ports, which open by and by; inertia; contact forces and the strength of teeth, \
                         wheels and housing.";

/// The whole answer.
pub(super) fn report(drawn: &Drawn) -> Result<Report, Failure> {
    let motor = &drawn.motor;
    let section = |name, title, rows| Part::Facts(Section { name, title, columns: &[], rows, note: "" });
    let mut parts = vec![section("numbers", "Numbers and their conditions", numbers(motor))];
    match &drawn.family {
        Some(family) => parts.push(section("arcs", arcs_title(drawn.chosen), arcs(motor, family)?)),
        None => parts.push(section("cosine_law", "Rotor by the cosine law", cosine(motor))),
    }
    parts.push(section("rotor", "Rotor: the exact curve, and arcs laid to it", rotor(motor)));
    parts.push(section("work", "Displacement, torque and flow, without losses", work(drawn)?));
    parts.push(section("ports", "Ideal ports in the cover", ports(motor)));
    parts.push(section("size", "Size of the centrodes", size(motor)));
    let mut warnings = vec![];
    parts.push(Part::Records(lists::checks(drawn, &mut warnings)?));
    parts.extend(teeth::parts(drawn, &mut warnings)?);
    parts.push(Part::Records(lists::chambers(drawn)?));
    parts.push(Part::Records(lists::satellites(drawn)?));
    parts.push(Part::Words(format!("Left out\n{}", wrapped("", NEGLECTED))));
    let title = Some(format!("Hydromotor {}", title(motor)));
    Ok(Report { title, parts, warnings: Some(warnings) })
}

fn title(motor: &Motor) -> String {
    let numbers = motor.numbers();
    let module = format::quantity(motor.module(), 6);
    format!(
        "{}×{}: {}/{}/{} teeth of stator, rotor, satellite, module {module}",
        numbers.stator_lobes(),
        numbers.rotor_lobes(),
        numbers.stator_teeth(),
        numbers.rotor_teeth(),
        numbers.satellite_teeth()
    )
}

fn remarked(row: Row, remark: impl Into<String>) -> Row {
    Row { remark: remark.into(), ..row }
}

fn count(name: &'static str, label: &'static str, symbol: &'static str, count: u32) -> Row {
    Row::new(name, label, symbol, [Figure::Count(count)])
}

fn length(name: &'static str, label: &'static str, symbol: &'static str, length: Length) -> Row {
    Row::new(name, label, symbol, [quantity(length)])
}

fn numbers(motor: &Motor) -> Vec<Row> {
    let numbers = motor.numbers();
    let more = numbers.stator_lobes() - numbers.rotor_lobes();
    let limit = f64::from(numbers.stator_teeth() - numbers.rotor_teeth()) / 2.0;
    vec![
        count("stator_lobes", "lobes of the stator", "N", numbers.stator_lobes()),
        remarked(
            count("rotor_lobes", "lobes of the rotor", "n", numbers.rotor_lobes()),
            format!("{more} fewer: 1 to {MOST_LOBE_DIFFERENCE}"),
        ),
        remarked(
            Row::new("lobe_ratio", "their ratio", "N/n", [Figure::Multiple(numbers.lobe_ratio())]),
            "near 1: little ripple",
        ),
        count("stator_teeth", "teeth of the stator", "Z₃", numbers.stator_teeth()),
        count("rotor_teeth", "teeth of the rotor", "Z₁", numbers.rotor_teeth()),
        remarked(
            count("satellite_teeth", "teeth of a satellite", "Z_s", numbers.satellite_teeth()),
            format!("below (Z₃ − Z₁)/2 = {limit}"),
        ),
        remarked(
            count("teeth_per_lobe", "teeth of a lobe", "Z₃/N = Z₁/n", numbers.teeth_per_lobe()),
            "whole: all mesh at once",
        ),
        count("satellites", "satellites, and chambers", "N + n", numbers.satellites()),
        count("common_divisor", "common divisor of N and n", "", numbers.common_divisor()),
        remarked(
            Row::new(
                "bearing_reactions_vanish",
                "wheels' bearings unloaded",
                "",
                [Figure::YesNo(numbers.bearing_reactions_vanish())],
            ),
            "if that is above 1",
        ),
        length("module", "module", "m", motor.module()),
        length("satellite_radius", "pitch radius of a satellite", "r", motor.satellite_radius()),
    ]
}

fn arcs_title(chosen: Chosen) -> &'static str {
    match chosen {
        Chosen::Middle => "Stator of two arcs, in the middle of its family, as nothing else was asked",
        _ => "Stator of two arcs",
    }
}

fn arcs(motor: &Motor, family: &Family) -> Result<Vec<Row>, Failure> {
    let mut rows = vec![];
    let Some(arcs) = motor.arcs() else { return Ok(rows) };
    let angle = |name, label, symbol, angle| Row::new(name, label, symbol, [quantity(angle)]);
    rows.push(length("l", "centre of arc 1 (troughs) from the axis", "l", arcs.trough_distance()));
    rows.push(length("a", "centre of arc 2 (crests) from the axis", "a", arcs.crest_distance()));
    rows.push(length("r1", "radius of arc 1", "R₁", arcs.trough_radius()));
    rows.push(length("r2", "radius of arc 2", "R₂", arcs.crest_radius()));
    rows.push(angle("gamma", "angle of arc 1 at its centre", "Γ", arcs.trough_angle()));
    rows.push(angle("beta", "angle of arc 2 at its centre", "B", arcs.crest_angle()));
    let names = [("family_from", "family_to"), ("second_family_from", "second_family_to")];
    for (interval, (from, to)) in family.intervals().iter().zip(names) {
        for (name, label, end) in
            [(from, "a motor closes from l =", &interval.lower), (to, "… to l =", &interval.upper)]
        {
            let value = optional(end.arcs().map(StatorArcs::trough_distance));
            rows.push(remarked(Row::new(name, label, "", [value]), in_words(end.limit)));
        }
    }
    let closed = closure(motor.numbers(), arcs).map_err(refuse)?;
    // Rounding alone: a power of ten that it keeps within says all.
    let mut within = 1e-12;
    while within < closed.residual_by_quadrature_rad.abs() {
        within *= 10.0;
    }
    let label = "closes, by quadrature, within";
    rows.push(remarked(
        Row::new("closes_by_quadrature_within_rad", label, "", [Figure::Number(within)]),
        "rad a half-lobe",
    ));
    // What a hundredth of a module in a, at the same l, opens.
    rows.push(remarked(
        Row::new(
            "opened_by_a_hundredth_module_rad",
            "opened by 0.01 modules of error in a",
            "",
            [Figure::Number(0.01 * closed.by_crest_distance)],
        ),
        "rad a half-lobe",
    ));
    Ok(rows)
}

fn in_words(limit: Limit) -> &'static str {
    match limit {
        Limit::NoTroughArc => "R₁ vanishes",
        Limit::RotorCusp => "the rotor gets cusps",
        Limit::RadialFlank => "flanks become radial",
        Limit::StraightArc => "no end: arc 1 straight",
    }
}

fn cosine(motor: &Motor) -> Vec<Row> {
    let Some(law) = motor.cosine_law() else { return vec![] };
    vec![
        length("mean_radius", "mean radius of the rotor", "c", law.mean_radius),
        Row::new("amplitude", "relative amplitude", "ε", [Figure::Number(law.amplitude)]),
        Row::new(
            "cusp_amplitude",
            "at which the stator gets cusps",
            "",
            [Figure::Number(law.cusp_amplitude)],
        ),
    ]
}

fn rotor(motor: &Motor) -> Vec<Row> {
    let fit = motor.two_arc_fit();
    let mut rows =
        vec![length("best_arcs_deviation", "best pair of tangent arcs misses it by", "", fit.deviation)];
    if let Some(circles) = motor.published_circles() {
        rows.push(length(
            "published_circles_deviation",
            "the source's circles miss it by",
            "",
            circles.deviation,
        ));
        rows.push(Row::new(
            "published_circles_kink",
            "and meet at an angle of",
            "",
            [quantity(circles.kink)],
        ));
    }
    rows
}

fn work(drawn: &Drawn) -> Result<Vec<Row>, Failure> {
    let motor = &drawn.motor;
    let ripple = motor.ripple();
    let [least, greatest] = motor.chamber_extremes();
    let mut rows = vec![
        Row::new("least_chamber", "least area of a chamber", "A_min", [quantity(least)]),
        Row::new("greatest_chamber", "greatest area of a chamber", "A_max", [quantity(greatest)]),
        Row::new(
            "displacement_per_width",
            "displacement a revolution over width",
            "q/b",
            [quantity(motor.displacement_per_width())],
        ),
        Row::new("ripple", "ripple of flow and torque", "δ", [Figure::Share(ripple.delta)]),
    ];
    let Some(width) = drawn.width else { return Ok(rows) };
    rows.push(length("width", "width", "b", width));
    rows.push(Row::new(
        "displacement",
        "displacement a revolution",
        "q",
        [quantity(motor.displacement(width).map_err(refuse)?)],
    ));
    let [low, high] = [ripple.least, ripple.greatest].map(|flow| (flow / ripple.mean).get::<ratio>());
    if let Some(pressure) = drawn.pressure {
        let torque = motor.theoretical_torque(width, pressure).map_err(refuse)?;
        rows.push(Row::new("pressure", "pressure drop", "Δp", [quantity(pressure)]));
        rows.push(Row::new("torque", "mean torque", "M = qΔp/2π", [quantity(torque)]));
        rows.push(Row::new("least_torque", "least torque", "", [quantity(torque * low)]));
        rows.push(Row::new("greatest_torque", "greatest torque", "", [quantity(torque * high)]));
        let force = pressure * (width * (2.0 * motor.satellite_radius()));
        rows.push(Row::new(
            "greatest_satellite_force",
            "force on a satellite, at most",
            "Δp·b·2r",
            [quantity::<Force>(force)],
        ));
    }
    if let Some(speed) = drawn.speed {
        let flow = motor.mean_flow(width, speed).map_err(refuse)?;
        rows.push(Row::new("speed", "speed of the rotor", "", [quantity(speed)]));
        rows.push(Row::new("flow", "mean flow", "", [quantity(flow)]));
        rows.push(Row::new("least_flow", "least flow", "", [quantity(flow * low)]));
        rows.push(Row::new("greatest_flow", "greatest flow", "", [quantity(flow * high)]));
        if let Some(pressure) = drawn.pressure {
            let power = motor.theoretical_power(width, pressure, speed).map_err(refuse)?;
            rows.push(Row::new("power", "power", "", [quantity(power)]));
        }
    }
    Ok(rows)
}

fn ports(motor: &Motor) -> Vec<Row> {
    let ports = motor.ports();
    let mut rows = vec![count("ports_of_each", "ports of each pressure", "", motor.numbers().stator_lobes())];
    if let (Some(high), Some(low)) = (ports.high.first(), ports.low.first()) {
        rows.push(length("centre_radius", "their centres from the axis", "", high.centre_radius));
        rows.push(Row::new("high_angle", "first at high pressure, from a crest", "", [quantity(high.angle)]));
        rows.push(Row::new("low_angle", "first at low pressure, from a crest", "", [quantity(low.angle)]));
        let hole = high.greatest_diameter;
        let hole = optional((hole > Length::default()).then_some(hole));
        rows.push(Row::new("greatest_diameter", "greatest round hole that a satellite covers", "", [hole]));
    }
    rows.push(Row::new("covered", "rotation for which one is covered", "", [quantity(ports.covered)]));
    rows.push(Row::new("open", "rotation for which it is open", "", [quantity(ports.open)]));
    rows
}

fn size(motor: &Motor) -> Vec<Row> {
    let envelope = motor.envelope();
    let (distance, _) = motor.least_neighbour_distance();
    vec![
        length("stator_outer", "stator, greatest diameter", "", envelope.stator_outer),
        length("stator_inner", "stator, least diameter", "", envelope.stator_inner),
        length("rotor_outer", "rotor, greatest diameter", "", envelope.rotor_outer),
        length("rotor_inner", "rotor, least diameter", "", envelope.rotor_inner),
        length("least_neighbour_distance", "satellites' centres, nearest", "", distance),
        Row::new(
            "displacement_by_volume",
            "displacement over enclosing cylinder",
            "q/V",
            [Figure::Multiple(envelope.displacement_by_volume)],
        ),
    ]
}

/// A length over the module.
pub(super) fn modules(length: Length, module: Length) -> f64 {
    (length / module).get::<ratio>()
}
