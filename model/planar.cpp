#include "model/planar.h"

#include <geos_c.h>

#include <memory>
#include <stdexcept>

namespace scree {
namespace {

/// A GEOS context of this call's own (the reentrant interface), with geometry that frees itself.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {}
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(handle_); }
  [[nodiscard]] GEOSContextHandle_t get() const { return handle_; }

  struct Free {
    GEOSContextHandle_t h;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(h, g); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Free>;
  [[nodiscard]] Geometry own(GEOSGeometry* g, const char* what) const {
    if (g == nullptr) throw std::runtime_error(std::string("GEOS: ") + what + " failed");
    return Geometry(g, Free{handle_});
  }

  [[nodiscard]] GEOSGeometry* ring(const Ring& points) const {
    const auto n = static_cast<unsigned>(points.size());
    GEOSCoordSequence* s = GEOSCoordSeq_create_r(handle_, n + 1, 2);
    for (unsigned i = 0; i <= n; ++i) GEOSCoordSeq_setXY_r(handle_, s, i, points[i % n].x(), points[i % n].y());
    return GEOSGeom_createLinearRing_r(handle_, s);
  }
  [[nodiscard]] Geometry polygon(const Polygon& p) const {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& h : p.holes) holes.push_back(ring(h));
    return own(GEOSGeom_createPolygon_r(handle_, ring(p.outer), holes.data(), static_cast<unsigned>(holes.size())),
               "polygon");
  }
  [[nodiscard]] Ring points(const GEOSGeometry* linear_ring) const {
    const GEOSCoordSequence* s = GEOSGeom_getCoordSeq_r(handle_, linear_ring);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(handle_, s, &n);
    Ring out;
    for (unsigned i = 0; i + 1 < n; ++i) {  // the last point repeats the first
      double x = 0.0, y = 0.0;
      GEOSCoordSeq_getXY_r(handle_, s, i, &x, &y);
      out.emplace_back(x, y);
    }
    return out;
  }
  /// Every polygon inside a geometry, oriented.
  void collect(const GEOSGeometry* g, std::vector<Polygon>& out) const {
    const int type = GEOSGeomTypeId_r(handle_, g);
    if (type == GEOS_POLYGON) {
      double area = 0.0;
      GEOSArea_r(handle_, g, &area);
      if (GEOSisEmpty_r(handle_, g) == 1 || !(area > 0.0)) return;
      Polygon p;
      p.outer = points(GEOSGetExteriorRing_r(handle_, g));
      for (int i = 0; i < GEOSGetNumInteriorRings_r(handle_, g); ++i)
        p.holes.push_back(points(GEOSGetInteriorRingN_r(handle_, g, i)));
      orient(p);
      out.push_back(std::move(p));
    } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
      for (int i = 0; i < GEOSGetNumGeometries_r(handle_, g); ++i) collect(GEOSGetGeometryN_r(handle_, g, i), out);
    }
  }

 private:
  GEOSContextHandle_t handle_;
};

}  // namespace

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
  for (Polygon& p : pieces) triangles.push_back(std::move(p.outer));
  return triangles;
}

}  // namespace scree
