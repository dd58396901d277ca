import { expect, test } from "vitest";
import { detectFileKind } from "./file-kind";

const bytes = (...values: number[]) => Uint8Array.from(values);

test.each([
  ["walk.bvh", "HIERARCHY\nROOT Hips", "clip"],
  ["walk.txt", "\ufeff  hierarchy\r\n", "clip"],
  ["walk.json", "HIERARCHY\n", "clip"],
  ["labels.txt", '{"format": "plantigrade-labels"}', "labels"],
  ["labels", '\n [{"a": 1}]', "labels"],
  ["frames.txt", "frame,time,left_contact,left_heel\n0,0,1,1", "labels"],
  ["cuts.txt", "start_frame,end_frame,label\n", "labels"],
  ["walk.elan.txt", "Tier\tBegin Time - ss.msec\tEnd Time - ss.msec\tAnnotation\n", "labels"],
  ["walk.audacity.txt", "0.000000\t1.250000\twalk\n", "labels"],
  ["odd.csv", "a,b\n1,2", "labels"],
  ["page.bvh", "<!doctype html>", "clip"],
  ["empty.bvh", "", "clip"],
  ["zip.bvh", bytes(0x50, 0x4b, 3, 4, 0, 0), "archive"],
  ["labels.npz", bytes(0x50, 0x4b, 3, 4, 0, 0), "labels"],
  ["walk.mp4", "\0\0\0\x20ftypisom", "video"],
  ["walk.mov", "\0\0\0\x08wide\0\0", "video"],
  ["walk.webm", bytes(0x1a, 0x45, 0xdf, 0xa3, 1), "video"],
  ["walk.avi", "RIFF\x10\0\0\0AVI LIST", "video"],
  [
    "wide.bvh",
    bytes(0xff, 0xfe, 72, 0, 73, 0, 69, 0, 82, 0, 65, 0, 82, 0, 67, 0, 72, 0, 89, 0, 10, 0),
    "clip",
  ],
])("%s starting with %j has the kind %s", async (name, content, kind) => {
  expect(await detectFileKind(new File([content as BlobPart], name))).toBe(kind);
});
