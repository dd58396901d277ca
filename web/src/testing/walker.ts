import { uncertainRanges } from "../model/plants";
import type { Clip, Joint, Track } from "../model/types";
import { summarizeCurve } from "../util/min-max-pyramid";

/** A made-up walk along +z with exact plants, for tests: no measured data, no claims. */
const rate = 60;
const period = 1.1;
const stance = 0.62;
const pace = 1.25;

type Point = readonly [x: number, y: number, z: number];

const shape: readonly (readonly [name: string, parent: number, kind?: Joint["kind"]])[] = [
  ["Hips", -1, "root"],
  ["Spine", 0],
  ["Chest", 1],
  ["Neck", 2],
  ["Head", 3],
  ["", 4, "end-site"],
  ["LeftArm", 2],
  ["LeftForeArm", 6],
  ["LeftHand", 7],
  ["", 8, "end-site"],
  ["RightArm", 2],
  ["RightForeArm", 10],
  ["RightHand", 11],
  ["", 12, "end-site"],
  ["LeftUpLeg", 0],
  ["LeftLeg", 14],
  ["LeftFoot", 15],
  ["LeftToeBase", 16],
  ["", 17, "end-site"],
  ["RightUpLeg", 0],
  ["RightLeg", 19],
  ["RightFoot", 20],
  ["RightToeBase", 21],
  ["", 22, "end-site"],
];

export const walkerRoles = {
  hips: 0,
  spine: 1,
  neck: 3,
  head: 4,
  left_thigh: 14,
  left_shank: 15,
  left_ankle: 16,
  left_toe: 17,
  left_tip: 18,
  right_thigh: 19,
  right_shank: 20,
  right_ankle: 21,
  right_toe: 22,
  right_tip: 23,
};

const ease = (t: number) => t * t * (3 - 2 * t);

/** Where a foot is and how it pitches at a time; `half` is the phase of the foot. */
function footAt(t: number, half: number) {
  const cycle = t / period + half;
  const step = Math.floor(cycle);
  const phase = cycle - step;
  const place = (n: number) => (n + stance / 2 - half) * period * pace;
  if (phase < stance) {
    const late = Math.max(0, (phase / stance - 0.72) / 0.28);
    const early = Math.max(0, 1 - phase / stance / 0.14);
    return { z: place(step), lift: 0, pitch: -0.95 * late * late + 0.35 * early };
  }
  const s = (phase - stance) / (1 - stance);
  const z = place(step) + (place(step + 1) - place(step)) * ease(s);
  return { z, lift: 0.09 * Math.sin(Math.PI * s), pitch: -0.95 * (1 - s) ** 2 + 0.35 * s * s };
}

function knee(hip: Point, ankle: Point): Point {
  const dy = ankle[1] - hip[1];
  const dz = ankle[2] - hip[2];
  const length = Math.min(Math.hypot(dy, dz), 0.859);
  const bend = Math.sqrt(Math.max(0, 0.43 ** 2 - (length / 2) ** 2));
  return [
    (hip[0] + ankle[0]) / 2,
    (hip[1] + ankle[1]) / 2 + (dz / length) * bend * 0.2,
    (hip[2] + ankle[2]) / 2 - (dy / length) * bend,
  ];
}

