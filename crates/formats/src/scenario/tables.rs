//! Tables of two columns: lists in the file, or a CSV file beside it.
//!
//! A CSV file has the units of its columns in the first line and numbers below:
//!
//! ```text
//! rpm,N·m
//! 0,120
//! 1500,95
//! ```

use crate::document::{Path, Position};
use crate::{Error, Place, Problem};
use epicyclic_units::{Physical, Quantity};
use std::collections::BTreeMap;

/// Texts of the CSV files by the names under which the scenario knows them, each with the name for messages.
pub type Texts = BTreeMap<String, (String, String)>;

/// Points of a table.
pub type Points<X, Y> = Vec<(X, Y)>;

/// A table that is none.
#[derive(Debug, Clone, PartialEq)]
pub enum TableFault {
    /// An entry that is not a table; the message says why.
    Entry(String),
    /// A fault in its CSV file.
    Csv(Error),
}

/// A column with its key.
pub(super) struct Column;

impl Column {
    /// The points of two lists of one length, or of a CSV file in their place.
    pub(super) fn pair<X: Physical, Y: Physical>(
        (across, xs): (&str, &[Quantity<X>]),
        (up, ys): (&str, &[Quantity<Y>]),
        csv: Option<&str>,
        texts: &Texts,
    ) -> Result<Points<X, Y>, TableFault> {
        let fault = |message: String| Err(TableFault::Entry(message));
        let Some(file) = csv else {
            if xs.is_empty() && ys.is_empty() {
                return fault(format!("a table is due: {across} and {up}, or csv"));
            }
            let points = pairs((across, xs), (up, ys)).map_err(TableFault::Entry)?;
            return Ok(points.into_iter().map(|(x, y)| (x.0, y.0)).collect());
        };
        if !xs.is_empty() || !ys.is_empty() {
            return fault(format!("give either {across} and {up}, or csv"));
        }
        let Some((name, text)) = texts.get(file) else {
            return fault(format!("the file {file} is not read"));
        };
        read_csv(name, text).map_err(TableFault::Csv)
    }
}

/// The points of two lists with the names of their keys.
///
/// # Errors
/// Why they are none: lists of different lengths.
pub fn pairs<X: Copy, Y: Copy>(
    (across, xs): (&str, &[X]),
    (up, ys): (&str, &[Y]),
) -> Result<Points<X, Y>, String> {
    if xs.len() != ys.len() {
        return Err(format!("{} {across} and {} {up}: each has one of the other", xs.len(), ys.len()));
    }
    Ok(xs.iter().copied().zip(ys.iter().copied()).collect())
}

/// The points in a CSV file: two columns, their units in the first line.
///
/// ```
/// use epicyclic_formats::scenario::read_csv;
/// use uom::si::{f64::{AngularVelocity, Torque}, torque::newton_meter};
///
/// let points = read_csv::<AngularVelocity, Torque>("motor.csv", "rpm,N·m\n0,120\n1500,95\n")?;
/// assert_eq!(points[1].1.get::<newton_meter>(), 95.0);
/// let error = read_csv::<AngularVelocity, Torque>("motor.csv", "rpm,kW\n0,120\n").unwrap_err();
/// assert_eq!(error.to_string(), "motor.csv:2:3: 120 kW: kW is a unit of power, and a torque is due; its units are N·m, mN·m, N·mm, N·cm, kN·m, MN·m, kgf·m, lbf·ft, lbf·in");
/// # Ok::<(), epicyclic_formats::Error>(())
/// ```
///
/// # Errors
/// The first thing wrong, with its line and column.
pub fn read_csv<X: Physical, Y: Physical>(file: &str, text: &str) -> Result<Points<X, Y>, Error> {
    let at = |line: usize, column: usize, problem: Problem| {
        let place = Place { file: file.into(), position: Position { line, column }, path: Path::root() };
        Error::new(place, problem)
    };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let two = |line: usize, row: &str| match row.split(',').collect::<Vec<_>>()[..] {
        [x, y] => Ok([(1, x.trim().to_owned()), (x.chars().count() + 2, y.trim().to_owned())]),
        ref cells => {
            let expected = "2, with a comma between them,".to_owned();
            Err(at(line, 1, Problem::WrongLength { found: cells.len(), expected }))
        }
    };
    let Some((first, header)) = lines.next() else { return Err(at(1, 1, Problem::EmptyFile)) };
    let [(_, x_unit), (_, y_unit)] = two(first, header)?;
    let (mut points, mut above) = (vec![], String::new());
    for (line, row) in lines {
        let [(x_at, written), (y_at, y)] = two(line, row)?;
        let x: Quantity<X> = format!("{written} {x_unit}")
            .parse()
            .map_err(|error| at(line, x_at, Problem::Quantity(error)))?;
        let y: Quantity<Y> =
            format!("{y} {y_unit}").parse().map_err(|error| at(line, y_at, Problem::Quantity(error)))?;
        if points.last().is_some_and(|(before, _): &(X, Y)| x.0.si() < before.si()) {
            let message = format!(
                "{written} {x_unit}, and the line before has {above} {x_unit}: the first column ascends"
            );
            return Err(at(line, x_at, Problem::refused("order", message)));
        }
        above = written;
        points.push((x.0, y.0));
    }
    if points.is_empty() {
        let message = "a table is due: the units of its columns, then lines of numbers";
        return Err(at(first, 1, Problem::refused("empty-table", message)));
    }
    Ok(points)
}
