//! Nothing but the language is in scope.
#![no_implicit_prelude]

struct Kepler {
    gm: f64,
}

#[::dmech::law]
impl Kepler {
    const SOFT: f64 = 0.1;

    fn soft(&self, r2: f64) -> f64 {
        r2 + Self::SOFT * Self::SOFT
    }

    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        let r2 = self.soft(q[0] * q[0] + q[1] * q[1]);
        if q[0] < 0.0 { -m * self.gm / r2.sqrt() } else { -m * self.gm * r2.powf(-0.5) }
    }
}

#[derive(::dmech::Law)]
#[potential(|q: f64| 0.5 * self.k * q * q)]
struct Spring {
    k: f64,
}

fn main() {
    let law = Kepler { gm: 1.0 };
    let field = ::dmech::Law::<2, _>::field(&law, 2.0, 0.0);
    let _ = ::dmech::Potential::gradient(&field, [0.5, 0.0]);
    ::std::assert_eq!(::dmech::Potential::gradient(&Spring { k: 4.0 }, [0.5]), [2.0]);
}
