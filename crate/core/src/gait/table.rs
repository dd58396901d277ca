//! Gait measures as columns of a table.

use crate::gait::{Gait, PerSide, Spread, Step, Stride};

impl Gait {
    /// Returns the measures as columns whose names state the unit: the mean and, with suffix `_sd`
    /// and `_count`, deviation and number of values.
    pub fn columns(&self) -> Vec<(String, Option<f64>)> {
        let mut columns = vec![
            ("strides".into(), Some(self.strides as f64)),
            ("cadence_steps_per_min".into(), self.cadence_steps_per_min),
            ("speed_m_per_s".into(), self.speed_m_per_s),
        ];
        let mut spread = |name: String, spread: Option<Spread>| {
            columns.push((name.clone(), spread.map(|spread| spread.mean)));
            columns.push((format!("{name}_sd"), spread.and_then(|spread| spread.sd)));
            columns.push((format!("{name}_count"), Some(spread.map_or(0.0, |spread| spread.count as f64))));
        };
        for (name, measure) in self.by_side() {
            spread(format!("left_{name}"), measure.left);
            spread(format!("right_{name}"), measure.right);
        }
        for (name, measure) in [
            ("double_support_s", self.double_support_s),
            ("double_support_share", self.double_support_share),
            ("flight_s", self.flight_s),
            ("flight_share", self.flight_share),
        ] {
            spread(name.into(), measure);
        }
        let symmetry = self.symmetry;
        columns.extend([
            ("stance_symmetry_percent".into(), symmetry.stance_percent),
            ("swing_symmetry_percent".into(), symmetry.swing_percent),
            ("step_time_symmetry_percent".into(), symmetry.step_time_percent),
            ("step_length_symmetry_percent".into(), symmetry.step_length_percent),
        ]);
        columns
    }

    /// Returns the measures that exist for each foot, by name.
    pub fn by_side(&self) -> [(&'static str, PerSide); 7] {
        [
            ("stance_s", self.stance_s),
            ("swing_s", self.swing_s),
            ("stride_time_s", self.stride_time_s),
            ("stride_length_m", self.stride_length_m),
            ("step_time_s", self.step_time_s),
            ("step_length_m", self.step_length_m),
            ("step_width_m", self.step_width_m),
        ]
    }

    /// Returns the parts of the gait cycle for each foot, in percent, by name.
    pub fn percent_by_side(&self) -> [(&'static str, PerSide); 4] {
        [
            ("stance_percent", self.stance_percent),
            ("swing_percent", self.swing_percent),
            ("single_support_percent", self.single_support_percent),
            ("double_support_percent", self.double_support_percent),
        ]
    }
}

impl Step {
    /// Names of the [`Step::columns`], with their units.
    pub const COLUMNS: [&'static str; 17] = [
        "foot",
        "strike_frame",
        "strike_s",
        "off_frame",
        "off_s",
        "step_time_s",
        "step_length_m",
        "step_width_m",
        "stride_time_s",
        "stride_length_m",
        "stance_s",
        "swing_s",
        "stance_percent",
        "swing_percent",
        "single_support_percent",
        "double_support_percent",
        "left_out",
    ];

    /// Returns the step as the fields of a table, in the order of [`Step::COLUMNS`]; unknown values are
    /// empty. Numbers are rounded to six decimals.
    pub fn columns(&self) -> [String; 17] {
        let number = |value: Option<f64>| value.map_or_else(String::new, |value| rounded(value).to_string());
        let stride = |value: fn(&Stride) -> f64| number(self.stride.as_ref().map(value));
        [
            self.side.name().into(),
            self.strike_frame.to_string(),
            number(Some(self.strike_s)),
            self.off_frame.map_or_else(String::new, |frame| frame.to_string()),
            number(self.off_s),
            number(self.step_time_s),
            number(self.step_length_m),
            number(self.step_width_m),
            stride(|stride| stride.time_s),
            stride(|stride| stride.length_m),
            stride(|stride| stride.stance_s),
            stride(|stride| stride.swing_s),
            stride(|stride| stride.stance_percent),
            stride(|stride| stride.swing_percent),
            stride(|stride| stride.single_support_percent),
            stride(|stride| stride.double_support_percent),
            self.left_out.map_or_else(String::new, |omission| omission.description().into()),
        ]
    }
}

/// Rounds to six decimals, which is beyond the accuracy of any clip.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}
