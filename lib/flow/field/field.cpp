#include "flow/field/field.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {

template <> BigReal number_as<BigReal>(const Rational& q) {
  BigReal r;
  fmpq_get_mpfr(r.raw(), q.raw(), MPFR_RNDN);
  return r;
}
template <> double number_as<double>(const Rational& q) {
  const PrecisionScope scope(53);
  return static_cast<double>(number_as<BigReal>(q));
}
template <> long double number_as<long double>(const Rational& q) {
  const PrecisionScope scope(64);
  return mpfr_get_ld(number_as<BigReal>(q).raw(), MPFR_RNDN);
}
template <> Twin1 number_as<Twin1>(const Rational& q) {
  const PrecisionScope scope(160);
  return to_twin(number_as<BigReal>(q));
}

namespace {

constexpr double max_places = 4e6; // of a storage: 256 MB with eight lanes

std::vector<NodeId> nodes_of(Graph& g, const std::vector<MFraction>& functions) {
  return mapped<NodeId>(functions, [&](const MFraction& f) { return g.of(f); });
}

// f as it is written, where that saves something beside the roots; else its factors, which keep more digits near 0.
NodeId cheapest(Graph& g, std::vector<NodeId> roots, const MFraction& f) {
  const auto cost = [&](NodeId n) {
    roots.push_back(n);
    const double all = products(g, roots);
    roots.pop_back();
    return all;
  };
  const NodeId written = g.of(f), other = g.multiplied_out(f);
  return cost(written) < 0.9 * cost(other) ? written : other;
}

bool is_linear(const MFraction& f, const std::vector<std::size_t>& variables) {
  const auto degree_in = [&](const std::vector<unsigned long>& e) {
    unsigned long sum = 0;
    for (const std::size_t v : variables)
      sum += e[v];
    return sum;
  };
  for (long i = 0; i < f.num().length(); ++i)
    if (degree_in(f.num().exponents(i)) > 1) return false;
  return !uses_any(f.den(), variables);
}

Instruction placed(Instruction i, const std::function<std::uint32_t(std::uint32_t)>& place) {
  for (std::size_t k = 0; k < group; ++k) {
    i.out[k] = place(i.out[k]);
    if (!i.is_register(k)) continue;
    i.a[k] = place(i.a[k]);
    i.b[k] = place(i.b[k]);
  }
  return i;
}

// Whole series have room for all orders.  Of the others order k is in the place after that of order k - 1, where their
// neighbour has been: in all they need hardly more room than one series, and the series that are read again and
// again stay in the cache.
std::vector<std::uint32_t> places_of(const std::vector<Room>& rooms, std::uint32_t stride) {
  std::vector<std::uint32_t> places(rooms.size());
  std::uint32_t next = 0;
  for (const auto& [room, size] :
       {std::pair{Room::whole, stride}, {Room::first, 1U}, {Room::present, 1U}})
    for (std::size_t i = 0; i < rooms.size(); ++i)
      if (rooms[i] == room) {
        places[i] = next;
        next += size;
      }
  places.push_back(next + stride);
  return places;
}

template <class R> std::vector<R> numbers_as(const std::vector<Rational>& numbers) {
  return mapped<R>(numbers, [&](const Rational& q) { return number_as<R>(q); });
}

// x was rounded: the number of R beside it, or a little further away.
template <class R> void round_otherwise(R& x) { x += x * (unit_roundoff<R>() * R(2)); }

// 1/2, 3, but not 1/3.
bool is_short(const Rational& q) {
  const Integer den = q.den();
  return fmpz_popcnt(den.raw()) == 1 && fmpz_bits(den.raw()) <= 64 &&
         fmpz_bits(q.num().raw()) <= 50;
}

} // namespace

Field::Field(const System& s, const MFraction& section, const std::vector<MFraction>& needed,
             const Values& values, bool tangent, const Graph* written)
    : motion_([&] {
        std::vector<MFraction> used = needed;
        used.push_back(section);
        Motion m = motion_of(s, used, written);
        use_powers(m);
        return m;
      }()),
      values_(values), curved_(!is_linear(section, motion_.variables)) {
  if (tangent) add_tangent(motion_, s.ring()->size());
  for (const auto& [variable, value] : values)
    numbers_.push_back(variable);
  std::vector<std::size_t> inputs = motion_.variables, points = motion_.variables;
  inputs.insert(inputs.end(), motion_.tangent.begin(), motion_.tangent.end());
  if (inputs.size() > most_variables)
    throw OutOfBudget("size limit: sections are drawn of systems with up to " +
                      std::to_string(most_variables) + " variables");
  for (auto* all : {&inputs, &points})
    all->insert(all->end(), numbers_.begin(), numbers_.end());
  registers_ = std::make_unique<Registers>(inputs);
  point_registers_ = std::make_unique<Registers>(points);
  std::vector<NodeId> followers;
  const std::size_t moves = motion_.variables.size() + motion_.tangent.size();
  for (std::uint32_t i = 0; i < moves; ++i)
    if (motion_.graph.rule_of(inputs[i]) == nullptr)
      moving_.push_back(i);
    else
      followers.push_back(motion_.graph.variable(inputs[i]));
  const std::vector<NodeId> roots = motion_.series_roots();
  const NodeId on_section = cheapest(motion_.graph, roots, section);
  field_ = compile(motion_.graph, roots, *registers_, true);
  section_ = compile(motion_.graph, {on_section}, *registers_, true);
  last_ = compile_again(motion_.graph, {on_section}, *registers_);
  followers_ = compile_again(motion_.graph, followers, *registers_);
  section_at_ = compile(motion_.graph, {on_section}, *point_registers_);
  rooms_.assign(registers_->count(), Room::present);
  std::fill_n(rooms_.begin(), inputs.size(), Room::whole);
  rooms_[section_.outputs.front()] = Room::whole;
  for (const Program* p : {&field_, &section_, &last_, &followers_})
    look_at_reads(*p);
}

