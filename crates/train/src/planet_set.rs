//! A planet set: a carrier, its planets, its central gears, and the tree of their meshes.
//!
//! # One type for all
//! Every set of a gearbox is one of these, whether described in short ([`SetSpec`]) or whole
//! ([`CompoundSpec`]). Relative to the carrier it has one freedom. With `ν = ω − ω_H` of any gear and `g` its
//! factor,
//!
//! ```text
//! speeds     ν_c/g_c = ν_r/g_r                             m − 1 equations for m central gears
//! torques    Σ T + T_H = 0    Σ g_c·T_c·Π η_j^w_j = 0      the product over the meshes between c and r
//! ```
//!
//! `r` is a central gear of reference, the *root*; `w_j` is +1 where power flows towards it through mesh `j`,
//! −1 where it flows away, 0 where none passes. The answer does not depend on which gear is the root.
//!
//! # Equations
//! The solver takes a set as `m − 1` equations of three links each, from the root to another central gear:
//!
//! ```text
//! ω_r − i_c·ω_c − (1 − i_c)·ω_H = 0        i_c = g_r/g_c
//! T_r = Σ t_c    T_c = −î_c·t_c    T_H = Σ (î_c − 1)·t_c        î_c = i_c·Π η_j^±1
//! ```
//!
//! Central gears are taken in the order in which a walk through the tree meets them, so that those behind any
//! mesh are neighbours. Meshes with the same gears behind them always carry power in the same direction; they
//! are one *segment*. A set with two central gears has one equation and one segment.

use crate::compound::{CentralKind, CompoundSpec, SetMember};
use crate::elimination::decimal;
use crate::set::{Gearing, MeshLoss, SetKind, SetSpec};
use crate::site::SetPart;
use crate::spacing::Spacing;
use crate::tolerance::BASIC_RATIO;
use crate::{Error, LinkId};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::{BasicRatio, Fraction};
use epicyclic_gears::teeth::ToothCount;
use std::ops::Range;

mod tree;
pub(crate) use tree::Tree;

/// Form in which a set was described.
#[derive(Debug, Clone, PartialEq)]
pub enum Description {
    /// Short form: kind and three members.
    Short(SetSpec),
    /// Whole, gear by gear.
    Compound(CompoundSpec),
}

impl Description {
    /// Name of the set.
    #[must_use]
    pub fn id(&self) -> &str {
        match self {
            Self::Short(spec) => &spec.id,
            Self::Compound(spec) => &spec.id,
        }
    }

    /// Number of planets of each kind around the axis, if known.
    #[must_use]
    pub fn planet_count(&self) -> Option<u32> {
        match self {
            Self::Short(spec) => spec.planet_count,
            Self::Compound(spec) => spec.planet_count,
        }
    }

    /// Spacing of the planets on the carrier.
    #[must_use]
    pub fn spacing(&self) -> &Spacing {
        match self {
            Self::Short(spec) => &spec.spacing,
            Self::Compound(spec) => &spec.spacing,
        }
    }
}

impl From<SetSpec> for Description {
    fn from(spec: SetSpec) -> Self {
        Self::Short(spec)
    }
}

impl From<CompoundSpec> for Description {
    fn from(spec: CompoundSpec) -> Self {
        Self::Compound(spec)
    }
}

/// A central gear or planet shaft of a set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Central {
    /// The link it belongs to.
    pub link: LinkId,
    /// Kind of the central gear.
    pub kind: CentralKind,
    /// Number of teeth, if known; `None` for a planet shaft.
    pub teeth: Option<ToothCount>,
    /// A number proportional to its teeth, in a set whose teeth are not known.
    pub proportion: Option<f64>,
    /// Body of the central gear: its own, or that of the planet it turns with.
    pub(crate) body: usize,
}

/// A planet: one rigid body with one gear or several.
#[derive(Debug, Clone, PartialEq)]
pub struct Planet {
    /// Name of the planet; empty if the set has only one.
    pub name: String,
    /// Teeth of its gears, where known.
    pub gears: Vec<Option<ToothCount>>,
}

/// A gear of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GearOf {
    /// A central gear, by its place in [`PlanetSet::centrals`].
    Central(usize),
    /// A gear of a planet: places in [`PlanetSet::planets`] and [`Planet::gears`].
    Planet(usize, usize),
}

