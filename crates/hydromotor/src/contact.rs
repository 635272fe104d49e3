//! The contact of a satellite with both wheels along a half-lobe, common to all conjugate pairs of centrodes.
//!
//! In units of the module and radians. Everything is counted from where a stator crest faces a rotor crest
//! across a satellite; the *phase* `Φ = θ₃ + θ₁` is the angle of the rotor since then. From the crest, radii
//! fall and `μ` is negative up to the trough, where it vanishes again.

/// A satellite between the wheels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact {
    /// `Φ = θ₃ + θ₁`.
    pub(crate) phase: f64,
    /// Polar angles of the contact on the stator, counter-clockwise, and on the rotor, clockwise.
    pub(crate) theta3: f64,
    pub(crate) theta1: f64,
    pub(crate) rho3: f64,
    pub(crate) rho1: f64,
    /// Polar angle less that of the normal, on either curve; `dρ/ds = sin μ`.
    pub(crate) mu: f64,
    /// Arc lengths rolled on either wheel, `s₁ − s₃ = 2·r·μ`.
    pub(crate) s3: f64,
    pub(crate) s1: f64,
    pub(crate) kappa3: f64,
    pub(crate) kappa1: f64,
    /// `G = ∫ f dΦ` with `f = ½·ρ₁·ρ₃`: the area that the satellite sweeps.
    pub(crate) swept: f64,
}

/// Curvature of the wheel across the satellite: of the rotor for `r > 0` from that of the stator, and of the
/// stator from that of the rotor for `r < 0` (Euler and Savary).
pub(crate) fn conjugate_curvature(r: f64, cos_mu: f64, rho: f64, kappa: f64, rho_across: f64) -> f64 {
    let turn = cos_mu / rho - kappa;
    cos_mu / rho_across - turn / (1.0 + 2.0 * r * turn)
}

/// Quantity that grows along the half-lobe and identifies a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum By {
    Phase,
    StatorArc,
    RotorArc,
    StatorAngle,
    RotorAngle,
}

impl Contact {
    pub(crate) fn get(&self, by: By) -> f64 {
        match by {
            By::Phase => self.phase,
            By::StatorArc => self.s3,
            By::RotorArc => self.s1,
            By::StatorAngle => self.theta3,
            By::RotorAngle => self.theta1,
        }
    }

    /// Derivative of the quantity by the stator's arc length; above 0 for a motor.
    pub(crate) fn slope(&self, by: By, r: f64) -> f64 {
        let cos_mu = libm::cos(self.mu);
        match by {
            By::Phase => 2.0 * cos_mu * (1.0 - r * self.kappa3) / self.rho1,
            By::StatorArc => 1.0,
            By::RotorArc => 1.0 + 2.0 * r * (cos_mu / self.rho3 - self.kappa3),
            By::StatorAngle => cos_mu / self.rho3,
            By::RotorAngle => self.slope(By::Phase, r) - cos_mu / self.rho3,
        }
    }

    /// `f = ½·ρ₁·ρ₃`.
    pub(crate) fn flow(&self) -> f64 {
        0.5 * self.rho1 * self.rho3
    }

    /// `df/dΦ`.
    pub(crate) fn flow_slope(&self, r: f64) -> f64 {
        let sine = libm::sin(self.mu);
        let by_arc = self.rho3 * self.slope(By::RotorArc, r) + self.rho1;
        0.5 * sine * by_arc / self.slope(By::Phase, r)
    }

    /// The contact mirrored in the crest.
    fn mirrored(self) -> Self {
        Self {
            phase: -self.phase,
            theta3: -self.theta3,
            theta1: -self.theta1,
            mu: -self.mu,
            s3: -self.s3,
            s1: -self.s1,
            swept: -self.swept,
            ..self
        }
    }

    /// Returns the contact moved back by whole lobes; `end` is the contact at the trough.
    pub(crate) fn lobes_back(&self, lobes: f64, end: &Self) -> Self {
        if lobes == 0.0 { *self } else { self.shifted(-lobes, end) }
    }

    /// Returns the contact moved on by whole lobes; `end` is the contact at the trough.
    fn shifted(self, lobes: f64, end: &Self) -> Self {
        let by = 2.0 * lobes;
        Self {
            phase: self.phase + by * end.phase,
            theta3: self.theta3 + by * end.theta3,
            theta1: self.theta1 + by * end.theta1,
            s3: self.s3 + by * end.s3,
            s1: self.s1 + by * end.s1,
            swept: self.swept + by * end.swept,
            ..self
        }
    }
}

