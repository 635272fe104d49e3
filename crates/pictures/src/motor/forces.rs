//! The forces on the satellites and on the rotor's bearing.

use epicyclic_drawing::{Color, LayerId, Point, Scene, Style, Text};
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::flanks::{FlankForce, Push};
use epicyclic_hydromotor::forces::SatelliteForce;
use epicyclic_hydromotor::satellites::Satellite;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length, Pressure};

use super::chambers::{coloured, direction};
use super::sheet::{AUXILIARY, Sheet, number};
use crate::Error;
use crate::tolerance::BALANCED;

/// Forces of the pressure.
const OF_PRESSURE: Color = Color::new(30, 30, 30);
/// Forces of flanks.
const OF_FLANKS: Color = Color::new(0, 120, 70);
/// Forces on the bearing.
const OF_BEARING: Color = Color::new(170, 80, 0);

/// Forces of so much pressure on a motor of a width, with ideal ports and contacts at the pitch points.
///
/// A satellite's flank forces end at its pitch points, in the lines of action; the force of the pressure
/// begins at its centre. The force on the rotor's bearing begins at the axis. All are to one scale.
///
/// # Errors
/// [`Error::Motor`] for a width or pressure that is not above 0 and flanks that hold no satellite;
/// [`Error::Drawing`] for a motor too large for a drawing.
pub fn forces(
    motor: &Motor,
    pressure_angle: Angle,
    rotation: Angle,
    width: Length,
    pressure_drop: Pressure,
) -> Result<Scene, Error> {
    let satellites = motor.satellites(rotation)?;
    let on_flanks = motor.flank_forces(pressure_angle, rotation, width, pressure_drop)?;
    let of_pressure = motor.satellite_forces(rotation, width, pressure_drop, Pressure::default())?;
    let bearing = motor.bearing_load(pressure_angle, rotation, width, pressure_drop)?;
    let mut sheet = Sheet::new(motor, "forces");
    coloured(&mut sheet, motor, rotation)?;
    let layers = [
        sheet.layer("forces of the pressure", Style::line(0.5).color(OF_PRESSURE))?,
        sheet.layer("forces of flanks", Style::line(0.5).color(OF_FLANKS))?,
        sheet.layer("force on the bearing", Style::line(0.6).color(OF_BEARING))?,
    ];
    let marks = sheet.layer("marks", Style::line(0.2).color(AUXILIARY))?;
    let numbers = sheet.layer("numbers", Style::line(0.12).color(AUXILIARY))?;
    let r = motor.satellite_radius().mm();
    let sizes = on_flanks.iter().map(|one| one.force.si());
    let sizes = sizes.chain(of_pressure.iter().map(|one| one.force.si().abs()));
    let greatest = sizes.chain([bearing.force.si()]).fold(0.0, f64::max);
    // The greatest force is two radii of a satellite long.
    let scale = 2.0 * r / greatest;

    for ((satellite, on_flank), force) in satellites.iter().zip(&on_flanks).zip(&of_pressure) {
        let centre = Point::new(satellite.centre.x.mm(), satellite.centre.y.mm());
        if let Some(frame) = Frame::of(satellite, on_flank, force) {
            let pressure = scale * force.force.si();
            arrow(&mut sheet, layers[0], centre, frame.across(pressure));
            let length = scale * on_flank.force.si();
            for (at, way) in frame.contacts() {
                let tail = Point::new(at.x - length * way[0], at.y - length * way[1]);
                arrow(&mut sheet, layers[1], tail, [length * way[0], length * way[1]]);
                sheet.circle(marks, at, 0.3 * sheet.unit);
            }
        }
        // The side away from the force of the pressure.
        let side = if on_flank.push == Some(Push::Forward) { -0.5 } else { 0.5 };
        let beside =
            Point::polar(centre, 0.55 * r, libm::atan2(centre.y, centre.x) + side * std::f64::consts::PI);
        sheet.scene.add(numbers, Text::new(beside, sheet.letter(), satellite.index.to_string()));
    }
    let is_loaded = bearing.force.si() > BALANCED * greatest;
    if is_loaded {
        let on_axis = [scale * bearing.x.si(), scale * bearing.y.si()];
        arrow(&mut sheet, layers[2], Point::default(), on_axis);
    }
    direction(&mut sheet, marks, 0.5 * motor.envelope().rotor_inner.mm(), rotation.si());

    sheet.column(motor)?;
    sheet.say(&format!("Rotor turned by {}°, running counter-clockwise", number(rotation.degrees())));
    sheet.skip();
    sheet.legend(OF_PRESSURE, "force of the pressure on a satellite");
    sheet.legend(OF_FLANKS, "force of a flank on it, at the pitch point");
    if is_loaded {
        sheet.legend(OF_BEARING, "force of the rotor on its bearing");
    }
    sheet.skip();
    sheet.say("Satellite: pressure, each of both flanks");
    for (on_flank, force) in on_flanks.iter().zip(&of_pressure) {
        let words = if on_flank.push.is_some() {
            format!("{}: {:.0} N, {:.0} N", on_flank.index, force.force.si().abs(), on_flank.force.si())
        } else {
            format!("{}: idle", on_flank.index)
        };
        sheet.say(&words);
    }
    if is_loaded {
        sheet.say(&format!("bearing: {:.0} N", bearing.force.si()));
    } else {
        sheet.say("bearing: none");
    }
    Ok(sheet.scene)
}

/// The frame of a satellite's ray: the axis, through both pitch points.
struct Frame {
    ray: f64,
    /// Middle of the pitch points.
    middle: Point,
    /// Half their distance.
    half: f64,
    sigma: f64,
    inclination: f64,
}

impl Frame {
    /// `None` of one that is idle.
    fn of(satellite: &Satellite, on_flank: &FlankForce, force: &SatelliteForce) -> Option<Self> {
        let sigma = match on_flank.push? {
            Push::Forward => 1.0,
            Push::Back => -1.0,
        };
        let ray = force.ray.si();
        let along = satellite.centre.x.mm() * libm::cos(ray) + satellite.centre.y.mm() * libm::sin(ray);
        Some(Self {
            ray,
            middle: Point::polar(Point::default(), along, ray),
            half: 0.5 * force.chord.mm(),
            sigma,
            inclination: on_flank.inclination.si(),
        })
    }

    /// Rotates a vector from the frame into the drawing.
    fn turned(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = libm::sincos(self.ray);
        [along * cos - across * sin, along * sin + across * cos]
    }

    fn across(&self, length: f64) -> [f64; 2] {
        self.turned([0.0, length])
    }

    /// Pitch points on stator and rotor, and the directions of the forces there on the satellite.
    fn contacts(&self) -> [(Point, [f64; 2]); 2] {
        let (sin, cos) = libm::sincos(self.inclination);
        [(1.0, [-sin, -self.sigma * cos]), (-1.0, [sin, -self.sigma * cos])].map(|(side, way)| {
            let at = Point::polar(self.middle, side * self.half, self.ray);
            (at, self.turned(way))
        })
    }
}

fn arrow(sheet: &mut Sheet, layer: LayerId, from: Point, [dx, dy]: [f64; 2]) {
    let tip = Point::new(from.x + dx, from.y + dy);
    sheet.line(layer, from, tip);
    sheet.arrowhead(layer, tip, libm::atan2(dy, dx));
}
