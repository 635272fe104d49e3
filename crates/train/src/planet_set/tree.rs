//! The tree of a set's meshes, as the solver walks it from the root.

use super::{Behind, Central, Description, GearOf, Mesh};
use crate::Error;
use crate::error::CompoundFault;
use crate::site::SetPart;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::Fraction;

/// Equations and segments of a set.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tree {
    /// Place of the central gear of reference.
    pub(crate) root: usize,
    /// The central gear of each equation.
    pub(crate) order: Vec<usize>,
    /// `i_c` of each equation.
    pub(crate) ratios: Vec<f64>,
    /// `i_c` of each equation as a fraction, of tooth counts or of decimals.
    pub(crate) rationals: Vec<Option<Fraction>>,
    /// `i_c` of each equation as a fraction of tooth counts alone.
    pub(crate) exact: Vec<Option<Fraction>>,
    /// Meshes that carry power in the same direction.
    pub(crate) segments: Vec<Segment>,
    /// Equations behind each mesh, as seen from the root.
    pub(crate) behind: Vec<Behind>,
    /// Segment of each mesh, and the mesh's place in it; `None` if nothing is behind the mesh.
    pub(crate) in_segment: Vec<Option<(usize, usize)>>,
}

/// Meshes with the same central gears behind them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Segment {
    /// The equations behind it.
    pub(crate) behind: Behind,
    /// Product over its meshes.
    pub(crate) efficiency: f64,
    /// The meshes, outwards.
    pub(crate) meshes: Vec<usize>,
}

/// A walk through the tree.
struct Walk<'a> {
    description: &'a Description,
    root: usize,
    centrals: &'a [Central],
    meshes: &'a mut [Mesh],
    seen: Vec<bool>,
    order: Vec<usize>,
    behind: Vec<Option<Behind>>,
    outwards: Vec<usize>,
}

impl Walk<'_> {
    fn body(&self, gear: GearOf) -> usize {
        match gear {
            GearOf::Central(central) => self.centrals[central].body,
            GearOf::Planet(planet, _) => self.centrals.len() + planet,
        }
    }

    fn fault(&self, fault: CompoundFault) -> Error {
        Error::Compound { set: self.description.id().to_owned(), fault }
    }

    /// Names of the gears of a mesh; only a compound set can have a wrong one.
    fn ends_of(&self, mesh: usize) -> [String; 2] {
        match self.description {
            Description::Compound(spec) => spec.meshes[mesh].between.clone(),
            Description::Short(_) => [String::new(), String::new()],
        }
    }

    fn name_of(&self, body: usize) -> String {
        match self.description {
            Description::Compound(spec) => match body.checked_sub(self.centrals.len()) {
                Some(planet) => spec.planets[planet].name.clone(),
                None => spec.centrals[body].name.clone(),
            },
            Description::Short(_) => String::new(),
        }
    }

    fn visit(&mut self, body: usize) -> Result<(), (SetPart, Error)> {
        self.seen[body] = true;
        for (place, central) in self.centrals.iter().enumerate() {
            if central.body == body && place != self.root {
                self.order.push(place);
            }
        }
        for mesh in 0..self.meshes.len() {
            if self.behind[mesh].is_some() {
                continue;
            }
            let gears = self.meshes[mesh].gears;
            let place = match gears.map(|gear| self.body(gear)) {
                [one, _] if one == body => 1,
                [_, other] if other == body => 0,
                _ => continue,
            };
            if place == 0 {
                self.meshes[mesh].gears.swap(0, 1);
            }
            let next = self.body(gears[place]);
            if self.seen[next] {
                let [first, second] = self.ends_of(mesh);
                return Err((SetPart::Mesh(mesh), self.fault(CompoundFault::Loop { first, second })));
            }
            let from = self.order.len();
            // Marked before the walk goes on, so that it does not come back this way.
            self.behind[mesh] = Some(from..from);
            self.outwards.push(mesh);
            self.visit(next)?;
            self.behind[mesh] = Some(from..self.order.len());
        }
        Ok(())
    }
}

impl Tree {
    /// Walks the meshes of a set; turns each so that its first gear is the one nearer to the root.
    pub(super) fn new(
        description: &Description,
        root: usize,
        centrals: &[Central],
        planets: usize,
        meshes: &mut [Mesh],
        whole: Option<MeshEfficiency>,
    ) -> Result<Self, (SetPart, Error)> {
        let bodies = centrals.len() + planets;
        let count = meshes.len();
        let mut walk = Walk {
            description,
            root,
            centrals,
            meshes,
            seen: vec![false; bodies],
            order: vec![],
            behind: vec![None; count],
            outwards: vec![],
        };
        walk.visit(centrals[root].body)?;
        let own = |body: &usize| *body >= centrals.len() || centrals[*body].body == *body;
        if let Some(body) = (0..bodies).filter(own).find(|&body| !walk.seen[body]) {
            let name = walk.name_of(body);
            let part = match body.checked_sub(centrals.len()) {
                Some(planet) => SetPart::Planet(planet),
                None => SetPart::Central(body),
            };
            return Err((part, walk.fault(CompoundFault::Apart { name })));
        }
        let (order, outwards) = (walk.order, walk.outwards);
        let behind: Vec<Behind> = walk.behind.into_iter().map(Option::unwrap_or_default).collect();
        let mut segments: Vec<Segment> = vec![];
        for mesh in outwards {
            if behind[mesh].is_empty() {
                continue;
            }
            let eta = meshes[mesh].efficiency.get();
            match segments.iter_mut().find(|segment| segment.behind == behind[mesh]) {
                Some(segment) => {
                    segment.efficiency *= eta;
                    segment.meshes.push(mesh);
                }
                None => {
                    segments.push(Segment {
                        behind: behind[mesh].clone(),
                        efficiency: eta,
                        meshes: vec![mesh],
                    });
                }
            }
        }
        if let (Some(whole), [only]) = (whole, segments.as_mut_slice()) {
            only.efficiency = whole.get();
        }
        let in_segment = (0..count)
            .map(|mesh| {
                let of = |(place, one): (usize, &Segment)| {
                    Some((place, one.meshes.iter().position(|&other| other == mesh)?))
                };
                segments.iter().enumerate().find_map(of)
            })
            .collect();
        Ok(Self {
            root,
            order,
            ratios: vec![],
            rationals: vec![],
            exact: vec![],
            segments,
            behind,
            in_segment,
        })
    }

    /// The equation of a central gear; none of the root.
    pub(crate) fn place(&self, central: usize) -> Option<usize> {
        self.order.iter().position(|&one| one == central)
    }
}
