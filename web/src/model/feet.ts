import type { Clip, Joint, Side } from "./types";

/** The joints of one foot; where a skeleton has no toe the ankle's own end stands in. */
export interface Foot {
  ankle: number;
  toe: number;
  tip: number;
}

/** Which light a bone carries: nothing, or the heel or toe of a foot. */
export const footLights = ["none", "leftHeel", "leftToe", "rightHeel", "rightToe"] as const;

export function footOf(clip: Pick<Clip, "joints" | "roles">, side: Side): Foot | undefined {
  const { joints, roles } = clip;
  const ankle = roles[`${side}_ankle`];
  if (ankle === undefined || !joints[ankle]) return undefined;
  const toe = roles[`${side}_toe`] ?? childOf(joints, ankle) ?? ankle;
  const tip = roles[`${side}_tip`] ?? childOf(joints, toe) ?? toe;
  return { ankle, toe, tip };
}

/** Per joint, the place in `lights` of the bone that ends there. */
export function footLightOfJoints(clip: Pick<Clip, "joints" | "roles">): Uint8Array {
  const lit = new Uint8Array(clip.joints.length);
  for (const side of ["left", "right"] as const) {
    const foot = footOf(clip, side);
    if (!foot) continue;
    const heel = side === "left" ? 1 : 3;
    const below = new Set([foot.ankle]);
    clip.joints.forEach((joint, i) => {
      if (joint.parent === undefined || !below.has(joint.parent)) return;
      below.add(i);
      lit[i] = heel;
    });
    const beyond = new Set([foot.toe]);
    clip.joints.forEach((joint, i) => {
      if (joint.parent === undefined || !beyond.has(joint.parent)) return;
      beyond.add(i);
      lit[i] = heel + 1;
    });
  }
  return lit;
}

function childOf(joints: readonly Joint[], parent: number): number | undefined {
  const child = joints.findIndex((joint) => joint.parent === parent);
  return child < 0 ? undefined : child;
}
