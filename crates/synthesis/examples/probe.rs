//! Probe.
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::refine::refine;
use epicyclic_synthesis::run::{Share, search};
use epicyclic_synthesis::search::Wish;
use epicyclic_synthesis::*;
use std::ops::ControlFlow;
use std::time::Instant;
fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let ratios: Vec<f64> = arguments[1].split(' ').map(|x| x.parse().unwrap()).collect();
    let kind = if arguments[2] == "core" { Kind::Core } else { Kind::AllSparse };
    let n: usize = arguments[3].parse().unwrap();
    let l: usize = arguments[4].parse().unwrap();
    let m: usize = arguments[5].parse().unwrap();
    let stride: usize = arguments.get(6).map_or(1, |x| x.parse().unwrap());
    let threads: usize = arguments.get(7).map_or(2, |x| x.parse().unwrap());
    let gears: Vec<Bounds> = ratios.iter().map(|r: &f64| Bounds { least: r - 0.01 * r.abs(), most: r + 0.01 * r.abs() }).collect();
    let wish = Wish { gears: gears.clone(), elements: m, k: vec![1.4..=4.5; n] };
    let t = Instant::now();
    let a = search(Class::new(kind, n, l).unwrap(), &wish, Share { number: 0, of: stride }, threads, &|_| ControlFlow::Continue(())).unwrap();
    println!("{} found in {:?} {:?} complete {}", a.found.len(), t.elapsed(), a.tally, a.complete);
    let t = Instant::now();
    for f in a.found.iter().take(400) {
        let y = &f.solution;
        let ratios: Vec<_> = y.gears.iter().map(|g| g.ratio).collect();
        let r = refine(&ratios, &gears, &vec![[1.4, 4.5]; n], &y.k);
        println!("{}  {}  k {:.3?} dev {:.3} {:.3?}", f.structure, y.elements.iter().map(|e| gearbox::element_name(e[0])).collect::<Vec<_>>().join(" "), r.k, r.deviation, r.ranges);
    }
    println!("refined in {:?}", t.elapsed());
}
