import { effect, signal, untracked, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { commandOf, tooltip } from "../actions/commands";
import { prefersReducedMotion } from "../actions/view/playback";
import { wasmModule } from "../engine";
import { characterSize, gridStep } from "../model/motion/trajectory";
import { titleOfSource } from "../model/sources/source";
import type { CameraView } from "../model/stored/view-state";
import type { Clip } from "../model/types";
import { shownCompanions } from "../store/companions";
import { shownMoment } from "../store/evidence";
import { firstInteraction } from "../store/first-interaction";
import { opening } from "../store/jobs";
import { playhead } from "../store/playback";
import {
  cleaned,
  cleanedView,
  clip,
  clipTitle,
  detection,
  isPreview,
  openClip,
  plants,
  source,
} from "../store/session";
import { theme } from "../store/theme";
import {
  cameraRequests,
  cameraView,
  feetRequests,
  followCamera,
  frameAllRequests,
  markedJoint,
  stageHandle,
  trailsVisible,
} from "../store/view";
import { lazy } from "../ui/lazy";
import { isTouch } from "../ui/touch";
import { Companions } from "./Companions";
import { Pills } from "./Pills";
import type { Stage } from "./stage";

const FrameSteps = lazy(() => import("./FrameSteps").then((module) => module.FrameSteps));

/** State of the 3D view. */
const state = signal<"ready" | keyof typeof messages>("loading");

const views: readonly CameraView[] = ["perspective", "front", "side", "top"];

export function Viewer() {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => (host.current ? mountStage(host.current) : undefined), []);
  const label = useComputed(() =>
    openClip.value ? `Skeleton of ${clipTitle}` : "A walking skeleton",
  );
  return (
    <section class="viewer" aria-label="View">
      <div class="stage" ref={host} role="img" aria-label={label} />
      <Message />
      {openClip.value && (
        <>
          <div class="viewer-tools" hidden={state.value === "missing"}>
            <fieldset class="segmented">
              <legend class="visually-hidden">Camera</legend>
              {views.map((view) => (
                <button
                  key={view}
                  type="button"
                  aria-pressed={cameraView.value === view}
                  title={tooltip(`view-${view}`)}
                  onClick={commandOf(`view-${view}`).run}
                >
                  {commandOf(`view-${view}`).label}
                </button>
              ))}
            </fieldset>
            <button
              type="button"
              class="chip"
              title={tooltip("view-feet")}
              onClick={commandOf("view-feet").run}
            >
              Feet
            </button>
            <button
              type="button"
              class="chip"
              aria-pressed={followCamera.value}
              title="Move the camera with the character"
              onClick={() => {
                followCamera.value = !followCamera.value;
              }}
            >
              Follow
            </button>
            <button
              type="button"
              class="chip"
              aria-pressed={trailsVisible.value}
              title={tooltip("trails")}
              onClick={commandOf("trails").run}
            >
              Trails
            </button>
            <button
              type="button"
              class="chip"
              title={tooltip("video")}
              onClick={commandOf("video").run}
            >
              Video
            </button>
          </div>
          {isTouch() && openClip.value.frames > 1 && <FrameSteps />}
          <Pills />
          <Companions />
          <p class="grid-size" hidden={state.value === "missing"}>
            Grid {gridStep(characterSize(openClip.value))} m
          </p>
        </>
      )}
    </section>
  );
}

const messages = {
  loading: "Loading the 3D view",
  missing:
    "3D view unavailable: WebGL is disabled or not supported. Enable WebGL to see the skeleton; the timeline and the labels work without it.",
  lost: "3D view interrupted: the graphics driver has reset. The view returns when the driver recovers; the timeline still works.",
  failed:
    "3D view unavailable: it could not be loaded. Check the connection to the network, then reload the page; the timeline and the labels work without it.",
} as const;

/** Text in the place of the view. While the start page loads the view, it shows a picture instead. */
function Message() {
  const isPictureShown = !openClip.value && ["loading", "failed"].includes(state.value);
  if (state.value === "ready" || isPictureShown) return null;
  return <p class={`viewer-message is-${state.value}`}>{messages[state.value]}</p>;
}

