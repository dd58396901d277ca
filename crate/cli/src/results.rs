//! One result per input: on standard output, or in a folder.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::args::{ReadArgs, WriteArgs};
use crate::failure::Failure;
use crate::inputs::{self, Input, Loaded};
use crate::output::{OutputFolder, Recipe};
use crate::parallel;

/// What results are made of.
pub struct Results<'a> {
    /// The clips, and how to read them.
    pub read: &'a ReadArgs,
    /// Where to.
    pub write: &'a WriteArgs,
    /// The ending of the files' names.
    pub ending: &'a str,
    /// All else of the command line that changes the results.
    pub settings: String,
}

impl Results<'_> {
    /// Makes and writes all results and counts inputs that failed; an error is one of the command line.
    pub fn make<R: AsRef<[u8]>>(
        &self,
        make: impl Fn(&Input, &Loaded) -> Result<R, Failure> + Sync,
    ) -> Result<usize, String> {
        let inputs = inputs::collect(self.read)?;
        match &self.write.out {
            None if inputs.len() > 1 => {
                Err(format!("there are {} inputs: name a folder for their results with --out", inputs.len()))
            }
            None => Ok(parallel::for_each(&inputs, self.write.jobs, |_, input| {
                let result = make(input, &inputs::load(input, self.read)?)?;
                let written = io::stdout().write_all(result.as_ref());
                written.map_err(|error| Failure::Write { path: "<stdout>".into(), error })
            })),
            Some(folder) => self.make_in(folder, &inputs, make),
        }
    }

    fn make_in<R: AsRef<[u8]>>(
        &self,
        folder: &Path,
        inputs: &[Input],
        make: impl Fn(&Input, &Loaded) -> Result<R, Failure> + Sync,
    ) -> Result<usize, String> {
        let mut owners: BTreeMap<PathBuf, &Input> = BTreeMap::new();
        for input in inputs {
            let name = self.name(input);
            if let Some(other) = owners.insert(name.clone(), input) {
                return Err(format!(
                    "{} and {} would both be written to {}",
                    other.path.display(),
                    input.path.display(),
                    name.display()
                ));
            }
        }
        let cannot_write = |error| format!("cannot write to {}: {error}", folder.display());
        let output = OutputFolder::open(folder).map_err(cannot_write)?;
        let ReadArgs { paths: _, fps, up, joints, unit, lenient } = self.read;
        let how = format!("{fps:?} {up:?} {joints:?} {unit:?} {lenient}");
        let settings = format!("{} {} {how}", self.settings, self.ending);
        let failed = parallel::for_each(inputs, self.write.jobs, |_, input| {
            let name = self.name(input);
            let loaded = inputs::load(input, self.read)?;
            let recipe = Recipe { sha256: &loaded.sha256, settings: settings.clone() };
            if !self.write.force && output.is_made(&name, &recipe) {
                return Ok(());
            }
            let result = make(input, &loaded)?;
            let written = output.write(&name, result.as_ref(), &recipe);
            written.map_err(|error| Failure::Write { path: output.path(&name), error })
        });
        output.close().map_err(cannot_write)?;
        Ok(failed)
    }

    /// Where the result of an input goes in the folder.
    fn name(&self, input: &Input) -> PathBuf {
        let mut name = input.stem.clone().into_os_string();
        name.push(".");
        name.push(self.ending);
        name.into()
    }
}
