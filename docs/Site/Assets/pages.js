// A link to each heading, seen when the pointer is on it; members have theirs from the generator.
for (const heading of document.querySelectorAll("main :is(h2, h3)[id]")) {
  const link = Object.assign(document.createElement("a"), { className: "anchor", href: `#${heading.id}`, textContent: "#" });
  link.setAttribute("aria-label", `Link to ${heading.textContent}`);
  heading.append(link);
}

// Code in colours, and a button that copies it.
const KEYWORDS = "using|var|new|foreach|for|while|if|else|in|is|and|or|not|return|class|sealed|record|struct|public|private|internal|static|readonly|const|double|int|bool|string|byte|long|ulong|null|true|false|with|switch|break|continue|out|ref|default|get|set|init|namespace|void|this|base|override";
const TOKENS = new RegExp(`(//[^\\n]*)|(\\$?"(?:\\\\.|[^"\\\\])*")|\\b(${KEYWORDS})\\b|\\b(\\d[\\d_]*(?:\\.\\d+)?(?:e-?\\d+)?)\\b|\\b([A-Z][A-Za-z0-9]*)\\b`, "g");
const KINDS = ["comment", "string", "keyword", "number", "type"];

for (const code of document.querySelectorAll("pre > code")) {
  const text = code.textContent;
  if (code.className.includes("csharp")) {
    const parts = [];
    let at = 0;
    for (const match of text.matchAll(TOKENS)) {
      parts.push(text.slice(at, match.index));
      const span = document.createElement("span");
      span.className = KINDS[match.slice(1).findIndex(x => x !== undefined)];
      span.textContent = match[0];
      parts.push(span);
      at = match.index + match[0].length;
    }
    parts.push(text.slice(at));
    code.replaceChildren(...parts);
  }
  if (code.className.includes("language-text")) continue;
  const button = Object.assign(document.createElement("button"), { type: "button", className: "copy", textContent: "copy" });
  button.addEventListener("click", async () => {
    await navigator.clipboard.writeText(text);
    button.textContent = "copied";
    setTimeout(() => { button.textContent = "copy"; }, 1500);
  });
  const frame = document.createElement("div");
  frame.className = text.trimEnd().includes("\n") ? "code" : "code line";
  const block = code.parentElement;
  block.replaceWith(frame);
  frame.append(block, button);
}

// One tab for each language. The choice holds for all pages; without a program in that language, the first tab is shown.
const stored = (name, value) => { try { if (value === undefined) return localStorage.getItem(name); localStorage.setItem(name, value); } catch { /* some browsers forbid storage */ } return null; };
const groups = [...document.querySelectorAll(".tabs")].map(group => {
  const tabs = [...group.children], list = document.createElement("div");
  list.setAttribute("role", "tablist");
  const buttons = tabs.map(tab => {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: tab.dataset.language });
    button.setAttribute("role", "tab");
    tab.setAttribute("role", "tabpanel");
    button.addEventListener("click", () => {
      const top = button.getBoundingClientRect().top;
      stored("language", tab.dataset.language);
      choose(tab.dataset.language);
      // Tabs above this one change their heights too.
      scrollBy(0, button.getBoundingClientRect().top - top);
    });
    return button;
  });
  list.addEventListener("keydown", e => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[e.key], at = buttons.indexOf(document.activeElement);
    if (!step || at < 0) return;
    const next = buttons[(at + step + buttons.length) % buttons.length];
    next.click();
    next.focus();
  });
  list.append(...buttons);
  group.prepend(list);
  return { tabs, buttons };
});

function choose(language) {
  for (const { tabs, buttons } of groups) {
    const shown = Math.max(0, tabs.findIndex(tab => tab.dataset.language === language));
    tabs.forEach((tab, i) => {
      tab.hidden = i !== shown;
      buttons[i].setAttribute("aria-selected", String(i === shown));
      buttons[i].tabIndex = i === shown ? 0 : -1;
    });
  }
}
choose(stored("language"));

// The theme is that of the system until somebody chooses.
document.getElementById("theme").addEventListener("click", () => {
  const root = document.documentElement, isDark = getComputedStyle(root).colorScheme === "dark";
  root.dataset.theme = isDark ? "light" : "dark";
  stored("theme", root.dataset.theme);
});
