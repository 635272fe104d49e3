//! The command `report`: whole pages, and refusals.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

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

/// Checks the order of a page: the most important parts first, the input last, and nothing to be fetched.
fn is_in_order(page: &str) {
    let place = |part: &str| page.find(part).unwrap_or_else(|| unreachable!("{part}"));
    let (answer, contents) = (place("<section class=\"answer\">"), place("<nav aria-label=\"Contents\">"));
    assert!(place("<h1>") < answer && answer < contents);
    let told = page[answer..contents].contains("What to object to");
    assert!(told != page[answer..contents].contains("No warnings."), "one of both");
    let headings = sections(page);
    assert_eq!(headings.first(), Some(&"Contents"));
    assert_eq!(headings.last(), Some(&"Input"));
    assert!(page.ends_with("</html>\n") && place("<pre") > page.rfind("<h2").unwrap());
    // The contents lead to every chapter.
    for rest in page.split("<a href=\"#").skip(1) {
        let name = rest.split_once('"').unwrap().0;
        assert!(page.contains(&format!(" id=\"{name}\"")), "{name}");
    }
    assert_eq!(page.matches("<a href").count() + 1, headings.len());
    // Every picture says in words what it is, and has a caption.
    assert!(page.matches("<svg").count() > 0);
    for picture in page.split("<svg").skip(1) {
        let start = picture.split_once('>').unwrap().0;
        assert!(
            start.contains("role=\"img\"")
                && start.contains("aria-label=\"")
                && !start.contains("aria-label=\"\"")
        );
        let rest = picture.split_once("</svg>").unwrap().1;
        assert!(rest.trim_start().starts_with("<figcaption>"), "{start}");
    }
}

/// The size of the letters of each picture on paper, in points: its width there is `w`, at most a column or
/// the page.
fn letters_on_paper(page: &str) -> Vec<f64> {
    let number = |text: &str| text.parse::<f64>().unwrap();
    let after = |text: &str, name: &str| -> String {
        text.split_once(name).unwrap().1.split('"').next().unwrap().to_owned()
    };
    let mut sizes = vec![];
    for figure in page.split("<figure").skip(1) {
        let figure = figure.split_once("</figure>").unwrap().0;
        let width = number(&after(figure, "--w: "));
        let room = if figure.starts_with(" class=\"wide\"") { 186.0 } else { 90.5 };
        let of_page = width.min(room);
        let box_width = number(after(figure, "viewBox=\"").split(' ').nth(2).unwrap());
        let letters =
            figure.split("font-size=\"").skip(1).map(|rest| number(rest.split('"').next().unwrap()));
        let smallest = letters.reduce(f64::min).unwrap();
        sizes.push(smallest * of_page / box_width * 72.0 / 25.4);
    }
    sizes
}

#[test]
fn letters_in_pictures_are_not_smaller_than_8_points_on_paper() {
    let pages: [&[&str]; 11] = [
        &["scheme-ii-3.yaml"],
        &["ravigneaux.yaml"],
        &["wolfrom.yaml"],
        &["power-split.yaml"],
        &["sized-gearbox.yaml"],
        &["every-gearbox-key.yaml"],
        &["wind-stage.yaml"],
        &["xe215cll-drive.yaml"],
        &["motor-5x3.yaml"],
        &["real-transmissions.yaml", "--transmission", "8HP"],
        &["real-transmissions.yaml", "--transmission", "TH400"],
    ];
    for arguments in pages {
        let page = page(arguments);
        is_sound(&page);
        is_in_order(&page);
        // A width is a whole number of millimetres.
        let small: Vec<f64> = letters_on_paper(&page).into_iter().filter(|size| *size < 7.95).collect();
        assert_eq!(small, [0.0; 0], "{arguments:?}");
    }
}

#[test]
fn the_page_of_a_drive_has_its_results_drawing_and_plots() {
    let page = page(&["xe215cll-drive.yaml"]);
    is_sound(&page);
    assert_eq!(
        sections(&page),
        ["Contents", "Results and checks", "Plots", "What is left out", "Sources", "Input"]
    );
    assert!(page.contains("106.5 kW") && page.contains("<h1>Travel drive of the XE215CLL</h1>"));
    assert_eq!(page.matches("<svg").count(), 3);
    assert!(page.contains("too thin"), "warnings are part of it");
}

