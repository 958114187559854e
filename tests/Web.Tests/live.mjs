// Runs descriptions of live examples as the pages do, with live.js and the npm package, and prints the path and the results of each as one line of JSON.
//   node live.mjs LIVE.JS PACKAGE < descriptions, one a line
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const [script, folder] = process.argv.slice(2), { load } = await import(pathToFileURL(`${folder}/index.js`).href);
const examples = new Function(`${readFileSync(script, "utf8")}; return LiveExamples;`)(), physics = await load();
for await (const line of createInterface({ input: process.stdin })) {
  const { example, values } = JSON.parse(line);
  const { rows, shown } = examples.run(physics, examples.described(example, values));
  console.log(JSON.stringify({ rows, shown: shown.map(([name, value]) => [name, value ?? null]) }));
}
