//! Text that shows itself: what would move the cursor of a terminal, colour it, reverse the reading or show
//! nothing is written as an escape.
//!
//! A name in a file may hold any character (`"\e[2J"`), and so may the name of a file. The escapes are those
//! of a YAML text in double quotes, so that what is shown can be found in the file: `\n`, `\t`, `\u001b`.

use std::borrow::Cow;
use std::fmt::Write as _;

/// The text on one line; line breaks are escaped too. For names, titles, cells of tables.
///
/// ```
/// use epicyclic_units::visible::one_line;
///
/// assert_eq!(one_line("gear\u{1b}[2J\n1"), r"gear\u001b[2J\n1");
/// assert_eq!(one_line("η₁ = 0,97 Ω"), "η₁ = 0,97 Ω");
/// ```
#[must_use]
pub fn one_line(text: &str) -> Cow<'_, str> {
    escaped(text, |c| c == '\n' || is_hidden(c))
}

/// The text with its line breaks; all else is escaped. For what is already put together of several lines.
#[must_use]
pub fn lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| c != '\n' && is_hidden(c))
}

/// Control characters, those that change the direction of reading, and those without width.
fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

fn escaped(text: &str, is_escaped: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.chars().any(&is_escaped) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match c {
            c if !is_escaped(c) => shown.push(c),
            '\n' => shown += "\\n",
            '\r' => shown += "\\r",
            '\t' => shown += "\\t",
            c => {
                let code = u32::from(c);
                // Writing to a string does not fail.
                let _ = if code > 0xffff {
                    write!(shown, "\\U{code:08x}")
                } else {
                    write!(shown, "\\u{code:04x}")
                };
            }
        }
    }
    Cow::Owned(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_shows_nothing_is_written_out() {
        for (text, shown) in [
            ("a\u{7f}\u{9b}b", r"a\u007f\u009bb"),
            ("\u{202e}txt", r"\u202etxt"),
            ("a\u{200b}\u{feff}", r"a\u200b\ufeff"),
            ("\u{e0041}", r"\U000e0041"),
            ("a\tb\r\n", r"a\tb\r\n"),
            ("🦀 N·m — ±½", "🦀 N·m — ±½"),
        ] {
            assert_eq!(one_line(text), shown);
        }
        assert_eq!(lines("a\tb\nc\u{7}"), "a\\tb\nc\\u0007");
    }
}
