import { embedded } from "../store/embedded";

/** Whoever was sent a clip may want to open one too. */
export function MadeWith() {
  const words = "Made with Plantigrade";
  const { home = "" } = embedded ?? {};
  // Nothing but a web address: a page may have been tampered with.
  if (!/^https?:/.test(home)) return <span class="made muted">{words}</span>;
  return (
    <a class="made link" href={home} target="_blank" rel="noreferrer">
      {words}
    </a>
  );
}
