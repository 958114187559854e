// The bytes of the files that a page loads from the package, each compressed with brotli as by a web server:
//   node tests/Npm/compressed.mjs PACKAGE
import { readdirSync, readFileSync } from "node:fs";
import { promisify } from "node:util";
import { brotliCompress } from "node:zlib";

const folder = process.argv[2], files = ["index.js", ...readdirSync(`${folder}/runtime`).map(name => `runtime/${name}`)];
const packed = await Promise.all(files.map(name => promisify(brotliCompress)(readFileSync(`${folder}/${name}`))));
console.log(packed.reduce((sum, bytes) => sum + bytes.length, 0));
