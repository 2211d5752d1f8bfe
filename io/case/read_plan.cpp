#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "coupling/bodies/methods.h"
#include "io/case/read_parts.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

using coupling::Integrator;
using namespace std::string_literals;

/// Method of every block of the model in a stage.
std::vector<std::string> methods_of_blocks(const coupling::Stage& stage, std::size_t blocks) {
  std::vector<std::string> methods(blocks, stage.method);
  for (const coupling::MethodRule& rule : stage.rules)
    for (const BlockId b : rule.blocks) methods[b.index()] = rule.method;
  return methods;
}

std::vector<coupling::MethodRule> read_rules(const Section& s, const Model& model,
                                             const std::vector<std::string>& methods) {
  const std::vector<std::string> known = names_of(model.blocks);
  std::vector<coupling::MethodRule> rules;
  std::set<BlockId> named;
  for (const Section& r : s.list("method_of")) {
    coupling::MethodRule rule;
    const std::size_t count = r.texts("blocks").size();
    if (count == 0)
      throw r.error("blocks", "the list of blocks is empty", "names of blocks", "name the blocks, or remove the rule");
    for (std::size_t i = 0; i < count; ++i)
      for (const std::int32_t b : find_names(r, "blocks", i, "block", known)) {
        rule.blocks.emplace_back(b);
        if (!named.insert(rule.blocks.back()).second)
          throw r.error("blocks", i,
                        fmt::format("block {} has a method already", in_quotes(known[static_cast<std::size_t>(b)])),
                        "each block once in method_of", "remove one of the two");
      }
    (void)find_name(r, "method", "method", methods);
    rule.method = r.text("method");
    rule.onefold = r.boolean("onefold");
    if (r.has("cover_size")) rule.cover_size = r.number("cover_size");
    for (const char* key : {"onefold", "cover_size"})
      if (rule.method != "nmm" && (key == std::string("onefold") ? rule.onefold : r.has(key)))
        throw r.error(key, fmt::format("the method {} has no covers", in_quotes(rule.method)), "the key beside \"nmm\"",
                      "remove it, or set method = \"nmm\"");
    if (rule.onefold && r.has("cover_size"))
      throw r.error("cover_size", "one cover around the whole block has no size to choose",
                    "onefold = true or cover_size", "remove one of the two");
    rule.model_triangle = r.text("triangle") == "model";
    if (rule.model_triangle && !rule.onefold)
      throw r.error("triangle", "a mesh has many triangles", "\"model\" beside onefold = true",
                    "add onefold = true, or remove the key");
    rules.push_back(std::move(rule));
  }
  return rules;
}

/// The first block with the NMM for which no cover size is given; invalid: none.
BlockId without_covers(const coupling::Stage& stage, const std::vector<std::string>& methods, const Model& model) {
  std::vector<char> sized(methods.size(), stage.cover_size > 0.0 ? 1 : 0);
  for (std::size_t b = 0; b < methods.size(); ++b) sized[b] |= methods[b] != "nmm" || model.blocks[b].cover_size > 0.0;
  for (const coupling::MethodRule& rule : stage.rules)
    for (const BlockId b : rule.blocks) sized[b.index()] |= rule.onefold || rule.cover_size > 0.0;
  const auto bare = std::find(sized.begin(), sized.end(), 0);
  return bare == sized.end() ? BlockId{} : BlockId{static_cast<std::int32_t>(bare - sized.begin())};
}

void check_nmm(const Section& s, const Section& m, coupling::Stage& stage, const Model& model) {
  std::vector<std::string> used = methods_of_blocks(stage, model.blocks.size());
  if (s.has("switch") && s.table("switch").has("back")) std::replace(used.begin(), used.end(), "dda"s, "nmm"s);
  if (!s.has("cover_size") && m.has("cover_size")) s.settle("cover_size", m.number("cover_size"));
  if (s.has("cover_size")) stage.cover_size = s.number("cover_size");
  if (std::find(used.begin(), used.end(), "nmm") == used.end()) return;
  if (const BlockId bare = without_covers(stage, used, model); bare.valid())
    throw s.error(
        "cover_size",
        fmt::format("block {} uses the NMM and no cover_size is given", in_quotes(model.blocks[bare.index()].name)),
        "number [m], > 0", "add cover_size here or to [model]: a tenth of the smallest block is a start");
}

