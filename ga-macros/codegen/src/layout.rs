//! Generated code as people read it: the lists of functions and the bodies laid out like
//! implementations and blocks, and documentation in line comments.

use proc_macro2::Span;
use syn::{Block, Expr, Ident, ImplItem, Item, Macro, Stmt};

/// The list of functions, as generated code calls it, and the module that stands for it while
/// the code is laid out.
const LIST: (&str, &str) = ("algebra::unrolled! {", "mod list_of_unrolled_functions {");

/// A body, as generated code hands it on, and the block that stands for it.
const BODY: (&str, &str) = ("algebra::kernel! {", "'body_of_a_kernel: {");

/// A file as text.
pub fn source(mut file: syn::File) -> String {
    open_lists(&mut file.items);
    let text = prettyplease::unparse(&file)
        .replace(LIST.1, LIST.0)
        .replace(BODY.1, BODY.0);
    line_comments(&text)
}

/// Turns the lists of functions, whose content reads as an implementation, into modules with
/// that implementation, which are laid out like any code.
fn open_lists(items: &mut [Item]) {
    for item in items {
        match item {
            Item::Mod(module) => {
                if let Some((_, items)) = &mut module.content {
                    open_lists(items);
                }
            }
            Item::Impl(implementation) => {
                for function in &mut implementation.items {
                    if let ImplItem::Fn(function) = function {
                        open_body(&mut function.block);
                    }
                }
            }
            Item::Macro(call) if is_call_of(&call.mac, "unrolled") => {
                let Ok(list) = syn::parse2::<syn::ItemImpl>(call.mac.tokens.clone()) else {
                    continue;
                };
                let name = Ident::new("list_of_unrolled_functions", Span::call_site());
                *item = syn::parse_quote!(mod #name { #list });
            }
            _ => {}
        }
    }
}

/// Turns a body that is handed on whole into a block.
fn open_body(block: &mut Block) {
    let call = match block.stmts.as_slice() {
        [Stmt::Macro(statement)] => &statement.mac,
        [Stmt::Expr(Expr::Macro(expression), None)] => &expression.mac,
        _ => return,
    };
    if !is_call_of(call, "kernel") {
        return;
    }
    if let Ok(statements) = call.parse_body_with(Block::parse_within) {
        let label = syn::Lifetime::new("'body_of_a_kernel", Span::call_site());
        block.stmts = vec![syn::parse_quote!(#label: { #(#statements)* })];
    }
}

fn is_call_of(call: &Macro, name: &str) -> bool {
    call.path
        .segments
        .last()
        .is_some_and(|segment| segment.ident == name)
}

/// Documentation in block comments as line comments, which is how people read it.
fn line_comments(source: &str) -> String {
    let mut result = String::with_capacity(source.len());
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        let text = line.trim_start();
        let indent = &line[..line.len() - text.len()];
        let Some(mut comment) = text.strip_prefix("/**") else {
            result.push_str(line);
            result.push('\n');
            continue;
        };
        loop {
            let (content, closed) = match comment.strip_suffix("*/") {
                Some(content) => (content, true),
                None => (comment, false),
            };
            result.push_str(format!("{indent}///{content}").trim_end());
            result.push('\n');
            match (closed, lines.next()) {
                (false, Some(next)) => comment = next,
                (_, Some(next)) => {
                    result.push_str(next);
                    result.push('\n');
                    break;
                }
                (_, None) => break,
            }
        }
    }
    result
}
