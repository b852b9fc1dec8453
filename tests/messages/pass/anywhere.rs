//! Laws inside a function, in a nested module, on a type from elsewhere.
use dmech::prelude::*;

mod physics {
    pub mod stars {
        pub struct Plummer {
            pub gm: f64,
            pub(super) eps: f64,
        }

        #[dmech::law]
        impl Plummer {
            #[potential]
            fn energy(&self, q: [f64; 3]) -> f64 {
                -self.gm / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + self.eps * self.eps).sqrt()
            }
        }
    }

    pub fn plummer() -> stars::Plummer {
        stars::Plummer { gm: 2.0, eps: 0.5 }
    }

    pub struct Elsewhere;
}

#[dmech::law]
impl physics::Elsewhere {
    #[potential]
    fn in_one_coordinate(&self, q: f64) -> f64 {
        1.0 - q.cos()
    }
}

fn main() {
    struct Spring {
        k: f64,
    }

    #[dmech::law]
    impl Spring {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            0.5 * self.k * q * q
        }
    }

    assert_eq!(Spring { k: 4.0 }.gradient([0.5]), [2.0]);
    assert_eq!(physics::plummer().gradient([0.0, 0.0, 0.0]), [0.0, 0.0, 0.0]);
    assert_eq!(physics::Elsewhere.gradient([0.0]), [0.0]);
}
