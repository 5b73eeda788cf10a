import { hairstyle, twoTufts } from "./hairstyles.mjs";

const kCanvas = ".stage-canvas";

async function pickBoth(studio) {
  await studio.press("2");
  await studio.row("left").click();
  await studio.row("right").click({ modifiers: ["Control"] });
  await studio.press("3");
  await studio.page.locator(".panel .primary:enabled").waitFor();
}

const move = (studio, [x, y]) => studio.at(x, y).then((place) => studio.page.mouse.move(...place, { steps: 3 }));

async function press(studio, ...places) {
  await move(studio, places[0]);
  await studio.page.mouse.down();
  for (const place of places.slice(1)) await move(studio, place);
}

/**
 * Every state of the page that people should look at, in groups that share a page, in the order in which one leads to the next.
 * They go by keys and classes, since they are shown in each language. `kept`: what was there before; `show`: leads to the state from the one
 * before it; `leave`: what to do after the picture.
 */
export const stateGroups = [
  {
    kept: null,
    states: [
      { name: "empty", show: async () => {} },
      { name: "hover", show: (studio) => move(studio, [-0.04, -0.2]) },
      { name: "freehand", show: (studio) => press(studio, [-0.06, -0.2], [-0.12, -0.12], [-0.14, 0.02]), leave: (studio) => studio.page.mouse.up() },
      {
        name: "point-by-point",
        show: async (studio) => {
          for (const [x, y] of [[0.02, -0.22], [0.02, -0.12], [0.06, -0.02]]) {
            await studio.click(x, y);
            await move(studio, [x + 0.03, y + 0.04]);
          }
        },
        leave: (studio) => studio.press("Escape"),
      },
      {
        name: "server-away",
        show: async (studio, server) => {
          studio.watch.allow(/ERR_/);
          await server.stop();
          await studio.draw([0, -0.22], [0.02, -0.1], [0.02, 0]);
          await studio.page.locator(".stage-away").waitFor();
        },
        leave: (_studio, server) => server.start(),
      },
    ],
  },
  {
    kept: hairstyle(twoTufts()),
    states: [
      {
        name: "shape",
        show: async (studio) => {
          await studio.press("2");
          await studio.row("left").click();
        },
      },
      {
        name: "problem",
        show: async (studio) => {
          studio.watch.allow(/status of 422/);
          await studio.page.locator('[data-field="/tufts/diameter"] input[type=number]').fill("500");
          await studio.page.locator(".field-problem:visible").first().waitFor();
        },
        leave: async (studio) => {
          await studio.page.locator(kCanvas).focus();
          await studio.press("Control+z");
        },
      },
      { name: "fill-preview", show: pickBoth },
      { name: "filled", show: (studio) => studio.page.locator(".panel .primary").click() },
      { name: "move", show: (studio) => studio.press("4") },
      {
        name: "sheet",
        show: async (studio) => {
          await studio.page.locator(".sheet-slider").focus();
          await studio.press("Home", "ArrowUp", "ArrowUp");
        },
      },
      { name: "onion", show: (studio) => studio.page.locator(".transport-button.onion").click(), leave: (studio) => studio.page.locator(".transport-button.onion").click() },
      { name: "compare", show: (studio) => studio.page.locator(".transport-button.compare").click(), leave: (studio) => studio.page.locator(".transport-button.compare").click() },
      { name: "gallery", show: (studio) => studio.page.getByRole("button", { name: /^(Gallery|ギャラリー)$/ }).click(), leave: (studio) => studio.press("Escape") },
      { name: "take-away", show: (studio) => studio.press("Control+s"), leave: (studio) => studio.press("Escape") },
      { name: "help", show: (studio) => studio.press("?"), leave: (studio) => studio.press("Escape") },
    ],
  },
];
