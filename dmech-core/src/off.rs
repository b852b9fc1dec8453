//! Methods of features that are off: their names say which feature they are of.
//!
//! A name that is not there is told as "no method named `plot`", also to those who have it from the guide. So it is there without its
//! feature, with a bound that nothing fulfils, and the message of the bound is read instead.

/// Bounds that nothing fulfils, each with what is said of a feature that is off.
macro_rules! features {
    ($($bound:ident: $message:literal, $note:literal;)*) => {$(
        /// A feature that is off.
        #[diagnostic::on_unimplemented(message = $message, label = "is compiled with this feature only", note = $note)]
        pub trait $bound {
            /// What its methods would give.
            fn nothing<T>() -> T;
        }
    )*};
}

features! {
    FeaturePlot: "pictures are a feature of dmech, `plot`, which is off",
        "in Cargo.toml: dmech = {{ …, features = [\"plot\"] }}";
    FeatureProgress: "a progress bar is a feature of dmech, `progress`, which is off",
        "in Cargo.toml: dmech = {{ …, features = [\"progress\"] }}";
    FeatureSerde: "checkpoints are a feature of dmech, `serde`, which is off",
        "in Cargo.toml: dmech = {{ …, features = [\"serde\"] }}";
    FeatureStore: "ensembles that are kept in a database are a feature of dmech, `store`, which is off",
        "in Cargo.toml: dmech = {{ …, features = [\"store\"] }}";
    FeatureRanks: "ensembles over several processes are a feature of dmech, `ranks`, which is off",
        "in Cargo.toml: dmech = {{ …, features = [\"ranks\"] }}";
    FeatureScene: "scenes of bodies are a feature of dmech, `scene`, which is off",
        "in Cargo.toml: dmech = {{ …, features = [\"scene\"] }}; it is on where `default-features = false` is not said";
}

// Written out: of a bound that a macro makes, the compiler shows the macro.

#[cfg(not(feature = "plot"))]
mod plot {
    use std::io;
    use std::path::Path;

    use super::FeaturePlot;
    use crate::{Invariant, Run};

    impl<X> Run<X> {
        #[doc(hidden)]
        pub fn plot(&self, _: impl AsRef<Path>) -> io::Result<()>
        where
            Self: FeaturePlot,
        {
            Self::nothing()
        }

        #[doc(hidden)]
        pub fn plot_energy(&self, _: impl AsRef<Path>) -> io::Result<()>
        where
            Self: FeaturePlot,
        {
            Self::nothing()
        }

        #[doc(hidden)]
        pub fn plot_drift(&self, _: Invariant, _: impl AsRef<Path>) -> io::Result<()>
        where
            Self: FeaturePlot,
        {
            Self::nothing()
        }

        #[doc(hidden)]
        pub fn plot_drift_of(&self, _: &str, _: impl AsRef<Path>) -> io::Result<()>
        where
            Self: FeaturePlot,
        {
            Self::nothing()
        }
    }
}

#[cfg(not(feature = "progress"))]
mod progress {
    use std::borrow::Cow;

    use super::FeatureProgress;
    use crate::ensemble::EachAlone;
    use crate::{Ensemble, Simulation};

    impl<L, X, S, O> Simulation<L, X, S, O> {
        #[doc(hidden)]
        pub fn with_progress(self, _: impl Into<Cow<'static, str>>) -> Self
        where
            Self: FeatureProgress,
        {
            Self::nothing()
        }

        #[doc(hidden)]
        pub fn with_progress_bar(self, _: impl Sized) -> Self
        where
            Self: FeatureProgress,
        {
            Self::nothing()
        }
    }

    impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
        #[doc(hidden)]
        pub fn with_progress(self, _: impl Into<Cow<'static, str>>) -> Self
        where
            Self: FeatureProgress,
        {
            Self::nothing()
        }

        #[doc(hidden)]
        pub fn with_progress_bar(self, _: impl Sized) -> Self
        where
            Self: FeatureProgress,
        {
            Self::nothing()
        }
    }

    impl<F, K> EachAlone<F, K> {
        #[doc(hidden)]
        pub fn with_progress(self, _: impl Into<Cow<'static, str>>) -> Self
        where
            Self: FeatureProgress,
        {
            Self::nothing()
        }

        #[doc(hidden)]
        pub fn with_progress_bar(self, _: impl Sized) -> Self
        where
            Self: FeatureProgress,
        {
            Self::nothing()
        }
    }
}

#[cfg(not(feature = "serde"))]
mod serde {
    use super::FeatureSerde;
    use crate::scheme::Scheme;
    use crate::setup::Setup;
    use crate::system::System;
    use crate::{Error, Simulation, Stepper};

    impl<Y: System, S: Scheme<Y>> Stepper<Y, S> {
        #[doc(hidden)]
        pub fn checkpoint(&self)
        where
            Self: FeatureSerde,
        {
            Self::nothing()
        }
    }

    impl<L, X: Setup<L>, S: Scheme<X::System>, O> Simulation<L, X, S, O> {
        #[doc(hidden)]
        pub fn resume(self, _: impl Sized) -> Result<Stepper<X::System, S>, Error>
        where
            Self: FeatureSerde,
        {
            Self::nothing()
        }
    }
}

#[cfg(not(feature = "store"))]
mod store {
    use std::path::Path;

    use super::FeatureStore;
    use crate::Ensemble;
    use crate::ensemble::EachAlone;

    impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
        #[doc(hidden)]
        pub fn store(self, _: impl AsRef<Path>) -> Self
        where
            Self: FeatureStore,
        {
            Self::nothing()
        }
    }

    impl<F, K> EachAlone<F, K> {
        #[doc(hidden)]
        pub fn store(self, _: impl AsRef<Path>) -> Self
        where
            Self: FeatureStore,
        {
            Self::nothing()
        }
    }
}

#[cfg(not(feature = "ranks"))]
mod ranks {
    use super::FeatureRanks;
    use crate::Ensemble;
    use crate::ensemble::EachAlone;

    impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
        #[doc(hidden)]
        pub fn ranks(self, _: &impl Sized) -> Self
        where
            Self: FeatureRanks,
        {
            Self::nothing()
        }
    }

    impl<F, K> EachAlone<F, K> {
        #[doc(hidden)]
        pub fn ranks(self, _: &impl Sized) -> Self
        where
            Self: FeatureRanks,
        {
            Self::nothing()
        }
    }
}

#[cfg(not(feature = "scene"))]
mod scene {
    use super::FeatureScene;
    use crate::Simulation;

    impl Simulation<(), ()> {
        // Of no argument, whose type is not known where `Scene` is none; a bound without a lifetime would be refused here.
        #[doc(hidden)]
        pub fn scene<'a>(_: impl Sized) -> Self
        where
            &'a Self: FeatureScene,
        {
            <&Self as FeatureScene>::nothing()
        }
    }
}
