//! Small matrices: what two bodies are to each other in a Jacobian.

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
    elimination::solve_definite(*x, [0.0; D]).1.iter().all(|&pivot| pivot > 0.0)
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
