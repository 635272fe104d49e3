//! Positions, paths and names of errors, for every way a document may be wrong.

use std::collections::BTreeMap;

use proptest::prelude::*;
use serde::Deserialize;
use uom::si::f64::{Length, Power, Torque};

use super::*;
use epicyclic_units::{Number, Quantity};

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)] // read, and looked at only by Debug
struct Case {
    given: Given,
    #[serde(default)]
    expect: BTreeMap<String, Expected>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)] // as above
struct Given {
    power: Quantity<Power>,
    ratio: Option<Number>,
    teeth: Option<u32>,
    #[serde(default)]
    shafts: Vec<Shaft>,
    scheme: Option<Scheme>,
    arms: Option<[f64; 2]>,
    name: Option<String>,
    wheels: Option<BTreeMap<u8, Quantity<Length>>>,
    odd: Option<Odd>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)] // as above
struct Shaft {
    torque: Quantity<Torque>,
    inertia_kg_m2: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)] // as above
struct Expected {
    published: String,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
#[allow(dead_code)] // as above
enum Scheme {
    I,
    Custom { teeth: Vec<u32> },
}

#[derive(Debug, Deserialize)]
#[serde(try_from = "u32")]
#[allow(dead_code)] // as above
struct Odd(u32);

impl TryFrom<u32> for Odd {
    type Error = String;

