// node table.mjs SEED ROWS: the lines of JSON of all peers as a table.
import { readFileSync } from "node:fs";

const peers = readFileSync(process.argv[3], "utf8").trim().split("\n").map((line) => JSON.parse(line));
const number = (x, digits = 0) => x.toLocaleString("en-US", { maximumFractionDigits: digits, minimumFractionDigits: digits });
const dash = (x, text) => (x === null || x === undefined ? "–" : text(x));
const metres = (x) => (x === 0 ? "0" : x < 1e-6 ? "below 1 µm" : x < 1e-3 ? `${number(1e6 * x)} µm` : `${number(1000 * x, 1)} mm`);
const columns = [
  ["peer", (p) => `${p.name} ${p.version}`.trim()],
  ["build", (p) => p.build],
  ["1 ball, ns per frame", (p) => number(p.cost1)],
  ["10⁴ balls, ns per ball and frame", (p) => dash(p.cost10k, number)],
  ["bounce, m: frames of 5, 10, 16.7, 40 ms", (p) => dash(p.tops, (t) => t.map((x) => number(x, 2)).join(", "))],
  ["restitution of 200 drops", (p) => dash(p.reboundLow, () => `${number(p.reboundLow, 3)} to ${number(p.reboundHigh, 3)}`)],
  ["post without CCD, 60 Hz", (p) => dash(p.post60, String)],
  ["post without CCD, 240 Hz", (p) => dash(p.post240, String)],
  ["post with CCD, 60 Hz", (p) => dash(p.postCcd, String)],
  ["roll, m", (p) => dash(p.roll, (x) => number(x, 2))],
  ["predict 3 s, µs", (p) => number(p.predictUs)],
  ["prediction off by", (p) => metres(p.predictOff)],
  ["saved state, bytes", (p) => `${number(p.bytes)} (${p.saved})`],
  ["save and restore, ns", (p) => number(p.saveNs)],
  ["replay identical", (p) => `${p.again} of 20`],
  ["download, KiB with brotli", (p) => dash(p.kib, number)],
  ["from start to first step, ms", (p) => dash(p.loadMs, number)],
  ["second run identical", (p) => `${p.same} of 20`],
];

console.log(`Seed ${process.argv[2]}, node ${process.version}\n`);
// One row per quantity: more readable than one per peer.
console.log(`| | ${peers.map((p) => columns[0][1](p)).join(" | ")} |`);
console.log(`|---|${peers.map(() => "--:|").join("")}`);
for (const [title, cell] of columns.slice(1)) console.log(`| ${title} | ${peers.map(cell).join(" | ")} |`);
