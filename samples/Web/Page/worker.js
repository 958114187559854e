// Runs the game in its own worker, so that the page never waits. It receives the files of the npm package, and then calls by name. Of the calls marked "latest",
// only the newest counts: older ones are dropped without a result.
let playground = null;
const waiting = [];

async function start({ files, keeper }) {
  const { load } = await import(URL.createObjectURL(new Blob([files["index.js"]], { type: "text/javascript" })));
  playground = new Playground(await load({ files }), keeper);
}

function answer({ id, call, args }) {
  try {
    postMessage({ id, value: playground[call](...args) });
  } catch (e) {
    postMessage({ id, error: String(e.message || e) });
  }
}

// Process one call per turn, so that calls that arrive in the meantime are queued before the next one.
function next() {
  const job = waiting.shift();
  if (job) answer(job);
  if (waiting.length > 0) setTimeout(next, 0);
}

onmessage = async e => {
  if (e.data.files) {
    await start(e.data).then(() => postMessage({ ready: true }), error => postMessage({ failed: String(error.message || error) }));
    return;
  }
  if (e.data.latest) {
    const older = waiting.findIndex(job => job.latest === e.data.latest);
    if (older >= 0) postMessage({ id: waiting.splice(older, 1)[0].id, dropped: true });
  }
  waiting.push(e.data);
  if (waiting.length === 1) setTimeout(next, 0);
};
