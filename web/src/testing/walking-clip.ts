import { uncertainRanges } from "../model/plants/plants";
import type { Clip, Joint, Track } from "../model/types";
import { summarizeCurve } from "../util/min-max-pyramid";

/** A synthetic walk along +z with exact plants, for tests. */

/** Frame rate, in Hz. */
const rate = 60;
/** Duration of a gait cycle, in seconds. */
const cyclePeriod = 1.1;
/** Fraction of the cycle that a foot is planted. */
const stanceFraction = 0.62;
/** Walking speed, in m/s. */
const walkingSpeed = 1.25;

type Point = readonly [x: number, y: number, z: number];

const skeleton: readonly (readonly [name: string, parent: number, kind?: Joint["kind"]])[] = [
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

export const walkingRoles = {
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

const smoothstep = (t: number) => t * t * (3 - 2 * t);

/** Returns the position and pitch of a foot at a time; `phaseOffset` is 0 or 0.5. */
function footAt(time: number, phaseOffset: number) {
  const cycle = time / cyclePeriod + phaseOffset;
  const step = Math.floor(cycle);
  const phase = cycle - step;
  const footZ = (stepIndex: number) =>
    (stepIndex + stanceFraction / 2 - phaseOffset) * cyclePeriod * walkingSpeed;
  if (phase < stanceFraction) {
    const heelRise = Math.max(0, (phase / stanceFraction - 0.72) / 0.28);
    const toeRise = Math.max(0, 1 - phase / stanceFraction / 0.14);
    return { z: footZ(step), lift: 0, pitch: -0.95 * heelRise * heelRise + 0.35 * toeRise };
  }
  const swingPhase = (phase - stanceFraction) / (1 - stanceFraction);
  const z = footZ(step) + (footZ(step + 1) - footZ(step)) * smoothstep(swingPhase);
  return {
    z,
    lift: 0.09 * Math.sin(Math.PI * swingPhase),
    pitch: -0.95 * (1 - swingPhase) ** 2 + 0.35 * swingPhase * swingPhase,
  };
}

/** Returns the position of the knee between hip and ankle. */
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

/** Returns the joint positions at a time, in metres. */
function pose(time: number): Point[] {
  const z = time * walkingSpeed;
  const bounce = 0.018 * Math.cos((4 * Math.PI * time) / cyclePeriod);
  const swing = Math.sin((2 * Math.PI * time) / cyclePeriod + 0.5);
  const hips: Point = [0, 0.9 + bounce, z];
  const at = (x: number, y: number, dz: number): Point => [x, y + bounce, z + dz];
  const points: Point[] = [
    hips,
    at(0, 1.03, 0.01),
    at(0, 1.28, 0.02),
    at(0, 1.48, 0.02),
    at(0, 1.57, 0.05),
    at(0, 1.76, 0.05),
  ];
  for (const side of [1, -1]) {
    const armSwing = -side * swing;
    points.push(
      at(0.19 * side, 1.42, 0.02 + 0.02 * armSwing),
      at(0.25 * side, 1.15, 0.02 + 0.14 * armSwing),
      at(0.24 * side, 0.93, 0.1 + 0.28 * armSwing),
      at(0.235 * side, 0.85, 0.13 + 0.34 * armSwing),
    );
  }
  for (const side of [1, -1]) {
    const foot = footAt(time, side > 0 ? 0 : 0.5);
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

/** Returns a clip of the walk; `seconds` may be 0 for a rest pose without frames. */
export function createWalkingClip(name: string, seconds = 12): Clip {
  const frames = Math.round(seconds * rate);
  const joints = skeleton.map(([name, parent, kind]): Joint => {
    const joint: Joint = { name, kind: kind ?? "joint" };
    return parent < 0 ? joint : { ...joint, parent };
  });
  const positions = new Float32Array(Math.max(frames, 1) * joints.length * 3);
  for (let frame = 0; frame < Math.max(frames, 1); frame++) {
    positions.set(pose(frame / rate).flat(), frame * joints.length * 3);
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
    roles: { ...walkingRoles },
    roleEvidence: Object.fromEntries(
      Object.keys(walkingRoles).map((role) => [
        role,
        { confidence: 0.95, doubtful: false, reasons: ["name"] },
      ]),
    ),
    roleNames: Object.keys(walkingRoles),
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

/** Returns a track planted between two phases of the cycle; `growth` widens each plant, in frames. */
export function createWalkingTrack(
  clip: Clip,
  phaseOffset: number,
  from: number,
  to: number,
  growth: number,
  joint: number,
) {
  const frames = clip.frames;
  const track: Track = {
    planted: new Uint8Array(frames),
    confidence: new Float32Array(frames),
    intervals: new Uint32Array(0),
    instants: new Float64Array(0),
    edited: new Uint8Array(0),
    uncertain: new Uint32Array(0),
    height: new Float32Array(frames),
    speed: new Float32Array(frames),
    summaries: {
      height: summarizeCurve(new Float32Array(0)),
      speed: summarizeCurve(new Float32Array(0)),
    },
  };
  const at = (frame: number, axis: number) =>
    clip.positions[(frame * clip.joints.length + joint) * 3 + axis] ?? 0;
  const intervals: number[] = [];
  for (let frame = 0; frame < frames; frame++) {
    const phase = (frame / rate / cyclePeriod + phaseOffset) % 1;
    const growthPhase = growth / rate / cyclePeriod;
    const margin = Math.min(phase - (from - growthPhase), to + growthPhase - phase);
    track.planted[frame] = margin >= 0 ? 1 : 0;
    track.confidence[frame] = Math.min(1, 0.55 + Math.abs(margin) * 6);
    track.height[frame] = Math.max(0, at(frame, 1) - 0.01);
    const before = Math.max(0, frame - 1);
    const after = Math.min(frames - 1, frame + 1);
    track.speed[frame] =
      (Math.hypot(at(after, 1) - at(before, 1), at(after, 2) - at(before, 2)) * rate) /
      Math.max(1, after - before);
    if (track.planted[frame] && !(frame > 0 && track.planted[frame - 1])) intervals.push(frame);
    if (!track.planted[frame] && frame > 0 && track.planted[frame - 1]) intervals.push(frame);
  }
  if (intervals.length % 2) intervals.push(frames);
  track.intervals = Uint32Array.from(intervals);
  track.edited = new Uint8Array(intervals.length / 2);
  track.uncertain = uncertainRanges(track.intervals, track.confidence);
  track.summaries = { height: summarizeCurve(track.height), speed: summarizeCurve(track.speed) };
  return track;
}
