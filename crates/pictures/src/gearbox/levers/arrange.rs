//! Arrangement of the levers: their order, their upper ends and their heights, so that ties are level and
//! cross as little as possible.
//!
//! A *tie* joins two points of different levers: the next points of one link, or the links of a clutch. An
//! arrangement costs
//!
//! ```text
//! 100·(ties that cross, or run through the point of another link)  +  30·(levers that ties cross)
//!   +  Σ |rise of a tie|, mm  +  5·Σ levers between the ends of a tie
//! ```
//!
//! A clutch between two links of one lever is an upright tie to the left of it. Every tie that passes there,
//! or comes from the left between its ends, crosses it, and so does the end of another such clutch.
//!
//! For one order and given upper ends of all levers, heights and lengths minimize the sum of the squared
//! rises, with lengths between 0.8 and 1.3 of the usual one. Up to five levers, all orders and directions are
//! tried. For more levers, the order is improved from that of the file by exchanging two levers or turning
//! one while this costs less. The result then need not be the best.

use super::merge::Lever;
use crate::tolerance::LEVEL;
use epicyclic_train::LinkId;

/// The usual length of a lever.
const LENGTH_MM: f64 = 70.0;
/// Shortest and longest lever, over the usual one.
const STRETCH: [f64; 2] = [0.8, 1.3];
/// Largest number of levers for which every arrangement is tried.
const ALL_TRIED: usize = 5;
/// A tie nearer than this to a point seems to belong to it.
const NEAR_MM: f64 = 4.0;
/// Weights of the usual length of a lever and of the usual height of its middle against a level tie of a
/// link.
const USUAL: [f64; 2] = [0.002, 0.0005];
/// Weight of a level tie of a clutch.
const CLUTCH: f64 = 0.02;
/// Steps of the iteration for the heights, at most.
const STEPS: usize = 120;

/// A lever on paper: heights of its points from the lowest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Column {
    /// Index of its lever.
    pub(super) lever: usize,
    pub(super) points: Vec<(LinkId, f64)>,
}

/// Two points that are joined: of a link in two columns, or of a clutch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tie {
    /// Column and link of both ends.
    pub(super) ends: [(usize, LinkId); 2],
    /// The clutch, by its place among the shift elements.
    pub(super) clutch: Option<usize>,
}

/// The columns from left to right, at the least cost.
pub(super) fn arrange(levers: &[Lever], clutches: &[(usize, [LinkId; 2])]) -> Vec<Column> {
    let usual: Vec<usize> = (0..levers.len()).collect();
    let of = |order: &[usize], turned: &[bool]| {
        let columns = heights(levers, order, turned, clutches);
        (cost(&columns, &ties(&columns, clutches)), columns)
    };
    let mut turned = vec![false; levers.len()];
    let mut best = of(&usual, &turned);
    // `at_least` is the least cost of the order, whichever ends are up.
    let mut better = |order: &[usize], turned: &[bool], at_least: f64| {
        if at_least >= best.0 - LEVEL {
            return false;
        }
        let next = of(order, turned);
        let is_better = next.0 < best.0 - LEVEL;
        if is_better {
            best = next;
        }
        is_better
    };
    // A clutch of one lever is drawn on its left, so that mirror images differ.
    let is_beside = |(_, links): &(usize, [LinkId; 2])| {
        let has = |lever: &Lever, link| lever.nodes.iter().any(|node| node.0 == link);
        levers.iter().any(|lever| links.iter().all(|&link| has(lever, link)))
    };
    let is_one_sided = clutches.iter().any(is_beside);
    if levers.len() <= ALL_TRIED {
        for order in permutations(levers.len()) {
            let at_least = cost_of_order(levers, &order, clutches);
            for senses in 0..1_u32 << levers.len() {
                let turned: Vec<bool> = (0..levers.len()).map(|lever| senses >> lever & 1 == 1).collect();
                // One of two mirror images is enough if they cost the same.
                if (is_one_sided || order.first() <= order.last()) && !turned[0] {
                    better(&order, &turned, at_least);
                }
            }
        }
    } else {
        let mut order = usual;
        loop {
            let mut moved = false;
            for one in 0..order.len() {
                turned[one] = !turned[one];
                let is_better = better(&order, &turned, 0.0);
                moved |= is_better;
                if !is_better {
                    turned[one] = !turned[one];
                }
                for other in one + 1..order.len() {
                    order.swap(one, other);
                    let is_better = better(&order, &turned, 0.0);
                    moved |= is_better;
                    if !is_better {
                        order.swap(one, other);
                    }
                }
            }
            if !moved {
                break;
            }
        }
    }
    best.1
}

