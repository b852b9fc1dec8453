//! A force knows its arguments by name.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, velocity: [f64; 2]) -> [f64; 2] {
        [-self.c * velocity[0], -self.c * velocity[1]]
    }
}

fn main() {}
