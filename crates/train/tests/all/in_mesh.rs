//! Gears of random sets of every kind as they are drawn, polygon against polygon: none enters another, and
//! each touches its mate after its share of the backlash, to both sides.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::compound::CompoundSpec;
use epicyclic_train::in_mesh::{InMesh, Placed, PlacedPlanet};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::toothed::Shifts;
use epicyclic_train::{Gearbox, PlanetSet};
use epicyclic_units::Physical;
use proptest::prelude::*;
use std::f64::consts::TAU;
use uom::si::f64::Angle;

/// Deviation of the polygons from the exact curves, modules.
const DEVIATION: f64 = 1e-3;

/// A gear as a polygon at its place.
struct Polygon {
    centre: [f64; 2],
    points: Vec<[f64; 2]>,
    is_ring: bool,
    /// Tip radius, which no point of a planet or sun exceeds and no point of a ring is within.
    tip: f64,
}

impl Polygon {
    fn new(in_mesh: &InMesh, placed: &Placed, more_turn: f64) -> Self {
        let gear = &in_mesh.gears[placed.gear];
        let (sin, cos) = libm::sincos(placed.turn_rad + more_turn);
        let [x0, y0] = placed.centre;
        let outline = gear.curve.outline(DEVIATION).unwrap();
        let points = outline
            .iter()
            .map(|[x, y]| [x0 + gear.module * (x * cos - y * sin), y0 + gear.module * (x * sin + y * cos)]);
        Self {
            centre: placed.centre,
            points: points.collect(),
            is_ring: gear.is_ring(),
            tip: gear.tip_radius(),
        }
    }

