//! Two-set structures: every way to tie two simple sets by two permanent links, with D, B, T₁, T₂ one each on
//! the four links that result.
//!
//! # Definition
//! Two simple sets have six members. Two permanent links tie a member of one set to a member of the other, so
//! that four links result: two shared by the sets, one of set 1 alone, one of set 2 alone. No link is
//! grounded permanently. The four links carry the driving shaft D, the driven shaft B and the braked links T₁
//! (gear 1) and T₂ (gear 2), one each. Each set therefore holds three of the four roles, and the two sets
//! lack different ones. A set is named by the roles of its sun, ring and carrier.
//!
//! # How many there are
//! Two shared links: 3·6 = 18 ways (a pair of members of set 1, an ordered pair of set 2). Roles: 4! = 24.
//! So 432 labelled structures. Two are equal where exchanging the sets (`σ`), the brakes (`τ`), or both
//! turns one into the other. By Burnside's lemma
//!
//! | exchange | left as they are | why |
//! |---|---|---|
//! | none | 432 | |
//! | `σ` | 0 | the links of one set alone change places, and bear different roles |
//! | `τ` | 0 | T₁ and T₂ are different links |
//! | `στ` | 12 | T₁, T₂ of one set alone; D and B tie *like* members: 3·2 ways, 2 labellings |
//!
//! classes: `(432 + 0 + 0 + 12)/4 = 111`. Which roles are shared makes four [families](Family) of 21, 18,
//! 36 and 36. Exchanging D and B (reversal: both ratios become their reciprocals) joins 102 of them in
//! pairs and maps 9 onto themselves; it is [reported](Structure::reversal), not merged.
//!
//! Which pair of links the direct-drive clutch joins is a choice within a structure:
//! [`DIRECT_CLUTCH_PAIRS`](crate::direct_drive::DIRECT_CLUTCH_PAIRS).
//!
//! # Two ratios settle both sets
//! The links have two degrees of freedom, and one of them is the rotation as a block. Up to a block rotation
//! all motions are therefore multiples of one, `u`. With the ratios `i₁`, `i₂` of gears 1 and 2
//!
//! ```text
//! u_D = i₁     u_B = 1     u_T1 = 0     u_T2 = (i₁ − i₂)/(1 − i₂)        k = −(u_a − u_H)/(u_b − u_H)
//! ```
//!
//! for each set separately. `(i₁, 1, 0, t₂)`, `(i₂, 1, t₁, 0)` and `(1, 1, 1, 1)` lie in one plane, which
//! gives `t₂`. The link speeds of both gears therefore follow from the two ratios *whatever the structure*. A
//! pair of ratios has at most one pair of ring-to-sun ratios, never a family: the two equations, bilinear in
//! `k₁`, `k₂`, have one common root. (Only `i₁ = i₂ = 1`, the direct drive, is met by a family.)
//!
//! # Source
//! multispeed-gearboxes, section 2.4, whose eleven are among these.

pub use crate::catalogue::Role;

use crate::Error;
use crate::catalogue::{SchemeElement, SchemeGear, ThreeSpeed, TwoSpeed};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_train::Gearbox;
use epicyclic_train::names::nearest;
use epicyclic_train::set::{MeshLoss, SetSpec};
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

impl Role {
    /// Roles in the order D, B, T₁, T₂.
    pub const ALL: [Self; 4] = [Self::D, Self::B, Self::T1, Self::T2];

    /// Index in [`Self::ALL`].
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

impl PartialOrd for Role {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Role {
    /// D, B, T₁, T₂.
    fn cmp(&self, other: &Self) -> Ordering {
        self.index().cmp(&other.index())
    }
}

impl FromStr for Role {
    type Err = UnknownRole;

