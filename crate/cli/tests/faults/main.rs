//! Tests of faults of the environment: killed processes, unusual files and folders, closed streams, hostile
//! names.

// They need signals, links and permissions of Unix.
#![cfg(unix)]

mod file_system;
mod interruption;
mod names;
mod streams;
mod support;
