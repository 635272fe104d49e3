//! Gears with several inputs: power splits, summing gears, differentials.
//!
//! A gear whose state is [underdetermined](crate::State::Underdetermined) keeps `F` freedoms, more than one.
//! As many speeds, given for independent links, settle all others. Torques act from outside at the
//! *terminals*: input and output of the gear, and every link for which a speed or a torque is given; where
//! the torques given would be too many for these, also the open ends, links with a single member of a single
//! set. Of `τ` terminals the torques of `τ − F` settle the rest:
//!
//! ```text
//! C·ω = 0                 N equations of the sets, N + F speeds, F given
//! Ĉᵀ·t = Σ T              N + F balances of links, N + F unknowns: t of the sets and F of the τ torques
//! ```
//!
//! Losses take the signs continuous with `η → 1`, as in a gear with one input.

use crate::elimination::{Echelon, Scalar};
use crate::error::{InputsFault, LinkFault, OperatingFault};
use crate::network::{Loads, Network};
use crate::power_flow::{Flowing, MeshPower, PowerFlow, mesh_powers, power_flow};
use crate::solution::Run;
use crate::speeds::{SetMotion, set_motion};
use crate::state::{Known, Torques};
use crate::tolerance::LARGEST_LOAD;
use crate::topology::{Topology, bounded, fractions, node_equations, traced};
use crate::torques::{self, Members, demands, edge_torques};
use crate::{Error, Gear, Gearbox, LinkId};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Torque and power that enter at a link from outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terminal {
    /// The link.
    pub link: LinkId,
    /// Torque on it.
    pub torque: Torque,
    /// Power that enters there; negative where it leaves.
    pub power: Power,
}

/// State of a gear with several inputs. Plain numbers are speeds in rad/s and torques in N·m.
#[derive(Debug, Clone, PartialEq)]
pub struct MultiState {
    /// Freedoms of the gear, and so how many speeds were given.
    pub freedoms: usize,
    /// Speed of each link by [`LinkId::index`]; `None` where it does not follow.
    pub speeds: Vec<Option<AngularVelocity>>,
    /// Slip of each shift element.
    pub slips: Vec<Option<AngularVelocity>>,
    /// Motion of each set, in rad/s.
    pub sets: Vec<SetMotion>,
    /// Torques and powers, where torques were given.
    pub load: Option<MultiLoad>,
}

/// Torques and powers of a gear with several inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct MultiLoad {
    /// Terminals with their speeds and torques from outside, the gear's input first, its output second.
    pub terminals: Vec<Terminal>,
    /// Torque that the housing takes.
    pub housing: Torque,
    /// Torques on the members of each set in N·m, in the order of
    /// [`PlanetSet::members`](crate::PlanetSet::members).
    pub members: Vec<Vec<f64>>,
    /// Torque of each shift element on its first link; `None` where several share it.
    pub shift_elements: Vec<Option<Torque>>,
    /// Powers in W.
    pub power: PowerFlow,
    /// Power lost in the meshes.
    pub loss: Power,
    /// Power that leaves over power that enters; `None` where none enters.
    pub efficiency: Option<f64>,
    /// Signs of the segments of the gearbox.
    signs: Vec<i8>,
}

impl MultiLoad {
    /// Power through each mesh of a set of its gearbox in W, in the order of
    /// [`PlanetSet::meshes`](crate::PlanetSet::meshes); `None` where a speed does not follow.
    #[must_use]
    pub fn meshes(&self, gearbox: &Gearbox, set: usize) -> Option<Vec<MeshPower>> {
        let power = self.power.sets.get(set)?.as_ref()?;
        let from = gearbox.segments.partition_point(|segment| segment.set < set);
        let to = gearbox.segments.partition_point(|segment| segment.set <= set);
        Some(mesh_powers(gearbox.sets.get(set)?, power, self.signs.get(from..to), self.power.largest))
    }
}

/// Degrees of freedom of a gear with given links, from the ranks.
struct Freedom {
    equations: Vec<usize>,
    free: Vec<usize>,
    /// A given node that follows from the others.
    dependent: Option<usize>,
    parts: Vec<usize>,
    /// Nodes whose speed follows from nodes at rest and given ones.
    follows: Vec<bool>,
    /// Free nodes that input or output depend on and that are not given.
    missing: usize,
}

