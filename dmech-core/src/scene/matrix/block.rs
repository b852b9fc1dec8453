//! Small matrices: what two bodies are to each other in a Jacobian.

use super::opposite;
use crate::newton::elimination;

/// D×D numbers.
pub(crate) type Block<const D: usize> = [[f64; D]; D];

/// X += Y.
#[inline(always)]
pub(crate) fn add<const D: usize>(x: &mut Block<D>, y: Block<D>) {
    for k in 0..D {
        for l in 0..D {
            x[k][l] += y[k][l];
        }
    }
}

/// X −= Y.
#[inline(always)]
pub(crate) fn subtract<const D: usize>(x: &mut Block<D>, y: Block<D>) {
    for k in 0..D {
        for l in 0..D {
            x[k][l] -= y[k][l];
        }
    }
}

/// Row k times g_k.
#[inline(always)]
pub(crate) fn scaled<const D: usize>(g: [f64; D], x: &Block<D>) -> Block<D> {
    let mut all = *x;
    for k in 0..D {
        for l in 0..D {
            all[k][l] *= g[k];
        }
    }
    all
}

#[inline(always)]
pub(crate) fn times<const D: usize>(block: &Block<D>, x: [f64; D]) -> [f64; D] {
    let mut all = [0.0; D];
    for k in 0..D {
        all[k] = (0..D).map(|l| block[k][l] * x[l]).sum();
    }
    all
}

#[inline(always)]
pub(crate) fn product<const D: usize>(x: &Block<D>, y: &Block<D>) -> Block<D> {
    let mut all = [[0.0; D]; D];
    for k in 0..D {
        for l in 0..D {
            all[k][l] = (0..D).map(|m| x[k][m] * y[m][l]).sum();
        }
    }
    all
}

/// X is positive definite, if it is symmetric, its rows scaled or not.
#[inline(always)]
pub(crate) fn definite<const D: usize>(x: &Block<D>) -> bool {
    least_pivot(x) > 0.0
}

/// The least pivot of X, without an exchange of rows, or a number of its sign.
#[inline(always)]
pub(crate) fn least_pivot<const D: usize>(x: &Block<D>) -> f64 {
    let lesser = |x: f64, y: f64| if y < x { y } else { x };
    if D == 2 {
        return lesser(x[0][0], x[0][0] * x[1][1] - x[0][1] * x[1][0]);
    }
    let (mut rest, mut least) = (*x, f64::INFINITY);
    for k in 0..D {
        least = lesser(least, rest[k][k]);
        for i in k + 1..D {
            let factor = rest[i][k] / rest[k][k];
            for j in k + 1..D {
                rest[i][j] -= factor * rest[k][j];
            }
        }
    }
    least
}

/// A number that no eigenvalue of (X + Xᵀ)/2 is below: one and two dimensions the least of them, in more not far from it where
/// that is small or above 0.
pub(crate) fn least<const D: usize>(x: &Block<D>) -> f64 {
    let mean: Block<D> = core::array::from_fn(|k| core::array::from_fn(|l| 0.5 * (x[k][l] + x[l][k])));
    if D == 2 {
        let [a, b, d] = [mean[0][0], mean[0][1], mean[1][1]];
        return 0.5 * (a + d) - (0.5 * (a - d)).hypot(b);
    }
    let size = mean.as_flattened().iter().map(|x| x.abs()).fold(0.0, f64::max);
    let lifted = |share: f64| {
        let mut block = mean;
        (0..D).for_each(|k| block[k][k] += share * size);
        definite(&block)
    };
    match [0.0, 0.01, 0.03, 0.1, 0.3, 1.0].into_iter().find(|&share| lifted(share)) {
        Some(share) => -share * size,
        None => -(D as f64) * size,
    }
}

/// X = Xᵀ, to rounding.
pub(crate) fn is_symmetric<const D: usize>(x: &Block<D>) -> bool {
    mirrored(x, x, [x, x])
}

/// X = Yᵀ beside two blocks on the diagonal, to rounding.
pub(crate) fn mirrored<const D: usize>(x: &Block<D>, y: &Block<D>, diagonal: [&Block<D>; 2]) -> bool {
    let [a, b] = diagonal;
    (0..D).all(|k| (0..D).all(|l| opposite([x[k][l], y[l][k]], [a[k][k], b[l][l]])))
}

/// X⁻¹, column by column.
#[inline(always)]
pub(crate) fn invert<const D: usize>(x: &Block<D>) -> Block<D> {
    if D == 1 {
        return x.map(|row| row.map(f64::recip));
    }
    let mut inverse = [[0.0; D]; D];
    for l in 0..D {
        let column = elimination::solve(*x, core::array::from_fn(|k| f64::from(u8::from(k == l))));
        for k in 0..D {
            inverse[k][l] = column[k];
        }
    }
    inverse
}
