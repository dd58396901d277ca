import { commandOf, isEnabled, tooltip } from "../actions/commands";
import { Icon } from "../ui/icons";

/** Undoes or redoes an edit of plants or cuts. */
export function HistoryButton({ id }: { id: "undo" | "redo" }) {
  const command = commandOf(id);
  return (
    <button
      type="button"
      class={`button flat icon-only ${id}`}
      aria-label={command.label}
      title={tooltip(id)}
      disabled={!isEnabled(command)}
      onClick={command.run}
    >
      <Icon name={id} />
    </button>
  );
}
