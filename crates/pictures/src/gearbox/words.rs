//! Numbers and sets in words.

use super::LETTERS_MM;
use crate::tolerance::SHOWN;
use epicyclic_drawing::Text;
use epicyclic_train::Gearbox;
use epicyclic_train::set::SetKind;

/// A number to three decimals, below 0.1 to four digits, its minus a real one; what is below a millionth is
/// 0.
pub(super) fn decimal(value: f64) -> String {
    let size = value.abs();
    if size < SHOWN {
        return "0.000".into();
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 3 to 9
    let decimals = if size < 0.1 { (3.0 - libm::log10(size).floor()) as usize } else { 3 };
    format!("{value:.decimals$}").replace('-', "−")
}

/// A drawn set by its number, and its name where that is another: `set 1 (P1)`.
pub(super) fn set_name(gearbox: &Gearbox, place: usize) -> String {
    let number = (place + 1).to_string();
    let id = gearbox.sets()[gearbox.drawn_sets()[place].set].id();
    if id == number { format!("set {number}") } else { format!("set {number} ({id})") }
}

/// Drawn set with its kind and gearing: `set 1 (P1): simple, z 48/96, k = 2.000`.
pub(super) fn set(gearbox: &Gearbox, place: usize, gearing: bool) -> String {
    let drawn = &gearbox.drawn_sets()[place];
    let mut words = format!("{}: {}", set_name(gearbox, place), drawn.kind);
    if gearing {
        if let Some([first, second]) = drawn.teeth(gearbox) {
            words += &format!(", z {}/{}", first.get(), second.get());
        }
        let ratio = drawn.basic_ratio(gearbox);
        let (symbol, size) = match drawn.kind {
            SetKind::Simple => ("k", -ratio),
            _ => ("i0", ratio),
        };
        words += &format!(", {symbol} = {}", decimal(size));
    }
    words
}

/// Words in lines of at most this width, in the letters of the drawings; a longer word has a line of its own.
pub(super) fn wrapped(words: &str, width_mm: f64) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in words.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width_of(&format!("{line} {word}")) <= width_mm => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Width of words in the letters of the drawings.
pub(super) fn width_of(words: &str) -> f64 {
    Text::new([0.0, 0.0], LETTERS_MM, words).width_mm()
}

#[cfg(test)]
mod tests {
    use super::{decimal, width_of, wrapped};

    #[test]
    fn lines_are_as_full_as_they_can_be() {
        let words = "one two three four";
        assert_eq!(wrapped(words, width_of("one two three")), ["one two three", "four"]);
        assert_eq!(wrapped(words, 0.1), ["one", "two", "three", "four"]);
        assert!(wrapped("", 9.0).is_empty());
    }

    #[test]
    fn small_numbers_keep_their_digits() {
        let values = [2.0, -0.5, 0.012_345_6, -1e-9, 81.491_2];
        assert_eq!(values.map(decimal), ["2.000", "−0.500", "0.01235", "0.000", "81.491"]);
    }
}
