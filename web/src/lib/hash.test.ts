import { expect, it } from "vitest";
import { nameOfUrl, parseHash } from "./hash";

it("reads a sample's name", () => {
  expect(parseHash("#sample=walk")).toEqual({ kind: "sample", name: "walk" });
});

it("reads an address, encoded or not, with its own query", () => {
  const url = "https://example.org/a b.bvh?x=1&y=2";
  expect(parseHash(`#url=${url}`)).toEqual({ kind: "url", url });
  expect(parseHash(`#url=${encodeURIComponent(url)}`)).toEqual({ kind: "url", url });
});

it("asks for nothing otherwise", () => {
  expect(parseHash("")).toBeUndefined();
  expect(parseHash("#url=")).toBeUndefined();
  expect(parseHash("#elsewhere")).toBeUndefined();
});

it("names the file of an address", () => {
  expect(nameOfUrl("https://example.org/clips/walk%201.bvh?raw=1")).toBe("walk 1.bvh");
  expect(nameOfUrl("https://example.org/")).toBe("example.org");
});
