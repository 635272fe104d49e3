//! Drawings with all sets in one band, as a sequence of steps from left to right.
//!
//! An upright line through the drawing meets, from the axis up, the lines of links below the band, the band
//! with the planets, and the lines above it. The uppermost is the housing. From left to right this list
//! changes only at its two ends next to the band. The sun of a set ends on the uppermost line below or begins
//! a line there. Its ring does the same above, an arm of its carrier on either side. Between two sets a link
//! may cross the band, and a shift element joins two neighbouring lines. These lists describe all drawings
//! without a crossing that have their sets in one band, so a search over them misses none.

use super::cost;
use super::scheme::{Kind, Scheme};
use epicyclic_train::drawn::DrawnSet;
use epicyclic_train::{Gearbox, LinkId};
use std::hash::{Hash, Hasher};

/// A link as the sweep counts it.
pub(super) type Net = u8;

/// Net of the housing.
pub(super) const HOUSE: Net = 0;

/// Lines on one side of the band, at most.
const MOST_LINES: usize = 14;
/// Sets and shift elements, at most.
const MOST_ROWS: usize = 16;
const MOST_TIES: usize = 64;
const MOST_NETS: usize = 48;

/// A set to be placed.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Links of central gear 1, central gear 2 and carrier.
    pub(super) members: [Net; 3],
    /// The set of the gearbox for which this one is drawn; those of one set are side by side.
    pub(super) of: usize,
    /// Position of the set in the flow of power.
    pub(super) stage: u32,
}

/// Tie between two links: a shift element, or a way out to the housing.
#[derive(Debug, Clone)]
pub(super) struct Tie {
    pub(super) ends: [Net; 2],
    pub(super) kind: Kind,
}

/// Scheme to be drawn.
#[derive(Debug, Clone)]
pub(super) struct Task {
    pub(super) pieces: Vec<LinkId>,
    pub(super) rows: Vec<Row>,
    pub(super) ties: Vec<Tie>,
    pub(super) input: Net,
    pub(super) output: Net,
    pub(super) same_side: bool,
    /// Whether the drawn sets of one set keep side by side.
    pub(super) keeps_together: bool,
    /// The sets that each net carries.
    pub(super) carries: Vec<u32>,
    /// Rows and ties of each net.
    rows_of: Vec<u32>,
    ties_of: Vec<u64>,
}

impl Task {
    /// Task of a scheme; `None` if it exceeds the limits of the sweep.
    pub(super) fn new(scheme: &Scheme<'_>, gearbox: &Gearbox, same_side: bool) -> Option<Self> {
        let mut pieces = vec![LinkId::GROUND];
        let mut net = |link: LinkId| {
            let piece = scheme.piece(link);
            let place = pieces.iter().position(|&other| other == piece).unwrap_or_else(|| {
                pieces.push(piece);
                pieces.len() - 1
            });
            u8::try_from(place.min(MOST_NETS)).unwrap_or(u8::MAX)
        };
        let (input, output) = (net(gearbox.input()), net(gearbox.output()));
        let drawn = gearbox.drawn_sets();
        let stages = scheme.stages();
        let row = |drawn: &DrawnSet| Row {
            members: drawn.links.map(&mut net),
            of: drawn.set,
            stage: stages[drawn.set],
        };
        let rows: Vec<Row> = drawn.iter().map(row).collect();
        let ties: Vec<Tie> =
            scheme.ties().into_iter().map(|(links, kind)| Tie { ends: links.map(&mut net), kind }).collect();
        let nets = pieces.len();
        if nets > MOST_NETS || rows.len() > MOST_ROWS || ties.len() > MOST_TIES {
            return None;
        }
        let (mut rows_of, mut ties_of) = (vec![0; nets], vec![0; nets]);
        for (place, row) in rows.iter().enumerate() {
            for net in row.members {
                rows_of[usize::from(net)] |= 1 << place;
            }
        }
        for (place, tie) in ties.iter().enumerate() {
            for net in tie.ends {
                ties_of[usize::from(net)] |= 1 << place;
            }
        }
        let carries = (0..nets).map(|net| {
            let of = |row: &Row| usize::from(row.members[2]) == net;
            rows.iter().enumerate().map(|(place, row)| u32::from(of(row)) << place).sum()
        });
        let carries = carries.collect();
        let keeps_together = rows.windows(2).any(|pair| pair[0].of == pair[1].of);
        Some(Self { pieces, rows, ties, input, output, same_side, keeps_together, carries, rows_of, ties_of })
    }

