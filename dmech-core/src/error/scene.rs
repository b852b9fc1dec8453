//! What can be wrong with a scene before it moves.

use thiserror::Error;

use crate::text::Number;

/// Why a scene cannot be set up.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A scene without bodies.
    #[error("the scene has no bodies")]
    Empty,
    /// The mass of a body is zero, negative, infinite or NaN.
    #[error("the mass of body {body} must be positive and finite, not {}", Number(*mass))]
    Mass {
        /// The body, counted from 0.
        body: usize,
        /// The refused mass.
        mass: f64,
    },
    /// A component of the position or velocity of a body is infinite or NaN.
    #[error("body {body} must have a finite state: {quantity} = {}", Number(*value))]
    State {
        /// The body, counted from 0.
        body: usize,
        /// `q` or `v`.
        quantity: &'static str,
        /// The refused value.
        value: f64,
    },
    /// A pin on a body that is not there.
    #[error("body {body} cannot be pinned or driven: the bodies are 0 to {}", bodies - 1)]
    Pin {
        /// The body.
        body: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// A change of a body that is not there.
    #[error("there is no body {body}: the bodies are 0 to {}", bodies - 1)]
    NoBody {
        /// The body.
        body: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// The distance of an encounter is zero, negative, infinite or NaN.
    #[error("bodies meet at a positive, finite distance, not {}", Number(*distance))]
    Encounter {
        /// The refused distance.
        distance: f64,
    },
    /// Two bodies of `collide_at` that are nearer than they may come, as they have begun or something else has put them, come nearer still.
    #[error(
        "at t = {} bodies {a} and {b} are {} apart, nearer than the {} at which bodies collide here, and come nearer \
         still: nothing would keep them apart",
        Number(*time),
        Number(*apart),
        Number(*distance)
    )]
    Overlap {
        /// The first body.
        a: usize,
        /// The second.
        b: usize,
        /// Their distance.
        apart: f64,
        /// The distance at which bodies collide.
        distance: f64,
        /// The time.
        time: f64,
    },
    /// A pinned body with a velocity.
    #[error("body {body} is pinned and must be at rest: a component of its velocity is {}", Number(*speed))]
    PinnedMoves {
        /// The body.
        body: usize,
        /// A component of its velocity.
        speed: f64,
    },
    /// A change of a body that moves along a given path.
    #[error("body {body} moves along a given path: it cannot be put elsewhere")]
    Driven {
        /// The body.
        body: usize,
    },
    /// Two given paths of a body.
    #[error("body {body} is driven along two paths: a body has one `.drive({body}, …)`")]
    DrivenTwice {
        /// The body.
        body: usize,
    },
    /// A bond with a body that is not there.
    #[error("no bond between {a} and {b}: the bodies are 0 to {}", bodies - 1)]
    Bond {
        /// The first body.
        a: usize,
        /// The second body.
        b: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// A bond of a body with itself.
    #[error("body {body} is bonded to itself")]
    SelfBond {
        /// The body.
        body: usize,
    },
    /// A bond that is listed twice.
    #[error("the bond between bodies {a} and {b} is listed twice")]
    DuplicateBond {
        /// The first body.
        a: usize,
        /// The second body.
        b: usize,
    },
    /// A state with another number of bodies to start from.
    #[error("the state has positions or velocities of {given} bodies, the scene has {bodies}")]
    Bodies {
        /// Those of the state.
        given: usize,
        /// Those of the scene.
        bodies: usize,
    },
    /// A scene that is to be a law of another number of bodies.
    #[error(
        "the scene has {bodies} bodies, and the law was said to be of {declared}: the first number of `::<{bodies}, _>()`"
    )]
    NotSoMany {
        /// Those of the scene.
        bodies: usize,
        /// Those of the law.
        declared: usize,
    },
    /// A body that moves along a given path, where the scene is to be a law; or a test body, where it is to be one without.
    #[error(
        "body {body} is driven, or a test body: in a law of few bodies each is free or pinned, and test bodies are those of `as_restricted_law`"
    )]
    NotFree {
        /// The body.
        body: usize,
    },
    /// A length of a periodic box that is zero, negative, infinite or NaN.
    #[error("the length of the box along coordinate {component} must be positive and finite, not {}", Number(*length))]
    Length {
        /// The coordinate, counted from 0.
        component: usize,
        /// The refused length.
        length: f64,
    },
    /// A cut-off that is zero, negative, infinite or NaN, or whose square is.
    #[error("the cut-off must be positive and finite, and so must its square, not {}", Number(*cutoff))]
    Cutoff {
        /// The refused cut-off.
        cutoff: f64,
    },
    /// A cut-off so long that it reaches a body and its image.
    #[error(
        "the cut-off {} is longer than half the box, whose length along coordinate {component} is {}: a body would be within reach of two images of another",
        Number(*cutoff),
        Number(*length)
    )]
    CutoffInBox {
        /// The refused cut-off.
        cutoff: f64,
        /// The coordinate, counted from 0.
        component: usize,
        /// The length of the box along it.
        length: f64,
    },
    /// A cut-off of a law whose potential depends on the direction.
    #[error(
        "a law can be cut off where it depends on the distance alone, so that it has one value there by which it is shifted: write it with `r: f64` in place of `d`"
    )]
    CutoffNotCentral,
}
