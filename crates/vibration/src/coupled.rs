//! Sets on common links: the planar model of a whole gearbox.
//!
//! A link is the parts that turn as one piece, a centre the parts that move in the plane as one piece. They
//! are bodies of their own, since members that a clutch lets turn together need not move together. In the
//! springs of the [planar model of one set](crate::gear_set) a member has the rotation of its link and the
//! displacement of its centre. A link has the inertias of its members without planets, a centre their masses
//! and their radial supports. A shaft joins two links by a torsional stiffness and two centres by a lateral
//! one.
//!
//! # Axes
//! The axes of a set turn with its carrier. At rest all are the same. In a set of three or more equal planets
//! at equal angles, the planets have the same stiffness for every direction of a centre's motion. So the
//! angle between such sets, or to one other set, does not matter. If all sets are such, each mode is of one
//! kind:
//!
//! | kind | links | centres | planets |
//! |---|---|---|---|
//! | rotational | rotate | are at rest | those of a set all do the same |
//! | translational, double | are at rest | translate | |
//! | planet, `N − 3` times for each frequency of a set | are at rest | are at rest | of this set alone |
//!
//! # Source
//! D. R. Kiracofe, R. G. Parker, Structured vibration modes of general compound planetary gear systems,
//! Journal of Vibration and Acoustics 129 (2007) 1–16, for the kinds; the energies are those of the planar
//! model of each set.

use crate::checks::not_negative;
use crate::gear_set::{GearSet, GearSetParts, Seat};
use crate::model::{Body, BodyId, Freedom, Model, SpringId, Support};
use crate::train::{Link, add_inertias, add_links, at, inertias};
use crate::{Error, Stiffness, TorsionalStiffness, newtons_per_meter};
use epicyclic_units::Physical;
use uom::si::f64::{Length, Mass, MomentOfInertia};

/// A centre: what moves in the plane as one piece.
#[derive(Debug, Clone, PartialEq)]
pub struct Centre {
    /// Name of the centre.
    pub name: String,
    /// Mass of what it has beside the members of sets.
    pub mass: Mass,
    /// Whether it is held.
    pub held: bool,
}

/// A set with the places of the links and the centres of its members.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Name of the set, with which the names of its bodies and springs begin.
    pub name: String,
    /// The set; of its members masses, inertias and radial supports count, tangential supports and freedoms
    /// do not.
    pub set: GearSet,
    /// Links of the members, in their order.
    pub links: Vec<usize>,
    /// Centres of the members, in their order.
    pub centres: Vec<usize>,
}

/// A shaft between two links, and between two centres.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    /// Name of the shaft.
    pub name: String,
    /// The links, with its torsional stiffness.
    pub links: Option<([usize; 2], TorsionalStiffness)>,
    /// The centres, with its lateral stiffness.
    pub centres: Option<([usize; 2], Stiffness)>,
}

/// Places of links, centres and sets in the model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CoupledParts {
    /// The links.
    pub links: Vec<BodyId>,
    /// The centres.
    pub centres: Vec<BodyId>,
    /// Planets, meshes and bearings of each set.
    pub sets: Vec<GearSetParts>,
    /// Springs of each shaft: torsion, bending.
    pub shafts: Vec<[Vec<SpringId>; 2]>,
    /// The support of each link against rotation; empty without.
    pub link_supports: Vec<Vec<SpringId>>,
    /// The radial support of each centre; empty without.
    pub centre_supports: Vec<Vec<SpringId>>,
}

impl CoupledParts {
    /// Links and centres, which determine the kind of a mode.
    #[must_use]
    pub fn central(&self) -> Vec<BodyId> {
        self.links.iter().chain(&self.centres).copied().collect()
    }
}

/// The planar model of sets on links and centres.
///
/// # Errors
/// [`Error::NotPositive`] for a link that turns without any inertia and a centre that moves without any mass,
/// and as [`GearSet::planar`]; [`Error::Negative`] for an inertia, mass or stiffness;
/// [`Error::NoSuchBody`] for a place of a link or centre.
pub fn planar(
    links: &[Link],
    centres: &[Centre],
    sets: &[Placed],
    shafts: &[Shaft],
) -> Result<(Model, CoupledParts), Error> {
    let mut inertias = inertias(links)?;
    let mut masses = centres
        .iter()
        .map(|centre| not_negative(|| format!("mass of {}", centre.name), centre.mass.si(), "kg"))
        .collect::<Result<Vec<f64>, Error>>()?;
    // Several members may share a link or a centre: their inertias, masses and supports add up.
    let mut supports = vec![0.0; centres.len()];
    for Placed { set, name, links, centres: own } in sets {
        set.check()?;
        add_inertias(&mut inertias, set, links, name)?;
        at(set.members.len().max(1) - 1, own.len())?;
        for (member, centre) in set.members.iter().zip(own) {
            let (central, centre) = (&member.central, at(*centre, centres.len())?);
            let mass = central.body.mass.si();
            masses[centre] += not_negative(|| format!("mass in {name}"), mass, "kg")?;
            let radial = central.support.radial.si();
            supports[centre] += not_negative(|| format!("support in {name}"), radial, "N/m")?;
        }
    }
    let mut model = Model::new();
    let mut parts = CoupledParts::default();
    (parts.links, parts.link_supports) = add_links(&mut model, links, inertias)?;
    for ((centre, of_members), support) in centres.iter().zip(masses).zip(supports) {
        let body = Body {
            mass: Mass::from_si(of_members),
            inertia: MomentOfInertia::from_si(0.0),
            radius: Length::from_si(1.0),
        };
        let freedom = if centre.held { Freedom::Held } else { Freedom::Translation };
        let place = model.body(&centre.name, &body, freedom)?;
        let support = Support { radial: newtons_per_meter(support), ..Support::default() };
        parts.centres.push(place);
        parts.centre_supports.push(if centre.held { vec![] } else { model.support(place, support)? });
    }
    for placed in sets {
        let seat = |(link, centre): (&usize, &usize)| Seat {
            centre: Some(parts.centres[*centre]),
            turn: parts.links[*link],
        };
        let seats: Vec<Seat> = placed.links.iter().zip(&placed.centres).map(seat).collect();
        parts.sets.push(placed.set.add_planets(&mut model, &placed.name, &seats)?);
    }
    for shaft in shafts {
        let mut springs = [vec![], vec![]];
        if let Some((ends, stiffness)) = shaft.links {
            let [first, second] = ends.map(|end| at(end, links.len()));
            let ends = [parts.links[first?], parts.links[second?]];
            springs[0] = model.shaft(&shaft.name, ends, stiffness, Stiffness::default())?;
        }
        if let Some((ends, stiffness)) = shaft.centres {
            let [first, second] = ends.map(|end| at(end, centres.len()));
            let ends = [parts.centres[first?], parts.centres[second?]];
            springs[1] = model.shaft(&shaft.name, ends, TorsionalStiffness::default(), stiffness)?;
        }
        parts.shafts.push(springs);
    }
    Ok((model, parts))
}
