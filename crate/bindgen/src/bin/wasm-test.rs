//! Runs wasm tests in a browser: what cargo takes for the runner of wasm targets.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os())
}
