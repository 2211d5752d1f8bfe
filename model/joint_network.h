// Discontinuities of a rock mass as line segments: joint sets, traces, arcs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"
#include "model/random.h"

namespace scree {

/// A family of parallel joints.
///   Line k passes through origin + t_k n, n the normal of the mean dip; t_0 = 0, and t_k - t_(k-1) is a spacing.
///   Along a line traces alternate with gaps (rock bridges). If neither length nor gap varies, a trace of line k begins
///   at its foot point origin + t_k n moved by k stagger (length + gap); else the first trace begins at random.
struct JointSet {
  Spread dip_deg;         // [deg] counter-clockwise from +x
  double fisher_k = 0.0;  // > 0: poles scatter in space by the Fisher distribution of this K, dips are apparent ones
  Spread spacing;         // [m], > 0, normal to the mean dip
  std::optional<Spread> length;  // of a trace [m]; empty: lines run through
  Spread gap;                    // between traces of a line [m]
  double stagger = 0.0;          // shift from line to line, a fraction of length + gap; 0.5 as in masonry
  std::optional<Vec2> origin;    // a line passes through it [m]; empty: the lower left corner of the domain
  std::optional<Ring> region;    // [m]; lines exist only inside; empty: everywhere
  JointId joint;                 // law of the lines
  std::uint64_t seed = 1;
};

/// Statistics of the drawn values of a quantity, before lines were cut off at the domain.
struct Sample {
  std::int64_t n = 0;
  double sum = 0.0, squares = 0.0;  // about `about`
  double about = 0.0;               // near the mean, to avoid cancellation
  void add(double x) {
    ++n;
    sum += x - about;
    squares += (x - about) * (x - about);
  }
  [[nodiscard]] double mean() const { return n > 0 ? about + sum / static_cast<double>(n) : 0.0; }
  [[nodiscard]] double deviation() const;  // of the sample; 0 for less than two
};

/// Specified and drawn values of a joint set.
struct SetStatistics {
  JointId joint;
  Spread dip_deg, spacing, length, gap;  // as specified
  double fisher_k = 0.0;
  bool through = true;                                       // its lines run through: no length is given
  Sample drawn_dip, drawn_spacing, drawn_length, drawn_gap;  // [deg], [m]
  std::int64_t lines = 0;                                    // straight pieces in the domain
  double total_length = 0.0;                                 // of these [m]
  double area = 0.0;                                         // that the set fills [m2]
  /// Length of traces per area, as drawn and as specified [1/m].
  [[nodiscard]] double density() const { return area > 0.0 ? total_length / area : 0.0; }
  [[nodiscard]] double asked_density() const;
  /// length/(length + gap)
  [[nodiscard]] double persistence() const { return through ? 1.0 : length.mean / (length.mean + gap.mean); }
};

/// Mean and standard deviation of the drawn values of a spread. For a normal distribution that is drawn again until it
/// is positive, those of the truncated distribution.
struct Moments1 {
  double mean = 0.0, deviation = 0.0;
};
[[nodiscard]] Moments1 drawn_moments(const Spread& spread, bool positive);
/// Standard deviation of the apparent dip of a Fisher distribution of poles about the normal in the section [deg].
[[nodiscard]] double fisher_deviation_deg(double k);

struct Trace {
  std::vector<Vec2> points;  // [m], at least two
  JointId joint;
};

/// A circular arc made of chords, counter-clockwise where to > from.
struct Arc {
  Vec2 centre{0.0, 0.0};  // [m]
  double radius = 0.0;    // [m], > 0
  double from_deg = 0.0, to_deg = 360.0;
  int chords = 36;
  JointId joint;
};

struct JointNetwork {
  std::vector<Trace> traces;
  std::vector<Arc> arcs;
  std::vector<JointSet> sets;
};

/// A straight piece of a discontinuity, within the domain.
struct JointLine {
  enum class Kind : std::int32_t { trace, arc, joint_set };
  Vec2 from{0.0, 0.0}, to{0.0, 0.0};  // [m]
  JointId joint;
  Kind kind = Kind::trace;
  std::int32_t source = 0;  // which trace, arc or joint set, from 0
};

/// Unit vector at an angle, exact at multiples of 90 degrees.
[[nodiscard]] Vec2 direction_deg(double angle_deg);

/// The chord ends of an arc; the last equals the first for a full circle.
[[nodiscard]] std::vector<Vec2> chord_points(const Arc& arc);

struct Segment {
  Vec2 a{0.0, 0.0}, b{0.0, 0.0};
};
/// Pieces of a segment inside a polygon, in order from a to b; pieces that only touch the boundary may be left out.
[[nodiscard]] std::vector<Segment> clipped(const Segment& segment, const Polygon& polygon);

/// Number of traces that a set is expected to draw in a domain: known before anything is drawn.
[[nodiscard]] double expected_traces(const JointSet& set, const Polygon& domain);

/// Number of crossings that two sets are expected to have with each other in a domain.
///   L_i L_j |sin(alpha_i - alpha_j)| / A,  L: total length of the traces of a set, A: area of the domain, for sets
/// that fill it; a set with a region of its own has the density of its region, and the smaller region counts
/// @source docs/theory/contact-geometry.md, "Block cutting": mean number of crossings of two independent
///         stationary systems of straight lines
[[nodiscard]] double expected_crossings(const JointSet& first, const JointSet& second, const Polygon& domain);

/// Numbers that joint sets are expected to draw in a domain. The cost of cutting the domain depends on their sum.
struct NetworkSize {
  double lines = 0.0, crossings = 0.0;
};
[[nodiscard]] NetworkSize expected_size(const JointNetwork& network, const Polygon& domain);

/// All lines: traces, arcs, then sets, in the order given, cut off at the domain's boundary.
/// @pre mean spacing and length > 0     @source docs/theory/contact-geometry.md, "Block cutting"
/// @param statistics  of the sets, appended; null: not computed
[[nodiscard]] std::vector<JointLine> draw_lines(const JointNetwork& network, const Polygon& domain,
                                                std::vector<SetStatistics>* statistics = nullptr);

}  // namespace scree
