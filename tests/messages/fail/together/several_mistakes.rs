//! All mistakes of a law in one run, each once, in the order of the text.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let r = q[0].hypot(q[2]);
        println!("{r}");
        let n = 2;
        for i in 0..self.n {
            sum += q[i].floor();
        }
        -gm / r.powi(n) + q[1] * 2 + q[0].sqare()
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
