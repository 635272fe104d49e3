//! Plots over time: speeds, torques of elements with their capacities, temperatures.

use crate::simulate::answer::{ElementKind, EventRecord, Simulation, State};
use crate::table::figure::rpm;
use epicyclic_pictures::plot::{Curve, Plot};

/// Events that are marked at most: more would hide the curves.
const MOST_MARKS: usize = 9;

fn over(times: &[f64], values: impl IntoIterator<Item = f64>) -> Vec<[f64; 2]> {
    times.iter().zip(values).map(|(time, value)| [*time, value]).collect()
}

/// The same with the instants before and after events among the samples, where a value jumps.
fn with_events(
    simulation: &Simulation,
    values: &[f64],
    at: impl Fn(&EventRecord) -> Option<[f64; 2]>,
) -> Vec<[f64; 2]> {
    let mut points = over(&simulation.samples.times_s, values.iter().copied());
    for event in &simulation.events {
        if let Some(both) = at(event) {
            let place = points.partition_point(|point| point[0] < event.time_s);
            points.splice(place..place, both.map(|value| [event.time_s, value]));
        }
    }
    points
}

/// Upright lines at events of elements and at beginnings of shifts.
fn marked(simulation: &Simulation, plot: Plot) -> Plot {
    let mut marks: Vec<(f64, String)> = vec![];
    for shift in &simulation.shifts {
        marks.push((shift.at_s, format!("{} to {}", shift.from, shift.to)));
    }
    for event in &simulation.events {
        for change in &event.changes {
            match change.to {
                Some(State::Holds) => marks.push((event.time_s, format!("{} holds", change.id))),
                Some(_) if change.from == Some(State::Holds) => {
                    marks.push((event.time_s, format!("{} slips", change.id)));
                }
                None => marks.push((event.time_s, change.id.clone())),
                _ => {}
            }
        }
    }
    if marks.len() > MOST_MARKS {
        return plot;
    }
    marks.sort_by(|one, other| one.0.total_cmp(&other.0));
    marks.into_iter().fold(plot, |plot, (time, name)| plot.mark(format!("{time:.3} s: {name}"), time))
}

/// Speeds of all links, with the events.
#[must_use]
pub fn speeds(simulation: &Simulation) -> Plot {
    let plot = Plot::new(format!("{}: speeds", simulation.scenario), "time, s", "speed, rpm");
    let mut links: Vec<_> = simulation.samples.links.iter().enumerate().collect();
    // Input and output in the first colours.
    links.sort_by_key(|(_, link)| (link.link != simulation.input, link.link != simulation.output));
    let curves = links.into_iter().map(|(place, link)| {
        let values: Vec<f64> = link.speeds_rad_s.iter().map(|speed| rpm(*speed)).collect();
        let at = |event: &EventRecord| event.speeds_rad_s.get(place).map(|speed| [rpm(*speed); 2]);
        Curve::new(&link.link, with_events(simulation, &values, at))
    });
    marked(simulation, curves.fold(plot, Plot::with))
}

/// Torques of the elements, shafts, converters (that of the turbine) and of the output.
#[must_use]
pub fn torques(simulation: &Simulation) -> Plot {
    let plot = Plot::new(format!("{}: torques", simulation.scenario), "time, s", "torque, N·m");
    let curves = simulation.samples.elements.iter().enumerate().map(|(place, element)| {
        let at = |event: &EventRecord| {
            let both = [&event.element_torques_before_n_m, &event.element_torques_n_m];
            both[0].get(place).zip(both[1].get(place)).map(|(before, after)| [*before, *after])
        };
        Curve::new(&element.id, with_events(simulation, &element.torques_n_m, at))
    });
    let times = &simulation.samples.times_s;
    let shafts = simulation.samples.shafts.iter().map(|one| (&one.id, &one.torques_n_m));
    let converters = simulation.samples.converters.iter().map(|one| (&one.id, &one.turbine_torques_n_m));
    let joints =
        shafts.chain(converters).map(|(id, torques)| Curve::new(id, over(times, torques.iter().copied())));
    let plot = joints.fold(curves.fold(plot, Plot::with), Plot::with);
    let at = |event: &EventRecord| Some([event.output_torque_before_n_m, event.output_torque_n_m]);
    let output = with_events(simulation, &simulation.samples.output_torques_n_m, at);
    marked(simulation, plot.with(Curve::new(format!("output {}", simulation.output), output)))
}

/// Capacities of brakes and clutches; nothing where no element has one.
#[must_use]
pub fn capacities(simulation: &Simulation) -> Option<Plot> {
    let plot = Plot::new(format!("{}: capacities", simulation.scenario), "time, s", "capacity, N·m");
    let is_one = |id: &str| {
        let kind = simulation.elements.iter().find(|one| one.id == id).map(|one| one.kind);
        matches!(kind, Some(ElementKind::Brake | ElementKind::Clutch))
    };
    let times = &simulation.samples.times_s;
    let curves: Vec<Curve> = (simulation.samples.elements.iter().enumerate())
        .filter(|(_, element)| is_one(&element.id))
        .filter_map(|(place, element)| {
            let capacities = element.capacities_n_m.as_ref()?;
            Some(Curve::new(&element.id, over(times, capacities.iter().copied())).colored(place))
        })
        .collect();
    (!curves.is_empty()).then(|| curves.into_iter().fold(plot, Plot::with))
}

/// Temperatures over the oil; nothing where no element has a heat capacity.
#[must_use]
pub fn temperatures(simulation: &Simulation) -> Option<Plot> {
    let title = format!("{}: temperature over the oil", simulation.scenario);
    let plot = Plot::new(title, "time, s", "over the oil, K");
    let times = &simulation.samples.times_s;
    let curves: Vec<Curve> = (simulation.samples.elements.iter().enumerate())
        .filter_map(|(place, element)| {
            let rises = element.temperature_rises_k.as_ref()?;
            Some(Curve::new(&element.id, over(times, rises.iter().copied())).colored(place))
        })
        .collect();
    (!curves.is_empty()).then(|| curves.into_iter().fold(plot, Plot::with))
}

/// What a picture shows.
#[must_use]
pub fn picture(simulation: &Simulation, view: super::PlotView) -> Option<Plot> {
    match view {
        super::PlotView::Speeds => Some(speeds(simulation)),
        super::PlotView::Torques => Some(torques(simulation)),
        super::PlotView::Capacities => capacities(simulation),
        super::PlotView::Temperatures => temperatures(simulation),
    }
}
