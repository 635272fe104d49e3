//! Formulas of a chapter as MathML, which browsers typeset without a script, fonts or a network.
//!
//! A formula `$…$` is part of a line of text, `$$…$$` a separate paragraph. The content is LaTeX; a command
//! that the converter does not know is an error and not a blank.

use math_core::{LatexToMathML, MathDisplay};
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::fmt;
use std::ops::Range;

/// Formula with its place in the chapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula {
    /// LaTeX of the formula, without the dollars.
    pub latex: String,
    /// Whether the formula is a separate paragraph.
    pub is_block: bool,
    /// Range of bytes in the chapter, with the dollars.
    pub range: Range<usize>,
}

/// Formula that cannot be typeset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Line of the formula in the chapter, from 1.
    pub line: usize,
    /// LaTeX of the formula.
    pub latex: String,
    /// Message about the fault.
    pub message: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: `{}`", self.line, self.message, self.latex.trim())
    }
}

fn events(markdown: &str) -> impl Iterator<Item = (Event<'_>, Range<usize>)> {
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    Parser::new_ext(markdown, options).into_offset_iter()
}

/// Formulas of a chapter in their order; dollars in code do not count.
#[must_use]
pub fn of(markdown: &str) -> Vec<Formula> {
    let formula = |(event, range)| match event {
        Event::InlineMath(latex) => Some(Formula { latex: latex.into_string(), is_block: false, range }),
        Event::DisplayMath(latex) => Some(Formula { latex: latex.into_string(), is_block: true, range }),
        _ => None,
    };
    events(markdown).filter_map(formula).collect()
}

/// Places in bytes of stray dollars in the text: of formulas that are not closed, or whose braces do not
/// match.
fn stray_dollars(markdown: &str) -> Vec<usize> {
    let mut is_code = false;
    let mut stray = Vec::new();
    for (event, range) in events(markdown) {
        match event {
            Event::Start(Tag::CodeBlock(_)) => is_code = true,
            Event::End(TagEnd::CodeBlock) => is_code = false,
            Event::Text(_) if !is_code => {
                let dollars = markdown[range.clone()].match_indices('$').map(|(at, _)| range.start + at);
                // A dollar after a backslash is meant as a dollar sign.
                stray.extend(dollars.filter(|at| !markdown[..*at].ends_with('\\')));
            }
            _ => {}
        }
    }
    stray
}

/// Converter of formulas.
#[derive(Debug, Default)]
pub struct Typesetter(LatexToMathML);

impl Typesetter {
    /// Replaces the formulas of a chapter by MathML.
    ///
    /// # Errors
    /// All formulas that cannot be typeset.
    pub fn chapter(&self, markdown: &str) -> Result<String, Vec<Fault>> {
        let mut text = String::with_capacity(markdown.len());
        let mut faults = Vec::new();
        let line_of = |byte: usize| markdown[..byte].matches('\n').count() + 1;
        for at in stray_dollars(markdown) {
            let message =
                "a dollar that begins no formula: it is not closed, or its braces do not match".to_owned();
            let latex = markdown[at..].lines().next().unwrap_or_default().to_owned();
            faults.push(Fault { line: line_of(at), latex, message });
        }
        let mut at = 0;
        for formula in of(markdown) {
            text.push_str(&markdown[at..formula.range.start]);
            at = formula.range.end;
            match self.set(&formula.latex, formula.is_block) {
                Ok(set) => text.push_str(&set),
                Err(message) => {
                    let line = line_of(formula.range.start);
                    faults.push(Fault { line, latex: formula.latex, message });
                }
            }
        }
        text.push_str(&markdown[at..]);
        if faults.is_empty() { Ok(text) } else { Err(faults) }
    }

    /// Converts one formula to MathML that can be placed within Markdown.
    ///
    /// # Errors
    /// The message of the converter.
    pub fn set(&self, latex: &str, is_block: bool) -> Result<String, String> {
        let display = if is_block { MathDisplay::Block } else { MathDisplay::Inline };
        let set = self.0.convert_with_local_state(latex, display).map_err(|error| error.error_message())?;
        let set = without_markdown(&set.mathml);
        // A wide formula is scrolled in its own box, so that it does not widen the page.
        Ok(if is_block { format!("<div class=\"formula\">{set}</div>") } else { set })
    }
}

/// MathML that Markdown leaves unchanged: without line breaks, and without characters between tags that could
/// be a mark.
fn without_markdown(mathml: &str) -> String {
    let mut text = String::with_capacity(mathml.len());
    let (mut in_tag, mut in_entity) = (false, false);
    for character in mathml.chars() {
        match character {
            '<' => in_tag = true,
            '&' if !in_tag => in_entity = true,
            _ => {}
        }
        let is_mark = character.is_ascii_punctuation() && !in_tag && !in_entity;
        match character {
            '\n' => text.push(' '),
            _ if is_mark => text.push_str(&format!("&#{};", u32::from(character))),
            _ => text.push(character),
        }
        match character {
            '>' => in_tag = false,
            ';' => in_entity = false,
            _ => {}
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_stand_in_text_tables_and_paragraphs_but_not_in_code() {
        let markdown =
            "a $k$ and `$x$`\n\n| $z_a$ |\n|---|\n| $z_b$ |\n\n```text\n$y$\n```\n\n$$\n1 + k\n$$\n";
        let latex: Vec<String> = of(markdown).into_iter().map(|formula| formula.latex).collect();
        assert_eq!(latex, ["k", "z_a", "z_b", "\n1 + k\n"]);
        let set = Typesetter::default().chapter(markdown).unwrap_or_default();
        assert!(set.contains("a <math><mi>k</mi></math> and `$x$`"), "{set}");
        assert!(set.contains("<div class=\"formula\"><math display=\"block\">"), "{set}");
    }

    #[test]
    fn an_unknown_command_is_a_fault_with_its_line() {
        let faults = Typesetter::default().chapter("a\n\nb $\\omgea_a$\n").err().unwrap_or_default();
        assert_eq!(faults.len(), 1);
        assert!(faults[0].to_string().starts_with("3: "), "{}", faults[0]);
        assert!(Typesetter::default().chapter("$\\frac{1}{$").is_err());
        assert!(Typesetter::default().chapter("$k").is_err());
        assert!(Typesetter::default().chapter("5 \\$ and `$k`\n\n```sh\n$ ls\n```\n").is_ok());
    }

    #[test]
    fn marks_between_tags_are_written_as_numbers() {
        assert_eq!(
            without_markdown("<mo a=\"*\">*</mo><mo>&lt;</mo>\n"),
            "<mo a=\"*\">&#42;</mo><mo>&lt;</mo> "
        );
    }
}
