//! The named methods of a type: arrays, scaling, and the products as methods without imports.

/// Inherent methods.
#[doc(hidden)]
#[macro_export]
macro_rules! element_methods {
    ($Name:ident $Sum:ident { $($field:ident $label:literal $mask:literal $sign:literal,)* }) => {
        impl<T> $Name<T> {
            $crate::inlined! {
                /// The element with these coefficients, in the order of the fields.
                #[allow(
                    clippy::too_many_arguments,
                    reason = "one argument a field, as many as the type was declared with"
                )]
                pub const fn new($($field: T),*) -> Self {
                    Self { $($field),* }
                }
            }
        }

        impl<T: $crate::Scalar> $Name<T> {
            $crate::inlined! {
                /// The coefficients in the order of the fields.
                pub fn to_array(self) -> [T; { $crate::count!($($field)*) }] {
                    [$(self.$field),*]
                }
            }

            $crate::inlined! {
                /// The element with each coefficient mapped.
                pub fn map<U: $crate::Scalar>(self, mut function: impl ::core::ops::FnMut(T) -> U) -> $Name<U> {
                    $Name { $($field: function(self.$field)),* }
                }
            }

            $crate::inlined! {
                /// The part of one grade; all other coefficients become zero.
                pub fn grade(self, grade: u32) -> $Sum<T>
                where
                    $Sum<T>: ::core::convert::From<$Name<T>>,
                {
                    $crate::convert::grade($Sum::from(self), grade)
                }
            }

            $crate::inlined! {
                /// The coefficient of a blade, if the type stores it.
                pub fn get(&self, blade: $crate::Blade) -> ::core::option::Option<T> {
                    let stored = <Self as $crate::ops::Element>::BLADES;
                    stored
                        .iter()
                        .any(|(own, _)| *own == blade)
                        .then(|| $crate::ops::Element::coefficient(self, blade))
                }
            }

            $crate::inlined! {
                /// The same element as a narrower type, if every coefficient that the narrower type
                /// does not store is within `tolerance` times the largest one of zero, or of its
                /// fixed value.
                ///
                /// # Errors
                /// [`Narrowing`]($crate::Narrowing) with the first blade that is in the way.
                pub fn narrow<B>(self, tolerance: T) -> ::core::result::Result<B, $crate::Narrowing>
                where
                    T: $crate::Real,
                    B: $crate::ops::Element<Number = T>,
                {
                    $crate::convert::narrow(self, tolerance)
                }
            }

            $crate::inlined! {
                /// The norm `√|⟨X X̃⟩|` (2.21); a root more than `norm_squared`.
                pub fn norm(self) -> T
                where
                    T: $crate::Real,
                    Self: $crate::ops::NormSquared<Output = T>,
                {
                    $crate::ops::norm(self)
                }
            }

            $crate::inlined! {
                /// The element over its norm; `None` where the norm is zero or not finite. One division
                /// and a multiplication a coefficient more than `norm`.
                pub fn normalized(self) -> ::core::option::Option<$Sum<T>>
                where
                    T: $crate::Real,
                    Self: $crate::ops::NormSquared<Output = T>,
                    $Sum<T>: ::core::convert::From<$Name<T>>,
                {
                    let norm = self.norm();
                    (norm.is_invertible() && norm.is_finite())
                        .then(|| $Sum::from(self) * (T::ONE / norm))
                }
            }

            $crate::inlined! {
                /// The inverse, the adjugate over the determinant; `None` where there is none. Their
                /// operation counts stand at the implementation of `Inverse` for this type; one
                /// division and a multiplication a coefficient come on top.
                pub fn inverse(self) -> ::core::option::Option<<Self as $crate::ops::Inverse>::Output>
                where
                    Self: $crate::ops::Inverse,
                {
                    $crate::ops::Inverse::inverse(self)
                }
            }

            $crate::inlined! {
                /// The principal logarithm; `None` where no real one exists or it is not unique.
                pub fn log(self) -> ::core::option::Option<<Self as $crate::ops::Logarithm>::Output>
                where
                    Self: $crate::ops::Logarithm,
                {
                    $crate::ops::Logarithm::log(self)
                }
            }

            $crate::inlined! {
                /// The principal square root; `None` where no real one exists or it is not unique.
                pub fn sqrt(self) -> ::core::option::Option<<Self as $crate::ops::SquareRoot>::Output>
                where
                    Self: $crate::ops::SquareRoot,
                {
                    $crate::ops::SquareRoot::sqrt(self)
                }
            }

            $crate::inlined! {
                /// The unit versor `(X X̃)^(−1/2) X`: removes the drift of rounding from any versor,
                /// which dividing by the norm does not; `None` where X X̃ has no inverse square root, or
                /// no positive scalar part.
                pub fn renormalized(self) -> ::core::option::Option<<Self as $crate::ops::Renormalize>::Output>
                where
                    Self: $crate::ops::Renormalize,
                {
                    $crate::ops::Renormalize::renormalized(self)
                }
            }

            $crate::inlined! {
                /// The two commuting blades whose sum the bivector is, where they are unique.
                pub fn split_commuting(self) -> $crate::algorithm::Split<<Self as $crate::ops::SplitCommuting>::Output>
                where
                    Self: $crate::ops::SplitCommuting,
                {
                    $crate::ops::SplitCommuting::split_commuting(self)
                }
            }

            $crate::inlined! {
                /// The orthogonal projection `(a ⌋ B) B⁻¹` onto `b` (2.29); non-finite where `b` has
                /// no inverse. Two contractions and an inverse.
                pub fn project<B>(self, b: B) -> $crate::convert::Projection<Self, B>
                where
                    B: $crate::ops::Inverse + ::core::marker::Copy,
                    Self: $crate::ops::LeftContract<B>,
                    <Self as $crate::ops::LeftContract<B>>::Output:
                        $crate::ops::LeftContract<<B as $crate::ops::Inverse>::Output>,
                {
                    $crate::convert::project(self, b)
                }
            }

            $crate::inlined! {
                /// The orthogonal rejection `(a ∧ B) B⁻¹` from `b` (2.30); non-finite where `b` has
                /// no inverse. An outer product, a contraction and an inverse.
                pub fn reject<B>(self, b: B) -> $crate::convert::Rejection<Self, B>
                where
                    B: $crate::ops::Inverse + ::core::marker::Copy,
                    Self: $crate::ops::Wedge<B>,
                    <Self as $crate::ops::Wedge<B>>::Output:
                        $crate::ops::RightContract<<B as $crate::ops::Inverse>::Output>,
                {
                    $crate::convert::reject(self, b)
                }
            }
        }

        impl<T: $crate::Field> $Name<T> {
            $crate::inlined! {
                /// The matrix of this versor on elements of type `X`: one versor on many elements.
                /// One application for each coefficient of `X`.
                pub fn linear_map<X>(self) -> $crate::LinearMap<Self, X>
                where
                    Self: $crate::ops::Outermorphism<X, Number = T>,
                {
                    $crate::linear_map::linear_map(self)
                }
            }

            $crate::inlined! {
                /// The images of all elements of a slice under this versor, which is divided by its
                /// norm once; by its matrix where that takes fewer multiplications.
                ///
                /// # Errors
                /// [`LengthMismatch`]($crate::LengthMismatch) where the slices are of different
                /// lengths; nothing is written then.
                pub fn apply_slice<X: ::core::marker::Copy>(
                    self,
                    elements: &[X],
                    images: &mut [<Self as $crate::ops::ApplyUnit<X>>::Image],
                ) -> ::core::result::Result<(), $crate::LengthMismatch>
                where
                    Self: $crate::ops::Outermorphism<X, Number = T>,
                {
                    let w = $crate::ops::Versor::over_norm(self);
                    $crate::linear_map::apply_slice(self, w, elements, images)
                }
            }

            $crate::inlined! {
                /// Replaces every element of a slice by its image under this versor, where that is of
                /// the same type; by the matrix where that takes fewer multiplications.
                pub fn apply_slice_in_place<X: ::core::marker::Copy>(self, elements: &mut [X])
                where
                    Self: $crate::ops::Outermorphism<X, Number = T, Image = X>,
                {
                    let w = $crate::ops::Versor::over_norm(self);
                    $crate::linear_map::apply_slice_in_place(self, w, elements);
                }
            }
        }

        $crate::element_methods! { @binary $Name
            /// The geometric product `a b`.
            Geometric geometric
            /// The outer product `a ∧ b`.
            Wedge wedge
            /// The left contraction `a ⌋ b`.
            LeftContract left_contract
            /// The right contraction `a ⌊ b`.
            RightContract right_contract
            /// The inner product `a · b` of (2.71).
            Inner inner
            /// The scalar product `⟨a b⟩`.
            ScalarProduct scalar_product
            /// The regressive product `a ∨ b`.
            Regressive regressive
            /// The commutator product `(ab − ba)/2`.
            Commutator commutator
            /// The anticommutator product `(ab + ba)/2`.
            Anticommutator anticommutator
            /// The quotient `a b⁻¹`; non-finite where `b` has no inverse.
            Quotient quotient
            /// The sandwich `V x̂ Ṽ` with this element as `V`.
            Sandwich sandwich
            /// The versor applied to `b`, `V x̂ V⁻¹` (2.28).
            Apply apply
        }

        $crate::element_methods! { @unary $Name
            /// The reverse.
            Reverse reverse
            /// The grade involution.
            Involute involute
            /// The Clifford conjugate.
            Conjugate conjugate
            /// The dual `A I⁻¹`.
            Dual dual
            /// The inverse of the dual, `A I`.
            Undual undual
            /// The left complement.
            LeftComplement left_complement
            /// The right complement.
            RightComplement right_complement
            /// The squared norm `⟨X X̃⟩` with its sign.
            NormSquared norm_squared
            /// The exponential.
            Exponential exp
        }
    };
    (@binary $Name:ident $($(#[$doc:meta])* $trait:ident $method:ident)*) => {
        impl<T> $Name<T> {
            $(
                $crate::inlined! {
                    $(#[$doc])*
                    ///
                    /// Formula and operation count stand with the implementation of the trait for
                    /// the two types.
                    pub fn $method<B>(self, b: B) -> <Self as $crate::ops::$trait<B>>::Output
                    where
                        Self: $crate::ops::$trait<B>,
                    {
                        $crate::ops::$trait::$method(self, b)
                    }
                }
            )*
        }
    };
    (@unary $Name:ident $($(#[$doc:meta])* $trait:ident $method:ident)*) => {
        impl<T> $Name<T> {
            $(
                $crate::inlined! {
                    $(#[$doc])*
                    ///
                    /// Formula and operation count stand with the implementation of the trait.
                    pub fn $method(self) -> <Self as $crate::ops::$trait>::Output
                    where
                        Self: $crate::ops::$trait,
                    {
                        $crate::ops::$trait::$method(self)
                    }
                }
            )*
        }
    };
}

/// The number of identifiers.
#[doc(hidden)]
#[macro_export]
macro_rules! count {
    ($($name:ident)*) => {
        <[&str]>::len(&[$(stringify!($name)),*])
    };
}