/// Torques that follow from those at the terminals.
struct Settled {
    /// Sets on the power path whose torques do not.
    open_sets: Vec<usize>,
    /// Sets that carry torque.
    loaded_sets: Vec<usize>,
    known: Known,
}

fn settled<S: Scalar>(
    gearbox: &Gearbox,
    topology: &Topology,
    ratios: Option<Vec<S>>,
    terminals: &[LinkId],
) -> Option<Settled> {
    let torques = Torques::new(gearbox, topology, &ratios?, terminals)?;
    let known = torques.known(gearbox, topology);
    let is_open = |set: &usize| {
        gearbox
            .equations_of(*set)
            .any(|equation| !known.equation(equation) && torques.on_power_path(equation))
    };
    let is_loaded = |set: &usize| gearbox.equations_of(*set).any(|equation| torques.is_loaded(equation));
    Some(Settled {
        open_sets: (0..gearbox.sets.len()).filter(is_open).collect(),
        loaded_sets: (0..gearbox.sets.len()).filter(is_loaded).collect(),
        known,
    })
}

fn freedom<S: Scalar>(topology: &Topology, ratios: Option<Vec<S>>, given: &[usize]) -> Option<Freedom> {
    let equations = node_equations(topology, ratios?.iter().map(Some))?;
    // Those given last depend on the others.
    let late: Vec<usize> = given.iter().rev().copied().collect();
    let echelon = Echelon::new(equations, topology.count, &late)?;
    let dependent = given.iter().copied().find(|node| echelon.pivots.iter().any(|(_, pivot)| pivot == node));
    let follows = (0..topology.count)
        .map(|node| echelon.dependence(node).all(|(free, _)| given.contains(&free)))
        .collect();
    let missing = |free: &&usize| {
        let terminals = [topology.input, topology.output].into_iter().flatten();
        !given.contains(free)
            && terminals.flat_map(|node| echelon.dependence(node)).any(|(other, _)| other == **free)
    };
    let missing = echelon.free.iter().filter(missing).count();
    let mut active: Vec<usize> = echelon.pivots.iter().map(|(equation, _)| *equation).collect();
    active.sort_unstable();
    Some(Freedom {
        equations: active,
        parts: echelon.parts(),
        free: echelon.free,
        dependent,
        follows,
        missing,
    })
}

