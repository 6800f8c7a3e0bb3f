// LoopsCertificate <-> JSON, keys in the order of loop_certificates.md 2.

#include "certify/loops/check.hpp"
#include "exact/error.hpp"
#include "proof/text/fields.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {
namespace {

constexpr Words<2> shows_words{"sl2", "not-abelian"};
constexpr Between loop_entry{0, max_loop_size};
constexpr Each<Between> loop_word{{0, max_loops}};

bool is_dyadic(const Rational& x) {
  const Integer d = x.den();
  return fmpz_bits(d.raw()) == 1 + static_cast<ulong>(fmpz_val2(d.raw()));
}

struct ShortPoly {
  static void read(const Node& n, Poly& f, NoSetting&) {
    f = n.poly();
    if (degree(f) > max_loop_degree) n.fail("a degree is out of range");
  }
  static Json write(const Poly& f, NoSetting&) { return json_of(f); }
};

struct RationalOrGaussian {
  static void read(const Node& n, Field& x, NoSetting&) {
    x = read_field(n);
    if (!x->is_rational() && x->minpoly_coefficients() != std::vector<Integer>{1, 0, 1})
      n.fail("Q or Q(i) is expected");
  }
  static Json write(const Field& x, NoSetting&) { return to_json(*x); }
};

} // namespace

inline void read_entry(const Node& n, LoopPoint& p, NoSetting&) {
  const auto both = n.items();
  if (both.size() != 2) n.fail("a point has two coordinates");
  p = {both[0].rational(), both[1].rational()};
  for (const Rational& x : {p.x, p.y}) {
    if (!is_dyadic(x)) n.fail("coordinates are dyadic");
    if (fmpz_bits(x.den().raw()) > max_coordinate_bits ||
        fmpz_bits(x.num().raw()) > max_coordinate_bits + fmpz_bits(x.den().raw()) - 1)
      n.fail("a coordinate is too long");
  }
}
inline Json write_entry(const LoopPoint& p, NoSetting&) {
  return {Json::Array{{to_string(p.x)}, {to_string(p.y)}}};
}

template <class IO> void describe(IO& io, In<IO, LoopRow>& x) {
  io("den", x.den, ShortPoly{})("num", x.num, Each<ShortPoly>{});
  io.check(!is_zero(x.den), "den", "a denominator is expected");
}
template <class IO> void describe(IO& io, In<IO, LoopElement>& x) {
  io("word", x.word, loop_word)("power", x.power, Between{1, max_loop_power});
}
template <class IO> void describe(IO& io, In<IO, RadicalFactor>& x) { io("q", x.q)("e", x.e); }
template <class IO> void describe(IO& io, In<IO, LoopBlock>& x) {
  io("unknowns", x.unknowns, loop_word)("factors", x.factors)("certificate", x.certificate);
}
template <class IO> void describe(IO& io, In<IO, ShowsSl2>& x) {
  io("A", x.a, loop_word)("B", x.b, loop_word)("C", x.c, loop_word);
}
template <class IO> void describe(IO& io, In<IO, ShowsNotAbelian>& x) {
  io("A", x.a)("B", x.b)("row", x.row, loop_entry)("column", x.column, loop_entry)("blocks",
                                                                                   x.blocks);
}

template <class IO> void describe(IO& io, In<IO, LoopsCertificate>& x) {
  io.format("kovacic-loops/1")("title", x.title)("field", x.field, RationalOrGaussian{})
      .over(x.field);
  io("system", x.rows, Each<>{{}, max_loop_size, "rows"});
  io.check(!x.rows.empty(), "system", "the size of the system is out of range");
  for (const LoopRow& row : x.rows)
    io.check(row.num.size() == x.rows.size(), "system", "a row for each unknown is expected");
  io("bits", x.bits, Between{32, max_loop_bits});
  io("loops", x.loops, Each{Each<>{{}, max_loop_points, "points"}, max_loops, "loops"});
  std::size_t points = 0;
  for (const Polygon& p : x.loops)
    points += p.size();
  io.check(points <= max_loop_points && !x.loops.empty(), "loops",
           "one loop or more, and at most 2000 points");
  io("shows", x.shows, one_of("by", shows_words));
}

LoopsCertificate read_loops_certificate(const Node& n) { return read_whole<LoopsCertificate>(n); }
LoopsCertificate read_loops_certificate(std::string_view text) {
  return read_whole<LoopsCertificate>(text);
}
Json to_json(const LoopsCertificate& c) { return whole_json(c); }
std::string write_loops_certificate(const LoopsCertificate& c) { return to_string(to_json(c)); }

} // namespace kov::certify
