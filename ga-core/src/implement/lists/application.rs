//! Versors applied to elements: by products, by the sandwich, by duality.

/// Sandwiches computed as two products, of which only the result's blades are kept.
#[doc(hidden)]
#[macro_export]
macro_rules! composed_sandwich {
    ($Versor:ident even: $($Operand:ident => $Result:ident $doc:literal),*) => {$(
        $crate::composed_sandwich! { @one $Versor $Operand $Result false $doc }
    )*};
    ($Versor:ident odd: $($Operand:ident => $Result:ident $doc:literal),*) => {$(
        $crate::composed_sandwich! { @one $Versor $Operand $Result true $doc }
    )*};
    (@one $Versor:ident $Operand:ident $Result:ident $odd:literal $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Sandwich<$Operand<T>> for $Versor<T> {
            type Output = $Result<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn sandwich(self, x: $Operand<T>) -> $Result<T> {
                    let back = $crate::ops::Reverse::reverse(self);
                    let image = $crate::ops::Geometric::geometric(self, x);
                    let image = $crate::ops::Geometric::geometric(image, back);
                    $crate::convert::image::<_, $Operand<T>, _>(image, $odd)
                }
            }
        }
    };
}

/// What all applications of one versor type have in common; its multiples are of the second type,
/// with `unit` its own.
#[doc(hidden)]
#[macro_export]
macro_rules! versor {
    ($Versor:ident $Number:ident divided $Multiple:ident) => {
        impl<T: $Number> $crate::ops::Versor for $Versor<T> {
            type Number = T;
            type Multiple = $Multiple<T>;
            #[inline(always)]
            fn multiple(self) -> $Multiple<T> {
                $Multiple::from(self)
            }
            #[inline(always)]
            fn over_norm(self) -> $Multiple<T>
            where
                T: $crate::Field,
            {
                let factor = T::ONE / $crate::ops::NormSquared::norm_squared(self);
                $Multiple::from(self) * factor
            }
            $crate::inlined! {
                fn unit(self) -> ::core::option::Option<$Multiple<T>>
                where
                    T: $crate::Real,
                {
                    let positive = T::ZERO.all_le($crate::ops::NormSquared::norm_squared(self));
                    if positive { self.normalized() } else { ::core::option::Option::None }
                }
            }
        }

        impl<T: $crate::Field, X> $crate::ops::Apply<X> for $Versor<T>
        where
            $Versor<T>: $crate::ops::ApplyUnit<X, Number = T>,
        {
            type Output = <$Versor<T> as $crate::ops::ApplyUnit<X>>::Image;
            #[inline(always)]
            fn apply(self, x: X) -> Self::Output {
                $crate::ops::ApplyUnit::apply_divided(self, x)
            }
        }
    };
    ($Versor:ident $Number:ident $promise:ident) => {
        impl<T: $Number> $crate::ops::Versor for $Versor<T> {
            type Number = T;
            type Multiple = Self;
            #[inline(always)]
            fn multiple(self) -> Self {
                self
            }
            #[inline(always)]
            fn over_norm(self) -> Self
            where
                T: $crate::Field,
            {
                self
            }
            $crate::inlined! {
                fn unit(self) -> ::core::option::Option<Self>
                where
                    T: $crate::Real,
                {
                    $crate::versor!(@$promise self T)
                }
            }
        }

        impl<T: $Number, X> $crate::ops::Apply<X> for $Versor<T>
        where
            $Versor<T>: $crate::ops::ApplyUnit<X>,
        {
            type Output = <$Versor<T> as $crate::ops::ApplyUnit<X>>::Image;
            #[inline(always)]
            fn apply(self, x: X) -> Self::Output {
                $crate::ops::ApplyUnit::apply_unit(self, x)
            }
        }
    };
    // Unit by promise: normalised all the same, for rounding.
    (@promised $this:ident $T:ident) => {{
        let positive = $T::ZERO.all_le($crate::ops::NormSquared::norm_squared($this));
        if positive {
            $this.normalized()
        } else {
            ::core::option::Option::None
        }
    }};
    // Unit by its fixed coefficients, as long as the others are numbers.
    (@fixed $this:ident $T:ident) => {{
        let norm = $crate::ops::NormSquared::norm_squared($this);
        (norm.is_finite() && norm.is_invertible() && $T::ZERO.all_le(norm)).then_some($this)
    }};
}

