//! Which words a CIF file consists of: the grammar below the level of blocks and loops.
//!
//! ```text
//! comment   = "#" to the end of the line
//! text      = ";" at the beginning of a line, up to the next line that begins with ";"
//! quoted    = ' or ", up to the same mark followed by a blank or the end of the line
//! data_NAME   loop_   save_NAME   save_   global_   stop_        in either case
//! name      = "_" and what follows up to a blank
//! value     = anything else up to a blank
//! ```
//!
//! In a file that begins with `#\#CIF_2.0` there are also
//!
//! ```text
//! triple    = ''' or """, up to the same three marks, over lines
//! list      = "[" values "]", and table = "{" names and values "}"; each one value, not looked into
//! ```

use super::Located;
use super::problem::Problem;

/// A word of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token<'a> {
    /// `data_NAME`.
    Data(&'a str),
    /// `loop_`.
    Loop,
    /// `save_NAME`, or `save_` with an empty name, which ends the frame.
    Save(&'a str),
    /// `global_` or `stop_`, which CIF reserves and does not use.
    Reserved,
    /// A data name, underscore included.
    Tag(&'a str),
    /// A value without its marks.
    Value(Value<'a>),
}

/// A value of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Value<'a> {
    /// The text, without quotation marks or semicolons.
    pub text: &'a str,
    /// Whether it was quoted or a text field, so that `?` and `.` mean themselves.
    pub quoted: bool,
    /// The line on which it begins.
    pub line: usize,
    /// Where the text begins in the file, in bytes.
    start: usize,
}

impl<'a> Value<'a> {
    /// The trimmed text; `None` for `?` (unknown), `.` (inapplicable) and nothing at all.
    pub fn known(&self) -> Option<&'a str> {
        let text = self.text.trim();
        (!text.is_empty() && (self.quoted || !matches!(text, "?" | "."))).then_some(text)
    }
}

/// Splits a text into tokens.
#[derive(Clone, Debug)]
pub struct Tokens<'a> {
    text: &'a str,
    at: usize,
    line: usize,
    is_version_2: bool,
}

impl<'a> Tokens<'a> {
    /// Begins at the first line.
    pub fn new(text: &'a str) -> Self {
        Self {
            text,
            at: 0,
            line: 1,
            is_version_2: text.starts_with("#\\#CIF_2.0"),
        }
    }

    /// The next token with its line; `None` at the end.
    pub fn next_token(&mut self) -> Result<Option<(Token<'a>, usize)>, Located> {
        self.skip();
        let line = self.line;
        let Some(byte) = self.peek() else {
            return Ok(None);
        };
        let token = match byte {
            b';' if self.at_line_start() => self.text_field()?,
            b'\'' | b'"' if self.is_version_2 && self.begins_triple() => self.triple()?,
            b'\'' | b'"' => self.quoted(byte)?,
            b'[' | b'{' if self.is_version_2 => self.container()?,
            _ => self.word(),
        };
        Ok(Some((token, line)))
    }

