//! The coefficients of Gauss's method with eight stages, and of its projections, from the nodes alone.

use super::digits::Digits;

/// Number of stages.
pub const STAGES: usize = 8;

/// A number for each stage, in two parts: the second is for scalars of more digits than `f64`.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The numbers.
    pub hi: [f64; STAGES],
    /// What they leave out.
    pub lo: [f64; STAGES],
}

/// A matrix by columns: its product with the stages L is Σⱼ columnⱼ Lⱼ.
pub type Columns = [Row; STAGES];

/// The coefficients of a method whose stages are Yᵢ = y + Σⱼ μᵢⱼ Lⱼ with Lⱼ = h bⱼ f(Yⱼ).
///
/// With the Legendre polynomials P of [−1, 1], xᵢ their zeros in degree 8, the force is projected on the first s of them:
///
/// ```text
/// cᵢ = (1 + xᵢ)/2,   bᵢ = 1/((1 − xᵢ²) P₈′(xᵢ)²)
/// μᵢⱼ = (1 + xᵢ)/2 + Σ_{0<k<s} (P_{k+1}(xᵢ) − P_{k−1}(xᵢ))/2 · P_k(xⱼ)
/// νᵢⱼ = Σₘ μᵢₘ bₘ μₘⱼ,   λᵢⱼ = Σₘ (Σ_{k<s} (2k + 1) P_k(xᵢ) P_k(xₘ)) bₘ μₘⱼ
/// ```
///
/// For s = 8 that is Gauss's method (Butcher 1964): μᵢⱼ = aᵢⱼ/bⱼ and λ = μ; for less Brugnano, Iavernaro and Trigiante's
/// HBVM(8, s). Coefficients are multiples of 2⁻⁵², so that μᵢⱼ + μⱼᵢ = 1 and νᵢⱼ − νⱼᵢ = cᵢ − cⱼ hold without rounding where they
/// make a step symplectic, and what makes it symmetric holds for all.
#[derive(Clone, Copy, Debug)]
pub struct Tableau {
    /// cᵢ, when a stage is.
    pub nodes: Row,
    /// 1 − cᵢ.
    pub rests: Row,
    /// bᵢ.
    pub weights: Row,
    /// μ, from forces to velocities.
    pub speeds: Columns,
    /// ν, from forces to positions.
    pub places: Columns,
    /// λ, from forces to the velocities at which they work.
    pub working: Columns,
    /// bᵢ ℓⱼ(1 + cᵢ)/bⱼ: the polynomial of the last step, continued.
    pub continued: Columns,
    /// 1/Πₖ(cⱼ − cₖ)/bⱼ, for steps of another length.
    pub barycentric: Row,
    /// (2k + 1) Pₖ(xⱼ) for k = 4 … 7: what the highest of Legendre's polynomials have of a force.
    pub highest: [Row; 4],
}

/// Gauss's method itself. No static: a register of numbers that are known need not be kept beside those that change.
pub(crate) const GAUSS: Tableau = Tableau::of(STAGES);

/// Half of the zeros of P₈; to forty digits 0.1834346424956498049394761423601839806668,
/// 0.5255324099163289858177390491892463490420, 0.7966664774136267395915539364758304368372 and
/// 0.9602898564975362316835608685694729904282.
const ZEROS: [Digits; STAGES / 2] = [
    Digits { hi: 0.1834346424956498, lo: -2.8967682069859046e-18 },
    Digits { hi: 0.525532409916329, lo: -4.999907577775897e-18 },
    Digits { hi: 0.7966664774136267, lo: 1.1625719829749724e-17 },
    Digits { hi: 0.9602898564975363, lo: -5.54885067908428e-17 },
];

/// 2⁵² and 2⁵³.
const GRIDS: [f64; 2] = [4_503_599_627_370_496.0, 9_007_199_254_740_992.0];

const NO_ROW: Row = Row { hi: [0.0; STAGES], lo: [0.0; STAGES] };

impl Row {
    const fn set(&mut self, i: usize, x: Digits) {
        self.hi[i] = x.hi;
        self.lo[i] = x.lo;
    }
}

/// P₀(x) … P₈(x).
const fn legendre(x: Digits) -> [Digits; STAGES + 1] {
    let mut p = [Digits::ONE; STAGES + 1];
    p[1] = x;
    let mut k = 1;
    while k < STAGES {
        // (k + 1) P_{k+1} = (2k + 1) x P_k − k P_{k−1}.
        let next = Digits::of((2 * k + 1) as f64).times(x.times(p[k]));
        let next = next.minus(Digits::of(k as f64).times(p[k - 1]));
        p[k + 1] = next.over(Digits::of((k + 1) as f64));
        k += 1;
    }
    p
}

