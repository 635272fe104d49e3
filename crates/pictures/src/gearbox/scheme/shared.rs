//! Sets of more than two central gears drawn as one: the planet in common goes through both halves, and the
//! gear in common is drawn once.

use super::halves::{Common, Pair};
use super::signs::{BEHIND_MM, FORK_MM, HUB_MM, MESH_MM, PLANET_PIN_MM, RIM_MM, STEP};
use super::to_scale::Wheel;
use super::{Look, SHAFT_MM, Sheet, UP_MM, WEB_MM};
use epicyclic_drawing::{Point, Shape, Style};
use epicyclic_layout::layout::Point as Place;

/// Distance from the rims of a short planet to a fork next to it, and on to the long planet.
const FORK_GAP_MM: f64 = 1.0;

impl Sheet<'_> {
    /// The pair that a drawn set belongs to.
    pub(super) fn pair_of(&self, set: usize) -> Option<Pair> {
        self.pairs.iter().copied().find(|pair| pair.stacks.iter().any(|stack| stack.set == set))
    }

    /// Pair of a set if the common planet is a long one, around which the carrier forks.
    pub(super) fn long_pair_of(&self, set: usize) -> Option<Pair> {
        self.pair_of(set).filter(|pair| pair.common == Common::Long)
    }

    /// Central gears and planets of two sets that are one.
    pub(super) fn pair(&mut self, pair: &Pair) {
        match pair.common {
            Common::Long => self.ravigneaux(pair),
            Common::Stepped => self.wolfrom(pair),
        }
    }

    fn level(&mut self, [left, right]: [f64; 2], y: f64, color: epicyclic_drawing::Color, width_mm: f64) {
        let style = Style::line(width_mm).color(color);
        self.scene.add_styled(self.layers.toothed_gears, style, Shape::line([left, y], [right, y]));
    }

    /// Draws both suns, the ring once over both, the short planet under the long one, and the carrier's fork
    /// around them.
    fn ravigneaux(&mut self, pair: &Pair) {
        let [double, simple] = pair.stacks;
        let [xd, xs] = [double.x, simple.x].map(|x| self.at(Place { x, y: 0.0 }).x);
        if let Some(planets) = self.beside(&double) {
            return self.ravigneaux_to_scale(pair, [xd, xs], planets);
        }
        let ends = [xd.min(xs) - RIM_MM, xd.max(xs) + RIM_MM];
        let middle = UP_MM * double.planet;
        let (low, high) = (UP_MM * double.sun_mesh, UP_MM * double.ring_mesh);
        let short = [low + MESH_MM, middle - MESH_MM];
        let long = [middle + MESH_MM, high - MESH_MM];
        self.central_gear(&double, 0, [xd, UP_MM * double.sun], low - MESH_MM, 0.0);
        self.central_gear(&simple, 0, [xs, UP_MM * simple.sun], middle - MESH_MM, 0.0);
        for (place, stack) in pair.stacks.iter().enumerate().filter(|(place, _)| Some(*place) != pair.without)
        {
            let x = if place == 0 { xd } else { xs };
            self.central_gear(stack, 1, [x, UP_MM * stack.ring], high + MESH_MM, 0.0);
        }
        let ring =
            if self.rests(double.members[1]) { super::RESTING } else { epicyclic_drawing::Color::BLACK };
        self.level(ends, high + MESH_MM, ring, SHAFT_MM);
        let look = Look { inner_mm: 0.0, width_mm: SHAFT_MM, ..self.member_look(&double, 2, SHAFT_MM) };
        let pins = [short, long].map(|[low, high]| f64::midpoint(low, high));
        let sides = [(-1.0, xd.min(xs)), (1.0, xd.max(xs))];
        let outwards = |side: f64, x: f64| {
            let stack = if x == xd { &double } else { &simple };
            self.carrier_sides(stack).contains(&side)
        };
        let mut forks: Vec<(f64, f64)> = sides.into_iter().filter(|&(side, x)| outwards(side, x)).collect();
        if forks.is_empty() {
            forks.push(sides[usize::from(xd > xs)]);
        }
        for &(side, x) in &forks {
            let fork = x + side * FORK_MM;
            let is_double = x == xd;
            let foot = if is_double { pins[0] } else { middle };
            self.line(self.layers.toothed_gears, look, Point::new(fork, foot), Point::new(fork, pins[1]));
        }
        // The pins: the long one from fork to fork, the short one at the fork beside it, or from its own.
        let left = forks.iter().find(|fork| fork.0 < 0.0).map_or(ends[0] - 0.6, |&(_, x)| x - FORK_MM);
        let right = forks.iter().find(|fork| fork.0 > 0.0).map_or(ends[1] + 0.6, |&(_, x)| x + FORK_MM);
        self.line(self.layers.toothed_gears, look, Point::new(left, pins[1]), Point::new(right, pins[1]));
        let beside = sides[usize::from(xd > xs)].0;
        let is_held = forks.iter().any(|&(_, x)| x == xd);
        let outer = if is_held { FORK_MM } else { PLANET_PIN_MM };
        self.line(
            self.layers.toothed_gears,
            look,
            Point::new(xd + beside * outer, pins[0]),
            Point::new(xd - beside * 1.8, pins[0]),
        );
        if !is_held {
            // A web on the long planet's pin holds the short one's.
            let web = xd + beside * PLANET_PIN_MM;
            self.line(self.layers.toothed_gears, look, Point::new(web, pins[0]), Point::new(web, pins[1]));
        }
        let color = self.planet_color(&double);
        for ([low, high], pin, reach, webs) in
            [(short, pins[0], [xd - RIM_MM, xd + RIM_MM], vec![xd]), (long, pins[1], ends, vec![xd, xs])]
        {
            for (side, rim) in [(-1.0, low), (1.0, high)] {
                let bearing = pin + 0.8 * side;
                for &x in &webs {
                    let style = Style::line(WEB_MM).color(color);
                    self.scene.add_styled(
                        self.layers.toothed_gears,
                        style,
                        Shape::line([x, bearing], [x, rim]),
                    );
                }
                let hub = [
                    webs.iter().copied().fold(f64::INFINITY, f64::min) - 1.2,
                    webs.iter().copied().fold(f64::NEG_INFINITY, f64::max) + 1.2,
                ];
                self.level(hub, bearing, color, WEB_MM);
                self.level(reach, rim, color, SHAFT_MM);
            }
        }
    }

    /// Draws the Ravigneaux set to scale: the long planet ends before the short one, as the two reach past
    /// each other.
    fn ravigneaux_to_scale(&mut self, pair: &Pair, [xd, xs]: [f64; 2], [short, long]: [Wheel; 2]) {
        let [double, simple] = pair.stacks;
        let high = UP_MM * double.ring_mesh + MESH_MM;
        for (stack, x) in [(&double, xd), (&simple, xs)] {
            self.central_gear(stack, 0, [x, UP_MM * stack.sun], UP_MM * stack.sun_mesh - MESH_MM, 0.0);
        }
        for (place, stack) in pair.stacks.iter().enumerate().filter(|(place, _)| Some(*place) != pair.without)
        {
            self.central_gear(stack, 1, [[xd, xs][place], UP_MM * stack.ring], high, 0.0);
        }
        let ring =
            if self.rests(double.members[1]) { super::RESTING } else { epicyclic_drawing::Color::BLACK };
        self.level([xd.min(xs) - RIM_MM, xd.max(xs) + RIM_MM], high, ring, SHAFT_MM);
        // Direction from the long planet to the short one.
        let towards = (xd - xs).signum();
        let look = Look { inner_mm: 0.0, width_mm: SHAFT_MM, ..self.member_look(&double, 2, SHAFT_MM) };
        let pins = [short, long].map(|planet| UP_MM * planet.pin);
        let layer = self.layers.toothed_gears;
        let reaches =
            |stack: &epicyclic_layout::layout::SetStack, side: f64| self.carrier_sides(stack).contains(&side);
        let (at_long, at_short) = (reaches(&simple, -towards), reaches(&double, towards));
        // The long planet's pin, from a fork beside it to one beyond the short planet, or to one between the
        // two.
        let start = if at_long { xs - towards * FORK_MM } else { xs - towards * PLANET_PIN_MM };
        let between = xd - towards * (RIM_MM + FORK_GAP_MM);
        self.line(layer, look, Point::new(start, pins[1]), Point::new(between, pins[1]));
        if at_short {
            let fork = xd + towards * FORK_MM;
            self.line(layer, look, Point::new(fork, pins[0]), Point::new(fork, pins[1]));
            let web = UP_MM * short.radius - MESH_MM;
            let is_behind = (pins[1] - pins[0]).abs() > HUB_MM && (pins[1] - pins[0]).abs() < web;
            if is_behind {
                self.line(
                    layer,
                    look,
                    Point::new(between, pins[1]),
                    Point::new(xd - towards * BEHIND_MM, pins[1]),
                );
                self.line(
                    layer,
                    look,
                    Point::new(xd + towards * BEHIND_MM, pins[1]),
                    Point::new(fork, pins[1]),
                );
            } else {
                self.line(layer, look, Point::new(between, pins[1]), Point::new(fork, pins[1]));
            }
            self.line(layer, look, Point::new(fork, pins[0]), Point::new(xd - towards * 1.8, pins[0]));
        } else {
            self.line(layer, look, Point::new(between, pins[0]), Point::new(between, pins[1]));
            self.line(layer, look, Point::new(between, pins[0]), Point::new(xd + towards * 1.8, pins[0]));
        }
        let color = self.planet_color(&double);
        self.wheel(xd, [RIM_MM; 2], pins[0], UP_MM * short.radius - MESH_MM, color);
        let mut reach = [RIM_MM, (between - towards * FORK_GAP_MM - xs).abs()];
        if towards < 0.0 {
            reach.reverse();
        }
        self.wheel(xs, reach, pins[1], UP_MM * long.radius - MESH_MM, color);
    }

    /// The sun once, a ring on each step of the planet.
    fn wolfrom(&mut self, pair: &Pair) {
        let [first, second] = pair.stacks;
        let [xa, xb] = [first.x, second.x].map(|x| self.at(Place { x, y: 0.0 }).x);
        let pin = UP_MM * first.planet;
        let [low, high] = [UP_MM * first.sun_mesh + MESH_MM, UP_MM * first.ring_mesh - MESH_MM];
        self.central_gear(&first, 0, [xa, UP_MM * first.sun], low - 2.0 * MESH_MM, 0.0);
        if pair.without != Some(1) {
            let seat = Point::new(xb, UP_MM * second.sun);
            let look = self.member_look(&second, 0, WEB_MM);
            self.line(self.layers.toothed_gears, look, seat, Point::new(xb, low - 2.0 * MESH_MM));
        }
        // The second ring is lower on its smaller step, or at its own height in a scheme to scale.
        let small = if self.is_to_scale(&second) {
            UP_MM * second.ring_mesh - MESH_MM
        } else {
            pin + STEP * (high - pin)
        };
        self.central_gear(&first, 1, [xa, UP_MM * first.ring], high + 2.0 * MESH_MM, 0.0);
        self.central_gear(&second, 1, [xb, UP_MM * second.ring], small + 2.0 * MESH_MM, 0.0);
        self.planet_pin(&first, xa, pin);
        self.planet_pin(&second, xb, pin);
        let color = self.planet_color(&first);
        let hub = self.planet_pin_half(&first) + 0.55;
        for side in [-1.0, 1.0] {
            for (x, rim) in [(xa, if side < 0.0 { low } else { high }), (xb, pin + side * (small - pin))] {
                let style = Style::line(WEB_MM).color(color);
                let web = Shape::line([x, pin + side * hub], [x, rim]);
                self.scene.add_styled(self.layers.toothed_gears, style, web);
                self.level([x - RIM_MM, x + RIM_MM], rim, color, SHAFT_MM);
            }
            self.level([xa.min(xb) - 1.2, xa.max(xb) + 1.2], pin + side * hub, color, WEB_MM);
        }
    }
}
