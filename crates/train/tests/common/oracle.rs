//! An oracle that shares no formula with the solver: every mesh is an unknown force, every gear, planet,
//! carrier and link a body with its own balance of moments, every body a speed of its own. nalgebra solves
//! what comes of it.
//!
//! ```text
//! mesh of a and b     z_a·ν_a ± z_b·ν_b = 0    ν = ω − ω_H             + outside, − inside a ring
//! torques there       T_a = z_a·F·α_a          T_b = ±z_b·F·α_b
//!                     α = η on the side that takes the power, else 1
//! body of a set       sum of the mesh torques on it + what its link gives it = 0
//! whole set           what its members' links give it = 0
//! link                what shift elements, ties and terminals give it − what it gives to members = 0
//! ```

#![allow(dead_code, reason = "each test binary uses its own part")]
#![allow(clippy::unwrap_used, reason = "fixtures of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::compound::{CentralKind, CentralSpec, CompoundSpec, MeshSpec, PlanetSpec};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{Direction, Error, Gearbox};
use nalgebra::{DMatrix, DVector};

/// Pseudo-random numbers (xorshift*).
#[derive(Debug, Clone)]
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 16
    }

    /// Random number of `0..n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    pub(crate) fn between(&mut self, least: u32, most: u32) -> u32 {
        least + self.below((most - least + 1) as usize) as u32
    }

    pub(crate) fn chance(&mut self, of_100: usize) -> bool {
        self.below(100) < of_100
    }

    /// An efficiency in 0.9…1.
    pub(crate) fn eta(&mut self) -> f64 {
        1.0 - 0.1 * (self.below(1_000_000) as f64 / 1e6)
    }

    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

#[derive(Debug, Clone)]
pub(crate) struct CentralPlan {
    pub(crate) link: usize,
    pub(crate) kind: CentralKind,
    pub(crate) teeth: u32,
    /// Planet that a planet shaft turns with.
    pub(crate) planet: Option<usize>,
}

/// A set gear by gear; with a kind it is described in short.
#[derive(Debug, Clone)]
pub(crate) struct SetPlan {
    pub(crate) kind: Option<SetKind>,
    pub(crate) carrier: usize,
    pub(crate) centrals: Vec<CentralPlan>,
    pub(crate) planets: Vec<Vec<u32>>,
    pub(crate) meshes: Vec<([GearOf; 2], f64)>,
}

/// A gearbox as numbers: links by index, 0 the housing.
#[derive(Debug, Clone)]
pub(crate) struct BoxPlan {
    pub(crate) links: usize,
    pub(crate) sets: Vec<SetPlan>,
    pub(crate) ties: Vec<[usize; 2]>,
    /// Links, and whether engaged.
    pub(crate) elements: Vec<([usize; 2], bool)>,
    pub(crate) input: usize,
    pub(crate) output: usize,
}

fn central(kind: CentralKind, teeth: u32) -> CentralPlan {
    CentralPlan { link: 0, kind, teeth, planet: None }
}

/// Places in a set, written short.
pub(crate) const fn c(place: usize) -> GearOf {
    GearOf::Central(place)
}

/// A planet's gear.
pub(crate) const fn p(planet: usize, step: usize) -> GearOf {
    GearOf::Planet(planet, step)
}

impl SetPlan {
    pub(crate) fn members(&self) -> Vec<usize> {
        self.centrals.iter().map(|one| one.link).chain([self.carrier]).collect()
    }

    fn body(&self, gear: GearOf) -> usize {
        match gear {
            GearOf::Central(place) => match self.centrals[place].planet {
                Some(planet) => self.centrals.len() + planet,
                None => place,
            },
            GearOf::Planet(planet, _) => self.centrals.len() + planet,
        }
    }

    fn teeth(&self, gear: GearOf) -> f64 {
        f64::from(match gear {
            GearOf::Central(place) => self.centrals[place].teeth,
            GearOf::Planet(planet, step) => self.planets[planet][step],
        })
    }

    /// Whether the gears turn in one direction seen from the carrier.
    fn is_inside(&self, gears: [GearOf; 2]) -> bool {
        gears.iter().any(|gear| {
            matches!(gear, GearOf::Central(place)
                if matches!(self.centrals[*place].kind, CentralKind::Ring | CentralKind::BevelRight))
        })
    }

