//! nalgebra's vectors, against the same formulas written out.

use super::{assert_same, body, lower_text, points, value};

/// A law of three coordinates with the vectors c = self.c and the number k = self.k.
fn assert_vector(text: &str, rust: impl Fn([f64; 3], [f64; 3], f64) -> f64) {
    let (c, k) = ([0.3, -0.2, 0.9], 1.7);
    let source = |path: &str| match path {
        "self.k" => Some(k),
        "self.c[0]" | "self.c.x" => Some(c[0]),
        "self.c[1]" => Some(c[1]),
        "self.c[2]" => Some(c[2]),
        _ => None,
    };
    for position in ["Vector3<f64>", "SVector<f64, 3>", "nalgebra::Vector3<f64>", "na::SVector<f64, 3>"] {
        let lowered = lower_text(&body(position, text)).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        let pairs: Vec<_> = points(3, true)
            .into_iter()
            .map(|q| (value(&lowered, &q, 1.0, 0.0, &source), rust([q[0], q[1], q[2]], c, k)))
            .collect();
        assert_same(text, &pairs);
    }
}

fn dot(u: [f64; 3], w: [f64; 3]) -> f64 {
    u[0] * w[0] + u[1] * w[1] + u[2] * w[2]
}

#[test]
fn norms() {
    assert_vector("-self.k / q.norm()", |q, _, k| -k / dot(q, q).sqrt());
    assert_vector("q.norm_squared() + q.magnitude()", |q, _, _| dot(q, q) + dot(q, q).sqrt());
    assert_vector("q.metric_distance(&self.c)", |q, c, _| {
        let d = [q[0] - c[0], q[1] - c[1], q[2] - c[2]];
        dot(d, d).sqrt()
    });
}

#[test]
fn arithmetic() {
    assert_vector("let d = q - self.c; d.dot(&d)", |q, c, _| (0..3).map(|i| (q[i] - c[i]) * (q[i] - c[i])).sum());
    assert_vector("(2.0 * q + q * self.k - q / 3.0).y", |q, _, k| 2.0 * q[1] + q[1] * k - q[1] / 3.0);
    assert_vector("(-q).x + (self.c + q)[2] + self.c.x * q.z", |q, c, _| -q[0] + c[2] + q[2] + c[0] * q[2]);
    assert_vector("let mut d = q; d += self.c; d *= 2.0; d.x -= q.y; d[1] /= 4.0; d.x * d.y + d.z", |q, c, _| {
        (2.0 * (q[0] + c[0]) - q[1]) * (2.0 * (q[1] + c[1]) / 4.0) + 2.0 * (q[2] + c[2])
    });
}

#[test]
fn products() {
    assert_vector("q.dot(&self.c) + self.c.dot(&q)", |q, c, _| 2.0 * dot(q, c));
    assert_vector("q.cross(&self.c).y", |q, c, _| q[2] * c[0] - q[0] * c[2]);
    assert_vector("let c: Vector3<f64> = self.c; q.cross(&c).norm() + c.norm()", |q, c, _| {
        let u = [q[1] * c[2] - q[2] * c[1], q[2] * c[0] - q[0] * c[2], q[0] * c[1] - q[1] * c[0]];
        dot(u, u).sqrt() + dot(c, c).sqrt()
    });
    assert_vector("q.component_mul(&q).sum() + q.normalize().x", |q, _, _| dot(q, q) + q[0] / dot(q, q).sqrt());
}

#[test]
fn constructors_and_elements() {
    assert_vector("let e = Vector3::new(1.0, self.k, q.x); e.dot(&q)", |q, _, k| q[0] + k * q[1] + q[0] * q[2]);
    assert_vector("let e = nalgebra::Vector3::from([0.0, 1.0, 2.0]); (q - e).norm_squared()", |q, _, _| {
        q[0] * q[0] + (q[1] - 1.0).powi(2) + (q[2] - 2.0).powi(2)
    });
    assert_vector("(SVector::<f64, 3>::repeat(0.5) + q + Vector3::zeros()).z", |q, _, _| 0.5 + q[2]);
    assert_vector("q.iter().map(|x| x.sin()).sum::<f64>() + q.map(|x| x * x).y + q[1]", |q, _, _| {
        q.iter().map(|x| x.sin()).sum::<f64>() + q[1] * q[1] + q[1]
    });
    assert_vector(
        "let mut s = 0.0; for i in 0..q.len() { s += q[i] * i as f64; } for x in q.iter() { s *= x; } s",
        |q, _, _| (q[1] + 2.0 * q[2]) * q[0] * q[1] * q[2],
    );
}

#[test]
fn a_helper_takes_a_vector() {
    let text = "impl Law { fn distance(&self, q: &Vector3<f64>) -> f64 { (q - self.c).norm() }
        #[potential] fn energy(&self, q: Vector3<f64>) -> f64 { self.distance(&q) } }";
    let lowered = lower_text(text).unwrap();
    let names: Vec<_> = lowered.parameters.iter().map(|p| lowered.graph.name(p.symbol)).collect();
    assert_eq!(names, ["c_0", "c_1", "c_2"]);
}
