//! Mechanisms among which selection chooses: one set for two speeds, or two sets for three.

use super::Error;
use super::tolerance::SLACK;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_numerics::extremes::golden;
use epicyclic_schemes::catalogue::{Scheme, TwoSpeed};
use epicyclic_schemes::direct_drive::{DirectClutch, direct_clutch_options, direct_clutch_options_of_set};
use epicyclic_schemes::pair::{coefficients, ratios};
use epicyclic_schemes::standing::reach;
use epicyclic_schemes::structures::{Role, SetRoles, Structure, gearbox};
use epicyclic_train::Gearbox;
use std::fmt;
use std::ops::RangeInclusive;

/// A mechanism whose ring-to-sun ratios are to be found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mechanism {
    /// One set of D, B and T₁: two speeds.
    OneSet(SetRoles),
    /// Two sets: three speeds.
    TwoSets(Structure),
}

/// Mechanisms from which to select.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Space {
    /// Schemes I, II, III for two speeds, I-1…III-3 for three.
    Catalogue,
    /// Six ways to use one set, and 111 two-set structures.
    All,
    /// Given mechanisms: those of one set for two speeds, those of two sets for three.
    Mechanisms(Vec<Mechanism>),
}

impl Space {
    /// Mechanisms with this number of braked gears.
    pub(crate) fn mechanisms(&self, gears: usize) -> Vec<Mechanism> {
        if gears == 1 {
            self.sets().into_iter().map(Mechanism::OneSet).collect()
        } else {
            self.structures().into_iter().map(Mechanism::TwoSets).collect()
        }
    }

    /// Ways to use one set, by the links of sun, ring and carrier.
    #[must_use]
    pub fn sets(&self) -> Vec<SetRoles> {
        let listed = TwoSpeed::ALL.map(TwoSpeed::set);
        // The other three speed up: D and B exchanged.
        let reversed = listed.map(|set| set.map(Role::reversed));
        match self {
            Self::Catalogue => listed.to_vec(),
            Self::All => [listed, reversed].concat(),
            Self::Mechanisms(chosen) => chosen
                .iter()
                .filter_map(|one| match one {
                    Mechanism::OneSet(set) => Some(*set),
                    Mechanism::TwoSets(_) => None,
                })
                .collect(),
        }
    }

    /// Structures of two sets.
    #[must_use]
    pub fn structures(&self) -> Vec<Structure> {
        match self {
            Self::Catalogue => Structure::catalogue(),
            Self::All => Structure::all(),
            Self::Mechanisms(chosen) => chosen
                .iter()
                .filter_map(|one| match one {
                    Mechanism::TwoSets(structure) => Some(*structure),
                    Mechanism::OneSet(_) => None,
                })
                .collect(),
        }
    }
}