    /// A set of one of the usual kinds with random teeth, on links still to be named.
    pub(crate) fn short(kind: SetKind, dice: &mut Dice) -> Self {
        use CentralKind::{BevelLeft, BevelRight, Ring, Sun};
        let (sun, planet) = (dice.between(18, 60), dice.between(15, 40));
        let other = dice.between(15, 40);
        let ring = dice.between(61, 130);
        let (kinds, planets, gears): ([CentralKind; 2], Vec<Vec<u32>>, Vec<[GearOf; 2]>) = match kind {
            SetKind::Simple => ([Sun, Ring], vec![vec![planet]], vec![[c(0), p(0, 0)], [p(0, 0), c(1)]]),
            SetKind::DoublePlanet => (
                [Sun, Ring],
                vec![vec![planet], vec![other]],
                vec![[c(0), p(0, 0)], [p(0, 0), p(1, 0)], [p(1, 0), c(1)]],
            ),
            SetKind::MeshingSuns => (
                [Sun, Sun],
                vec![vec![planet], vec![other]],
                vec![[c(0), p(0, 0)], [p(0, 0), p(1, 0)], [p(1, 0), c(1)]],
            ),
            SetKind::SteppedSunRing | SetKind::SteppedSuns | SetKind::SteppedRings => {
                let kinds = match kind {
                    SetKind::SteppedSunRing => [Sun, Ring],
                    SetKind::SteppedSuns => [Sun, Sun],
                    _ => [Ring, Ring],
                };
                (kinds, vec![vec![planet, other]], vec![[c(0), p(0, 0)], [p(0, 1), c(1)]])
            }
            SetKind::Bevel => {
                ([BevelLeft, BevelRight], vec![vec![planet]], vec![[c(0), p(0, 0)], [p(0, 0), c(1)]])
            }
            SetKind::ExternalPair => ([Sun, Sun], vec![], vec![[c(0), c(1)]]),
            SetKind::InternalPair => ([Sun, Ring], vec![], vec![[c(0), c(1)]]),
        };
        let teeth = |kind: CentralKind, fallback: u32| if kind == Ring { ring + fallback } else { fallback };
        let centrals =
            vec![central(kinds[0], teeth(kinds[0], sun)), central(kinds[1], teeth(kinds[1], ring))];
        let meshes = gears.into_iter().map(|gears| (gears, dice.eta())).collect();
        Self { kind: Some(kind), carrier: 0, centrals, planets, meshes }
    }

    /// A compound set of one of the well known forms, or any tree.
    pub(crate) fn compound(form: usize, dice: &mut Dice) -> Self {
        use CentralKind::{Ring, Sun};
        let mut z = |least, most| dice.between(least, most);
        let (centrals, planets, gears) = match form {
            // Ravigneaux with three and four central gears.
            0 => (
                vec![central(Sun, z(20, 40)), central(Sun, z(25, 50)), central(Ring, z(61, 120))],
                vec![vec![z(15, 25)], vec![z(15, 25)]],
                vec![[c(0), p(0, 0)], [p(0, 0), p(1, 0)], [c(1), p(1, 0)], [p(1, 0), c(2)]],
            ),
            1 => (
                vec![
                    central(Sun, z(20, 40)),
                    central(Sun, z(25, 50)),
                    central(Ring, z(61, 120)),
                    central(Ring, z(61, 120)),
                ],
                vec![vec![z(15, 25)], vec![z(15, 25)]],
                vec![[c(0), p(0, 0)], [p(1, 0), p(0, 0)], [c(1), p(1, 0)], [p(1, 0), c(2)], [c(3), p(0, 0)]],
            ),
            // Wolfrom.
            2 => (
                vec![central(Sun, z(20, 40)), central(Ring, z(80, 120)), central(Ring, z(80, 120))],
                vec![vec![z(25, 40), z(25, 40)]],
                vec![[c(0), p(0, 0)], [p(0, 0), c(1)], [p(0, 1), c(2)]],
            ),
            // A stepped long planet beside an idler.
            3 => (
                vec![central(Sun, z(20, 40)), central(Sun, z(25, 50)), central(Ring, z(61, 120))],
                vec![vec![z(15, 25), z(15, 30)], vec![z(15, 25)]],
                vec![[c(0), p(1, 0)], [p(1, 0), p(0, 0)], [p(0, 1), c(1)], [c(2), p(0, 1)]],
            ),
            // Ring to ring through planets in mesh.
            4 => (
                vec![central(Ring, z(80, 120)), central(Ring, z(70, 110)), central(Sun, z(20, 30))],
                vec![vec![z(15, 25)], vec![z(15, 25)]],
                vec![[c(0), p(0, 0)], [p(0, 0), p(1, 0)], [p(1, 0), c(1)], [c(2), p(0, 0)]],
            ),
            // A ring and a sun in mesh with two planets each.
            5 => (
                vec![central(Sun, z(20, 40)), central(Ring, z(80, 120)), central(Ring, z(70, 110))],
                vec![vec![z(15, 25)], vec![z(15, 25), z(20, 30)]],
                vec![[c(0), p(0, 0)], [c(0), p(1, 0)], [p(0, 0), c(1)], [p(1, 1), c(2)]],
            ),
            _ => return Self::tree(dice),
        };
        let meshes = gears.into_iter().map(|gears| (gears, dice.eta())).collect();
        Self { kind: None, carrier: 0, centrals, planets, meshes }
    }