    /// The text from the first of two values to the end of the last, as one value.
    pub fn joined(&self, first: Value<'a>, last: Value<'a>) -> Value<'a> {
        Value {
            text: self.slice(first.start, last.start + last.text.len()),
            ..first
        }
    }

    fn peek(&self) -> Option<u8> {
        self.byte(self.at)
    }

    fn byte(&self, at: usize) -> Option<u8> {
        self.text.as_bytes().get(at).copied()
    }

    fn slice(&self, from: usize, to: usize) -> &'a str {
        self.text.get(from..to).unwrap_or_default()
    }

    fn at_line_start(&self) -> bool {
        self.at
            .checked_sub(1)
            .and_then(|before| self.byte(before))
            .is_none_or(is_line_end)
    }

    /// Steps over one byte and counts lines: LF, CR LF and a lone CR each end one.
    fn step(&mut self) {
        match self.peek() {
            Some(b'\n') => self.line += 1,
            Some(b'\r') if self.byte(self.at + 1) != Some(b'\n') => self.line += 1,
            _ => {}
        }
        self.at += 1;
    }

    fn skip(&mut self) {
        while let Some(byte) = self.peek() {
            if byte == b'#' {
                while self.peek().is_some_and(|byte| !is_line_end(byte)) {
                    self.at += 1;
                }
            } else if is_blank(byte) {
                self.step();
            } else {
                return;
            }
        }
    }

    /// The value between marks that began at `start` and ends here.
    fn enclosed(&self, start: usize, line: usize) -> Token<'a> {
        Token::Value(Value {
            text: self.slice(start, self.at),
            quoted: true,
            line,
            start,
        })
    }

    fn text_field(&mut self) -> Result<Token<'a>, Located> {
        let (start, line) = (self.at + 1, self.line);
        self.at += 1;
        loop {
            match self.peek() {
                None => return Err(Located::new(line, Problem::OpenText)),
                Some(b';') if self.at_line_start() => {
                    let value = self.enclosed(start, line);
                    self.at += 1;
                    return Ok(value);
                }
                Some(_) => self.step(),
            }
        }
    }

    fn quoted(&mut self, quote: u8) -> Result<Token<'a>, Located> {
        let (start, line) = (self.at + 1, self.line);
        self.at += 1;
        loop {
            match self.peek() {
                // A mark inside a word, as in 'it's', does not close.
                Some(byte) if byte == quote && self.byte(self.at + 1).is_none_or(is_blank) => {
                    let value = self.enclosed(start, line);
                    self.at += 1;
                    return Ok(value);
                }
                Some(byte) if !is_line_end(byte) => self.at += 1,
                _ => {
                    let quote = char::from(quote);
                    return Err(Located::new(line, Problem::OpenQuote { quote }));
                }
            }
        }
    }

    /// Whether three equal bytes stand here.
    fn begins_triple(&self) -> bool {
        let first = self.peek();
        self.byte(self.at + 1) == first && self.byte(self.at + 2) == first
    }

    fn triple(&mut self) -> Result<Token<'a>, Located> {
        let (mark, line) = (self.peek(), self.line);
        self.at += 3;
        let start = self.at;
        loop {
            match self.peek() {
                None => return Err(Located::new(line, Problem::OpenTriple)),
                byte if byte == mark && self.begins_triple() => {
                    // Of four and more marks the last three close.
                    while self.byte(self.at + 3) == mark {
                        self.at += 1;
                    }
                    let value = self.enclosed(start, line);
                    self.at += 3;
                    return Ok(value);
                }
                Some(_) => self.step(),
            }
        }
    }

    /// A list or table as one value: what stands between its brackets has no meaning for a crystal.
    fn container(&mut self) -> Result<Token<'a>, Located> {
        let (start, line) = (self.at, self.line);
        let mut depth = 0_usize;
        loop {
            match self.peek() {
                None => return Err(Located::new(line, Problem::OpenList)),
                Some(b'[' | b'{') => {
                    depth += 1;
                    self.at += 1;
                }
                Some(b']' | b'}') => {
                    depth -= 1;
                    self.at += 1;
                    if depth == 0 {
                        return Ok(self.enclosed(start, line));
                    }
                }
                Some(b'\'' | b'"') if self.begins_triple() => {
                    self.triple()?;
                }
                Some(mark @ (b'\'' | b'"')) => self.marked(mark)?,
                Some(b';') if self.at_line_start() => {
                    self.text_field()?;
                }
                Some(b'#') => self.skip(),
                Some(_) => self.step(),
            }
        }
    }

    /// Steps over a quotation inside a list or table, where any equal mark closes.
    fn marked(&mut self, quote: u8) -> Result<(), Located> {
        let line = self.line;
        self.at += 1;
        loop {
            match self.peek() {
                Some(byte) if byte == quote => {
                    self.at += 1;
                    return Ok(());
                }
                Some(byte) if !is_line_end(byte) => self.at += 1,
                _ => {
                    let quote = char::from(quote);
                    return Err(Located::new(line, Problem::OpenQuote { quote }));
                }
            }
        }
    }

    fn word(&mut self) -> Token<'a> {
        let start = self.at;
        while self.peek().is_some_and(|byte| !is_blank(byte)) {
            self.at += 1;
        }
        let text = self.slice(start, self.at);
        if text.starts_with('_') {
            return Token::Tag(text);
        }
        if let Some(name) = after_keyword(text, "data_") {
            return Token::Data(name);
        }
        if let Some(name) = after_keyword(text, "save_") {
            return Token::Save(name);
        }
        if text.eq_ignore_ascii_case("loop_") {
            return Token::Loop;
        }
        if text.eq_ignore_ascii_case("global_") || text.eq_ignore_ascii_case("stop_") {
            return Token::Reserved;
        }
        Token::Value(Value {
            text,
            quoted: false,
            line: self.line,
            start,
        })
    }
}

fn after_keyword<'a>(text: &'a str, keyword: &str) -> Option<&'a str> {
    let head = text.get(..keyword.len())?;
    head.eq_ignore_ascii_case(keyword)
        .then(|| text.get(keyword.len()..))
        .flatten()
}

fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// Every control character parts words, as form feeds and end-of-file marks of old editors do.
fn is_blank(byte: u8) -> bool {
    byte <= b' ' || byte == 0x7f
}
