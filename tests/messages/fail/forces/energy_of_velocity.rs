//! A potential does not depend on the velocity.

struct Odd {
    c: f64,
}

#[dmech::law]
impl Odd {
    #[potential]
    fn energy(&self, q: f64, v: f64) -> f64 {
        self.c * q * v
    }
}

fn main() {}
