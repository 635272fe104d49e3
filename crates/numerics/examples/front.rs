//! The front of five designs by mass in kg and loss in per cent, both to be small.

use epicyclic_numerics::front::front;

fn main() {
    let designs = [[12.0, 3.1], [10.0, 3.4], [10.0, 3.9], [12.0, 3.1], [15.0, 2.8]];
    let lightest_first = [0, 1];
    for equal in front(&designs, lightest_first) {
        let [mass, loss] = designs[equal[0]];
        println!("{mass} kg, {loss} %: designs {equal:?}");
    }
}
