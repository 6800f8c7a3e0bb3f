#include "theorem/bundle.hpp"

#include "certify/jets/check.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/check.hpp"
#include "certify/theorem/fact.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "proof/algebra/arithmetic.hpp"
#include "splitting/perturbation.hpp"
#include "theorem/bundle_place.hpp"
#include "theorem/bundle_rules.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"
#include "theorem/strata.hpp"

#include <algorithm>

namespace kov {
namespace {

/// A step of the certificate that the cover needs.
struct BundlePart {
  std::string id;
  std::vector<Condition> region; ///< in the ring of the theorem's system
};

class Bundle {
public:
  Bundle(const TheoremResult& t, std::string directory, const Budget& budget)
      : t_(t), directory_(std::move(directory)), budget_(budget) {}

  std::string operator()() {
    const NodeResult& root = t_.nodes.front();
    if (root.node.kind != NodeKind::cover || t_.theorem.system.empty() ||
        !root.node.place.at.empty() || !root.node.place.conditions.empty())
      throw DomainError("the first step is not a cover of all parameters");
    whole_ = &family(t_.theorem.system, {});
    for (const std::string& id : root.node.needs)
      if (const NodeResult& n = find(id); n.says != Conclusion::none) put_part(n);
    put_cover(root);
    carried_.push_back(root.node.id);
    std::vector<Json> families;
    for (const auto& f : families_)
      families.push_back(f->json_with_lagrangian());
    return certify::to_string(Json{Json::Object{{"format", json_text("kovacic-theorem/1")},
                                                {"title", json_text(t_.theorem.title)},
                                                {"systems", json_list(std::move(families))},
                                                {"steps", json_list(std::move(steps_))}}});
  }

  [[nodiscard]] std::vector<std::string> carried() const { return carried_; }

private:
  const NodeResult& find(const std::string& id) const {
    return *std::ranges::find_if(t_.nodes, [&](const NodeResult& n) { return n.node.id == id; });
  }

  // ---- systems

  static std::string name_of(const std::string& file, const ParameterValues& where) {
    std::string name = file;
    for (const auto& [p, value] : where)
      name += ", " + p + " = " + value;
    return name;
  }
  BundleFamily& family(const std::string& file, const ParameterValues& where) {
    return family(read_system(beside(directory_, file), where), name_of(file, where));
  }
  BundleFamily& family(System s, const std::string& name) {
    for (const auto& f : families_)
      if (f->name() == name) return *f;
    for (const std::size_t i : s.field.parameters) // as all members of a family are
      s.real.insert(s.ring()->name(i));
    s.domain = {}; // its denominators stand beside the assumptions
    families_.push_back(std::make_unique<BundleFamily>(std::move(s), name));
    if (!families_.back()->family().is_plain())
      throw DomainError("the system of " + name + " is not given by a Hamiltonian and a bracket");
    return *families_.back();
  }

  void put_step(const std::string& id, const std::string& rule, Json::Object members) {
    Json::Object step{{"id", json_text(id)}, {"rule", json_text(rule)}};
    for (auto& m : members)
      step.push_back(std::move(m));
    steps_.push_back(Json{std::move(step)});
  }

  // ---- a part of the cover

  void put_part(const NodeResult& n) {
    try {
      const std::string own = n.node.id + "-step";
      const Place& p = n.node.place;
      if (p.of.empty()) {
        parts_.push_back(put_place(n, put_own_step(n, own), n.node.id, *whole_));
      } else {
        BundleFamily& low = lowest_family(find(p.of));
        const BundlePart there = put_place(n, put_own_step(n, own), n.node.id + "-place", low);
        parts_.push_back(put_lowest_order(n, there, low));
        carried_.push_back(p.of);
      }
      carried_.push_back(n.node.id);
    } catch (const DomainError& why) {
      throw DomainError("step '" + n.node.id + "': " + why.what());
    } catch (const InvalidArgument& why) {
      throw DomainError("step '" + n.node.id + "': " + why.what());
    }
  }

