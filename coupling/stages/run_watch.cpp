#include "coupling/stages/run_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "coupling/contact/audit/audit.h"
#include "coupling/contact/audit/friction_check.h"

namespace scree::coupling {
namespace {

/// The column of the scheme with the largest value.
Column largest_scheme_column(const Ledger& ledger) {
  auto largest = Column::elastic_trapezoid;
  for (int c = 0; c < kColumns; ++c) {
    const auto column = static_cast<Column>(c);
    if (info(column).side == Side::scheme && !(ledger[column] <= ledger[largest])) largest = column;
  }
  return largest;
}

}  // namespace

double energy_of_round_off(const Model& model) {
  double sum = 0.0;
  for (const Block& b : model.blocks) sum += model.materials[b.material.index()].young * moments(b.polygon).area;
  return 1e-14 * sum;  // strains of 1e-7
}

std::optional<std::string> energy_from_nowhere(const Ledger& ledger, double most, double round_off, bool complete) {
  if (!(most > 0.0)) return std::nullopt;
  const double gain = complete ? ledger.gain() : ledger.least_gain();
  if (!std::isfinite(gain)) return std::nullopt;  // Driver::check_finite() names the number
  if (gain <= most * std::max(ledger.passed_given(), round_off)) return std::nullopt;
  const Column column = largest_scheme_column(ledger);
  const std::string where =
      ledger[column] > 0.5 * gain
          ? fmt::format("the ledger's column '{}' contains {:.3g} J of it", info(column).name, ledger[column])
          : std::string("no column of the ledger contains it: the time scheme itself is unstable");
  return fmt::format(
      "the blocks hold {:.3g} J, and {:.3g} J were given to them by initial motion and work: the rest has no "
      "source ({}). Either the steps are too long (force_dt, or safety above 0.95: use dt = \"auto\" and a smaller "
      "safety), or contacts are far stiffer than the blocks (normal_stiffness, penalty), or a force is wrong; "
      "run.max_gain sets what is allowed",
      ledger.held(), ledger.given(), where);
}

std::vector<std::string> large_scheme_columns(const Ledger& ledger, ReportedWarnings& reported) {
  std::vector<std::string> lines;
  const double passed = ledger.passed();
  for (int c = 0; c < kColumns; ++c) {
    const auto column = static_cast<Column>(c);
    if (!info(column).watched || std::abs(ledger[column]) <= kSchemeShare * passed) continue;
    if (std::find(reported.columns.begin(), reported.columns.end(), c) != reported.columns.end()) continue;
    reported.columns.push_back(c);
    const char* what = column == Column::deformation_damping
                           ? "it regularises sliding and is not a property of the rock; compare with another "
                             "sliding_damping of the stage"
                           : "the scheme itself adds or removes it; use shorter steps (safety, dt) and compare";
    lines.push_back(fmt::format(
        "the ledger's column '{}' ({}) has {:.3g} J, {:.2g} of the {:.3g} J that passed, more than {:g}: {}",
        info(column).name, info(column).meaning, ledger[column], std::abs(ledger[column]) / passed, passed,
        kSchemeShare, what));
  }
  return lines;
}

std::vector<std::string> lost_friction(const Model& model, const State& state, RunStats& stats,
                                       ReportedWarnings& reported) {
  struct Pair {
    std::pair<std::int32_t, std::int32_t> blocks;
    double ratio;
    ContactKey key;
  };
  std::vector<Pair> lost;
  for (const ContactMemory& m : state.contacts) {
    const auto ratio = static_cast<double>(m.slide.worst);
    if (ratio < stats.friction_ratio) {
      stats.friction_ratio = ratio;
      stats.friction_key = m.key;
    }
    if (m.slide.worst < FrictionCheck::kLeast)
      lost.push_back({std::minmax(m.key.block_p, m.key.block_e), ratio, m.key});
  }
  std::sort(lost.begin(), lost.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.blocks, a.ratio, a.key) < std::tie(b.blocks, b.ratio, b.key);
  });
  std::vector<std::string> lines;
  for (const Pair& p : lost) {
    const std::array pair{p.blocks.first, p.blocks.second};
    if (reported.has(pair)) continue;
    reported.add(pair);
    lines.push_back(fmt::format(
        "{}: sliding friction was {:.3f} of what its strength and normal force give; the block flutters or hops on "
        "its contacts, and slides too far (docs/theory/contact-law.md, \"Friction check\"): raise the joint's "
        "damping, give the stage more damping, or use other steps, and compare",
        contact_name(model, p.key), p.ratio));
  }
  return lines;
}

}  // namespace scree::coupling
