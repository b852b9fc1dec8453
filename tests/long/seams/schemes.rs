//! Every scheme, as rows of tables: a new scheme is a new line.

/// Runs a macro for every scheme of a law in equal steps.
macro_rules! for_each_scheme {
    ($run:ident, $($rest:tt)*) => {
        for_each_scene_scheme!($run, $($rest)*);
        $run! { CompensatedLeapfrog, $($rest)* }
        for_each_adaptable_of_laws!($run, $($rest)*);
    };
}
pub(crate) use for_each_scheme;

/// Runs a macro for every scheme of a law that may change its step.
macro_rules! for_each_adaptable {
    ($run:ident, $($rest:tt)*) => {
        for_each_adaptable_of_scenes!($run, $($rest)*);
        for_each_adaptable_of_laws!($run, $($rest)*);
    };
}
pub(crate) use for_each_adaptable;

/// Runs a macro for every scheme of a scene.
macro_rules! for_each_scene_scheme {
    ($run:ident, $($rest:tt)*) => {
        $run! { Explicit, $($rest)* }
        $run! { Leapfrog, $($rest)* }
        $run! { Kanatani, $($rest)* }
        for_each_adaptable_of_scenes!($run, $($rest)*);
    };
}
pub(crate) use for_each_scene_scheme;

/// Runs a macro for the schemes that a scene has too, and whose step may change for a law.
macro_rules! for_each_adaptable_of_scenes {
    ($run:ident, $($rest:tt)*) => {
        $run! { Implicit, $($rest)* }
        $run! { DiscreteGradient, $($rest)* }
        $run! { Composed::order4(Leapfrog), $($rest)* }
        $run! { Composed::order6(Leapfrog), $($rest)* }
        $run! { Composed::order8(Leapfrog), $($rest)* }
        $run! { Composed::order4(DiscreteGradient), $($rest)* }
        $run! { Composed::order6(DiscreteGradient), $($rest)* }
        $run! { Composed::order8(DiscreteGradient), $($rest)* }
        $run! { Nystrom::order4(), $($rest)* }
        $run! { Nystrom::order6(), $($rest)* }
        $run! { Nystrom::order8(), $($rest)* }
    };
}
pub(crate) use for_each_adaptable_of_scenes;

/// Runs a macro for the schemes that only a law has, and whose step may change.
macro_rules! for_each_adaptable_of_laws {
    ($run:ident, $($rest:tt)*) => {
        $run! { Composed::order4(Implicit), $($rest)* }
        $run! { Composed::order6(Implicit), $($rest)* }
        $run! { Composed::order8(Implicit), $($rest)* }
        $run! { ForceGradient::order4(), $($rest)* }
        $run! { ForceGradient::order6(), $($rest)* }
        $run! { ForceGradient::order8(), $($rest)* }
    };
}
pub(crate) use for_each_adaptable_of_laws;
