import { effect, useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { principalTracks } from "../model/plants";
import { toSentence } from "../model/report";
import type { Failure } from "../model/types";
import { companions } from "../store/companions";
import { opening } from "../store/jobs";
import { loopedRange, loopedSegment, timeView } from "../store/playback";
import {
  clip,
  detectFailure,
  detection,
  dragPreview,
  namedSegments,
  openClip,
  plants,
  reference,
  referenceSegments,
  segmentation,
  selected,
} from "../store/session";
import { theme } from "../store/theme";
import { activeTab, sheetOpen } from "../store/view";
import { type CanvasTheme, readCanvasTheme } from "../ui/canvas-theme";
import { listenToCanvas } from "./gestures";
import { layoutTimeline } from "./layout";
import { PlantTable } from "./PlantTable";
import { Playhead } from "./Playhead";
import { PointedLine } from "./PointedLine";
import { paint } from "./paint";
import { SegmentTable } from "./SegmentTable";
import { Transport } from "./Transport";

export function Timeline() {
  const room = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const box = useSignal({ width: 0, height: 0 });
  const width = useComputed(() => box.value.width);
  const layout = useComputed(() => {
    const shown = {
      detection: detection.value,
      reference: reference.value,
      segmentation: segmentation.value,
      referenceSegments: referenceSegments.value,
      companions: openClip.value ? companions.value : [],
    };
    return layoutTimeline(shown, box.value.width, box.value.height);
  });

  const shape = useComputed(() => selected.value && { ...selected.value, ...dragPreview.value });

  useEffect(() => {
    const host = room.current;
    if (!host) return;
    const observer = new ResizeObserver(() => {
      box.value = { width: host.clientWidth, height: host.clientHeight };
    });
    observer.observe(host);
    return () => observer.disconnect();
  }, [box]);

  useEffect(() => {
    const surface = canvas.current;
    const pen = surface?.getContext("2d", { alpha: false });
    if (!surface || !pen) return;
    let ink: CanvasTheme | undefined;
    let due = 0;
    const draw = () => {
      due = 0;
      const held = clip.peek();
      const wide = width.peek();
      const { height: high } = layout.peek();
      if (!wide || !held) return;
      const ratio = Math.min(devicePixelRatio, 2);
      const dots = [Math.round(wide * ratio), Math.round(high * ratio)] as const;
      if (surface.width !== dots[0] || surface.height !== dots[1]) {
        [surface.width, surface.height] = dots;
        surface.style.height = `${high}px`;
      }
      ink ??= readCanvasTheme(surface, pen, ratio);
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      paint(pen, {
        layout: layout.peek(),
        ink,
        view: timeView.peek(),
        frames: held.frames,
        rate: held.rate,
        width: wide,
        plants: plants.peek(),
        tracks: principalTracks(detection.peek()?.parts ?? {}),
        segmentation: segmentation.peek(),
        namedSegments: namedSegments.peek(),
        loopedSegment: loopedSegment.peek(),
        referenceSegments: referenceSegments.peek(),
        loop: loopedRange.peek(),
        selected: shape.peek(),
      });
    };
    const ask = () => {
      if (!due) due = requestAnimationFrame(draw);
    };
    const stops = [
      effect(() => {
        void theme.value;
        ink = undefined;
        ask();
      }),
      effect(() => {
        void [
          layout.value,
          clip.value,
          timeView.value,
          plants.value,
          namedSegments.value,
          loopedRange.value,
        ];
        void shape.value;
        ask();
      }),
      listenToCanvas(surface, () => layout.peek()),
    ];
    // What was measured before the typeface came would be cut.
    void document.fonts?.ready.then(() => {
      ink = undefined;
      ask();
    });
    return () => {
      cancelAnimationFrame(due);
      for (const stop of stops) stop();
    };
  }, [layout, width, shape]);

  const held = openClip.value;
  const still = !held || held.frames === 0;
  return (
    <section class="timeline" aria-label="Timeline" data-compared={reference.value !== null}>
      <Transport />
      <div class="tracks" ref={room}>
        <canvas ref={canvas} class={still ? "no-frames" : undefined} />
        {!still && <PointedLine layout={layout} width={width} />}
        {!still && <Playhead layout={layout} width={width} />}
        {still ? (
          <Why
            failure={{
              message: "This file holds a skeleton and no motion.",
              hint: "Its rest pose is on show; there is nothing to play or to label.",
            }}
          />
        ) : (
          detectFailure.value &&
          !opening.value && (
            <Why
              failure={detectFailure.value}
              toJoints
              below={box.value.height - (layout.value.lanes[0]?.y ?? layout.value.minimap.y)}
            />
          )
        )}
      </div>
      <div class="visually-hidden">
        <PlantTable />
        <SegmentTable />
      </div>
    </section>
  );
}

/** Why there are no lanes, in words, with the way out. */
function Why({
  failure,
  toJoints,
  below = 0,
}: {
  failure: Failure;
  toJoints?: boolean;
  /** Height of what stands below it, in pixels. */
  below?: number;
}) {
  return (
    <div
      class="timeline-message"
      ref={(element) => element?.style.setProperty("--lanes-height", `${below}px`)}
    >
      <p>{toSentence(failure.message)}</p>
      {failure.hint && <p class="muted">{failure.hint}</p>}
      {toJoints && (
        <button
          type="button"
          class="button"
          onClick={() => {
            activeTab.value = "clip";
            sheetOpen.value = true;
          }}
        >
          Choose the joints
        </button>
      )}
    </div>
  );
}
