#include "model/block_cutting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "model/cell_grid.h"
#include "model/line_graph.h"
#include "model/outline.h"
#include "model/sliver_join.h"

namespace scree {
namespace {

constexpr std::int32_t kNoRegion = -1;
constexpr int kMostRounds = 4;  // of extended lines
using Role = SourceLine::Role;

std::pair<double, double> key_of(const Vec2& p) { return {p.y(), p.x()}; }

/// A line for the graph, written from its lower end, so that its direction in the case file changes no bit.
SourceLine source(Vec2 a, Vec2 b, Role role, JointId law, std::size_t priority, double beyond_a = 0.0,
                  double beyond_b = 0.0) {
  if (key_of(b) < key_of(a)) {
    std::swap(a, b);
    std::swap(beyond_a, beyond_b);
  }
  return {a, b, role, law, beyond_a, beyond_b, static_cast<std::int32_t>(priority)};
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  return (p - a - std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm();
}

class Cutter {
 public:
  explicit Cutter(const Domain& domain)
      : domain_(domain),
        grid_(domain.snap.value_or(auto_snap(domain))),
        least_width_(domain.least_width.value_or(auto_least_width(domain))) {
    const Box box = bounds(domain.outline);
    straight_ = 1e-12 * (box.hi - box.lo).maxCoeff();
  }

  Cutting cut() {
    out_.lines = draw_lines(domain_.network, domain_.outline, &out_.sets);
    Faces cut = faces();
    // Extended lines may end at other extended lines: a few rounds are enough.
    for (int round = 0; domain_.dead_ends == DeadEnds::extend && round < kMostRounds && extend(cut.dead); ++round)
      cut = faces();
    std::vector<Face> faces = std::move(cut.faces);
    std::erase_if(faces, [this](const Face& f) { return !contains(domain_.outline, f.inside); });
    std::sort(faces.begin(), faces.end(),
              [](const Face& f, const Face& g) { return lowest_first(f) < lowest_first(g); });
    join(faces);
    add_blocks(faces);
    add_cracks(cut.dead);
    finish_report();
    return std::move(out_);
  }

 private:
  /// The outer ring from its lowest vertex on: no two faces share it.
  static std::vector<std::int32_t> lowest_first(const Face& f) {
    std::vector<std::int32_t> ring = f.rings.front();
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  Faces faces() {
    sources_.clear();
    collect_sources();
    graph_ = node_lines(sources_, grid_);
    std::erase_if(graph_.edges, [this](const GraphEdge& e) { return !cuts(e); });
    place_vertices(graph_, sources_);
    return faces_of(graph_);
  }

  /// Extends each dead end by a line to the nearest line in its way.   @return true if any line was added
  bool extend(const std::vector<GraphEdge>& dead) {
    std::map<std::int32_t, int> degree;
    for (const GraphEdge& e : graph_.edges) {
      ++degree[e.a];
      ++degree[e.b];
    }
    std::vector<JointLine> more;
    for (const GraphEdge& e : dead) {
      if (e.discontinuity < 0) continue;
      for (const auto& [tip, other] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
        if (degree[tip] != 1) continue;
        const SourceLine& own = sources_[static_cast<std::size_t>(e.discontinuity)];
        Vec2 along = (own.b - own.a).normalized();
        const Vec2& from = vertex(tip);
        if (along.dot(from - vertex(other)) < 0.0) along = -along;
        const double reach = first_hit(from, along, e.discontinuity);
        if (!(reach > 0.0)) continue;
        JointLine line = out_.lines[static_cast<std::size_t>(own.priority) - boundaries_];
        line.from = from;
        line.to = from + reach * along;
        more.push_back(line);
        ++out_.report.ends_extended;
        out_.report.extended_length += reach;
      }
    }
    out_.lines.insert(out_.lines.end(), more.begin(), more.end());
    return !more.empty();
  }

  /// Distance to the first other line along a ray; 0 if that line is at the start of the ray, or if there is none.
  [[nodiscard]] double first_hit(const Vec2& from, const Vec2& along, std::int32_t own) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (static_cast<std::int32_t>(i) == own) continue;
      const Vec2 d = sources_[i].b - sources_[i].a, to = sources_[i].a - from;
      const double sine = cross(along, d);
      if (std::abs(sine) < 1e-9 * d.norm()) continue;
      const double t = cross(to, d) / sine, s = cross(to, along) / sine;
      if (s >= 0.0 && s <= 1.0 && t > -grid_) nearest = std::min(nearest, t);
    }
    return std::isfinite(nearest) && nearest > 4.0 * grid_ ? nearest : 0.0;
  }

  void collect_sources() {
    const auto add_ring = [this](const Ring& ring, Role role, JointId law) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        sources_.push_back(source(ring[i], ring[(i + 1) % ring.size()], role, law, sources_.size()));
    };
    for (std::size_t r = 0; r < domain_.outline.rings(); ++r) add_ring(domain_.outline.ring(r), Role::outline, {});
    for (const Region& r : domain_.regions) add_ring(r.outline, Role::region, r.joint);
    const std::size_t boundaries = boundaries_ = sources_.size();

    // A line cut off at a boundary ends on it up to rounding, on either side. It is extended until it has left the
    // grid cells of the boundary, so that the two cross. The overruns are removed as edges outside or as dead ends.
    CellGrid near(bounds(domain_.outline), boundaries + 1);
    for (std::size_t i = 0; i < boundaries; ++i)
      near.insert(sources_[i].a, sources_[i].b, 2.0 * grid_, static_cast<std::int32_t>(i));
    const auto overrun = [&](const Vec2& p, const Vec2& along) {
      double length = 0.0;
      for (const std::int32_t i : near.at(p)) {
        const SourceLine& s = sources_[static_cast<std::size_t>(i)];
        if (distance(p, s.a, s.b) > grid_) continue;
        const double sine = std::abs(cross(along, (s.b - s.a).normalized()));
        if (sine > 1e-2) length = std::max(length, 3.0 * grid_ / sine);  // a line along the boundary needs no crossing
      }
      return length;
    };
    for (const JointLine& line : out_.lines) {
      const Vec2 along = (line.to - line.from).normalized();
      sources_.push_back(source(line.from, line.to, Role::discontinuity, line.joint, sources_.size(),
                                overrun(line.from, along), overrun(line.to, along)));
    }
    std::sort(sources_.begin(), sources_.end(), [](const SourceLine& s, const SourceLine& t) {
      return std::tuple(s.role, key_of(s.a), key_of(s.b), s.priority) <
             std::tuple(t.role, key_of(t.a), key_of(t.b), t.priority);
    });
  }
  [[nodiscard]] double longest_overrun() const { return 300.0 * grid_; }

