#include "io/results/xdmf_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "model/check.h"

namespace scree::io::xdmf {

namespace {

constexpr std::int32_t kPolygon = 3;
constexpr double kTick = 1e-12;  // [s]

double just_before(double time) {
  return time - std::max(kTick, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(time));
}

}  // namespace

std::string item(const Array& array) {
  SCREE_ASSERT(array.numbers.empty() || (!array.whole && std::ssize(array.numbers) == array.rows * array.width));
  return fmt::format("<DataItem Format=\"{}\" NumberType=\"{}\" Precision=\"{}\" Dimensions=\"{}{}\">{}{}</DataItem>\n",
                     array.numbers.empty() ? "HDF" : "XML", array.whole ? "Int" : "Float", array.whole ? 4 : 8,
                     array.rows, array.width > 1 ? fmt::format(" {}", array.width) : "", array.path,
                     fmt::join(array.numbers, " "));
}

std::vector<std::int32_t> mixed_polygons(std::span<const std::int32_t> offsets,
                                         std::span<const std::int32_t> connectivity) {
  std::vector<std::int32_t> mixed;
  if (offsets.empty()) return mixed;
  mixed.reserve(connectivity.size() + 2 * (offsets.size() - 1));
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    const std::int32_t points = offsets[c + 1] - offsets[c];
    SCREE_ASSERT(points >= 3);
    const auto cell = connectivity.subspan(static_cast<std::size_t>(offsets[c]), static_cast<std::size_t>(points));
    mixed.insert(mixed.end(), {kPolygon, points});
    mixed.insert(mixed.end(), cell.begin(), cell.end());
  }
  return mixed;
}

std::string topology(std::int64_t cells, const Array& mixed) {
  return fmt::format("<Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">\n{}</Topology>\n", cells, item(mixed));
}

std::string geometry(std::string_view type, const Array& points) {
  return fmt::format("<Geometry GeometryType=\"{}\">\n{}</Geometry>\n", type, item(points));
}

std::string attribute(std::string_view name, std::string_view center, std::string_view type, const Array& values) {
  return fmt::format("<Attribute Name=\"{}\" Center=\"{}\" AttributeType=\"{}\">\n{}</Attribute>\n", name, center, type,
                     item(values));
}

std::string grid(std::int64_t number, std::string_view parts, double time) {
  return fmt::format("<Grid Name=\"frame {}\">\n{}<Time Value=\"{:.17g}\"/>\n</Grid>\n", number, parts, time);
}

std::string_view opening() {
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
         "<!-- Frames of run.vtkhdf for ParaView. Made by Scree. -->\n"
         "<Xdmf Version=\"3.0\">\n<Domain>\n"
         "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
}

std::string_view closing() { return "</Grid>\n</Domain>\n</Xdmf>\n"; }

std::vector<double> told_apart(std::vector<double> times) {
  for (std::size_t i = times.size(); i-- > 1;) times[i - 1] = std::min(times[i - 1], just_before(times[i]));
  return times;
}

}  // namespace scree::io::xdmf
