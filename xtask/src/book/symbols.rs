//! Symbols of a formula: letters with their subscripts, as `\omega_a` or `T_{\mathrm{in}}`.

use std::collections::BTreeSet;

/// Commands that are letters in formulas; all others are operators, arrows, blanks or layout.
const LETTERS: &[&str] = &[
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "eta",
    "theta",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "pi",
    "rho",
    "varrho",
    "sigma",
    "tau",
    "varphi",
    "phi",
    "psi",
    "omega",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Pi",
    "Sigma",
    "Phi",
    "Psi",
    "Omega",
    "ell",
];

/// Commands whose braces hold words, units or names of functions, but no symbols.
const TEXTS: &[&str] = &["text", "mathrm", "mathsf", "operatorname", "begin", "end", "tag"];

/// Accents above a letter, which belong to the name of its symbol.
const ACCENTS: &[&str] = &["hat", "bar", "dot", "tilde", "vec"];

/// Symbols of a formula in a unique spelling: without blanks, and without braces around a single letter.
#[must_use]
pub fn of(latex: &str) -> BTreeSet<String> {
    let mut symbols = BTreeSet::new();
    Reader { rest: latex, symbols: &mut symbols }.all();
    symbols
}

struct Reader<'a, 's> {
    rest: &'a str,
    symbols: &'s mut BTreeSet<String>,
}

impl<'a> Reader<'a, '_> {
    fn all(&mut self) {
        while !self.rest.is_empty() {
            if let Some(name) = self.letter() {
                let below = self.below();
                let marks = self.marks();
                self.symbols.insert(format!("{name}{below}{marks}"));
            } else {
                self.other();
            }
        }
    }

    /// Reads a letter, if one is next.
    fn letter(&mut self) -> Option<String> {
        let first = self.rest.chars().next()?;
        if first.is_alphabetic() {
            self.rest = &self.rest[first.len_utf8()..];
            return Some(first.to_string());
        }
        let command = command(self.rest)?;
        if LETTERS.contains(&command) {
            self.rest = &self.rest[1 + command.len()..];
            return Some(format!("\\{command}"));
        }
        if ACCENTS.contains(&command) {
            self.rest = self.rest[1 + command.len()..].trim_start();
            let over = self.group();
            return Some(format!("\\{command}{{{}}}", tight(over)));
        }
        None
    }

    /// Reads a subscript in the form in which it belongs to the symbol's name.
    fn below(&mut self) -> String {
        let after = self.rest.trim_start();
        let Some(below) = after.strip_prefix('_') else { return String::new() };
        self.rest = below.trim_start();
        let below = tight(self.group());
        if below.chars().count() == 1 || command(&below).is_some_and(|name| name.len() + 1 == below.len()) {
            format!("_{below}")
        } else {
            format!("_{{{below}}}")
        }
    }

    /// Reads primes and a star, which make a different symbol of a letter; a power does not.
    fn marks(&mut self) -> &'a str {
        let end = self.rest.find(|character| character != '\'').unwrap_or(self.rest.len());
        let end = if self.rest[end..].starts_with("^*") { end + 2 } else { end };
        let (marks, rest) = self.rest.split_at(end);
        self.rest = rest;
        marks
    }

    /// Reads the contents of the next braces, or the next letter or command.
    fn group(&mut self) -> &'a str {
        let rest = self.rest;
        let end = if let Some(inner) = rest.strip_prefix('{') {
            let mut depth = 1;
            let closed = inner.char_indices().find(|(_, character)| {
                depth += match character {
                    '{' => 1,
                    '}' => -1,
                    _ => 0,
                };
                depth == 0
            });
            let end = closed.map_or(inner.len(), |(at, _)| at);
            self.rest = inner.get(end + 1..).unwrap_or_default();
            return &inner[..end];
        } else if let Some(command) = command(rest) {
            1 + command.len()
        } else {
            rest.chars().next().map_or(0, char::len_utf8)
        };
        self.rest = &rest[end..];
        &rest[..end]
    }

    /// Skips text that is not a symbol.
    fn other(&mut self) {
        if let Some(command) = command(self.rest) {
            self.rest = self.rest[1 + command.len()..].trim_start();
            if TEXTS.contains(&command) {
                self.group();
            }
            return;
        }
        let skipped = self.rest.chars().next().map_or(0, char::len_utf8);
        // A backslash before a character other than a letter escapes it.
        let skipped = if self.rest.starts_with('\\') { self.rest.len().min(2) } else { skipped };
        self.rest = &self.rest[skipped..];
    }
}

/// Name of the next command, without its backslash.
fn command(text: &str) -> Option<&str> {
    let name = text.strip_prefix('\\')?;
    let end = name.find(|character: char| !character.is_ascii_alphabetic()).unwrap_or(name.len());
    (end > 0).then(|| &name[..end])
}

/// Removes blanks, except one after a command before a letter.
fn tight(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    let mut tight = String::new();
    for word in words {
        let last = tight.rfind('\\').map_or("", |at| &tight[at + 1..]);
        let is_command = !last.is_empty() && last.chars().all(|character| character.is_ascii_alphabetic());
        if is_command && word.starts_with(|character: char| character.is_ascii_alphabetic()) {
            tight.push(' ');
        }
        tight.push_str(word);
    }
    tight
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(latex: &str) -> Vec<String> {
        of(latex).into_iter().collect()
    }

    #[test]
    fn letters_are_symbols_with_what_stands_below_them() {
        assert_eq!(
            found(r"\omega_a + k\,\omega_b - (1 + k)\,\omega_H = 0"),
            [r"\omega_H", r"\omega_a", r"\omega_b", "k"]
        );
        assert_eq!(
            found(r"T_{\mathrm{in}}^2 \cdot \hat{C} \cdot z_{ 1 }"),
            [r"T_{\mathrm{in}}", r"\hat{C}", "z_1"]
        );
        assert_eq!(found(r"v_p' = \frac{\sin \gamma}{h_a^*}"), [r"\gamma", "h_a^*", "v_p'"]);
    }

    #[test]
    fn words_functions_and_layout_are_none() {
        assert_eq!(
            found(r"\begin{aligned} \cos x &\le 1 \\ \text{where } \operatorname{sign} y \end{aligned}"),
            ["x", "y"]
        );
    }
}
