//! The mechanism: links, planets, and the sets between them, as matrices.
//!
//! # Speeds
//! Links joined for ever are one *node*. For each central gear `c` other than the first `r` a set has an
//! equation of the nodes:
//!
//! ```text
//! (ω_r − ω_H) − i_c·(ω_c − ω_H) = 0      i_c = g_r/g_c
//! ω_p = ω_H + g_p·(ω_r − ω_H)/g_r        a planet about its own axis, absolute
//! ```
//!
//! Elimination with the largest pivot of the remaining entries makes some node speeds sums of the others.
//! These others are the coordinates `q̇`, and all bodies (nodes, then planets) turn at `ω = B·q̇`.
//!
//! # Inertia
//! ```text
//! M = Bᵀ·J·B        J = inertia of each link, N·m·r² of planets on their carrier,
//!                       N·J_p of planets about their own axes
//! ```
//!
//! # Torques
//! A mesh acts on its gears `A`, `B` and through the bearings of the planets on the carrier `H`; with
//! `ρ = g_A/g_B`:
//!
//! ```text
//! T_B = −ρ·e·T_A     T_H = −T_A − T_B
//! e = η^w            w = +1 where power flows from A to B, −1 where it flows back
//! P = −T_A·(ω_A − ω_H)                    power from A into the mesh, relative to the carrier
//! loss = P·(1 − e)
//! ```
//!
//! Each body keeps its own balance `J·ω̇ = Σ T`, so that the meshes of a planet carry different powers while
//! it accelerates. A planet without inertia and with two meshes passes its torque on; these meshes are taken
//! as one, with the product of their efficiencies.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `ω`, `q̇` | speeds of bodies, coordinates | rad/s |
//! | `g` | factor of a gear: `ω − ω_H` of all gears of a set are as their factors | 1 |
//! | `J`, `N`, `m`, `r` | inertia; number, mass and centre radius of planets | kg·m², 1, kg, m |
//! | `T` | torque on a body from outside it | N·m |
//! | `η` | efficiency of a mesh | 1 |

mod coordinates;
mod sets;

use crate::Error;
use crate::tolerance::{PIVOT, RANK};
use epicyclic_dynamics::gearbox::Masses;
use epicyclic_numerics::linear::{Matrix, Triangles, independent};
use epicyclic_numerics::values::dot;
use epicyclic_train::groups::Groups;
use epicyclic_train::{GROUND, Gearbox, LinkId};
use epicyclic_units::Physical;
use uom::si::f64::MomentOfInertia;

/// A body: a node or a planet by its row; none is the housing.
pub(crate) type Place = Option<usize>;

/// A mesh, or meshes in a row, as torques between bodies.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeshForce {
    pub(crate) set: usize,
    pub(crate) ends: [Place; 2],
    pub(crate) carrier: Place,
    /// `ρ = g_A/g_B`.
    pub(crate) ratio: f64,
    pub(crate) efficiency: f64,
    /// Names of the gears at its ends.
    pub(crate) gears: [String; 2],
    /// Bodies of its ends among those of its set.
    pub(crate) bodies: [usize; 2],
    /// `g_A/g_r`.
    pub(crate) factor: f64,
    /// `ω_A − ω_H` over the coordinates.
    pub(crate) rolling: Vec<f64>,
}

impl MeshForce {
    pub(crate) fn is_lossy(&self) -> bool {
        self.efficiency < 1.0
    }
}

/// Common data of the meshes of a set.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SetMotion {
    pub(crate) name: String,
    pub(crate) carrier: Place,
    /// The first central gear.
    pub(crate) root: Place,
    /// Places of its meshes in [`Mechanism::meshes`], outwards from the first central gear.
    pub(crate) meshes: std::ops::Range<usize>,
    /// `ω_r − ω_H` over the coordinates.
    pub(crate) rolling: Vec<f64>,
    /// Whether a mesh loses power, and the set can roll.
    pub(crate) is_lossy: bool,
    /// Body of each central gear, by its number in the set.
    pub(crate) centrals: Vec<usize>,
}

