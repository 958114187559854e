// Checks the workflows with GitHub's own language service; and each action must be pinned by the hash of a commit.
//   npm ci --prefix tests/Workflows && npm test --prefix tests/Workflows
import { readFileSync, readdirSync } from "node:fs";
import { validate } from "@actions/languageservice";
import { TextDocument } from "vscode-languageserver-textdocument";

// npm starts a script in the folder of its package.json.
const folder = "../../.github/workflows/";
const files = readdirSync(folder).filter(name => name.endsWith(".yml"));
let faults = 0;

function report(file, line, message) {
  faults++;
  console.error(`${file}:${line}: ${message}`);
}

async function check(file) {
  const text = readFileSync(folder + file, "utf8");
  for (const fault of await validate(TextDocument.create(`file:///.github/workflows/${file}`, "yaml", 1, text))) {
    report(file, fault.range.start.line + 1, fault.message);
  }

  text.split("\n").forEach((line, i) => {
    const used = /^\s*-?\s*uses:\s*(\S+)/.exec(line);
    if (used && !used[1].startsWith("./") && !/@[0-9a-f]{40}$/.test(used[1])) {
      report(file, i + 1, `${used[1]} is not pinned by the hash of a commit`);
    }
  });
}

Promise.all(files.map(check)).then(() => {
  console.log(`${files.length} workflows, ${faults} faults`);
  process.exitCode = faults === 0 && files.length > 0 ? 0 : 1;
});
