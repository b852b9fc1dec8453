use dmech::models::Kepler;
use dmech::prelude::*;

fn main() {
    let planets = Ensemble::of(10).law(|_| Kepler { gm: 1.0 }).scheme(Leapfrog).dt(0.01);
    let _ = planets.with(|_, member| member.event(|state| state.q[0], Crossing::Rising));
}
