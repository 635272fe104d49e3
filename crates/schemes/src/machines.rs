//! Mining machines of tables 1.1 and 1.2, and how many speeds table 2.1 recommends for a range.
//!
//! | `d` | speeds, table 2.1 | chosen for the ends |
//! |---|---|---|
//! | 1 < d < 1.2 | 1 | |
//! | 1.2 < d < 1.5 | 2 | d = 1.2 → 2 |
//! | 1.5 < d < 2.5 | 3 | d = 1.5 → 3 |
//! | 2.5 < d < 4.0 | 4 | d = 2.5 → 4, d = 4 → 4 |
//! | above 4 | not assigned | 4 |
//!
//! The print has strict inequalities, so it does not assign the ends, nor d > 4. Here an end belongs to the
//! larger number, which loads the motor better at the cost of a gear. Beyond 4 the number stays 4, since the
//! source finds more than four speeds of no use. [`Recommendation::printed`] distinguishes these from what is
//! printed.
//!
//! Table 2.1 is made for bucket wheels. The source does not compare it with its own tables;
//! [`Machine::is_as_recommended`] does.
//!
//! # Source
//! multispeed-gearboxes, tables 1.1, 1.2, 2.1.

use crate::Error;
use crate::quantity::SeriesParameter;
use epicyclic_train::names::nearest;
use std::fmt;
use std::sync::LazyLock;

static MACHINES: LazyLock<Vec<Machine>> = LazyLock::new(|| {
    include_str!("../data/mining_machines.csv")
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .skip(1)
        .map(|line| Machine::from_row(line).expect("the embedded table is checked by the tests of this file"))
        .collect()
});

/// The table that lists a machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Table {
    /// Table 1.1.
    BucketWheels,
    /// Table 1.2.
    Conveyors,
}

impl Table {
    /// Number of the table.
    #[must_use]
    pub const fn number(self) -> &'static str {
        match self {
            Self::BucketWheels => "1.1",
            Self::Conveyors => "1.2",
        }
    }

    /// The table of this number.
    #[must_use]
    pub fn numbered(number: &str) -> Option<Self> {
        [Self::BucketWheels, Self::Conveyors].into_iter().find(|table| table.number() == number)
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "table {}", self.number())
    }
}

/// A machine of the tables.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Machine {
    /// The table that lists it.
    pub table: Table,
    /// Kind of the driven machine.
    pub kind: &'static str,
    /// Name as printed.
    pub name: &'static str,
    /// Number of speeds; `None` where its control is stepless.
    pub steps: Option<u32>,
    /// Range of speeds `d`, the fastest over the slowest.
    pub speed_range: f64,
}

impl Machine {
    fn from_row(row: &'static str) -> Option<Self> {
        let (table, rest) = row.split_once(',')?;
        let (kind, rest) = rest.split_once(',')?;
        let (name, rest) = match rest.strip_prefix('"') {
            Some(quoted) => quoted.split_once("\",")?,
            None => rest.split_once(',')?,
        };
        let (steps, range) = rest.split_once(',')?;
        let steps = if steps.is_empty() { None } else { Some(steps.parse().ok()?) };
        Some(Self { table: Table::numbered(table)?, kind, name, steps, speed_range: range.parse().ok()? })
    }

    /// Number of speeds that table 2.1 recommends for its range; `None` for conveyors, for which the table is
    /// not made.
    #[must_use]
    pub fn recommended(&self) -> Option<Recommendation> {
        (self.table == Table::BucketWheels).then(|| recommended_speeds(self.speed_range).ok()).flatten()
    }

    /// Whether the machine has as many speeds as recommended; `None` for a stepless control, and for
    /// conveyors.
    #[must_use]
    pub fn is_as_recommended(&self) -> Option<bool> {
        Some(self.steps? == self.recommended()?.speeds)
    }
}

/// Every machine, in the order of the tables.
#[must_use]
pub fn machines() -> &'static [Machine] {
    &MACHINES
}

/// The machine of this name.
///
/// ```
/// let wheel = epicyclic_schemes::machines::machine("РЕ-1")?;
/// assert_eq!((wheel.steps, wheel.recommended().map(|found| found.speeds)), (Some(2), Some(3)));
/// # Ok::<(), epicyclic_schemes::Error>(())
/// ```
///
/// # Errors
/// [`Error::UnknownMachine`] with the nearest name.
pub fn machine(name: &str) -> Result<&'static Machine, Error> {
    MACHINES.iter().find(|machine| machine.name == name).ok_or_else(|| Error::UnknownMachine {
        name: name.into(),
        nearest: nearest(name, MACHINES.iter().map(|machine| machine.name)),
    })
}

/// A number of speeds from table 2.1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recommendation {
    /// Number of speeds.
    pub speeds: u32,
    /// Whether the print says so; at the ends of its intervals and above 4 it is our choice.
    pub printed: bool,
}

/// Number of speeds that table 2.1 recommends for a range of speeds.
///
/// # Errors
/// [`Error::SpeedRange`] for `d ≤ 1`.
pub fn recommended_speeds(speed_range: f64) -> Result<Recommendation, Error> {
    if !(speed_range > 1.0 && speed_range.is_finite()) {
        return Err(Error::SpeedRange { what: SeriesParameter::SpeedRange, value: speed_range });
    }
    let ends = [1.2, 1.5, 2.5];
    let speeds = 1 + ends.iter().filter(|end| speed_range >= **end).count() as u32;
    Ok(Recommendation { speeds, printed: speed_range < 4.0 && !ends.contains(&speed_range) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_have_seventeen_machines_each() {
        let count = |table| machines().iter().filter(|machine| machine.table == table).count();
        assert_eq!((count(Table::BucketWheels), count(Table::Conveyors)), (17, 17));
        assert!(machines().iter().all(|machine| machine.speed_range > 1.0));
        assert_eq!(machine("ПТД-800, ПТД-100").unwrap().steps, Some(3));
        assert_eq!(machine("SchRS 25/0.35 6").unwrap().steps, None);
    }

    #[test]
    fn an_unknown_machine_is_answered_with_the_nearest() {
        let refused = machine("СП-62").unwrap_err();
        assert_eq!(refused, Error::UnknownMachine { name: "СП-62".into(), nearest: Some("СП-63".into()) });
    }

    #[test]
    fn ends_of_the_intervals_go_to_the_larger_number() {
        let of = |d| recommended_speeds(d).map(|r| (r.speeds, r.printed));
        for (d, speeds, printed) in [
            (1.1, 1, true),
            (1.2, 2, false),
            (1.3, 2, true),
            (1.5, 3, false),
            (2.49, 3, true),
            (2.5, 4, false),
            (3.9, 4, true),
            (4.0, 4, false),
            (6.03, 4, false),
        ] {
            assert_eq!(of(d), Ok((speeds, printed)), "{d}");
        }
        assert!(of(1.0).is_err() && of(f64::NAN).is_err());
    }
}
