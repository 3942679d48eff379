//! How tokens become data blocks: names with one value, and loops of columns.

use std::collections::HashMap;

use super::problem::Problem;
use super::token::{Token, Tokens, Value};
use super::{Located, Warnings};

/// The most tokens that a file may have.
const MOST_TOKENS: usize = 5_000_000;

/// The most data blocks that a file may have.
const MOST_BLOCKS: usize = 100_000;

/// A data block.
#[derive(Clone, Debug, Default)]
pub struct Block<'a> {
    /// What follows `data_`.
    pub name: &'a str,
    /// The line of `data_`.
    pub line: usize,
    items: HashMap<String, Value<'a>>,
    loops: Vec<Loop<'a>>,
    /// For each data name in a loop: the loop and the column.
    columns: HashMap<String, (usize, usize)>,
}

#[derive(Clone, Debug)]
struct Loop<'a> {
    line: usize,
    tags: Vec<String>,
    values: Vec<Value<'a>>,
}

impl<'a> Block<'a> {
    /// The first known value of the first of several data names that has one, and that name.
    pub fn first<'t>(&self, tags: &[&'t str]) -> Option<(&'t str, Value<'a>)> {
        tags.iter().find_map(|tag| {
            let value = match (self.items.get(*tag), self.columns.get(*tag)) {
                (Some(value), _) => Some(*value),
                (None, Some((at, column))) => self
                    .loops
                    .get(*at)
                    .and_then(|found| found.values.get(*column).copied()),
                (None, None) => None,
            };
            value
                .filter(|value| value.known().is_some())
                .map(|value| (*tag, value))
        })
    }

    /// The column of the first of several data names that the block has, and that name. A name
    /// with a single value is a column of one row.
    ///
    /// # Errors
    /// [`Problem::Ragged`] when the last row of its loop is incomplete.
    pub fn column<'t>(
        &self,
        tags: &[&'t str],
    ) -> Result<Option<(&'t str, Vec<Value<'a>>)>, Located> {
        for tag in tags {
            if let Some((at, column)) = self.columns.get(*tag) {
                let Some(found) = self.loops.get(*at) else {
                    continue;
                };
                found.check()?;
                let rows = found
                    .values
                    .iter()
                    .skip(*column)
                    .step_by(found.tags.len().max(1));
                return Ok(Some((tag, rows.copied().collect())));
            }
            if let Some(value) = self.items.get(*tag) {
                return Ok(Some((tag, vec![*value])));
            }
        }
        Ok(None)
    }

    /// Whether the block has any of the data names.
    pub fn has(&self, tags: &[&str]) -> bool {
        tags.iter()
            .any(|tag| self.items.contains_key(*tag) || self.columns.contains_key(*tag))
    }

    fn add_item(&mut self, tag: &str, value: Value<'a>, warnings: &mut Warnings) {
        let tag = normalized(tag);
        if self.has(&[&tag]) {
            warnings.add(
                value.line,
                format!("`{tag}` stands twice; the first value is used"),
            );
        } else {
            self.items.insert(tag, value);
        }
    }

    fn add_loop(&mut self, complete: Loop<'a>, warnings: &mut Warnings) {
        for (column, tag) in complete.tags.iter().enumerate() {
            if self.has(&[tag]) {
                let message = format!("`{tag}` stands twice; the first values are used");
                warnings.add(complete.line, message);
            } else {
                self.columns.insert(tag.clone(), (self.loops.len(), column));
            }
        }
        if let Err(Located { line, problem }) = complete.check() {
            warnings.add(line, problem.to_string());
        }
        self.loops.push(complete);
    }
}

impl Loop<'_> {
    fn check(&self) -> Result<(), Located> {
        let (columns, values) = (self.tags.len(), self.values.len());
        let extra = values.checked_rem(columns).unwrap_or(0);
        if extra == 0 {
            return Ok(());
        }
        let tag = self.tags.first().cloned().unwrap_or_default();
        let problem = Problem::Ragged {
            tag,
            columns,
            values,
            missing: columns - extra,
        };
        Err(Located::new(self.line, problem))
    }
}

/// Data names are compared in small letters, dots of newer dictionaries as underscores.
fn normalized(tag: &str) -> String {
    tag.chars()
        .take(120)
        .map(|c| {
            if c == '.' {
                '_'
            } else {
                c.to_ascii_lowercase()
            }
        })
        .collect()
}

