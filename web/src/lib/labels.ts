/** Whether a file is labels by its name: a document or a truth file, or a table per frame. */
export const isLabels = (name: string) => /\.(json|csv)$/i.test(name);
