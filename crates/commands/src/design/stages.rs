//! Requests for one ratio: stages in series.

use super::request::{Request, refuse_of};
use crate::design::answer::axes::Axes;
use crate::design::answer::stage_kind::StageKind;
use crate::design::answer::stages::{MOST_STAGES, Stages};
use crate::design::answer::stages_wanted::WantedStages;
use crate::design::answer::stages_ways_out::{self, LARGE_SUNS};
use crate::error::Error;
use crate::failure::Failure;
use crate::select::answer::duty::{Duty, Load};
use crate::shared::application::{Application, FULL_LOAD};
use epicyclic_gears::synthesis::Bounds;
use epicyclic_strength::series::Teeth;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use std::ops::ControlFlow;

/// Teeth of the largest suns of sets with planets of two gears, unless more are given.
const MOST_ARRANGED: u32 = 60;

impl Request {
    /// Designs stages in series. The closure is called now and then, and may end the search.
    ///
    /// # Errors
    /// As of [`Self::answer`].
    pub fn answer_stages(&self, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Stages, Failure> {
        let mut stages = stages_ways_out::answer(&self.wanted_stages()?, goes_on).map_err(refuse_of)?;
        stages.warnings.extend(self.unused());
        Ok(stages)
    }

    fn wanted_stages(&self) -> Result<WantedStages, Failure> {
        let due = || Failure::missing("--ratio", "the ratio, or the speed of the output, is due");
        let speed = self.input.0.abs();
        let ratio = match (self.ratio, self.output_speed) {
            (Some(ratio), _) => ratio.get(),
            (None, Some(output)) => (self.input.0 / output.0).si(),
            (None, None) => return Err(due()),
        };
        if ratio.is_infinite() {
            return Err(Failure::invalid(
                "--output-speed",
                "the output must turn; write a speed other than 0",
            ));
        }
        let turns_back = ratio < 0.0;
        let axes = self.axes.unwrap_or(match turns_back {
            true => Axes::Coaxial,
            false => Axes::usual(self.sizes.application),
        });
        if turns_back && axes == Axes::Either {
            let message = "where the housing turns, or behind a pair of gears, the output turns against the input; \
                           write --axes coaxial or --axes parallel";
            return Err(Failure::invalid("--axes", message));
        }
        // A quotient of the fast speed over the slow one.
        let steps_up = ratio.abs() < 1.0;
        let quotient = if steps_up { 1.0 / ratio.abs() } else { ratio.abs() };
        if !(quotient.is_finite() && quotient > 1.0) {
            let message =
                format!("{}: stages in series have a ratio other than 0, 1 and -1", trimmed(ratio, 6));
            let option = if self.ratio.is_some() { "--ratio" } else { "--output-speed" };
            return Err(Failure::invalid(option, message));
        }
        let is_wrong = |torque: f64| torque == 0.0 || torque < 0.0 && !turns_back;
        if self.output_torque.is_some_and(|torque| is_wrong(torque.0.si())) {
            let message = "the torque on the output is above 0; its direction is that of --ratio";
            return Err(Failure::invalid("--output-torque", message));
        }
        let load = match (self.torque, self.output_torque, self.power) {
            (Some(torque), ..) => Some(Load::Torque(torque.0)),
            // The torque on an output that turns backward may be written with its sign or without.
            (_, Some(torque), _) if turns_back => Some(Load::Torque((torque.0 / ratio).abs())),
            (_, Some(torque), _) => Some(Load::Torque(torque.0 / ratio)),
            (.., power) => power.map(|power| Load::Power(power.0)),
        };
        // Power enters in either direction.
        let duty = Duty { input_speed: Some(speed), load };
        let tolerance = self.tolerance()?;
        self.refuse_ring()?;
        let mut suns = Application::suns(self.sizes.application);
        let product = quotient + f64::from(turns_back);
        let larger = LARGE_SUNS.iter().find(|(below, _)| product < *below);
        // The suns of servo drives stay small.
        if let Some((_, most)) = larger.filter(|_| self.sizes.application != Some(Application::Robot)) {
            suns = *suns.start()..=*most;
        }
        let bounds = self.teeth([suns, 17..=80, 50..=160])?;
        let (fewest, most) = (*bounds.sun.start(), *bounds.sun.end());
        // Large suns make Wolfrom sets light, and are few.
        let arranged_suns = fewest..=if self.sun.is_none() { MOST_ARRANGED.max(most) } else { most };
        if axes == Axes::Parallel && self.stages == Some(1..=1) {
            let of_sets = [
                ("--sun", self.sun.is_some()),
                ("--planet", self.planet.is_some()),
                ("--ring", self.ring.is_some()),
                ("--ring-offset", self.ring_offset.is_some()),
            ];
            if let Some((option, _)) = of_sets.into_iter().find(|(_, is_given)| *is_given) {
                let message =
                    "a pair alone has no sun, planets or ring; leave it out, or allow more --stages";
                return Err(Failure::invalid(option, message));
            }
        }
        let kinds = self.kinds(axes, steps_up)?;
        // Gearboxes of wind turbines have three stages at most.
        let most = if self.sizes.application == Some(Application::Wind) { 3 } else { MOST_STAGES };
        let stages = self.stages.clone().unwrap_or(1..=most);
        Ok(WantedStages {
            ratio: quotient,
            steps_up,
            turns_back,
            axes,
            kinds,
            tolerance,
            stages: *stages.start() as usize..=*stages.end() as usize,
            teeth: Teeth {
                suns: bounds.sun,
                planets: bounds.planet,
                rings: bounds.ring,
                ring_offsets: self.ring_offset.clone().unwrap_or(0..=0),
                ring_to_sun_ratio: self.criteria.k(Bounds::default().ring_to_sun_ratio)?,
                is_hunting: self.hunting_teeth || self.sizes.application == Some(Application::Wind),
            },
            arranged_suns,
            speed,
            is_backward: self.input.0.si() < 0.0,
            is_front_asked: self.front,
            is_hunting_asked: self.hunting_teeth && self.sizes.application != Some(Application::Wind),
            torque: duty.torque().map_err(refuse_of)?.ok_or(Error::NoLoad).map_err(refuse_of)?,
            is_of_output: self.output_torque.is_some(),
            overload: self.overload()?,
            spectrum: self.spectrum(&FULL_LOAD)?,
            backlash: self.backlash.map(|angle| angle.0),
            limits: self.limits()?,
            efficiency: self.criteria.set_efficiency()?.get(),
            basis: self.basis()?,
            size: self.sized(),
        })
    }

    /// Kinds of stages to choose from: each once.
    fn kinds(&self, axes: Axes, steps_up: bool) -> Result<Vec<StageKind>, Failure> {
        let mut kinds = self.kind.clone();
        kinds.sort_unstable();
        kinds.dedup();
        let refuse = |message| Err(Failure::conflict("--kind", message));
        if kinds.iter().any(|kind| *kind != StageKind::Simple) {
            if self.stages.as_ref().is_some_and(|stages| !stages.contains(&1)) {
                return refuse(
                    "a set with stepped planets and a Wolfrom set are one stage; write --stages 1, or leave it out",
                );
            }
            if axes == Axes::Parallel {
                return refuse(
                    "a pair of gears is in front of simple sets; leave out --axes, or write --kind simple",
                );
            }
        }
        if steps_up && kinds.contains(&StageKind::Wolfrom) {
            return refuse(
                "the losses of a Wolfrom set that steps up usually hold it; write --kind simple,stepped",
            );
        }
        Ok(kinds)
    }
}
