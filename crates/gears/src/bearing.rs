//! Deep-groove ball bearings of the series 200, 300 and 400 with bores of 20 to 100 mm.
//!
//! Outside dimensions only: enough to size a hub, a carrier or a hole, not to choose a bearing by its life.

use std::fmt;
use std::sync::LazyLock;

use epicyclic_units::Physical;
use uom::si::f64::Length;

use crate::checks::{positive_length, shown_mm};
use crate::tolerance::SAME_M;
use crate::{Error, Quantity};

static TABLE: LazyLock<Vec<Bearing>> = LazyLock::new(|| {
    include_str!("../data/deep_groove_ball_bearings.csv")
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .skip(1)
        .map(|line| Bearing::from_row(line).expect("the embedded table is checked by the tests of this file"))
        .collect()
});

/// Diameter series of a bearing: how thick its section is for one bore.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Series {
    /// 200, light (62 of the international numbers).
    Light200,
    /// 300, medium (63).
    Medium300,
    /// 400, heavy (64).
    Heavy400,
}

impl Series {
    /// 200, 300 or 400.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::Light200 => 200,
            Self::Medium300 => 300,
            Self::Heavy400 => 400,
        }
    }
}

impl fmt::Display for Series {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.number().fmt(f)
    }
}

/// Whether a row of the table was found in a catalogue; which one, the table's header says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verification {
    /// Listed in a catalogue of deep-groove ball bearings.
    Confirmed,
    /// Follows from the boundary plan, but no such bearing was found in a catalogue.
    Unverified,
}

/// One bearing of the table.
///
/// # Source
/// Dimensions by ISO 15, diameter series 2, 3 and 4 (GOST 8338); excavator-dynamics, table 1, uses 310, 312,
/// 318.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Bearing {
    /// Designation by GOST, e.g. `310`; the international one has a 6 before it.
    pub designation: &'static str,
    /// Diameter series.
    pub series: Series,
    /// Bore `d`.
    pub bore: Length,
    /// Outside diameter `D`.
    pub outside_diameter: Length,
    /// Width `B`.
    pub width: Length,
    /// Nominal chamfer coordinate `r`.
    pub chamfer: Length,
    /// Whether the row was confirmed.
    pub verification: Verification,
}

/// Designation, bore, outside diameter and width: `310 (50 × 110 × 27 mm)`.
impl fmt::Display for Bearing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [bore, outside, width] = [self.bore, self.outside_diameter, self.width].map(shown_mm);
        write!(f, "{} ({bore} × {outside} × {width} mm)", self.designation)
    }
}

impl Bearing {
    fn from_row(row: &'static str) -> Option<Self> {
        let mut cells = row.split(',');
        let designation = cells.next()?;
        let series = match designation.as_bytes() {
            [b'2', _, _] => Series::Light200,
            [b'3', _, _] => Series::Medium300,
            [b'4', _, _] => Series::Heavy400,
            _ => return None,
        };
        let mut next_mm = || cells.next()?.parse().ok().map(Length::from_mm);
        let (bore, outside_diameter, width, chamfer) = (next_mm()?, next_mm()?, next_mm()?, next_mm()?);
        let verification = match cells.next()? {
            "confirmed" => Verification::Confirmed,
            "unverified" => Verification::Unverified,
            _ => return None,
        };
        let end = cells.next().is_none();
        end.then_some(Self { designation, series, bore, outside_diameter, width, chamfer, verification })
    }
}

/// Every bearing of the table, by series, then by bore.
///
/// ```
/// use epicyclic_gears::bearing;
///
/// assert_eq!(bearing::all().len(), 51);
/// ```
#[must_use]
pub fn all() -> &'static [Bearing] {
    &TABLE
}

