import "./base/theme.css";
import { ColorManagement } from "three";
import { App } from "./App";
import { element } from "./base/element";
import { loadBundledHead } from "./paint/loadBundledHead";
import { Studio } from "./Studio";
import { appText } from "./text/appText";
import { language } from "./text/language";

ColorManagement.enabled = false; // colors are what the painter mixed, from the first one on

const root = document.querySelector("#studio")!;
try {
  const studio = new Studio();
  const app = new App(studio, await loadBundledHead());
  root.replaceWith(app.element);
  studio.load();
  await app.bring.restore();
} catch (error) {
  // Mostly no WebGL 2: an old browser, or a machine that forbids it.
  root.replaceChildren(element("p", { className: "cannot-start", role: "alert" }, appText[language.value].cannotStart));
  throw error;
}
