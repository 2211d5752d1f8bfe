#include "model/joint_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree {
namespace {

/// Circle around the area that a set fills, in the set's axes: along the mean dip and along its normal.
struct Window {
  Vec2 origin{0.0, 0.0}, along{1.0, 0.0}, normal{0.0, 1.0};
  double s = 0.0, t = 0.0;  // centre of the circle, from the origin
  double radius = 0.0;
};

Window window_of(const JointSet& set, const Polygon& domain) {
  const Box whole = bounds(domain), box = set.region ? bounds({*set.region, {}}) : whole;
  Window w;
  w.origin = set.origin.value_or(whole.lo);
  w.along = direction_deg(set.dip_deg.mean);
  w.normal = {-w.along.y(), w.along.x()};
  const Vec2 to_centre = 0.5 * (box.lo + box.hi) - w.origin;
  w.s = w.along.dot(to_centre);
  w.t = w.normal.dot(to_centre);
  w.radius = 0.5 * (box.hi - box.lo).norm();
  return w;
}

/// Distances t_k of the lines from the origin within the window, with their numbers k.
struct Offset {
  double t;
  std::int64_t k;
};
std::vector<Offset> offsets(const JointSet& set, const Window& w, Random& random, SetStatistics& drawn) {
  const auto spacing = [&] {
    const double s = set.spacing.draw_positive(random);
    drawn.drawn_spacing.add(s);
    return s;
  };
  std::vector<Offset> out;
  const double low = w.t - w.radius, high = w.t + w.radius;
  if (!set.spacing.varies()) {
    const auto first = static_cast<std::int64_t>(std::ceil(low / set.spacing.mean));
    for (std::int64_t k = first; static_cast<double>(k) * set.spacing.mean <= high; ++k)
      out.push_back({static_cast<double>(k) * set.spacing.mean, k});
    return out;
  }
  double t = 0.0;
  for (std::int64_t k = 0; t <= high; t += spacing(), ++k)
    if (t >= low) out.push_back({t, k});
  t = -spacing();
  for (std::int64_t k = -1; t >= low; t -= spacing(), --k)
    if (t <= high) out.push_back({t, k});
  return out;
}

/// Traces along a line of half length `half`, as intervals of the distance from its pivot.
struct TraceInterval {
  double from, to;
};
std::vector<TraceInterval> intervals(const JointSet& set, double foot, std::int64_t k, double half, Random& random,
                                     SetStatistics& drawn) {
  if (!set.length) return {{-half, half}};
  std::vector<TraceInterval> out;
  const double period = set.length->mean + set.gap.mean;
  if (!set.length->varies() && !set.gap.varies()) {
    const double start = foot + static_cast<double>(k) * set.stagger * period;
    auto j = static_cast<std::int64_t>(std::floor((-half - start) / period));
    for (; start + static_cast<double>(j) * period < half; ++j) {
      const double from = start + static_cast<double>(j) * period;
      out.push_back({from, from + set.length->mean});
    }
    return out;
  }
  double s = -half - random.uniform() * period;
  while (s < half) {
    const double length = set.length->draw_positive(random);
    drawn.drawn_length.add(length);
    out.push_back({s, s + length});
    s += length;
    if (set.gap.mean > 0.0) {
      const double gap = set.gap.draw_positive(random);
      drawn.drawn_gap.add(gap);
      s += gap;
    }
  }
  return out;
}

void append(std::vector<JointLine>& lines, const Segment& piece, const Polygon& domain, JointId joint,
            JointLine::Kind kind, std::size_t source) {
  for (const Segment& s : clipped(piece, domain))
    lines.push_back({s.a, s.b, joint, kind, static_cast<std::int32_t>(source)});
}

/// Rotation of a trace in the section if the pole of its plane deviates from the mean pole by the Fisher distribution:
///   cos t = 1 + ln(1 - u (1 - exp(-2 K)))/K, in a direction uniform about the mean pole; the section cuts the plane
///   along the normal of the pole's part in the section.
/// @source [Fisher1953]
double fisher_turn_deg(double k, Random& random) {
  const double u = random.uniform(), about = 2.0 * std::numbers::pi * random.uniform();
  const double cosine = 1.0 + portable_log(1.0 - u * (1.0 - (k < 300.0 ? portable_exp(-2.0 * k) : 0.0))) / k;
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  double turn = std::atan2(sine * std::cos(about), cosine) * 180.0 / std::numbers::pi;
  if (turn > 90.0) turn -= 180.0;  // a pole that points down belongs to the same plane
  if (turn < -90.0) turn += 180.0;
  return turn;
}

void append(std::vector<JointLine>& lines, const JointSet& set, std::size_t index, const Polygon& domain,
            SetStatistics& drawn) {
  const Window w = window_of(set, domain);
  Random random(set.seed);
  const std::size_t first = lines.size();
  for (const Offset& offset : offsets(set, w, random, drawn)) {
    const Vec2 pivot = w.origin + offset.t * w.normal + w.s * w.along;
    const double dip =
        set.fisher_k > 0.0 ? set.dip_deg.mean + fisher_turn_deg(set.fisher_k, random) : set.dip_deg.draw(random);
    drawn.drawn_dip.add(dip);
    const Vec2 along = direction_deg(dip);
    const double half = 1.1 * w.radius;  // the window and a margin for lines rotated about their pivot
    for (const TraceInterval& i : intervals(set, -w.s, offset.k, half, random, drawn)) {
      const Segment whole{pivot + i.from * along, pivot + i.to * along};
      if (!set.region) {
        append(lines, whole, domain, set.joint, JointLine::Kind::joint_set, index);
        continue;
      }
      for (const Segment& s : clipped(whole, {*set.region, {}}))
        append(lines, s, domain, set.joint, JointLine::Kind::joint_set, index);
    }
  }
  for (std::size_t i = first; i < lines.size(); ++i) drawn.total_length += (lines[i].to - lines[i].from).norm();
  drawn.lines = static_cast<std::int64_t>(lines.size() - first);
}

/// Area of a polygon, or of its part within a ring, then by a grid of points, 400 along the longer side.
double area_within(const Polygon& domain, const std::optional<Ring>& ring) {
  double area = 0.0;
  for (std::size_t r = 0; r < domain.rings(); ++r)
    area += (r == 0 ? 1.0 : -1.0) * std::abs(signed_area(domain.ring(r)));
  if (!ring) return area;
  const Polygon region{*ring, {}};
  const Box box = bounds(region);
  const double step = (box.hi - box.lo).maxCoeff() / 400.0;
  double inside = 0.0;
  for (double y = box.lo.y() + 0.5 * step; y < box.hi.y(); y += step)
    for (double x = box.lo.x() + 0.5 * step; x < box.hi.x(); x += step)
      if (contains(region, {x, y}) && contains(domain, {x, y})) inside += step * step;
  return inside;
}

}  // namespace