/// The bearing of a designation: `310`, or `6310` as international catalogues write it.
///
/// # Errors
/// [`Error::UnknownBearing`], which lists the designations with the bore that the last two figures name.
///
/// # Example
/// ```
/// use epicyclic_gears::{bearing, Error};
/// use uom::si::length::millimeter;
///
/// let bearing = bearing::by_designation("310")?;
/// assert_eq!(bearing.outside_diameter.get::<millimeter>().round(), 110.0);
/// let refused = bearing::by_designation("510").unwrap_err();
/// assert_eq!(refused.to_string(), "no deep-groove ball bearing 510; for that bore there are 210, 310, 410");
/// # Ok::<(), Error>(())
/// ```
pub fn by_designation(designation: &str) -> Result<&'static Bearing, Error> {
    let wanted = designation.trim();
    // International catalogues put a 6 before the GOST designation. Only three more digits make it such a
    // prefix.
    let gost = match wanted.strip_prefix('6') {
        Some(rest) if rest.len() == 3 => rest,
        _ => wanted,
    };
    all().iter().find(|bearing| bearing.designation == gost).ok_or_else(|| {
        let size_code = gost.get(gost.len().saturating_sub(2)..).filter(|code| code.len() == 2);
        let has_code = |bearing: &&Bearing| size_code.is_some_and(|code| bearing.designation.ends_with(code));
        let same_bore = all().iter().filter(has_code).map(|bearing| bearing.designation).collect();
        Error::UnknownBearing { designation: designation.to_owned(), same_bore }
    })
}

/// The bearing of a series with exactly this bore.
///
/// # Errors
/// [`Error::NotPositive`] for the bore; [`Error::NoSuchBore`], which names the neighbouring bores.
///
/// # Example
/// ```
/// use epicyclic_gears::bearing::{self, Series};
/// use uom::si::{f64::Length, length::millimeter};
///
/// let bearing = bearing::by_bore(Series::Medium300, Length::new::<millimeter>(60.0))?;
/// assert_eq!(bearing.designation, "312");
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn by_bore(series: Series, bore: Length) -> Result<&'static Bearing, Error> {
    let bore_m = positive_length(Quantity::Bore, bore)?;
    // Millimetres are not exact in binary, so equal bores may differ by rounding.
    of_series(series).find(|bearing| (bearing.bore.si() - bore_m).abs() < SAME_M).ok_or_else(|| {
        let below = of_series(series).rfind(|bearing| bearing.bore.si() < bore_m);
        let above = of_series(series).find(|bearing| bearing.bore.si() > bore_m);
        let neighbours_mm = below.into_iter().chain(above).map(|bearing| bearing.bore.mm()).collect();
        Error::NoSuchBore { series: series.number(), bore_mm: bore.mm(), neighbours_mm }
    })
}

/// The smallest bearing of a series whose bore is at least the shaft diameter.
///
/// # Errors
/// [`Error::NotPositive`] for the diameter, [`Error::NoBearingForShaft`] above the largest bore.
///
/// # Example
/// ```
/// use epicyclic_gears::bearing::{self, Series};
/// use uom::si::{f64::Length, length::millimeter};
///
/// let bearing = bearing::smallest_for_shaft(Series::Medium300, Length::new::<millimeter>(51.0))?;
/// assert_eq!(bearing.designation, "311");
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn smallest_for_shaft(series: Series, shaft_diameter: Length) -> Result<&'static Bearing, Error> {
    let shaft_m = positive_length(Quantity::ShaftDiameter, shaft_diameter)?;
    of_series(series).find(|bearing| bearing.bore.si() > shaft_m - SAME_M).ok_or_else(|| {
        Error::NoBearingForShaft {
            series: series.number(),
            shaft_mm: shaft_diameter.mm(),
            largest_mm: of_series(series).map(|bearing| bearing.bore.mm()).fold(0.0, f64::max),
        }
    })
}

