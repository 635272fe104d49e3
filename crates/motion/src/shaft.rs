//! Elastic, damped shafts with backlash between two links.
//!
//! ```text
//! φ̇ = ω_1 − ω_2
//! T = c·φ + d·φ̇                        without backlash
//! T = max(0, c·δ + d·φ̇),  δ = φ − j/2   where δ > 0, and its mirror image where φ < −j/2; else 0
//! T_1 = −T    T_2 = T
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `φ` | twist, 0 in the middle of the backlash | rad |
//! | `c`, `d` | stiffness, damping | N·m/rad, N·m·s/rad |
//! | `j` | backlash: the twist from contact on one side to contact on the other | rad |
//! | `T` | torque that the shaft passes on | N·m |
//!
//! # Contact
//! Flanks only push. Contact begins when the backlash is used up, `δ = 0`, and the torque there jumps to
//! `d·φ̇`. It ends when the torque has come down to 0, which with damping is before `δ = 0`. From there the
//! flank alone relaxes and spends its remaining energy in its damper, without torque. The torque is 0 exactly
//! while `φ̇ < −c·δ/d`, so that energy decreases at the rate `−c·δ·φ̇ > 0`. Hence twist and its rate alone
//! determine the torque, the stored energy is `½·c·δ²` everywhere, and no heat is ever below 0. The
//! alternative is a massless flank with a position of its own. It would have one more state for each flank
//! and the same torque but for a second contact within its relaxation `d/c`.
//!
//! Without backlash, `j = 0`, the shaft has no flanks: it pulls and pushes. The limit `j → 0` differs from it
//! by the damping torque that flanks do not pull with.

use crate::Error;
use crate::course::finite;
use crate::mechanism::{Place, not_negative};
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Torque};

/// Stiffness, damping and backlash of a shaft between two links.
///
/// ```
/// use epicyclic_motion::Shaft;
/// use uom::si::f64::{Angle, AngularVelocity, Torque};
/// use uom::si::{angle::radian, angular_velocity::radian_per_second, torque::newton_meter};
/// # fn main() -> Result<(), epicyclic_motion::Error> {
/// let (n_m, rad) = (Torque::new::<newton_meter>, Angle::new::<radian>);
/// // 8000 N·m/rad, 5 N·m·s/rad, and 0.03 rad of play.
/// let damping = (n_m(5.0), AngularVelocity::new::<radian_per_second>(1.0));
/// let shaft = Shaft::new(n_m(8000.0), rad(1.0))?.damping(damping.0, damping.1)?.backlash(rad(0.03))?;
/// # let _ = shaft;
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    pub(crate) backlash: f64,
}

impl Shaft {
    /// A shaft that passes on this torque under this twist, without damping and backlash.
    ///
    /// # Errors
    /// [`Error::Value`] unless both are finite and above 0.
    pub fn new(torque: Torque, twist: Angle) -> Result<Self, Error> {
        let torque = positive("the torque that twists a shaft in N·m", torque.si())?;
        let twist = positive("its twist in rad", twist.si())?;
        let stiffness = positive("the stiffness of a shaft in N·m/rad", torque / twist)?;
        Ok(Self { stiffness, damping: 0.0, backlash: 0.0 })
    }

    /// Returns the shaft with a damper parallel to the spring: `torque` when the ends turn against each other
    /// at `speed`.
    ///
    /// # Errors
    /// [`Error::Value`] for a torque that is not finite or below 0, and for a speed that is not finite and
    /// above 0.
    pub fn damping(self, torque: Torque, speed: AngularVelocity) -> Result<Self, Error> {
        let torque = not_negative("the damping torque of a shaft in N·m".into(), torque.si())?;
        let speed = positive("its speed in rad/s", speed.si())?;
        let damping = not_negative("the damping of a shaft in N·m·s/rad".into(), torque / speed)?;
        Ok(Self { damping, ..self })
    }

    /// Returns the shaft with a play between contact on one side and on the other.
    ///
    /// # Errors
    /// [`Error::Value`] for a play that is not finite or below 0.
    pub fn backlash(self, play: Angle) -> Result<Self, Error> {
        let backlash = not_negative("the backlash of a shaft in rad".into(), play.si())?;
        Ok(Self { backlash, ..self })
    }
}

fn positive(field: &str, value: f64) -> Result<f64, Error> {
    if finite(field, value)? > 0.0 {
        Ok(value)
    } else {
        Err(Error::Value { field: field.to_owned(), value, allowed: "it is above 0" })
    }
}

/// Contact at the ends of a shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// Within the backlash, or apart while the flank relaxes: no torque.
    Free,
    /// `φ > 0`: the first link drives the second forward.
    Forward,
    /// `φ < 0`.
    Backward,
}

