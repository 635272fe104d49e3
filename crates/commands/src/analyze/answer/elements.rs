//! Shift elements: the links they join, their slip and torque in one gear and over all gears.

use super::Worked;
use super::records::{ShiftElementKind, links_of};
use crate::tolerance::ROUNDED;
use epicyclic_train::{self as train, Gearbox};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Shift element and the links that it joins.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Name of the shift element.
    pub shift_element: String,
    /// Kind of the shift element: brake or clutch, one-way or not.
    pub kind: ShiftElementKind,
    /// The two links that it joins; `ground` is the housing.
    pub links: [String; 2],
}

impl ShiftElement {
    /// Lists the shift elements of a gearbox.
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

/// Slip and torque of a shift element in a gear; torques act on its first link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SlipAndTorque {
    /// Whether the gear engages the shift element.
    pub engaged: bool,
    /// Slip relative to the input speed: speed of the first link minus speed of the second; null if unknown.
    pub slip_of_input: Option<f64>,
    /// Slip in rad/s, speed of the first link minus speed of the second; null if unknown or no input speed is
    /// given.
    pub slip_rad_s: Option<f64>,
    /// Torque on the first link without losses, relative to the input torque; null if it cannot be computed.
    pub ideal_torque_of_input: Option<f64>,
    /// Torque on the first link with losses, relative to the input torque; null if it cannot be computed.
    pub torque_of_input: Option<f64>,
    /// Torque on the first link at the given load, in N·m; null without a load or if it cannot be computed.
    pub torque_n_m: Option<f64>,
}

impl SlipAndTorque {
    /// Slip and torque of the shift element at this place of the gearbox.
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
    /// Name of the shift element.
    pub shift_element: String,
    /// Slip and torque of the shift element.
    #[serde(flatten)]
    pub duty: SlipAndTorque,
}

impl InGear {
    /// Lists the shift elements with their slips and torques in a gear.
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
    /// Name, kind and links of the shift element.
    #[serde(flatten)]
    pub element: ShiftElement,
    /// Largest torque with losses over all gears, the first of equal ones; null if no gear has any or none
    /// can be computed.
    pub largest_torque: Option<LargestTorque>,
    /// Largest slip over all gears, the first of equal ones; null if the element never slips or no slip is
    /// known.
    pub largest_slip: Option<LargestSlip>,
}

/// Largest torque of a shift element over all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestTorque {
    /// Gear in which the torque occurs.
    pub gear: String,
    /// Torque relative to the input torque.
    pub torque_of_input: f64,
    /// Torque at the given load, in N·m; null without a load.
    pub torque_n_m: Option<f64>,
}

/// Largest slip of a shift element over all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestSlip {
    /// Gear in which the slip occurs.
    pub gear: String,
    /// Slip relative to the input speed.
    pub slip_of_input: f64,
    /// Slip in rad/s; null if no input speed is given.
    pub slip_rad_s: Option<f64>,
}

/// Finds the entry with the largest absolute value, the first of equal ones; `None` if all are zero.
pub(super) fn largest<T>(all: impl IntoIterator<Item = (f64, T)>) -> Option<(f64, T)> {
    let larger = |most: Option<(f64, T)>, one: (f64, T)| match most {
        Some(most) if one.0.abs() <= most.0.abs() => Some(most),
        _ => Some(one),
    };
    all.into_iter().filter(|(value, _)| value.abs() > ROUNDED).fold(None, larger)
}

impl OverGears {
    /// Lists the shift elements of a gearbox with their extremes over the named gears.
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
