//! The port plate: what a workshop makes of the ports, with the motor behind it.

use epicyclic_drawing::{Color, Dash, Point, Scene, Shape, Style, Vertex};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::ports::timing::{Stretch, Timing};
use epicyclic_hydromotor::ports::{PortOutline, PortPlate, PortShape};
use epicyclic_hydromotor::quantity::PortSide;
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use super::curve::outline;
use super::sheet::{AUXILIARY, HIGH, LOW, STEEL, Sheet, millimetres, number};
use super::whole::WALL;
use crate::Error;

/// The ports as they are made, on layers of their own, over the centrodes after a rotation of the rotor.
///
/// # Errors
/// [`Error::Motor`] for a rotation that is not finite, [`Error::Drawing`] for a motor too large for a
/// drawing.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::ports::PortPlate;
/// use epicyclic_hydromotor::{Motor, MotorNumbers};
/// use epicyclic_pictures::motor::plate;
/// use uom::si::{angle::degree, f64::{Angle, Length}, length::millimeter};
///
/// let mm = Length::new::<millimeter>;
/// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(0.75), mm(30.0))?;
/// let ports = PortPlate::of_ideal_holes(&motor, 0.9)?;
/// let timing = ports.timing()?;
/// let scene = plate(&ports, &timing, Angle::new::<degree>(10.0))?;
/// assert!(epicyclic_drawing::svg::write(&scene)?.contains("high-pressure ports"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plate(ports: &PortPlate, timing: &Timing, rotation: Angle) -> Result<Scene, Error> {
    let motor = ports.motor();
    let satellites = motor.satellites(rotation)?;
    let centre = Point::default();
    let outer = 0.5 * motor.envelope().stator_outer.mm();
    let mut sheet = Sheet::new(motor, "port plate");
    let edge = sheet.layer("plate", Style::line(0.5).fill(STEEL))?;
    let behind = sheet.layer("motor behind", Style::line(0.15).color(AUXILIARY))?;
    let axes = sheet.layer("axes", Style::line(0.1).color(AUXILIARY).dash(Dash::DashDot))?;
    let high = sheet.layer("high-pressure ports", Style::line(0.4).color(HIGH))?;
    let low = sheet.layer("low-pressure ports", Style::line(0.4).color(LOW))?;

    let wall = outer + (1.25 + WALL) * motor.module().mm();
    sheet.circle(edge, centre, wall);
    for outline in ports.outlines() {
        let (layer, color) = match outline.side {
            PortSide::High => (high, HIGH),
            _ => (low, LOW),
        };
        let style = Style::line(0.4 * sheet.unit).color(color).fill(color.towards(Color::WHITE, 0.6));
        sheet.scene.add_styled(layer, style, closed(&outline));
    }
    sheet.outline(behind, outline(motor, Wheel::Stator)?);
    sheet.outline(behind, outline(motor, Wheel::Rotor)?.turned(rotation.si()));
    for satellite in &satellites {
        let at = Point::new(satellite.centre.x.mm(), satellite.centre.y.mm());
        sheet.circle(behind, at, motor.satellite_radius().mm());
    }
    let far = wall + 2.0 * sheet.unit;
    sheet.line(axes, Point::new(-far, 0.0), Point::new(far, 0.0));
    sheet.line(axes, Point::new(0.0, -far), Point::new(0.0, far));

    sheet.column(motor)?;
    let lobes = motor.numbers().stator_lobes();
    for (side, color, name) in [(PortSide::High, HIGH, "high"), (PortSide::Low, LOW, "low")] {
        sheet.legend(
            color.towards(Color::WHITE, 0.6),
            &format!("{lobes} {name}-pressure ports, one at each crest"),
        );
        words(&mut sheet, ports.shape(side));
        sheet.say(&format!("area {} mm²", number(ports.port_area(side).mm2())));
        sheet.skip();
    }
    sheet.say(&format!("Least land between the pressures: {}", millimetres(ports.land().mm())));
    sheet.say(&format!("Thin lines: the motor behind, rotor turned by {}°", number(rotation.degrees())));
    sheet.skip();
    sheet.say(&format!("A chamber over its cycle of {}° of the rotor,", number(timing.cycle.degrees())));
    sheet.say("counted from where it is greatest:");
    for (name, stretches) in
        [("high", &timing.high), ("low", &timing.low), ("both: short circuit", &timing.short_circuits)]
    {
        for stretch in stretches {
            sheet.say(&format!(
                "{name}: {} to {}°",
                signed(stretch.from.degrees()),
                signed(stretch.to.degrees())
            ));
        }
    }
    for closed in &timing.closed {
        let Stretch { from, to } = closed.stretch;
        sheet.say(&format!("closed: {} to {}°", signed(from.degrees()), signed(to.degrees())));
    }
    Ok(sheet.scene)
}

/// An angle with two decimals and its sign.
fn signed(angle_deg: f64) -> String {
    let text = format!("{angle_deg:.2}");
    if text.trim_start_matches('-').trim_start_matches(['0', '.']).is_empty() {
        return "0".to_owned();
    }
    text.replace('-', "−")
}

fn closed(outline: &PortOutline) -> Shape {
    let vertices = outline
        .vertices
        .iter()
        .map(|vertex| Vertex { at: Point::new(vertex.at.x.mm(), vertex.at.y.mm()), bulge: vertex.bulge });
    Shape::Polyline { vertices: vertices.collect(), closed: true }
}

fn words(sheet: &mut Sheet, shape: PortShape) {
    match shape {
        PortShape::Hole { diameter, pitch_radius, angle } => {
            sheet.say(&format!("hole Ø {}", millimetres(diameter.mm())));
            sheet.say(&format!(
                "on Ø {}, {}° from the crest",
                millimetres(2.0 * pitch_radius.mm()),
                signed(angle.degrees())
            ));
        }
        PortShape::Kidney { inner_radius, outer_radius, angle, span, corner } => {
            let [inner, outer] = [inner_radius, outer_radius].map(|radius| millimetres(radius.mm()));
            sheet.say(&format!("kidney R {inner} to R {outer}, corners R {}", millimetres(corner.mm())));
            sheet.say(&format!(
                "over {}°, middle {}° from the crest",
                number(span.degrees()),
                signed(angle.degrees())
            ));
        }
    }
}
