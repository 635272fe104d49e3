//! Page of a simulated scenario.

use crate::page::paper::PLOT_MM;
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::simulate::answer::Simulation;
use crate::simulate::table::{capacities, speeds, temperatures, torques};
use crate::table::report::Part;
use crate::table::report::{AsReport as _, Report};
use crate::table::text::Error;
use epicyclic_pictures::plot::Plot;

/// Builds the page: speeds and events first, then tables and plots; `file` is the text of the scenario.
///
/// # Errors
/// [`Error::Picture`] for speeds or torques that no plot can show.
pub fn sheet(simulation: &Simulation, file: String) -> Result<Sheet, Error> {
    let picture = |plot: Plot, caption: &str| {
        let scene = plot.sized(PLOT_MM).untitled().scene().map_err(|error| Error::Picture(error.into()))?;
        Ok::<_, Error>(Block::picture(scene, caption))
    };
    let report = simulation.report();
    let (first, rest): (Vec<Part>, Vec<Part>) = report.parts.into_iter().partition(
        |part| matches!(part, Part::Records(records) if ["events", "shifts"].contains(&records.name)),
    );
    let mut answer = vec![picture(speeds(simulation), "Speeds of all links, with the events.")?];
    answer.push(Block::Answer(Report { parts: first, ..Report::default() }));
    let mut plots = vec![];
    if !(simulation.elements.is_empty() && simulation.shafts.is_empty() && simulation.converters.is_empty()) {
        let caption = if simulation.shafts.is_empty() && simulation.converters.is_empty() {
            "Torques on the first links of the shift elements and resistances, and torque of the output."
        } else {
            "Torques on the first links of the shift elements and resistances, on the second links of shafts and converters, \
             and torque of the output."
        };
        plots.push(picture(torques(simulation), caption)?);
    }
    if let Some(plot) = capacities(simulation) {
        plots.push(picture(plot, "What brakes and clutches can carry while they slip.")?);
    }
    if let Some(plot) = temperatures(simulation) {
        plots.push(picture(plot, "Temperature of the shift elements over the oil.")?);
    }
    let mut sections = vec![
        Section::new(
            "Elements, speeds, energies",
            vec![Block::Answer(Report { parts: rest, ..Report::default() })],
        )
        .arranged(Arrangement::Rows),
    ];
    if !plots.is_empty() {
        sections.push(Section::new("Over time", plots).arranged(Arrangement::Rows));
    }
    let left_out = [
        if simulation.shafts.is_empty() {
            "Elasticity and backlash of shafts and teeth: torques jump where capacities do."
        } else {
            "Elasticity and backlash of all but the shafts named: elsewhere torques jump where capacities do."
        },
        "Friction and drags over temperature.",
    ];
    sections.push(Section::new("What is left out", vec![Block::List(left_out.map(str::to_owned).to_vec())]));
    Ok(Sheet {
        title: simulation.scenario.clone(),
        about: format!("{} in motion, {} s", simulation.gearbox, simulation.duration_s),
        answer,
        arrangement: Arrangement::Rows,
        objections: simulation.warnings.iter().map(|warning| warning.message.clone()).collect(),
        sections,
        input: file,
    })
}