    /// Any tree: 2 to 5 central gears, 1 to 4 planets with 1 to 3 gears, planet shafts, a central gear in
    /// mesh with two planets.
    fn tree(dice: &mut Dice) -> Self {
        use CentralKind::{PlanetShaft, Ring, Sun};
        let planets: Vec<Vec<u32>> = (0..dice.between(1, 4))
            .map(|_| (0..dice.between(1, 3)).map(|_| dice.between(15, 40)).collect())
            .collect();
        let mut centrals: Vec<CentralPlan> = vec![];
        let mut meshes: Vec<([GearOf; 2], f64)> = vec![];
        let wanted = dice.between(2, 5) as usize;
        let gear = |dice: &mut Dice, planet: usize| p(planet, dice.below(planets[planet].len()));
        for planet in 1..planets.len() {
            let before = dice.below(planet);
            if dice.chance(30) && centrals.len() + 1 < wanted {
                // Tied by a central gear instead of a mesh between them.
                let kind = if dice.chance(50) { Ring } else { Sun };
                let teeth = if kind == Ring { dice.between(60, 120) } else { dice.between(18, 50) };
                centrals.push(central(kind, teeth));
                for one in [before, planet] {
                    meshes.push(([c(centrals.len() - 1), gear(dice, one)], dice.eta()));
                }
            } else {
                meshes.push(([gear(dice, before), gear(dice, planet)], dice.eta()));
            }
        }
        while centrals.len() < wanted {
            let planet = dice.below(planets.len());
            let has_shaft = centrals.iter().any(|one| one.planet == Some(planet));
            if dice.chance(15) && !has_shaft {
                centrals.push(CentralPlan { link: 0, kind: PlanetShaft, teeth: 0, planet: Some(planet) });
                continue;
            }
            let kind = if dice.chance(50) { Ring } else { Sun };
            let teeth = if kind == Ring { dice.between(60, 120) } else { dice.between(18, 50) };
            centrals.push(central(kind, teeth));
            let gears = [c(centrals.len() - 1), gear(dice, planet)];
            meshes.push((if dice.chance(50) { gears } else { [gears[1], gears[0]] }, dice.eta()));
        }
        Self { kind: None, carrier: 0, centrals, planets, meshes }
    }
}

pub(crate) const KINDS: [SetKind; 9] = [
    SetKind::Simple,
    SetKind::DoublePlanet,
    SetKind::SteppedSunRing,
    SetKind::SteppedSuns,
    SetKind::SteppedRings,
    SetKind::MeshingSuns,
    SetKind::Bevel,
    SetKind::ExternalPair,
    SetKind::InternalPair,
];

