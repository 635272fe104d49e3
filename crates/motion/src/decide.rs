//! Decision which elements hold and which slip from a moment on.
//!
//! Elements and lossy sets whose slip is not 0 go on as they do. The others have three ways each: stuck,
//! forwards, backwards; a one-way clutch has two. Every combination is tried. Those that release the fewest
//! stuck elements come first, then those with the most stuck elements. A combination is consistent under
//! these conditions:
//!
//! ```text
//! stuck        |λ| ≤ κ·C, and λ ≥ 0 of a one-way clutch
//! forwards     ds/dt > 0          backwards   ds/dt < 0
//! power        through each lossy mesh in the direction that was assumed
//! ```
//!
//! Without losses and with `κ = 1` the accelerations minimize the strictly convex
//! `½·(q̈ − a)ᵀ·M·(q̈ − a) + Σ C·abs(ds/dt)`, so that only one motion is consistent. With `κ > 1` several may
//! be consistent. A stuck element is then released only if nothing else is consistent, and an element that
//! comes to rest holds if it can, which is the hysteresis of static friction. An element that has just
//! exceeded its capacity does not hold again at that moment.
//!
//! If several elements that share their torque reach their capacities at once, all accelerations are still 0
//! at that moment. So they do not show which elements slip. The torques and capacities a little later then
//! decide; an element below its capacity goes on to hold, if that is consistent.
//!
//! The meshes of a set at rest are elements, too. The set starts to roll if the losses of that direction let
//! it, and is held by friction if neither direction does. An element that has exceeded its capacity then
//! *yields*: it carries its capacity without slip, and mesh friction carries the rest. If stuck elements make
//! a set a block, the share of friction within it in the torque is not determined, and the block is assumed
//! to have no losses.

use crate::Error;
use crate::field::{Field, Trigger, push};
use crate::model::{Kind, Model};
use crate::pattern::{Pattern, System, Way};
use crate::tolerance::{ACCELERATION, MOST_AT_REST, MOST_LOSSY_MESHES, PATTERN, RANK, SLIP};
use epicyclic_numerics::linear::independent;
use epicyclic_numerics::values::{dot, largest_absolute};
use epicyclic_train::GROUND;
use rustc_hash::FxHashMap;

/// An element that slips from now on in this direction, since it could not hold.
pub(crate) type Loosed = (usize, Way);

/// Uniqueness of the motion under a pattern, by stuck elements and moving sets.
pub(crate) type Unique = FxHashMap<(Vec<Way>, Vec<Way>), Result<(), Error>>;

/// The state at which it is decided, and what was before.
pub(crate) struct Moment<'s> {
    pub(crate) t: f64,
    pub(crate) y: &'s [f64],
    /// The largest speed so far.
    pub(crate) speed_scale: f64,
    pub(crate) loosed: &'s [Loosed],
    /// Time to look ahead if the moment itself does not decide, in s.
    pub(crate) ahead: f64,
    /// Torques that the elements held before, for elements that yield and may go on to do so in this
    /// direction.
    pub(crate) held: Option<&'s [f64]>,
}

/// Open elements and sets of a moment.
struct Open {
    elements: Vec<usize>,
    sets: Vec<usize>,
}

