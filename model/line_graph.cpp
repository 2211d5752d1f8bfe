#include "model/line_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "model/cell_grid.h"
#include "model/check.h"
#include "model/geos.h"
#include "model/main_direction.h"
#include "model/random.h"

namespace scree {
namespace {

/// A vertex on the grid as whole numbers, y first: the order of vertices.
using GridPoint = std::pair<std::int64_t, std::int64_t>;
GridPoint on_grid(const Vec2& p, double grid) { return {std::llround(p.y() / grid), std::llround(p.x() / grid)}; }

double distance(const Vec2& p, const SourceLine& s) {
  const Vec2 d = s.b - s.a;
  const double along = std::clamp((p - s.a).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (p - s.a - along * d).norm();
}

/// Calls see(a, b) for every straight piece of the lines in a geometry.
template <class See>
void each_piece(const Geos& geos, const GEOSGeometry* g, See&& see) {
  const int type = GEOSGeomTypeId_r(geos.get(), g);
  if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) {
    const GEOSCoordSequence* s = GEOSGeom_getCoordSeq_r(geos.get(), g);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(geos.get(), s, &n);
    Vec2 before(0.0, 0.0);
    for (unsigned i = 0; i < n; ++i) {
      Vec2 p(0.0, 0.0);
      GEOSCoordSeq_getXY_r(geos.get(), s, i, &p.x(), &p.y());
      if (i > 0) see(before, p);
      before = p;
    }
  } else if (type == GEOS_MULTILINESTRING || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < GEOSGetNumGeometries_r(geos.get(), g); ++i)
      each_piece(geos, GEOSGetGeometryN_r(geos.get(), g, i), see);
  }
}

/// The direction of more than half of the total length, if there are very many lines; else the x axis.
Vec2 main_direction(const std::vector<SourceLine>& sources) {
  if (sources.size() < kManyLines) return {1.0, 0.0};
  MainDirection main;
  for (const SourceLine& s : sources) main.add(s.b - s.a);
  return main.share() > 0.5 ? main.along() : Vec2(1.0, 0.0);
}

/// Order in which the lines are passed to GEOS. Its tree of nodes is not balanced: very many lines in the order of
/// their ends would degenerate it to a list.
std::vector<std::size_t> drawing_order(std::size_t lines) {
  std::vector<std::size_t> order(lines);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (lines < kManyLines) return order;
  Random random(1);
  for (std::size_t i = lines - 1; i > 0; --i) std::swap(order[i], order[random.bits() % (i + 1)]);
  return order;
}

std::vector<SourceLine> turned(std::vector<SourceLine> sources, const Mat2& axes) {
  for (SourceLine& s : sources) {
    s.a = axes * s.a;
    s.b = axes * s.b;
  }
  return sources;
}

/// Sources of each edge, in the axes of the grid: lines within 1.5 grid widths of both ends of the edge (snap rounding
/// moves a line by at most 0.71).
void find_sources(LineGraph& graph, const std::vector<SourceLine>& sources) {
  if (graph.edges.empty()) return;
  Box box{sources.front().a, sources.front().a};
  for (const SourceLine& s : sources) box = {box.lo.cwiseMin(s.a).cwiseMin(s.b), box.hi.cwiseMax(s.a).cwiseMax(s.b)};
  const double reach = 1.5 * graph.grid;
  CellGrid cells(box, graph.edges.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
    cells.insert(sources[i].a, sources[i].b, 2.0 * reach, static_cast<std::int32_t>(i));
  for (GraphEdge& e : graph.edges) {
    const Vec2 &p = graph.snapped[static_cast<std::size_t>(e.a)], &q = graph.snapped[static_cast<std::size_t>(e.b)];
    for (const std::int32_t i : cells.at(0.5 * (p + q))) {
      const SourceLine& s = sources[static_cast<std::size_t>(i)];
      std::int32_t& found = s.role == SourceLine::Role::discontinuity ? e.discontinuity : e.boundary;
      if (found >= 0 && sources[static_cast<std::size_t>(found)].priority <= s.priority) continue;
      if (distance(p, s) <= reach && distance(q, s) <= reach) found = i;
    }
  }
}

std::optional<Vec2> intersection(const SourceLine& s, const SourceLine& t, double& squareness) {
  const Vec2 d = s.b - s.a, e = t.b - t.a;
  const double det = cross(d, e);
  squareness = std::abs(det) / (d.norm() * e.norm());
  if (squareness < 1e-7) return std::nullopt;  // below this the intersection is no more accurate than the grid
  return s.a + cross(t.a - s.a, e) / det * d;
}

/// Final position of a vertex of a graph.   @param lines  sources of its edges, ascending, each once
Vec2 placed(const LineGraph& graph, std::int32_t vertex, const std::vector<std::int32_t>& lines,
            const std::vector<SourceLine>& sources) {
  const double grid = graph.grid;
  const Vec2 snapped = graph.node(vertex);
  const GridPoint at = on_grid(graph.snapped[static_cast<std::size_t>(vertex)], grid);
  std::optional<Vec2> end;
  for (const std::int32_t i : lines) {
    const SourceLine& s = sources[static_cast<std::size_t>(i)];
    for (const Vec2& p : {s.a, s.b}) {
      if (on_grid(graph.axes * p, grid) != at) continue;
      if (s.role != SourceLine::Role::discontinuity) return p;
      if (!end) end = p;
    }
  }
  // An end as the user wrote it, if it is on all lines to the last bit: computed intersections have rounding errors.
  if (end && std::all_of(lines.begin(), lines.end(), [&](std::int32_t i) {
        const SourceLine& s = sources[static_cast<std::size_t>(i)];
        return cross(*end - s.a, s.b - s.a) == 0.0;
      }))
    return *end;
  std::optional<Vec2> best;
  double best_squareness = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      double squareness = 0.0;
      const std::optional<Vec2> p = intersection(sources[static_cast<std::size_t>(lines[i])],
                                                 sources[static_cast<std::size_t>(lines[j])], squareness);
      if (!p || squareness <= best_squareness || (*p - snapped).lpNorm<Eigen::Infinity>() > grid) continue;
      best = p;
      best_squareness = squareness;
    }
  if (best) return *best;
  if (end || lines.empty()) return end.value_or(snapped);
  // A node of a line that was removed since: it is projected on the remaining line.
  const SourceLine& s = sources[static_cast<std::size_t>(lines.front())];
  const Vec2 d = s.b - s.a;
  return s.a + (snapped - s.a).dot(d) / d.squaredNorm() * d;
}

}  // namespace

