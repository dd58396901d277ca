import { openFiles } from "./open-files";

/** Files that the picker offers. */
const accepted = {
  all: ".bvh,.json,.csv,.npz,.zip,text/plain,video/*",
  videos: "video/*,.mp4,.m4v,.mov,.webm",
} as const;

let input: HTMLInputElement | null = null;

/** Registers the file input of the page. */
export function setFileInput(element: HTMLInputElement | null) {
  input = element;
}

function pick(accept: string) {
  if (!input) return;
  input.accept = accept;
  input.click();
}

/** Opens the file picker of the browser. */
export function pickFiles() {
  pick(accepted.all);
}

/** Opens the file picker of the browser for a video. */
export function pickVideo() {
  pick(accepted.videos);
}

/** Opens the picked files, and clears the input so that the same file can be picked again. */
export function openPickedFiles(picker: HTMLInputElement) {
  void openFiles({ files: [...(picker.files ?? [])] });
  picker.value = "";
}
