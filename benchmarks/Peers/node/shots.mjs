// Writes the shots that every peer plays: node shots.mjs SEED > shots.txt
const seed = Number(process.argv[2] ?? 1);
let state = seed >>> 0;

// mulberry32: a number from 0 to 1.
function random() {
  state = (state + 0x6d2b79f5) >>> 0;
  let t = state;
  t = Math.imul(t ^ (t >>> 15), t | 1);
  t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
  return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
}

const between = (low, high) => (low + (high - low) * random()).toFixed(6);
const lines = [];
// The height of a ball that is dropped.
for (let i = 0; i < 200; i++) lines.push(`drop ${between(1.8, 2.2)}`);
// The sideways offset from the post and the distance from which the shot starts. The ball and the post touch below 0.17 m.
for (let i = 0; i < 1000; i++) lines.push(`post ${between(-0.12, 0.12)} ${between(0, 0.6667)}`);
// Velocity and spin of a kick.
for (let i = 0; i < 10000; i++) {
  lines.push(`kick ${between(-6, 6)} ${between(2, 10)} ${between(-28, -15)} ${between(-20, 20)} ${between(-40, 40)} ${between(-20, 20)}`);
}

console.log(lines.join("\n"));
