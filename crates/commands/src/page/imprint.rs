//! Imprint of a page: for whom it was made, by whom and when, and its paper.

use maud::{Markup, html};

/// Imprint of a page, which its answers do not contain. Values that are not given do not appear, so that
/// equal input gives an equal page.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Imprint {
    /// Project for which the page was made.
    pub project: Option<String>,
    /// Customer for whom the page was made.
    pub customer: Option<String>,
    /// Author of the page.
    pub author: Option<String>,
    /// Date of the page, as text.
    pub date: Option<String>,
    /// Paper size; `None` for that of the printer.
    pub paper: Option<Paper>,
}

/// Paper sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Paper {
    /// 210 × 297 mm.
    A4,
    /// 8.5 × 11 in.
    Letter,
}

impl Paper {
    const fn name(self) -> &'static str {
        match self {
            Self::A4 => "A4",
            Self::Letter => "letter",
        }
    }
}

impl Imprint {
    /// Lines of the imprint below the title.
    pub(crate) fn html(&self) -> Markup {
        let lines =
            [("Project", &self.project), ("For", &self.customer), ("By", &self.author), ("Date", &self.date)];
        let lines: Vec<_> =
            lines.into_iter().filter_map(|(name, line)| Some((name, line.as_ref()?))).collect();
        html! {
            @if !lines.is_empty() {
                dl.imprint { @for (name, line) in lines { div { dt { (name) } dd { (line) } } } }
            }
        }
    }

    /// CSS rules for paper: its size, and a footer with the title on each page.
    pub(crate) fn rules(&self, title: &str) -> String {
        let size = self.paper.map_or_else(String::new, |paper| format!("size: {}; ", paper.name()));
        let foot = [Some(title), self.project.as_deref(), self.date.as_deref()];
        let foot = foot.into_iter().flatten().collect::<Vec<_>>().join(" · ");
        format!(
            "@page {{ {size}@bottom-left {{ content: {}; font: 8pt Arial, Helvetica, sans-serif; color: #555c68; }} }}\n",
            string(&foot)
        )
    }
}

/// Converts a text to a CSS string; characters other than letters, digits and blanks become their code
/// points.
fn string(text: &str) -> String {
    let shown = |c: char| match c {
        c if c.is_alphanumeric() || c == ' ' => c.to_string(),
        c => format!("\\{:x} ", u32::from(c)),
    };
    format!("\"{}\"", text.chars().map(shown).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_cannot_leave_its_string() {
        assert_eq!(string("a\"}</style>"), "\"a\\22 \\7d \\3c \\2f style\\3e \"");
        let rules = Imprint::default().rules("8HP");
        assert!(rules.contains("content: \"8HP\"") && !rules.contains("size"), "{rules}");
    }

    #[test]
    fn only_what_is_given_is_on_the_page() {
        assert_eq!(Imprint::default().html().into_string(), "");
        let given = Imprint {
            project: Some("Winch <7>".to_owned()),
            paper: Some(Paper::Letter),
            ..Imprint::default()
        };
        let html = given.html().into_string();
        assert!(
            html.contains("<dt>Project</dt><dd>Winch &lt;7&gt;</dd>") && !html.contains("Date"),
            "{html}"
        );
        assert!(given.rules("A").contains("size: letter;"));
    }
}
