// Access to GEOS for the sources of model/: no other folder includes this header or links GEOS.
#pragma once

#include <geos_c.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/geometry.h"

namespace scree {

/// A GEOS context of the caller's own (the reentrant interface), with geometry that is freed automatically.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {
    const auto keep = [](const char* text, void* last) { *static_cast<std::string*>(last) = text; };
    GEOSContext_setErrorMessageHandler_r(handle_, keep, &last_error_);
  }
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
    if (g == nullptr) fail(what);
    return Geometry(g, Free{handle_});
  }

  /// Result of a predicate.   @throws std::runtime_error if GEOS could not evaluate it
  [[nodiscard]] bool holds(char answer, const char* what) const {
    if (answer != 0 && answer != 1) fail(what);
    return answer == 1;
  }
  /// Checks calls whose failure is reported to the context only.   @throws std::runtime_error if one failed
  void check(const char* what) const {
    if (!last_error_.empty()) fail(what);
  }
  [[noreturn]] void fail(const char* what) const {
    throw std::runtime_error(std::string("GEOS: ") + what + " failed: " + last_error_);
  }

  /// A coordinate sequence for points, not owned yet.
  [[nodiscard]] GEOSCoordSequence* coordinates(unsigned points) const {
    GEOSCoordSequence* s = GEOSCoordSeq_create_r(handle_, points, 2);
    if (s == nullptr) throw std::bad_alloc();
    return s;
  }
  /// Valid points always make a line or ring: a null result means that there was no memory.
  [[nodiscard]] static GEOSGeometry* made(GEOSGeometry* g) {
    if (g == nullptr) throw std::bad_alloc();
    return g;
  }
  /// A line of two points, not owned yet.
  [[nodiscard]] GEOSGeometry* line(const Vec2& a, const Vec2& b) const {
    GEOSCoordSequence* s = coordinates(2);
    GEOSCoordSeq_setXY_r(handle_, s, 0, a.x(), a.y());
    GEOSCoordSeq_setXY_r(handle_, s, 1, b.x(), b.y());
    return made(GEOSGeom_createLineString_r(handle_, s));
  }
  [[nodiscard]] GEOSGeometry* ring(const Ring& points) const {
    const auto n = static_cast<unsigned>(points.size());
    GEOSCoordSequence* s = coordinates(n + 1);
    for (unsigned i = 0; i <= n; ++i) GEOSCoordSeq_setXY_r(handle_, s, i, points[i % n].x(), points[i % n].y());
    return made(GEOSGeom_createLinearRing_r(handle_, s));
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
  std::string last_error_;
};

}  // namespace scree
