//! The state of a scene.

/// Time, positions and velocities of the bodies of a scene, in the order in which they were added.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneState<const D: usize> {
    /// Time.
    pub t: f64,
    /// Positions.
    pub q: Vec<[f64; D]>,
    /// Velocities.
    pub v: Vec<[f64; D]>,
}

impl<const D: usize> SceneState<D> {
    /// The same positions with all velocities turned round: where a reversible motion goes back from.
    pub fn reversed(mut self) -> Self {
        for v in &mut self.v {
            *v = v.map(|v| -v);
        }
        self
    }
}
