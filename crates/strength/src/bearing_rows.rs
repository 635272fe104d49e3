//! A planet on two bearing rows, or on two bearings, under a radial force and a tilting moment.
//!
//! ```text
//! F⃗_1,2 = F⃗/2 ± M⃗ × z⃗/s        P = 2·((F_1^w + F_2^w)/2)^(1/w)        w = 10/3 of balls, 9/2 of rollers
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `F⃗`, `M⃗` | `force`, `moment` | radial force on the planet midway between the rows, tilting moment | N, N·m |
//! | `z⃗` | | direction of the pin, across `F⃗` and `M⃗` | 1 |
//! | `s` | `span` | distance of the middles of both rows | m |
//! | `F_1`, `F_2` | `rows` | radial force on either row | N |
//! | `P` | | equivalent load of both rows, for their load rating together | N |
//!
//! A plain bearing has two halves in place of rows, and `w` is infinite: `P` is twice the load of the half with more.
//!
//! The rows carry the force and the moment: `F⃗_1 + F⃗_2 = F⃗`, `z⃗·s/2 × (F⃗_1 − F⃗_2) = M⃗`.
//!
//! The exponent `w` is that of ISO 281 for two bearing rows as a unit, rated `2^(1 − 1/w)` times one: `2^0.7`
//! with balls, `2^(7/9)` with rollers. The unit fails with the first of its rows, whose lives are joined as
//! those of two bearings: `w` is the exponent of life times the Weibull slope, 3·10/9 with balls and 4·9/8
//! with rollers. Without a moment `P = F`; where one row carries all, the life is that of one row by its own
//! rating.
//!
//! # Left out
//! The axial force on the planet; the change of the contact angle under it; the stiffness of pin and races.
//!
//! # Source
//! ISO 281:2007, 5.1.2 and 7.1.2: load ratings of two bearing rows as a unit. The rows by statics.

use epicyclic_gears::life::Rolling;
use epicyclic_units::Physical;
use uom::si::f64::{Force, Length, Torque};

/// Radial forces of both rows as vectors, for a force and a moment in the same two directions across the pin;
/// of a right-handed frame with the pin as its third axis, in whose direction the first row lies.
///
/// ```
/// use epicyclic_strength::bearing_rows::row_forces;
/// use uom::si::f64::{Force, Length, Torque};
/// use uom::si::{force::newton, length::meter, torque::newton_meter};
///
/// let newtons = Force::new::<newton>;
/// let moment = [Torque::new::<newton_meter>(0.0), Torque::new::<newton_meter>(50.0)];
/// let rows = row_forces([newtons(0.0), newtons(2000.0)], moment, Length::new::<meter>(0.1));
/// // Half the force each, and 500 N outwards and inwards.
/// assert_eq!(rows.map(|row| row.map(|part| part.get::<newton>())), [[500.0, 1000.0], [-500.0, 1000.0]]);
/// ```
#[must_use]
pub fn row_forces(force: [Force; 2], moment: [Torque; 2], span: Length) -> [[Force; 2]; 2] {
    let half = force.map(|part| part / 2.0);
    let [first, second] = moment.map(|part| Force::from_si(part.si() / span.si()));
    [[half[0] + second, half[1] - first], [half[0] - second, half[1] + first]]
}