// Finds the rooms of the registers: the whole series must be there of what a program has not made
// itself, in this order.
void Field::look_at_reads(const Program& p) {
  using Op = Instruction::Op;
  const auto needs = [&](std::uint32_t reg, Room room) {
    rooms_[reg] = std::max(rooms_[reg], room);
  };
  for (const Instruction& i : p.once) // 0 from order 1 on
    for (const std::uint32_t out : {i.out[0], i.out[1]})
      needs(out, Room::whole);
  std::set<std::uint32_t> made;
  const auto at_order = [&](std::uint32_t reg) {
    if (!made.contains(reg)) needs(reg, Room::whole);
  };
  for (const auto& [reg, low] : registers_->low())
    needs(low, Room::first);
  for (const Instruction& i : p.each) {
    const bool recurs = i.op == Op::quotient || i.op == Op::root || i.op == Op::power;
    if (recurs) needs(i.out[1], Room::first);
    if (recurs || i.op == Op::copy) needs(i.out[0], Room::whole);
    if (i.op == Op::quotient || i.op == Op::copy) at_order(i.a[0]);
    if (i.op == Op::quotient || i.op == Op::power) needs(i.b[0], Room::whole);
    if (i.op == Op::power)
      for (const std::uint32_t series : {i.a[0], i.out[2]})
        needs(series, Room::whole);
    if (i.op == Op::scaled) at_order(i.b[0]);
    if (i.op == Op::scaled || i.op == Op::root) needs(i.a[0], Room::whole);
    for (std::size_t m = 0; m < i.count; ++m) {
      if (i.op == Op::products || i.op == Op::squares)
        for (const std::uint32_t factor : {i.a[m], i.b[m]})
          needs(factor, Room::whole);
      made.insert(i.out[m]);
    }
    for (std::uint32_t t = i.a[0]; i.op == Op::sum && t < i.b[0]; ++t)
      at_order(p.terms[t].reg);
  }
}

template <class R>
Tape<R> Tapes<R>::Kept::tape(const Program& p, const Place& place, bool otherwise_rounded) {
  for (const Instruction& i : p.once)
    once.push_back(placed(i, place));
  for (const Instruction& i : p.each)
    each.push_back(placed(i, place));
  for (const SumTerm& t : p.terms)
    terms.push_back({place(t.reg), t.number});
  numbers = numbers_as<R>(p.numbers);
  for (std::size_t i = 0; otherwise_rounded && i < numbers.size(); ++i)
    if (!is_short(p.numbers[i])) round_otherwise(numbers[i]);
  for (int k = 1; k <= max_degree; ++k)
    numbers.push_back(R(k));
  return {once.data(),
          once.data() + once.size(),
          each.data(),
          each.data() + each.size(),
          terms.data(),
          numbers.data(),
          static_cast<std::uint32_t>(p.numbers.size())};
}

