#include "model/planar.h"

#include "model/geos.h"

namespace scree {

struct Clipper::Impl {
  explicit Impl(const Polygon& p) : polygon(geos.polygon(p)), prepared(GEOSPrepare_r(geos.get(), polygon.get())) {
    if (prepared == nullptr) geos.fail("preparation");
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { GEOSPreparedGeom_destroy_r(geos.get(), prepared); }
  Geos geos;
  Geos::Geometry polygon;
  const GEOSPreparedGeometry* prepared;
};

Clipper::Clipper(const Polygon& polygon) : impl_(new Impl(polygon)) {}
Clipper::~Clipper() { delete impl_; }

Clipper::Relation Clipper::relation(const Ring& cell) const {
  const auto g = impl_->geos.polygon(Polygon{cell, {}});
  const Geos& geos = impl_->geos;
  if (geos.holds(GEOSPreparedContainsProperly_r(geos.get(), impl_->prepared, g.get()), "relation"))
    return Relation::inside;
  return geos.holds(GEOSPreparedIntersects_r(geos.get(), impl_->prepared, g.get()), "relation") ? Relation::across
                                                                                                : Relation::outside;
}

std::vector<Polygon> Clipper::intersection(const Ring& cell) const {
  const Geos& geos = impl_->geos;
  const auto g = geos.polygon(Polygon{cell, {}});
  const auto common = geos.own(GEOSIntersection_r(geos.get(), impl_->polygon.get(), g.get()), "intersection");
  std::vector<Polygon> pieces;
  geos.collect(common.get(), pieces);
  return pieces;
}

std::vector<Polygon> cut_by_lines(const Polygon& polygon, std::span<const CutLine> lines) {
  const Geos geos;
  const auto area = geos.polygon(polygon);
  const auto boundary = geos.own(GEOSBoundary_r(geos.get(), area.get()), "boundary");
  std::vector<GEOSGeometry*> parts;
  for (const CutLine& s : lines) parts.push_back(geos.line(s.from, s.to));
  const auto drawn = geos.own(
      GEOSGeom_createCollection_r(geos.get(), GEOS_MULTILINESTRING, parts.data(), static_cast<unsigned>(parts.size())),
      "lines");
  const auto noded = geos.own(GEOSUnion_r(geos.get(), boundary.get(), drawn.get()), "noding");
  const GEOSGeometry* all = noded.get();
  const auto faces = geos.own(GEOSPolygonize_r(geos.get(), &all, 1), "polygons");
  std::vector<Polygon> found, inside;
  geos.collect(faces.get(), found);
  for (Polygon& face : found) {  // lines beyond the polygon, and holes, also bound faces
    const auto g = geos.polygon(face);
    const auto point = geos.own(GEOSPointOnSurface_r(geos.get(), g.get()), "point");
    double x = 0.0, y = 0.0;
    GEOSGeomGetX_r(geos.get(), point.get(), &x);
    GEOSGeomGetY_r(geos.get(), point.get(), &y);
    if (contains(polygon, {x, y})) inside.push_back(std::move(face));
  }
  return inside;
}

std::string invalidity(const Polygon& polygon) {
  const Geos geos;
  const auto g = geos.polygon(polygon);
  if (geos.holds(GEOSisValid_r(geos.get(), g.get()), "validity")) return {};
  char* reason = GEOSisValidReason_r(geos.get(), g.get());
  std::string text = reason == nullptr ? "invalid polygon" : reason;
  GEOSFree_r(geos.get(), reason);
  return text;
}

std::vector<Polygon> intersection(const Polygon& a, const Polygon& b) {
  const Geos geos;
  const auto ga = geos.polygon(a), gb = geos.polygon(b);
  std::vector<Polygon> pieces;
  if (!geos.holds(GEOSIntersects_r(geos.get(), ga.get(), gb.get()), "relation")) return pieces;
  const auto common = geos.own(GEOSIntersection_r(geos.get(), ga.get(), gb.get()), "intersection");
  geos.collect(common.get(), pieces);
  return pieces;
}

double overlap_area(const Polygon& a, const Polygon& b) {
  const Geos geos;
  const auto ga = geos.polygon(a), gb = geos.polygon(b);
  if (!geos.holds(GEOSIntersects_r(geos.get(), ga.get(), gb.get()), "relation")) return 0.0;
  const auto common = geos.own(GEOSIntersection_r(geos.get(), ga.get(), gb.get()), "intersection");
  double area = 0.0;
  GEOSArea_r(geos.get(), common.get(), &area);
  return area;
}

std::vector<Ring> drawing_cells(const Polygon& polygon) {
  if (polygon.holes.empty()) return {polygon.outer};
  return triangulate(polygon);
}

std::vector<Ring> triangulate(const Polygon& polygon) {
  const Geos geos;
  const auto g = geos.polygon(polygon);
  const auto cells = geos.own(GEOSConstrainedDelaunayTriangulation_r(geos.get(), g.get()), "triangulation");
  std::vector<Polygon> pieces;
  geos.collect(cells.get(), pieces);
  std::vector<Ring> triangles;
  triangles.reserve(pieces.size());
  for (Polygon& p : pieces) triangles.push_back(std::move(p.outer));
  return triangles;
}

}  // namespace scree
