//! A sweep as a drawing: heights of lines, places of everything upright, and the layout.

use super::layout::{BrakeMark, ClutchMark, GAP, Layout, PLANET, Point, Segment, SetStack, ShaftEnd, shapes};
use super::scheme::Kind;
use super::sweep::{Arm, HOUSE, Net, Recorder, Side, Step, Taking, Task};
use epicyclic_train::LinkId;

/// A line along the axis from the first to the last column that meets it.
#[derive(Debug, Clone)]
struct Bar {
    net: Net,
    side: Side,
    /// Lines nearer to the band that begin while this one is met.
    inner: Vec<usize>,
    columns: Vec<usize>,
    /// Whether another line lies under it where it begins.
    is_over: bool,
}

/// Something upright.
#[derive(Debug, Clone, Copy)]
enum Column {
    /// Sun and ring of a set on their lines.
    Set { row: usize, sun: usize, ring: usize },
    /// The arms of a carrier on one side, to lines below and above.
    Arm { row: usize, below: Option<usize>, above: Option<usize> },
    /// Two lines of one net.
    Cross { below: usize, above: usize },
    /// A shift element between two lines, the lower first.
    Tie { tie: usize, ends: [usize; 2] },
    /// The output's way down to the axis.
    Down { line: usize },
}

/// A sweep written down.
struct Draft<'a> {
    task: &'a Task,
    bars: Vec<Bar>,
    columns: Vec<Column>,
    below: Vec<usize>,
    above: Vec<usize>,
    /// Pairs of columns that a carrier joins at the height of its planet pin, with a row of its.
    levels: Vec<(usize, [usize; 2])>,
    /// The column that the level line has reached.
    reached: Option<usize>,
}

impl Recorder for Draft<'_> {
    fn begins(&mut self, side: Side, net: Net) {
        let bar = self.bars.len();
        let stack = self.stack(side);
        let outer = stack.last().copied();
        stack.push(bar);
        self.bars.push(Bar { net, side, inner: vec![], columns: vec![], is_over: outer.is_some() });
        if let Some(outer) = outer {
            self.bars[outer].inner.push(bar);
        }
    }

    fn ends(&mut self, side: Side, place: usize) {
        // Bars outside of the line stay outside of those inside of it as long as both go on.
        let stack = self.stack(side);
        stack.remove(place);
        if place > 0 && place < stack.len() {
            let (outer, inner) = (stack[place - 1], stack[place]);
            self.bars[outer].inner.push(inner);
        }
    }

    fn arm(&mut self, row: usize, arm: Arm) {
        let last = |goes: bool, stack: &[usize]| stack.last().copied().filter(|_| goes);
        let (below, above) = (last(arm.below, &self.below), last(arm.above, &self.above));
        self.column(Column::Arm { row, below, above }, &[below, above]);
        self.reach(row);
    }

    fn set(&mut self, row: usize) {
        let (Some(&sun), Some(&ring)) = (self.below.last(), self.above.last()) else { return };
        self.column(Column::Set { row, sun, ring }, &[Some(sun), Some(ring)]);
        self.reach(row);
    }

    fn crosses(&mut self) {
        let (Some(&below), Some(&above)) = (self.below.last(), self.above.last()) else { return };
        self.column(Column::Cross { below, above }, &[Some(below), Some(above)]);
    }

    fn tie(&mut self, tie: usize, side: Side, place: usize) {
        let stack = if side == Side::Below { &self.below } else { &self.above };
        let (outer, inner) = (stack[place], stack[place + 1]);
        let ends = if side == Side::Below { [outer, inner] } else { [inner, outer] };
        self.column(Column::Tie { tie, ends }, &ends.map(Some));
    }
}

/// Heights and places.
struct Grid {
    /// Height of each bar.
    heights: Vec<i32>,
    /// Place of each column along the axis.
    places: Vec<i32>,
    planet: i32,
    wall: i32,
    /// Places of the left and the right shaft end.
    left: i32,
    right: i32,
}

impl<'a> Draft<'a> {
    fn stack(&mut self, side: Side) -> &mut Vec<usize> {
        if side == Side::Below { &mut self.below } else { &mut self.above }
    }

