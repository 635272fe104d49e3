//! An answer as part of a page.

use super::{Grid, Part, Report, Text};
use maud::{Markup, html};

impl Report {
    /// Tables, words and warnings, without the title.
    #[must_use]
    pub fn html(&self) -> Markup {
        html! {
            @for part in &self.parts { (part.html()) }
            @if let Some(warnings) = &self.warnings {
                @if warnings.is_empty() {
                    p.fine { "No warnings." }
                } @else {
                    h3 { "Warnings" }
                    ul.warnings { @for (_, warning) in warnings { li { (warning) } } }
                }
            }
        }
    }
}

impl Part {
    fn html(&self) -> Markup {
        match self {
            Self::Facts(section) => section.grid().html(),
            Self::Records(records) => {
                html! { @for view in &records.views { (records.grid(view).html()) } }
            }
            Self::Words(words) => self::words(words),
            Self::Text(text) => text.html(),
        }
    }
}

impl Text {
    fn html(&self) -> Markup {
        let table = self.table.split_first();
        html! {
            @if let Some(heading) = &self.heading { h3 { (heading) } }
            @for paragraph in &self.paragraphs { p { (paragraph) } }
            @if !self.points.is_empty() { ul { @for point in &self.points { li { (point) } } } }
            @if let Some((header, rows)) = table {
                table {
                    thead { tr { @for title in header { th { (title) } } } }
                    tbody { @for row in rows { tr { @for cell in row { td { (cell) } } } } }
                }
            }
        }
    }
}

/// Words as they stand: a table of letters keeps its columns.
fn words(words: &str) -> Markup {
    // What goes on from the first line is set in by more than a blank; below a heading it is not.
    let (heading, rest) = match words.split_once('\n') {
        Some((heading, rest)) if !rest.trim().is_empty() && !rest.starts_with("  ") => (heading, rest),
        _ => ("", words),
    };
    let listed = rest.starts_with(" - ")
        && rest.lines().all(|line| line.starts_with(" - ") || line.starts_with("   "));
    // Columns are parted by two blanks or more, sentences by one.
    let sentences = rest.lines().all(|line| !line.trim().contains("  "));
    let joined = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    html! {
        @if !heading.is_empty() { h3 { (heading) } }
        @if listed {
            ul { @for point in rest.split(" - ").filter(|point| !point.trim().is_empty()) {
                li { (joined(point)) }
            } }
        } @else if sentences {
            p { (joined(rest)) }
        } @else {
            pre { (rest.trim_end()) }
        }
    }
}

impl Grid<'_> {
    fn html(self) -> Markup {
        let class = |place: usize| self.right.contains(&place).then_some("number");
        let has_header = self.header.iter().any(|title| !title.is_empty());
        html! {
            section.table {
                h3 { (self.title) }
                table {
                    @if has_header {
                        thead { tr {
                            @for (place, title) in self.header.iter().enumerate() {
                                th class=[class(place)] { (title) }
                            }
                        } }
                    }
                    tbody { @for row in &self.rows { tr {
                        @for (place, cell) in row.iter().enumerate() { td class=[class(place)] { (cell) } }
                    } } }
                }
                @if !self.note.is_empty() { p.note { (self.note) } }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_lists_and_tables_of_letters_keep_their_columns() {
        let list = words("Why not\n - one\n   more\n - two & three\n").into_string();
        assert_eq!(list, "<h3>Why not</h3><ul><li>one more</li><li>two &amp; three</li></ul>");
        let sentence = words("Left out\n Losses\n and more.\n").into_string();
        assert_eq!(sentence, "<h3>Left out</h3><p>Losses and more.</p>");
        let source = words("Source: a table\n        and a chart\n").into_string();
        assert_eq!(source, "<p>Source: a table and a chart</p>");
        let table = words("Shift table\n gear  K1\n slow  x\n").into_string();
        assert_eq!(table, "<h3>Shift table</h3><pre> gear  K1\n slow  x</pre>");
    }
}
