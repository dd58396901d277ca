import { expect, test } from "vitest";
import { DownloadError, failureOf, isFatal, messageOf, WorkerError } from "./failure";

const named = (name: string, message: string) => Object.assign(new Error(message), { name });

test("takes failures of the core over, which are no errors", () => {
  const failure = { message: "the side must be left or right", hint: "Change it.", line: 3 };
  expect(failureOf(failure)).toEqual(failure);
});

test("offers to try again after errors that end a worker", () => {
  for (const error of [
    new WorkerError("the worker was ended"),
    named("RuntimeError", "unreachable"),
    named("RangeError", "Array buffer allocation failed"),
  ]) {
    expect(isFatal(error)).toBe(true);
    expect(failureOf(error)).toMatchObject({
      message: `the program failed (${error.message})`,
      canRetry: true,
    });
  }
  expect(isFatal(new Error("No clip is open."))).toBe(false);
  expect(failureOf(new Error("No clip is open."))).toEqual({ message: "No clip is open." });
});

test("offers to try again after a failed download, for which no worker is replaced", () => {
  const error = new DownloadError("a part of the program could not be loaded");
  expect(isFatal(error)).toBe(false);
  expect(failureOf(error)).toMatchObject({ message: error.message, canRetry: true });
});

test("never shows the default text of an object", () => {
  for (const value of [{}, { message: {} }, [], null, undefined, 0, "", new Error(""), () => {}]) {
    expect(messageOf(value)).toMatch(/^(unknown error|Error)$/);
  }
  expect(messageOf("text")).toBe("text");
});
