//! A law called R, parameters called like what generated code calls its own values, keywords.
#![deny(warnings)]
#![allow(non_camel_case_types, non_snake_case)]
use dmech::prelude::*;

pub struct R {
    pub x: f64,
    pub y: f64,
    pub xa: f64,
    pub xb: f64,
    pub r2: f64,
    pub inv_r2: f64,
    pub c: f64,
    pub g: f64,
    pub s: f64,
    pub sa: f64,
    pub a: f64,
    pub b: f64,
    pub q: f64,
    pub v: f64,
    pub m: f64,
    pub t: f64,
    pub t0: f64,
    pub delta0: f64,
    pub rhs0: f64,
    pub equation: f64,
    pub mass: f64,
    pub law: f64,
    pub dmech_v1: f64,
    pub r#type: f64,
}

#[dmech::law]
impl R {
    #[potential]
    pub fn potential(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        let [x, y] = q;
        let r2 = x * x + y * y;
        let t0 = self.x * x + self.y * y + self.xa + self.xb + self.r2 * r2 + self.inv_r2 / r2;
        let t1 = self.c + self.g + self.s + self.sa + self.a * x * x * y + self.b + self.q + self.v + self.m * m;
        let delta = self.t * t + self.t0 + self.delta0 + self.rhs0 + self.equation + self.mass + self.law;
        t0 * t1 + delta + self.dmech_v1 * self.r#type * (x * y).sin()
    }
}

pub struct Potential {
    pub Real: f64,
    pub Some: f64,
    pub λ: f64,
}

#[dmech::law]
impl Potential {
    #[potential]
    pub fn gradient(&self, q: f64) -> f64 {
        let Law = q.sin();
        self.Real * Law + self.Some * q * self.λ
    }
}

struct f64x;

#[dmech::law]
impl f64x {
    #[potential]
    fn self_energy(&self, q: f64) -> f64 {
        q.powi(4)
    }
}

fn main() {
    let law = R {
        x: 0.1,
        y: 0.2,
        xa: 0.3,
        xb: 0.4,
        r2: 0.5,
        inv_r2: 0.6,
        c: 0.7,
        g: 0.8,
        s: 0.9,
        sa: 1.0,
        a: 1.1,
        b: 1.2,
        q: 1.3,
        v: 1.4,
        m: 1.5,
        t: 1.6,
        t0: 1.7,
        delta0: 1.8,
        rhs0: 1.9,
        equation: 2.0,
        mass: 2.1,
        law: 2.2,
        dmech_v1: 2.3,
        r#type: 2.4,
    };
    let declared = law.potential([0.5, 0.25], 2.0, 3.0);
    let generated = dmech::Potential::potential(&dmech::Law::field(&law, 2.0, 3.0), [0.5, 0.25]);
    assert!((declared - generated).abs() < 1e-13 * declared.abs(), "{declared} {generated}");
    let start = State::new([0.5, 0.25], [0.1, 0.2]);
    assert!(Simulation::new(law, start).scheme(DiscreteGradient).dt(0.001).run(10).is_ok());

    let other = Potential { Real: 2.0, Some: 3.0, λ: 1.0 };
    assert_eq!(other.gradient(0.0), 0.0);
    assert_eq!(dmech::Potential::gradient(&other, [0.0]), [5.0]);
    assert_eq!(dmech::Potential::gradient(&f64x, [1.0]), [4.0]);
}
