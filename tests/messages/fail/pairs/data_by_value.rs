//! The data of a body stays where it is.

pub struct Charge {
    pub q: f64,
}

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, a: Charge, b: &Charge) -> f64 {
        self.k * a.q * b.q / r
    }
}

fn main() {}
