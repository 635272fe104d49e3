use epicyclic_schemes::search::ToothSearch;
use epicyclic_schemes::selection::{Demand, RatioSeries};
#[test]
fn timing() {
    let s = ToothSearch::new(Demand::new(RatioSeries::new(&[1.95 / 1.33, 1.95 / 0.76]).unwrap()));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for _ in 0..2 {
        let t = std::time::Instant::now();
        let b = pool.install(|| s.best(10)).unwrap();
        println!("best {:?} {:?}", t.elapsed(), b.counts());
        let t = std::time::Instant::now();
        let f = pool.install(|| s.front()).unwrap();
        println!("front {:?} {}", t.elapsed(), f.entries().len());
        for e in &b.entries()[..3] {
            println!("{:?} {}", e.objectives, b.designs(e).len());
        }
    }
}
