//! Requests for lists of gears.

use super::Design;
use super::answer::transmission::{self, K, Transmission, WantedTransmission};
use super::request::{Request, refuse_of};
use crate::error::Error;
use crate::failure::Failure;
use crate::shared::application::{Application, FULL_LOAD};
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::Orders;
use epicyclic_synthesis::limits::Limits;
use epicyclic_synthesis::usable::Usable;
use epicyclic_units::Physical;
use std::ops::ControlFlow;

/// Most ratios of braked gears; a list of more is one of all gears.
const MOST_BRAKED: usize = 2;

impl Request {
    /// Whether a list of all gears is asked for: of more ratios than a scheme has braked gears, in both
    /// directions, or with one of 1.
    pub(super) fn is_of_gears(&self) -> bool {
        let ratios = self.listed_ratios();
        let signs = [ratios.iter().any(|ratio| *ratio < 0.0), ratios.iter().any(|ratio| *ratio > 0.0)];
        ratios.len() > MOST_BRAKED || signs == [true; 2] || ratios.len() > 1 && ratios.contains(&1.0)
    }

    /// Whether a structure of any kind may replace a design that has no tooth numbers.
    pub(super) fn may_be_of_gears(&self, design: &Design) -> bool {
        self.scheme.is_none() && self.tooth_design.is_none() && !self.may_reverse && design.teeth.is_none()
    }

    /// Designs a gearbox for a list of gears: ratios or speeds. Direct drive is added to ratios of braked
    /// gears; the fastest speed is direct. The closure is called now and then, and may end the search.
    ///
    /// # Errors
    /// As of [`Request::answer`].
    pub fn answer_gears(
        &self,
        goes_on: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Transmission, Failure> {
        let of_schemes = [
            ("--scheme", self.scheme.is_some()),
            ("--tooth-design", self.tooth_design.is_some()),
            ("--all-structures", self.speeds.all_structures),
            ("--signs", self.ratios.signs.is_some()),
            ("--brakes", self.ratios.brakes != Orders::Either),
            ("--prefer", self.criteria.has_own_preference()),
            ("--allow-crossing", self.criteria.allow_crossing),
            ("--may-reverse", self.may_reverse),
        ];
        if let Some((option, _)) =
            of_schemes.into_iter().find(|(_, is_given)| *is_given && self.is_of_gears())
        {
            let message = "leave it out: it chooses among the schemes of one or two --ratios beside direct drive, and a list of all gears takes structures of synthesize";
            return Err(Failure::invalid(option, message));
        }
        let mut ratios = self.listed_ratios();
        if let Some(wrong) = ratios.iter().find(|ratio| !(ratio.is_finite() && **ratio != 0.0)) {
            return Err(Failure::invalid("--ratios", format!("{wrong} is no ratio; it must not be 0")));
        }
        let is_repeated = |(place, ratio): &(usize, &f64)| ratios[..*place].contains(ratio);
        if let Some((_, twice)) = ratios.iter().enumerate().find(is_repeated) {
            let message = format!("{twice} is given twice: every gear has a ratio of its own; write it once");
            return Err(Failure::invalid("--ratios", message));
        }
        if let Some(speeds) = &self.speeds.speeds {
            let speeds: Vec<f64> = speeds.values().into_iter().map(Physical::si).collect();
            let fastest = speeds.iter().copied().fold(0.0, f64::max);
            ratios = speeds.iter().map(|speed| fastest / speed).collect();
        } else if !self.is_of_gears() {
            ratios.push(1.0);
        }
        let torque = self.duty().torque().map_err(refuse_of)?.ok_or(Error::NoLoad).map_err(refuse_of)?;
        let all_k = Bounds::default().ring_to_sun_ratio;
        let asked_k = self.criteria.k(all_k.clone())?;
        let k = if asked_k == all_k { K } else { asked_k };
        let mut shares = self.shares(ratios.len())?;
        if shares.is_empty() {
            shares = self.sizes.application.map(|of| of.shares(&ratios)).unwrap_or_default();
        }
        let wanted = WantedTransmission {
            ratios,
            tolerance: self.tolerance()?,
            bounds: self.bounds([17..=60, 17..=80, 50..=140])?,
            k,
            limits: Limits {
                slip: Some(self.criteria.clutch_slip.get()),
                link_speed: Some(self.criteria.link_speed.get()),
                planet_speed: Some(self.criteria.planet_speed.get()),
                ..Limits::default()
            },
            usable: Usable {
                forward: self.criteria.least_efficiency.0.si(),
                circulation: self.criteria.circulation.map_or(Usable::default().circulation, |of| of.0.si()),
                ..Usable::default()
            },
            efficiency: self.criteria.set_efficiency()?,
            speed: self.input.0,
            torque,
            shares,
            overload: self.overload()?,
            spectrum: self.spectrum(self.sizes.application.map_or(&FULL_LOAD, Application::spectrum))?,
            order: self.limits()?,
            is_front_asked: self.front,
            basis: self.basis()?,
            size: self.sized(),
        };
        let mut transmission = transmission::answer(&wanted, goes_on).map_err(refuse_of)?;
        transmission.warnings.extend(self.unused());
        Ok(transmission)
    }

    /// The ratios of the request.
    fn listed_ratios(&self) -> Vec<f64> {
        self.speeds.ratios.iter().flat_map(|list| &list.0).map(|ratio| ratio.get()).collect()
    }
}
