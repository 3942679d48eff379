//! `articulate group` on good input: the JSON contract, all groups of all kinds against an independent
//! program, symbols of every notation, points, and files that independent readers accept.

use crate::run::{directory, names, run};
use moyo::data::{
    HallSymbol, LayerSetting, hall_symbol_entry, layer_hall_symbol_entry,
    operations_from_layer_number,
};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;

/// An operation as integers: the matrix, and the translation in 24ths modulo the lattice.
type Key = ([[i32; 3]; 3], [i64; 3]);

/// Reads a triplet such as `-x+1/2,x-y,z`, with code of its own.
fn key(triplet: &str) -> Key {
    let (mut rotation, mut shift) = ([[0; 3]; 3], [0; 3]);
    for (row, text) in triplet.split(',').enumerate() {
        let spaced = text.replace('-', " -").replace('+', " ");
        for term in spaced.split_whitespace() {
            let (sign, name) = match term.strip_prefix('-') {
                Some(name) => (-1, name),
                None => (1, term),
            };
            match name {
                "x" => rotation[row][0] += sign,
                "y" => rotation[row][1] += sign,
                "z" => rotation[row][2] += sign,
                number => {
                    let (over, under) = number.split_once('/').unwrap_or((number, "1"));
                    let part: i64 =
                        over.parse::<i64>().unwrap() * 24 / under.parse::<i64>().unwrap();
                    shift[row] = (i64::from(sign) * part).rem_euclid(24);
                }
            }
        }
    }
    (rotation, shift)
}

fn keys(group: &Value) -> BTreeSet<Key> {
    let all = texts(&group["operations"]);
    let keys: BTreeSet<Key> = all.iter().map(|triplet| key(triplet)).collect();
    assert_eq!(keys.len(), all.len(), "an operation twice: {group}");
    keys
}

fn texts(list: &Value) -> Vec<String> {
    let list = list.as_array().expect("a list").iter();
    list.map(|text| text.as_str().expect("a text").to_owned())
        .collect()
}

/// The operations that moyo has for a Hall symbol; it writes `^` and `=` for `'` and `"`.
fn judged(hall: &str) -> BTreeSet<Key> {
    let symbol =
        HallSymbol::new(&hall.replace('\'', "^").replace('"', "=")).expect("a Hall symbol");
    let mut keys = BTreeSet::new();
    for operation in symbol.traverse().iter() {
        let shift = operation.translation_as_array();
        for centring in symbol.centering.lattice_points() {
            let units = [0, 1, 2]
                .map(|i| (((shift[i] + centring[i]) * 24.0).round() as i64).rem_euclid(24));
            keys.insert((operation.rotation_as_array(), units));
        }
    }
    keys
}

fn group(words: &[&str]) -> Value {
    let directory = directory();
    let mut all = vec!["group"];
    all.extend(words);
    all.push("--json");
    let ran = run(directory.path(), &all);
    assert_eq!(ran.code, 0, "{words:?}: {}", ran.stderr);
    serde_json::from_str(&ran.stdout).expect("standard output is JSON")
}

#[test]
fn all_230_have_the_operations_of_an_independent_program() {
    let all = group(&["--all"]);
    let all = all.as_array().expect("a list");
    assert_eq!(all.len(), 230);
    let mut symbols = BTreeSet::new();
    for (at, group) in all.iter().enumerate() {
        assert_eq!(group["number"], at + 1);
        let hall = group["hall"].as_str().expect("a text");
        assert_eq!(keys(group), judged(hall), "{hall}");
        // The Hall symbol belongs to the number.
        let known = (1..=530).filter_map(hall_symbol_entry);
        let mut known = known.filter(|entry| entry.number as usize == at + 1);
        assert!(
            known.any(|entry| judged(entry.hall_symbol) == judged(hall)),
            "{hall}"
        );
        let centring = group["centring"].as_array().expect("a list");
        let operations = group["operations"].as_array().expect("a list");
        assert_eq!(group["order"], operations.len() / centring.len());
        assert_eq!(centring[0], serde_json::json!([0.0, 0.0, 0.0]));
        assert!(!texts(&group["generators"]).is_empty());
        for field in [
            "hm",
            "point_group",
            "geometric",
            "system",
            "laue_class",
            "schoenflies",
        ] {
            assert!(
                group[field].as_str().is_some_and(|text| !text.is_empty()),
                "{hall}: {field}"
            );
        }
        assert!(
            symbols.insert(group["geometric"].to_string()),
            "{hall}: twice"
        );
    }
}

