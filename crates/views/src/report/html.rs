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
            @for line in &self.lines { p.line { (line) } }
            @if !self.points.is_empty() { ul { @for point in &self.points { li { (point) } } } }
            @if let Some((header, rows)) = table {
                div.table { table {
                    thead { tr { @for title in header { th { (title) } } } }
                    tbody { @for row in rows { tr { @for cell in row { td { (cell) } } } } }
                } }
            }
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
    fn a_text_is_headings_paragraphs_lists_and_tables() {
        let list = Text::list("Why not", vec!["one more".to_owned(), "two & three".to_owned()]);
        let made = "<h3>Why not</h3><ul><li>one more</li><li>two &amp; three</li></ul>";
        assert_eq!(list.html().into_string(), made);
        assert_eq!(Text::paragraph("Left out").html().into_string(), "<p>Left out</p>");
        let lines = Text { lines: vec!["  i = k₁".to_owned()], ..Text::default() };
        assert_eq!(lines.html().into_string(), "<p class=\"line\">  i = k₁</p>");
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let table = vec![words(&["gear", "K1"]), words(&["slow", "x"])];
        let table = Text { table, ..Text::default() }.html().into_string();
        assert!(table.contains("<th>gear</th>") && table.contains("<td>x</td>"), "{table}");
    }
}
