//! What another type's methods compute cannot be seen.

pub struct Charge {
    pub q: f64,
}

impl Charge {
    pub fn strength(&self) -> f64 {
        2.0 * self.q
    }
}

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        self.k * a.strength() * b.q / r
    }
}

fn main() {}
