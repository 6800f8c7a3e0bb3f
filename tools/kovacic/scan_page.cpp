// A scan as one HTML file.  No network, no library.

#include "page_palette.hpp"
#include "scan_files.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace kov::cli {
namespace {

constexpr const char* scan_head = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>Scan</title>
<style>
)html";

constexpr const char* scan_body = R"html(</style>
</head>
<body>
<h1 id="title"></h1>
<canvas id="plane" tabindex="0" role="img"></canvas>
<p id="said" aria-live="polite"></p>
<p id="caption"></p>
<p id="help">Drag: move. Wheel or + and -: zoom. Pointer: the number of a cell. 0 or double click: everything. Grey: no orbit starts there, or it ends early.</p>
<script>
"use strict";
const scan = )html";

constexpr const char* scan_script = R"html(
const bytes = Uint8Array.from(atob(scan.numbers), c => c.charCodeAt(0));
const numbers = new Float32Array(bytes.buffer);
const canvas = document.getElementById("plane"), pen = canvas.getContext("2d");
const margin = { left: 70, right: 100, top: 10, bottom: 45 };
const [nx, ny] = scan.counts, flat = scan.flat;
let view;

const scale = v => scan.logarithmic ? Math.log(Math.max(v, 1e-300)) : v;
function part(value) {
  const a = scale(scan.low), b = scale(scan.high);
  return b > a ? Math.min(1, Math.max(0, (scale(value) - a) / (b - a))) : 0;
}
const picture = document.createElement("canvas");
function paint() {
  picture.width = nx;
  picture.height = ny;
  const colours = Array.from({ length: 256 }, (_, i) => shade(i / 255, scan.logarithmic).match(/\d+/g).map(Number));
  const grey = dark.matches ? [52, 58, 68] : [224, 224, 224];
  const paper = picture.getContext("2d"), image = paper.createImageData(nx, ny);
  for (let i = 0; i < nx * ny; ++i) {
    const x = i % nx, y = (i - x) / nx, at = 4 * ((ny - 1 - y) * nx + x);
    const c = Number.isFinite(numbers[i]) ? colours[Math.round(255 * part(numbers[i]))] : grey;
    image.data.set([...c, 255], at);
  }
  paper.putImageData(image, 0, 0);
}
function all() {
  view = { x0: scan.x[0], x1: scan.x[1], y0: scan.y[0], y1: scan.y[1] };
  if (!flat) return;
  const known = numbers.filter(Number.isFinite);
  const low = known.reduce((a, b) => Math.min(a, b), Infinity), high = known.reduce((a, b) => Math.max(a, b), -Infinity);
  const edge = 0.04 * (high - low) || 1;
  view.y0 = low - edge;
  view.y1 = high + edge;
}
const width = () => canvas.clientWidth - margin.left - margin.right;
const height = () => canvas.clientHeight - margin.top - margin.bottom;
const toX = x => margin.left + (x - view.x0) / (view.x1 - view.x0) * width();
const toY = y => margin.top + (view.y1 - y) / (view.y1 - view.y0) * height();
const fromX = p => view.x0 + (p - margin.left) / width() * (view.x1 - view.x0);
const fromY = p => view.y1 - (p - margin.top) / height() * (view.y1 - view.y0);
const cellX = i => scan.x[0] + (i + 0.5) / nx * (scan.x[1] - scan.x[0]);
const cellY = i => scan.y[0] + (i + 0.5) / ny * (scan.y[1] - scan.y[0]);

