import assert from "node:assert/strict";
import { test } from "node:test";
import { countTests } from "../../scripts/counts.mjs";

test("counts tests of cargo over all crates", () => {
  const output = `
test result: ok. 12 passed; 0 failed; 3 ignored; 0 measured; 0 filtered out; finished in 0.1s
test result: FAILED. 4 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1s
`;
  assert.deepEqual(countTests(output), { passed: 16, failed: 2, skipped: 3 });
});

test("counts tests of Vitest", () => {
  const output =
    " Test Files  1 failed | 39 passed (40)\n      Tests  1 failed | 230 passed | 2 skipped (233)\n";
  assert.deepEqual(countTests(output), { passed: 230, failed: 1, skipped: 2 });
  assert.equal(
    countTests("\u001b[2m      Tests \u001b[22m \u001b[1m232 passed\u001b[0m (232)\n").passed,
    232,
  );
});

test("counts tests of Playwright", () => {
  const output =
    "  1 failed\n    [chromium] › a.spec.ts:1:1 › b\n  1 flaky\n  6 skipped\n  2 did not run\n  190 passed (4.2m)\n";
  assert.deepEqual(countTests(output), { passed: 191, failed: 3, skipped: 6 });
});

test("counts tests of Node's test runner", () => {
  const output = "ℹ tests 5\nℹ pass 3\nℹ fail 1\nℹ cancelled 0\nℹ skipped 1\nℹ todo 0\n";
  assert.deepEqual(countTests(output), { passed: 3, failed: 1, skipped: 1 });
});

test("counts tests of pytest", () => {
  const output = `
=========== 1 failed, 12 passed, 3 skipped, 2 warnings in 3.88s ===========
10 passed, 1 error in 61.02s (0:01:01)
1 skipped in 0s
`;
  assert.deepEqual(countTests(output), { passed: 22, failed: 2, skipped: 4 });
});

test("counts nothing in other output", () => {
  assert.deepEqual(countTests("Checked 300 files. No fixes applied.\n"), {
    passed: 0,
    failed: 0,
    skipped: 0,
  });
});