    /// The level line of a carrier reaches the last column.
    fn reach(&mut self, row: usize) {
        let column = self.columns.len() - 1;
        if let Some(from) = self.reached.replace(column) {
            self.levels.push((row, [from, column]));
        }
    }

    /// Something upright that meets these lines.
    fn column(&mut self, column: Column, bars: &[Option<usize>]) {
        for &bar in bars.iter().flatten() {
            self.bars[bar].columns.push(self.columns.len());
        }
        self.columns.push(column);
    }

    fn new(task: &'a Task, steps: &[Step]) -> Option<Self> {
        let mut draft = Self {
            task,
            bars: vec![],
            columns: vec![],
            below: vec![],
            above: vec![],
            levels: vec![],
            reached: None,
        };
        let mut state = task.start();
        draft.begins(Side::Above, HOUSE);
        for line in state.below.lines() {
            draft.begins(Side::Below, line.net);
        }
        for &step in steps {
            (state, _) = Taking::new(task, state, &mut draft).take(step)?;
            if state.level.is_none() {
                draft.reached = None;
            }
        }
        if let Some(&line) = draft.below.last()
            && draft.bars[line].is_over
        {
            draft.column(Column::Down { line }, &[Some(line)]);
        }
        Some(draft)
    }

    /// Whether a bar is a shaft on the axis.
    fn on_axis(&self, bar: usize) -> bool {
        let Bar { net, side, is_over, .. } = self.bars[bar];
        side == Side::Below && !is_over && [self.task.input, self.task.output].contains(&net)
    }

    fn is_met(&self, bar: usize) -> bool {
        !self.bars[bar].columns.is_empty()
    }

    fn grid(&self) -> Grid {
        // Distance from the band: one more than of whatever lies nearer to it. Later bars are never outside
        // of earlier ones.
        let mut depth = vec![1; self.bars.len()];
        for bar in (0..self.bars.len()).rev() {
            let inner = self.bars[bar].inner.iter().filter(|&&inner| self.is_met(inner));
            depth[bar] = inner.map(|&inner| depth[inner] + 1).max().unwrap_or(1);
        }
        let most = |side: Side| {
            let bars = (0..self.bars.len()).filter(|&bar| self.bars[bar].side == side);
            bars.map(|bar| depth[bar] + i32::from(side == Side::Below && !self.on_axis(bar)))
                .max()
                .unwrap_or(1)
        };
        let planet = most(Side::Below);
        let wall = planet + most(Side::Above);
        let height = |bar: usize| match self.bars[bar].side {
            Side::Below if self.on_axis(bar) => 0,
            Side::Below => planet - depth[bar],
            Side::Above if bar == 0 => wall,
            Side::Above => planet + depth[bar],
        };
        let heights: Vec<i32> = (0..self.bars.len()).map(height).collect();
        let mut grid = Grid { heights, places: vec![0; self.columns.len()], planet, wall, left: 0, right: 0 };
        self.places(&mut grid);
        grid
    }

    /// Nets and heights of the upright lines in a column, doubled so that they are integers.
    fn spans(&self, column: usize, grid: &Grid) -> Vec<(Net, [i32; 2])> {
        let height = |bar: usize| 2 * grid.heights[bar];
        let pin = 2 * grid.planet;
        match self.columns[column] {
            Column::Set { row, sun, ring } => {
                let [a, b, h] = self.task.rows[row].members;
                vec![(a, [height(sun), pin - 1]), (h, [pin - 1, pin + 1]), (b, [pin + 1, height(ring)])]
            }
            Column::Arm { row, below, above } => {
                let from = below.map_or(pin, height);
                vec![(self.task.rows[row].members[2], [from, above.map_or(pin, height)])]
            }
            Column::Cross { below, above } => vec![(self.bars[below].net, [height(below), height(above)])],
            Column::Tie { ends: [low, high], .. } => {
                let (y0, y1) = (height(low), height(high));
                vec![(self.bars[low].net, [y0, (y0 + y1) / 2]), (self.bars[high].net, [(y0 + y1) / 2, y1])]
            }
            Column::Down { line } => vec![(self.bars[line].net, [0, height(line)])],
        }
    }

