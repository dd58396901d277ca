//! Calibration of the uncertainty of edges.

use plantigrade::foot::Side;
use plantigrade::plants::Detection;

use super::timing::{Event, Kind, MAX_DISTANCE, TrueEvents};
use crate::report::{Report, percent};

/// Error of a detected edge with its stated uncertainty, both in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeError {
    kind: Kind,
    error: f64,
    uncertainty: f64,
}

/// Returns the errors of the edges of contact that belong to a true event within 150 ms.
pub fn edge_errors(detection: &Detection, truth: &TrueEvents) -> Vec<EdgeError> {
    let mut errors = Vec::new();
    for side in Side::BOTH {
        let labels = detection.principal().foot(side);
        for edge in &labels.edges {
            let kind = if labels.planted[edge.frame] { Kind::Strike } else { Kind::Off };
            let error = |event: &Event| edge.time - event.time;
            let matching = truth.events.iter().filter(|event| event.side == side && event.kind == kind);
            let nearest = matching.map(error).min_by(|a, b| a.abs().total_cmp(&b.abs()));
            errors.extend(nearest.filter(|error| error.abs() <= MAX_DISTANCE).map(|error| EdgeError {
                kind,
                error,
                uncertainty: edge.uncertainty,
            }));
        }
    }
    errors
}

/// Adds a table of the calibration.
pub fn write(report: &mut Report, errors: &[EdgeError]) {
    report.text(
        "Uncertainty of the edges of *Robust spectral*: the stated standard deviations, and the fraction of \
         errors within one and two of them (68 and 95 % if errors are normal). The *ratio* is the 68th \
         percentile of error divided by stated standard deviation: below 1 the edges are more exact than \
         stated.",
    );
    let rows: Vec<Vec<String>> = Kind::BOTH
        .into_iter()
        .map(|kind| {
            let of_kind: Vec<EdgeError> = errors.iter().copied().filter(|error| error.kind == kind).collect();
            row(kind, &of_kind)
        })
        .collect();
    report
        .table(&["edge", "edges", "stated in ms: median", "within 1 in %", "within 2 in %", "ratio"], &rows);
}

fn row(kind: Kind, errors: &[EdgeError]) -> Vec<String> {
    let deviations = sorted(errors.iter().map(|edge| edge.error.abs() / edge.uncertainty));
    let stated = sorted(errors.iter().map(|edge| 1e3 * edge.uncertainty));
    let within = |limit: f64| {
        percent(
            100.0 * deviations.partition_point(|deviation| *deviation <= limit) as f64
                / deviations.len() as f64,
        )
    };
    vec![
        kind.name().to_owned(),
        errors.len().to_string(),
        format!("{:.1}", quantile(&stated, 0.5)),
        within(1.0),
        within(2.0),
        format!("{:.2}", quantile(&deviations, 0.6827)),
    ]
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Returns the nearest value to a quantile; NaN if there are no values.
fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    let index = (fraction * (sorted.len().max(1) - 1) as f64).round() as usize;
    sorted.get(index).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_compare_errors_with_stated_deviations() {
        let edge = |error: f64| EdgeError { kind: Kind::Strike, error, uncertainty: 0.01 };
        let errors = [0.0, 0.004, -0.005, 0.008, -0.03].map(edge);
        assert_eq!(row(Kind::Strike, &errors), ["foot strike", "5", "10.0", "80.00", "80.00", "0.80"]);
    }
}