/// Versor application by way of the sandwich, whose type may be another one than the result's.
#[doc(hidden)]
#[macro_export]
macro_rules! application {
    ($Versor:ident $Number:ident unit: $($Operand:ident $doc:literal),*) => {$(
        impl<T: $Number> $crate::ops::ApplyUnit<$Operand<T>> for $Versor<T>
        where
            $Versor<T>: $crate::ops::Sandwich<$Operand<T>>,
        {
            type Image = <$Versor<T> as $crate::ops::Sandwich<$Operand<T>>>::Output;
            $crate::inlined! {
                #[doc = $doc]
                fn apply_with(self, _: Self, x: $Operand<T>) -> Self::Image {
                    $crate::ops::Sandwich::sandwich(self, x)
                }
            }
        }
    )*};
    ($Versor:ident $Multiple:ident divided: $($Operand:ident => $Output:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::ApplyUnit<$Operand<T>> for $Versor<T> {
            type Image = $Output<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn apply_with(self, w: $Multiple<T>, x: $Operand<T>) -> $Output<T> {
                    // Of W = c V with W Ṽ = 1, c is ⟨W W̃⟩.
                    let factor = $crate::ops::NormSquared::norm_squared(w);
                    $crate::convert::multiple($crate::ops::Sandwich::sandwich(self, x), factor)
                }
            }
            $crate::inlined! {
                fn apply_unit(self, x: $Operand<T>) -> $Output<T> {
                    $crate::convert::pick($crate::ops::Sandwich::sandwich(self, x))
                }
            }
            $crate::inlined! {
                fn apply_divided(self, x: $Operand<T>) -> $Output<T> {
                    let factor = T::ONE / $crate::ops::NormSquared::norm_squared(self);
                    $crate::convert::multiple($crate::ops::Sandwich::sandwich(self, x), factor)
                }
            }
        }
    )*};
}

/// Versor application handed on by duality: the pseudoscalar passes through versors, so that
/// `(V I)[x] = V[x̂]` and `V[x I] = ±V[x] I`, minus for odd versors.
///
/// The dual of `V` has the norm of `V` times `⟨I Ĩ⟩`, whose sign is given.
#[doc(hidden)]
#[macro_export]
macro_rules! dual_application {
    ($Versor:ident $sign:tt: $($form:ident $image:tt $Operand:ident => $Output:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::ApplyUnit<$Operand<T>> for $Versor<T> {
            type Image = $Output<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn apply_with(
                    self,
                    w: <Self as $crate::ops::Versor>::Multiple,
                    x: $Operand<T>,
                ) -> $Output<T> {
                    $crate::signed!($image $crate::dual_application!(@with $form $sign self w x))
                }
            }
            $crate::inlined! {
                fn apply_unit(self, x: $Operand<T>) -> $Output<T> {
                    $crate::signed!($image $crate::dual_application!(@unit $form $sign self x))
                }
            }
            $crate::inlined! {
                fn apply_divided(self, x: $Operand<T>) -> $Output<T> {
                    $crate::signed!($image $crate::dual_application!(@by apply_divided $form self x))
                }
            }
        }
    )*};
    (@with versor $sign:tt $v:ident $w:ident $x:ident) => {
        $v.dual().apply_with($crate::signed!($sign $w.dual()), $x)
    };
    (@with involuted $sign:tt $v:ident $w:ident $x:ident) => {
        $v.dual().apply_with($crate::signed!($sign $w.dual()), $x.involute())
    };
    (@with operand $sign:tt $v:ident $w:ident $x:ident) => {
        $v.apply_with($w, $x.dual()).undual()
    };
    // The dual of a unit versor is a unit versor up to the sign.
    (@unit operand $sign:tt $v:ident $x:ident) => {
        $crate::dual_application!(@by apply_unit operand $v $x)
    };
    (@unit $form:ident + $v:ident $x:ident) => {
        $crate::dual_application!(@by apply_unit $form $v $x)
    };
    (@unit $form:ident - $v:ident $x:ident) => {
        $crate::dual_application!(@with $form - $v $v $x)
    };
    (@by $method:ident versor $v:ident $x:ident) => {
        $v.dual().$method($x)
    };
    (@by $method:ident involuted $v:ident $x:ident) => {
        $v.dual().$method($x.involute())
    };
    (@by $method:ident operand $v:ident $x:ident) => {
        $v.$method($x.dual()).undual()
    };
}