    /// The first state: the shafts that enter on the left.
    pub(super) fn start(&self) -> State {
        let mut state = State::default();
        state.above.push(Line { net: HOUSE, part: 0, form: Form::Bar });
        let shafts =
            [(self.output, self.same_side), (self.input, !self.same_side || self.input != self.output)];
        for (net, _) in shafts.into_iter().filter(|(_, enters)| *enters) {
            // A shaft of the housing's has to reach it yet.
            state.below.push(Line { net, part: u8::from(net == HOUSE), form: Form::Bar });
        }
        state
    }

    /// Sets not yet placed that a net has to do with.
    pub(super) fn open_rows(&self, state: &State, net: Net) -> u32 {
        self.rows_of[usize::from(net)] & !state.placed
    }

    /// Shift elements not yet drawn that a net has to do with.
    pub(super) fn open_ties(&self, state: &State, net: Net) -> u64 {
        self.ties_of[usize::from(net)] & !state.done
    }

    /// Whether a net still has to reach anything.
    pub(super) fn waits(&self, state: &State, net: Net) -> bool {
        self.open_rows(state, net) != 0
            || self.open_ties(state, net) != 0
            || (net == self.output && !self.same_side)
    }

    /// Whether all is drawn.
    pub(super) fn is_done(&self, state: &State) -> bool {
        let ends: &[Net] = if self.same_side { &[] } else { &[self.output] };
        state.placed.count_ones() as usize == self.rows.len()
            && state.done.count_ones() as usize == self.ties.len()
            && state.level.is_none()
            && state.above.lines().len() == 1
            && state.below.lines().iter().all(|line| line.net != HOUSE || line.part == 0)
            && state.below.lines().iter().map(|line| line.net).eq(ends.iter().copied())
    }
}

/// Form of a line so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(super) enum Form {
    /// The line begins here, and so far might end here.
    #[default]
    Point,
    /// The line begins here with something on its other side, too.
    Through,
    /// The line goes on along the axis.
    Bar,
}

/// A line along the axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(super) struct Line {
    pub(super) net: Net,
    /// Lines of one net and part hang together.
    pub(super) part: u8,
    pub(super) form: Form,
}

/// Lines on one side of the band, the last next to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Stack {
    lines: [Line; MOST_LINES],
    count: usize,
}

impl Hash for Stack {
    /// Two lines a word.
    fn hash<H: Hasher>(&self, state: &mut H) {
        for pair in self.lines().chunks(2) {
            let word = |line: &Line| u32::from_be_bytes([line.net, line.part, line.form as u8, 1]);
            let [first, second] = [pair.first(), pair.get(1)].map(|line| u64::from(line.map_or(0, word)));
            state.write_u64(first << 32 | second);
        }
        state.write_usize(self.count);
    }
}

impl Stack {
    pub(super) fn lines(&self) -> &[Line] {
        &self.lines[..self.count]
    }

    fn lines_mut(&mut self) -> &mut [Line] {
        &mut self.lines[..self.count]
    }

    pub(super) fn last(&self) -> Option<Line> {
        self.lines().last().copied()
    }

    fn push(&mut self, line: Line) -> bool {
        let fits = self.count < MOST_LINES;
        if fits {
            self.lines[self.count] = line;
            self.count += 1;
        }
        fits
    }

    fn remove(&mut self, place: usize) {
        self.lines.copy_within(place + 1..self.count, place);
        self.count -= 1;
        self.lines[self.count] = Line::default();
    }
}

/// Side of the band.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Side {
    Below,
    Above,
}
use Side::{Above, Below};

