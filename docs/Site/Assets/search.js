const search = document.getElementById("search");
const found = document.getElementById("found");
const words = text => text.toLowerCase().split(/[^\p{L}\p{N}_.]+/u).filter(w => w.length > 0);

// A section counts for how often the words stand in it; in a heading they count more, and all of them must be there.
function look(query) {
  const wanted = words(query);
  if (wanted.length === 0) return [];
  return SECTIONS.map(([page, heading, address, text]) => {
    const [head, body] = [`${page} ${heading}`.toLowerCase(), text.toLowerCase()];
    const counts = wanted.map(w => 8 * (head.split(w).length - 1) + Math.min(5, body.split(w).length - 1));
    return { page, heading, address, text, score: counts.includes(0) ? 0 : counts.reduce((a, b) => a + b) };
  }).filter(s => s.score > 0).sort((a, b) => b.score - a.score).slice(0, 12);
}

function snippet(text, query) {
  const at = Math.max(0, text.toLowerCase().indexOf(words(query)[0]) - 40);
  return (at > 0 ? "…" : "") + text.slice(at, at + 160);
}

function show() {
  const results = look(search.value);
  found.hidden = search.value.trim() === "";
  found.replaceChildren(...results.map(r => {
    const item = document.createElement("li");
    const link = Object.assign(document.createElement("a"), { href: r.address });
    link.append(r.heading === r.page ? r.page : `${r.page}: ${r.heading}`);
    link.append(Object.assign(document.createElement("small"), { textContent: snippet(r.text, search.value) }));
    item.append(link);
    return item;
  }));
  if (results.length === 0) found.append(Object.assign(document.createElement("li"), { textContent: "Nothing found." }));
}

search.addEventListener("input", show);
document.addEventListener("keydown", e => {
  if (e.key === "/" && document.activeElement !== search) { search.focus(); e.preventDefault(); }
  if (e.key === "Escape") { search.value = ""; show(); }
  if (e.key === "Enter" && document.activeElement === search && found.querySelector("a")) found.querySelector("a").click();
  if ((e.key === "ArrowDown" || e.key === "ArrowUp") && !found.hidden) {
    const links = [...found.querySelectorAll("a")];
    const next = links.indexOf(document.activeElement) + (e.key === "ArrowDown" ? 1 : -1);
    if (next < 0) search.focus(); else links[Math.min(next, links.length - 1)]?.focus();
    e.preventDefault();
  }
});
document.addEventListener("click", e => { if (!found.contains(e.target) && e.target !== search) found.hidden = true; });
if (matchMedia("(max-width: 800px)").matches) document.querySelector("nav details").open = false;