    fn sides(&self) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let next = self.points.iter().cycle().skip(1);
        self.points.iter().zip(next).map(|(one, next)| [*one, *next])
    }

    /// Depth of a point in the material; 0 outside.
    fn depth(&self, [x, y]: [f64; 2]) -> f64 {
        let from_axis = libm::hypot(x - self.centre[0], y - self.centre[1]);
        if (from_axis < self.tip) == self.is_ring {
            return 0.0;
        }
        let mut is_within = false;
        let mut nearest = f64::INFINITY;
        for [[x1, y1], [x2, y2]] in self.sides() {
            if (y1 > y) != (y2 > y) && x < x1 + (x2 - x1) * (y - y1) / (y2 - y1) {
                is_within = !is_within;
            }
            let (dx, dy) = (x2 - x1, y2 - y1);
            let share = (((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            nearest = nearest.min(libm::hypot(x - x1 - share * dx, y - y1 - share * dy));
        }
        if is_within == self.is_ring { 0.0 } else { nearest }
    }
}

/// Greatest depth of corners of one polygon within the other.
fn overlap(one: &Polygon, other: &Polygon) -> f64 {
    let within =
        |points: &[[f64; 2]], of: &Polygon| points.iter().map(|at| of.depth(*at)).fold(0.0, f64::max);
    f64::max(within(&one.points, other), within(&other.points, one))
}

/// Checks every mesh at every place where its gears are drawn.
fn check(in_mesh: &InMesh, kinds: usize) -> Result<(), TestCaseError> {
    let copies: Vec<&[PlacedPlanet]> =
        if kinds == 0 { vec![&[]] } else { in_mesh.planets.chunks(kinds).collect() };
    for mesh in &in_mesh.meshes {
        for copy in &copies {
            let all = in_mesh.centrals.iter().chain(copy.iter().flat_map(|planet| &planet.gears));
            let all: Vec<&Placed> = all.collect();
            let [one, other] = mesh.gears.map(|gear| *all.iter().find(|placed| placed.gear == gear).unwrap());
            let own = Polygon::new(in_mesh, one, 0.0);
            let mate = Polygon::new(in_mesh, other, 0.0);
            let apart = libm::hypot(one.centre[0] - other.centre[0], one.centre[1] - other.centre[1]);
            let (pair, module) = (&mesh.pair, mesh.module);
            prop_assert!((apart - module * pair.centre_distance()).abs() < 1e-9 * apart, "{:?}", mesh.gears);
            let tolerance = 2.5 * DEVIATION * module;
            let play = module * pair.backlash();
            // A share of a negative play lies at each flank.
            let pressed = (-0.5 * play * libm::cos(pair.working_angle_rad())).max(0.0);
            let depth = overlap(&own, &mate);
            prop_assert!(depth <= pressed + tolerance, "{depth} {pressed} {tolerance} {pair:?}");
            prop_assert!(pressed < 2.0 * tolerance || depth > 0.5 * pressed, "hidden: {depth} {pressed}");
            let radius = 0.5 * module * pair.working_diameters()[0];
            for side in [-1.0, 1.0] {
                let turned = side * (0.5 * play.max(0.0) + 6.0 * tolerance) / radius;
                let depth = overlap(&Polygon::new(in_mesh, one, turned), &mate);
                prop_assert!(depth > tolerance, "no contact: {depth} {side} {:?}", mesh.gears);
            }
        }
    }
    Ok(())
}

/// All planets of a kind must be one part: their gears are turned against each other alike.
fn check_planets(in_mesh: &InMesh, kinds: usize) -> Result<(), TestCaseError> {
    for planet in 0..kinds {
        let turned = |copy: usize| &in_mesh.planets[copy * kinds + planet].gears;
        prop_assert!(turned(0).iter().all(|gear| gear.turn_rad == turned(0)[0].turn_rad), "teeth in line");
        for copy in 1..in_mesh.planets.len() / kinds.max(1) {
            let (first, own) = (turned(0), turned(copy));
            let pitch = |gear: &Placed| TAU / in_mesh.gears[gear.gear].curve.gear().teeth().as_f64();
            let steps = (TAU / pitch(&first[0])).round() as u32;
            let fits = |step: u32| {
                let body = own[0].turn_rad - first[0].turn_rad + f64::from(step) * pitch(&first[0]);
                first.iter().zip(own).all(|(one, other)| {
                    let teeth = (other.turn_rad - one.turn_rad - body) / pitch(one);
                    (teeth - teeth.round()).abs() < 1e-6
                })
            };
            prop_assert!((0..steps).any(fits), "planet {planet} of copy {copy} is another part");
        }
    }
    Ok(())
}

fn alone(set: CompoundSpec) -> Gearbox {
    let links: Vec<String> = set.centrals.iter().map(|central| central.link.clone()).collect();
    let input = links[0].clone();
    Gearbox::builder("one set")
        .links(links)
        .links(["H"])
        .compound_set(set)
        .input(&input)
        .output("H")
        .build()
        .unwrap()
}

fn alone_short(set: SetSpec) -> Gearbox {
    let links: Vec<String> = if set.kind.is_pair() {
        vec!["a".into(), "b".into()]
    } else {
        ["a", "b", "H"].map(String::from).into()
    };
    let output = links[links.len() - 1].clone();
    Gearbox::builder("one set").links(links).set(set).input("a").output(&output).build().unwrap()
}

fn count(teeth: u32) -> ToothCount {
    ToothCount::new(teeth).unwrap()
}

/// Data that random sets have in common.
#[derive(Debug, Clone)]
struct Dice {
    teeth: [u32; 5],
    shifts: [f64; 3],
    helix_deg: f64,
    play: f64,
    planets: u32,
}

fn dice() -> impl Strategy<Value = Dice> {
    let helix = prop_oneof![Just(0.0), 5.0..25.0_f64];
    let shifts = [0.0..0.5_f64, 0.0..0.5_f64, -0.2..0.2_f64];
    ([18..34_u32, 17..34_u32, 17..34_u32, 18..34_u32, 0..5_u32], shifts, helix, -0.03..0.08_f64, 1..=3_u32)
        .prop_map(|(teeth, shifts, helix_deg, play, planets)| Dice {
            teeth,
            shifts,
            helix_deg,
            play,
            planets,
        })
}

impl Dice {
    fn profile(&self) -> Profile {
        Profile { helix_angle: Angle::from_degrees(self.helix_deg), ..Profile::default() }
    }

    fn gear(&self, kind: GearKind, teeth: u32, shift: f64) -> Option<InvoluteGear> {
        InvoluteGear::new(kind, count(teeth), self.profile(), shift).ok()
    }

    /// Shift of a ring about a planet at a centre distance, which leaves about the play that is asked for.
    fn ring_shift(&self, planet: u32, shift: f64, ring: u32, distance: f64) -> Option<f64> {
        let planet = self.gear(GearKind::External, planet, shift)?;
        let plain = self.gear(GearKind::Internal, ring, 0.0)?;
        let sum = Pair::shift_sum(&planet, &plain, distance).ok()?;
        Some(sum - shift - self.play / 0.73).filter(|shift| shift.abs() < 0.8)
    }

    fn external_distance(&self, one: (u32, f64), other: (u32, f64)) -> Option<f64> {
        let [one, other] = [one, other].map(|(teeth, shift)| self.gear(GearKind::External, teeth, shift));
        Some(Pair::without_backlash(one?, other?).ok()?.centre_distance())
    }

    fn set(&self, kind: usize) -> Option<Gearbox> {
        let [z1, p1, p2, z2, more] = self.teeth;
        let [x1, x2, x3] = self.shifts;
        let helix = [Angle::from_degrees(self.helix_deg); 8];
        let eta = MeshEfficiency::IDEAL;
        let new = || CompoundSpec::new("P", "H").planet_count(self.planets);
        let shaped = |mut set: CompoundSpec, shifts: &[f64]| {
            set.tooth_shape.shifts = Some(Shifts { profile: shifts.to_vec(), tips: None });
            set.tooth_shape.helix_angles = helix[..set.meshes.len()].to_vec();
            Some(alone(set))
        };
        match kind {
            // External and internal pairs.
            0 | 1 => {
                let is_internal = kind == 1;
                let second = if is_internal { z1 + p1 + 10 } else { p1 };
                let kind = if is_internal { SetKind::InternalPair } else { SetKind::ExternalPair };
                let set = SetSpec { kind, ..SetSpec::pair("P", ["a", "b"], z1, second).ok()? };
                let set = set.helical(helix[0]);
                Some(alone_short(set.shifted(Shifts { profile: vec![x1, x3], tips: None })))
            }
            // A simple set whose teeth need shifts.
            2 => {
                let ring = z1 + 2 * p1 + more - 2;
                let ring_shift =
                    self.ring_shift(p1, x2, ring, self.external_distance((z1, x1), (p1, x2))?)?;
                let set = SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], z1, ring).ok()?;
                let set = set.planet_teeth(count(p1), None).planet_count(self.planets).helical(helix[0]);
                Some(alone_short(set.shifted(Shifts { profile: vec![x1, x2, ring_shift], tips: None })))
            }
            // Two planets in mesh between sun and ring.
            3 => {
                let ring = z1 + p1 + p2 + z2 / 3;
                let set = new().sun("a", z1).ring("b", ring).planet("p", &[p1]).planet("q", &[p2]);
                let set = set.mesh("a", "p", eta).mesh("p", "q", eta).mesh("q", "b", eta);
                shaped(set, &[x1, x3, x2, 0.0])
            }
            // A stepped planet between a sun and a ring; the second module follows.
            4 => {
                let set = new().sun("a", z1).ring("b", z1 + p1 + p2 + 20).planet("p", &[p1 + 10, p2]);
                let set = set.mesh("a", "p.1", eta).mesh("p.2", "b", eta);
                shaped(set, &[x1, x3, x2, 0.0])
            }
            // A Wolfrom drive.
            5 => {
                let ring = z1 + 2 * p1;
                let first = self.ring_shift(p1, x2, ring, self.external_distance((z1, x1), (p1, x2))?)?;
                let set =
                    new().sun("a", z1).ring("b", ring).ring("c", ring - more - 2).planet("p", &[p1, p1 - 1]);
                let set = set.mesh("a", "p.1", eta).mesh("p.1", "b", eta).mesh("p.2", "c", eta);
                shaped(set, &[x1, first, x3, x2, 0.1])
            }
            // A Ravigneaux set.
            _ => {
                let ring = z1 + 6 + 2 * p2;
                let distance = self.external_distance((z1 + 6, x1), (p2, x2))?;
                let ring_shift = self.ring_shift(p2, x2, ring, distance)?;
                let set = new().sun("a", z1).sun("b", z1 + 6).ring("c", ring);
                let set = set.planet("short", &[p2 - 1]).planet("long", &[p2]);
                let set = set.mesh("a", "short", eta).mesh("short", "long", eta);
                let set = set.mesh("b", "long", eta).mesh("long", "c", eta);
                shaped(set, &[x3, x1, ring_shift, 0.0, x2])
            }
        }
    }
}

