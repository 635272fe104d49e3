//! Sets as levers, and levers with two links in common as one.

use crate::gearbox::scheme::piece_of;
use crate::tolerance::PLACE;
use epicyclic_train::{Gearbox, LinkId};

/// A lever: links and their positions along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Lever {
    /// Indices of its sets in the gearbox; the lever has the units of the first.
    pub sets: Vec<usize>,
    /// Links and their positions; of permanently joined links the first.
    pub nodes: Vec<(LinkId, f64)>,
}

impl Lever {
    /// The lever of one set: carrier at 0, central gear 2 at −1, central gear 1 at `−i₀`.
    #[must_use]
    pub fn of_set(gearbox: &Gearbox, set: usize) -> Self {
        let drawn = &gearbox.drawn_sets()[set];
        let members = drawn.links.map(|link| piece_of(gearbox, link));
        let at = [-drawn.basic_ratio(gearbox), -1.0, 0.0];
        let mut nodes: Vec<(LinkId, f64)> = vec![];
        for node in members.into_iter().zip(at) {
            if nodes.iter().all(|(link, _)| *link != node.0) {
                nodes.push(node);
            }
        }
        Self { sets: vec![set], nodes }
    }

    /// Lower and upper end.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        let at = || self.nodes.iter().map(|node| node.1);
        (at().fold(f64::INFINITY, f64::min), at().fold(f64::NEG_INFINITY, f64::max))
    }

    fn place(&self, link: LinkId) -> Option<f64> {
        self.nodes.iter().find(|node| node.0 == link).map(|node| node.1)
    }

    /// The members of its sets at a node, `a` central gear 1, `b` central gear 2, `H` carrier, with the
    /// numbers of their sets.
    pub(super) fn members(&self, gearbox: &Gearbox, link: LinkId) -> String {
        let of_set = |&set: &usize| {
            let members = gearbox.drawn_sets()[set].links.map(|member| piece_of(gearbox, member));
            let here = members.into_iter().zip(["a", "b", "H"]).filter(move |(member, _)| *member == link);
            here.map(move |(_, letter)| format!("{letter}{}", set + 1))
        };
        self.sets.iter().flat_map(of_set).collect::<Vec<_>>().join(", ")
    }

    /// Lever of both, in the units of this one. `None` without two common links at different positions, or if
    /// a third one does not fit.
    ///
    /// Speeds are linear along each lever, so two common links fix the scale and the offset of the other
    /// lever.
    fn with(&self, other: &Self) -> Option<Self> {
        let common: Vec<(f64, f64)> =
            other.nodes.iter().filter_map(|&(link, theirs)| Some((self.place(link)?, theirs))).collect();
        let [(one, theirs), (next, their_next), ..] = common[..] else { return None };
        let scale = (next - one) / (their_next - theirs);
        let fits = |place: f64| one + scale * (place - theirs);
        let size = self.ends().1 - self.ends().0;
        if scale == 0.0
            || !scale.is_finite()
            || common.iter().any(|&(ours, theirs)| (fits(theirs) - ours).abs() > PLACE * size)
        {
            return None;
        }
        let mut nodes = self.nodes.clone();
        nodes.extend(
            other
                .nodes
                .iter()
                .filter(|node| self.place(node.0).is_none())
                .map(|&(link, place)| (link, fits(place))),
        );
        Some(Self { sets: [self.sets.clone(), other.sets.clone()].concat(), nodes })
    }
}

/// The levers of a gearbox: one a set, joined while two have two links in common.
///
/// ```
/// use epicyclic_pictures::gearbox::levers::levers;
/// use epicyclic_train::{Gearbox, set::SetSpec};
/// # fn main() -> Result<(), epicyclic_train::Error> {
/// // Simpson: common suns, the first carrier with the second ring.
/// let gearbox = Gearbox::builder("Simpson")
///     .links(["S", "R1", "out", "C2"])
///     .set(SetSpec::simple("1", ["S", "R1", "out"], 2.0))
///     .set(SetSpec::simple("2", ["S", "out", "C2"], 2.0))
///     .input("R1")
///     .output("out")
///     .build()?;
/// let [lever] = &levers(&gearbox)[..] else { panic!("one lever of four links") };
/// assert_eq!(lever.nodes.len(), 4);
/// // Set 2 is twice from sun to carrier what set 1 leaves between its sun and carrier, so 2/3 of it.
/// let carrier = lever.nodes[3].1;
/// assert!((carrier - 2.0 / 3.0).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn levers(gearbox: &Gearbox) -> Vec<Lever> {
    let mut levers: Vec<Lever> =
        (0..gearbox.drawn_sets().len()).map(|set| Lever::of_set(gearbox, set)).collect();
    let pair = |levers: &[Lever]| {
        (0..levers.len())
            .find_map(|a| (a + 1..levers.len()).find_map(|b| Some((a, b, levers[a].with(&levers[b])?))))
    };
    while let Some((a, b, joined)) = pair(&levers) {
        levers[a] = joined;
        levers.remove(b);
    }
    levers
}
