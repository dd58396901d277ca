import { expect, it } from "vitest";
import { latest } from "./latest";

it("runs one at a time and drops all but the newest", async () => {
  const ran: number[] = [];
  let release = () => {};
  const go = latest<number>((value) => {
    ran.push(value);
    return new Promise((done) => {
      release = done;
    });
  });
  go(1);
  go(2);
  go(3);
  expect(ran).toEqual([1]);
  release();
  await new Promise((done) => setTimeout(done));
  expect(ran).toEqual([1, 3]);
});
