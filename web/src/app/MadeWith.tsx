import { embedded } from "../store/embedded";

/** Credit on shared pages, with a link to the app if it has a public address. */
export function MadeWith() {
  const text = "Made with Plantigrade";
  const home = (embedded && "home" in embedded && embedded.home) || "";
  // The page may have been modified by others: only web addresses become links.
  if (!/^https?:/.test(home)) return <span class="credit made-with muted">{text}</span>;
  return (
    <a class="credit made-with link" href={home} target="_blank" rel="noreferrer">
      {text}
    </a>
  );
}