/// Kind of mesh of two gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeshKind {
    /// External teeth with external teeth: the gears turn in opposite directions.
    External,
    /// External teeth with internal teeth: they turn in the same direction.
    Internal,
    /// A bevel gear on the left of a planet.
    BevelLeft,
    /// A bevel gear on the right of it.
    BevelRight,
}

impl MeshKind {
    /// Sign of the ratio of the two speeds relative to the carrier.
    pub(crate) fn sign(self) -> i128 {
        match self {
            Self::External | Self::BevelLeft => -1,
            Self::Internal | Self::BevelRight => 1,
        }
    }
}

/// A mesh of a set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mesh {
    /// The gears, the one nearer to the root first.
    pub gears: [GearOf; 2],
    /// Kind of the mesh.
    pub kind: MeshKind,
    /// Efficiency of the mesh. If only that of the whole set is known, its meshes have equal losses.
    pub efficiency: MeshEfficiency,
}

/// A planet set, or a pair of gears on fixed axes, of a built gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanetSet {
    description: Description,
    members: Vec<LinkId>,
    centrals: Vec<Central>,
    planets: Vec<Planet>,
    meshes: Vec<Mesh>,
    /// `g` of each body, central gears first, then planets; over that of the first central gear.
    factors: Vec<Option<f64>>,
    exact: Vec<Option<Fraction>>,
    pub(crate) tree: Tree,
}

impl PlanetSet {
    /// Name of the set.
    #[must_use]
    pub fn id(&self) -> &str {
        self.description.id()
    }

    /// Form in which the set was described.
    #[must_use]
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// Copy of the set with a description that changes neither its members nor its teeth.
    pub(crate) fn described(&self, description: Description) -> Self {
        Self { description, ..self.clone() }
    }

    /// Short description of the set, if it has one.
    #[must_use]
    pub fn short(&self) -> Option<&SetSpec> {
        match &self.description {
            Description::Short(spec) => Some(spec),
            Description::Compound(_) => None,
        }
    }

    /// Kind of the set, if it is one of the usual; `None` for a compound set.
    #[must_use]
    pub fn kind(&self) -> Option<SetKind> {
        self.short().map(|spec| spec.kind)
    }

    /// Whether it is a pair of gears on fixed axes.
    #[must_use]
    pub fn is_pair(&self) -> bool {
        self.kind().is_some_and(SetKind::is_pair)
    }

    /// Links of all members: the central gears in the order in which they were described, the carrier last.
    #[must_use]
    pub fn members(&self) -> &[LinkId] {
        &self.members
    }

    /// Link of the carrier.
    #[must_use]
    pub fn carrier(&self) -> LinkId {
        self.members[self.centrals.len()]
    }

    /// Kind of a member: a central gear, or the carrier, which is last.
    #[must_use]
    pub fn member(&self, member: usize) -> SetMember {
        self.centrals.get(member).map_or(SetMember::Carrier, |central| SetMember::Central(central.kind))
    }

    /// The central gears and planet shafts.
    #[must_use]
    pub fn centrals(&self) -> &[Central] {
        &self.centrals
    }

    /// Planets of different kinds; empty for a pair.
    #[must_use]
    pub fn planets(&self) -> &[Planet] {
        &self.planets
    }

    /// Number of planets of each kind around the axis, if known.
    #[must_use]
    pub fn planet_count(&self) -> Option<u32> {
        self.description.planet_count()
    }

    /// The meshes.
    #[must_use]
    pub fn meshes(&self) -> &[Mesh] {
        &self.meshes
    }

    /// A gear in words: `sun`, `ring drum`, `planet`, `long.2`.
    #[must_use]
    pub fn gear_name(&self, gear: GearOf) -> String {
        match gear {
            GearOf::Central(central) if self.is_pair() => format!("gear {}", central + 1),
            GearOf::Central(central) => {
                let alike =
                    self.centrals.iter().filter(|one| one.kind == self.centrals[central].kind).count();
                let kind = self.centrals[central].kind;
                match &self.description {
                    Description::Compound(spec) if alike > 1 => {
                        format!("{kind} {}", spec.centrals[central].name)
                    }
                    _ if alike > 1 => format!("{kind} {}", central + 1),
                    _ => kind.to_string(),
                }
            }
            GearOf::Planet(planet, step) => {
                let one = &self.planets[planet];
                let step = if one.gears.len() > 1 { format!(".{}", step + 1) } else { String::new() };
                match (one.name.as_str(), self.planets.len()) {
                    ("", 1) => {
                        format!("planet{}", if step.is_empty() { step } else { format!(" {}", &step[1..]) })
                    }
                    ("", _) => format!("planet {}{step}", planet + 1),
                    (name, _) => format!("{name}{step}"),
                }
            }
        }
    }

