import { effect, useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { runDetection } from "../actions/analyse/detect";
import { principalTracks } from "../model/plants/plants";
import { shownCompanions } from "../store/companions";
import { opening } from "../store/jobs";
import { loopedRange, loopedSegment, timeView } from "../store/playback";
import { hiddenTracks, timelineHeight } from "../store/preferences";
import {
  clip,
  cutPreview,
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
  selectedCut,
  selectedEdge,
  similar,
} from "../store/session";
import { theme } from "../store/theme";
import { video } from "../store/video";
import { type CanvasTheme, readCanvasTheme } from "../ui/canvas-theme";
import { Splitter, setSize } from "../ui/Splitter";
import { isTouch } from "../ui/touch";
import { attachGestures } from "./gestures";
import { LanesMessage } from "./LanesMessage";
import { layoutTimeline } from "./layout";
import { PlantTable } from "./PlantTable";
import { MinimapPlayhead, Playhead } from "./Playhead";
import { paintTimeline } from "./paint";
import { Readout } from "./Readout";
import { SegmentTable } from "./SegmentTable";
import { StorageStatus } from "./StorageStatus";
import { Transport } from "./Transport";
import { VideoLane } from "./VideoLane";

/** Returns the height of the tracks without what the style sheet adds for a comparison, in pixels. */
const ownHeight = (tracks: HTMLElement) =>
  tracks.clientHeight -
  (Number.parseFloat(getComputedStyle(tracks).getPropertyValue("--compared-height")) || 0);

export function Timeline() {
  const container = useRef<HTMLDivElement | null>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = useSignal({ width: 0, height: 0 });
  const width = useComputed(() => size.value.width);
  const layout = useComputed(() => {
    const input = {
      detection: detection.value,
      reference: reference.value,
      segmentation: segmentation.value,
      referenceSegments: referenceSegments.value,
      companions: shownCompanions.value,
      hidden: hiddenTracks.value,
      isTouch: isTouch(),
    };
    return layoutTimeline(input, size.value.width, size.value.height);
  });

  const selectedBar = useComputed(
    () => selected.value && { ...selected.value, ...dragPreview.value },
  );

  useEffect(() => {
    const element = container.current;
    if (!element) return;
    const observer = new ResizeObserver(() => {
      // A canvas that is higher by a fraction of a pixel would scroll.
      const height = Math.floor(element.getBoundingClientRect().height);
      size.value = { width: element.clientWidth, height };
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [size]);

  useEffect(() => {
    const element = canvas.current;
    const ctx = element?.getContext("2d", { alpha: false });
    if (!element || !ctx) return;
    let canvasTheme: CanvasTheme | undefined;
    /** Pending animation frame, 0 if none. */
    let request = 0;
    const draw = () => {
      request = 0;
      const shownClip = clip.peek();
      const cssWidth = width.peek();
      const { height: cssHeight } = layout.peek();
      if (!cssWidth || !shownClip) return;
      const pixelRatio = Math.min(devicePixelRatio, 2);
      const pixelWidth = Math.round(cssWidth * pixelRatio);
      const pixelHeight = Math.round(cssHeight * pixelRatio);
      if (element.width !== pixelWidth || element.height !== pixelHeight) {
        element.width = pixelWidth;
        element.height = pixelHeight;
        element.style.height = `${cssHeight}px`;
      }
      canvasTheme ??= readCanvasTheme(element, ctx, pixelRatio);
      ctx.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
      paintTimeline(ctx, {
        layout: layout.peek(),
        theme: canvasTheme,
        view: timeView.peek(),
        frames: shownClip.frames,
        rate: shownClip.rate,
        width: cssWidth,
        plants: plants.peek(),
        tracks: principalTracks(detection.peek()?.parts ?? {}),
        segmentation: segmentation.peek(),
        namedSegments: namedSegments.peek(),
        loopedSegment: loopedSegment.peek(),
        selectedCut: cutPreview.peek() ?? selectedCut.peek(),
        referenceSegments: referenceSegments.peek(),
        loop: loopedRange.peek(),
        selected: selectedBar.peek(),
        selectedEdge: selectedEdge.peek(),
        similar: similar.peek()?.changes ?? [],
      });
    };
    const requestDraw = () => {
      if (!request) request = requestAnimationFrame(draw);
    };
    const disposers = [
      effect(() => {
        void theme.value;
        canvasTheme = undefined;
        requestDraw();
      }),
      effect(() => {
        void [
          layout.value,
          clip.value,
          timeView.value,
          plants.value,
          namedSegments.value,
          loopedRange.value,
          similar.value,
        ];
        void [selectedBar.value, selectedEdge.value, selectedCut.value, cutPreview.value];
        requestDraw();
      }),
      attachGestures(element, () => layout.peek()),
    ];
    // Texts measured with the fallback font would be truncated wrongly.
    void document.fonts?.ready.then(() => {
      canvasTheme = undefined;
      requestDraw();
    });
    return () => {
      cancelAnimationFrame(request);
      for (const stop of disposers) stop();
    };
  }, [layout, width, selectedBar]);

  const height = timelineHeight.value;
  const hasFrames = (openClip.value?.frames ?? 0) > 0;
  return (
    <section class="timeline" aria-label="Timeline" data-compared={reference.value !== null}>
      <Splitter
        label="Height of the timeline"
        orientation="horizontal"
        size={timelineHeight}
        measure={() => (container.current ? ownHeight(container.current) : 0)}
      />
      <StorageStatus />
      <Transport layout={layout} />
      {hasFrames && video.value && <VideoLane layout={layout} width={width} />}
      <div
        class="tracks"
        ref={(element) => {
          container.current = element;
          setSize(element, "--own-height", height);
        }}
      >
        <canvas ref={canvas} class={hasFrames ? undefined : "no-frames"} />
        {hasFrames && <Readout layout={layout} width={width} />}
        {hasFrames && <MinimapPlayhead layout={layout} width={width} />}
        {hasFrames && <Playhead layout={layout} width={width} />}
        {!hasFrames && (
          <LanesMessage
            message="This file contains a skeleton but no motion."
            hint="The rest pose is shown. There is nothing to play or to label."
          />
        )}
        {hasFrames && detectFailure.value && !opening.value && (
          <LanesMessage
            message={detectFailure.value.message}
            hint={detectFailure.value.hint}
            offersJoints={!detectFailure.value.canRetry}
            retry={detectFailure.value.canRetry ? () => void runDetection() : undefined}
            bottom={size.value.height - (layout.value.lanes[0]?.y ?? layout.value.minimap.y)}
          />
        )}
      </div>
      <div class="visually-hidden">
        <PlantTable />
        <SegmentTable />
      </div>
    </section>
  );
}
