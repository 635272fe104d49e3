//! Lists of ratios as people write them: `4.714, 3.143`, `4.714,3.143`, `4.714 3.143`, `4,714; 3,143`.
//!
//! Spaces, semicolons and commas part the ratios. A comma between two digits, *inner* below, can be that of a
//! decimal fraction:
//!
//! | the list has | an inner comma |
//! |---|---|
//! | a point, and a number with one beside the comma | parts ratios |
//! | a point, and inner commas alone for separators | parts ratios |
//! | no point, spaces or semicolons for separators, at most one inner comma a number | parts decimals |
//! | anything else | may be either and is refused |

use epicyclic_formats::WantedRatio;
use epicyclic_units::Number;
use std::str::FromStr;

/// A list of ratios.
#[derive(Debug, Clone, PartialEq)]
pub struct Ratios(pub Vec<WantedRatio>);

impl FromStr for Ratios {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let read = |piece: &String| piece.parse().map_err(|error| format!("{error}"));
        pieces(text)?.iter().map(read).collect::<Result<_, _>>().map(Self)
    }
}

/// A list of ratios that are mere numbers, separated in the same way.
#[derive(Debug, Clone, PartialEq)]
pub struct PlainRatios(pub Vec<Number>);

impl FromStr for PlainRatios {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let read = |piece: &String| piece.parse::<Number>().map_err(|error| format!("{error}"));
        pieces(text)?.iter().map(read).collect::<Result<_, _>>().map(Self)
    }
}

/// The ratios of a list, each as it is written but with a point for its decimals.
///
/// # Errors
/// Two separators with nothing between them; commas that may part decimals or ratios.
pub(crate) fn pieces(text: &str) -> Result<Vec<String>, String> {
    let text = joined(text);
    let marks: Vec<char> = text.chars().collect();
    let inner: Vec<usize> = (1..marks.len().saturating_sub(1))
        .filter(|at| marks[*at] == ',' && marks[*at - 1].is_ascii_digit() && marks[*at + 1].is_ascii_digit())
        .collect();
    let parts_decimals = meaning(&marks, &inner)?;
    let mut pieces = vec![String::new()];
    // Whether a comma or semicolon stands since the last ratio; spaces beside it part nothing more.
    let mut marked = false;
    for (at, mark) in marks.iter().enumerate() {
        match mark {
            ',' if parts_decimals && inner.contains(&at) => {
                pieces.last_mut().into_iter().for_each(|piece| piece.push('.'));
            }
            ',' | ';' => {
                if marked || pieces.last().is_some_and(String::is_empty) && pieces.len() == 1 {
                    return Err(format!("there is no ratio before one of the {mark:?}"));
                }
                marked = true;
                pieces.push(String::new());
            }
            space if space.is_whitespace() => {
                if pieces.last().is_some_and(|piece| !piece.is_empty()) && !followed_by_mark(&marks, at) {
                    pieces.push(String::new());
                }
            }
            _ => {
                marked = false;
                pieces.last_mut().into_iter().for_each(|piece| piece.push(*mark));
            }
        }
    }
    if pieces.last().is_some_and(String::is_empty) {
        return Err(match pieces.len() {
            1 => "no ratios; write them as in 4.714, 3.143, 2.106".into(),
            _ => "there is no ratio after the last separator".into(),
        });
    }
    Ok(pieces)
}

/// Whether the next character other than a space is a comma or semicolon, or the text ends.
fn followed_by_mark(marks: &[char], at: usize) -> bool {
    marks[at..].iter().find(|mark| !mark.is_whitespace()).is_none_or(|mark| matches!(mark, ',' | ';'))
}

/// Whether inner commas part decimals.
fn meaning(marks: &[char], inner: &[usize]) -> Result<bool, String> {
    if inner.is_empty() {
        return Ok(false);
    }
    let is_point =
        |at: usize| marks[at] == '.' && marks.get(at + 1) != Some(&'.') && (at == 0 || marks[at - 1] != '.');
    let others = (0..marks.len()).filter(|at| !inner.contains(at));
    let mut separators = others.map(|at| marks[at]).filter(|mark| matches!(mark, ',' | ';' | ' '));
    let parts_ratios = if (0..marks.len()).any(is_point) {
        // The number on one side of the comma, its digits and its point.
        let in_number = |at: &usize| marks[*at].is_ascii_digit() || is_point(*at);
        let beside = |at: usize| {
            let before = (0..at).rev().take_while(in_number);
            before.chain((at + 1..marks.len()).take_while(in_number)).any(is_point)
        };
        separators.next().is_none() || inner.iter().all(|at| beside(*at))
    } else {
        let one_a_number = inner
            .windows(2)
            .all(|pair| marks[pair[0] + 1..pair[1]].iter().any(|mark| !mark.is_ascii_digit()));
        let commas_alone = separators.clone().next().is_none();
        if !commas_alone && one_a_number && separators.all(|mark| mark != ',') {
            return Ok(true);
        }
        false
    };
    if parts_ratios {
        return Ok(false);
    }
    let (before, after) = (digits(marks[..inner[0]].iter().rev()), digits(marks[inner[0] + 1..].iter()));
    let before: String = before.chars().rev().collect();
    Err(format!(
        "the comma in {before},{after} may part decimals or ratios; write decimals with a point, as in {before}.{after}, or part the \
         ratios by semicolons, as in {before},{after}; 1,5"
    ))
}

