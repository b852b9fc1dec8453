//! A force on a particle in the plane is not one number.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        -self.c * v[0].hypot(v[1])
    }
}

fn main() {}
