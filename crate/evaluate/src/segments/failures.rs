//! Missed cuts, and the causes of errors.

use std::collections::BTreeMap;

use plantigrade::score::{self, Tolerance};
use plantigrade::segments::Method;

use super::generated::{Generated, Transition};
use super::two_decimals;
use crate::report::Report;

/// Number of actions in the list of false cuts.
const LISTED_ACTIONS: usize = 4;

/// Adds the section.
pub fn write(report: &mut Report, generated: &Generated) {
    report.text("### Causes of errors");
    report.text("Recall of true cuts of the generated clips within 1 s, by transition:");
    let defaults: Vec<_> = generated.cuts.iter().take(Method::ALL.len()).collect();
    let rows: Vec<Vec<String>> = Transition::ALL
        .into_iter()
        .map(|transition| {
            let by_method = defaults.iter().map(|(_, cuts)| {
                let (matched, total) = recall(generated, cuts, transition);
                two_decimals(matched as f64 / total as f64)
            });
            [vec![transition.title().to_owned()], by_method.collect()].concat()
        })
        .collect();
    let head: Vec<&str> =
        std::iter::once("transition").chain(defaults.iter().map(|(variant, _)| variant.name)).collect();
    report.table(&head, &rows);
    report.text(&CAUSES.replace("{cuts_inside_actions}", &cuts_inside_actions(generated)));
}

/// Returns the number of true cuts of one transition that are detected within 1 s, and their total.
fn recall(generated: &Generated, cuts: &[Vec<usize>], transition: Transition) -> (usize, usize) {
    let (mut matched, mut total) = (0, 0);
    for ((clip, case), cuts) in generated.clips.iter().zip(&generated.cases).zip(cuts) {
        for (pair, cut) in clip.actions.windows(2).zip(&case.truth) {
            if Transition::between(pair, cut, case.clip.frame_time()) == transition {
                matched +=
                    score::cuts(cuts, &[*cut], case.clip.frame_time(), Tolerance::Seconds(1.0)).correct;
                total += 1;
            }
        }
    }
    (matched, total)
}

/// Describes the cuts of the default method inside actions: more than 1 s from the middle of each
/// true cut and outside its range.
fn cuts_inside_actions(generated: &Generated) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for ((clip, case), cuts) in generated.clips.iter().zip(&generated.cases).zip(&generated.cuts[0].1) {
        let margin = 1.0 / case.clip.frame_time();
        for &cut in cuts {
            let cut = cut as f64;
            let is_far = case.truth.iter().all(|truth| (cut - truth.middle()).abs() > margin);
            let is_outside = case.truth.iter().all(|truth| !(truth.earliest..=truth.latest).contains(&cut));
            if is_far && is_outside {
                let action = case.truth.iter().filter(|truth| truth.middle() < cut).count();
                *counts.entry(clip.actions[action].name()).or_default() += 1;
            }
        }
    }
    let total: usize = counts.values().sum();
    let mut sorted: Vec<_> = counts.into_iter().collect();
    sorted.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    let listed: Vec<String> =
        sorted.iter().take(LISTED_ACTIONS).map(|(name, count)| format!("{name} {count}")).collect();
    format!("{total} cuts inside actions, most of them in {}", listed.join(", "))
}

const CAUSES: &str = "\
- *Pauses.* A person who walks and then jumps stands still in between. Most methods detect the change of poses at the
  beginning or the end of the pause. The true cut is its middle, so many cuts are slightly more than 1 s off but at the
  edge of the range; the last column of the first table counts them as correct. `auto` and `lsd` search for the most
  likely instant within the transition. `lsd` also has more cuts inside actions.
- *Actions of several parts.* `auto` models actions as pose distributions, and an action may have several. It has
  {cuts_inside_actions}.
  Stretching, for example, consists of leaning with raised arms and twisting with spread arms; all methods treat these
  as two actions.
- *Walking and jogging* have similar body poses. The motifs of `lsd` continue across the transition, so it joins both.
- *Short actions.* A turn of 2 s is little longer than the shortest segment of `auto` (1.2 s), and it consists of
  steps, so it is merged with the adjacent walk. Methods whose first window is 2 s rarely detect it.
- *Sequential methods.* `mvu`, `pca`, `pca-tail` and `ppca` restart at each cut, so each cut depends on all previous
  ones, and a marginal cut shifts all that follow. `auto` optimises all cuts jointly. `lsd` also considers the whole
  clip, but a motif near a threshold or a class boundary can change which motifs repeat, and with them the cuts.
- *Truth.* Annotators do not agree to within half a second. F1 at ±0.5 s and inside the range depends on conventions as
  much as on methods.
";
