use super::*;

/// The topologies of a chain, the last of them with a matrix that could hold more.
fn topologies(n: usize) -> [Topology; 4] {
    // Listed once or twice, forwards or backwards: the pattern holds each link once.
    let bonds = (1..n).map(|i| if i % 2 == 0 { (i, i - 1) } else { (i - 1, i) }).chain([(0, 1)]).collect();
    [Topology::Chain, Topology::Sparse { bonds, chain: n > 5 }, Topology::Near, Topology::Dense]
}

/// A dense matrix and the others with the same blocks multiply and solve alike, with rows of pinned bodies among them.
#[test]
fn all_matrices_solve_the_same_system() {
    let n = 7;
    let mut matrices = topologies(n).map(|topology| Matrix::<2>::new(n, &topology));
    #[cfg(feature = "sparse")]
    assert!(matches!(matrices, [Matrix::Chain(_), Matrix::Sparse(_), Matrix::Near(_), Matrix::Dense(_)]));
    let mut g = Vectors::<2>::zeros(n);
    let mut x = Vectors::<2>::zeros(n);
    for i in 0..n {
        let f = i as f64;
        g.set(i, if i == 3 { [0.0; 2] } else { [0.3 + 0.1 * f, 0.7 - 0.05 * f] });
        x.set(i, [(1.3 * f).sin(), (0.7 * f).cos()]);
    }
    // The second time in room that the first has filled with other numbers.
    for scale in [-3.0, 1.0] {
        for matrix in &mut matrices {
            matrix.clear();
            for i in 1..n {
                let f = i as f64;
                let link = [[2.0 + f.sin(), 0.4], [-0.3 * f, 1.5]];
                matrix.add_link(i - 1, i, link.map(|row| row.map(|x| scale * x)));
                matrix.add_block(i, i, [[0.2, 0.1 * f], [-0.6, 0.9]]);
            }
            assert!(matrix.factorise(&g, Kind::Regular));
        }
    }
    let [chain, sparse, near, dense] = matrices.map(|mut matrix| {
        let (mut product, mut solution, mut sums) = (Vectors::zeros(n), x.clone(), Vectors::zeros(n));
        matrix.multiply_add(&x, &mut product);
        matrix.add_row_sums(&mut sums);
        matrix.solve(&g, &mut solution);
        // (1 + g J) x = b.
        let mut residual = solution.clone();
        let mut image = Vectors::zeros(n);
        matrix.multiply_add(&solution, &mut image);
        for (i, r) in residual.flat_mut().iter_mut().enumerate() {
            *r += g.flat()[i] * image.flat()[i] - x.flat()[i];
        }
        assert!(residual.largest() < 1e-14, "{:e}", residual.largest());
        (product, solution, sums)
    });
    for other in [chain, sparse, near] {
        for i in 0..2 * n {
            assert!((other.0.flat()[i] - dense.0.flat()[i]).abs() < 1e-14);
            assert!((other.1.flat()[i] - dense.1.flat()[i]).abs() < 1e-14);
        }
        assert_eq!(other.1.get(3), x.get(3));
        for (sum, of_dense) in other.2.flat().iter().zip(dense.2.flat()) {
            assert!((sum - of_dense).abs() < 1e-14 * of_dense, "{sum}, {of_dense}");
        }
    }
}

