//! Why an operation misses its goal where it does, and what was tried: printed below a table for
//! the rows that miss.

/// What is to be said of an operation; nothing of most.
pub fn remark(operation: &str) -> Option<&'static str> {
    Some(match operation {
        "rotor·rotor" => {
            "the product is one and the same, 16 multiplications; a loop over structs is \
             vectorised as the compiler likes, glam's f32 quaternion by hand; by slices it is in \
             lanes"
        }
        "motor·motor" => {
            "a motor has 48 multiplications for 8 numbers, an isometry of quaternion and vector 31 \
             for 7, glam's matrix is multiplied in vectors by hand; tried for the loop: sums in the \
             order of the left and of the right factor, signs on either factor, no fused \
             operations, of which none reaches the others; by slices several products are \
             computed at a time"
        }
        "motor-on-point" => {
            "a matrix has 9 multiplications for a point, a motor 18, and glam's columns are vectors \
             by type; it has twice the size of a motor, and has to be made of the motion first; by \
             slices motors are in lanes"
        }
        "exp-of-line" => {
            "two polynomials of the square, summed four coefficients at a time, without root, \
             quotient or table; their latency is most of the time, and a loop that calls one \
             function after the other cannot overlap it; tried: Horner's scheme, even and odd \
             parts, fewer negations; in batches several are computed at a time"
        }
        "log-of-motor" => {
            "one polynomial and one quotient beside it, and questions whether there is a logarithm \
             and whether it is near the edge, which others do not ask; tried: the slope by a \
             polynomial of its own, rare cases in functions apart; in batches several are computed \
             at a time"
        }
        "join-of-points" => {
            "six coefficients of 15 operations: on the oldest processors loading and storing is most \
             of it, for both libraries"
        }
        "conformal-motor-on-circle" => {
            "98 multiplications for ten coefficients, of which a loop over structs keeps more than \
             there are registers; tried: V x̂ Ṽ as two products, one polynomial, and the form that \
             is generated, which takes the fewest; one motor on many by `apply_slice`"
        }
        "p∧q∧r" | "dense-32×32" | "one-motor-on-points" => {
            "with 512-bit vectors the compiler shuffles loops over structs more than it computes; the \
             build without AVX-512 does not"
        }
        _ => return None,
    })
}