impl Field<'_> {
    /// Elements without slip that carry friction, engaged dog clutches, and lossy sets that do not roll.
    pub(crate) fn at_rest(&self, y: &[f64], speed_scale: f64) -> (Vec<usize>, Vec<usize>) {
        let zero = SLIP * speed_scale;
        let elements = (0..self.model.elements.len())
            .filter(|&place| !self.is_idle[place] && self.slip(place, y).abs() <= zero)
            .filter(|&place| !self.is_dog(place) || self.pattern.elements[place] == Way::Stuck);
        let sets = self.model.mechanism.sets.iter().enumerate();
        let sets = sets.filter(|(_, set)| set.is_lossy && dot(&set.rolling, y).abs() <= zero);
        (elements.collect(), sets.map(|(place, _)| place).collect())
    }

    /// Finds the pattern that is consistent at a moment, and takes it.
    pub(crate) fn decide(&mut self, moment: &Moment, unique: &mut Unique) -> Result<(), Error> {
        self.speed_scale = moment.speed_scale;
        let (mut elements, sets) = self.at_rest(moment.y, moment.speed_scale);
        // They hold or not as they are engaged.
        elements.retain(|&place| !self.is_dog(place));
        let given = elements.len() + sets.len();
        if given > MOST_AT_REST {
            let (parts, _) = self.named(&elements, &sets);
            return Err(Error::TooManyAtRest { parts, given, most: MOST_AT_REST, time_s: moment.t });
        }
        let open = Open { elements, sets };
        let mut base = self.pattern.clone();
        for (place, way) in base.elements.iter_mut().enumerate() {
            if self.is_dog(place) {
                continue;
            }
            let slip = self.slip(place, moment.y);
            *way = if self.is_idle[place] { Way::Open } else { Way::of(slip) };
            let one = &self.model.elements[place];
            if matches!(one.kind, Kind::OneWay) && *way == Way::Backward && !open.elements.contains(&place) {
                return Err(Error::InitialSlip { element: one.name.clone(), slip });
            }
        }
        for (way, set) in base.sets.iter_mut().zip(&self.model.mechanism.sets) {
            *way = if set.is_lossy { Way::of(dot(&set.rolling, moment.y)) } else { Way::Open };
        }
        let was_stuck: Vec<bool> =
            open.elements.iter().map(|&place| self.pattern.elements[place] == Way::Stuck).collect();
        let mut refused = None;
        let mut best: Option<(f64, Pattern)> = None;
        let (later, held, firm) = match moment.loosed {
            [] => (vec![], vec![], vec![]),
            _ => (self.later(moment, &open), self.elements.clone(), self.firm(moment, &open)),
        };
        let ahead =
            Moment { t: moment.t + moment.ahead, y: &later, loosed: &[], held: Some(&held), ..*moment };
        let is_shared = moment.loosed.len() > 1 || !self.system.independent.others.is_empty();
        let passes: &[(&Moment, &[Loosed], &[usize])] = match moment.loosed {
            [] => &[(moment, &[], &[])],
            loosed if is_shared => {
                &[(&ahead, &[], &firm), (&ahead, &[], &[]), (moment, loosed, &[]), (moment, &[], &[])]
            }
            loosed => &[(moment, loosed, &[]), (&ahead, &[], &[]), (moment, &[], &[])],
        };
        for &(seen, loosed, firm) in passes {
            let is_ahead = seen.t != moment.t;
            for ways in self.combinations(&open, loosed, firm, &was_stuck) {
                let mut candidate = base.clone();
                for (&place, &way) in open.elements.iter().zip(&ways) {
                    candidate.elements[place] = way;
                }
                for assumed in self.rolling(&candidate, &open.sets) {
                    let found = self.violation(assumed, &open, seen, loosed, unique, &mut refused);
                    let Some((violation, pattern)) = found else { continue };
                    if violation == 0.0 && is_ahead {
                        return self.take(pattern, moment, unique);
                    }
                    if violation == 0.0 {
                        // It is the one solved last.
                        return Ok(());
                    }
                    if is_ahead {
                        continue;
                    }
                    if best.as_ref().is_none_or(|(least, _)| violation < *least) {
                        best = Some((violation, pattern));
                    }
                }
            }
            if best.as_ref().is_some_and(|(least, _)| *least <= PATTERN) {
                break;
            }
        }
        match (best, refused) {
            // What slips instead of holding would do so without any slip, which is no answer.
            (_, Some(open @ Error::OpenSplit { .. })) => Err(open),
            (Some((violation, pattern)), _) if violation <= PATTERN => self.take(pattern, moment, unique),
            (_, Some(refused)) => Err(refused),
            (best, None) => {
                let (parts, links) = self.named(&open.elements, &open.sets);
                let violation = best.map(|(violation, _)| violation);
                Err(Error::NoMotion { time_s: moment.t, parts, links, violation })
            }
        }
    }

    /// Names of elements and sets, and of their links.
    pub(crate) fn named(&self, elements: &[usize], sets: &[usize]) -> (Vec<String>, Vec<String>) {
        let Model { mechanism, elements: all, .. } = self.model;
        let names = elements.iter().map(|&place| all[place].name.clone());
        let names = names.chain(sets.iter().map(|&set| mechanism.sets[set].name.clone())).collect();
        let places = elements.iter().flat_map(|&place| all[place].places);
        let of_sets = sets.iter().flat_map(|&set| [mechanism.sets[set].root, mechanism.sets[set].carrier]);
        let mut links: Vec<String> = vec![];
        for place in places.chain(of_sets) {
            let name = place.map_or(GROUND, |node| mechanism.node_name(node));
            if !links.iter().any(|link| link == name) {
                links.push(name.to_owned());
            }
        }
        (names, links)
    }

    /// Stuck elements that hold less than they can.
    fn firm(&self, moment: &Moment, open: &Open) -> Vec<usize> {
        let most = |place: usize| self.static_capacity(place, moment.t).unwrap_or(0.0);
        let spare = |place: usize| most(place) - self.elements[place].abs() > PATTERN * self.torque_scale;
        let is_firm = |&place: &usize| self.pattern.elements[place] == Way::Stuck && spare(place);
        open.elements.iter().copied().filter(is_firm).collect()
    }

    /// The state a little later: twists of shafts, whose torques are what may be about to exceed a capacity,
    /// and speeds as long as what is without slip remains so.
    fn later(&self, moment: &Moment, open: &Open) -> Vec<f64> {
        let mut later = moment.y.to_vec();
        let rates = &self.accelerations;
        later.iter_mut().zip(rates).for_each(|(speed, rate)| *speed += moment.ahead * rate);
        let (elements, sets) = self.at_rest(&later, moment.speed_scale);
        let remains = open.elements.iter().all(|place| elements.contains(place))
            && open.sets.iter().all(|place| sets.contains(place));
        if !remains {
            later.copy_from_slice(moment.y);
        }
        for (twist, one) in later[self.parts.twist..].iter_mut().zip(&self.model.shafts) {
            *twist += moment.ahead * dot(&one.rate, moment.y);
        }
        later
    }

    /// Ways of the open elements: first those that let go of the fewest that were stuck, then those with the
    /// most stuck.
    fn combinations(
        &self,
        open: &Open,
        loosed: &[Loosed],
        firm: &[usize],
        was_stuck: &[bool],
    ) -> Vec<Vec<Way>> {
        let options = |&place: &usize| match loosed.iter().find(|(one, _)| *one == place) {
            Some((_, way)) => vec![*way],
            None if firm.contains(&place) => vec![Way::Stuck],
            // Its links never turn against each other.
            None if largest_absolute(&self.model.elements[place].slip) <= RANK => vec![Way::Stuck],
            None if matches!(self.model.elements[place].kind, Kind::OneWay) => vec![Way::Stuck, Way::Forward],
            None => vec![Way::Stuck, Way::Forward, Way::Backward],
        };
        let mut all = product(&open.elements.iter().map(options).collect::<Vec<_>>());
        all.sort_by_key(|ways| {
            let moving = || ways.iter().zip(was_stuck).filter(|(way, _)| **way != Way::Stuck);
            (moving().filter(|(_, was_stuck)| **was_stuck).count(), moving().count())
        });
        all
    }

    /// Patterns with ways of the sets that do not roll: moving ones first, so that friction holds only where
    /// nothing moves.
    ///
    /// A set whose rolling depends on what is stuck is a block. Of sets that roll together one leads.
    fn rolling(&self, candidate: &Pattern, sets: &[usize]) -> Vec<Pattern> {
        if sets.is_empty() {
            return vec![candidate.clone()];
        }
        let stuck: Vec<usize> = candidate.stuck().collect();
        let slips = stuck.iter().map(|&place| self.model.elements[place].slip.as_slice());
        let rolling = sets.iter().map(|&set| self.model.mechanism.sets[set].rolling.as_slice());
        let found = independent(&slips.chain(rolling).collect::<Vec<_>>(), RANK);
        let leaders: Vec<usize> = found
            .kept
            .iter()
            .filter_map(|place| place.checked_sub(stuck.len()))
            .map(|one| sets[one])
            .collect();
        let options = vec![vec![Way::Forward, Way::Backward, Way::Stuck]; leaders.len()];
        let mut all = product(&options);
        all.sort_by_key(|ways| ways.iter().filter(|way| **way == Way::Stuck).count());
        let with = |ways: Vec<Way>| {
            let mut pattern = candidate.clone();
            for (place, made) in &found.others {
                let Some(one) = place.checked_sub(stuck.len()) else { continue };
                // The sign of a sum is that of its largest part; where another would be right the
                // accelerations tell.
                let mut most = 0.0_f64;
                for (factor, kept) in made.iter().zip(&found.kept) {
                    let leader = kept.checked_sub(stuck.len());
                    let place = leader.and_then(|leader| leaders.iter().position(|&set| set == sets[leader]));
                    let part = place.map_or(0.0, |place| factor * ways[place].sign());
                    if part.abs() > most.abs() && part.abs() > RANK {
                        most = part;
                    }
                }
                pattern.sets[sets[one]] = if most == 0.0 { Way::Open } else { Way::of(most) };
            }
            for (&set, &way) in leaders.iter().zip(&ways) {
                pattern.sets[set] = way;
            }
            pattern
        };
        all.into_iter().map(with).collect()
    }

    /// Violation of a pattern, over the largest torque or acceleration, with its mesh powers settled.
    fn violation(
        &mut self,
        assumed: Pattern,
        open: &Open,
        moment: &Moment,
        loosed: &[Loosed],
        unique: &mut Unique,
        refused: &mut Option<Error>,
    ) -> Option<(f64, Pattern)> {
        self.pattern = assumed;
        match self.settle(moment, unique) {
            Ok(true) => {}
            Ok(false) => return None,
            Err(error) => {
                refused.get_or_insert(error);
                return None;
            }
        }
        let mut worst = 0.0_f64;
        for (trigger, margin) in self.triggers.iter().zip(&self.margins) {
            if let Trigger::Exceeds(_) | Trigger::LetsGo(_) = trigger
                && *margin < 0.0
            {
                worst = worst.max(-margin / self.torque_scale);
            }
        }
        let speeds = &self.model.mechanism.speeds;
        let scale =
            largest_absolute((0..speeds.rows()).map(|body| dot(speeds.row(body), &self.accelerations)));
        let starts = |way: Way, row: &[f64], is_loosed: bool| {
            if way.sign() == 0.0 {
                return 0.0;
            }
            let part = if scale > 0.0 { way.sign() * dot(row, &self.accelerations) / scale } else { 0.0 };
            // One that has just been loosed begins with nothing; any other must move away.
            let due = if is_loosed { -ACCELERATION } else { ACCELERATION };
            (due - part).max(0.0)
        };
        for &place in &open.elements {
            let way = self.pattern.elements[place];
            let goes_on = |held: &[f64]| self.yields[place] && way.sign() * held[place] <= 0.0;
            let is_loosed = loosed.iter().any(|(one, _)| *one == place) || moment.held.is_some_and(goes_on);
            let due = match (self.yields[place], is_loosed) {
                // What accelerations there are is rounding.
                (true, true) => 0.0,
                (true, false) => ACCELERATION,
                (false, _) => starts(way, &self.model.elements[place].slip, is_loosed),
            };
            worst = worst.max(due);
        }
        for &set in &open.sets {
            worst = worst.max(starts(self.pattern.sets[set], &self.model.mechanism.sets[set].rolling, false));
        }
        Some((worst, self.pattern.clone()))
    }

    /// Finds the directions of the mesh powers under the ways of elements and sets; false where none are
    /// consistent.
    fn settle(&mut self, moment: &Moment, unique: &mut Unique) -> Result<bool, Error> {
        let lossy: Vec<usize> = self.lossy_meshes().collect();
        if lossy.len() > MOST_LOSSY_MESHES {
            return Err(Error::TooManyMeshes { given: lossy.len(), most: MOST_LOSSY_MESHES });
        }
        if !self.solve(moment) {
            // Nothing follows from this pattern; if losses are to blame, that is the answer.
            return if lossy.is_empty() { Ok(false) } else { self.check_unique(unique).map(|()| false) };
        }
        if lossy.is_empty() {
            return Ok(true);
        }
        self.check_unique(unique)?;
        self.check_redundant(&lossy, moment.t)?;
        for _ in 0..2 * lossy.len() + 2 {
            if !self.turn_meshes() {
                return Ok(true);
            }
            if !self.solve(moment) {
                break;
            }
        }
        for signs in 0..1_u32 << lossy.len() {
            for (bit, &mesh) in lossy.iter().enumerate() {
                self.pattern.meshes[mesh] = if signs >> bit & 1 == 0 { 1 } else { -1 };
            }
            if self.solve(moment) && !self.turn_meshes() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Turns the assumed directions that the torques contradict; false if all agree.
    fn turn_meshes(&mut self) -> bool {
        let mut any = false;
        for (trigger, margin) in self.triggers.iter().zip(&self.margins) {
            if let Trigger::Reverses(mesh) = trigger
                && *margin < 0.0
            {
                self.pattern.meshes[*mesh] *= -1;
                any = true;
            }
        }
        any
    }

    /// Meshes whose losses count under the pattern.
    fn lossy_meshes(&self) -> impl Iterator<Item = usize> + '_ {
        let meshes = &self.model.mechanism.meshes;
        (0..meshes.len())
            .filter(|&mesh| meshes[mesh].is_lossy() && self.pattern.sets[meshes[mesh].set].sign() != 0.0)
    }

    /// Solves the equations of motion under the pattern and measures its margins.
    fn solve(&mut self, moment: &Moment) -> bool {
        let Some(system) = System::new(self.model, &self.pattern) else { return false };
        self.system = system;
        let mut rates = vec![0.0; self.parts.size];
        self.evaluate(moment.t, moment.y, &mut rates);
        self.torque_scale = self.torque_scale.max(self.largest_torque());
        self.find_triggers();
        self.measure(moment.t, moment.y);
        true
    }

    /// Takes a consistent pattern.
    fn take(&mut self, pattern: Pattern, moment: &Moment, unique: &mut Unique) -> Result<(), Error> {
        self.pattern = pattern;
        // The system of another candidate may have been solved since.
        self.solve(moment);
        if self.lossy_meshes().next().is_some() { self.check_unique(unique) } else { Ok(()) }
    }

    /// Refuses losses under which the determinant of the loaded mass matrix has not one sign.
    fn check_unique(&self, unique: &mut Unique) -> Result<(), Error> {
        let key = (
            self.pattern
                .elements
                .iter()
                .map(|&way| if way == Way::Stuck { way } else { Way::Open })
                .collect(),
            self.pattern
                .sets
                .iter()
                .map(|&way| if way == Way::Backward { Way::Forward } else { way })
                .collect(),
        );
        if let Some(known) = unique.get(&key) {
            return known.clone();
        }
        let found = self.find_unique();
        unique.insert(key, found.clone());
        found
    }

    /// Refuses stuck elements whose torques could be split otherwise and load a mesh that loses power: the
    /// losses would follow the split, which is not determined.
    ///
    /// A split that stays in balance is 1 on a dependent element and what this takes from the independent
    /// ones.
    fn check_redundant(&self, lossy: &[usize], time_s: f64) -> Result<(), Error> {
        let System { stuck, independent, meshes, .. } = &self.system;
        for (other, made) in &independent.others {
            let taken = independent.kept.iter().zip(made).map(|(&kept, factor)| (kept, -factor));
            let split: Vec<(usize, f64)> =
                taken.chain([(*other, 1.0)]).filter(|(_, part)| *part != 0.0).collect();
            let mut nodes = vec![0.0; self.nodes.len()];
            for &(place, torque) in &split {
                push(&mut nodes, self.model.elements[stuck[place]].places, torque);
            }
            let scale = largest_absolute(&nodes);
            let loaded =
                lossy.iter().find(|&&mesh| dot(meshes.row(mesh), &nodes).abs() > ACCELERATION * scale);
            if let Some(&mesh) = loaded {
                let set = self.model.mechanism.meshes[mesh].set;
                let places: Vec<usize> = split.iter().map(|&(place, _)| stuck[place]).collect();
                let (elements, links) = self.named(&places, &[]);
                let set = self.model.mechanism.sets[set].name.clone();
                return Err(Error::OpenSplit { time_s, elements, links, set });
            }
        }
        Ok(())
    }

    fn find_unique(&self) -> Result<(), Error> {
        let lossy: Vec<usize> = self.lossy_meshes().collect();
        let meshes = &self.model.mechanism.meshes;
        let stuck: Vec<usize> = self.pattern.stuck().collect();
        let rows: Vec<&[f64]> =
            stuck.iter().map(|&place| self.model.elements[place].slip.as_slice()).collect();
        let stuck_sets: Vec<usize> =
            (0..self.pattern.sets.len()).filter(|&set| self.pattern.sets[set] == Way::Stuck).collect();
        let independent = independent(&rows, RANK);
        let with = |part: &dyn Fn(usize) -> f64| {
            System::determinant_with(self.model, &stuck, &independent, &stuck_sets, part)
        };
        let ideal = with(&|_| 1.0);
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for signs in 0..1_u32 << lossy.len() {
            let part = |mesh: usize| match lossy.iter().position(|&one| one == mesh) {
                Some(bit) if signs >> bit & 1 == 0 => meshes[mesh].efficiency,
                Some(_) => 1.0 / meshes[mesh].efficiency,
                None => 1.0,
            };
            let share = with(&part) / ideal;
            least = least.min(share);
            greatest = greatest.max(share);
        }
        if least > 0.0 {
            return Ok(());
        }
        let mut sets: Vec<usize> = lossy.iter().map(|&mesh| meshes[mesh].set).collect();
        sets.dedup();
        let sets = sets.iter().map(|&set| self.model.mechanism.sets[set].name.clone()).collect();
        Err(Error::NotUnique { sets, least, greatest })
    }

    /// Whether a set that friction holds would start under some pattern, with the elements as they are but
    /// that those that yield may hold again.
    pub(crate) fn would_start(&self, moment: &Moment, unique: &mut Unique) -> bool {
        let (mut yielding, sets) = self.at_rest(moment.y, moment.speed_scale);
        // Those that only begin to slip, too.
        yielding.retain(|&place| self.pattern.elements[place].sign() != 0.0);
        let options: Vec<Vec<Way>> =
            yielding.iter().map(|&place| vec![self.pattern.elements[place], Way::Stuck]).collect();
        let mut other = self.clone();
        let mut refused = None;
        let mut base = self.pattern.clone();
        sets.iter().for_each(|&set| base.sets[set] = Way::Open);
        let open = Open { elements: yielding, sets };
        product(&options).into_iter().any(|ways| {
            open.elements.iter().zip(ways).for_each(|(&place, way)| base.elements[place] = way);
            self.rolling(&base, &open.sets).into_iter().any(|pattern| {
                let moves =
                    |set: &usize| pattern.sets[*set].sign() != 0.0 && self.pattern.sets[*set].sign() == 0.0;
                open.sets.iter().any(moves)
                    && other
                        .violation(pattern, &open, moment, &[], unique, &mut refused)
                        .is_some_and(|(violation, _)| violation == 0.0)
            })
        })
    }
}

/// Combinations of one way from each list of options.
fn product(options: &[Vec<Way>]) -> Vec<Vec<Way>> {
    options.iter().fold(vec![vec![]], |made, ways| {
        made.iter()
            .flat_map(|start| {
                ways.iter().map(move |way| {
                    let mut longer = start.clone();
                    longer.push(*way);
                    longer
                })
            })
            .collect()
    })
}

/// The largest speed of any body.
pub(crate) fn largest_speed(field: &Field, y: &[f64]) -> f64 {
    let speeds = &field.model.mechanism.speeds;
    let mut most = largest_absolute(&y[..field.parts.work]);
    for body in 0..speeds.rows() {
        most = most.max(dot(speeds.row(body), y).abs());
    }
    most
}
