#include "io/results/bolt_writer.h"

#include <algorithm>

namespace scree::io {

BoltWriter::BoltWriter(const h5::File& file, const Model& model) {
  const auto liner = [](const scree::Bolt& b) { return b.liner(); };
  if (!std::all_of(model.bolts.begin(), model.bolts.end(), liner)) file.group("/bolts");
  if (std::any_of(model.bolts.begin(), model.bolts.end(), liner)) file.group("/liners");
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    if (model.bolts[i].liner()) {
      add_liner(file, model.bolts[i], i);
      continue;
    }
    const std::string g = "/bolts/" + model.bolts[i].name;
    bolts_.push_back(
        {{file, g + "/time", 1, {"s", "time"}},
         {file, g + "/force", 1, {"N", "largest axial force of its segments, for unit thickness"}},
         {file, g + "/shear", 1, {"N", "largest shear force at the joints it crosses, for unit thickness"}},
         {file, g + "/slip", 1, {"m", "largest slip of its bond"}},
         {file, g + "/plastic_strain", 1, {"1", "largest plastic strain of its segments"}},
         {file, g + "/broken", 1, {"1", "segments that are broken"}},
         false});
    file.attribute(g, "order", static_cast<std::int64_t>(i));
    file.attribute(g, "long_name", "bolt " + model.bolts[i].name);
  }
  const std::string g = "/bolt_nodes/";
  bolt_ = {file, g + "bolt", 1, {"1", "bolt of a node, counted from 0 in the order of the case"}};
  position_ = {file, g + "position", 2, {"m", "x, y of the rock at a node"}};
  force_ = {file, g + "force", 1, {"N", "axial force from a node to the next, for unit thickness; tension positive"}};
  first_ = {file, g + "frames/first", 1, {"1", "first row of a frame"}};
  count_ = {file, g + "frames/count", 1, {"1", "rows of a frame"}};
}

void BoltWriter::add_liner(const h5::File& file, const scree::Bolt& liner, std::size_t index) {
  const std::string g = "/liners/" + liner.name;
  bolts_.push_back(
      {{file, g + "/time", 1, {"s", "time"}},
       {file, g + "/thrust", 1, {"N", "axial force of the bar that bears most, for unit thickness; tension positive"}},
       {file, g + "/moment", 1, {"N m", "size of the largest bending moment at a node, for unit thickness"}},
       {},
       {file, g + "/plastic_strain", 1, {"1", "size of the largest plastic strain of its bars"}},
       {file, g + "/broken", 1, {"1", "bars that are broken"}},
       true});
  file.attribute(g, "order", static_cast<std::int64_t>(index));
  file.attribute(g, "long_name", "liner " + liner.name);
}

void BoltWriter::append(const coupling::HistoryView& history) {
  const coupling::BoltsView& view = *history.bolts;
  for (std::size_t i = 0; i < bolts_.size(); ++i) {
    bolts_[i].force.append(view.force[i]);
    bolts_[i].shear.append(view.shear[i]);
    if (!bolts_[i].liner) bolts_[i].slip.append(view.slip[i]);
    bolts_[i].strain.append(view.strain[i]);
    bolts_[i].broken.append(view.broken[i]);
    bolts_[i].time.append(history.time);
  }
}

void BoltWriter::frame(const coupling::FrameView& frame) {
  const coupling::BoltsView& view = *frame.bolts;
  first_.append(force_.rows());
  count_.append(static_cast<std::int64_t>(view.bolt.size()));
  for (std::size_t k = 0; k < view.bolt.size(); ++k) {
    bolt_.append(view.bolt[k]);
    force_.append(view.node_force[k]);
  }
  position_.append(view.position);
}

std::vector<std::pair<std::string, std::string>> bolt_columns(const Model& model) {
  std::vector<std::pair<std::string, std::string>> columns;
  for (const scree::Bolt& b : model.bolts) {
    const std::vector<std::pair<const char*, const char*>> of_bolt = {{".force", "N"}, {".shear", "N"}, {".slip", "m"}},
                                                           of_liner = {{".thrust", "N"}, {".moment", "N m"}};
    for (const auto& [end, units] : b.liner() ? of_liner : of_bolt) columns.emplace_back(b.name + end, units);
    columns.emplace_back(b.name + ".plastic_strain", "1");
    columns.emplace_back(b.name + ".broken", "1");
  }
  return columns;
}

void add_bolt_values(const coupling::HistoryView& history, std::vector<double>& row) {
  if (history.bolts == nullptr) return;
  const coupling::BoltsView& view = *history.bolts;
  for (std::size_t i = 0; i < view.force.size(); ++i) {
    row.insert(row.end(), {view.force[i], view.shear[i]});
    if (view.liner[i] == 0) row.push_back(view.slip[i]);
    row.insert(row.end(), {view.strain[i], static_cast<double>(view.broken[i])});
  }
}

}  // namespace scree::io