/// Mode in which a shaft passes on torque between two events.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Flank {
    /// Shaft without backlash.
    Firm,
    /// Within the backlash.
    Free,
    /// Flank in contact, 1 if `φ > 0`, −1 if `φ < 0`.
    Touching(i8),
    /// Flank beyond the backlash without torque.
    Relaxing(i8),
}

impl Flank {
    /// Side of the flank; 0 without a side.
    fn side(self) -> f64 {
        match self {
            Self::Firm | Self::Free => 0.0,
            Self::Touching(side) | Self::Relaxing(side) => f64::from(side),
        }
    }

    /// Contact as recorded in results, under this twist.
    pub(crate) fn contact(self, twist: f64) -> Contact {
        match self {
            Self::Free | Self::Relaxing(_) => Contact::Free,
            Self::Touching(side) if side > 0 => Contact::Forward,
            Self::Touching(_) => Contact::Backward,
            Self::Firm if twist < 0.0 => Contact::Backward,
            Self::Firm => Contact::Forward,
        }
    }
}

/// A shaft in a model.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) places: [Place; 2],
    /// `ω_1 − ω_2` over the coordinates.
    pub(crate) rate: Vec<f64>,
    pub(crate) shaft: Shaft,
}

impl Shaft {
    /// Twist of the spring: `φ` less half the backlash on its side.
    fn spring(&self, flank: Flank, twist: f64) -> f64 {
        twist - 0.5 * self.backlash * flank.side()
    }

    /// `c·δ + d·φ̇` on the side of the flank.
    fn pressed(&self, flank: Flank, twist: f64, rate: f64) -> f64 {
        self.stiffness * self.spring(flank, twist) + self.damping * rate
    }

    /// Torque that the shaft passes on.
    pub(crate) fn torque(&self, flank: Flank, twist: f64, rate: f64) -> f64 {
        match flank {
            Flank::Firm | Flank::Touching(_) => self.pressed(flank, twist, rate),
            Flank::Free | Flank::Relaxing(_) => 0.0,
        }
    }

    /// Power that the damper takes.
    pub(crate) fn heat(&self, flank: Flank, twist: f64, rate: f64) -> f64 {
        match flank {
            Flank::Firm | Flank::Touching(_) => self.damping * rate * rate,
            Flank::Relaxing(_) => -self.stiffness * self.spring(flank, twist) * rate,
            Flank::Free => 0.0,
        }
    }

    /// `½·c·δ²`.
    pub(crate) fn energy(&self, twist: f64) -> f64 {
        let beyond = (twist.abs() - 0.5 * self.backlash).max(0.0);
        0.5 * self.stiffness * beyond * beyond
    }

    /// Mode of the shaft under a twist and its rate.
    pub(crate) fn flank(&self, twist: f64, rate: f64) -> Flank {
        if self.backlash == 0.0 {
            return Flank::Firm;
        }
        if twist.abs() <= 0.5 * self.backlash {
            return Flank::Free;
        }
        let side = if twist > 0.0 { 1 } else { -1 };
        let touching = Flank::Touching(side);
        if f64::from(side) * self.pressed(touching, twist, rate) > 0.0 {
            touching
        } else {
            Flank::Relaxing(side)
        }
    }

    /// Margins up to which the mode of the shaft goes on, two or `None` for an end that does not exist; see
    /// [`next`](Self::next).
    pub(crate) fn margins(&self, flank: Flank, twist: f64, rate: f64) -> [Option<f64>; 2] {
        let half = 0.5 * self.backlash;
        let side = flank.side();
        match flank {
            Flank::Firm => [None, None],
            Flank::Free => [Some(half - twist), Some(half + twist)],
            Flank::Touching(_) => [Some(side * self.pressed(flank, twist, rate)), None],
            Flank::Relaxing(_) => {
                [Some(side * self.spring(flank, twist)), Some(-side * self.pressed(flank, twist, rate))]
            }
        }
    }

    /// Mode of the shaft after the first or second of its margins has ended, and the twist there if it is
    /// known exactly.
    pub(crate) fn next(&self, flank: Flank, is_second: bool, twist: f64) -> (Flank, f64) {
        let half = 0.5 * self.backlash;
        let end = |flank: Flank| flank.side() * half;
        match (flank, is_second) {
            (Flank::Firm, _) => (flank, twist),
            (Flank::Free, false) => (Flank::Touching(1), half),
            (Flank::Free, true) => (Flank::Touching(-1), -half),
            (Flank::Touching(_), _) if self.damping == 0.0 => (Flank::Free, end(flank)),
            (Flank::Touching(side), _) if flank.side() * self.spring(flank, twist) > 0.0 => {
                (Flank::Relaxing(side), twist)
            }
            (Flank::Touching(_), _) | (Flank::Relaxing(_), false) => (Flank::Free, end(flank)),
            (Flank::Relaxing(side), true) => (Flank::Touching(side), twist),
        }
    }
}