#[test]
fn a_drive_and_a_motor_are_a_page_in_a_file_that_ends_in_html() {
    let folder = here();
    let file = examples().join("xe215cll-drive.yaml");
    let file = file.to_str().unwrap();
    let done = output(folder.path(), &["drive", file, "-o", "drive.html"]);
    assert!(done.status.success() && text(&done.stderr).contains("too thin"), "{done:?}");
    let same = output(folder.path(), &["report", file, "-o", "report.html"]);
    assert!(same.status.success());
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(read("drive.html"), read("report.html"));
    let line = "motor --stator 5 --rotor 3 --z3 55 --zs 10 --module 2mm --svg motor.svg -o motor.html";
    let line: Vec<&str> = line.split(' ').collect();
    assert!(output(folder.path(), &line).status.success());
    let page = read("motor.html");
    is_sound(&page);
    is_in_order(&page);
    assert!(page.contains("<pre>epicyclic motor --stator 5") && !page.contains("motor.html"));
    assert!(read("motor.svg").contains("<svg"));
}

#[test]
fn the_page_of_a_choice_has_the_best_and_its_scheme_first() {
    let folder = here();
    for (name, line) in [
        ("three.html", &["select", "--speeds", "0.76 m/s, 1.33 m/s, 1.95 m/s", "--all-structures"][..]),
        ("two.html", &["select", "--speeds", "0.8 m/s, 3.15 m/s"]),
        ("teeth.html", &["select", "--ratios", "1.465, 2.56", "--teeth", "--ring", "50..60", "--limit", "2"]),
    ] {
        let done = output(folder.path(), &[line, &["-o", name]].concat());
        assert!(done.status.success() && done.stdout.is_empty(), "{done:?}");
        let page = fs::read_to_string(folder.path().join(name)).unwrap();
        is_sound(&page);
        is_in_order(&page);
        assert_eq!(page.matches("<svg").count(), 1);
        let first = page.split_once("<nav").unwrap().0;
        assert!(
            first.contains("Kinematic scheme, the half above") && first.contains("<td>direct</td>"),
            "{name}"
        );
    }
    let none = output(folder.path(), &["select", "--ratios", "90", "-o", "none.html"]);
    assert_eq!(none.status.code(), Some(1));
    let page = fs::read_to_string(folder.path().join("none.html")).unwrap();
    is_sound(&page);
    assert!(page.contains("<h1>No gearbox meets every required criterion</h1>"));
}

#[test]
fn a_page_says_for_whom_it_is_only_where_that_is_given() {
    let given = page(&[
        "minimal-drive.yaml",
        "--project",
        "Winch <7>",
        "--customer",
        "Mine North",
        "--author",
        "A. Engineer",
        "--date",
        "22 November 2026",
        "--paper",
        "a4",
    ]);
    is_sound(&given);
    for part in [
        "<dd>Winch &lt;7&gt;</dd>",
        "<dd>Mine North</dd>",
        "<dd>A. Engineer</dd>",
        "<dd>22 November 2026</dd>",
    ] {
        assert!(given.contains(part), "{part}");
    }
    assert!(given.contains("size: A4;") && given.contains("Winch \\3c 7\\3e "));
    let plain = page(&["minimal-drive.yaml"]);
    assert!(!plain.contains("<dl") && plain.contains("@page { @bottom-left"));
    assert_eq!(plain, page(&["minimal-drive.yaml"]), "the same input gives the same page");
}

