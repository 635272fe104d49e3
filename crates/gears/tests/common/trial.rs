//! Tooth numbers of an arrangement by trial of every combination: slow, and the oracle of the search.
//!
//! It shares no formula with the search: speeds come from the equations of all meshes, assembly from trying
//! every tooth of the planet, gaps from coordinates. Shifts are chosen anew for the trees of meshes written
//! down here; the choice itself is held against the trial of every shift.

use epicyclic_gears::ToothCount;
use epicyclic_gears::arrangement::{
    ArrangedTeeth, Arrangement, ArrangementBounds, ArrangementMember, ArrangementMode,
};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::Severity;
use epicyclic_gears::involute::checks::mesh_checks;
use epicyclic_gears::involute::shifts::StatedDistance;
use epicyclic_gears::involute::tree::MeshTree;
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_gears::synthesis::Placement;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Place of the right side in a line of the equations: after five gears and the carrier.
const LAST: usize = 6;

/// Sets within the bounds with a ratio within the tolerance, ascending by teeth and number of planets.
#[derive(Default)]
pub(crate) struct ByTrial {
    /// Sets without profile shift, before the checks of their teeth.
    pub(crate) plain: Vec<ArrangedTeeth>,
    /// Sets with profile shift.
    pub(crate) shifted: Vec<ArrangedTeeth>,
    /// Number of sets that no shifts close and whose gears would be apart without.
    pub(crate) left_out: u64,
}

/// Every set within the bounds with a ratio within the tolerance.
///
/// Sets of one kind of gears, as stepped planets with equal steps, are left out as by the search. Only bounds
/// with one module and equal spacing are tried.
///
/// # Panics
/// With other bounds.
pub(crate) fn arranged_by_trial(
    bounds: &ArrangementBounds,
    wanted: f64,
    mode: ArrangementMode,
    tolerance: f64,
) -> ByTrial {
    assert!(bounds.module_ratios == [1.into()] && bounds.placement == Placement::Equal);
    let arrangement = bounds.arrangement;
    let gears = arrangement.gears().len();
    let (mut found, mut known) = (ByTrial::default(), HashMap::new());
    let mut teeth: Vec<u32> = bounds.teeth.iter().map(|range| *range.start()).collect();
    loop {
        let planets = if arrangement.is_pair() { 1..=1 } else { bounds.planets.clone() };
        for planets in planets {
            let is_set = has_centres(bounds, &teeth)
                && ratio(arrangement, &teeth, mode)
                    .is_some_and(|ratio| (ratio / wanted - 1.0).abs() <= tolerance + 1e-12)
                && (arrangement.is_pair() || assembles(arrangement, &teeth, planets));
            if !is_set {
                continue;
            }
            let set = ArrangedTeeth::new(arrangement, &teeth, 1.into(), planets);
            let plain = Shape::plain(bounds, &teeth);
            let is_apart = || arrangement.is_pair() || plain.is_apart(bounds, &teeth, planets);
            let equal = |distances: &Vec<i64>| distances.iter().all(|distance| *distance == distances[0]);
            if doubled(arrangement, &teeth).iter().all(equal) {
                found.plain.extend(set.ok().filter(|_| is_apart()));
                continue;
            }
            match Shape::shifted(bounds, &teeth, &mut known) {
                Some(shape) => {
                    let is_apart = shape.is_apart(bounds, &teeth, planets);
                    found.shifted.extend(set.ok().filter(|_| is_apart));
                }
                None => found.left_out += u64::from(is_apart()),
            }
        }
        // The next combination, as an odometer counts.
        let Some(place) = (0..gears).rev().find(|place| teeth[*place] < *bounds.teeth[*place].end()) else {
            return found;
        };
        teeth[place] += 1;
        for (teeth, range) in teeth.iter_mut().zip(&bounds.teeth).skip(place + 1) {
            *teeth = *range.start();
        }
    }
}

/// Doubled centre distances of the meshes with central gears: of the planet, or of the short and the long.
fn doubled(arrangement: Arrangement, z: &[u32]) -> [Vec<i64>; 2] {
    let z: Vec<i64> = z.iter().map(|&teeth| i64::from(teeth)).collect();
    match arrangement {
        Arrangement::Stepped => [vec![z[0] + z[1], z[3] - z[2]], vec![]],
        Arrangement::SteppedSuns => [vec![z[0] + z[1], z[3] + z[2]], vec![]],
        Arrangement::SteppedRings => [vec![z[0] - z[1], z[3] - z[2]], vec![]],
        Arrangement::Wolfrom => [vec![z[0] + z[1], z[2] - z[1], z[4] - z[3]], vec![]],
        Arrangement::Ravigneaux => [vec![z[0] + z[1]], vec![z[3] + z[2], z[4] - z[2]]],
        Arrangement::ExternalPair => [vec![z[0] + z[1]], vec![]],
        Arrangement::InternalPair => [vec![z[1] - z[0]], vec![]],
    }
}

