//! The cheapest sweeps: A* over the lists of [`sweep`](super::sweep).

use super::sweep::{ALONG, Arm, BEND, Form, HOUSE, Line, Net, Side, State, Step, Taking, Task};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A state on the way, with the step that led to it.
struct Node {
    state: State,
    cost: u32,
    from: Option<(usize, Step)>,
}

/// A sweep to the end, and how many states were met on the way to it or to no end.
pub(super) struct Found {
    pub(super) steps: Option<Vec<Step>>,
    pub(super) states: usize,
}

/// A cheap sweep, after at most `most` states.
///
/// The estimate of the remaining cost is weighted by `haste` tenths. From 10 on, a larger value finds a sweep
/// sooner, and the sweep is dearer by at most that factor, but for the error of the estimate.
pub(super) fn sweep(task: &Task, haste: u32, most: usize) -> Found {
    let mut nodes = vec![Node { state: task.start(), cost: 0, from: None }];
    let mut known: FxHashMap<State, u32> = FxHashMap::default();
    known.insert(nodes[0].state, 0);
    let mut waiting = BinaryHeap::from([Reverse((0, 0, 0))]);
    while let Some(Reverse((_, _, node))) = waiting.pop() {
        let Node { state, cost, .. } = nodes[node];
        if task.is_done(&state) {
            return Found { steps: Some(steps(&nodes, node)), states: nodes.len() };
        }
        if known.get(&state).is_some_and(|&least| least < cost) {
            continue;
        }
        if nodes.len() > most {
            break;
        }
        for step in possible(task, &state) {
            let Some((next, more)) = Taking::new(task, state, &mut ()).take(step) else { continue };
            let cost = cost + more;
            let least = known.entry(next).or_insert(u32::MAX);
            if *least <= cost {
                continue;
            }
            *least = cost;
            nodes.push(Node { state: next, cost, from: Some((node, step)) });
            let left = task.rows.len() - next.placed.count_ones() as usize;
            waiting.push(Reverse((10 * cost + haste * at_least(task, &next), left, nodes.len() - 1)));
        }
    }
    Found { steps: None, states: nodes.len() }
}

fn steps(nodes: &[Node], end: usize) -> Vec<Step> {
    let mut steps = vec![];
    let mut node = end;
    while let Some((from, step)) = nodes[node].from {
        steps.push(step);
        node = from;
    }
    steps.reverse();
    steps
}

/// Lower bound of the cost of the remaining steps.
fn at_least(task: &Task, state: &State) -> u32 {
    let lines = || state.below.lines().iter().chain(state.above.lines());
    let open = |place: usize| state.placed >> place & 1 == 0;
    let mut cost = 0;
    for (place, row) in task.rows.iter().enumerate().filter(|(place, _)| open(*place)) {
        // Sun and ring are there, and the carrier reaches what it is joined with.
        cost += 2 * ALONG;
        let carrier = row.members[2];
        let others = task.open_rows(state, carrier) & !(1 << place);
        let is_joined = task.open_ties(state, carrier) != 0
            || (carrier == task.output && !task.same_side)
            || lines().any(|line| line.net == carrier);
        let is_beside = |other: usize| task.rows[other].members[2] == carrier;
        let level = state.level.is_some_and(|(net, _)| net == carrier)
            || (0..task.rows.len()).any(|other| others >> other & 1 == 1 && is_beside(other));
        if (is_joined || others != 0) && !level {
            cost += BEND;
        }
    }
    // A line that continues is met again later.
    for line in lines() {
        let same = |other: &&Line| other.net == line.net && other.part == line.part;
        if line.form == Form::Point || line.form == Form::Through && lines().filter(same).count() == 1 {
            cost += 2 * BEND;
        }
    }
    for (net, carries) in task.carries.iter().enumerate().skip(1) {
        let net = Net::try_from(net).unwrap_or(HOUSE);
        if lines().any(|line| line.net == net) || state.level.is_some_and(|level| level.0 == net) {
            continue;
        }
        // One above the other a gear and a shift element meet a line in one place.
        let rows = task.open_rows(state, net);
        let gears = (rows & !carries).count_ones();
        let all = rows.count_ones() + task.open_ties(state, net).count_ones();
        if gears > 1 || gears > 0 && all > 2 && rows & carries == 0 {
            cost += 2 * BEND;
        }
    }
    cost
}

