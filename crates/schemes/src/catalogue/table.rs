//! The table of the catalogue: the one place that says what the fourteen schemes are.
//!
//! A line holds the name, the links of sun, ring and carrier of each set, and the closed forms of the last
//! braked gear. Names, structures, modes, ranges, ring-to-sun ratios from ratios, gearboxes and the formulas
//! that are shown are all read from it. A closed form is written once: the function and its text are the same
//! tokens.
//!
//! # Where this departs from the print
//! (2.49), the ratio of II-2, is printed as a copy of (2.39); the one here follows from the scheme and
//! is the inverse of the ratio inside the printed (2.50). Among the efficiencies (2.59) is printed with a
//! stray "2", (2.54) and (2.57) with a stray "+", and (2.61) breaks off: all are
//! taken as the torque balance has them.
//!
//! # Source
//! multispeed-gearboxes (2.26)–(2.31), (2.39)–(2.61); the number (2.55) does not exist.

use super::Role::{self, B, D, T1, T2};

/// A closed form in `k₁`, `k₂` and `η₀`.
#[derive(Debug, Clone, Copy)]
pub struct ClosedForm {
    of: fn(f64, f64, f64) -> f64,
    text: &'static str,
}

impl ClosedForm {
    /// Value of the form; a form of one set ignores `k₂`, and a ratio ignores `η₀`.
    #[must_use]
    pub fn value(&self, k1: f64, k2: f64, eta0: f64) -> f64 {
        (self.of)(k1, k2, eta0)
    }

    /// Text of the form in `k1`, `k2`, `eta0`: `(k1+1)*(k2+1)/(k1+k2+1)`.
    #[must_use]
    pub fn text(&self) -> String {
        self.text.split_whitespace().collect::<String>().replace(".0", "")
    }
}

/// A line of the table.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) name: &'static str,
    /// Links of `a b H` of each set.
    pub(super) sets: &'static [[Role; 3]],
    /// Ratio of the last braked gear.
    pub(super) ratio: ClosedForm,
    /// Efficiency of the last braked gear, each set losing `1 − η₀` of its rolling power. By Kreines' rule it
    /// is the ratio with each `k` times `η₀^±1`, over the ratio itself.
    pub(super) efficiency: ClosedForm,
}

macro_rules! lines {
    (($k1:ident, $k2:ident, $eta0:ident) $($name:literal $sets:expr, i = $ratio:expr, eta = $efficiency:expr;)*) => {
        [$(Line {
            name: $name,
            sets: &$sets,
            ratio: ClosedForm { of: |$k1, $k2, $eta0| { let _ = ($k1, $k2, $eta0); $ratio }, text: stringify!($ratio) },
            efficiency: ClosedForm {
                of: |$k1, $k2, $eta0| { let _ = ($k1, $k2, $eta0); $efficiency },
                text: stringify!($efficiency),
            },
        },)*]
    };
}

/// I, II, III.
#[rustfmt::skip]
pub(super) static TWO_SPEED: [Line; 3] = lines! { (k1, k2, eta0)
    "I" [[D, T1, B]],
        i = 1.0 + k1,
        eta = (1.0 + k1 * eta0) / (1.0 + k1);
    "II" [[T1, D, B]],
        i = (1.0 + k1) / k1,
        eta = (k1 + eta0) / (1.0 + k1);
    "III" [[D, B, T1]],
        i = -k1,
        eta = eta0;
};