/// A gearbox, or shafts alone, with their masses: the moving parts, without drives and loads.
///
/// ```
/// use epicyclic_dynamics::gearbox::Masses;
/// use epicyclic_motion::Mechanism;
/// use epicyclic_train::{Gearbox, set::SetSpec};
/// use uom::si::f64::MomentOfInertia;
/// use uom::si::moment_of_inertia::kilogram_square_meter;
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("conveyor")
///     .links(["D", "B", "T1"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("slow", ["K1"])
///     .build()?;
/// let kg_m2 = MomentOfInertia::new::<kilogram_square_meter>;
/// let links = vec![("D".into(), kg_m2(0.5)), ("B".into(), kg_m2(16.0))];
/// let masses = Masses { links, ..Masses::default() };
/// assert_eq!(Mechanism::of(&gearbox, &[], &masses)?.freedoms(), 2);
/// // The brake engaged for good: one freedom, and the drum felt at a quarter of its speed.
/// let slow = Mechanism::of(&gearbox, &["K1"], &masses)?;
/// assert_eq!(slow.freedoms(), 1);
/// assert!((slow.equivalent_inertia("D")?.get::<kilogram_square_meter>() - 1.5).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mechanism {
    /// Links by [`LinkId::index`], the housing first.
    pub(crate) links: Vec<String>,
    /// Node of each link.
    pub(crate) node: Vec<Place>,
    /// Number of nodes; planets follow them.
    pub(crate) nodes: usize,
    /// Nodes whose speeds are the coordinates.
    pub(crate) coordinates: Vec<usize>,
    /// `B`, of nodes and planets.
    pub(crate) speeds: Matrix,
    /// `J`, of nodes and planets.
    pub(crate) inertias: Vec<f64>,
    pub(crate) meshes: Vec<MeshForce>,
    pub(crate) sets: Vec<SetMotion>,
    /// Shift elements of the gearbox that are not engaged for good: name, links, whether one-way.
    pub(crate) elements: Vec<(String, [String; 2], bool)>,
}

impl Mechanism {
    /// A gearbox with its masses, these shift elements engaged for good; as a rule none, since a shift
    /// element is a torque of the [`Model`](crate::Model).
    ///
    /// # Errors
    /// [`Error::Unknown`] for a shift element, link, set or planet that is not there; [`Error::Value`] for a
    /// mass, inertia or radius that no body has; [`Error::PlanetSpeed`]; [`Error::NoFreedom`];
    /// [`Error::Overdetermined`]; [`Error::NoInertia`].
    pub fn of(gearbox: &Gearbox, engaged: &[&str], masses: &Masses) -> Result<Self, Error> {
        let mut groups = Groups::new(gearbox.links().len());
        for [first, second] in gearbox.permanent() {
            groups.join(first.index(), second.index());
        }
        for name in engaged {
            let unknown = || Error::Unknown { what: "shift element", name: (*name).to_owned() };
            let element =
                gearbox.shift_elements().iter().find(|one| one.id() == *name).ok_or_else(unknown)?;
            let [first, second] = element.links();
            groups.join(first.index(), second.index());
        }
        let (node, nodes) = numbered(&groups, gearbox.links().len());
        let elements = gearbox.shift_elements().iter().filter(|one| !engaged.contains(&one.id()));
        let name = |link: LinkId| gearbox.link_name(link).to_owned();
        let mut made = Self {
            links: gearbox.links().to_vec(),
            node,
            nodes,
            coordinates: vec![],
            speeds: Matrix::zeros(0, 0),
            inertias: vec![0.0; nodes],
            meshes: vec![],
            sets: vec![],
            elements: elements
                .map(|one| (one.id().to_owned(), one.links().map(name), one.is_one_way()))
                .collect(),
        };
        for (link, inertia) in &masses.links {
            made.add_inertia(link, *inertia)?;
        }
        let asked = sets::asked(gearbox, &made.node, nodes);
        made.find_coordinates(&asked, gearbox)?;
        made.add_sets(gearbox, &masses.planets)?;
        made.check_inertia()?;
        Ok(made)
    }