std::int32_t LineGraph::vertex_at(const Vec2& point) const {
  const GridPoint key = on_grid(point, grid);
  const auto at = std::lower_bound(snapped.begin(), snapped.end(), key,
                                   [&](const Vec2& p, const GridPoint& k) { return on_grid(p, grid) < k; });
  SCREE_ASSERT(at != snapped.end() && on_grid(*at, grid) == key);
  return static_cast<std::int32_t>(at - snapped.begin());
}

LineGraph node_lines(const std::vector<SourceLine>& drawn, double grid) {
  const Vec2 along_most = main_direction(drawn);
  const bool turns = along_most.y() != 0.0;
  LineGraph graph;
  graph.grid = grid;
  if (turns) graph.axes << along_most.x(), along_most.y(), -along_most.y(), along_most.x();
  const std::vector<SourceLine> sources = turns ? turned(drawn, graph.axes) : drawn;
  const Geos geos;
  std::vector<GEOSGeometry*> lines;
  for (const std::size_t i : drawing_order(sources.size())) {
    const SourceLine& s = sources[i];
    const Vec2 along = (s.b - s.a).normalized();
    lines.push_back(geos.line(s.a - s.beyond_a * along, s.b + s.beyond_b * along));
  }
  const auto all = geos.own(
      GEOSGeom_createCollection_r(geos.get(), GEOS_MULTILINESTRING, lines.data(), static_cast<unsigned>(lines.size())),
      "collection");
  const auto noded = geos.own(GEOSUnaryUnionPrec_r(geos.get(), all.get(), grid), "noding");

  std::vector<std::pair<GridPoint, GridPoint>> pieces;
  std::vector<GridPoint> points;
  each_piece(geos, noded.get(), [&](const Vec2& p, const Vec2& q) {
    const GridPoint a = on_grid(p, grid), b = on_grid(q, grid);
    if (a == b) return;
    pieces.emplace_back(std::min(a, b), std::max(a, b));
    points.push_back(a);
    points.push_back(b);
  });
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());

  for (const GridPoint& p : points) {
    graph.snapped.emplace_back(static_cast<double>(p.second) * grid, static_cast<double>(p.first) * grid);
    graph.vertices.push_back(graph.axes.transpose() * graph.snapped.back());
  }
  const auto number = [&](const GridPoint& p) {
    return static_cast<std::int32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
  };
  for (const auto& [a, b] : pieces) graph.edges.push_back({number(a), number(b), -1, -1});
  find_sources(graph, sources);
  return graph;
}

