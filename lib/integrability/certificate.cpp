#include "integrability/certificate.hpp"

#include "certify/equation/certificate.hpp"
#include "decide/certificate.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "integrability/way.hpp"
#include "strata/certificate.hpp"

#include <algorithm>

namespace kov {

namespace {

// "y'' = r(z) y with z = ... is the equation of the block (...) along ..., derived by this program"
std::string derivation(const System& s, const ManifoldReport& m, const BlockReport& b,
                       const std::string& level) {
  std::vector<std::string> equations;
  std::vector<std::string> values;
  for (const auto& e : m.manifold->equations)
    equations.push_back(e.text);
  for (const auto& e : m.manifold->levels)
    equations.push_back(e.text);
  for (const auto& [name, value] : s.values)
    values.push_back(name + " = " + to_string(value));
  if (!level.empty()) values.push_back(level);
  return "y'' = r y, in the variable " + s.ring()->name(b.ode->z) + " (" + b.ode->change +
         "), is the normal form of the equation of " + b.ode->unknown + " in the block (" +
         joined(b.unknowns) + ") of the normal variational equations of " + s.file + " along " +
         m.name + ": " + joined(equations) + (values.empty() ? "" : "; with " + joined(values));
}

class CertificateCollector {
public:
  explicit CertificateCollector(const System& s) : s_(s) {}

  std::vector<NamedCertificate> operator()(const ManifoldReport& m) {
    study(m, "");
    return std::move(all_);
  }

private:
  /// role: "-special" for a stratum on which r means nothing.
  void study(const ManifoldReport& m, const std::string& role) {
    if (!m.manifold) return;
    m_ = &m;
    if (m.matrices) matrices(*m.matrices, role + "-matrices");
    for (const BlockReport& b : m.blocks) {
      block(b, role);
      for (const auto& special : b.special_studies)
        study(*special, role + "-special");
      m_ = &m;
    }
  }
  void matrices(const MatrixEvidence& by, const std::string& role) {
    if (by.certificate.empty())
      refuse(by.no_certificate, role);
    else
      add(by.certificate + "\n", role);
  }
  void block(const BlockReport& b, const std::string& role) {
    if (b.decision) take(*b.decision, b, b.way, "", role);
    if (b.strata) take(*b.strata, b.way, role);
    for (const EnergyResult& e : b.energies) {
      if (e.decision) take(*e.decision, b, e.way, sentence(e.at), role + "-level");
      if (e.strata) take(*e.strata, b.way, role + "-level");
    }
    if (b.no_way) refuse(sentence(*b.no_way), role + "-way");
  }

  void take(const Decision& d, const BlockReport& b, const std::shared_ptr<const WayToR>& way,
            const std::string& level, const std::string& role) {
    const std::string equation = of_equation(d, role);
    if (equation.empty() || whole(way, equation, role)) return;
    certify::Certificate c = certify::read_certificate(equation);
    const std::string group = c.steps.back().id;
    c.steps.push_back(
        {"equation",
         {group},
         certify::ApplyTheorem{"normal variational equation", derivation(s_, *m_, b, level)}});
    if (m_->verdict == Verdict::non_integrable && d.abelian == Truth::no)
      c.steps.push_back({"obstruction",
                         {group, "equation"},
                         certify::ApplyTheorem{m_->by->id(), s_.file + ": " + statement(*m_)}});
    add(certify::write_certificate(c), role);
  }

  /// Written now, if it was not kept; empty: there is none.
  std::string of_equation(const Decision& d, const std::string& role) {
    if (!d.certificate.empty() || !d.checked || d.withdrawn || !d.proof()) return d.certificate;
    try {
      Judged opinion = judged(certificate(*d.proof(), d.r));
      if (opinion.refusal.empty()) return std::move(opinion.json);
      refuse(opinion.refusal, role);
    } catch (const Error& why) {
      refuse(why.what(), role);
    }
    return {};
  }

  /// The tree of strata, and those of the special strata; a limit leaves a certificate out.
  void take(const strata::StrataAnswer& a, const std::shared_ptr<const WayToR>& way,
            const std::string& role) {
    try {
      if (a.tree) take(strata::certificate(a), a, way, role);
    } catch (const Error& why) {
      refuse(why.what(), role);
    }
  }

  /// The certificate of the whole way, if there is one.
  bool whole(const std::shared_ptr<const WayToR>& way, const std::string& equation,
             const std::string& role) {
    if (!way) return false;
    std::string none;
    const auto text = certificate_of(*way, equation, none);
    if (text)
      add(*text + "\n", role);
    else
      refuse(none, role + "-way");
    return text.has_value();
  }
  void take(const strata::StrataCertificate& c, const strata::StrataAnswer& a,
            const std::shared_ptr<const WayToR>& way, const std::string& role) {
    if (!c.refusal.empty())
      refuse(strata::objection(c), role);
    else if (c.says_anything && !whole(way, c.json, role))
      add(c.json + "\n", role);
    else if (!c.says_anything && somewhere_decided(a))
      refuse("the format has no rule for the strata that are decided", role);
  }
  static bool somewhere_decided(const strata::StrataAnswer& a) {
    return std::ranges::any_of(
        a.strata, [](const strata::Stratum& x) { return x.leaf.abelian != Truth::unknown; });
  }
  void refuse(const std::string& why, const std::string& role) {
    all_.push_back({m_->name + role, "", why});
  }
  void add(const std::string& json, const std::string& role) {
    const std::string name = m_->name + role;
    const auto same = std::ranges::count_if(all_, [&](const NamedCertificate& c) {
      return c.name == name || c.name.rfind(name + "-", 0) == 0;
    });
    all_.push_back({name + (same == 0 ? "" : "-" + std::to_string(same + 1)), json, ""});
  }

  const System& s_;
  const ManifoldReport* m_ = nullptr; ///< the one that is studied
  std::vector<NamedCertificate> all_;
};

} // namespace

std::vector<NamedCertificate> certificates(const System& s, const ManifoldReport& m) {
  return CertificateCollector(s)(m);
}

} // namespace kov