/// The steps that may lead on.
fn possible(task: &Task, state: &State) -> Vec<Step> {
    let mut steps = vec![];
    sets(task, state, &mut steps);
    if state.level.is_some() {
        return steps;
    }
    let [below, above] = [state.below.last(), state.above.last()];
    if let Some(line) = below
        && above.is_some_and(|above| above.net != line.net || above.part != line.part)
    {
        steps.push(Step::Cross { from: Side::Below });
    }
    if let Some(line) = above
        && below.is_none_or(|below| below.net != line.net)
        && (line.net != HOUSE || task.open_rows(state, HOUSE) != 0)
    {
        steps.push(Step::Cross { from: Side::Above });
    }
    for net in 1..task.pieces.len() {
        let Ok(net) = u8::try_from(net) else { continue };
        let is_begun = state.below.lines().iter().chain(state.above.lines()).any(|line| line.net == net);
        let rows = task.open_rows(state, net).count_ones();
        if !is_begun && rows > 0 && rows + task.open_ties(state, net).count_ones() > 1 {
            steps.push(Step::Rise { net });
        }
    }
    for side in [Side::Below, Side::Above] {
        let lines = state.side(side).lines();
        for (place, line) in lines.iter().enumerate() {
            let is_wall = side == Side::Above && place == 0;
            let same = |other: &&Line| other.net == line.net && other.part == line.part;
            let twice = state.below.lines().iter().chain(state.above.lines()).filter(same).count() > 1;
            // The line blocks the next step, or a shift element.
            let is_last = place + 1 == lines.len();
            let between = place > 0
                && lines.get(place + 1).is_some_and(|inner| {
                    let outer = lines[place - 1].net;
                    task.open_ties(state, outer) & task.open_ties(state, inner.net) != 0
                });
            if twice && !is_wall && line.form != Form::Point && (is_last || between) {
                steps.push(Step::End { side, place });
            }
        }
        let Some(last) = lines.last() else { continue };
        for net in 1..task.pieces.len() {
            let Ok(net) = u8::try_from(net) else { continue };
            let is_begun = state.below.lines().iter().chain(state.above.lines()).any(|line| line.net == net);
            let without_sets = !task.rows.iter().any(|row| row.members.contains(&net));
            if without_sets && !is_begun && task.open_ties(state, net) & task.open_ties(state, last.net) != 0
            {
                steps.push(Step::Begin { net, side });
            }
        }
    }
    steps
}

fn sets(task: &Task, state: &State, steps: &mut Vec<Step>) {
    let open = |place: usize| state.placed >> place & 1 == 0;
    for (row, set) in task.rows.iter().enumerate().filter(|(place, _)| open(*place)) {
        let carrier = set.members[2];
        // A set of several rows is drawn without anything between them.
        let rest = |of: usize| {
            task.rows.iter().enumerate().filter(|(place, other)| other.of == of && open(*place)).count()
        };
        let size = |of: usize| task.rows.iter().filter(|row| row.of == of).count();
        let is_begun = rest(set.of) < size(set.of);
        if task.keeps_together {
            let half_done = task.rows.iter().map(|row| row.of).find(|&of| (1..size(of)).contains(&rest(of)));
            if half_done.is_some_and(|of| of != set.of) {
                continue;
            }
        }
        let held = |side: Side| state.side(side).last().is_some_and(|line| line.net == carrier);
        let begun = state.below.lines().iter().chain(state.above.lines()).any(|line| line.net == carrier);
        let needs = (task.open_rows(state, carrier) & !(1 << row)).count_ones()
            + task.open_ties(state, carrier).count_ones()
            + u32::from(carrier == task.output && !task.same_side)
            + u32::from(begun || carrier == HOUSE);
        let lefts: Vec<Arm> = match state.level {
            Some((net, _)) if net != carrier => continue,
            Some(_) => vec![Arm { level: true, ..Arm::default() }],
            None if task.keeps_together && is_begun => continue,
            None => {
                let arms = (0..4).map(|arm| Arm { below: arm & 1 == 1, above: arm & 2 == 2, level: false });
                arms.collect()
            }
        };
        let another = task
            .rows
            .iter()
            .enumerate()
            .any(|(place, other)| place != row && open(place) && other.members[2] == carrier);
        let must = task.keeps_together && rest(set.of) > 1;
        for &left in &lefts {
            for arm in 0..8 {
                let right = Arm { below: arm & 1 == 1, above: arm & 2 == 2, level: arm & 4 == 4 };
                if right.level && !another || must && right != (Arm { level: true, ..Arm::default() }) {
                    continue;
                }
                // Arms that go the same way on both sides close a ring around sun or ring.
                if left.below && right.below || left.above && right.above {
                    continue;
                }
                if carrier == HOUSE && right.level && !must {
                    continue;
                }
                let new = |arm: Arm| {
                    [Side::Below, Side::Above]
                        .iter()
                        .filter(|&&side| arm.reaches(side) && !held(side))
                        .count()
                };
                let arms = [left, right].map(new);
                if arms.iter().sum::<usize>() as u32 > needs.min(2) || arms.contains(&2) {
                    continue;
                }
                let bent = |arm: Arm| arm.below || arm.above;
                if needs == 0 && (bent(left) || bent(right)) {
                    continue;
                }
                steps.push(Step::Set { row, left, right });
            }
        }
    }
}
