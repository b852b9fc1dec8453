//! Laws, generics, bounds and lifetimes called like what generated code hides.
#![deny(warnings)]
use dmech::prelude::*;

/// Names the time, so that its field at a moment is a hidden struct.
pub struct Moment {
    pub k: f64,
}

#[dmech::law]
impl Moment {
    #[potential]
    fn energy(&self, q: [f64; 2], t: f64) -> f64 {
        self.k * q[0] * q[0] * t.cos() + q[1] * q[1]
    }
}

pub struct Instant {
    pub moment: Moment,
}

#[dmech::law]
impl Instant {
    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        [-self.moment.k * v[0], -self.moment.k * v[1]]
    }
}

/// Its generics have the names of the hidden struct and of its lifetime.
pub struct Borrowed<'law, 'held, Moment, Instant> {
    pub k: &'law [f64; 1],
    pub others: &'held (Moment, Instant),
}

#[dmech::law]
impl<'law, 'held, Moment: Clone, Instant: Clone> Borrowed<'law, 'held, Moment, Instant> {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        m * self.k[0] * q[0] * q[0] + q[1] * q[1]
    }
}

/// Traits that only bounds name.
pub trait R {}
pub trait Law {}
impl R for f64 {}
impl Law for f64 {}

pub struct Bounded<T> {
    pub k: f64,
    pub label: T,
}

#[dmech::law]
impl<T> Bounded<T>
where
    T: R + Law,
{
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        m * self.k * q[0] * q[0] + q[1] * q[1]
    }
}

/// Between two bodies that carry moments.
pub struct Pair<'law, D> {
    pub k: &'law [f64; 1],
    pub label: D,
}

#[dmech::law]
impl<'law, D: Sync> Pair<'law, D> {
    #[pair]
    fn energy(&self, r: f64, a: &Moment, b: &Moment) -> f64 {
        self.k[0] * r * r * a.k * b.k
    }
}

fn main() {
    let (start, k) = (State::new([1.0, 0.5], [0.0, 0.1]), 2.0);
    assert!(Simulation::new(Moment { k }, start).scheme(Leapfrog).dt(0.1).run(3).is_ok());
    assert!(Simulation::new(Instant { moment: Moment { k } }, start).scheme(Implicit).dt(0.1).run(3).is_ok());
    let borrowed = Borrowed { k: &[k], others: &(1, "one") };
    assert_eq!(borrowed.others.1.len(), 3);
    assert!(Simulation::new(borrowed, start).scheme(Leapfrog).dt(0.1).run(3).is_ok());
    let bounded = Bounded { k, label: 1.0 };
    assert_eq!(bounded.label, 1.0);
    assert!(Simulation::new(bounded, start).scheme(Leapfrog).dt(0.1).run(3).is_ok());
    let law = Pair { k: &[k], label: 1 };
    assert_eq!(law.label, 1);
    let scene = Scene::new().body_with(1.0, [0.0, 0.0], [0.0, 0.0], Moment { k: 1.0 });
    let scene = scene.body_with(1.0, [1.0, 0.0], [0.0, 0.0], Moment { k: 2.0 }).pairs(law);
    assert!(Simulation::scene(scene).scheme(Leapfrog).dt(0.1).run(3).is_ok());
}
