import { effect, useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { pause, seek } from "../app/playback";
import {
  clip,
  detectFailure,
  detection,
  frame,
  loop,
  loopRegion,
  openClip,
  plants,
  playhead,
  sheetOpen,
  tab,
  task,
  timeView,
} from "../app/state";
import { theme } from "../app/theme";
import { plantAt } from "../lib/plants";
import { toFrame, toX } from "../lib/timeView";
import type { Failure } from "../worker/types";
import { listen } from "./gestures";
import { type Ink, readInk } from "./ink";
import { type Layout, layOut } from "./layout";
import { PlantTable } from "./PlantTable";
import { paint } from "./paint";
import { margin } from "./scene";
import { Transport } from "./Transport";

export function Timeline() {
  const room = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const head = useRef<HTMLDivElement>(null);
  const box = useSignal({ width: 0, height: 0 });

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
    let layout: Layout = layOut(null, 0, 0);
    let ink: Ink | undefined;
    let due = 0;
    const draw = () => {
      due = 0;
      const { width } = box.peek();
      const held = clip.peek();
      if (!width || !held) return;
      const ratio = Math.min(devicePixelRatio, 2);
      const wide = Math.round(width * ratio);
      const high = Math.round(layout.height * ratio);
      if (surface.width !== wide || surface.height !== high) {
        surface.width = wide;
        surface.height = high;
        surface.style.height = `${layout.height}px`;
      }
      ink ??= readInk(surface, pen, ratio);
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      paint(pen, {
        layout,
        ink,
        view: timeView.peek(),
        frames: held.frames,
        rate: held.rate,
        width,
        plants: plants.peek(),
        loop: loop.peek() === "plant" ? loopRegion.peek() : null,
      });
    };
    const ask = () => {
      if (!due) due = requestAnimationFrame(draw);
    };
    const stops = [
      effect(() => {
        const { width, height } = box.value;
        layout = layOut(detection.value, width, height);
        ask();
      }),
      effect(() => {
        void theme.value;
        ink = undefined;
        ask();
      }),
      effect(() => {
        void [clip.value, timeView.value, plants.value, loop.value, loopRegion.value];
        ask();
      }),
      effect(() => {
        const { width } = box.value;
        const inner = width - layout.labels - margin;
        const x = toX(timeView.value, playhead.value, inner);
        const mark = head.current;
        if (!mark) return;
        mark.style.transform = `translateX(${layout.labels + x}px)`;
        mark.style.visibility = x < -1 || x > inner + 1 ? "hidden" : "visible";
        mark.style.height = `${layout.minimap.y - 4}px`;
      }),
      listen(surface, () => layout),
    ];
    // Numbers measured before the typeface came would be cut.
    void document.fonts?.ready.then(ask);
    return () => {
      cancelAnimationFrame(due);
      for (const stop of stops) stop();
    };
  }, [box]);

  const held = openClip.value;
  const still = !held || held.frames === 0;
  return (
    <section class="timeline" aria-label="Timeline">
      <Transport />
      <div class="tracks" ref={room}>
        <canvas ref={canvas} class={still ? "gone" : undefined} />
        {!still && <Playhead head={head} width={() => box.peek().width} />}
        {still ? (
          <Why
            failure={{
              message: "This file holds a skeleton and no motion.",
              hint: "Its rest pose is on show; there is nothing to play or to label.",
            }}
          />
        ) : (
          detectFailure.value && !task.value && <Why failure={detectFailure.value} toJoints />
        )}
      </div>
      <PlantTable />
    </section>
  );
}

/** Why there are no lanes, in words, with the way out. */
function Why({ failure, toJoints }: { failure: Failure; toJoints?: boolean }) {
  const { message } = failure;
  const sentence = message.charAt(0).toUpperCase() + message.slice(1);
  return (
    <div class="why">
      <p>{/[.!?]$/.test(sentence) ? sentence : `${sentence}.`}</p>
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

/** The line over everything: an element of its own, so that playing repaints no lane. */
function Playhead({
  head,
  width,
}: {
  head: { current: HTMLDivElement | null };
  width: () => number;
}) {
  const text = useComputed(() => {
    const at = frame.value;
    const rate = clip.value?.rate ?? 1;
    const foot = (side: "left" | "right") =>
      plantAt(plants.value, at, side) ? `${side} planted` : `${side} in the air`;
    const feet = detection.value ? `, ${foot("left")}, ${foot("right")}` : "";
    return `${(at / rate).toFixed(3)} s, frame ${at}${feet}`;
  });
  const drag = (event: PointerEvent) => {
    const handle = event.currentTarget as HTMLElement;
    if (event.type === "pointerdown") {
      handle.setPointerCapture(event.pointerId);
      pause();
    }
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const tracks = handle.closest(".tracks");
    const area = tracks?.getBoundingClientRect();
    if (!area) return;
    const labels = layOut(null, width(), 0).labels;
    const view = timeView.peek();
    const at = toFrame(view, event.clientX - area.left - labels, width() - labels - margin);
    seek(Math.min(Math.max(at, view.start), view.end));
  };
  return (
    <div class="playhead" ref={head}>
      <div
        class="playhead-handle"
        role="slider"
        tabIndex={0}
        aria-label="Playhead"
        aria-valuemin={0}
        aria-valuemax={Math.max(0, (clip.value?.frames ?? 1) - 1)}
        aria-valuenow={frame}
        aria-valuetext={text}
        onPointerDown={drag}
        onPointerMove={drag}
      />
    </div>
  );
}
