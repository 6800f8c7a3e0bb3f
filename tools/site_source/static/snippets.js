"use strict";
// The search asks for a page to show some words of it; they stand in texts.js.
Search.htmlToText = text => text;
window.fetch = url => Promise.resolve({
  text: () => TEXTS[decodeURIComponent(String(url)).replace(/^(\.\.?\/)*/, "").replace(/\.html$/, "")] || "" });
