//! The bodies of a scene carry one type.

pub struct Charge {
    pub q: f64,
}

pub struct Spin {
    pub q: f64,
}

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Spin) -> f64 {
        self.k * a.q * b.q / r
    }
}

fn main() {}
