//! The bearings that planets may turn on: two small tables, tables of one's own, and plain bearings.
//!
//! A table is a text of lines `designation,rolling,d_mm,D_mm,B_mm,C_kN,C0_kN` below a header that names these
//! columns, in any order; `C0_kN` may be missing or empty. Lines that begin with `#` are remarks. Cells are
//! parted by commas and have no quotes.
//!
//! # Source
//! The tables are of a maker's catalogues, named in their headers: deep groove ball bearings, and single-row
//! cylindrical roller bearings, whose rows another maker's catalogue confirms. Full complement and needle
//! roller bearings are in neither: of those two catalogues that could be read differ by a quarter, or none
//! could be read.

use crate::Error;
use crate::plain_bearing::{GREATEST_PRESSURE, USUAL_PRESSURE};
use epicyclic_gears::life::Rolling;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use std::borrow::Cow;
use std::sync::LazyLock;
use uom::si::f64::{Force, Length, Pressure};

/// A bearing of a planet.
#[derive(Debug, Clone, PartialEq)]
pub struct Bearing {
    /// Designation, `6309`.
    pub designation: String,
    /// Rolling elements.
    pub rolling: Rolling,
    /// Bore `d`: diameter of the pin.
    pub bore: Length,
    /// Outside diameter `D`: bore of the planet.
    pub outside_diameter: Length,
    /// Width `B`; 0 of a plain bearing that is no [part of a planet](Self::in_planet) yet.
    pub width: Length,
    /// Rows of rolling elements; 0 where load ratings alone are known, which may be those of any. A plain bearing has
    /// two halves.
    pub rows: u32,
    /// Basic dynamic load rating `C`; of a plain bearing the load that it may bear.
    pub load_rating: Force,
    /// Basic static load rating `C_0`, if known.
    pub static_load_rating: Option<Force>,
}

/// Exponent of the number of rows in the load rating of ball bearings, `(i·cos α)^0.7`.
const ROWS_OF_BALLS: f64 = 0.7;
/// Exponent of the number of rows in the load rating of roller bearings.
const ROWS_OF_ROLLERS: f64 = 7.0 / 9.0;

impl Bearing {
    /// Mean of bore and outside diameter; `None` of a bearing whose bore is not known.
    #[must_use]
    pub fn mean_diameter(&self) -> Option<Length> {
        (self.bore.si() > 0.0).then(|| (self.bore + self.outside_diameter) / 2.0)
    }

    /// Pair of this bearing side by side as a unit, rated by ISO 281 as one double-row bearing: `2^0.7·C`
    /// with balls, `2^(7/9)·C` with rollers, `2·C_0`, `2·B`.
    ///
    /// ```
    /// use epicyclic_strength::sizing::bearing;
    /// use uom::si::force::kilonewton;
    ///
    /// let one = bearing::listed().iter().find(|bearing| bearing.designation == "6309").unwrap();
    /// let pair = one.pair();
    /// assert_eq!(pair.designation, "2 x 6309");
    /// assert!((pair.load_rating.get::<kilonewton>() - 1.6245 * 54.2).abs() < 0.01);
    /// ```
    #[must_use]
    pub fn pair(&self) -> Self {
        let exponent = match self.rolling {
            Rolling::Balls => ROWS_OF_BALLS,
            _ => ROWS_OF_ROLLERS,
        };
        Self {
            designation: format!("2 x {}", self.designation),
            width: 2.0 * self.width,
            rows: 2 * self.rows,
            load_rating: self.load_rating * libm::pow(2_f64, exponent),
            static_load_rating: self.static_load_rating.map(|rating| 2.0 * rating),
            ..self.clone()
        }
    }