fn digits<'m>(marks: impl Iterator<Item = &'m char>) -> String {
    marks.take_while(|mark| mark.is_ascii_digit()).collect()
}

/// The text with one space for each run of them, and none where it parts nothing: at its ends, before `%`,
/// beside `±`, `..` and within parentheses.
fn joined(text: &str) -> String {
    let mut joined = String::new();
    for word in text.split_whitespace() {
        let glued = joined.is_empty()
            || joined.ends_with(['±', '(', '['])
            || joined.ends_with("..")
            || joined.ends_with("..=")
            || word.starts_with(['±', '%', ')', ']'])
            || word.starts_with("..");
        if !glued {
            joined.push(' ');
        }
        joined.push_str(word);
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_formats::wanted_ratio::Wanted;

    fn read(text: &str) -> Vec<f64> {
        text.parse::<Ratios>()
            .unwrap_or_else(|error| panic!("{text}: {error}"))
            .0
            .iter()
            .map(|ratio| match ratio.wanted {
                Wanted::Around { ratio, within: None } => ratio,
                other => panic!("{text}: {other}"),
            })
            .collect()
    }

    #[test]
    fn ratios_are_read_as_people_write_them() {
        let ratios = [4.714, 3.143, 1.0, 0.839, -3.295];
        for text in [
            "4.714, 3.143, 1, .839, -3.295",
            "4.714,3.143,1,.839,-3.295",
            "4.714 3.143 1 .839 -3.295",
            "  4.714\t3.143  1 .839   −3.295 ",
            "4.714; 3.143; 1; .839; -3.295",
            "4.714;3.143;1;.839;-3.295",
            "4.714 , 3.143 , 1 ; .839 -3.295",
            "4.714,3.143, 1, .839, -3.295",
            "4,714 3,143 1 0,839 -3,295",
            "4,714; 3,143; 1; 0,839; -3,295",
            "4,714;3,143;1;0,839;−3,295",
        ] {
            assert_eq!(read(text), ratios, "{text}");
        }
        assert_eq!(read("4, 3, 2, 1"), [4.0, 3.0, 2.0, 1.0]);
        assert_eq!(read("4.714,3,1"), [4.714, 3.0, 1.0]);
        assert_eq!(read("4,3 2,1"), [4.3, 2.1]);
        assert_eq!(read("2.5"), [2.5]);
    }

    #[test]
    fn mere_numbers_are_separated_alike() {
        let plain = |text: &str| -> Vec<f64> {
            text.parse::<PlainRatios>().unwrap().0.iter().map(|ratio| ratio.get()).collect()
        };
        for text in ["2.5,1.5", "2.5, 1.5", "2.5;1.5", "2.5 1.5", "2,5; 1,5", "2,5 1,5"] {
            assert_eq!(plain(text), [2.5, 1.5], "{text}");
        }
        assert_eq!(plain("3.9375"), [3.9375]);
        let refused = |text: &str| text.parse::<PlainRatios>().unwrap_err();
        assert!(refused("3,94").contains("may part decimals or ratios"));
        assert!(refused("2.5, fast").contains("does not start with a number"));
    }

    #[test]
    fn what_belongs_to_one_ratio_stays_together() {
        let pieces = |text| pieces(text).unwrap();
        assert_eq!(pieces("4.714 ± 0.5 %, 3 .. 3.5 (-3.295)"), ["4.714±0.5%", "3..3.5", "(-3.295)"]);
        assert_eq!(pieces("4,5..4,9; 3,143±0,5%; ?"), ["4.5..4.9", "3.143±0.5%", "?"]);
    }

    #[test]
    fn gears_have_bounds_of_their_own() {
        let ratios: Ratios = "4,714 ± 0,5 %; 3 .. 3,5 ? (-3,295)".parse().unwrap();
        let written: Vec<String> = ratios.0.iter().map(WantedRatio::to_string).collect();
        assert_eq!(written, ["4.714±0.5%", "3..3.5", "?", "(-3.295)"]);
        assert!("2, 0".parse::<Ratios>().unwrap_err().contains("no gear has the ratio 0"));
    }

    #[test]
    fn a_comma_that_may_be_either_is_refused_with_both_ways_to_write() {
        for text in
            ["4,714", "4,714,3,143", "4,714, 3,143", "4,714,-3,295", "4,3,2,1", "4,3,2 1", "4.714, 3,143, 1"]
        {
            let error = text.parse::<Ratios>().unwrap_err();
            assert!(
                error.contains("may part decimals or ratios; write decimals with a point"),
                "{text}: {error}"
            );
        }
        assert_eq!(
            "4,714, 3,143".parse::<Ratios>().unwrap_err(),
            "the comma in 4,714 may part decimals or ratios; write decimals with a point, as in 4.714, or part the ratios by \
             semicolons, as in 4,714; 1,5"
        );
    }

    #[test]
    fn a_place_without_a_ratio_is_refused() {
        for text in ["", "  ", "4.7,,3.1", "4.7; ;3.1", ",4.7", "4.7,", "4.7; 3.1 ;"] {
            assert!(text.parse::<Ratios>().unwrap_err().contains("no ratio"), "{text}");
        }
        assert_eq!(
            "4.7 fast".parse::<Ratios>().unwrap_err(),
            "fast: this does not start with a number; write a number, such as 3.94; a gear is written as 4.714, 4.714±0.5%, 4.5..4.9, ? or (-3.295)"
        );
    }
}