/// Bodies that feel others which feel nothing of them: residuals have parts that products of the transposed matrix never reach, so
/// that BiCGSTAB breaks down. Stiff and turning as well, and from right sides with all, some and one of the parts.
#[test]
fn what_is_one_sided_is_solved() {
    let mut harder = 0;
    for n in [2, 3, 6] {
        for (stiffness, turn) in [(0.4, 0.9), (3.0, 0.2), (2.0, 10.0), (1e3, 1.0), (0.0, 40.0)] {
            let mut near = Matrix::<2>::new(n, &Topology::Near);
            let mut g = Vectors::<2>::zeros(n);
            for a in 0..n {
                g.set(a, [0.4 + 0.3 * a as f64; 2]);
                near.add_block(a, a, [[0.0, -turn], [turn, 0.0]]);
                // The even feel nothing of the odd.
                for b in (0..n).filter(|b| *b != a && (a % 2 == 1 || b % 2 == 0)) {
                    near.add_block(a, a, [[stiffness, 0.0], [0.0, stiffness]]);
                    near.add_block(a, b, [[-stiffness, 0.0], [0.0, -stiffness]]);
                }
            }
            assert!(near.factorise(&g, Kind::Regular));
            for only in [None, Some(0), Some(1), Some(n - 1)] {
                let mut b = Vectors::<2>::zeros(n);
                (0..n)
                    .filter(|i| only.is_none_or(|only| only == *i))
                    .for_each(|i| b.set(i, [1e-18, -3e-19 * i as f64]));
                let mut x = b.clone();
                near.solve(&g, &mut x);
                let mut image = Vectors::zeros(n);
                near.multiply_add(&x, &mut image);
                let rows = x.flat().iter().zip(g.flat()).zip(image.flat()).zip(b.flat());
                let left = rows.map(|(((x, g), image), b)| (x + g * image - b).abs()).fold(0.0, f64::max);
                let size = x.largest() * (1.0 + stiffness + turn);
                assert!(left <= 1e-7 * size, "{n}, {stiffness}, {turn}, {only:?}: {left:e} of {size:e}");
                harder += usize::from(x.largest() > 0.0 && !near.is_positive());
            }
        }
    }
    assert!(harder > 40, "{harder}");
}

/// Elimination needs the exchange of rows here: the first pivot is 1 − 1 + 10⁻¹⁷, which rounds to nothing.
#[test]
fn rows_are_exchanged_by_size() {
    // All but the first, and the one that has no factors.
    for topology in topologies(3)[1..].iter().filter(|&topology| *topology != Topology::Near) {
        let mut matrix = Matrix::<1>::new(3, topology);
        let mut g = Vectors::zeros(3);
        g.flat_mut().fill(1.0);
        matrix.add_block(0, 0, [[-1.0 + 1e-14]]);
        matrix.add_block(0, 1, [[2.0]]);
        matrix.add_block(1, 0, [[3.0]]);
        matrix.add_block(1, 2, [[5.0]]);
        matrix.add_block(2, 1, [[7.0]]);
        assert!(matrix.factorise(&g, Kind::Regular));
        let mut x = Vectors::from_list(&[[2.0], [9.0], [8.0]]);
        matrix.solve(&g, &mut x);
        for (found, exact) in x.flat().iter().zip([1.0, 1.0, 1.0]) {
            assert!((found - exact).abs() < 1e-13, "{topology:?}: {found}");
        }
    }
}

/// A small g J is inverted by its power series, a larger one by elimination; both leave no residual beyond rounding.
#[test]
fn large_matrices_are_solved_both_ways() {
    let n = 50;
    let all = (0..n).flat_map(|a| (0..a).map(move |b| (a, b))).collect();
    let sparse = Topology::Sparse { bonds: all, chain: false };
    let scales = [(1e-6, 1e-15), (0.002, 1e-15), (0.005, 1e-14), (0.5, 1e-12)];
    for (topology, (scale, rounding)) in scales.iter().flat_map(|&x| [(&Topology::Dense, x), (&sparse, x)]) {
        let mut matrix = Matrix::<2>::new(n, topology);
        let (mut g, mut x) = (Vectors::zeros(n), Vectors::zeros(n));
        let mut row = 0.0_f64;
        for a in 0..n {
            let f = a as f64;
            g.set(a, if a == 5 { [0.0; 2] } else { [scale, scale * (1.0 + 0.3 * f.sin())] });
            x.set(a, [(1.3 * f).sin(), 0.4 + (0.7 * f).cos()]);
            let mut sum = 0.0;
            for b in 0..n {
                let entry = |k: usize| 0.3 * ((a * (7 + k) + b * b * 3) as f64).cos();
                let block = [[entry(1), entry(2)], [entry(3), entry(4)]];
                matrix.add_block(a, b, block);
                sum += block[1][0].abs() + block[1][1].abs();
            }
            row = row.max(sum * g.get(a)[1]);
        }
        // The scales lie on both sides of where the series ends.
        assert_eq!(row < 1.0 / 16.0, scale < 0.003, "{row}");
        assert!(matrix.factorise(&g, Kind::Regular));
        let (mut solution, mut image) = (x.clone(), Vectors::zeros(n));
        matrix.solve(&g, &mut solution);
        matrix.multiply_add(&solution, &mut image);
        for i in 0..2 * n {
            let residual = solution.flat()[i] + g.flat()[i] * image.flat()[i] - x.flat()[i];
            assert!(residual.abs() < rounding, "scale {scale}: {residual:e}");
        }
        assert_eq!(solution.get(5), x.get(5));
        g.flat_mut()[3] = f64::NAN;
        matrix.factorise(&g, Kind::Regular);
        matrix.solve(&g, &mut x);
        assert!(!x.is_finite());
    }
}