    /// Reads `D`, `B`, `T1`, `T2` in capital or small letters, also `T₁`, `T₂`.
    fn from_str(name: &str) -> Result<Self, UnknownRole> {
        let plain = name.replace('₁', "1").replace('₂', "2");
        Self::ALL.into_iter().find(|role| role.symbol().eq_ignore_ascii_case(&plain)).ok_or(UnknownRole)
    }
}

/// Error for a name other than `D`, `B`, `T1`, `T2`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("a link of a scheme is D, B, T1 or T2")]
pub struct UnknownRole;

/// Exchanges between a given labelling and the canonical one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Renaming {
    /// Whether sets 1 and 2 change places, and with them their ring-to-sun ratios.
    pub sets: bool,
    /// Whether T₁ and T₂ change places, and with them gears 1 and 2.
    pub brakes: bool,
}

/// Roles of sun, ring and carrier of a set.
pub type SetRoles = [Role; 3];

/// Division of the work between the sets of a structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Sets of D B T₁ and of T₁ T₂ B: gear 1 is set 1 alone, in gear 2 set 2 ties T₁ to B.
    ConnectedToB,
    /// Sets of D B T₁ and of T₁ T₂ D: gear 1 is set 1 alone, in gear 2 set 2 ties T₁ to D.
    ConnectedToD,
    /// Sets of D B T₁ and of D B T₂: each gear is one set alone.
    Parallel,
    /// Sets of D T₁ T₂ and of B T₁ T₂: each gear is the two sets one after the other.
    Serial,
}

/// A two-set structure, in its canonical labelling.
///
/// ```
/// use epicyclic_schemes::catalogue::ThreeSpeed;
/// use epicyclic_schemes::structures::{Family, Structure};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let structures = Structure::all();
/// assert_eq!(structures.len(), 111);
/// let ii_3 = structures.iter().find(|structure| structure.scheme() == Some(ThreeSpeed::II3)).unwrap();
/// assert_eq!(ii_3.to_string(), "T1.D.B+T1.B.T2");
/// assert_eq!(ii_3.family(), Family::ConnectedToB);
/// let [k1, k2] = ii_3.ring_to_sun_ratios([1.465, 2.56]).unwrap();
/// assert!((k1 - 2.1505).abs() < 1e-4 && (k2 - 2.3548).abs() < 1e-4);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Structure {
    sets: [SetRoles; 2],
}

impl Structure {
    /// The structure of two sets by the roles of their suns, rings and carriers, in its canonical
    /// labelling; `None` for sets that are not such.
    ///
    /// Where one set has D and B, it is set 1, and its brake is T₁: the document's labelling. Otherwise
    /// set 1 has D, and of the labellings that remain the least counts.
    #[must_use]
    pub fn new(sets: [SetRoles; 2]) -> Option<Self> {
        Self::canonical(sets).map(|(structure, _)| structure)
    }

    /// Structure of two sets, with the exchanges that make the labelling canonical.
    #[must_use]
    pub fn canonical(sets: [SetRoles; 2]) -> Option<(Self, Renaming)> {
        let lacks = |set: SetRoles| {
            let missing = Role::ALL.into_iter().find(|role| !set.contains(role))?;
            (set[0] != set[1] && set[0] != set[2] && set[1] != set[2]).then_some(missing)
        };
        let (first, second) = (lacks(sets[0])?, lacks(sets[1])?);
        if first == second {
            return None;
        }
        let [a, b] = sets;
        let [c, d] = sets.map(exchange_brakes);
        let labellings =
            [([a, b], false, false), ([b, a], true, false), ([c, d], false, true), ([d, c], true, true)];
        let (sets, of_sets, of_brakes) = labellings
            .into_iter()
            .filter(|(labelled, ..)| is_labelled_as_in_the_source(*labelled))
            .min_by_key(|(labelled, ..)| *labelled)?;
        Some((Self { sets }, Renaming { sets: of_sets, brakes: of_brakes }))
    }