impl BoxPlan {
    /// A gearbox of up to this many sets; with `compound` in 100 of them compound. As many conditions as
    /// speeds, so that most are driven.
    pub(crate) fn random(most: usize, compound: usize, dice: &mut Dice) -> Self {
        let mut sets: Vec<SetPlan> = (0..=dice.below(most))
            .map(|_| {
                if dice.chance(compound) {
                    let form = dice.below(12);
                    SetPlan::compound(form, dice)
                } else {
                    let kind = KINDS[dice.below(KINDS.len())];
                    SetPlan::short(kind, dice)
                }
            })
            .collect();
        let engaged = dice.below(4);
        let equations: usize = sets.iter().map(|set| set.centrals.len() - 1).sum();
        let links = (1 + equations + engaged).max(2);
        for set in &mut sets {
            let mut places: Vec<usize> = (0..=links).collect();
            dice.shuffle(&mut places);
            if set.planets.is_empty() {
                places.retain(|place| *place != 0);
                set.carrier = 0;
            } else {
                set.carrier = places.pop().unwrap();
            }
            for one in &mut set.centrals {
                one.link = places.pop().unwrap();
            }
        }
        let pair = |dice: &mut Dice| {
            let first = 1 + dice.below(links);
            let second = (first + 1 + dice.below(links)) % (links + 1);
            [first, second]
        };
        let mut ties = vec![];
        let mut elements = vec![];
        for place in 0..engaged {
            let own = pair(dice);
            if place == 0 && dice.chance(20) { ties.push(own) } else { elements.push((own, true)) }
        }
        for _ in 0..dice.below(3) {
            elements.push((pair(dice), false));
        }
        dice.shuffle(&mut elements);
        let input = 1 + dice.below(links);
        let output = 1 + (input + dice.below(links - 1)) % links;
        Self { links, sets, ties, elements, input, output }
    }

    /// A gearbox of these sets with their links set, nothing engaged.
    pub(crate) fn of(sets: Vec<SetPlan>, links: usize, input: usize, output: usize) -> Self {
        Self { links, sets, ties: vec![], elements: vec![], input, output }
    }

    pub(crate) fn link_name(link: usize) -> String {
        if link == 0 { "ground".to_owned() } else { format!("n{link}") }
    }

    /// The gearbox, everything named in its order or, with dice, in any.
    pub(crate) fn build(&self, mut dice: Option<&mut Dice>) -> Result<Gearbox, Error> {
        let mut order = |count: usize| {
            let mut places: Vec<usize> = (0..count).collect();
            if let Some(dice) = dice.as_deref_mut() {
                dice.shuffle(&mut places);
            }
            places
        };
        let name = Self::link_name;
        let mut builder =
            Gearbox::builder("random").links(order(self.links).into_iter().map(|place| name(place + 1)));
        for place in order(self.sets.len()) {
            let set = &self.sets[place];
            let id = format!("s{place}");
            let eta = |mesh: usize| MeshEfficiency::new(set.meshes[mesh].1).unwrap();
            if let Some(kind) = set.kind {
                let [a, b] = [0, 1].map(|one| name(set.centrals[one].link));
                let teeth = |one: usize| set.centrals[one].teeth;
                let carrier = name(set.carrier);
                let spec = SetSpec::teeth(&id, kind, [&a, &b, &carrier], teeth(0), teeth(1)).unwrap();
                let ideal = MeshEfficiency::IDEAL;
                let loss = match set.meshes.len() {
                    1 => MeshLoss::Set(eta(0)),
                    2 => MeshLoss::Meshes { first: eta(0), between: ideal, second: eta(1) },
                    _ => MeshLoss::Meshes { first: eta(0), between: eta(1), second: eta(2) },
                };
                let gears: Vec<ToothCount> =
                    set.planets.iter().flatten().map(|&z| ToothCount::new(z).unwrap()).collect();
                let spec = spec.with_loss(loss);
                builder = builder.set(match gears.first() {
                    Some(first) => spec.planet_teeth(*first, gears.get(1).copied()),
                    None => spec,
                });
                continue;
            }
            let mut spec = CompoundSpec::new(&id, &name(set.carrier));
            for one in order(set.centrals.len()) {
                let own = &set.centrals[one];
                spec.centrals.push(CentralSpec {
                    name: format!("c{one}"),
                    link: name(own.link),
                    kind: own.kind,
                    teeth: f64::from(own.teeth),
                    planet: own.planet.map(|planet| format!("p{planet}")),
                });
            }
            for one in order(set.planets.len()) {
                spec.planets.push(PlanetSpec { name: format!("p{one}"), teeth: set.planets[one].clone() });
            }
            let gear = |gear: GearOf| match gear {
                GearOf::Central(one) => format!("c{one}"),
                GearOf::Planet(planet, step) if set.planets[planet].len() > 1 => {
                    format!("p{planet}.{}", step + 1)
                }
                GearOf::Planet(planet, _) => format!("p{planet}"),
            };
            for mesh in order(set.meshes.len()) {
                let between = set.meshes[mesh].0.map(gear);
                spec.meshes.push(MeshSpec { between, efficiency: eta(mesh) });
            }
            builder = builder.compound_set(spec);
        }
        for place in order(self.ties.len()) {
            let [first, second] = self.ties[place].map(name);
            builder = builder.tie(&first, &second);
        }
        let mut engaged = vec![];
        for place in order(self.elements.len()) {
            let (pair, on) = self.elements[place];
            let [first, second] = pair.map(name);
            builder = builder.clutch(&format!("e{place}"), &first, &second);
            if on {
                engaged.push(format!("e{place}"));
            }
        }
        builder.input(&name(self.input)).output(&name(self.output)).gear("g", engaged).build()
    }