function ticks(a, b) {
  const rough = (b - a) / 6, power = Math.pow(10, Math.floor(Math.log10(rough)));
  const step = power * [1, 2, 5, 10].find(m => m * power >= rough), found = [];
  for (let k = Math.ceil(a / step); k * step <= b; ++k)
    found.push({ at: k * step, text: String(Number((k * step).toPrecision(10))) });
  return found;
}
function turned(text, x, y) {
  pen.save();
  pen.translate(x, y);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText(text, 0, 0);
  pen.restore();
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
  pen.fillText(scan.labels[0], margin.left + width() / 2, margin.top + height() + 38);
  pen.textAlign = "right";
  for (const t of ticks(view.y0, view.y1)) {
    pen.fillRect(margin.left - 5, toY(t.at), 5, 1);
    pen.fillText(t.text, margin.left - 8, toY(t.at) + 4);
  }
  turned(scan.labels[1], 14, margin.top + height() / 2);
}
function legend() {
  const x = margin.left + width() + 14, h = height();
  for (let i = 0; i < h; ++i) {
    pen.fillStyle = shade(1 - i / h, scan.logarithmic);
    pen.fillRect(x, margin.top + i, 14, 1.5);
  }
  pen.fillStyle = ink();
  pen.textAlign = "left";
  for (const t of scan.logarithmic ? paletteTicks : [scan.low, scan.high])
    pen.fillText(Number(t.toPrecision(3)), x + 18, Math.max(margin.top + 10, margin.top + (1 - part(t)) * h + 4));
  turned(scan.label, x + 60, margin.top + h / 2);
}
function curve() {
  pen.fillStyle = dark.matches ? "#6ab0ff" : "#31688e";
  for (let i = 0; i < nx; ++i)
    if (Number.isFinite(numbers[i])) pen.fillRect(toX(cellX(i)) - 1, toY(numbers[i]) - 1, 2, 2);
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
  pen.imageSmoothingEnabled = false;
  if (flat) curve();
  else pen.drawImage(picture, toX(scan.x[0]), toY(scan.y[1]), toX(scan.x[1]) - toX(scan.x[0]), toY(scan.y[0]) - toY(scan.y[1]));
  pen.restore();
  axes();
  if (!flat) legend();
}
function say(px, py) {
  const i = Math.floor((fromX(px) - scan.x[0]) / (scan.x[1] - scan.x[0]) * nx);
  const k = flat ? 0 : Math.floor((fromY(py) - scan.y[0]) / (scan.y[1] - scan.y[0]) * ny);
  let text = "";
  if (i >= 0 && i < nx && k >= 0 && k < ny) {
    const v = numbers[i + nx * k], round = x => Number(x.toPrecision(6));
    text = `${scan.labels[0]} = ${round(cellX(i))}` + (flat ? "" : `, ${scan.labels[1]} = ${round(cellY(k))}`) + ": " +
      (Number.isNaN(v) ? "no orbit starts here" : Number.isFinite(v) ? `${scan.label} ${round(v)}` : "the orbit ends early");
  }
  document.getElementById("said").textContent = text;
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
let held = null;
canvas.addEventListener("pointerdown", e => {
  held = { x: e.offsetX, y: e.offsetY };
  try { canvas.setPointerCapture(e.pointerId); } catch (error) { /* the pointer is gone */ }
});
canvas.addEventListener("pointermove", e => {
  if (held) {
    move(e.offsetX - held.x, e.offsetY - held.y);
    held = { x: e.offsetX, y: e.offsetY };
  } else {
    say(e.offsetX, e.offsetY);
  }
});
canvas.addEventListener("pointerup", e => { held = null; say(e.offsetX, e.offsetY); });
canvas.addEventListener("pointercancel", () => { held = null; });
canvas.addEventListener("wheel", e => {
  e.preventDefault();
  zoom(Math.pow(1.002, Math.max(-300, Math.min(300, e.deltaY))), e.offsetX, e.offsetY);
}, { passive: false });
canvas.addEventListener("dblclick", () => { all(); draw(); });
canvas.addEventListener("keydown", e => {
  const cx = margin.left + width() / 2, cy = margin.top + height() / 2;
  const keys = { "+": () => zoom(0.8, cx, cy), "-": () => zoom(1.25, cx, cy),
                 "0": () => { all(); draw(); },
                 ArrowLeft: () => move(40, 0), ArrowRight: () => move(-40, 0),
                 ArrowUp: () => move(0, 40), ArrowDown: () => move(0, -40) };
  if (!keys[e.key]) return;
  e.preventDefault();
  keys[e.key]();
});
window.addEventListener("resize", draw);
dark.addEventListener("change", () => { if (!flat) paint(); draw(); });
document.title = scan.title;
document.getElementById("title").textContent = scan.title;
document.getElementById("caption").textContent = scan.caption.join("\n");
canvas.setAttribute("aria-label", scan.title);
if (!flat) paint();
all();
draw();
</script>
</body>
</html>
)html";

std::string base64(const std::string& bytes) {
  static constexpr const char* digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63U];
  }
  return out;
}

// Text in a script element: no character of it can end that.
std::string script_text(const nlohmann::json& j) {
  std::string out;
  for (const char c : j.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

} // namespace

std::string scan_page(const ScanPlot& plot, const std::vector<double>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(float));
  for (const double x : values) {
    const auto one = static_cast<float>(x);
    bytes.append(reinterpret_cast<const char*>(&one), sizeof one);
  }
  const auto& x = plot.axes.front();
  const bool flat = plot.axes.size() == 1;
  const auto ends = [](const flow::ScanAxis& a) {
    return nlohmann::json{a.from.as<double>(), a.to.as<double>()};
  };
  const nlohmann::json j{{"title", plot.title},
                         {"caption", plot.caption},
                         {"labels", {x.name, flat ? plot.label : plot.axes[1].name}},
                         {"label", plot.label},
                         {"counts", {x.count, flat ? 1 : plot.axes[1].count}},
                         {"flat", flat},
                         {"x", ends(x)},
                         {"y", flat ? nlohmann::json{0, 1} : ends(plot.axes[1])},
                         {"low", plot.colours.low},
                         {"high", plot.colours.high},
                         {"logarithmic", plot.colours.logarithmic},
                         {"numbers", base64(bytes)}};
  return std::string(scan_head) + page_paper + scan_body + script_text(j) + page_palette +
         scan_script;
}

} // namespace kov::cli
