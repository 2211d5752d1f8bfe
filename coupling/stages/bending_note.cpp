#include "coupling/stages/bending_note.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace scree::coupling {

std::optional<std::string> bending_note(const Model& model, const Stage& stage) {
  if (stage.method != "nmm") return std::nullopt;
  double worst = kBendingExcess, cover = 0.0, thickness = 0.0;
  BlockId block;
  std::size_t stiff = 0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const BlockId id{static_cast<std::int32_t>(i)};
    const double size = model.blocks[i].cover_size > 0.0 ? model.blocks[i].cover_size : stage.cover_size;
    if (!(size > 0.0) || model.support_of(id) != nullptr) continue;
    const Moments m = moments(model.blocks[i].polygon);
    const Eigen::SelfAdjointEigenSolver<Mat2> axes(m.second, Eigen::EigenvaluesOnly);
    const double t = std::sqrt(12.0 * axes.eigenvalues()[0] / m.area),
                 length = std::sqrt(12.0 * axes.eigenvalues()[1] / m.area);
    const double excess = bending_excess(size, t);
    if (length < kBendingSlender * t || excess <= kBendingExcess) continue;
    ++stiff;
    if (excess <= worst) continue;
    worst = excess;
    block = id;
    cover = size;
    thickness = t;
  }
  if (!block.valid()) return std::nullopt;
  // The formula holds for fine covers; beyond twice the stiffness its value is not meaningful.
  return fmt::format(
      "stage '{}': covers of {:.3g} m make block '{}', {:.3g} m thick, bend {}{}; covers of {:.2g} m do so by {:.0f} %",
      stage.name, cover, model.blocks[block.index()].name, thickness,
      worst > 1.0 ? "more than twice too stiffly, or not at all"
                  : fmt::format("about {:.0f} % too stiffly", 100.0 * worst),
      stiff > 1 ? fmt::format(", and {} more by a tenth at least", stiff - 1) : "",
      thickness * std::sqrt(kBendingExcess / bending_excess(1.0, 1.0)), 100.0 * kBendingExcess);
}

}  // namespace scree::coupling
