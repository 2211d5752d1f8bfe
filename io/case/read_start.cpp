// Times at which motions, functions and loads begin, and whether they begin in a stage of the plan.
#include <fmt/format.h>

#include <algorithm>

#include "coupling/bodies/clocks.h"
#include "io/case/read_parts.h"

namespace scree::io {
namespace {

std::vector<std::string> stage_names(const Section& root) {
  std::vector<std::string> names;
  for (const Section& stage : root.list("stage")) names.push_back(stage.text("name"));
  return names;
}

/// The section of each function of a model: those of the case, then those of loads with a start of their own.
std::vector<Section> sections_of_functions(const Section& root) {
  std::vector<Section> out;
  for (const Section::Named& named : root.named("function")) out.push_back(named.section);
  for (const char* list : {"point_load", "traction", "body_acceleration"})
    for (const Section& load : root.list(list))
      if (load.has("start")) out.push_back(load);
  return out;
}

/// Refuses a stage to rest during which a motion moves the base: the rest that it reports would be false.
void check_rest(const Section& root, const Model& model) {
  const std::vector<Section> stages = root.list("stage");
  std::vector<double> begins{0.0};
  for (const Section& s : stages) begins.push_back(begins.back() + s.number("duration"));
  for (const BlockSupport& support : model.block_supports) {
    if (!support.motion.valid()) continue;
    const GroundMotion::Setting& motion = model.motions[support.motion.index()].setting();
    const double first = (motion.stage.valid() ? begins[motion.stage.index()] : 0.0) + motion.start,
                 last = first + model.motions[support.motion.index()].facts().duration;
    for (std::size_t i = 0; i < stages.size(); ++i) {
      if (!stages[i].boolean("rest") || first >= begins[i + 1] || last <= begins[i]) continue;
      const auto next = std::find_if(stages.begin() + static_cast<std::ptrdiff_t>(i), stages.end(),
                                     [](const Section& s) { return !s.boolean("rest"); });
      throw stages[i].error("rest",
                            fmt::format("the motion '{}' moves the base from {:g} s to {:g} s, while this stage, from "
                                        "{:g} s to {:g} s, removes all "
                                        "motion",
                                        motion.name, first, last, begins[i], begins[i + 1]),
                            "false, or a motion at another time",
                            next == stages.end()
                                ? "add a stage without rest for the motion"
                                : fmt::format("let the motion begin later: start = \"{}\" in [motion.{}]",
                                              next->text("name"), motion.name));
    }
  }
}

}  // namespace

Start read_start(const Section& s, const Section& root) {
  Start out;
  if (s.is_text("start")) {
    out.stage = StageId{find_name(s, "start", "stage", stage_names(root))};
    out.time = s.has("offset") ? s.number("offset") : 0.0;
  } else {
    if (s.has("offset"))
      throw s.error("offset", "it is counted from the beginning of a stage, and start names none",
                    "beside start = \"STAGE\"", "name the stage in start, or add it to the time there");
    out.time = s.number("start");
  }
  return out;
}

void check_times(const Section& root, const Model& model, const coupling::Plan& plan) {
  check_rest(root, model);
  const std::vector<Section::Named> motions = root.named("motion");
  const std::vector<Section> functions = sections_of_functions(root);
  for (const coupling::TimeFault& f : coupling::time_faults(model, plan)) {
    if (f.kind != coupling::TimeFault::Kind::missed) continue;  // the run warns about it
    const Section& s = f.motion ? motions[f.index].section : functions[f.index];
    throw s.error("start", coupling::text(f, model) + ": it acts in no stage",
                  fmt::format("the name of a stage, or a time before {:g} s", f.run_end),
                  fmt::format("write start = \"{}\", or make a stage last longer", plan.stages.back().name));
  }
}

}  // namespace scree::io