#[test]
fn a_singular_matrix_is_noticed() {
    // Without factors it is noticed by what does not converge.
    for topology in topologies(2).into_iter().filter(|topology| *topology != Topology::Near) {
        let mut matrix = Matrix::<1>::new(2, &topology);
        matrix.add_block(0, 0, [[-1.0]]);
        let mut g = Vectors::zeros(2);
        g.flat_mut().fill(1.0);
        assert!(!matrix.factorise(&g, Kind::Regular), "{topology:?}");
    }
}

/// 1 + g J of a symmetric J, rows with a g of their own, by its eigenvalues: every topology says of the same matrices that they are
/// positive definite, with a positive determinant or without; pinned bodies and links that one end does not feel among them.
#[test]
fn what_is_not_positive_definite_is_noticed() {
    let n = 4;
    let mut seen = [0; 3];
    for seed in 0..400 {
        let wave = |i: usize| ((seed * 37 + i * 11 + 1) as f64 * 0.7).sin();
        let g: [f64; 8] =
            core::array::from_fn(|i| if seed % 5 == 0 && i % n == 2 { 0.0 } else { 0.3 + 0.25 * wave(i) });
        let links: Vec<_> = (1..n)
            .map(|i| {
                let strength = [0.1, 0.4, 1.0, 2.5][seed % 4];
                let [x, y, z] = core::array::from_fn(|k| strength * wave(10 * i + k));
                (i - 1, i, [[x, y], [y, z]])
            })
            .collect();
        let own: Vec<_> = (0..n).map(|i| [[wave(50 + i), 0.3], [0.3, wave(60 + i)]]).collect();
        // Body 3 feels body 2, which does not feel it.
        let one_sided = seed % 3 == 0;
        let mut dense = nalgebra::DMatrix::<f64>::identity(2 * n, 2 * n);
        let mut add = |a: usize, b: usize, block: [[f64; 2]; 2], sign: f64| {
            for (k, l) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let (row, column) = (k * n + a, l * n + b);
                let scale = (g[row] * g[column]).sqrt();
                dense[(row, column)] += sign * scale * block[k][l];
            }
        };
        for (i, &block) in own.iter().enumerate() {
            add(i, i, block, 1.0);
        }
        for &(a, b, block) in &links {
            if one_sided && b == 3 {
                add(b, b, block, 1.0);
            } else {
                for (a, b, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                    add(a, b, block, sign);
                }
            }
        }
        let least = dense.clone().symmetric_eigenvalues().min();
        if least.abs() < 1e-9 {
            continue;
        }
        seen[if least > 0.0 { 0 } else { 1 + usize::from(dense.determinant() > 0.0) }] += 1;
        let mut columns = Vectors::<2>::zeros(n);
        columns.flat_mut().copy_from_slice(&g);
        for topology in topologies(n) {
            let mut matrix = Matrix::<2>::new(n, &topology);
            for (i, &block) in own.iter().enumerate() {
                matrix.add_block(i, i, block);
            }
            for &(a, b, block) in &links {
                if one_sided && b == 3 {
                    matrix.add_block(b, b, block);
                    matrix.add_block(b, a, block.map(|row| row.map(|x| -x)));
                } else {
                    matrix.add_link(a, b, block);
                }
            }
            assert_eq!(matrix.factorise(&columns, Kind::Definite), least > 0.0, "{topology:?}, {seed}: {least}");
            // And so they say of factors made by exchange of rows.
            assert!(matrix.factorise(&columns, Kind::Regular), "{topology:?}, {seed}");
            let continues = matrix.is_positive() || matrix.continues(&columns);
            assert_eq!(continues, least > 0.0, "{topology:?}, {seed}: {least}");
        }
    }
    println!("{seen:?} matrices: definite, of a negative determinant, of a positive one");
    assert!(seen.iter().all(|&n| n >= 20));
}

