// A section drawing as lines and points on layers, independent of the format of its file.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "model/geometry.h"

namespace scree::io {

/// A line of a drawing; curves are flattened.
struct DrawnLine {
  std::string layer;
  std::string entity;        // its kind: "LWPOLYLINE"; "line" of a file of columns
  int row = 0;               // line of the file where that begins, from 1
  std::vector<Vec2> points;  // [m], at least two; a closed line does not repeat the first
  bool closed = false;
  std::string unusable;  // why it has no points although it is read; empty: it has points
};

struct DrawnPoint {
  std::string layer, entity;
  int row = 0;
  Vec2 at{0.0, 0.0};  // [m]
};

/// Number of entities of one kind on one layer; of inserted blocks, the entities in them are counted.
struct DrawnCount {
  std::string layer, entity;
  int count = 0;
  std::string left_out;  // why they are left out; empty: they are read
};

struct Drawing {
  std::string file, form;  // "DXF R2018 (AC1032)", "text"
  double unit = 1.0;       // length of a unit of the file [m]
  std::string unit_from;   // origin of unit: "the header", "the case"
  double tolerance = 0.0;  // of the flattening of curves [m]
  std::vector<DrawnLine> lines;
  std::vector<DrawnPoint> points;
  std::vector<DrawnCount> counts;  // by layer, then entity
};

/// What is wrong with a drawing, and where.
struct DrawingError : std::runtime_error {
  DrawingError(int at_row, const std::string& problem, std::string what_allowed, std::string what_helps)
      : std::runtime_error(problem), row(at_row), allowed(std::move(what_allowed)), hint(std::move(what_helps)) {}
  int row;  // line of the file, from 1; 0: the file as a whole
  std::string allowed, hint;
};

/// Factor from the named unit to metres.   @return 0 for an unknown name
[[nodiscard]] double unit_of(const std::string& name);

}  // namespace scree::io
