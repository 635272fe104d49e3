//! Page of a hydromotor.

use crate::motor::answer::{Designed, Motor, OverAngle};
use crate::motor::table::{View, plots};
use crate::page::paper::PLOT_MM;
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::report::answer::motor::MotorReport;
use crate::table::figure::{Figure, text};
use crate::table::quantities::quantity;
use crate::table::report::{AsReport as _, Report};
use crate::table::report::{Part, Row, Section as Facts};
use crate::table::text::Error;
use epicyclic_drawing::Scene;
use epicyclic_pictures::motor;
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_units::Dimension::{
    self, AngularSpeed, Area, Length, Power, Pressure, Torque, Volume, VolumeRate,
};

/// Builds the page of a hydromotor: key figures, drawing, results and plots; `input` is the text of its file
/// or command.
///
/// # Errors
/// [`Error::Picture`] for a motor too large for a drawing.
pub fn sheet(report: &MotorReport, designed: &Designed, input: String) -> Result<Sheet, Error> {
    let MotorReport { title, motor: answer, over_angle, over_cycle } = report;
    let Designed { motor, profile, angle, .. } = designed;
    let angle = *angle;
    let about = crate::motor::table::title(&answer.numbers);
    let centrodes = Block::picture(
        motor::centrodes(motor, angle)?,
        "Centrodes of stator, rotor and satellites, and how the stator's arcs are constructed.",
    );
    let chambers = Block::picture(
        motor::chambers(motor, angle)?,
        "Chambers between neighbouring satellites, by their pressure.",
    );
    // Teeth show the motor best; without teeth the centrodes are drawn.
    let (drawing, mut drawings) = match profile {
        Ok(profile) => {
            let teeth = motor::teeth(profile, angle)?;
            let caption = "Teeth of all wheels, every satellite in mesh with both, at the angle asked for.";
            (Block::picture(teeth, caption), vec![centrodes, chambers])
        }
        Err(_) => (centrodes, vec![chambers]),
    };
    for (view, caption) in [
        (
            View::Forces,
            "Forces on the satellites at the angle asked for, to one scale: of the pressure, and of the flanks.",
        ),
        (View::Ports, "Ports as made, with the motor behind them."),
    ] {
        match crate::motor::table::scene(view, designed) {
            Ok(scene) => drawings.push(Block::picture(scene, caption)),
            Err(Error::Lacking(_) | Error::Picture(epicyclic_pictures::Error::Motor(_))) => {}
            Err(error) => return Err(error),
        }
    }
    let mut plots = vec![
        Block::picture(
            picture(&flow(answer, over_angle))?,
            "Flow of ideal ports over the angle of the rotor, sealed at the pitch points and where the flanks touch: a radian and a \
             millimetre of width. The torque over width and pressure is the same.",
        ),
        Block::picture(picture(&areas(over_angle))?, "Areas of the chambers over the angle of the rotor."),
    ];
    let pressure = plots::pressure(over_cycle).map(|plot| {
        (plot, "Pressure in a chamber over its cycle, with the ports as made and the oil's bulk modulus.")
    });
    let stress = plots::stress(over_cycle).map(|plot| {
        (plot, "Contact stress of a satellite at its pitch points, first by a crest, then by a trough.")
    });
    for (plot, caption) in [pressure, stress].into_iter().flatten() {
        plots.push(Block::picture(picture(&plot.sized(PLOT_MM).untitled())?, caption));
    }
    if let Some(map) = answer.losses.as_ref().and_then(|losses| losses.map.as_ref()) {
        let scene = plots::efficiency(map).scene().map_err(epicyclic_pictures::Error::from)?;
        plots.push(Block::picture(scene, "Total efficiency over speed and pressure with the greatest friction, by models from the gaps, oil and friction given."));
    }
    let sources = [
        "System (1), formulas (2) to (8) and the conditions on the numbers: the document rotary-hydromotor, with what it leaves out: \
         closure, the exact rotor, working data, teeth.",
        "Flanks under load, stresses, ports as made, leaks and friction: derived in the theory chapter; not validated against a made motor.",
    ];
    Ok(Sheet {
        title: title.clone().unwrap_or_else(|| about.clone()),
        about,
        answer: vec![in_short(answer), drawing],
        arrangement: Arrangement::Columns,
        objections: answer.warnings.iter().map(|warning| warning.message.clone()).collect(),
        sections: vec![
            Section::new("Drawings", drawings),
            Section::new(
                "Results and checks",
                vec![Block::Answer(Report { warnings: None, ..answer.report() })],
            ),
            Section::new("Plots", plots),
            Section::new("Sources", vec![Block::List(sources.map(str::to_owned).to_vec())]),
        ],
        input,
    })
}

