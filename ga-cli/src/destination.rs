//! Decides in which form a file is saved: by the ending of its path, of those that a command has a form
//! for.

use clap::builder::{PathBufValueParser, TypedValueParser};
use std::path::PathBuf;
use thiserror::Error;

/// What a command saves, and in which forms.
pub trait Forms: Copy + Send + Sync + 'static {
    /// What is saved, for messages: `a crystal`.
    const SUBJECT: &'static str;

    /// The endings in lower case and the form of each, in the order in which messages list them. An
    /// empty ending never occurs; several endings may have one form.
    const ENDINGS: &'static [(&'static str, Self)];
}

/// A file to be saved.
#[derive(Debug, Clone)]
pub struct Destination<F> {
    /// Where.
    pub path: PathBuf,
    /// In which form.
    pub form: F,
}

/// The ending of a file names no form in which there is such a thing.
#[derive(Debug, Error)]
#[error("{subject} cannot be saved under this ending; use one of {endings}")]
pub struct UnknownEnding {
    /// What should be saved.
    subject: &'static str,
    /// The endings that there are.
    endings: String,
}

impl<F: Forms> Destination<F> {
    /// The file at this path, in the form of its ending.
    ///
    /// # Errors
    /// [`UnknownEnding`], which lists the endings that there are.
    pub fn new(path: PathBuf) -> Result<Self, UnknownEnding> {
        let ending = path.extension().unwrap_or_default();
        let mut forms = F::ENDINGS.iter();
        match forms.find(|(name, _)| ending.eq_ignore_ascii_case(name)) {
            Some(&(_, form)) => Ok(Self { path, form }),
            None => Err(UnknownEnding {
                subject: F::SUBJECT,
                endings: endings::<F>(),
            }),
        }
    }

    /// What is told of the option.
    pub fn help() -> String {
        format!(
            "A file to save, in the format of its ending: {}. Can be given several times; if one file cannot \
             be made, none is",
            endings::<F>()
        )
    }

    /// Reads the value of the option.
    pub fn parser() -> impl TypedValueParser<Value = Self> {
        PathBufValueParser::new().try_map(Self::new)
    }
}

/// The endings that there are, with dots and blanks.
fn endings<F: Forms>() -> String {
    let names = F::ENDINGS.iter().map(|(name, _)| format!(".{name}"));
    names.collect::<Vec<_>>().join(" ")
}

/// The paths of these files.
pub fn paths<F>(files: &[Destination<F>]) -> Vec<PathBuf> {
    files.iter().map(|file| file.path.clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::{Destination, Forms};

    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    enum Form {
        Text,
        Picture,
    }

    impl Forms for Form {
        const SUBJECT: &'static str = "a map";
        const ENDINGS: &'static [(&'static str, Self)] =
            &[("txt", Self::Text), ("png", Self::Picture)];
    }

    #[test]
    fn an_ending_chooses_the_form() {
        let form = |path: &str| Destination::<Form>::new(path.into()).map(|file| file.form);
        assert_eq!(form("a/b.txt").ok(), Some(Form::Text));
        assert_eq!(form("a.txt.PNG").ok(), Some(Form::Picture));
        for wrong in ["", "png", ".png", "a.", "a.pn", "a.png.gz", "png/a"] {
            let told = form(wrong).err().map(|error| error.to_string());
            let expected = "a map cannot be saved under this ending; use one of .txt .png";
            assert_eq!(told.as_deref(), Some(expected), "{wrong}");
        }
    }
}
