//! Where Newton starts in a stage: the forces of the stages before it, continued in time.

use dmech_scalar::Real;

use crate::system::System;

/// What the forces of one step would have been, had the step been longer or shorter: for steps that change.
#[derive(Clone, Copy)]
pub(super) struct Resample<const N: usize> {
    /// The terms at each stage, times from the end of the step.
    terms: [[f64; N]; TERMS],
    /// Weights that take the coefficient of each term out of the forces.
    coefficients: [[f64; N]; TERMS],
}

/// The powers of h in the terms.
const POWERS: [i32; TERMS] = [0, 1, 2, 2, 3, 3, 3];

impl<const N: usize> Resample<N> {
    pub(super) const fn new(gamma: [f64; N], place: SlopeAt) -> Self {
        let terms = terms(stages(gamma, place), 0.0, 0);
        let mut coefficients = [[0.0; N]; TERMS];
        let mut i = 0;
        while i < TERMS {
            let mut one = [0.0; TERMS];
            one[i] = 1.0;
            coefficients[i] = smallest(terms, one);
            i += 1;
        }
        Resample { terms, coefficients }
    }

    /// From a step of length h to one of length `ratio` h.
    pub(super) fn apply<Y: System>(&self, system: &Y, ratio: Y::Scalar, slopes: &mut [Y::Vector; N]) {
        let mut changes: [Y::Vector; TERMS] = core::array::from_fn(|_| system.zero());
        for i in 1..TERMS {
            Y::weigh(&self.coefficients[i], slopes, &mut changes[i]);
            Y::scale(&mut changes[i], ratio.powi(POWERS[i]) - Y::Scalar::ONE);
        }
        for j in 0..N {
            for i in 1..TERMS {
                Y::add_scaled(&mut slopes[j], Y::Scalar::from_f64(self.terms[i][j]), &changes[i]);
            }
        }
    }
}

/// Where in a stage the force of a scheme belongs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum SlopeAt {
    /// A discrete gradient: at the middle, and off it by the square of the stage's length.
    Middle,
    /// A force at the end.
    End,
}

/// What a force of a stage depends on: 1, τ, τ², ℓ², τ³, τℓ², s, …; the first ones matter most.
const TERMS: usize = 7;

/// Weights w[k][j] by which the forces of the last N stages predict that of stage k; j counts the stages, so that j < k
/// is of this step and j ≥ k of the step before.
///
/// Stages go to and fro in time, so their order says nothing: a stage of length ℓ h whose force belongs to the time τ h
/// has G = g(τ h) + e ℓ² h² + d s h³ + O(h⁴). Here e is what a discrete gradient differs from the force in the middle by,
/// and d what the local errors O(h³) of the stages before have moved the position by: s is the sum of their γ³.
/// The weights reproduce these terms exactly, as many as the number of stages allows, and are the smallest that do.
pub(super) const fn weights<const N: usize>(gamma: [f64; N], place: SlopeAt) -> [[f64; N]; N] {
    let stages = stages(gamma, place);
    let mut weights = [[0.0; N]; N];
    let mut k = 0;
    while k < N {
        weights[k] = smallest(terms(stages, stages[k][0], k), values(0.0, stages[k][1], stages[k][2]));
        k += 1;
    }
    weights
}

/// The terms at each stage, times from `origin`. Those from stage `next` on are of the step before.
const fn terms<const N: usize>(stages: [[f64; 3]; N], origin: f64, next: usize) -> [[f64; N]; TERMS] {
    let mut terms = [[0.0; N]; TERMS];
    let mut j = 0;
    while j < N {
        let before = if j < next { 0.0 } else { 1.0 };
        let [time, length, error] = stages[j];
        let column = values(time - before - origin, length, error);
        let mut i = 0;
        while i < TERMS {
            terms[i][j] = column[i];
            i += 1;
        }
        j += 1;
    }
    terms
}

/// Time, length and s of each stage.
const fn stages<const N: usize>(gamma: [f64; N], place: SlopeAt) -> [[f64; 3]; N] {
    let mut stages = [[0.0; 3]; N];
    let (mut t, mut s) = (0.0, 0.0);
    let mut k = 0;
    while k < N {
        let (x, cube) = (gamma[k], gamma[k] * gamma[k] * gamma[k]);
        stages[k] = match place {
            SlopeAt::Middle => [t + 0.5 * x, x, s + 0.5 * cube],
            SlopeAt::End => [t + x, 0.0, s + cube],
        };
        t += x;
        s += cube;
        k += 1;
    }
    stages
}

const fn values(t: f64, length: f64, error: f64) -> [f64; TERMS] {
    let square = length * length;
    [1.0, t, t * t, square, t * t * t, t * square, error]
}

/// The smallest w with Σⱼ aᵢⱼ wⱼ = bᵢ, w = Aᵀ (A Aᵀ)⁻¹ b; rows that depend on earlier ones are left out.
const fn smallest<const N: usize>(a: [[f64; N]; TERMS], mut b: [f64; TERMS]) -> [f64; N] {
    const DEPENDENT: f64 = 1e-6;
    let mut rows = a;
    let mut squares = [0.0; TERMS];
    // Gram–Schmidt on the rows, carrying the right-hand sides along.
    let mut i = 0;
    while i < TERMS {
        let before = dot(&rows[i], &rows[i]);
        let mut pass = 0;
        while pass < 2 {
            let mut l = 0;
            while l < i {
                if squares[l] > 0.0 {
                    let c = dot(&rows[i], &rows[l]) / squares[l];
                    let mut j = 0;
                    while j < N {
                        rows[i][j] -= c * rows[l][j];
                        j += 1;
                    }
                    b[i] -= c * b[l];
                }
                l += 1;
            }
            pass += 1;
        }
        let left = dot(&rows[i], &rows[i]);
        squares[i] = if left > DEPENDENT * before { left } else { 0.0 };
        i += 1;
    }
    let mut w = [0.0; N];
    let mut i = 0;
    while i < TERMS {
        if squares[i] > 0.0 {
            let c = b[i] / squares[i];
            let mut j = 0;
            while j < N {
                w[j] += c * rows[i][j];
                j += 1;
            }
        }
        i += 1;
    }
    w
}

const fn dot<const N: usize>(x: &[f64; N], y: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    let mut j = 0;
    while j < N {
        sum += x[j] * y[j];
        j += 1;
    }
    sum
}
