import "./base/theme.css";
import { ColorManagement } from "three";
import { App } from "./App";
import { loadBundledHead } from "./paint/loadBundledHead";
import { Studio } from "./Studio";

ColorManagement.enabled = false; // colors are what the painter mixed, from the first one on

const studio = new Studio();
const app = new App(studio, await loadBundledHead());
document.querySelector("#studio")?.replaceWith(app.element);
studio.load();
await app.bring.restore();
