//! Feeds the CIF reader with files that are changed word by word: tags taken out, doubled, replaced
//! by others, numbers made extreme, lines cut; and now and then byte by byte.

#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};

#[path = "../../tests/cif/survives.rs"]
mod survives;

/// Words that mean something in the files, one a line.
const WORDS: &str = include_str!("../words.txt");

fuzz_target!(|bytes: &[u8]| survives::survives(bytes));

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    let mut random = Random(u64::from(seed) << 16 | 0x9E37);
    // A third of the changes are those of the fuzzer itself, which know no words.
    if random.below(3) == 0 {
        return fuzzer_mutate(data, size, max_size);
    }
    let text = String::from_utf8_lossy(&data[..size]).into_owned();
    let mut words: Vec<String> = pieces(&text);
    for _ in 0..1 + random.below(4) {
        change(&mut words, &mut random);
    }
    let changed: String = words.concat();
    let length = changed.len().min(max_size);
    data[..length].copy_from_slice(&changed.as_bytes()[..length]);
    length
});

/// Words and the blanks between them, in turn.
fn pieces(text: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut was_blank = None;
    for c in text.chars() {
        match all.last_mut() {
            Some(last) if was_blank == Some(c.is_whitespace()) => last.push(c),
            _ => all.push(c.to_string()),
        }
        was_blank = Some(c.is_whitespace());
    }
    all
}

fn change(words: &mut Vec<String>, random: &mut Random) {
    let known: Vec<&str> = WORDS.lines().collect();
    let at = random.below(words.len().max(1));
    let other = random.below(words.len().max(1));
    let word = known[random.below(known.len())].replace("\\n", "\n");
    if words.is_empty() {
        words.push(word);
        return;
    }
    match random.below(8) {
        0 => words[at] = word,
        1 => words.insert(at, format!("\n{word}\n")),
        2 => drop(words.remove(at)),
        3 => words.swap(at, other),
        4 => {
            let (from, to) = (at.min(other), at.max(other));
            let copied: Vec<String> = words[from..to.min(from + 40)].to_vec();
            words.splice(to..to, copied);
        }
        5 => {
            let to = (at + random.below(12)).min(words.len());
            words.drain(at..to);
        }
        6 => words[at] = number(random),
        _ => {
            let copied = words[other].clone();
            words[at].push_str(&copied);
        }
    }
}

fn number(random: &mut Random) -> String {
    const EXTREME: [&str; 16] = [
        "0",
        "-0",
        "1e-300",
        "1e300",
        "999.999",
        "-1000",
        "0.3333",
        "1/3",
        "90.000001",
        "0.001",
        "1.0(99)",
        "179.99",
        "59.9",
        "1e5",
        "2.5(1)e-3",
        "120",
    ];
    match random.below(3) {
        0 => EXTREME[random.below(EXTREME.len())].to_owned(),
        1 => format!("{}", random.below(1000) as f64 / 1000.0),
        _ => format!("{}", random.below(20_000) as f64 / 100.0),
    }
}

/// A small generator (xorshift64*), since the fuzzer wants the same change for the same seed.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % limit
    }
}
