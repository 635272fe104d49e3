//! Shift elements: what each joins, and its slip and torque in one gear and over all.

use super::Worked;
use super::records::{ShiftElementKind, links_of};
use crate::tolerance::ROUNDED;
use epicyclic_train::{self as train, Gearbox};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// A shift element.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Its name.
    pub shift_element: String,
    /// What it is.
    pub kind: ShiftElementKind,
    /// The two links that it joins; `ground` is the housing.
    pub links: [String; 2],
}

impl ShiftElement {
    /// Those of a gearbox.
    pub(crate) fn all(gearbox: &Gearbox) -> Vec<Self> {
        gearbox.shift_elements().iter().map(|element| Self::of(gearbox, element)).collect()
    }

    pub(super) fn of(gearbox: &Gearbox, element: &train::ShiftElement) -> Self {
        Self {
            shift_element: element.id().to_owned(),
            kind: ShiftElementKind::of(element),
            links: links_of(gearbox, element),
        }
    }
}

/// What a shift element does in a gear; torques act on its first link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SlipAndTorque {
    /// Whether it is engaged.
    pub engaged: bool,
    /// Slip over the input's speed: speed of the first link less that of the second.
    pub slip_of_input: Option<f64>,
    /// Slip.
    pub slip_rad_s: Option<f64>,
    /// Torque without losses, over the input's.
    pub ideal_torque_of_input: Option<f64>,
    /// Torque with losses, over the input's.
    pub torque_of_input: Option<f64>,
    /// Torque at the load.
    pub torque_n_m: Option<f64>,
}

impl SlipAndTorque {
    /// Of the shift element at this place of a gearbox.
    pub(super) fn of(worked: &Worked<'_>, place: usize) -> Self {
        let analysis = &worked.analysis;
        let torque = worked.operation.as_ref().and_then(|operation| operation.shift_elements[place]);
        Self {
            engaged: analysis.gear().engaged().contains(&place),
            slip_of_input: analysis.slips()[place],
            slip_rad_s: worked.speed_rad_s(analysis.slips()[place]),
            ideal_torque_of_input: analysis.ideal().and_then(|case| case.shift_elements[place]),
            torque_of_input: worked.of_input(|case| case.shift_elements[place]),
            torque_n_m: torque.map(Physical::si),
        }
    }
}

/// A shift element in a gear of an overview.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct InGear {
    /// Its name.
    pub shift_element: String,
    /// What it does.
    #[serde(flatten)]
    pub duty: SlipAndTorque,
}

impl InGear {
    /// All shift elements in a gear.
    pub(super) fn all(gearbox: &Gearbox, worked: &Worked<'_>) -> Vec<Self> {
        let one = |(place, element): (usize, &train::ShiftElement)| Self {
            shift_element: element.id().to_owned(),
            duty: SlipAndTorque::of(worked, place),
        };
        gearbox.shift_elements().iter().enumerate().map(one).collect()
    }
}

/// A shift element over all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverGears {
    /// What it is.
    #[serde(flatten)]
    pub element: ShiftElement,
    /// Its largest torque with losses; of equal ones the first. `null` where it carries none or none follows.
    pub largest_torque: Option<LargestTorque>,
    /// Its largest slip; of equal ones the first. `null` where it never slips or no slip follows.
    pub largest_slip: Option<LargestSlip>,
}

/// The largest torque of a shift element.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestTorque {
    /// In which gear.
    pub gear: String,
    /// Torque over the input's.
    pub torque_of_input: f64,
    /// Torque at the load.
    pub torque_n_m: Option<f64>,
}

/// The largest slip of a shift element.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestSlip {
    /// In which gear.
    pub gear: String,
    /// Slip over the input's speed.
    pub slip_of_input: f64,
    /// Slip.
    pub slip_rad_s: Option<f64>,
}

/// The entry of the largest size, of equal ones the first; none where all are nothing.
pub(super) fn largest<T>(all: impl IntoIterator<Item = (f64, T)>) -> Option<(f64, T)> {
    let larger = |most: Option<(f64, T)>, one: (f64, T)| match most {
        Some(most) if one.0.abs() <= most.0.abs() => Some(most),
        _ => Some(one),
    };
    all.into_iter().filter(|(value, _)| value.abs() > ROUNDED).fold(None, larger)
}

impl OverGears {
    /// Those of a gearbox over its gears, which have their names.
    pub(super) fn all(gearbox: &Gearbox, gears: &[(&str, &[InGear])]) -> Vec<Self> {
        let one = |(place, element): (usize, &train::ShiftElement)| {
            let duties = || gears.iter().map(|(gear, duties)| (*gear, &duties[place].duty));
            let torque =
                largest(duties().filter_map(|(gear, duty)| Some((duty.torque_of_input?, (gear, duty)))));
            let slip = largest(duties().filter_map(|(gear, duty)| Some((duty.slip_of_input?, (gear, duty)))));
            Self {
                element: ShiftElement::of(gearbox, element),
                largest_torque: torque.map(|(torque_of_input, (gear, duty))| LargestTorque {
                    gear: gear.to_owned(),
                    torque_of_input,
                    torque_n_m: duty.torque_n_m,
                }),
                largest_slip: slip.map(|(slip_of_input, (gear, duty))| LargestSlip {
                    gear: gear.to_owned(),
                    slip_of_input,
                    slip_rad_s: duty.slip_rad_s,
                }),
            }
        };
        gearbox.shift_elements().iter().enumerate().map(one).collect()
    }
}
