//! The fillet that a tool leaves at the root of a tooth, as a curve in the transverse plane.
//!
//! A point is given by its radius and its angle from the centre line of the tooth. Lengths in modules, angles
//! in rad.
//!
//! # By a rack
//! The corner of the rack is an arc of radius `ρ` about `(ξ_c, η_c)`: `ξ_c` from the middle of the rack's
//! tooth, `η_c` from the reference line of the gear. It touches the gear where its normal passes through the
//! pitch point. The angle `θ` of the corner runs from 0 at its crest to `90° − α_n` at its flank:
//!
//! ```text
//! x_E = x + q/sin α_n
//! η_c = x_E − h_fP* + ρ,   ξ_c = π/4 − (h_fP* − ρ)·tan α_n − (ρ − p_r)/cos α_n
//! ξ = (ξ_c + ρ·sin θ)/cos β,   η = η_c − ρ·cos θ,   u = −η·tan θ·cos β
//! r_y = √(u² + (r + η)²),   angle from the middle of the space: atan(u/(r + η)) + (ξ − u)/r
//! ```
//!
//! The factors `cos β` carry the corner, a circle in the normal section, into the transverse one. A
//! protuberance `p_r` moves it beyond the flank of the tool, a stock `q` moves the whole tool outwards.
//!
//! # By a shaper
//! The corner of a cutter's tooth is an arc of radius `ρ_a0` that touches its tip circle and its involute.
//! Its centre has the radius `r_c = r_a0 − ρ_a0` and the angle `θ_c` from the middle of the tooth. A normal
//! of the arc in the direction `δ` passes through the pitch point when the cutter has turned by `γ`:
//!
//! ```text
//! θ_c = (π/2 + 2·x_0·tan α_n)/z_0 + inv α_t − ρ_a0/r_b0 − (t − atan t),   t = √(r_c² − r_b0²)/r_b0
//! sin(δ + γ) = r_c·sin(δ − θ_c)/r_w0
//! ```
//!
//! The point of the arc there, seen from the gear, which turns by `γ·z_0/z`, is a point of the fillet. `ρ_a0`
//! is the radius in the transverse section.
//!
//! # By a form tool
//! One arc of radius `ρ` about a point at the radius `r_f ∓ ρ` (− of a ring) that touches the root circle and
//! the involute.

use super::flank::Flank;
use super::profile::Profile;
use crate::tolerance::TOUCH;
use epicyclic_numerics::roots::bisected;
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A point of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Distance from the axis, modules.
    pub radius: f64,
    /// Angle from the centre line of the tooth, rad.
    pub angle: f64,
}

impl Point {
    /// Coordinates with the centre line of the tooth along the first axis.
    #[must_use]
    pub fn coordinates(self) -> [f64; 2] {
        let (sin, cos) = libm::sincos(self.angle);
        [self.radius * cos, self.radius * sin]
    }
}

/// A fillet as its tool would cut it without the flank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fillet {
    flank: Flank,
    shift: f64,
    corner: Corner,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Corner {
    /// Rounded corner of a rack.
    ///
    /// `xi`, `eta` and `radius` are its centre in the normal section (`η` from the reference line of the
    /// gear) and its radius. `end` is the last angle of the curve, `corner` the parameter where the corner
    /// ends at the flank of the tool.
    Rack { xi: f64, eta: f64, radius: f64, end: f64, corner: f64 },
    /// Corner of a cutter.
    Shaper(Cutter),
    /// Radius and angle from the middle of the space of the centre of the arc, its radius, and the angle of
    /// the arc.
    Form { centre: Point, radius: f64, end: f64 },
}

/// A shaper in mesh with the gear that it cuts, and its corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cutter {
    /// Centre of the corner from the axis of the cutter.
    pub(super) centre: Point,
    /// Direction of the normal of its flank where the corner begins.
    pub(super) normal: f64,
    /// Radius of the corner.
    pub(super) radius: f64,
    /// Working radius of the cutter.
    pub(super) working: f64,
    /// Centre distance, below 0 within a ring.
    pub(super) distance: f64,
    /// Teeth of the cutter over those of the gear.
    pub(super) ratio: f64,
}

/// Halvings of a stretch: below the rounding of its ends.
pub(super) const HALVINGS: u32 = 48;

impl Fillet {
    pub(super) fn by_rack(flank: Flank, profile: &Profile, shift: f64) -> Self {
        let alpha = profile.rack.pressure_angle.si();
        let (cos, tan) = (libm::cos(alpha), libm::tan(alpha));
        let radius = profile.fillet;
        let depth = profile.dedendum() - radius;
        let at_flank = FRAC_PI_2 - alpha;
        // A protuberance goes on cutting on the far side of its round, beyond where it is parallel to the
        // flank.
        let end = if profile.protuberance > profile.stock { FRAC_PI_2 } else { at_flank };
        let corner = Corner::Rack {
            xi: FRAC_PI_4 - depth * tan - (radius - profile.protuberance) / cos,
            eta: profile.generating_shift(shift) - depth,
            radius,
            end,
            corner: at_flank / end,
        };
        Self { flank, shift, corner }
    }