    /// Shafts without any gear set, by name, to be joined by shift elements.
    ///
    /// # Errors
    /// [`Error::Duplicate`], [`Error::Value`], [`Error::NoInertia`] for a shaft without inertia,
    /// [`Error::NoFreedom`] without shafts.
    pub fn shafts(shafts: &[(&str, MomentOfInertia)]) -> Result<Self, Error> {
        let mut links = vec![GROUND.to_owned()];
        for (name, _) in shafts {
            if links.iter().any(|link| link == name) {
                return Err(Error::Duplicate { what: "link", name: (*name).to_owned() });
            }
            links.push((*name).to_owned());
        }
        let nodes = shafts.len();
        let (node, _) = numbered(&Groups::new(links.len()), links.len());
        let mut speeds = Matrix::zeros(nodes, nodes);
        (0..nodes).for_each(|node| speeds.row_mut(node)[node] = 1.0);
        let mut made = Self {
            links,
            node,
            nodes,
            coordinates: (0..nodes).collect(),
            speeds,
            inertias: vec![0.0; nodes],
            meshes: vec![],
            sets: vec![],
            elements: vec![],
        };
        for (name, inertia) in shafts {
            made.add_inertia(name, *inertia)?;
        }
        made.check_inertia()?;
        Ok(made)
    }

    /// Adds a body that is not part of the gearbox: engine, load, vehicle. It is a link of its own, which
    /// only shafts, converters and friction join to others.
    ///
    /// # Errors
    /// [`Error::Duplicate`] for a link that exists; [`Error::Value`]; [`Error::NoInertia`] for a body without
    /// inertia.
    pub fn with_body(mut self, name: &str, inertia: MomentOfInertia) -> Result<Self, Error> {
        if self.links.iter().any(|link| link == name) {
            return Err(Error::Duplicate { what: "link", name: name.to_owned() });
        }
        let value = not_negative(format!("the inertia of {name} in kg·m²"), inertia.si())?;
        if value == 0.0 {
            return Err(Error::NoInertia { links: vec![name.to_owned()], missing: 1 });
        }
        let (row, column) = (self.nodes, self.freedoms());
        let mut speeds = Matrix::zeros(self.speeds.rows() + 1, column + 1);
        for body in 0..self.speeds.rows() {
            // Planets follow the nodes.
            let moved = body + usize::from(body >= row);
            speeds.row_mut(moved)[..column].copy_from_slice(self.speeds.row(body));
        }
        speeds.row_mut(row)[column] = 1.0;
        self.speeds = speeds;
        self.inertias.insert(row, value);
        self.links.push(name.to_owned());
        self.node.push(Some(row));
        self.nodes += 1;
        self.coordinates.push(row);
        let moved = |place: &mut Place| *place = place.map(|body| body + usize::from(body >= row));
        for mesh in &mut self.meshes {
            mesh.ends.iter_mut().for_each(moved);
            mesh.rolling.push(0.0);
        }
        for set in &mut self.sets {
            moved(&mut set.root);
            set.rolling.push(0.0);
        }
        Ok(self)
    }

    /// Number of coordinates.
    #[must_use]
    pub fn freedoms(&self) -> usize {
        self.coordinates.len()
    }

    /// Links whose speeds are the coordinates `q̇`.
    #[must_use]
    pub fn coordinates(&self) -> Vec<&str> {
        self.coordinates.iter().map(|&node| self.node_name(node)).collect()
    }

    /// The mass matrix `M = Bᵀ·J·B` in these coordinates.
    #[must_use]
    pub fn mass_matrix(&self) -> Vec<Vec<MomentOfInertia>> {
        let matrix = self.masses();
        (0..matrix.rows())
            .map(|row| matrix.row(row).iter().map(|&entry| MomentOfInertia::from_si(entry)).collect())
            .collect()
    }

