#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "io/case/drawn_layers.h"
#include "io/case/line_file.h"
#include "io/case/read_parts.h"
#include "io/case/suggest.h"
#include "model/block_cutting.h"

namespace scree::io {
namespace {

constexpr double kManyPieces = 10000.0;  // lines and crossings that are cut within about a second

/// Reads a domain and keeps the sections and rows that its parts come from, for faults.
class DomainReader {
 public:
  DomainReader(const Section& section, const std::filesystem::path& folder, const DrawnLayers& drawing,
               const Model& model)
      : s_(section),
        folder_(folder),
        drawing_(drawing),
        materials_(names_of(model.materials)),
        joints_(names_of(model.joints)),
        regions_(section.list("region")),
        sets_(section.list("joint_set")),
        traces_(section.list("trace")),
        arcs_(section.list("arc")) {}

  Domain read() {
    Domain d;
    d.outline.outer = outline();
    d.outline.holes = s_.rings("holes");
    if (s_.has("holes_layer")) {
      if (!d.outline.holes.empty())
        throw s_.error("holes_layer", "holes and holes_layer are both given", "either holes or holes_layer",
                       "remove one of the two");
      for (Chain& c : drawing_.rings(s_, "holes_layer", "domain.holes")) {
        d.outline.holes.push_back(std::move(c.points));
        hole_rows_.push_back(c.row);
      }
    }
    d.prefix = s_.text("prefix");
    d.material = MaterialId{find_name(s_, "material", "material", materials_)};
    if (s_.has("joint")) d.joint = joint(s_);
    d.snap = s_.number_or_auto("snap");
    d.least_width = s_.number_or_auto("least_width");
    d.least_area = s_.number("least_area");
    const std::string& ends = s_.text("dead_ends");
    d.dead_ends = ends == "drop" ? DeadEnds::drop : ends == "extend" ? DeadEnds::extend : DeadEnds::keep;
    std::set<std::string> names{d.prefix};
    for (const Section& r : regions_)
      for (Region& one : regions_of(r, d)) {
        if (!names.insert(one.name).second)
          throw r.error("name", "another region, or domain.prefix, has the same name", "a name for each region",
                        "choose another name");
        d.regions.push_back(std::move(one));
      }
    for (std::size_t i = 0; i < sets_.size(); ++i) d.network.sets.push_back(joint_set(sets_[i], i));
    for (const Section& t : traces_) read_trace(t, d.network);
    for (const Section& a : arcs_)
      d.network.arcs.push_back({a.point("centre"), a.number("radius"), a.number("from_deg"), a.number("to_deg"),
                                a.integer("chords"), joint(a)});
    if (const auto fault = check_domain(d)) throw error(*fault);
    orient(d.outline);
    for (Region& r : d.regions) {
      Polygon ring{r.outline, {}};
      orient(ring);
      r.outline = ring.outer;
    }
    return d;
  }

 private:
  [[nodiscard]] JointId joint(const Section& s) const { return JointId{find_name(s, "joint", "joint", joints_)}; }

  /// Refuses none or more than one of several keys.
  static void check_one(const Section& s, std::initializer_list<const char*> keys, const char* none, const char* hint) {
    std::vector<std::string> given;
    std::string allowed = "one of";
    for (const char* key : keys) {
      if (s.has(key)) given.emplace_back(key);
      allowed += fmt::format("{} {}", key == *keys.begin() ? "" : key == *(keys.end() - 1) ? " and" : ",", key);
    }
    if (given.empty()) throw s.error(*keys.begin(), none, allowed, hint);
    if (given.size() > 1)
      throw s.error(given[1], fmt::format("{} and {} are both given", given[0], given[1]), allowed, hint);
  }

  Ring outline() {
    check_one(s_, {"outline", "outline_file", "outline_layer"}, "the domain has no outline",
              "write outline = [[x, y], [x, y], [x, y], ...]");
    if (s_.has("outline")) return s_.ring("outline");
    if (s_.has("outline_layer")) {
      const std::vector<Chain> rings = drawing_.rings(s_, "outline_layer", "domain.outline");
      if (rings.size() > 1)
        throw CaseError(drawing_.file(), {rings[1].row, 1},
                        {"another outline begins here", "domain.outline_layer", in_quotes(s_.text("outline_layer")),
                         "one closed line", "put other lines on another layer; holes have holes_layer"});
      outline_row_ = rings[0].row;
      return rings[0].points;
    }
    const std::filesystem::path file = path(s_, "outline_file");
    const std::vector<FileLine> lines = lines_of(s_, "outline_file");
    const auto fail = [&](int row, std::string problem, std::string hint) {
      throw CaseError(file.string(), {row, 1},
                      {std::move(problem), "domain.outline_file", "",
                       "one line of points, the first repeated at the end", std::move(hint)});
    };
    if (lines.size() > 1)
      fail(lines[1].rows[0], "another line begins here", "keep one line, without blank lines in it");
    Ring ring = lines[0].points;
    const Vec2 first = ring.front(), last = ring.back();
    if (ring.size() < 4 || first != last)
      fail(lines[0].rows.back(),
           fmt::format(
               "the outline is open: it ends at ({:.10g}, {:.10g}), {:.4g} m from its first point ({:.10g}, {:.10g})",
               last.x(), last.y(), (last - first).norm(), first.x(), first.y()),
           "repeat the first point in a last row, exactly, or add the points that are missing");
    ring.pop_back();
    return ring;
  }