    /// Teeth of a gear, where known.
    #[must_use]
    pub fn teeth(&self, gear: GearOf) -> Option<ToothCount> {
        match gear {
            GearOf::Central(central) => self.centrals[central].teeth,
            GearOf::Planet(planet, step) => self.planets[planet].gears[step],
        }
    }

    /// Basic ratio `i₀ = (ω_1 − ω_H)/(ω_2 − ω_H)` of the first two central gears.
    #[must_use]
    pub fn basic_ratio(&self) -> BasicRatio {
        match self.short().map(SetSpec::ratio) {
            Some(Ok((ratio, _))) => ratio,
            // Within the limits that the tree was built under.
            _ => BasicRatio::new(self.ratio_between(0, 1))
                .unwrap_or_else(|_| unreachable!("a built set has a ratio")),
        }
    }

    /// The basic ratio as a fraction of tooth counts, where they are known.
    #[must_use]
    pub fn exact_ratio(&self) -> Option<Fraction> {
        self.exact[self.centrals[1].body].map(|second| second.recip())
    }

    /// `(ω_c − ω_H)/(ω_d − ω_H)` of two members that are not the carrier.
    #[must_use]
    pub fn ratio_between(&self, first: usize, second: usize) -> f64 {
        // As it was given: its inverse is rounded, and 1/(1/i₀) need not be i₀.
        if let (Some(Ok((ratio, _))), 0, 1) = (self.short().map(SetSpec::ratio), first, second) {
            return ratio.get();
        }
        let factor = |central: usize| self.factors[self.centrals[central].body].unwrap_or(f64::NAN);
        factor(first) / factor(second)
    }

    /// Whether two members turn alike whatever the set does: central gears with a basic ratio of exactly 1
    /// between them.
    pub(crate) fn turn_alike(&self, first: usize, second: usize) -> bool {
        let is_central = first.max(second) < self.centrals.len();
        is_central && {
            let exact = |central: usize| self.exact[self.centrals[central].body];
            match (exact(first), exact(second)) {
                (Some(one), Some(other)) => one == other,
                _ => self.ratio_between(first, second) == 1.0,
            }
        }
    }

    /// `(ω_p − ω_H)/(ω_1 − ω_H)` of a planet over the first central gear, if it follows from the teeth.
    #[must_use]
    pub fn planet_factor(&self, planet: usize) -> Option<f64> {
        self.factors[self.centrals.len() + planet]
    }

    /// `η₀` from the first central gear to the second under a carrier at rest: the product over the meshes
    /// between them.
    #[must_use]
    pub fn efficiency(&self) -> f64 {
        if let Some(spec) = self.short() {
            return spec.loss.set_efficiency().get();
        }
        self.path(0, 1).iter().map(|&mesh| self.meshes[mesh].efficiency.get()).product()
    }

    /// Whether any mesh loses power.
    #[must_use]
    pub fn has_losses(&self) -> bool {
        self.meshes.iter().any(|mesh| mesh.efficiency.get() < 1.0)
    }

    /// The meshes between two central gears.
    #[must_use]
    pub fn path(&self, first: usize, second: usize) -> Vec<usize> {
        let behind = |central: usize, mesh: usize| {
            self.tree.place(central).is_some_and(|place| self.tree.behind[mesh].contains(&place))
        };
        (0..self.meshes.len()).filter(|&mesh| behind(first, mesh) != behind(second, mesh)).collect()
    }

    /// Body of a gear: central gears first in their order, then planets. A planet shaft is of the body of its
    /// planet.
    #[must_use]
    pub fn body(&self, gear: GearOf) -> usize {
        match gear {
            GearOf::Central(central) => self.centrals[central].body,
            GearOf::Planet(planet, _) => self.centrals.len() + planet,
        }
    }
}

/// Parts of a described set before the tree of its meshes is walked.
pub(crate) struct Parts {
    pub(crate) centrals: Vec<Central>,
    pub(crate) planets: Vec<Planet>,
    pub(crate) meshes: Vec<Mesh>,
    /// `g` of each body, where teeth do not give it.
    pub(crate) factors: Vec<Option<f64>>,
    pub(crate) exact: Vec<Option<Fraction>>,
    pub(crate) rational: Option<Fraction>,
    pub(crate) loss: Option<MeshEfficiency>,
}

