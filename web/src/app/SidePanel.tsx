import { useRef } from "preact/hooks";
import { EvidencePanel } from "../evidence/EvidencePanel";
import { ClipPanel } from "../panels/ClipPanel";
import { DetectPanel } from "../panels/DetectPanel";
import { LabelsPanel } from "../panels/LabelsPanel";
import { ScorePanel } from "../panels/ScorePanel";
import { SegmentPanel } from "../panels/SegmentPanel";
import { panelWidth } from "../store/preferences";
import { reference } from "../store/session";
import { activeTab, sheetOpen, type Tab } from "../store/view";
import { Splitter } from "../ui/Splitter";

const allTabs: readonly (readonly [Tab, string, () => preact.JSX.Element | null])[] = [
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
  const choose = (next: Tab) => {
    // On phones, the tab that is shown collapses the sheet.
    sheetOpen.value = !(sheetOpen.value && activeTab.value === next);
    activeTab.value = next;
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const index = tabs.findIndex(([id]) => id === activeTab.value);
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
  const Body = tabs.find(([id]) => id === activeTab.value)?.[2] ?? DetectPanel;
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
              aria-selected={activeTab.value === id}
              aria-controls="panel-body"
              tabIndex={activeTab.value === id ? 0 : -1}
              onClick={() => choose(id)}
            >
              {name}
            </button>
          ))}
        </div>
      </div>
      <div
        class="panel-body"
        data-scrolls
        role="tabpanel"
        id="panel-body"
        aria-labelledby={`tab-${activeTab.value}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a scroll container must be focusable by keyboard
        tabIndex={0}
      >
        <Body />
      </div>
    </aside>
  );
}
