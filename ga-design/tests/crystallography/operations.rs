//! Whether coordinate triplets are read and printed as files and International Tables spell them.

use ga_design::crystallography::Operation;
use num_rational::Ratio;

#[test]
fn triplets_are_read_as_files_spell_them() {
    for (text, printed) in [
        ("x,y,z", "x,y,z"),
        ("-x+1/2, 1/2-Y ,z", "-x+1/2,-y+1/2,z"),
        ("x-y, x, z+0.5", "x-y,x,z+1/2"),
        ("'+x,-y,+z'", "x,-y,z"),
        ("-x+.3333,y+0.6667,z+.25", "-x+1/3,y+2/3,z+1/4"),
        ("x+.33,y+0.67,z+.125", "x+1/3,y+2/3,z+1/8"),
        ("x+.16667,y+0.83333,z+.0416667", "x+1/6,y+5/6,z+1/24"),
        ("x+1,y-1/4,z+5/2", "x,y+3/4,z+1/2"),
        ("y,x,-z+2/3", "y,x,-z+2/3"),
        ("2*x-x,y,z", "x,y,z"),
        ("2/2x,2y/2,z", "x,y,z"),
        ("x+1/5,y,z", "x+1/5,y,z"),
        ("x+0.2,y,z", "x+1/5,y,z"),
    ] {
        let operation: Operation = text.parse().unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(operation.to_string(), printed, "{text}");
    }
    for (text, part) in [
        ("", "ends at column 1"),
        ("x,y", "2 of 3 coordinates"),
        ("x,y,", "ends at column 5"),
        ("x,,z", "unexpected `,` at column 3"),
        ("x,y,z,x", "fourth coordinate at column 6"),
        ("x,y,w", "unexpected `w` at column 5"),
        ("x y,z,x", "unexpected `y` at column 3"),
        ("x,y,z+1/0", "division by zero at column 9"),
        ("x,y,z+0.3", "column 7 is no multiple of 1/24"),
        ("x,y,z+1/11", "no multiple of 1/24"),
        ("x,y,z+999999999", "column 7 is too large"),
        ("x,y,z/2", "column 5 has a factor"),
        ("99x,y,z", "column 1 has a factor"),
        ("x,x,z", "determinant is 0"),
        ("2x,y,z", "determinant is 2"),
        ("x,y,z+", "ends at column 7"),
        ("x,y,++z", "unexpected `+` at column 6"),
    ] {
        let error = text.parse::<Operation>().expect_err(text).to_string();
        assert!(error.contains(part), "{text}: {error}");
    }
    let long = format!("x,y,z{}", "+1".repeat(1000));
    assert!(long.parse::<Operation>().is_err());
}

#[test]
fn translations_that_are_no_fractions_are_refused() {
    let identity = Operation::IDENTITY.rotation();
    let zero = Ratio::new_raw(0, 1);
    for (numerator, denominator) in [
        (1, 0),
        (0, 0),
        (i32::MIN, -1),
        (1, -2),
        (1, 11),
        (1, i32::MIN),
    ] {
        let raw = Ratio::new_raw(numerator, denominator);
        assert_eq!(Operation::new(identity, [raw, zero, zero]), None, "{raw:?}");
    }
    let far = Ratio::new_raw(i32::MAX, 1);
    assert_eq!(
        Operation::new(identity, [far; 3]),
        Some(Operation::IDENTITY)
    );
}
