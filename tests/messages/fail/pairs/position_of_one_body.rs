//! Two bodies have two positions.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.k * q[0]
    }
}

fn main() {}