/// Whether only backlash and planets side by side are faulty.
fn runs(gearbox: &Gearbox) -> bool {
    let checks = gearbox.set_checks(&BasicRack::default(), |_| vec![]);
    let is_fault = |rule: &str| !matches!(rule, "backlash" | "planet-gap" | "assembly" | "planes");
    checks.checks.iter().all(|check| {
        check.severity < epicyclic_gears::involute::check::Severity::Warning
            || check.miss.is_none()
            || !is_fault(check.rule)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases / 32, ..ProptestConfig::default() })]
    #[test]
    fn no_gear_enters_its_mate_and_each_has_its_backlash_at_both_flanks(dice in dice()) {
        for gearbox in (0..7).filter_map(|kind| dice.set(kind)).filter(runs) {
            let set = &gearbox.sets()[0];
            let Ok(toothed) = set.toothed(&BasicRack::default(), &[]) else { continue };
            if toothed.meshes.iter().any(|mesh| mesh.pair.transverse_contact_ratio() < 1.1) {
                continue;
            }
            let is_behind = vec![dice.teeth[4] > 2; set.meshes().len()];
            // Two planets in mesh may not reach each other.
            let Ok(mut in_mesh) = set.in_mesh(&toothed, &is_behind, 3) else { continue };
            let kinds = set.planets().len();
            let positions = set.assembly_positions().unwrap_or(0);
            if positions > 0 && positions < in_mesh.planets.len() as u64 / kinds.max(1) as u64 {
                // Not so many planets go in: only the first of each kind meshes.
                in_mesh.planets.truncate(kinds);
            }
            check(&in_mesh, kinds)?;
            check_planets(&in_mesh, kinds)?;
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases / 32, ..ProptestConfig::default() })]
    /// A chain of planets, of which those in the middle mesh with planets alone.
    #[test]
    fn planets_between_planets_are_drawn_in_mesh(
        sun in 17..40_u32, teeth in prop::collection::vec(17..30_u32, 3..6), more in -20..20_i32, at: bool,
    ) {
        // Sun and chain reach a ring of this size with the planets at any angles that are not too steep.
        let across = sun + teeth[0] + teeth[1..].iter().sum::<u32>();
        let ring = across.checked_add_signed(more).unwrap();
        let names: Vec<String> = (0..teeth.len()).map(|place| format!("p{place}")).collect();
        let mut set = CompoundSpec::new("P", "H").planet_count(1).sun("a", sun).ring("c", ring);
        for (name, teeth) in names.iter().zip(&teeth) {
            set = set.planet(name, &[*teeth]);
        }
        set = set.mesh("a", &names[0], MeshEfficiency::IDEAL);
        for pair in names.windows(2) {
            set = set.mesh(&pair[0], &pair[1], MeshEfficiency::IDEAL);
        }
        set = set.mesh(&names[teeth.len() - 1], "c", MeshEfficiency::IDEAL);
        let gearbox = alone(set);
        let set = &gearbox.sets()[0];
        let Ok(mut toothed) = set.toothed(&BasicRack::default(), &[]) else { return Ok(()) };
        let open: Vec<usize> = (0..teeth.len()).filter(|planet| toothed.radii[*planet].is_none()).collect();
        prop_assert_eq!(open.len(), teeth.len() - 2);
        let free = set.in_mesh(&toothed, &[], 1);
        let radius = |planet: usize| toothed.radii[planet].unwrap();
        let steps: f64 = toothed.meshes[1..teeth.len()].iter().map(|mesh| mesh.pair.centre_distance()).sum();
        if (radius(0) - radius(teeth.len() - 1)).abs() > steps {
            prop_assert!(free.is_err());
            return Ok(());
        }
        let in_mesh = free.unwrap();
        let assumed: Vec<usize> = in_mesh.assumed.iter().map(|one| one.0).collect();
        prop_assert_eq!(&assumed, &open);
        // Each gear of the set is there.
        prop_assert_eq!(in_mesh.placed().count(), set.gears().len());
        check(&in_mesh, teeth.len())?;
        // A radius that is stated is that of the picture.
        let (planet, radius) = in_mesh.assumed[0];
        let stated = if at { radius } else { 1.0005 * radius };
        toothed.radii[planet] = Some(stated);
        if let Ok(in_mesh) = set.in_mesh(&toothed, &[], 1) {
            prop_assert_eq!(in_mesh.planets[planet].centre_distance, stated);
            prop_assert!(in_mesh.assumed.iter().all(|one| one.0 != planet));
        } else {
            prop_assert!(!at);
        }
    }
}

