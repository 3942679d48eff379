//! Decides what the argument of `articulate expand` is: a signature, the body of a call, or Rust
//! source with calls in it.

use crate::failure::Failure;
use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use std::fs;
use std::io::ErrorKind;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The largest file that is read, in bytes; an algebra is a page of text.
const LARGEST_FILE: u64 = 4 << 20;

/// The deepest nesting of brackets that is read. Tokens are trees, which are walked by recursion; an
/// algebra nests four deep, a program perhaps thirty.
const DEEPEST: usize = 200;

/// The bodies of the calls of `define_algebra!` that were asked for.
#[derive(Debug)]
pub struct Calls {
    /// Where they come from, as messages name it.
    name: String,
    /// The bodies, each at the lines and columns at which it stands in its file.
    pub texts: Vec<String>,
}

impl Calls {
    /// The failure of a call with these mistakes, one line `line:column: message` for each.
    pub fn mistaken(&self, mistakes: &str) -> Failure {
        let lines = mistakes.lines().map(|line| match line.split_once(':') {
            // A message may go on over several lines; only the first has a place.
            Some((number, _)) if number.parse::<u32>().is_ok() => format!("{}:{line}", self.name),
            _ => line.to_owned(),
        });
        Failure::Algebra(lines.collect::<Vec<_>>().join("\n"))
    }
}

/// The calls that an argument stands for: those of a file if there is one or its name has a
/// directory or an ending, otherwise the argument itself.
pub fn calls(argument: &Path) -> Result<Calls, Failure> {
    let spelled = argument
        .to_str()
        .filter(|text| !text.contains(['/', '\\', '.']));
    match spelled {
        Some(text) if !argument.exists() => {
            let name = text.to_owned();
            check_nesting(&name, text)?;
            Ok(Calls {
                name,
                texts: vec![text.to_owned()],
            })
        }
        _ => read(argument),
    }
}

fn read(file: &Path) -> Result<Calls, Failure> {
    let refused = |reason: std::io::Error| {
        let remedy = match reason.kind() {
            ErrorKind::NotFound => "check its name, or give a signature such as R4_1",
            ErrorKind::IsADirectory => "it is a directory: give a file in it",
            ErrorKind::InvalidData => "give a text file in UTF-8",
            ErrorKind::FileTooLarge => "give a file with the algebra alone",
            _ => "check that you may read it",
        };
        Failure::Unreadable {
            file: PathBuf::from(file),
            reason,
            remedy,
        }
    };
    let size = fs::metadata(file).map_err(refused)?.len();
    if size > LARGEST_FILE {
        return Err(refused(ErrorKind::FileTooLarge.into()));
    }
    let text = fs::read_to_string(file).map_err(refused)?;
    let name = file.display().to_string();
    check_nesting(&name, &text)?;
    let tokens = text.parse::<TokenStream>();
    let mut bodies = Vec::new();
    if let Ok(tokens) = tokens {
        find_calls(tokens, &mut bodies);
    }
    // Without a call in it, the whole file is a body.
    if bodies.is_empty() {
        return Ok(Calls {
            name,
            texts: vec![text],
        });
    }
    let texts = bodies.iter().map(|body| kept(&text, body)).collect();
    Ok(Calls { name, texts })
}

/// Refuses brackets nested deeper than [`DEEPEST`], at the place where they become so. Brackets in
/// comments and strings count too, which does no harm at this depth.
fn check_nesting(name: &str, text: &str) -> Result<(), Failure> {
    let mut depth = 0_usize;
    for (row, line) in text.lines().enumerate() {
        for (column, character) in line.chars().enumerate() {
            match character {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth > DEEPEST {
                let (row, column) = (row + 1, column + 1);
                return Err(Failure::Algebra(format!(
                    "{name}:{row}:{column}: brackets are nested more than {DEEPEST} deep; an \
                     algebra needs four"
                )));
            }
        }
    }
    Ok(())
}

/// Finds what stands between the brackets of each `define_algebra!`, at any depth.
fn find_calls(tokens: TokenStream, bodies: &mut Vec<Range<usize>>) {
    let mut pending = vec![tokens];
    while let Some(tokens) = pending.pop() {
        // How much of `define_algebra` `!` has just been passed.
        let mut passed = 0;
        for token in tokens {
            passed = match (passed, token) {
                (_, TokenTree::Ident(name)) if name == "define_algebra" => 1,
                (1, TokenTree::Punct(mark))
                    if mark.as_char() == '!' && mark.spacing() == Spacing::Alone =>
                {
                    2
                }
                (2, TokenTree::Group(call)) if call.delimiter() != Delimiter::None => {
                    let open = call.span_open().byte_range().end;
                    let close = call.span_close().byte_range().start;
                    bodies.push(open..close);
                    0
                }
                (_, TokenTree::Group(inner)) => {
                    pending.push(inner.stream());
                    0
                }
                _ => 0,
            };
        }
    }
    bodies.sort_by_key(|body| body.start);
}

/// The text with everything outside the range blanked out, so that lines and columns stay.
fn kept(text: &str, range: &Range<usize>) -> String {
    let blanked = text.char_indices().map(|(at, character)| {
        if range.contains(&at) || character == '\n' {
            character
        } else {
            ' '
        }
    });
    blanked.collect()
}
