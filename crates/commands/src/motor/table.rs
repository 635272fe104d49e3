//! A hydromotor, as tables; its drawings, and its centrodes as CSV.

pub(crate) mod lists;
pub(crate) mod made;
pub(crate) mod plots;

use crate::motor::answer::{
    self as motor, Arcs, Centrodes, Chosen, CosineLaw, Designed, Interval, Motor, Numbers,
};
use crate::motor::construction::answer::Constructed;
use crate::shared::judgement::table as judgement;
use crate::table::figure::Figure;
use crate::table::quantities::{optional, quantity, remarked, words};
use crate::table::report::AsReport;
use crate::table::report::{Part, Report, Row, Section, Text, headline, warned};
use crate::table::text::{self, Error};
use epicyclic_drawing::Scene;
use epicyclic_hydromotor::closure::Limit;
use epicyclic_pictures::motor as pictures;
use epicyclic_units::Dimension::{
    self, Angle, AngularSpeed, Area, Force, Length, Power, Pressure, Torque, Volume, VolumeRate,
};
use epicyclic_units::format::trimmed;

impl AsReport for Motor {
    fn report(&self) -> Report {
        let section = |name, title, rows| facts(name, title, rows, "");
        let mut parts = vec![section("numbers", "Numbers and their conditions", numbers(&self.numbers))];
        if let Some(found) = &self.arcs {
            let title = match found.chosen {
                Chosen::Middle => {
                    "Stator of two arcs, in the middle of its family, as nothing else was asked"
                }
                Chosen::Given => "Stator of two arcs",
            };
            parts.push(section("arcs", title, arcs(found)));
        }
        if let Some(law) = &self.cosine_law {
            parts.push(section("cosine_law", "Rotor by the cosine law", cosine_law(law)));
        }
        parts.push(section("rotor", "Rotor: the exact curve, and arcs laid to it", rotor(self)));
        parts.push(section("work", "Displacement, torque and flow, without losses", work(self)));
        if let Some(flanks) = &self.flanks {
            parts.extend(made::flanks(flanks));
        }
        parts.push(section("ports", "Ideal ports in the cover", ports(self)));
        if let Some(ports) = &self.made_ports {
            parts.extend(made::ports(ports));
        }
        if let Some(losses) = &self.losses {
            parts.extend(made::losses(losses));
        }
        parts.push(section("size", "Size of the centrodes", size(self)));
        parts.push(Part::Records(lists::checks(self)));
        match (&self.tooth_limits, &self.clearances) {
            (Some(limits), Some(clearances)) => {
                parts.push(Part::Records(lists::limits(limits)));
                parts.push(Part::Records(lists::clearances(clearances)));
            }
            _ => parts.push(Part::Text(Text {
                heading: Some("Teeth".to_owned()),
                paragraphs: vec!["None of this form on this motor; the warning says why.".to_owned()],
                ..Text::default()
            })),
        }
        parts.extend(judgement::parts(&self.judgement));
        parts.push(Part::Records(lists::chambers(self)));
        parts.push(Part::Records(lists::satellites(self)));
        parts.push(Part::Text(Text {
            heading: Some("Left out".to_owned()),
            paragraphs: vec![made::neglected(self.made_ports.is_some(), self.losses.as_ref())],
            ..Text::default()
        }));
        let title = headline(title(&self.numbers), &self.warnings);
        Report { title: Some(title), parts, warnings: warned(&self.warnings) }
    }
}

/// Figures by which a motor is chosen, each with its name and as in a table. Figures that need a width,
/// pressure or speed are left out without it.
#[must_use]
pub fn key(motor: &Motor) -> Vec<[String; 2]> {
    const KEY: [&str; 7] =
        ["satellites", "ripple", "flank_ripple", "displacement", "torque", "flow", "power"];
    let mut rows: Vec<Row> = numbers(&motor.numbers).into_iter().chain(work(motor)).collect();
    if let (Some(flanks), Some(place)) = (&motor.flanks, rows.iter().position(|row| row.name == "ripple")) {
        rows.insert(place + 1, made::flank_ripple(flanks));
    }
    let chosen = rows.iter().filter(|row| KEY.contains(&row.name));
    chosen.map(|row| [row.label.to_owned(), row.cells.iter().map(Figure::table).collect()]).collect()
}