#[test]
fn all_groups_of_fewer_translations_are_there() {
    for (kind, count) in [
        ("--frieze", 7),
        ("--wallpaper", 17),
        ("--rod", 75),
        ("--layer", 80),
    ] {
        let all = group(&["--all", kind]);
        let all = all.as_array().expect("a list");
        assert_eq!(all.len(), count, "{kind}");
        for (at, group) in all.iter().enumerate() {
            assert_eq!(group["number"], at + 1, "{kind}");
            let own = keys(group);
            let in_plane = matches!(kind, "--frieze" | "--wallpaper");
            let completed: BTreeSet<Key> = own
                .iter()
                .map(|(rotation, shift)| {
                    let mut rotation = *rotation;
                    // A triplet of the plane leaves z as it is.
                    rotation[2][2] += i32::from(in_plane);
                    (rotation, *shift)
                })
                .collect();
            let hall = group["hall"].as_str().expect("a text");
            if !hall.contains('(') {
                assert_eq!(completed, judged(hall), "{kind} {hall}");
            }
        }
    }
    let all = group(&["--all", "--point"]);
    assert_eq!(all.as_array().map(Vec::len), Some(32));
}

#[test]
fn layer_groups_have_the_operations_of_an_independent_program() {
    let all = group(&["--all", "--layer"]);
    let moyo: Vec<BTreeSet<Key>> = (1..=116)
        .filter_map(|number| {
            let entry = layer_hall_symbol_entry(number)?;
            let setting = LayerSetting::HallNumber(number);
            operations_from_layer_number(entry.number, setting, false).ok()
        })
        .map(|operations| {
            let units = |value: &f64| ((value * 24.0).round() as i64).rem_euclid(24);
            let key = |operation: &moyo::base::Operation| {
                let shift = operation.translation_as_array();
                (
                    operation.rotation_as_array(),
                    [0, 1, 2].map(|i| units(&shift[i])),
                )
            };
            operations.iter().map(key).collect()
        })
        .collect();
    for group in all.as_array().expect("a list") {
        assert!(moyo.contains(&keys(group)), "{}", group["hm"]);
    }
}

#[test]
fn a_group_is_found_by_every_kind_of_symbol() {
    for text in [
        "227",
        "F d -3 m",
        "Fd-3m",
        "F d -3 m:2",
        "F 41/d -3 2/m",
        "Oh^7",
        "-F 4vw 2vw 3",
        "F_d 4 3",
    ] {
        let found = group(&[text]);
        assert_eq!(found["number"], 227, "{text}");
        assert_eq!(found["hm"], "F d -3 m", "{text}");
        assert_eq!(found["hall"], "-F 4vw 2vw 3", "{text}");
        assert_eq!(found["setting"]["choice"], "2", "{text}");
        assert_eq!(found["operations"].as_array().map(Vec::len), Some(192));
    }
    assert_eq!(group(&["F d -3 m:1"])["hall"], "F 4d 2 3 -1d");
    assert_eq!(
        group(&["R -3 c:R", "--cell", "6,55"])["centring"]
            .as_array()
            .map(Vec::len),
        Some(1)
    );
    assert_eq!(group(&["P 21/n"])["number"], 14);
    // The same text in two notations.
    let tetragonal = group(&["P 43"]);
    assert_eq!(
        (&tetragonal["number"], &tetragonal["also"][0]["number"]),
        (&78.into(), &221.into())
    );
    assert_eq!(group(&["P 43", "--notation", "geometric"])["number"], 221);
    assert_eq!(
        group(&["P 2", "--notation", "hall"])["setting"]["standard"],
        false
    );
    for (kind, text, number) in [
        ("--wallpaper", "p4g", 12),
        ("--wallpaper", "4*2", 12),
        ("--wallpaper", "442", 10),
        ("--frieze", "p 2 m g", 7),
        ("--layer", "p 4/n m m", 64),
        ("--rod", "p 42/m m c", 41),
        ("--plane", "17", 17),
    ] {
        assert_eq!(group(&[text, kind])["number"], number, "{kind} {text}");
    }
    for (text, order, name) in [
        ("4/mmm", 16, "D4h"),
        ("D4h", 16, "D4h"),
        ("42", 16, "D4h"),
        ("m-3m", 48, "Oh"),
        ("53", 120, "Ih"),
        ("b(5)b(3)", 60, "I"),
        ("I", 60, "I"),
        ("D5h", 20, "D5h"),
        ("D5d", 20, "D5d"),
        ("C7", 7, "C7"),
        ("C12v", 24, "C12v"),
        ("C5h", 10, "C5h"),
        ("S8", 8, "S8"),
        ("D12", 24, "D12"),
        ("-1", 2, "Ci"),
    ] {
        let found = group(&["--point", text]);
        assert_eq!(
            (&found["order"], &found["schoenflies"]),
            (&order.into(), &name.into()),
            "{text}"
        );
        assert_eq!(
            found["versors"].as_array().map(Vec::len),
            Some(order),
            "{text}"
        );
    }
}

