// Derivatives as quotients: d^2y/dx^2, dy/dx, d/dx (p y').

#include "symbol/pasted_characters.hpp"
#include "symbol/pasted_passes.hpp"

#include <algorithm>
#include <optional>

namespace kov {
namespace {

using List = std::vector<Token>;

bool begins_with_d(const Token& t) {
  return t.kind == TokenKind::name && t.text.front() == 'd' && !is_greek(t.text) &&
         t.text != "diff" && t.text != "dsolve" && t.text != "desolve" && t.text != "derivative";
}

class Quotients {
public:
  Quotients(List in, Pasting& p) : in_(std::move(in)), p_(p) {}

  List operator()() {
    List out;
    run(0, in_.size() - 1, out);
    out.push_back(in_.back());
    return out;
  }

private:
  struct Above {
    long order = 1;
    std::size_t begin = 0, end = 0; // of the function's tokens after its name
    std::optional<Token> function;
    std::size_t next = 0;
  };
  struct Below {
    long order = 1;
    Token variable;
    std::size_t next = 0;
  };

  [[nodiscard]] const Token& token(std::size_t i) const { return in_[std::min(i, in_.size() - 1)]; }

  // [^ n] or [^ (n)]
  void order_at(std::size_t& i, long& order) const {
    if (!token(i).is("^")) return;
    const bool grouped = token(i + 1).is("(");
    const Token& n = token(i + 1 + grouped);
    if (n.kind != TokenKind::number || n.text.size() > 1 || (grouped && !token(i + 3).is(")")))
      return;
    order = n.text[0] - '0';
    i += grouped ? 4 : 2;
  }

  // The rest of a name without its first letters.
  static Token shortened(Token t, std::size_t by, std::size_t length = std::string_view::npos) {
    t.text = t.text.substr(by, length);
    t.span.offset += static_cast<std::uint32_t>(by);
    t.span.length = static_cast<std::uint32_t>(t.text.size());
    return t;
  }

  [[nodiscard]] std::optional<Above> above(std::size_t i) const {
    if (!begins_with_d(token(i)) || p_.names.has(token(i).text)) return std::nullopt;
    Above a;
    const Token d = token(i);
    if (d.text == "d") {
      a.next = i + 1;
      order_at(a.next, a.order);
      if (token(a.next).kind == TokenKind::name) a.function = token(a.next++);
    } else {
      const bool digit = d.text.size() > 2 && d.text[1] >= '2' && d.text[1] <= '9'; // d2y
      if (digit) a.order = d.text[1] - '0';
      a.function = shortened(d, digit ? 2 : 1);
      a.next = i + 1;
    }
    a.begin = a.end = a.next;
    if (a.function && token(a.next).is("(") && !token(a.next).after_blank)
      a.next = a.end = closing_of(in_, a.next) + 1;
    if (!token(a.next).is("/")) return std::nullopt;
    ++a.next;
    return a;
  }

  [[nodiscard]] std::optional<Below> below(std::size_t i) const {
    const bool grouped = token(i).is("(");
    i += grouped;
    if (!begins_with_d(token(i))) return std::nullopt;
    Below b;
    Token d = token(i++);
    if (d.text == "d") {
      if (token(i).kind != TokenKind::name) return std::nullopt;
      b.variable = token(i++);
    } else {
      const char last = d.text.back();
      const bool digit = d.text.size() > 2 && last >= '2' && last <= '9'; // dx2
      if (digit) b.order = last - '0';
      b.variable = shortened(d, 1, d.text.size() - 1 - digit);
    }
    order_at(i, b.order);
    if (grouped && !token(i).is(")")) return std::nullopt;
    b.next = i + grouped;
    return b;
  }

  void run(std::size_t at, std::size_t end, List& out) {
    while (at < end)
      at = step(at, end, out);
  }

  std::size_t step(std::size_t at, std::size_t end, List& out) {
    const auto a = above(at);
    const auto b = a ? below(a->next) : std::nullopt;
    if (!b || a->order != b->order || a->order == 0) {
      out.push_back(token(at));
      return at + 1;
    }
    if (a->function) {
      List f = part_of(in_, a->begin, a->end);
      f.insert(f.begin(), *a->function);
      put(token(at), f, *b, out);
      return b->next;
    }
    return applied(at, *b, end, out);
  }

  // d/dx of what follows: a group, a name, another derivative; of nothing: the operator.
  std::size_t applied(std::size_t at, const Below& b, std::size_t end, List& out) {
    const Token& t = token(b.next);
    List f;
    std::size_t next = b.next;
    if (opens(t)) {
      next = closing_of(in_, b.next) + 1;
      run(b.next, std::min(next, end), f);
    } else if (above(b.next)) {
      next = step(b.next, end, f);
    } else if (t.kind == TokenKind::name) {
      f.push_back(t);
      ++next;
      if (token(next).is("(") && !token(next).after_blank) {
        const std::size_t close = closing_of(in_, next) + 1;
        f.insert(f.end(), in_.begin() + static_cast<std::ptrdiff_t>(next),
                 in_.begin() + static_cast<std::ptrdiff_t>(close));
        next = close;
      }
      for (; token(next).is("'"); ++next)
        f.push_back(token(next));
      const Token& then = token(next);
      if (then.kind == TokenKind::name || then.kind == TokenKind::number || then.is("(") ||
          then.is("^") || then.is("*") || then.is("/"))
        p_.refuse(t.span, "what is differentiated here?", "write d/dx (...)");
    } else {
      const Token& d = token(at);
      out.push_back(made(d, TokenKind::name, p_.kept("D" + std::string(b.variable.text))));
      if (b.order == 1) return b.next;
      out.push_back(made(d, TokenKind::sign, "^"));
      out.push_back(made(d, TokenKind::number, p_.kept(std::to_string(b.order))));
      return b.next;
    }
    put(token(at), f, b, out);
    return next;
  }

  void put(const Token& at, const List& f, const Below& b, List& out) {
    out.push_back(made(at, TokenKind::name, "diff"));
    out.push_back(made(at, TokenKind::sign, "("));
    out.back().after_blank = false;
    out.insert(out.end(), f.begin(), f.end());
    const auto sign = [&](std::string_view s) {
      out.push_back(made(b.variable, TokenKind::sign, s));
    };
    sign(",");
    out.push_back(b.variable);
    if (b.order != 1) {
      sign(",");
      out.push_back(made(b.variable, TokenKind::number, p_.kept(std::to_string(b.order))));
    }
    sign(")");
    out.back().after_blank = false;
  }

  List in_;
  Pasting& p_;
};

} // namespace

bool is_quotient_of_d(const std::vector<Token>& a, const std::vector<Token>& b) {
  return !a.empty() && !b.empty() && begins_with_d(a.front()) && begins_with_d(b.front());
}

std::vector<Token> without_quotients_of_d(std::vector<Token> tokens, Pasting& p) {
  return Quotients(std::move(tokens), p)();
}

} // namespace kov
