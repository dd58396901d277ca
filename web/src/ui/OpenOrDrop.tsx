import { commandOf, isEnabled, tooltip } from "../actions/commands";

/** The start of a sentence about files that can be opened: a link, or only the text if the host opens files. */
export function OpenOrDrop() {
  const open = commandOf("open");
  if (!isEnabled(open)) return <>Drop</>;
  return (
    <>
      <button type="button" class="link" title={tooltip("open")} onClick={open.run}>
        Open
      </button>
      <span class="with-pointer"> or drop</span>
    </>
  );
}
