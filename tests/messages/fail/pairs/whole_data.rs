//! A struct is no number.

pub struct Charge {
    pub q: f64,
}

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        self.k * a * b.q / r
    }
}

fn main() {}
