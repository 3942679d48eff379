//! Decides how bytes reach the disk: written beside, then renamed, so that a file is whole or absent.

use super::ExportError;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Writes one file, replacing any that is there.
///
/// # Errors
/// [`ExportError::Write`], which names the path and what would help; nothing is left behind.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), ExportError> {
    let staged = stage(path, bytes)?;
    publish(vec![staged])
}

/// Writes several files that belong together: all are written beside their places first, and only
/// then renamed. Should a rename fail, the files that this call has newly made are removed; a file
/// that replaced an older one stays, because the older one is gone.
///
/// # Errors
/// [`ExportError::Write`], which names the path and what would help.
pub fn write_files(files: &[(PathBuf, Vec<u8>)]) -> Result<(), ExportError> {
    let staged = files.iter().map(|(path, bytes)| stage(path, bytes));
    publish(staged.collect::<Result<Vec<_>, _>>()?)
}

/// Makes a directory, and those above it, if it is not there.
///
/// # Errors
/// [`ExportError::Write`], which names the path and what would help.
pub fn create_directory(path: &Path) -> Result<(), ExportError> {
    fs::create_dir_all(path).map_err(|source| failure(path, "make the directory", source))
}

/// A file that is written but not yet in its place.
enum Staged {
    /// Complete under another name in the same directory; removed when dropped.
    Beside { file: NamedTempFile, path: PathBuf },
    /// A device or pipe, which cannot be replaced and is written to directly.
    Stream { path: PathBuf, bytes: Vec<u8> },
}

fn stage(path: &Path, bytes: &[u8]) -> Result<Staged, ExportError> {
    // The file that a link points to is replaced, not the link.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let existing = fs::metadata(&path).ok();
    match &existing {
        Some(there) if there.is_dir() => {
            let source = io::Error::from(io::ErrorKind::IsADirectory);
            return Err(failure(&path, "write the file", source));
        }
        Some(there) if !there.is_file() => {
            return Ok(Staged::Stream {
                path,
                bytes: bytes.to_owned(),
            });
        }
        _ => {}
    }
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".").suffix(".partial");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any new file has: the default of temporary files hides them from other users.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let refused = |source| failure(&path, "write the file", source);
    let mut file = builder.tempfile_in(directory).map_err(refused)?;
    file.write_all(bytes).map_err(refused)?;
    file.as_file().sync_all().map_err(refused)?;
    if let Some(there) = existing {
        file.as_file()
            .set_permissions(there.permissions())
            .map_err(refused)?;
    }
    Ok(Staged::Beside { file, path })
}

fn publish(staged: Vec<Staged>) -> Result<(), ExportError> {
    let mut made: Vec<PathBuf> = Vec::new();
    for staged in staged {
        let (path, result) = match staged {
            Staged::Beside { file, path } => {
                let is_new = !path.exists();
                let result = file.persist(&path).map(drop).map_err(|failed| failed.error);
                if is_new && result.is_ok() {
                    made.push(path.clone());
                }
                (path, result)
            }
            Staged::Stream { path, bytes } => {
                let opened = fs::OpenOptions::new().write(true).open(&path);
                let result = opened.and_then(|mut stream| stream.write_all(&bytes));
                (path, result)
            }
        };
        if let Err(source) = result {
            for path in made {
                // The first failure is the one to report; a file that cannot be removed stays.
                let _ = fs::remove_file(path);
            }
            return Err(failure(&path, "write the file", source));
        }
    }
    Ok(())
}

fn failure(path: &Path, action: &'static str, source: io::Error) -> ExportError {
    let remedy = match source.kind() {
        // A directory in which the system alone makes files, such as `/proc`.
        io::ErrorKind::NotFound if path.parent().is_some_and(Path::is_dir) => {
            "no files can be made in this directory: choose another one"
        }
        io::ErrorKind::NotFound => "make its directory first",
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "choose a directory that you may write to"
        }
        io::ErrorKind::IsADirectory => "it is a directory: give the name of a file in it",
        io::ErrorKind::NotADirectory | io::ErrorKind::AlreadyExists => {
            "a part of the path is a file: choose another name"
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "make room on the disk",
        io::ErrorKind::InvalidFilename => "choose a shorter or simpler name",
        _ => {
            return ExportError::Write {
                path: path.to_owned(),
                action,
                source,
                remedy: "check the path and try again",
            };
        }
    };
    // The reason alone: the error itself may name the passing file beside the one asked for.
    let source = io::Error::from(source.kind());
    ExportError::Write {
        path: path.to_owned(),
        action,
        source,
        remedy,
    }
}
