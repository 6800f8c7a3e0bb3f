#include "theorem/bundle.hpp"

#include "certify/jets/check.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/check.hpp"
#include "certify/theorem/fact.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "proof/algebra/arithmetic.hpp"
#include "splitting/perturbation.hpp"
#include "theorem/bundle_rules.hpp"
#include "theorem/bundle_symmetries.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"
#include "theorem/strata_parts.hpp"

#include <algorithm>

namespace kov {
namespace {

/// A theorem whose steps are about systems of their own files, which have their places in its system.
class PlacedParts {
public:
  PlacedParts(const TheoremResult& t, std::string directory, const Budget& budget)
      : t_(t), s_(t, std::move(directory), budget) {}

  TheoremBundle operator()() {
    const NodeResult& root = cover_of_all(t_);
    need_plain(s_.family);
    for (const std::string& id : root.cover->parts)
      put_part(*node_with(t_, id));
    std::vector<Json::Object> symmetries;
    for (const PlaceMap& map : root.symmetries)
      symmetries.push_back(
          symmetry_members(s_.family, s_.family.placed(Substitution(), {}), map, s_.budget));
    s_.put_cover(root.node.id, symmetries, root.cover->tree);
    return {.json = s_.text(&BundleFamily::json_with_lagrangian), .carried = std::move(carried_)};
  }

private:
  // ---- systems

  static BundleFamily& need_plain(BundleFamily& y) {
    if (!y.family().is_plain())
      throw DomainError("the system of " + y.name() +
                        " is not given by a Hamiltonian and a bracket");
    return y;
  }
  BundleFamily& family(const std::string& file, const ParameterValues& where) {
    std::string name = file;
    for (const auto& [p, value] : where)
      name += ", " + p + " = " + value;
    return family(read_system(beside(s_.directory, file), where), name);
  }
  BundleFamily& family(System s, const std::string& name) {
    const auto known = std::ranges::find(s_.families, name, &BundleFamily::name);
    return known != s_.families.end()
               ? *known
               : need_plain(s_.families.emplace_back(with_real_parameters(std::move(s)), name));
  }

  // ---- a part of the cover

  void put_part(const NodeResult& n) {
    try {
      const certify::Target own = put_own_step(n, certificate_step(n.node.id));
      const Place& p = n.node.place;
      BundleFamily& x = p.of.empty() ? s_.family : lowest_family(*node_with(t_, p.of));
      const System base = read_system(beside(s_.directory, x.name()), p.at);
      const PartPlace there = x.placed(p, base);
      const std::string id = n.node.id + (p.of.empty() ? "" : "-place");
      s_.put_place(id, certificate_step(n.node.id), x, there, n.map ? *n.map : identity_map(base),
                   own);
      if (!p.of.empty()) {
        s_.put_step(n.node.id, "lowest-order", {{"of", json_text(id)}},
                    lowest_order_members(s_.family, x, s_.family.system().weights, s_.budget));
        carried_.push_back(p.of);
      }
      s_.add_region(n.node.id, s_.family.moved(there.conditions()));
      carried_.push_back(n.node.id);
    } catch (const DomainError& why) {
      throw DomainError("step '" + n.node.id + "': " + why.what());
    } catch (const InvalidArgument& why) {
      throw DomainError("step '" + n.node.id + "': " + why.what());
    }
  }
  BundleFamily& lowest_family(const NodeResult& n) {
    System s = read_system(beside(s_.directory, n.node.other), n.node.where);
    s.assumptions.clear();
    for (Assumption a : s_.family.system().assumptions) {
      a.value = transfer(a.value, s.ring());
      s.assumptions.push_back(std::move(a));
    }
    return family(std::move(s), n.node.other);
  }

  /// The statement of the step about the system of its own file.
  certify::Target put_own_step(const NodeResult& n, const std::string& id) {
    switch (n.node.kind) {
    case NodeKind::case_file:
      return put_certificate(n, id);
    case NodeKind::theorem:
      return put_literature(n, id);
    case NodeKind::splitting:
      return put_splitting(n, id);
    case NodeKind::claims:
      return put_integrals(n, id);
    default:
      throw DomainError("there is no rule for a step of kind " + to_string(n.node.kind));
    }
  }
  certify::Target put_certificate(const NodeResult& n, const std::string& id) {
    std::string why = "none was written";
    for (const std::string& json : n.certificates) {
      try {
        const certify::Said& said = said_.emplace_back(said_by(json));
        if (said.kind != certify::FactKind::not_integrable)
          throw DomainError("the certificate does not say \"not integrable\" of all its points");
        s_.put_step(id, "certificate", {{"certificate", certify::parse_json(json, 512)}});
        return *said.target;
      } catch (const Error& no) {
        why = no.what();
      }
    }
    throw DomainError(why);
  }
  certify::Target put_literature(const NodeResult& n, const std::string& id) {
    const std::string& name = n.node.theorem->id;
    const BundleFamily& y = family(read_system(parse_document(n.node.theorem->system, name)), name);
    s_.put_step(id, "literature", {{"system", json_text(y.name())}, {"theorem", json_text(name)}});
    return certify::target_of(y.family(), {}, true);
  }
  certify::Target put_splitting(const NodeResult& n, const std::string& id) {
    const BundleFamily& y = family(n.node.file, n.node.where);
    std::vector<Condition> region;
    for (const std::string& text : n.domain) {
      const Assumption a = condition(y.system(), text);
      region.push_back(y.moved({a.value.num(), std::get<Sign>(a.says)}));
    }
    s_.put_step(id, "splitting",
                splitting_members(y, perturbation_of_euler(y.system(), n.node.small), n.node.small,
                                  region, s_.budget));
    return certify::target_of(y.family(), region, true);
  }
  certify::Target put_integrals(const NodeResult& n, const std::string& id) {
    BundleFamily& y = family(n.node.file, n.node.where);
    const System& s = y.system();
    std::vector<Json> claims, level;
    const SystemClaim* first = nullptr;
    for (const SystemClaim& c : s.claims) {
      if (c.kind != SystemClaim::Kind::integral || !c.holds) continue;
      if (!first) {
        first = &c;
        for (const Equation& e : c.on)
          level.push_back(certify::to_json(y.written(e.difference)));
      }
      if (c.on.size() != first->on.size() || c.on.size() > 1 ||
          (!c.on.empty() && !(c.on[0].difference == first->on[0].difference)))
        continue;
      std::vector<Json> cofactors;
      for (const Equation& e : c.on)
        cofactors.push_back(
            certify::to_json(y.written(lie_derivative(s.field, c.value) / e.difference)));
      claims.push_back(Json{Json::Object{{"name", json_text(c.name)},
                                         {"value", certify::to_json(y.written(c.value))},
                                         {"cofactors", json_list(std::move(cofactors))}}});
    }
    s_.put_step(id, "integrals",
                {{"system", json_text(y.name())},
                 {"claims", json_list(std::move(claims))},
                 {"level", json_list(std::move(level))}});
    return certify::target_of(y.family(), {}, false);
  }

