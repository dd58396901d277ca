import { effect, signal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { commandOf, tooltip } from "../actions/commands";
import { prefersReducedMotion } from "../actions/playback";
import { characterSize, gridStep } from "../model/trajectory";
import type { Clip } from "../model/types";
import type { CameraView } from "../model/view-state";
import { companions } from "../store/companions";
import { shownMoment } from "../store/evidence";
import { firstInteraction } from "../store/first-interaction";
import { opening } from "../store/jobs";
import { playhead } from "../store/playback";
import {
  cleaned,
  cleanedView,
  clip,
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
  followCamera,
  frameAllRequests,
  stageHandle,
  trailsVisible,
} from "../store/view";
import { Companions } from "./Companions";
import { Pills } from "./Pills";
import type { Stage } from "./stage";

/** Why there is no picture; empty while there is one. */
const trouble = signal<"" | "missing" | "lost">("");

const views: readonly CameraView[] = ["perspective", "front", "side", "top"];

export function Viewer() {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => (host.current ? direct(host.current) : undefined), []);
  const label = useComputed(() =>
    openClip.value ? `The skeleton of ${openClip.value.name}` : "A walking skeleton",
  );
  return (
    <section class="viewer" aria-label="View">
      <div class="stage" ref={host} role="img" aria-label={label} />
      {trouble.value && <p class="viewer-error">{troubleText[trouble.value]}</p>}
      {openClip.value && (
        <>
          <div class="viewer-tools" hidden={trouble.value === "missing"}>
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
              title={tooltip("paths")}
              onClick={commandOf("paths").run}
            >
              Paths
            </button>
          </div>
          <Pills />
          <Companions />
          <p class="grid-size" hidden={trouble.value === "missing"}>
            Grid {gridStep(characterSize(openClip.value))} m
          </p>
        </>
      )}
    </section>
  );
}

const troubleText = {
  missing:
    "This browser shows no 3D (WebGL is off or missing). The timeline and the labels work without it.",
  lost: "The graphics driver dropped the picture. It comes back by itself when the driver does; the timeline works meanwhile.",
} as const;

/** Builds the stage when three.js has come, keeps it at what the state says; returns how to end it. */
function direct(host: HTMLElement): () => void {
  let ended = false;
  let end = () => {};
  const coming = Promise.race([firstInteraction, when(() => opening.value || clip.value)]);
  void Promise.all([coming.then(() => import("./stage")), when(() => clip.value)]).then(
    ([{ Stage }]) => {
      if (ended) return;
      let stage: Stage;
      try {
        stage = new Stage(host, prefersReducedMotion());
      } catch {
        trouble.value = "missing";
        return;
      }
      stage.canvas.addEventListener("webglcontextlost", (event) => {
        event.preventDefault();
        trouble.value = "lost";
      });
      stage.canvas.addEventListener("webglcontextrestored", () => {
        trouble.value = "";
        stage.invalidate();
      });
      const stops = connect(stage);
      end = () => {
        for (const stop of stops) stop();
        stage.dispose();
      };
    },
  );
  return () => {
    ended = true;
    end();
  };
}

/** Settles when a state has come. */
function when(state: () => unknown): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (!state()) return;
      resolve();
      queueMicrotask(() => stop());
    });
  });
}

function connect(stage: Stage): (() => void)[] {
  stageHandle.value = stage;
  let before: unknown;
  let up: unknown;
  return [
    effect(() => {
      void theme.value;
      const isOther = before !== source.value;
      const reframe = isOther || up !== clip.value?.up;
      before = source.value;
      up = clip.value?.up;
      const held = clip.value;
      const after = cleaned.value && { ...held, positions: cleaned.value.positions };
      stage.setClip(after && cleanedView.value !== "before" ? (after as Clip) : held, reframe);
      if (cleanedView.value === "both") stage.setGhost(held);
      stage.setLabels(detection.peek(), plants.peek());
      stage.setCompanions(openClip.value ? companions.peek() : []);
      stage.setTrails(trailsVisible.peek());
      if (reframe) cameraView.value = "perspective";
      if (isOther) showAsSent(stage);
    }),
    effect(() => stage.setLabels(detection.value, plants.value)),
    effect(() => stage.setTrails(trailsVisible.value)),
    effect(() => stage.setCompanions(openClip.value ? companions.value : [])),
    effect(() => stage.seek(shownMoment.value)),
    effect(() => stage.setFollow(followCamera.value || isPreview.value)),
    effect(() => stage.setAside(isPreview.value)),
    skipFirst(
      () => cameraRequests.value,
      () => stage.look(cameraView.peek()),
    ),
    skipFirst(
      () => frameAllRequests.value,
      () => stage.frameAll(),
    ),
  ];
}

/** The camera is where a link or a shared page says. */
function showAsSent(stage: Stage) {
  const { view } = source.peek() ?? {};
  if (!view) return;
  stage.seek(playhead.peek());
  stage.setFollow(followCamera.peek());
  stage.show(view);
  if (view.view) cameraView.value = view.view;
}

/** An effect for requests: what was asked before there was a stage is past. */
function skipFirst<T>(read: () => T, act: (value: T) => void): () => void {
  let first = true;
  return effect(() => {
    const value = read();
    if (!first) act(value);
    first = false;
  });
}