    /// The bearing in a planet of this width: a [listed](listed_plain) plain one is as wide and may bear the usual
    /// [pressure](USUAL_PRESSURE), for a short time the [greatest](GREATEST_PRESSURE); others stay as they are.
    ///
    /// ```
    /// use epicyclic_strength::sizing::bearing;
    /// use epicyclic_units::Physical;
    /// use uom::si::f64::Length;
    ///
    /// let plain = bearing::listed_plain().iter().find(|bearing| bearing.designation == "plain 100").unwrap();
    /// let width = Length::from_mm(90.0);
    /// // 7 N/mm² on 100 mm x 90 mm.
    /// assert!((plain.in_planet(width).load_rating.si() - 63e3).abs() < 1e-6);
    /// ```
    #[must_use]
    pub fn in_planet(&self, width: Length) -> Cow<'_, Self> {
        if self.rolling != Rolling::Plain || self.load_rating.si() > 0.0 {
            return Cow::Borrowed(self);
        }
        let bears = |pressure| Pressure::from_si(pressure) * self.outside_diameter * width;
        let static_load_rating = Some(bears(GREATEST_PRESSURE));
        Cow::Owned(Self { width, load_rating: bears(USUAL_PRESSURE), static_load_rating, ..self.clone() })
    }

    /// Whether planets that a moment tilts may turn on it. The rollers of one row would bear at one end, and
    /// one ball bearing has no stated rating against a moment: such planets turn on a pair.
    #[must_use]
    pub const fn holds_moment(&self) -> bool {
        self.rows != 1
    }

    /// Distance of the middles of both rows in a planet of this width: a spacer keeps them at its ends, which
    /// is the longest lever that both rows have there. `None` unless there are two.
    ///
    /// ```
    /// use epicyclic_strength::sizing::bearing;
    /// use epicyclic_units::Physical;
    /// use uom::si::f64::Length;
    ///
    /// let pair = bearing::listed().iter().find(|bearing| bearing.designation == "6309").unwrap().pair();
    /// // Two bearings of 25 mm: side by side, and at the ends of a wider planet.
    /// let span = |width: f64| pair.span(Length::from_mm(width)).unwrap().mm();
    /// assert!((span(50.0) - 25.0).abs() < 1e-9 && (span(80.0) - 55.0).abs() < 1e-9);
    /// ```
    #[must_use]
    pub fn span(&self, planet_width: Length) -> Option<Length> {
        (self.rows == 2).then(|| planet_width - self.width / 2.0)
    }
}

static TABLE: LazyLock<Vec<Bearing>> = LazyLock::new(|| {
    parse(include_str!("../../data/planet_bearings.csv"))
        .expect("the embedded table is checked by the tests of this file")
});

/// The bearings of the table, by bore and outside diameter.
///
/// ```
/// use epicyclic_strength::sizing::bearing;
/// use uom::si::force::kilonewton;
///
/// let bearing = bearing::listed().iter().find(|bearing| bearing.designation == "6309").unwrap();
/// assert!((bearing.load_rating.get::<kilonewton>() - 54.2).abs() < 1e-9);
/// ```
#[must_use]
pub fn listed() -> &'static [Bearing] {
    &TABLE
}

static ROLLERS: LazyLock<Vec<Bearing>> = LazyLock::new(|| {
    parse(include_str!("../../data/planet_roller_bearings.csv"))
        .expect("the embedded table is checked by the tests of this file")
});

/// The cylindrical roller bearings of the table, by bore, outside diameter and width.
///
/// ```
/// use epicyclic_gears::life::Rolling;
/// use epicyclic_strength::sizing::bearing;
/// use uom::si::force::kilonewton;
///
/// let bearing = bearing::listed_rollers().iter().find(|bearing| bearing.designation == "NJ 2309").unwrap();
/// assert!((bearing.load_rating.get::<kilonewton>() - 138.0).abs() < 1e-9);
/// assert_eq!(bearing.rolling, Rolling::Rollers);
/// ```
#[must_use]
pub fn listed_rollers() -> &'static [Bearing] {
    &ROLLERS
}

/// Digits of a diameter in a designation.
const DIGITS: usize = 6;

static PLAIN: LazyLock<Vec<Bearing>> = LazyLock::new(|| {
    let fine = (15..100).step_by(5).chain((100..300).step_by(10));
    fine.chain((300..=1000).step_by(20)).map(|mm: u32| plain(Length::from_mm(f64::from(mm)))).collect()
});

/// A plain bearing in a bore of this diameter.
#[must_use]
pub fn plain(bore: Length) -> Bearing {
    Bearing {
        designation: format!("plain {}", trimmed(bore.mm(), DIGITS)),
        rolling: Rolling::Plain,
        bore,
        outside_diameter: bore,
        width: Length::default(),
        rows: 2,
        load_rating: Force::default(),
        static_load_rating: None,
    }
}

