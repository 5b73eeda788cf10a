import type { ServiceProblem } from "../api/ServiceProblem";
import { Signal } from "../base/Signal";
import { faultText } from "../text/faultText";
import type { Slider } from "../widgets/Slider";

/** The fields on the page by the JSON pointers of the contract, without numbers: "/tufts/diameter". */
export class Fields {
  private sliders: { readonly field: string; readonly slider: Slider }[] = [];

  /** Counts the panels that came, for those who show problems. */
  readonly changed = new Signal(0);

  add(field: string, slider: Slider): Slider {
    this.sliders.push({ field, slider });
    return slider;
  }

  /** Another panel is there with all its fields. */
  announce(): void {
    this.changed.value++;
  }

  /** Another panel comes. */
  clear(): void {
    this.sliders = [];
  }

  /** Shows each fault of a problem at its field. @return  whether the first one has a field that is on show */
  show(problem: ServiceProblem | null): boolean {
    const faults = (problem?.fields ?? []).map((fault) => ({ field: this.fieldOf(fault.pointer), text: faultText(fault) }));
    let isShown = false;
    for (const { field, slider } of this.sliders) {
      const fault = faults.find((one) => one.field === field);
      slider.showProblem(fault?.text ?? null);
      if (fault === faults[0] && fault && slider.element.checkVisibility()) isShown = true;
    }
    return isShown;
  }

  /** A problem of a query names a field by its last word: "?amplitude". */
  private fieldOf(pointer: string): string {
    if (!pointer.startsWith("?")) return pointer.replace(/\/\d+/g, "");
    return this.sliders.find(({ field }) => field.endsWith(`/${pointer.slice(1)}`))?.field ?? pointer;
  }
}