/// The list at one place along the axis, and what is behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(super) struct State {
    pub(super) below: Stack,
    pub(super) above: Stack,
    /// Net and part of a carrier that goes on at the height of its planet pin.
    pub(super) level: Option<(Net, u8)>,
    pub(super) placed: u32,
    pub(super) done: u64,
}

impl State {
    pub(super) fn side(&self, side: Side) -> &Stack {
        match side {
            Below => &self.below,
            Above => &self.above,
        }
    }

    fn side_mut(&mut self, side: Side) -> &mut Stack {
        match side {
            Below => &mut self.below,
            Above => &mut self.above,
        }
    }

    fn all_lines(&self) -> impl Iterator<Item = &Line> {
        self.above.lines().iter().chain(self.below.lines())
    }

    /// Joins two parts of a net; `false` where they are one already.
    fn join(&mut self, net: Net, into: u8, gone: u8) -> bool {
        if into == gone {
            return false;
        }
        for side in [Below, Above] {
            for line in self.side_mut(side).lines_mut() {
                if line.net == net && line.part == gone {
                    line.part = into;
                }
            }
        }
        if self.level == Some((net, gone)) {
            self.level = Some((net, into));
        }
        true
    }

    fn fresh(&self, net: Net) -> u8 {
        let lines = self.all_lines().filter(|line| line.net == net).map(|line| line.part);
        let level = self.level.filter(|level| level.0 == net).map(|level| level.1);
        lines.chain(level).max().map_or(0, |part| part + 1)
    }

    /// Parts numbered as they come, so that equal lists are equal.
    fn normalize(&mut self) {
        let mut names: [(Net, u8, u8); 2 * MOST_LINES + 1] = [(0, 0, 0); 2 * MOST_LINES + 1];
        let mut count = 0;
        let mut name = |net: Net, part: u8| {
            if let Some(known) = names[..count].iter().find(|known| known.0 == net && known.1 == part) {
                return known.2;
            }
            let next = names[..count].iter().filter(|known| known.0 == net).count();
            let next = u8::try_from(next).unwrap_or(u8::MAX);
            names[count] = (net, part, next);
            count += 1;
            next
        };
        for side in [Above, Below] {
            for line in self.side_mut(side).lines_mut() {
                line.part = name(line.net, line.part);
            }
        }
        if let Some((net, part)) = self.level {
            self.level = Some((net, name(net, part)));
        }
    }
}

/// Directions of an arm of a carrier from its planet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Arm {
    pub(super) below: bool,
    pub(super) above: bool,
    /// Whether the arm goes on to the next set at the height of the planet pin.
    pub(super) level: bool,
}

impl Arm {
    pub(super) fn reaches(self, side: Side) -> bool {
        if side == Below { self.below } else { self.above }
    }

    fn is_bent(self) -> bool {
        self.below || self.above
    }
}

/// Next step of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    /// A set with the arms on its left and right.
    Set { row: usize, left: Arm, right: Arm },
    /// The last line on a side crosses the band.
    Cross { from: Side },
    /// A line is not needed further on.
    End { side: Side, place: usize },
    /// A link without sets begins at a shift element.
    Begin { net: Net, side: Side },
    /// A link begins with a line through the band.
    Rise { net: Net },
}

/// Recorder of the steps of a sweep.
pub(super) trait Recorder {
    /// A line begins next to the band.
    fn begins(&mut self, side: Side, net: Net);
    /// The line in this place of a side ends where it was met last.
    fn ends(&mut self, side: Side, place: usize);
    /// The arms of a carrier beside its set, to the last lines below and above.
    fn arm(&mut self, row: usize, arm: Arm);
    /// A set, its sun on the last line below and its ring on the last above.
    fn set(&mut self, row: usize);
    /// The last lines on both sides are joined.
    fn crosses(&mut self);
    /// A shift element between the line in this place of a side and the next.
    fn tie(&mut self, tie: usize, side: Side, place: usize);
}

