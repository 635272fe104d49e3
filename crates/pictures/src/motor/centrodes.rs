//! The centrodes with their construction: centres, distances, radii and angles of the stator's arcs,
//! junctions, satellites.

use std::f64::consts::{PI, TAU};

use epicyclic_drawing::{Color, Dash, Point, Scene, Shape, Style};
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::arcs::StatorArcs;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use super::curve::outline;
use super::sheet::{AUXILIARY, Sheet, millimetres, number};
use crate::Error;

/// Distance outside the stator, over its greatest radius, up to which a centre of arc 1 is drawn.
const REACH: f64 = 1.9;

/// The centrodes after a rotation of the rotor, with what they are constructed from.
///
/// # Errors
/// [`Error::Motor`] for a rotation that is not finite, [`Error::Drawing`] for a motor too large for a
/// drawing.
pub fn centrodes(motor: &Motor, rotation: Angle) -> Result<Scene, Error> {
    let satellites = motor.satellites(rotation)?;
    let (stator, rotor) = (outline(motor, Wheel::Stator)?, outline(motor, Wheel::Rotor)?);
    let envelope = motor.envelope();
    let outer = 0.5 * envelope.stator_outer.mm();
    let centre = Point::new(0.0, 0.0);
    let mut sheet = Sheet::new(motor, "centrodes");
    let stator_layer = sheet.layer("stator", Style::line(0.45))?;
    let rotor_layer = sheet.layer("rotor", Style::line(0.45).color(Color::new(140, 60, 20)))?;
    let satellite_layer = sheet.layer("satellites", Style::line(0.25).color(Color::new(30, 110, 60)))?;
    let axes = sheet.layer("axes", Style::line(0.12).color(AUXILIARY).dash(Dash::DashDot))?;
    let construction = sheet.layer("construction", Style::line(0.15).color(AUXILIARY))?;
    let marks = sheet.layer("junctions", Style::line(0.2).color(Color::new(190, 30, 60)))?;
    let dimensions = sheet.layer("dimensions", Style::line(0.15))?;

    let (deviation, arcs_drawn) = (rotor.deviation_mm, rotor.vertices.len());
    let stator_deviation = stator.deviation_mm;
    let stator_arcs = stator.vertices.len();
    sheet.outline(stator_layer, stator);
    sheet.outline(rotor_layer, rotor.turned(rotation.si()));
    let r = motor.satellite_radius().mm();
    for satellite in &satellites {
        let at = Point::new(satellite.centre.x.mm(), satellite.centre.y.mm());
        sheet.circle(satellite_layer, at, r);
        sheet.circle(satellite_layer, at, 0.35 * sheet.unit);
        for contact in [satellite.on_stator, satellite.on_rotor] {
            sheet.circle(satellite_layer, Point::new(contact.x.mm(), contact.y.mm()), 0.35 * sheet.unit);
        }
    }
    let far = 1.06 * outer;
    sheet.line(axes, Point::new(-far, 0.0), Point::new(far, 0.0));
    sheet.line(axes, Point::new(0.0, -far), Point::new(0.0, far));
    for diameter in [envelope.stator_outer, envelope.stator_inner] {
        sheet.circle(axes, centre, 0.5 * diameter.mm());
    }
    if let Some(arcs) = motor.arcs() {
        junctions(&mut sheet, marks, motor, arcs, rotation)?;
        construct(&mut sheet, construction, motor, arcs, outer);
    }
    across(&mut sheet, dimensions, outer);

    sheet.column(motor)?;
    match (motor.arcs(), motor.harmonic_law()) {
        (Some(arcs), _) => {
            sheet.say("Stator: two arcs a half-lobe, exact");
            say_arcs(&mut sheet, arcs, outer);
        }
        (None, Some(law)) => {
            sheet.say("Rotor by the cosine law, stator conjugate to it");
            sheet.say(&format!("mean radius c = {}", millimetres(law.mean_radius.mm())));
            sheet.say(&format!("relative amplitude ε = {}", number(law.amplitude)));
            if law.second_amplitude != 0.0 {
                sheet.say(&format!("of the second harmonic ε₂ = {}", number(law.second_amplitude)));
            }
            sheet.say(&format!("Stator drawn with {stator_arcs} arcs,"));
            sheet.say(&format!("at most {} mm off the exact curve", below(stator_deviation)));
        }
        (None, None) => {}
    }
    sheet.skip();
    sheet.say(&format!("Rotor: exact curve, drawn with {arcs_drawn} arcs"));
    sheet.say(&format!("at most {} mm off it", below(deviation)));
    sheet.say(&format!("Rotor turned by {}°", number(rotation.degrees())));
    sheet.skip();
    sheet.say("Diameters");
    for (what, diameter) in [
        ("stator, greatest", envelope.stator_outer),
        ("stator, least", envelope.stator_inner),
        ("rotor, greatest", envelope.rotor_outer),
        ("rotor, least", envelope.rotor_inner),
        ("satellite", 2.0 * motor.satellite_radius()),
    ] {
        sheet.say(&format!("{what}: {}", millimetres(diameter.mm())));
    }
    Ok(sheet.scene)
}