#[test]
fn the_page_of_a_gearbox_has_each_gear() {
    let page = page(&["scheme-ii-3.yaml", "--torque", "500 N·m", "--speed", "1475 rpm"]);
    is_sound(&page);
    let sections = sections(&page);
    assert_eq!(
        sections,
        [
            "Contents",
            "All gears",
            "Shifts",
            "Figures of every gear",
            "Review by rules of practice",
            "Losses at the operating point",
            "Power flow of the gears",
            "Speeds of the gears",
            "Another k",
            "What is left out",
            "Sources",
            "Input"
        ]
    );
    for gear in ["Gear slow: K", "Gear middle: K", "Gear fast: L"] {
        let captions = page.matches(&format!("<figcaption>{gear}")).count();
        assert_eq!(captions, 2, "{gear}: the power flow and the speed diagram");
    }
    assert!(page.contains("-1240.9"), "the torque at the output");
    let first = page.split_once("<nav").unwrap().0;
    assert!(first.contains("Kinematic scheme") && first.contains("-1240.9") && first.contains("No warnings"));
    assert!(first.contains("Planetary gearbox: 3 ratios, 2 planet sets, 3 shift elements"), "what it is");
    assert!(first.contains("At the input: 1475 rpm, 500 N·m."), "at which point");
    // The scheme and the levers, the ladder, scheme and speed plan of each gear, and the plots of two rows.
    assert_eq!(page.matches("<svg").count(), 3 + 2 * 3 + 6);
    // A note once for the tables of all gears together.
    assert_eq!(page.matches("Slip: speed of the first link less that of the second").count(), 1);
}

/// At the operating point and over the duty: what governs on the first page, then the safeties and one table
/// of factors for the set.
#[test]
fn the_page_of_a_gearbox_with_data_for_it_has_the_strength_of_its_teeth() {
    let page = page(&["wind-stage.yaml", "--torque", "999.650881 kN·m", "--speed", "47.8 rpm"]);
    is_sound(&page);
    is_in_order(&page);
    let (first, chapters) = page.split_once("<nav").unwrap();
    assert!(first.contains("Strength of teeth: S_H = 1.209 of the sun's flank"), "what is enough");
    let objection = "S_F = 1.310 of the planet's root (set stage, mesh sun-planet, over the duty) is below the 1.5 required; one more";
    assert!(first.contains(objection), "what is not");
    let chapter = |heading: &str| {
        let of = chapters.split_once(&format!("{heading}</h2>")).unwrap().1.split_once("<h2").unwrap().0;
        for table in ["Load and requirements", "sun-planet", "Factors of set stage", "planet at ring"] {
            assert!(of.contains(table), "{heading}: {table}");
        }
        of
    };
    let at_point = chapter("Strength of teeth at the operating point");
    assert!(at_point.contains("2.817") && at_point.contains("Y_NT"), "the root of the sun");
    let over_duty = chapter("Strength of teeth over the duty");
    assert!(over_duty.contains("29.8 %") && over_duty.contains("0.9577 to 0.9607"));
    assert!(!over_duty.contains("Y_NT</td>"), "Miner's rule has no one life factor");
    assert!(chapters.contains("scuffing") && !chapters.contains("Profile shift and strength of teeth"));
}

/// The chapter has what `losses` prints, and what is left out says that drags are counted.
#[test]
fn the_page_of_a_gearbox_that_loses_power_has_its_losses() {
    let load = ["--torque", "60 N·m", "--speed", "1475 rpm"];
    let shown = page(&[&["drags.yaml"][..], &load].concat());
    is_sound(&shown);
    is_in_order(&shown);
    let chapter =
        shown.split_once("Losses at the operating point</h2>").unwrap().1.split_once("<h2").unwrap().0;
    let told = output(&examples(), &[&["losses", "drags.yaml", "--format", "json"][..], &load].concat());
    let told: serde_json::Value = serde_json::from_slice(&told.stdout).unwrap();
    let sources = told["losses"].as_array().unwrap();
    assert!(sources.len() > 8);
    for source in sources {
        assert!(chapter.contains(&format!("<td>{}</td>", source["of"].as_str().unwrap())), "{source}");
    }
    for gear in told["gears"].as_array().unwrap() {
        let efficiency = format!("{:.4}", gear["efficiency"].as_f64().unwrap());
        assert!(chapter.contains(&efficiency), "{efficiency} in {chapter}");
    }
    assert!(shown.contains("but for the drags that the file states"));
    for without in [&["drags.yaml"][..], &[&["lepelletier.yaml"][..], &load].concat()] {
        assert!(!page(without).contains("Losses at the operating point"), "{without:?}");
    }
}