  [[nodiscard]] std::filesystem::path path(const Section& s, std::string_view key) const {
    return folder_ / s.text(key);
  }
  /// A file that cannot be read is a fault of the key that names it; wrong rows are faults of the file.
  [[nodiscard]] std::vector<FileLine> lines_of(const Section& s, std::string_view key) const {
    try {
      return read_lines(path(s, key));
    } catch (const CaseError& e) {
      if (e.line > 0) throw;
      throw s.error(key, e.problem + ": " + in_quotes(path(s, key).string(), 400), "path of a text file with points",
                    "paths start from the folder of the case file; " + e.hint);
    }
  }

  /// The regions of a section: one, or one for each ring of a layer.
  [[nodiscard]] std::vector<Region> regions_of(const Section& r, const Domain& d) {
    check_one(r, {"polygon", "layer"}, "the region has no outline", "write polygon = [[x, y], [x, y], [x, y], ...]");
    const Region one = region(r, d);
    if (!r.has("layer")) {
      region_origin_.push_back({&r, 0});
      return {one};
    }
    std::vector<Region> out;
    const std::vector<Chain> rings = drawing_.rings(r, "layer", fmt::format("region {}", one.name));
    for (const Chain& c : rings) {
      Region next = one;
      if (rings.size() > 1) next.name += fmt::format("_{}", out.size() + 1);
      next.outline = c.points;
      region_origin_.push_back({&r, c.row});
      out.push_back(std::move(next));
    }
    return out;
  }

  [[nodiscard]] Region region(const Section& r, const Domain& d) const {
    Region out;
    out.name = r.text("name");
    if (r.has("polygon")) out.outline = r.ring("polygon");
    out.material = d.material;
    if (r.has("material")) out.material = MaterialId{find_name(r, "material", "material", materials_)};
    if (r.has("joint")) out.joint = joint(r);
    out.cut = r.boolean("cut");
    if (r.has("cover_size")) out.cover_size = r.number("cover_size");
    return out;
  }

  [[nodiscard]] static Spread spread(const Section& s, const std::string& mean, const std::string& deviation,
                                     const std::string& distribution) {
    const std::string& kind = s.text(distribution);
    Spread out{s.number(mean), s.number(deviation),
               kind == "normal"        ? Distribution::normal
               : kind == "uniform"     ? Distribution::uniform
               : kind == "exponential" ? Distribution::exponential
                                       : Distribution::lognormal};
    if (out.distribution == Distribution::exponential && out.deviation > 0.0)
      throw s.error(deviation, "an exponential distribution has no deviation of its own", "no deviation",
                    fmt::format("remove it: the deviation is {} itself", mean));
    return out;
  }
  /// The spread of a positive quantity.
  [[nodiscard]] static Spread positive_spread(const Section& s, const std::string& key, bool mean_elsewhere = false) {
    const std::string deviation = key + "_deviation";
    Spread out = spread(s, key, deviation, key + "_distribution");
    if (mean_elsewhere) return out;
    if (out.distribution == Distribution::uniform && out.deviation > out.mean)
      throw s.error(deviation, fmt::format("half the width of the distribution is more than {} itself", key),
                    fmt::format("0 <= value <= {:g}", out.mean), "values must be positive");
    if (out.varies() && !(out.mean > 0.0))
      throw s.error(key, fmt::format("{} varies, but has no mean value", key), "number [m], > 0",
                    fmt::format("give {}, or remove its deviation and distribution", key));
    return out;
  }

  [[nodiscard]] JointSet joint_set(const Section& s, std::size_t index) const {
    JointSet set;
    set.joint = joint(s);
    set.dip_deg = spread(s, "dip_deg", "dip_deviation_deg", "dip_distribution");
    set.spacing = positive_spread(s, "spacing");
    set.gap = positive_spread(s, "gap", s.has("persistence"));
    if (s.has("length")) {
      set.length = positive_spread(s, "length");
    } else {
      for (const char* key : {"gap", "length_deviation", "stagger"})
        if (s.number(key) > 0.0)
          throw s.error(key, "the lines run through: they have no traces", "a value beside length",
                        "add length, the length of a trace, or remove this");
    }
    if (s.has("persistence")) {
      if (!s.has("length"))
        throw s.error("persistence", "the lines run through: they have no traces", "a value beside length",
                      "add length, the length of a trace, or remove this");
      if (s.number("gap") > 0.0)
        throw s.error("persistence", "gap and persistence are both given", "either gap or persistence",
                      "remove one of the two");
      const double p = s.number("persistence");
      set.gap.mean = set.length->mean * (1.0 - p) / p;
      if (set.gap.varies() && !(set.gap.mean > 0.0))
        throw s.error("persistence", "gaps vary, but have no mean value", "a value below 1", "remove their deviation");
    }
    if (s.has("dip_fisher_k")) {
      if (set.dip_deg.varies())
        throw s.error("dip_fisher_k", "dip_deviation_deg and dip_fisher_k are both given", "one of the two",
                      "remove one of the two");
      set.fisher_k = s.number("dip_fisher_k");
    }
    set.stagger = s.number("stagger");
    if (s.has("origin")) set.origin = s.point("origin");
    if (s.has("region")) set.region = s.ring("region");
    if (!s.has("seed")) s.settle("seed", static_cast<std::int64_t>(index) + 1);
    set.seed = static_cast<std::uint64_t>(s.integer("seed"));
    return set;
  }