#[test]
fn a_symbol_of_several_settings_takes_the_standard_one_and_says_so() {
    let directory = directory();
    let ran = run(directory.path(), &["group", "F d -3 m", "--json"]);
    assert_eq!(ran.code, 0);
    assert!(
        ran.stderr.starts_with("note: ") && ran.stderr.contains("`F d -3 m:1`"),
        "{}",
        ran.stderr
    );
    assert!(ran.stdout.starts_with('{'));
    // A number leaves nothing open.
    run(directory.path(), &["group", "227"]).well();
}

/// The image of a point under the versor that JSON tells: the reflection in the dual plane n + δ n_∞, then
/// the motor R + q n_∞, as rotation matrix and translation, by formulas of quaternions.
fn moved(versor: &Value, point: [f64; 3]) -> [f64; 3] {
    let mut x = point;
    if let Some(mirror) = versor["mirror"].as_object() {
        let n = ["e1", "e2", "e3"].map(|name| mirror[name].as_f64().unwrap());
        let distance = mirror
            .values()
            .map(|v| v.as_f64().unwrap())
            .next_back()
            .unwrap();
        assert_eq!(mirror.len(), 4);
        let height: f64 = (0..3).map(|i| n[i] * x[i]).sum::<f64>() - distance;
        x = [0, 1, 2].map(|i| x[i] - 2.0 * height * n[i]);
    }
    let motor = versor["motor"].as_object().expect("a motor");
    let part = |name: &str| motor[name].as_f64().unwrap();
    // e23, e31, e12 are minus i, j, k.
    let q = [part("1"), -part("e23"), part("e13"), -part("e12")];
    let product = |a: [f64; 4], b: [f64; 4]| {
        [
            a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
        ]
    };
    let back = [q[0], -q[1], -q[2], -q[3]];
    let turned = product(product(q, [0.0, x[0], x[1], x[2]]), back);
    // (1 − ½ v n_∞) R: the rest of the motor is −½ v n_∞ R = −½ (v R) n_∞ for even R.
    let rest = |names: [&str; 4]| names.map(part);
    let labels: Vec<&str> = motor
        .keys()
        .map(String::as_str)
        .filter(|name| name.contains("ni"))
        .collect();
    assert_eq!(labels.len(), 4, "{labels:?}");
    let find = |blade: &str| {
        labels
            .iter()
            .copied()
            .find(|name| name.replace(['^', '∧'], "") == blade)
            .unwrap()
    };
    let [e1, e2, e3, e123] = rest([find("e1ni"), find("e2ni"), find("e3ni"), find("e123ni")]);
    // v R = −2 (e1, e2, e3, e123); as v is the vector of v R R̃ by components.
    let (s, b12, b13, b23) = (part("1"), part("e12"), part("e13"), part("e23"));
    let (a1, a2, a3, t) = (-2.0 * e1, -2.0 * e2, -2.0 * e3, -2.0 * e123);
    let shift = [
        a1 * s + a2 * b12 + a3 * b13 + t * b23,
        a2 * s - a1 * b12 + a3 * b23 - t * b13,
        a3 * s - a1 * b13 - a2 * b23 + t * b12,
    ];
    [0, 1, 2].map(|i| turned[i + 1] + shift[i])
}

#[test]
fn the_versors_do_what_the_operations_say() {
    for words in [
        ["227", "5"],
        ["14", "5,6,7,100"],
        ["154", "4.9,5.4"],
        ["2", "5,6,7,80,95,110"],
        ["98", "4,7"],
        ["214", "6"],
        ["61", "5,6,7"],
    ] {
        let found = group(&[words[0], "--cell", words[1]]);
        let cell = &found["cell"];
        let number = |name: &str| cell[name].as_f64().unwrap();
        let (a, b, c) = (number("a"), number("b"), number("c"));
        let (ca, cb, cg) = (
            number("alpha").cos(),
            number("beta").cos(),
            number("gamma").cos(),
        );
        let sg = number("gamma").sin();
        let tilt = (ca - cb * cg) / sg;
        let height = (1.0 - cb * cb - tilt * tilt).sqrt();
        // a along x, b in the plane of x and y.
        let cartesian = |f: [f64; 3]| {
            [
                a * f[0] + b * cg * f[1] + c * cb * f[2],
                b * sg * f[1] + c * tilt * f[2],
                c * height * f[2],
            ]
        };
        let point = [0.13, 0.29, 0.41];
        let versors = found["versors"].as_array().expect("a list");
        assert_eq!(
            versors.len(),
            found["operations"].as_array().map_or(0, Vec::len)
        );
        for (versor, operation) in versors.iter().zip(texts(&found["operations"])) {
            assert_eq!(versor["operation"], operation.as_str());
            let (rotation, shift) = key(&operation);
            let image = [0, 1, 2].map(|i| {
                let turned: f64 = (0..3).map(|j| f64::from(rotation[i][j]) * point[j]).sum();
                turned + shift[i] as f64 / 24.0
            });
            let (expected, found) = (cartesian(image), moved(versor, cartesian(point)));
            for (one, other) in expected.iter().zip(found) {
                assert!(
                    (one - other).abs() < 1e-9,
                    "{words:?} {operation}: {expected:?} {found:?}"
                );
            }
        }
    }
}