#[test]
fn a_set_without_data_for_its_strength_is_named_on_the_page() {
    let folder = here();
    let wind = fs::read_to_string(examples().join("wind-stage.yaml")).unwrap();
    fs::write(folder.path().join("narrow.yaml"), wind.replace("    face_width: 550 mm\n", "")).unwrap();
    let done = output(folder.path(), &["report", "narrow.yaml", "-o", "page.html"]);
    assert!(done.status.success(), "{done:?}");
    let page = fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(page.split_once("<nav").unwrap().0.contains("the strength of no set can be rated"));
    assert!(page.contains("<td>face_width missing</td>") && page.contains("No set can be rated."));
    let wrong = wind.replace("share: 50 %", "share: 60 %");
    fs::write(folder.path().join("wrong.yaml"), wrong).unwrap();
    let refused = output(folder.path(), &["report", "wrong.yaml", "-o", "wrong.html"]);
    assert!(!refused.status.success() && !folder.path().join("wrong.html").exists());
    assert!(text(&refused.stderr).contains("the shares of the duty sum to 1.1"), "{refused:?}");
}

/// A planet that is not said to fit has not been looked at, and the page says why.
#[test]
fn the_first_page_has_the_sets_and_whether_their_planets_fit() {
    let first = |arguments: &[&str]| page(arguments).split_once("<nav").unwrap().0.to_owned();
    let known = first(&["ravigneaux.yaml"]);
    assert!(
        known.contains("sun large_sun 36, sun small_sun 30, ring 72") && known.contains("assemble, clear")
    );
    let unknown = first(&["real-transmissions.yaml", "--transmission", "8HP"]);
    assert!(unknown.contains("sun 48, ring 96, planet 24") && !unknown.contains("assemble, clear"));
    assert!(unknown.contains("not checked (all sets): the number of planets is not given"));
    let folder = here();
    let file = "gearbox: seven of 84\nsets:\n  - { id: P, sun: a, ring: b, carrier: c, teeth: [24, 60], planets: 7 }\n\
                input: a\noutput: c\nbrakes: [{ id: B, link: b }]\ngears: [{ name: '1', engaged: [B] }]\n";
    fs::write(folder.path().join("seven.yaml"), file).unwrap();
    let told = output(folder.path(), &["analyze", "seven.yaml"]);
    let told = text(&told.stdout);
    assert!(told.contains("sun 24, ring 60") && told.contains("7  assemble, do not clear"), "{told}");
    assert!(told.contains("neighbours among 7 planets"), "{told}");
}

/// Table with a column for each gear with torques, and each figure once.
#[test]
fn the_figures_of_every_gear_stand_side_by_side() {
    let page = page(&["real-transmissions.yaml", "--transmission", "8HP", "--efficiency", "97%"]);
    let figures = page.split_once("Figures of every gear</h2>").unwrap().1.split_once("<h2").unwrap().0;
    for title in [
        "Speed of the links over the input",
        "Torque on the members of the sets",
        "The part of it that circulates",
    ] {
        assert_eq!(figures.matches(title).count(), 1, "{title}");
    }
    let table = figures.split_once("Speed of the links").unwrap().1.split_once("</table>").unwrap().0;
    let gears: Vec<&str> =
        table.split("<th class=\"number\">").skip(1).filter_map(|rest| rest.split('<').next()).collect();
    assert_eq!(gears, ["1", "2", "3", "4", "5", "6", "7", "8", "R"]);
    // 4.7143: the input turns so much faster than the output, which is 0.2121 of it in the first gear.
    let output = table.split("<td>n_out</td>").nth(1).unwrap();
    let speeds: Vec<&str> =
        output.split("<td class=\"number\">").skip(1).filter_map(|rest| rest.split('<').next()).collect();
    assert_eq!((speeds[0], speeds[8]), ("0.2121", "-0.3035"));
}

/// A design at the end of the usual range of `k`, or beyond it, is still on its curves.
#[test]
fn what_the_first_page_objects_to_is_not_said_again_with_every_gear() {
    let page = page(&["real-transmissions.yaml", "--transmission", "Prius"]);
    let (first, chapters) = page.split_once("<nav").unwrap();
    let objection = "equal centre distances need shifted profiles";
    assert_eq!((first.matches(objection).count(), chapters.matches(objection).count()), (1, 0));
    assert!(!chapters.contains("<h3>Warnings</h3>"), "nor an empty list");
}