impl Gearbox {
    /// Computes the state of a gear with these speeds, which must settle all its freedoms, under these
    /// torques. Without torques it computes the speeds alone.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}};
    /// use uom::si::angular_velocity::revolution_per_minute;
    /// use uom::si::f64::{AngularVelocity, Torque};
    /// use uom::si::torque::newton_meter;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// // The power split of a hybrid car: 72 % of the engine's torque goes to the ring.
    /// let gearbox = Gearbox::builder("split")
    ///     .links(["engine", "mg1", "ring"])
    ///     .set(SetSpec::teeth("PSD", SetKind::Simple, ["mg1", "ring", "engine"], 30, 78)?)
    ///     .input("engine")
    ///     .output("ring")
    ///     .gear("split", [""; 0])
    ///     .build()?;
    /// let link = |name| gearbox.link(name).unwrap();
    /// let rpm = AngularVelocity::new::<revolution_per_minute>;
    /// let state = gearbox.with_inputs(
    ///     gearbox.gear("split")?,
    ///     &[(link("engine"), rpm(2000.0)), (link("mg1"), rpm(3000.0))],
    ///     &[(link("engine"), Torque::new::<newton_meter>(108.0))],
    /// )?;
    /// let ring = state.speeds[link("ring").index()].unwrap();
    /// assert!((ring.get::<revolution_per_minute>() - (108.0 * 2000.0 - 30.0 * 3000.0) / 78.0).abs() < 1e-9);
    /// let load = state.load.unwrap();
    /// assert!((load.terminals[1].torque.get::<newton_meter>() + 78.0).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// - [`Error::Inputs`] if the speeds or torques are too few, too many or dependent; also if sets share a
    ///   torque that nothing settles, or if the mesh losses hold the gear;
    /// - [`Error::OperatingPoint`] for a value that is not a number;
    /// - [`Error::ForeignGear`] for a gear of another gearbox.
    pub fn with_inputs(
        &self,
        gear: &Gear,
        speeds: &[(LinkId, AngularVelocity)],
        torques: &[(LinkId, Torque)],
    ) -> Result<MultiState, Error> {
        self.check_gear(gear)?;
        let values = speeds.iter().map(|(_, speed)| speed.si());
        if !values
            .chain(torques.iter().map(|(_, torque)| torque.si()))
            .all(|value| value.abs() <= LARGEST_LOAD)
        {
            return Err(Error::OperatingPoint { why: OperatingFault::NoNumbers });
        }
        let topology = Topology::new(self, gear);
        let given = self.given_nodes(&topology, speeds.iter().map(|(link, _)| *link), true)?;
        let nodes: Vec<usize> = given.iter().map(|(_, node)| *node).collect();
        let freedom = freedom(&topology, Some(bounded(self)), &nodes)
            .or_else(|| freedom(&topology, fractions(self), &nodes))
            .or_else(|| freedom(&topology, traced(self), &nodes))
            .unwrap_or_else(|| {
                unreachable!("a number is a rational, and rationals of any size do not overflow")
            });
        self.check_speeds(&topology, &given, &freedom)?;

        // Parts that nothing given moves carry no torque: their free speeds are held.
        let mut slot: Vec<Option<usize>> = vec![None; topology.count];
        let mut count = 0;
        for (node, slot) in slot.iter_mut().enumerate() {
            if nodes.contains(&node) || !freedom.free.contains(&node) {
                *slot = Some(count);
                count += 1;
            }
        }
        let place = |node: Option<usize>| node.and_then(|node| slot[node]);
        let network = Network {
            nodes: freedom.equations.iter().map(|&one| topology.equations[one].map(place)).collect(),
            ratios: freedom.equations.iter().map(|&one| self.equations[one].ratio).collect(),
            runs: vec![],
            etas: vec![],
            count,
            least_pivot: 0.0,
        };
        let values: Vec<f64> = speeds.iter().map(|(_, speed)| speed.si()).collect();
        let at: Vec<(usize, f64)> =
            nodes.iter().zip(&values).filter_map(|(&node, &speed)| Some((slot[node]?, speed))).collect();
        let solved = network.speeds(&at).ok_or(InputsFault::DependentTorques { candidates: vec![] })?;
        let of_node =
            |node: usize| freedom.follows[node].then(|| slot[node].map(|slot| solved[slot])).flatten();
        let omega: Vec<Option<f64>> =
            topology.node.iter().map(|node| node.map_or(Some(0.0), of_node)).collect();
        let slip = |(place, shift_element): (usize, &crate::ShiftElement)| {
            if gear.engaged.contains(&place) {
                return Some(AngularVelocity::from_si(0.0));
            }
            Some(AngularVelocity::from_si(
                omega[shift_element.links[0].0]? - omega[shift_element.links[1].0]?,
            ))
        };
        let state = MultiState {
            freedoms: nodes.len(),
            speeds: omega.iter().map(|omega| omega.map(AngularVelocity::from_si)).collect(),
            slips: self.shift_elements.iter().enumerate().map(slip).collect(),
            sets: self.sets.iter().map(|set| set_motion(set, &omega)).collect(),
            load: None,
        };
        if torques.is_empty() {
            return Ok(state);
        }
        let load =
            self.multi_load(&topology, gear, network, &freedom, (&solved, &slot), &omega, &given, torques)?;
        Ok(MultiState { load: Some(load), ..state })
    }

    /// Links with their nodes; refuses the housing and two on one node.
    fn given_nodes(
        &self,
        topology: &Topology,
        links: impl Iterator<Item = LinkId>,
        must_differ: bool,
    ) -> Result<Vec<(LinkId, usize)>, Error> {
        let mut found: Vec<(LinkId, usize)> = vec![];
        for link in links {
            let refuse =
                |why| Error::Inputs(InputsFault::Link { link: self.link_name(link).to_owned(), why });
            if link.0 >= self.links.len() {
                return Err(Error::ForeignGear { gear: format!("link {}", link.0) });
            }
            let Some(node) = topology.node[link.0] else {
                return Err(refuse(LinkFault::Held));
            };
            if must_differ && found.iter().any(|(_, other)| *other == node) {
                return Err(refuse(LinkFault::OnePiece));
            }
            found.push((link, node));
        }
        Ok(found)
    }

