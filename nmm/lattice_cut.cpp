#include "nmm/lattice_cut.h"

#include <algorithm>
#include <cmath>

#include "model/perimeter.h"
#include "model/planar.h"

namespace scree::nmm {
namespace {

constexpr double kSliver = 1e-9;  // least area of a face of a crack, a fraction of the triangle's
constexpr double kReach = 1e-8;   // by which cracks are lengthened, a fraction of a mesh edge

/// Calls see for the cells near a segment, both triangles of each: within a thousandth of the mesh size.
template <class See>
void cells_near(const Lattice& lattice, const Vec2& a, const Vec2& b, See&& see) {
  const double margin = 1e-3;  // in oblique coordinates
  const Vec2 oa = lattice.oblique(a), ob = lattice.oblique(b);
  const double low = std::min(oa.y(), ob.y()) - margin, high = std::max(oa.y(), ob.y()) + margin;
  for (auto j = static_cast<std::int32_t>(std::floor(low)); j <= static_cast<std::int32_t>(std::floor(high)); ++j) {
    // The part of the segment within this row of cells.
    double t0 = 0.0, t1 = 1.0;
    const double rise = ob.y() - oa.y();
    if (std::abs(rise) > 1e-12) {
      const double at0 = (j - margin - oa.y()) / rise, at1 = (j + 1 + margin - oa.y()) / rise;
      t0 = std::clamp(std::min(at0, at1), 0.0, 1.0);
      t1 = std::clamp(std::max(at0, at1), 0.0, 1.0);
    }
    const double x0 = oa.x() + t0 * (ob.x() - oa.x()), x1 = oa.x() + t1 * (ob.x() - oa.x());
    const auto i0 = static_cast<std::int32_t>(std::floor(std::min(x0, x1) - margin));
    const auto i1 = static_cast<std::int32_t>(std::floor(std::max(x0, x1) + margin));
    for (std::int32_t i = i0; i <= i1; ++i) see(i, j);
  }
}

/// Empty pieces of an outline: only the range of cells in which they may lie.
LatticePieces room_for(const Polygon& outline, const Lattice& lattice) {
  LatticePieces out{lattice, {}, 0, 0, {}, {}, {}};
  const Box box = bounds(outline);
  Vec2 lo = lattice.oblique(box.lo), hi = lo;
  for (const Vec2& corner : {box.hi, Vec2(box.lo.x(), box.hi.y()), Vec2(box.hi.x(), box.lo.y())}) {
    lo = lo.cwiseMin(lattice.oblique(corner));
    hi = hi.cwiseMax(lattice.oblique(corner));
  }
  out.low = {static_cast<std::int32_t>(std::floor(lo.x())) - 1, static_cast<std::int32_t>(std::floor(lo.y())) - 1};
  out.columns = static_cast<std::int32_t>(std::floor(hi.x())) + 2 - out.low.i;
  out.rows = static_cast<std::int32_t>(std::floor(hi.y())) + 2 - out.low.j;
  const auto cells = static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows);
  out.cracked.assign(2 * cells, 0);
  out.first.assign(2 * cells + 1, 0);
  return out;
}

/// The faces into which lines cut a part of a triangle; the part itself if they do not cut it.
/// @param full  area of the triangle [m2]   @param crack_length  grows by the length of the cuts [m]
std::vector<Polygon> faces_of(const Polygon& part, std::span<const CutLine> lines, double full, double& crack_length) {
  std::vector<Polygon> faces;
  if (!lines.empty()) faces = cut_by_lines(part, lines);
  // A crack along a mesh line, up to round-off, must not cut off a sliver: it runs between the triangles.
  std::erase_if(faces, [&](const Polygon& f) { return moments(f).area < kSliver * full; });
  if (faces.size() > 1) {
    double cut = -perimeter(part);
    for (const Polygon& f : faces) cut += perimeter(f);
    crack_length += 0.5 * cut;
  } else {
    faces.assign(1, part);
  }
  return faces;
}

}  // namespace

