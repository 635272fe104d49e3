//! Gear as its tool cuts it: root circle, end of the involute, and the limit beyond which a shaper spoils
//! tips.
//!
//! Lengths in modules, transverse section; index 0 the cutter.
//!
//! ```text
//! hob         r_f = r − h_fP* + x_E             u = r·sin α_t − (h_fP* − ρ·(1 − sin α_n) − x_E)/sin α_t
//! shaper      inv α_w0 = inv α_t + 2·tan α_n·(x_0 + x)/(z_0 ± z)
//!             a_0 = (z ± z_0)/(2·cos β)·cos α_t/cos α_w0              − of a ring
//!             r_f = a_0 ∓ r_a0,  r_a0 = r_0 + h_aP0* + x_0            + of a ring
//!             g_0 = ρ_a0 + √((r_a0 − ρ_a0)² − r_b0²)                  u = ±(a_0·sin α_w0 ∓ g_0)
//! form tool   r_f = r ∓ (h_fP* ∓ x)                                   u = ∓ρ + √((r_f ± ρ)² − r_b²)
//! form circle d_Ff = 2·√(r_b² + u²) for u ≥ 0
//!             below, the tool undercuts: d_Ff is where fillet and involute cross
//! ```
//!
//! # Source
//! Derived from the meshing of tool and gear; the form circles of the NREL reference wind gearbox are met to
//! their printed digits.

use super::fault::ToolFault;
use super::fillet::{Cutter, Fillet, Point};
use super::flank::Flank;
use super::function::{angle_of_involute, involute};
use super::profile::Profile;
use super::tips::Tips;
use super::tool::{Shaper, Tool};
use crate::tolerance::TOUCH;
use epicyclic_numerics::roots::bisected;
use std::f64::consts::{FRAC_PI_2, PI};

/// A gear as its tool leaves it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    /// Root radius.
    pub(super) root: f64,
    /// Radius of curvature of the flank where the involute ends at the root.
    pub(super) end: f64,
    /// Radius of curvature of the flank where the flank of the tool ends; below 0 the tool undercuts.
    pub(super) reach: f64,
    /// The shaper in mesh, where one cuts the gear.
    pub(super) shaped: Option<Shaped>,
    /// Reason why the tool does not cut the gear. Root and end are then those that a shaper without room for
    /// its corners would leave, or the root circle of the basic rack.
    pub(super) fault: Option<ToolFault>,
}

/// Room that a shaper leaves for the tips of its work: each value is 0 or more where no tip is spoilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Room {
    /// Radius of curvature between the tip and where the base circle of the shaper touches the line of
    /// action, modules.
    pub(super) flank: f64,
    /// Angle of the ring, rad, by which tips of shaper and ring miss each other outside the mesh.
    pub(super) trochoidal: f64,
    /// Angle of the shaper, rad, by which they miss each other when it is fed radially.
    pub(super) radial: f64,
}

/// A shaper in mesh with the gear that it cuts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shaped {
    pub(super) shaper: Shaper,
    /// Addendum of the shaper.
    pub(super) addendum: f64,
    /// Tip radius and base radius of the shaper.
    pub(super) tip: f64,
    pub(super) base: f64,
    /// Centre distance, without sign.
    pub(super) distance: f64,
    /// Working transverse pressure angle, rad.
    pub(super) working_angle: f64,
}

