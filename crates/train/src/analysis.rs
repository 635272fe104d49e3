//! Everything about one gear: state, ratio, speeds, torques, powers, efficiency.

use crate::compiled::{CompiledGear, verdict};
use crate::efficiency::{Pattern, patterns};
use crate::kreines::{Kreines, kreines, ratio};
use crate::solution::{Direction, Solution};
use crate::speeds::{SetMotion, link_speeds, set_motion, slips};
use crate::state::Verdict;
use crate::topology::{Topology, numbers};
use crate::torques::{LoadCase, Scene, ideal, loaded};
use crate::{Error, Gear, Gearbox, LinkId, State};
use epicyclic_gears::simple_set::Fraction;
use std::sync::OnceLock;

/// Result of solving one gear: state, ratio, speeds, torques and efficiencies.
///
/// Speeds are multiples of the input's speed and torques of the input's torque; [`at`](Self::at) turns them
/// into quantities. A result is computed on first request and then kept: a ratio or a speed costs neither
/// torques nor efficiencies.
#[derive(Debug, Clone)]
pub struct Analysis<'g> {
    pub(crate) gearbox: &'g Gearbox,
    pub(crate) gear: Gear,
    pub(crate) topology: Topology,
    pub(crate) verdict: Verdict,
    ratio: Option<f64>,
    speeds: Vec<Option<f64>>,
    compiled: OnceLock<Option<CompiledGear>>,
    state: OnceLock<State>,
    exact_ratio: OnceLock<Option<Fraction>>,
    sets: OnceLock<Vec<SetMotion>>,
    slips: OnceLock<Vec<Option<f64>>>,
    forward: OnceLock<Option<Solution>>,
    backward: OnceLock<Option<Solution>>,
    ideal: OnceLock<Option<LoadCase>>,
    driving: OnceLock<Option<LoadCase>>,
    back_driving: OnceLock<Option<LoadCase>>,
    kreines: OnceLock<Option<Kreines>>,
    patterns: OnceLock<Vec<Pattern>>,
}