function pose(t: number): Point[] {
  const z = t * pace;
  const bob = 0.018 * Math.cos((4 * Math.PI * t) / period);
  const swing = Math.sin((2 * Math.PI * t) / period + 0.5);
  const hips: Point = [0, 0.9 + bob, z];
  const at = (x: number, y: number, dz: number): Point => [x, y + bob, z + dz];
  const points: Point[] = [
    hips,
    at(0, 1.03, 0.01),
    at(0, 1.28, 0.02),
    at(0, 1.48, 0.02),
    at(0, 1.57, 0.05),
    at(0, 1.76, 0.05),
  ];
  for (const side of [1, -1]) {
    const s = -side * swing;
    points.push(
      at(0.19 * side, 1.42, 0.02 + 0.02 * s),
      at(0.25 * side, 1.15, 0.02 + 0.14 * s),
      at(0.24 * side, 0.93, 0.1 + 0.28 * s),
      at(0.235 * side, 0.85, 0.13 + 0.34 * s),
    );
  }
  for (const side of [1, -1]) {
    const foot = footAt(t, side > 0 ? 0 : 0.5);
    const x = 0.09 * side;
    const toeZ = foot.z + 0.08;
    const toeY = 0.02 + foot.lift + Math.max(0, foot.pitch) * 0.14;
    const ankle: Point = [
      x,
      toeY + 0.145 * Math.sin(0.5 - foot.pitch),
      toeZ - 0.145 * Math.cos(0.5 - foot.pitch),
    ];
    const hip: Point = [x, hips[1] - 0.03, z];
    const tipPitch = Math.max(foot.pitch, foot.lift * -4);
    points.push(
      hip,
      knee(hip, ankle),
      ankle,
      [x * 1.1, toeY, toeZ],
      [x * 1.15, Math.max(0.01, toeY + 0.07 * Math.sin(tipPitch)), toeZ + 0.07],
    );
  }
  return points;
}

export function walker(name: string, seconds = 12): Clip {
  const frames = Math.round(seconds * rate);
  const joints = shape.map(([name, parent, kind]): Joint => {
    const joint: Joint = { name, kind: kind ?? "joint" };
    return parent < 0 ? joint : { ...joint, parent };
  });
  const positions = new Float32Array(Math.max(frames, 1) * joints.length * 3);
  for (let f = 0; f < Math.max(frames, 1); f++) {
    positions.set(pose(f / rate).flat(), f * joints.length * 3);
  }
  return {
    name,
    frames,
    rate,
    joints,
    up: "y",
    metresPerUnit: 0.01,
    unit: "cm",
    leg: 0.86,
    roles: { ...walkerRoles },
    roleNames: Object.keys(walkerRoles),
    notices: [
      {
        code: "missing-end-brace",
        line: 74,
        text: "A closing brace was missing at the end; it was supplied.",
      },
      {
        code: "frame-time-rounded",
        line: 77,
        column: 13,
        text: "Frame time 0.016667 is taken as 60 Hz.",
      },
    ],
    positions,
  };
}

/** A track planted between two phases of the cycle; `grow` widens every plant by frames. */
export function walkerTrack(
  clip: Clip,
  half: number,
  from: number,
  to: number,
  grow: number,
  joint: number,
) {
  const n = clip.frames;
  const track: Track = {
    planted: new Uint8Array(n),
    confidence: new Float32Array(n),
    intervals: new Uint32Array(0),
    edited: new Uint8Array(0),
    uncertain: new Uint32Array(0),
    height: new Float32Array(n),
    speed: new Float32Array(n),
    summaries: {
      height: summarizeCurve(new Float32Array(0)),
      speed: summarizeCurve(new Float32Array(0)),
    },
  };
  const at = (f: number, axis: number) =>
    clip.positions[(f * clip.joints.length + joint) * 3 + axis] ?? 0;
  const intervals: number[] = [];
  for (let f = 0; f < n; f++) {
    const phase = (f / rate / period + half) % 1;
    const g = grow / rate / period;
    const inside = Math.min(phase - (from - g), to + g - phase);
    track.planted[f] = inside >= 0 ? 1 : 0;
    track.confidence[f] = Math.min(1, 0.55 + Math.abs(inside) * 6);
    track.height[f] = Math.max(0, at(f, 1) - 0.01);
    const before = Math.max(0, f - 1);
    const after = Math.min(n - 1, f + 1);
    track.speed[f] =
      (Math.hypot(at(after, 1) - at(before, 1), at(after, 2) - at(before, 2)) * rate) /
      Math.max(1, after - before);
    if (track.planted[f] && !(f > 0 && track.planted[f - 1])) intervals.push(f);
    if (!track.planted[f] && f > 0 && track.planted[f - 1]) intervals.push(f);
  }
  if (intervals.length % 2) intervals.push(n);
  track.intervals = Uint32Array.from(intervals);
  track.edited = new Uint8Array(intervals.length / 2);
  track.uncertain = uncertainRanges(track.intervals, track.confidence);
  track.summaries = { height: summarizeCurve(track.height), speed: summarizeCurve(track.speed) };
  return track;
}
