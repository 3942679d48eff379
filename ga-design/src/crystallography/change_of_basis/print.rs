//! How an affine map with rational entries is spelled: `1/2x+1/2y,-z,x+1/4`.

use std::fmt;

use num_rational::Ratio;

type Exact = Ratio<i128>;

/// Three sums of the variables x, y, z, the constant last; a sum without terms is `0`.
pub fn write(
    out: &mut fmt::Formatter<'_>,
    linear: &[[Exact; 3]; 3],
    shift: &[Exact; 3],
) -> fmt::Result {
    for (place, (row, constant)) in linear.iter().zip(shift).enumerate() {
        if place > 0 {
            out.write_str(",")?;
        }
        let mut first = true;
        for (factor, name) in row.iter().zip(["x", "y", "z"]) {
            write_term(out, *factor, name, first)?;
            first &= *factor.numer() == 0;
        }
        if *constant.numer() != 0 || first {
            write_term(out, *constant, "", first)?;
            if *constant.numer() == 0 {
                out.write_str("0")?;
            }
        }
    }
    Ok(())
}

fn write_term(out: &mut fmt::Formatter<'_>, factor: Exact, name: &str, first: bool) -> fmt::Result {
    let whole = factor.numer();
    if *whole == 0 {
        return Ok(());
    }
    match (*whole < 0, first) {
        (true, _) => out.write_str("-")?,
        (false, false) => out.write_str("+")?,
        (false, true) => {}
    }
    let size = if *whole < 0 { -factor } else { factor };
    if name.is_empty() || size != Exact::from_integer(1) {
        write!(out, "{size}")?;
    }
    out.write_str(name)
}