    pub(crate) fn mesh_count(&self) -> usize {
        self.sets.iter().map(|set| set.meshes.len()).sum()
    }

    /// Ties, then engaged shift elements: their links, and the place of the element.
    fn joints(&self) -> Vec<([usize; 2], Option<usize>)> {
        let ties = self.ties.iter().map(|&pair| (pair, None));
        let engaged = self.elements.iter().enumerate().filter(|(_, (_, on))| *on);
        ties.chain(engaged.map(|(place, (pair, _))| (*pair, Some(place)))).collect()
    }
}

/// Speeds: of the links, and of the bodies of each set.
pub(crate) struct Speeds {
    pub(crate) links: Vec<f64>,
    pub(crate) bodies: Vec<Vec<f64>>,
}

/// Torques and powers, per unit of power that enters.
pub(crate) struct Loads {
    /// Torques on the members of each set, the carrier last.
    pub(crate) members: Vec<Vec<f64>>,
    /// Torque on the first link of each shift element.
    pub(crate) elements: Vec<f64>,
    pub(crate) input: f64,
    pub(crate) output: f64,
    /// Power that the first and the second gear of each mesh take from it.
    pub(crate) meshes: Vec<Vec<[f64; 2]>>,
    pub(crate) largest: f64,
    pub(crate) efficiency: f64,
}

impl Loads {
    /// Direction of power through each mesh: 1 from its first gear to its second.
    pub(crate) fn signs(&self) -> Vec<i8> {
        let zero = 1e-11 * self.largest;
        let sign = |[first, _]: &[f64; 2]| i8::from(*first < -zero) - i8::from(*first > zero);
        self.meshes.iter().flatten().map(sign).collect()
    }
}

/// Solves a square system; `None` where it is near singular.
fn solve(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.nrows() != matrix.ncols() {
        return None;
    }
    let lu = matrix.full_piv_lu();
    let diagonal = lu.u().diagonal().map(f64::abs);
    if diagonal.min().is_nan() || diagonal.min() <= 1e-9 * diagonal.max() {
        return None;
    }
    lu.solve(right)
}

/// Speeds of everything for one of the input; `None` unless all follow.
pub(crate) fn speeds(plan: &BoxPlan) -> Option<Speeds> {
    let mut column = plan.links;
    let mut first_body = vec![];
    for set in &plan.sets {
        first_body.push(column);
        column += set.centrals.len() + set.planets.len();
    }
    let mut rows: Vec<Vec<(usize, f64)>> = vec![];
    let link = |link: usize, factor: f64| (link > 0).then(|| (link - 1, factor));
    for (set, &from) in plan.sets.iter().zip(&first_body) {
        for (place, one) in set.centrals.iter().enumerate() {
            let body = from + set.body(c(place));
            rows.push([link(one.link, 1.0), Some((body, -1.0))].into_iter().flatten().collect());
            if one.planet.is_some() {
                // The place of a body that a planet shaft has not.
                rows.push(vec![(from + place, 1.0)]);
            }
        }
        for &(gears, _) in &set.meshes {
            let [a, b] = gears.map(|gear| set.teeth(gear));
            let b = if set.is_inside(gears) { -b } else { b };
            let scale = a.max(b.abs());
            let [x, y] = gears.map(|gear| from + set.body(gear));
            let row = [Some((x, a / scale)), Some((y, b / scale)), link(set.carrier, -(a + b) / scale)];
            rows.push(row.into_iter().flatten().collect());
        }
    }
    for ([first, second], _) in plan.joints() {
        rows.push([link(first, 1.0), link(second, -1.0)].into_iter().flatten().collect());
    }
    rows.push(vec![(plan.input - 1, 1.0)]);
    if rows.len() != column {
        return None;
    }
    let mut matrix = DMatrix::zeros(column, column);
    for (place, row) in rows.iter().enumerate() {
        for &(at, factor) in row {
            matrix[(place, at)] += factor;
        }
    }
    let mut right = DVector::zeros(column);
    right[column - 1] = 1.0;
    let found = solve(matrix, &right)?;
    let of_link = |link: usize| if link == 0 { 0.0 } else { found[link - 1] };
    let bodies = plan.sets.iter().zip(&first_body).map(|(set, &from)| {
        (0..set.centrals.len() + set.planets.len()).map(|body| found[from + body]).collect()
    });
    Some(Speeds { links: (0..=plan.links).map(of_link).collect(), bodies: bodies.collect() })
}

