//! An answer as part of a page.

use super::{Grid, Part, Report, Text};
use crate::page::paper::{COLUMN_MM, SMALLEST_MM};
use epicyclic_drawing::Text as Line;
use maud::{Markup, html};

/// Room to the right of a cell on paper.
const GAP_MM: f64 = 2.4;
/// A column of words on paper is broken into lines rather than be wider.
const WORDS_MM: f64 = 34.0;
/// Capitals of bold letters over those of plain ones, as wide.
const BOLD: f64 = 1.08;
/// Tables with more rows may go on on the next page.
const LONG: usize = 45;

/// A part of a page.
#[derive(Debug)]
pub(crate) struct Piece {
    pub(crate) html: Markup,
    /// Whether it needs the width of both columns.
    pub(crate) is_wide: bool,
}

impl Report {
    /// Returns the report as HTML for a foreign page: sections with headings of the third level, tables,
    /// words, warnings. All text is escaped.
    #[must_use]
    pub fn html(&self) -> String {
        self.pieces().into_iter().map(|piece| piece.html.into_string()).collect()
    }

    /// Tables, words and warnings, without the title. That there are no warnings is not said: the page says
    /// it once.
    pub(crate) fn pieces(&self) -> Vec<Piece> {
        let mut pieces: Vec<Piece> = self.parts.iter().flat_map(Part::pieces).collect();
        if let Some(warnings) = self.warnings.as_ref().filter(|warnings| !warnings.is_empty()) {
            let html = html! {
                div {
                    h3 { "Warnings" }
                    ul.warnings { @for (_, warning) in warnings { li { (warning) } } }
                }
            };
            pieces.push(Piece { html, is_wide: false });
        }
        pieces
    }
}

impl Part {
    fn pieces(&self) -> Vec<Piece> {
        match self {
            Self::Facts(section) => {
                let mut grid = section.grid();
                // A row with nothing in it is for those who compare answers line by line.
                grid.rows.retain(|row| row[2..].iter().any(|cell| !matches!(cell.as_str(), "-" | "")));
                vec![grid.piece()]
            }
            Self::Records(records) => records.views.iter().map(|view| records.grid(view).piece()).collect(),
            Self::Text(text) => vec![text.piece()],
        }
    }
}

impl Text {
    fn piece(&self) -> Piece {
        let table = self.table.split_first();
        let width = table.map_or(0.0, |(header, rows)| {
            let header: Vec<&str> = header.iter().map(String::as_str).collect();
            width_mm(&header, rows)
        });
        let lines = self.lines.iter().map(|line| text_mm(line)).fold(0.0, f64::max);
        let rows = self.table.len() + self.points.len() + self.lines.len() + self.paragraphs.len();
        let is_wide = width.max(lines) > COLUMN_MM;
        let html = html! {
            section class=[class(is_wide, rows)] {
                @if let Some(heading) = &self.heading { h3 { (heading) } }
                @for paragraph in &self.paragraphs { p { (paragraph) } }
                @for line in &self.lines { p.line { (line) } }
                @if !self.points.is_empty() { ul { @for point in &self.points { li { (point) } } } }
                @if let Some((header, rows)) = table {
                    div.table { table {
                        thead { tr { @for title in header { th { (title) } } } }
                        tbody { @for row in rows { tr { @for cell in row { td class=[words(cell)] { (cell) } } } } }
                    } }
                }
            }
        };
        Piece { html, is_wide }
    }
}

impl Grid<'_> {
    fn piece(self) -> Piece {
        let number = |place: usize| self.right.contains(&place).then_some("number");
        let has_header = self.header.iter().any(|title| !title.is_empty());
        let is_wide = width_mm(&self.header, &self.rows) > COLUMN_MM;
        let html = html! {
            section class=[class(is_wide, self.rows.len())] {
                h3 { (self.title) }
                div.table { table {
                    @if has_header {
                        thead { tr {
                            @for (place, title) in self.header.iter().enumerate() {
                                th class=[number(place)] { (title) }
                            }
                        } }
                    }
                    tbody { @for row in &self.rows { tr {
                        @for (place, cell) in row.iter().enumerate() {
                            td class=[number(place).or(words(cell))] { (cell) }
                        }
                    } } }
                } }
                @if !self.note.is_empty() { p.note { (self.note) } }
            }
        };
        Piece { html, is_wide }
    }
}

