//! Batch processing: one result per input, on standard output or in a folder.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

use crate::args::{ReadArgs, WriteArgs};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input, LoadedClip};
use crate::output;
use crate::output_folder::{Origin, OutputFolder, RESERVED_NAMES, hex_digest};
use crate::parallel;
use crate::text::{decode, display_name};

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
        match self.write.folder() {
            None if inputs.len() > 1 => Err(UsageError::MissingOut(inputs.len())),
            None => {
                let (_, failures) = parallel::map(&inputs, self.write.jobs, |input| {
                    let result = compute(input, &input::load(input, self.read)?)?;
                    output::write(Path::new("-"), result.as_ref())
                });
                Ok(failures)
            }
            Some(folder) => Ok(self.run_to_folder(folder, inputs, compute)),
        }
    }

    /// Analyses all inputs, combines the analyses, and writes the results. Returns the number of inputs
    /// that failed.
    ///
    /// Every result depends on all inputs, so the origin of each result includes the hashes of all inputs.
    /// Results of an interrupted batch are therefore reused only if no input changed, and equal those of a
    /// batch that was not interrupted. Analyses are not stored: a batch that resumes repeats them.
    pub fn run_jointly<T: Send>(
        &self,
        analyse: impl Fn(&Input, &LoadedClip) -> Result<T, InputError> + Sync,
        combine: impl FnOnce(&mut [T]),
        result: impl Fn(T) -> Vec<u8>,
    ) -> Result<usize, UsageError> {
        let mut inputs = input::collect(self.read)?;
        let analyse = |input: &Input| {
            let loaded = input::load(input, self.read)?;
            Ok(Analysis { input: input.clone(), content: analyse(input, &loaded)?, sha256: loaded.sha256 })
        };
        let Some(folder) = self.write.folder() else {
            if inputs.len() > 1 {
                return Err(UsageError::MissingOut(inputs.len()));
            }
            let (analyses, mut failures) = parallel::map(&inputs, self.write.jobs, analyse);
            let mut contents: Vec<T> = analyses.into_iter().map(|analysis| analysis.content).collect();
            combine(&mut contents);
            for content in contents {
                failures += report_write_error(output::STDOUT.into(), output::print_bytes(&result(content)));
            }
            return Ok(failures);
        };
        let output = match self.open_folder(folder, &mut inputs) {
            Ok(output) => output,
            Err(failures) => return Ok(failures),
        };
        let hashes: Vec<Option<String>> = inputs.iter().map(input::sha256).collect();
        let options = format!("{} {}", self.all_options(), joint_digest(&inputs, &hashes));
        let is_reusable = hashes.iter().all(Option::is_some);
        let is_done: Vec<bool> = inputs
            .iter()
            .zip(&hashes)
            .map(|(input, sha256)| {
                let origin =
                    Origin { sha256: sha256.as_deref().unwrap_or_default(), options: options.clone() };
                is_reusable
                    && input.problem.is_none()
                    && output.is_up_to_date(&self.output_name(input), &origin)
            })
            .collect();
        let with = |wanted: bool| -> Vec<Input> {
            let inputs = inputs.iter().zip(&is_done).filter(|(_, is_done)| **is_done == wanted);
            inputs.map(|(input, _)| input.clone()).collect()
        };
        let (mut analyses, mut failures) = parallel::map(&with(false), self.write.jobs, analyse);
        if !analyses.is_empty() {
            let (done, failures_of_done) = parallel::map(&with(true), self.write.jobs, analyse);
            analyses.extend(done);
            failures += failures_of_done;
            let places: BTreeMap<&Path, usize> =
                inputs.iter().enumerate().map(|(place, input)| (&*input.path, place)).collect();
            analyses.sort_by_key(|analysis| places[&*analysis.input.path]);
            let (sources, mut contents): (Vec<_>, Vec<T>) = analyses
                .into_iter()
                .map(|Analysis { input, content, sha256 }| ((input, sha256), content))
                .unzip();
            combine(&mut contents);
            for ((input, sha256), content) in sources.into_iter().zip(contents) {
                let name = self.output_name(&input);
                let origin = Origin { sha256: &sha256, options: options.clone() };
                if is_reusable && output.is_up_to_date(&name, &origin) {
                    continue;
                }
                let written = output.write(&name, &result(content), &origin);
                failures += report_write_error(output.path(&name), written);
            }
        }
        match output.close() {
            Ok(()) => Ok(failures),
            Err(error) => Ok(failures + report_folder_error(folder, error)),
        }
    }

    /// Opens the output folder and marks inputs with conflicting results. Returns the number of failures
    /// if the folder cannot be used.
    fn open_folder(&self, folder: &Path, inputs: &mut [Input]) -> Result<OutputFolder, usize> {
        let names: Vec<PathBuf> = inputs.iter().map(|input| self.output_name(input)).collect();
        let output = OutputFolder::open(folder, names.iter().map(PathBuf::as_path), self.write.force)
            .map_err(|error| report_folder_error(folder, error))?;
        mark_conflicts(inputs, &names, output.ignores_case());
        Ok(output)
    }

    /// Returns all options that change the results, those of the reader included.
    fn all_options(&self) -> String {
        let ReadArgs { paths: _, fps, up, joints, unit, lenient } = self.read;
        let read_options = format!("{fps:?} {up:?} {joints:?} {unit:?} {lenient}");
        format!("{} {} {read_options}", self.options, self.extension)
    }

    fn run_to_folder<R: AsRef<[u8]>>(
        &self,
        folder: &Path,
        mut inputs: Vec<Input>,
        compute: impl Fn(&Input, &LoadedClip) -> Result<R, InputError> + Sync,
    ) -> usize {
        let output = match self.open_folder(folder, &mut inputs) {
            Ok(output) => output,
            Err(failures) => return failures,
        };
        let options = self.all_options();
        let (_, failures) = parallel::map(&inputs, self.write.jobs, |input| {
            let name = self.output_name(input);
            let loaded = input::load(input, self.read)?;
            let origin = Origin { sha256: &loaded.sha256, options: options.clone() };
            if output.is_up_to_date(&name, &origin) {
                return Ok(());
            }
            let result = compute(input, &loaded)?;
            let written = output.write(&name, result.as_ref(), &origin);
            written.map_err(|error| InputError::Write { path: output.path(&name), error })
        });
        match output.close() {
            Ok(()) => failures,
            Err(error) => failures + report_folder_error(folder, error),
        }
    }

    /// Returns the path of the result of an input, relative to the output folder.
    fn output_name(&self, input: &Input) -> PathBuf {
        let mut name = input.stem.clone().into_os_string();
        name.push(".");
        name.push(self.extension);
        name.into()
    }
}

