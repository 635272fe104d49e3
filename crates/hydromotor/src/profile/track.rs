//! A wheel's centrode as the track that the satellite rolls along.
//!
//! The track runs the way that contact goes as the rotor turns, counter-clockwise along the stator and
//! clockwise along the rotor. So on either wheel the satellite is to the left and the teeth's roots to the
//! right. Each track is in its wheel's own frame.

use crate::centrode::Wheel;
use crate::contact::{By, Conjugate, Contact};
use crate::motor::Shape;
use crate::tolerance::WITHIN;
use std::f64::consts::FRAC_PI_2;

/// A wheel with a track.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Stator,
    Rotor,
}

impl Side {
    pub(crate) const BOTH: [Self; 2] = [Self::Stator, Self::Rotor];

    pub(super) fn wheel(self) -> Wheel {
        match self {
            Self::Stator => Wheel::Stator,
            Self::Rotor => Wheel::Rotor,
        }
    }
}

/// A place of the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    /// Arc length from the crest.
    pub(super) s: f64,
    pub(super) at: [f64; 2],
    /// Unit vector along the track.
    pub(super) along: [f64; 2],
    /// Curvature, positive towards the satellite.
    pub(super) curvature: f64,
}

impl Frame {
    /// The point at distances along the track and across it to the left, from here.
    pub(super) fn point(&self, along: f64, across: f64) -> [f64; 2] {
        let ([x, y], [tx, ty]) = (self.at, self.along);
        [x + along * tx - across * ty, y + along * ty + across * tx]
    }
}

/// The track of a wheel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Track<'a> {
    pub(super) shape: &'a Shape,
    pub(super) side: Side,
}

impl Track<'_> {
    fn arc(&self) -> By {
        match self.side {
            Side::Stator => By::StatorArc,
            Side::Rotor => By::RotorArc,
        }
    }

    /// Length of a lobe.
    pub(super) fn lobe(&self) -> f64 {
        2.0 * self.shape.trough().get(self.arc())
    }

    /// Arc lengths just before and behind each jump of the curvature between two arc lengths, in no order.
    pub(super) fn jumps(&self, from: f64, to: f64) -> Vec<f64> {
        let Some(phase) = self.shape.kink() else { return Vec::new() };
        let (kink, lobe) = (self.shape.within(By::Phase, phase).get(self.arc()), self.lobe());
        let (low, high) = (from.min(to), from.max(to));
        let near = |s: f64| [s * (1.0 - WITHIN), s * (1.0 + WITHIN)];
        let first = (low / lobe).floor() as i64;
        let last = (high / lobe).ceil() as i64;
        (first..=last)
            .flat_map(|k| [kink + lobe * k as f64, lobe * k as f64 - kink])
            .flat_map(near)
            .filter(|s| (low..=high).contains(s))
            .collect()
    }

    pub(super) fn at(&self, s: f64) -> Frame {
        self.frame(&self.shape.at(self.arc(), s))
    }

    pub(super) fn frame(&self, contact: &Contact) -> Frame {
        let Contact { mu, .. } = *contact;
        let (s, rho, theta, kappa) = match self.side {
            Side::Stator => (contact.s3, contact.rho3, contact.theta3, contact.kappa3),
            Side::Rotor => (contact.s1, contact.rho1, contact.theta1, contact.kappa1),
        };
        let (sin, cos) = libm::sincos(theta);
        let (along_sin, along_cos) = libm::sincos(theta + FRAC_PI_2 - mu);
        match self.side {
            Side::Stator => {
                Frame { s, at: [rho * cos, rho * sin], along: [along_cos, along_sin], curvature: kappa }
            }
            Side::Rotor => {
                Frame { s, at: [rho * cos, -rho * sin], along: [along_cos, -along_sin], curvature: -kappa }
            }
        }
    }

    /// `count` places from one arc length on towards another, which is left out; the first exactly there.
    ///
    /// Evenly in the shape's own parameter: the rotor's arc length is a function of the stator's, not the
    /// other way round.
    pub(super) fn frames(&self, from: f64, to: f64, count: u32) -> impl Iterator<Item = Frame> {
        let by = self.shape.explicit();
        let [from, to] =
            [from, to].map(|s| if by == self.arc() { s } else { self.shape.at(self.arc(), s).get(by) });
        let step = (to - from) / f64::from(count);
        let track = *self;
        (0..count).map(move |i| track.frame(&track.shape.at(by, from + step * f64::from(i))))
    }
}