/// CSS classes of a table: `wide` if wider than a column, `long` if longer than most of a page.
fn class(is_wide: bool, rows: usize) -> Option<&'static str> {
    match (is_wide, rows > LONG) {
        (true, true) => Some("wide long"),
        (true, false) => Some("wide"),
        (false, true) => Some("long"),
        (false, false) => None,
    }
}

/// Width of a table on paper, its words broken into lines where they are long.
fn width_mm(header: &[&str], rows: &[Vec<String>]) -> f64 {
    let columns = rows.iter().map(Vec::len).chain([header.len()]).max().unwrap_or(0);
    let column = |place: usize| {
        let title = header.get(place).map(|title| BOLD * text_mm(title));
        let cells = rows.iter().filter_map(|row| Some(broken_mm(row.get(place)?)));
        cells.chain(title).fold(0.0, f64::max) + GAP_MM
    };
    (0..columns).map(column).sum()
}

/// Width of a cell: of its longest word, if the whole of it is wider than words may be.
fn broken_mm(cell: &str) -> f64 {
    let longest = cell.split_whitespace().map(text_mm).fold(0.0, f64::max);
    text_mm(cell).min(WORDS_MM).max(longest)
}

/// A cell whose words are broken into lines: on a narrow screen they would become a column of single words.
fn words(cell: &str) -> Option<&'static str> {
    (text_mm(cell) > WORDS_MM).then_some("words")
}

fn text_mm(words: &str) -> f64 {
    let unit = Line::new([0.0, 0.0], 1.0, words);
    unit.width_mm() * SMALLEST_MM / unit.font_size_mm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_headings_paragraphs_lists_and_tables() {
        let list = Text::list("Why not", vec!["one more".to_owned(), "two & three".to_owned()]);
        let made = "<section><h3>Why not</h3><ul><li>one more</li><li>two &amp; three</li></ul></section>";
        assert_eq!(list.piece().html.into_string(), made);
        let paragraph = Text::paragraph("Left out").piece().html.into_string();
        assert_eq!(paragraph, "<section><p>Left out</p></section>");
        let lines = Text { lines: vec!["  i = k₁".to_owned()], ..Text::default() };
        assert_eq!(lines.piece().html.into_string(), "<section><p class=\"line\">  i = k₁</p></section>");
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let table = vec![words(&["gear", "K1"]), words(&["slow", "x"])];
        let table = Text { table, ..Text::default() }.piece().html.into_string();
        assert!(table.contains("<th>gear</th>") && table.contains("<td>x</td>"), "{table}");
    }

    #[test]
    fn what_is_wider_than_a_column_goes_across_both() {
        let row = |count: usize| vec![vec!["-1.2345".to_owned(); count]];
        // Helvetica's widths: of a hyphen, five digits and a point.
        let width_mm_of_one = (0.333 + 5.0 * 0.556 + 0.278) * SMALLEST_MM;
        assert!((text_mm("-1.2345") - width_mm_of_one).abs() < 1e-9, "{}", text_mm("-1.2345"));
        let is_wide = |count: usize| width_mm(&[], &row(count)) > COLUMN_MM;
        assert_eq!([5, 7, 8].map(is_wide), [false, false, true]);
        let long = vec![vec!["a sentence of many short words that is broken into lines".to_owned(); 2]];
        assert!(width_mm(&[], &long) < COLUMN_MM);
        assert_eq!([class(false, 60), class(true, 9)], [Some("long"), Some("wide")]);
    }

    #[test]
    fn a_cell_of_many_words_is_marked_as_such() {
        assert_eq!(words("a sentence of many short words that is broken into lines"), Some("words"));
        assert_eq!(words("turbine - ground"), None);
        let row =
            [["scheme", "because"], ["III-3", "speed 4.29 of planet 1 relative to its carrier in gear 1"]];
        let table = row.map(|row| row.map(str::to_owned).to_vec()).to_vec();
        let table = Text { table, ..Text::default() }.piece().html.into_string();
        assert!(table.contains("<td class=\"words\">speed"), "{table}");
    }
}