/// The search writes nothing down.
impl Recorder for () {
    fn begins(&mut self, _: Side, _: Net) {}
    fn ends(&mut self, _: Side, _: usize) {}
    fn arm(&mut self, _: usize, _: Arm) {}
    fn set(&mut self, _: usize) {}
    fn crosses(&mut self) {}
    fn tie(&mut self, _: usize, _: Side, _: usize) {}
}

/// Costs are counted in halves of those of [`cost`].
const fn half(cost: f64) -> u32 {
    (2.0 * cost) as u32
}

/// A corner.
pub(super) const BEND: u32 = half(cost::BEND);
/// A line along the axis from one set or crossing of the band to the next.
pub(super) const ALONG: u32 = 2;
/// A line through the band, and a wall of the housing there.
const ACROSS: u32 = 5;
const WALL: u32 = half(cost::WALL);
/// A brake that does not reach the housing above all.
const BRAKE_INSIDE: u32 = BEND;
/// Two sets against the order of the power.
const BACKWARDS: u32 = half(cost::BACKWARDS);

/// A step while it is taken.
pub(super) struct Taking<'a, R> {
    pub(super) task: &'a Task,
    pub(super) state: State,
    pub(super) recorder: &'a mut R,
    cost: u32,
}

impl<'a, R: Recorder> Taking<'a, R> {
    pub(super) fn new(task: &'a Task, state: State, recorder: &'a mut R) -> Self {
        Self { task, state, recorder, cost: 0 }
    }

    /// The state after a step and what the step costs; `None` where it cannot be taken.
    pub(super) fn take(mut self, step: Step) -> Option<(State, u32)> {
        match step {
            Step::Set { row, left, right } => self.set(row, left, right)?,
            Step::Cross { from } => self.cross(from)?,
            Step::End { side, place } => {
                self.recorder.ends(side, place);
                self.state.side_mut(side).remove(place);
                self.settle();
            }
            Step::Begin { net, side } => {
                let part = self.state.fresh(net);
                self.begin(side, net, part)?;
                self.settle();
            }
            Step::Rise { net } => {
                let part = self.state.fresh(net);
                self.begin(Below, net, part)?;
                self.begin(Above, net, part)?;
                self.recorder.crosses();
                self.cost += if net == HOUSE { WALL } else { ACROSS };
                self.along();
                self.settle();
            }
        }
        self.state.normalize();
        Some((self.state, self.cost))
    }

    fn begin(&mut self, side: Side, net: Net, part: u8) -> Option<()> {
        // A shaft of the output above another does not lie on the axis.
        if side == Below && net == self.task.output && !self.state.below.lines().is_empty() {
            self.cost += 2 * BEND;
        }
        self.recorder.begins(side, net);
        self.state.side_mut(side).push(Line { net, part, form: Form::Point }).then_some(())
    }

    /// Something meets the line in a place of a side, from the band's side or from the other.
    fn meet(&mut self, side: Side, place: usize, from_band: bool) {
        let Some(line) = self.state.side_mut(side).lines_mut().get_mut(place) else { return };
        let form = match line.form {
            Form::Point if !from_band => Form::Through,
            _ => Form::Bar,
        };
        if form == Form::Bar && line.form != Form::Bar {
            self.cost += 2 * BEND;
        }
        line.form = form;
    }

    /// A member of a set, or an arm of a carrier, on the last line of a side, or on a new one.
    fn attach(&mut self, side: Side, net: Net, part: u8) -> Option<()> {
        match self.state.side(side).last() {
            Some(line) if line.net == net => {
                self.meet(side, self.state.side(side).count - 1, true);
                self.state.join(net, line.part, part).then_some(())
            }
            _ => self.begin(side, net, part),
        }
    }

    fn arm(&mut self, row: usize, net: Net, part: u8, arm: Arm) -> Option<()> {
        if !arm.is_bent() {
            return Some(());
        }
        self.cost += BEND;
        let mut part = part;
        for side in [Below, Above] {
            if arm.reaches(side) {
                self.attach(side, net, part)?;
                part = self.state.side(side).last()?.part;
            }
        }
        self.recorder.arm(row, arm);
        self.settle();
        Some(())
    }

