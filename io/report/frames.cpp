#include "io/report/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "io/pictures/frame_field.h"
#include "io/pictures/recovered_stress.h"

namespace scree::io {
namespace {

constexpr int kBits = 11;                  // of velocities and stresses: 1 in 4000, finer than any colour
constexpr int kPlaceBits = 16;             // of displacements and contact points: 1 in 130,000, finer than any pixel
constexpr std::size_t kMostFrames = 2000;  // packed at all: a longer run is thinned before it is read
constexpr std::size_t kComponents = 3;

std::vector<float> floats(const std::vector<double>& values, int bits) {
  std::vector<float> out;
  out.reserve(values.size());
  for (const double v : values) out.push_back(rounded(v, bits));
  return out;
}

/// xx, yy, xy per point: the recovered stress; a point of two nodes of the recovery has their mean.
std::vector<double> point_stress(const StoredFrame& f) {
  const std::vector<double> corner = recovered_stress(f);
  std::vector<double> sum(kComponents * f.points(), 0.0), count(f.points(), 0.0);
  for (std::size_t i = 0; i < f.connectivity.size(); ++i) {
    const auto p = static_cast<std::size_t>(f.connectivity[i]);
    for (std::size_t k = 0; k < kComponents; ++k) sum[kComponents * p + k] += corner[kComponents * i + k];
    count[p] += 1.0;
  }
  for (std::size_t p = 0; p < f.points(); ++p)
    for (std::size_t k = 0; k < kComponents; ++k) sum[kComponents * p + k] /= std::max(1.0, count[p]);
  return sum;
}

/// The closed contact points of a frame.
void add_contacts(Chunk& chunk, const StoredContacts& c, const Vec2& base) {
  std::vector<float> position, normal, force, slip;
  std::vector<std::int32_t> blocks;
  std::vector<std::uint8_t> state;
  for (std::size_t i = 0; i < c.state.size(); ++i) {
    if (c.state[i] == 0) continue;
    for (const std::size_t axis : {0U, 1U}) {
      position.push_back(rounded(c.position[2 * i + axis] - base[static_cast<Eigen::Index>(axis)], kPlaceBits));
      normal.push_back(rounded(c.normal[2 * i + axis], kBits));
    }
    force.insert(force.end(), {rounded(c.fn[i], kBits), rounded(c.ft[i], kBits)});
    slip.push_back(rounded(c.slip[i], kBits));
    blocks.insert(blocks.end(), {c.corner_block[i], c.edge_block[i], c.law[i]});
    state.push_back(static_cast<std::uint8_t>(c.state[i] | (c.failed[i] != 0 ? 4 : 0)));
  }
  chunk.add("c.position", std::span<const float>(position));
  chunk.add("c.normal", std::span<const float>(normal));
  chunk.add("c.force", std::span<const float>(force));
  chunk.add("c.slip", std::span<const float>(slip));
  chunk.add("c.blocks", std::span<const std::int32_t>(blocks));
  chunk.add("c.state", std::span<const std::uint8_t>(state));
}

/// The nodes of the bolts that are installed.
void add_bolts(Chunk& chunk, const StoredBolts& bolts, const Vec2& base) {
  std::vector<float> position, force;
  for (std::size_t i = 0; i < bolts.bolt.size(); ++i) {
    for (const std::size_t axis : {0U, 1U})
      position.push_back(rounded(bolts.position[2 * i + axis] - base[static_cast<Eigen::Index>(axis)], kPlaceBits));
    force.push_back(rounded(bolts.force[i], kBits));
  }
  chunk.add("b.position", std::span<const float>(position));
  chunk.add("b.force", std::span<const float>(force));
  chunk.add("b.bolt", std::span<const std::int32_t>(bolts.bolt));
}

/// The ranges of all fields that have numbers, grown frame by frame.
class Ranges {
 public:
  explicit Ranges(const RunReader& run) : run_(&run) {}