impl PlanetSet {
    /// A set of these parts.
    pub(crate) fn new(
        description: Description,
        carrier: LinkId,
        parts: Parts,
    ) -> Result<Self, (SetPart, Error)> {
        let Parts { centrals, planets, mut meshes, factors, exact, rational, loss } = parts;
        let root = match &description {
            Description::Short(_) => 0,
            // A single sun is the common gear of several rings; otherwise the first ring is the root.
            Description::Compound(_) => {
                let of = |kind| centrals.iter().filter(move |central| central.kind == kind).count();
                let is_single_sun = of(CentralKind::Sun) == 1 && of(CentralKind::Ring) > 1;
                let kind = if is_single_sun { CentralKind::Sun } else { CentralKind::Ring };
                centrals.iter().position(|central| central.kind == kind).unwrap_or(0)
            }
        };
        let tree = Tree::new(&description, root, &centrals, planets.len(), &mut meshes, loss)?;
        let members = centrals.iter().map(|central| central.link).chain([carrier]).collect();
        let mut set = Self { description, members, centrals, planets, meshes, factors, exact, tree };
        set.find_factors();
        set.tree.ratios = set.tree.order.iter().map(|&central| set.ratio_between(root, central)).collect();
        let fraction = |central: usize| set.exact[set.centrals[central].body];
        let exact: Vec<Option<Fraction>> = set
            .tree
            .order
            .iter()
            .map(|&central| fraction(root)?.checked_div_by(fraction(central)?))
            .collect();
        set.tree.rationals = exact.iter().map(|exact| exact.or(rational)).collect();
        set.tree.exact = exact;
        if set.centrals.iter().any(|central| central.proportion.is_some()) {
            // Fractions of decimals decide states, but are not tooth counts.
            set.tree.exact.fill(None);
            set.exact.fill(None);
        }
        for (&ratio, &central) in set.tree.ratios.iter().zip(&set.tree.order) {
            if !(1.0 / BASIC_RATIO..=BASIC_RATIO).contains(&ratio.abs()) {
                let [first, second] = [root, central].map(|one| set.gear_name(GearOf::Central(one)));
                let set = set.id().to_owned();
                return Err((SetPart::Whole, Error::BasicRatio { set, first, second, ratio }));
            }
        }
        Ok(set)
    }

    /// Walks from the first central gear along the meshes and finds the factor of every body whose teeth are
    /// known.
    fn find_factors(&mut self) {
        // The teeth of a planet with one gear cancel between its meshes; it is taken by its pitch line.
        let is_compound = self.short().is_none();
        let count = |gear: GearOf| match (self.teeth(gear), gear) {
            (None, GearOf::Planet(..)) if is_compound => Some(1.0),
            (None, GearOf::Central(central)) => self.centrals[central].proportion,
            (teeth, _) => teeth.map(ToothCount::as_f64),
        };
        let counts: Vec<[Option<f64>; 2]> = self.meshes.iter().map(|mesh| mesh.gears.map(count)).collect();
        let start = self.centrals[0].body;
        self.factors[start] = Some(1.0);
        self.exact[start] = Some(Fraction::from_integer(1));
        for _ in 0..self.meshes.len() {
            for (mesh, counts) in self.meshes.clone().into_iter().zip(&counts) {
                let [one, other] = [0, 1].map(|end| (mesh.gears[end], counts[end]));
                for [(from, z_from), (to, z_to)] in [[one, other], [other, one]] {
                    let (body, next) = (self.body(from), self.body(to));
                    let (Some(z_from), Some(z_to)) = (z_from, z_to) else { continue };
                    if self.exact[next].is_none()
                        && let Some(known) = self.exact[body]
                        && let (Some(from), Some(to)) = (decimal(z_from), decimal(z_to))
                    {
                        let step = from.checked_div_by(to).map(|step| step * mesh.kind.sign());
                        self.exact[next] = step.and_then(|step| known.checked_times(step));
                    }
                    if self.factors[next].is_none()
                        && let Some(known) = self.factors[body]
                    {
                        let step = z_from / z_to;
                        self.factors[next] = Some(known * mesh.kind.sign() as f64 * step);
                    }
                }
            }
        }
        for planet in 0..self.planets.len() {
            if is_compound && self.planets[planet].gears.contains(&None) {
                self.factors[self.centrals.len() + planet] = None;
            }
        }
    }
}