#[test]
fn a_point_is_told_its_wyckoff_position_and_orbit() {
    let found = group(&["227", "--cell", "5.43", "--at", "0.126,0.125,0.125"]);
    let site = &found["site"];
    assert_eq!(
        (&site["letter"], &site["multiplicity"]),
        (&"a".into(), &8.into())
    );
    assert_eq!(site["site_symmetry"], "-43m");
    assert_eq!(site["place"], serde_json::json!([0.125, 0.125, 0.125]));
    assert!((site["distance"].as_f64().unwrap() - 0.00543).abs() < 1e-9);
    assert_eq!(site["orbit"].as_array().map(Vec::len), Some(8));
    let exact = group(&[
        "227",
        "--cell",
        "5.43",
        "--at",
        "0.126,0.125,0.125",
        "--snap",
        "0.001",
    ]);
    assert_ne!(exact["site"]["letter"], "a");
    // The centre of fourfold rotation of p4gm, and its mirror.
    for (at, multiplicity) in [("0.004,0.003,0", 2), ("0.3,0.2,0", 4), ("0.1,0.23,0", 8)] {
        let site = &group(&["12", "--wallpaper", "--at", at])["site"];
        assert_eq!(site["multiplicity"], multiplicity, "{at}: {site}");
    }
    let wyckoff = &found["wyckoff"];
    let letters: Vec<&str> = wyckoff
        .as_array()
        .unwrap()
        .iter()
        .map(|p| p["letter"].as_str().unwrap())
        .collect();
    assert_eq!(letters.concat(), "abcdefghi");
}

#[test]
fn a_motif_becomes_files_that_others_read() {
    let directory = directory();
    let words = [
        "group", "62", "--motif", "hand", "--cells", "2x1x1", "--json", "--out", "a.glb", "--out",
        "a.obj", "--out", "a.stl", "--out", "a.ply", "--out", "a.svg", "--out", "a.json",
    ];
    let ran = run(directory.path(), &words).well();
    let told: Value = serde_json::from_str(&ran).expect("JSON");
    assert_eq!(
        (&told["motif"]["copies"], &told["motif"]["name"]),
        (&16.into(), &"hand".into())
    );
    let expected = [
        "a.glb", "a.json", "a.mtl", "a.obj", "a.ply", "a.stl", "a.svg",
    ];
    assert_eq!(names(directory.path()), expected);
    let read = |name: &str| fs::read(directory.path().join(name)).expect("the file is there");
    assert_eq!(read("a.json"), ran.as_bytes());
    let model = gltf::Gltf::from_slice(&read("a.glb")).expect("a valid GLB file");
    let hands = |mirrored: bool| {
        let of_hand = |node: &gltf::Node| {
            let name = node.mesh().and_then(|mesh| mesh.name().map(str::to_owned));
            name.is_some_and(|name| {
                name.starts_with("hand") && name.contains("mirrored") == mirrored
            })
        };
        model.nodes().filter(of_hand).count()
    };
    // Half the operations change the hand.
    assert_eq!((hands(false), hands(true)), (8, 8));
    let text = String::from_utf8(read("a.svg")).expect("UTF-8");
    let drawing = roxmltree::Document::parse(&text).expect("well-formed XML");
    let paths = drawing
        .descendants()
        .filter(|node| node.has_tag_name("path"));
    // Twelve edges of each of two cells, and the strokes of sixteen hands.
    assert!(paths.count() > 24 + 16);
}

