//! Sections about foot plants.

pub mod confidence;
pub mod corrections;
mod edge_uncertainty;
pub mod force_plates;
pub mod frame_rates;
pub mod gaitkit;
pub mod hard_cases;
pub mod methods;
pub mod paper;
pub mod paper_figures_3_to_5;
pub mod paper_table_3;
pub mod threshold_search;
pub mod timing;
pub mod timing_tables;
pub mod trial;
pub mod video_noise;