impl Gearbox {
    /// Analyses a gear by name.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("prius split")
    ///     .links(["engine", "mg1", "ring"])
    ///     .set(SetSpec::teeth("PSD", SetKind::Simple, ["mg1", "ring", "engine"], 30, 78)?)
    ///     .brake("hold", "mg1")
    ///     .input("engine")
    ///     .output("ring")
    ///     .gear("mechanical", ["hold"])
    ///     .gear("split", [""; 0])
    ///     .build()?;
    /// let held = gearbox.analyze("mechanical")?;
    /// assert_eq!(held.exact_ratio().unwrap().to_string(), "13/18"); // 78/108
    /// let split = gearbox.analyze("split")?;
    /// assert_eq!(split.state().to_string(), "underdetermined (mg1, ring)");
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`] for a gear that does not exist. A gear that is not driven is no error: see
    /// [`Analysis::state`].
    pub fn analyze(&self, gear: &str) -> Result<Analysis<'_>, Error> {
        self.analyze_gear(self.gear(gear)?)
    }

    /// Analyses a gear, named or made by [`Gearbox::gear_of`].
    ///
    /// # Errors
    /// [`Error::ForeignGear`] for a gear of another gearbox.
    pub fn analyze_gear(&self, gear: &Gear) -> Result<Analysis<'_>, Error> {
        self.check_gear(gear)?;
        let topology = Topology::new(self, gear);
        let verdict = verdict(self, &topology);
        let output = topology.output.and_then(|node| verdict.speeds[node]).filter(|speed| *speed != 0.0);
        let is_blocked = matches!(verdict.state, State::InputBlocked { .. });
        Ok(Analysis {
            gearbox: self,
            gear: gear.clone(),
            // A blocked input is at rest, so the speeds of its links relate to no input speed and give no
            // ratio.
            ratio: output.map(f64::recip).filter(|_| !is_blocked),
            speeds: link_speeds(&topology, &verdict),
            topology,
            verdict,
            compiled: OnceLock::new(),
            state: OnceLock::new(),
            exact_ratio: OnceLock::new(),
            sets: OnceLock::new(),
            slips: OnceLock::new(),
            forward: OnceLock::new(),
            backward: OnceLock::new(),
            ideal: OnceLock::new(),
            driving: OnceLock::new(),
            back_driving: OnceLock::new(),
            kreines: OnceLock::new(),
            patterns: OnceLock::new(),
        })
    }
}

impl<'g> Analysis<'g> {
    /// The gearbox.
    #[must_use]
    pub fn gearbox(&self) -> &'g Gearbox {
        self.gearbox
    }

    /// The gear.
    #[must_use]
    pub fn gear(&self) -> &Gear {
        &self.gear
    }

    /// State of the gear.
    #[must_use]
    pub fn state(&self) -> &State {
        self.state.get_or_init(|| {
            let moves = |efficiency: Option<f64>| efficiency.is_some_and(|efficiency| efficiency > 0.0);
            // Only a solved case with losses can show self-locking: without losses every driven gear moves.
            if self.verdict.state != State::Driven
                || !self.gearbox.sets.iter().any(crate::PlanetSet::has_losses)
                || self.solution(Direction::Drive).is_none()
                || moves(self.efficiency())
            {
                return self.verdict.state.clone();
            }
            State::SelfLocking {
                links: vec![self.gearbox.link_name(self.gear.input).to_owned()],
                both_ways: !moves(self.back_driving_efficiency()),
            }
        })
    }

    /// State of the gear by speeds and ranks alone, whatever the losses.
    #[must_use]
    pub fn kinematic_state(&self) -> &State {
        &self.verdict.state
    }

    /// Ratio `i = ω_in/ω_out`, where the output turns at a speed that follows from the input's.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        self.ratio
    }

    /// The ratio as a fraction of tooth counts, where those of all sets that settle it are known.
    #[must_use]
    pub fn exact_ratio(&self) -> Option<Fraction> {
        *self.exact_ratio.get_or_init(|| {
            self.ratio?;
            let known: Vec<Option<Fraction>> = self.gearbox.equations.iter().map(|one| one.exact).collect();
            ratio(&self.topology, &known).filter(|i| *i.numer() != 0)
        })
    }

    /// Speed of a link as a multiple of the input's (of a blocked input: 0 where the link rests);
    /// `None` where it does not follow.
    #[must_use]
    pub fn speed(&self, link: LinkId) -> Option<f64> {
        self.speeds.get(link.index()).copied().flatten()
    }

    /// Speeds of all links by [`LinkId::index`].
    #[must_use]
    pub fn speeds(&self) -> &[Option<f64>] {
        &self.speeds
    }

    /// Motion of each set.
    #[must_use]
    pub fn sets(&self) -> &[SetMotion] {
        self.sets.get_or_init(|| self.gearbox.sets.iter().map(|set| set_motion(set, &self.speeds)).collect())
    }

    /// Number of sets whose meshes roll. Sets that turn as one have none.
    #[must_use]
    pub fn rolling_sets(&self) -> usize {
        self.sets().iter().filter(|set| set.relative.is_some_and(|speed| speed != 0.0)).count()
    }

    /// Circulating power of a load of this gear, over the power that enters; 0 where everything turns as one,
    /// since no mesh loses any of it.
    #[must_use]
    pub fn circulating(&self, case: &LoadCase) -> f64 {
        if self.rolling_sets() == 0 { 0.0 } else { case.power.circulating }
    }

    /// Slip of each shift element, `ω_first − ω_second`: 0 when engaged, `None` where it does not follow.
    #[must_use]
    pub fn slips(&self) -> &[Option<f64>] {
        self.slips.get_or_init(|| slips(self.gearbox, &self.gear, &self.speeds))
    }

    fn compiled(&self) -> Option<&CompiledGear> {
        let compile =
            || self.verdict.solvable.then(|| CompiledGear::of(self.gearbox, &self.topology, &self.verdict));
        self.compiled.get_or_init(compile).as_ref()
    }

    fn solution(&self, direction: Direction) -> Option<&Solution> {
        let solve = || {
            let mut solution = Solution::default();
            let gearbox = self.gearbox;
            let solved = self.compiled()?.solve_numbers(
                |equation| gearbox.equations[equation].ratio,
                |segment| gearbox.segments[segment].efficiency,
                direction,
                0.0,
                &mut solution,
            );
            solved.then_some(solution)
        };
        match direction {
            Direction::Drive => self.forward.get_or_init(solve).as_ref(),
            Direction::BackDrive => self.backward.get_or_init(solve).as_ref(),
        }
    }

    fn scene<'a>(&'a self, compiled: &'a CompiledGear) -> Scene<'a> {
        Scene {
            gearbox: self.gearbox,
            topology: &self.topology,
            verdict: &self.verdict,
            compiled,
            speeds: &self.speeds,
        }
    }

    /// Torques and powers without losses, driven from the input.
    #[must_use]
    pub fn ideal(&self) -> Option<&LoadCase> {
        let case = || {
            let scene = self.scene(self.compiled()?);
            Some(ideal(&scene, &numbers(self.gearbox), self.solution(Direction::Drive)?))
        };
        self.ideal.get_or_init(case).as_ref()
    }

    /// Torques and powers with losses, driven from the input.
    ///
    /// With an efficiency at or below 0 the gear is [self-locking](State::SelfLocking), and these are the
    /// torques at which it just moves when the output helps.
    #[must_use]
    pub fn driving(&self) -> Option<&LoadCase> {
        self.driving.get_or_init(|| self.loaded(Direction::Drive)).as_ref()
    }

    /// Torques and powers with losses, driven from the output.
    #[must_use]
    pub fn back_driving(&self) -> Option<&LoadCase> {
        self.back_driving.get_or_init(|| self.loaded(Direction::BackDrive)).as_ref()
    }

    fn loaded(&self, direction: Direction) -> Option<LoadCase> {
        loaded(&self.scene(self.compiled()?), direction, self.solution(direction)?)
    }

    /// Efficiency driven from the input; `None` unless driven (or [torques are
    /// indeterminate](State::TorquesIndeterminate) where nothing is lost), or where no torque at the
    /// input moves the gear against its losses.
    #[must_use]
    pub fn efficiency(&self) -> Option<f64> {
        self.solution(Direction::Drive)?.efficiency()
    }

    /// Back-driving efficiency, from the output; `None` as in [`efficiency`](Self::efficiency).
    #[must_use]
    pub fn back_driving_efficiency(&self) -> Option<f64> {
        self.solution(Direction::BackDrive)?.efficiency()
    }

    /// Whether a gear cannot be moved from its output: back-driving efficiency at or below 0.
    /// `None` where no losses follow.
    #[must_use]
    pub fn is_self_locking(&self) -> Option<bool> {
        self.solution(Direction::Drive)?;
        Some(self.back_driving_efficiency().is_none_or(|eta| eta <= 0.0))
    }

    /// Result of Kreines' rule.
    #[must_use]
    pub fn kreines(&self) -> Option<&Kreines> {
        let rule = || {
            let solution = self.solution(Direction::Drive)?;
            let mut signs = vec![0; self.gearbox.segments.len()];
            for (&segment, &sign) in self.compiled()?.segments.iter().zip(solution.signs()) {
                signs[segment] = sign;
            }
            // Without a branch no loaded torques exist, so the rule has no signs to compare its own with.
            kreines(self.gearbox, &self.topology, solution.has_branch.then_some(signs.as_slice()))
        };
        self.kreines.get_or_init(rule).as_ref()
    }

    /// Self-consistent patterns of signs, the chosen one first.
    #[must_use]
    pub fn patterns(&self) -> &[Pattern] {
        let all = || {
            let found = self.solution(Direction::Drive)?;
            Some(patterns(&self.scene(self.compiled()?), &numbers(self.gearbox), found))
        };
        self.patterns.get_or_init(|| all().unwrap_or_default())
    }
}
