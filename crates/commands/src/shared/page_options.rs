//! Options for the imprint of a page: project, customer, author, date, paper.

use crate::desk::Call;
use crate::failure::Failure;
use crate::page::{Imprint, Paper};
use std::ffi::OsString;

/// What a page says of itself. What is not given is not on it.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Page, in a file whose name ends in .html")]
pub(crate) struct PageArgs {
    /// What it is for, below the title and at the foot of each sheet.
    #[arg(long, value_name = "TEXT")]
    project: Option<String>,

    /// For whom it is.
    #[arg(long, value_name = "TEXT")]
    customer: Option<String>,

    /// Who made it.
    #[arg(long, value_name = "TEXT")]
    author: Option<String>,

    /// Its date, as it is to be read.
    #[arg(long, value_name = "TEXT")]
    date: Option<String>,

    /// Paper to print it on. Default: the printer's.
    #[arg(long, value_enum)]
    paper: Option<Paper>,
}

impl PageArgs {
    /// Imprint of the page.
    pub(crate) fn imprint(&self) -> Imprint {
        Imprint {
            project: self.project.clone(),
            customer: self.customer.clone(),
            author: self.author.clone(),
            date: self.date.clone(),
            paper: self.paper,
        }
    }

    /// Refuses these options where no page is written.
    pub(crate) fn only_of_a_page(&self, is_page: bool) -> Result<(), Failure> {
        let texts = [
            ("--project", &self.project),
            ("--customer", &self.customer),
            ("--author", &self.author),
            ("--date", &self.date),
        ];
        let text = texts.into_iter().find(|(_, text)| text.is_some()).map(|(option, _)| option);
        match text.or(self.paper.map(|_| "--paper")) {
            Some(option) if !is_page => {
                let message = "it stands on a page: the answer as a table, in a file of --output whose name ends in .html";
                Err(Failure::conflict(option, message))
            }
            _ => Ok(()),
        }
    }
}

/// The command as it was typed, without the file that its answer goes to: the input of a page that no file
/// describes.
pub(crate) fn command(call: &Call<'_>) -> String {
    words(call.words.iter().cloned())
}

fn words(arguments: impl IntoIterator<Item = OsString>) -> String {
    let mut line = "epicyclic".to_owned();
    let mut arguments = arguments.into_iter().map(|argument| argument.to_string_lossy().into_owned());
    while let Some(word) = arguments.next() {
        if matches!(word.as_str(), "-o" | "--output") {
            arguments.next();
        } else if !["--output=", "-o"].iter().any(|start| word.starts_with(start)) {
            line.push(' ');
            // Only a NUL cannot be quoted, and no argument holds one.
            line += &shlex::try_quote(&word).unwrap_or_default();
        }
    }
    line + "\n"
}

#[cfg(test)]
mod tests {
    use super::words;
    use std::ffi::OsString;

    #[test]
    fn a_command_is_quoted_for_a_shell_and_leaves_out_its_output() {
        let line =
            ["select", "--speeds", "0.8 m/s, 3.15 m/s", "-o", "page.html", "--output=b.html", "-oc.html"];
        assert_eq!(words(line.map(OsString::from)), "epicyclic select --speeds '0.8 m/s, 3.15 m/s'\n");
    }
}