    pub(super) const fn by_shaper(flank: Flank, shift: f64, cutter: Cutter) -> Self {
        Self { flank, shift, corner: Corner::Shaper(cutter) }
    }

    /// An arc between the root circle and the flank at a radius of curvature `end`, 0 at the base circle.
    pub(super) fn by_form(flank: Flank, shift: f64, root: f64, radius: f64, end: f64) -> Self {
        let pitch = PI / flank.z.abs();
        let base = flank.base();
        let centre_radius = root + flank.sign() * radius;
        // The normal of the involute is tangent to the base circle; the centre of the arc lies on it, in the
        // space.
        let at_flank = libm::hypot(base, end);
        let flank_angle = pitch - flank.half_angle(shift, at_flank);
        let along = end + flank.sign() * radius;
        let centre_angle = flank_angle + flank.sign() * (libm::atan(end / base) - libm::atan(along / base));
        // Angle from the direction of the root, as seen from the axis, towards the flank.
        let turned = flank_angle - centre_angle;
        let (sin, cos) = libm::sincos(turned);
        let end = libm::atan2(at_flank * sin, -flank.sign() * (at_flank * cos - centre_radius));
        let centre = Point { radius: centre_radius, angle: centre_angle };
        Self { flank, shift, corner: Corner::Form { centre, radius, end } }
    }

    /// A point of the fillet, as the tool would cut it without the flank: 0 at the root, 1 where the corner
    /// of the tool ends.
    pub(super) fn at(&self, t: f64) -> Point {
        let flank = &self.flank;
        let (radius, from_space) = match self.corner {
            Corner::Rack { xi, eta, radius, end, .. } => {
                let theta = t * end;
                let (sin, cos) = libm::sincos(theta);
                let (xi, eta) = ((xi + radius * sin) / flank.cos_beta, eta - radius * cos);
                let u = -eta * libm::tan(theta) * flank.cos_beta;
                let reference = flank.reference();
                (libm::hypot(u, reference + eta), libm::atan2(u, reference + eta) + (xi - u) / reference)
            }
            Corner::Shaper(Cutter { centre, normal, radius, working, distance, ratio }) => {
                let delta = centre.angle + t * (normal - centre.angle);
                let reach = centre.radius * libm::sin(delta - centre.angle) / working;
                let direction = libm::asin(reach.clamp(-1.0, 1.0));
                let turned = direction - delta;
                let (sin, cos) = libm::sincos(centre.angle + turned);
                let x = centre.radius * cos + radius * libm::cos(direction);
                let y = centre.radius * sin + radius * libm::sin(direction);
                // Distance from the axis of the gear, beyond the pitch point or, of a ring, behind the
                // cutter.
                let across = distance - x;
                let (from_axis, angle) = (libm::hypot(across, y), libm::atan(y / across));
                (from_axis, flank.sign() * angle - ratio * turned)
            }
            Corner::Form { centre, radius, end } => {
                let (sin, cos) = libm::sincos(t * end);
                let (x, y) = (centre.radius - flank.sign() * radius * cos, radius * sin);
                (libm::hypot(x, y), centre.angle + libm::atan2(y, x))
            }
        };
        Point { radius, angle: PI / flank.z.abs() - from_space }
    }

    /// Parameter at which the involute takes over, and whether the fillet removes a part of the involute.
    ///
    /// `reach` is the radius of curvature of the gear's flank where the flank of the tool ends. Below 0 the
    /// tool reaches below the tangent point of the base circle. In this case, and with a protuberance, the
    /// fillet crosses the involute further out. Otherwise both have a common tangent where the flank of the
    /// tool ends.
    pub(super) fn joint(&self, reach: f64) -> (f64, bool) {
        let excess = |t: f64| {
            let point = self.at(t);
            point.angle - self.flank.half_angle(self.shift, point.radius)
        };
        let crossing = |from: f64, to: f64| bisected([from, to], HALVINGS, |t| excess(t) < 0.0)[1];
        let corner = match self.corner {
            Corner::Rack { corner, .. } => corner,
            _ => 1.0,
        };
        if corner < 1.0 && excess(corner) < 0.0 {
            return (crossing(corner, 1.0), true);
        }
        if reach >= -TOUCH {
            return (corner, false);
        }
        // The corner ends on the other branch of the involute, beyond the base circle, and has cut into the
        // tooth before.
        let base = self.flank.base();
        let [_, at_base] = bisected([0.0, corner], HALVINGS, |t| self.at(t).radius <= base);
        (crossing(at_base, corner), true)
    }
}
