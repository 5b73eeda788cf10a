// Hair by name: the request, and what the service makes of it.
import { readFile } from "node:fs/promises";

import { requestNamed } from "./requests.mjs";
import { kUploads } from "./uploads.mjs";

async function post(url, type, body) {
  const answer = await fetch(url, { method: "POST", headers: { "Content-Type": type, Accept: "model/gltf-binary" }, body });
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
