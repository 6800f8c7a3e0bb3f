"use strict";
// Each formula of the page, as TeX until this has run.
document.addEventListener("DOMContentLoaded", () => {
  for (const place of document.querySelectorAll(".math"))
    katex.render(place.textContent, place, { displayMode: place.classList.contains("display"), throwOnError: false });
});