/// Analysis of an input.
struct Analysis<T> {
    input: Input,
    content: T,
    sha256: String,
}

/// Returns a digest of the names and hashes of all inputs.
fn joint_digest(inputs: &[Input], hashes: &[Option<String>]) -> String {
    let lines = inputs.iter().zip(hashes).map(|(input, sha256)| format!("{:?} {sha256:?}\n", input.stem));
    hex_digest(lines.collect::<String>().as_bytes())
}

/// Reports that a result could not be written, if so. Returns the number of failures.
fn report_write_error(path: PathBuf, written: io::Result<()>) -> usize {
    let Err(error) = written else { return 0 };
    output::report(format_args!("{}", InputError::Write { path, error }));
    1
}

/// Reports that the output folder cannot be used. Returns the number of failures.
fn report_folder_error(folder: &Path, error: io::Error) -> usize {
    output::report(format_args!("{}", InputError::OutputFolder { folder: folder.into(), error }));
    1
}

/// Marks the inputs whose results conflict with those of earlier inputs or with the record: they are the same
/// file, or one is a folder of the other.
fn mark_conflicts(inputs: &mut [Input], names: &[PathBuf], ignore_case: bool) {
    let fold = |path: &Path| match ignore_case {
        true => path.to_string_lossy().to_lowercase().into(),
        false => path.to_owned(),
    };
    let record = RESERVED_NAMES.map(|name| (fold(Path::new(name)), "the record of the folder".to_owned()));
    // Owners of files, and of the folders that contain them.
    let mut files: BTreeMap<PathBuf, String> = record.into();
    let mut folders: BTreeMap<PathBuf, String> = BTreeMap::new();
    for (input, name) in inputs.iter_mut().zip(names).filter(|(input, _)| input.problem.is_none()) {
        let path = fold(name);
        let parents = || path.ancestors().skip(1).filter(|parent| !parent.as_os_str().is_empty());
        let owner = folders.get(&path).or_else(|| path.ancestors().find_map(|path| files.get(path)));
        if let Some(owner) = owner {
            let name = decode(name.as_os_str());
            input.problem = Some(format!(
                "its result {name} conflicts with {owner}. Rename the file, or use another output folder"
            ));
            continue;
        }
        let owner = format!("that of {}", display_name(&input.path));
        folders.extend(parents().map(|parent| (parent.to_owned(), owner.clone())));
        files.insert(path, owner);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conflicts_depend_on_case_where_the_folder_does() {
        let conflicts = |ignore_case| -> Vec<bool> {
            let names = ["Walk.json", "walk.json", "WALK.JSON/run.json", "É.json", "é.json"];
            let names = [&names[..], &[".Plantigrade.LOCK", "run.json"]].concat();
            let names: Vec<PathBuf> = names.iter().map(PathBuf::from).collect();
            let input = |path: &PathBuf| Input { path: path.clone(), stem: path.clone(), problem: None };
            let mut inputs: Vec<Input> = names.iter().map(input).collect();
            mark_conflicts(&mut inputs, &names, ignore_case);
            inputs.iter().map(|input| input.problem.is_some()).collect()
        };
        assert_eq!(conflicts(false), [false; 7]);
        assert_eq!(conflicts(true), [false, true, true, false, true, true, false]);
    }
}