LatticePieces cut_lattice(const Polygon& outline, std::span<const CutLine> cracks, const Lattice& lattice,
                          CoverMesh& mesh) {
  LatticePieces out = room_for(outline, lattice);
  const std::size_t cells = out.cracked.size() / 2;

  // Per cell, whether a line is near it; the cracks near each cell.
  std::vector<char> near(cells, 0);
  std::vector<std::pair<std::size_t, std::int32_t>> crack_at;
  const auto cell = [&](std::int32_t i, std::int32_t j) { return out.index({j, i, 0}) / 2; };
  for (std::size_t r = 0; r < outline.rings(); ++r)
    for (std::size_t k = 0; k < outline.ring(r).size(); ++k)
      cells_near(lattice, outline.ring(r)[k], outline.ring(r)[(k + 1) % outline.ring(r).size()],
                 [&](std::int32_t i, std::int32_t j) {
                   if (out.inside({j, i, 0})) near[cell(i, j)] = 1;
                 });
  for (std::size_t c = 0; c < cracks.size(); ++c)
    cells_near(lattice, cracks[c].from, cracks[c].to, [&](std::int32_t i, std::int32_t j) {
      if (out.inside({j, i, 0})) crack_at.emplace_back(cell(i, j), static_cast<std::int32_t>(c));
    });
  std::sort(crack_at.begin(), crack_at.end());

  mesh.shapes = {gradients_of({lattice.position({0, 0}), lattice.position({1, 0}), lattice.position({0, 1})}),
                 gradients_of({lattice.position({1, 0}), lattice.position({1, 1}), lattice.position({0, 1})})};
  const double full = lattice.triangle_area();
  mesh.triangle_areas = {full, full};
  const auto add = [&](const LatticeTriangle& t, double area, std::int32_t piece) {
    mesh.shape.push_back(static_cast<std::uint16_t>(t.down));
    mesh.area.push_back(area);
    mesh.piece.push_back(piece);
    out.triangle.push_back(t);
  };
  const Clipper clipper(outline);
  const auto add_cut = [&](const LatticeTriangle& t, std::span<const CutLine> lines) {
    const auto nodes = Lattice::corners(t);
    const Ring ring{lattice.position(nodes[0]), lattice.position(nodes[1]), lattice.position(nodes[2])};
    const Clipper::Relation relation = clipper.relation(ring);
    if (relation == Clipper::Relation::outside) return;
    std::vector<Polygon> parts;
    if (relation == Clipper::Relation::inside)
      parts.push_back({ring, {}});
    else
      parts = clipper.intersection(ring);
    for (const Polygon& part : parts) {
      std::vector<Polygon> faces = faces_of(part, lines, full, mesh.crack_length);
      for (Polygon& face : faces) {
        const double area = moments(face).area;
        if (area < 1e-13 * full) continue;  // touches along a line only
        if (relation == Clipper::Relation::inside && faces.size() == 1) {
          add(t, full, -1);
          continue;
        }
        add(t, area, static_cast<std::int32_t>(mesh.pieces.size()));
        mesh.pieces.push_back(std::move(face));
      }
    }
  };

  std::size_t next_crack = 0;
  std::vector<CutLine> lines;
  for (std::int32_t j = out.low.j; j < out.low.j + out.rows; ++j) {
    bool known = false, solid = false;  // of the run of cells that are not near any line
    for (std::int32_t i = out.low.i; i < out.low.i + out.columns; ++i) {
      const std::size_t c = cell(i, j);
      lines.clear();
      for (; next_crack < crack_at.size() && crack_at[next_crack].first == c; ++next_crack) {
        // Slightly lengthened: an end typed as a point of another line or of the outline lies beside it by round-off.
        const CutLine& line = cracks[static_cast<std::size_t>(crack_at[next_crack].second)];
        const Vec2 more = kReach * lattice.size() * (line.to - line.from).normalized();
        lines.push_back({line.from - more, line.to + more});
      }
      const bool touched = near[c] != 0 || !lines.empty();
      if (!touched && !known) {
        known = true;
        solid =
            contains(outline, lattice.position({i, j}) + 0.5 * (lattice.position({1, 1}) - lattice.position({0, 0})));
      }
      if (touched) known = false;
      for (std::int32_t down = 0; down < 2; ++down) {
        const LatticeTriangle t{j, i, down};
        out.first[out.index(t)] = static_cast<std::int32_t>(mesh.area.size());
        out.cracked[out.index(t)] = lines.empty() ? 0 : 1;
        if (touched)
          add_cut(t, lines);
        else if (solid)
          add(t, full, -1);
      }
    }
  }
  out.first.back() = static_cast<std::int32_t>(mesh.area.size());
  return out;
}

}  // namespace scree::nmm
