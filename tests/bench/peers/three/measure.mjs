// How a peer in Node.js prints its times: lines as tests/bench/bench.py reads them.
const WARMING = 2; // calls, by which the hot loops are compiled
const MEASURED = 2;

export async function measure(name, work) {
  for (let call = 0; call < WARMING; call++) await work();
  const ms = [];
  for (let call = 0; call < MEASURED; call++) {
    const begun = performance.now();
    await work();
    ms.push(performance.now() - begun);
  }
  console.log(JSON.stringify({ name, ms }));
}

/** The first call in a process, which pays for compiling: what a tool that is started for one clip waits. */
export async function measureCold(name, work) {
  const begun = performance.now();
  await work();
  console.log(JSON.stringify({ name, ms: [performance.now() - begun] }));
}

export const printValue = (name, value, unit) => console.log(JSON.stringify({ name, value: [value], unit }));
