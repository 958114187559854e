// Runs the programs of docs/javascript.md, and compares what they print with the page. With --write, writes it there.
import { readFileSync, writeFileSync } from "node:fs";
import { load } from "football-physics";

const page = process.argv[2], text = readFileSync(page, "utf8"), physics = await load();
let wrong = 0, count = 0;
const pieces = text.split(/(^```js\n[^]*?^```\n\n^```text\n[^]*?^```\n)/m);
for (let i = 1; i < pieces.length; i += 2) {
  const [, code, printed] = /^```js\n([^]*?)^```\n\n^```text\n([^]*?)^```\n$/m.exec(pieces[i]), lines = [];
  // The imports and the first line of the first program are here already.
  const body = code.replace(/^import .*\n/m, "").replace(/^const physics = await load\(\);\n/m, "");
  new Function("physics", "console", body)(physics, { log: line => lines.push(line) });
  count++;
  const said = lines.map(line => line + "\n").join("");
  if (said !== printed) {
    wrong++;
    console.error(`${page}: a program prints\n${said}instead of\n${printed}`);
  }
  pieces[i] = pieces[i].replace("```text\n" + printed, () => "```text\n" + said);
}
if (process.argv[3] === "--write") writeFileSync(page, pieces.join("")); else if (wrong > 0 || count === 0) process.exit(1);
console.log(`${count} programs of ${page} print what the page says`);