  void add(const StoredFrame& f) {
    std::vector<char> skip;
    for (const std::int32_t b : f.block) skip.push_back(run_->blocks()[static_cast<std::size_t>(b)].held ? 1 : 0);
    for (const Field field :
         {Field::displacement, Field::speed, Field::sxx, Field::syy, Field::sxy, Field::s1, Field::s3})
      grow(field_names()[static_cast<std::size_t>(field)], f, field, cell_values(f, field), skip);
    std::vector<double> shear;
    for (std::size_t c = 0; c < f.cells(); ++c) shear.push_back(0.5 * (f.principal[2 * c] - f.principal[2 * c + 1]));
    grow("shear", f, Field::s1, shear, skip);
    for (const std::size_t axis : {0U, 1U}) {
      std::vector<double> u;
      for (std::size_t c = 0; c < f.cells(); ++c) u.push_back(std::abs(f.cell_displacement[2 * c + axis]));
      grow(axis == 0 ? "ux" : "uy", f, Field::displacement, u, skip);
      std::vector<double> v;
      for (std::size_t c = 0; c < f.cells(); ++c) v.push_back(std::abs(f.cell_velocity[2 * c + axis]));
      grow(axis == 0 ? "vx" : "vy", f, Field::speed, v, skip);
    }
  }

  [[nodiscard]] std::vector<ReportRange> all() const {
    std::vector<ReportRange> out;
    for (const auto& [name, most] : most_) {
      const bool one_sided = name == "displacement" || name == "speed" || name == "shear";
      const double high = most > 0.0 ? most : 1.0;
      out.push_back({name, one_sided ? 0.0 : -high, high});
    }
    return out;
  }

 private:
  /// @param like  the field whose rule decides what the range covers
  void grow(const std::string& name, const StoredFrame& f, Field like, const std::vector<double>& values,
            const std::vector<char>& skip) {
    const double noise = rounding_of(like, f, run_->materials());
    double& most = most_[name];
    // A frame without values above rounding does not count: colour_range gives it a range of one.
    const bool anything = [&] {
      for (std::size_t c = 0; c < values.size(); ++c)
        if (skip[c] == 0 && std::abs(values[c]) > noise) return true;
      return false;
    }();
    if (anything) most = std::max(most, colour_range(f, like, values, skip, noise).second);
  }

  const RunReader* run_;
  std::map<std::string, double> most_;
};

class Bounds {
 public:
  void add(const StoredFrame& f, const Vec2& base) {
    for (std::size_t p = 0; p < f.points(); ++p) {
      const Vec2 x = Vec2(f.position[2 * p], f.position[2 * p + 1]) - base;
      if (!x.allFinite()) continue;
      low_ = low_.cwiseMin(x), high_ = high_.cwiseMax(x);
    }
  }
  [[nodiscard]] std::array<double, 4> all() const {
    if (!(low_.x() <= high_.x())) return {0.0, 0.0, 1.0, 1.0};
    return {low_.x(), low_.y(), high_.x(), high_.y()};
  }

 private:
  Vec2 low_ = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high_ = Vec2::Constant(-std::numeric_limits<double>::infinity());
};

/// First and last frames of each mesh and stage.
std::vector<char> edges_of(const std::vector<ReportFrame>& frames) {
  std::vector<char> kept(frames.size(), 0);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool first = i == 0 || frames[i - 1].mesh != frames[i].mesh || frames[i - 1].stage != frames[i].stage;
    if (!first) continue;
    kept[i] = 1;
    if (i > 0) kept[i - 1] = 1;
  }
  if (!frames.empty()) kept.back() = 1;
  return kept;
}

/// Leaves out frames until the rest takes no more than `bytes`.
void thin(std::vector<ReportFrame>& frames, std::size_t bytes) {
  const std::vector<char> kept = edges_of(frames);
  for (std::size_t stride = 1; stride <= frames.size(); ++stride) {
    const std::vector<std::size_t> stay = thinned(kept, stride);
    std::size_t size = 0;
    for (const std::size_t i : stay) size += frames[i].text.size();
    if (size > bytes && stride < frames.size()) continue;
    std::vector<ReportFrame> out;
    out.reserve(stay.size());
    for (const std::size_t i : stay) out.push_back(std::move(frames[i]));
    frames = std::move(out);
    return;
  }
}

}  // namespace