template <class R> Tapes<R>::Tapes(const Field& f, int order, bool otherwise_rounded) {
  const auto stride = static_cast<std::uint32_t>(order + 1);
  if (static_cast<double>(f.registers_->count()) * stride > max_places)
    throw OutOfBudget("size limit: the field has too many operations for steps of this order");
  const std::vector<std::uint32_t> places = places_of(f.rooms_, stride);
  const auto place = [&](std::uint32_t reg) { return places[reg]; };
  tapes_.field = field_.tape(f.field_, place, otherwise_rounded);
  tapes_.section = section_.tape(f.section_, place, otherwise_rounded);
  tapes_.last = last_.tape(f.last_, place, otherwise_rounded);
  tapes_.section_at = section_at_.tape(f.section_at_, std::identity(), otherwise_rounded);
  tapes_.followers = followers_.tape(f.followers_, place, otherwise_rounded);
  for (std::size_t m = 0; m < f.moving_.size(); ++m) {
    moving_.push_back(place(f.moving_[m]));
    derivatives_.push_back(place(f.field_.outputs[m]));
  }
  for (const auto& [reg, low] : f.registers_->low())
    low_parts_.push_back({reg, place(low)});
  tapes_.low_parts = low_parts_.data();
  tapes_.low_parts_count = low_parts_.size();
  for (const std::size_t variable : f.numbers_)
    values_.push_back(f.values_.at(variable).template as<R>());
  for (R& value : values_)
    if (otherwise_rounded) round_otherwise(value);
  tapes_.moving = moving_.data();
  tapes_.derivatives = derivatives_.data();
  tapes_.moving_count = moving_.size();
  tapes_.section_at_place = f.section_at_.outputs.front();
  tapes_.curved = f.curved_;
  tapes_.section_place = place(f.section_.outputs.front());
  tapes_.coordinates = f.coordinates();
  tapes_.variables = f.variables().size();
  tapes_.tangent = f.tangent();
  tapes_.values = f.numbers_.size();
  tapes_.places = places.back();
  tapes_.point_registers = f.point_registers_->count();
}

template <class R>
Evaluator<R>::Evaluator(const Field& f, const std::vector<MFraction>& functions) {
  Graph g = f.motion_.graph;
  std::vector<std::size_t> variables = f.motion_.variables;
  inputs_ = variables.size();
  variables.insert(variables.end(), f.numbers_.begin(), f.numbers_.end());
  Registers places(variables);
  const Program p = compile(g, nodes_of(g, functions), places);
  code_ = p.each;
  terms_ = p.terms;
  numbers_ = numbers_as<R>(p.numbers);
  outputs_ = p.outputs;
  registers_.resize(places.count());
  results_.resize(outputs_.size());
  once_ = p.once;
  given_ = f.numbers_.size();
  std::vector<R> values;
  for (const std::size_t variable : f.numbers_)
    values.push_back(f.values_.at(variable).template as<R>());
  set(values.data());
}

template <class R> void Evaluator<R>::set(const R* numbers) {
  std::copy_n(numbers, given_, registers_.begin() + static_cast<std::ptrdiff_t>(inputs_));
  for (const Instruction& i : once_)
    machine::execute(i, terms_.data(), numbers_.data(), registers_.data(), 0);
}

template <class R> const std::vector<R>& Evaluator<R>::operator()(const R* x) {
  std::copy_n(x, inputs_, registers_.begin());
  for (const Instruction& i : code_)
    machine::execute(i, terms_.data(), numbers_.data(), registers_.data(), 0);
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    results_[i] = registers_[outputs_[i]];
  return results_;
}

std::vector<TermSize::Term> TermSize::terms_of(const Field& f, const MPoly& p) {
  std::vector<Term> all;
  for (long i = 0; i < p.length(); ++i) {
    const double rational = std::abs(number_as<double>(Rational(p.coefficient(i))));
    Term t{rational, rational, {}, {}};
    const auto e = p.exponents(i);
    for (std::size_t v = 0; v < e.size(); ++v) {
      if (e[v] == 0) continue;
      const auto place = std::ranges::find(f.variables(), v);
      if (const auto number = std::ranges::find(f.numbers_, v); number != f.numbers_.end())
        t.numbers.emplace_back(number - f.numbers_.begin(), e[v]);
      else if (place != f.variables().end())
        t.powers.emplace_back(place - f.variables().begin(), e[v]);
    }
    all.push_back(std::move(t));
  }
  return all;
}

TermSize::TermSize(const Field& f, const MFraction& function)
    : num_(terms_of(f, function.num())), denominator_(f, {MFraction(function.den())}) {
  std::vector<double> numbers;
  for (const std::size_t variable : f.numbers_)
    numbers.push_back(f.values_.at(variable).as<double>());
  set(numbers.data());
}

void TermSize::set(const double* numbers) {
  denominator_.set(numbers);
  for (Term& t : num_) {
    t.coefficient = t.rational;
    for (const auto& [place, exponent] : t.numbers)
      t.coefficient *= std::pow(std::abs(numbers[place]), static_cast<double>(exponent));
  }
}

double TermSize::operator()(const double* x, const double* least) {
  const auto size = [&](std::size_t i) {
    return least == nullptr ? std::abs(x[i]) : std::max(std::abs(x[i]), least[i]);
  };
  double sum = 0;
  for (const Term& t : num_) {
    double product = t.coefficient;
    for (const auto& [place, exponent] : t.powers)
      for (long k = 0; k < exponent; ++k)
        product *= size(place);
    sum += product;
  }
  return sum / std::abs(denominator_(x)[0]);
}

template class Tapes<double>;
template class Tapes<long double>;
template class Tapes<Twin1>;
template class Tapes<BigReal>;
template class Evaluator<double>;
template class Evaluator<long double>;
template class Evaluator<Twin1>;
template class Evaluator<BigReal>;

} // namespace kov::flow