/// Equivalent load `P` of both rows for their load rating together.
#[must_use]
pub fn equivalent_load(rolling: Rolling, rows: [Force; 2]) -> Force {
    let largest = rows[0].max(rows[1]);
    let exponent = match rolling {
        Rolling::Balls => 10.0 / 3.0,
        Rolling::Rollers | Rolling::Needles | Rolling::FullComplement => 9.0 / 2.0,
        Rolling::Plain => return 2.0 * largest,
    };
    if largest.si() == 0.0 {
        return largest;
    }
    // Over the largest, so that no power overflows.
    let sum: f64 = rows.iter().map(|row| libm::pow((*row / largest).value, exponent)).sum();
    2.0 * largest * libm::pow(sum / 2.0, 1.0 / exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sizing::bearing::listed;
    use epicyclic_gears::life::basic_rating_life;
    use proptest::prelude::*;
    use uom::si::f64::AngularVelocity;

    fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    proptest! {
        /// A planet as a rigid body in space: forces in its meshes at any points of its middle plane, a body
        /// force at its centre, and both rows. Neither a force nor a moment across the pin is left.
        #[test]
        fn a_planet_on_both_rows_is_in_balance(
            forces in prop::collection::vec(prop::array::uniform3(-1e4..1e4_f64), 1..5),
            places in prop::collection::vec((0.01..0.2_f64, -3.2..3.2_f64), 5),
            body in prop::array::uniform2(-1e4..1e4_f64), span_m in 0.01..0.3_f64,
        ) {
            let (mut force, mut moment) = ([body[0], body[1], 0.0], [0.0; 3]);
            for (push, (radius, angle)) in forces.iter().zip(&places) {
                let at = [radius * libm::cos(*angle), radius * libm::sin(*angle), 0.0];
                let turn = cross(at, *push);
                (0..3).for_each(|axis| {
                    force[axis] += push[axis];
                    moment[axis] += turn[axis];
                });
            }
            let rows = row_forces(
                [Force::from_si(force[0]), Force::from_si(force[1])],
                [Torque::from_si(moment[0]), Torque::from_si(moment[1])],
                Length::from_si(span_m),
            );
            // The rows push back.
            for (row, end) in rows.iter().zip([0.5, -0.5]) {
                let back = [-row[0].si(), -row[1].si(), 0.0];
                let turn = cross([0.0, 0.0, end * span_m], back);
                (0..3).for_each(|axis| {
                    force[axis] += back[axis];
                    moment[axis] += turn[axis];
                });
            }
            prop_assert!(force[0].abs().max(force[1].abs()) < 1e-8, "{force:?}");
            prop_assert!(moment[0].abs().max(moment[1].abs()) < 1e-8, "{moment:?}");
        }

        /// The life of the unit is that of two bearings of half the unit, of which none may fail.
        #[test]
        fn the_life_is_that_of_both_rows_of_which_none_fails(first in 1e3..2e4_f64, second in 1e3..2e4_f64) {
            let rows = [first, second].map(Force::from_si);
            for rolling in [Rolling::Balls, Rolling::Rollers] {
                let together = equivalent_load(rolling, rows);
                let (unit, exponent, slope) = match rolling {
                    Rolling::Balls => (libm::pow(2.0, 0.7), 3.0, 10.0 / 9.0),
                    _ => (libm::pow(2.0, 7.0 / 9.0), 4.0, 9.0 / 8.0),
                };
                // Lives in the measure of the unit's rating 1; failures of rows with one slope add up.
                let life = |load: f64, rating: f64| libm::pow(rating / load, exponent);
                let failures = |row: &Force| libm::pow(1.0 / life(row.si(), 1.0 / unit), slope);
                let joined = libm::pow(rows.iter().map(failures).sum::<f64>(), -1.0 / slope);
                prop_assert!((life(together.si(), 1.0) / joined - 1.0).abs() < 1e-9);
                prop_assert!(together >= rows[0] + rows[1] - Force::from_si(1e-6));
            }
        }
    }

    #[test]
    fn equal_rows_are_the_pair_and_one_row_alone_is_one_bearing() {
        let speed = AngularVelocity::from_rpm(500.0);
        let one = &listed()[30];
        let pair = one.pair();
        let life =
            |rating, load| basic_rating_life(Rolling::Balls, rating, load, speed).unwrap().unwrap().hours();
        let load = |rows: [f64; 2]| equivalent_load(Rolling::Balls, rows.map(Force::from_si));
        assert!((load([3e3, 3e3]).si() - 6e3).abs() < 1e-9);
        let alone = life(pair.load_rating, load([3e3, 0.0]));
        assert!((alone / life(one.load_rating, Force::from_si(3e3)) - 1.0).abs() < 1e-12);
        assert_eq!(load([0.0, 0.0]).si(), 0.0);
        let halves = [3e3, 1e3].map(Force::from_si);
        assert_eq!(equivalent_load(Rolling::Plain, halves).si(), 6e3);
    }
}
