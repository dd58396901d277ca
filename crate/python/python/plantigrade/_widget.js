/** The widget of the viewer: a frame with the page of the app, which gets its clip from the notebook. */

/** Decompresses bytes. */
const gunzip = (bytes) =>
  new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));

/** Returns the theme of the notebook: that of JupyterLab or VS Code, or else that of the system. */
function themeOfNotebook() {
  const { jpThemeLight, vscodeThemeKind } = document.body.dataset;
  if (jpThemeLight) return jpThemeLight === "true" ? "light" : "dark";
  if (vscodeThemeKind) return vscodeThemeKind.endsWith("light") ? "light" : "dark";
  return "system";
}

function createFrame(name, height) {
  const frame = document.createElement("iframe");
  frame.title = `Viewer of ${name}`;
  // An origin of its own: the page cannot read the notebook.
  frame.sandbox = "allow-scripts allow-downloads allow-popups";
  Object.assign(frame.style, {
    display: "block",
    boxSizing: "border-box",
    width: "100%",
    height: `${height}px`,
    border: "1px solid #8884",
    borderRadius: "6px",
  });
  return frame;
}

async function render({ model, el }) {
  const frame = createFrame(model.get("name"), model.get("height"));
  const controller = new AbortController();
  const post = (message) => frame.contentWindow?.postMessage(message, "*");
  const postTheme = () => post({ type: "plantigrade-theme", theme: themeOfNotebook() });
  // The state that the page has, as text.
  let shown = "";

  const open = async () => {
    const data = await (await gunzip(model.get("clip"))).arrayBuffer();
    const state = model.get("state");
    shown = JSON.stringify(state);
    postTheme();
    post({ type: "plantigrade-open", name: model.get("name"), data, state });
  };
  const onMessage = ({ source, data }) => {
    if (source !== frame.contentWindow) return;
    // A notebook that moves the frame loads the page again.
    if (data.type === "plantigrade-ready") open();
    if (data.type === "plantigrade-state") {
      shown = JSON.stringify(data.state);
      model.set("state", data.state);
      model.save_changes();
    }
  };
  const onState = () => {
    const state = model.get("state");
    const text = JSON.stringify(state);
    if (text === shown) return;
    shown = text;
    post({ type: "plantigrade-state", state });
  };
  addEventListener("message", onMessage, { signal: controller.signal });
  model.on("change:state", onState);
  const observer = new MutationObserver(postTheme);
  observer.observe(document.body, { attributes: true });

  el.append(frame);
  frame.srcdoc = await (await gunzip(model.get("page"))).text();
  return () => {
    controller.abort();
    model.off("change:state", onState);
    observer.disconnect();
  };
}

export default { render };