/// Torques for these directions of power through the meshes, with each loss at `share` of its full size.
pub(crate) fn loads(
    plan: &BoxPlan,
    speeds: &Speeds,
    direction: Direction,
    signs: &[i8],
    share: f64,
) -> Option<Loads> {
    let joints = plan.joints();
    // Unknowns: forces, torques on members, joints, the terminal that is not given.
    let meshes = plan.mesh_count();
    let members: usize = plan.sets.iter().map(|set| set.centrals.len() + 1).sum();
    let columns = meshes + members + joints.len() + 1;
    let bodies: usize = plan.sets.iter().map(|set| set.centrals.len() + set.planets.len()).sum();
    let shafts: usize =
        plan.sets.iter().flat_map(|set| &set.centrals).filter(|one| one.planet.is_some()).count();
    let rows = bodies - shafts + plan.sets.len() + plan.links;
    if rows != columns {
        return None;
    }
    let mut matrix = DMatrix::zeros(rows, columns);
    let mut right = DVector::zeros(rows);
    let first_link = rows - plan.links;
    let (mut row, mut mesh, mut member) = (0, 0, meshes);
    // Share of the force that acts on each gear of each mesh, over the largest teeth.
    let mut factors: Vec<[f64; 2]> = vec![];
    for set in &plan.sets {
        let place_of_body = |body: usize| {
            row + body
                - set.centrals[..body.min(set.centrals.len())]
                    .iter()
                    .filter(|one| one.planet.is_some())
                    .count()
        };
        for &(gears, eta) in &set.meshes {
            let eta = libm::pow(eta, share);
            let [on_first, on_second] = match signs[mesh] {
                1 => [1.0, eta],
                -1 => [eta, 1.0],
                _ => [1.0, 1.0],
            };
            let [a, b] = gears.map(|gear| set.teeth(gear));
            let scale = a.max(b);
            let b = if set.is_inside(gears) { -b } else { b };
            let own = [a * on_first / scale, b * on_second / scale];
            for (gear, factor) in gears.into_iter().zip(own) {
                matrix[(place_of_body(set.body(gear)), mesh)] += factor;
            }
            factors.push(own);
            mesh += 1;
        }
        let whole = row + set.centrals.len() + set.planets.len()
            - set.centrals.iter().filter(|one| one.planet.is_some()).count();
        for (place, link) in set.members().into_iter().enumerate() {
            if place < set.centrals.len() {
                matrix[(place_of_body(set.body(c(place))), member)] += 1.0;
            }
            matrix[(whole, member)] += 1.0;
            if link > 0 {
                matrix[(first_link + link - 1, member)] -= 1.0;
            }
            member += 1;
        }
        row = whole + 1;
    }
    for (place, ([first, second], _)) in joints.iter().enumerate() {
        for (link, factor) in [(*first, 1.0), (*second, -1.0)] {
            if link > 0 {
                matrix[(first_link + link - 1, member + place)] += factor;
            }
        }
    }
    let output_speed = speeds.links[plan.output];
    let (given, known, other) = match direction {
        Direction::Drive => (1.0, plan.input, plan.output),
        Direction::BackDrive => (1.0 / output_speed, plan.output, plan.input),
    };
    right[first_link + known - 1] -= given;
    matrix[(first_link + other - 1, columns - 1)] += 1.0;
    let found = solve(matrix, &right)?;

    let other_torque = found[columns - 1];
    let (input, output) = match direction {
        Direction::Drive => (given, other_torque),
        Direction::BackDrive => (other_torque, given),
    };
    let efficiency = match direction {
        Direction::Drive => -output * output_speed,
        Direction::BackDrive => -input,
    };
    let mut largest = 1.0_f64.max(efficiency.abs());
    let (mut mesh, mut member) = (0, meshes);
    let (mut of_members, mut of_meshes) = (vec![], vec![]);
    for (set, bodies) in plan.sets.iter().zip(&speeds.bodies) {
        let carrier = speeds.links[set.carrier];
        let mut own = vec![];
        for link in set.members() {
            own.push(found[member]);
            let (torque, speed) = (found[member], speeds.links[link]);
            largest = largest.max((torque * speed).abs()).max((torque * (speed - carrier)).abs());
            member += 1;
        }
        of_members.push(own);
        let mut powers = vec![];
        for &(gears, _) in &set.meshes {
            let taken: Vec<f64> = gears
                .iter()
                .zip(factors[mesh])
                .map(|(gear, factor)| found[mesh] * factor * (bodies[set.body(*gear)] - carrier))
                .collect();
            largest = largest.max(taken[0].abs());
            powers.push([taken[0], taken[1]]);
            mesh += 1;
        }
        of_meshes.push(powers);
    }
    let mut elements = vec![0.0; plan.elements.len()];
    for (place, (_, element)) in joints.iter().enumerate() {
        if let Some(element) = element {
            elements[*element] = found[member + place];
        }
    }
    Some(Loads { members: of_members, elements, input, output, meshes: of_meshes, largest, efficiency })
}

