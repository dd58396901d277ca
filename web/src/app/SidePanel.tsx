import type { ComponentType } from "preact";
import { useRef } from "preact/hooks";
import { DetectPanel } from "../panels/DetectPanel";
import { panelWidth } from "../store/preferences";
import { reference } from "../store/session";
import { activeTab, sheetOpen, type Tab } from "../store/view";
import { lazy } from "../ui/lazy";
import { Splitter } from "../ui/Splitter";

const EvidencePanel = lazy(() =>
  import("../evidence/EvidencePanel").then((module) => module.EvidencePanel),
);
const SegmentPanel = lazy(() =>
  import("../panels/SegmentPanel").then((module) => module.SegmentPanel),
);
const LabelsPanel = lazy(() =>
  import("../panels/LabelsPanel").then((module) => module.LabelsPanel),
);
const ScorePanel = lazy(() => import("../panels/ScorePanel").then((module) => module.ScorePanel));
const ClipPanel = lazy(() => import("../panels/ClipPanel").then((module) => module.ClipPanel));

/** Loads the panels that the first labels do not require. */
export function preloadPanels() {
  for (const panel of [EvidencePanel, SegmentPanel, LabelsPanel, ScorePanel, ClipPanel]) {
    panel.preload();
  }
}

type TabEntry = readonly [Tab, string, ComponentType<object>];

const allTabs: readonly [TabEntry, ...TabEntry[]] = [
  ["detect", "Detect", DetectPanel],
  ["evidence", "Evidence", EvidencePanel],
  ["segment", "Segment", SegmentPanel],
  ["labels", "Labels", LabelsPanel],
  ["score", "Score", ScorePanel],
  ["clip", "Clip", ClipPanel],
];

/** The side panel; on phones a sheet below the timeline. */
export function SidePanel() {
  const tabList = useRef<HTMLDivElement>(null);
  const panel = useRef<HTMLElement | null>(null);
  // The score requires a reference.
  const tabs = allTabs.filter(([id]) => id !== "score" || reference.value);
  const [shown, , Body] = tabs.find(([id]) => id === activeTab.value) ?? allTabs[0];
  const choose = (next: Tab) => {
    // On phones, the tab that is shown collapses the sheet.
    sheetOpen.value = !(sheetOpen.value && shown === next);
    activeTab.value = next;
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const index = tabs.findIndex(([id]) => id === shown);
    const target = { ArrowRight: index + 1, ArrowLeft: index - 1, Home: 0, End: tabs.length - 1 }[
      event.key
    ];
    if (target === undefined) return;
    event.preventDefault();
    const next = tabs[(target + tabs.length) % tabs.length];
    if (!next) return;
    activeTab.value = next[0];
    tabList.current?.querySelector<HTMLElement>(`#tab-${next[0]}`)?.focus();
  };
  return (
    <aside
      class="panel"
      aria-label="Settings and labels"
      data-open={sheetOpen.value}
      ref={(element) => {
        panel.current = element;
      }}
    >
      <Splitter
        label="Width of the panel"
        orientation="vertical"
        size={panelWidth}
        measure={() => panel.current?.clientWidth ?? 0}
      />
      <button
        type="button"
        class="sheet-handle"
        aria-expanded={sheetOpen.value}
        aria-label={sheetOpen.value ? "Collapse panel" : "Expand panel"}
        onClick={() => {
          sheetOpen.value = !sheetOpen.value;
        }}
      />
      <div class="panel-head">
        <div class="tabs" role="tablist" aria-label="Panel" ref={tabList} onKeyDown={onKeyDown}>
          {tabs.map(([id, name]) => (
            <button
              key={id}
              type="button"
              role="tab"
              id={`tab-${id}`}
              aria-selected={shown === id}
              aria-controls="panel-body"
              tabIndex={shown === id ? 0 : -1}
              onClick={() => choose(id)}
            >
              {name}
            </button>
          ))}
        </div>
      </div>
      {/* Each tab begins at its top. */}
      <div
        key={shown}
        class="panel-body"
        data-scrolls
        role="tabpanel"
        id="panel-body"
        aria-labelledby={`tab-${shown}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a scroll container must be focusable by keyboard
        tabIndex={0}
      >
        <Body />
      </div>
    </aside>
  );
}
