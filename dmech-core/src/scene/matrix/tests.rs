use super::*;

/// A chain matrix and a dense one with the same blocks multiply and solve alike, with rows of pinned bodies among them.
#[test]
fn both_matrices_solve_the_same_system() {
    let n = 7;
    let mut matrices = [Topology::Chain, Topology::Dense].map(|topology| Matrix::<2>::new(n, &topology));
    let mut g = Vectors::<2>::zeros(n);
    let mut x = Vectors::<2>::zeros(n);
    for i in 0..n {
        let f = i as f64;
        g.set(i, if i == 3 { [0.0; 2] } else { [0.3 + 0.1 * f, 0.7 - 0.05 * f] });
        x.set(i, [(1.3 * f).sin(), (0.7 * f).cos()]);
    }
    for matrix in &mut matrices {
        matrix.clear();
        for i in 1..n {
            let f = i as f64;
            matrix.add_link(i - 1, i, [[2.0 + f.sin(), 0.4], [-0.3 * f, 1.5]]);
            matrix.add_block(i, i, [[0.2, 0.1 * f], [-0.6, 0.9]]);
        }
        assert!(matrix.factorise(&g));
    }
    let [chain, dense] = matrices.map(|mut matrix| {
        let (mut product, mut solution) = (Vectors::zeros(n), x.clone());
        matrix.multiply_add(&x, &mut product);
        matrix.solve(&mut solution);
        // (1 + g J) x = b.
        let mut residual = solution.clone();
        let mut image = Vectors::zeros(n);
        matrix.multiply_add(&solution, &mut image);
        for (i, r) in residual.flat_mut().iter_mut().enumerate() {
            *r += g.flat()[i] * image.flat()[i] - x.flat()[i];
        }
        assert!(residual.largest() < 1e-14, "{:e}", residual.largest());
        (product, solution)
    });
    for i in 0..2 * n {
        assert!((chain.0.flat()[i] - dense.0.flat()[i]).abs() < 1e-14);
        assert!((chain.1.flat()[i] - dense.1.flat()[i]).abs() < 1e-14);
    }
    assert_eq!(chain.1.get(3), x.get(3));
}

#[test]
fn a_singular_matrix_is_noticed() {
    for topology in [Topology::Chain, Topology::Dense] {
        let mut matrix = Matrix::<1>::new(2, &topology);
        matrix.add_block(0, 0, [[-1.0]]);
        let mut g = Vectors::zeros(2);
        g.flat_mut().fill(1.0);
        assert!(!matrix.factorise(&g), "{topology:?}");
    }
}
