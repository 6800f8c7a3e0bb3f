#include "systems/mechanics.hpp"
#include "exact/lists.hpp"
#include "symbol/given_text.hpp"

#include "equations/result.hpp"

#include "decide/words.hpp"
#include "equations/present.hpp"
#include "equations/present_strata.hpp"
#include "equations/recognized.hpp"
#include "integrability/matrices.hpp"

#include <algorithm>
#include <ostream>

namespace kov::cli {

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

const char* kind_of(const FoundIntegral& f) {
  return f.hamiltonian ? "hamiltonian" : f.casimir ? "casimir" : "integral";
}

namespace {

Json factored_or_null(const std::optional<MFraction>& f) {
  return f ? Json(to_factored_string(*f)) : Json(nullptr);
}

Json decision_json(const Decision& d) {
  Json j;
  j["group"] = d.group ? group_json(*d.group) : Json(nullptr);
  j["identity_component"] = d.component ? Json(to_string(*d.component)) : Json(nullptr);
  j["abelian"] = word_of(d.abelian);
  j["case"] = d.kovacic_case ? Json(*d.kovacic_case) : Json(nullptr);
  j["reason"] = reason(d);
  return j;
}

} // namespace

std::string title_of(const SystemClaim& claim) {
  using Kind = SystemClaim::Kind;
  const std::string kind = claim.kind == Kind::integral  ? "integral"
                           : claim.kind == Kind::casimir ? "casimir"
                           : claim.kind == Kind::darboux ? "darboux"
                           : claim.kind == Kind::poisson ? "poisson"
                                                         : "equal";
  return kind + " " + (claim.name.empty() ? claim.text : claim.name);
}

ParameterValues parameter_values(const Settings& settings) {
  ParameterValues values;
  for (const auto& [name, e] : settings.settings())
    values.emplace_back(name, std::string(e.text()));
  return values;
}

int written_report(const Settings& settings, const Report& report) {
  const bool json = settings.format == "json" && !report.json.is_null();
  write_output(settings, json ? indented(report.json) : report.text);
  return report.exit;
}

Report supervised(const Settings& settings, const std::string& file,
                  const std::function<Report()>& work) {
  return supervised(settings, file, [&](const FileWorker::SoFar&) { return work(); });
}

Report supervised(const Settings& settings, const std::string& file,
                  const std::function<Report(const FileWorker::SoFar&)>& work) {
  const auto job = [&](std::string_view, const FileWorker::SoFar& so_far) { return work(so_far); };
  return FileWorker(settings, file, job).ask("");
}

namespace {

std::string packed_report(const Report& r) {
  return dump({{"exit", r.exit}, {"text", r.text}, {"json", r.json}, {"at_work", r.at_work}});
}

Report unpacked_report(const std::string& text) {
  const Json j = Json::parse(text);
  return {j.at("exit"), j.at("text"), j.at("json"), {}, j.at("at_work")};
}

} // namespace

std::string stage_in(std::string_view early) {
  const Json j = Json::parse(early, nullptr, false);
  return j.is_object() ? j.value("at_work", "") : "";
}

FileWorker::FileWorker(const Settings& settings, const std::string& file, Work work)
    : settings_(settings), file_(for_children(file)),
      worker_(settings, [file, work = std::move(work)](std::string_view job, std::ostream& out,
                                                       const Worker::Early& early) {
        try {
          const Report r = work(job, [&](const Report& so_far) { early(packed_report(so_far)); });
          out << packed_report(r);
          return r.exit;
        } catch (const DomainError& e) {
          throw InputError(file, 0, 0, 1, e.what());
        } catch (const InvalidArgument& e) {
          throw InputError(file, 0, 0, 1, e.what());
        }
      }) {}

Report FileWorker::ask(std::string_view job) {
  const TextAnswer a = worker_.ask(job);
  if (a.error) throw *a.error;
  Report r;
  r.exit = a.exit;
  if (!a.limit.empty() && !a.early.empty()) {
    r = unpacked_report(a.early);
    r.limit = a.limit;
  } else if (!a.limit.empty()) {
    r.limit = a.limit;
    r.json = Json{{"format", "kovacic-result/1"}, {"input", Json{{"file", file_}}}};
    set_undecided(r.json, "budget", a.limit);
    r.text = file_ + "\n  UNDECIDED\n" + limit_lines(a.limit);
  } else if (a.exit == exit_internal || a.exit == exit_interrupted) {
    Answer failure;
    failure.exit = a.exit;
    failure.internal = a.internal;
    report_failure(settings_, failure);
    if (!a.early.empty()) r = unpacked_report(a.early);
    r.exit = a.exit;
    r.limit = a.exit == exit_interrupted ? "interrupted" : "internal error: " + a.internal;
  } else {
    r = unpacked_report(a.text);
  }
  return r;
}

Json json_of(const LinearSystem& s) {
  return Json{{"unknowns", s.names},
              {"matrix", list_of(s.a, [](const auto& row) { return texts(row); })}};
}

Json json_of(const NormalVariationalEquation& e) {
  return Json{{"unknown", e.unknown}, {"a1", to_string(e.a1)}, {"a0", to_string(e.a0)}};
}

Json json_of(const System& s, const AlgebraicOde& ode) {
  Json parameters = Json::array();
  Json constants = Json::array();
  const auto& algebraic = s.field.constants;
  for (const std::size_t i : used_variables(ode.r))
    if (i != ode.z) (!is_among(i, algebraic) ? parameters : constants).push_back(s.ring()->name(i));
  return Json{{"unknown", ode.unknown},
              {"change", ode.change},
              {"variable", s.ring()->name(ode.z)},
              {"parameters", parameters},
              {"constants", constants},
              {"relations", texts(s.field.relations)},
              {"z_dot_squared", factored_or_null(ode.z_dot_squared)},
              {"z_ddot", factored_or_null(ode.z_ddot)},
              {"p", factored_or_null(ode.p)},
              {"q", factored_or_null(ode.q)},
              {"r", to_factored_string(ode.r)},
              {"generic", texts(ode.generic)},
              {"checks", ode.checks}};
}

Json json_of(const System& s, const BlockReport& b) {
  Json j{{"unknowns", b.unknowns}};
  if (b.ode) j["equation"] = json_of(s, *b.ode);
  if (b.decision) j["decision"] = decision_json(*b.decision);
  if (b.strata) put_strata(j, *b.strata);
  if (!b.special.empty()) j["merging"] = texts(b.special);
  if (!b.energies.empty()) {
    j["energies"] = list_of(b.energies, [&](const EnergyResult& e) {
      Json one{{"at", sentence(e.at)}, {"why", why(e)}};
      if (e.r) one["r"] = to_string(*e.r, s.ring()->name(b.ode->z));
      if (e.decision) one["decision"] = decision_json(*e.decision);
      if (e.strata) put_strata(one, *e.strata);
      if (!e.missing.empty()) one["note"] = note(e.missing);
      return one;
    });
  }
  const bool mixed = b.abelian == Truth::unknown && b.strata && b.strata->decided();
  j["abelian"] = mixed ? "depends" : word_of(b.abelian);
  if (!b.missing.empty()) j["note"] = note(b.missing);
  return j;
}

Json json_of(const System& s, const ManifoldReport& m) {
  Json j{{"name", m.name}, {"verdict", to_string(m.verdict)}};
  if (m.failure) {
    j["failure"] = Json{{"message", m.failure->message},
                        {"component", m.failure->component},
                        {"value", to_string(m.failure->value)}};
    return j;
  }
  for (const std::string& constant : s.adjoined)
    j["constants"].push_back(constant);
  j["theorem"] = m.by ? m.by->id() : "";
  j["function_class"] = m.by ? sentence(m.by->integrals) : "";
  if (m.by)
    for (const std::string& name : m.by->integrals.without)
      j["integrals_without"].push_back(name);
  if (const std::string text = statement(m); !text.empty()) j["statement"] = text;
  if (const std::string open = not_checked(m); !open.empty()) j["not_checked"] = open;
  if (m.matrices)
    j["matrices"] = Json{{"size", m.matrices->size},
                         {"unknowns", m.matrices->unknowns},
                         {"change", m.matrices->change},
                         {"level", sentence(m.matrices->level)},
                         {"reason", reason(*m.matrices)}};
  if (m.manifold) {
    const auto text = [](const auto& equation) { return equation.text; };
    j["equations"] = list_of(m.manifold->equations, text);
    j["level"] = list_of(m.manifold->levels, text);
    j["proof"] = m.manifold->proof;
    if (!m.manifold->rewritten.empty()) j["rewritten"] = m.manifold->rewritten;
  }
  j["eliminated"] = list_of(m.reduced.eliminations, [](const auto& e) {
    return Json{{"integral", e.integral}, {"unknown", e.unknown}};
  });
  j["blocks"] = list_of(m.blocks, [&](const BlockReport& b) { return json_of(s, b); });
  j["reasons"] = reasons(m);
  j["trusted_steps"] = sentences(trusted_steps(m));
  return j;
}

Json json_of(const ClaimReport& c) {
  Json j{{"name", title_of(c.claim)},         {"claim", c.claim.text},
         {"proved", c.result.proved},         {"claimed", c.claim.holds},
         {"detail", c.result.detail},         {"value", to_string(c.result.witness)},
         {"generic", texts(c.result.generic)}};
  if (!c.result.open.empty()) j["undecided"] = c.result.open;
  return j;
}

Json json_of_field(const System& s) {
  Json field;
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    field[s.field.name(j)] = to_string(s.field.components[j]);
  const auto name = [&](std::size_t i) { return s.ring()->name(i); };
  Json j{{"coordinates", list_of(s.field.coordinates, name)},
         {"parameters", list_of(s.field.parameters, name)},
         {"relations", texts(s.field.relations)},
         {"field", field}};
  if (s.field.hamiltonian) j["hamiltonian"] = to_string(*s.field.hamiltonian);
  for (const FunctionSymbol& f : s.field.functions)
    if (!f.meaning.empty()) j["functions"][s.ring()->name(f.variable)] = f.meaning;
  return j;
}

} // namespace kov::cli
