import { expect, it } from "vitest";
import { downloadUrl, fileNameOfUrl, formatHash, parseHash } from "./link";

const sample = (name: string, view = "") => ({ origin: { kind: "sample", name }, view });
const url = (url: string, view = "") => ({ origin: { kind: "url", url }, view });

it("parses the name of a sample", () => {
  expect(parseHash("#sample=walk")).toEqual(sample("walk"));
});

it("parses a URL with a query, encoded or not", () => {
  const fileUrl = "https://example.org/a b.bvh?x=1&y=2";
  expect(parseHash(`#url=${fileUrl}`)).toEqual(url(fileUrl));
  expect(parseHash(`#url=${encodeURIComponent(fileUrl)}`)).toEqual(url(fileUrl));
});

it("separates the view state", () => {
  expect(parseHash("#sample=walk&t=1.25&method=paper")).toEqual(
    sample("walk", "t=1.25&method=paper"),
  );
  expect(parseHash("#t=2&sample=walk&r=0.002")).toEqual(sample("walk", "t=2&r=0.002"));
  expect(parseHash("#t=2&url=https://example.org/a.bvh?t=3&r=4")).toEqual(
    url("https://example.org/a.bvh?t=3&r=4", "t=2"),
  );
});

it("returns undefined for other hashes", () => {
  for (const hash of ["", "#elsewhere", "#t=2", "#sample=", "#curl=https://a.b"]) {
    expect(parseHash(hash)).toBeUndefined();
  }
});

it("parses what it formats", () => {
  const addresses = [
    "https://example.org/a.bvh",
    "https://example.org/a%20b.bvh?x=1&y=%2F#part",
    "https://example.org/löwe und bär.bvh?url=https://example.org",
    "http://127.0.0.1:8080/clips/100%.bvh",
  ];
  for (const view of ["", "t=1.25&method=paper", "eye=1,2,3&at=0,0.9,0"]) {
    for (const address of addresses) {
      const link = url(address, view);
      expect(parseHash(formatHash(link as never))).toEqual(link);
    }
    for (const name of ["walk", "a&b=c", "ü #1"]) {
      const link = sample(name, view);
      expect(parseHash(formatHash(link as never))).toEqual(link);
    }
  }
  expect(formatHash(url("https://example.org/a.bvh?x=1&y=2", "t=2") as never)).toBe(
    "#t=2&url=https://example.org/a.bvh?x=1&y=2",
  );
});

it("returns the file name of a URL", () => {
  expect(fileNameOfUrl("https://example.org/clips/walk%201.bvh?raw=1")).toBe("walk 1.bvh");
  expect(fileNameOfUrl("https://example.org/")).toBe("example.org");
});

it("accepts https and relative addresses of clips only", () => {
  const page = "https://example.com/app/";
  expect(downloadUrl("https://example.org/a.bvh", page).href).toBe("https://example.org/a.bvh");
  expect(downloadUrl("clips/a.bvh", page).href).toBe("https://example.com/app/clips/a.bvh");
  const rejected: readonly (readonly [string, RegExp])[] = [
    ["javascript:alert(1)", /javascript:/],
    ["java\tscript:alert(1)", /javascript:/],
    ["data:text/plain,HIERARCHY", /data:/],
    ["blob:https://example.com/1", /blob:/],
    ["file:///etc/passwd", /file:/],
    ["about:blank", /about:/],
    ["http://example.org/a.bvh", /starts with “http:”/],
    ["https://", /not valid/],
    ["https:", /not valid/],
    ["http://[", /not valid/],
    ["https://user:secret@example.org/a.bvh", /user name/],
    ["", /no address/],
  ];
  // The page may be served by a computer in the same network.
  const local = "http://localhost:8000/app/";
  expect(downloadUrl("clips/a.bvh", local).href).toBe("http://localhost:8000/app/clips/a.bvh");
  expect(() => downloadUrl("http://example.org/a.bvh", local)).toThrow();
  for (const [address, message] of rejected) {
    expect(() => downloadUrl(address, page), address).toThrow(
      expect.objectContaining({ message: expect.stringMatching(message) }),
    );
  }
});
