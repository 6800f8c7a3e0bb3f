// JSON -> LoopsCertificate, in the order of loop_certificates.md 2; unknown, missing and doubled keys
// are errors.

#include "certify/loops/certificate.hpp"
#include "exact/error.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {
namespace {

long number(const Node& n, long least, long most) {
  const Integer x = n.integer();
  if (x < Integer(least) || Integer(most) < x) n.fail("a number is out of range");
  return to_long(x);
}

LoopWord read_word(const Node& n) {
  LoopWord w;
  for (const Node& x : n.items())
    w.push_back(static_cast<std::size_t>(number(x, 0, max_loops)));
  return w;
}

bool is_dyadic(const Rational& x) {
  const Integer d = x.den();
  return fmpz_bits(d.raw()) == 1 + static_cast<ulong>(fmpz_val2(d.raw()));
}

LoopPoint read_point(const Node& n) {
  const auto both = n.items();
  if (both.size() != 2) n.fail("a point has two coordinates");
  const LoopPoint p{both[0].rational(), both[1].rational()};
  for (const Rational& x : {p.x, p.y}) {
    if (!is_dyadic(x)) n.fail("coordinates are dyadic");
    if (fmpz_bits(x.den().raw()) > max_coordinate_bits ||
        fmpz_bits(x.num().raw()) > max_coordinate_bits + fmpz_bits(x.den().raw()) - 1)
      n.fail("a coordinate is too long");
  }
  return p;
}

LoopElement read_element(const Node& n) {
  Keys k(n);
  LoopElement e;
  e.word = read_word(k.at("word"));
  e.power = number(k.at("power"), 1, max_loop_power);
  k.done();
  return e;
}

LoopBlock read_block(const Node& n) {
  Keys k(n);
  LoopBlock b;
  b.unknowns = read_word(k.at("unknowns"));
  for (const Node& x : k.at("factors").items()) {
    Keys f(x);
    b.factors.push_back({f.at("q").poly(), f.at("e").rational()});
    f.done();
  }
  if (const auto c = k.find("certificate")) b.certificate = read_certificate(*c);
  k.done();
  return b;
}

std::variant<ShowsSl2, ShowsNotAbelian> read_shows(const Node& n) {
  Keys k(n);
  const Node by = k.at("by");
  if (by.text() == "sl2") {
    ShowsSl2 s{read_word(k.at("A")), read_word(k.at("B")), read_word(k.at("C"))};
    k.done();
    return s;
  }
  if (by.text() != "not-abelian") by.fail("sl2 or not-abelian is expected");
  ShowsNotAbelian s;
  s.a = read_element(k.at("A"));
  s.b = read_element(k.at("B"));
  s.row = static_cast<std::size_t>(number(k.at("row"), 0, max_loop_size));
  s.column = static_cast<std::size_t>(number(k.at("column"), 0, max_loop_size));
  for (const Node& x : k.at("blocks").items())
    s.blocks.push_back(read_block(x));
  k.done();
  return s;
}

Poly read_short(const Node& n) {
  Poly f = n.poly();
  if (degree(f) > max_loop_degree) n.fail("a degree is out of range");
  return f;
}

void read_rows(LoopsCertificate& c, const Node& n) {
  const auto rows = n.items();
  if (rows.empty() || rows.size() > max_loop_size) n.fail("the size of the system is out of range");
  for (const Node& x : rows) {
    Keys k(x);
    LoopRow row{read_short(k.at("den")), {}};
    for (const Node& f : k.at("num").items())
      row.num.push_back(read_short(f));
    if (is_zero(row.den) || row.num.size() != rows.size())
      x.fail("a row with a denominator is expected");
    k.done();
    c.rows.push_back(std::move(row));
  }
}

void read_polygons(LoopsCertificate& c, const Node& n) {
  std::size_t points = 0;
  for (const Node& x : n.items()) {
    Polygon p;
    for (const Node& y : x.items()) {
      p.push_back(read_point(y));
      if (++points > max_loop_points) n.fail("too many points");
    }
    c.loops.push_back(std::move(p));
    if (c.loops.size() > max_loops) n.fail("too many loops");
  }
  if (c.loops.empty()) n.fail("there is no loop");
}

} // namespace

LoopsCertificate read_loops_certificate(std::string_view text) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  const Json json = parse_json(text);
  const Node without_field(json, "certificate", rationals());
  Keys outer(without_field);
  LoopsCertificate c;
  const Node field = outer.at("field");
  c.field = read_field(field);
  const auto m = c.field->minpoly_coefficients();
  if (!c.field->is_rational() && m != std::vector<Integer>{1, 0, 1})
    field.fail("Q or Q(i) is expected");
  const Node top(json, "certificate", c.field);
  Keys k(top);
  const Node format = k.at("format");
  if (format.text() != "kovacic-loops/1") format.fail("not kovacic-loops/1");
  static_cast<void>(k.at("field"));
  c.title = k.at("title").text();
  read_rows(c, k.at("system"));
  c.bits = number(k.at("bits"), 32, max_loop_bits);
  read_polygons(c, k.at("loops"));
  c.shows = read_shows(k.at("shows"));
  k.done();
  return c;
}

} // namespace kov::certify
