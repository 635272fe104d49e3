//! What a page says of itself: for whom it was made, by whom and when, and its paper.

use maud::{Markup, html};

/// What the answers on a page do not know. What is not given is not on the page, so that the same input gives
/// the same page.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Imprint {
    /// What it is for.
    pub project: Option<String>,
    /// For whom.
    pub customer: Option<String>,
    /// By whom.
    pub author: Option<String>,
    /// When, as it is to be read.
    pub date: Option<String>,
    /// The paper; that of the printer unless given.
    pub paper: Option<Paper>,
}

/// A size of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// Below the title.
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

    /// Rules for paper: its size, and at the foot of each page what it is of.
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

/// A text as a string of CSS: what is not a letter, a digit or a blank is written by its number.
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
