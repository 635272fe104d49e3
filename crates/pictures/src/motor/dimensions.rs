//! The motor for a drawing office: its dimensions with their lines, and a table of wheel data.
//!
//! Dimension lines as in ISO 129-1: thin, closed arrowheads, the number above the line in millimetres;
//! diameters with `Ø`, radii with `R`. The table has a column for tolerances and lines for material and
//! finish that are left blank: the program chooses neither.

use std::f64::consts::{FRAC_PI_2, PI};

use epicyclic_drawing::{Align, Color, Dash, LayerId, Point, Scene, Shape, Style, Text, text};
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::profile::Profile;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use super::curve::outline;
use super::sheet::{AUXILIARY, Sheet, name, number};
use crate::Error;

/// Distance from the drawing to the first dimension line, and from line to line, in units of the sheet.
const FIRST: f64 = 8.0;
const NEXT: f64 = 6.0;
/// Length and half the width of an arrowhead.
const ARROW: [f64; 2] = [2.2, 0.4];
/// Height of a row of the table, over that of its letters.
const ROW: f64 = 2.0;
/// Largest distance of a centre of arc 1 that is still shown, over the stator's greatest radius.
const REACH: f64 = 1.5;

/// The motor with its dimensions after a rotation of the rotor; the table shows teeth and width if they are
/// given.
///
/// # Errors
/// [`Error::Motor`] for a rotation that is not finite, [`Error::Drawing`] for a motor too large for a
/// drawing.
pub fn dimensions(
    motor: &Motor,
    profile: Option<&Profile>,
    width: Option<Length>,
    rotation: Angle,
) -> Result<Scene, Error> {
    let satellites = motor.satellites(rotation)?;
    let envelope = motor.envelope();
    let centre = Point::default();
    let mut sheet = Sheet::new(motor, "dimensions");
    let body = sheet.layer("outlines", Style::line(0.5))?;
    let ports_layer = sheet.layer("ports", Style::line(0.3))?;
    let axes = sheet.layer("axes", Style::line(0.13).color(AUXILIARY).dash(Dash::DashDot))?;
    let layer = sheet.layer("dimensions", Style::line(0.18))?;
    let table = sheet.layer("table", Style::line(0.18))?;

    sheet.outline(body, outline(motor, Wheel::Stator)?);
    sheet.outline(body, outline(motor, Wheel::Rotor)?.turned(rotation.si()));
    let r = motor.satellite_radius().mm();
    let places: Vec<Point> =
        satellites.iter().map(|one| Point::new(one.centre.x.mm(), one.centre.y.mm())).collect();
    for at in &places {
        sheet.circle(body, *at, r);
        for [dx, dy] in [[0.3 * r, 0.0], [0.0, 0.3 * r]] {
            sheet.line(axes, Point::new(at.x - dx, at.y - dy), Point::new(at.x + dx, at.y + dy));
        }
    }
    let ports = motor.ports();
    let round: Vec<(Point, f64)> = ports
        .high
        .iter()
        .chain(&ports.low)
        .map(|port| {
            let at = Point::polar(centre, port.centre_radius.mm(), port.angle.si());
            (at, 0.5 * port.greatest_diameter.mm())
        })
        .filter(|(_, radius)| *radius > 0.0)
        .collect();
    for (at, radius) in &round {
        sheet.circle(ports_layer, *at, *radius);
    }
    let outer = 0.5 * envelope.stator_outer.mm();
    let far = 1.04 * outer;
    sheet.line(axes, Point::new(-far, 0.0), Point::new(far, 0.0));
    sheet.line(axes, Point::new(0.0, -far), Point::new(0.0, far));

    // Diameters below, the smallest nearest; one that leaves no room for its number is given in the table
    // alone.
    let curves = [envelope.rotor_inner, envelope.rotor_outer, envelope.stator_inner, envelope.stator_outer]
        .map(Physical::mm);
    let mut diameters: Vec<(f64, String)> =
        curves.into_iter().map(|diameter| (diameter, format!("Ø{}", number(diameter)))).collect();
    if !round.is_empty() {
        let circle = ports.high.first().map(|port| 2.0 * port.centre_radius.mm());
        diameters.extend(circle.map(|diameter| (diameter, format!("ports on Ø{}", number(diameter)))));
    }
    diameters.sort_by(|one, other| one.0.total_cmp(&other.0));
    let room = 2.0 * ARROW[0] * sheet.unit;
    let fits = |(diameter, words): &(f64, String)| {
        Text::new(centre, sheet.letter(), words.as_str()).width_mm() + room < *diameter
    };
    let shown: Vec<(f64, String)> = diameters.into_iter().filter(fits).collect();
    for (place, (diameter, words)) in shown.into_iter().enumerate() {
        let y = -outer - (FIRST + NEXT * place as f64) * sheet.unit;
        let radius = 0.5 * diameter;
        sheet.circle(axes, centre, radius);
        for side in [-1.0, 1.0] {
            let x = side * radius;
            sheet.line(layer, Point::new(x, 0.0), Point::new(x, y - 1.2 * sheet.unit));
            arrow(&mut sheet, layer, Point::new(x, y), if side > 0.0 { 0.0 } else { PI });
        }
        sheet.line(layer, Point::new(-radius, y), Point::new(radius, y));
        let at = Point::new(0.0, y + 0.9 * sheet.letter());
        sheet.scene.add(layer, Text::new(at, sheet.letter(), words));
    }
    radii(&mut sheet, layer, axes, motor, outer);
    if !places.is_empty() {
        let words = format!("{}× Ø{}", places.len(), number(2.0 * r));
        called(&mut sheet, layer, &places, r, &words, outer);
    }
    if let Some((_, radius)) = round.first() {
        let words = format!("{}× Ø{}", round.len(), number(2.0 * radius));
        let at: Vec<Point> = round.iter().map(|port| port.0).collect();
        called(&mut sheet, layer, &at, *radius, &words, outer);
    }
    wheel_data(&mut sheet, table, motor, profile, width, places.len());
    Ok(sheet.scene)
}

