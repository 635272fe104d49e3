//! One-way clutches: whether each holds or overruns, on drive and on coast.
//!
//! A one-way clutch between links `a` and `b` keeps `a` from turning slower than `b`. It holds with a
//! positive torque on `a`, and overruns with a positive slip `ω_a − ω_b`. A gear that relies on the clutch
//! counts it as engaged. The torque shows whether it is engaged, and the slip shows whether the other one-way
//! clutches stay free:
//!
//! | the gear | finds | then it |
//! |---|---|---|
//! | relies on it | torque > 0 | holds |
//! | | torque = 0 | idles |
//! | | torque < 0 | overruns: on coast there is no engine braking; on drive the gear contradicts itself |
//! | does not | slip > 0 | overruns |
//! | | slip = 0 | idles; the parts in parallel take the torque |
//! | | slip < 0 | would hold: the gear contradicts itself |
//!
//! Speeds are for an input that turns forwards. At an [operating point](Operation) torques and speeds have
//! their own signs: [`Analysis::released`] lists the clutches that release there.

use crate::tolerance::{POWER, SPEED};
use crate::{Analysis, Direction, LoadCase, Operation};
use epicyclic_numerics::values::largest_absolute;

/// State of a one-way clutch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Duty {
    /// The clutch carries torque.
    Holds,
    /// The clutch slips in its free direction.
    Overruns,
    /// The clutch neither slips nor carries torque, or the parts in parallel take the torque.
    Idles,
    /// The gear counts on it, and its torque would turn it free.
    WouldOverrun,
    /// The gear does not count on it, and its slip would make it hold.
    WouldHold,
    /// Neither torque nor slip follows.
    Unknown,
}

impl Duty {
    /// Whether the gear's engaged elements contradict the state of the clutch.
    #[must_use]
    pub fn is_contradiction(self) -> bool {
        matches!(self, Self::WouldOverrun | Self::WouldHold)
    }
}

/// A one-way clutch in a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OneWay {
    /// Place of the clutch in [`Gearbox::shift_elements`](crate::Gearbox::shift_elements).
    pub shift_element: usize,
    /// Whether the gear relies on it.
    pub is_relied_on: bool,
    /// State of the clutch while the input drives.
    pub drive: Duty,
    /// State of the clutch while the output drives the input.
    pub coast: Duty,
}

impl Analysis<'_> {
    /// The one-way clutches of the gearbox in this gear.
    #[must_use]
    pub fn one_way_clutches(&self) -> Vec<OneWay> {
        let shift_elements = self
            .gearbox
            .shift_elements()
            .iter()
            .enumerate()
            .filter(|(_, shift_element)| shift_element.is_one_way());
        shift_elements
            .map(|(shift_element, _)| {
                let is_relied_on = self.gear.engaged().contains(&shift_element);
                let of = |case: Option<&LoadCase>| {
                    if is_relied_on { relied_on(shift_element, case) } else { self.free(shift_element) }
                };
                let (drive, coast) = (of(self.driving()), of(self.back_driving()));
                // Releasing on coast is the purpose of a one-way clutch.
                let coast = if coast == Duty::WouldOverrun { Duty::Overruns } else { coast };
                OneWay { shift_element, is_relied_on, drive, coast }
            })
            .collect()
    }

    /// Whether the output can drive the input: every one-way clutch that the gear relies on holds on coast
    /// too. `None` without such clutches, or where one's torque does not follow.
    #[must_use]
    pub fn has_engine_braking(&self) -> Option<bool> {
        let relied: Vec<Duty> =
            self.one_way_clutches().iter().filter(|one| one.is_relied_on).map(|one| one.coast).collect();
        if relied.is_empty() || relied.contains(&Duty::Unknown) {
            return None;
        }
        Some(!relied.contains(&Duty::Overruns))
    }

    /// One-way clutches that the gear relies on and that release at this operating point, since they would
    /// need a torque below 0 on their first links: no such operation exists. Places in
    /// [`Gearbox::shift_elements`](crate::Gearbox::shift_elements).
    #[must_use]
    pub fn released(&self, operation: &Operation) -> Vec<usize> {
        let case = match operation.direction {
            Direction::Drive => self.driving(),
            Direction::BackDrive => self.back_driving(),
        };
        // An input that turns backwards reverses all torques of the case.
        let is_mirrored = case.is_some_and(|case| case.input * operation.input.value < 0.0);
        let lets_go = if is_mirrored { Duty::Holds } else { Duty::WouldOverrun };
        let relied = self.one_way_clutches().into_iter().filter(|one| one.is_relied_on);
        relied.map(|one| one.shift_element).filter(|place| relied_on(*place, case) == lets_go).collect()
    }

    fn free(&self, shift_element: usize) -> Duty {
        let Some(slip) = self.slips()[shift_element] else { return Duty::Unknown };
        let [first, second] = self.gearbox.shift_elements()[shift_element].links();
        let largest = largest_absolute([first, second].iter().filter_map(|link| self.speed(*link)));
        if slip.abs() <= SPEED * largest {
            Duty::Idles
        } else if slip > 0.0 {
            Duty::Overruns
        } else {
            Duty::WouldHold
        }
    }
}

fn relied_on(shift_element: usize, case: Option<&LoadCase>) -> Duty {
    let Some(case) = case else { return Duty::Unknown };
    let Some(torque) = case.shift_elements[shift_element] else { return Duty::Unknown };
    let members = case.members.iter().flatten().flatten();
    let largest = largest_absolute(members.chain([&case.input, &case.output]));
    if torque.abs() <= POWER * largest {
        Duty::Idles
    } else if torque > 0.0 {
        Duty::Holds
    } else {
        Duty::WouldOverrun
    }
}
