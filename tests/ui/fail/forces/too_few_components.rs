//! The value of the body has the length that the signature says.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        let drag = -self.c * v[0];
        [drag]
    }
}

fn main() {}