    fn set(&mut self, row: usize, left: Arm, right: Arm) -> Option<()> {
        let [sun, ring, carrier] = self.task.rows[row].members;
        let pin = match self.state.level {
            Some((_, part)) => part,
            None => self.state.fresh(carrier),
        };
        // While the set is drawn its planet keeps the parts of the carrier apart from others.
        self.state.level = Some((carrier, pin));
        self.arm(row, carrier, pin, left)?;
        for (side, net) in [(Below, sun), (Above, ring)] {
            let part = self.state.fresh(net);
            self.attach(side, net, part)?;
        }
        self.recorder.set(row);
        self.state.placed |= 1 << row;
        self.along();
        let other_of = |row: &Row| (row.stage, row.of);
        let before = self.task.rows.iter().enumerate().filter(|(other, behind)| {
            self.state.placed >> other & 1 == 0 && other_of(behind) < other_of(&self.task.rows[row])
        });
        self.cost += BACKWARDS * u32::try_from(before.count()).unwrap_or(0);
        self.settle();
        let part = self.state.level.map_or(pin, |(_, part)| part);
        self.arm(row, carrier, part, right)?;
        let level = self.state.level.take();
        if right.level {
            self.state.level = level;
        } else {
            // No other line reaches the carrier here: it has to go on elsewhere, or be complete.
            let (net, part) = level?;
            let goes_on = self.state.all_lines().any(|line| line.net == net && line.part == part);
            let others = self.state.all_lines().any(|line| line.net == net);
            if !goes_on && (others || self.task.waits(&self.state, net)) {
                return None;
            }
        }
        self.settle();
        Some(())
    }

    fn cross(&mut self, from: Side) -> Option<()> {
        let to = if from == Below { Above } else { Below };
        let line = self.state.side(from).last()?;
        self.meet(from, self.state.side(from).count - 1, true);
        self.attach(to, line.net, line.part)?;
        self.recorder.crosses();
        self.cost += if line.net == HOUSE { WALL } else { ACROSS };
        self.along();
        self.settle();
        Some(())
    }

    fn along(&mut self) {
        let lines = self.state.below.lines().len() + self.state.above.lines().len() - 1;
        self.cost += ALONG * u32::try_from(lines).unwrap_or(0);
    }

    /// Draws all shift elements between neighbours, and ends all lines of links that are whole.
    fn settle(&mut self) {
        loop {
            for side in [Below, Above] {
                let mut place = 0;
                while place + 1 < self.state.side(side).count {
                    let [a, b] = [place, place + 1].map(|place| self.state.side(side).lines()[place].net);
                    let open = self.task.open_ties(&self.state, a) & self.task.open_ties(&self.state, b);
                    if open != 0 && a != b {
                        let tie = open.trailing_zeros();
                        self.state.done |= 1 << tie;
                        self.recorder.tie(tie as usize, side, place);
                        if [a, b].contains(&HOUSE) && !(side == Above && place == 0) {
                            self.cost += BRAKE_INSIDE;
                        }
                        if !(a == HOUSE && place == 0 && side == Above) {
                            self.meet(side, place, true);
                        }
                        self.meet(side, place + 1, false);
                    } else {
                        place += 1;
                    }
                }
            }
            if !self.end_whole() {
                break;
            }
        }
    }

    /// Ends the lines of one link that has all it needs and is one part.
    fn end_whole(&mut self) -> bool {
        for side in [Below, Above] {
            for place in (0..self.state.side(side).count).rev() {
                let line = self.state.side(side).lines()[place];
                let waits = line.net == HOUSE || self.task.waits(&self.state, line.net);
                let in_hand = self.state.level.is_some_and(|(net, _)| net == line.net);
                let is_one =
                    self.state.all_lines().all(|other| other.net != line.net || other.part == line.part);
                if !waits && !in_hand && is_one {
                    self.recorder.ends(side, place);
                    self.state.side_mut(side).remove(place);
                    return true;
                }
            }
        }
        false
    }
}
