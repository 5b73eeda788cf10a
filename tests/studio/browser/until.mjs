import { setTimeout as pause } from "node:timers/promises";

const kAskAgain_ms = 30;

/**
 * Waits until `ask` gives something true, and returns it.
 * @param what  what is waited for, for the error
 * @throws Error after `timeout_ms`
 */
export async function until(what, ask, timeout_ms = 10_000) {
  const end = Date.now() + timeout_ms;
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (Date.now() > end) throw new Error(`waited ${timeout_ms / 1000} s in vain: ${what}`);
    await pause(kAskAgain_ms);
  }
}