/// Permutations of `count` items, the usual order first.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    let mut all = vec![vec![]];
    for _ in 0..count {
        let longer = |order: &Vec<usize>| {
            let order = order.clone();
            (0..count)
                .filter(|next| !order.contains(next))
                .map(|next| [order.clone(), vec![next]].concat())
                .collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

/// Ties between the columns: each link from one of its columns to the next, and each clutch between the
/// nearest columns of its links.
pub(super) fn ties(columns: &[Column], clutches: &[(usize, [LinkId; 2])]) -> Vec<Tie> {
    let mut found = vec![];
    let of = |link: LinkId| {
        let has = move |column: &&Column| column.points.iter().any(|point| point.0 == link);
        columns.iter().enumerate().filter(move |(_, column)| has(column)).map(|(place, _)| place)
    };
    let mut links: Vec<LinkId> =
        columns.iter().flat_map(|column| &column.points).map(|point| point.0).collect();
    links.sort_unstable();
    links.dedup();
    for link in links.into_iter().filter(|link| *link != LinkId::GROUND) {
        let places: Vec<usize> = of(link).collect();
        let pairs = places.windows(2).map(|pair| [(pair[0], link), (pair[1], link)]);
        found.extend(pairs.map(|ends| Tie { ends, clutch: None }));
    }
    for &(clutch, [one, other]) in clutches {
        let pairs = of(one).flat_map(|a| of(other).map(move |b| (a, b)));
        if let Some((a, b)) = pairs.min_by_key(|(a, b)| a.abs_diff(*b)) {
            let ends = if a <= b { [(a, one), (b, other)] } else { [(b, other), (a, one)] };
            found.push(Tie { ends, clutch: Some(clutch) });
        }
    }
    found
}

/// Height of a link's point in a column.
pub(super) fn height(column: &Column, link: LinkId) -> f64 {
    column.points.iter().find(|point| point.0 == link).map_or(0.0, |point| point.1)
}

/// The columns in an order, with the heights and lengths of the least squared rises.
fn heights(
    levers: &[Lever],
    order: &[usize],
    turned: &[bool],
    clutches: &[(usize, [LinkId; 2])],
) -> Vec<Column> {
    // From 0 to 1 along each lever; a single point is its middle.
    let column = |&lever: &usize| {
        let (low, high) = levers[lever].ends();
        let part = |at: f64| if high > low { (at - low) / (high - low) } else { 0.5 };
        let up = |at: f64| if turned[lever] { 1.0 - part(at) } else { part(at) };
        let mut points: Vec<(LinkId, f64)> =
            levers[lever].nodes.iter().map(|&(link, at)| (link, up(at))).collect();
        points.sort_by(|a, b| a.1.total_cmp(&b.1));
        Column { lever, points }
    };
    let mut columns: Vec<Column> = order.iter().map(column).collect();
    // Each tie from both its ends: part of the lever, the other column, part of that, weight.
    let mut seen: Vec<Vec<(f64, usize, f64, f64)>> = vec![vec![]; columns.len()];
    for tie in ties(&columns, clutches).iter().filter(|tie| tie.ends[0].0 != tie.ends[1].0) {
        let weight = if tie.clutch.is_some() { CLUTCH } else { 1.0 };
        let [(one, at), (other, there)] = tie.ends;
        let [at, there] = [height(&columns[one], at), height(&columns[other], there)];
        seen[one].push((at, other, there, weight));
        seen[other].push((there, one, at, weight));
    }
    // Normal equations of weight·(o + s·t − wanted)² over the ties, and of s near 1 and o + s/2 near 1/2. The
    // left side does not change as the levers move.
    let [stiff, centred] = USUAL;
    let sums = seen.iter().map(|seen| {
        let mut sums = [centred, 0.5 * centred, 0.25 * centred + stiff];
        for &(t, _, _, weight) in seen {
            for (sum, by) in sums.iter_mut().zip([1.0, t, t * t]) {
                *sum += weight * by;
            }
        }
        sums
    });
    let sums: Vec<[f64; 3]> = sums.collect();
    let mut place = vec![(0.0_f64, 1.0_f64); columns.len()];
    // Each lever in turn takes the best place for those of the others: the sum falls with each.
    for _ in 0..STEPS {
        let mut moved = 0.0_f64;
        for at in 0..columns.len() {
            let mut right = [0.5 * centred, 0.25 * centred + stiff];
            for &(t, other, there, weight) in &seen[at] {
                let wanted = place[other].0 + place[other].1 * there;
                for (sum, by) in right.iter_mut().zip([1.0, t]) {
                    *sum += weight * by * wanted;
                }
            }
            let [n, t, tt] = sums[at];
            let stretch = ((n * right[1] - t * right[0]) / (n * tt - t * t)).clamp(STRETCH[0], STRETCH[1]);
            let next = ((right[0] - stretch * t) / n, stretch);
            moved = moved.max((next.0 - place[at].0).abs()).max((next.1 - place[at].1).abs());
            place[at] = next;
        }
        if LENGTH_MM * moved < LEVEL {
            break;
        }
    }
    for (column, (from, stretch)) in columns.iter_mut().zip(place) {
        for point in &mut column.points {
            point.1 = LENGTH_MM * (from + stretch * point.1);
        }
    }
    columns
}

/// Cost of an order for any choice of the upper ends: the levers between the ends of ties.
fn cost_of_order(levers: &[Lever], order: &[usize], clutches: &[(usize, [LinkId; 2])]) -> f64 {
    let columns: Vec<Column> =
        order.iter().map(|&lever| Column { lever, points: levers[lever].nodes.clone() }).collect();
    let between = |tie: &Tie| (tie.ends[1].0 - tie.ends[0].0).saturating_sub(1);
    5.0 * ties(&columns, clutches).iter().map(between).sum::<usize>() as f64
}

/// Cost of an arrangement.
fn cost(columns: &[Column], ties: &[Tie]) -> f64 {
    let end = |tie: &Tie, end: usize| {
        let (column, link) = tie.ends[end];
        [column as f64, height(&columns[column], link)]
    };
    let level = |tie: &Tie, x: f64| {
        let ([x0, y0], [x1, y1]) = (end(tie, 0), end(tie, 1));
        y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    };
    let (mut crossings, mut passed) = (0, 0);
    let (mut rise, mut between) = (0.0, 0);
    for (place, tie) in ties.iter().enumerate() {
        let [(first, one), (last, other)] = tie.ends;
        if first == last {
            let [low, high] = {
                let [[_, one], [_, other]] = [end(tie, 0), end(tie, 1)];
                [one.min(other), one.max(other)]
            };
            let inside = |y: f64| low < y && y < high;
            let crossed = ties.iter().enumerate().map(|(next_place, next)| {
                let [(from, _), (to, _)] = next.ends;
                match () {
                    // The outer of two beside one lever; the inner one is counted with it.
                    () if from == to && from == first && next_place > place => {
                        [0, 1].into_iter().filter(|&at| inside(end(next, at)[1])).count()
                    }
                    () if from < first && first <= to => usize::from(inside(level(next, first as f64))),
                    () => 0,
                }
            });
            crossings += crossed.sum::<usize>();
            continue;
        }
        rise += (end(tie, 0)[1] - end(tie, 1)[1]).abs();
        between += last - first - 1;
        for (column, x) in columns.iter().enumerate().take(last).skip(first + 1) {
            let y = level(tie, column as f64);
            let near =
                |(link, at): &(LinkId, f64)| *link != one && *link != other && (at - y).abs() < NEAR_MM;
            crossings += usize::from(x.points.iter().any(near));
            let inside = |points: &[(LinkId, f64)]| match points {
                [(_, low), .., (_, high)] => (*low..=*high).contains(&y),
                _ => false,
            };
            passed += usize::from(inside(&x.points));
        }
        for next in &ties[place + 1..] {
            let (left, right) = (first.max(next.ends[0].0) as f64, last.min(next.ends[1].0) as f64);
            if left >= right {
                continue;
            }
            let [from, to] = [left, right].map(|x| level(tie, x) - level(next, x));
            // At an end that both have they only meet.
            let shared = |x: f64, apart: f64| {
                let here = |tie: &Tie| tie.ends.iter().find(|end| end.0 as f64 == x).map(|end| end.1);
                apart.abs() < LEVEL && here(tie).is_some() && here(tie) == here(next)
            };
            let alike = from.abs() < NEAR_MM && to.abs() < NEAR_MM;
            let cross = from * to < 0.0 && from.abs().min(to.abs()) > LEVEL;
            crossings += usize::from(alike || (cross && !shared(left, from) && !shared(right, to)));
        }
    }
    100.0 * crossings as f64 + 30.0 * passed as f64 + rise + 5.0 * between as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn link(index: usize) -> LinkId {
        let names: Vec<String> = (0..9).map(|i| format!("l{i}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let set = epicyclic_train::set::SetSpec::simple("1", ["l0", "l1", "l2"], 2.0);
        let builder = epicyclic_train::Gearbox::builder("links").links(names).set(set);
        builder.input("l0").output("l1").build().unwrap().link(&format!("l{index}")).unwrap()
    }

    fn lever(nodes: &[(usize, f64)]) -> Lever {
        Lever { sets: vec![0], nodes: nodes.iter().map(|&(at, place)| (link(at), place)).collect() }
    }

    /// Counted by hand: two levers upside down to each other cross their two ties, which rise by 70 mm each
    /// at the usual length.
    #[test]
    fn the_cost_is_that_counted_by_hand() {
        let column = |lever, points: [(usize, f64); 2]| Column {
            lever,
            points: points.map(|(at, y)| (link(at), y)).to_vec(),
        };
        let crossed = [column(0, [(0, 0.0), (1, 70.0)]), column(1, [(1, 0.0), (0, 70.0)])];
        assert_eq!(cost(&crossed, &ties(&crossed, &[])), 100.0 + 2.0 * 70.0);
        let level = [column(0, [(0, 0.0), (1, 70.0)]), column(1, [(0, 0.0), (1, 70.0)])];
        assert_eq!(cost(&level, &ties(&level, &[])), 0.0);
        // A tie past a lever between its ends, 35 mm high on it.
        let past = [
            column(0, [(0, 0.0), (1, 35.0)]),
            column(1, [(2, 0.0), (3, 70.0)]),
            column(2, [(1, 35.0), (4, 70.0)]),
        ];
        assert_eq!(cost(&past, &ties(&past, &[])), 30.0 + 5.0);
    }

    /// A clutch over a whole lever, to the left of it: a tie that comes from the left to its middle crosses
    /// it, and none that leaves to the right. So the lever comes first.
    #[test]
    fn a_clutch_beside_its_lever_keeps_clear_of_ties() {
        let clutch = [(0, [link(1), link(3)])];
        let column = |lever, points: [usize; 3]| Column {
            lever,
            points: points.into_iter().zip([0.0, 35.0, 70.0]).map(|(at, y)| (link(at), y)).collect(),
        };
        let (own, other) = (column(1, [1, 2, 3]), column(0, [0, 2, 4]));
        let behind = [other.clone(), own.clone()];
        assert_eq!(cost(&behind, &ties(&behind, &clutch)), 100.0);
        let first = [own.clone(), other.clone()];
        assert_eq!(cost(&first, &ties(&first, &clutch)), 0.0);
        let levers = [lever(&[(0, 0.0), (2, 1.0), (4, 2.0)]), lever(&[(1, 0.0), (2, 1.0), (3, 2.0)])];
        assert_eq!(arrange(&levers, &clutch)[0].lever, 1);
        // Two clutches beside one lever, of which the outer ends between the ends of the inner one.
        let long = [Column { lever: 0, points: (0..4).map(|at| (link(at), 20.0 * at as f64)).collect() }];
        let nested = |pairs: [[usize; 2]; 2]| {
            let pairs: Vec<_> = pairs.into_iter().enumerate().map(|(i, pair)| (i, pair.map(link))).collect();
            cost(&long, &ties(&long, &pairs))
        };
        assert_eq!(nested([[0, 2], [1, 3]]), 100.0);
        assert_eq!(nested([[1, 2], [0, 3]]), 0.0);
    }

    /// Three levers in a chain, the middle one upside down and last in the file: level ties, none over a
    /// lever.
    #[test]
    fn a_chain_gets_level_ties() {
        let levers = [
            lever(&[(0, 0.0), (1, 1.0), (2, 3.0)]),
            lever(&[(3, 0.0), (4, 2.0), (5, 3.0)]),
            lever(&[(2, 0.0), (6, 2.0), (3, 3.0)]),
        ];
        let columns = arrange(&levers, &[]);
        let ties = ties(&columns, &[]);
        assert_eq!(ties.len(), 2);
        assert_eq!(columns[1].lever, 2, "{columns:?}");
        assert!(cost(&columns, &ties) < 1.0, "{}: {columns:?}", cost(&columns, &ties));
    }

    /// More levers than are all tried: still no worse than in the file's order.
    #[test]
    fn many_levers_cost_no_more_than_as_they_came() {
        let levers: Vec<Lever> =
            (0..7).map(|i| lever(&[(i, 0.0), (8 - i, 1.0), ((i + 3) % 9, 2.5)])).collect();
        let usual = heights(&levers, &[0, 1, 2, 3, 4, 5, 6], &[false; 7], &[]);
        let columns = arrange(&levers, &[]);
        assert!(cost(&columns, &ties(&columns, &[])) <= cost(&usual, &ties(&usual, &[])));
    }
}