    /// Reads a structure in any spelling: `a.b.H+a.b.H` with either set first and either brake as T₁, in
    /// capital or small letters. D and B are the input and the output, and sun and ring of a set differ in
    /// size: exchanging these makes another gearbox.
    ///
    /// ```
    /// use epicyclic_schemes::structures::Structure;
    /// # fn main() -> Result<(), epicyclic_schemes::Error> {
    /// let (structure, renaming) = Structure::read("D.T2.B+D.T1.B")?;
    /// assert_eq!(structure.to_string(), "D.T1.B+D.T2.B");
    /// assert!(renaming.sets && !renaming.brakes);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::UnknownStructure`] with the nearest canonical spelling, [`Error::NotAStructure`] where the
    /// six links are named and do not make one.
    pub fn read(name: &str) -> Result<(Self, Renaming), Error> {
        let unknown = || {
            let all: Vec<String> = Self::all().iter().map(Self::to_string).collect();
            let nearest = nearest(name, all.iter().map(String::as_str));
            Error::UnknownStructure { name: name.into(), nearest }
        };
        let set = |text: &str| -> Option<SetRoles> {
            let roles: Option<Vec<Role>> = text.split('.').map(|role| role.trim().parse().ok()).collect();
            roles?.try_into().ok()
        };
        let (first, second) = name.split_once('+').ok_or_else(unknown)?;
        let sets = set(first).zip(set(second)).ok_or_else(unknown)?;
        Self::canonical([sets.0, sets.1]).ok_or_else(|| Error::NotAStructure { name: name.into() })
    }

    /// Structures of two sets: 111, by family and then in the order of their roles.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let sets = set_roles();
        let pairs = sets.iter().flat_map(|&first| sets.iter().map(move |&second| [first, second]));
        let mut found: Vec<Self> = pairs.filter_map(Self::new).collect();
        found.sort_unstable_by_key(|structure| (structure.family(), *structure));
        found.dedup();
        found
    }

    /// The document's eleven, in its order.
    #[must_use]
    pub fn catalogue() -> Vec<Self> {
        ThreeSpeed::ALL.into_iter().map(ThreeSpeed::structure).collect()
    }

    /// Roles of sun, ring and carrier of both sets.
    #[must_use]
    pub fn sets(self) -> [SetRoles; 2] {
        self.sets
    }

    /// The document's scheme, if it is one of its eleven.
    #[must_use]
    pub fn scheme(self) -> Option<ThreeSpeed> {
        ThreeSpeed::ALL.into_iter().find(|scheme| scheme.sets() == self.sets)
    }

    /// Family: the division of the work between the sets.
    #[must_use]
    pub fn family(self) -> Family {
        let has = |set: usize, role| self.sets[set].contains(&role);
        match (has(0, Role::B), has(1, Role::D), has(1, Role::B)) {
            (true, true, true) => Family::Parallel,
            (true, true, false) => Family::ConnectedToD,
            (true, false, _) => Family::ConnectedToB,
            (false, ..) => Family::Serial,
        }
    }

    /// Whether exchanging the brakes and the sets changes nothing: then both orders of two ratios are
    /// one design.
    #[must_use]
    pub fn is_symmetric(self) -> bool {
        let [first, second] = self.sets.map(exchange_brakes);
        [second, first] == self.sets
    }

    /// The structure with D and B exchanged: its ratios are the reciprocals of this one's, and what
    /// drives here is driven there.
    #[must_use]
    pub fn reversal(self) -> Self {
        let reversed = self.sets.map(|set| set.map(Role::reversed));
        Self::new(reversed).unwrap_or_else(|| unreachable!("renaming links keeps a structure one"))
    }

    /// Ring-to-sun ratios for the ratios of gears 1 and 2, the only ones there are; `None` where a set would
    /// need one that is not finite. They may be outside what a simple set can have: `k` above 1.
    #[must_use]
    pub fn ring_to_sun_ratios(self, ratios: [f64; 2]) -> Option<[f64; 2]> {
        let u = motion(ratios);
        let [k1, k2] = self.sets.map(|[a, b, h]| {
            let [a, b, h] = [a, b, h].map(|role| u[role.index()]);
            -(a - h) / (b - h)
        });
        (k1.is_finite() && k2.is_finite()).then_some([k1, k2])
    }

    /// The structure as a gearbox with gears `1`, `2` and `direct`, the direct-drive clutch between these
    /// links.
    ///
    /// # Errors
    /// [`Error::Gearbox`] for `k ≤ 1`, and for a clutch between a link and itself.
    pub fn gearbox(
        self,
        k: [f64; 2],
        eta0: MeshEfficiency,
        direct_clutch: [Role; 2],
    ) -> Result<Gearbox, Error> {
        let [first, second] = self.sets;
        gearbox(&self.to_string(), &[(first, k[0]), (second, k[1])], eta0, Some(direct_clutch))
    }
}

