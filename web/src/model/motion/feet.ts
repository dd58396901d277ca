import type { Clip, Joint, Side } from "../types";

/** Joint indices of one foot; a missing toe or tip is replaced by the joint above it. */
export interface Foot {
  ankle: number;
  toe: number;
  tip: number;
}

/** Highlights of bones, by the part of a foot to which they belong. */
const highlights = { none: 0, leftHeel: 1, leftToe: 2, rightHeel: 3, rightToe: 4 } as const;

/** Returns the joints of a foot; undefined if the skeleton has no ankle on that side. */
export function footOf(clip: Pick<Clip, "joints" | "roles">, side: Side): Foot | undefined {
  const { joints, roles } = clip;
  const ankle = roles[`${side}_ankle`];
  if (ankle === undefined || !joints[ankle]) return undefined;
  const toe = roles[`${side}_toe`] ?? childOf(joints, ankle) ?? ankle;
  const tip = roles[`${side}_tip`] ?? childOf(joints, toe) ?? toe;
  return { ankle, toe, tip };
}

/**
 * Returns for every joint the highlight of the bone that ends there: 0 none, 1 left heel,
 * 2 left toe, 3 right heel, 4 right toe.
 */
export function footLightOfJoints(clip: Pick<Clip, "joints" | "roles">): Uint8Array {
  const highlightOf = new Uint8Array(clip.joints.length);
  for (const side of ["left", "right"] as const) {
    const foot = footOf(clip, side);
    if (!foot) continue;
    for (const joint of descendants(clip.joints, foot.ankle)) {
      highlightOf[joint] = highlights[`${side}Heel`];
    }
    for (const joint of descendants(clip.joints, foot.toe)) {
      highlightOf[joint] = highlights[`${side}Toe`];
    }
  }
  return highlightOf;
}

/** Returns the joints below a joint; parents precede their children in the list. */
function descendants(joints: readonly Joint[], root: number): number[] {
  const below = new Set([root]);
  joints.forEach(({ parent }, i) => {
    if (parent !== undefined && below.has(parent)) below.add(i);
  });
  below.delete(root);
  return [...below];
}

function childOf(joints: readonly Joint[], parent: number): number | undefined {
  const child = joints.findIndex((joint) => joint.parent === parent);
  return child < 0 ? undefined : child;
}