Vec2 direction_deg(double angle_deg) {
  const double turn = std::fmod(angle_deg, 360.0), quarter = turn / 90.0;
  if (quarter == std::floor(quarter)) {
    const Vec2 axes[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    return axes[(static_cast<int>(quarter) % 4 + 4) % 4];
  }
  const double angle = turn * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

std::vector<Vec2> chord_points(const Arc& arc) {
  std::vector<Vec2> points;
  for (int i = 0; i <= arc.chords; ++i)
    points.emplace_back(arc.centre +
                        arc.radius * direction_deg(arc.from_deg + (arc.to_deg - arc.from_deg) * i / arc.chords));
  return points;
}

std::vector<Segment> clipped(const Segment& segment, const Polygon& polygon) {
  const Vec2 d = segment.b - segment.a;
  const double length = d.norm();
  std::vector<double> cuts{0.0, 1.0};
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring& ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 e = ring[(i + 1) % ring.size()] - ring[i], to = ring[i] - segment.a;
      const double det = cross(d, e);
      if (std::abs(det) <= 1e-14 * length * e.norm()) {  // parallel: the corners are enough
        for (const Vec2& corner : {ring[i], ring[(i + 1) % ring.size()]})
          cuts.push_back((corner - segment.a).dot(d) / (length * length));
        continue;
      }
      const double u = cross(to, d) / det;
      if (u >= -1e-12 && u <= 1.0 + 1e-12) cuts.push_back(cross(to, e) / det);
    }
  }
  std::erase_if(cuts, [](double t) { return !(t >= 0.0 && t <= 1.0); });
  std::sort(cuts.begin(), cuts.end());
  std::vector<TraceInterval> kept;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] - cuts[i] <= 1e-13) continue;
    if (!contains(polygon, segment.a + 0.5 * (cuts[i] + cuts[i + 1]) * d)) continue;
    if (!kept.empty() && cuts[i] - kept.back().to <= 1e-12)
      kept.back().to = cuts[i + 1];
    else
      kept.push_back({cuts[i], cuts[i + 1]});
  }
  const auto at = [&](double t) -> Vec2 { return t == 0.0 ? segment.a : t == 1.0 ? segment.b : segment.a + t * d; };
  std::vector<Segment> out;
  out.reserve(kept.size());
  for (const TraceInterval& i : kept) out.push_back({at(i.from), at(i.to)});
  return out;
}

double expected_traces(const JointSet& set, const Polygon& domain) {
  const Window w = window_of(set, domain);
  const double lines = 2.0 * (w.radius + std::abs(w.t)) / set.spacing.mean + 1.0;  // also those from origin to window
  if (!set.length) return lines;
  return lines * (2.2 * w.radius / (set.length->mean + set.gap.mean) + 1.0);
}

