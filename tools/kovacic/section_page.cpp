#include "section_page.hpp"

#include "page_palette.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace kov::cli {
namespace {

constexpr const char* head = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>Section</title>
<style>
)html";

constexpr const char* body = R"html(</style>
</head>
<body>
<h1 id="title"></h1>
<canvas id="plane" tabindex="0" role="img"></canvas>
<p id="said" aria-live="polite"></p>
<p id="caption"></p>
<p id="help">Drag: move. Wheel or + and -: zoom. Click: an orbit. 0 or double click: everything.</p>
<script>
"use strict";
const scene = )html";

constexpr const char* script = R"html(
const canvas = document.getElementById("plane"), pen = canvas.getContext("2d");
const margin = { left: 70, right: scene.colour_label ? 90 : 16, top: 10, bottom: 45 };
const listed = () => dark.matches ? ["#c8d4e8", "#6ab0ff", "#62c47c", "#f0a850", "#ff7fa6", "#c49aff"]
                                  : ["#102040", "#0060c0", "#007020", "#b06000", "#a00040", "#6000a0"];
let view, chosen = -1;

const values = scene.orbits.map(o => o.value).filter(Number.isFinite);
const range = scene.logarithmic ? [0.1, 40] : [Math.min(...values), Math.max(...values)];
function part(value) {
  const scale = v => scene.logarithmic ? Math.log(Math.max(v, 1e-300)) : v;
  const [a, b] = range.map(scale);
  return b > a ? Math.min(1, Math.max(0, (scale(value) - a) / (b - a))) : 0;
}
const coloured = () => scene.orbits.map((o, i) =>
  scene.colour_label ? shade(Number.isFinite(o.value) ? part(o.value) : 0, scene.logarithmic) : listed()[i % 6]);
let colours = coloured();

function all() {
  let box = [Infinity, -Infinity, Infinity, -Infinity];
  for (const o of scene.orbits)
    for (let i = 0; i < o.points.length; i += 2)
      box = [Math.min(box[0], o.points[i]), Math.max(box[1], o.points[i]),
             Math.min(box[2], o.points[i + 1]), Math.max(box[3], o.points[i + 1])];
  if (!(box[1] >= box[0])) box = [-1, 1, -1, 1];
  const noise = 1e-12 * Math.max(...box.map(Math.abs)); // the section itself: 0 but for rounding
  const room = width => width > noise ? 0.04 * width : 1;
  const dx = room(box[1] - box[0]), dy = room(box[3] - box[2]);
  view = { x0: box[0] - dx, x1: box[1] + dx, y0: box[2] - dy, y1: box[3] + dy };
}
const width = () => canvas.clientWidth - margin.left - margin.right;
const height = () => canvas.clientHeight - margin.top - margin.bottom;
const toX = x => margin.left + (x - view.x0) / (view.x1 - view.x0) * width();
const toY = y => margin.top + (view.y1 - y) / (view.y1 - view.y0) * height();
const fromX = p => view.x0 + (p - margin.left) / width() * (view.x1 - view.x0);
const fromY = p => view.y1 - (p - margin.top) / height() * (view.y1 - view.y0);

