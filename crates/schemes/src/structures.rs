//! All two-row structures: every way to tie two simple rows by two permanent links, with D, B, T₁, T₂
//! one each on the four links that result.
//!
//! # What is counted
//! Two simple rows have six members. Two permanent links tie a member of one row to a member of the
//! other, so that four links result: two shared by the rows, one of row 1 alone, one of row 2 alone.
//! Nothing is grounded for ever. On the four links sit the driving shaft D, the driven shaft B and the
//! braked links T₁ (gear 1) and T₂ (gear 2), one each. Hence each row holds three of the four roles, and
//! the two rows lack different ones; a row is named by the roles of its sun, ring and carrier.
//!
//! # How many there are
//! Two shared links: 3·6 = 18 ways (a pair of members of row 1, an ordered pair of row 2). Roles: 4! = 24.
//! So 432 labelled structures. Two are equal where exchanging the rows (`σ`), the brakes (`τ`), or both
//! turns one into the other. By Burnside's lemma
//!
//! | exchange | left as they are | why |
//! |---|---|---|
//! | none | 432 | |
//! | `σ` | 0 | the links of one row alone change places, and bear different roles |
//! | `τ` | 0 | T₁ and T₂ are different links |
//! | `στ` | 12 | T₁, T₂ of one row alone; D and B tie *like* members: 3·2 ways, 2 labellings |
//!
//! classes: `(432 + 0 + 0 + 12)/4 = 111`. Which roles are shared makes four [families](Family) of 21, 18,
//! 36 and 36. Exchanging D and B (reversal: both ratios become their reciprocals) joins 102 of them in
//! pairs and maps 9 onto themselves; it is [reported](Structure::reversal), not merged.
//!
//! Which pair of links the locking clutch joins is a choice within a structure:
//! [`LOCKING_PAIRS`](crate::locking::LOCKING_PAIRS).
//!
//! # Two ratios settle both rows
//! The links have two degrees of freedom, and one of them is turning as a block. So up to a block
//! rotation all motions are multiples of one, `u`, and with the ratios `i₁`, `i₂` of gears 1 and 2
//!
//! ```text
//! u_D = i₁     u_B = 1     u_T1 = 0     u_T2 = (i₁ − i₂)/(1 − i₂)        k = −(u_a − u_H)/(u_b − u_H)
//! ```
//!
//! for each row by itself: `(i₁, 1, 0, t₂)`, `(i₂, 1, t₁, 0)` and `(1, 1, 1, 1)` lie in one plane, hence
//! `t₂`. So the link speeds of both gears follow from the two ratios *whatever the structure*, and a
//! pair of ratios has at most one pair of row parameters, never a family: the two equations, bilinear
//! in `k₁`, `k₂`, have one common root. (Only `i₁ = i₂ = 1`, the direct drive, is met by a family.)
//!
//! # Source
//! multispeed-gearboxes, section 2.4, whose eleven are among these.

pub use crate::catalogue::Role;

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::set::{MeshLoss, SetSpec};
use epicyclic_train::{Error, Gearbox};
use std::cmp::Ordering;
use std::fmt;

impl Role {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::D, Self::B, Self::T1, Self::T2];

    /// Its place in [`Self::ALL`].
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

/// Roles of sun, ring and carrier of a row.
pub type RowRoles = [Role; 3];

/// How a structure's rows share the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Rows of D B T₁ and of T₁ T₂ B: gear 1 is row 1 alone, in gear 2 row 2 ties T₁ to B.
    ClosedOnB,
    /// Rows of D B T₁ and of T₁ T₂ D: gear 1 is row 1 alone, in gear 2 row 2 ties T₁ to D.
    ClosedOnD,
    /// Rows of D B T₁ and of D B T₂: each gear is one row alone.
    Parallel,
    /// Rows of D T₁ T₂ and of B T₁ T₂: each gear is the two rows one after the other.
    Serial,
}

/// A two-row structure, in its canonical labelling.
///
/// ```
/// use crate::structures::{Family, Structure};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let structures = Structure::all();
/// assert_eq!(structures.len(), 111);
/// let ii_3 = structures.iter().find(|structure| structure.scheme() == Some("II-3")).unwrap();
/// assert_eq!(ii_3.to_string(), "T1.D.B+T1.B.T2");
/// assert_eq!(ii_3.family(), Family::ClosedOnB);
/// let [k1, k2] = ii_3.parameters([1.465, 2.56]).unwrap();
/// assert!((k1 - 2.1505).abs() < 1e-4 && (k2 - 2.3548).abs() < 1e-4);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Structure {
    rows: [RowRoles; 2],
}

