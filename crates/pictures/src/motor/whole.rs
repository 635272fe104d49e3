//! The motor at an angle: housing, centrodes, satellites, ports.

use epicyclic_drawing::{Color, Point, Scene, Style, Text};
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use super::chambers::direction;
use super::curve::outline;
use super::sheet::{AUXILIARY, HIGH, LOW, STEEL, Sheet, millimetres, number};
use crate::Error;

/// Wall of the housing that is drawn, outside the stator's roots, in modules.
pub(super) const WALL: f64 = 3.0;

/// The motor after a rotation of the rotor; the ports for running counter-clockwise.
///
/// The housing has room for tooth roots of 1.25 modules and a wall of 3: it is drawn, not designed.
///
/// # Errors
/// [`Error::Motor`] for a rotation that is not finite, [`Error::Drawing`] for a motor too large for a
/// drawing.
pub fn whole(motor: &Motor, rotation: Angle) -> Result<Scene, Error> {
    let satellites = motor.satellites(rotation)?;
    let ports = motor.ports();
    let envelope = motor.envelope();
    let outer = 0.5 * envelope.stator_outer.mm();
    let centre = Point::default();
    let mut sheet = Sheet::new(motor, "motor");
    let housing = sheet.layer("housing", Style::line(0.5).fill(STEEL.towards(Color::BLACK, 0.12)))?;
    let stator = sheet.layer("stator", Style::line(0.45).fill(Color::WHITE))?;
    let high = sheet.layer(
        "ports at high pressure",
        Style::line(0.2).color(HIGH).fill(HIGH.towards(Color::WHITE, 0.35)),
    )?;
    let low = sheet
        .layer("ports at low pressure", Style::line(0.2).color(LOW).fill(LOW.towards(Color::WHITE, 0.35)))?;
    let rotor = sheet.layer("rotor", Style::line(0.45).fill(STEEL))?;
    let satellite_layer =
        sheet.layer("satellites", Style::line(0.3).fill(STEEL.towards(Color::WHITE, 0.5)))?;
    let marks = sheet.layer("marks", Style::line(0.2).color(AUXILIARY))?;

    let wall = outer + (1.25 + WALL) * motor.module().mm();
    sheet.circle(housing, centre, wall);
    sheet.outline(stator, outline(motor, Wheel::Stator)?);
    for (layer, ports) in [(high, &ports.high), (low, &ports.low)] {
        for port in ports {
            let radius = 0.5 * port.greatest_diameter.mm();
            if radius > 0.0 {
                let at = Point::polar(centre, port.centre_radius.mm(), port.angle.si());
                sheet.circle(layer, at, radius);
            }
        }
    }
    sheet.outline(rotor, outline(motor, Wheel::Rotor)?.turned(rotation.si()));
    let r = motor.satellite_radius().mm();
    for satellite in &satellites {
        let at = Point::new(satellite.centre.x.mm(), satellite.centre.y.mm());
        sheet.circle(satellite_layer, at, r);
        sheet.circle(marks, at, 0.3 * sheet.unit);
        let turn = satellite.rotation.si();
        sheet.line(marks, Point::polar(at, 0.3 * r, turn), Point::polar(at, 0.9 * r, turn));
        let beside = Point::polar(centre, wall + 3.0 * sheet.unit, libm::atan2(at.y, at.x));
        let number = Text::new(beside, sheet.letter(), satellite.index.to_string());
        sheet.scene.add(marks, number);
    }
    direction(&mut sheet, marks, 0.5 * envelope.rotor_inner.mm(), rotation.si());
    sheet.column(motor)?;
    sheet.say(&format!("Rotor turned by {}°, running counter-clockwise", number(rotation.degrees())));
    sheet.say("Satellites are numbered; their strokes turn with them");
    sheet.say(&format!("stator, greatest diameter: {}", millimetres(envelope.stator_outer.mm())));
    sheet.say(&format!("housing as drawn: {}", millimetres(2.0 * wall)));
    sheet.skip();
    let diameter = ports.high.first().map_or(0.0, |port| port.greatest_diameter.mm());
    if diameter > 0.0 {
        sheet.legend(HIGH.towards(Color::WHITE, 0.35), "ports at high pressure, in the cover");
        sheet.legend(LOW.towards(Color::WHITE, 0.35), "ports at low pressure, in the cover");
        sheet.say(&format!("round holes of at most {}", millimetres(diameter)));
    } else {
        sheet.say("No round port that a satellite covers");
    }
    sheet.say(&format!("A satellite covers a port for {}°", number(ports.covered.degrees())));
    sheet.say(&format!("and leaves it open for {}°", number(ports.open.degrees())));
    Ok(sheet.scene)
}
