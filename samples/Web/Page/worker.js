// The game in a worker of its own: the page never waits for it. It gets the files of the npm package and then calls by name; of calls that only the
// newest counts of ("latest"), older ones are dropped unanswered.
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

// One call a turn, so that calls which came in the meantime are seen before the next.
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
