// Shows the claims in which every word typed begins a word, of the statuses that are pressed (none: of all).
"use strict";

const field = document.getElementById("search");
const buttons = [...document.querySelectorAll("button[data-status]")];
const articles = [...document.querySelectorAll("article.claim")];
const claims = articles.map((element) => ({ element, text: element.textContent }));

function show() {
  const words = field.value.split(/\s+/).filter(Boolean);
  const begins = words.map((w) => new RegExp(`(?<![\\p{L}\\p{N}])${w.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}`, "iu"));
  const wanted = buttons.filter((b) => b.ariaPressed === "true").map((b) => b.dataset.status);
  let count = 0;
  for (const { element, text } of claims) {
    const fits = (!wanted.length || wanted.includes(element.dataset.status)) && begins.every((w) => w.test(text));
    element.hidden = !fits;
    count += fits;
  }
  for (const section of document.querySelectorAll("section.paper"))
    section.hidden = !section.querySelector("article.claim:not([hidden])");
  document.getElementById("shown").textContent = `${count} of ${claims.length}`;
}

field.hidden = false; // without scripts there is nothing to type into
field.addEventListener("input", show);
for (const button of buttons)
  button.addEventListener("click", () => {
    button.ariaPressed = String(button.ariaPressed !== "true");
    show();
  });
show();
