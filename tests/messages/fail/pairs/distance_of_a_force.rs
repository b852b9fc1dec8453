//! A force has a direction.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair_force]
    fn pull(&self, r: f64) -> [f64; 2] {
        [self.k / r, 0.0]
    }
}

fn main() {}
