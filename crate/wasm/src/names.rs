//! Joint names that are not UTF-8, decoded by the browser.

use js_sys::{Object, Reflect};
use plantigrade::bvh;
use plantigrade::skeleton::known_name_count;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    type TextDecoder;

    #[wasm_bindgen(constructor, catch)]
    fn new(label: &str, options: &JsValue) -> Result<TextDecoder, JsValue>;

    #[wasm_bindgen(method, catch)]
    fn decode(this: &TextDecoder, bytes: &[u8]) -> Result<String, JsValue>;
}

/// Encodings of joint names in files of other programs, as the Encoding Standard names them.
const ENCODINGS: [&str; 5] = ["Shift_JIS", "GBK", "Big5", "EUC-KR", "windows-1251"];

/// Decodes names in the encoding that gives the most names with a meaning; windows-1252 if none is
/// better.
///
/// The decoders of the browser save the tables of the encodings in the module.
pub(crate) fn decode(names: &[Vec<u8>]) -> (Vec<String>, &'static str) {
    let mut best = bvh::decode_windows_1252(names);
    let count = |names: &[String]| known_name_count(names.iter().map(String::as_str));
    let mut best_count = count(&best.0);
    for encoding in ENCODINGS {
        let Some(decoded) = decode_as(names, encoding) else { continue };
        let decoded_count = count(&decoded);
        if decoded_count > best_count {
            best = (decoded, encoding);
            best_count = decoded_count;
        }
    }
    best
}

/// Decodes names, if all of them are valid in the encoding.
fn decode_as(names: &[Vec<u8>], encoding: &str) -> Option<Vec<String>> {
    let options = Object::new();
    for option in ["fatal", "ignoreBOM"] {
        Reflect::set(&options, &option.into(), &true.into()).ok()?;
    }
    let decoder = TextDecoder::new(encoding, &options).ok()?;
    names.iter().map(|name| decoder.decode(name).ok()).collect()
}