impl Mechanism {
    /// The mechanism of a name: of a scheme (`II-3`), of a structure of two sets (`D.T1.B+T2.B.T1`), of one
    /// set (`D.T1.B`).
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name.parse::<Scheme>() {
            Ok(Scheme::Two(scheme)) => return Some(Self::OneSet(scheme.set())),
            Ok(scheme @ Scheme::Three(_)) => {
                let all = Structure::catalogue().into_iter().map(Self::TwoSets);
                return all.into_iter().find(|one| one.scheme() == Some(scheme));
            }
            Err(_) => {}
        }
        if let Ok(structure) = name.parse::<Structure>() {
            return Some(Self::TwoSets(structure));
        }
        let roles: Vec<Role> = name.split('.').map(str::parse).collect::<Result<_, _>>().ok()?;
        Space::All.sets().into_iter().find(|set| set[..] == roles[..]).map(Self::OneSet)
    }

    /// The document's scheme, if it is one.
    #[must_use]
    pub fn scheme(self) -> Option<Scheme> {
        match self {
            Self::OneSet(set) => TwoSpeed::of_set(set).map(Scheme::Two),
            Self::TwoSets(structure) => structure.scheme().map(Scheme::Three),
        }
    }

    /// Roles of sun, ring and carrier of each set.
    #[must_use]
    pub fn sets(self) -> Vec<SetRoles> {
        match self {
            Self::OneSet(set) => vec![set],
            Self::TwoSets(structure) => structure.sets().to_vec(),
        }
    }

    /// Whether both orders of the ratios are one design.
    pub(crate) fn is_symmetric(self) -> bool {
        matches!(self, Self::TwoSets(structure) if structure.is_symmetric())
    }

    /// Ring-to-sun ratios that give these ratios exactly; they may be below what a simple set can have, `k`
    /// above 1.
    #[must_use]
    pub fn ring_to_sun_ratios(self, wanted: &[f64]) -> Option<Vec<f64>> {
        match (self, wanted) {
            (Self::OneSet(set), &[i]) => {
                let u = |role: Role| match role {
                    Role::D => i,
                    Role::B => 1.0,
                    _ => 0.0,
                };
                let [a, b, h] = set.map(u);
                let k = -(a - h) / (b - h);
                k.is_finite().then(|| vec![k])
            }
            (Self::TwoSets(structure), &[first, second]) => {
                structure.ring_to_sun_ratios([first, second]).map(|k| k.to_vec())
            }
            _ => None,
        }
    }

    /// Ratios of the braked gears at these ring-to-sun ratios; none unless there is one a set.
    #[must_use]
    pub fn ratios(self, k: &[f64]) -> Vec<f64> {
        match (self, k) {
            (Self::OneSet(set), &[k]) => {
                let c = coefficients(set, k);
                vec![-c[Role::B.index()] / c[Role::D.index()]]
            }
            (Self::TwoSets(structure), &[first, second]) => {
                let [one, two] = structure.sets();
                ratios(&coefficients(one, first), &coefficients(two, second)).to_vec()
            }
            _ => vec![],
        }
    }

    /// Whether ring-to-sun ratios of a range can give ratios within tolerance of the targets, by the values
    /// that each gear takes between the corners. `true` may be wrong, `false` is not.
    pub(crate) fn reaches(self, wanted: &[f64], tolerance: f64, [low, high]: [f64; 2]) -> bool {
        let Self::TwoSets(structure) = self else { return true };
        reach(structure, &(low..=high)).into_iter().zip(wanted).all(|(reach, ratio)| {
            let ends = [1.0 - tolerance - SLACK, 1.0 + tolerance + SLACK].map(|part| part * ratio);
            let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            let hair = SLACK * to.abs().max(from.abs());
            reach.meets(from, to, hair)
        })
    }

    /// Ring-to-sun ratios within a range that come nearest to the ratios: the least largest relative error.
    ///
    /// The result is exact if the exact ring-to-sun ratios lie within the range.
    ///
    /// Otherwise they lie on the edge of the range: ratios and `k` correspond one to one, so from an inner
    /// point a step straight towards the target ratios lessens both errors. Along an edge each ratio is
    /// monotonous. The largest error therefore falls and then rises, and a section search finds its minimum.
    /// `None` where no point of the range gives ratios of the required signs.
    pub(crate) fn nearest(self, wanted: &[f64], range: &RangeInclusive<f64>) -> Option<Vec<f64>> {
        let exact = self.ring_to_sun_ratios(wanted);
        if let Some(exact) = exact.filter(|k| k.iter().all(|k| range.contains(k))) {
            return Some(exact);
        }
        let ends = [*range.start(), *range.end()];
        let mut found: Option<(f64, Vec<f64>)> = None;
        let mut consider = |error: f64, k: &[f64]| {
            if error < 1.0 && found.as_ref().is_none_or(|(least, _)| error < *least) {
                found = Some((error, k.to_vec()));
            }
        };
        match self {
            Self::OneSet(_) => {
                for end in ends {
                    consider(largest_error(&self.ratios(&[end]), wanted), &[end]);
                }
            }
            Self::TwoSets(structure) => {
                let [one, two] = structure.sets();
                let error = |[k1, k2]: [f64; 2]| {
                    largest_error(&ratios(&coefficients(one, k1), &coefficients(two, k2)), wanted)
                };
                for end in ends {
                    for edge in [|end, k| [end, k], |end, k| [k, end]] {
                        let k = section(ends, |k| error(edge(end, k))).map_or([end, end], |k| edge(end, k));
                        consider(error(k), &k);
                    }
                }
            }
        }
        found.map(|(_, k)| k)
    }

    /// Every option for the direct-drive clutch, the least torque first.
    pub(crate) fn direct_clutch_options(self, ratios: &[f64]) -> Vec<DirectClutch> {
        match (self, ratios) {
            (Self::OneSet(_), &[i]) => direct_clutch_options_of_set(i),
            (_, &[first, second]) => direct_clutch_options([first, second]),
            _ => vec![],
        }
    }

    /// The mechanism with its brakes and without a direct-drive clutch, sets without losses at this `k`.
    ///
    /// # Errors
    /// As [`gearbox`](Self::gearbox).
    pub fn without_direct_clutch(self, k: f64) -> Result<Gearbox, Error> {
        self.built(&vec![k; self.sets().len()], MeshEfficiency::IDEAL, None)
    }

    /// The mechanism as a gearbox with gears `1`, `2` (of two sets) and `direct`, the direct-drive clutch `L`
    /// between these links.
    ///
    /// # Errors
    /// [`Error::RingToSunCount`] unless there is one `k` a set; as
    /// [`structures::gearbox`](epicyclic_schemes::structures::gearbox).
    pub fn gearbox(
        self,
        k: &[f64],
        eta0: MeshEfficiency,
        direct_clutch: [Role; 2],
    ) -> Result<Gearbox, Error> {
        self.built(k, eta0, Some(direct_clutch))
    }

    fn built(
        self,
        k: &[f64],
        eta0: MeshEfficiency,
        direct_clutch: Option<[Role; 2]>,
    ) -> Result<Gearbox, Error> {
        let sets = self.sets();
        if k.len() != sets.len() {
            return Err(Error::RingToSunCount { given: k.len(), sets: sets.len() });
        }
        let sets: Vec<(SetRoles, f64)> = sets.into_iter().zip(k.iter().copied()).collect();
        Ok(gearbox(&self.to_string(), &sets, eta0, direct_clutch)?)
    }
}

