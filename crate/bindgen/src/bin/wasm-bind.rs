//! Generates the JavaScript and TypeScript bindings of a wasm module. This is `wasm-bindgen` at
//! the version in the lock file, so nothing has to be installed.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(std::env::args_os())
}
