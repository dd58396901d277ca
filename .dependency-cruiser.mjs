/**
 * Rules for the imports of the web app, checked by `npm test -- layers`. Folders are ordered from
 * the bottom layer to the top one; an import, also of types only, goes down or stays in its folder.
 */

/** Folders of web/src by layer, the lowest first. */
const layers = [
  ["wasm"],
  ["util"],
  ["model"],
  ["workers"],
  ["engine"],
  ["store"],
  ["actions"],
  ["ui"],
  // Views of one kind each; they do not import each other.
  ["viewer", "timeline", "evidence", "batch", "panels"],
  ["app"],
];

const pathOf = (folders) => `^web/src/(${folders.join("|")})/`;

const upward = layers.slice(0, -1).map((folders, i) => ({
  name: `no-import-above-${folders.length > 1 ? "views" : folders[0]}`,
  comment: `${folders.join(", ")} must not import a higher layer`,
  severity: "error",
  from: { path: pathOf(folders), pathNot: "\\.test\\.tsx?$" },
  to: { path: pathOf(layers.slice(i + 1).flat()) },
}));

const views = layers
  .find((folders) => folders.length > 1)
  .map((folder, _, siblings) => ({
    name: `no-sibling-of-${folder}`,
    comment: "views must not import each other; what they share belongs to a lower layer",
    severity: "error",
    from: { path: pathOf([folder]) },
    to: { path: pathOf(siblings.filter((other) => other !== folder)) },
  }));

export default {
  forbidden: [
    { name: "no-circular", severity: "error", from: {}, to: { circular: true } },
    ...upward,
    ...views,
    {
      name: "page-does-not-load-wasm",
      comment: "only workers run the module; the model may use its types",
      severity: "error",
      from: { path: "^web/src/", pathNot: "^web/src/(workers|engine|wasm)/" },
      to: { path: "^web/src/wasm/", dependencyTypesNot: ["type-only"] },
    },
    {
      name: "page-does-not-load-workers",
      comment: "the engine starts workers by their URL; only their types are imported",
      severity: "error",
      from: { path: "^web/src/", pathNot: "^web/src/workers/" },
      to: {
        path: "^web/src/workers/",
        pathNot: "\\.worker\\.ts$",
        dependencyTypesNot: ["type-only"],
      },
    },
    {
      name: "no-test-code-in-app",
      severity: "error",
      from: { path: "^web/src/", pathNot: "(\\.test\\.tsx?$|^web/src/testing/)" },
      to: { path: "(^web/src/testing/|\\.test\\.tsx?$)" },
    },
    {
      name: "resolvable",
      severity: "error",
      from: {},
      to: { couldNotResolve: true, pathNot: "^(virtual:|three/addons/)" },
    },
  ],
  options: {
    doNotFollow: { path: "node_modules" },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: "tsconfig.json" },
    enhancedResolveOptions: { extensions: [".ts", ".tsx", ".js", ".d.ts"] },
  },
};
