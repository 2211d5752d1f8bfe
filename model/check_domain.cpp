// Conditions under which a domain can be cut into blocks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/domain.h"
#include "model/planar.h"

namespace scree {
namespace {

using Part = DomainFault::Part;

double extent_of(const Domain& domain) {
  const Box box = bounds(domain.outline);
  return (box.hi - box.lo).maxCoeff();
}

std::string at(const Vec2& p) { return fmt::format("({:.10g}, {:.10g})", p.x(), p.y()); }

constexpr const char* kSimpleRing = "a simple polygon: corners in order, the first not repeated, no crossing edges";

/// @param extent  of the outline [m]
std::optional<DomainFault> ring_fault(Part part, std::size_t index, const std::string& name, const Ring& ring,
                                      double extent) {
  const auto fault = [&](const std::string& what, std::string hint) {
    return DomainFault{part, index, name + " " + what, kSimpleRing, std::move(hint)};
  };
  if (ring.size() < 3)
    return fault(fmt::format("is open: {} points enclose nothing", ring.size()), "give at least three corners");
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!ring[i].allFinite()) return fault(fmt::format("has corner {} that is not finite", i + 1), "give numbers");
    const double gap = (ring[(i + 1) % ring.size()] - ring[i]).norm();
    if (gap <= 1e-9 * extent)
      return fault(fmt::format("has corner {} twice", at(ring[i])),
                   "remove the repeated corner; the first corner is not repeated at the end");
    // A last corner this near the first was meant to repeat the first.
    if (i + 1 == ring.size() && gap <= 1e-4 * extent)
      return fault(
          fmt::format("is open: it ends at {}, {:.3g} m short of its first corner {}", at(ring[i]), gap, at(ring[0])),
          "remove the last corner: the outline closes from the last corner to the first by itself");
  }
  // The signed area is no test: it may vanish for a ring shaped like an 8 too.
  const Vec2 farthest = *std::max_element(ring.begin(), ring.end(), [&](const Vec2& p, const Vec2& q) {
    return (p - ring[0]).squaredNorm() < (q - ring[0]).squaredNorm();
  });
  const Vec2 along = (farthest - ring[0]).normalized();
  if (std::all_of(ring.begin(), ring.end(),
                  [&](const Vec2& p) { return std::abs(cross(along, p - ring[0])) <= 1e-9 * extent; }))
    return fault("encloses no area: its corners lie on a line", "give corners that enclose an area");
  if (std::string reason = invalidity({ring, {}}); !reason.empty())
    return fault("crosses or touches itself: " + reason, "list the corners in order around it, without crossing edges");
  return std::nullopt;
}

std::optional<DomainFault> hole_fault(const Domain& domain, double extent) {
  Polygon so_far{domain.outline.outer, {}};
  for (std::size_t i = 0; i < domain.outline.holes.size(); ++i) {
    const Ring& hole = domain.outline.holes[i];
    if (auto f = ring_fault(Part::hole, i, "the hole", hole, extent)) return f;
    Polygon filled{hole, {}};
    orient(filled);
    const auto fault = [&](std::string what, std::string hint) {
      return DomainFault{Part::hole, i, std::move(what), "a hole inside the outline, apart from other holes",
                         std::move(hint)};
    };
    const double area = signed_area(filled.outer), inside = overlap_area(filled, {domain.outline.outer, {}});
    if (inside <= 1e-9 * area)
      return fault("the hole lies outside the outline", "move it into the outline, or remove it");
    if (inside < (1.0 - 1e-9) * area)
      return fault("the hole crosses the outline", "make it part of the outline where it opens to the outside");
    for (std::size_t j = 0; j < i; ++j) {
      Polygon other{domain.outline.holes[j], {}};
      orient(other);
      if (overlap_area(filled, other) > 1e-9 * area)
        return fault(fmt::format("the hole overlaps hole {}", j), "make one hole of the two");
    }
    so_far.holes.push_back(hole);
    if (std::string reason = invalidity(so_far); !reason.empty())
      return fault("the hole touches the outline or another hole along an edge: " + reason,
                   "make it part of the outline, or leave rock between");
  }
  return std::nullopt;
}

