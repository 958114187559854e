// The library, in a worker of its own: the page never waits for it. It gets the runtime's files and then calls by name; of calls that only the
// newest counts of ("latest"), older ones are dropped unanswered.
globalThis.dotnetSidecar = true;

// Files that live in the page have addresses that nothing can be relative to.
globalThis.URL = class extends URL {
  constructor(url, base) { super(url, base && String(base).startsWith("blob:") ? "https://page.invalid/" : base); }
};

let library = null;
const waiting = [];

async function start(files) {
  const script = name => URL.createObjectURL(new Blob([files[name]], { type: "text/javascript" }));
  const { dotnet } = await import(script("dotnet.js"));
  // The interpreter's own compiler of often used traces is off: with it sums over four waves at once, as in gusts, have other bits than everywhere else.
  const runtime = await dotnet.withConfig({ runtimeOptions: ["--no-jiterpreter-traces-enabled"] }).withResourceLoader((type, name) =>
    name.endsWith(".js") ? script(name) : Promise.resolve(new Response(files[name], { headers: { "Content-Type": "application/wasm" } }))).create();
  library = (await runtime.getAssemblyExports("football-web.dll")).Playground;
}

function answer({ id, call, args }) {
  try {
    const value = library[call](...args);
    postMessage({ id, value });
  } catch (e) {
    postMessage({ id, error: String(e.message || e) });
  }
}

// One call a turn, so that calls which came in the meantime are seen before the next.
function next() {
  const job = waiting.shift();
  if (job) answer(job);
  if (waiting.length > 0) setTimeout(next, 0);
}

onmessage = async e => {
  if (e.data.files) {
    await start(e.data.files).then(() => postMessage({ ready: true }), error => postMessage({ failed: String(error.message || error) }));
    return;
  }
  if (e.data.latest) {
    const older = waiting.findIndex(job => job.latest === e.data.latest);
    if (older >= 0) postMessage({ id: waiting.splice(older, 1)[0].id, dropped: true });
  }
  waiting.push(e.data);
  if (waiting.length === 1) setTimeout(next, 0);
};
