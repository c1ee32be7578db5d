// Search through SECTIONS, which stands above: every word typed must begin a word of the section.
"use strict";

const MOST = 12;
const AROUND = 70; // letters shown before and after the first word found
const field = document.getElementById("search");
const list = document.getElementById("found");
let chosen = -1;

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
const begins = (word) => new RegExp(`(?<![\\p{L}\\p{N}])${escaped(word)}`, "giu");
const count = (text, word) => (text.match(begins(word)) || []).length;

function score(section, words) {
  let sum = 0;
  for (const word of words) {
    const found =
      20 * count(section.heading, word) + 8 * count(section.title, word) + Math.min(count(section.text, word), 5);
    if (found === 0) return 0;
    sum += found;
  }
  return sum;
}

function marked(text, words) {
  const part = document.createElement("span");
  const all = new RegExp(words.map((word) => begins(word).source).join("|"), "giu");
  let last = 0;
  for (const hit of text.matchAll(all)) {
    part.append(text.slice(last, hit.index));
    const mark = document.createElement("mark");
    mark.textContent = hit[0];
    part.append(mark);
    last = hit.index + hit[0].length;
  }
  part.append(text.slice(last));
  return part;
}

function excerpt(section, words) {
  const first = Math.min(...words.map((word) => section.text.search(begins(word))).filter((at) => at >= 0));
  if (!Number.isFinite(first)) return section.text.slice(0, 2 * AROUND);
  const from = Math.max(0, first - AROUND);
  return (from ? "..." : "") + section.text.slice(from, first + AROUND) + "...";
}

function row(section, words) {
  const item = document.createElement("li");
  const link = document.createElement("a");
  link.href = `${section.page}.html#${section.anchor}`;
  link.addEventListener("click", close); // a section of this page: nothing is loaded
  const where = section.heading === section.title ? section.title : `${section.title}: ${section.heading}`;
  const below = document.createElement("small");
  link.append(marked(where, words));
  below.append(marked(excerpt(section, words), words));
  link.append(below);
  item.append(link);
  return item;
}

function show() {
  const words = field.value.trim().split(/\s+/).filter(Boolean);
  chosen = -1;
  list.replaceChildren();
  list.hidden = words.length === 0;
  if (list.hidden) return;
  const found = SECTIONS.map((section) => [score(section, words), section]).filter(([points]) => points > 0);
  found.sort((a, b) => b[0] - a[0]);
  list.append(...found.slice(0, MOST).map(([, section]) => row(section, words)));
  if (found.length === 0) {
    const none = document.createElement("li");
    none.append(Object.assign(document.createElement("p"), { textContent: "No page has all of these words." }));
    list.append(none);
  }
}

function close() {
  list.hidden = true;
}

function choose(by) {
  const rows = [...list.querySelectorAll("a")];
  if (rows.length === 0) return;
  chosen = (chosen + by + rows.length) % rows.length;
  rows.forEach((link, at) => link.parentElement.classList.toggle("chosen", at === chosen));
  rows[chosen].scrollIntoView({ block: "nearest" });
}

field.hidden = false;
field.addEventListener("input", show);
field.addEventListener("focus", show);
field.addEventListener("keydown", (event) => {
  if (event.key === "ArrowDown" || event.key === "ArrowUp") {
    event.preventDefault();
    choose(event.key === "ArrowDown" ? 1 : -1);
  } else if (event.key === "Enter") {
    list.querySelectorAll("a")[Math.max(chosen, 0)]?.click();
  } else if (event.key === "Escape") {
    field.blur();
    close();
  }
});
document.addEventListener("keydown", (event) => {
  if (event.key === "/" && document.activeElement !== field) {
    event.preventDefault();
    field.focus();
  }
});
document.addEventListener("click", (event) => {
  if (!event.target.closest(".search")) close();
});
// all pages beside the text where there is room for them
const broad = window.matchMedia("(min-width: 56.01rem)");
const unfold = () => { document.getElementById("pages").open = broad.matches; };
broad.addEventListener("change", unfold);
unfold();