/// The document's eleven, as its table has them.
const SCHEMES: [(&str, [RowRoles; 2]); 11] = {
    use Role::{B, D, T1, T2};
    [
        ("I-1", [[D, T1, B], [D, T2, T1]]),
        ("I-2", [[D, T1, B], [T2, D, T1]]),
        ("I-3", [[D, T1, B], [B, T1, T2]]),
        ("I-4", [[D, T1, B], [T1, B, T2]]),
        ("II-1", [[T1, D, B], [D, T2, T1]]),
        ("II-2", [[T1, D, B], [T2, D, T1]]),
        ("II-3", [[T1, D, B], [T1, B, T2]]),
        ("II-4", [[T1, D, B], [B, T1, T2]]),
        ("III-1", [[D, B, T1], [D, T1, T2]]),
        ("III-2", [[D, B, T1], [T1, B, T2]]),
        ("III-3", [[D, B, T1], [B, T1, T2]]),
    ]
};

impl Structure {
    /// The structure of two rows by the roles of their suns, rings and carriers, in its canonical
    /// labelling; `None` where they are no such rows.
    ///
    /// Where one row has D and B, it is row 1, and its brake is T₁: the document's labelling. Otherwise
    /// row 1 has D, and of the labellings that remain the least counts.
    #[must_use]
    pub fn new(rows: [RowRoles; 2]) -> Option<Self> {
        let lacks = |row: RowRoles| {
            let missing = Role::ALL.into_iter().find(|role| !row.contains(role))?;
            (row[0] != row[1] && row[0] != row[2] && row[1] != row[2]).then_some(missing)
        };
        let (first, second) = (lacks(rows[0])?, lacks(rows[1])?);
        if first == second {
            return None;
        }
        let [a, b] = rows;
        let [c, d] = rows.map(exchange_brakes);
        let canonical = [[a, b], [b, a], [c, d], [d, c]]
            .into_iter()
            .filter(|labelled| is_labelled_as_in_the_source(*labelled))
            .min()?;
        Some(Self { rows: canonical })
    }

    /// All 111, by family and then in the order of their roles.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let rows = row_roles();
        let pairs = rows.iter().flat_map(|&first| rows.iter().map(move |&second| [first, second]));
        let mut found: Vec<Self> = pairs.filter_map(Self::new).collect();
        found.sort_unstable_by_key(|structure| (structure.family(), *structure));
        found.dedup();
        found
    }

    /// The document's eleven, in its order.
    #[must_use]
    pub fn catalogue() -> Vec<Self> {
        SCHEMES.iter().filter_map(|(_, rows)| Self::new(*rows)).collect()
    }

    /// Roles of sun, ring and carrier of both rows.
    #[must_use]
    pub fn rows(self) -> [RowRoles; 2] {
        self.rows
    }

    /// The document's name, if it is one of its eleven.
    #[must_use]
    pub fn scheme(self) -> Option<&'static str> {
        SCHEMES.iter().find(|(_, rows)| *rows == self.rows).map(|(name, _)| *name)
    }

    /// How the rows share the work.
    #[must_use]
    pub fn family(self) -> Family {
        let has = |row: usize, role| self.rows[row].contains(&role);
        match (has(0, Role::B), has(1, Role::D), has(1, Role::B)) {
            (true, true, true) => Family::Parallel,
            (true, true, false) => Family::ClosedOnD,
            (true, false, _) => Family::ClosedOnB,
            (false, ..) => Family::Serial,
        }
    }

    /// Whether exchanging the brakes and the rows changes nothing: then both orders of two ratios are
    /// one design.
    #[must_use]
    pub fn is_symmetric(self) -> bool {
        let [first, second] = self.rows.map(exchange_brakes);
        [second, first] == self.rows
    }

    /// The structure with D and B exchanged: its ratios are the reciprocals of this one's, and what
    /// drives here is driven there.
    #[must_use]
    pub fn reversal(self) -> Self {
        let reversed = self.rows.map(|row| {
            row.map(|role| match role {
                Role::D => Role::B,
                Role::B => Role::D,
                brake => brake,
            })
        });
        Self::new(reversed).unwrap_or_else(|| unreachable!("renaming links keeps a structure one"))
    }

    /// Row parameters for the ratios of gears 1 and 2, the only ones there are; `None` where a row would
    /// need one that is not finite. They may be outside what a simple row can have: `k` above 1.
    #[must_use]
    pub fn parameters(self, ratios: [f64; 2]) -> Option<[f64; 2]> {
        let u = motion(ratios);
        let [k1, k2] = self.rows.map(|[a, b, h]| {
            let [a, b, h] = [a, b, h].map(|role| u[role.index()]);
            -(a - h) / (b - h)
        });
        (k1.is_finite() && k2.is_finite()).then_some([k1, k2])
    }

    /// The structure as a gearbox with gears `1`, `2` and `direct`, the locking clutch between these
    /// links.
    ///
    /// # Errors
    /// [`Error::RingToSunRatio`] for `k ≤ 1`, [`Error::ControlJoinsItself`] for a clutch between a link and
    /// itself.
    pub fn gearbox(self, k: [f64; 2], eta0: MeshEfficiency, lock: [Role; 2]) -> Result<Gearbox, Error> {
        let mut builder = Gearbox::builder(&self.to_string())
            .links(Role::ALL.map(Role::symbol))
            .brake("K1", "T1")
            .brake("K2", "T2")
            .clutch("L", lock[0].symbol(), lock[1].symbol())
            .input("D")
            .output("B");
        for (name, (members, k)) in ["1", "2"].iter().zip(self.rows.iter().zip(k)) {
            let row = SetSpec::simple(name, members.map(Role::symbol), k);
            builder = builder.set(row.with_loss(MeshLoss::Row(eta0)));
        }
        builder.gear("1", ["K1"]).gear("2", ["K2"]).gear("direct", ["L"]).build()
    }
}

