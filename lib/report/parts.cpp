#include "report/render_theorem.hpp"
#include "symbol/given_text.hpp"

#include <algorithm>
#include <set>

namespace kov::report {

namespace {

struct Box {
  long left = 0, low = 0, right = 0, high = 0;
  [[nodiscard]] bool meets(const Box& b) const {
    return left < b.right && b.left < right && low < b.high && b.low < high;
  }
};

// The first place of those around a point where nothing else stands; else the first of all.
void put_labels(std::vector<PlacedPoint>& points, const PictureSize& size) {
  const long w = size.letter_width, h = size.letter_height;
  std::vector<Box> taken;
  for (const PlacedPoint& p : points)
    taken.push_back({p.x - w / 2, p.y - h / 2, p.x + w / 2, p.y + h / 2});
  for (PlacedPoint& p : points) {
    const long length = w * static_cast<long>(label(p.label, Markup::text).size());
    const std::pair<long, long> around[] = {
        {w, h / 2}, {w, -5 * h / 4},  {-w - length, h / 2}, {-w - length, -5 * h / 4},
        {w, 2 * h}, {w, -11 * h / 4}, {-w - length, 2 * h}};
    const auto box = [&](const std::pair<long, long>& d) {
      return Box{p.x + d.first, p.y + d.second, p.x + d.first + length, p.y + d.second + h};
    };
    const auto is_free = [&](const std::pair<long, long>& d) {
      const Box b = box(d);
      return b.left >= 0 && b.low >= 0 && b.right <= size.width && b.high <= size.height &&
             std::ranges::none_of(taken, [&](const Box& x) { return x.meets(b); });
    };
    const auto* found = std::find_if(std::begin(around), std::end(around), is_free);
    const auto& chosen = found == std::end(around) ? around[0] : *found;
    p.label_x = p.x + chosen.first;
    p.label_y = p.y + chosen.second;
    taken.push_back(box(chosen));
  }
}

} // namespace

PlacedPicture place(const PolePicture& p, const PictureSize& size) {
  const auto [width, height, letter_width, letter_height] = size;
  PlacedPicture out{width, height, {}, {}, {}, {}};
  Rational low_x(-1), high_x(1), low_y(p.strip ? 0 : -1), high_y(p.strip ? 2 : 1);
  for (const auto& q : p.points) {
    low_x = std::min(low_x, q.x);
    high_x = std::max(high_x, q.x);
    low_y = std::min(low_y, q.y);
    high_y = std::max(high_y, q.y);
  }
  // the same scale on both axes, with a margin of a tenth
  const Rational inner(Integer(8), Integer(10));
  const Rational span_x = high_x - low_x, span_y = high_y - low_y;
  const Rational scale = inner * std::min(Rational(width) / span_x, Rational(height) / span_y);
  const Rational half(Integer(1), Integer(2));
  const Rational mid_x = half * (low_x + high_x), mid_y = half * (low_y + high_y);
  const auto at = [&](const Rational& v, const Rational& mid, long side) {
    return to_long(floor(scale * (v - mid) + half * Rational(side)));
  };
  for (const auto& q : p.points)
    out.points.push_back({at(q.x, mid_x, width), at(q.y, mid_y, height), q.label, q.special});
  put_labels(out.points, size);
  out.axis_x = at(Rational(0), mid_x, width);
  out.axis_y = at(Rational(0), mid_y, height);
  if (p.strip) out.band = {at(Rational(0), mid_y, height), at(Rational(2), mid_y, height)};
  if (*out.axis_x < 0 || *out.axis_x > width) out.axis_x.reset();
  if (*out.axis_y < 0 || *out.axis_y > height) out.axis_y.reset();
  return out;
}

std::string settled(const TheoremHypothesis& h) {
  return h.settled == Settled::checked  ? "checked (" + h.how + "): "
         : h.settled == Settled::stated ? "part of the statement: "
                                        : "NOT CHECKED: ";
}

std::string finding(const NodeResult& n) {
  return n.statement.find(n.summary) == std::string::npos ? n.summary : "";
}

const InputFile* main_system(const TheoremResult& t) {
  const std::string& file =
      t.theorem.system.empty() && !t.nodes.empty() ? t.nodes.front().node.file : t.theorem.system;
  const auto found =
      std::ranges::find_if(t.files, [&](const InputFile& f) { return f.name == file; });
  return found == t.files.end() || found->setting.empty() ? nullptr : &*found;
}

std::string name_of_system(const TheoremResult& t, const InputFile& f, Markup m) {
  const auto shown =
      std::ranges::count_if(t.files, [](const InputFile& x) { return !x.setting.empty(); });
  return shown > 1 ? prose("The " + f.titled, m) : "The system";
}

std::vector<Reference> references(const TheoremResult& t) {
  std::set<std::string> keys(t.theorem.cite.begin(), t.theorem.cite.end());
  for (const NodeResult& n : t.nodes)
    keys.insert(n.node.cite.begin(), n.node.cite.end());
  for (const TheoremUsed& u : t.uses())
    keys.insert(u.theorem->cite);
  std::vector<Reference> all;
  for (const std::string& key : keys)
    if (auto found = reference(key)) all.push_back(std::move(*found));
  return all;
}

std::vector<std::string> commands_to_check(const TheoremResult& t) {
  std::string file = t.theorem.file.substr(folder_of(t.theorem.file).size());
  const std::string command = t.theorem.nodes.empty()    ? "classify"
                              : t.theorem.system == file ? "report"
                                                         : "prove";
  if (const InputFile* s = main_system(t); s != nullptr && s->name != "-" && is_given(s->name))
    for (const Formula& line : s->setting)
      if (line.label == "Hamiltonian" || line.label == "Lagrangian")
        file = "-" + line.label.substr(0, 1) + " '" + line.text + "'" +
               (s->assumed.empty() ? "" : " (with --assume)");
  const std::string out = t.bundle.empty() ? "certificates" : "certificate.json";
  const std::string written = t.bundle.empty() ? out + "/*.json" : out;
  std::vector<std::string> all{"kovacic " + command + " " + file + " --certificate " + out};
  if (t.certificates() == 0 && t.bundle.empty()) return {"kovacic " + command + " " + file};
  all.push_back("kovacic verify " + written);
  all.push_back("kovacic-verify " + written);
  return all;
}

std::vector<InputFile> files_of(const TheoremResult& t) {
  std::vector<InputFile> all = t.files;
  std::erase_if(all, [](const InputFile& f) { return is_given(f.name); });
  return all;
}

std::string how_to_check(const TheoremResult& t) {
  if (!t.bundle.empty())
    return "All that the statement rests on is one certificate. Two programs check it; the second, "
           "in Python with its standard library only, shares nothing with the one that found it:";
  return t.certificates() > 0
             ? "The certificates of the steps are checked by two programs; the second, in Python "
               "with its standard library only, shares nothing with the one that found them:"
             : "The same answer comes from:";
}

std::string remark(const NodeResult& n) {
  return n.statement.empty() && n.node.kind == NodeKind::argument ? "argument in words: "
                                                                  : "the author's remark: ";
}

std::vector<const NodeResult*> roots(const TheoremResult& t) {
  std::set<std::string> needed;
  for (const NodeResult& n : t.nodes)
    needed.insert(n.node.needs.begin(), n.node.needs.end());
  std::vector<const NodeResult*> all;
  for (const NodeResult& n : t.nodes)
    if (all.empty() || !needed.contains(n.node.id)) all.push_back(&n);
  return all;
}

} // namespace kov::report