impl Cut {
    /// A gear of profile shift `x` by a tool.
    pub(super) fn new(flank: &Flank, profile: &Profile, shift: f64, tool: &Tool) -> Self {
        let sign = flank.sign();
        let nominal = sign * (flank.signed_reference() - profile.dedendum() + shift);
        let known =
            |root: f64, reach: f64, shaped| Self { root, end: reach.max(0.0), reach, shaped, fault: None };
        let cut = match tool {
            Tool::Rack => {
                let generated = profile.generating_shift(shift);
                let straight = profile.dedendum() - profile.fillet * (1.0 - flank.sin_alpha_n);
                let reach =
                    flank.reference() * flank.sin_alpha_t - (straight - generated) / flank.sin_alpha_t;
                Ok(known(flank.reference() - profile.dedendum() + generated, reach, None))
            }
            Tool::Shaper(shaper) => shaped(flank, nominal, shift, shaper).map(|shaped| {
                let root = shaped.distance - sign * shaped.tip;
                let tangents = shaped.distance * libm::sin(shaped.working_angle);
                let reach = tangents - sign * shaped.corner();
                Self { fault: shaped.without_room(flank), ..known(root, reach, Some(shaped)) }
            }),
            Tool::Form { fillet } => {
                formed(flank, shift, nominal, *fillet).map(|reach| known(nominal, reach, None))
            }
        };
        let cut = cut.unwrap_or_else(|fault| Self {
            root: nominal,
            end: flank.curvature(nominal),
            reach: 0.0,
            shaped: None,
            fault: Some(fault),
        });
        if cut.reach < -TOUCH || flank.sign() > 0.0 && profile.protuberance > profile.stock {
            let Some(fillet) = cut.fillet(flank, profile, shift, tool) else { return cut };
            let (joint, _) = fillet.joint(cut.reach);
            return Self { end: flank.curvature(fillet.at(joint).radius), ..cut };
        }
        cut
    }

    /// Room that the shaper leaves for the tips of a gear with this tip radius; `None` for other tools.
    pub(super) fn room(&self, flank: &Flank, tip: f64) -> Option<Room> {
        let shaped = self.shaped?;
        let flank_room = -flank.sign() * (flank.curvature(tip) - self.tip_end()?);
        let tips = Tips {
            tips: [shaped.tip, tip],
            bases: [shaped.base, flank.base()],
            distance: shaped.distance,
            inv_w: involute(shaped.working_angle),
        };
        let [trochoidal, radial] =
            if flank.sign() < 0.0 { [tips.trochoidal(), tips.trimming()] } else { [f64::INFINITY; 2] };
        Some(Room { flank: flank_room, trochoidal, radial })
    }

    /// Radius of curvature of the flank beyond which the shaper leaves no involute, of a ring below which;
    /// `None` of other tools.
    pub(super) fn tip_end(&self) -> Option<f64> {
        self.shaped.map(|shaped| shaped.distance * libm::sin(shaped.working_angle))
    }

    /// The fillet; `None` where the tool does not cut the gear.
    pub(super) fn fillet(&self, flank: &Flank, profile: &Profile, shift: f64, tool: &Tool) -> Option<Fillet> {
        if self.fault.is_some() {
            return None;
        }
        Some(match tool {
            Tool::Rack => Fillet::by_rack(*flank, profile, shift),
            Tool::Form { fillet } => Fillet::by_form(*flank, shift, self.root, *fillet, self.reach.max(0.0)),
            Tool::Shaper(_) => Fillet::by_shaper(*flank, shift, self.shaped?.cutter(flank)),
        })
    }
}

impl Shaped {
    /// Length `g_0` along the normal of the shaper's flank from the base circle to where its corner begins.
    fn corner(&self) -> f64 {
        self.shaper.tip_radius + curvature(self.tip - self.shaper.tip_radius, self.base)
    }

    /// Reason why the tips of the shaper have no room for their corners; `None` where they have.
    fn without_room(&self, flank: &Flank) -> Option<ToolFault> {
        let has_room = |radius: f64| {
            let from_axis = self.tip - radius;
            let length = radius + curvature(from_axis, self.base);
            from_axis >= self.base && corner_angle(flank, &self.shaper, self.base, length, radius) >= 0.0
        };
        let radius = self.shaper.tip_radius;
        (!has_room(radius)).then(|| ToolFault::Corners {
            radius,
            most: largest(radius, has_room),
            addendum: self.addendum,
        })
    }