  /// False for edges outside the domain, and for joints in regions that they do not cut.
  [[nodiscard]] bool cuts(const GraphEdge& e) const {
    const auto role = e.boundary < 0 ? Role::discontinuity : sources_[static_cast<std::size_t>(e.boundary)].role;
    if (role == Role::outline) return true;
    const Vec2 middle = 0.5 * (graph_.node(e.a) + graph_.node(e.b));
    if (!contains(domain_.outline, middle)) return false;
    if (role == Role::region) return true;
    const std::int32_t r = region_at(middle);
    return r == kNoRegion || domain_.regions[static_cast<std::size_t>(r)].cut;
  }

  [[nodiscard]] std::int32_t region_at(const Vec2& p) const {
    for (std::size_t r = 0; r < domain_.regions.size(); ++r)
      if (contains({domain_.regions[r].outline, {}}, p)) return static_cast<std::int32_t>(r);
    return kNoRegion;
  }

  /// Joins slivers; afterwards `faces` are the faces of the graph without the edges between joined faces.
  void join(std::vector<Face>& faces) {
    for (const Face& f : faces) region_.push_back(region_at(f.inside));
    const SliverJoin joined = join_slivers(graph_, faces, region_, {domain_.least_area, least_width_});
    out_.report.slivers_joined = joined.joined;
    out_.report.slivers_left = joined.left;
    if (joined.joined == 0) return;

    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> left;  // group to the left of a directed edge
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const auto& ring : faces[f].rings)
        for (std::size_t i = 0; i < ring.size(); ++i) left[{ring[i], ring[(i + 1) % ring.size()]}] = joined.group[f];
    LineGraph between = graph_;
    std::erase_if(between.edges, [&](const GraphEdge& e) {
      const auto one = left.find({e.a, e.b}), other = left.find({e.b, e.a});
      if (one == left.end() && other == left.end()) return true;  // a dead end
      return one != left.end() && other != left.end() && one->second == other->second;
    });
    std::vector<std::int32_t> region;
    std::vector<Face> blocks;
    for (Face& f : faces_of(between).faces) {
      const auto group = left.find({f.rings[0][0], f.rings[0][1]});
      if (group == left.end()) continue;  // an opening
      blocks.push_back(std::move(f));
      region.push_back(region_[static_cast<std::size_t>(group->second)]);
    }
    std::vector<std::size_t> order(blocks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return lowest_first(blocks[i]) < lowest_first(blocks[j]); });
    faces.clear();
    region_.clear();
    for (const std::size_t i : order) {
      faces.push_back(std::move(blocks[i]));
      region_.push_back(region[i]);
    }
  }

  [[nodiscard]] const Vec2& vertex(std::int32_t v) const { return graph_.vertices[static_cast<std::size_t>(v)]; }

  [[nodiscard]] const GraphEdge& edge(std::int32_t a, std::int32_t b) const {
    const std::pair key{std::min(a, b), std::max(a, b)};
    return *std::lower_bound(graph_.edges.begin(), graph_.edges.end(), key,
                             [](const GraphEdge& e, const auto& k) { return std::pair(e.a, e.b) < k; });
  }

  [[nodiscard]] JointId law(const GraphEdge& e) const {
    if (e.boundary >= 0 && sources_[static_cast<std::size_t>(e.boundary)].role == Role::outline) return {};
    if (e.discontinuity >= 0) return sources_[static_cast<std::size_t>(e.discontinuity)].law;
    return e.boundary >= 0 ? sources_[static_cast<std::size_t>(e.boundary)].law : JointId{};
  }

  /// A corner of a block and the law of the edge that leaves it.
  using Corner = std::pair<std::int32_t, JointId>;

  /// Ring of a block, from its lowest vertex on, without the vertices at which a straight edge with one law was noded.
  /// A vertex that had to stay on the grid beside its line is kept: without it blocks would have a gap or an overlap.
  [[nodiscard]] std::vector<Corner> straightened(const std::vector<std::int32_t>& ring) const {
    std::vector<Corner> kept, all;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const GraphEdge &before = edge(ring[(i + n - 1) % n], ring[i]), &after = edge(ring[i], ring[(i + 1) % n]);
      const bool same_line = (before.boundary >= 0 && before.boundary == after.boundary) ||
                             (before.discontinuity >= 0 && before.discontinuity == after.discontinuity);
      all.emplace_back(ring[i], law(after));
      const bool straight =
          same_line && distance(vertex(ring[i]), vertex(ring[(i + n - 1) % n]), vertex(ring[(i + 1) % n])) <= straight_;
      if (!straight || law(before) != law(after)) kept.push_back(all.back());
    }
    if (kept.size() < 3) kept = all;
    std::rotate(kept.begin(), std::min_element(kept.begin(), kept.end()), kept.end());
    return kept;
  }

  void add_blocks(const std::vector<Face>& faces) {
    std::map<std::int32_t, int> count;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const bool free = region_[f] == kNoRegion;
      const Region* region = free ? nullptr : &domain_.regions[static_cast<std::size_t>(region_[f])];
      Block block;
      block.name = fmt::format("{}-{}", free ? domain_.prefix : region->name, ++count[region_[f]]);
      block.material = free ? domain_.material : region->material;
      block.joint = !free && region->joint.valid() ? region->joint : domain_.joint;
      if (!free) block.cover_size = region->cover_size;
      block.polygon.holes.resize(faces[f].rings.size() - 1);
      std::vector<std::vector<Corner>> rings;
      for (const auto& ring : faces[f].rings) rings.push_back(straightened(ring));
      std::sort(rings.begin() + 1, rings.end());
      for (std::size_t r = 0; r < rings.size(); ++r) {
        block.edges.emplace_back();
        for (const auto& [v, law] : rings[r]) {
          block.polygon.ring(r).push_back(vertex(v));
          block.edges.back().push_back(law);
        }
      }
      out_.blocks.push_back(std::move(block));
    }
  }

  void add_cracks(const std::vector<GraphEdge>& dead) {
    // Connected pieces: each vertex points towards the lowest one of its piece.
    std::map<std::int32_t, std::int32_t> root;
    const auto find = [&](std::int32_t v) {
      root.try_emplace(v, v);
      while (root[v] != v) v = root[v] = root[root[v]];
      return v;
    };
    for (const GraphEdge& e : dead) {
      const std::int32_t a = find(e.a), b = find(e.b);
      root[std::max(a, b)] = std::min(a, b);
    }
    const auto length = [this](const GraphEdge& e) { return (vertex(e.b) - vertex(e.a)).norm(); };
    std::map<std::int32_t, double> piece;
    for (const GraphEdge& e : dead) piece[find(e.a)] += length(e);

    const double least = domain_.dead_ends == DeadEnds::drop ? std::numeric_limits<double>::infinity()
                                                             : std::max(least_width_, 2.0 * longest_overrun());
    std::vector<GraphEdge> kept = dead;
    std::erase_if(kept, [&](const GraphEdge& e) { return e.discontinuity < 0 || piece[find(e.a)] < least; });
    std::sort(kept.begin(), kept.end(),
              [](const GraphEdge& e, const GraphEdge& f) { return std::pair(e.a, e.b) < std::pair(f.a, f.b); });
    CuttingReport& r = out_.report;
    for (const auto& [v, l] : piece) {
      if (l >= least) {
        ++r.cracks_kept;
        r.crack_length += l;
      } else if (l > 2.0 * longest_overrun()) {
        ++r.cracks_trimmed;
        r.trimmed_length += l;
      }
    }
    CellGrid near(bounds(domain_.outline), out_.blocks.size());
    for (std::size_t b = 0; b < out_.blocks.size(); ++b)
      near.insert(bounds(out_.blocks[b].polygon), static_cast<std::int32_t>(b));
    for (const GraphEdge& e : kept) {
      const Vec2 &from = vertex(e.a), &to = vertex(e.b);
      const Vec2 middle = 0.5 * (from + to);
      for (const std::int32_t b : near.at(middle))
        if (contains(out_.blocks[static_cast<std::size_t>(b)].polygon, middle)) {
          out_.cracks.push_back({from, to, law(e), BlockId{b}});
          break;
        }
    }
  }

  void finish_report() {
    CuttingReport& r = out_.report;
    r.blocks = static_cast<std::int64_t>(out_.blocks.size());
    r.lines = static_cast<std::int64_t>(out_.lines.size());
    r.snap = grid_;
    r.least_width = least_width_;
    r.least_area = r.least_edge = r.least_angle = std::numeric_limits<double>::infinity();
    for (const Block& b : out_.blocks) {
      double area = 0.0;
      for (std::size_t k = 0; k < b.polygon.rings(); ++k) {
        const Ring& ring = b.polygon.ring(k);
        area += signed_area(ring);
        for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
          r.least_edge = std::min(r.least_edge, (ring[(i + 1) % n] - ring[i]).norm());
          r.least_angle = std::min(r.least_angle, interior_angle(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]));
        }
      }
      r.area += area;
      r.least_area = std::min(r.least_area, area);
    }
    double whole = 0.0;
    for (std::size_t k = 0; k < domain_.outline.rings(); ++k) whole += signed_area(domain_.outline.ring(k));
    // Blocks that the polygoniser could not close would be missing.
    const Box box = bounds(domain_.outline);
    if (std::abs(r.area - whole) > 1e-9 * whole + 4.0 * grid_ * (box.hi - box.lo).sum())
      throw CuttingError(fmt::format("the blocks cover {:.12g} of {:.12g} m2", r.area, whole));
  }

  const Domain& domain_;
  double grid_, least_width_;
  double straight_;  // largest distance from a straight line of a corner that is left out [m]
  Cutting out_;
  std::vector<SourceLine> sources_;
  std::size_t boundaries_ = 0;  // number of sources that are not joints
  LineGraph graph_;
  std::vector<std::int32_t> region_;  // of each face
};

}  // namespace

Cutting cut_blocks(const Domain& domain) { return Cutter(domain).cut(); }

}  // namespace scree