/// A closed arrowhead that points in a direction.
fn arrow(sheet: &mut Sheet, layer: LayerId, tip: Point, direction_rad: f64) {
    let [length, half] = ARROW.map(|part| part * sheet.unit);
    let foot = Point::polar(tip, -length, direction_rad);
    let wing = |side: f64| Point::polar(foot, side * half, direction_rad + FRAC_PI_2);
    let head = Shape::polygon([tip, wing(1.0), wing(-1.0)]);
    sheet.scene.add_styled(layer, Style::filled(Color::BLACK), head);
}

/// Radii of both arcs with their centres, as far as these are near, and the distances of these centres.
fn radii(sheet: &mut Sheet, layer: LayerId, axes: LayerId, motor: &Motor, outer: f64) {
    let Some(arcs) = motor.arcs() else { return };
    let theta = PI / f64::from(motor.numbers().stator_lobes());
    let (l, a) = (arcs.trough_distance().mm(), arcs.crest_distance().mm());
    let (r1, r2) = (arcs.trough_radius().mm(), arcs.crest_radius().mm());
    let centre = Point::default();
    let unit = sheet.unit;
    let cross = |sheet: &mut Sheet, at: Point| {
        for [dx, dy] in [[1.2 * unit, 0.0], [0.0, 1.2 * unit]] {
            sheet.line(axes, Point::new(at.x - dx, at.y - dy), Point::new(at.x + dx, at.y + dy));
        }
    };
    // The crest on the x axis: from its centre to the arc, the number outside.
    let crest = Point::new(a, 0.0);
    let turn = 0.5 * arcs.crest_angle().si();
    cross(sheet, crest);
    let tip = Point::polar(crest, r2, turn);
    let end = Point::polar(crest, r2 + 0.1 * outer + 4.0 * unit, turn);
    sheet.line(layer, crest, end);
    arrow(sheet, layer, tip, turn);
    let mut numbers = vec![(end, format!("R{}", number(r2)))];
    // The trough beside it: its centre lies outside.
    let at = Point::polar(centre, l, theta);
    let tip = Point::polar(centre, l - r1, theta);
    let start = if l <= REACH * outer {
        cross(sheet, at);
        at
    } else {
        Point::polar(centre, 1.12 * outer, theta)
    };
    sheet.line(layer, start, tip);
    arrow(sheet, layer, tip, theta + PI);
    numbers.push((start, format!("R{}", number(r1))));
    // Distances of the centres: that of the crest above, that of the trough along its ray.
    let y = outer + FIRST * unit;
    for x in [0.0, a] {
        sheet.line(layer, Point::new(x, 0.0), Point::new(x, y + 1.2 * unit));
    }
    // Between narrow extension lines the arrows are outside.
    let wide = a > 8.0 * unit;
    let [low, high] = if wide { [0.0, a] } else { [-4.0 * unit, a + 4.0 * unit] };
    sheet.line(layer, Point::new(low, y), Point::new(high, y));
    arrow(sheet, layer, Point::new(0.0, y), if wide { PI } else { 0.0 });
    arrow(sheet, layer, Point::new(a, y), if wide { 0.0 } else { PI });
    numbers.push((Point::new(high.max(a + unit), y), format!("a = {}", number(a))));
    trough_distance(sheet, layer, motor, l, outer, &mut numbers);
    // Numbers without room are given in the table.
    for (at, words) in numbers {
        sheet.label(layer, at, &words);
    }
}