/**
 * Creates the stage as soon as three.js has loaded and binds it to the application state. Returns a
 * function that removes it.
 */
function mountStage(host: HTMLElement): () => void {
  let unmounted = false;
  let dispose = () => {};
  const stageNeeded = Promise.race([
    firstInteraction,
    untilTruthy(() => opening.value || clip.value),
  ]);
  // The labels need the module but not the view: over a slow network, three.js must not delay them.
  const moduleLoaded = wasmModule().catch(() => {});
  const stageLoaded = Promise.all([stageNeeded, moduleLoaded]).then(() => import("./stage"));
  const onFailure = () => {
    state.value = "failed";
  };
  void Promise.all([stageLoaded, untilTruthy(() => clip.value)]).then(([{ Stage }]) => {
    if (unmounted) return;
    let stage: Stage;
    try {
      stage = new Stage(host, prefersReducedMotion());
    } catch {
      state.value = "missing";
      return;
    }
    state.value = "ready";
    stage.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      state.value = "lost";
    });
    stage.canvas.addEventListener("webglcontextrestored", () => {
      state.value = "ready";
      stage.invalidate();
    });
    const disposers = bindStage(stage);
    dispose = () => {
      for (const stop of disposers) stop();
      stage.dispose();
    };
  }, onFailure);
  return () => {
    unmounted = true;
    dispose();
  };
}

/** Resolves as soon as the state is truthy. */
function untilTruthy(state: () => unknown): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (!state()) return;
      resolve();
      queueMicrotask(() => stop());
    });
  });
}

/** Shows the comparison clips. */
function setCompanions(stage: Stage) {
  const others = shownCompanions.value;
  const titles = others.map(({ source }) => titleOfSource(source));
  stage.setCompanions(others, [clipTitle.value, ...titles]);
}

function bindStage(stage: Stage): (() => void)[] {
  stageHandle.value = stage;
  let previousSource: unknown;
  let previousUp: unknown;
  return [
    effect(() => {
      void theme.value;
      const isNewClip = previousSource !== source.value;
      const reframe = isNewClip || previousUp !== clip.value?.up;
      previousSource = source.value;
      previousUp = clip.value?.up;
      const original = clip.value;
      const corrected = cleaned.value && { ...original, positions: cleaned.value.positions };
      const isCorrected = corrected && cleanedView.value !== "before";
      stage.setClip(isCorrected ? (corrected as Clip) : original, reframe);
      if (cleanedView.value === "both") stage.setGhost(original);
      stage.setLabels(detection.peek(), plants.peek());
      untracked(() => setCompanions(stage));
      stage.setTrails(trailsVisible.peek());
      stage.markJoint(markedJoint.peek());
      if (reframe) cameraView.value = "perspective";
      if (isNewClip) applyLinkedView(stage);
    }),
    effect(() => stage.setLabels(detection.value, plants.value)),
    effect(() => stage.setTrails(trailsVisible.value)),
    effect(() => stage.markJoint(openClip.value ? markedJoint.value : null)),
    effect(() => setCompanions(stage)),
    effect(() => stage.seek(shownMoment.value)),
    effect(() => stage.setFollow(followCamera.value || isPreview.value)),
    effect(() => stage.setPreview(isPreview.value)),
    skipFirst(
      () => cameraRequests.value,
      () => stage.setCameraView(cameraView.peek()),
    ),
    skipFirst(
      () => feetRequests.value,
      () => stage.frameFeet(),
    ),
    skipFirst(
      () => frameAllRequests.value,
      () => stage.frameAll(),
    ),
  ];
}

/** Applies the camera and the playhead that a link or a shared page carries. */
function applyLinkedView(stage: Stage) {
  const { view } = source.peek() ?? {};
  if (!view) return;
  stage.seek(playhead.peek());
  stage.setFollow(followCamera.peek());
  stage.applyViewState(view);
  if (view.view) cameraView.value = view.view;
}

/** An effect that ignores the initial value: requests made before the stage existed are dropped. */
function skipFirst<T>(read: () => T, act: (value: T) => void): () => void {
  let first = true;
  return effect(() => {
    const value = read();
    if (!first) act(value);
    first = false;
  });
}
