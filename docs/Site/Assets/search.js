const search = document.getElementById("search");
const found = document.getElementById("found");
const words = text => text.toLowerCase().split(/[^\p{L}\p{N}_.]+/u).map(w => w.replace(/^\.+|\.+$/g, "")).filter(w => w.length > 0);

// What everybody writes in a question says nothing of where the answer is.
const COMMON = new Set("a an the i my me you your we it its is are be can could do does did how what when where which who why will would should to of in on at for with by from and or not no so as that this there have has get make use want need".split(" "));

// Words of players and viewers, and the words of these pages for the same.
const SAME = {
  xg: "chance goal xg", probability: "chance", odds: "chance", shootout: "penalty", penalties: "penalty", volley: "firsttimeshot", kickoff: "kick-off restart", restart: "kick-off", soccer: "football",
  curve: "curl bend", swerve: "curl bend", goalie: "keeper", goalkeeper: "keeper", tunnelling: "passes through", tunneling: "passes through", lag: "rollback", desync: "desync", multiplayer: "network", gc: "allocation garbage",
  dropped: "restart kick-off", threejs: "three.js", love: "lua", replay: "recording", bounciness: "bounce restitution", install: "install", error: "misses", trajectory: "path", header: "head",
};

// Words are the same whatever their ending.
const stem = w => w.length > 4 ? w.replace(/(ies)$/, "y").replace(/(ings?|ers?|ed|es|s|ly)$/, "").replace(/([bdglmnprt])\1$/, "$1") : w.replace(/s$/, "");
let INDEX = null;
const KNOWN = new Map();

// The words of all pages are as large as twenty pages, so they are loaded at the first search.
let loading = null;
function prepare() {
  return loading ??= new Promise(done => {
    const script = Object.assign(document.createElement("script"), { src: "search-index.js" });
    script.onload = () => { INDEX = SECTIONS.map(count); for (const { counts } of INDEX) for (const w of counts.keys()) KNOWN.set(w, (KNOWN.get(w) || 0) + 1); done(); };
    document.head.append(script);
  });
}

function count([page, heading, address, text]) {
  const counts = new Map();
  const add = (from, weight) => words(from).forEach(w => counts.set(stem(w), (counts.get(stem(w)) || 0) + weight));
  // A member is found by its name with or without its type. Without the type, only a name of several words is certainly no other word.
  const isMember = address.startsWith("api-") && address.includes("#"), bare = heading.split(/[. ]/).pop();
  const names = isMember ? [heading, bare].filter(name => /[.]|[a-z][A-Z]/.test(name)) : [heading];
  names.forEach(name => add(name, 100));
  add(page, 4);
  add(text, 1);
  return { page, heading, address, text, counts, length: words(text).length, isMember, names: names.map(name => stem(name.toLowerCase())) };
}

// How much a word counts in a section: rare words more than common ones, in a heading more than below it, and again and again only a little more.
function weight(section, w) {
  let n = section.counts.get(w) || 0;
  if (n === 0 && w.length > 3) for (const [k, c] of section.counts) if (k.includes(".") === w.includes(".") && (k.startsWith(w) || (k.length > 4 && w.startsWith(k)))) n = Math.max(n, 0.4 * c);
  if (n === 0) return 0;
  const body = n % 100, rare = Math.log(1 + INDEX.length / (KNOWN.get(w) || 3));
  return rare * ((n >= 40 ? 3 : 0) + body / (body + 0.6 + section.length / 400));
}

function look(query) {
  // "kick-off" and "shoot-out" are also one word.
  const joined = query.toLowerCase().replace(/(\p{L}+)-(\p{L}+)/gu, "$1$2"), added = words(joined).flatMap(w => words(SAME[w] || "")).filter(w => !words(query).includes(w)).map(stem);
  const all = words(query).map(stem), telling = words(query).filter(w => !COMMON.has(w)).map(stem), wanted = telling.length > 0 ? telling : all;
  if (wanted.length === 0) return [];
  return INDEX.map(section => {
    const each = wanted.map(w => weight(section, w)), met = each.filter(x => x > 0).length;
    const isNamed = !section.isMember || wanted.some((w, i) => section.names.includes(w) || (w.includes(".") && each[i] > 0));
    // An added word helps, but a page without it loses nothing. A word that no page has says nothing against a page with the added word.
    const more = added.map(w => weight(section, w)).reduce((a, b) => a + b, 0), share = wanted.every(w => !KNOWN.has(w)) && more > 0 ? 1 : (met / wanted.length) ** 2;
    // Guides answer questions; lists and pages for contributors come after them.
    const score = (/^(internals-|changelog|contents)/.test(section.address) ? 0.6 : 1) * (isNamed ? 1 : 0.5) * (each.reduce((a, b) => a + b, 0) + 0.6 * more) * share;
    return { ...section, score: section.heading.toLowerCase() === query.trim().toLowerCase() ? score + 20 : score };
  }).filter(s => s.score > 0).sort((a, b) => b.score - a.score).slice(0, 12);
}

function snippet(text, query) {
  const first = words(query).filter(w => !COMMON.has(w)).map(w => text.toLowerCase().indexOf(stem(w))).find(i => i >= 0);
  const at = Math.max(0, (first ?? 0) - 40);
  return (at > 0 ? "…" : "") + text.slice(at, at + 160);
}

async function show() {
  await prepare();
  const results = look(search.value);
  found.hidden = search.value.trim() === "";
  found.replaceChildren(...results.map(r => {
    const item = document.createElement("li");
    const link = Object.assign(document.createElement("a"), { href: r.address });
    link.append(r.isMember || r.heading === r.page ? r.heading : `${r.page}: ${r.heading}`);
    link.append(Object.assign(document.createElement("small"), { textContent: snippet(r.text, search.value) }));
    item.append(link);
    return item;
  }));
  document.body.dataset.searched = search.value;
  if (results.length === 0) found.append(Object.assign(document.createElement("li"), { textContent: "Nothing found." }));
}

// Only a device with a keyboard has the key.
if (matchMedia("(hover: hover) and (pointer: fine)").matches) search.placeholder = "Search (press /)";
search.addEventListener("focus", prepare);
search.addEventListener("input", show);
document.addEventListener("keydown", e => {
  if (e.key === "/" && document.activeElement !== search) { search.focus(); e.preventDefault(); }
  if (e.key === "Escape") { search.value = ""; show(); }
  if (e.key === "Enter" && document.activeElement === search) show().then(() => found.querySelector("a")?.click());
  if ((e.key === "ArrowDown" || e.key === "ArrowUp") && !found.hidden) {
    const links = [...found.querySelectorAll("a")];
    const next = links.indexOf(document.activeElement) + (e.key === "ArrowDown" ? 1 : -1);
    if (next < 0) search.focus(); else links[Math.min(next, links.length - 1)]?.focus();
    e.preventDefault();
  }
});
document.addEventListener("click", e => { if (!found.contains(e.target) && e.target !== search) found.hidden = true; });
if (matchMedia("(max-width: 800px)").matches) document.querySelectorAll(".pages details, aside details").forEach(part => { part.open = false; });
const menu = document.querySelector(".pages details"), current = menu.querySelector("[aria-current]");
if (current) menu.scrollTop = current.offsetTop - menu.clientHeight / 2;
