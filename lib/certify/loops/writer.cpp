// LoopsCertificate -> JSON, keys in the order of loop_certificates.md 2.

#include "certify/loops/certificate.hpp"

namespace kov::certify {
namespace {

Json text(std::string s) { return {std::move(s)}; }
template <class Number> Json number(const Number& n) { return text(to_string(n)); }
Json count(long n) { return text(std::to_string(n)); }

template <class T, class F> Json listed(const std::vector<T>& all, F one) {
  Json::Array a;
  for (const T& x : all)
    a.push_back(one(x));
  return {std::move(a)};
}

Json word(const LoopWord& w) {
  return listed(w, [](std::size_t i) { return count(static_cast<long>(i)); });
}

Json row(const LoopRow& r) {
  return {Json::Object{{"den", to_json(r.den)},
                       {"num", listed(r.num, [](const Poly& f) { return to_json(f); })}}};
}

Json polygon(const Polygon& p) {
  return listed(p, [](const LoopPoint& x) -> Json {
    return {Json::Array{number(x.x), number(x.y)}};
  });
}

Json element(const LoopElement& e) {
  return {Json::Object{{"word", word(e.word)}, {"power", count(e.power)}}};
}

Json block(const LoopBlock& b) {
  Json::Object o{{"unknowns", word(b.unknowns)},
                 {"factors", listed(b.factors, [](const RadicalFactor& f) -> Json {
                    return {Json::Object{{"q", to_json(f.q)}, {"e", number(f.e)}}};
                  })}};
  if (b.certificate) o.emplace_back("certificate", to_json(*b.certificate));
  return {std::move(o)};
}

Json shown(const ShowsSl2& s) {
  return {Json::Object{{"by", text("sl2")}, {"A", word(s.a)}, {"B", word(s.b)}, {"C", word(s.c)}}};
}

Json shown(const ShowsNotAbelian& s) {
  return {Json::Object{{"by", text("not-abelian")},
                       {"A", element(s.a)},
                       {"B", element(s.b)},
                       {"row", count(static_cast<long>(s.row))},
                       {"column", count(static_cast<long>(s.column))},
                       {"blocks", listed(s.blocks, block)}}};
}

} // namespace

std::string write_loops_certificate(const LoopsCertificate& c) {
  return to_string(
      Json{Json::Object{{"format", text("kovacic-loops/1")},
                        {"title", text(c.title)},
                        {"field", to_json(*c.field)},
                        {"system", listed(c.rows, row)},
                        {"bits", count(c.bits)},
                        {"loops", listed(c.loops, polygon)},
                        {"shows", std::visit([](const auto& s) { return shown(s); }, c.shows)}}});
}

} // namespace kov::certify