    /// Corner of the shaper's tooth as the fillet curve needs it.
    pub(super) fn cutter(&self, flank: &Flank) -> Cutter {
        let length = self.corner();
        let radius = self.shaper.tip_radius;
        let angle = corner_angle(flank, &self.shaper, self.base, length, radius);
        // The normal at the start of the corner is tangent to the base circle.
        let at_flank = angle - libm::atan((length - radius) / self.base);
        Cutter {
            centre: Point { radius: self.tip - radius, angle },
            normal: at_flank + FRAC_PI_2,
            radius,
            working: self.base / libm::cos(self.working_angle),
            distance: flank.sign() * self.distance,
            ratio: self.shaper.teeth.as_f64() / flank.z.abs(),
        }
    }
}

/// A shaper in mesh with the gear that it cuts, whose basic rack has this root circle.
fn shaped(flank: &Flank, nominal: f64, shift: f64, shaper: &Shaper) -> Result<Shaped, ToolFault> {
    let z0 = shaper.teeth.as_f64();
    if z0 >= -flank.z && flank.z < 0.0 {
        return Err(ToolFault::TooManyTeeth { cutter: shaper.teeth.get(), ring: -flank.z as u32 });
    }
    let sum = z0 + flank.z;
    let inv = flank.inv_alpha_t + 2.0 * flank.tan_alpha_n * (shaper.shift + shift) / sum;
    let working_angle = angle_of_involute(inv)
        .filter(|angle| *angle > 0.0)
        .ok_or(ToolFault::NoMesh { sum: shaper.shift + shift })?;
    let distance = sum.abs() / (2.0 * flank.cos_beta) * flank.cos_alpha_t / libm::cos(working_angle);
    let reference = z0 / (2.0 * flank.cos_beta);
    let base = reference * flank.cos_alpha_t;
    let tip = match shaper.addendum {
        Some(addendum) => reference + addendum + shaper.shift,
        None => flank.sign() * (distance - nominal),
    };
    let addendum = tip - reference - shaper.shift;
    Ok(Shaped { shaper: *shaper, addendum, tip, base, distance, working_angle })
}

/// Angle `θ_c` of the centre of a shaper's corner from the middle of its tooth; below 0 there is no room for
/// the corner.
fn corner_angle(flank: &Flank, shaper: &Shaper, base: f64, length: f64, radius: f64) -> f64 {
    let half = (FRAC_PI_2 + 2.0 * shaper.shift * flank.tan_alpha_n) / shaper.teeth.as_f64();
    let tan = (length - radius) / base;
    half + flank.inv_alpha_t - radius / base - (tan - libm::atan(tan))
}

/// The reach of a form tool: radius of curvature of the flank where its fillet begins.
fn formed(flank: &Flank, shift: f64, root: f64, radius: f64) -> Result<f64, ToolFault> {
    let sign = flank.sign();
    let centre = root + sign * radius;
    let base = flank.base();
    if sign < 0.0 && centre < base {
        return Err(ToolFault::Fillets { radius });
    }
    let reach = (curvature(centre, base) - sign * radius).max(0.0);
    // The arc is on its side of the middle of the space.
    let at_flank = libm::hypot(base, reach);
    let flank_angle = PI / flank.z.abs() - flank.half_angle(shift, at_flank);
    let turned = libm::atan(reach / base) - libm::atan((reach + sign * radius) / base);
    if flank_angle + sign * turned < 0.0 { Err(ToolFault::Fillets { radius }) } else { Ok(reach) }
}

/// Radius of curvature of an involute at a radius.
fn curvature(radius: f64, base: f64) -> f64 {
    (radius * radius - base * base).max(0.0).sqrt()
}

/// The largest radius below a bound for which there is room; below 0 for none.
fn largest(bound: f64, has_room: impl Fn(f64) -> bool) -> f64 {
    if has_room(0.0) { bisected([0.0, bound], super::fillet::HALVINGS, has_room)[0] } else { -1.0 }
}
