//! Decides how the Schoenflies symbol of any point group, crystallographic or not, is read and found.

use ga_design::crystallography::{Isometry, PointGroup};

/// The geometric symbol of the group of a Schoenflies symbol such as `D5h`, `C_{7v}`, `S8`, `Ih`.
pub fn symbol(text: &str) -> Option<String> {
    let plain: String = text
        .chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '_' | '{' | '}'))
        .flat_map(char::to_lowercase)
        .collect();
    let fixed = match plain.as_str() {
        "cs" | "c1h" | "c1v" | "s1" => "1",
        "ci" | "s2" => "b(22)",
        "t" => "b(3)b(3)",
        "td" => "33",
        "th" => "4b(3)",
        "o" => "b(4)b(3)",
        "oh" => "43",
        "i" => "b(5)b(3)",
        "ih" => "53",
        "v" => "b(2)b(2)",
        "vh" => "22",
        "vd" => "4b(2)",
        _ => "",
    };
    if !fixed.is_empty() {
        return Some(fixed.to_owned());
    }
    let family = plain.chars().next()?;
    let rest = plain.get(family.len_utf8()..)?;
    let end = rest
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(rest.len());
    let (digits, suffix) = rest.split_at_checked(end)?;
    let n: u32 = digits.parse().ok().filter(|n| (1..=500).contains(n))?;
    let twice = 2 * n;
    Some(match (family, suffix) {
        ('c', "") => format!("b(({n}))"),
        ('c', "v") => format!("({n})"),
        ('c', "h") => format!("b(({n}))2"),
        // Odd n: the rotation and the inversion.
        ('c', "i") if !n.is_multiple_of(2) => format!("b(({twice})2)"),
        ('s', "") if n.is_multiple_of(2) => format!("b(({n})2)"),
        ('s', "") => format!("b(({n}))2"),
        ('d', "") => format!("b(({n}))b(2)"),
        ('d', "h") => format!("({n})2"),
        ('d', "d") => format!("({twice})b(2)"),
        _ => return None,
    })
}

/// The Schoenflies symbol of a group, from its rotations and reflections.
pub fn name(group: &PointGroup) -> String {
    if let Some(class) = group.crystal_class() {
        return class.schoenflies.to_owned();
    }
    let inversion = group.position(&Isometry::inversion());
    let (mut rotations, mut highest, mut reflections) = (0, 1, 0);
    for (number, isometry) in group.transformations().iter().enumerate() {
        let order = group.order_of(number).unwrap_or_default();
        if isometry.is_proper() {
            rotations += 1;
            highest = highest.max(order);
        } else if order == 2 && Some(number) != inversion {
            reflections += 1;
        }
    }
    let is_chiral = group.order() == rotations;
    // Three axes of order five or more meet in the icosahedron only.
    if rotations == 60 && highest == 5 {
        return String::from(if is_chiral { "I" } else { "Ih" });
    }
    let n = highest;
    let is_cyclic = rotations == n;
    match (is_cyclic, is_chiral, reflections) {
        (true, true, _) => format!("C{n}"),
        (true, _, 0) => format!("S{}", 2 * n),
        (true, _, 1) => format!("C{n}h"),
        (true, ..) => format!("C{n}v"),
        (false, true, _) => format!("D{n}"),
        (false, _, mirrors) if mirrors > n => format!("D{n}h"),
        (false, ..) => format!("D{n}d"),
    }
}
