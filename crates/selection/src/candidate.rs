//! A mechanism at given ring-to-sun ratios, measured and judged.

use super::mechanism::{Mechanism, largest_error};
use super::objectives::{Objectives, ring_to_sun_distance};
use super::requirements::{Limits, OBJECTED_CIRCULATION, Requirements};
use super::size::relative_ring_diameter;
use super::tolerance::SLACK;
use super::{Drawing, Error, NotDrawable};
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_schemes::catalogue::{SchemeElement, SchemeGear};
use epicyclic_schemes::direct_drive::DirectClutch;
use epicyclic_schemes::structures::Role;
use epicyclic_train::Gearbox;
use epicyclic_train::set::{Gearing, SetSpec};
use epicyclic_train::speeds::PlanetMotion;
use std::fmt;

/// A braked gear; speeds and torques are multiples of the input's.
#[derive(Debug, Clone, PartialEq)]
pub struct GearReport {
    /// The gear.
    pub gear: SchemeGear,
    /// Target ratio.
    pub wanted: f64,
    /// Ratio it has.
    pub ratio: f64,
    /// Efficiency; `None` where the gear is self-locking.
    pub efficiency: Option<f64>,
    /// Speeds of the links.
    pub links: Vec<(Role, f64)>,
    /// Speeds of the planets of each set.
    pub planets: Vec<PlanetMotion>,
    /// Torque of the brake on the link it holds, with losses.
    pub brake_torque: Option<f64>,
    /// Brake torque without losses: `i − 1`, whatever the mechanism.
    pub ideal_brake_torque: f64,
    /// Torques on the suns, with losses.
    pub sun_torques: Vec<f64>,
    /// Circulating power over what enters; `None` where the gear is self-locking.
    pub circulation: Option<f64>,
}

/// A line of the engagement table.
#[derive(Debug, Clone, PartialEq)]
pub struct Engagement {
    /// The gear.
    pub gear: SchemeGear,
    /// The one shift element engaged.
    pub engaged: SchemeElement,
    /// Ratio of speeds.
    pub ratio: f64,
    /// Whether the output turns against the input.
    pub reverses: bool,
}

/// Criterion by which a candidate is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Criterion {
    /// Ratios within tolerance.
    Ratio,
    /// Ring-to-sun ratios within the range allowed.
    RingToSun,
    /// Efficiency of every braked gear.
    Efficiency,
    /// Speeds of all links.
    LinkSpeed,
    /// Planet speeds relative to the carriers.
    PlanetSpeed,
    /// Slip of the open direct-drive clutch.
    ClutchSlip,
    /// Circulating power of every braked gear.
    Circulation,
    /// Output turns alike in all gears, direct drive among them.
    SameDirection,
    /// No self-crossing: the scheme can be drawn in the half-plane.
    Drawable,
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Ratio => "ratio error",
            Self::RingToSun => "ring-to-sun ratio",
            Self::Efficiency => "efficiency",
            Self::LinkSpeed => "link speed",
            Self::PlanetSpeed => "planet speed",
            Self::ClutchSlip => "clutch slip",
            Self::Circulation => "circulating power",
            Self::SameDirection => "same direction of rotation",
            Self::Drawable => "no self-crossing",
        })
    }
}

/// Result of a criterion for a candidate.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The criterion.
    pub criterion: Criterion,
    /// The worst value found, in the criterion's own terms; of a yes or no, 1 or 0.
    pub value: f64,
    /// Limits, ends included.
    pub limits: [f64; 2],
    /// Whether the value keeps to them.
    pub met: bool,
    /// Whether a candidate is rejected where it does not.
    pub required: bool,
    /// Place of the worst value, or reason for a yes or no.
    pub evidence: Evidence,
}

/// Place of the worst value of a criterion, or reason for a yes or no.
#[derive(Debug, Clone, PartialEq)]
pub enum Evidence {
    /// A gear.
    Gear(SchemeGear),
    /// A set, by its place from 0.
    Set(usize),
    /// A link.
    Link {
        /// The link, by its role.
        role: Role,
        /// The gear in which it is worst.
        gear: SchemeGear,
    },
    /// The planets of a set, by its place from 0.
    Planet {
        /// Index of the set.
        set: usize,
        /// The gear in which they are worst.
        gear: SchemeGear,
    },
    /// The direct-drive clutch between these links.
    DirectClutch([Role; 2]),
    /// No direct-drive clutch gives direct drive.
    NoDirectClutch,
    /// Every gear turns the output as direct drive does.
    AllForward,
    /// Gears that turn the output against direct drive.
    Backward(Vec<SchemeGear>),
    /// The scheme can be drawn, with a number of options for the direct-drive clutch.
    Drawable {
        /// Number of these options.
        direct_clutches: usize,
    },
    /// The scheme cannot be drawn.
    NotDrawable(NotDrawable),
}