fn has_centres(bounds: &ArrangementBounds, teeth: &[u32]) -> bool {
    let has_centre = |distances: &Vec<i64>| {
        distances.iter().all(|&one| {
            let offset = one - distances[0];
            one > 0
                && (i64::from(*bounds.offsets.start())..=i64::from(*bounds.offsets.end())).contains(&offset)
        })
    };
    // A stepped planet with equal steps between sun and ring makes a simple set.
    let is_simple = bounds.arrangement == Arrangement::Stepped && teeth[1] == teeth[2];
    doubled(bounds.arrangement, teeth).iter().all(has_centre) && !is_simple
}

/// Ratio by Gaussian elimination of the meshes' equations; `None` where it is not determined.
fn ratio(arrangement: Arrangement, teeth: &[u32], mode: ArrangementMode) -> Option<f64> {
    let gears = arrangement.gears().len();
    let carrier = gears;
    let place = |member: ArrangementMember| member.gear().unwrap_or(carrier);
    let mut lines: Vec<[f64; LAST + 1]> = vec![];
    let mut add = |terms: &[(usize, f64)], right: f64| {
        let mut line = [0.0; LAST + 1];
        terms.iter().for_each(|(place, factor)| line[*place] += factor);
        line[LAST] = right;
        lines.push(line);
    };
    for (number, &[one, other]) in arrangement.meshes().iter().enumerate() {
        let is_internal = match arrangement {
            Arrangement::Stepped | Arrangement::Wolfrom => number > 0,
            Arrangement::SteppedRings | Arrangement::InternalPair => true,
            Arrangement::Ravigneaux => number == 3,
            _ => false,
        };
        let (first, second) = (f64::from(teeth[one]), f64::from(teeth[other]));
        let second = if is_internal { -second } else { second };
        add(&[(one, first), (other, second), (carrier, -first - second)], 0.0);
    }
    if arrangement.has_steps() {
        let second = if arrangement == Arrangement::Wolfrom { 3 } else { 2 };
        add(&[(1, 1.0), (second, -1.0)], 0.0);
    }
    add(&[(place(mode.fixed), 1.0)], 0.0);
    add(&[(place(mode.output), 1.0)], 1.0);
    let unknowns = gears + 1;
    for column in 0..unknowns {
        let pivot = (column..lines.len())
            .max_by(|one, other| lines[*one][column].abs().total_cmp(&lines[*other][column].abs()))?;
        if lines[pivot][column].abs() < 1e-9 {
            return None;
        }
        lines.swap(column, pivot);
        let own = lines[column];
        for (_, line) in lines.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let factor = line[column] / own[column];
            line.iter_mut().zip(own).for_each(|(value, own)| *value -= factor * own);
        }
    }
    let input = place(mode.input);
    Some(lines[input][LAST] / lines[input][input])
}

/// Whether a planet, turned by any number of its teeth, meets every central gear moved on by `z/N` teeth.
fn assembles(arrangement: Arrangement, z: &[u32], planets: u32) -> bool {
    let z: Vec<i64> = z.iter().map(|&teeth| i64::from(teeth)).collect();
    let n = i64::from(planets);
    // The first step turns by (c + k·N)/(N·g) revolutions; the sign is that of a ring.
    let meets = |turns: [i64; 2], step: i64, central: i64| {
        let [over, under] = turns;
        (step * over * n - central * under) % (under * n) == 0
    };
    let steps = |first: i64, others: &[(i64, i64)]| {
        (0..z[1]).any(|k| {
            let turns = [first + k * n, n * z[1]];
            others.iter().all(|&(step, central)| meets(turns, step, central))
        })
    };
    match arrangement {
        Arrangement::Stepped => steps(z[0], &[(-z[2], z[3])]),
        Arrangement::SteppedSuns => steps(z[0], &[(z[2], z[3])]),
        Arrangement::SteppedRings => steps(-z[0], &[(-z[2], z[3])]),
        Arrangement::Wolfrom => steps(z[0], &[(-z[1], z[2]), (-z[3], z[4])]),
        Arrangement::Ravigneaux => (0..z[1]).any(|k| {
            // The short planet turns by (a + k·N)/(N·g), the long one by any number of its teeth against it.
            let short = [z[0] + k * n, n * z[1]];
            (0..z[2]).any(|l| {
                let long = [-z[1] * short[0] + l * short[1], z[2] * short[1]];
                meets(long, z[2], z[3]) && meets(long, -z[2], z[4])
            })
        }),
        Arrangement::ExternalPair | Arrangement::InternalPair => true,
    }
}