/// The gearbox of one or two simple sets whose members `[a, b, H]` belong to these links, with their
/// ring-to-sun ratios: brakes `K1` and, of two sets, `K2` with gears `1` and `2`; with a direct-drive clutch,
/// `L`, also the gear `direct`.
///
/// # Errors
/// [`Error::Gearbox`] for `k ≤ 1`, and for a clutch between a link and itself.
pub fn gearbox(
    name: &str,
    sets: &[(SetRoles, f64)],
    eta0: MeshEfficiency,
    direct_clutch: Option<[Role; 2]>,
) -> Result<Gearbox, Error> {
    let [d, b, t1, t2] = Role::ALL.map(Role::symbol);
    let mut builder = Gearbox::builder(name).links([d, b, t1]).input(d).output(b);
    let mut gears = vec![SchemeGear::First];
    builder = builder.brake(SchemeElement::FirstBrake.name(), t1);
    if sets.len() > 1 {
        builder = builder.links([t2]).brake(SchemeElement::SecondBrake.name(), t2);
        gears.push(SchemeGear::Second);
    }
    if let Some([one, other]) = direct_clutch {
        builder = builder.clutch(SchemeElement::DirectClutch.name(), one.symbol(), other.symbol());
        gears.push(SchemeGear::Direct);
    }
    for gear in gears {
        builder = builder.gear(gear.name(), [gear.engaged().name()]);
    }
    for (name, (members, k)) in ["1", "2"].into_iter().zip(sets) {
        let set = SetSpec::simple(name, members.map(Role::symbol), *k);
        builder = builder.set(set.with_loss(MeshLoss::Set(eta0)));
    }
    Ok(builder.build()?)
}

impl FromStr for Structure {
    type Err = Error;

    /// Reads a structure as [`read`](Self::read) does.
    fn from_str(name: &str) -> Result<Self, Error> {
        Self::read(name).map(|(structure, _)| structure)
    }
}

impl fmt::Display for Structure {
    /// `a₁.b₁.H₁+a₂.b₂.H₂`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[a, b, h], [p, q, r]] = self.sets;
        f.pad(&format!("{a}.{b}.{h}+{p}.{q}.{r}"))
    }
}

/// The 24 sets.
pub(crate) fn set_roles() -> Vec<SetRoles> {
    let mut found = Vec::with_capacity(24);
    for a in Role::ALL {
        for b in Role::ALL {
            found.extend(Role::ALL.into_iter().map(|h| [a, b, h]).filter(|_| a != b));
        }
    }
    found.retain(|[a, b, h]| h != a && h != b);
    found
}

/// `u`: speeds of D, B, T₁, T₂ in gear 1 as multiples of the output's, from the ratios of both gears.
#[must_use]
pub fn motion([first, second]: [f64; 2]) -> [f64; 4] {
    [first, 1.0, 0.0, (first - second) / (1.0 - second)]
}

/// A set with T₁ and T₂ exchanged.
#[must_use]
pub fn exchange_brakes(set: SetRoles) -> SetRoles {
    set.map(|role| match role {
        Role::T1 => Role::T2,
        Role::T2 => Role::T1,
        shaft => shaft,
    })
}

fn is_labelled_as_in_the_source([first, second]: [SetRoles; 2]) -> bool {
    let has = |set: SetRoles, role| set.contains(&role);
    if has(first, Role::B) && has(first, Role::D) {
        has(first, Role::T1)
    } else {
        // Neither set has both shafts, or set 2 has them and should be set 1.
        has(first, Role::D) && !(has(second, Role::B) && has(second, Role::D))
    }
}

impl TwoSpeed {
    /// The scheme as a gearbox with gears `1` and `direct`.
    ///
    /// # Errors
    /// None of a ring-to-sun ratio: what the solver would refuse is refused before.
    pub fn gearbox(self, k: RingToSunRatio, eta0: MeshEfficiency) -> Result<Gearbox, Error> {
        gearbox(self.name(), &[(self.set(), k.get())], eta0, Some([Role::D, Role::B]))
    }
}

