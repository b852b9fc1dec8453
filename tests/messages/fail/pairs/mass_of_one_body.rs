//! Two bodies have two masses.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, m: f64) -> f64 {
        self.k * m / r
    }
}

fn main() {}