/// All data blocks of a file.
pub fn blocks<'a>(text: &'a str, warnings: &mut Warnings) -> Result<Vec<Block<'a>>, Located> {
    let mut reader = Reader {
        tokens: Tokens::new(text),
        pending: None,
        count: 0,
    };
    let mut blocks: Vec<Block<'a>> = Vec::new();
    while let Some((token, line)) = reader.next()? {
        if let Token::Data(name) = token {
            if blocks.len() >= MOST_BLOCKS {
                let problem = Problem::TooLarge {
                    what: "data blocks",
                    limit: MOST_BLOCKS,
                };
                return Err(Located::new(line, problem));
            }
            blocks.push(Block {
                name,
                line,
                ..Block::default()
            });
            continue;
        }
        if blocks.is_empty() {
            if let Token::Value(value) = token {
                let found = value.text.trim().chars().take(40).collect();
                return Err(Located::new(line, Problem::NotCif { found }));
            }
            warnings.add(line, "no line such as `data_quartz` begins the file");
            blocks.push(Block {
                line,
                ..Block::default()
            });
        }
        let Some(block) = blocks.last_mut() else {
            continue;
        };
        match token {
            Token::Tag(tag) => reader.item(tag, line, block, warnings)?,
            Token::Loop => reader.looped(line, block, warnings)?,
            Token::Save(name) if !name.is_empty() => reader.skip_frame(line)?,
            Token::Value(value) => {
                let shown: String = value.text.trim().chars().take(40).collect();
                warnings.add(
                    line,
                    format!("`{shown}` belongs to no data name and is passed over"),
                );
            }
            Token::Data(_) | Token::Save(_) | Token::Reserved => {}
        }
    }
    if blocks.is_empty() {
        return Err(Located::new(1, Problem::Empty));
    }
    Ok(blocks)
}

struct Reader<'a> {
    tokens: Tokens<'a>,
    pending: Option<(Token<'a>, usize)>,
    count: usize,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Result<Option<(Token<'a>, usize)>, Located> {
        if let Some(token) = self.pending.take() {
            return Ok(Some(token));
        }
        let token = self.tokens.next_token()?;
        self.count += 1;
        match token {
            Some((_, line)) if self.count > MOST_TOKENS => {
                let problem = Problem::TooLarge {
                    what: "words",
                    limit: MOST_TOKENS,
                };
                Err(Located::new(line, problem))
            }
            token => Ok(token),
        }
    }

    fn item(
        &mut self,
        tag: &str,
        line: usize,
        block: &mut Block<'a>,
        warnings: &mut Warnings,
    ) -> Result<(), Located> {
        match self.next()? {
            Some((Token::Value(value), _)) => {
                let value = self.whole_symbol(tag, value, warnings)?;
                block.add_item(tag, value, warnings);
                Ok(())
            }
            None => {
                let tag = tag.chars().take(80).collect();
                Err(Located::new(line, Problem::NoValue { tag }))
            }
            other => {
                let shown: String = tag.chars().take(80).collect();
                warnings.add(line, format!("the data name `{shown}` has no value"));
                self.pending = other;
                Ok(())
            }
        }
    }

    /// A symbol of a space group has blanks; where its marks were forgotten, the rest of its line
    /// belongs to it.
    fn whole_symbol(
        &mut self,
        tag: &str,
        mut value: Value<'a>,
        warnings: &mut Warnings,
    ) -> Result<Value<'a>, Located> {
        let tag = normalized(tag);
        if value.quoted || !(tag.contains("name_h-m") || tag.contains("name_hall")) {
            return Ok(value);
        }
        let first = value;
        loop {
            match self.next()? {
                Some((Token::Value(next), line)) if line == first.line && !next.quoted => {
                    value = self.tokens.joined(first, next);
                }
                other => {
                    self.pending = other;
                    break;
                }
            }
        }
        if value != first {
            let message = format!("`{:.40}` has blanks and should stand in marks", value.text);
            warnings.add(value.line, message);
        }
        Ok(value)
    }

    fn looped(
        &mut self,
        line: usize,
        block: &mut Block<'a>,
        warnings: &mut Warnings,
    ) -> Result<(), Located> {
        let mut found = Loop {
            line,
            tags: Vec::new(),
            values: Vec::new(),
        };
        loop {
            match self.next()? {
                Some((Token::Tag(tag), _)) if found.values.is_empty() => {
                    found.tags.push(normalized(tag));
                }
                Some((Token::Value(value), _)) if !found.tags.is_empty() => {
                    found.values.push(value);
                }
                None => {
                    // An incomplete row at the very end means that the file was cut off.
                    found.check()?;
                    if let (Some(tag), true) = (found.tags.last(), found.values.is_empty()) {
                        let problem = Problem::NoValue { tag: tag.clone() };
                        return Err(Located::new(line, problem));
                    }
                    block.add_loop(found, warnings);
                    return Ok(());
                }
                other => {
                    self.pending = other;
                    block.add_loop(found, warnings);
                    return Ok(());
                }
            }
        }
    }

    fn skip_frame(&mut self, line: usize) -> Result<(), Located> {
        loop {
            match self.next()? {
                Some((Token::Save(""), _)) => return Ok(()),
                Some(_) => {}
                None => return Err(Located::new(line, Problem::OpenFrame)),
            }
        }
    }
}
