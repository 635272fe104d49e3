//! A mechanism at given row parameters, measured and judged.

use super::demand::{Demand, Limits};
use super::mechanism::{Mechanism, largest_error};
use super::objectives::{Objectives, parameter_distance};
use super::size::relative_ring_diameter;
use super::{Drawing, SelectionError};
use epicyclic_schemes::locking::Lock;
use epicyclic_schemes::structures::Role;
use epicyclic_train::Gearbox;
use epicyclic_train::speeds::PlanetMotion;
use std::fmt;

/// A braked gear; speeds and torques are multiples of the input's.
#[derive(Debug, Clone, PartialEq)]
pub struct GearReport {
    /// Its name, `1` or `2`.
    pub name: &'static str,
    /// Ratio wanted.
    pub wanted: f64,
    /// Ratio it has.
    pub ratio: f64,
    /// Efficiency; `None` where the gear locks itself.
    pub efficiency: Option<f64>,
    /// Speeds of the links.
    pub links: Vec<(Role, f64)>,
    /// Speeds of the planets of each row.
    pub planets: Vec<PlanetMotion>,
    /// Torque of the brake on the link it holds, with losses.
    pub brake_torque: Option<f64>,
    /// The same without losses: `i − 1`, whatever the mechanism.
    pub ideal_brake_torque: f64,
    /// Torques on the suns, with losses.
    pub sun_torques: Vec<f64>,
}

/// A line of the shift table.
#[derive(Debug, Clone, PartialEq)]
pub struct Shift {
    /// Name of the gear: `1`, `2`, `direct`.
    pub gear: &'static str,
    /// The one control engaged: `K1`, `K2`, `L`.
    pub engaged: &'static str,
    /// Ratio of speeds.
    pub ratio: f64,
    /// Whether the output turns against the input.
    pub reverses: bool,
}

/// What a candidate is judged by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Criterion {
    /// Ratios within tolerance.
    Ratio,
    /// Row parameters within the range allowed.
    Parameter,
    /// Efficiency of every braked gear.
    Efficiency,
    /// Speeds of all links.
    LinkSpeed,
    /// Planet speeds relative to the carriers.
    PlanetSpeed,
    /// Slip of the open locking clutch.
    ClutchSlip,
    /// Output turns alike in all gears, direct drive among them.
    OneSense,
    /// No self-crossing: the scheme can be drawn in the half-plane.
    Drawable,
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Ratio => "ratio error",
            Self::Parameter => "row parameter",
            Self::Efficiency => "efficiency",
            Self::LinkSpeed => "link speed",
            Self::PlanetSpeed => "planet speed",
            Self::ClutchSlip => "clutch slip",
            Self::OneSense => "one sense of rotation",
            Self::Drawable => "no self-crossing",
        })
    }
}

/// What a criterion says of a candidate.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Which.
    pub criterion: Criterion,
    /// The worst value found, in the criterion's own terms; of a yes or no, 1 or 0.
    pub value: f64,
    /// Its limits, ends included.
    pub limits: [f64; 2],
    /// Whether the value keeps to them.
    pub met: bool,
    /// Whether a candidate is rejected where it does not.
    pub required: bool,
    /// Where the worst value is, or the witness against it.
    pub place: String,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let not = if self.met { "" } else { "not " };
        write!(f, "{}: {:.4} ({}), {not}within ", self.criterion, self.value, self.place)?;
        write!(f, "{} to {}", self.limits[0], self.limits[1])
    }
}

/// A mechanism at given row parameters, measured and judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Which mechanism.
    pub mechanism: Mechanism,
    /// Row parameters `k₁`, `k₂`.
    pub k: Vec<f64>,
    /// The braked gears.
    pub gears: Vec<GearReport>,
    /// Every way to lock, the least torque first.
    pub locks: Vec<Lock>,
    /// Place in `locks` of the one chosen: the least torque among those that can be drawn and slip within
    /// limits; where none does, the least that can be drawn, or the least of all.
    pub lock: usize,
    /// What the criteria say, each once.
    pub verdicts: Vec<Verdict>,
    /// What it is measured by.
    pub objectives: Objectives,
}

impl Candidate {
    /// Whether every required criterion is met.
    #[must_use]
    pub fn is_accepted(&self) -> bool {
        self.verdicts.iter().all(|verdict| verdict.met || !verdict.required)
    }

    /// Criteria not met, required or not: what there is to object to.
    pub fn objections(&self) -> impl Iterator<Item = &Verdict> {
        self.verdicts.iter().filter(|verdict| !verdict.met)
    }