    /// Whether two columns need different places.
    fn collide(&self, spans: &[Vec<(Net, [i32; 2])>], one: usize, other: usize) -> bool {
        let common = self.bars.iter().any(|bar| bar.columns.contains(&one) && bar.columns.contains(&other));
        spans[one].iter().any(|&(a, [low, high])| {
            spans[other].iter().any(|&(b, [from, to])| {
                let touch = low <= to && from <= high;
                let point = low == to || from == high;
                touch && !(a == b && point && common)
            })
        })
    }

    /// Places the columns as far left as possible, then moves right those that make the lines shorter there.
    fn places(&self, grid: &mut Grid) {
        let count = self.columns.len();
        let spans: Vec<_> = (0..count).map(|column| self.spans(column, grid)).collect();
        let mut before: Vec<Vec<(usize, i32)>> = vec![vec![]; count];
        let mut behind = before.clone();
        for pair in (0..count).flat_map(|column| (0..column).map(move |other| [other, column])) {
            let [other, column] = pair;
            let apart = i32::from(self.collide(&spans, other, column));
            let is_met_by_both = |bar: &Bar| bar.columns.contains(&column) && bar.columns.contains(&other);
            if apart > 0 || self.bars.iter().any(is_met_by_both) {
                before[column].push((other, apart));
                behind[other].push((column, apart));
            }
        }
        for (column, before) in before.iter().enumerate() {
            let place = before.iter().map(|&(other, apart)| grid.places[other] + apart).max();
            grid.places[column] = place.unwrap_or(0);
        }
        let last = grid.places.iter().copied().max().unwrap_or(0);
        let mut moved = true;
        while std::mem::take(&mut moved) {
            for column in (0..count).rev() {
                let limit = behind[column].iter().map(|&(other, apart)| grid.places[other] - apart).min();
                let limit = limit.unwrap_or(last);
                let now = grid.places[column];
                if limit > now && self.pull(grid, column, limit) < 0 {
                    grid.places[column] = limit;
                    moved = true;
                }
            }
        }
        (grid.left, grid.right) = (-1, last + 1);
    }

    /// Growth of the lines' length if a column moves.
    fn pull(&self, grid: &Grid, column: usize, to: i32) -> i32 {
        let length = |bar: usize, moved: bool| {
            let Bar { net, columns, side, .. } = &self.bars[bar];
            let place = |&other: &usize| if other == column && moved { to } else { grid.places[other] };
            let ends = *side == Side::Below;
            let left = ends && bar != 0 && self.starts(bar);
            let right = ends && *net == self.task.output && !self.task.same_side;
            let low = columns.iter().map(place).min().unwrap_or(0);
            let high = columns.iter().map(place).max().unwrap_or(0);
            (if right { grid.right } else { high }) - (if left { grid.left } else { low })
        };
        let met = (1..self.bars.len()).filter(|&bar| self.bars[bar].columns.contains(&column));
        let mut longer: i32 = met.map(|bar| length(bar, true) - length(bar, false)).sum();
        // Level lines between sets and their arms.
        for (a, b) in self.levels.iter().flat_map(|&(_, [a, b])| [(a, b), (b, a)]) {
            if a == column {
                let other = grid.places[b];
                longer += (to - other).abs() - (grid.places[a] - other).abs();
            }
        }
        longer
    }

    /// Whether a bar is there on the left border.
    fn starts(&self, bar: usize) -> bool {
        let entering = self.task.start().below.lines().len();
        self.bars[bar].side == Side::Below && bar <= entering && bar > 0
    }
}