    /// Speeds of a link over those of the coordinates; all 0 of one piece with the housing.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn speed_factors(&self, link: &str) -> Result<Vec<f64>, Error> {
        Ok(match self.place(link)? {
            Some(node) => self.speeds.row(node).to_vec(),
            None => vec![0.0; self.freedoms()],
        })
    }

    /// Equivalent inertia at a link: its torque over its acceleration while nothing else acts, `1/(b·M⁻¹·bᵀ)`
    /// with the row `b` of `B`.
    ///
    /// # Errors
    /// [`Error::Unknown`]; [`Error::NoFreedom`] of a link that cannot move.
    pub fn equivalent_inertia(&self, link: &str) -> Result<MomentOfInertia, Error> {
        let factors = self.speed_factors(link)?;
        let triangles = Triangles::new(self.masses(), PIVOT).ok_or(Error::NoFreedom)?;
        let mobility = dot(&factors, &triangles.solution(&factors));
        if mobility > 0.0 { Ok(MomentOfInertia::from_si(1.0 / mobility)) } else { Err(Error::NoFreedom) }
    }

    /// Whether two links are one piece: joined for ever, or by an engaged shift element that never slips.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn is_one_piece(&self, first: &str, second: &str) -> Result<bool, Error> {
        Ok(self.place(first)? == self.place(second)?)
    }

    /// Node of a link.
    pub(crate) fn place(&self, link: &str) -> Result<Place, Error> {
        let found = self.links.iter().position(|name| name == link);
        let unknown = || Error::Unknown { what: "link", name: link.to_owned() };
        Ok(self.node[found.ok_or_else(unknown)?])
    }

    /// Name of the first link of a node.
    pub(crate) fn node_name(&self, node: usize) -> &str {
        self.node.iter().position(|&one| one == Some(node)).map_or(GROUND, |link| &self.links[link])
    }

    /// `M`.
    pub(crate) fn masses(&self) -> Matrix {
        let n = self.freedoms();
        let mut matrix = Matrix::zeros(n, n);
        for (body, &inertia) in self.inertias.iter().enumerate() {
            let speeds = self.speeds.row(body);
            for row in 0..n {
                for column in 0..n {
                    matrix.row_mut(row)[column] += inertia * speeds[row] * speeds[column];
                }
            }
        }
        matrix
    }

    /// `½·Σ J·ω²` over all bodies.
    pub(crate) fn kinetic_energy(&self, coordinates: &[f64]) -> f64 {
        let of = |(body, inertia): (usize, &f64)| {
            let speed = dot(self.speeds.row(body), coordinates);
            0.5 * inertia * speed * speed
        };
        self.inertias.iter().enumerate().map(of).sum()
    }

    fn add_inertia(&mut self, link: &str, inertia: MomentOfInertia) -> Result<(), Error> {
        let value = not_negative(format!("the inertia of {link} in kg·m²"), inertia.si())?;
        if let Some(node) = self.place(link)? {
            self.inertias[node] += value;
        }
        Ok(())
    }

    /// Refuses motions in which nothing with inertia moves, naming the links that move in them.
    ///
    /// `M = Bᵀ·J·B` is positive definite exactly if the rows of `B` of bodies with inertia span all
    /// coordinates.
    fn check_inertia(&self) -> Result<(), Error> {
        let n = self.freedoms();
        if n == 0 {
            return Err(Error::NoFreedom);
        }
        let heavy = self.inertias.iter().enumerate().filter(|(_, inertia)| **inertia > 0.0);
        let rows: Vec<&[f64]> = heavy.map(|(body, _)| self.speeds.row(body)).collect();
        let known = independent(&rows, RANK).kept.len();
        if known == n {
            // Inertias so far apart that rounding leaves nothing of the lesser ones are none either.
            return match Triangles::new(self.masses(), PIVOT) {
                Some(triangles) if triangles.determinant() > 0.0 => Ok(()),
                _ => Err(Error::NoInertia { links: self.lightest(), missing: 1 }),
            };
        }
        let adds = |node: &usize| {
            let with: Vec<&[f64]> = rows.iter().copied().chain([self.speeds.row(*node)]).collect();
            independent(&with, RANK).kept.len() > known
        };
        let links = (0..self.nodes).filter(adds).map(|node| self.node_name(node).to_owned()).collect();
        Err(Error::NoInertia { links, missing: n - known })
    }

    /// The node of least inertia.
    fn lightest(&self) -> Vec<String> {
        let least =
            (0..self.nodes).min_by(|&one, &other| self.inertias[one].total_cmp(&self.inertias[other]));
        least.map(|node| self.node_name(node).to_owned()).into_iter().collect()
    }
}

/// Nodes of the links, the housing first.
fn numbered(groups: &Groups, links: usize) -> (Vec<Place>, usize) {
    let mut node: Vec<Place> = vec![None; links];
    let mut count = 0;
    for link in 1..links {
        let root = groups.root(link);
        if root == link {
            node[link] = Some(count);
            count += 1;
        } else {
            node[link] = node[root];
        }
    }
    (node, count)
}

/// A number that is finite and not negative.
pub(crate) fn not_negative(field: String, value: f64) -> Result<f64, Error> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Error::Value { field, value, allowed: "it is finite and not negative" })
    }
}