void place_vertices(LineGraph& graph, const std::vector<SourceLine>& sources) {
  std::vector<std::vector<std::int32_t>> lines(graph.snapped.size());
  std::vector<char> crowded(graph.snapped.size(), 0);
  for (const GraphEdge& e : graph.edges) {
    const auto a = static_cast<std::size_t>(e.a), b = static_cast<std::size_t>(e.b);
    const bool is_short = (graph.snapped[b] - graph.snapped[a]).norm() < 8.0 * graph.grid;
    for (const std::size_t v : {a, b}) {
      if (is_short) crowded[v] = 1;
      for (const std::int32_t i : {e.boundary, e.discontinuity})
        if (i >= 0) lines[v].push_back(i);
    }
  }
  for (std::size_t v = 0; v < lines.size(); ++v) {
    if (crowded[v] != 0) continue;
    std::sort(lines[v].begin(), lines[v].end());
    lines[v].erase(std::unique(lines[v].begin(), lines[v].end()), lines[v].end());
    graph.vertices[v] = placed(graph, static_cast<std::int32_t>(v), lines[v], sources);
  }
}

Faces faces_of(const LineGraph& graph) {
  const Geos geos;
  std::vector<GEOSGeometry*> lines;
  const auto point = [&](std::int32_t v) -> const Vec2& { return graph.snapped[static_cast<std::size_t>(v)]; };
  for (const GraphEdge& e : graph.edges) lines.push_back(geos.line(point(e.a), point(e.b)));
  const auto all = geos.own(
      GEOSGeom_createCollection_r(geos.get(), GEOS_MULTILINESTRING, lines.data(), static_cast<unsigned>(lines.size())),
      "collection");
  std::array<GEOSGeometry*, 3> rest{};  // bridges, dead ends, invalid rings
  const auto polygons =
      geos.own(GEOSPolygonize_full_r(geos.get(), all.get(), &rest[0], &rest[1], &rest[2]), "polygons");

  Faces out;
  const auto find = [&](const Vec2& p, const Vec2& q) {
    const std::int32_t i = graph.vertex_at(p), j = graph.vertex_at(q);
    const GraphEdge key{std::min(i, j), std::max(i, j), -1, -1};
    return std::lower_bound(graph.edges.begin(), graph.edges.end(), key, [](const GraphEdge& a, const GraphEdge& b) {
      return std::pair(a.a, a.b) < std::pair(b.a, b.b);
    });
  };
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto owned = geos.own(rest[i], "polygons");
    if (i == 2) continue;
    each_piece(geos, owned.get(), [&](const Vec2& p, const Vec2& q) { out.dead.push_back(*find(p, q)); });
  }
  for (int i = 0; i < GEOSGetNumGeometries_r(geos.get(), polygons.get()); ++i) {
    const GEOSGeometry* g = GEOSGetGeometryN_r(geos.get(), polygons.get(), i);
    std::vector<Polygon> one;
    geos.collect(g, one);
    if (one.empty()) continue;
    Face face;
    for (std::size_t r = 0; r < one.front().rings(); ++r) {
      face.rings.emplace_back();
      for (const Vec2& p : one.front().ring(r)) face.rings.back().push_back(graph.vertex_at(p));
    }
    const auto inside = geos.own(GEOSPointOnSurface_r(geos.get(), g), "point in a polygon");
    GEOSGeomGetX_r(geos.get(), inside.get(), &face.inside.x());
    GEOSGeomGetY_r(geos.get(), inside.get(), &face.inside.y());
    face.inside = graph.axes.transpose() * face.inside;
    out.faces.push_back(std::move(face));
  }
  return out;
}

}  // namespace scree
