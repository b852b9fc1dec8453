//! A force names what it depends on.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, q: [f64; 2]) -> [f64; 2] {
        [-self.c * v[0], q[1]]
    }
}

fn main() {}
