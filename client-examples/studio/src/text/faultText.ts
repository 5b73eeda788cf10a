import type { FieldError } from "../api/contract";
import { language } from "./language";
import { problemText } from "./problemText";

/** A fault in one sentence: the service's own, or in the page's language with the value and what is allowed. */
export function faultText({ code, detail, value, allowed }: FieldError): string {
  const words = problemText[language.value];
  if (!words) return detail;
  const given = value === undefined ? "" : `：${JSON.stringify(value)}`;
  return `${words[code]}${given}${allowed ? `（${allowed.replace(/ to /, "〜")}）` : ""}`;
}
