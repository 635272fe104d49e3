//! Common parts of a simulation: the scenario, its elements, shifts and output.

use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Document;
use epicyclic_formats::scenario::{ScenarioFile, Texts};
use epicyclic_motion::{Course, Model, Sample, Start};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Kinds of elements between two links.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ElementKind {
    /// A brake.
    Brake,
    /// A clutch.
    Clutch,
    /// A one-way clutch or brake.
    OneWayClutch,
    /// A clutch or brake by dogs.
    DogClutch,
    /// A load against the motion of a link.
    Resistance,
}

/// Kinds of drags.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DragKind {
    /// Drag that always acts.
    Drag,
    /// Brake or clutch while it is open or slips.
    OpenElement,
}

/// Scenario with its document, gearbox and CSV files.
pub(super) struct Scenario<'s> {
    pub(super) document: &'s Document,
    pub(super) file: &'s ScenarioFile,
    pub(super) subject: &'s Gearbox,
    pub(super) texts: &'s Texts,
}

/// Model with its start, elements, drags, shifts and output.
pub(super) struct Built {
    pub(super) model: Model,
    pub(super) start: Start,
    pub(super) elements: Vec<Element>,
    pub(super) drags: Vec<Drag>,
    pub(super) shifts: Vec<Ramps>,
    pub(super) output: Output,
}

/// Element of the model, in the model's order.
#[derive(Debug, Clone)]
pub(super) struct Element {
    pub(super) id: String,
    pub(super) kind: ElementKind,
    pub(super) links: [String; 2],
    /// Torque capacity over time; `None` for one-way and dog clutches.
    pub(super) capacity: Option<Course>,
    pub(super) friction_area_m2: Option<f64>,
    pub(super) heat_capacity_j_per_k: Option<f64>,
    pub(super) conductance_w_per_k: f64,
}

impl Element {
    pub(super) fn new(id: &str, kind: ElementKind, links: [String; 2], capacity: Option<Course>) -> Self {
        Self {
            id: id.to_owned(),
            kind,
            links,
            capacity,
            friction_area_m2: None,
            heat_capacity_j_per_k: None,
            conductance_w_per_k: 0.0,
        }
    }
}

/// Drag of the model, in the model's order.
#[derive(Debug, Clone)]
pub(super) struct Drag {
    pub(super) id: String,
    pub(super) kind: DragKind,
    pub(super) links: [String; 2],
    /// Index of the drag in the list of the gearbox.
    pub(super) place: usize,
}

/// Ramps of one shift.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ramps {
    pub(super) at: f64,
    pub(super) from: String,
    pub(super) to: String,
    /// Names of the released elements; `release` holds start and end of their ramp.
    pub(super) released: Vec<String>,
    pub(super) release: [f64; 2],
    /// Names of the applied elements; `apply` holds start and end of their ramp.
    pub(super) applied: Vec<String>,
    pub(super) apply: [f64; 2],
}

impl Ramps {
    /// End of the later ramp.
    pub(super) fn end(&self) -> f64 {
        self.release[1].max(self.apply[1])
    }
}

/// Output link with the places of all torques that act on it.
pub(super) struct Output {
    /// Index of the output among the links.
    place: usize,
    /// Inertia of the links that are one piece with the output.
    inertia_kg_m2: f64,
    /// Places of the torques on these links.
    torques: Vec<usize>,
    /// Places of the resistances on these links.
    resistances: Vec<usize>,
    /// Places of the shafts on these links, and the signs of their torques there.
    shafts: Vec<(usize, f64)>,
    /// Places of the converters on these links, and the end there: 0 for the impeller, 1 for the turbine.
    converters: Vec<(usize, usize)>,
    /// Places of the drags on these links, and the signs of their torques there; drags of shift elements are
    /// left out.
    drags: Vec<(usize, f64)>,
}

impl Output {
    /// Collects the parts on the output; `elements` and `drags` are those of the model, in its order.
    pub(super) fn of(scenario: &Scenario<'_>, model: &Model, elements: &[Element], drags: &[Drag]) -> Self {
        let (file, gearbox) = (scenario.file, &scenario.subject.train);
        let output = gearbox.link_name(gearbox.output());
        let is_it = |link: &str| model.mechanism().is_one_piece(output, link).unwrap_or(false);
        let inertias = file.inertias.iter().filter(|(link, _)| is_it(link));
        let torques = file.torques.iter().filter(|one| one.resistance.is_none()).enumerate();
        let is_resistance = |one: &Element| one.kind == ElementKind::Resistance && is_it(&one.links[0]);
        let ends = |links: &[String; 2], place: usize| {
            let at = links.each_ref().map(|link| is_it(link));
            at.into_iter().enumerate().filter(|(_, is_there)| *is_there).map(move |(end, _)| (place, end))
        };
        let of_shafts = file.shafts.iter().enumerate().flat_map(|(place, one)| ends(&one.links, place));
        let of_converters =
            file.converters.iter().enumerate().flat_map(|(place, one)| ends(&one.links, place));
        let is_own = |one: &&(usize, &Drag)| one.1.kind == DragKind::Drag;
        let of_drags: Vec<(usize, &Drag)> = drags.iter().enumerate().collect();
        let of_drags = of_drags.iter().filter(is_own).flat_map(|(place, one)| ends(&one.links, *place));
        Self {
            drags: of_drags.map(|(place, end)| (place, if end == 0 { 1.0 } else { -1.0 })).collect(),
            shafts: of_shafts.map(|(place, end)| (place, if end == 0 { -1.0 } else { 1.0 })).collect(),
            converters: of_converters.collect(),
            place: gearbox.output().index(),
            inertia_kg_m2: inertias.map(|(_, inertia)| inertia.0.si()).sum(),
            torques: torques.filter(|(_, one)| is_it(&one.link)).map(|(place, _)| place).collect(),
            resistances: elements
                .iter()
                .enumerate()
                .filter(|(_, one)| is_resistance(one))
                .map(|(place, _)| place)
                .collect(),
        }
    }

    /// Torque that sets and shift elements exert on the output, `J·ω̇ − Σ T_applied`, in N·m.
    pub(super) fn torque(&self, sample: &Sample) -> f64 {
        let applied: f64 = self.torques.iter().map(|&place| sample.torques[place].si()).sum();
        let resisting: f64 = self.resistances.iter().map(|&place| sample.elements[place].si()).sum();
        let twisting: f64 = self.shafts.iter().map(|&(place, sign)| sign * sample.shafts[place].si()).sum();
        let by_oil: f64 =
            self.converters.iter().map(|&(place, end)| sample.converters[place][end].si()).sum();
        let dragging: f64 = self.drags.iter().map(|&(place, sign)| sign * sample.drags[place].si()).sum();
        let outside = applied + resisting + twisting + by_oil + dragging;
        self.inertia_kg_m2 * sample.accelerations[self.place].si() - outside
    }
}