/// A set as it is written in two ways.
fn both_ways(dice: &Dice) -> Option<[Gearbox; 2]> {
    let short = dice.set(2)?;
    let spec = short.sets()[0].short()?;
    let [sun, planet, ring] = [GearOf::Central(0), GearOf::Planet(0, 0), GearOf::Central(1)]
        .map(|gear| short.sets()[0].teeth(gear).map(ToothCount::get));
    let set = CompoundSpec::new("P", "H").planet_count(dice.planets).sun("a", sun?).ring("b", ring?);
    let set = set.planet("planet", &[planet?]);
    let mut set = set.mesh("a", "planet", MeshEfficiency::IDEAL).mesh("planet", "b", MeshEfficiency::IDEAL);
    let shifts = &spec.tooth_shape.shifts.as_ref()?.profile;
    set.tooth_shape.shifts = Some(Shifts { profile: vec![shifts[0], shifts[2], shifts[1]], tips: None });
    set.tooth_shape.helix_angles = spec.tooth_shape.helix_angles.clone();
    Some([alone(set), short])
}

fn outlines(set: &PlanetSet) -> Option<Vec<[f64; 2]>> {
    let in_mesh = set.in_mesh(&set.toothed(&BasicRack::default(), &[]).ok()?, &[], 3).ok()?;
    Some(in_mesh.placed().flat_map(|placed| Polygon::new(&in_mesh, placed, 0.0).points).collect())
}

proptest! {
    #[test]
    fn a_simple_set_written_as_a_compound_one_looks_the_same(dice in dice()) {
        let Some(both) = both_ways(&dice) else { return Ok(()) };
        let [Some(one), Some(other)] = both.map(|gearbox| outlines(&gearbox.sets()[0])) else { return Ok(()) };
        prop_assert_eq!(one.len(), other.len());
        for ([x1, y1], [x2, y2]) in one.iter().zip(&other) {
            prop_assert!((x1 - x2).abs() < 1e-12 && (y1 - y2).abs() < 1e-12);
        }
    }
}
