//! The atlas holds every structure and every gear of it, and real gearboxes.

use bytes::Bytes;
use epicyclic_synthesis::gearbox::{element_name, gearbox};
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::structure::Link;
use epicyclic_synthesis::{Class, Kind, Structure, enumerate};
use epicyclic_tables::atlas::{Atlas, Table, atlas, classes};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row, RowAccessor as _};
use std::collections::{HashMap, HashSet};
use std::sync::OnceLock;

fn the_atlas() -> &'static Atlas {
    static ATLAS: OnceLock<Atlas> = OnceLock::new();
    ATLAS.get_or_init(|| {
        atlas(&classes().expect("classes"), "0.0.1", &|| std::ops::ControlFlow::Continue(()))
            .expect("an atlas")
    })
}

/// Function of each gear, by structure and engaged elements; no gear comes twice.
fn the_gears() -> &'static HashMap<i32, HashMap<i64, i32>> {
    static GEARS: OnceLock<HashMap<i32, HashMap<i64, i32>>> = OnceLock::new();
    GEARS.get_or_init(|| {
        let mut by_structure: HashMap<i32, HashMap<i64, i32>> = HashMap::new();
        for row in rows(&the_atlas().gears) {
            let [structure, function] = [0, 3].map(|column| row.get_int(column).expect("a number"));
            let engaged = row.get_long(1).expect("bits");
            let before = by_structure.entry(structure).or_default().insert(engaged, function);
            assert!(before.is_none());
        }
        by_structure
    })
}

fn rows(table: &Table) -> Vec<Row> {
    let file = SerializedFileReader::new(Bytes::from(table.bytes.clone())).expect("Parquet");
    let rows = file.get_row_iter(None).expect("rows").map(|row| row.expect("a row")).collect::<Vec<_>>();
    assert_eq!(rows.len(), table.rows);
    rows
}

fn texts(row: &Row, column: usize) -> Vec<String> {
    let text = |field: &Field| if let Field::Str(text) = field { text.clone() } else { String::new() };
    row.get_list(column).expect("a list").elements().iter().map(text).collect()
}

fn longs(row: &Row, column: usize) -> Vec<i64> {
    let long = |field: &Field| if let Field::Long(value) = field { *value } else { i64::MAX };
    row.get_list(column).expect("a list").elements().iter().map(long).collect()
}

/// The value of a function from its coefficients, as a query would calculate it.
fn value(function: &Row, k: &[f64]) -> f64 {
    let polynomial = |column: usize| -> f64 {
        let term = |(product, coefficient): (usize, &i64)| {
            let of = (0..3).filter(|set| product >> set & 1 == 1);
            *coefficient as f64 * of.map(|set| k.get(set).copied().unwrap_or(f64::NAN)).product::<f64>()
        };
        longs(function, column).iter().enumerate().filter(|(_, c)| **c != 0).map(term).sum()
    };
    polynomial(3) / polynomial(4)
}