/// A mechanism at given ring-to-sun ratios, measured and judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Ring-to-sun ratios `k₁`, `k₂`.
    pub k: Vec<f64>,
    /// The braked gears.
    pub gears: Vec<GearReport>,
    /// Every option for the direct-drive clutch, the least torque first.
    pub direct_clutches: Vec<DirectClutch>,
    /// Place in `direct_clutches` of the one chosen: the least torque among those that can be drawn and slip
    /// within limits; where none does, the least that can be drawn, or the least of all.
    pub direct_clutch: usize,
    /// Results of the criteria, each once.
    pub verdicts: Vec<Verdict>,
    /// Values of the objectives.
    pub objectives: Objectives,
}

impl Candidate {
    /// Whether every required criterion is met.
    #[must_use]
    pub fn is_accepted(&self) -> bool {
        self.verdicts.iter().all(|verdict| verdict.met || !verdict.required)
    }

    /// Objections: criteria that are not met, required or not.
    pub fn objections(&self) -> impl Iterator<Item = &Verdict> {
        self.verdicts.iter().filter(|verdict| !verdict.met)
    }

    /// Whether gears, direct drive among them, turn the output in both directions.
    #[must_use]
    pub fn mixes_directions(&self) -> bool {
        self.gears.iter().any(|gear| gear.ratio < 0.0)
    }

    /// Gears and what engages them, the slowest output first.
    #[must_use]
    pub fn engagement_table(&self) -> Vec<Engagement> {
        let line = |gear: SchemeGear, ratio: f64| Engagement {
            gear,
            engaged: gear.engaged(),
            ratio,
            reverses: ratio < 0.0,
        };
        let mut table: Vec<Engagement> = self.gears.iter().map(|one| line(one.gear, one.ratio)).collect();
        table.push(line(SchemeGear::Direct, 1.0));
        table.sort_by(|one, other| other.ratio.abs().total_cmp(&one.ratio.abs()));
        table
    }

    /// The candidate as a gearbox, with the direct-drive clutch chosen.
    ///
    /// # Errors
    /// None of a candidate of [`select`](super::select).
    pub fn gearbox(&self, requirements: &Requirements) -> Result<Gearbox, Error> {
        let pair =
            self.direct_clutches.get(self.direct_clutch).map_or([Role::D, Role::B], |clutch| clutch.pair);
        self.mechanism.gearbox(&self.k, requirements.eta0, pair)
    }

    /// Measures and judges a mechanism at ring-to-sun ratios above 1, one for each set, for the target ratios
    /// of its braked gears.
    ///
    /// # Errors
    /// [`Error::RingToSunCount`]; what the solver refuses of `k`.
    pub fn new(
        mechanism: Mechanism,
        k: Vec<f64>,
        wanted: &[f64],
        requirements: &Requirements,
        drawing: Option<&Drawing>,
    ) -> Result<Self, Error> {
        Self::with_planets(mechanism, k, &[], wanted, requirements, drawing)
    }