/// A bound in plain decimals that a deviation keeps.
fn below(deviation_mm: f64) -> &'static str {
    match deviation_mm {
        d if d <= 0.000_01 => "0.00001",
        d if d <= 0.000_1 => "0.0001",
        d if d <= 0.001 => "0.001",
        _ => "0.01",
    }
}

/// The diameter across the stator's crests, below.
fn across(sheet: &mut Sheet, layer: epicyclic_drawing::LayerId, outer: f64) {
    let unit = sheet.unit;
    let low = -outer - 9.0 * unit;
    for side in [-1.0, 1.0] {
        let x = side * outer;
        sheet.line(layer, Point::new(x, 0.0), Point::new(x, low - 1.5 * unit));
        sheet.arrowhead(layer, Point::new(x, low), if side > 0.0 { 0.0 } else { PI });
    }
    sheet.line(layer, Point::new(-outer, low), Point::new(outer, low));
    let text = format!("Ø {}", number(2.0 * outer));
    let text = epicyclic_drawing::Text::new([0.0, low - 2.2 * unit], sheet.letter(), text);
    sheet.scene.add(layer, text);
}

fn junctions(
    sheet: &mut Sheet,
    layer: epicyclic_drawing::LayerId,
    motor: &Motor,
    arcs: &StatorArcs,
    rotation: Angle,
) -> Result<(), Error> {
    let contact = motor.contact_at_stator_arc(arcs.crest_radius() * arcs.crest_angle().si())?;
    let numbers = motor.numbers();
    let wheels = [
        (numbers.stator_lobes(), contact.stator_radius, contact.stator_angle, 0.0),
        (numbers.rotor_lobes(), contact.rotor_radius, contact.rotor_angle, rotation.si()),
    ];
    for (lobes, radius, angle, turn) in wheels {
        for lobe in 0..lobes {
            for side in [-1.0, 1.0] {
                let polar = turn + side * angle.si() + TAU * f64::from(lobe) / f64::from(lobes);
                let at = Point::polar(Point::default(), radius.mm(), polar);
                // A stroke across the curve, radial: short enough to stay on it.
                let [inner, outside] = [-0.9, 0.9]
                    .map(|by| Point::polar(Point::default(), radius.mm() + by * sheet.unit, polar));
                sheet.circle(layer, at, 0.5 * sheet.unit);
                sheet.line(layer, inner, outside);
            }
        }
    }
    Ok(())
}