double expected_crossings(const JointSet& first, const JointSet& second, const Polygon& domain) {
  double area = std::abs(signed_area(domain.outer));
  for (const Ring& hole : domain.holes) area -= std::abs(signed_area(hole));
  // Length of traces per unit area [1/m], and the area in which there are any.
  const auto density = [](const JointSet& s) {
    return (s.length ? s.length->mean / (s.length->mean + s.gap.mean) : 1.0) / s.spacing.mean;
  };
  const auto extent = [area](const JointSet& s) {
    return s.region ? std::min(area, std::abs(signed_area(*s.region))) : area;
  };
  return std::min(extent(first), extent(second)) * density(first) * density(second) *
         std::abs(cross(direction_deg(first.dip_deg.mean), direction_deg(second.dip_deg.mean)));
}

NetworkSize expected_size(const JointNetwork& network, const Polygon& domain) {
  NetworkSize out;
  for (std::size_t i = 0; i < network.sets.size(); ++i) {
    out.lines += expected_traces(network.sets[i], domain);
    for (std::size_t j = 0; j < i; ++j) out.crossings += expected_crossings(network.sets[i], network.sets[j], domain);
  }
  return out;
}

double Sample::deviation() const {
  if (n < 2) return 0.0;
  const double count = static_cast<double>(n);
  return std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0)));
}

double SetStatistics::asked_density() const { return persistence() / drawn_moments(spacing, true).mean; }

Moments1 drawn_moments(const Spread& s, bool positive) {
  switch (s.distribution) {
    case Distribution::uniform:
      return {s.mean, s.deviation / std::numbers::sqrt3};
    case Distribution::exponential:
      return {s.mean, s.mean};
    case Distribution::lognormal:
      return {s.mean, s.deviation};
    case Distribution::normal:
      break;
  }
  if (!positive || !(s.deviation > 0.0)) return {s.mean, s.deviation};
  // Cut off at a = -mean/deviation: mean + d l, d^2 (1 + a l - l^2), l = pdf(a)/(1 - cdf(a)).
  const double a = -s.mean / s.deviation, pdf = std::exp(-0.5 * a * a) / std::sqrt(2.0 * std::numbers::pi),
               l = pdf / (0.5 * std::erfc(a / std::numbers::sqrt2));
  return {s.mean + s.deviation * l, s.deviation * std::sqrt(std::max(0.0, 1.0 + a * l - l * l))};
}

double fisher_deviation_deg(double k) {
  constexpr int kSteps = 400;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double u = (i + 0.5) / kSteps, cosine = 1.0 + std::log(1.0 - u * (1.0 - std::exp(-2.0 * k))) / k,
                 sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    for (int j = 0; j < kSteps; ++j) {
      double turn = std::atan2(sine * std::cos(2.0 * std::numbers::pi * (j + 0.5) / kSteps), cosine);
      if (turn > 0.5 * std::numbers::pi) turn -= std::numbers::pi;
      if (turn < -0.5 * std::numbers::pi) turn += std::numbers::pi;
      sum += turn * turn;
    }
  }
  return std::sqrt(sum) / kSteps * 180.0 / std::numbers::pi;
}

std::vector<JointLine> draw_lines(const JointNetwork& network, const Polygon& domain,
                                  std::vector<SetStatistics>* statistics) {
  std::vector<JointLine> lines;
  const auto polyline = [&](const std::vector<Vec2>& points, JointId joint, JointLine::Kind kind, std::size_t source) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      append(lines, Segment{points[i], points[i + 1]}, domain, joint, kind, source);
  };
  for (std::size_t i = 0; i < network.traces.size(); ++i)
    polyline(network.traces[i].points, network.traces[i].joint, JointLine::Kind::trace, i);
  for (std::size_t i = 0; i < network.arcs.size(); ++i)
    polyline(chord_points(network.arcs[i]), network.arcs[i].joint, JointLine::Kind::arc, i);
  for (std::size_t i = 0; i < network.sets.size(); ++i) {
    const JointSet& set = network.sets[i];
    SetStatistics drawn;
    drawn.joint = set.joint;
    drawn.dip_deg = set.dip_deg;
    drawn.spacing = set.spacing;
    drawn.length = set.length.value_or(Spread());
    drawn.gap = set.gap;
    drawn.fisher_k = set.fisher_k;
    drawn.through = !set.length;
    drawn.drawn_dip.about = set.dip_deg.mean;
    drawn.drawn_spacing.about = set.spacing.mean;
    drawn.drawn_length.about = drawn.length.mean;
    drawn.drawn_gap.about = set.gap.mean;
    append(lines, set, i, domain, drawn);
    drawn.area = statistics == nullptr ? 0.0 : area_within(domain, set.region);
    if (statistics != nullptr) statistics->push_back(drawn);
  }
  return lines;
}

}  // namespace scree