function ticks(a, b) {
  const rough = (b - a) / 6, power = Math.pow(10, Math.floor(Math.log10(rough)));
  const step = power * [1, 2, 5, 10].find(m => m * power >= rough), found = [];
  for (let k = Math.ceil(a / step); k * step <= b; ++k)
    found.push({ at: k * step, text: String(Number((k * step).toPrecision(10))) });
  return found;
}
function axes() {
  pen.fillStyle = ink();
  pen.strokeStyle = "#8090a0";
  pen.font = "12px sans-serif";
  pen.strokeRect(margin.left, margin.top, width(), height());
  pen.textAlign = "center";
  for (const t of ticks(view.x0, view.x1)) {
    pen.fillRect(toX(t.at), margin.top + height(), 1, 5);
    pen.fillText(t.text, toX(t.at), margin.top + height() + 18);
  }
  pen.fillText(scene.labels[0], margin.left + width() / 2, margin.top + height() + 38);
  pen.textAlign = "right";
  for (const t of ticks(view.y0, view.y1)) {
    pen.fillRect(margin.left - 5, toY(t.at), 5, 1);
    pen.fillText(t.text, margin.left - 8, toY(t.at) + 4);
  }
  pen.save();
  pen.translate(14, margin.top + height() / 2);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText(scene.labels[1], 0, 0);
  pen.restore();
}
function legend() {
  if (!scene.colour_label || !values.length) return;
  const x = margin.left + width() + 14, h = height();
  for (let i = 0; i < h; ++i) {
    pen.fillStyle = shade(1 - i / h, scene.logarithmic);
    pen.fillRect(x, margin.top + i, 14, 1.5);
  }
  pen.fillStyle = ink();
  pen.textAlign = "left";
  for (const t of scene.logarithmic ? paletteTicks : range)
    pen.fillText(Number(t.toPrecision(3)), x + 18, Math.max(margin.top + 10, margin.top + (1 - part(t)) * h + 4));
  pen.save();
  pen.translate(x + 48, margin.top + h / 2);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText(scene.colour_label, 0, 0);
  pen.restore();
}
function dots(o, colour, size) {
  const alpha = pen.globalAlpha;
  pen.fillStyle = colour;
  for (let i = 0; i < o.points.length; i += 2) {
    if (i === 2 * o.right) pen.globalAlpha = 0.4 * alpha;
    pen.fillRect(toX(o.points[i]) - size / 2, toY(o.points[i + 1]) - size / 2, size, size);
  }
  pen.globalAlpha = alpha;
}
function draw() {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  pen.save();
  pen.beginPath();
  pen.rect(margin.left, margin.top, width(), height());
  pen.clip();
  pen.globalAlpha = chosen < 0 ? 1 : 0.25;
  scene.orbits.forEach((o, i) => { if (i !== chosen) dots(o, colours[i], 1.6); });
  pen.globalAlpha = 1;
  if (chosen >= 0) dots(scene.orbits[chosen], colours[chosen], 3.5);
  pen.restore();
  axes();
  legend();
  document.getElementById("said").textContent = chosen < 0 ? "" : scene.orbits[chosen].text;
}
function zoom(factor, px, py) {
  const x = fromX(px), y = fromY(py);
  view = { x0: x + (view.x0 - x) * factor, x1: x + (view.x1 - x) * factor,
           y0: y + (view.y0 - y) * factor, y1: y + (view.y1 - y) * factor };
  draw();
}
function move(dx, dy) {
  const x = dx / width() * (view.x1 - view.x0), y = dy / height() * (view.y1 - view.y0);
  view = { x0: view.x0 - x, x1: view.x1 - x, y0: view.y0 + y, y1: view.y1 + y };
  draw();
}
function choose(px, py) {
  let best = 12 * 12;
  chosen = -1;
  scene.orbits.forEach((o, k) => {
    for (let i = 0; i < o.points.length; i += 2) {
      const d = (toX(o.points[i]) - px) ** 2 + (toY(o.points[i + 1]) - py) ** 2;
      if (d < best) { best = d; chosen = k; }
    }
  });
  draw();
}
let held = null;
canvas.addEventListener("pointerdown", e => {
  held = { x: e.offsetX, y: e.offsetY, moved: false };
  try { canvas.setPointerCapture(e.pointerId); } catch (error) { /* the pointer is gone */ }
});
canvas.addEventListener("pointermove", e => {
  if (!held) return;
  const dx = e.offsetX - held.x, dy = e.offsetY - held.y;
  if (!held.moved && Math.hypot(dx, dy) < 4) return;
  held = { x: e.offsetX, y: e.offsetY, moved: true };
  move(dx, dy);
});
canvas.addEventListener("pointerup", e => {
  if (held && !held.moved) choose(e.offsetX, e.offsetY);
  held = null;
});
canvas.addEventListener("pointercancel", () => { held = null; });
canvas.addEventListener("wheel", e => {
  e.preventDefault();
  zoom(Math.pow(1.002, Math.max(-300, Math.min(300, e.deltaY))), e.offsetX, e.offsetY);
}, { passive: false });
canvas.addEventListener("dblclick", () => { all(); draw(); });
canvas.addEventListener("keydown", e => {
  const cx = margin.left + width() / 2, cy = margin.top + height() / 2;
  const keys = { "+": () => zoom(0.8, cx, cy), "-": () => zoom(1.25, cx, cy),
                 "0": () => { all(); draw(); }, Escape: () => { chosen = -1; draw(); },
                 ArrowLeft: () => move(40, 0), ArrowRight: () => move(-40, 0),
                 ArrowUp: () => move(0, 40), ArrowDown: () => move(0, -40) };
  if (!keys[e.key]) return;
  e.preventDefault();
  keys[e.key]();
});
window.addEventListener("resize", draw);
dark.addEventListener("change", () => { colours = coloured(); draw(); });
document.title = scene.title;
document.getElementById("title").textContent = scene.title;
document.getElementById("caption").textContent = scene.caption.join("\n");
canvas.setAttribute("aria-label", scene.title);
all();
draw();
</script>
</body>
</html>
)html";

// Text for a script element: no character of it can end that.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c :
       nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

std::string number(double x) { return std::isfinite(x) ? fmt::format("{:.6g}", x) : "null"; }

std::string orbit(const SectionPage::Orbit& o) {
  std::string points;
  std::size_t right = 0;
  for (std::size_t i = 0; i < o.points.size(); ++i) {
    const auto& [x, y] = o.points[i];
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    points += fmt::format("{}{:.6g},{:.6g}", points.empty() ? "" : ",", x, y);
    right += i < o.right ? 1 : 0;
  }
  return fmt::format("{{\"text\":{},\"value\":{},\"right\":{},\"points\":[{}]}}", quoted(o.text),
                     number(o.value), right, points);
}

} // namespace

std::string section_page(const SectionPage& page) {
  std::string caption, orbits;
  for (const std::string& line : page.caption)
    caption += (caption.empty() ? "" : ",") + quoted(line);
  for (const SectionPage::Orbit& o : page.orbits)
    orbits += (orbits.empty() ? "\n" : ",\n") + orbit(o);
  return std::string(head) + page_paper + body +
         fmt::format("{{\"title\":{},\"caption\":[{}],\"labels\":[{},{}],\"colour_label\":{},"
                     "\"logarithmic\":{},\"orbits\":[{}]}}",
                     quoted(page.title), caption, quoted(page.labels[0]), quoted(page.labels[1]),
                     quoted(page.colour_label), page.logarithmic, orbits) +
         page_palette + script;
}

} // namespace kov::cli
