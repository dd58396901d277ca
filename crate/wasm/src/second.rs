//! The second module.
//!
//! The app loads two modules with one memory: the first one contains what the first labels require, the second
//! one everything that only functions of [`second_module`] reach. `wasm-split` moves them.

/// Declares functions of the second module, each with a unique number of two hexadecimal digits.
///
/// With the feature `split`, a call traps unless the second module has been loaded. Without it, the functions
/// are ordinary ones.
macro_rules! second_module {
    ($($(#[$attribute:meta])* $id:literal fn $name:ident($($argument:ident: $Argument:ty),* $(,)?) -> $Return:ty $body:block)+) => {$(
        $(#[$attribute])*
        #[cfg(not(feature = "split"))]
        fn $name($($argument: $Argument),*) -> $Return $body

        $(#[$attribute])*
        #[cfg(feature = "split")]
        fn $name($($argument: $Argument),*) -> $Return {
            #[link(wasm_import_module = "__wasm_split_placeholder__")]
            #[expect(improper_ctypes, reason = "both sides are compiled together")]
            unsafe extern "C" {
                #[link_name = concat!(
                    "__wasm_split_00second00_import_000000000000000000000000000000", $id, "_", stringify!($name)
                )]
                safe fn import(call: &mut $crate::second::Call<($($Argument,)*), $Return>);
            }

            #[unsafe(export_name = concat!(
                "__wasm_split_00second00_export_000000000000000000000000000000", $id, "_", stringify!($name)
            ))]
            extern "C" fn export(call: &mut $crate::second::Call<($($Argument,)*), $Return>) {
                fn function($($argument: $Argument),*) -> $Return $body
                call.run(|($($argument,)*)| function($($argument),*));
            }

            $crate::second::Call::make(($($argument,)*), |call| import(call))
        }
    )+};
}

pub(crate) use second_module;

/// A call of a function in another module: its arguments, then its result.
#[cfg(feature = "split")]
pub(crate) enum Call<Arguments, Return> {
    Requested(Arguments),
    Running,
    Returned(Return),
}

#[cfg(feature = "split")]
impl<Arguments, Return> Call<Arguments, Return> {
    /// Calls a function and returns its result.
    pub(crate) fn make(arguments: Arguments, function: impl FnOnce(&mut Self)) -> Return {
        let mut call = Call::Requested(arguments);
        function(&mut call);
        match call {
            Call::Returned(result) => result,
            _ => unreachable!("the function returns a result"),
        }
    }

    /// Replaces the arguments by the result of a function.
    pub(crate) fn run(&mut self, function: impl FnOnce(Arguments) -> Return) {
        if let Call::Requested(arguments) = std::mem::replace(self, Call::Running) {
            *self = Call::Returned(function(arguments));
        }
    }
}