Chunk mesh_chunk(const StoredFrame& f, const Vec2& base) {
  std::vector<float> origin;
  for (std::size_t p = 0; p < f.points(); ++p)
    for (const int axis : {0, 1}) {
      const std::size_t i = 2 * p + static_cast<std::size_t>(axis);
      origin.push_back(static_cast<float>(f.position[i] - f.displacement[i] - base[axis]));
    }
  const auto ints = [](const auto& values) { return std::vector<std::int32_t>(values.begin(), values.end()); };
  Chunk chunk;
  chunk.add("origin", std::span<const float>(origin));
  chunk.add("offsets", std::span<const std::int32_t>(ints(f.offsets)));
  chunk.add("cells", std::span<const std::int32_t>(ints(f.connectivity)));
  chunk.add("block", std::span<const std::int32_t>(f.block));
  chunk.add("material", std::span<const std::int32_t>(f.material));
  chunk.add("method", std::span<const std::int32_t>(f.method));
  return chunk;
}

Chunk frame_chunk(const RunReader& run, const StoredFrame& f, const Vec2& base) {
  Chunk chunk;
  chunk.add("displacement", std::span<const float>(floats(f.displacement, kPlaceBits)));
  chunk.add("velocity", std::span<const float>(floats(f.velocity, kBits)));
  chunk.add("stress", std::span<const float>(floats(point_stress(f), kBits)));
  const std::vector<std::uint8_t> integrator(f.cell_integrator.begin(), f.cell_integrator.end());
  chunk.add("integrator", std::span<const std::uint8_t>(integrator));
  if (run.has_contacts()) add_contacts(chunk, run.contacts(static_cast<std::size_t>(f.index)), base);
  if (run.has_bolts()) add_bolts(chunk, run.bolts(static_cast<std::size_t>(f.index)), base);
  return chunk;
}

std::vector<std::size_t> thinned(const std::vector<char>& kept, std::size_t stride) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i] != 0 || i % stride == 0) out.push_back(i);
  return out;
}

ReportFrames pack_frames(const RunReader& run, const Vec2& base, std::size_t bytes) {
  ReportFrames out;
  out.stored = run.times().size();
  const std::size_t stride = bytes == 0 ? 1 : (out.stored + kMostFrames - 1) / kMostFrames;
  std::map<std::int64_t, std::size_t> mesh_place;
  Ranges ranges(run);
  Bounds bounds;
  for (std::size_t i = 0; i < out.stored; ++i) {
    if (i % std::max<std::size_t>(1, stride) != 0 && i + 1 != out.stored) continue;
    const StoredFrame f = run.frame(i);
    const auto [place, is_new] = mesh_place.emplace(f.mesh, out.meshes.size());
    if (is_new) {
      out.meshes.push_back(mesh_chunk(f, base).text());
      out.first.push_back(i);
    }
    ranges.add(f);
    bounds.add(f, base);
    out.frames.push_back({i, f.step, place->second, f.time, f.stage, f.integrator, frame_chunk(run, f, base).text()});
  }
  if (bytes > 0) {
    std::size_t meshes = 0;
    for (const std::string& mesh : out.meshes) meshes += mesh.size();
    thin(out.frames, bytes > meshes ? bytes - meshes : 0);
  }
  out.ranges = ranges.all();
  out.bounds = bounds.all();
  return out;
}

ReportFrames list_frames(const RunReader& run, const Vec2& base, std::size_t looked) {
  ReportFrames out;
  const std::vector<StoredNote> notes = run.notes();
  out.stored = notes.size();
  std::map<std::int64_t, std::size_t> mesh_place;
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const StoredNote& n = notes[i];
    const auto [place, is_new] = mesh_place.emplace(n.mesh, out.first.size());
    if (is_new) out.first.push_back(i), seen.insert(i);
    out.frames.push_back({i, n.step, place->second, n.time, n.stage, n.integrator, {}});
  }
  out.meshes.resize(out.first.size());
  const std::size_t stride = std::max<std::size_t>(1, (notes.size() + looked - 1) / looked);
  for (std::size_t i = 0; i < notes.size(); i += stride) seen.insert(i);
  if (!notes.empty()) seen.insert(notes.size() - 1);
  Ranges ranges(run);
  Bounds bounds;
  for (const std::size_t i : seen) {
    const StoredFrame f = run.frame(i);
    ranges.add(f);
    bounds.add(f, base);
  }
  out.ranges = ranges.all();
  out.bounds = bounds.all();
  return out;
}

}  // namespace scree::io