    /// Candidate of tooth numbers, one combination for each set. Its planets need not have the teeth of equal
    /// centre distances without profile shift.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_teeth(
        mechanism: Mechanism,
        teeth: &[ToothNumbers],
        wanted: &[f64],
        requirements: &Requirements,
        drawing: Option<&Drawing>,
    ) -> Result<Self, Error> {
        let k = teeth.iter().map(ToothNumbers::ring_to_sun_ratio).collect();
        Self::with_planets(mechanism, k, teeth, wanted, requirements, drawing)
    }

    /// Planets turn by `k` unless an offset of a ring says otherwise.
    fn with_planets(
        mechanism: Mechanism,
        k: Vec<f64>,
        teeth: &[ToothNumbers],
        wanted: &[f64],
        requirements: &Requirements,
        drawing: Option<&Drawing>,
    ) -> Result<Self, Error> {
        let mut gearbox = mechanism.gearbox(&k, requirements.eta0, [Role::D, Role::B])?;
        if teeth.iter().any(|teeth| teeth.ring_offset() != 0) {
            let mut teeth = teeth.iter();
            let with_teeth = |set: SetSpec| match teeth.next() {
                None => set,
                Some(of) => {
                    SetSpec { gearing: Gearing::Teeth(of.sun, of.ring), ..set }.planet_teeth(of.planet, None)
                }
            };
            gearbox = gearbox.to_builder().map_sets(with_teeth).build()?;
        }
        let gears = SchemeGear::BRAKED
            .into_iter()
            .zip(wanted)
            .map(|(gear, &wanted)| gear_report(&gearbox, gear, wanted))
            .collect::<Result<Vec<_>, _>>()?;
        let ratios: Vec<f64> = gears.iter().map(|gear| gear.ratio).collect();
        let direct_clutches = mechanism.direct_clutch_options(&ratios);
        let limits = &requirements.limits;
        let drawing = drawing.map(|drawing| drawing(mechanism));
        let drawn = |clutch: &DirectClutch| match &drawing {
            Some(Ok(pairs)) if limits.drawable => pairs.contains(&clutch.pair),
            _ => true,
        };
        let slips = |clutch: &DirectClutch| slip(clutch, gears.len()) > limits.clutch_slip * (1.0 + SLACK);
        let chosen = direct_clutches.iter().position(|clutch| drawn(clutch) && !slips(clutch));
        let direct_clutch = chosen.or_else(|| direct_clutches.iter().position(drawn)).unwrap_or(0);
        let worst = worst_speeds(&gears);
        let objectives = Objectives {
            efficiency: least_efficiency(&gears).0,
            speed: worst[0].0.max(worst[1].0),
            ring_to_sun: k
                .iter()
                .map(|k| ring_to_sun_distance(*k, *limits.preferred.start(), *limits.preferred.end()))
                .sum(),
            ratio_error: largest_error(&ratios, wanted),
            size: (0..k.len())
                .map(|set| {
                    let torque = largest_absolute(gears.iter().map(|gear| gear.sun_torques[set]));
                    relative_ring_diameter(k[set], torque, requirements.rating.planets, &requirements.rating)
                })
                .fold(0.0, f64::max),
            circulation: Some(greatest_circulation(&gears).0),
        };
        let mut candidate =
            Self { mechanism, k, gears, direct_clutches, direct_clutch, verdicts: vec![], objectives };
        candidate.verdicts = candidate.judge(requirements, worst, drawing);
        Ok(candidate)
    }

    fn judge(
        &self,
        requirements: &Requirements,
        [links, planets]: [(f64, Evidence); 2],
        drawing: Option<Result<Vec<[Role; 2]>, NotDrawable>>,
    ) -> Vec<Verdict> {
        let Limits { ring_to_sun, .. } = &requirements.limits;
        let limits = &requirements.limits;
        let within = |criterion, (value, evidence): (f64, Evidence), [least, greatest]: [f64; 2]| {
            // A value chosen to lie at a limit may miss it by rounding.
            let slack = SLACK * (1.0 + value.abs());
            let met = value >= least - slack && value <= greatest + slack;
            Verdict { criterion, value, limits: [least, greatest], met, required: true, evidence }
        };
        let preferred =
            f64::midpoint(libm::log(*limits.preferred.start()), libm::log(*limits.preferred.end()));
        let far = |k: f64| (libm::log(k) - preferred).abs();
        let odd = (0..self.k.len()).max_by(|a, b| far(self.k[*a]).total_cmp(&far(self.k[*b]))).unwrap_or(0);
        let error = |gear: &GearReport| (gear.ratio / gear.wanted - 1.0).abs();
        let off = self.gears.iter().max_by(|a, b| error(a).total_cmp(&error(b)));
        let off = Evidence::Gear(off.map_or(SchemeGear::First, |gear| gear.gear));
        let chosen = self.direct_clutches.get(self.direct_clutch);
        let (slipping, pair) = chosen.map_or((f64::INFINITY, Evidence::NoDirectClutch), |clutch| {
            (slip(clutch, self.gears.len()), Evidence::DirectClutch(clutch.pair))
        });
        let backward: Vec<SchemeGear> = self.gears.iter().filter(|g| g.ratio < 0.0).map(|g| g.gear).collect();
        let directions = if backward.is_empty() {
            (1.0, Evidence::AllForward)
        } else {
            (0.0, Evidence::Backward(backward))
        };
        let mut verdicts = vec![
            within(Criterion::Ratio, (self.objectives.ratio_error, off), [0.0, requirements.tolerance]),
            within(
                Criterion::RingToSun,
                (self.k[odd], Evidence::Set(odd)),
                [*ring_to_sun.start(), *ring_to_sun.end()],
            ),
            within(Criterion::Efficiency, least_efficiency(&self.gears), [limits.efficiency, 1.0]),
            within(Criterion::LinkSpeed, links, [0.0, limits.link_speed]),
            within(Criterion::PlanetSpeed, planets, [0.0, limits.planet_speed]),
            within(Criterion::ClutchSlip, (slipping, pair), [0.0, limits.clutch_slip]),
            Verdict {
                required: limits.circulation.is_finite(),
                ..within(
                    Criterion::Circulation,
                    greatest_circulation(&self.gears),
                    [
                        0.0,
                        if limits.circulation.is_finite() {
                            limits.circulation
                        } else {
                            OBJECTED_CIRCULATION
                        },
                    ],
                )
            },
            Verdict {
                required: limits.same_direction,
                ..within(Criterion::SameDirection, directions, [1.0, 1.0])
            },
        ];
        if let Some(drawing) = drawing {
            let found = drawing.map_or_else(
                |witness| (0.0, Evidence::NotDrawable(witness)),
                |pairs| (1.0, Evidence::Drawable { direct_clutches: pairs.len() }),
            );
            let verdict = within(Criterion::Drawable, found, [1.0, 1.0]);
            verdicts.push(Verdict { required: limits.drawable, ..verdict });
        }
        verdicts
    }
}

