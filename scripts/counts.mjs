/** Counts tests in the output of cargo, Vitest, Playwright and Node's test runner. */

/** @typedef {{ passed: number, failed: number, skipped: number }} Counts */

const kinds = {
  passed: { cargo: "passed", vitest: "passed", playwright: "passed|flaky", node: "pass" },
  failed: { cargo: "failed", vitest: "failed", playwright: "failed|did not run", node: "fail" },
  skipped: { cargo: "ignored", vitest: "skipped|todo", playwright: "skipped", node: "skipped" },
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
  const count = ({ cargo, vitest, playwright, node }) =>
    sum(new RegExp(`^test result: .*?(\\d+) ${cargo};`, "gm")) +
    sum(new RegExp(`^\\s*Tests\\s.*?(\\d+) (?:${vitest})\\b`, "gm")) +
    sum(new RegExp(`^  (\\d+) (?:${playwright})(?: \\(.*\\))?$`, "gm")) +
    sum(new RegExp(`^\\W*${node} (\\d+)$`, "gm"));
  return {
    passed: count(kinds.passed),
    failed: count(kinds.failed),
    skipped: count(kinds.skipped),
  };
}
