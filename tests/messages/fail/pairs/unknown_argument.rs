//! Arguments are known by name.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, s: f64) -> f64 {
        self.k / s
    }
}

fn main() {}