/// The motor in a line.
#[must_use]
pub fn title(numbers: &Numbers) -> String {
    format!(
        "Hydromotor {}×{}: {}/{}/{} teeth of stator, rotor, satellite, module {}",
        numbers.stator_lobes,
        numbers.rotor_lobes,
        numbers.stator_teeth,
        numbers.rotor_teeth,
        numbers.satellite_teeth,
        words(Length, numbers.module_m, 6)
    )
}

/// A section of rows with one value each.
pub(crate) fn facts(name: &'static str, title: &'static str, rows: Vec<Row>, note: &'static str) -> Part {
    Part::Facts(Section { name, title, columns: &[], rows, note })
}

pub(crate) fn one(
    name: &'static str,
    label: &'static str,
    symbol: &'static str,
    dimension: Dimension,
    si: f64,
) -> Row {
    Row::new(name, label, symbol, [quantity(dimension, si)])
}

fn count(name: &'static str, label: &'static str, symbol: &'static str, count: u32) -> Row {
    Row::new(name, label, symbol, [Figure::Count(count)])
}

pub(crate) fn numbers(numbers: &Numbers) -> Vec<Row> {
    let fewer = numbers.stator_lobes - numbers.rotor_lobes;
    vec![
        count("stator_lobes", "lobes of the stator", "N", numbers.stator_lobes),
        remarked(
            count("rotor_lobes", "lobes of the rotor", "n", numbers.rotor_lobes),
            format!("{fewer} fewer: 1 to {}", numbers.most_lobe_difference),
        ),
        Row::new("lobe_ratio", "their ratio", "N/n", [Figure::Multiple(numbers.lobe_ratio)]),
        count("stator_teeth", "teeth of the stator", "Z₃", numbers.stator_teeth),
        count("rotor_teeth", "teeth of the rotor", "Z₁", numbers.rotor_teeth),
        remarked(
            count("satellite_teeth", "teeth of a satellite", "Z_s", numbers.satellite_teeth),
            format!("below (Z₃ − Z₁)/2 = {}", numbers.satellite_teeth_below),
        ),
        remarked(
            count("teeth_per_lobe", "teeth of a lobe", "Z₃/N = Z₁/n", numbers.teeth_per_lobe),
            "whole: all mesh at once",
        ),
        count("satellites", "satellites, and chambers", "N + n", numbers.satellites),
        count("common_divisor", "common divisor of N and n", "", numbers.common_divisor),
        remarked(
            Row::new(
                "bearing_reactions_vanish",
                "wheels' bearings unloaded",
                "",
                [Figure::YesNo(numbers.bearing_reactions_vanish)],
            ),
            "if that is above 1",
        ),
        remarked(
            count("pulses_per_revolution", "pulses of flow a revolution", "", numbers.pulses_per_revolution),
            "many: little ripple at the pitch points",
        ),
        one("module", "module", "m", Length, numbers.module_m),
        one("satellite_radius", "pitch radius of a satellite", "r", Length, numbers.satellite_radius_m),
    ]
}

