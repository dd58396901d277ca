//! Formats of gait: the printable report, and tables of steps and of joint angles.

mod export;
mod report;
mod tables;

pub use export::{GaitExport, SkeletonGait};

use crate::formats::format_info::FormatInfo;
use crate::registry::registry;
use export::{Reader, Writer};

registry! {
    /// File format of gait.
    pub enum GaitFormat: FormatInfo<Writer, Reader> as "format" {
        /// Printable page.
        #[default]
        Report => report::FORMAT_INFO,
        /// Table with one row per step.
        Steps => tables::STEPS,
        /// Table with one row per percent of the gait cycle.
        Angles => tables::ANGLES,
    }
    with {
        /// Returns the file extension, without the leading dot.
        extension: &'static str,
        /// Returns the media (MIME) type.
        media_type: &'static str,
    }
}

impl GaitFormat {
    /// Returns gait as the text of a file.
    pub fn write(self, export: &GaitExport) -> String {
        (self.entry().write)(export)
    }
}

#[cfg(test)]
mod tests;
