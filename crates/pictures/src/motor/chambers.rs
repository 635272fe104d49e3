//! The motor with its chambers coloured by pressure.

use std::f64::consts::{PI, TAU};

use epicyclic_drawing::{Color, Point, Scene, Shape, Style, Text};
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::chambers::Phase;
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use super::curve::outline;
use super::sheet::{AUXILIARY, HIGH, IDLE, LOW, STEEL, Sheet, number};
use crate::Error;

/// Straight sides for each of a chamber's four walls.
pub const STEPS: u32 = 48;

const fn color(phase: Phase) -> Color {
    match phase {
        Phase::Filling => HIGH,
        Phase::Emptying => LOW,
        Phase::AtExtreme => IDLE,
    }
}

/// The motor after a rotation of the rotor, each chamber filled with the colour of its pressure;
/// counter-clockwise running.
///
/// # Errors
/// [`Error::Motor`] for a rotation that is not finite, [`Error::Drawing`] for a motor too large for a
/// drawing.
pub fn chambers(motor: &Motor, rotation: Angle) -> Result<Scene, Error> {
    let all = motor.chambers(rotation)?;
    let outer = 0.5 * motor.envelope().stator_outer.mm();
    let mut sheet = Sheet::new(motor, "chambers");
    let unit = sheet.unit;
    let middles = coloured(&mut sheet, motor, rotation)?;
    let marks = sheet.layer("marks", Style::line(0.2).color(AUXILIARY))?;
    let leaders = sheet.layer("numbers", Style::line(0.12).color(AUXILIARY))?;
    let r = motor.satellite_radius().mm();
    for satellite in motor.satellites(rotation)? {
        let at = Point::new(satellite.centre.x.mm(), satellite.centre.y.mm());
        sheet.line(marks, at, Point::polar(at, 0.8 * r, satellite.rotation.si()));
    }
    direction(&mut sheet, marks, 0.5 * motor.envelope().rotor_inner.mm(), rotation.si());

    for (chamber, wall) in all.iter().zip(middles) {
        let angle = libm::atan2(wall.y, wall.x);
        let at = |radius: f64| Point::polar(Point::default(), radius, angle);
        sheet.line(leaders, at(libm::hypot(wall.x, wall.y) + unit), at(outer + 2.0 * unit));
        let text = Text::new(at(outer + 5.0 * unit), sheet.letter(), chamber.index.to_string());
        sheet.scene.add(leaders, text);
    }

    sheet.column(motor)?;
    sheet.say(&format!("Rotor turned by {}°, running counter-clockwise", number(rotation.degrees())));
    sheet.skip();
    sheet.legend(HIGH.towards(Color::WHITE, 0.35), "filling: high pressure");
    sheet.legend(LOW.towards(Color::WHITE, 0.35), "emptying: low pressure");
    sheet.legend(IDLE.towards(Color::WHITE, 0.35), "changing over: at its greatest or least");
    sheet.skip();
    sheet.say("Chamber: area, and what it gains a degree");
    let total: f64 = all.iter().map(|chamber| chamber.area.mm2()).sum();
    for chamber in &all {
        let growth = chamber.growth.mm2() * PI / 180.0;
        let growth = if Phase::of(chamber, &all) == Phase::AtExtreme { 0.0 } else { growth };
        let words = format!("{}: {} mm², {:+.3} mm²", chamber.index, number(chamber.area.mm2()), growth);
        sheet.say(&words.replace('-', "−"));
    }
    sheet.say(&format!("together: {} mm²", number(total)));
    Ok(sheet.scene)
}

/// Chambers in the colours of their pressures, stator, rotor and satellites; a point on the stator's wall of
/// each chamber.
pub(super) fn coloured(sheet: &mut Sheet, motor: &Motor, rotation: Angle) -> Result<Vec<Point>, Error> {
    let all = motor.chambers(rotation)?;
    let layers = [
        (Phase::Filling, "chambers at high pressure"),
        (Phase::Emptying, "chambers at low pressure"),
        (Phase::AtExtreme, "chambers changing over"),
    ];
    let mut chamber_layers = vec![];
    for (phase, name) in layers {
        let color = color(phase);
        let tint = color.towards(Color::WHITE, 0.35);
        chamber_layers.push((phase, sheet.layer(name, Style::line(0.1).color(color).fill(tint))?));
    }
    let stator = sheet.layer("stator", Style::line(0.45))?;
    let rotor = sheet.layer("rotor", Style::line(0.45).fill(STEEL))?;
    let satellite_layer =
        sheet.layer("satellites", Style::line(0.3).fill(STEEL.towards(Color::WHITE, 0.5)))?;

    let mut middles = vec![];
    for chamber in &all {
        let points = motor.chamber_outline(rotation, chamber.index, STEPS)?;
        let points: Vec<Point> = points.iter().map(|point| Point::new(point.x.mm(), point.y.mm())).collect();
        // The stator's wall comes first.
        middles.push(points[(STEPS / 2) as usize]);
        let phase = Phase::of(chamber, &all);
        for (of, layer) in &chamber_layers {
            if *of == phase {
                sheet.scene.add(*layer, Shape::polygon(points.iter().copied()));
            }
        }
    }
    sheet.outline(stator, outline(motor, Wheel::Stator)?);
    sheet.outline(rotor, outline(motor, Wheel::Rotor)?.turned(rotation.si()));
    let r = motor.satellite_radius().mm();
    for satellite in motor.satellites(rotation)? {
        sheet.circle(satellite_layer, Point::new(satellite.centre.x.mm(), satellite.centre.y.mm()), r);
    }
    Ok(middles)
}

/// The rotor's crest, and an arrow the way that it turns.
pub(super) fn direction(sheet: &mut Sheet, layer: epicyclic_drawing::LayerId, inner: f64, rotation: f64) {
    let centre = Point::default();
    let rotation = rotation.rem_euclid(TAU);
    sheet.circle(layer, centre, 0.4 * sheet.unit);
    let radius = 0.55 * inner;
    sheet.line(
        layer,
        Point::polar(centre, 0.7 * inner, rotation),
        Point::polar(centre, 0.95 * inner, rotation),
    );
    let (start, sweep) = (rotation - 0.9, 1.8);
    sheet.scene.add(layer, Shape::Arc { centre, radius, start_rad: start, sweep_rad: sweep });
    let end = start + sweep;
    // A chord of the head's length turns half of what it spans.
    let lean = sheet.unit / radius;
    sheet.arrowhead(layer, Point::polar(centre, radius, end), end + PI / 2.0 - lean);
}