    fn check_speeds(
        &self,
        topology: &Topology,
        given: &[(LinkId, usize)],
        freedom: &Freedom,
    ) -> Result<(), Error> {
        if let Some(dependent) = freedom.dependent {
            let link = given.iter().find(|(_, node)| *node == dependent);
            let link = link.map(|(link, _)| self.link_name(*link).to_owned()).unwrap_or_default();
            return Err(InputsFault::DependentSpeed { link }.into());
        }
        let touched: Vec<usize> = [topology.input, topology.output]
            .into_iter()
            .flatten()
            .chain(given.iter().map(|(_, node)| *node))
            .map(|node| freedom.parts[node])
            .collect();
        if freedom.missing == 0 {
            return Ok(());
        }
        let is_open = |node: usize| touched.contains(&freedom.parts[node]) && !freedom.follows[node];
        let candidates = (1..self.links.len())
            .filter(|&link| topology.node[link].is_some_and(is_open))
            .map(|link| self.links[link].clone())
            .collect();
        let needed = given.len() + freedom.missing;
        Err(InputsFault::TooFewSpeeds { given: given.len(), needed, candidates }.into())
    }

    /// Moving links with a single member of a single set, which nothing else joins: shafts that lead out.
    fn open_ends(
        &self,
        topology: &Topology,
        omega: &[Option<f64>],
        terminals: &[(LinkId, usize, Option<f64>)],
    ) -> Vec<(LinkId, usize, Option<f64>)> {
        let mut members = vec![0_usize; topology.count];
        for link in self.sets.iter().flat_map(crate::PlanetSet::members) {
            if let Some(node) = topology.node[link.0] {
                members[node] += 1;
            }
        }
        let open = |link: usize| {
            let node = topology.node[link]?;
            let is_open = members[node] == 1
                && omega[link].is_some()
                && self.sets.iter().any(|set| set.members().contains(&LinkId(link)))
                && !terminals.iter().any(|(_, other, _)| *other == node);
            is_open.then_some((LinkId(link), node, None))
        };
        (1..self.links.len()).filter_map(open).collect()
    }

