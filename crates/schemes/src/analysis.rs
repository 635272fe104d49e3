//! Everything about one gear: state, ratio, speeds, torques, powers, efficiency.

use crate::compiled::{CompiledGear, Direction, Solution, verdict};
use crate::efficiency::{Pattern, patterns};
use crate::kreines::{Kreines, kreines, ratio};
use crate::speeds::{RowMotion, link_speeds, row_motion, slips};
use crate::topology::{Topology, numbers};
use crate::torques::{LoadCase, Scene, ideal, loaded};
use crate::{Error, Gear, Gearbox, LinkId, State};
use epicyclic_gears::row::Fraction;

/// What the solver says of one gear.
///
/// Speeds are multiples of the input's speed and torques of the input's torque;
/// [`at`](Self::at) turns them into quantities.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    pub(crate) gear: Gear,
    pub(crate) state: State,
    pub(crate) ratio: Option<f64>,
    pub(crate) exact_ratio: Option<Fraction>,
    pub(crate) speeds: Vec<Option<f64>>,
    pub(crate) rows: Vec<RowMotion>,
    pub(crate) slips: Vec<Option<f64>>,
    pub(crate) ideal: Option<LoadCase>,
    pub(crate) driving: Option<LoadCase>,
    pub(crate) overrun: Option<LoadCase>,
    pub(crate) kreines: Option<Kreines>,
    pub(crate) patterns: Vec<Pattern>,
}

impl Gearbox {
    /// Analyses a gear by name.
    ///
    /// ```
    /// use epicyclic_schemes::{Gearbox, row::{RowKind, RowSpec}};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("prius split")
    ///     .links(["engine", "mg1", "ring"])
    ///     .row(RowSpec::teeth("PSD", RowKind::Simple, ["mg1", "ring", "engine"], 30, 78)?)
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
    /// [`Error::Unknown`] for a gear that does not exist, [`Error::TooMany`] beyond the fixed size of
    /// the solver. That a gear is not driven is no error: see [`Analysis::state`].
    pub fn analyze(&self, gear: &str) -> Result<Analysis, Error> {
        self.analyze_gear(self.gear(gear)?)
    }

    /// Analyses a gear, named or made by [`Gearbox::gear_of`].
    ///
    /// # Errors
    /// [`Error::TooMany`] beyond the fixed size of the solver.
    pub fn analyze_gear(&self, gear: &Gear) -> Result<Analysis, Error> {
        let topology = Topology::new(self, gear);
        let verdict = verdict(self, &topology);
        let speeds = link_speeds(&topology, &verdict);
        let mut analysis = Analysis {
            gear: gear.clone(),
            state: verdict.state.clone(),
            ratio: None,
            exact_ratio: None,
            rows: self.rows.iter().map(|row| row_motion(row, &speeds)).collect(),
            slips: slips(self, gear, &speeds),
            speeds,
            ideal: None,
            driving: None,
            overrun: None,
            kreines: None,
            patterns: vec![],
        };
        let output = topology.output.and_then(|node| verdict.speeds[node]).filter(|speed| *speed != 0.0);
        analysis.ratio =
            output.map(f64::recip).filter(|_| !matches!(verdict.state, State::InputBlocked { .. }));
        if analysis.ratio.is_some() {
            let known: Vec<Option<Fraction>> = self.rows.iter().map(|row| row.exact).collect();
            analysis.exact_ratio = ratio(&topology, &known).filter(|i| *i.numer() != 0);
        }
        if !verdict.solvable {
            return Ok(analysis);
        }
        let compiled = CompiledGear::of(self, &topology, &verdict)?;
        let scene = Scene {
            gearbox: self,
            topology: &topology,
            verdict: &verdict,
            compiled: &compiled,
            speeds: &analysis.speeds,
        };
        let ratios = numbers(self);
        let shared: Vec<f64> = self.shared.iter().map(|mesh| mesh.eta).collect();
        let solve = |direction| {
            let mut solution = Solution::default();
            let own = |row: usize| self.own_efficiency(row);
            compiled
                .solve_numbers(|row| ratios[row], own, &shared, direction, &mut solution)
                .then_some(solution)
        };
        let (Some(forward), Some(backward)) = (solve(Direction::Drive), solve(Direction::Overrun)) else {
            return Ok(analysis);
        };
        let driving = loaded(&scene, Direction::Drive, &forward);
        let signs = driving.as_ref().map(|case| (case.signs.as_slice(), case.shared_signs.as_slice()));
        analysis.kreines = kreines(self, &topology, &ratios, signs);
        analysis.patterns = patterns(&scene, &ratios, &forward);
        analysis.ideal = Some(ideal(&scene, &ratios, &forward));
        analysis.overrun = loaded(&scene, Direction::Overrun, &backward);
        analysis.driving = driving;
        Ok(analysis)
    }
}

impl Analysis {
    /// The gear.
    #[must_use]
    pub fn gear(&self) -> &Gear {
        &self.gear
    }

    /// Its state.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Ratio `i = ω_in/ω_out`, where the output turns at a speed that follows from the input's.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        self.ratio
    }

    /// The ratio as a fraction of tooth counts, where those of all rows that settle it are known.
    #[must_use]
    pub fn exact_ratio(&self) -> Option<Fraction> {
        self.exact_ratio
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

    /// Motion of each row.
    #[must_use]
    pub fn rows(&self) -> &[RowMotion] {
        &self.rows
    }

    /// Slip of each control, `ω_first − ω_second`: 0 when engaged, `None` where it does not follow.
    #[must_use]
    pub fn slips(&self) -> &[Option<f64>] {
        &self.slips
    }

    /// Torques and powers without losses, driven from the input.
    #[must_use]
    pub fn ideal(&self) -> Option<&LoadCase> {
        self.ideal.as_ref()
    }

    /// Torques and powers with losses, driven from the input.
    #[must_use]
    pub fn driving(&self) -> Option<&LoadCase> {
        self.driving.as_ref()
    }

    /// Torques and powers with losses, driven from the output.
    #[must_use]
    pub fn overrun(&self) -> Option<&LoadCase> {
        self.overrun.as_ref()
    }

    /// Efficiency driven from the input; `None` unless driven (or [torques are
    /// indeterminate](State::TorquesIndeterminate) where nothing is lost), or where no torque at the
    /// input moves the gear against its losses.
    #[must_use]
    pub fn efficiency(&self) -> Option<f64> {
        self.driving.as_ref().map(|case| case.efficiency)
    }

    /// Efficiency driven from the output; `None` as in [`efficiency`](Self::efficiency).
    #[must_use]
    pub fn overrun_efficiency(&self) -> Option<f64> {
        self.overrun.as_ref().map(|case| case.efficiency)
    }

    /// Whether a driven gear cannot be moved from its output: overrun efficiency at or below 0.
    /// `None` where no losses follow.
    #[must_use]
    pub fn is_self_locking(&self) -> Option<bool> {
        self.ideal.as_ref().map(|_| self.overrun_efficiency().is_none_or(|eta| eta <= 0.0))
    }

    /// What Kreines' rule says.
    #[must_use]
    pub fn kreines(&self) -> Option<&Kreines> {
        self.kreines.as_ref()
    }

    /// Self-consistent patterns of signs, the chosen one first.
    #[must_use]
    pub fn patterns(&self) -> &[Pattern] {
        &self.patterns
    }
}