/// Plain bearings by diameter, which is that of the pin and of the planet's bore: the bush is part of the pin or
/// of the planet.
#[must_use]
pub fn listed_plain() -> &'static [Bearing] {
    &PLAIN
}

/// Columns of a table; the last may be missing.
const COLUMNS: [&str; 7] = ["designation", "rolling", "d_mm", "D_mm", "B_mm", "C_kN", "C0_kN"];

/// Bearings of a table in the form of the [module](self).
///
/// # Errors
/// [`Error::BearingColumn`] for a column that is missing, unknown or named twice; [`Error::BearingCell`],
/// with line and column, for a cell that is missing or wrong; [`Error::NoBearings`] for a table without
/// lines.
pub fn parse(text: &str) -> Result<Vec<Bearing>, Error> {
    let mut lines = text
        .trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(place, line)| (place + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let (line, header) = lines.next().ok_or(Error::NoBearings)?;
    let places = columns(line, header)?;
    let bearings: Vec<Bearing> =
        lines.map(|(line, row)| bearing(line, row, places)).collect::<Result<_, _>>()?;
    if bearings.is_empty() { Err(Error::NoBearings) } else { Ok(bearings) }
}

/// Position of each known column in the header.
fn columns(line: usize, header: &str) -> Result<[Option<usize>; COLUMNS.len()], Error> {
    let mut places = [None; COLUMNS.len()];
    for (place, name) in header.split(',').map(str::trim).enumerate() {
        let wrong = || Error::BearingColumn { line, column: name.to_owned(), allowed: COLUMNS.join(", ") };
        let column = COLUMNS.iter().position(|column| *column == name).ok_or_else(wrong)?;
        if places[column].replace(place).is_some() {
            return Err(wrong());
        }
    }
    let missing = COLUMNS[..COLUMNS.len() - 1].iter().zip(places).find(|(_, place)| place.is_none());
    match missing {
        Some((column, _)) => {
            Err(Error::BearingColumn { line, column: (*column).to_owned(), allowed: COLUMNS.join(", ") })
        }
        None => Ok(places),
    }
}

fn bearing(line: usize, row: &str, places: [Option<usize>; COLUMNS.len()]) -> Result<Bearing, Error> {
    let cells: Vec<&str> = row.split(',').map(str::trim).collect();
    let cell = |column: usize| places[column].and_then(|place| cells.get(place)).copied().unwrap_or("");
    let wrong = |column: usize, allowed| Error::BearingCell {
        line,
        column: COLUMNS[column],
        value: cell(column).to_owned(),
        allowed,
    };
    let number = |column: usize| {
        let value = cell(column).parse::<f64>().ok().filter(|value| value.is_finite() && *value > 0.0);
        value.ok_or_else(|| wrong(column, "a number above 0"))
    };
    if cell(0).is_empty() {
        return Err(wrong(0, "a designation"));
    }
    let rolling = Rolling::ALL.into_iter().find(|rolling| rolling.name() == cell(1));
    let rolling = rolling.ok_or_else(|| wrong(1, "balls, rollers, needles or full_complement"))?;
    let bore = number(2)?;
    let outside = number(3)?;
    if outside <= bore {
        return Err(wrong(3, "a number above that of d_mm"));
    }
    let kilonewtons = |value: f64| Force::from_si(value * 1e3);
    Ok(Bearing {
        designation: cell(0).to_owned(),
        rolling,
        bore: Length::from_mm(bore),
        outside_diameter: Length::from_mm(outside),
        width: Length::from_mm(number(4)?),
        rows: 1,
        load_rating: kilonewtons(number(5)?),
        static_load_rating: if cell(6).is_empty() { None } else { Some(kilonewtons(number(6)?)) },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_whole_and_in_order() {
        let all = listed();
        assert_eq!(all.len(), 63);
        let key = |bearing: &Bearing| (bearing.bore.mm(), bearing.outside_diameter.mm());
        assert!(all.windows(2).all(|two| key(&two[0]) < key(&two[1])));
        // Series 62 and 63 have the envelope of the other table of the workspace.
        for bearing in all.iter().filter(|bearing| bearing.bore.mm() >= 20.0) {
            if let Ok(other) = epicyclic_gears::bearing::by_designation(&bearing.designation) {
                assert_eq!(
                    other.outside_diameter.mm(),
                    bearing.outside_diameter.mm(),
                    "{}",
                    bearing.designation
                );
                assert_eq!(other.width.mm(), bearing.width.mm(), "{}", bearing.designation);
            }
        }
    }

    /// Compares each row with the bearing of another maker: equal dimensions, and ratings that differ as
    /// makers' do.
    #[test]
    fn each_roller_bearing_was_read_twice() {
        let kilonewtons = |rating: Force| rating.si() / 1e3;
        let again = include_str!("../../data/planet_roller_bearings_again.csv");
        let again: Vec<Vec<&str>> = again
            .lines()
            .filter(|line| !line.starts_with('#'))
            .map(|line| line.split(',').collect())
            .collect();
        assert_eq!((again.len(), listed_rollers().len()), (38, 38));
        for (bearing, again) in listed_rollers().iter().zip(&again) {
            let number = |place: usize| again[place].parse::<f64>().unwrap();
            assert_eq!((bearing.designation.as_str(), bearing.rolling), (again[0], Rolling::Rollers));
            let envelope = [bearing.bore, bearing.outside_diameter, bearing.width].map(Physical::mm);
            assert!(
                envelope.iter().zip(1..).all(|(one, place)| (one - number(place)).abs() < 1e-9),
                "{again:?}"
            );
            let ratings = [bearing.load_rating, bearing.static_load_rating.unwrap()].map(kilonewtons);
            assert!(
                ratings.iter().zip(4..).all(|(one, place)| (number(place) / one - 1.0).abs() < 0.13),
                "{again:?}"
            );
            // Series 2 and 3 have the envelope of the ball bearings of the same number.
            if let Some(balls) =
                listed().iter().find(|balls| bearing.designation == format!("NJ {}", &balls.designation[1..]))
            {
                assert_eq!([balls.bore, balls.outside_diameter, balls.width].map(Physical::mm), envelope);
            }
        }
        let key =
            |bearing: &Bearing| [bearing.bore, bearing.outside_diameter, bearing.width].map(Physical::mm);
        assert!(listed_rollers().windows(2).all(|two| key(&two[0]) < key(&two[1])));
    }

    #[test]
    fn columns_may_stand_in_any_order() {
        let table = "# mine\nC_kN,designation,B_mm,rolling,d_mm,D_mm\n12.5,NJ 202, 11,rollers,15,35\n";
        let [bearing] = &parse(table).unwrap()[..] else { panic!() };
        assert_eq!((bearing.designation.as_str(), bearing.rolling), ("NJ 202", Rolling::Rollers));
        assert_eq!(bearing.static_load_rating, None);
        assert!((bearing.outside_diameter.mm() - 35.0).abs() < 1e-9);
    }

    #[test]
    fn faults_name_line_and_column() {
        let of = |text: &str| parse(text).unwrap_err().to_string();
        let head = "designation,rolling,d_mm,D_mm,B_mm,C_kN,C0_kN\n";
        assert_eq!(
            of(&format!("{head}a,balls,10,30,9,x,1\n")),
            "bearings, line 2, column C_kN: `x`; a number above 0 is needed"
        );
        assert_eq!(
            of(&format!("{head}a,balls,30,10,9,5,1\n")),
            "bearings, line 2, column D_mm: `10`; a number above that of d_mm is needed"
        );
        assert!(
            of(&format!("{head}a,cones,10,30,9,5,1\n")).ends_with("needles or full_complement is needed")
        );
        assert!(of(&format!("{head},balls,10,30,9,5,1\n")).contains("column designation"));
        assert!(of("designation,D_mm\n").contains("column rolling"));
        assert!(of("designation,colour\n").contains("column colour"));
        assert_eq!(of(head), "the table of bearings has no lines; at least one bearing is needed");
        assert_eq!(of("# nothing\n"), "the table of bearings has no lines; at least one bearing is needed");
    }
}