fn arcs(arcs: &Arcs) -> Vec<Row> {
    let mut rows = vec![
        one("l", "centre of arc 1 (troughs) from the axis", "l", Length, arcs.l_m),
        one("a", "centre of arc 2 (crests) from the axis", "a", Length, arcs.a_m),
        one("r1", "radius of arc 1", "R₁", Length, arcs.r1_m),
        one("r2", "radius of arc 2", "R₂", Length, arcs.r2_m),
        one("gamma", "angle of arc 1 at its centre", "Γ", Angle, arcs.gamma_rad),
        one("beta", "angle of arc 2 at its centre", "B", Angle, arcs.beta_rad),
    ];
    rows.extend(family(&arcs.family));
    let opening =
        |name, label, value| remarked(Row::new(name, label, "", [Figure::Number(value)]), "rad a half-lobe");
    rows.push(opening(
        "closes_by_quadrature_within_rad",
        "closes, by quadrature, within",
        arcs.closes_by_quadrature_within_rad,
    ));
    rows.push(opening(
        "opened_by_a_hundredth_module_rad",
        "opened by 0.01 modules of error in a",
        arcs.opened_by_a_hundredth_module_rad,
    ));
    rows
}

/// Where motors of a family close, and what ends it.
pub(crate) fn family(family: &[Interval]) -> Vec<Row> {
    let mut rows = vec![];
    let names = [("family_from", "family_to"), ("second_family_from", "second_family_to")];
    for (interval, (from, to)) in family.iter().zip(names) {
        rows.push(remarked(
            one(from, "a motor closes from l =", "", Length, interval.from_m),
            limit(interval.from_limit),
        ));
        rows.push(remarked(
            Row::new(to, "… to l =", "", [optional(Length, interval.to_m)]),
            limit(interval.to_limit),
        ));
    }
    rows
}

fn limit(limit: Limit) -> &'static str {
    match limit {
        Limit::NoTroughArc => "R₁ vanishes",
        Limit::RotorCusp => "the rotor gets cusps",
        Limit::RadialFlank => "flanks become radial",
        Limit::GreatestRadius => "100 × the stator's radius",
    }
}

fn cosine_law(law: &CosineLaw) -> Vec<Row> {
    let number = |name, label, symbol, value| Row::new(name, label, symbol, [Figure::Number(value)]);
    let mut rows = vec![
        one("mean_radius", "mean radius of the rotor", "c", Length, law.mean_radius_m),
        number("amplitude", "relative amplitude", "ε", law.amplitude),
    ];
    if law.second_amplitude != 0.0 {
        rows.push(number("second_amplitude", "of the second harmonic", "ε₂", law.second_amplitude));
    }
    rows.extend(
        law.cusp_amplitude.map(|cusp| number("cusp_amplitude", "at which the stator gets cusps", "", cusp)),
    );
    if let Some(range) = &law.second_harmonics {
        rows.push(number("second_from", "second harmonics close above ε₂ =", "", range.from));
        rows.push(number("second_to", "… and below ε₂ =", "", range.to));
    }
    rows
}

/// A row of a figure that may be missing, and is left out then.
fn maybe(
    name: &'static str,
    label: &'static str,
    symbol: &'static str,
    dimension: Dimension,
    si: Option<f64>,
) -> Option<Row> {
    si.map(|si| one(name, label, symbol, dimension, si))
}

