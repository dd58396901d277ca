import type { ReadonlySignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { plural } from "../util/format";
import { useDebounced } from "./use-debounced";

/** Longer tables are impractical with a screen reader; the side panel lists all items. */
const maxRows = 100;

interface Props<T> {
  items: ReadonlySignal<readonly T[]>;
  /** Singular noun of the items, for the caption. */
  noun: string;
  columns: readonly string[];
  /** Returns the cells of the row of an item, without those for start and duration. */
  cells: (item: T) => readonly ComponentChildren[];
  /** Label of the button in the first column. */
  buttonLabel: (item: T) => string;
  onSelect: (item: T) => void;
  /** Frame rate, in Hz. */
  rate: number;
}

/**
 * A lane as a table for screen readers. Its rows are debounced, since they must not slow down the
 * canvas, and its buttons are not tab stops.
 */
export function AccessibleTable<T extends { number: number; start: number; end: number }>({
  items,
  noun,
  columns,
  cells,
  buttonLabel,
  onSelect,
  rate,
}: Props<T>) {
  const all = useDebounced(items);
  if (!all.length) return null;
  return (
    <table>
      <caption>
        {plural(all.length, noun)}
        {all.length > maxRows ? `, the first ${maxRows} listed` : ""}
      </caption>
      <thead>
        <tr>
          {[...columns, "Start", "Duration"].map((column) => (
            <th key={column}>{column}</th>
          ))}
        </tr>
      </thead>
      <tbody>
        {all.slice(0, maxRows).map((item) => (
          <tr key={item.number}>
            <td>
              <button type="button" tabIndex={-1} onClick={() => onSelect(item)}>
                {buttonLabel(item)}
              </button>
            </td>
            {cells(item).map((cell, i) => (
              <td key={i}>{cell}</td>
            ))}
            <td>{(item.start / rate).toFixed(2)} s</td>
            <td>{((item.end - item.start) / rate).toFixed(2)} s</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
