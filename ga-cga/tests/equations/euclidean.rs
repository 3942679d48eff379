//! The algebras of §2.2 and §2.3: the plane, space, one dimension more, the Minkowski plane,
//! and a metric with all three signs.

ga_macros::define_algebra!(R2);
ga_macros::define_algebra!(R3);
ga_macros::define_algebra!(R4);
ga_macros::define_algebra!(R1_1_1);
ga_macros::define_algebra!(R1_1);
