import { type ReadonlySignal, useComputed } from "@preact/signals";
import { hiddenTracks, type TrackGroup, trackGroups } from "../store/preferences";
import { Menu } from "../ui/Menu";
import { joinWords } from "../util/format";
import type { Layout, OmittedTrack } from "./layout";

const groupNames: Record<TrackGroup, string> = {
  parts: "Heel and toe",
  curves: "Height and speed",
  segments: "Segments",
};

const omittedNames: Record<OmittedTrack, string> = {
  parts: "heel and toe",
  references: "references of heel and toe",
  companions: "clips side by side",
  height: "height",
  speed: "speed",
  segments: "segments",
  curve: "cut score",
};

/** What the marks of the timeline mean; the class draws a sample of each. */
const legend = [
  ["contact", "Contact: any part of the foot is on the ground"],
  ["heel", "Heel contact"],
  ["toe", "Toe contact"],
  ["uncertain", "Low confidence: review these frames"],
  ["whisker", "Foot strike or foot off ± one standard deviation"],
  ["edited", "Edited by hand"],
  ["reference", "Reference labels"],
  ["difference", "False negatives and false positives"],
  ["action", "Segments of the same action have the same letter, in all clips of the table"],
] as const;

/** Chooses the tracks that the timeline shows, and explains its marks. */
export function TracksMenu({ layout }: { layout: ReadonlySignal<Layout> }) {
  const hidden = hiddenTracks.value;
  const omitted = useComputed(() => layout.value.omitted).value;
  return (
    <Menu
      label={
        <>
          Tracks
          {omitted.length > 0 && <span class="omitted-mark"> {omitted.length} not shown</span>}
        </>
      }
      title="Choose tracks, and see what the marks mean"
    >
      <fieldset class="menu-choices">
        <legend>Tracks</legend>
        {trackGroups.map((group) => (
          <label key={group} class="checkbox-row">
            <input
              type="checkbox"
              checked={!hidden.includes(group)}
              onChange={(event) =>
                hiddenTracks.set(
                  event.currentTarget.checked
                    ? hidden.filter((other) => other !== group)
                    : [...hidden, group],
                )
              }
            />
            {groupNames[group]}
          </label>
        ))}
      </fieldset>
      {omitted.length > 0 && (
        <p class="note">
          There is no space for {joinWords(omitted.map((track) => omittedNames[track]))}. Hide other
          tracks
          <span class="if-resizable">, or make the timeline taller</span>
          <span class="if-raised">, or lower the panel</span>.
        </p>
      )}
      <h2>Legend</h2>
      <dl class="legend">
        {legend.map(([name, text]) => (
          <div key={name}>
            <dt class={`legend-mark ${name}`} aria-hidden="true" />
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
    </Menu>
  );
}