    fn try_from(value: u32) -> Result<Self, String> {
        if value % 2 == 1 { Ok(Self(value)) } else { Err(format!("{value} is even; write an odd number")) }
    }
}

fn read(text: &str) -> Result<Case, Error> {
    Document::parse_one("c.yaml", text.as_bytes())?.read()
}

/// The error of a text, as `name | message`.
fn refused(text: &str) -> String {
    let error = read(text).unwrap_err();
    format!("{} | {error}", error.name())
}

fn check(cases: &[(&str, &str)]) {
    for (text, message) in cases {
        assert_eq!(refused(text), *message, "{text}");
    }
}

#[test]
fn a_right_case_is_read() {
    let case = read(
        "given:\n  power: 106.5 kW\n  ratio: 3\n  teeth: 18\n  shafts: [{torque: 520 N m, inertia_kg_m2: 1}]\n  scheme: \
         i\n  arms: [1, 2.5]\n  name: x\n  wheels: {7: 8 mm}\n  odd: 3\nexpect:\n  speeds.g1: {published: \"0.515\"}\n",
    )
    .unwrap();
    assert_eq!(case.given.power.to_string(), "106.5 kW");
    assert_eq!(case.given.ratio, Number::new(3.0).ok());
    assert_eq!(case.expect["speeds.g1"].published, "0.515");
    read("given: {power: 1 W, scheme: {custom: {teeth: [18, 72]}}}").unwrap();
}

#[test]
fn a_bare_number_gets_the_unit_that_engineers_use_of_its_key() {
    for (text, corrected) in [("life: 8000", "8000 h"), ("life: 20'000", "20000 h"), ("pause: 5", "5 s")] {
        let document = Document::parse_one("c.yaml", text.as_bytes()).unwrap();
        let read = document.read::<BTreeMap<String, Quantity<uom::si::f64::Time>>>();
        assert!(read.unwrap_err().to_string().contains(&format!("; write {corrected}")), "{text}");
    }
}

#[test]
fn quantity_errors_keep_their_name_and_place() {
    check(&[
        (
            "given:\n  power: 106,5 kW\n",
            "decimal-comma | c.yaml:2:10: given.power: 106,5 kW: decimal comma; write 106.5 kW",
        ),
        (
            "given:\n  power: 75\n",
            "missing-unit | c.yaml:2:10: given.power: 75: no unit; write 75 kW, or another unit of power (kW, mW, W, MW, PS, hp(I))",
        ),
        (
            "given: {power: 75 KW}",
            "unknown-unit | c.yaml:1:16: given.power: 75 KW: unknown unit KW; write 75 kW? (units of power: kW, mW, W, MW, PS, hp(I))",
        ),
        (
            "given:\n  power: 1 W\n  shafts:\n  - torque: 1 N·m\n  - torque: 5 J\n",
            "wrong-dimension | c.yaml:5:13: given.shafts[1].torque: 5 J: J is a unit of energy, and a torque is due; its units are N·m, mN·m, N·mm, N·cm, kN·m, MN·m, kgf·m, lbf·ft, lbf·in",
        ),
        (
            "given:\n  power: 1 W\n  wheels:\n    7: 8,5 mm\n",
            "decimal-comma | c.yaml:4:8: given.wheels.7: 8,5 mm: decimal comma; write 8.5 mm",
        ),
        (
            "given: {power: [1]}",
            "wrong-type | c.yaml:1:16: given.power: a sequence where a power with its unit, such as 12.5 kW is due",
        ),
        (
            "given:\n  power:\n",
            "wrong-type | c.yaml:2:3: given.power: nothing where a power with its unit, such as 12.5 kW is due",
        ),
    ]);
}

/// In braces and brackets a comma parts: `31,5 kg` is a value of 31 and a key `5 kg` without a value.
#[test]
fn a_decimal_comma_in_braces_is_recognised() {
    check(&[
        (
            "given: {power: 31,5 kW, ratio: 2}",
            "decimal-comma | c.yaml:1:16: given.power: 31,5 kW: decimal comma; write 31.5 kW",
        ),
        (
            "given: {power: 31,5 кВт}",
            "decimal-comma | c.yaml:1:16: given.power: 31,5 кВт: decimal comma; write 31.5 kW",
        ),
        (
            "given: {power: 1 W, ratio: 3,94}",
            "decimal-comma | c.yaml:1:28: given.ratio: 3,94: decimal comma; write 3.94",
        ),
        (
            "given: {power: 1 W, shafts: [{inertia_kg_m2: 0,00818, torque: 1 Nm}]}",
            "decimal-comma | c.yaml:1:46: given.shafts[0].inertia_kg_m2: 0,00818: decimal comma; write 0.00818",
        ),
    ]);
}

#[test]
fn a_decimal_comma_is_recognised_in_every_number() {
    check(&[
        (
            "given: {power: 1 W, ratio: \"3,94\"}",
            "decimal-comma | c.yaml:1:28: given.ratio: 3,94: decimal comma; write 3.94",
        ),
        (
            "given:\n  power: 1 W\n  ratio: 3,94",
            "decimal-comma | c.yaml:3:10: given.ratio: 3,94: decimal comma; write 3.94",
        ),
        (
            "given:\n  power: 1 W\n  teeth: 18,0",
            "decimal-comma | c.yaml:3:10: given.teeth: 18,0: decimal comma; write 18.0",
        ),
        (
            "given:\n  power: 1 W\n  arms:\n  - 1\n  - 2,5",
            "decimal-comma | c.yaml:5:5: given.arms[1]: 2,5: decimal comma; write 2.5",
        ),
        (
            "given:\n  power: 1 W\n  shafts:\n  - torque: 1 Nm\n    inertia_kg_m2: 0,5\n",
            "decimal-comma | c.yaml:5:20: given.shafts[0].inertia_kg_m2: 0,5: decimal comma; write 0.5",
        ),
        (
            "given:\n  power: 1 W\n  ratio: 3 mm",
            "unexpected-unit | c.yaml:3:10: given.ratio: 3 mm: a plain number is due here, without a unit; write 3",
        ),
        (
            "given:\n  power: 1 W\n  ratio: 1e999",
            "not-finite | c.yaml:3:10: given.ratio: 1e999: not a finite number; write one such as 3.94",
        ),
    ]);
}

#[test]
fn keys_and_names_are_checked() {
    check(&[
        (
            "given:\n  power: 1 W\n  tooth: 3\n",
            "unknown-key | c.yaml:3:3: given.tooth: unknown key tooth; write teeth?; allowed: power, ratio, teeth, shafts, scheme, arms, name, wheels, odd",
        ),
        (
            "given: {power: 1 W}\nexpect:\n  \"speeds.g1\": {publish: '1'}\n",
            "unknown-key | c.yaml:3:17: expect[\"speeds.g1\"].publish: unknown key publish; write published?; allowed: published",
        ),
        ("given:\n  ratio: 1\n", "missing-key | c.yaml:2:3: given: the key power is missing"),
        ("expect: {}", "missing-key | c.yaml:1:1: the key given is missing"),
        (
            "given: {power: 1 W, shafts: [{inertia_kg_m2: 1}]}",
            "missing-key | c.yaml:1:30: given.shafts[0]: the key torque is missing",
        ),
        (
            "given: {power: 1 W, scheme: ii}",
            "unknown-name | c.yaml:1:29: given.scheme: unknown name ii; write i?; allowed: i, custom",
        ),
        (
            "given: {power: 1 W, scheme: {custm: {}}}",
            "unknown-name | c.yaml:1:30: given.scheme.custm: unknown name custm; write custom?; allowed: i, custom",
        ),
        (
            "given: {power: 1 W, scheme: {custom: {teeth: [18, x]}}}",
            "wrong-type | c.yaml:1:51: given.scheme.custom.teeth[1]: the text \"x\" where a whole number from 0 to 4294967295 is due",
        ),
        (
            "given:\n  power: 1 W\n  ratio: 1\n  power: 2 W\n",
            "duplicate-key | c.yaml:4:3: given.power: the key power is written twice, first at 2:3; remove one",
        ),
        (
            "given: {power: 1 W, shafts: [{torque: 1 Nm, \"torque\": 1 Nm}]}",
            "duplicate-key | c.yaml:1:45: given.shafts[0].torque: the key torque is written twice, first at 1:31; remove one",
        ),
    ]);
}

#[test]
fn a_share_is_read_wherever_a_number_is() {
    for (share, value) in [("5 %", 0.05), ("5%", 0.05), ("'97.5 %'", 0.975), ("-2 ‰", -0.002)] {
        let text = format!(
            "given: {{ power: 1 kW, ratio: {share}, arms: [{share}, 1], shafts: [{{ torque: 1 N·m, inertia_kg_m2: {share} }}] }}"
        );
        let given = read(&text).unwrap().given;
        let read =
            [given.ratio.unwrap().get(), given.arms.unwrap()[0], given.shafts[0].inertia_kg_m2.unwrap()];
        assert!(read.iter().all(|read| (read - value).abs() < 1e-15), "{share}: {read:?}");
    }
    check(&[
        (
            "given: { power: 1 kW, teeth: 50 % }",
            "wrong-type | c.yaml:1:30: given.teeth: the number 0.5 where a whole number from 0 to 4294967295 is due",
        ),
        (
            "given: { power: 1 kW, ratio: '0,5 %' }",
            "decimal-comma | c.yaml:1:30: given.ratio: 0,5 %: decimal comma; write 0.5 %",
        ),
    ]);
}

#[test]
fn wrong_types_are_told_in_plain_words() {
    check(&[
        ("given: 3", "wrong-type | c.yaml:1:8: given: the number 3 where a map is due"),
        ("given: [1 W]", "wrong-type | c.yaml:1:8: given: a sequence where a map is due"),
        (
            "given: {power: 1 W, teeth: 3.5}",
            "wrong-type | c.yaml:1:28: given.teeth: the number 3.5 where a whole number from 0 to 4294967295 is due",
        ),
        (
            "given: {power: 1 W, teeth: -3}",
            "out-of-range | c.yaml:1:28: given.teeth: the number -3 where a whole number from 0 to 4294967295 is due",
        ),
        (
            "given: {power: 1 W, teeth: '18'}",
            "wrong-type | c.yaml:1:28: given.teeth: the text \"18\" where a whole number from 0 to 4294967295 is due; write 18",
        ),
        (
            "given: {power: 1 W, name: 2.94}",
            "wrong-type | c.yaml:1:27: given.name: the number 2.94 where text is due; write \"2.94\", in quotes",
        ),
        (
            "given: {power: 1 W, shafts: }",
            "wrong-type | c.yaml:1:21: given.shafts: nothing where a sequence is due; write [] for an empty one",
        ),
        (
            "given: {power: 1 W, arms: [1, 2, 3]}",
            "wrong-length | c.yaml:1:27: given.arms: 3 entries where exactly 2 are due",
        ),
        (
            "given: {power: 1 W, arms: [1]}",
            "wrong-length | c.yaml:1:27: given.arms: 1 entries where exactly 2 are due",
        ),
        (
            "given: {power: 1 W, odd: 4}",
            "invalid-value | c.yaml:1:26: given.odd: 4 is even; write an odd number",
        ),
        (
            "given: {power: 1 W, scheme: [i]}",
            "wrong-type | c.yaml:1:29: given.scheme: a sequence where a name, or a map with one name as its key is due",
        ),
    ]);
}

#[test]
fn what_hides_values_is_refused() {
    check(&[
        (
            "given: &a {power: 1 W}",
            "anchor | c.yaml:1:8: given: anchors and aliases are not understood; write the value itself",
        ),
        (
            "given: {power: !kw 1}",
            "tag | c.yaml:1:16: given.power: the tag !kw is not understood; remove it, and put the value in quotes if it is to stay text",
        ),
        (
            "given: !!map {}",
            "tag | c.yaml:1:8: given: the tag !!map is not understood; remove it, and put the value in quotes if it is to stay text",
        ),
        (
            "given:\n  <<: {power: 1 W}",
            "merge-key | c.yaml:2:3: given: merge keys (`<<`) are not understood; write the keys themselves",
        ),
        (
            "given: {ratio: .nan}",
            "not-finite | c.yaml:1:16: given.ratio: .nan: not a finite number; write one such as 3.94",
        ),
        (
            "given: {arms: [1, -.INF]}",
            "not-finite | c.yaml:1:19: given.arms[1]: -.inf: not a finite number; write one such as 3.94",
        ),
        ("? [a]\n: 1\n", "complex-key | c.yaml:1:3: a key must be plain text, not a map or a sequence"),
    ]);
    let deep = "[".repeat(200);
    assert!(refused(&deep).starts_with("too-deep | c.yaml:1:101: [0][0]"));
}

#[test]
fn a_file_that_is_no_document_is_named() {
    check(&[
        ("", "empty-file | c.yaml:1:1: the file is empty; write a document in it"),
        ("# only this\n\n", "empty-file | c.yaml:1:1: the file is empty; write a document in it"),
        ("---\n", "empty-file | c.yaml:1:1: the file is empty; write a document in it"),
        (
            "a: 1\n---\n---\nb: 1\n",
            "empty-document | c.yaml:3:1: the document is empty; remove its `---` or write the document",
        ),
        (
            "a: 1\n---\nb: 1\n",
            "several-documents | c.yaml:3:1: the file has 2 documents, and one is due; remove this one and those after it",
        ),
        ("a: 1\nb: [1\nc: 2\n", "syntax | c.yaml:3:2: b[0]: not YAML: illegal placement of ':' indicator"),
        (
            "a: 99999999999999999999\n",
            "syntax | c.yaml:1:4: a: not YAML: a whole number of more than 64 bits; write it with a decimal point",
        ),
        ("a: b: c\n", "syntax | c.yaml:1:5: not YAML: mapping values are not allowed in this context"),
        ("é: 1\nb: \u{7}\n", "control-character | c.yaml:2:4: an invisible character, U+0007; remove it"),
    ]);
    let error = Document::parse_all("c.yaml", b"\xef\xbb\xbfa: 1\n\xc3\xa9: \xff\n").unwrap_err();
    assert_eq!(error.to_string(), "c.yaml:2:4: not UTF-8 text (byte 12 of the file); save the file as UTF-8");
}

#[test]
fn columns_count_characters_in_any_kind_of_file() {
    for (text, place) in [
        ("\u{feff}given: {power: 1,5 kW}", "c.yaml:1:16: "),
        ("given:\r\n  power: 1,5 kW\r\n", "c.yaml:2:10: "),
        ("given: {\"name\": \"ωé漢😀\", power: 1.5 KW}", "c.yaml:1:32: "),
        ("# ω\n\ngiven:\n\n  # é\n  power:   '1,5 kW'\n", "c.yaml:6:12: "),
        ("given:\n  power: |\n    1,5 kW\n", "c.yaml:3:5: "),
    ] {
        let error = read(text).unwrap_err().to_string();
        assert!(error.starts_with(&format!("{place}given.power: ")), "{error}");
    }
}

#[test]
fn every_document_of_a_file_has_its_own_positions() {
    let text = b"given: {power: 1 W}\n---\ngiven: {power: 2 W}\n---\n# third\ngiven:\n  power: 3\n";
    let documents = Document::parse_all("c.yaml", text).unwrap();
    assert_eq!(documents.len(), 3);
    assert!(documents[1].read::<Case>().is_ok());
    let error = documents[2].read::<Case>().unwrap_err();
    assert_eq!((error.at().position, error.name()), (Position { line: 7, column: 10 }, "missing-unit"));
}

#[test]
fn a_path_has_a_position_or_its_ancestor_has() {
    let text = b"given:\n  shafts:\n  - torque: 2.940 N m\n    \"a.b\": {c: [2, 3]}\n  ratio: 2.940\n";
    let document = Document::parse_one("c.yaml", text).unwrap();
    let shaft = || Path::root().key("given").key("shafts").index(0);
    let at = |path: &Path| (document.position(path).to_string(), document.key_position(path).to_string());
    assert_eq!(at(&Path::root()), ("1:1".into(), "1:1".into()));
    assert_eq!(at(&Path::root().key("given")), ("2:3".into(), "1:1".into()));
    assert_eq!(at(&shaft()), ("3:5".into(), "3:5".into()));
    assert_eq!(at(&shaft().key("torque")), ("3:13".into(), "3:5".into()));
    assert_eq!(at(&shaft().key("a.b").key("c").index(1)), ("4:20".into(), "4:20".into()));
    assert_eq!(at(&shaft().key("a.b").key("no").index(1)), ("4:12".into(), "4:12".into()));
    assert_eq!(document.text_at(&Path::root().key("given").key("ratio")), Some("2.940"));
}

#[test]
fn a_part_is_read_with_the_positions_of_the_whole() {
    let document =
        Document::parse_one("c.yaml", b"given:\n  power: {from: other}\n  shafts: [{torque: 1 Nm}]\n")
            .unwrap();
    let given = Path::root().key("given");
    let shaft: Shaft = document.read_at(&given.clone().key("shafts").index(0)).unwrap();
    assert_eq!(shaft.torque.to_string(), "1 N·m");
    let error = document.read_at::<Shaft>(&given.clone().key("shafts").index(3).key("x")).unwrap_err();
    assert_eq!(error.to_string(), "c.yaml:3:11: given.shafts: the key [3] is missing");

    let mut value = document.value_at(&given).unwrap().clone();
    value["power"] = Value::from("75 kW");
    assert!(document.read_value::<Given>(&value, &given).is_ok());
    value["power"] = Value::from(75);
    value["added"] = Value::from(1);
    let error = document.read_value::<Given>(&value, &given).unwrap_err();
    let faults: Vec<_> =
        error.faults().map(|fault| format!("{} {}", fault.at, fault.problem.name())).collect();
    assert_eq!(faults, ["c.yaml:2:3: given.added unknown-key", "c.yaml:2:10: given.power missing-unit"]);
    value["power"] = Value::from("75 kW");
    let error = document.read_value::<Given>(&value, &given).unwrap_err();
    assert_eq!((error.name(), error.at().to_string().as_str()), ("unknown-key", "c.yaml:2:3: given.added"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = Document::parse_all("c.yaml", &bytes);
    }

    #[test]
    fn no_text_makes_it_panic_and_a_refusal_has_a_reason(
        parts in prop::collection::vec(prop::sample::select(vec![
            "a", "b", "given", "power", "1 kW", ": ", ":", "\n", "\n  ", "\n    ", "\r\n", "- ", "[", "]", "{", "}", ", ", "\"",
            "'", "|\n", ">-\n", "# c", "---\n", "...\n", "&x ", "*x", "!t ", "<<", "? ", "%YAML 1.2\n", "\t", " ", "é",
            "\u{feff}", "\u{85}", "\u{0}", ".nan", "1e999", "0x10", "3,94", "~", "null", "true", "\\", "@", "`",
        ]), 0..40),
    ) {
        let text = parts.concat();
        match Document::parse_all("c.yaml", text.as_bytes()) {
            Ok(documents) => {
                for document in documents {
                    let _ = document.read::<Case>();
                    let _ = document.read::<Value>();
                }
            }
            Err(error) => {
                prop_assert!(!error.to_string().is_empty() && error.at().position >= Position::START);
                let lines = text.split(['\n', '\r', '\u{85}']).count();
                prop_assert!(error.at().position.line <= lines + 1);
            }
        }
    }
}

#[test]
fn a_file_beyond_the_limit_is_refused_unread() {
    let limit = usize::try_from(super::SIZE_LIMIT).unwrap();
    // Not even text: its size alone is looked at.
    let error = Document::parse_one("c.yaml", &vec![0xff; limit + 1]).unwrap_err();
    let due = "c.yaml:1:1: the file is larger than 4194304 bytes: it has 4194305; a description is text and far smaller";
    assert_eq!((error.name(), error.to_string().as_str()), ("too-large", due));
    let whole = format!("title: {}\n", "x".repeat(limit - "title: \n".len()));
    assert!(Document::parse_one("c.yaml", whole.as_bytes()).is_ok());
    assert!(Document::parse_one("c.yaml", format!("{whole} ").as_bytes()).is_err());
}

#[test]
fn a_file_of_too_many_values_is_refused_where_they_become_too_many() {
    let limit = super::tree::VALUE_LIMIT;
    // The sequence is a value too.
    let of = |count: usize| format!("a:\n{}", "- x\n".repeat(count));
    assert!(Document::parse_one("c.yaml", of(limit - 2).as_bytes()).is_ok());
    let error = Document::parse_one("c.yaml", of(limit).as_bytes()).unwrap_err();
    let due = "c.yaml:200000:3: a[199998]: the file has more than 200000 values";
    assert_eq!((error.name(), error.to_string().as_str()), ("too-many-values", due));
}

#[test]
fn a_message_is_one_line_that_shows_every_character_of_a_name() {
    let error =
        Document::parse_one("c\u{1b}[2J\n.yaml", b"{\"a\\e[31m\\n\": 1, \"a\\e[31m\\n\": 2}").unwrap_err();
    let text = error.to_string();
    assert!(!text.contains(char::is_control), "{text:?}");
    assert!(
        text.starts_with(r"c\u001b[2J\n.yaml:1:18: ")
            && text.contains(r"the key a\u001b[31m\n is written twice"),
        "{text}"
    );
}

#[test]
fn json_is_read_with_pairs_of_surrogates() {
    let text = "{\"a\": \"\\ud83d\\ude00 \\u00e4 \\\\ud83d \\\"\", 'b': '\\ud83d\\ude00'} # \"\n";
    let document = Document::parse_one("a.json", text.as_bytes()).unwrap();
    assert_eq!(document.value()["a"], "\u{1f600} \u{e4} \\ud83d \"");
    assert_eq!(document.value()["b"], "\\ud83d\\ude00");
    // Half a pair is none.
    assert!(Document::parse_one("a.json", br#"{"a": "\ud83d"}"#).is_err());
    // A plain text of YAML keeps its backslashes.
    let plain = Document::parse_one("a.yaml", b"a: \\ud83d\\ude00\n").unwrap();
    assert_eq!(plain.value()["a"], "\\ud83d\\ude00");
}

proptest! {
    /// A number that is changed in place leaves the document that the changed text is read to.
    #[test]
    fn another_number_is_as_if_read_anew(
        old in number(), to in prop_oneof![4 => number(), 1 => "[-a-z0-9. ]{0,6}"], which in 0..6_usize, is_flow: bool,
    ) {
        let text = |third: &str| match is_flow {
            true => format!("a: {{ ü: 1, k: {third}, z: [1.5, 20], n: '3', \"7\": 2 }}\nb: [2, {{c: 3}}]\n"),
            false => format!("a:\n  ü: 1\n  k: {third}\n  z: [1.5, 20]\n  n: '3'\n  \"7\": 2\nb: [2, {{c: 3}}]\n"),
        };
        let mut document = one(&text(&old));
        let a = Path::root().key("a");
        let paths = [a.clone().key("k"), a.clone().key("z").index(0), a.clone().key("n"), a.clone().key("7"), a.clone(), Path::root().key("b").index(0)];
        let at = document.position(&paths[which]);
        let unchanged = one(&text(&old));
        if !document.renumber(at, &to) {
            prop_assert_eq!(&document, &unchanged);
            // Numbers in plain decimals are taken.
            prop_assert!(which == 2 || which == 4 || to.parse::<f64>().is_err() || !is_plain(&to));
            return Ok(());
        }
        let before = unchanged.text_at(&paths[which]).unwrap();
        let lines = text(&old);
        let mut lines: Vec<String> = lines.split_inclusive('\n').map(str::to_owned).collect();
        let line = &mut lines[at.line - 1];
        let start = line.char_indices().nth(at.column - 1).unwrap().0;
        line.replace_range(start..start + before.len(), &to);
        prop_assert_eq!(document, one(&lines.concat()));
    }
}

fn one(text: &str) -> Document {
    Document::parse_one("g.yaml", text.as_bytes()).unwrap()
}

fn number() -> impl Strategy<Value = String> {
    prop_oneof!["(0|[1-9][0-9]{0,8})", "(0|[1-9][0-9]{0,5})\\.[0-9]{1,9}"]
}

fn is_plain(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.')
        && !text.starts_with(['0', '.'])
        && !text.ends_with('.')
}
