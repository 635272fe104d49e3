//! `verify` itself: what it accepts, what it refuses, and what it says then.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;
use xtask::cases::figure::Status;
use xtask::cases::run::Outcome;
use xtask::verify::{self, Arguments, Format};

fn arguments(cases: &Path) -> Arguments {
    Arguments {
        filter: String::new(),
        format: Format::Human,
        html: None,
        accept: false,
        cases: Some(cases.to_owned()),
    }
}

fn outcomes(cases: &Path) -> Vec<Outcome> {
    verify::outcomes(&arguments(cases)).unwrap()
}

fn xtask(arguments: &[&str], cases: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(arguments)
        .arg("--cases")
        .arg(cases)
        .env("INSTA_UPDATE", "always")
        .output()
        .unwrap()
}

/// Output of a command without line breaks.
fn words(printed: &[u8]) -> String {
    String::from_utf8_lossy(printed).split_whitespace().collect::<Vec<_>>().join(" ")
}

fn real_cases() -> PathBuf {
    xtask::project_root().join("spec-cases")
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// A folder `cases`, with the temporary folder that holds it.
struct Cases(TempDir);

impl Cases {
    fn path(&self) -> PathBuf {
        self.0.path().join("cases")
    }
}

/// A folder of one source with an index of one place and these files.
fn source(files: &[(&str, &[u8])]) -> Cases {
    let folder = Cases(tempfile::tempdir().unwrap());
    let source = folder.path().join("s");
    fs::create_dir_all(&source).unwrap();
    let index = "source: s\ntitle: a source\nplaces:\n  - { place: here, what: all of it }\n";
    fs::write(source.join("index.yaml"), index).unwrap();
    for (name, bytes) in files {
        fs::write(source.join(name), bytes).unwrap();
    }
    folder
}

const SHAFT: &str = "case: shaft\ncite: here\ncalculation: gears.shaft\ngiven: { torque: 521.8 N·m, \
                     allowable_stress: 20 MPa }\nexpect:\n  diameter: { published: \"51.0 mm\" }\n";

#[test]
fn the_projects_cases_hold() {
    let text = xtask::report::human::render(&outcomes(&real_cases()), false);
    assert!(text.contains("\nverified: "), "{text}");
}

#[test]
fn plain_verify_writes_nothing() {
    let folder = source(&[("a.yaml", SHAFT.as_bytes())]);
    let output = xtask(&["verify"], &folder.path());
    assert_eq!(output.status.code(), Some(1));
    let text = words(&output.stdout);
    assert!(text.contains("cargo xtask verify --accept"), "{text}");
    assert!(!folder.path().join("s/snapshots").exists());

    assert_eq!(xtask(&["verify", "--accept"], &folder.path()).status.code(), Some(0));
    assert_eq!(xtask(&["verify"], &folder.path()).status.code(), Some(0));
    assert_eq!(fs::read_to_string(folder.path().join("s/a.yaml")).unwrap(), SHAFT);
}

#[test]
fn a_changed_digit_names_place_and_difference() {
    let folder = source(&[("a.yaml", SHAFT.replace("51.0", "51.9").as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    let output = xtask(&["verify"], &folder.path());
    assert_eq!(output.status.code(), Some(1));
    insta::assert_snapshot!(String::from_utf8(output.stdout).unwrap());
}

/// A newcomer's three cases beside one that holds: a good one, a wrong one, a malformed one.
#[test]
fn a_newcomers_cases_are_told_apart() {
    let case = |name: &str, diameter: &str| {
        SHAFT.replace("case: shaft", &format!("case: {name}")).replace("51.0 mm", diameter)
    };
    let folder = source(&[("a.yaml", SHAFT.as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    let report = |name: &str, text: &str| {
        let file = folder.path().join("s/new.yaml");
        fs::write(&file, text).unwrap();
        let output = xtask(&["verify", name], &folder.path());
        assert_eq!(output.status.code(), Some(1));
        format!("{}{}", String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    insta::assert_snapshot!("good_case", report("winch-good", &case("winch-good", "51.0 mm")));
    insta::assert_snapshot!("wrong_case", report("winch-wrong", &case("winch-wrong", "45 mm")));
    let malformed = case("winch-malformed", "51,0 mm").replace("torque: 521.8 N·m", "torqe: 521.8 N·m");
    insta::assert_snapshot!("malformed_case", report("winch-malformed", &malformed));
    fs::write(folder.path().join("s/new.yaml"), case("winch-good", "51.0 mm")).unwrap();
    assert_eq!(xtask(&["verify", "winch-good", "--accept"], &folder.path()).status.code(), Some(0));
    let accepted = xtask(&["verify", "winch-good"], &folder.path());
    assert_eq!(accepted.status.code(), Some(0));
    insta::assert_snapshot!("accepted_case", String::from_utf8(accepted.stdout).unwrap());
}

/// Verdicts and tolerances that need a reason, one figure of a case each.
#[test]
fn a_figure_that_needs_a_reason_is_refused_without_it() {
    let mut report = String::new();
    for (figure, restored, name) in [
        ("published: 51.0 mm, verdict: reconstructed", "", Some("restored-figure")),
        ("published: 51.0 mm", "restored: the root was lost\n", Some("restored-figure")),
        ("published: 51.0 mm, verdict: reconstructed", "restored: the root was lost\n", None),
        ("published: 51.0 mm, verdict: agrees", "restored: the root was lost\n", None),
        ("published: 51.0 mm, verdict: definition", "", Some("incomplete-figure")),
        ("published: 51.0 mm, verdict: definition, because: it is its own input", "", None),
        ("published: 51.2 mm, tolerance: 0.3 mm", "", Some("incomplete-figure")),
        ("published: 51.2 mm, tolerance: 0.3 mm, because: read off a graph", "", None),
        ("published: 51.0 mm, tolerance: 0.05 mm, because: rounded", "", Some("idle-tolerance")),
        ("published: 52 mm, tolerance: 2 %, because: read off a graph", "", None),
        ("published: 52 mm, tolerance: 3 %, because: read off a graph", "", Some("loose-tolerance")),
        ("published: 51.00 mm, tolerance: 0.1 mm, because: by π = 3.14", "", Some("loose-tolerance")),
        ("published: 51.00 mm, tolerance: 0.1 mm, because: by π = 3.14, cause: constant", "", None),
        ("published: 51.0 mm, cause: constant", "", Some("idle-cause")),
        ("published: 51.0 mm, print_of: shaft/width", "", Some("unusable-print")),
    ] {
        let text =
            SHAFT.replace("published: \"51.0 mm\"", figure).replace("given:", &format!("{restored}given:"));
        let folder = source(&[("a.yaml", text.as_bytes())]);
        xtask(&["verify", "--accept"], &folder.path());
        let outcome = &outcomes(&folder.path())[0];
        assert_eq!(outcome.faults.first().map(|fault| fault.name.as_str()), name, "{figure}: {outcome:?}");
        assert!(outcome.figures.iter().all(|figure| figure.failure.is_none()), "{figure}: {outcome:?}");
        for fault in &outcome.faults {
            report.push_str(&format!("{restored}{figure}\n  {}\n", fault.message));
        }
    }
    insta::assert_snapshot!(report);
}

#[test]
fn two_comparisons_of_a_print_are_one_print() {
    let again = SHAFT
        .replace("case: shaft", "case: again")
        .replace("\"51.0 mm\"", "51.0 mm, print_of: shaft/diameter");
    let refused = "\n---\ncase: bad\ncite: here\ncalculation: gears.shaft\ngiven: { torque: 0 N·m, \
                   allowable_stress: 20 MPa }\nexpect_error: not-positive\n";
    let folder = source(&[("a.yaml", format!("{SHAFT}---\n{again}{refused}").as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    let text = words(&xtask(&["verify"], &folder.path()).stdout);
    let headline = "verified: 2 comparisons of 1 print in 3 cases: 2 agree; 1 input refused as must be";
    assert!(text.ends_with(headline), "{text}");
}

#[test]
fn a_case_that_cannot_run_covers_nothing() {
    for text in [
        SHAFT.replace("gears.shaft", "gears.shafts"),
        SHAFT.replace("torque: 521.8 N·m", "torque: 521.8 kW"),
        SHAFT.replace("torque: 521.8 N·m", "torque: 0 N·m"),
        SHAFT.replace("diameter:", "width:"),
        SHAFT.replace("torque: 521.8 N·m", "torque: { from: other/torque, as: exact }"),
    ] {
        let folder = source(&[("a.yaml", text.as_bytes())]);
        let outcome = &outcomes(&folder.path())[0];
        assert_eq!(outcome.coverage[0].figures, 0, "{text}");
        assert!(outcome.faults.iter().any(|fault| fault.name == "uncovered-place"), "{text}");
    }
    // A figure that misses was compared.
    let folder = source(&[("a.yaml", SHAFT.replace("51.0", "51.9").as_bytes())]);
    assert_eq!(outcomes(&folder.path())[0].coverage[0].figures, 1);
}

#[test]
fn a_removed_case_a_removed_figure_and_a_changed_print_are_told() {
    let two = SHAFT.to_owned() + "  standard_diameter: { published: \"53 mm\" }\n";
    let more = two.replace("case: shaft", "case: other");
    let folder = source(&[("a.yaml", two.as_bytes()), ("b.yaml", more.as_bytes())]);
    let file = folder.path().join("s/a.yaml");
    xtask(&["verify", "--accept"], &folder.path());
    assert_eq!(xtask(&["verify"], &folder.path()).status.code(), Some(0));
    let mut report = String::new();
    fs::remove_file(folder.path().join("s/b.yaml")).unwrap();
    for text in [two.as_str(), SHAFT, &two.replace("51.0 mm\"", "51.03 mm\"")] {
        fs::write(&file, text).unwrap();
        for fault in &outcomes(&folder.path())[0].faults {
            report.push_str(&format!("{}: {}\n", fault.name, fault.message));
        }
    }
    insta::assert_snapshot!(report);
}

#[test]
fn a_finding_without_a_text_and_a_changed_count_are_told() {
    let wrong = SHAFT.replace(
        "published: \"51.0 mm\"",
        "published: \"45 mm\", verdict: contradicted, computed: 51.02872647 mm, because: by (3)",
    );
    let folder = source(&[("a.yaml", wrong.as_bytes())]);
    let texts = folder.path().with_file_name("docs").join("src");
    fs::create_dir_all(&texts).unwrap();
    fs::write(texts.join("findings.md"), "").unwrap();
    fs::write(folder.path().with_file_name("README.md"), "one figure\n").unwrap();
    xtask(&["verify", "--accept"], &folder.path());
    let told = || -> Vec<String> {
        let faults = &outcomes(&folder.path())[0].faults;
        faults.iter().map(|fault| format!("{}:{}: {}", fault.file, fault.name, fault.message)).collect()
    };
    let mut report = told();
    let row = "| `shaft/diameter` | 45 mm | 51.03 mm | here | by (3) |";
    fs::write(texts.join("findings.md"), format!("1 figures are contradicted\n{row}\n")).unwrap();
    report.extend(told());
    insta::assert_snapshot!(report.join("\n"));
    fs::write(texts.join("findings.md"), format!("1 figures are contradicted, 0 figures are lost\n{row}\n"))
        .unwrap();
    let headline = "1 comparison of 1 print in 1 case: 0 agree, 1 contradicted";
    fs::write(folder.path().with_file_name("README.md"), headline).unwrap();
    assert!(told().is_empty(), "{:?}", told());
}

/// Every digit of every agreeing figure of the project, changed by five one at a time.
#[test]
fn no_digit_of_an_agreeing_figure_is_idle() {
    let sources = xtask::cases::load::sources(&real_cases(), &xtask::calculations::all()).unwrap();
    let mut tried = 0;
    for outcome in outcomes(&real_cases()) {
        for figure in outcome.figures.iter().filter(|figure| {
            matches!(figure.status, Status::Agrees | Status::Reconstructed | Status::Definition)
        }) {
            let (Some(published), Some(tolerance)) = (&figure.published, &figure.tolerance) else { continue };
            let (case, quantity) = figure.name.split_once('/').unwrap();
            let source = sources.iter().find(|source| source.id == outcome.source).unwrap();
            let case = &source.cases.iter().find(|loaded| loaded.case.case == case).unwrap().case;
            let expectation = &case.expect[quantity];
            if expectation.tolerance.is_some() {
                continue;
            }
            let computed = figure.computed.as_ref().unwrap();
            let value = |text: &str| epicyclic_units::parse(text).unwrap();
            let number = value(published).number;
            for (at, digit) in number.char_indices().filter(|(_, c)| c.is_ascii_digit()) {
                let changed = char::from_digit((digit.to_digit(10).unwrap() + 5) % 10, 10).unwrap();
                let mut text = published.clone();
                text.replace_range(at..at + 1, &changed.to_string());
                let mut expectation = expectation.clone();
                expectation.published = Some(text.clone());
                let found = value(computed);
                let result =
                    xtask::calculations::Value::Quantity { si: found.si(), dimension: found.dimension() };
                let judged = xtask::cases::figure::judge(&expectation, &result);
                assert!(judged.failure.is_some(), "{}: {text} for {computed} ± {tolerance}", figure.name);
                tried += 1;
            }
        }
    }
    assert!(tried > 100, "{tried}");
}

#[test]
fn a_contradiction_that_starts_to_agree_fails() {
    let folder = Cases(tempfile::tempdir().unwrap());
    copy(&real_cases(), &folder.path());
    let file = folder.path().join("excavator-dynamics/80-motion.yaml");
    let text = fs::read_to_string(&file).unwrap();
    assert!(text.contains("published: \"0.821 kg·m²\""));
    fs::write(&file, text.replace("published: \"0.821 kg·m²\"", "published: \"0.289 kg·m²\"")).unwrap();
    let output = xtask(&["verify", "excavator"], &folder.path());
    assert_eq!(output.status.code(), Some(1));
    let text = words(&output.stdout);
    assert!(
        text.contains("motion/equivalent_inertia: marked contradicted, but the published figure"),
        "{text}"
    );
}

#[test]
fn a_changed_result_and_an_orphan_are_seen() {
    let folder = source(&[("a.yaml", SHAFT.as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    let snapshots = folder.path().join("s/snapshots");
    let stored = fs::read_to_string(snapshots.join("shaft.snap")).unwrap();
    fs::write(snapshots.join("shaft.snap"), stored.replace("0.05102", "0.05103")).unwrap();
    fs::write(snapshots.join("gone.snap"), &stored).unwrap();
    let outcome = &outcomes(&folder.path())[0];
    let names: Vec<&str> = outcome.faults.iter().map(|fault| fault.name.as_str()).collect();
    assert_eq!(names, ["changed-snapshot", "orphan-snapshot"]);
    xtask(&["verify", "--accept"], &folder.path());
    assert!(!snapshots.join("gone.snap").exists());
    assert_eq!(xtask(&["verify"], &folder.path()).status.code(), Some(0));
}

#[test]
fn an_uncovered_place_fails_and_an_excused_one_does_not() {
    let index = |second: &str| {
        format!("source: s\ntitle: a source\nplaces:\n  - {{ place: here, what: all }}\n  - {second}\n")
    };
    for (second, name) in [
        ("{ place: there, what: the rest }", Some("uncovered-place")),
        ("{ place: there, what: the rest, excused: a drawing }", None),
    ] {
        let folder = source(&[("a.yaml", SHAFT.as_bytes()), ("index.yaml", index(second).as_bytes())]);
        xtask(&["verify", "--accept"], &folder.path());
        let faults = &outcomes(&folder.path())[0].faults;
        assert_eq!(faults.first().map(|fault| fault.name.as_str()), name);
    }
    let excused = "source: s\ntitle: a source\nplaces:\n  - { place: here, what: all, excused: no reason }\n";
    let folder = source(&[("a.yaml", SHAFT.as_bytes()), ("index.yaml", excused.as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    assert_eq!(outcomes(&folder.path())[0].faults[0].name, "covered-excuse");
}

#[test]
fn an_accepted_bad_input_fails() {
    let bad = "case: shaft\ncite: here\ncalculation: gears.shaft\ngiven: { torque: 521.8 N·m, \
               allowable_stress: 20 MPa }\nexpect_error: not-positive\n";
    let folder = source(&[("a.yaml", bad.as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    assert_eq!(outcomes(&folder.path())[0].figures[0].status, Status::Failed);
    let refused = bad.replace("521.8 N·m", "0 N·m");
    let folder = source(&[("a.yaml", refused.as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    assert_eq!(outcomes(&folder.path())[0].figures[0].status, Status::Refused);
    let unexpected =
        refused.replace("expect_error: not-positive", "expect:\n  diameter: { published: 0 mm }");
    let folder = source(&[("a.yaml", unexpected.as_bytes())]);
    xtask(&["verify", "--accept"], &folder.path());
    assert_eq!(outcomes(&folder.path())[0].figures[0].status, Status::Failed);
}

/// Files of `tests/bad` have one fault each and are named after it.
#[test]
fn bad_cases_are_refused_by_name_at_their_place() {
    let mut files: Vec<PathBuf> = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/bad"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    let mut report = String::new();
    for file in files {
        let stem = file.file_stem().unwrap().to_string_lossy().into_owned();
        let folder = source(&[("case.yaml", fs::read(&file).unwrap().as_slice())]);
        let outcome = &outcomes(&folder.path())[0];
        let faults: Vec<_> = outcome
            .faults
            .iter()
            .filter(|fault| {
                !["missing-snapshot", "uncovered-place", "not-run"].contains(&fault.name.as_str())
            })
            .collect();
        let Some(fault) = faults.iter().find(|fault| stem.starts_with(&fault.name)) else {
            panic!("{stem}: {faults:?}, {:?}", outcome.figures);
        };
        let place = format!("{}:{}:{}", fault.file, fault.line, fault.column);
        report.push_str(&format!("{stem}\n  {place}: {}\n", fault.message));
        assert_eq!(xtask(&["verify"], &folder.path()).status.code(), Some(1), "{stem}");
    }
    insta::assert_snapshot!(report);
}

#[test]
fn nothing_to_run_is_an_error_of_its_own() {
    let missing = xtask(&["verify"], Path::new("no/such/folder"));
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8(missing.stderr).unwrap().contains("no/such/folder cannot be read"));
    let empty = tempfile::tempdir().unwrap();
    assert_eq!(xtask(&["verify"], empty.path()).status.code(), Some(2));
    let unmatched = xtask(&["verify", "no-such-case"], &real_cases());
    assert_eq!(unmatched.status.code(), Some(2));
    assert!(String::from_utf8(unmatched.stderr).unwrap().contains("excavator-dynamics"));
}

#[test]
fn reports_for_programs_hold_every_figure() {
    let outcomes = outcomes(&real_cases());
    let figures: usize = outcomes.iter().map(|outcome| outcome.figures.len()).sum();
    let json: serde_json::Value =
        serde_json::from_str(&xtask::report::json::render(&outcomes).unwrap()).unwrap();
    assert_eq!(json["holds"], true);
    let listed = json["sources"].as_array().unwrap().iter();
    assert_eq!(listed.map(|source| source["figures"].as_array().unwrap().len()).sum::<usize>(), figures);
    let junit = xtask::report::junit::render(&outcomes).unwrap();
    assert_eq!(junit.matches("<testcase ").count(), figures);
}

#[test]
fn a_new_case_starts_from_a_file_that_reads() {
    let folder = source(&[]);
    for calculation in xtask::calculations::all() {
        let name = calculation.name.replace(['.', '_'], "-");
        let made = xtask(&["new-case", calculation.name, "--source", "s", "--name", &name], &folder.path());
        assert_eq!(made.status.code(), Some(0), "{}", String::from_utf8_lossy(&made.stderr));
        let again = xtask(&["new-case", calculation.name, "--source", "s", "--name", &name], &folder.path());
        assert_eq!(again.status.code(), Some(2));
    }
    // The message names the place and the result to fill in, and everything can be read.
    let outcome = &outcomes(&folder.path())[0];
    for fault in &outcome.faults {
        let known = ["unknown-place", "missing-snapshot", "uncovered-place"];
        assert!(known.contains(&fault.name.as_str()), "{fault:?}");
    }
}

#[test]
fn the_page_has_every_figure_and_what_is_said_of_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pages/verification.html");
    let output = xtask(&["verify", "--html", file.to_str().unwrap()], &real_cases());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(String::from_utf8_lossy(&output.stdout).contains("\nverified: "));
    let page = fs::read_to_string(&file).unwrap();
    assert!(!page.contains("<script") && !page.contains("http"), "the page is whole in itself");
    let escaped = |text: &str| {
        text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
    };
    let (mut figures, mut arithmetic) = (0, 0);
    for outcome in outcomes(&real_cases()) {
        let section = page.split(&format!("<section id=\"{}\">", outcome.source)).nth(1).unwrap();
        let section = section.split("</section>").next().unwrap();
        assert_eq!(section.matches("<td class=\"verdict\">").count(), outcome.figures.len());
        figures += outcome.figures.len();
        for figure in &outcome.figures {
            for text in [&figure.published, &figure.computed, &figure.because, &figure.arithmetic]
                .into_iter()
                .flatten()
            {
                assert!(section.contains(&escaped(text)), "{}: {text}", figure.name);
            }
            arithmetic += usize::from(figure.arithmetic.is_some());
        }
        for place in outcome.coverage.iter().filter_map(|place| place.excused.as_ref()) {
            assert!(section.contains(&escaped(place)), "{place}");
        }
    }
    assert!(figures > 600 && arithmetic > 40, "{figures} {arithmetic}");
    assert_eq!(fs::read_dir(file.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn the_page_says_what_does_not_hold() {
    let folder = source(&[("a.yaml", SHAFT.replace("51.0", "51.9").as_bytes())]);
    let file = folder.path().with_file_name("page.html");
    let output = xtask(&["verify", "--html", file.to_str().unwrap()], &folder.path());
    assert_eq!(output.status.code(), Some(1));
    let page = fs::read_to_string(&file).unwrap();
    for said in ["Not verified", "does not hold", "51.9 mm", "Remedy: compare", "id=\"only-failed\""] {
        assert!(page.contains(said), "{said}");
    }
    // A folder in place of the file: nothing is written, and the error says so.
    let output = xtask(&["verify", "--html", folder.path().to_str().unwrap()], &folder.path());
    assert_eq!(output.status.code(), Some(2));
    assert!(words(&output.stderr).contains("cannot be written"));
}