    #[allow(clippy::too_many_arguments, reason = "one step of `with_inputs`, with what it has found")]
    fn multi_load(
        &self,
        topology: &Topology,
        gear: &Gear,
        mut network: Network,
        freedom: &Freedom,
        (solved, slot): (&[f64], &[Option<usize>]),
        omega: &[Option<f64>],
        given: &[(LinkId, usize)],
        given_torques: &[(LinkId, Torque)],
    ) -> Result<MultiLoad, Error> {
        let torque_nodes = self.given_nodes(topology, given_torques.iter().map(|(link, _)| *link), false)?;
        // One terminal a node, the gear's own first; these are two even where a clutch makes them one node.
        let mut terminals: Vec<(LinkId, usize, Option<f64>)> = vec![];
        for link in [gear.input, gear.output] {
            let Some(node) = topology.node[link.0] else { continue };
            if !terminals.iter().any(|(other, ..)| *other == link) {
                terminals.push((link, node, None));
            }
        }
        for &(link, node) in given.iter().chain(&torque_nodes) {
            if !terminals.iter().any(|(_, other, _)| *other == node) {
                terminals.push((link, node, None));
            }
        }
        for ((link, node), (_, given)) in torque_nodes.iter().zip(given_torques) {
            let place = terminals.iter().position(|(other, ..)| other == link);
            let place = place.or_else(|| terminals.iter().position(|(_, other, _)| other == node));
            if let Some((.., torque)) = place.map(|place| &mut terminals[place]) {
                *torque = Some(torque.unwrap_or(0.0) + given.si());
            }
        }
        let known = terminals.iter().filter(|(.., torque)| torque.is_some()).count();
        // Too many torques mean that power passes at the open ends too.
        let ends = self.open_ends(topology, omega, &terminals);
        if known + given.len() == terminals.len() + ends.len() {
            terminals.extend(ends);
        }
        let names =
            || terminals.iter().map(|(link, ..)| self.link_name(*link).to_owned()).collect::<Vec<_>>();
        let known = terminals.iter().filter(|(.., torque)| torque.is_some()).count();
        let needed = terminals.len().saturating_sub(given.len());
        if known != needed {
            return Err(InputsFault::Torques { given: known, needed, candidates: names() }.into());
        }
        let links: Vec<LinkId> = terminals.iter().map(|(link, ..)| *link).collect();
        let settled = settled(self, topology, Some(bounded(self)), &links)
            .or_else(|| settled(self, topology, fractions(self), &links))
            .or_else(|| settled(self, topology, traced(self), &links))
            .unwrap_or_else(|| {
                unreachable!("a number is a rational, and rationals of any size do not overflow")
            });
        if !settled.open_sets.is_empty() {
            let sets = settled.open_sets.iter().map(|&set| self.sets[set].id().to_owned()).collect();
            return Err(InputsFault::SharedTorques { sets }.into());
        }
        // The loss of a loaded set does not follow while a member's speed does not.
        let is_adrift = |link: &usize| {
            let is_member = |set: &usize| self.sets[*set].members().iter().any(|member| member.0 == *link);
            omega[*link].is_none() && settled.loaded_sets.iter().any(is_member)
        };
        let candidates: Vec<String> =
            (1..self.links.len()).filter(is_adrift).map(|link| self.links[link].clone()).collect();
        if !candidates.is_empty() {
            let needed = given.len() + 1;
            return Err(InputsFault::TooFewSpeeds { given: given.len(), needed, candidates }.into());
        }
        for segment in &self.segments {
            let from = freedom.equations.partition_point(|&one| one < segment.behind.start);
            let to = freedom.equations.partition_point(|&one| one < segment.behind.end);
            // A segment without an active equation carries nothing; it keeps its place.
            network.runs.push(Run { from, to });
            network.etas.push(segment.efficiency);
        }
        let active: Vec<usize> = (0..network.runs.len())
            .filter(|&place| network.runs[place].from < network.runs[place].to)
            .collect();
        network.runs = active.iter().map(|&place| network.runs[place]).collect();
        network.etas = active.iter().map(|&place| network.etas[place]).collect();
        let at: Vec<(usize, Option<f64>)> =
            terminals.iter().filter_map(|(_, node, torque)| Some((slot[*node]?, *torque))).collect();
        let loads = Loads { network: &network, speeds: solved, terminals: &at };
        let ideal = loads
            .balance(&network.ratios)
            .ok_or_else(|| InputsFault::DependentTorques { candidates: names() })?;
        let (found, _, active_signs) = loads.branch(&ideal);
        let found = found.ok_or(InputsFault::SelfLocking)?;
        let Members { sets: members, signs } = torques::members(
            self,
            [&freedom.equations, &active],
            [&found.root, &found.effective],
            &active_signs,
        );
        let outside: Vec<(LinkId, f64)> =
            terminals.iter().zip(&found.terminals).map(|((link, ..), torque)| (*link, *torque)).collect();
        let mut demand = demands(self, &members);
        for &(link, torque) in &outside {
            demand[link.0] -= torque;
        }
        let edges = edge_torques(topology, &settled.known, demand);
        let mut shift_elements = vec![Some(Torque::from_si(0.0)); self.shift_elements.len()];
        for (edge, own) in topology.edges.iter().zip(&edges) {
            if let Some(shift_element) = edge.shift_element {
                shift_elements[shift_element] = own.map(Torque::from_si);
            }
        }
        let known_members: Vec<Option<Vec<f64>>> = members.iter().cloned().map(Some).collect();
        let flow = power_flow(&Flowing {
            gearbox: self,
            topology,
            speeds: omega,
            members: &known_members,
            edges: &edges,
            terminals: &outside,
            least: 0.0,
        });
        let entering = |&(link, torque): &(LinkId, f64)| torque * omega[link.0].unwrap_or(0.0);
        let powers: Vec<f64> = outside.iter().map(entering).collect();
        let enters: f64 = powers.iter().filter(|power| **power > 0.0).sum();
        let leaves: f64 = -powers.iter().filter(|power| **power < 0.0).sum::<f64>();
        Ok(MultiLoad {
            terminals: outside
                .iter()
                .zip(&powers)
                .map(|(&(link, own), &entering)| Terminal {
                    link,
                    torque: Torque::from_si(own),
                    power: Power::from_si(entering),
                })
                .collect(),
            housing: Torque::from_si(-outside.iter().map(|(_, torque)| torque).sum::<f64>()),
            members,
            shift_elements,
            loss: Power::from_si(flow.sets.iter().flatten().map(|set| set.loss).sum()),
            power: flow,
            efficiency: (enters > 0.0).then(|| leaves / enters),
            signs,
        })
    }
}
