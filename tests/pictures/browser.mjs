// Headless Chromium.
import { chromium } from "playwright-core";

const kArguments = [
  "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--force-color-profile=srgb", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

/** @return  a browser, whose pages are made by newPage below */
export const openBrowser = () => chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: kArguments });

/** A page that says on the terminal what goes wrong in it. @param options  as playwright's newPage takes them */
export async function newPage(browser, options = {}) {
  const page = await browser.newPage(options);
  page.on("console", (message) => message.type() === "error" && console.error(`page: ${message.text()}`));
  page.on("pageerror", (error) => console.error(`page: ${error.stack}`));
  return page;
}