/// Fractions that report an overflow of their integers.
trait Checked: Sized {
    fn checked_times(self, other: Self) -> Option<Self>;
    fn checked_div_by(self, other: Self) -> Option<Self>;
}

impl Checked for Fraction {
    fn checked_times(self, other: Self) -> Option<Self> {
        crate::elimination::Scalar::times(&self, &other)
    }

    fn checked_div_by(self, other: Self) -> Option<Self> {
        crate::elimination::Scalar::over(&self, &other)
    }
}

/// Returns the parts that a short description represents.
pub(crate) fn parts_of_short(spec: &SetSpec, links: [LinkId; 2]) -> Result<Parts, Error> {
    use CentralKind::{BevelLeft, BevelRight, Ring, Sun};
    use MeshKind::{External, Internal};
    let (ratio, exact) = spec.ratio()?;
    let kinds = match spec.kind {
        SetKind::SteppedSuns | SetKind::MeshingSuns | SetKind::ExternalPair => [Sun, Sun],
        SetKind::SteppedRings => [Ring, Ring],
        SetKind::Bevel => [BevelLeft, BevelRight],
        _ => [Sun, Ring],
    };
    let teeth = match spec.gearing {
        Gearing::Teeth(first, second) => [Some(first), Some(second)],
        Gearing::BasicRatio(_) => [None; 2],
    };
    let central = |place: usize| Central {
        link: links[place],
        kind: kinds[place],
        teeth: teeth[place],
        proportion: None,
        body: place,
    };
    let centrals = vec![central(0), central(1)];
    let planet = |gears: &[Option<ToothCount>]| Planet { name: String::new(), gears: gears.to_vec() };
    let (g, f) = (spec.planet, spec.second_planet);
    let planets = match spec.kind {
        kind if kind.is_pair() => vec![],
        kind if kind.is_stepped() => vec![planet(&[g, f])],
        SetKind::DoublePlanet | SetKind::MeshingSuns => vec![planet(&[g]), planet(&[f])],
        _ => vec![planet(&[g])],
    };
    let with_central = |place: usize| match kinds[place] {
        Ring => Internal,
        BevelLeft => MeshKind::BevelLeft,
        BevelRight => MeshKind::BevelRight,
        _ => External,
    };
    let [first, between, second] = match (spec.loss, planets.len()) {
        (MeshLoss::Meshes { first, between, second }, _) => [first, between, second],
        (MeshLoss::Set(eta), 0) => [eta; 3],
        (MeshLoss::Set(eta), planets) => {
            let each = libm::pow(eta.get(), 1.0 / (planets + 1) as f64);
            [MeshEfficiency::new(each).unwrap_or(eta); 3]
        }
    };
    let mesh = |gears, kind, efficiency| Mesh { gears, kind, efficiency };
    let (one, two) = (GearOf::Central(0), GearOf::Central(1));
    let meshes = match spec.kind {
        SetKind::ExternalPair => vec![mesh([one, two], External, first)],
        SetKind::InternalPair => vec![mesh([one, two], Internal, first)],
        SetKind::DoublePlanet | SetKind::MeshingSuns => vec![
            mesh([one, GearOf::Planet(0, 0)], with_central(0), first),
            mesh([GearOf::Planet(0, 0), GearOf::Planet(1, 0)], External, between),
            mesh([GearOf::Planet(1, 0), two], with_central(1), second),
        ],
        kind => {
            let step = usize::from(kind.is_stepped());
            vec![
                mesh([one, GearOf::Planet(0, 0)], with_central(0), first),
                mesh([GearOf::Planet(0, step), two], with_central(1), second),
            ]
        }
    };
    // Factors that teeth do not give: the second central gear from k, and the planet of a simple set by equal
    // centre distances.
    let mut factors = vec![None; 2 + planets.len()];
    let mut known = vec![None; 2 + planets.len()];
    factors[1] = Some(1.0 / ratio.get());
    known[1] = exact.map(|exact| exact.recip());
    let k = -ratio.get();
    if spec.kind == SetKind::Simple && (g.is_none() || teeth[0].is_none()) {
        factors[2] = Some(-2.0 / (k - 1.0));
    }
    Ok(Parts {
        centrals,
        planets,
        meshes,
        factors,
        exact: known,
        rational: decimal(ratio.get()),
        loss: Some(spec.loss.set_efficiency()),
    })
}

/// Places in a tree's order.
pub(crate) type Behind = Range<usize>;