/// Key figures of the motor.
fn in_short(motor: &Motor) -> Block {
    let (numbers, work) = (&motor.numbers, &motor.work);
    let maybe = |label, symbol, dimension, si: Option<f64>| {
        Some(Row::new("", label, symbol, [quantity(dimension, si?)]))
    };
    let known = [
        maybe("width", "b", Length, work.width_m),
        maybe("displacement a revolution", "q", Volume, work.displacement_m3),
        maybe("pressure drop", "Δp", Pressure, work.pressure_pa),
        maybe("mean torque", "T", Torque, work.torque_n_m),
        maybe("speed of the rotor", "n", AngularSpeed, work.speed_rad_s),
        maybe("mean flow", "Q", VolumeRate, work.flow_m3_s),
        maybe("power", "P", Power, work.power_w),
    ];
    let teeth = [numbers.stator_teeth, numbers.rotor_teeth, numbers.satellite_teeth];
    let teeth = teeth.map(|teeth| teeth.to_string()).join(" / ");
    let one = |label, symbol, figure| Row::new("", label, symbol, [figure]);
    let mut rows = vec![
        one(
            "lobes of stator, rotor",
            "N / n",
            text(format!("{} / {}", numbers.stator_lobes, numbers.rotor_lobes)),
        ),
        one("teeth of stator, rotor, satellite", "Z₃ / Z₁ / Z_s", text(teeth)),
        one("module", "m", quantity(Length, numbers.module_m)),
        one("satellites", "N + n", Figure::Count(numbers.satellites)),
        one("greatest diameter of the stator's centrode", "", quantity(Length, motor.size.stator_outer_m)),
        one("displacement a revolution over width", "q/b", quantity(Area, work.displacement_per_width_m2)),
        one("ripple at the pitch points", "δ", Figure::Share(work.ripple)),
    ];
    rows.extend(
        motor.flanks.as_ref().map(|flanks| one("ripple at the flanks", "δ′", Figure::Share(flanks.ripple))),
    );
    rows.extend(known.into_iter().flatten());
    let section = Facts { name: "", title: "The motor", columns: &[], rows, note: "" };
    Block::Answer(Report { parts: vec![Part::Facts(section)], ..Report::default() })
}

fn picture(plot: &Plot) -> Result<Scene, Error> {
    Ok(plot.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// Points of a plot in the units of drawings, one value for each angle.
fn points(over_angle: &OverAngle, values: &[f64]) -> Vec<[f64; 2]> {
    let (degree, square_millimetre) =
        (Dimension::Angle.usual_unit().factor, Dimension::Area.usual_unit().factor);
    let angles = over_angle.angles_rad.iter().map(|angle| angle / degree);
    angles.zip(values).map(|(angle, value)| [angle, value / square_millimetre]).collect()
}

/// Plot of the flow per width and radian.
fn flow(answer: &Motor, over_angle: &OverAngle) -> Plot {
    let mean = vec![over_angle.mean_flow_per_width_m2; over_angle.angles_rad.len()];
    let at = |ripple: f64, place: &str| format!("{:.2} % at the {place}", 100.0 * ripple);
    let at_flanks = answer.flanks.as_ref().map(|flanks| at(flanks.ripple, "flanks"));
    let ripples: Vec<String> =
        std::iter::once(at(answer.work.ripple, "pitch points")).chain(at_flanks).collect();
    let plot = Plot::new(
        format!("Flow, ripple {}", ripples.join(", ")),
        "angle of the rotor, deg",
        "flow, mm² a radian",
    )
    .sized(PLOT_MM)
    .with(Curve::new("at the pitch points", points(over_angle, &over_angle.flow_per_width_m2)));
    let at_flanks = over_angle.flank_flow_per_width_m2.as_ref();
    let plot = match at_flanks {
        Some(flow) => plot.with(Curve::new("at the flanks", points(over_angle, flow))),
        None => plot,
    };
    plot.with(Curve::new("mean", points(over_angle, &mean)))
}

/// Plot of the area of each chamber.
fn areas(over_angle: &OverAngle) -> Plot {
    let curve = |(index, areas): (usize, &Vec<f64>)| {
        Curve::new(format!("chamber {index}"), points(over_angle, areas))
    };
    let plot = Plot::new("Chambers", "angle of the rotor, deg", "area, mm²").sized(PLOT_MM);
    over_angle.chamber_areas_m2.iter().enumerate().map(curve).fold(plot, Plot::with)
}