  /// The statement of the step about the system of its own file.
  struct Own {
    std::string id;
    certify::Target target;
    certify::Said said{}; ///< of a certificate
  };
  Own put_own_step(const NodeResult& n, const std::string& id) {
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

  Own put_certificate(const NodeResult& n, const std::string& id) {
    std::string why = "none was written";
    for (const std::string& json : n.certificates) {
      try {
        Own own{id, {}, said_by(json)};
        if (own.said.kind != certify::FactKind::not_integrable)
          throw DomainError("the certificate does not say \"not integrable\" of all its points");
        own.target = *own.said.target;
        put_step(id, "certificate", {{"certificate", certify::parse_json(json, 512)}});
        return own;
      } catch (const Error& no) {
        why = no.what();
      }
    }
    throw DomainError(why);
  }

  Own put_literature(const NodeResult& n, const std::string& id) {
    BundleFamily& y =
        family(read_system(parse_document(n.node.theorem->system, n.node.theorem->id)),
               n.node.theorem->id);
    put_step(id, "literature",
             {{"system", json_text(y.name())}, {"theorem", json_text(n.node.theorem->id)}});
    return {id, certify::target_of(y.family(), {}, true)};
  }

  Own put_integrals(const NodeResult& n, const std::string& id) {
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
      const MFraction along = lie_derivative(s.field, c.value);
      std::vector<Json> cofactors;
      if (!c.on.empty())
        cofactors.push_back(is_zero(along)
                                ? json_text("0")
                                : certify::to_json(y.written(along / c.on[0].difference)));
      claims.push_back(Json{Json::Object{{"name", json_text(c.name)},
                                         {"value", certify::to_json(y.written(c.value))},
                                         {"cofactors", json_list(std::move(cofactors))}}});
    }
    put_step(id, "integrals",
             {{"system", json_text(y.name())},
              {"claims", json_list(std::move(claims))},
              {"level", json_list(std::move(level))}});
    return {id, certify::target_of(y.family(), {}, false)};
  }

  // ---- splitting

  Own put_splitting(const NodeResult& n, const std::string& id) {
    BundleFamily& y = family(n.node.file, n.node.where);
    const System& s = y.system();
    std::vector<Condition> region;
    for (const std::string& text : n.domain) {
      const Assumption a = condition(s, text);
      region.push_back(y.moved({a.value.num(), std::get<Sign>(a.says)}));
    }
    put_step(id, "splitting",
             splitting_members(y, perturbation_of_euler(s, n.node.small), n.node.small, region,
                               budget_));
    return {id, certify::target_of(y.family(), region, true)};
  }

  // ---- the place of a step

  BundlePart put_place(const NodeResult& n, const Own& own, const std::string& id,
                       BundleFamily& x) {
    const Place& p = n.node.place;
    const System base = read_system(beside(directory_, x.name()), p.at);
    std::vector<Condition> region;
    for (const Condition& c : conditions_of(x.system(), p))
      region.push_back(x.moved(c));
    const PartPlace here = x.placed(p.at, base, std::move(region));
    const PlaceMap map = n.map ? *n.map : identity_map(base);
    Json::Object members{{"of", json_text(own.id)},
                         {"system", json_text(x.name())},
                         {"at", here.values},
                         {"region", json_conditions(here.region)}};
    for (auto& m : map_members(x, here, map, own.target, budget_))
      members.push_back(std::move(m));
    put_step(id, "place", std::move(members));
    return {id, here.conditions()};
  }
  // ---- lowest order

  BundleFamily& lowest_family(const NodeResult& n) {
    const System whole = read_system(beside(directory_, t_.theorem.system));
    System s = read_system(beside(directory_, n.node.other), n.node.where);
    s.assumptions.clear();
    for (Assumption a : whole.assumptions) {
      a.value = transfer(a.value, s.ring());
      s.assumptions.push_back(std::move(a));
    }
    return family(std::move(s), n.node.other);
  }

  BundlePart put_lowest_order(const NodeResult& n, const BundlePart& there, BundleFamily& low) {
    const System& s = whole_->system();
    if (s.weights.empty()) throw DomainError("the system has no weights");
    Json::Object members{{"of", json_text(there.id)}};
    for (auto& m : lowest_order_members(*whole_, low, s.weights, budget_))
      members.push_back(std::move(m));
    put_step(n.node.id, "lowest-order", std::move(members));
    std::vector<Condition> region;
    for (const Condition& c : there.region)
      region.push_back(
          {is_zero(c.p) ? MPoly(whole_->ring()) : transfer(MFraction(c.p), whole_->ring()).num(),
           c.sign});
    return {n.node.id, std::move(region)};
  }
  // ---- the cover

