//! Batch processing: one result per input, on standard output or in a folder.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::args::{ReadArgs, WriteArgs};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input, LoadedClip};
use crate::output::{self, Origin, OutputFolder};
use crate::parallel;

/// Inputs, outputs and options of a batch.
pub struct Batch<'a> {
    /// Inputs and reader options.
    pub read: &'a ReadArgs,
    /// Output options.
    pub write: &'a WriteArgs,
    /// File extension of the results.
    pub extension: &'a str,
    /// All other options that change the results.
    pub options: String,
}

impl Batch<'_> {
    /// Computes and writes the results of all inputs. Returns the number of inputs that failed.
    pub fn run<R: AsRef<[u8]>>(
        &self,
        compute: impl Fn(&Input, &LoadedClip) -> Result<R, InputError> + Sync,
    ) -> Result<usize, UsageError> {
        let inputs = input::collect(self.read)?;
        match &self.write.out {
            None if inputs.len() > 1 => Err(UsageError::MissingOut(inputs.len())),
            None => {
                let (_, failures) = parallel::map(&inputs, self.write.jobs, |input| {
                    let result = compute(input, &input::load(input, self.read)?)?;
                    let written = output::print_bytes(result.as_ref());
                    written.map_err(|error| InputError::Write { path: "<stdout>".into(), error })
                });
                Ok(failures)
            }
            Some(folder) => self.run_to_folder(folder, &inputs, compute),
        }
    }

    fn run_to_folder<R: AsRef<[u8]>>(
        &self,
        folder: &Path,
        inputs: &[Input],
        compute: impl Fn(&Input, &LoadedClip) -> Result<R, InputError> + Sync,
    ) -> Result<usize, UsageError> {
        self.check_output_names(inputs)?;
        let folder_error = |error| UsageError::OutputFolder { folder: folder.into(), error };
        let output = OutputFolder::open(folder).map_err(folder_error)?;
        let ReadArgs { paths: _, fps, up, joints, unit, lenient } = self.read;
        let read_options = format!("{fps:?} {up:?} {joints:?} {unit:?} {lenient}");
        let options = format!("{} {} {read_options}", self.options, self.extension);
        let (_, failures) = parallel::map(inputs, self.write.jobs, |input| {
            let name = self.output_name(input);
            let loaded = input::load(input, self.read)?;
            let origin = Origin { sha256: &loaded.sha256, options: options.clone() };
            if !self.write.force && output.is_up_to_date(&name, &origin) {
                return Ok(());
            }
            let result = compute(input, &loaded)?;
            let written = output.write(&name, result.as_ref(), &origin);
            written.map_err(|error| InputError::Write { path: output.path(&name), error })
        });
        output.close().map_err(folder_error)?;
        Ok(failures)
    }

    /// Checks that no two inputs have the same output file.
    fn check_output_names(&self, inputs: &[Input]) -> Result<(), UsageError> {
        let mut input_by_output: BTreeMap<PathBuf, &Input> = BTreeMap::new();
        for input in inputs {
            let output = self.output_name(input);
            if let Some(other) = input_by_output.insert(output.clone(), input) {
                let (first, second) = (other.path.clone(), input.path.clone());
                return Err(UsageError::OutputConflict { first, second, output });
            }
        }
        Ok(())
    }

    /// Returns the path of the result of an input, relative to the output folder.
    fn output_name(&self, input: &Input) -> PathBuf {
        let mut name = input.stem.clone().into_os_string();
        name.push(".");
        name.push(self.extension);
        name.into()
    }
}