std::optional<DomainFault> region_fault(const Domain& domain, double extent) {
  for (std::size_t i = 0; i < domain.regions.size(); ++i) {
    const Region& region = domain.regions[i];
    if (auto f = ring_fault(Part::region, i, fmt::format("region '{}'", region.name), region.outline, extent)) return f;
    Polygon polygon{region.outline, {}};
    orient(polygon);
    const auto fault = [&](std::string what, std::string hint) {
      return DomainFault{Part::region, i, std::move(what), "a polygon in the domain that overlaps no other region",
                         std::move(hint)};
    };
    if (overlap_area(polygon, domain.outline) <= 1e-9 * extent * extent)
      return fault(fmt::format("region '{}' lies outside the domain", region.name), "move or remove it");
    for (std::size_t j = 0; j < i; ++j) {
      Polygon other{domain.regions[j].outline, {}};
      orient(other);
      const double common = overlap_area(polygon, other), area = signed_area(polygon.outer);
      if (common <= 1e-9 * extent * extent) continue;
      const bool same = common >= (1.0 - 1e-9) * std::max(area, signed_area(other.outer));
      return fault(
          same ? fmt::format("region '{}' covers the same area as region '{}'", region.name, domain.regions[j].name)
               : fmt::format("region '{}' overlaps region '{}' by {:.4g} m2", region.name, domain.regions[j].name,
                             common),
          same ? "remove one of the two" : "let regions only touch");
    }
  }
  return std::nullopt;
}

std::optional<DomainFault> line_fault(const JointNetwork& network, const Domain& domain, double extent) {
  constexpr double kMostLines = 1e6, kMostCrossings = 1e7;
  double lines = 0.0, crossings = 0.0;
  for (std::size_t i = 0; i < network.sets.size(); ++i) {
    const JointSet& set = network.sets[i];
    if (set.region)
      if (auto f = ring_fault(Part::set_region, i, "the region of the joint set", *set.region, extent)) return f;
    lines += expected_traces(set, domain.outline);
    if (!(lines <= kMostLines))
      return DomainFault{Part::set_spacing, i, fmt::format("the joint sets draw about {:.3g} lines", lines),
                         fmt::format("at most {:g} lines", kMostLines),
                         "check the units of spacing, length and gap; an origin far from the domain costs lines too"};
    for (std::size_t j = 0; j < i; ++j) crossings += expected_crossings(set, network.sets[j], domain.outline);
    if (!(crossings <= kMostCrossings))
      return DomainFault{Part::set_spacing, i, fmt::format("the joint sets cross about {:.3g} times", crossings),
                         fmt::format("at most {:g} crossings", kMostCrossings),
                         "each crossing is a corner of four blocks: check the units of spacing, length and gap"};
  }
  for (std::size_t i = 0; i < network.traces.size(); ++i) {
    const std::vector<Vec2>& points = network.traces[i].points;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      if ((points[k + 1] - points[k]).norm() <= 1e-9 * extent)
        return DomainFault{Part::trace, i, fmt::format("the trace has the point {} twice", at(points[k])),
                           "a line of distinct points", "remove the repeated point"};
  }
  for (std::size_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    const double turn = std::abs(arc.to_deg - arc.from_deg);
    if (turn > 0.0 && turn <= 360.0 && chord_points(arc).size() > 1 &&
        (chord_points(arc)[1] - chord_points(arc)[0]).norm() > 1e-9 * extent)
      continue;
    return DomainFault{Part::arc, i, "the arc has no length, or more than a full turn",
                       "0 < |to_deg - from_deg| <= 360", "give two angles, or fewer chords"};
  }
  return std::nullopt;
}

}  // namespace

double auto_snap(const Domain& domain) {
  // Crossings of lines have errors of a few units in the last place of the coordinates; the grid must be coarser.
  constexpr double kRoundOff = 64.0 * std::numeric_limits<double>::epsilon();
  const Box box = bounds(domain.outline);
  const double farthest = std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff());
  return std::pow(10.0, std::ceil(std::log10(std::max(1e-9 * extent_of(domain), kRoundOff * farthest)) - 1e-9));
}

double auto_least_width(const Domain& domain) {
  return std::max(1e-6 * extent_of(domain), 10.0 * domain.snap.value_or(auto_snap(domain)));
}

std::optional<DomainFault> check_domain(const Domain& domain) {
  double extent = 1.0;
  if (domain.outline.outer.size() >= 3) extent = extent_of(domain);
  if (auto f = ring_fault(Part::outline, 0, "the outline", domain.outline.outer, extent)) return f;
  if (domain.snap && !(*domain.snap >= 1e-12 * extent && *domain.snap <= 1e-3 * extent))
    return DomainFault{Part::snap, 0, "the grid is too fine or too coarse for the domain",
                       fmt::format("{:g} to {:g} m: 1e-12 to 1e-3 of the extent", 1e-12 * extent, 1e-3 * extent),
                       "leave snap out for 1e-9 of the extent"};
  if (auto f = hole_fault(domain, extent)) return f;
  if (auto f = region_fault(domain, extent)) return f;
  return line_fault(domain.network, domain, extent);
}

}  // namespace scree
