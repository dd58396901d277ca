//! Splits the wasm module into two, which share memory and functions: `wasm-split INPUT FIRST SECOND`.
//!
//! The input is linked with `--emit-relocs` from the crate with its feature `split`. The second module receives
//! the functions that are marked there, and all code and data that nothing else reaches. The bindings are
//! generated from the first one.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow, bail};
use walrus::ModuleConfig;
use wasm_split_cli_support::{Options, transform};

fn main() -> anyhow::Result<()> {
    let paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [input, first, second] = &paths[..] else { bail!("usage: wasm-split INPUT FIRST SECOND") };
    let wasm = std::fs::read(input).with_context(|| format!("cannot read {}", input.display()))?;
    let folder = second.with_extension("split");
    let mut options = Options::new(&wasm);
    options.main_out_path = first;
    options.output_dir = &folder;
    let split = transform(options).map_err(|error| anyhow!("{error:?}"))?;
    let [module] = &split.split_modules[..] else {
        bail!("expected one other module than the first, found {}", split.split_modules.len())
    };
    let module = std::fs::read(module)?;
    std::fs::write(second, compacted(&module)?)?;
    remove(&folder)
}

/// Removes the folder of intermediate files.
fn remove(folder: &Path) -> anyhow::Result<()> {
    std::fs::remove_dir_all(folder).with_context(|| format!("cannot remove {}", folder.display()))
}

/// Encodes a module again: without names, and with short numbers in place of those that the linker could change.
fn compacted(module: &[u8]) -> anyhow::Result<Vec<u8>> {
    let mut module = ModuleConfig::new()
        .generate_name_section(false)
        .generate_producers_section(false)
        .parse(module)
        .context("cannot parse the second module")?;
    let sections: Vec<_> = module.customs.iter().map(|(id, _)| id).collect();
    for section in sections {
        module.customs.delete(section);
    }
    Ok(module.emit_wasm())
}
