import { commandOf, isEnabled, tooltip } from "../actions/commands";
import { Icon } from "../ui/icons";

/** A button with the icon of a command. */
export function CommandButton({
  id,
}: {
  id: "undo" | "redo" | "delete" | "frame-back" | "frame-ahead";
}) {
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