impl fmt::Display for Structure {
    /// `a₁.b₁.H₁+a₂.b₂.H₂`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[a, b, h], [p, q, r]] = self.rows;
        f.pad(&format!("{a}.{b}.{h}+{p}.{q}.{r}"))
    }
}

/// The 24 rows.
pub(crate) fn row_roles() -> Vec<RowRoles> {
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

fn exchange_brakes(row: RowRoles) -> RowRoles {
    row.map(|role| match role {
        Role::T1 => Role::T2,
        Role::T2 => Role::T1,
        shaft => shaft,
    })
}

fn is_labelled_as_in_the_source([first, second]: [RowRoles; 2]) -> bool {
    let has = |row: RowRoles, role| row.contains(&role);
    if has(first, Role::B) && has(first, Role::D) {
        has(first, Role::T1)
    } else {
        // Neither row has both shafts, or row 2 has them and should be row 1.
        has(first, Role::D) && !(has(second, Role::B) && has(second, Role::D))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// A structure as the partition of its members into roles, with no thought of rows having roles:
    /// the role of a₁ b₁ H₁ a₂ b₂ H₂.
    type Labelled = [usize; 6];

    /// Every way to tie two members of row 1 to two of row 2 and to name the four links.
    fn labelled() -> BTreeSet<Labelled> {
        let mut found = BTreeSet::new();
        for code in 0..4_usize.pow(6) {
            let roles: Labelled = std::array::from_fn(|place| code / 4_usize.pow(place as u32) % 4);
            let distinct = |row: &[usize]| row.iter().collect::<BTreeSet<_>>().len() == 3;
            let used: BTreeSet<_> = roles.iter().collect();
            if distinct(&roles[..3]) && distinct(&roles[3..]) && used.len() == 4 {
                found.insert(roles);
            }
        }
        found
    }

    fn relabelled(roles: Labelled, rows: bool, brakes: bool, shafts: bool) -> Labelled {
        std::array::from_fn(|place| {
            let role = roles[if rows { (place + 3) % 6 } else { place }];
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
            for rows in [false, true] {
                for brakes in [false, true] {
                    all.extend(shafts.iter().map(|&shafts| relabelled(roles, rows, brakes, shafts)));
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
                let [first, second] = structure.rows();
                let roles: Vec<usize> = first.into_iter().chain(second).map(Role::index).collect();
                let roles: Labelled = roles.try_into().unwrap();
                let all = [(false, false), (false, true), (true, false), (true, true)];
                all.map(|(rows, brakes)| relabelled(roles, rows, brakes, false)).into_iter().min().unwrap()
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
        let families = [Family::ClosedOnB, Family::ClosedOnD, Family::Parallel, Family::Serial];
        assert_eq!(families.map(count), [36, 36, 21, 18]);
        assert_eq!(Structure::all().iter().filter(|s| s.is_symmetric()).count(), 6);
    }

    #[test]
    fn the_documents_eleven_keep_their_labels() {
        for (name, rows) in SCHEMES {
            assert_eq!(Structure::new(rows).unwrap().rows(), rows, "{name}");
            assert_eq!(Structure::new(rows).unwrap().scheme(), Some(name));
        }
        assert_eq!(Structure::catalogue().len(), 11);
    }

    #[test]
    fn what_is_no_structure_is_refused() {
        use Role::{B, D, T1, T2};
        for rows in [[[D, T1, B], [B, D, T1]], [[D, D, B], [T1, T2, B]], [[D, B, T2], [D, T1, T1]]] {
            assert_eq!(Structure::new(rows), None);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn two_ratios_give_the_parameters_back(a in 1.05..12.0, b in 1.05..12.0) {
            let eta0 = MeshEfficiency::IDEAL;
            for structure in Structure::all() {
                let gearbox = structure.gearbox([a, b], eta0, [Role::D, Role::B]).unwrap();
                let ratio = |gear| gearbox.analyze(gear).unwrap().ratio();
                let (Some(first), Some(second)) = (ratio("1"), ratio("2")) else { continue };
                // Where the gears are nearly direct, or nearly at rest, rounding decides.
                if [first, second].iter().any(|i| (i - 1.0).abs() < 1e-3 || i.abs() > 1e3 || i.abs() < 1e-3) {
                    continue;
                }
                let k = structure.parameters([first, second]).unwrap();
                prop_assert!((k[0] - a).abs() < 1e-6 * a && (k[1] - b).abs() < 1e-6 * b, "{structure}: {k:?}");
            }
        }
    }
}