#[test]
fn plots_over_k_reach_around_the_design_and_mark_it() {
    for k in ["5", "1.4", "9"] {
        let folder = here();
        let done = output(folder.path(), &["report", "I", "--k1", k, "-o", "page.html"]);
        assert!(done.status.success(), "{done:?}");
        let page = fs::read_to_string(folder.path().join("page.html")).unwrap();
        let plots: Vec<&str> =
            page.split("<figure").skip(1).filter(|one| one.contains("over k of set")).collect();
        assert!(!plots.is_empty());
        for plot in plots {
            // The line across the field, and its sample in the legend.
            assert_eq!(plot.matches("class=\"layer-marks\"").count(), 2, "k {k}");
            assert!(plot.contains("<circle"), "k {k}: a dot on a curve");
        }
    }
}

#[test]
fn the_page_of_a_motor_has_drawings_results_and_plots() {
    let page = page(&["motor-5x3.yaml"]);
    is_sound(&page);
    assert_eq!(sections(&page), ["Contents", "Drawings", "Results and checks", "Plots", "Sources", "Input"]);
    assert!(page.contains("<h1>Motor 5×3</h1>") && page.contains("Flow, ripple 7.64 %"));
    assert_eq!(page.matches("<svg").count(), 7);
}

#[test]
fn one_of_several_transmissions_is_named() {
    let page = page(&["real-transmissions.yaml", "--transmission", "8HP", "--efficiency", "97%"]);
    is_sound(&page);
    assert!(page.contains("346/105"));
    let input = page.split_once("<pre").unwrap().1;
    assert!(input.contains("8HP") && !input.contains("TH400"), "its own lines of the list");
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
    is_in_order(&page);
    let headings =
        ["Contents", "Search and solutions", "Families", "Schemes of the first", "What is left out", "Input"];
    assert_eq!(sections(&page), headings);
    assert_eq!(page.matches("<svg").count(), 4);
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
    is_in_order(&page);
    assert_eq!(sections(&page), ["Contents", "II-3", "III-1", "What is left out", "Input"]);
    assert_eq!(page.matches("<svg").count(), 2);
}

#[test]
fn the_page_of_a_gearbox_has_its_shifts() {
    let page = page(&["ravigneaux.yaml"]);
    is_sound(&page);
    assert!(sections(&page).contains(&"Shifts"));
    assert!(page.contains("Change of slip of the shift elements") && page.contains("<td>(F1)</td>"));
}

/// Chapters so far as the file says enough: with a load below that of the parting flanks the first sheet
/// objects.
#[test]
fn a_gearbox_with_vibration_has_chapters_of_it() {
    let of = |more: &[&str]| page(&[&["two-stages.yaml"], more].concat());
    let chapters = ["natural frequencies", "modes", "resonances", "forces by the transmission error"];
    let chapters = chapters.map(|chapter| format!("Vibration: {chapter}"));
    let plain = of(&[]);
    is_sound(&plain);
    is_in_order(&plain);
    let own = |page: &str| -> Vec<String> {
        let all = sections(page).into_iter().filter(|heading| heading.starts_with("Vibration"));
        all.map(str::to_owned).collect()
    };
    assert_eq!(own(&plain), chapters);
    assert!(plain.contains("Vibration: the transmission error makes at most"));
    assert!(!plain.contains("Coupled frequencies") && of(&["--coupled"]).contains("Coupled frequencies"));
    let parts = "the flanks of the";
    let loaded = |torque| of(&["--torque", torque, "--speed", "1475 rpm"]).contains(parts);
    assert!(!plain.contains(parts) && loaded("1 N·m") && !loaded("500 N·m"));
    // Without the keys of excitation as far as the modes.
    assert_eq!(own(&page(&["vibration.yaml"])), chapters[..2]);
    assert_eq!(own(&page(&["scheme-ii-3.yaml"])), [""; 0]);
}