  const TheoremResult& t_;
  StrataParts s_;
  std::list<certify::Said> said_; ///< whose systems are those of targets
  std::vector<std::string> carried_;
};

[[noreturn]] void refuse(const certify::Rejected& no) {
  throw InternalError("the judge refuses the certificate of the theorem: " + no.step + ": " +
                      no.why);
}

// Certificates of other formats are not judged.
bool is_refused(const std::string& certificate) {
  try {
    if (certificate.find("kovacic-jets/1") < 60)
      return std::holds_alternative<certify::Rejected>(
          certify::check_jets(certify::read_jets_certificate(certificate)));
    return std::holds_alternative<certify::Rejected>(
        certify::check_way(certify::read_system_certificate(certificate)));
  } catch (const InvalidArgument&) {
    return false;
  }
}

// The node that a step of the certificate stands for.
auto owner_of(const std::string& step, TheoremResult& t) {
  const auto with = [&](const char* more) {
    return std::ranges::find_if(t.nodes, [&](const NodeResult& n) {
      return *more == 0 ? step == n.node.id : step.starts_with(n.node.id + more);
    });
  };
  const auto same = with("");
  return same != t.nodes.end() ? same : with("-");
}

// Steps that are too large for the judge, or of which it does not see where their certificate belongs, are on
// trust under their names; then it looks again.
TheoremBundle strata_bundle(TheoremResult& t, const std::string& directory,
                            const ProveOptions& options) {
  TheoremBundle b;
  std::map<std::string, std::string> refused;
  constexpr int most_refused = 40;
  for (int k = 0; k < most_refused; ++k) {
    try {
      b = bundle_of_strata(t, directory, refused, options);
    } catch (const DomainError& why) {
      return {.none = why.what()};
    }
    const auto verdict = certify::check_theorem(b.json);
    if (const auto* yes = std::get_if<certify::TheoremAccepted>(&verdict)) {
      b.open = yes->open;
      b.excluded = yes->excluded;
      if (b.on_trust.size() != yes->trusted)
        return {.none = "the judge counts " + std::to_string(yes->trusted) +
                        " steps on trust, and it was made with " +
                        std::to_string(b.on_trust.size())};
      return b;
    }
    const auto& no = std::get<certify::Rejected>(verdict);
    b.json.clear();
    b.none = no.step + ": " + no.why;
    const auto node = owner_of(no.id, t);
    const bool of_symmetry = no.id.starts_with("symmetry-") || no.id == t.nodes.front().node.id;
    if (of_symmetry && refused.emplace(all_symmetries, no.why).second) continue;
    // Not that the certificate is false, but that it is seen to be about this set, or that theorems have a
    // rule for it: for one with steps on trust they have none.
    const bool has_no_rule = node != t.nodes.end() &&
                             no.id.starts_with(certificate_step(node->node.id)) &&
                             std::ranges::none_of(node->certificates, is_refused);
    const bool is_link =
        node != t.nodes.end() && (!node->node.darboux.empty() || node->node.found.splitting ||
                                  has_no_rule || !node->node.found.special.empty() ||
                                  (node->node.kind == NodeKind::case_file &&
                                   !no.id.starts_with(certificate_step(node->node.id))));
    if (!no.limit && !is_link) refuse(no);
    if (node != t.nodes.end() && !node->node.found.studies.empty()) {
      study_again(*node, directory, options);
      continue;
    }
    const bool is_new =
        node != t.nodes.end() && node->node.kind != NodeKind::cover &&
        refused
            .emplace(node->node.id, has_no_rule && !node->trusted.empty()
                                        ? "its own certificate has steps on trust: " +
                                              joined(sentences(node->trusted), "; ")
                                        : no.why)
            .second;
    if (!is_new) return b;
  }
  return b;
}

} // namespace

TheoremBundle theorem_bundle(TheoremResult& t, const std::string& directory,
                             const ProveOptions& options) {
  if (t.complete_but_for_open_parts() && is_of_strata(t.theorem))
    return strata_bundle(t, directory, options);
  if (!t.complete()) return {.none = "the theorem is not proved"};
  try {
    TheoremBundle b = PlacedParts(t, directory, options.decide.budget)();
    const auto verdict = certify::check_theorem(b.json);
    if (const auto* no = std::get_if<certify::Rejected>(&verdict)) refuse(*no);
    return b;
  } catch (const DomainError& why) {
    return {.none = why.what()};
  }
}

} // namespace kov
