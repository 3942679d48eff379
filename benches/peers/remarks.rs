//! Why an operation misses its goal where it does, and what was tried: printed below a table for
//! the rows that miss.

/// What is to be said of an operation; nothing of most.
pub fn remark(operation: &str) -> Option<&'static str> {
    Some(match operation {
        "rotor·rotor" => {
            "the product is one and the same, 16 multiplications; glam's f32 quaternion is an \
             aligned vector of the processor multiplied by intrinsics, a generic struct is \
             vectorised by the compiler across elements or not at all"
        }
        "motor·motor" => {
            "a motor has 48 multiplications for 8 numbers, an isometry of quaternion and vector 31 \
             for 7, a matrix is multiplied by aligned vectors; tried in isolation: fused sums, and \
             three quaternion products in rows of four, which change the time by less than 20 in \
             a hundred, because loading and transposing structs is most of it"
        }
        "motor-on-point" => {
            "a matrix has 9 multiplications for a point, a motor 18, and its columns are aligned \
             vectors; it is twice as large, and has to be made of the motion first"
        }
        "one-motor-on-points" => {
            "as a matrix the motion has 9 multiplications for a point, and glam's is in aligned \
             vectors; batches of points are the fast form here"
        }
        _ => return None,
    })
}