coupling::Stage read_stage(const Section& s, const Section& m, const Model& model,
                           const std::vector<std::string>& methods, bool first) {
  coupling::Stage stage;
  stage.name = s.text("name");
  (void)find_name(s, "method", "method", methods);
  stage.method = s.text("method");
  stage.rules = read_rules(s, model, methods);
  const std::string& integrator = s.text("integrator");
  stage.integrator = integrator == "implicit"      ? Integrator::implicit
                     : integrator == "partitioned" ? Integrator::partitioned
                                                   : Integrator::explicit_;
  stage.dt = s.number_or_auto("dt");
  stage.safety = s.number("safety");
  stage.duration = ticks(s.number("duration"));
  stage.control.max_passes = s.integer("max_passes");
  stage.control.max_displacement = s.number_or_auto("max_displacement").value_or(0.0);
  check_nmm(s, m, stage, model);
  read_partition(s, model, stage);
  std::vector<std::string> used = methods_of_blocks(stage, model.blocks.size());
  check_divided(s, model, used, stage);
  if (s.has("switch")) used.insert(used.end(), {"nmm", "dda"});
  read_stage_options(s, used, first, stage);
  read_stage_rules(s, model, stage);
  if (stage.integrator != Integrator::explicit_ && !stage.dt)
    throw s.error("dt", fmt::format("{} {} stage needs a time step", integrator == "implicit" ? "an" : "a", integrator),
                  "number [s], > 0",
                  "implicit steps have no stability bound to take dt from: write dt = 1e-3, for example");
  return stage;
}

coupling::OutputPlan read_output(const Section& s, Tick total) {
  if (!s.has("every")) s.settle("every", seconds(std::max<Tick>(total / 100, 1)));
  if (!s.has("history_every")) s.settle("history_every", s.number("every"));
  return {ticks(s.number("every")), ticks(s.number("history_every")), s.boolean("contacts"),
          s.number("checkpoint_every"), s.integer("checkpoint_steps")};
}

coupling::LivePlan read_live(const Section& s) {
  const std::vector<std::string> schemes = {"udpm://", "memq://", "file://"};
  const std::string& url = s.text("url");
  // Others are refused here because LCM ends the program when, for example, a tcpq server cannot be reached.
  if (std::none_of(schemes.begin(), schemes.end(), [&](const std::string& k) { return url.starts_with(k); }))
    throw s.error("url", "the address has a scheme that is not supported", listed(schemes),
                  "write udpm://239.255.76.67:7667?ttl=0");
  return {s.boolean("enabled"), url, s.number("rate")};
}

bool uses(const coupling::Stage& stage, const std::string& method) {
  return stage.method == method ||
         std::any_of(stage.rules.begin(), stage.rules.end(), [&](const auto& r) { return r.method == method; });
}

/// Constants of the methods that have keys; a method that no stage uses needs none.
void read_constants(const Section& root, coupling::Plan& plan) {
  const std::vector<Section> stages = root.list("stage");
  for (const coupling::Method& m : coupling::registered_methods()) {
    if (m.keys.empty()) continue;
    const bool given = root.has("method") && root.table("method").has(m.name);
    const auto lacks =
        std::find_if(m.keys.begin(), m.keys.end(), [](const NumberKey& k) { return k.fallback.empty(); });
    if (!given && lacks != m.keys.end()) {
      for (std::size_t i = 0; i < stages.size(); ++i)
        if (uses(plan.stages[i], m.name))
          throw stages[i].error("method", fmt::format("the method {} has no constants", in_quotes(m.name)),
                                fmt::format("[method.{}] with {}", m.name, lacks->name),
                                fmt::format("add the table; {}: {}", lacks->name, lacks->meaning));
      continue;
    }
    std::vector<double>& values = plan.constants[m.name];
    for (const NumberKey& key : m.keys)
      values.push_back(given ? root.table("method").table(m.name).number(key.name)
                             : std::strtod(key.fallback.c_str(), nullptr));
    if (const std::string wrong = m.fault ? m.fault(values) : std::string(); !wrong.empty()) {
      if (!given) throw std::logic_error(fmt::format("method '{}': its defaults are invalid: {}", m.name, wrong));
      throw root.table("method").error(m.name, wrong, m.meaning, "`scree schema` explains each key");
    }
  }
}

}  // namespace

coupling::Plan read_plan(const Section& root, const Model& model, std::span<const std::string> methods) {
  const std::vector<std::string> known(methods.begin(), methods.end());
  const Section m = root.table("model");
  coupling::Plan plan;
  plan.detection = m.number_or_auto("detection").value_or(0.0);
  std::set<std::string> names;
  double total = 0.0;
  for (const Section& s : root.list("stage")) {
    if (!names.insert(s.text("name")).second)
      throw s.error("name", "two stages have the same name", "a name for each stage", "number the stages");
    plan.stages.push_back(read_stage(s, m, model, known, plan.stages.empty()));
    constexpr double kLongestRun = 8e6;  // [s]; a run counts 2^63 ticks of 1 ps
    if ((total += s.number("duration")) > kLongestRun)
      throw s.error("duration", "the stages together are too long", fmt::format("at most {:g} s in all", kLongestRun),
                    "shorten a stage");
  }
  read_construction(root, model, plan);
  Tick run = 0;
  for (const coupling::Stage& stage : plan.stages) run += stage.duration;
  plan.output = read_output(root.table("output"), run);
  plan.live = read_live(root.table("live"));
  read_constants(root, plan);
  plan.threads = root.table("run").integer("threads");
  plan.max_closure = root.table("run").number("max_closure");
  plan.max_passed_closure = root.table("run").number("max_passed_closure");
  plan.max_gain = root.table("run").number("max_gain");
  plan.max_slowdown = root.table("run").number("max_slowdown");
  return plan;
}

}  // namespace scree::io
