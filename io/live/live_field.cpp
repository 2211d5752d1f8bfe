#include "io/live/live_field.h"

#include <algorithm>
#include <cmath>

namespace scree::io {
namespace {

constexpr std::array<std::string_view, kLiveFields> kNames{"speed", "mean_stress", "s1",  "s3",    "shear",
                                                           "sxx",   "syy",         "sxy", "joint", "integrator"};

/// The worst state of the contacts of each block.
void take_joint_states(std::vector<double>& out, const coupling::State& state, std::span<const std::int32_t> cells) {
  std::int32_t most = -1;
  for (const std::int32_t block : cells) most = std::max(most, block);
  out.assign(static_cast<std::size_t>(most) + 1, 0.0);  // without cells: most = -1, size 0
  for (const coupling::ContactMemory& c : state.contacts) {
    if (c.status == coupling::ContactStatus::open) continue;
    const double rank = c.status == coupling::ContactStatus::stick ? 1.0 : c.failed != 0 ? 3.0 : 2.0;
    for (const std::int32_t block : {c.key.block_p, c.key.block_e}) {
      if (block < 0 || block > most) continue;
      double& worst = out[static_cast<std::size_t>(block)];
      worst = std::max(worst, rank);
    }
  }
}

/// 0 explicit, 1 implicit per cell; in a partitioned stage that of its block, or of its part of a divided block.
void take_integrators(std::vector<double>& out, const coupling::FrameView& view) {
  const std::span<const std::int32_t> block = view.mesh->cell_block;
  out.assign(block.size(), view.integrator == coupling::Integrator::explicit_ ? 0.0 : 1.0);
  if (view.integrator != coupling::Integrator::partitioned || view.state == nullptr) return;
  for (std::size_t c = 0; c < block.size(); ++c) {
    const char side = view.state->explicit_side[static_cast<std::size_t>(block[c])];
    if (side == 1 || (side == coupling::kDivided && view.mesh->cell_explicit[c] != 0)) out[c] = 0.0;
  }
}

double mean_speed(const RawFrame& frame, std::size_t cell) {
  const LiveMesh& mesh = *frame.mesh;
  const std::int32_t first = mesh.offsets[cell], last = mesh.offsets[cell + 1];
  double sum = 0.0;
  for (std::int32_t k = first; k < last; ++k) {
    const auto p = static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(k)]);
    sum += std::sqrt(frame.source[2 * p] * frame.source[2 * p] + frame.source[2 * p + 1] * frame.source[2 * p + 1]);
  }
  return sum / std::max(1, last - first);
}

/// s = m +- r,  m = (xx + yy)/2,  r = |((xx - yy)/2, xy)|
double of_stress(LiveField field, double xx, double yy, double xy) {
  const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
  switch (field) {
    case LiveField::mean_stress:
      return mean;
    case LiveField::s1:
      return mean + radius;
    case LiveField::s3:
      return mean - radius;
    case LiveField::shear:
      return radius;
    case LiveField::sxx:
      return xx;
    case LiveField::syy:
      return yy;
    default:
      return xy;
  }
}

}  // namespace

std::string_view name(LiveField field) { return kNames[static_cast<std::size_t>(field)]; }

std::optional<LiveField> live_field(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<LiveField>(found - kNames.begin());
}

std::optional<LiveField> live_field(double number) {
  if (!(number >= 0.0) || number >= static_cast<double>(kLiveFields) || number != std::floor(number))
    return std::nullopt;
  return static_cast<LiveField>(static_cast<int>(number));
}

bool take_source(RawFrame& frame, const coupling::FrameView& view) {
  const std::size_t points = frame.mesh->points(), cells = frame.mesh->cells();
  const auto copy = [&](std::span<const double> values, std::size_t wanted) {
    frame.source.assign(values.begin(), values.end());
    return values.size() == wanted;
  };
  switch (frame.field) {
    case LiveField::speed:
      return copy(view.velocity, 2 * points);
    case LiveField::joint:
      if (view.state == nullptr) return false;
      take_joint_states(frame.source, *view.state, frame.mesh->block);
      return true;
    case LiveField::integrator:
      if (view.mesh == nullptr || view.mesh->cell_block.size() != cells) return false;
      take_integrators(frame.source, view);
      return true;
    default:
      return copy(view.stress, 3 * cells);
  }
}

std::vector<float> cell_values(const RawFrame& frame) {
  const LiveMesh& mesh = *frame.mesh;
  std::vector<float> values(mesh.cells());
  for (std::size_t c = 0; c < values.size(); ++c) {
    double value = 0.0;
    if (frame.field == LiveField::speed)
      value = mean_speed(frame, c);
    else if (frame.field == LiveField::integrator)
      value = frame.source[c];
    else if (frame.field == LiveField::joint)
      value = frame.source[static_cast<std::size_t>(mesh.block[c])];
    else
      value = of_stress(frame.field, frame.source[3 * c], frame.source[3 * c + 1], frame.source[3 * c + 2]);
    values[c] = static_cast<float>(value);
  }
  return values;
}

}  // namespace scree::io
