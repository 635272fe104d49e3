//! Designs in ascending order of the objective, until enough of them hold.

use super::bearing::Bearing;
use super::gear_masses::{Masses, widest_bore};
use super::pin_loads::{Borne, PinStep, bearing_duty, borne};
use super::practice::{Misses, Practice, of_pin, priced};
use super::rated::{Place, Ratings, rim_of};
use super::task::{Body, Design, DesignedPlanet, Governing, Layout, Task};
use super::{Found, LeftOut, Objective, Requirement, Tried};
use crate::tolerance::{RIM, SAME};
use crate::{Error, Quantity};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::life::Rolling;
use epicyclic_judge::Rule;
use epicyclic_units::Physical;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;
use std::ops::ControlFlow;
use std::rc::Rc;
use uom::si::f64::{Force, Length, Mass};

/// The best `most` designs of these layouts, unless `goes_on`, which is called now and then, breaks. `tried`
/// is what was left out before.
///
/// # Errors
/// [`Error::Cancelled`]; [`Error::NothingToSearch`] without face widths; [`Error::IdleDuty`] for a duty that
/// loads no mesh; [`Error::NotPositive`], [`Error::Negative`] and [`Error::OutOfRange`] for a quantity; those
/// of [`rate_duty`](crate::spectrum::rate_duty), except for teeth outside the range of the standard, which
/// are left out and counted.
pub fn search(
    task: &Task,
    layouts: &[Layout],
    tried: Tried,
    most: usize,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Found, Error> {
    task.check()?;
    if task.face_widths.iter().any(Vec::is_empty) {
        return Err(Error::NothingToSearch { quantity: Quantity::FaceWidth });
    }
    for layout in layouts {
        task.check_loads(&layout.loads)?;
    }
    let space = tried.left_out.total() + layouts.len() as u64 * task.designs_of_layout();
    let mut search = Search {
        task,
        layouts,
        masses: layouts.iter().map(|layout| Masses::new(task, layout)).collect(),
        practice: task.practice.as_ref().map_or_else(Vec::new, |limits| {
            layouts.iter().map(|layout| Practice::of(task, layout, limits)).collect()
        }),
        ratings: Ratings::new(task, layouts),
        bearings: task.planets.iter().map(|planet| by_bore(planet.eligible())).collect(),
        left_out: tried.left_out,
        against_stated: vec![],
        is_quick: true,
    };
    let (mut found, mut nearest) = search.best(most, goes_on)?;
    if found.is_empty() && task.asks_nearest {
        // Only now the design that misses least is asked for, and with it the bearings of those whose teeth miss.
        (search.is_quick, search.left_out, search.against_stated) = (false, tried.left_out, vec![]);
        (found, nearest) = search.best(most, goes_on)?;
    }
    Ok(Found {
        space,
        geometries: tried.geometries,
        rated: search.ratings.made,
        not_reached: space - search.left_out.total() - found.len() as u64,
        left_out: search.left_out,
        usual_fault: tried.usual_fault(),
        stated_limit: search.stated_limit(),
        nearest_miss: nearest.filter(|_| found.is_empty()),
        found,
    })
}

/// A design in the order of the search: before it is judged with the objectives that it cannot be below.
#[derive(Debug, Clone, PartialEq)]
struct Candidate {
    objectives: [f64; 3],
    layout: usize,
    /// Index of the face width of each family.
    widths: Vec<usize>,
    /// Whether the wider ones are in the queue already.
    is_followed: bool,
    /// The design, if it holds.
    design: Option<Box<Design>>,
}

impl Candidate {
    fn place(&self) -> Place<'_> {
        Place { layout: self.layout, widths: &self.widths }
    }
}

impl Eq for Candidate {}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        let by = self.objectives.iter().zip(&other.objectives).map(|(one, other)| one.total_cmp(other));
        let rest = |one: &Self| (one.layout, one.design.is_some());
        by.fold(Ordering::Equal, Ordering::then)
            .then_with(|| rest(self).cmp(&rest(other)))
            .then_with(|| self.widths.cmp(&other.widths))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

