// The loop over manifold elements that dominates explicit runs: internal forces and elastic energy.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/elasticity.h"
#include "model/formulation.h"
#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// Properties common to the elements of one block.
struct ElementLaw {
  Elasticity law;
  Kinematics kinematics = Kinematics::corotational;
};

/// All elements of a pool in contiguous arrays. Work is cut into chunks of neighbouring elements; chunks of one colour
/// share no cover and run in parallel, colours run one after another, so every sum has a fixed order: the same bits for
/// any number of threads. Within a chunk, runs of whole lattice cells with consecutive covers need no index at all, and
/// vectorise.
class ElementForces {
 public:
  /// Appends a block's elements.   @param first  its first cover   @param scale  of the elements' areas
  /// @param initial  co-rotated initial stress (xx, yy, xy) per element; empty: none [Pa]
  void add(const CoverMesh& mesh, std::int32_t first, double scale, const ElementLaw& law,
           std::vector<std::array<double, 3>> initial);
  /// Cuts the work into chunks; called once, after the last block.
  void finish(std::int32_t covers);

  /// f += internal force of the positions q.
  /// @return the elastic energy [J]; not a number where a co-rotated element is turned inside out
  double add_force(std::span<const double> q, std::span<double> f) const;
  /// f -= rate times the material stiffness applied to v: stress rate C:U' in each element's co-rotated frame, so that
  /// rigid motion has none and the power is -rate U':C:U'.   @param rate [s]
  void add_rate_force(std::span<const double> q, std::span<const double> v, double rate, std::span<double> f) const;

  [[nodiscard]] std::size_t size() const { return cover_.size(); }
  [[nodiscard]] const std::array<std::int32_t, 3>& cover(std::size_t e) const { return cover_[e]; }
  [[nodiscard]] std::span<const std::array<std::int32_t, 3>> covers() const { return cover_; }
  [[nodiscard]] const Gradients& gradients(std::size_t e) const { return shapes_[shape_[e]]; }
  [[nodiscard]] double area(std::size_t e) const { return area_[e]; }
  [[nodiscard]] const ElementLaw& law(std::size_t e) const { return laws_[law_[e]]; }
  [[nodiscard]] Mat2 initial_stress(std::size_t e) const;
  /// F = sum_k x_k (grad w_k)^T
  [[nodiscard]] Mat2 gradient(std::size_t e, std::span<const double> q) const;
  [[nodiscard]] ElasticResponse response(std::size_t e, std::span<const double> q) const;

 private:
  /// Elements in a row: `count` lattice cells of two whole triangles, their covers at bottom, bottom + 1, ... and top,
  /// top + 1, ...; or single elements (bottom < 0).
  struct Run {
    std::int32_t element = 0, count = 0, bottom = -1, top = -1;
  };
  struct Chunk {
    std::int32_t begin = 0, end = 0;  // runs
  };
  [[nodiscard]] bool is_cell(std::size_t e) const;
  void find_runs();
  void colour_chunks(std::int32_t covers);
  double cells(const Run& run, const double* q, double* f) const;
  double singles(const Run& run, const double* q, double* f) const;

  // One entry per element.
  std::vector<std::array<std::int32_t, 3>> cover_;
  std::vector<std::uint32_t> shape_, law_;
  std::vector<double> area_;
  std::vector<std::array<double, 3>> initial_;  // empty if no block has any
  std::vector<char> whole_;                     // the whole triangle, with the full area of its block's lattice
  std::vector<Gradients> shapes_;
  std::vector<ElementLaw> laws_;

  std::vector<Run> runs_;
  std::vector<Chunk> chunks_;               // by colour
  std::vector<std::int32_t> colour_start_;  // into chunks_
  mutable std::vector<double> partial_;     // energies, per chunk
};

}  // namespace scree::nmm
