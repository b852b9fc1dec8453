//! States between those that were recorded.

use dmech_scalar::Real as _;

use super::{Event, Run};
use crate::snapshot::Snapshot;

/// What position and velocity of a state count in those of another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weights {
    /// a and b.
    pub(super) position: [f64; 2],
    /// a′ and b′.
    pub(super) velocity: [f64; 2],
}

/// At a time: Σ (a q + b v) and its derivative Σ (a′ q + b′ v) over some states, with their weights.
pub(super) fn blend<X: Snapshot>(time: f64, states: &[X], weights: &[Weights]) -> X {
    let bodies = states.first().map_or(0, X::bodies);
    X::from_numbers(time, bodies, |list, i| {
        states.iter().zip(weights).fold(X::Scalar::ZERO, |sum, (state, &Weights { position, velocity })| {
            let [a, b] = [position, velocity][list].map(X::Scalar::from_f64);
            sum + (a * state.number(0, i) + b * state.number(1, i))
        })
    })
}

/// The largest |Δq| of a coordinate.
fn apart<X: Snapshot>(one: &X, other: &X) -> f64 {
    let pairs = one.lists()[0].iter().zip(other.lists()[0]);
    pairs.fold(0.0, |most, (&x, &y)| most.max((x - y).to_f64().abs()))
}

/// Hermite's weights at a time: with ℓⱼ Lagrange's polynomials, a = (1 − 2 (t − tⱼ) ℓⱼ′(tⱼ)) ℓⱼ² and b = (t − tⱼ) ℓⱼ².
fn hermite(time: f64, nodes: &[f64]) -> Vec<Weights> {
    let of = |(j, &at): (usize, &f64)| {
        let others = || nodes.iter().enumerate().filter(move |&(k, _)| k != j).map(|(_, &node)| node);
        let l: f64 = others().map(|node| (time - node) / (at - node)).product();
        let rise: f64 = others().map(|node| (at - node).recip()).sum();
        let slope: f64 = others()
            .map(|left| {
                let rest = others().filter(|&node| node != left).map(|node| (time - node) / (at - node));
                rest.product::<f64>() / (at - left)
            })
            .sum();
        let (from, tilt) = (time - at, 1.0 - 2.0 * (time - at) * rise);
        Weights {
            position: [tilt * l * l, from * l * l],
            velocity: [2.0 * (tilt * slope - rise * l) * l, l * (l + 2.0 * from * slope)],
        }
    };
    nodes.iter().enumerate().map(of).collect()
}

impl<X: Snapshot> Run<X> {
    /// The state at a time between two that were recorded: the polynomial through positions and velocities of the nearest, of so
    /// high a degree that after every step recorded it has the order of the scheme, or of a lower one where a higher brings it no
    /// nearer. `None` before the first and after the last.
    ///
    /// It does not reach over a [change](crate::Simulation::change_when) of the motion, at which it ends in the state of the event and begins
    /// in the one [after](Event::after) it. Of the law it knows nothing. Where few states were recorded, or steps are long, as those of
    /// [`Gauss`](crate::Gauss) and all adaptive ones may be, the polynomial is less exact than the states: with steps of a radian of the
    /// motion it is right to 10⁻² or so. Ask for the times before the run, with [`record_at`](crate::Simulation::record_at), which costs a
    /// step and is as exact as the run.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let spring = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0])).scheme(Nystrom::order8()).dt(0.1);
    /// let run = spring.run_until(3.0)?;
    /// let state = run.at(1.234).unwrap();
    /// assert!((state.q[0] - 2.468_f64.cos()).abs() < 1e-11 && (state.v[0] + 2.0 * 2.468_f64.sin()).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn at(&self, t: f64) -> Option<X> {
        let after = self.states.partition_point(|state| state.time() < t);
        let recorded = self.states.get(after).filter(|state| state.time() == t);
        // The end of the run belongs to it also where it was not due.
        if let Some(there) = recorded.or(Some(&self.last).filter(|last| last.time() == t)) {
            return Some(there.clone());
        }
        if after == 0 || t.is_nan() || t > self.last.time() {
            return None;
        }
        let Piece { from, states, end } = self.piece(t);
        let after = states.partition_point(|state| state.time() < t);
        let (earlier, later) = states.split_at(after);
        let mut earlier = from.into_iter().chain(earlier).rev();
        let mut later = later.iter().chain([end]);
        let (before, behind) = (earlier.next()?, later.next()?);
        let [start, end] = [before, behind].map(Snapshot::time);
        let least = 0.1 * (end - start);
        let mut earlier = spaced(start, least, earlier).peekable();
        let mut later = spaced(end, least, later).peekable();
        let most = self.report.order().div_ceil(2) as usize + 1;
        let mut near = vec![before.clone(), behind.clone()];
        while near.len() < most {
            let nearer = match (earlier.peek(), later.peek()) {
                (Some(one), Some(other)) => t - one.time() <= other.time() - t,
                (one, _) => one.is_some(),
            };
            let Some(next) = (if nearer { earlier.next() } else { later.next() }) else { break };
            near.push(next.clone());
        }
        Some(nearest(t, &near))
    }

    /// Where a time is in the motion.
    fn piece(&self, t: f64) -> Piece<'_, X> {
        let passed = self.events.partition_point(|event| event.state().time() <= t);
        let from = self.events[..passed].iter().rev().find_map(Event::after);
        let to = self.events[passed..].iter().find(|event| event.after().is_some()).map(Event::state);
        let end = to.unwrap_or(&self.last);
        let [first, last] = [
            from.map_or(0, |from| self.states.partition_point(|state| state.time() <= from.time())),
            self.states.partition_point(|state| state.time() < end.time()),
        ];
        Piece { from, states: &self.states[first..last.max(first)], end }
    }
}

/// States between one change of the motion and the next.
struct Piece<'a, X> {
    /// That after the first change; none where it begins with the run.
    from: Option<&'a X>,
    /// Those that were recorded.
    states: &'a [X],
    /// That before the next change, or at the end of the run.
    end: &'a X,
}

/// Of the polynomials through two of the states, three, … the one from which the next two differ least. Where steps are long
/// beside the motion, those through many states go astray.
fn nearest<X: Snapshot>(t: f64, states: &[X]) -> X {
    let nodes: Vec<f64> = states.iter().map(Snapshot::time).collect();
    let through = |n: usize| blend(t, &states[..n], &hermite(t, &nodes[..n]));
    let mut all: Vec<X> = (2..=states.len()).map(through).collect();
    let steps: Vec<f64> = all.windows(2).map(|two| apart(&two[0], &two[1])).collect();
    // Of the last no more is known than how far it is from the one before.
    let off = |k: usize| {
        let next = steps[k.min(steps.len().saturating_sub(1))..].iter().take(2);
        next.fold(0.0, |most: f64, &x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
    };
    let best = (0..all.len()).rev().min_by(|&a, &b| off(a).total_cmp(&off(b)));
    all.swap_remove(best.unwrap_or(0))
}

/// Of states in a row those that lie apart: between two that all but coincide nothing is to be divided by.
fn spaced<'a, X: Snapshot + 'a>(
    from: f64,
    least: f64,
    states: impl Iterator<Item = &'a X>,
) -> impl Iterator<Item = &'a X> {
    let mut last = from;
    states.filter(move |state| {
        let apart = (state.time() - last).abs() >= least;
        if apart {
            last = state.time();
        }
        apart
    })
}
