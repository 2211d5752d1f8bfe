#include "io/results/history_writer.h"

#include <algorithm>

#include "model/check.h"

namespace scree::io {

std::string_view side_name(coupling::Side side) {
  switch (side) {
    case coupling::Side::energy:
      return "energy";
    case coupling::Side::work:
      return "work";
    case coupling::Side::dissipated:
      return "dissipated";
    case coupling::Side::scheme:
      return "scheme";
  }
  return "";
}

std::vector<std::string> monitor_names(const Model& model) {
  std::vector<std::string> names;
  for (const scree::Monitor& monitor : model.monitors) {
    std::string base = monitor.name.empty() || monitor.name == "." ? "monitor" : monitor.name;
    std::replace(base.begin(), base.end(), '/', '_');
    std::string name = base;
    for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n)
      name = base + "_" + std::to_string(n);
    names.push_back(name);
  }
  return names;
}

HistoryWriter::HistoryWriter(const h5::Growing& in, const Model& model) {
  in.file->group("/history");
  const std::vector<std::string> names = monitor_names(model);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string group = "/history/" + names[i];
    monitors_.push_back({{in, group + "/time", 1, {"s", "time"}},
                         {in, group + "/position", 2, {"m", "position x, y"}},
                         {in, group + "/displacement", 2, {"m", "displacement x, y since the start"}},
                         {in, group + "/velocity", 2, {"m/s", "velocity x, y"}},
                         {in, group + "/stress", 3, {"Pa", "recovered Cauchy stress xx, yy, xy; tension positive"}}});
    in.file->attribute(group, "name", model.monitors[i].name);
    in.file->attribute(group, "order", static_cast<std::int64_t>(i));
    in.file->attribute(group, "block", model.blocks[model.monitors[i].block.index()].name);
    in.file->attribute(group, "long_name", "monitor " + model.monitors[i].name);
  }
  const std::string group = "/energy/";
  time_ = {in, group + "time", 1, {"s", "time"}};
  for (int c = 0; c < coupling::kColumns; ++c) {
    const coupling::ColumnInfo& column = coupling::info(static_cast<coupling::Column>(c));
    const std::string name = group + std::string(column.name);
    columns_.emplace_back(in, name, 1, h5::Label{"J", std::string(column.meaning)});
    in.file->attribute(name, "side", std::string(side_name(column.side)));
    in.file->attribute(name, "order", std::int64_t{c});
  }
  energy_ = {in, group + "energy", 1, {"J", "energy held: sum of the columns of side energy"}};
  closure_ = {in, group + "closure", 1, {"J", "E - E_0 - W + D - R: zero but for rounding"}};
  moved_ = {in, group + "moved", 1, {"J", "running sum of |increments| of all columns"}};
  passed_ = {in, group + "passed", 1, {"J", "energy passed: the largest so far of what was given and what is held"}};
}

void HistoryWriter::append(const coupling::HistoryView& history) {
  SCREE_ASSERT(history.ledger != nullptr && history.position.size() == 2 * monitors_.size() &&
               history.stress.size() == 3 * monitors_.size());
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    monitors_[i].time.append(history.time);
    monitors_[i].position.append(history.position.subspan(2 * i, 2));
    monitors_[i].displacement.append(history.displacement.subspan(2 * i, 2));
    monitors_[i].velocity.append(history.velocity.subspan(2 * i, 2));
    monitors_[i].stress.append(history.stress.subspan(3 * i, 3));
  }
  for (int c = 0; c < coupling::kColumns; ++c)
    columns_[static_cast<std::size_t>(c)].append((*history.ledger)[static_cast<coupling::Column>(c)]);
  energy_.append(history.ledger->energy());
  closure_.append(history.ledger->closure());
  moved_.append(history.ledger->moved());
  passed_.append(history.ledger->passed());
  time_.append(history.time);
}

}  // namespace scree::io