fn rotor(motor: &Motor) -> Vec<Row> {
    let rotor = &motor.rotor;
    [
        maybe(
            "best_arcs_deviation",
            "best pair of tangent arcs misses it by",
            "",
            Length,
            Some(rotor.best_arcs_deviation_m),
        ),
        maybe(
            "published_circles_deviation",
            "the source's circles miss it by",
            "",
            Length,
            rotor.published_circles_deviation_m,
        ),
        maybe(
            "published_circles_kink",
            "and meet at an angle of",
            "",
            Angle,
            rotor.published_circles_kink_rad,
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn work(motor: &Motor) -> Vec<Row> {
    let work = &motor.work;
    let mut rows = vec![
        one("least_chamber", "least area of a chamber", "A_min", Area, work.least_chamber_m2),
        one("greatest_chamber", "greatest area of a chamber", "A_max", Area, work.greatest_chamber_m2),
        one(
            "displacement_per_width",
            "displacement a revolution over width",
            "q/b",
            Area,
            work.displacement_per_width_m2,
        ),
        Row::new("ripple", "ripple at the pitch points", "δ", [Figure::Share(work.ripple)]),
    ];
    let given = [
        maybe("width", "width", "b", Length, work.width_m),
        maybe("displacement", "displacement a revolution", "q", Volume, work.displacement_m3),
        maybe("pressure", "pressure drop", "Δp", Pressure, work.pressure_pa),
        maybe("torque", "mean torque", "M = qΔp/2π", Torque, work.torque_n_m),
        maybe("least_torque", "least torque", "", Torque, work.least_torque_n_m),
        maybe("greatest_torque", "greatest torque", "", Torque, work.greatest_torque_n_m),
        maybe(
            "greatest_satellite_force",
            "force on a satellite, at most",
            "Δp·b·2r",
            Force,
            work.greatest_satellite_force_n,
        ),
        maybe("speed", "speed of the rotor", "", AngularSpeed, work.speed_rad_s),
        maybe("flow", "mean flow", "", VolumeRate, work.flow_m3_s),
        maybe("least_flow", "least flow", "", VolumeRate, work.least_flow_m3_s),
        maybe("greatest_flow", "greatest flow", "", VolumeRate, work.greatest_flow_m3_s),
        maybe("power", "power", "", Power, work.power_w),
    ];
    rows.extend(given.into_iter().flatten());
    rows
}

fn ports(motor: &Motor) -> Vec<Row> {
    let ports = &motor.ports;
    let hole = "greatest round hole that a satellite covers";
    let mut rows = vec![count("ports_of_each", "ports of each pressure", "", ports.ports_of_each)];
    rows.extend(maybe("centre_radius", "their centres from the axis", "", Length, ports.centre_radius_m));
    rows.extend(maybe("high_angle", "first at high pressure, from a crest", "", Angle, ports.high_angle_rad));
    rows.extend(maybe("low_angle", "first at low pressure, from a crest", "", Angle, ports.low_angle_rad));
    rows.push(Row::new("greatest_diameter", hole, "", [optional(Length, ports.greatest_diameter_m)]));
    rows.push(one("covered", "rotation for which one is covered", "", Angle, ports.covered_rad));
    rows.push(one("open", "rotation for which it is open", "", Angle, ports.open_rad));
    rows
}

fn size(motor: &Motor) -> Vec<Row> {
    let size = &motor.size;
    let length = |name, label, si| one(name, label, "", Length, si);
    vec![
        length("stator_outer", "stator, greatest diameter", size.stator_outer_m),
        length("stator_inner", "stator, least diameter", size.stator_inner_m),
        length("rotor_outer", "rotor, greatest diameter", size.rotor_outer_m),
        length("rotor_inner", "rotor, least diameter", size.rotor_inner_m),
        length("least_neighbour_distance", "satellites' centres, nearest", size.least_neighbour_distance_m),
        Row::new(
            "displacement_by_volume",
            "displacement over enclosing cylinder",
            "q/V",
            [Figure::Multiple(size.displacement_by_volume)],
        ),
    ]
}

/// What is drawn of a motor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum View {
    /// Stator, rotor, satellites, and how the arcs are constructed.
    Centrodes,
    /// Half a lobe of stator and rotor with the construction of the arcs, (1)-(8).
    Construction,
    /// Every tooth in mesh.
    Teeth,
    /// The motor in its housing with its ports.
    Motor,
    /// The chambers coloured by pressure.
    Chambers,
    /// Dimensions and a table of wheel data, for a drawing office.
    Dimensions,
    /// Forces on the satellites and on the rotor's bearing, with --width and --pressure.
    Forces,
    /// The ports as made, with --ports.
    Ports,
    /// Pressure in a chamber over its cycle, with --ports and the bulk modulus of --oil.
    Pressure,
    /// Contact stress of a satellite over its cycle, with --pressure.
    Stress,
    /// Total efficiency over speed and pressure, with --gaps, --oil and --friction.
    Efficiency,
}

/// A drawing of a motor at its angle.
///
/// # Errors
/// [`Error::NoTeeth`] for the view of teeth where the form gives none; [`Error::Picture`].
pub fn scene(view: View, designed: &Designed) -> Result<Scene, Error> {
    let Designed { motor, angle, .. } = designed;
    let scene = match view {
        View::Centrodes => pictures::centrodes(motor, *angle),
        View::Construction => {
            let constructed = Constructed::of_motor(designed);
            return construction(&constructed.map_err(|why| Error::Answer(Box::new(why)))?);
        }
        View::Motor => pictures::whole(motor, *angle),
        View::Chambers => pictures::chambers(motor, *angle),
        View::Dimensions => {
            pictures::dimensions(motor, designed.profile.as_ref().ok(), designed.width, *angle)
        }
        View::Forces => {
            let lacking = || Error::Lacking("width and pressure".to_owned());
            let (width, drop) = designed.width.zip(designed.pressure).ok_or_else(lacking)?;
            pictures::forces(motor, designed.form.pressure_angle, *angle, width, drop)
        }
        View::Ports => {
            let lacking = || Error::Lacking("ports as made, with the key or option ports".to_owned());
            let (plate, timing) = designed.made.ports.as_ref().ok_or_else(lacking)?;
            pictures::plate(plate, timing, *angle)
        }
        View::Pressure | View::Stress => {
            let cycle = motor::over_cycle(designed).map_err(|why| Error::Answer(Box::new(why)))?;
            let (plot, lacking) = if view == View::Pressure {
                (plots::pressure(&cycle), "ports as made, the oil's bulk modulus, and pressure")
            } else {
                (plots::stress(&cycle), "teeth and a pressure")
            };
            let plot = plot.ok_or_else(|| Error::Lacking(lacking.to_owned()))?;
            return Ok(plot.scene().map_err(epicyclic_pictures::Error::from)?);
        }
        View::Efficiency => {
            let losses = designed
                .made
                .losses()
                .ok_or_else(|| Error::Lacking("gaps, oil, friction, width, pressure and speed".to_owned()))?;
            let map = losses.map.as_ref().ok_or_else(|| Error::Lacking(losses.missing.join(", ")))?;
            return Ok(plots::efficiency(map).scene().map_err(epicyclic_pictures::Error::from)?);
        }
        View::Teeth => match &designed.profile {
            Ok(profile) => pictures::teeth(profile, *angle),
            Err(why) => return Err(Error::NoTeeth(Box::new(why.clone().into()))),
        },
    };
    Ok(scene?)
}

/// A drawing of the construction of a stator's arcs.
///
/// # Errors
/// [`Error::Picture`].
pub fn construction(constructed: &Constructed) -> Result<Scene, Error> {
    Ok(pictures::construction(constructed.numbers, &constructed.arcs)?)
}

/// Centrodes as CSV in millimetres and degrees.
///
/// # Errors
/// A writer that fails.
pub fn centrodes_csv(centrodes: &Centrodes) -> Result<String, Error> {
    let header = [
        "wheel",
        "arc_length_mm",
        "x_mm",
        "y_mm",
        "polar_radius_mm",
        "polar_angle_deg",
        "tangent_deg",
        "curvature_per_mm",
    ];
    let rows = centrodes.points.iter().map(|point| {
        let in_drawing = |dimension, si| quantity(dimension, si).csv().0;
        // Its unit is the reciprocal of a length's.
        let curvature = point.curvature_per_m * Length.usual_unit().factor;
        let values = [
            in_drawing(Length, point.arc_length_m),
            in_drawing(Length, point.x_m),
            in_drawing(Length, point.y_m),
            in_drawing(Length, point.polar_radius_m),
            in_drawing(Angle, point.polar_angle_rad),
            in_drawing(Angle, point.tangent_rad),
            trimmed(curvature, 12),
        ];
        let mut row = vec![point.wheel.words().to_owned()];
        row.extend(values);
        row
    });
    text::csv_text(&header, rows)
}
