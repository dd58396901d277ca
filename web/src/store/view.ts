/** View state of the page: camera, tabs, dialogs and announcements. */

import { batch, type Signal, signal } from "@preact/signals";
import type { CameraPose, CameraView } from "../model/stored/view-state";
import { panelCollapsed } from "./preferences";

export type Tab = "detect" | "evidence" | "segment" | "labels" | "score" | "clip";

/** The parts of the 3D stage that other parts of the page use. */
export interface StageHandle {
  /** Returns the camera pose, or undefined if it is the default of the view. */
  cameraPose(view: CameraView): CameraPose | undefined;
  /** Renders the view as PNG. */
  picture(): Promise<Blob | null>;
  /** Draws now if a draw is requested for the next animation frame. */
  flush(): void;
}

/** The 3D stage; null until it is created or if the browser has no WebGL. */
export const stageHandle = signal<StageHandle | null>(null);

/** The preset view that was requested last. */
export const cameraView = signal<CameraView>("perspective");

/** Number of camera requests; repeating a request turns the camera back. */
export const cameraRequests = signal(0);

/** Turns the camera to a side. */
export function lookFrom(view: CameraView) {
  cameraView.value = view;
  cameraRequests.value++;
}

/** Number of requests for a close-up of the feet. */
export const feetRequests = signal(0);

/** Moves the camera to the feet. */
export function lookAtFeet() {
  feetRequests.value++;
}

/** True if the camera moves with the character. */
export const followCamera = signal(true);

/** True if the trails of toes and hips are drawn. */
export const trailsVisible = signal(false);

/** Joint that the view marks, because its row in a panel has the focus or the pointer; or null. */
export const markedJoint = signal<number | null>(null);

/** Number of requests to frame everything; the viewer responds to each change. */
export const frameAllRequests = signal(0);

export const activeTab = signal<Tab>("detect");

/** True if the panel, a bottom sheet on phones, is raised. */
export const sheetOpen = signal(false);

/** Shows a tab of the panel, also if the panel is hidden or a lowered sheet. */
export function showTab(tab: Tab) {
  batch(() => {
    activeTab.value = tab;
    sheetOpen.value = true;
    if (panelCollapsed.peek()) panelCollapsed.set(false);
  });
}

export const dialog = signal<"keys" | "notices" | "share" | "third-party" | null>(null);

/** The frame under the pointer in the timeline, and the lane; null if the pointer is elsewhere. */
export const hovered = signal<{ frame: number; y: number } | null>(null);

/** True while files are dragged over the page. */
export const filesDragged = signal(false);

/** Next announcement to screen readers. */
export const announcement = signal("");

/** What the last edit did, or why it did nothing; shown for a short time. */
export const message = signal("");

/** Replaces a text; if it is the same, by one that looks the same, because only changes are announced. */
function replaceText(field: Signal<string>, text: string) {
  field.value = field.peek() === text ? `${text}\u00a0` : text;
}

/** Announces a text to screen readers. */
export const announce = (text: string) => replaceText(announcement, text);

/** Reports what an edit did, on the page and to screen readers. */
export function notify(text: string) {
  replaceText(message, text);
  announce(text);
}