/// The distance `l` of a trough's centre from the axis: of one on the left above the drawing, else of one
/// above to the left of it, else along its own ray. Of a centre too far away the line ends before it, without
/// an arrowhead.
fn trough_distance(
    sheet: &mut Sheet,
    layer: LayerId,
    motor: &Motor,
    l: f64,
    outer: f64,
    numbers: &mut Vec<(Point, String)>,
) {
    let lobes = motor.numbers().stator_lobes();
    let unit = sheet.unit;
    // Troughs are at odd multiples of π/N.
    let (ray, is_beside) = match lobes % 4 {
        1 | 3 => (PI, true),
        2 => (FRAC_PI_2, true),
        _ => (PI - PI / f64::from(lobes), false),
    };
    let aside = if lobes % 2 == 1 { FRAC_PI_2 } else { PI };
    let y = if is_beside { outer + FIRST * unit } else { 0.0 };
    let at = |along: f64, off: f64| Point::polar(Point::polar(Point::default(), along, ray), off, aside);
    let is_near = l <= REACH * outer;
    let end = if is_near { l } else { 1.25 * outer };
    if is_beside {
        sheet.line(layer, at(0.0, 0.0), at(0.0, y + 1.2 * unit));
    }
    if is_near && is_beside {
        sheet.line(layer, at(l, 0.0), at(l, y + 1.2 * unit));
    }
    sheet.line(layer, at(0.0, y), at(end, y));
    arrow(sheet, layer, at(0.0, y), ray + PI);
    if is_near {
        arrow(sheet, layer, at(l, y), ray);
    }
    numbers.push((at(if is_beside { 0.5 * end } else { end }, y), format!("l = {}", number(l))));
}

/// A circle of several equal ones with its number outside: at the first that has room for it.
fn called(sheet: &mut Sheet, layer: LayerId, places: &[Point], radius: f64, words: &str, outer: f64) {
    for at in places {
        let direction = libm::atan2(at.y, at.x);
        for lean in [0.0, 0.15, -0.15, 0.3, -0.3] {
            let tip = Point::polar(*at, radius, direction + lean);
            let end = Point::polar(Point::default(), 1.12 * outer, (libm::atan2(tip.y, tip.x)) + 0.5 * lean);
            let left = end.x < 0.0;
            let align = if left { Align::Right } else { Align::Left };
            let to = Point::new(end.x + if left { -1.0 } else { 1.0 } * sheet.unit, end.y);
            let label = Text::new(to, sheet.letter(), words).align(align);
            let line = Shape::line(tip, end);
            let mut others = sheet.scene.items().iter().filter_map(|item| match &item.shape {
                Shape::Text(text) => Some(text.bounds()),
                _ => None,
            });
            let clear = 0.5 * sheet.letter();
            // The leader of the label comes from the drawing and must end before the words.
            if text::is_free(&sheet.scene, &label, clear)
                && !text::line_meets(&line, label.bounds())
                && !others.any(|other| text::line_meets(&line, other))
            {
                sheet.line(layer, tip, end);
                let back = libm::atan2(tip.y - end.y, tip.x - end.x);
                arrow(sheet, layer, tip, back);
                sheet.scene.add(layer, label);
                return;
            }
        }
    }
}

