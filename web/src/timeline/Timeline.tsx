import { effect, useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import {
  actions,
  besides,
  chosen,
  clip,
  detectFailure,
  detection,
  looped,
  openClip,
  other,
  otherSegments,
  plants,
  reach,
  segmentation,
  selected,
  sheetOpen,
  tab,
  task,
  timeView,
} from "../app/state";
import { theme } from "../app/theme";
import { principal } from "../lib/plants";
import { sentence } from "../lib/report";
import type { Failure } from "../worker/types";
import { listen } from "./gestures";
import { type Ink, readInk } from "./ink";
import { layOut } from "./layout";
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
      other: other.value,
      segmentation: segmentation.value,
      otherSegments: otherSegments.value,
      besides: openClip.value ? besides.value : [],
    };
    return layOut(shown, box.value.width, box.value.height);
  });

  const shape = useComputed(() => selected.value && { ...selected.value, ...reach.value });

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
    let ink: Ink | undefined;
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
      ink ??= readInk(surface, pen, ratio);
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      paint(pen, {
        layout: layout.peek(),
        ink,
        view: timeView.peek(),
        frames: held.frames,
        rate: held.rate,
        width: wide,
        plants: plants.peek(),
        tracks: principal(detection.peek()?.parts ?? {}),
        segmentation: segmentation.peek(),
        actions: actions.peek(),
        chosen: chosen.peek(),
        otherSegments: otherSegments.peek(),
        loop: looped.peek(),
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
        void [layout.value, clip.value, timeView.value, plants.value, actions.value, looped.value];
        void shape.value;
        ask();
      }),
      listen(surface, () => layout.peek()),
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
    <section class="timeline" aria-label="Timeline" data-compared={other.value !== null}>
      <Transport />
      <div class="tracks" ref={room}>
        <canvas ref={canvas} class={still ? "gone" : undefined} />
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
          !task.value && (
            <Why
              failure={detectFailure.value}
              toJoints
              below={box.value.height - (layout.value.lanes[0]?.y ?? layout.value.minimap.y)}
            />
          )
        )}
      </div>
      <div class="hidden">
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
    <div class="why" ref={(element) => element?.style.setProperty("--below", `${below}px`)}>
      <p>{sentence(failure.message)}</p>
      {failure.hint && <p class="quiet">{failure.hint}</p>}
      {toJoints && (
        <button
          type="button"
          class="button"
          onClick={() => {
            tab.value = "clip";
            sheetOpen.value = true;
          }}
        >
          Choose the joints
        </button>
      )}
    </div>
  );
}
