//! The checks of a gear and of a mesh, and the limits that they keep.

use super::check::{Check, Rule};
use super::gear::InvoluteGear;
use super::pair::Pair;
use crate::{Error, Quantity};

/// Limits for the checks of a set; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Least normal thickness of a tip: 0.2 by default, 0.4 of case-hardened teeth.
    pub tip_thickness: f64,
    /// Least transverse contact ratio: 1.1 by default.
    pub contact_ratio: f64,
    /// Least clearance between tips and the roots of the mate: 0 by default.
    pub tip_clearance: f64,
    /// Gap between the tip circles of neighbouring planets that must be exceeded: 0 by default.
    pub planet_gap: f64,
    /// Whether the planets must enter the ring radially; they need not by default, since they enter it along
    /// the axis.
    pub radial_assembly: bool,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            tip_thickness: 0.2,
            contact_ratio: 1.1,
            tip_clearance: 0.0,
            planet_gap: 0.0,
            radial_assembly: false,
        }
    }
}

impl Limits {
    /// Refuses limits that are no numbers or below 0.
    ///
    /// # Errors
    /// [`Error::Negative`].
    pub fn check(&self) -> Result<(), Error> {
        for (quantity, value, unit) in [
            (Quantity::TipThickness, self.tip_thickness, "modules"),
            (Quantity::ContactRatio, self.contact_ratio, ""),
            (Quantity::TipClearance, self.tip_clearance, "modules"),
            (Quantity::TipGap, self.planet_gap, "modules"),
        ] {
            crate::checks::not_negative(quantity, value, unit)?;
        }
        Ok(())
    }
}

/// The checks of one gear, however it is named.
pub fn gear_checks<P: Clone>(place: &P, of: &InvoluteGear, limits: &Limits, see: &mut impl FnMut(Check<P>)) {
    let mut check = |rule, value, limit| see(Check { rule, place: place.clone(), value, limit });
    check(Rule::Tool, if of.tool_fault().is_none() { 1.0 } else { 0.0 }, 1.0);
    if let Some(least) = of.least_shift_without_undercut() {
        check(Rule::Undercut, of.shift(), least);
    }
    check(Rule::TipThickness, of.tip_thickness(), limits.tip_thickness);
    if let Some(room) = of.cut().room(of.flank(), of.tip_diameter() / 2.0) {
        check(Rule::ToolTips, room.flank, 0.0);
        check(Rule::ToolTrochoidal, room.trochoidal, 0.0);
        check(Rule::ToolFeed, room.radial, 0.0);
    }
}

/// The checks of a mesh, and of the tips of its first and its second gear in it, however they are named.
pub fn mesh_checks<P: Clone>(
    place: &P,
    tips: &[P; 2],
    pair: &Pair,
    limits: &Limits,
    see: &mut impl FnMut(Check<P>),
) {
    let mut check = |rule, place: &P, value, limit| see(Check { rule, place: place.clone(), value, limit });
    check(Rule::ContactRatio, place, pair.transverse_contact_ratio(), limits.contact_ratio);
    for (tip, clearance) in tips.iter().zip(pair.tip_clearances()) {
        check(Rule::TipClearance, tip, clearance, limits.tip_clearance);
    }
    check(Rule::Backlash, place, pair.backlash(), 0.0);
    // Radius of curvature at which each tip meets its mate's flank, and at which the involute of that flank
    // ends; on a ring it ends outwards.
    let [first, second] = pair.gears();
    let at_first = pair.of_mate(second.curvature_radius(second.tip_diameter()));
    let at_second = pair.mate(first.curvature_radius(first.tip_diameter()));
    let outwards = second.sign();
    for (tip, mate, radius, room) in [
        (&tips[1], first, at_first, at_first - first.cut().end),
        (&tips[0], second, at_second, outwards * (at_second - second.cut().end)),
    ] {
        // A hob that undercuts has removed more than the tips of any external mate need.
        if outwards > 0.0 && mate.cut().reach < 0.0 {
            continue;
        }
        check(Rule::Involute, tip, radius, 0.0);
        // A tip below the base circle is one fault, not two.
        if radius >= 0.0 {
            check(Rule::Fillet, tip, room, 0.0);
        }
    }
    if let Some(free) = pair.interference() {
        check(Rule::Trochoidal, place, free.trochoidal, 0.0);
        check(Rule::RadialAssembly, place, free.trimming, 0.0);
    }
}