/// The table of wheel data to the right, in rows of name, value and a blank for the tolerance.
fn wheel_data(
    sheet: &mut Sheet,
    layer: LayerId,
    motor: &Motor,
    profile: Option<&Profile>,
    width: Option<Length>,
    satellites: usize,
) {
    let numbers = motor.numbers();
    let envelope = motor.envelope();
    let length = |value: Length| number(value.mm());
    let mut rows: Vec<(String, String)> = vec![];
    let mut say = |what: &str, value: String| rows.push((what.to_owned(), value));
    say("Lobes, stator N / rotor n", format!("{} / {}", numbers.stator_lobes(), numbers.rotor_lobes()));
    say(
        "Teeth, stator / rotor / satellite",
        format!("{} / {} / {}", numbers.stator_teeth(), numbers.rotor_teeth(), numbers.satellite_teeth()),
    );
    say("Satellites", satellites.to_string());
    say("Module m", length(motor.module()));
    match profile {
        Some(profile) => {
            let form = profile.form();
            let [tip, root] = profile.satellite_radii();
            say("Pressure angle α", format!("{}°", number(form.pressure_angle.degrees())));
            say("Profile shift x", number(form.shift));
            say(
                "Addendum h_a*, clearance c*",
                format!("{}, {}", number(form.addendum), number(form.clearance)),
            );
            say(
                "Backlash j*, cutter's tip radius ρ*",
                format!("{}, {}", number(form.backlash), number(form.fillet)),
            );
            say("Satellite, tip Ø", length(2.0 * tip));
            say("Satellite, root Ø", length(2.0 * root));
            say("Satellite, tooth height", length(tip - root));
        }
        None => say("Teeth of the form given", "none".to_owned()),
    }
    say("Satellite, pitch Ø", length(2.0 * motor.satellite_radius()));
    say("Stator, pitch curve: greatest Ø", length(envelope.stator_outer));
    say("Stator, pitch curve: least Ø", length(envelope.stator_inner));
    say("Rotor, pitch curve: greatest Ø", length(envelope.rotor_outer));
    say("Rotor, pitch curve: least Ø", length(envelope.rotor_inner));
    match (motor.arcs(), motor.harmonic_law()) {
        (Some(arcs), _) => {
            say("Arc 1 (troughs): radius R₁", length(arcs.trough_radius()));
            say("  centre from the axis l", length(arcs.trough_distance()));
            say("  angle Γ", format!("{}°", number(arcs.trough_angle().degrees())));
            say("Arc 2 (crests): radius R₂", length(arcs.crest_radius()));
            say("  centre from the axis a", length(arcs.crest_distance()));
            say("  angle B", format!("{}°", number(arcs.crest_angle().degrees())));
        }
        (None, Some(law)) => {
            say("Rotor by the cosine law: mean radius c", length(law.mean_radius));
            say("  relative amplitude ε", number(law.amplitude));
            if law.second_amplitude != 0.0 {
                say("  of the second harmonic ε₂", number(law.second_amplitude));
            }
        }
        (None, None) => {}
    }
    let ports = motor.ports();
    if let Some(port) = ports.high.first().filter(|port| port.greatest_diameter.mm() > 0.0) {
        say("Ports, high / low pressure", format!("{} / {}", ports.high.len(), ports.low.len()));
        say("  Ø at most", length(port.greatest_diameter));
        say("  on Ø", length(2.0 * port.centre_radius));
    }
    say("Width of the wheels", width.map_or_else(String::new, length));
    say("Material, heat treatment", String::new());
    say("Finish of the tooth flanks", String::new());

    let letter = sheet.letter();
    let wide = |words: &str| Text::new(Point::default(), letter, words).width_mm() + letter;
    let heads = ["Wheel data, lengths in mm", "Value", "Tolerance"];
    let columns = [
        rows.iter().map(|row| wide(&row.0)).fold(wide(heads[0]), f64::max),
        rows.iter().map(|row| wide(&row.1)).fold(wide(heads[1]), f64::max),
        2.0 * wide(heads[2]),
    ];
    let bounds = sheet.scene.bounds();
    let left = bounds.right + 6.0 * sheet.unit;
    let row_height = ROW * letter;
    let title = Text::new(
        [left, bounds.top - 0.5 * row_height],
        1.25 * letter,
        name(motor.numbers(), motor.module()),
    )
    .align(Align::Left);
    sheet.scene.add(layer, title);
    let top = bounds.top - 1.5 * row_height;
    let total: f64 = columns.iter().sum();
    let mut y = top;
    let starts = [left, left + columns[0], left + columns[0] + columns[1], left + total];
    let head = (heads[0].to_owned(), heads[1].to_owned());
    for (place, (what, value)) in [&head].into_iter().chain(&rows).enumerate() {
        sheet.line(layer, Point::new(left, y), Point::new(left + total, y));
        let middle = y - 0.5 * row_height;
        let last = if place == 0 { heads[2] } else { "" };
        for (x, words) in starts.into_iter().zip([what.as_str(), value.as_str(), last]) {
            if !words.is_empty() {
                let indent = if words.starts_with(' ') { 1.5 } else { 0.5 };
                let at = Point::new(x + indent * letter, middle);
                sheet.scene.add(layer, Text::new(at, letter, words.trim()).align(Align::Left));
            }
        }
        y -= row_height;
    }
    sheet.line(layer, Point::new(left, y), Point::new(left + total, y));
    for x in starts {
        sheet.line(layer, Point::new(x, top), Point::new(x, y));
    }
}
