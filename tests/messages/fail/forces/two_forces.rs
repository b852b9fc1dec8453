//! One force per law.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn linear(&self, v: f64) -> f64 {
        -self.c * v
    }
    #[force]
    fn quadratic(&self, v: f64) -> f64 {
        -self.c * v * v.abs()
    }
}

fn main() {}
