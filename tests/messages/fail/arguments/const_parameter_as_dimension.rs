//! The number of coordinates must be a literal.
use dmech::prelude::*;

struct Chain<const D: usize> {
    k: f64,
}

#[dmech::law]
impl<const D: usize> Chain<D> {
    #[potential]
    fn energy(&self, q: [f64; D]) -> f64 {
        0.5 * self.k * (1..D).map(|i| (q[i] - q[i - 1]).powi(2)).sum::<f64>()
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Chain { k: 2.0 }.energy([0.1, 0.4]);
}
