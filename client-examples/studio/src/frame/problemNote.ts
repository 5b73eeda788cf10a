import type { App } from "../App";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import { faultText } from "../text/faultText";
import { iconButton } from "../widgets/iconButton";

/** What the service refused: shown at its field if that is on show, else over the picture. */
export function problemNote({ studio, fields, words }: App): Part {
  const note = element("div", { className: "stage-problem", role: "alert" });
  const show = () => {
    const problem = studio.problem.value;
    note.hidden = fields.show(problem) || problem === null;
    if (!problem) return note.replaceChildren();
    const [fault] = problem.fields;
    note.replaceChildren(element("strong", {}, words.problem), element("p", {}, fault ? `${fault.pointer}: ${faultText(fault)}` : problem.message), iconButton("close", words.dismiss, () => (studio.problem.value = null)));
  };
  const endings = [studio.problem.changed(show), fields.changed.changed(show)];
  show();
  return { element: note, dispose: () => endings.forEach((end) => end()) };
}
