import { useRef } from "preact/hooks";
import { pickFiles } from "../actions/pick-files";
import { EvidencePanel } from "../evidence/EvidencePanel";
import { ClipPanel } from "../panels/ClipPanel";
import { DetectPanel } from "../panels/DetectPanel";
import { LabelsPanel } from "../panels/LabelsPanel";
import { ScorePanel } from "../panels/ScorePanel";
import { SegmentPanel } from "../panels/SegmentPanel";
import { reference } from "../store/session";
import { activeTab, sheetOpen, type Tab } from "../store/view";

const allTabs: readonly (readonly [Tab, string, () => preact.JSX.Element | null])[] = [
  ["detect", "Detect", DetectPanel],
  ["why", "Why", EvidencePanel],
  ["segment", "Segment", SegmentPanel],
  ["labels", "Labels", LabelsPanel],
  ["score", "Score", ScorePanel],
  ["clip", "Clip", ClipPanel],
];

/** The panel at the right; on a phone a sheet over the lower half, with an Open button. */
export function SidePanel() {
  const list = useRef<HTMLDivElement>(null);
  // Without other labels there is nothing to score.
  const tabs = allTabs.filter(([id]) => id !== "score" || reference.value);
  const choose = (next: Tab) => {
    // On a phone the tab that is up already puts the sheet down again.
    sheetOpen.value = !(sheetOpen.value && activeTab.value === next);
    activeTab.value = next;
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const at = tabs.findIndex(([id]) => id === activeTab.value);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = tabs[(to + tabs.length) % tabs.length];
    if (!next) return;
    activeTab.value = next[0];
    list.current?.querySelector<HTMLElement>(`#tab-${next[0]}`)?.focus();
  };
  const Body = tabs.find(([id]) => id === activeTab.value)?.[2] ?? DetectPanel;
  return (
    <aside class="panel" aria-label="Settings and labels" data-open={sheetOpen.value}>
      <button
        type="button"
        class="sheet-handle"
        aria-expanded={sheetOpen.value}
        aria-label={sheetOpen.value ? "Lower the panel" : "Raise the panel"}
        onClick={() => {
          sheetOpen.value = !sheetOpen.value;
        }}
      />
      <div class="panel-head">
        <div class="tabs" role="tablist" aria-label="Panel" ref={list} onKeyDown={onKeyDown}>
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
        <button type="button" class="button open-low" onClick={pickFiles}>
          Open
        </button>
      </div>
      <div
        class="panel-body"
        data-scrolls
        role="tabpanel"
        id="panel-body"
        aria-labelledby={`tab-${activeTab.value}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard
        tabIndex={0}
      >
        <Body />
      </div>
    </aside>
  );
}
