import type { FileFormat } from "../model/types";

interface Props {
  format: FileFormat;
  onClick: () => void;
}

/** Button that saves a file; it shows the title of the format and the type of file. */
export function FormatButton({ format: { title, description, extension }, onClick }: Props) {
  const fileType = extension.slice(extension.lastIndexOf(".") + 1).toUpperCase();
  return (
    <button type="button" class="button" title={description} onClick={onClick}>
      {title} <span class="muted">{fileType}</span>
    </button>
  );
}
