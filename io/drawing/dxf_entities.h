// Contents of a DXF before blocks are inserted and curves flattened. Lengths are in units of the file.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/drawing/curves.h"
#include "io/drawing/drawing.h"

namespace scree::io {

struct DxfEntity {
  enum class Kind { polyline, arc, spline, point, insert };
  Kind kind = Kind::polyline;
  std::string layer, type;
  int row = 0;
  std::string unusable;  // why the entity cannot be used
  // polyline, point
  std::vector<Vec2> vertices;
  std::vector<double> bulges;  // from a vertex to the next
  bool closed = false;
  // arc, of circles and ellipses: c + cos(t) a + sin(t) b; closed: the full curve
  Vec2 c{0.0, 0.0}, a{0.0, 0.0}, b{0.0, 0.0};
  double from = 0.0, to = 0.0;  // [rad]
  Spline spline;
  // insert
  std::string block;
  Vec2 at{0.0, 0.0}, scale{1.0, 1.0}, pitch{0.0, 0.0};
  double turn = 0.0;  // [rad]
  int columns = 1, rows = 1;
  bool mirrored = false;  // drawn in a plane seen from below: the sign of x is reversed
};

struct DxfBlock {
  Vec2 base{0.0, 0.0};
  std::vector<DxfEntity> entities;
};

struct DxfContent {
  std::string version;  // "AC1009"; empty: the header has none
  int unit = 0;         // $INSUNITS; 0: none
  std::map<std::string, DxfBlock, std::less<>> blocks;
  std::vector<DxfEntity> entities;                                                      // of the model space
  std::map<std::pair<std::string, std::string>, std::pair<int, std::string>> left_out;  // layer, type: count, why
};

/// @throws DrawingError
[[nodiscard]] DxfContent read_dxf_entities(std::string_view text);

}  // namespace scree::io
