//! Page: the answer first, then chapters of answers, pictures and text, the input last. A page can be read
//! without a network, and printed.

use super::imprint::Imprint;
use super::paper::{COLUMN_MM, SMALLEST_MM};
use crate::table::report::Report;
use crate::table::report::html::Piece;
use crate::table::text::Error;
use epicyclic_drawing::{Scene, Shape, svg};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// Page of answers, pictures and text.
#[derive(Debug)]
pub struct Sheet {
    /// Title of the page.
    pub title: String,
    /// Subject of the page in one line.
    pub about: String,
    /// Short answer on the first page.
    pub answer: Vec<Block>,
    /// Arrangement of the short answer.
    pub arrangement: Arrangement,
    /// Objections to the result, shown below the answer.
    pub objections: Vec<String>,
    /// Sections in their order.
    pub sections: Vec<Section>,
    /// Text of the input, a file or a command, shown at the end.
    pub input: String,
}

/// Section of a page.
#[derive(Debug)]
pub struct Section {
    /// Heading of the section.
    pub heading: String,
    /// Blocks of the section.
    pub blocks: Vec<Block>,
    /// Arrangement of the blocks.
    pub arrangement: Arrangement,
}

/// Arrangements of blocks if there is room for several side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// Two columns, in the given order.
    Columns,
    /// Two columns; blocks across both columns follow the others, so that they leave no gaps.
    WideLast,
    /// Rows, with as many blocks side by side as fit.
    Rows,
}

impl Section {
    /// Section with a heading and blocks, in two columns in the given order.
    pub fn new(heading: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self { heading: heading.into(), blocks, arrangement: Arrangement::Columns }
    }

    /// Changes the arrangement of the blocks.
    #[must_use]
    pub fn arranged(self, arrangement: Arrangement) -> Self {
        Self { arrangement, ..self }
    }
}

/// Part of a section.
#[derive(Debug)]
pub enum Block {
    /// Tables, text and warnings of an answer.
    Answer(Report),
    /// Picture with a caption.
    Picture {
        /// The picture.
        scene: Scene,
        /// Caption of the picture.
        caption: String,
    },
    /// Paragraph of text.
    Words(String),
    /// List of sentences.
    List(Vec<String>),
}

impl Block {
    /// Picture with a caption.
    pub fn picture(scene: Scene, caption: impl Into<String>) -> Self {
        Self::Picture { scene, caption: caption.into() }
    }

    /// Paragraph of text.
    pub fn words(words: impl Into<String>) -> Self {
        Self::Words(words.into())
    }
}

/// Number of lines above which an input counts as long.
const LONG_INPUT: usize = 12;

/// CSS rules of all pages.
const STYLE: &str = include_str!("page.css");

impl Sheet {
    /// Formats the page as HTML.
    ///
    /// # Errors
    /// [`Error::Picture`] for a picture that cannot be written.
    pub fn html(&self, imprint: &Imprint) -> Result<String, Error> {
        let answer = arranged(&self.answer, self.arrangement)?;
        let sections = self.sections.iter().map(|section| arranged(&section.blocks, section.arrangement));
        let sections = sections.collect::<Result<Vec<Markup>, Error>>()?;
        let name = |place: usize| format!("section-{}", place + 1);
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { (self.title) }
                    style { (PreEscaped(STYLE)) (PreEscaped(imprint.rules(&self.title))) }
                }
                body {
                    header {
                        h1 { (self.title) }
                        p.about { (self.about) }
                        (imprint.html())
                    }
                    main {
                        section.answer {
                            (answer)
                            (self.objections())
                        }
                        nav aria-label="Contents" {
                            h2 { "Contents" }
                            ul {
                                @for (place, section) in self.sections.iter().enumerate() {
                                    li { a href={ "#" (name(place)) } { (section.heading) } }
                                }
                                li { a href="#input" { "Input" } }
                            }
                        }
                        @for (place, (section, blocks)) in self.sections.iter().zip(sections).enumerate() {
                            section { h2 id=(name(place)) { (section.heading) } (blocks) }
                        }
                        section { h2 #input { "Input" } pre class=[self.input_class()] { (self.input) } }
                    }
                    footer {
                        "Calculated by epicyclic " (env!("CARGO_PKG_VERSION")) ". Check what matters, and what is left out."
                    }
                }
            }
        };
        Ok(page.into_string() + "\n")
    }

    /// CSS class of the input; a long one is set in two columns on paper.
    fn input_class(&self) -> Option<&'static str> {
        (self.input.lines().count() > LONG_INPUT).then_some("long")
    }

    fn objections(&self) -> Markup {
        html! {
            @if self.objections.is_empty() {
                p { "No warnings." }
            } @else {
                div.objections {
                    h3 { "What to object to" }
                    ul { @for objection in &self.objections { li { (objection) } } }
                }
            }
        }
    }
}