/// A stator and a rotor conjugate by satellites, known by a half-lobe from crest to trough.
pub(crate) trait Conjugate {
    /// Pitch radius of a satellite.
    fn satellite_radius(&self) -> f64;

    /// The contact at the trough.
    fn trough(&self) -> &Contact;

    /// The contact where a quantity has a value between 0 and its value at the trough.
    fn within(&self, by: By, value: f64) -> Contact;

    /// The phase where the curvature jumps, if it does.
    fn kink(&self) -> Option<f64>;

    /// Area between the rotor's centrode and the axis, of a half-lobe.
    fn rotor_area(&self) -> f64;

    /// `f` and `df/dΦ` at a phase between 0 and that of the trough.
    fn flow_within(&self, phase: f64) -> (f64, f64) {
        let contact = self.within(By::Phase, phase);
        (contact.flow(), contact.flow_slope(self.satellite_radius()))
    }

    /// The greatest of `−κ₃`, `κ₃`, `κ₁`, `−κ₁` along the half-lobe; 0 of those that are negative throughout.
    fn curvature_extremes(&self) -> [f64; 4];

    /// The satellite's centre at a phase between 0 and that of the trough, in the stator's frame.
    fn centre_within(&self, phase: f64) -> [f64; 2] {
        let contact = self.within(By::Phase, phase);
        let r = self.satellite_radius();
        let (sin, cos) = libm::sincos(contact.theta3);
        let (normal_sin, normal_cos) = libm::sincos(contact.theta3 - contact.mu);
        [contact.rho3 * cos - r * normal_cos, contact.rho3 * sin - r * normal_sin]
    }

    /// The satellite's centre at any phase, in the stator's frame.
    fn centre(&self, phase: f64) -> [f64; 2] {
        let trough = self.trough();
        let lobes = (phase / (2.0 * trough.phase)).round();
        let rest = phase - 2.0 * lobes * trough.phase;
        let [x, y] = self.centre_within(rest.abs().min(trough.phase));
        let y = if rest < 0.0 { -y } else { y };
        if lobes == 0.0 {
            return [x, y];
        }
        let (sin, cos) = libm::sincos(2.0 * lobes * trough.theta3);
        [x * cos - y * sin, x * sin + y * cos]
    }

    /// `f` and `df/dΦ` at any phase.
    fn flow(&self, phase: f64) -> (f64, f64) {
        let end = self.trough().phase;
        let rest = phase - 2.0 * (phase / (2.0 * end)).round() * end;
        let (flow, slope) = self.flow_within(rest.abs().min(end));
        (flow, if rest < 0.0 { -slope } else { slope })
    }

    /// The contact at any value: the half-lobe mirrored and repeated.
    fn at(&self, by: By, value: f64) -> Contact {
        let trough = self.trough();
        let end = trough.get(by);
        let lobes = (value / (2.0 * end)).round();
        let rest = value - 2.0 * lobes * end;
        let contact = self.within(by, rest.abs().min(end));
        let contact = if rest < 0.0 { contact.mirrored() } else { contact };
        if lobes == 0.0 { contact } else { contact.shifted(lobes, trough) }
    }
}

/// The greatest of `−κ₃`, `κ₃`, `κ₁`, `−κ₁` of some contacts; 0 of those that are negative throughout.
pub(crate) fn greatest_curvatures(contacts: impl Iterator<Item = Contact>) -> [f64; 4] {
    contacts.fold([0.0_f64; 4], |greatest, contact| {
        let curvatures = [-contact.kappa3, contact.kappa3, contact.kappa1, -contact.kappa1];
        std::array::from_fn(|i| greatest[i].max(curvatures[i]))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_wheels_have_round_partners() {
        // Stator of radius 30, satellite of 5: a rotor of radius 20.
        assert!((conjugate_curvature(5.0, 1.0, 30.0, 1.0 / 30.0, 20.0) - 0.05).abs() < 1e-16);
        assert!((conjugate_curvature(-5.0, 1.0, 20.0, 0.05, 30.0) - 1.0 / 30.0).abs() < 1e-16);
    }
}