#[test]
fn a_group_of_the_plane_is_drawn_with_filled_commas() {
    let directory = directory();
    for (text, copies, mirrored) in [
        ("p1", 12, 0),
        ("p4g", 96, 48),
        ("cm", 48, 24),
        ("p6m", 144, 72),
    ] {
        run(
            directory.path(),
            &["group", text, "--wallpaper", "--out", "w.svg"],
        )
        .well();
        let text = fs::read_to_string(directory.path().join("w.svg")).expect("the file is there");
        let drawing = roxmltree::Document::parse(&text).expect("well-formed XML");
        let motifs: Vec<_> = drawing
            .descendants()
            .filter(|node| node.attribute("class") == Some("motif"))
            .collect();
        assert_eq!(motifs.len(), copies);
        let of_second = motifs
            .iter()
            .filter(|node| node.attribute("fill") == Some("#e27024"));
        assert_eq!(of_second.count(), mirrored);
    }
}

#[test]
fn a_motif_may_come_from_a_file() {
    let directory = directory();
    let write = |name: &str, text: &str| {
        fs::write(directory.path().join(name), text).expect("the file is written");
    };
    write(
        "t.obj",
        "v 0 0 0\nv 3 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    );
    write(
        "w.xyz",
        "3\nwater\nO 0 0 0\nH 0.76 0.59 0\nH -0.76 0.59 0\n",
    );
    write(
        "t.stl",
        "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
         endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\n\
         endfacet\nendsolid t\n",
    );
    for (motif, parts) in [("t.obj", 1), ("w.xyz", 3), ("t.stl", 1)] {
        let words = [
            "group",
            "P 21 21 21",
            "--motif",
            motif,
            "--out",
            "m.glb",
            "--out",
            "m.svg",
        ];
        run(directory.path(), &words).well();
        let bytes = fs::read(directory.path().join("m.glb")).expect("the file is there");
        let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
        let is_copy =
            |node: &gltf::Node| node.mesh().is_some_and(|mesh| mesh.name() != Some("cell"));
        assert_eq!(model.nodes().filter(is_copy).count(), 4 * parts, "{motif}");
    }
    // Atoms on a special position are merged: sodium chloride has four at the origin.
    write("na.xyz", "1\n\nNa 0 0 0\n");
    let words = [
        "group", "225", "--at", "0,0,0", "--motif", "na.xyz", "--out", "na.glb",
    ];
    run(directory.path(), &words).well();
    let bytes = fs::read(directory.path().join("na.glb")).expect("the file is there");
    let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
    let atoms = model
        .nodes()
        .filter(|node| node.mesh().is_some_and(|mesh| mesh.name() != Some("cell")));
    assert_eq!(atoms.count(), 4);
}

#[test]
fn symmetry_elements_are_listed_and_drawn() {
    let directory = directory();
    let words = [
        "group",
        "19",
        "--symmetry",
        "--json",
        "--out",
        "s.glb",
        "--out",
        "s.svg",
    ];
    let told = run(directory.path(), &words).json();
    let elements = told["symmetry_elements"].as_array().expect("a list");
    assert!(
        elements.iter().all(|element| element["symbol"] == "2_1"),
        "{elements:?}"
    );
    let bytes = fs::read(directory.path().join("s.glb")).expect("the file is there");
    let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
    let drawn = model
        .nodes()
        .filter(|node| node.name().is_some_and(|name| name.starts_with("2_1")));
    assert!(drawn.count() > 3);
    let text = fs::read_to_string(directory.path().join("s.svg")).expect("the file is there");
    let drawing = roxmltree::Document::parse(&text).expect("well-formed XML");
    let named = drawing
        .descendants()
        .filter(|node| node.text() == Some("2_1"));
    assert!(named.count() > 3);
}

#[test]
fn the_summary_has_the_terms_of_international_tables() {
    let directory = directory();
    let text = run(directory.path(), &["group", "62"]).well();
    for word in [
        "P n m a",
        "D2h^16",
        "mmm",
        "orthorhombic",
        "62",
        "P 21/n 21/m 21/a",
        "-P 2ac 2n",
        "oP",
        "(1) x,y,z",
        "Generators",
        "Positions",
        "T_",
    ] {
        assert!(text.contains(word), "{word} in {text}");
    }
    let general = text
        .lines()
        .find(|line| line.trim_start().starts_with("8  d"));
    assert!(
        general.is_some_and(|line| line.contains("(x,y,z)")),
        "{text}"
    );
    let list = run(directory.path(), &["group", "--all"]).well();
    assert_eq!(list.lines().count(), 231);
    let point = run(directory.path(), &["group", "--point", "53"]).well();
    assert!(
        point.contains("rotoreflection") && point.contains("order 120"),
        "{point}"
    );
    assert!(names(directory.path()).is_empty());
}
