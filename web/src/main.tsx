import { render } from "preact";
import { App } from "./app/App";
import "./styles/font.css";
import "./styles/tokens.css";
import "./styles/base.css";
import "./styles/shell.css";
import "./styles/empty.css";
import "./styles/overlays.css";
import "./styles/viewer.css";
import "./styles/timeline.css";
import "./styles/panel.css";
import "./styles/batch.css";
import "./styles/edit.css";
import "./styles/tour.css";
import "./styles/score.css";
import "./styles/segment.css";

const root = document.getElementById("app");
if (root) render(<App />, root);
