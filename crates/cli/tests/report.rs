//! The command `report`: whole pages, and refusals.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

mod common;

use common::{examples, here, output, text};
use std::fs;

/// The page of an example.
fn page(arguments: &[&str]) -> String {
    let folder = here();
    let file = examples().join(arguments[0]);
    let command = [&["report", file.to_str().unwrap()], &arguments[1..], &["-o", "page.html"]].concat();
    let done = output(folder.path(), &command);
    assert!(done.status.success() && done.stdout.is_empty() && done.stderr.is_empty(), "{done:?}");
    fs::read_to_string(folder.path().join("page.html")).unwrap()
}

/// Headings of the sections.
fn sections(page: &str) -> Vec<&str> {
    page.split("<h2")
        .skip(1)
        .filter_map(|rest| rest.split_once('>')?.1.split_once('<'))
        .map(|(h, _)| h)
        .collect()
}

/// Every page: whole in itself, each element closed, each name given once.
fn is_sound(page: &str) {
    for banned in ["http:", "https:", "<script", "src=", "@import", "NaN", "inf "] {
        let found = page.replace("http://www.w3.org/2000/svg", "");
        assert!(!found.contains(banned), "{banned}");
    }
    for element in ["section", "table", "tr", "td", "th", "svg", "g", "figure", "ul", "li", "pre", "text"] {
        let opened =
            page.matches(&format!("<{element}>")).count() + page.matches(&format!("<{element} ")).count();
        assert_eq!(opened, page.matches(&format!("</{element}>")).count(), "{element}");
    }
    let names: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let mut once = names.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), names.len());
}

#[test]
fn the_page_of_a_drive_has_its_input_drawing_results_and_plots() {
    let page = page(&["xe215cll-drive.yaml"]);
    is_sound(&page);
    assert_eq!(
        sections(&page),
        ["Input", "Drawing", "Results and checks", "Plots", "What is left out", "Sources"]
    );
    assert!(page.contains("106.5 kW") && page.contains("<h1>Travel drive of the XE215CLL</h1>"));
    assert_eq!(page.matches("<svg").count(), 3);
    assert!(page.contains("too thin"), "warnings are part of it");
}

#[test]
fn the_page_of_a_gearbox_has_each_gear() {
    let page = page(&["scheme-ii-3.yaml", "--torque", "500 N·m", "--speed", "1475 rpm"]);
    is_sound(&page);
    let sections = sections(&page);
    for heading in ["Input", "Gears", "Gear slow", "Gear middle", "Gear fast", "Another k", "Sources"] {
        assert!(sections.contains(&heading), "{heading}: {sections:?}");
    }
    assert!(page.contains("-1240.9"), "the torque at the output");
    // The scheme and the levers, the ladder, scheme and speed plan of each gear, and the plots of two rows.
    assert_eq!(page.matches("<svg").count(), 3 + 2 * 3 + 6);
}

#[test]
fn the_page_of_a_motor_has_drawings_results_and_plots() {
    let page = page(&["motor-5x3.yaml"]);
    is_sound(&page);
    assert_eq!(sections(&page), ["Input", "Drawings", "Results and checks", "Plots", "Sources"]);
    assert!(page.contains("<h1>Motor 5×3</h1>") && page.contains("Flow, ripple 7.64 %"));
    assert_eq!(page.matches("<svg").count(), 5);
}

#[test]
fn one_of_several_transmissions_is_named() {
    let page = page(&["real-transmissions.yaml", "--transmission", "8HP", "--efficiency", "97%"]);
    is_sound(&page);
    assert!(page.contains("346/105"));
    let file = examples().join("real-transmissions.yaml");
    let refused = output(here().path(), &["report", file.to_str().unwrap()]);
    assert!(!refused.status.success() && refused.stdout.is_empty());
    let complaint = text(&refused.stderr);
    assert!(complaint.contains("--transmission") && complaint.contains("GM TH400"), "{complaint}");
}

#[test]
fn a_file_of_none_of_the_kinds_is_refused_and_leaves_the_old_page() {
    let folder = here();
    fs::write(folder.path().join("else.yaml"), "colour: red\n").unwrap();
    fs::write(folder.path().join("page.html"), "old").unwrap();
    let refused = output(folder.path(), &["report", "else.yaml", "-o", "page.html"]);
    assert!(!refused.status.success());
    assert!(text(&refused.stderr).contains("power") && text(&refused.stderr).contains("stator"));
    assert_eq!(fs::read_to_string(folder.path().join("page.html")).unwrap(), "old");
}

#[test]
fn the_page_of_a_search_has_its_answer_and_the_schemes_of_the_first() {
    let folder = here();
    let line = ["synthesize", "--ratios", "2.56, 1.465", "-o", "search.html"];
    let done = output(folder.path(), &line);
    assert!(done.status.success() && done.stdout.is_empty(), "{done:?}");
    let page = fs::read_to_string(folder.path().join("search.html")).unwrap();
    is_sound(&page);
    let headings =
        ["Search and solutions", "Families", "Gearbox 1", "Gearbox 2", "Gearbox 3", "What is left out"];
    assert_eq!(sections(&page), headings);
    assert_eq!(page.matches("<svg").count(), 3);
    assert!(page.contains("Scheme II-3 of the catalogue"));
}

#[test]
fn the_page_of_a_comparison_has_the_tables_and_the_scheme_of_each() {
    let folder = here();
    let line = ["compare", "II-3", "III-1", "--k1", "2.15", "--k2", "2.35", "-o", "compared.html"];
    let done = output(folder.path(), &line);
    assert!(done.status.success() && done.stdout.is_empty(), "{done:?}");
    let page = fs::read_to_string(folder.path().join("compared.html")).unwrap();
    is_sound(&page);
    assert_eq!(sections(&page), ["Side by side", "II-3", "III-1", "What is left out"]);
    assert_eq!(page.matches("<svg").count(), 2);
}

#[test]
fn the_page_of_a_gearbox_has_its_shifts() {
    let page = page(&["ravigneaux.yaml"]);
    is_sound(&page);
    assert!(sections(&page).contains(&"Shifts"));
    assert!(page.contains("Change of slip of the shift elements") && page.contains("<td>(F1)</td>"));
}
