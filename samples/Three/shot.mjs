// Plays the kicks of scene.json in Chromium, compares events and hashes with golden.txt, and writes a picture:
//   npm run shot [-- FILE.png]
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { serve } from "./serve.mjs";

const file = process.argv[2] ?? "shot.png", browser = process.env.CHROMIUM ?? "chromium-headless-shell";
const profile = mkdtempSync(join(tmpdir(), "three-"));
let chromium = null, timer = null;
const result = await new Promise((done, failed) => {
  serve(0, done).then(server => {
    chromium = spawn(browser, [
      "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--remote-debugging-port=0", "--window-size=1280,720", "--hide-scrollbars",
      "--enable-logging=stderr", `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/?shot`,
    ], { stdio: ["ignore", "ignore", "pipe"], detached: true });
    chromium.on("error", failed);
    chromium.stderr.on("data", text => { if (/CONSOLE.*(Uncaught|Error)/.test(text)) failed(new Error(String(text))); });
    timer = setTimeout(() => failed(new Error("The page sent no result within 120 s.")), 120_000);
    chromium.on("close", () => { server.close(); server.closeAllConnections(); });
  }, failed);
}).finally(() => {
  clearTimeout(timer);
  // The program may be a script that starts the browser, so end its entire process group.
  try { process.kill(-chromium.pid); } catch { /* It has ended. */ }
});
await new Promise(done => chromium.exitCode === null && chromium.signalCode === null ? chromium.on("close", done) : done());
rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
writeFileSync(file, Buffer.from(result.png.split(",")[1], "base64"));
console.log(result.lines.join("\n"));
console.log(`first ball after ${Math.round(result.firstBall)} ms; ${file}`);
if (result.lines.at(-1) !== `hash ${result.inWorker}`) {
  console.error(`The worker has another hash: ${result.inWorker}`);
  process.exit(1);
}
const golden = readFileSync(new URL("./golden.txt", import.meta.url), "utf8").trim();
if (result.lines.join("\n") !== golden) {
  console.error(`golden.txt has other lines:\n${golden}`);
  process.exit(1);
}