/// Self-consistent signs, which the torques they give confirm, from these by repetition.
fn settle(
    plan: &BoxPlan,
    speeds: &Speeds,
    direction: Direction,
    mut signs: Vec<i8>,
    share: f64,
) -> Option<(Vec<i8>, Loads)> {
    for _ in 0..30 {
        let found = loads(plan, speeds, direction, &signs, share)?;
        let own = found.signs();
        if own == signs {
            return Some((signs, found));
        }
        signs = own;
    }
    None
}

/// Torques with losses: signs of the gear without losses, then losses raised step by step, signs settled at
/// each.
pub(crate) fn lossy(plan: &BoxPlan, speeds: &Speeds, direction: Direction) -> Option<(Vec<i8>, Loads)> {
    let ideal = loads(plan, speeds, direction, &vec![0; plan.mesh_count()], 1.0)?;
    let mut signs = ideal.signs();
    if let Some(found) = settle_at_once(plan, speeds, direction, &signs) {
        return Some(found);
    }
    const STEPS: u32 = 200;
    let mut last = None;
    for step in 1..=STEPS {
        let found = settle(plan, speeds, direction, signs, f64::from(step) / f64::from(STEPS))?;
        if found.1.largest > 1e6 * ideal.largest {
            return None;
        }
        signs = found.0.clone();
        last = Some(found);
    }
    last
}

fn settle_at_once(
    plan: &BoxPlan,
    speeds: &Speeds,
    direction: Direction,
    signs: &[i8],
) -> Option<(Vec<i8>, Loads)> {
    let found = loads(plan, speeds, direction, signs, 1.0)?;
    (found.signs() == signs).then(|| (signs.to_vec(), found))
}

/// Every self-consistent sign pattern, with its efficiency; meshes that roll without power once.
pub(crate) fn patterns(plan: &BoxPlan, speeds: &Speeds, direction: Direction) -> Vec<(Vec<i8>, f64)> {
    let count = plan.mesh_count();
    let mut found: Vec<(Vec<i8>, f64)> = vec![];
    for bits in 0..1_u32 << count {
        let signs: Vec<i8> = (0..count).map(|bit| if bits >> bit & 1 == 0 { 1 } else { -1 }).collect();
        let Some(own) = loads(plan, speeds, direction, &signs, 1.0) else { continue };
        let is = own.signs();
        let fits = is.iter().zip(&signs).all(|(is, sign)| *is == 0 || is == sign);
        if fits && !found.iter().any(|(known, _)| *known == is) {
            found.push((is, own.efficiency));
        }
    }
    found
}