/// Draws centres, distances, radii and angles of the first crest and the trough next to it.
fn construct(
    sheet: &mut Sheet,
    layer: epicyclic_drawing::LayerId,
    motor: &Motor,
    arcs: &StatorArcs,
    outer: f64,
) {
    let theta = PI / f64::from(motor.numbers().stator_lobes());
    let (l, a) = (arcs.trough_distance().mm(), arcs.crest_distance().mm());
    let (r1, r2) = (arcs.trough_radius().mm(), arcs.crest_radius().mm());
    let (gamma, beta) = (arcs.trough_angle().si(), arcs.crest_angle().si());
    let o = Point::default();
    let o2 = Point::new(a, 0.0);
    let p = Point::new(a + r2 * libm::cos(beta), r2 * libm::sin(beta));
    let is_near = l <= REACH * outer;
    let reach = if is_near { l } else { 1.15 * outer };
    let o1 = Point::polar(o, l, theta);
    let far = Point::polar(o, reach, theta);
    sheet.line(layer, o, far);
    sheet.line(layer, o, o2);
    sheet.line(layer, o2, p);
    let mark = 0.5 * sheet.unit;
    sheet.circle(layer, o, mark);
    sheet.circle(layer, o2, mark);
    // B between the crest's ray and O₂P.
    let arc_radius = 0.45 * r2;
    sheet.line(layer, o2, Point::new(a + r2, 0.0));
    sheet.scene.add(layer, Shape::Arc { centre: o2, radius: arc_radius, start_rad: 0.0, sweep_rad: beta });
    let middle = |one: Point, other: Point| Point::new(0.5 * (one.x + other.x), 0.5 * (one.y + other.y));
    let mut labels = vec![
        (o, "O"),
        (o2, "O₂"),
        (p, "P"),
        (middle(o, o2), "a"),
        (middle(o2, p), "R₂"),
        (Point::polar(o2, arc_radius, 0.5 * beta), "B"),
    ];
    if is_near {
        sheet.line(layer, p, o1);
        sheet.circle(layer, o1, mark);
        let arc_radius = 0.6 * r1;
        // Γ between O₁O and O₁P; O₁P points along O₁O₂, clockwise of the ray to O seen from outside.
        let start = theta + PI;
        let to_p = libm::atan2(p.y - o1.y, p.x - o1.x);
        let sweep = if turned_from(start, to_p) > 0.0 { gamma } else { -gamma };
        sheet
            .scene
            .add(layer, Shape::Arc { centre: o1, radius: arc_radius, start_rad: start, sweep_rad: sweep });
        labels.push((o1, "O₁"));
        labels.push((middle(p, o1), "R₁"));
        labels.push((Point::polar(o1, arc_radius, start + 0.5 * sweep), "Γ"));
        labels.push((Point::polar(o, 0.5 * l, theta), "l"));
    } else {
        sheet.arrowhead(layer, far, theta);
        labels.push((far, "to O₁"));
    }
    for (at, words) in labels {
        sheet.label(layer, at, words);
    }
}

/// The angle from one direction to another, −π…π.
fn turned_from(from: f64, to: f64) -> f64 {
    (to - from + PI).rem_euclid(TAU) - PI
}

fn say_arcs(sheet: &mut Sheet, arcs: &StatorArcs, outer: f64) {
    let l = arcs.trough_distance().mm();
    sheet.say(&format!("l = {}", millimetres(l)));
    if l > REACH * outer {
        sheet.say("O₁ lies outside the picture");
    }
    sheet.say(&format!("a = {}", millimetres(arcs.crest_distance().mm())));
    sheet.say(&format!("R₁ = {}, about O₁ at the troughs", millimetres(arcs.trough_radius().mm())));
    sheet.say(&format!("R₂ = {}, about O₂ at the crests", millimetres(arcs.crest_radius().mm())));
    sheet.say(&format!(
        "Γ = {}°, B = {}°",
        number(arcs.trough_angle().degrees()),
        number(arcs.crest_angle().degrees())
    ));
    sheet.say("P and its like: where arcs meet");
}
