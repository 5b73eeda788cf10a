// Hair by name: the request, and what the service makes of it.
import { requestNamed } from "./requests.mjs";

async function post(url, body) {
  const answer = await fetch(`${url}/v1/hairstyles`, {
    method: "POST",
    headers: { "Content-Type": "application/json", Accept: "model/gltf-binary" },
    body,
  });
  if (!answer.ok) throw new Error(`${answer.status} ${await answer.text()}`);
  return Buffer.from(await answer.arrayBuffer());
}

/** @return  a function from "NAME.json" to the request and from "NAME.glb" to the answer */
export function hairFrom(url) {
  return async (file) => {
    const [name, extension] = file.split(".");
    const body = await requestNamed(name);
    return extension === "json" ? Buffer.from(body) : post(url, body);
  };
}