impl Tableau {
    /// The method that projects the force on the first s polynomials.
    pub(crate) const fn of(s: usize) -> Tableau {
        let mut p = [[Digits::ZERO; STAGES + 1]; STAGES];
        let (mut nodes, mut weights) = ([Digits::ZERO; STAGES], [Digits::ZERO; STAGES]);
        let mut i = 0;
        while i < STAGES {
            let zero = ZEROS[if i < STAGES / 2 { STAGES / 2 - 1 - i } else { i - STAGES / 2 }];
            let x = if i < STAGES / 2 { Digits::ZERO.minus(zero) } else { zero };
            p[i] = legendre(x);
            nodes[i] = Digits::ONE.plus(x).scaled(0.5);
            // (1 − x²) P₈′ = 8 P₇ at a zero of P₈.
            let square = Digits::ONE.minus(x.times(x));
            weights[i] = square.over(Digits::of(64.0).times(p[i][STAGES - 1].times(p[i][STAGES - 1])));
            i += 1;
        }

        let (mut speed, mut projected) = ([[Digits::ZERO; STAGES]; STAGES], [[Digits::ZERO; STAGES]; STAGES]);
        let mut i = 0;
        while i < STAGES {
            let mut j = 0;
            while j < STAGES {
                (speed[i][j], projected[i][j]) = (nodes[i], Digits::ONE);
                let mut k = 1;
                while k < s {
                    // For s = 8 the zero that P₈ has at its nodes is exact.
                    let above = if k + 1 == STAGES { Digits::ZERO } else { p[i][k + 1] };
                    let rise = above.minus(p[i][k - 1]).scaled(0.5);
                    speed[i][j] = speed[i][j].plus(rise.times(p[j][k]));
                    let term = Digits::of((2 * k + 1) as f64).times(p[i][k].times(p[j][k]));
                    projected[i][j] = projected[i][j].plus(term);
                    k += 1;
                }
                j += 1;
            }
            i += 1;
        }
        let place = product(&speed, &weights, &speed);
        let working = if s == STAGES { speed } else { product(&projected, &weights, &speed) };

        let mut all = Tableau {
            nodes: NO_ROW,
            rests: NO_ROW,
            weights: NO_ROW,
            speeds: [NO_ROW; STAGES],
            places: [NO_ROW; STAGES],
            working: [NO_ROW; STAGES],
            continued: [NO_ROW; STAGES],
            barycentric: NO_ROW,
            highest: [NO_ROW; 4],
        };
        let mut j = 0;
        while j < STAGES {
            all.nodes.set(j, nodes[j].on_grid(GRIDS[1]));
            all.rests.set(j, Digits::ONE.minus(nodes[j]).on_grid(GRIDS[1]));
            all.weights.set(j, weights[j]);
            let mut k = STAGES - 4;
            while k < STAGES {
                all.highest[k + 4 - STAGES].set(j, Digits::of((2 * k + 1) as f64).times(p[j][k]));
                k += 1;
            }
            let mut i = 0;
            while i < STAGES {
                all.speeds[j].set(i, speed[i][j].on_grid(GRIDS[0]));
                all.working[j].set(i, working[i][j].on_grid(GRIDS[0]));
                all.places[j].set(i, place_on_grid(&place, &nodes, i, j));
                let x = Digits::ONE.plus(nodes[i]);
                all.continued[j].set(i, lagrange(&nodes, j, x).times(weights[i]).over(weights[j]));
                i += 1;
            }
            all.barycentric.set(j, Digits::ONE.over(spread(&nodes, j, nodes[j]).times(weights[j])));
            j += 1;
        }
        all
    }
}

/// X diag(b) Y.
const fn product(
    x: &[[Digits; STAGES]; STAGES],
    b: &[Digits; STAGES],
    y: &[[Digits; STAGES]; STAGES],
) -> [[Digits; STAGES]; STAGES] {
    let mut all = [[Digits::ZERO; STAGES]; STAGES];
    let mut i = 0;
    while i < STAGES {
        let mut j = 0;
        while j < STAGES {
            let mut m = 0;
            while m < STAGES {
                all[i][j] = all[i][j].plus(x[i][m].times(b[m]).times(y[m][j]));
                m += 1;
            }
            j += 1;
        }
        i += 1;
    }
    all
}

/// νᵢⱼ on the grid: below the diagonal cᵢ − cⱼ more than the number next to it, above it the number.
const fn place_on_grid(place: &[[Digits; STAGES]; STAGES], nodes: &[Digits; STAGES], i: usize, j: usize) -> Digits {
    if i <= j {
        return place[i][j].on_grid(GRIDS[1]);
    }
    let (late, early) = (nodes[i].on_grid(GRIDS[1]), nodes[j].on_grid(GRIDS[1]));
    let above = place[i][j].minus(nodes[i].minus(nodes[j])).on_grid(GRIDS[1]);
    let hi = above.hi + (late.hi - early.hi);
    Digits { hi, lo: (place[i][j].hi - hi) + place[i][j].lo }
}

/// Π (x − cₖ) over all k but j.
const fn spread(nodes: &[Digits; STAGES], j: usize, x: Digits) -> Digits {
    let (mut product, mut k) = (Digits::ONE, 0);
    while k < STAGES {
        if k != j {
            product = product.times(x.minus(nodes[k]));
        }
        k += 1;
    }
    product
}

/// ℓⱼ(x).
const fn lagrange(nodes: &[Digits; STAGES], j: usize, x: Digits) -> Digits {
    spread(nodes, j, x).over(spread(nodes, j, nodes[j]))
}
