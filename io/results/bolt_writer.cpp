#include "io/results/bolt_writer.h"

namespace scree::io {

BoltWriter::BoltWriter(const h5::File& file, const Model& model) {
  file.group("/bolts");
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const std::string g = "/bolts/" + model.bolts[i].name;
    bolts_.push_back(
        {{file, g + "/time", 1, {"s", "time"}},
         {file, g + "/force", 1, {"N", "largest axial force of its segments, for unit thickness"}},
         {file, g + "/shear", 1, {"N", "largest shear force at the joints it crosses, for unit thickness"}},
         {file, g + "/slip", 1, {"m", "largest slip of its bond"}},
         {file, g + "/plastic_strain", 1, {"1", "largest plastic strain of its segments"}},
         {file, g + "/broken", 1, {"1", "segments that are broken"}}});
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

void BoltWriter::append(const coupling::HistoryView& history) {
  const coupling::BoltsView& view = *history.bolts;
  for (std::size_t i = 0; i < bolts_.size(); ++i) {
    bolts_[i].force.append(view.force[i]);
    bolts_[i].shear.append(view.shear[i]);
    bolts_[i].slip.append(view.slip[i]);
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
  for (const scree::Bolt& b : model.bolts)
    for (const auto& [end, units] :
         {std::pair{".force", "N"}, {".shear", "N"}, {".slip", "m"}, {".plastic_strain", "1"}, {".broken", "1"}})
      columns.emplace_back(b.name + end, units);
  return columns;
}

void add_bolt_values(const coupling::HistoryView& history, std::vector<double>& row) {
  if (history.bolts == nullptr) return;
  const coupling::BoltsView& view = *history.bolts;
  for (std::size_t i = 0; i < view.force.size(); ++i)
    row.insert(row.end(),
               {view.force[i], view.shear[i], view.slip[i], view.strain[i], static_cast<double>(view.broken[i])});
}

}  // namespace scree::io