    /// Whether gears, direct drive among them, turn the output in both senses.
    #[must_use]
    pub fn mixes_senses(&self) -> bool {
        self.gears.iter().any(|gear| gear.ratio < 0.0)
    }

    /// Gears and what engages them, the slowest output first.
    #[must_use]
    pub fn shift_table(&self) -> Vec<Shift> {
        let braked = self.gears.iter().zip(["K1", "K2"]);
        let mut table: Vec<Shift> = braked
            .map(|(gear, engaged)| Shift {
                gear: gear.name,
                engaged,
                ratio: gear.ratio,
                reverses: gear.ratio < 0.0,
            })
            .collect();
        table.push(Shift { gear: "direct", engaged: "L", ratio: 1.0, reverses: false });
        table.sort_by(|one, other| other.ratio.abs().total_cmp(&one.ratio.abs()));
        table
    }

    /// The candidate as a gearbox, locked in the chosen way.
    ///
    /// # Errors
    /// None of a candidate of [`select`](super::select).
    pub fn gearbox(&self, demand: &Demand) -> Result<Gearbox, SelectionError> {
        let pair = self.locks.get(self.lock).map_or([Role::D, Role::B], |lock| lock.pair);
        self.mechanism.gearbox(&self.k, demand.eta0, pair)
    }

    /// Measures and judges a mechanism at row parameters above 1.
    pub(crate) fn new(
        mechanism: Mechanism,
        k: Vec<f64>,
        wanted: &[f64],
        demand: &Demand,
        drawing: Option<&Drawing>,
    ) -> Result<Self, SelectionError> {
        let gearbox = mechanism.gearbox(&k, demand.eta0, [Role::D, Role::B])?;
        let gears = ["1", "2"]
            .into_iter()
            .zip(wanted)
            .map(|(name, &wanted)| gear_report(&gearbox, name, wanted))
            .collect::<Result<Vec<_>, _>>()?;
        let ratios: Vec<f64> = gears.iter().map(|gear| gear.ratio).collect();
        let locks = mechanism.locks(&ratios);
        let limits = &demand.limits;
        let drawing = drawing.map(|drawing| drawing(mechanism));
        let drawn = |lock: &Lock| match &drawing {
            Some(Ok(pairs)) if limits.drawable => pairs.contains(&lock.pair),
            _ => true,
        };
        let slips = |lock: &Lock| slip(lock, gears.len()) > limits.clutch_slip * (1.0 + 1e-9);
        let lock = locks.iter().position(|lock| drawn(lock) && !slips(lock));
        let lock = lock.or_else(|| locks.iter().position(drawn)).unwrap_or(0);
        let worst = worst_speeds(&gears);
        let objectives = Objectives {
            efficiency: least_efficiency(&gears).0,
            speed: worst[0].0.max(worst[1].0),
            parameter: k
                .iter()
                .map(|k| parameter_distance(*k, *limits.preferred.start(), *limits.preferred.end()))
                .sum(),
            ratio_error: largest_error(&ratios, wanted),
            size: (0..k.len())
                .map(|row| {
                    let torque = gears.iter().fold(0.0_f64, |m, gear| m.max(gear.sun_torques[row].abs()));
                    relative_ring_diameter(k[row], torque, demand.rating.planets, &demand.rating)
                })
                .fold(0.0, f64::max),
        };
        let mut candidate = Self { mechanism, k, gears, locks, lock, verdicts: vec![], objectives };
        candidate.verdicts = candidate.judge(demand, worst, drawing);
        Ok(candidate)
    }