#[test]
fn every_structure_and_every_gear_of_it_is_there_once() {
    let atlas = the_atlas();
    assert_eq!((atlas.structures.rows, atlas.functions.rows, atlas.gears.rows), (35_292, 6_686, 1_470_147));
    let structures = rows(&atlas.structures);
    let words: Vec<Structure> = structures
        .iter()
        .map(|row| row.get_string(1).expect("a word").parse().expect("a structure"))
        .collect();
    assert_eq!(words.iter().collect::<HashSet<_>>().len(), words.len());
    for (sets, links, core) in [(2, 4, 111), (2, 5, 90), (3, 5, 3656), (3, 6, 4428), (3, 7, 1350)] {
        let is_core = |row: &&Row| row.get_bool(5).expect("a flag");
        let of = |row: &&Row| (row.get_int(2).ok(), row.get_int(3).ok()) == (Some(sets), Some(links));
        assert_eq!(structures.iter().filter(of).filter(is_core).count(), core);
        let class = Class::new(Kind::Core, sets as usize, links as usize).expect("a class");
        let there: HashSet<&Structure> = words.iter().collect();
        assert!(enumerate::all(class).iter().all(|structure| there.contains(structure)));
    }
    // Rows by the solver, structure by structure, of every 500th: each choice of elements drives the output
    // or is no row.
    let functions = rows(&atlas.functions);
    let mut compared = 0;
    for (place, structure) in words.iter().enumerate().step_by(500) {
        let row = &structures[place];
        let k = &[1.7, 2.3, 3.1][..structure.sets().len()];
        let elements: Vec<Element> = texts(row, 7)
            .iter()
            .map(|names| {
                let first = names.split('=').next().expect("a name");
                epicyclic_synthesis::gearbox::element_of_name(first).expect("an element")
            })
            .collect();
        let engaged = usize::try_from(row.get_int(4).expect("a number")).expect("a count");
        let gears = the_gears().get(&(place as i32 + 1)).cloned().unwrap_or_default();
        for bits in 0u64..1 << elements.len() {
            if bits.count_ones() as usize != engaged {
                continue;
            }
            let chosen: Vec<usize> = (0..elements.len()).filter(|element| bits >> element & 1 == 1).collect();
            let eta = epicyclic_gears::efficiency::MeshEfficiency::new(1.0).expect("an efficiency");
            let ratio = gearbox(structure, k, eta, &elements, &[chosen])
                .ok()
                .and_then(|gearbox| {
                    let analysis = gearbox.analyze_gear(&gearbox.gears()[0]).ok()?;
                    // A loose link gives no row, even if input and output are tied.
                    let settled = analysis.speeds().iter().all(Option::is_some);
                    analysis.ratio().filter(|_| settled)
                })
                .filter(|ratio| ratio.is_finite() && *ratio != 0.0);
            let told = gears.get(&(bits as i64)).map(|function| value(&functions[*function as usize - 1], k));
            match (ratio, told) {
                (Some(ratio), Some(told)) => {
                    assert!((ratio / told - 1.0).abs() < 1e-9, "{structure}: {ratio} {told}");
                }
                (None, None) => {}
                other => panic!("{structure} {bits:b}: {other:?}"),
            }
            compared += 1;
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// A gearbox in service: its sets with its own names of links, each set's `k`, and for each gear its engaged
/// elements and the ratio as it is published.
struct Real {
    name: &'static str,
    sets: &'static str,
    k: &'static [f64],
    gears: &'static [(&'static str, f64)],
}

/// Sets sun-ring-carrier; of a double-planet set ring and carrier exchanged and `k − 1`, which has the same
/// speeds.
const REAL: [Real; 4] = [
    Real {
        // Simpson: PA (s-r-2), PB (s-2-c).
        name: "GM TH400",
        sets: "s-r-2 s-2-c",
        k: &[54.0 / 26.0, 54.0 / 26.0],
        gears: &[("1-r c", 2.48), ("1-r s", 1.48), ("1-r 1-s", 1.0), ("1-s c", -2.08)],
    },
    Real {
        // Ravigneaux: the large sun l with the ring; the small sun s over two planets: 72/30 − 1.
        name: "Ford AOD",
        sets: "l-2-c s-c-2",
        k: &[72.0 / 36.0, 72.0 / 30.0 - 1.0],
        gears: &[("1-s c", 2.4), ("1-s l", 1.47), ("1-s 1-c", 1.0), ("1-c l", 0.67), ("1-l c", -2.0)],
    },
    Real {
        name: "GM 4L60-E",
        sets: "x-h-2 y-2-h",
        k: &[2.059, 2.294],
        gears: &[("1-x h", 3.059), ("1-x y", 1.625), ("1-x 1-h", 1.0), ("1-h y", 0.696), ("1-y h", -2.294)],
    },
    Real {
        // The document's scheme II-3: 1 + 1/k₁ and (1 + k₁ + k₂)/k₁.
        name: "scheme II-3",
        sets: "x-1-2 x-2-y",
        k: &[2.1505, 2.3548],
        gears: &[("x", 1.465), ("y", 2.56), ("1-2", 1.0)],
    },
];

#[test]
fn gearboxes_in_service_are_found_with_their_gears() {
    let atlas = the_atlas();
    let structures = rows(&atlas.structures);
    let functions = rows(&atlas.functions);
    let by_word: HashMap<String, usize> = structures
        .iter()
        .enumerate()
        .map(|(place, row)| (row.get_string(1).expect("a word").clone(), place))
        .collect();
    for Real { name, sets, k, gears: published } in REAL {
        let (structure, letters) = Structure::read(sets).expect("a structure");
        let place = *by_word.get(&structure.to_string()).unwrap_or_else(|| panic!("{name}: {structure}"));
        let elements: Vec<Vec<String>> = texts(&structures[place], 7)
            .iter()
            .map(|names| names.split('=').map(str::to_owned).collect())
            .collect();
        let link = |letter: &str| -> Link {
            let place = letters.iter().position(|known| letter.starts_with(*known)).expect("a link");
            Link::try_from(place).expect("a link")
        };
        // The canonical word may have the sets in another order.
        let order: Vec<f64> = {
            let (_, order) = Structure::canonical(&given(sets), structure.links()).expect("a structure");
            order.iter().map(|set| k[*set]).collect()
        };
        for (engaged, ratio) in published {
            let bits = engaged.split(' ').fold(0i64, |bits, element| {
                let mut pair = match element.split_once('-') {
                    Some((one, other)) => [link(one), link(other)],
                    None => [0, link(element)],
                };
                pair.sort_unstable();
                let name = element_name(pair);
                let place = elements.iter().position(|names| names.contains(&name)).expect("an element");
                bits | 1 << place
            });
            let of_it = the_gears().get(&(place as i32 + 1));
            let function = of_it.and_then(|gears| gears.get(&bits));
            let function = function.unwrap_or_else(|| panic!("{name}: {engaged}"));
            let value = value(&functions[*function as usize - 1], &order);
            assert!((value / ratio - 1.0).abs() < 0.005, "{name}, {engaged}: {value}, published {ratio}");
        }
    }
}

/// The sets of a text with its links numbered as it names them.
fn given(sets: &str) -> Vec<[Link; 3]> {
    let mut letters = vec!['0', '1', '2'];
    let mut number = |letter: char| {
        let place = letters.iter().position(|known| *known == letter).unwrap_or_else(|| {
            letters.push(letter);
            letters.len() - 1
        });
        Link::try_from(place).expect("a link")
    };
    let set = |set: &str| {
        let members: Vec<Link> =
            set.split('-').filter_map(|link| link.chars().next()).map(&mut number).collect();
        members.try_into().expect("three members")
    };
    sets.split(' ').map(set).collect()
}

#[test]
fn the_bytes_are_the_same_each_time() {
    let class = [Class::new(Kind::AllSparse, 2, 5).expect("a class")];
    let [one, other] =
        [(), ()].map(|()| atlas(&class, "0.0.1", &|| std::ops::ControlFlow::Continue(())).expect("an atlas"));
    assert_eq!(one, other);
    assert!(
        atlas(&[Class::new(Kind::Core, 4, 9).expect("a class")], "0.0.1", &|| {
            std::ops::ControlFlow::Continue(())
        })
        .is_err()
    );
}
