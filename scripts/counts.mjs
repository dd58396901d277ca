/** Counts tests in the output of cargo, Vitest, Playwright, Node's test runner and pytest. */

/** @typedef {{ passed: number, failed: number, skipped: number }} Counts */

const kinds = {
  passed: {
    cargo: "passed",
    vitest: "passed",
    playwright: "passed|flaky",
    node: "pass",
    pytest: "passed",
  },
  failed: {
    cargo: "failed",
    vitest: "failed",
    playwright: "failed|did not run",
    node: "fail",
    pytest: "failed|errors?",
  },
  skipped: {
    cargo: "ignored",
    vitest: "skipped|todo",
    playwright: "skipped",
    node: "skipped",
    pytest: "skipped",
  },
};

/**
 * @param {string} output
 * @returns {Counts}
 */
export function countTests(output) {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: colours are control characters
  const plain = output.replace(/\u001b\[[0-9;]*m/g, "");
  const sum = (pattern) =>
    [...plain.matchAll(pattern)].reduce((total, match) => total + Number(match[1]), 0);
  const count = ({ cargo, vitest, playwright, node, pytest }) =>
    sum(new RegExp(`^test result: .*?(\\d+) ${cargo};`, "gm")) +
    sum(new RegExp(`^\\s*Tests\\s.*?(\\d+) (?:${vitest})\\b`, "gm")) +
    sum(new RegExp(`^  (\\d+) (?:${playwright})(?: \\(.*\\))?$`, "gm")) +
    sum(new RegExp(`^\\W*${node} (\\d+)$`, "gm")) +
    sum(
      new RegExp(`^(?:=+ )?(?:\\d+ \\w+, )*(\\d+) (?:${pytest})\\b(?:, \\d+ \\w+)* in \\d`, "gm"),
    );
  return {
    passed: count(kinds.passed),
    failed: count(kinds.failed),
    skipped: count(kinds.skipped),
  };
}