    fn judge(
        &self,
        demand: &Demand,
        [links, planets]: [(f64, String); 2],
        drawing: Option<Result<Vec<[Role; 2]>, String>>,
    ) -> Vec<Verdict> {
        let Limits { parameter, .. } = &demand.limits;
        let limits = &demand.limits;
        let within = |criterion, (value, place): (f64, String), [least, greatest]: [f64; 2]| {
            // What was chosen to lie at a limit may miss it by rounding.
            let slack = 1e-9 * (1.0 + value.abs());
            let met = value >= least - slack && value <= greatest + slack;
            Verdict { criterion, value, limits: [least, greatest], met, required: true, place }
        };
        let preferred = f64::midpoint(limits.preferred.start().ln(), limits.preferred.end().ln());
        let far = |k: f64| (k.ln() - preferred).abs();
        let odd = (0..self.k.len()).max_by(|a, b| far(self.k[*a]).total_cmp(&far(self.k[*b]))).unwrap_or(0);
        let of_row = |row: usize| format!("row {}", row + 1);
        let error = |gear: &GearReport| (gear.ratio / gear.wanted - 1.0).abs();
        let off = self.gears.iter().max_by(|a, b| error(a).total_cmp(&error(b)));
        let off = off.map_or_else(String::new, |gear| format!("gear {}", gear.name));
        let lock = self.locks.get(self.lock);
        let (slipping, pair) = lock.map_or((f64::INFINITY, "no way to lock".into()), |lock| {
            (slip(lock, self.gears.len()), format!("{}–{}", lock.pair[0], lock.pair[1]))
        });
        let backward: Vec<&str> = self.gears.iter().filter(|g| g.ratio < 0.0).map(|g| g.name).collect();
        let senses = if backward.is_empty() {
            (1.0, "all gears forward".to_owned())
        } else {
            (0.0, format!("gears {} turn against direct drive", backward.join(", ")))
        };
        let mut verdicts = vec![
            within(Criterion::Ratio, (self.objectives.ratio_error, off), [0.0, demand.tolerance]),
            within(Criterion::Parameter, (self.k[odd], of_row(odd)), [*parameter.start(), *parameter.end()]),
            within(Criterion::Efficiency, least_efficiency(&self.gears), [limits.efficiency, 1.0]),
            within(Criterion::LinkSpeed, links, [0.0, limits.link_speed]),
            within(Criterion::PlanetSpeed, planets, [0.0, limits.planet_speed]),
            within(Criterion::ClutchSlip, (slipping, pair), [0.0, limits.clutch_slip]),
            Verdict { required: limits.one_sense, ..within(Criterion::OneSense, senses, [1.0, 1.0]) },
        ];
        if let Some(drawing) = drawing {
            let found = drawing.map_or_else(
                |witness| (0.0, witness),
                |pairs| (1.0, format!("drawn, {} ways to lock", pairs.len())),
            );
            let verdict = within(Criterion::Drawable, found, [1.0, 1.0]);
            verdicts.push(Verdict { required: limits.drawable, ..verdict });
        }
        verdicts
    }
}

fn gear_report(gearbox: &Gearbox, name: &'static str, wanted: f64) -> Result<GearReport, SelectionError> {
    let found = gearbox.analyze(name)?;
    let not_driven = || epicyclic_train::Error::NotDriven { state: found.state().to_string() };
    let ratio = found.ratio().ok_or_else(not_driven)?;
    let link = |role: Role| Some((role, found.speed(gearbox.link(role.symbol())?)?));
    let brake = if name == "1" { 0 } else { 1 };
    let loaded = found.driving();
    Ok(GearReport {
        name,
        wanted,
        ratio,
        efficiency: found.efficiency(),
        links: Role::ALL.into_iter().filter_map(link).collect(),
        planets: found.sets().iter().flat_map(|set| set.planets.iter().copied().flatten()).collect(),
        brake_torque: loaded.and_then(|case| case.shift_elements[brake]),
        ideal_brake_torque: ratio - 1.0,
        sun_torques: (0..gearbox.sets().len())
            .map(|set| loaded.and_then(|case| case.members[set].as_ref()).map_or(0.0, |torques| torques[0]))
            .collect(),
    })
}

/// The largest slip of an open clutch over the braked gears.
pub(crate) fn slip(lock: &Lock, gears: usize) -> f64 {
    lock.slip[..gears].iter().fold(0.0, |m, slip| m.max(slip.abs()))
}

/// A gear without an efficiency locks itself: it has none worth having.
fn least_efficiency(gears: &[GearReport]) -> (f64, String) {
    let of = |gear: &GearReport| (gear.efficiency.unwrap_or(0.0), format!("gear {}", gear.name));
    gears.iter().map(of).min_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or((1.0, String::new()))
}

/// The largest speeds of links and of planets relative to their carriers.
fn worst_speeds(gears: &[GearReport]) -> [(f64, String); 2] {
    let mut worst = [(0.0, String::new()), (0.0, String::new())];
    for gear in gears {
        let links = gear.links.iter().map(|(role, speed)| (0, *speed, role.to_string()));
        let planets = gear.planets.iter().enumerate();
        let planets = planets.map(|(row, planet)| (1, planet.relative, format!("planet {}", row + 1)));
        for (kind, speed, name) in links.chain(planets) {
            if speed.abs() > worst[kind].0 {
                worst[kind] = (speed.abs(), format!("{name} in gear {}", gear.name));
            }
        }
    }
    worst
}