  void put_cover(const NodeResult& root) {
    std::vector<Substitution> symmetries;
    std::vector<Json> names, parts;
    for (std::size_t i = 0; i < root.symmetries.size(); ++i) {
      const std::string id = "symmetry-" + std::to_string(i + 1);
      put_symmetry(id, root.symmetries[i], symmetries);
      names.push_back(json_text(id));
    }
    for (const BundlePart& p : parts_)
      parts.push_back(json_text(p.id));
    const auto tree = tree_of_regions(whole_->proof(budget_), whole_->assumptions(),
                                      regions(symmetries), budget_);
    if (!tree) throw DomainError("the cover of the parameters: no proof without Z3 was found");
    put_step(root.node.id, "cover",
             {{"system", json_text(whole_->name())},
              {"symmetries", json_list(std::move(names))},
              {"parts", json_list(std::move(parts))},
              {"tree", *tree}});
  }
  void put_symmetry(const std::string& id, const PlaceMap& map,
                    std::vector<Substitution>& symmetries) {
    const certify::Target y = certify::target_of(whole_->family(), {}, false);
    Json::Object members{{"system", json_text(whole_->name())}};
    for (auto& m : map_members(*whole_, whole_->placed(Substitution(), {}), map, y, budget_))
      members.push_back(std::move(m));
    put_step(id, "symmetry", std::move(members));
    Substitution put;
    for (const std::string& p : whole_->parameters())
      put[whole_->ring()->index(p)] = transfer(map.values.at(p), whole_->ring());
    symmetries.push_back(std::move(put));
  }

  // The regions under all products of symmetries: first the first letter of the word is put in.
  [[nodiscard]] std::vector<RegionOfPart>
  regions(const std::vector<Substitution>& symmetries) const {
    struct Product {
      std::vector<std::size_t> word;
      Substitution put;
    };
    Substitution same;
    for (const std::string& p : whole_->parameters())
      same[whole_->ring()->index(p)] = MFraction::variable(whole_->ring(), p);
    std::vector<Product> all{{{}, same}};
    constexpr std::size_t most = 48;
    for (std::size_t i = 0; i < all.size() && all.size() <= most; ++i)
      for (std::size_t k = 0; k < symmetries.size(); ++k) {
        Product next{all[i].word, {}};
        next.word.push_back(k);
        for (const auto& [x, value] : all[i].put)
          next.put[x] = substitute(value, symmetries[k]);
        if (std::ranges::none_of(all, [&](const Product& p) { return p.put == next.put; }))
          all.push_back(std::move(next));
      }
    std::vector<RegionOfPart> found;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (const Product& p : all) {
        found.push_back({k, std::nullopt, {}, p.word});
        for (const Condition& c : parts_[k].region)
          found.back().conditions.push_back({substitute(c.p, p.put).num(), c.sign});
      }
    return found;
  }

  const TheoremResult& t_;
  std::string directory_;
  const Budget& budget_;
  std::vector<std::unique_ptr<BundleFamily>> families_;
  BundleFamily* whole_ = nullptr;
  std::vector<Json> steps_;
  std::vector<BundlePart> parts_;
  std::vector<std::string> carried_;
};

} // namespace

namespace {

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
TheoremBundle strata_bundle(TheoremResult& t, const std::string& directory, const StudyAgain& again,
                            const Budget& budget) {
  TheoremBundle b;
  std::map<std::string, std::string> refused;
  constexpr int most_refused = 40;
  for (int k = 0; k < most_refused; ++k) {
    try {
      BundleOfStrata made = bundle_of_strata(t, directory, refused, again, budget);
      b.json = std::move(made.json);
      b.on_trust = std::move(made.on_trust);
      b.carried = std::move(made.carried);
      b.by_points = std::move(made.by_points);
    } catch (const DomainError& why) {
      b.none = why.what();
      return b;
    }
    const auto verdict = certify::check_theorem(b.json);
    if (const auto* yes = std::get_if<certify::TheoremAccepted>(&verdict)) {
      b.open = yes->open;
      b.excluded = yes->excluded;
      if (b.on_trust.size() != yes->trusted)
        return {.json = {},
                .none = "the judge counts " + std::to_string(yes->trusted) +
                        " steps on trust, and it was made with " +
                        std::to_string(b.on_trust.size())};
      return b;
    }
    const auto& no = std::get<certify::Rejected>(verdict);
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
    b.json.clear();
    if (!no.limit && !is_link) refuse(no);
    if (node != t.nodes.end() && !node->node.found.studies.empty()) {
      again(*node);
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
                             const StudyAgain& again, const Budget& budget) {
  TheoremBundle b;
  if (t.complete_but_for_open_parts() && is_of_strata(t.theorem))
    return strata_bundle(t, directory, again, budget);
  if (!t.complete()) {
    b.none = "the theorem is not proved";
    return b;
  }
  try {
    Bundle bundle(t, directory, budget);
    b.json = bundle();
    b.carried = bundle.carried();
  } catch (const DomainError& why) {
    b.none = why.what();
    return b;
  }
  const auto verdict = certify::check_theorem(b.json);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) refuse(*no);
  return b;
}

} // namespace kov