/// Arranges blocks side by side where they fit; in two columns, blocks too wide for one go across both.
fn arranged(blocks: &[Block], arrangement: Arrangement) -> Result<Markup, Error> {
    // Text before rows belongs to the heading, because a page may break between the rows.
    let is_lead = |block: &&Block| arrangement == Arrangement::Rows && matches!(block, Block::Words(_));
    let (lead, blocks) = blocks.split_at(blocks.iter().take_while(is_lead).count());
    let pieces = |blocks: &[Block]| -> Result<Vec<Piece>, Error> {
        let pieces = blocks.iter().map(Block::pieces).collect::<Result<Vec<_>, _>>()?;
        Ok(pieces.into_iter().flatten().collect())
    };
    let (lead, mut pieces) = (pieces(lead)?, pieces(blocks)?);
    if arrangement == Arrangement::WideLast {
        pieces.sort_by_key(|piece| piece.is_wide);
    }
    let class = if arrangement == Arrangement::Rows { "rows" } else { "columns" };
    Ok(html! {
        @for piece in lead { (piece.html) }
        div class=(class) { @for piece in pieces { (piece.html) } }
    })
}

impl Block {
    fn pieces(&self) -> Result<Vec<Piece>, Error> {
        let wide = |html| vec![Piece { html, is_wide: true }];
        Ok(match self {
            Self::Answer(report) => report.pieces(),
            Self::Picture { scene, caption } => {
                let image = svg::embed(scene).map_err(epicyclic_pictures::Error::from)?;
                let width_mm = least_width_mm(scene).ceil();
                let is_wide = width_mm > COLUMN_MM;
                let class = is_wide.then_some("wide");
                let html = html! {
                    figure class=[class] style=(format!("--w: {width_mm}")) {
                        (PreEscaped(image))
                        figcaption { (caption) }
                    }
                };
                vec![Piece { html, is_wide }]
            }
            Self::Words(words) => wide(html! { p.wide { (words) } }),
            Self::List(points) => wide(html! { ul.wide { @for point in points { li { (point) } } } }),
        })
    }
}

/// Width at which the smallest letters of a picture are as large as the smallest on paper.
fn least_width_mm(scene: &Scene) -> f64 {
    let letters = scene.items().iter().filter_map(|item| match &item.shape {
        Shape::Text(text) => Some(text.font_size_mm()),
        _ => None,
    });
    let width_mm = scene.bounds().grown(svg::MARGIN_MM).width();
    letters.reduce(f64::min).map_or(width_mm, |letters| width_mm * SMALLEST_MM / letters)
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::{Style, Text};

    fn sheet(sections: Vec<Section>) -> Sheet {
        Sheet {
            title: "A <b>".to_owned(),
            about: "test".to_owned(),
            answer: vec![Block::words("42")],
            arrangement: Arrangement::Columns,
            objections: vec!["too <fast>".to_owned()],
            sections,
            input: "gearbox: <script>\n".to_owned(),
        }
    }

    #[test]
    fn a_page_is_whole_in_itself_and_escapes_what_it_is_given() {
        let sections = vec![Section::new("Inputs & more", vec![Block::words("1 < 2")])];
        let page = sheet(sections).html(&Imprint::default()).unwrap();
        assert!(page.starts_with("<!DOCTYPE html>"));
        assert!(page.contains("<h1>A &lt;b&gt;</h1>") && page.contains("gearbox: &lt;script&gt;"));
        assert!(page.contains("<a href=\"#section-1\">Inputs &amp; more</a>"));
        assert!(page.contains("<li>too &lt;fast&gt;</li>"));
        assert!(!page.contains("http"), "nothing from a network");
    }

    #[test]
    fn the_answer_stands_first_and_the_input_last() {
        let page = sheet(vec![Section::new("Chapter", vec![])]).html(&Imprint::default()).unwrap();
        let places = ["<p class=\"wide\">42", "What to object to", "<nav", "Chapter</h2>", "<pre>"];
        let places = places.map(|part| page.find(part).unwrap());
        assert!(places.is_sorted(), "{places:?}");
    }

    #[test]
    fn a_pictures_width_is_that_of_letters_of_8_points() {
        let mut scene = Scene::new("letters of 5.08 mm, twice 8 pt");
        let layer = scene.layer("all", Style::line(0.2)).unwrap();
        scene.add(layer, Shape::line([0.0, 0.0], [192.0, 0.0]));
        assert!((least_width_mm(&scene) - 200.0).abs() < 1e-9, "no letters");
        let height_mm = 2.0 * SMALLEST_MM * 2.5 / Text::new([0.0, 0.0], 2.5, "").font_size_mm();
        scene.add(layer, Text::new([9.0, 0.0], height_mm, "a"));
        assert!((least_width_mm(&scene) - 100.0).abs() < 1e-9);
    }
}
