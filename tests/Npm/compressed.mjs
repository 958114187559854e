// The bytes of the files that a page loads from the package, each compressed with brotli as by a web server:
//   node tests/Npm/compressed.mjs PACKAGE
import { readdirSync, readFileSync } from "node:fs";
import { brotliCompressSync } from "node:zlib";

const folder = process.argv[2], files = ["index.js", ...readdirSync(`${folder}/runtime`).map(name => `runtime/${name}`)];
console.log(files.reduce((sum, name) => sum + brotliCompressSync(readFileSync(`${folder}/${name}`)).length, 0));
