//! The path of contact of every flank: from where to where along the line of action it meets the satellite.

use super::Profile;
use super::cut::Flank;
use super::form::Teeth;
use super::track::Side;

/// A flank's path of contact in modules, from the pitch point along the line of action, positive towards the
/// satellite's base circle, which is towards the wheel's tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FlankPath {
    /// Arc length at which the contact is in the pitch point.
    pub(crate) pitch: f64,
    /// Path at which contact is at the satellite's tip, or the wheel's flank begins; negative.
    pub(crate) from: f64,
    /// Path at which contact is at the wheel's tip, or the satellite's involute begins.
    pub(crate) to: f64,
}

impl FlankPath {
    /// Arc lengths of the centrode at which contact begins and ends on a flank at the front of its space, for
    /// a `sign` of 1, or at its back.
    pub(crate) fn arcs(&self, sign: f64, cos: f64) -> [f64; 2] {
        let [one, other] = [self.from, self.to].map(|e| self.pitch + sign * e / cos);
        [one.min(other), one.max(other)]
    }
}

impl Side {
    /// The side of their spaces on which a wheel's flanks carry satellites that are pushed forward, for a
    /// `sigma` of 1, or back: `1` at the front.
    pub(crate) fn carrying(self, sigma: f64) -> f64 {
        match self {
            Self::Stator => sigma,
            Self::Rotor => -sigma,
        }
    }
}

impl Profile {
    /// The paths of all flanks of a lobe on one side of their spaces, in order along the track: at their
    /// front for a `sign` of 1.
    pub(crate) fn paths(&self, side: Side, sign: f64) -> Vec<FlankPath> {
        let teeth = &self.teeth;
        let satellite = teeth.base * (teeth.tan - self.satellite.from);
        let satellite_tip = -teeth.tip_roll() * teeth.cos;
        let path = |flank: &Flank| FlankPath {
            pitch: flank.pitch,
            from: -satellite_tip.min(-flank.roll(flank.end) * teeth.cos),
            to: satellite.min(flank.roll(flank.tip) * teeth.cos),
        };
        let mut paths: Vec<FlankPath> =
            self.cut(side).flanks.iter().flatten().filter(|flank| flank.sign == sign).map(path).collect();
        paths.sort_by(|a, b| a.pitch.total_cmp(&b.pitch));
        paths
    }

    pub(crate) fn lobe_length(&self, side: Side) -> f64 {
        self.track(side).lobe()
    }

    pub(crate) fn teeth(&self) -> &Teeth {
        &self.teeth
    }
}