/// I-1…III-3.
#[rustfmt::skip]
pub(super) static THREE_SPEED: [Line; 11] = lines! { (k1, k2, eta0)
    "I-1" [[D, T1, B], [D, T2, T1]],
        i = (k1 + 1.0) * (k2 + 1.0) / (k1 + k2 + 1.0),
        eta = (k1 * eta0 + 1.0) * (k2 * eta0 + 1.0) * (k1 + k2 + 1.0)
            / ((k1 + 1.0) * (k2 + 1.0) * (k1 * eta0 + k2 * eta0 + 1.0));
    "I-2" [[D, T1, B], [T2, D, T1]],
        i = (k1 + 1.0) * (k2 + 1.0) / (k2 * (k1 + 1.0) + 1.0),
        eta = (k1 * eta0 + 1.0) * (k2 + eta0) * (k2 * (k1 + 1.0) + 1.0)
            / ((k1 + 1.0) * (k2 + 1.0) * (k2 * (k1 * eta0 + 1.0) + eta0));
    "I-3" [[D, T1, B], [B, T1, T2]],
        i = (k2 * (k1 + 1.0) + k1) / k2,
        eta = (k2 * (k1 * eta0 + 1.0) + k1 * eta0 * eta0) / (k2 * (k1 + 1.0) + k1);
    "I-4" [[D, T1, B], [T1, B, T2]],
        i = k1 * (k2 + 1.0) + 1.0,
        eta = (k1 * (k2 * eta0 + 1.0) * eta0 + 1.0) / (k1 * (k2 + 1.0) + 1.0);
    "II-1" [[T1, D, B], [D, T2, T1]],
        i = (k1 + 1.0) * (k2 + 1.0) / (k1 * (k2 + 1.0) + 1.0),
        eta = (k1 + eta0) * (k2 * eta0 + 1.0) * (k1 * (k2 + 1.0) + 1.0)
            / ((k1 + 1.0) * (k2 + 1.0) * (k1 * (k2 * eta0 + 1.0) + eta0));
    "II-2" [[T1, D, B], [T2, D, T1]],
        i = (k1 + 1.0) * (k2 + 1.0) / ((k1 + 1.0) * (k2 + 1.0) - 1.0),
        eta = (k1 + eta0) * (k2 + eta0) * (k1 * (k2 + 1.0) + k2)
            / ((k1 + 1.0) * (k2 + 1.0) * (k1 * (k2 + eta0) + k2 * eta0));
    "II-3" [[T1, D, B], [T1, B, T2]],
        i = (k1 + k2 + 1.0) / k1,
        eta = (k1 + (k2 * eta0 + 1.0) * eta0) / (k1 + k2 + 1.0);
    "II-4" [[T1, D, B], [B, T1, T2]],
        i = (k2 * (k1 + 1.0) + 1.0) / (k1 * k2),
        eta = (k2 * (k1 + eta0) + eta0 * eta0) / (k2 * (k1 + 1.0) + 1.0);
    "III-1" [[D, B, T1], [D, T1, T2]],
        i = -k1 * k2 / (k1 + k2 + 1.0),
        eta = eta0 * eta0 * (k1 + k2 + 1.0) / ((k1 + k2) * eta0 + 1.0);
    "III-2" [[D, B, T1], [T1, B, T2]],
        i = -(k1 * (k2 + 1.0) + k2),
        eta = (k1 * (k2 * eta0 + 1.0) + k2) * eta0 / (k1 * (k2 + 1.0) + k2);
    "III-3" [[D, B, T1], [B, T1, T2]],
        i = -(k1 * (k2 + 1.0) + 1.0) / k2,
        eta = (k1 * (k2 + eta0) + 1.0) * eta0 / (k1 * (k2 + 1.0) + 1.0);
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_what_is_computed() {
        assert_eq!(THREE_SPEED[0].ratio.text(), "(k1+1)*(k2+1)/(k1+k2+1)");
        assert_eq!(THREE_SPEED[10].efficiency.text(), "(k1*(k2+eta0)+1)*eta0/(k1*(k2+1)+1)");
        assert_eq!(TWO_SPEED[2].ratio.text(), "-k1");
        assert_eq!(THREE_SPEED[6].ratio.value(2.15, 2.354, 1.0), (2.15 + 2.354 + 1.0) / 2.15);
    }

    #[test]
    fn names_and_structures_are_different() {
        let all: Vec<&Line> = TWO_SPEED.iter().chain(&THREE_SPEED).collect();
        for (place, line) in all.iter().enumerate() {
            assert!(all[..place].iter().all(|other| other.name != line.name && other.sets != line.sets));
        }
        // Set 1 of a three-speed scheme is a two-speed scheme, and the name says which.
        for line in &THREE_SPEED {
            let first = TWO_SPEED.iter().find(|first| first.sets[0] == line.sets[0]).unwrap();
            assert_eq!(line.name.split('-').next(), Some(first.name));
        }
    }
}