/// Meshes of each tree of gears at one centre distance, a ring second; of a planet of one gear those of all.
fn trees(arrangement: Arrangement, z: &[u32]) -> Vec<Vec<[usize; 2]>> {
    match arrangement {
        Arrangement::Stepped => vec![vec![[0, 1]], vec![[2, 3]]],
        Arrangement::SteppedSuns if z[1] == z[2] => vec![vec![[0, 1], [3, 1]]],
        Arrangement::SteppedSuns => vec![vec![[0, 1]], vec![[3, 2]]],
        Arrangement::SteppedRings if z[1] == z[2] => vec![vec![[1, 0], [1, 3]]],
        Arrangement::SteppedRings => vec![vec![[1, 0]], vec![[2, 3]]],
        Arrangement::Wolfrom if z[1] == z[3] => vec![vec![[0, 1], [1, 2], [1, 4]]],
        Arrangement::Wolfrom => vec![vec![[0, 1], [1, 2]], vec![[3, 4]]],
        Arrangement::Ravigneaux => vec![vec![[0, 1]], vec![[3, 2], [2, 4]]],
        Arrangement::ExternalPair | Arrangement::InternalPair => vec![],
    }
}

fn is_ring(arrangement: Arrangement, gear: usize) -> bool {
    match arrangement {
        Arrangement::Stepped => gear == 3,
        Arrangement::SteppedRings => gear == 0 || gear == 3,
        Arrangement::Wolfrom => gear == 2 || gear == 4,
        Arrangement::Ravigneaux => gear == 4,
        Arrangement::InternalPair => gear == 1,
        Arrangement::SteppedSuns | Arrangement::ExternalPair => false,
    }
}

/// Radius of the centres of planets, from the doubled distances of their meshes.
fn radius(distances: &[i64]) -> f64 {
    let (least, most) = (distances.iter().min(), distances.iter().max());
    (least.copied().unwrap_or(0) + most.copied().unwrap_or(0)) as f64 / 4.0
}

/// Gears of a tree by its meshes, their teeth and the doubled distances.
type Known = HashMap<(Vec<[usize; 2]>, Vec<u32>, u64), Option<Vec<(usize, InvoluteGear)>>>;

/// Tip radii of the gears, and the centre distance of planets in mesh.
struct Shape {
    tips: Vec<f64>,
    distance: f64,
}

impl Shape {
    fn plain(bounds: &ArrangementBounds, z: &[u32]) -> Self {
        let tip = |(gear, teeth): (usize, &u32)| {
            let addendum = bounds.rack.addendum;
            let outwards = if is_ring(bounds.arrangement, gear) { -addendum } else { addendum };
            f64::from(*teeth) / 2.0 + outwards
        };
        let tips = z.iter().enumerate().map(tip).collect();
        Self { tips, distance: f64::from(z[1] + z.get(2).unwrap_or(&0)) / 2.0 }
    }