fn gear_report(gearbox: &Gearbox, gear: SchemeGear, wanted: f64) -> Result<GearReport, Error> {
    let found = gearbox.analyze(gear.name())?;
    let not_driven = || epicyclic_train::Error::NotDriven { state: found.state().to_string() };
    let ratio = found.ratio().ok_or_else(not_driven)?;
    let link = |role: Role| Some((role, found.speed(gearbox.link(role.symbol())?)?));
    let brake = if gear == SchemeGear::First { 0 } else { 1 };
    let loaded = found.driving();
    Ok(GearReport {
        gear,
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
        circulation: loaded.map(|case| found.circulating(case)),
    })
}

/// The largest slip of an open clutch over the braked gears.
pub(crate) fn slip(clutch: &DirectClutch, gears: usize) -> f64 {
    largest_absolute(&clutch.slip[..gears])
}

/// Least efficiency over the gears; 0 represents a self-locking gear, which has no efficiency.
fn least_efficiency(gears: &[GearReport]) -> (f64, Evidence) {
    let of = |gear: &GearReport| (gear.efficiency.unwrap_or(0.0), Evidence::Gear(gear.gear));
    gears
        .iter()
        .map(of)
        .min_by(|one, other| one.0.total_cmp(&other.0))
        .unwrap_or((1.0, Evidence::Gear(SchemeGear::First)))
}

/// The largest circulating power over what enters; a self-locking gear has none.
fn greatest_circulation(gears: &[GearReport]) -> (f64, Evidence) {
    gears.iter().fold((0.0, Evidence::Gear(SchemeGear::First)), |most, gear| {
        let of = gear.circulation.unwrap_or(0.0);
        if of > most.0 { (of, Evidence::Gear(gear.gear)) } else { most }
    })
}

/// The largest speeds of links and of planets relative to their carriers.
fn worst_speeds(gears: &[GearReport]) -> [(f64, Evidence); 2] {
    let gear = SchemeGear::First;
    let mut worst = [(0.0, Evidence::Link { role: Role::D, gear }), (0.0, Evidence::Planet { set: 0, gear })];
    for report in gears {
        let gear = report.gear;
        let links = report.links.iter().map(|&(role, speed)| (0, speed, Evidence::Link { role, gear }));
        let planets = report.planets.iter().enumerate();
        let planets = planets.map(|(set, planet)| (1, planet.relative, Evidence::Planet { set, gear }));
        for (kind, speed, evidence) in links.chain(planets) {
            if speed.abs() > worst[kind].0 {
                worst[kind] = (speed.abs(), evidence);
            }
        }
    }
    worst
}