fn of_series(series: Series) -> impl DoubleEndedIterator<Item = &'static Bearing> {
    all().iter().filter(move |bearing| bearing.series == series)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bearing_shows_its_dimensions() {
        assert_eq!(by_designation("310").unwrap().to_string(), "310 (50 × 110 × 27 mm)");
    }

    const SERIES: [Series; 3] = [Series::Light200, Series::Medium300, Series::Heavy400];

    #[test]
    fn every_row_parses_and_grows_with_the_bore() {
        for series in SERIES {
            let rows: Vec<_> = of_series(series).collect();
            assert_eq!(rows.len(), 17, "series {series}: bores 20 to 100 mm in steps of 5");
            for bearing in &rows {
                let size_code: f64 = bearing.designation[1..].parse().unwrap();
                assert!((bearing.bore.mm() - 5.0 * size_code).abs() < 1e-6, "{bearing:?}");
                let section = bearing.outside_diameter.si() - bearing.bore.si();
                assert!(section > 0.0 && bearing.width.si() < section, "{bearing:?}");
                assert!(bearing.chamfer.si() > 0.0 && 2.0 * bearing.chamfer.si() < bearing.width.si());
            }
            for pair in rows.windows(2) {
                assert!(pair[0].bore < pair[1].bore && pair[0].outside_diameter < pair[1].outside_diameter);
                assert!(pair[0].width < pair[1].width && pair[0].chamfer <= pair[1].chamfer);
            }
        }
    }

    #[test]
    fn a_heavier_series_is_larger_at_the_same_bore() {
        for bearing in of_series(Series::Light200) {
            let medium = by_bore(Series::Medium300, bearing.bore).unwrap();
            let heavy = by_bore(Series::Heavy400, bearing.bore).unwrap();
            assert!(bearing.outside_diameter < medium.outside_diameter);
            assert!(medium.outside_diameter < heavy.outside_diameter);
            assert!(bearing.width < medium.width && medium.width < heavy.width);
        }
    }

    #[test]
    fn table_of_the_excavator_drive() {
        for (designation, size_mm) in
            [("310", [50.0, 110.0, 27.0]), ("312", [60.0, 130.0, 31.0]), ("318", [90.0, 190.0, 43.0])]
        {
            let bearing = by_designation(designation).unwrap();
            let found = [bearing.bore, bearing.outside_diameter, bearing.width].map(Physical::mm);
            assert!(
                found.iter().zip(size_mm).all(|(found, wanted)| (found - wanted).abs() < 1e-6),
                "{bearing:?}"
            );
            assert_eq!(bearing.verification, Verification::Confirmed);
            assert_eq!(by_designation(&format!("6{designation}")).unwrap(), bearing);
        }
    }

    #[test]
    fn only_the_two_largest_heavy_ones_are_unverified() {
        let unverified = all().iter().filter(|bearing| bearing.verification == Verification::Unverified);
        assert_eq!(unverified.map(|bearing| bearing.designation).collect::<Vec<_>>(), ["419", "420"]);
    }

    #[test]
    fn unknown_designations_name_what_there_is() {
        let offered = |designation| match by_designation(designation) {
            Err(Error::UnknownBearing { same_bore, .. }) => same_bore,
            other => panic!("{other:?}"),
        };
        assert_eq!(offered("510"), ["210", "310", "410"]);
        assert_eq!(offered("6010"), ["210", "310", "410"]);
        for nonsense in ["", "3", "325", "ball", "подшипник", "36310"] {
            let offer = offered(nonsense);
            assert!(offer.is_empty() || nonsense.ends_with("10"), "{nonsense}: {offer:?}");
        }
    }

    #[test]
    fn missing_bores_name_their_neighbours() {
        let at = |bore_mm| by_bore(Series::Heavy400, Length::from_mm(bore_mm));
        let neighbours = |bore_mm| match at(bore_mm) {
            Err(Error::NoSuchBore { series: 400, neighbours_mm, .. }) => {
                neighbours_mm.iter().map(|mm| mm.round()).collect::<Vec<_>>()
            }
            other => panic!("{other:?}"),
        };
        assert_eq!(neighbours(51.0), [50.0, 55.0]);
        assert_eq!(neighbours(17.0), [20.0]);
        assert_eq!(neighbours(110.0), [100.0]);
        assert!(matches!(at(f64::NAN), Err(Error::NotPositive { quantity: Quantity::Bore, .. })));
    }

    #[test]
    fn the_smallest_bore_that_takes_the_shaft_is_chosen() {
        for series in SERIES {
            for bearing in of_series(series) {
                assert_eq!(smallest_for_shaft(series, bearing.bore).unwrap(), bearing);
                let thicker = bearing.bore + Length::from_mm(0.1);
                match smallest_for_shaft(series, thicker) {
                    Ok(next) => assert!(next.bore > thicker),
                    Err(error) => assert!(matches!(error, Error::NoBearingForShaft { .. })),
                }
            }
        }
        let refused = smallest_for_shaft(Series::Medium300, Length::from_mm(-5.0));
        assert!(matches!(refused, Err(Error::NotPositive { quantity: Quantity::ShaftDiameter, .. })));
        let refused = smallest_for_shaft(Series::Medium300, Length::from_mm(101.0));
        assert!(matches!(refused, Err(Error::NoBearingForShaft { series: 300, .. })));
    }
}
