//! Phrases that many messages share.

/// The remedy: a name that was probably meant, else what holds in general.
pub fn hint(suggestion: &Option<String>, otherwise: &str) -> String {
    match suggestion {
        Some(name) => format!("did you mean `{name}`?"),
        None => otherwise.to_owned(),
    }
}

/// Where names come from that are not `e1`, `e2`, ….
pub fn basis_hint(named: bool) -> &'static str {
    if named {
        ""
    } else {
        " (vectors of other names are declared in `basis { … }`)"
    }
}

/// A number of things.
pub fn counted(count: usize, thing: &str) -> String {
    match count {
        1 => format!("1 {thing}"),
        _ => format!("{count} {thing}s"),
    }
}

/// What was written, cut where it is too long to be shown.
pub fn shown(text: &str) -> String {
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
