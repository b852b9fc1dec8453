//! What a law keeps is a function of the motion.

struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        0.5 * self.k * q * q
    }

    #[invariant]
    fn total(&self, q: f64, v: f64, m: f64) -> f64 {
        0.5 * m * v * v + self.energy(q)
    }
}

fn main() {}
