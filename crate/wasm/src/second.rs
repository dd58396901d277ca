//! The second module.
//!
//! The app loads two modules with one memory: the first one contains what the first labels require, the second
//! one everything that only functions of [`second_module`] reach. `wasm-split` moves them.

/// Declares functions of the second module, each with a unique number of two hexadecimal digits.
///
/// With the feature `split`, a call traps unless the second module has been loaded. Without it, the functions
/// are ordinary ones.
macro_rules! second_module {
    ($(
        $id:literal fn $name:ident($($argument:ident: $Argument:ty),* $(,)?) -> $Return:ty $body:block
    )+) => {$(
        #[cfg(not(feature = "split"))]
        fn $name($($argument: $Argument),*) -> $Return $body

        #[cfg(feature = "split")]
        fn $name($($argument: $Argument),*) -> $Return {
            use std::mem::{ManuallyDrop, MaybeUninit};

            #[link(wasm_import_module = "__wasm_split_placeholder__")]
            #[expect(improper_ctypes, reason = "both sides are compiled together")]
            unsafe extern "C" {
                #[link_name = concat!(
                    "__wasm_split_00second00_import_000000000000000000000000000000", $id, "_", stringify!($name)
                )]
                fn import(
                    arguments: &mut ManuallyDrop<($($Argument,)*)>,
                    result: &mut MaybeUninit<$Return>,
                );
            }

            /// # Safety
            /// The arguments must not be used afterwards.
            #[unsafe(export_name = concat!(
                "__wasm_split_00second00_export_000000000000000000000000000000", $id, "_", stringify!($name)
            ))]
            unsafe extern "C" fn export(
                arguments: &mut ManuallyDrop<($($Argument,)*)>,
                result: &mut MaybeUninit<$Return>,
            ) {
                fn function($($argument: $Argument),*) -> $Return $body
                // SAFETY: by the contract of this function, this is the only use of the arguments.
                let ($($argument,)*) = unsafe { ManuallyDrop::take(arguments) };
                result.write(function($($argument),*));
            }

            let mut arguments = ManuallyDrop::new(($($argument,)*));
            let mut result = MaybeUninit::uninit();
            // SAFETY: the arguments are not used afterwards, and the function writes the result.
            unsafe {
                import(&mut arguments, &mut result);
                result.assume_init()
            }
        }
    )+};
}

pub(crate) use second_module;
