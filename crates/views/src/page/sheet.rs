//! A page of one file: sections of answers, pictures and words, to be read without a network and printed.

use crate::{Error, Report};
use epicyclic_drawing::{Scene, svg};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A page.
#[derive(Debug)]
pub struct Sheet {
    /// Its heading.
    pub title: String,
    /// What it is about, in a line.
    pub about: String,
    /// In their order.
    pub sections: Vec<Section>,
}

/// A section of a page.
#[derive(Debug)]
pub struct Section {
    /// Its heading.
    pub heading: String,
    /// What stands in it.
    pub blocks: Vec<Block>,
}

impl Section {
    /// A heading and what stands below it.
    pub fn new(heading: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self { heading: heading.into(), blocks }
    }
}

/// A part of a section.
#[derive(Debug)]
pub enum Block {
    /// Tables, words and warnings of an answer.
    Answer(Report),
    /// A picture with what it shows.
    Picture {
        /// The picture.
        scene: Scene,
        /// What it shows.
        caption: String,
    },
    /// A paragraph.
    Words(String),
    /// A list of sentences.
    List(Vec<String>),
    /// A file as it was written.
    File(String),
}

impl Block {
    /// A picture with what it shows.
    pub fn picture(scene: Scene, caption: impl Into<String>) -> Self {
        Self::Picture { scene, caption: caption.into() }
    }

    /// A paragraph.
    pub fn words(words: impl Into<String>) -> Self {
        Self::Words(words.into())
    }
}

/// Rules of the page: black on white, tables and pictures whole on a printed page.
///
/// Pictures are drawn 1.4 times as large as on paper, so that the letters of all are of one size, but no wider than the page. On a
/// narrow screen they would be too small to read that way: there they scroll sideways within the page, as wide tables do.
const STYLE: &str = "\
:root { font: 15px/1.45 Arial, Helvetica, 'Liberation Sans', sans-serif; color: #111; background: #fff; }
body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin: 0; } h2 { font-size: 1.25rem; border-bottom: 1px solid #999; margin-top: 2.2rem; }
h3 { font-size: 1rem; margin: 1.2rem 0 .3rem; } .about, .fine, .note, figcaption, footer { color: #555; }
nav ul { columns: 3 10rem; padding-left: 1.1rem; } a { color: #00508c; } h1, li { overflow-wrap: anywhere; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
.table { overflow-x: auto; }
th, td { padding: .12rem .7rem .12rem 0; text-align: left; vertical-align: top; } thead th { border-bottom: 1px solid #999; }
tbody tr:nth-child(even) { background: #f4f5f7; } .number { text-align: right; }
figure { margin: 1rem 0; } figure svg { width: min(100%, calc(1.4mm * var(--width))); max-height: 60rem; }
pre { overflow-x: auto; font-size: .85rem; }
pre.file { background: #f4f5f7; padding: .6rem; } ul.warnings li { color: #8a2c00; }
.note { max-width: 45rem; margin: .3rem 0; font-size: .9rem; } footer { margin-top: 3rem; font-size: .85rem; }
@media screen and (max-width: 45rem) {
  figure { overflow-x: auto; } figcaption { position: sticky; left: 0; }
  figure svg { width: max(100%, min(calc(1mm * var(--width)), 44rem)); max-height: none; }
}
@page { margin: 18mm 15mm; }
@media print {
  :root { font-size: 10pt; } body { max-width: none; margin: 0; padding: 0; } nav { display: none; }
  .table, figure { break-inside: avoid; } h2, h3 { break-after: avoid; } a { color: inherit; text-decoration: none; }
  figure svg { max-height: 15cm; } pre { white-space: pre-wrap; } pre:not(.file) { break-inside: avoid; }
}";

impl Sheet {
    /// What the answers warn of, each once: it stands first.
    fn warnings(&self) -> Vec<&str> {
        let reports =
            self.sections.iter().flat_map(|section| &section.blocks).filter_map(|block| match block {
                Block::Answer(report) => Some(report),
                _ => None,
            });
        let mut all: Vec<&str> = vec![];
        for (_, warning) in reports.flat_map(|report| report.warnings.iter().flatten()) {
            if !all.contains(&warning.as_str()) {
                all.push(warning);
            }
        }
        all
    }

    /// The page as text.
    ///
    /// # Errors
    /// [`Error::Picture`] for a picture that cannot be written.
    pub fn html(&self) -> Result<String, Error> {
        let name = |place: usize| format!("section-{}", place + 1);
        let sections = self.sections.iter().enumerate().map(|(place, section)| {
            let blocks = section.blocks.iter().map(Block::html).collect::<Result<Vec<_>, _>>()?;
            Ok(html! {
                section {
                    h2 id=(name(place)) { (section.heading) }
                    @for block in blocks { (block) }
                }
            })
        });
        let sections = sections.collect::<Result<Vec<Markup>, Error>>()?;
        let warnings = self.warnings();
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { (self.title) }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    header {
                        h1 { (self.title) }
                        p.about { (self.about) }
                        @if !warnings.is_empty() {
                            ul.warnings { @for warning in warnings { li { (warning) } } }
                        }
                    }
                    nav aria-label="Contents" { ul {
                        @for (place, section) in self.sections.iter().enumerate() {
                            li { a href={ "#" (name(place)) } { (section.heading) } }
                        }
                    } }
                    main { @for section in sections { (section) } }
                    footer {
                        "Calculated by epicyclic " (env!("CARGO_PKG_VERSION")) ". What is left out is said above; check what matters."
                    }
                }
            }
        };
        Ok(page.into_string() + "\n")
    }
}

impl Block {
    fn html(&self) -> Result<Markup, Error> {
        Ok(match self {
            Self::Answer(report) => report.html(),
            Self::Picture { scene, caption } => {
                let image = svg::embed(scene).map_err(epicyclic_pictures::Error::from)?;
                let width_mm = scene.bounds().grown(svg::MARGIN_MM).width().ceil();
                html! { figure style=(format!("--width: {width_mm}")) { (PreEscaped(image)) figcaption { (caption) } } }
            }
            Self::Words(words) => html! { p { (words) } },
            Self::List(points) => html! { ul { @for point in points { li { (point) } } } },
            Self::File(text) => html! { pre.file { (text) } },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_whole_in_itself_and_escapes_what_it_is_given() {
        let blocks = vec![Block::words("1 < 2"), Block::File("gearbox: <script>\n".to_owned())];
        let sections = vec![Section::new("Inputs & more", blocks)];
        let sheet = Sheet { title: "A <b>".to_owned(), about: "test".to_owned(), sections };
        let page = sheet.html().unwrap();
        assert!(page.starts_with("<!DOCTYPE html>"));
        assert!(page.contains("<h1>A &lt;b&gt;</h1>") && page.contains("gearbox: &lt;script&gt;"));
        assert!(page.contains("<a href=\"#section-1\">Inputs &amp; more</a>"));
        assert!(!page.contains("http"), "nothing from a network");
    }
}