  void read_trace(const Section& t, JointNetwork& network) {
    check_one(t, {"points", "file", "layer"}, "the trace has no points", "write points = [[x, y], [x, y]]");
    const JointId law = joint(t);
    if (t.has("points")) {
      network.traces.push_back({t.ring("points"), law});
      origin_.push_back({&t, {}, 0});
      return;
    }
    if (t.has("layer")) {
      for (const DrawnLine* line : drawing_.lines(t, "layer", fmt::format("trace of joint {}", t.text("joint")))) {
        Ring points = line->points;
        if (line->closed) points.push_back(points.front());
        network.traces.push_back({std::move(points), law});
        origin_.push_back({&t, drawing_.file(), line->row});
      }
      return;
    }
    for (FileLine& line : lines_of(t, "file")) {
      network.traces.push_back({std::move(line.points), law});
      origin_.push_back({&t, path(t, "file").string(), line.rows.front()});
    }
  }

  [[nodiscard]] CaseError error(const DomainFault& f) const {
    using Part = DomainFault::Part;
    const auto at = [&](const Section& s, std::string_view key) { return s.error(key, f.what, f.allowed, f.hint); };
    const auto drawn = [&](int row) {
      return CaseError(drawing_.file(), {row, 1}, {f.what, "", "", f.allowed, f.hint});
    };
    switch (f.part) {
      case Part::outline:
        if (outline_row_ > 0) return drawn(outline_row_);
        return at(s_, s_.has("outline") ? "outline" : "outline_file");
      case Part::hole:
        if (!hole_rows_.empty()) return drawn(hole_rows_[f.index]);
        return s_.error("holes", f.index, f.what, f.allowed, f.hint);
      case Part::region:
        if (region_origin_[f.index].row > 0) return drawn(region_origin_[f.index].row);
        return at(*region_origin_[f.index].section, "polygon");
      case Part::set_spacing:
        return at(sets_[f.index], "spacing");
      case Part::set_region:
        return at(sets_[f.index], "region");
      case Part::trace:
        if (const TraceOrigin& o = origin_[f.index]; !o.file.empty())
          return {o.file, {o.row, 1}, {f.what, "", "", f.allowed, f.hint}};
        return at(*origin_[f.index].section, "points");
      case Part::arc:
        return at(arcs_[f.index], "to_deg");
      case Part::snap:
        break;
    }
    return at(s_, "snap");
  }

  struct TraceOrigin {
    const Section* section;
    std::string file;  // empty: the points are in the case
    int row;
  };

  struct RegionOrigin {
    const Section* section;
    int row;  // of the drawing; 0: the corners are in the case
  };

  const Section& s_;
  const std::filesystem::path& folder_;
  const DrawnLayers& drawing_;
  std::vector<std::string> materials_, joints_;
  std::vector<Section> regions_, sets_, traces_, arcs_;
  std::vector<TraceOrigin> origin_;  // of each trace of the network
  std::vector<RegionOrigin> region_origin_;
  std::vector<int> hole_rows_;  // of the drawing
  int outline_row_ = 0;
};

}  // namespace

void read_domain(const Section& section, const std::filesystem::path& folder, const DrawnLayers& drawing, Model& model,
                 const Notice& notice) {
  const Domain domain = DomainReader(section, folder, drawing, model).read();
  const NetworkSize size = expected_size(domain.network, domain.outline);
  if (notice && size.lines + size.crossings > kManyPieces)
    notice(
        fmt::format("domain: the joint sets draw about {:.2g} lines, which cross about {:.2g} times; cutting it into "
                    "blocks may take long",
                    size.lines, size.crossings));
  Cutting cutting;
  try {
    cutting = cut_blocks(domain);
  } catch (const std::runtime_error& e) {
    throw section.error("snap", std::string("the lines cannot be cut into blocks: ") + e.what(),
                        "\"auto\" or a grid well below the least distance of joints",
                        "give another snap, or larger spacings");
  }
  const auto first = static_cast<std::int32_t>(model.blocks.size());
  for (Block& b : cutting.blocks) model.blocks.push_back(std::move(b));
  for (Crack& c : cutting.cracks) c.block = BlockId{c.block.value + first};
  model.cracks = std::move(cutting.cracks);
  model.joint_lines = std::move(cutting.lines);
  model.joint_sets = std::move(cutting.sets);
  model.cutting = cutting.report;
}

}  // namespace scree::io
