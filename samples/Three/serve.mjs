// Serves this folder on 127.0.0.1:  npm start
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const folder = fileURLToPath(new URL(".", import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".json": "application/json", ".wasm": "application/wasm" };

/** Serves the folder. Each JSON body that the page posts goes to `receive`. */
export function serve(port, receive) {
  const server = createServer((request, response) => {
    if (request.method === "POST" && receive) {
      const parts = [];
      request.on("data", part => parts.push(part)).on("end", () => {
        response.end();
        receive(JSON.parse(Buffer.concat(parts)));
      });
      return;
    }
    const path = decodeURIComponent(new URL(request.url, "http://page").pathname), file = normalize(join(folder, path.endsWith("/") ? path + "index.html" : path));
    if (!file.startsWith(folder) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "Content-Type": types[extname(file)] ?? "application/octet-stream" });
    createReadStream(file).pipe(response);
  });
  return new Promise(done => server.listen(port, "127.0.0.1", () => done(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(8080);
  console.log(`http://127.0.0.1:${server.address().port}/`);
}
