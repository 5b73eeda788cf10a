// Hair by name: the request, and what the service makes of it.
import { readFile } from "node:fs/promises";

import { requestNamed } from "./requests.mjs";
import { kUploads } from "./uploads.mjs";

async function post(url, type, body, accept = "model/gltf-binary") {
  const answer = await fetch(url, { method: "POST", headers: { "Content-Type": type, Accept: accept }, body });
  if (!answer.ok) throw new Error(`${answer.status} ${await answer.text()}`);
  return Buffer.from(await answer.arrayBuffer());
}

/** @return  a function from "NAME.json" to the request and from "NAME.glb" to the answer */
export function hairFrom(url) {
  return async (file) => {
    const [name, extension] = file.split(".");
    if (name in kUploads) {
      const { file, query } = kUploads[name];
      return post(`${url}/v1/characters/motion?${new URLSearchParams(query)}`, "model/gltf-binary", await readFile(file));
    }
    const body = await requestNamed(name);
    return extension === "json" ? Buffer.from(body) : post(`${url}/v1/hairstyles`, "application/json", body);
  };
}

/** @return  the hairstyle with the tufts of its fills among its tufts, and without fills */
export async function fillsKept(url, { fills = [], ...hairstyle }) {
  const tuft = (wanted) => hairstyle.tufts.find(({ name }) => name === wanted);
  const tufts = [...hairstyle.tufts];
  for (const fill of fills) {
    const body = JSON.stringify({ head: hairstyle.head, fill: { ...fill, from: tuft(fill.from), to: tuft(fill.to) } });
    tufts.push(...JSON.parse(await post(`${url}/v1/fills`, "application/json", body, "application/json")).tufts);
  }
  return { ...hairstyle, tufts };
}
