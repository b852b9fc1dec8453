//! Types with parameters of their own.
use std::marker::PhantomData;

use dmech::prelude::*;

struct Tagged<'a, R: Clone, const N: usize>
where
    R: Default,
{
    k: f64,
    weights: &'a [f64; N],
    tag: PhantomData<R>,
}

#[dmech::law]
impl<'a, R: Clone, const N: usize> Tagged<'a, R, N>
where
    R: Default,
{
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        0.5 * self.k * (self.weights[0] * q[0] * q[0] + self.weights[1] * q[1] * q[1])
    }
}

/// One instance of a generic type.
struct Well<const N: usize> {
    depth: f64,
}

#[dmech::law]
impl Well<2> {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.depth * (-q[0] * q[0] - q[1] * q[1]).exp()
    }
}

#[derive(dmech::Law)]
#[potential(|q: f64| 0.5 * self.k * q * q)]
struct Derived<T: Clone = u8, const N: usize = 3> {
    k: f64,
    #[allow(dead_code)]
    other: [T; N],
}

fn main() {
    let law = Tagged::<u8, 2> { k: 2.0, weights: &[1.0, 3.0], tag: PhantomData };
    assert_eq!(law.gradient([0.5, 0.25]), [1.0, 1.5]);
    assert_eq!(Well::<2> { depth: 3.0 }.gradient([0.0, 0.0]), [0.0, 0.0]);
    let run = Simulation::new(Derived { k: 4.0, other: [0_u8; 3] }, State::new([1.0], [0.0])).scheme(Implicit).dt(0.1);
    assert!(run.run(10).is_ok());
}
