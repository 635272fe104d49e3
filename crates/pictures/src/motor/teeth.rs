//! The teeth in mesh: outlines of stator, rotor and satellites in place, with the pitch curves that roll.

use epicyclic_drawing::{Color, Dash, Point, Scene, Shape, Style, Text};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::profile::{self, Profile};
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use super::chambers::direction;
use super::curve::{outline, turned};
use super::sheet::{AUXILIARY, STEEL, Sheet, millimetres, number};
use super::whole::WALL;
use crate::Error;

/// Straight sides of each tooth.
pub const SIDES: u32 = 120;

/// The teeth after a rotation of the rotor.
///
/// Outlines are closed polylines of [`SIDES`] straight sides a tooth, their vertices on the exact curves;
/// what the sides miss is written beside the picture.
///
/// # Errors
/// [`Error::Motor`] for a rotation that is not finite, [`Error::Drawing`] for a motor too large for a
/// drawing.
pub fn teeth(profile: &Profile, rotation: Angle) -> Result<Scene, Error> {
    let motor = profile.motor();
    let satellites = motor.satellites(rotation)?;
    let numbers = motor.numbers();
    let mut sheet = Sheet::new(motor, "teeth");
    let housing = sheet.layer("housing", Style::line(0.4).fill(STEEL.towards(Color::BLACK, 0.12)))?;
    let stator = sheet.layer("stator teeth", Style::line(0.12).fill(Color::WHITE))?;
    let rotor = sheet.layer("rotor teeth", Style::line(0.12).fill(STEEL))?;
    let satellite_layer =
        sheet.layer("satellite teeth", Style::line(0.12).fill(STEEL.towards(Color::WHITE, 0.4)))?;
    let pitch = sheet.layer("pitch curves", Style::line(0.1).color(AUXILIARY).dash(Dash::DashDot))?;
    let marks = sheet.layer("marks", Style::line(0.15).color(AUXILIARY))?;

    let outer = 0.5 * motor.envelope().stator_outer.mm();
    let form = profile.form();
    let wall = outer + (form.addendum + form.clearance + form.shift.max(0.0) + WALL) * motor.module().mm();
    sheet.circle(housing, Point::default(), wall);

    let of = |wheel, teeth: u32| -> Result<(Vec<Point>, f64), Error> {
        let outline = profile.outline(wheel, SIDES * teeth)?;
        let points: Vec<Point> =
            outline.points.iter().map(|point| Point::new(point.x.mm(), point.y.mm())).collect();
        let missed = sagitta(&points, &outline.segments);
        Ok((points, missed))
    };
    let (stator_points, stator_missed) = of(Wheel::Stator, numbers.stator_teeth())?;
    let (rotor_points, rotor_missed) = of(Wheel::Rotor, numbers.rotor_teeth())?;
    let (satellite_points, satellite_missed) = of(Wheel::Satellite, numbers.satellite_teeth())?;
    sheet.scene.add(stator, Shape::polygon(stator_points));
    let turn = rotation.si();
    sheet.scene.add(rotor, Shape::polygon(rotor_points.into_iter().map(|point| turned(point, turn))));
    for satellite in &satellites {
        let (x, y, turn) = (satellite.centre.x.mm(), satellite.centre.y.mm(), satellite.rotation.si());
        let placed = satellite_points.iter().map(|&point| {
            let Point { x: along, y: across } = turned(point, turn);
            Point::new(x + along, y + across)
        });
        sheet.scene.add(satellite_layer, Shape::polygon(placed));
    }
    sheet.outline(pitch, outline(motor, Wheel::Stator)?);
    sheet.outline(pitch, outline(motor, Wheel::Rotor)?.turned(turn));
    for satellite in &satellites {
        let at = Point::new(satellite.centre.x.mm(), satellite.centre.y.mm());
        sheet.circle(pitch, at, motor.satellite_radius().mm());
        sheet.circle(marks, at, 0.3 * sheet.unit);
        let beside = Point::polar(Point::default(), wall + 3.0 * sheet.unit, libm::atan2(at.y, at.x));
        let text = Text::new(beside, sheet.letter(), satellite.index.to_string());
        sheet.scene.add(marks, text);
    }
    direction(&mut sheet, marks, 0.5 * motor.envelope().rotor_inner.mm(), turn);

    sheet.column(motor)?;
    sheet.say(&format!("Rotor turned by {}°", number(rotation.degrees())));
    sheet.skip();
    sheet.say(&format!("Involute satellites, α = {}°", number(form.pressure_angle.degrees())));
    sheet.say("stator and rotor are their envelopes");
    sheet.say(&format!(
        "addendum h_a* = {}, clearance c* = {}",
        number(form.addendum),
        number(form.clearance)
    ));
    sheet.say(&format!("shift x = {}, backlash j* = {}", number(form.shift), number(form.backlash)));
    sheet.say(&format!("rounded tips of the cutters ρ* = {}", number(form.fillet)));
    let [tip, root] = profile.satellite_radii();
    sheet.say(&format!("satellite: tip Ø {}", millimetres(2.0 * tip.mm())));
    sheet.say(&format!("satellite: root Ø {}", millimetres(2.0 * root.mm())));
    sheet.skip();
    let failed = profile.limits().iter().filter(|limit| !limit.holds()).count();
    match failed {
        0 => sheet.say("Every limit of the teeth holds"),
        1 => sheet.say("1 limit of the teeth fails"),
        more => sheet.say(&format!("{more} limits of the teeth fail")),
    }
    sheet.skip();
    let missed = stator_missed.max(rotor_missed).max(satellite_missed);
    sheet.say(&format!("{SIDES} straight sides a tooth,"));
    sheet.say(&format!("about {} mm off the curves", number(round_up(missed))));
    Ok(sheet.scene)
}

/// Rounded up to one digit.
fn round_up(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let digit = libm::pow(10_f64, libm::log10(value).floor());
    (value / digit).ceil() * digit
}

/// Height of the curve beyond its sides: a quarter of the distance of a vertex from the chord of its
/// neighbours, where all three are of one part.
fn sagitta(points: &[Point], segments: &[profile::Segment]) -> f64 {
    let ends = segments.iter().skip(1).map(|segment| segment.start).chain([points.len()]);
    let of_part = |(segment, end): (&profile::Segment, usize)| {
        let triples = points.get(segment.start..end).unwrap_or_default().windows(3);
        triples
            .map(|p| {
                let (dx, dy) = (p[2].x - p[0].x, p[2].y - p[0].y);
                let chord = libm::hypot(dx, dy);
                if chord == 0.0 {
                    0.0
                } else {
                    0.25 * ((p[1].x - p[0].x) * dy - (p[1].y - p[0].y) * dx).abs() / chord
                }
            })
            .fold(0.0, f64::max)
    };
    segments.iter().zip(ends).map(of_part).fold(0.0, f64::max)
}
