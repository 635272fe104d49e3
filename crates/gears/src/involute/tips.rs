//! Contact of the tips of an external gear and of a ring about it outside their mesh. The external gear is a
//! planet, or the shaper that cuts the ring.
//!
//! Index 1 the external gear, 2 the ring; radii and centre distance in one unit, `r_b1/r_b2 = z_1/z_2`.

/// An external gear within a ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tips {
    /// Tip radii.
    pub(super) tips: [f64; 2],
    /// Base radii.
    pub(super) bases: [f64; 2],
    /// Centre distance.
    pub(super) distance: f64,
    /// Involute function of the working angle.
    pub(super) inv_w: f64,
}

impl Tips {
    /// Tangent of the transverse pressure angle at the tip of a gear; 0 within its base circle.
    fn tangent(&self, gear: usize) -> f64 {
        let ratio = self.tips[gear] / self.bases[gear];
        (ratio * ratio - 1.0).max(0.0).sqrt()
    }

    fn involutes(&self) -> [f64; 2] {
        [0, 1].map(|gear| {
            let tan = self.tangent(gear);
            tan - libm::atan(tan)
        })
    }

    fn ratio(&self) -> f64 {
        self.bases[1] / self.bases[0]
    }

    /// Angle of the ring, rad, by which the tips miss each other after they have left the mesh.
    ///
    /// If the tip circle of the external gear encloses that of the ring, some tooth is always in the way and
    /// the angle is −∞. If the tip circles do not meet, it is +∞.
    pub(super) fn trochoidal(&self) -> f64 {
        let ([r1, r2], a) = (self.tips, self.distance);
        if r1 >= r2 + a {
            return f64::NEG_INFINITY;
        }
        if r1 + a <= r2 {
            return f64::INFINITY;
        }
        let [inv1, inv2] = self.involutes();
        let theta1 = libm::acos((r2 * r2 - r1 * r1 - a * a) / (2.0 * a * r1)) + inv1 - self.inv_w;
        let theta2 = libm::acos((a * a + r2 * r2 - r1 * r1) / (2.0 * a * r2));
        theta1 / self.ratio() + self.inv_w - inv2 - theta2
    }

    /// Angle of the external gear, rad, by which the tips miss each other when it is moved radially. It is −∞
    /// where the tips of the ring reach within its base circle, +∞ where they never meet.
    pub(super) fn trimming(&self) -> f64 {
        if self.tips[1] < self.bases[1] {
            return f64::NEG_INFINITY;
        }
        let ratio = self.ratio();
        let [cos1, cos2] = [0, 1].map(|gear| 1.0 / libm::hypot(1.0, self.tangent(gear)));
        let cosines = cos1 / cos2;
        let sine1 = (1.0 - cosines * cosines) / (1.0 - 1.0 / (ratio * ratio));
        let sine2 = (1.0 / (cosines * cosines) - 1.0) / (ratio * ratio - 1.0);
        if !((0.0..=1.0).contains(&sine1) && (0.0..=1.0).contains(&sine2)) {
            return f64::INFINITY;
        }
        let ([inv1, inv2], inv_w) = (self.involutes(), self.inv_w);
        let (theta1, theta2) = (libm::asin(sine1.sqrt()), libm::asin(sine2.sqrt()));
        theta1 + inv1 - inv_w - ratio * (theta2 + inv2 - inv_w)
    }
}