/// The layout of a sweep.
pub(super) fn layout(task: &Task, steps: &[Step]) -> Option<Layout> {
    let draft = Draft::new(task, steps)?;
    let grid = draft.grid();
    let y = |bar: usize| f64::from(grid.heights[bar]);
    let x = |column: usize| f64::from(grid.places[column]);
    let pin = f64::from(grid.planet);
    let piece = |net: Net| task.pieces[usize::from(net)];
    let line = |x0: f64, y0: f64, x1: f64, y1: f64| Segment {
        from: Point { x: x0.min(x1), y: y0.min(y1) },
        to: Point { x: x0.max(x1), y: y0.max(y1) },
    };
    let (left, right) = (f64::from(grid.left), f64::from(grid.right));
    let mut pieces: Vec<(LinkId, Segment)> = vec![];
    let mut sets: Vec<SetStack> = vec![];
    let (mut clutches, mut brakes, mut take_offs) = (vec![], vec![], vec![]);
    let mut input_y = 0.0;

    let end_line = draft.below.last().copied().filter(|_| !task.same_side);
    for (place, bar) in draft.bars.iter().enumerate().skip(1) {
        let mut xs: Vec<f64> = bar.columns.iter().map(|&column| x(column)).collect();
        if draft.starts(place) {
            xs.push(left);
            if bar.net == task.input {
                input_y = y(place);
            }
        }
        if end_line == Some(place) && !bar.is_over {
            xs.push(right);
        }
        let low = xs.iter().copied().fold(f64::INFINITY, f64::min);
        let high = xs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low < high {
            pieces.push((piece(bar.net), line(low, y(place), high, y(place))));
        }
    }
    for column in 0..draft.columns.len() {
        let at = |y: f64| Point { x: x(column), y };
        match draft.columns[column] {
            Column::Set { row, sun, ring } => sets.push(SetStack {
                set: row,
                members: task.rows[row].members.map(piece),
                x: x(column),
                sun: y(sun),
                sun_mesh: pin - PLANET,
                planet: pin,
                ring_mesh: pin + PLANET,
                ring: y(ring),
            }),
            Column::Arm { row, below, above } => {
                let carrier = piece(task.rows[row].members[2]);
                let span = line(x(column), below.map_or(pin, y), x(column), above.map_or(pin, y));
                pieces.push((carrier, span));
            }
            Column::Cross { below, above } => {
                pieces.push((piece(draft.bars[below].net), line(x(column), y(below), x(column), y(above))));
            }
            Column::Down { line: bar } => {
                let net = piece(draft.bars[bar].net);
                pieces.push((net, line(x(column), 0.0, x(column), y(bar))));
                pieces.push((net, line(x(column), 0.0, right, 0.0)));
            }
            Column::Tie { tie, ends: [low, high] } => {
                let [lower, upper] = [low, high].map(|bar| draft.bars[bar].net);
                let (y0, y1) = (y(low), y(high));
                let grounded = [lower == HOUSE, upper == HOUSE];
                match task.ties[tie].kind {
                    Kind::ShiftElement(shift_element) if grounded == [false; 2] => {
                        let middle = f64::midpoint(y0, y1);
                        pieces.push((piece(lower), line(x(column), y0, x(column), middle - GAP)));
                        pieces.push((piece(upper), line(x(column), middle + GAP, x(column), y1)));
                        clutches.push(ClutchMark {
                            shift_element,
                            lower: (piece(lower), at(middle - GAP)),
                            upper: (piece(upper), at(middle + GAP)),
                        });
                    }
                    kind => {
                        let (link, from, to, wall) = if grounded[1] {
                            (piece(lower), y0, y1 - GAP, y1)
                        } else {
                            (piece(upper), y1, y0 + GAP, y0)
                        };
                        pieces.push((link, line(x(column), from, x(column), to)));
                        match kind {
                            Kind::ShiftElement(shift_element) => brakes.push(BrakeMark {
                                shift_element,
                                link,
                                link_end: at(to),
                                housing: at(wall),
                            }),
                            _ => take_offs.push(ShaftEnd { link, at: at(to) }),
                        }
                    }
                }
            }
        }
    }
    for &(row, [from, to]) in &draft.levels {
        pieces.push((piece(task.rows[row].members[2]), line(x(from), pin, x(to), pin)));
    }
    sets.sort_by_key(|stack| stack.set);
    clutches.sort_by_key(|mark| mark.shift_element);
    brakes.sort_by_key(|mark| mark.shift_element);
    let wall = f64::from(grid.wall);
    let (input, output) = (piece(task.input), piece(task.output));
    let output_x = if task.same_side { left } else { right };
    Some(Layout {
        sets,
        links: shapes(pieces.into_iter().filter(|(_, s)| s.from != s.to).collect()),
        clutches,
        brakes,
        take_offs,
        input: ShaftEnd { link: input, at: Point { x: left, y: input_y } },
        output: ShaftEnd { link: output, at: Point { x: output_x, y: 0.0 } },
        axis: line(left, 0.0, right, 0.0),
        housing: line(left, wall, right, wall),
    })
}
