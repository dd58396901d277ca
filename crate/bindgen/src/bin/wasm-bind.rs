//! Writes the JavaScript and types that go with a wasm module: `wasm-bindgen`
//! of the version that the lock file fixes, without anything to install.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(std::env::args_os())
}
