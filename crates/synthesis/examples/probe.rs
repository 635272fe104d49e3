//! Probe.
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::search::{Search, Wish};
use epicyclic_synthesis::*;
use std::time::Instant;
fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let ratios: Vec<f64> = arguments[1].split(' ').map(|x| x.parse().unwrap()).collect();
    let kind = if arguments[2] == "core" { Kind::Core } else { Kind::AllSparse };
    let n: usize = arguments[3].parse().unwrap();
    let l: usize = arguments[4].parse().unwrap();
    let m: usize = arguments[5].parse().unwrap();
    let stride: usize = arguments.get(6).map_or(1, |x| x.parse().unwrap());
    let gears = ratios.iter().map(|r: &f64| Bounds { least: r - 0.01 * r.abs(), most: r + 0.01 * r.abs() }).collect();
    let wish = Wish { gears, elements: m, k: vec![1.4..=4.5; n] };
    let t = Instant::now();
    let all = enumerate::all(Class::new(kind, n, l).unwrap());
    println!("{} structures {:?}", all.len(), t.elapsed());
    let t = Instant::now();
    let mut found = 0;
    macro_rules! run { ($w:ty) => {{
        let mut s = Search::<$w>::new(wish.clone(), l);
        let mut structures = 0;
        for x in all.iter().step_by(stride) {
            let f = s.structure(x);
            structures += usize::from(!f.is_empty());
            for y in f {
                found += 1;
                if found < 60 { println!("{x}  {}  k {:.3?} {:?}", y.elements.iter().map(|e| gearbox::element_name(e[0])).collect::<Vec<_>>().join(" "), y.k, y.gears.iter().map(|g| g.ratio.to_string()).collect::<Vec<_>>()); }
            }
        }
        println!("{found} in {structures} structures {:?} {:?} {:?}", s.tally(), s.functions(), t.elapsed());
    }} }
    if n <= 3 { run!(u8) } else { run!(u16) }
}