impl fmt::Display for Mechanism {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OneSet([a, b, h]) => f.pad(&format!("{a}.{b}.{h}")),
            Self::TwoSets(structure) => structure.fmt(f),
        }
    }
}

/// The largest relative error; infinite where one is not a number.
pub(crate) fn largest_error(ratios: &[f64], wanted: &[f64]) -> f64 {
    let error = |(i, w): (&f64, &f64)| (i / w - 1.0).abs();
    ratios.iter().zip(wanted).map(error).fold(0.0, |m, e| if e.is_nan() { f64::INFINITY } else { m.max(e) })
}

/// Minimum of a function that falls and then rises, by golden sections. Its part at or above 1 may be flat or
/// broken (a ratio passes a pole there) and is left by halving towards the part below.
fn section(ends: [f64; 2], of: impl Fn(f64) -> f64) -> Option<f64> {
    const STEPS: usize = 64;
    // The part below 1 may be narrow: first a ladder, then sections around its best rung.
    let rung = |step: usize| ends[0] + (ends[1] - ends[0]) * step as f64 / STEPS as f64;
    let best = (0..=STEPS).min_by(|one, other| of(rung(*one)).total_cmp(&of(rung(*other))))?;
    let (low, high) = (rung(best.saturating_sub(1)), rung((best + 1).min(STEPS)));
    let (least, _) = golden(low, high, 80, &of);
    [rung(best), least].into_iter().min_by(|a, b| of(*a).total_cmp(&of(*b)))
}
