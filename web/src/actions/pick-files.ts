import { openFiles } from "./open-files";

let input: HTMLInputElement | null = null;

/** Registers the file input of the page. */
export function setFileInput(element: HTMLInputElement | null) {
  input = element;
}

/** Opens the file picker of the browser. */
export function pickFiles() {
  input?.click();
}

/** Opens the picked files, and clears the input so that the same file can be picked again. */
export function openPickedFiles(picker: HTMLInputElement) {
  void openFiles({ files: [...(picker.files ?? [])] });
  picker.value = "";
}
