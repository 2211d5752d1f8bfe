#include "model/planar.h"

#include "model/geos.h"

namespace scree {

struct Clipper::Impl {
  explicit Impl(const Polygon& p) : polygon(geos.polygon(p)), prepared(GEOSPrepare_r(geos.get(), polygon.get())) {}
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
  if (GEOSPreparedContainsProperly_r(impl_->geos.get(), impl_->prepared, g.get()) == 1) return Relation::inside;
  return GEOSPreparedIntersects_r(impl_->geos.get(), impl_->prepared, g.get()) == 1 ? Relation::across
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

std::string invalidity(const Polygon& polygon) {
  const Geos geos;
  const auto g = geos.polygon(polygon);
  if (GEOSisValid_r(geos.get(), g.get()) == 1) return {};
  char* reason = GEOSisValidReason_r(geos.get(), g.get());
  std::string text = reason == nullptr ? "invalid polygon" : reason;
  GEOSFree_r(geos.get(), reason);
  return text;
}

double overlap_area(const Polygon& a, const Polygon& b) {
  const Geos geos;
  const auto ga = geos.polygon(a), gb = geos.polygon(b);
  if (GEOSIntersects_r(geos.get(), ga.get(), gb.get()) != 1) return 0.0;
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
