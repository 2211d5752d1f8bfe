#include "coupling/stages/bolt_observer.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {
namespace {

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double x : values) most = std::max(most, std::abs(x));
  return most;
}

}  // namespace

BoltObserver::BoltObserver(const Setup& setup, const State& state) {
  for (std::size_t i = 0; i < setup.model().bolts.size(); ++i) {
    rows_.push_back(bolt_rows(setup, state, i));
    liner_.push_back(rows_.back().liner ? 1 : 0);
  }
}

const BoltsView* BoltObserver::view(const State& state) {
  if (rows_.empty()) return nullptr;
  for (auto* v : {&force_, &shear_, &slip_, &strain_, &position_, &node_force_}) v->clear();
  broken_.clear();
  node_bolt_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const BoltMemory& m = state.bolts[i];
    const bool liner = rows_[i].liner;
    const auto most = std::max_element(m.force.begin(), m.force.end(), [liner](double a, double b) {
      return liner ? std::abs(a) < std::abs(b) : a < b;
    });
    force_.push_back(m.force.empty() ? 0.0 : *most);
    shear_.push_back(largest(m.shear));
    slip_.push_back(largest(m.slipped));
    broken_.push_back(static_cast<std::int32_t>(std::count(m.broken.begin(), m.broken.end(), 1)));
    double strain = 0.0;
    for (std::size_t s = 0; s < m.plastic.size(); ++s)
      if (m.rest[s] > 0.0) strain = std::max(strain, (liner ? std::abs(m.plastic[s]) : m.plastic[s]) / m.rest[s]);
    strain_.push_back(strain);
    if (m.installed != 1) continue;
    for (std::size_t k = 0; k < rows_[i].nodes; ++k) {
      const Vec2 x = scree::coupling::position(rows_[i].row[k], state.q);
      position_.insert(position_.end(), {x.x(), x.y()});
      node_force_.push_back(k < m.force.size() ? m.force[k] : 0.0);
      node_bolt_.push_back(static_cast<std::int32_t>(i));
    }
  }
  view_ = {force_, shear_, slip_, strain_, broken_, position_, node_force_, node_bolt_, liner_};
  return &view_;
}

}  // namespace scree::coupling