impl ThreeSpeed {
    /// The structure that it is.
    #[must_use]
    pub fn structure(self) -> Structure {
        Structure::new(self.sets()).unwrap_or_else(|| unreachable!("the eleven are structures, by test"))
    }

    /// The scheme as a gearbox with gears `1`, `2` and `direct`.
    ///
    /// # Errors
    /// None of ring-to-sun ratios: what the solver would refuse is refused before.
    pub fn gearbox(
        self,
        k1: RingToSunRatio,
        k2: RingToSunRatio,
        eta0: MeshEfficiency,
    ) -> Result<Gearbox, Error> {
        three_speed_gearbox(self.name(), self.sets(), [k1, k2], eta0)
    }
}

/// The gearbox of three speeds with these sets: gears `1`, `2` and `direct`, the direct-drive clutch between
/// the shafts.
pub(crate) fn three_speed_gearbox(
    name: &str,
    [first, second]: [SetRoles; 2],
    [k1, k2]: [RingToSunRatio; 2],
    eta0: MeshEfficiency,
) -> Result<Gearbox, Error> {
    gearbox(name, &[(first, k1.get()), (second, k2.get())], eta0, Some([Role::D, Role::B]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// A structure as the partition of its members into roles, with no thought of sets having roles:
    /// the role of a₁ b₁ H₁ a₂ b₂ H₂.
    type Labelled = [usize; 6];

    /// Every way to tie two members of set 1 to two of set 2 and to name the four links.
    fn labelled() -> BTreeSet<Labelled> {
        let mut found = BTreeSet::new();
        for code in 0..4_usize.pow(6) {
            let roles: Labelled = std::array::from_fn(|place| code / 4_usize.pow(place as u32) % 4);
            let distinct = |set: &[usize]| set.iter().collect::<BTreeSet<_>>().len() == 3;
            let used: BTreeSet<_> = roles.iter().collect();
            if distinct(&roles[..3]) && distinct(&roles[3..]) && used.len() == 4 {
                found.insert(roles);
            }
        }
        found
    }

    fn relabelled(roles: Labelled, sets: bool, brakes: bool, shafts: bool) -> Labelled {
        std::array::from_fn(|place| {
            let role = roles[if sets { (place + 3) % 6 } else { place }];
            match role {
                2 | 3 if brakes => 5 - role,
                0 | 1 if shafts => 1 - role,
                _ => role,
            }
        })
    }

    fn classes(shafts: &[bool]) -> BTreeMap<Labelled, usize> {
        let mut found = BTreeMap::new();
        for roles in labelled() {
            let mut all = vec![];
            for sets in [false, true] {
                for brakes in [false, true] {
                    all.extend(shafts.iter().map(|&shafts| relabelled(roles, sets, brakes, shafts)));
                }
            }
            *found.entry(all.into_iter().min().unwrap()).or_default() += 1;
        }
        found
    }

    #[test]
    fn brute_force_relabelling_finds_the_same_classes() {
        assert_eq!(labelled().len(), 432);
        let classes = classes(&[false]);
        assert_eq!(classes.len(), 111);
        let ours: BTreeSet<Labelled> = Structure::all()
            .into_iter()
            .map(|structure| {
                let [first, second] = structure.sets();
                let roles: Vec<usize> = first.into_iter().chain(second).map(Role::index).collect();
                let roles: Labelled = roles.try_into().unwrap();
                let all = [(false, false), (false, true), (true, false), (true, true)];
                all.map(|(sets, brakes)| relabelled(roles, sets, brakes, false)).into_iter().min().unwrap()
            })
            .collect();
        assert_eq!(ours, classes.into_keys().collect());
    }

    #[test]
    fn reversal_joins_all_but_nine_in_pairs() {
        assert_eq!(classes(&[false, true]).len(), 60);
        let all = Structure::all();
        assert_eq!(all.iter().filter(|structure| structure.reversal() == **structure).count(), 9);
        assert!(all.iter().all(|structure| structure.reversal().reversal() == *structure));
    }

    #[test]
    fn families_have_36_36_21_and_18_members() {
        let count = |family| Structure::all().iter().filter(|s| s.family() == family).count();
        let families = [Family::ConnectedToB, Family::ConnectedToD, Family::Parallel, Family::Serial];
        assert_eq!(families.map(count), [36, 36, 21, 18]);
        assert_eq!(Structure::all().iter().filter(|s| s.is_symmetric()).count(), 6);
    }

    #[test]
    fn the_documents_eleven_keep_their_labels() {
        for scheme in ThreeSpeed::ALL {
            assert_eq!(scheme.structure().sets(), scheme.sets(), "{scheme}");
            assert_eq!(scheme.structure().scheme(), Some(scheme));
        }
        assert_eq!(Structure::catalogue().len(), 11);
    }

    #[test]
    fn what_is_no_structure_is_refused() {
        use Role::{B, D, T1, T2};
        for sets in [[[D, T1, B], [B, D, T1]], [[D, D, B], [T1, T2, B]], [[D, B, T2], [D, T1, T1]]] {
            assert_eq!(Structure::new(sets), None);
        }
    }

    /// Every way to name the links of each structure is read as that structure, and says what it renames: the
    /// same gearbox, gear for gear.
    #[test]
    fn any_spelling_is_read() {
        let mut spellings = 0;
        for structure in Structure::all() {
            let [first, second] = structure.sets();
            let [a, b] = [first, second].map(exchange_brakes);
            for sets in [[first, second], [second, first], [a, b], [b, a]] {
                let name = sets.map(|set| set.map(Role::symbol).join(".")).join("+");
                let (read, renaming) = Structure::read(&name).unwrap();
                assert_eq!(read, structure, "{name}");
                assert_eq!(name.to_lowercase().parse(), Ok(structure));
                // Ratios as named and as canonical, by the sets' coefficients alone.
                let k = [2.3, 3.1];
                let ours = |sets: [SetRoles; 2], k: [f64; 2]| {
                    crate::pair::ratios(
                        &crate::pair::coefficients(sets[0], k[0]),
                        &crate::pair::coefficients(sets[1], k[1]),
                    )
                };
                let mut named = ours(sets, k);
                if renaming.brakes {
                    named.reverse();
                }
                let canonical = ours(structure.sets(), if renaming.sets { [k[1], k[0]] } else { k });
                for (named, canonical) in named.into_iter().zip(canonical) {
                    assert!((named / canonical - 1.0).abs() < 1e-12, "{name} {named} {canonical}");
                }
                spellings += 1;
            }
        }
        assert_eq!(spellings, 444);
    }

    #[test]
    fn what_is_misspelt_is_answered_with_the_nearest() {
        let nearest = |name: &str| match Structure::read(name) {
            Err(Error::UnknownStructure { nearest, .. }) => nearest,
            other => panic!("{other:?}"),
        };
        assert_eq!(nearest("D.T1.B+D.T1.T3"), Some("D.T1.B+D.T1.T2".to_owned()));
        assert_eq!(nearest("D.T1.B"), None);
        let same = Structure::read("D.T1.B+D.B.T1");
        assert_eq!(same, Err(Error::NotAStructure { name: "D.T1.B+D.B.T1".to_owned() }));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn two_ratios_give_the_ring_to_sun_ratios_back(a in 1.05..12.0, b in 1.05..12.0) {
            let eta0 = MeshEfficiency::IDEAL;
            for structure in Structure::all() {
                let gearbox = structure.gearbox([a, b], eta0, [Role::D, Role::B]).unwrap();
                let ratio = |gear| gearbox.analyze(gear).unwrap().ratio();
                let (Some(first), Some(second)) = (ratio("1"), ratio("2")) else { continue };
                // If the gears are nearly direct, or nearly at rest, rounding decides.
                if [first, second].iter().any(|i| (i - 1.0).abs() < 1e-3 || i.abs() > 1e3 || i.abs() < 1e-3) {
                    continue;
                }
                let k = structure.ring_to_sun_ratios([first, second]).unwrap();
                prop_assert!((k[0] - a).abs() < 1e-6 * a && (k[1] - b).abs() < 1e-6 * b, "{structure}: {k:?}");
            }
        }
    }
}