/// Of a J that is not symmetric it is the sign of the determinant.
#[test]
fn a_negative_determinant_is_noticed() {
    let mut seen = [0; 2];
    for seed in 0..300 {
        // Columns are put in another order, of either sign.
        let n = 3 + seed % 5;
        let wave = |i: usize| 2.5 * ((seed * 53 + i * 17 + 3) as f64 * 0.7).sin();
        let mut g = Vectors::<2>::zeros(n);
        (0..n).for_each(|i| g.set(i, if i == seed % 9 { [0.0; 2] } else { [0.4, 0.3 + 0.05 * i as f64] }));
        let block = |i: usize| [[wave(i), wave(i + 1)], [wave(i + 2), wave(i + 3)]];
        let mut dense = nalgebra::DMatrix::<f64>::identity(2 * n, 2 * n);
        let mut matrices = topologies(n).map(|topology| Matrix::<2>::new(n, &topology));
        for (a, b) in (0..n).map(|a| (a, a)).chain((1..n).flat_map(|a| [(a - 1, a), (a, a - 1)])) {
            let block = block(40 * a + 4 * b);
            for (k, l) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                dense[(k * n + a, l * n + b)] += g.get(a)[k] * block[k][l];
            }
            matrices.iter_mut().for_each(|matrix| matrix.add_block(a, b, block));
        }
        let determinant = dense.determinant();
        if determinant.abs() < 1e-6 {
            continue;
        }
        seen[usize::from(determinant < 0.0)] += 1;
        for matrix in &mut matrices {
            assert!(matrix.factorise(&g, Kind::Regular));
            assert_eq!(matrix.is_positive() || matrix.continues(&g), determinant > 0.0, "{matrix:?}, {seed}");
        }
    }
    assert!(seen.iter().all(|&n| n >= 50), "{seen:?}");
}

/// Entries without an opposite that lead round in a circle, x₀ → x₁ → y₁ → y₀ → x₀: of no symmetric matrix, and with a determinant
/// of d⁴ − c⁴ where d is on the diagonal.
#[test]
fn a_circle_of_entries_is_not_symmetric() {
    let n = 4;
    for (d, c) in [(-2.0, 1.0), (-1.0, 2.0), (1.0, 2.0), (2.0, 1.0)] {
        let mut g = Vectors::<2>::zeros(n);
        g.flat_mut().fill(0.5);
        let own = (d - 1.0) / 0.5;
        let link = c / 0.5;
        for topology in topologies(n) {
            let mut matrix = Matrix::<2>::new(n, &topology);
            matrix.add_block(0, 0, [[own, 0.0], [link, own]]);
            matrix.add_block(1, 1, [[own, link], [0.0, own]]);
            matrix.add_block(0, 1, [[link, 0.0], [0.0, 0.0]]);
            matrix.add_block(1, 0, [[0.0, 0.0], [0.0, link]]);
            assert!(matrix.factorise(&g, Kind::Regular));
            let continues = matrix.is_positive() || matrix.continues(&g);
            assert_eq!(continues, d.abs() > c, "{topology:?}: {d}, {c}");
        }
    }
}
