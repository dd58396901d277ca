//! Where cutting into actions fails, and why.

use std::collections::BTreeMap;

use plantigrade::score::{self, Tolerance};
use plantigrade::segments::Method;

use super::generated::{Change, Generated};
use super::share;
use crate::report::Report;

/// Adds the section.
pub fn write(report: &mut Report, generated: &Generated) {
    report.text("### Where it fails, and why");
    report.text("Share of true cuts of the generated clips that have a found one within 1 s, by what goes over into what:");
    let own: Vec<_> = generated.found.iter().take(Method::ALL.len()).collect();
    let rows: Vec<Vec<String>> = Change::ALL
        .into_iter()
        .map(|change| {
            let of_ways = own.iter().map(|(_, found)| {
                let (met, all) = recall(generated, found, change);
                share(met as f64 / all as f64)
            });
            [vec![change.title().to_owned()], of_ways.collect()].concat()
        })
        .collect();
    let head: Vec<&str> = std::iter::once("change").chain(own.iter().map(|(way, _)| way.name)).collect();
    report.table(&head, &rows);
    report.text(&LIMITS.replace("{inner}", &inner(generated)));
}

/// True cuts of one kind that have a found one within a second, and all of them.
fn recall(generated: &Generated, found: &[Vec<usize>], change: Change) -> (usize, usize) {
    let (mut met, mut all) = (0, 0);
    for ((chain, case), found) in generated.chains.iter().zip(&generated.cases).zip(found) {
        for (pair, cut) in chain.actions.windows(2).zip(&case.truth) {
            if Change::of(pair, cut, case.clip.frame_time()) == change {
                met += score::cuts(found, &[*cut], case.clip.frame_time(), Tolerance::Seconds(1.0)).right;
                all += 1;
            }
        }
    }
    (met, all)
}

/// In which actions the default has cuts, a second and more from their ends and beyond the
/// ranges of the true cuts.
fn inner(generated: &Generated) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for ((chain, case), found) in generated.chains.iter().zip(&generated.cases).zip(&generated.found[0].1) {
        for &cut in found {
            let at = cut as f64;
            let is_apart = |margin: f64| {
                let far = margin / case.clip.frame_time();
                case.truth.iter().all(|truth| (at - truth.middle()).abs() > far)
            };
            let is_outside = case.truth.iter().all(|truth| !(truth.earliest..=truth.latest).contains(&at));
            if is_apart(1.0) && is_outside {
                let place = case.truth.iter().filter(|truth| truth.middle() < at).count();
                *counts.entry(chain.actions[place].name()).or_default() += 1;
            }
        }
    }
    let total: usize = counts.values().sum();
    let mut most: Vec<_> = counts.into_iter().collect();
    most.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    let listed: Vec<String> = most.iter().take(4).map(|(name, count)| format!("{name} {count}")).collect();
    format!("{total} cuts inside actions, most of them in these: {}", listed.join(", "))
}

const LIMITS: &str = "\
- *Moments of rest.* Someone who walks and then jumps stands between the two. Most methods see where poses change:
  at the end of that rest or at its beginning, seldom in its middle, from which the true cut is counted. So many
  cuts are a little more than a second off and still at the edge of the range: the last column of the first table
  counts them. `lsd` looks for the likest turn-over in the rest itself, and is ahead of `auto` if its middle counts;
  if the whole range does, `auto` is far ahead, for `lsd` also has more cuts where nothing ends.
- *Actions of several parts.* `auto` knows distributions of poses, and an action may have several. Here it has
  {inner}.
  A stretch leans with raised arms and then twists with spread ones, which is two actions to any method here.
- *Walking and jogging* look alike in the shape of the body: the curve of `lsd` goes on with the same motifs, and it
  joins the two.
- *Short actions.* A turn of 2 s is hardly longer than the least that `auto` tells apart (1.2 s), and is made of steps:
  it is taken for a part of the walk beside it. Methods whose first window is of 2 s hardly ever have it.
- *Chains.* `mvu`, `pca`, `pca-tail` and `ppca` start anew at each cut, so that every cut depends on all before it.
  One that is found or missed by a hair moves what follows. At ten and twelve poses a second, of which some lie between
  the frames of slower clips, leaving out frames moved up to a quarter of the cuts; now most take six, which lie on
  frames at 24, 30, 60 and 120 Hz. `auto` weighs all cuts at once. So does `lsd`, but a motif that just reaches the
  threshold, or falls just into another class, changes what repeats, and with it the cuts. Before its curve was
  blurred, noise of slower clips was enough for that: of eight cuts one was another at 24 Hz.
- *Truth.* People do not agree on cuts to the half second: F1 at ±0.5 s and inside are about conventions as much as
  about methods.
";