    /// Gears with the shifts that the aim picks; `None` where a check fails.
    fn shifted(bounds: &ArrangementBounds, z: &[u32], known: &mut Known) -> Option<Self> {
        let arrangement = bounds.arrangement;
        let [first, second] = doubled(arrangement, z);
        let mut gears: Vec<Option<InvoluteGear>> = vec![None; z.len()];
        for (place, meshes) in trees(arrangement, z).into_iter().enumerate() {
            let is_second = arrangement == Arrangement::Ravigneaux && place == 1;
            let distance = radius(if is_second { &second } else { &first });
            let mut own: Vec<usize> = meshes.iter().flatten().copied().collect();
            own.sort_unstable();
            own.dedup();
            let teeth = own.iter().map(|gear| z[*gear]).collect();
            let chosen = known.entry((meshes.clone(), teeth, distance.to_bits())).or_insert_with(|| {
                let gear = |gear: &usize| {
                    let kind =
                        if is_ring(arrangement, *gear) { GearKind::Internal } else { GearKind::External };
                    InvoluteGear::searched(
                        kind,
                        ToothCount::new(z[*gear]).ok()?,
                        Profile::of_rack(bounds.rack),
                    )
                    .ok()
                };
                let at = |gear: usize| own.iter().position(|one| *one == gear).unwrap_or_default();
                let stated =
                    meshes.iter().map(|mesh| StatedDistance { gears: mesh.map(at), distance }).collect();
                let tree = MeshTree::new(own.iter().map(gear).collect::<Option<_>>()?, stated).ok()?;
                let chosen = tree.choose(bounds.aim, &bounds.limits).ok()?;
                Some(own.iter().copied().zip(chosen.gears).collect())
            });
            for (gear, own) in chosen.as_ref()? {
                gears[*gear] = Some(*own);
            }
        }
        let step = if arrangement == Arrangement::Wolfrom { 3 } else { 2 };
        gears[step] = gears[step].or(gears[1]);
        let gears: Vec<InvoluteGear> = gears.into_iter().collect::<Option<_>>()?;
        let distance = match arrangement {
            Arrangement::Ravigneaux => planet_distance(bounds, gears[1], gears[2])?,
            _ => 0.0,
        };
        Some(Self { tips: gears.iter().map(|gear| gear.tip_diameter() / 2.0).collect(), distance })
    }

    /// Whether gears that do not mesh are apart, by the coordinates of their centres.
    fn is_apart(&self, bounds: &ArrangementBounds, z: &[u32], planets: u32) -> bool {
        let gap = bounds.tip_gap + 1e-9;
        let [first, second] = doubled(bounds.arrangement, z);
        // Gears of one planet: place, radius of the centre, angle about the axis.
        let mut gears = vec![];
        if bounds.arrangement == Arrangement::Ravigneaux {
            let (short, long) = (radius(&first), radius(&second));
            let apart = |angle: f64| libm::hypot(long * libm::cos(angle) - short, long * libm::sin(angle));
            let (mut near, mut far) = (0.0, TAU / 2.0);
            // A flat triangle closes but for rounding.
            if apart(near) > self.distance + 1e-12 || apart(far) < self.distance - 1e-12 {
                return false;
            }
            for _ in 0..60 {
                let middle = (near + far) / 2.0;
                if apart(middle) > self.distance { far = middle } else { near = middle }
            }
            gears.extend([(1, short, 0.0), (2, long, near)]);
            if self.tips[4] - short - self.tips[1] <= gap || long - self.tips[2] - self.tips[0] <= gap {
                return false;
            }
        } else {
            let step = if bounds.arrangement == Arrangement::Wolfrom { 3 } else { 2 };
            gears.extend([(1, radius(&first), 0.0), (step, radius(&first), 0.0)]);
        }
        let are_steps = bounds.arrangement.has_steps();
        gears.iter().all(|&(one, r, at)| {
            gears.iter().filter(|other| !are_steps || other.0 == one).all(|&(other, s, from)| {
                (1..planets).all(|turn| {
                    let angle = from + TAU * f64::from(turn) / f64::from(planets) - at;
                    let distance = libm::hypot(s * libm::cos(angle) - r, s * libm::sin(angle));
                    distance - self.tips[one] - self.tips[other] > gap
                })
            })
        })
    }
}

/// Centre distance of two planets in mesh without backlash, by halving; `None` where a check of their mesh
/// fails.
fn planet_distance(bounds: &ArrangementBounds, short: InvoluteGear, long: InvoluteGear) -> Option<f64> {
    let inv = |angle: f64| libm::tan(angle) - angle;
    let alpha = bounds.rack.pressure_angle.get::<uom::si::angle::radian>();
    let teeth = short.teeth().as_f64() + long.teeth().as_f64();
    let wanted = inv(alpha) + 2.0 * libm::tan(alpha) * (short.shift() + long.shift()) / teeth;
    let (mut low, mut high) = (0.0, TAU / 4.0);
    for _ in 0..100 {
        let middle = (low + high) / 2.0;
        if inv(middle) > wanted { high = middle } else { low = middle }
    }
    let distance = teeth / 2.0 * libm::cos(alpha) / libm::cos(low);
    let pair = Pair::at_centre_distance(short, long, distance).ok()?;
    let mut is_good = wanted > 0.0;
    mesh_checks(&(), &[(), ()], &pair, &bounds.limits, &mut |check| {
        is_good &= check.holds() || check.rule.severity() == Severity::Remark;
    });
    is_good.then_some(distance)
}