struct Search<'a> {
    task: &'a Task,
    layouts: &'a [Layout],
    masses: Vec<Masses>,
    /// Empty where practice does not count.
    practice: Vec<Practice>,
    ratings: Ratings<'a>,
    /// Bearings of each kind of planets, the largest outside diameter first.
    bearings: Vec<Rc<[&'a Bearing]>>,
    left_out: LeftOut,
    /// Designs outside a stated range, by the rule.
    against_stated: Vec<(Rule, u64)>,
    /// Whether no bearings are tried for teeth that miss a requirement.
    is_quick: bool,
}

impl Search<'_> {
    /// The best designs, and of those judged in full the one that misses least.
    fn best(
        &mut self,
        most: usize,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<(Vec<Design>, Option<Design>), Error> {
        let mut heap = BinaryHeap::new();
        for layout in 0..self.layouts.len() {
            heap.extend(self.narrowest(layout).into_iter().map(Reverse));
        }
        let (mut found, mut nearest): (Vec<Design>, Option<Design>) = (vec![], None);
        while found.len() < most {
            let Some(Reverse(mut next)) = heap.pop() else { break };
            if goes_on().is_break() {
                return Err(Error::Cancelled);
            }
            if let Some(design) = next.design.take() {
                found.push(*design);
                continue;
            }
            // Wider designs are no lighter: they enter the queue only now, which keeps it short.
            if !next.is_followed {
                heap.extend(self.wider(&next).into_iter().map(Reverse));
            }
            let (misses, _) = self.misses(next.layout, &self.widths(&next.widths));
            if misses.is_refused() {
                self.refuse(misses, 1);
                continue;
            }
            let Some((design, missed)) = self.judged(&next)? else { continue };
            if design.governing.ratio() >= 1.0 {
                // It waits until no other design can be better.
                let widths = self.widths(&next.widths);
                let key = self.objectives(design.rules_missed, next.layout, design.mass.si(), &widths);
                heap.push(Reverse(Candidate { objectives: key, design: Some(Box::new(design)), ..next }));
                continue;
            }
            self.leave_out(missed);
            let reserve = |design: &Design| design.governing.reserve();
            if found.is_empty() && nearest.as_ref().is_none_or(|one| reserve(&design) > reserve(one)) {
                nearest = Some(design);
            }
        }
        Ok((found, nearest))
    }

    /// Counts a design for the requirement that it misses.
    const fn leave_out(&mut self, requirement: Requirement) {
        match requirement {
            Requirement::Flank => self.left_out.flank += 1,
            Requirement::Root => self.left_out.root += 1,
            Requirement::OverloadFlank | Requirement::OverloadRoot => self.left_out.overload += 1,
            Requirement::BearingLife => self.left_out.bearing_life += 1,
        }
    }

    /// Leaves out designs for what they miss of practice and of stated ranges.
    fn refuse(&mut self, misses: Misses, designs: u64) {
        self.left_out.practice += designs;
        for rule in misses.against_stated() {
            match self.against_stated.iter_mut().find(|(of, _)| *of == rule) {
                Some((_, count)) => *count += designs,
                None => self.against_stated.push((rule, designs)),
            }
        }
    }

    /// The rule whose stated range leaves out most designs, and their number.
    fn stated_limit(&self) -> Option<(Rule, u64)> {
        self.against_stated.iter().copied().max_by_key(|(_, count)| *count)
    }

    fn objectives(&self, rules_missed: u32, layout: usize, gears: f64, widths: &[f64]) -> [f64; 3] {
        let masses = &self.masses[layout];
        let ring = masses.ring.map_or(0.0, Physical::si);
        let (value, next) = match self.task.objective {
            Objective::Mass => (gears, ring),
            Objective::Ring => (ring, gears),
            Objective::Whole => (gears + masses.structure(widths), gears),
        };
        let [is_unusual, price] = priced(rules_missed, value);
        [is_unusual, price + self.task.length_price * masses.length(widths), next]
    }

    fn widths(&self, widths: &[usize]) -> Vec<f64> {
        self.task.face_widths.iter().zip(widths).map(|(all, place)| all[*place].si()).collect()
    }

    /// A design before it is judged, and those that follow it where it is too narrow for usual practice: a
    /// wider one may be better. No bearing makes it lighter than the largest bore.
    fn candidates(&self, layout: usize, widths: Vec<usize>, all: &mut Vec<Candidate>) {
        let masses = &self.masses[layout];
        let bores = masses.largest_bore.iter().copied();
        let lengths = self.widths(&widths);
        let mass = masses.all(self.layouts[layout].planets, bores, &lengths);
        let (misses, is_followed) = self.misses(layout, &lengths);
        let objectives = self.objectives(misses.count(), layout, mass, &lengths);
        let one = Candidate { objectives, layout, widths, is_followed, design: None };
        if is_followed {
            all.extend(self.wider(&one));
        }
        all.push(one);
    }

    /// Rules of practice that gears and widths miss, and whether a wider one may miss fewer.
    fn misses(&self, layout: usize, widths: &[f64]) -> (Misses, bool) {
        let Some(limits) = &self.task.practice else { return (Misses::default(), false) };
        let own = &self.practice[layout];
        let (mut of_widths, is_narrow) = own.of_widths(limits, widths);
        // Widths that are stated, too, are kept.
        if self.task.face_widths.iter().all(|widths| widths.len() <= 1) {
            of_widths = of_widths.kept();
        }
        (own.of_layout.with(of_widths), is_narrow)
    }

    /// How many of the face widths of each family the width ratio allows.
    fn allowed(&self, layout: usize) -> Vec<usize> {
        let ratio = self.task.width_ratio.unwrap_or(f64::INFINITY);
        let all = self.task.face_widths.iter().zip(&self.masses[layout].diameters);
        all.map(|(widths, diameter)| widths.partition_point(|width| width.si() <= ratio * diameter)).collect()
    }

    /// The narrowest design of a layout; those that the width ratio or the rims leave out are counted.
    fn narrowest(&mut self, layout: usize) -> Vec<Candidate> {
        let all = self.task.designs_of_layout();
        let of_layout = self.practice.get(layout).map_or_else(Misses::default, |own| own.of_layout);
        if of_layout.is_refused() {
            self.refuse(of_layout, all);
            return vec![];
        }
        if self.masses[layout].largest_bore.contains(&f64::NEG_INFINITY) {
            self.left_out.rim += all;
            return vec![];
        }
        let is_above =
            |ring: Length| self.task.largest_ring.is_some_and(|largest| ring > largest * (1.0 + RIM));
        if self.masses[layout].ring.is_some_and(is_above) {
            self.left_out.ring += all;
            return vec![];
        }
        let allowed: u64 = self.allowed(layout).iter().map(|count| *count as u64).product();
        self.left_out.width_ratio += all - allowed;
        let mut first = vec![];
        if allowed > 0 {
            self.candidates(layout, vec![0; self.task.face_widths.len()], &mut first);
        }
        first
    }

    /// The designs that follow one in width: each is reached from one other alone.
    fn wider(&self, one: &Candidate) -> Vec<Candidate> {
        let allowed = self.allowed(one.layout);
        let last = one.widths.iter().rposition(|width| *width > 0).unwrap_or(0);
        let mut next = vec![];
        for family in last..one.widths.len() {
            let mut widths = one.widths.clone();
            widths[family] += 1;
            if widths[family] < allowed[family] {
                self.candidates(one.layout, widths, &mut next);
            }
        }
        next
    }

    /// A design with its safeties and lives, and the requirement that it counts for if it does not hold: the one that
    /// its teeth miss most, or else that of its bearings. `None` if it is left out for other reasons, which are counted.
    fn judged(&mut self, one: &Candidate) -> Result<Option<(Design, Requirement)>, Error> {
        let (task, layouts) = (self.task, self.layouts);
        let own = &layouts[one.layout];
        let mut teeth = vec![];
        for mesh in 0..task.meshes.len() {
            let Some(rated) = self.ratings.rate(one.place(), mesh, [None; 2])? else {
                self.left_out.not_calculable += 1;
                return Ok(None);
            };
            teeth.push(rated);
        }
        // Bearings and thin rims only add to what teeth miss.
        let of_teeth = Governing::least(teeth.iter().filter_map(|rated| rated.governing));
        let missed = of_teeth.filter(|least| least.ratio() < 1.0).map(|least| least.requirement);
        if let Some(missed) = missed.filter(|_| self.is_quick) {
            self.leave_out(missed);
            return Ok(None);
        }
        let widths = self.widths(&one.widths);
        let Held { planets, governing: of_bearings, misses: of_pins } = match self.planets(one, &widths)? {
            Chosen::Planets(held) => held,
            Chosen::TooWide => {
                self.left_out.bearing_width += 1;
                return Ok(None);
            }
            Chosen::NotCalculable => {
                self.left_out.not_calculable += 1;
                return Ok(None);
            }
            Chosen::Refused(misses) => {
                self.refuse(misses, 1);
                return Ok(None);
            }
        };
        let bore = |planet: &DesignedPlanet| planet.bore.map_or(0.0, Physical::si);
        let bores: Vec<f64> = planets.iter().map(bore).collect();
        for (mesh, rated) in teeth.iter_mut().enumerate() {
            let Some(thin) = self.ratings.thin(one.place(), mesh, |planet| bores[planet])? else { continue };
            let Some(thin) = thin else {
                self.left_out.not_calculable += 1;
                return Ok(None);
            };
            *rated = thin;
        }
        let all = teeth.iter().filter_map(|rated| rated.governing).chain(of_bearings);
        let alone = Governing::least(all).expect("a duty that loads a mesh has a safety");
        // Damages that add up take the longest: they are asked for last.
        let together = if alone.ratio() < 1.0 { None } else { self.ratings.together(one.place(), &bores)? };
        let governing = Governing::least([alone].into_iter().chain(together)).unwrap_or(alone);
        let masses = &self.masses[one.layout];
        let rim = |gear: usize| match task.gears[gear].body {
            Body::Planet(planet) if bores[planet] > 0.0 => {
                Some(Length::from_si(rim_of(task, own, gear, bores[planet])))
            }
            Body::Central if own.gears[gear].kind() == GearKind::Internal => {
                Some(task.ring_rim(gear, own.module(task, gear)))
            }
            _ => None,
        };
        let ratio = |(width, diameter): (&f64, &f64)| width / diameter;
        let misses = self.misses(one.layout, &widths).0.with(of_pins);
        let design = Design {
            rules_missed: misses.count(),
            mass: Mass::from_si(masses.all(own.planets, planets.iter().map(bore), &widths)),
            structure: Mass::from_si(masses.structure(&widths)),
            length: Length::from_si(masses.length(&widths)),
            face_loads: (0..widths.len()).map(|family| task.face_load(own, family, widths[family])).collect(),
            ring_diameter: masses.ring,
            rims: (0..own.gears.len()).map(rim).collect(),
            width_ratios: widths.iter().zip(&masses.diameters).map(ratio).collect(),
            layout: own.clone(),
            face_widths: widths.into_iter().map(Length::from_si).collect(),
            planets,
            overload: Governing::least(teeth.iter().filter_map(|rated| rated.overload)),
            meshes: teeth.into_iter().map(|rated| rated.over_duty).collect(),
            governing,
        };
        Ok(Some((design, missed.unwrap_or(governing.requirement))))
    }

    /// Planets of each kind with the bearing that misses the fewest rules of practice, of equal ones that of
    /// the largest bore, of those that live as long as required and leave the teeth strong enough. If no
    /// bearing holds, the one that misses least is taken.
    fn planets(&mut self, one: &Candidate, widths: &[f64]) -> Result<Chosen, Error> {
        let kinds: Vec<usize> = (0..self.task.planets.len()).collect();
        if self.task.has_one_bearing {
            return self.alike(one, &kinds, widths);
        }
        let mut all = Held::default();
        for kind in kinds {
            match self.alike(one, &[kind], widths)? {
                Chosen::Planets(own) => {
                    all.planets.extend(own.planets);
                    all.governing.extend(own.governing);
                    all.misses = all.misses.with(own.misses);
                }
                none => return Ok(none),
            }
        }
        Ok(Chosen::Planets(all))
    }

    /// Kinds of planets with one bearing for all, or without any.
    fn alike(&mut self, one: &Candidate, kinds: &[usize], widths: &[f64]) -> Result<Chosen, Error> {
        let (task, layouts) = (self.task, self.layouts);
        let own = &layouts[one.layout];
        let made = |kind: usize, bearing: Option<&Bearing>, bore: f64, (span, life)| DesignedPlanet {
            bearing: bearing.cloned(),
            span,
            bore: (bore > 0.0).then(|| Length::from_si(bore)),
            rim: (bore > 0.0).then(|| {
                let rims = task.gears_of(kind).map(|gear| rim_of(task, own, gear, bore));
                Length::from_si(rims.fold(f64::INFINITY, f64::min))
            }),
            life,
        };
        let misses = |kind: usize, bearing: Option<&Bearing>, duty: &[PinStep], bore: f64| {
            let of = |limits| of_pin((task, own, kind), limits, (bearing, duty), bore);
            task.practice.as_ref().map_or_else(Misses::default, of)
        };
        let sized = match kinds {
            [] => return Ok(Chosen::Planets(Held::default())),
            [first, ..] => &task.planets[*first],
        };
        if sized.bearings.is_empty() {
            let mut held = Held::default();
            for kind in kinds {
                let bore = task.planets[*kind].bore.map_or(0.0, Physical::si);
                held.planets.push(made(*kind, None, bore, (None, None)));
                held.misses = held.misses.with(misses(*kind, None, &[], bore));
            }
            return Ok(Chosen::Planets(held));
        }
        let bore = |bearing: &Bearing| bearing.outside_diameter.si();
        let of_kind = |kind: &usize| task.gears_of(*kind).map(|gear| widths[task.gears[gear].family]).sum();
        let width: f64 = kinds.iter().map(of_kind).fold(f64::INFINITY, f64::min);
        let widest = kinds.iter().map(|kind| widest_bore(task, own, *kind)).fold(f64::INFINITY, f64::min);
        let is_too_large = |bearing: &&Bearing| bore(bearing) > widest;
        // The best that holds, and of the others the one that misses least.
        let (mut best, mut nearest): (Option<Held>, Option<(f64, Held)>) = (None, None);
        let (mut is_none, mut refused) = (true, Misses::default());
        let mut alike: Option<Alike> = None;
        // One bearing for all kinds has one distance of its rows.
        let span_of = |bearing: &Bearing| {
            let is_tilted = kinds.iter().any(|kind| task.planets[*kind].is_tilted);
            let own = || bearing.span(Length::from_si(width));
            sized.pin.span.or_else(own).filter(|_| is_tilted)
        };
        let bearings = Rc::clone(&self.bearings[kinds[0]]);
        let bearings = &bearings[bearings.partition_point(is_too_large)..];
        'bearings: for bearing in bearings.iter().filter(|bearing| bearing.width.si() <= width) {
            is_none = false;
            let bearing = &*bearing.in_planet(Length::from_si(width));
            let (bore, rolling, span) = (bore(bearing), bearing.rolling, span_of(bearing));
            let least = |all: &[Borne]| all.iter().filter_map(|of| of.ratio).fold(f64::INFINITY, f64::min);
            let is_alike = |of: &Alike| of.bore == bore && of.rolling == rolling && of.span == span;
            let known = match alike.take().filter(is_alike) {
                Some(known) => alike.insert(known),
                None => {
                    let duty = |kind: &usize| {
                        let own_mass = self.masses[one.layout].planet(*kind, bore, widths);
                        let mass = task.planets[*kind].mass.map_or(own_mass, Physical::si);
                        let sharing = task.planets[*kind].sharing.unwrap_or(own.sharing);
                        bearing_duty(own, *kind, (mass, sharing), (rolling, span), |gear| {
                            widths[task.gears[gear].family]
                        })
                    };
                    let duties: Vec<_> = kinds.iter().map(|kind| (*kind, duty(kind))).collect();
                    let ratio = least(&borne(&duties, bearing, task.life)?);
                    alike.insert(Alike { bore, rolling, span, duties, required: bearing.load_rating / ratio })
                }
            };
            let is_miss = |ratio: f64| {
                let is_no_nearer = |(least, _): &(f64, Held)| ratio <= *least;
                ratio < 1.0 && (best.is_some() || nearest.as_ref().is_some_and(is_no_nearer))
            };
            // Most bearings of a table need no look at their lives.
            if is_miss((bearing.load_rating / known.required).si() * (1.0 + SAME)) {
                continue;
            }
            let (duties, all) = (&known.duties, borne(&known.duties, bearing, task.life)?);
            let mut ratio = least(&all);
            // Teeth only lower it.
            if is_miss(ratio) {
                continue;
            }
            let of_pins = duties.iter().map(|(kind, duty)| misses(*kind, Some(bearing), duty, bore));
            let mut held = Held { misses: of_pins.fold(Misses::default(), Misses::with), ..Held::default() };
            if held.misses.is_against_stated() {
                refused = refused.with(held.misses);
                continue;
            }
            // A smaller bore is heavier: it helps only with fewer misses.
            if best.as_ref().is_some_and(|best| best.misses.of_bearing() <= held.misses.of_bearing()) {
                continue;
            }
            for (kind, Borne { life, ratio: of_bearing }) in kinds.iter().copied().zip(all) {
                held.governing.extend(of_bearing.map(|value| Governing {
                    requirement: Requirement::BearingLife,
                    mesh: None,
                    gear: task.gears_of(kind).next().unwrap_or_default(),
                    value,
                    required: 1.0,
                }));
                held.planets.push(made(kind, Some(bearing), bore, (span, life)));
                let Some(of_teeth) = self.ratings.roots(one.place(), kind, bore)? else {
                    continue 'bearings;
                };
                let all = of_teeth.iter().chain(&held.governing).map(Governing::ratio);
                ratio = all.fold(ratio, f64::min);
            }
            if ratio >= 1.0 {
                let is_first = held.misses.of_bearing() == 0;
                best = Some(held);
                if is_first {
                    break;
                }
            } else if nearest.as_ref().is_none_or(|(least, _)| ratio > *least) {
                nearest = Some((ratio, held));
            }
        }
        Ok(match best.or(nearest.map(|(_, held)| held)) {
            Some(held) => Chosen::Planets(held),
            None if is_none => Chosen::TooWide,
            None if refused.is_against_stated() => Chosen::Refused(refused),
            None => Chosen::NotCalculable,
        })
    }
}

/// Loads of bearings with one bore of the planets, one kind of rolling elements and one distance of rows.
struct Alike {
    bore: f64,
    rolling: Rolling,
    span: Option<Length>,
    duties: Vec<(usize, Vec<PinStep>)>,
    /// Load rating that bears the loads for the required life.
    required: Force,
}

/// The largest outside diameter first, of equal ones as the table has them.
fn by_bore<'a>(all: impl Iterator<Item = &'a Bearing>) -> Rc<[&'a Bearing]> {
    let mut all: Vec<&Bearing> = all.collect();
    all.sort_by(|one, other| other.outside_diameter.si().total_cmp(&one.outside_diameter.si()));
    all.into()
}

/// Planets with what their bearings require, and the rules of practice that they miss.
#[derive(Default)]
struct Held {
    planets: Vec<DesignedPlanet>,
    governing: Vec<Governing>,
    misses: Misses,
}

/// Planets of a design, if bearings fit.
enum Chosen {
    Planets(Held),
    /// No bearing is as narrow as the planets.
    TooWide,
    /// Rims outside what the standard holds for.
    NotCalculable,
    /// Every bearing has values outside a range that is stated.
    Refused(Misses),
}
