// shade(p) for p in [0, 1]: around MEGNO's 2 in the middle, or from dark to light; what is regular is dark on light
// paper and light on dark paper.  paletteTicks: where the bar has numbers.
const dark = matchMedia("(prefers-color-scheme: dark)");
const ink = () => getComputedStyle(document.body).color;
const paletteTicks = [0.1, 0.5, 1, 2, 4, 10, 40];
function stops(around) {
  const middle = dark.matches ? [190, 200, 214] : [34, 48, 74], above = dark.matches ? [176, 120, 200] : [91, 29, 114];
  const high = [[165, 49, 126], [226, 80, 95], [251, 154, 98]];
  return around ? [[0, [79, 185, 159]], [0.25, [18, 122, 107]], [0.5, middle], [0.62, above], [0.75, high[0]], [0.88, high[1]], [1, high[2]]]
                : [[0, middle], [0.25, above], [0.5, high[0]], [0.75, high[1]], [1, high[2]]];
}
function shade(p, around) {
  const s = stops(around), i = Math.max(1, s.findIndex(one => one[0] >= p)), [a, low] = s[i - 1], [b, high] = s[i];
  return `rgb(${low.map((c, k) => Math.round(c + (p - a) / (b - a) * (high[k] - c)))})`;
}
