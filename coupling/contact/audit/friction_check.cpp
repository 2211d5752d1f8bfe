#include "coupling/contact/audit/friction_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {
namespace {

float ratio(const SlideMemory::Sum& sum) { return -std::copysign(1.0F, sum.slip) * sum.drag / sum.limit; }

/// Adds a window to the successive ones that lose friction, or to those that keep it.
/// @param still  nothing moves the ground or changes the loads any more
void add(const SlideMemory::Sum& window, bool still, SlideMemory& s) {
  const bool loses = ratio(window) < FrictionCheck::kLeast;
  if (s.losing == 0 ? loses : !loses && s.keeping >= FrictionCheck::kBetween) {
    s.total = {};
    s.losing = s.keeping = 0;
  }
  s.total.slip += window.slip;
  s.total.drag += window.drag;
  s.total.limit += window.limit;
  if (loses) {
    ++s.losing;
    if (still || s.losing >= FrictionCheck::kLosing) s.lost = 1;
  } else if (s.keeping <= FrictionCheck::kBetween) {
    ++s.keeping;
  }
  if (std::abs(s.total.slip) > FrictionCheck::kStretches && (s.losing == 0 || s.losing >= FrictionCheck::kLosing))
    s.worst = std::min(s.worst, ratio(s.total));
}

/// End of the last motion and the last function of a stage [s]; infinite: one of them does not end.
double last_change(const Setup& setup) {
  const Model& model = setup.model();
  const Clocks& clocks = setup.clocks();
  double last = 0.0;
  const auto take = [&](const std::vector<double>& origins, std::size_t i, double end) {
    const double origin = origins.empty() ? 0.0 : origins[i];
    if (std::isfinite(origin)) last = std::max(last, origin + end);  // the others do not begin in this stage
  };
  for (std::size_t i = 0; i < model.motions.size(); ++i) {
    const GroundMotion& m = model.motions[i];
    take(clocks.motion, i, m.setting().start + (m.times().back() - m.times().front()));
  }
  for (std::size_t i = 0; i < model.functions.size(); ++i) take(clocks.function, i, model.functions[i].end());
  return last;
}

/// Doubles the length of the next windows, with which the stretch begins anew.
/// @param slip  of the window before them, in elastic stretches: the pace at which the point slides on
void lengthen(float slip, SlideMemory& s) {
  const float length = 2.0F * s.length;
  const std::int16_t lost = s.lost;
  s.end();
  s.length = length;
  s.lost = lost;
  s.last.slip = 2.0F * slip;
}

/// Adds a complete window to the stretch, or ends the stretch.
/// @param stretch  elongation of the spring at the mean limit of the window, or slip that a block's strain may cause
/// [m]
/// @param longest  windows of a stretch that is not steady are lengthened up to this [s]; 0: a motion or function
/// still acts
void close_window(double stretch, double longest, SlideMemory& s) {
  SlideMemory::Sum window{stretch > 0.0 ? static_cast<float>(s.slip / stretch) : 0.0F, static_cast<float>(s.drag),
                          static_cast<float>(s.limit)};
  const float pace = s.last.slip == 0.0F ? 0.0F : window.slip / s.last.slip;
  const bool first = s.last.slip == 0.0F, slides = std::abs(window.slip) >= FrictionCheck::kCreeps,
             steady = pace <= FrictionCheck::kPace && pace * FrictionCheck::kPace >= 1.0F;
  if (pace >= 0.0F && (!slides || (!first && !steady)) && 2.0 * static_cast<double>(s.length) <= longest)
    return lengthen(slides ? window.slip : 0.0F, s);
  if (!slides || pace < 0.0F) return s.end();
  if (s.last.limit > 0.0F && steady) {
    add(s.last, longest > 0.0, s);
  } else {
    s.total = {};
    s.losing = s.keeping = 0;
  }
  if (first || std::abs(window.slip) < 1.0F) window.drag = window.limit = 0.0F;  // the point may have stopped between
  s.last = window;
  s.slip = s.drag = s.limit = s.time = 0.0;
}

}  // namespace

FrictionCheck::FrictionCheck(const Setup& setup) : setup_(&setup), last_change_(last_change(setup)) {
  const Model& model = setup.model();
  stiffness_.reserve(setup.bodies().size());  // so that steps need not allocate
  for (const Body& b : setup.bodies()) {
    const Block& block = model.blocks[b.block.index()];
    const Material& rock = model.materials[block.material.index()];
    const double area = moments(block.polygon).area, shear = rock.young / (2.0 * (1.0 + rock.poisson));
    bodies_.push_back(
        {!b.driven || b.ghost, rock.density * area, 2.0 * std::sqrt(area * rock.density / shear), std::sqrt(area)});
  }
}

void FrictionCheck::forget(ContactList& list) {
  for (ContactMemory& m : list.memory) m.slide.end();
}

double FrictionCheck::deformation(const ContactPoint& p) const {
  const Outlines& o = setup_->outlines();
  double least = std::numeric_limits<double>::infinity();
  for (const BodyIndex b : {o.vertices[p.vertex].body, o.edges[p.edge].body}) {
    const Inertia& body = bodies_[b];
    if (body.free) least = std::min(least, body.size);
  }
  return std::isfinite(least) ? kStrain * least : 0.0;
}

double FrictionCheck::period(const ContactPoint& p) {
  const Outlines& o = setup_->outlines();
  const auto body_of_vertex = [&](const ContactPoint& c) { return o.vertices[c.vertex].body; };
  const auto body_of_edge = [&](const ContactPoint& c) { return o.edges[c.edge].body; };
  if (!summed_) {
    summed_ = true;
    stiffness_.assign(bodies_.size(), 0.0);
    for (std::size_t i = 0; i < list_->points.size(); ++i) {
      const ContactMemory& m = list_->memory[i];
      if (m.status == ContactStatus::open) continue;
      stiffness_[body_of_vertex(list_->points[i])] += m.kt;
      stiffness_[body_of_edge(list_->points[i])] += m.kt;
    }
  }
  double longest = 0.0;
  for (const BodyIndex b : {body_of_vertex(p), body_of_edge(p)}) {
    if (!bodies_[b].free || !(stiffness_[b] > 0.0)) continue;
    const double on_contacts = 2.0 * std::numbers::pi * std::sqrt(bodies_[b].mass / stiffness_[b]);
    longest = std::max(longest, std::hypot(on_contacts, bodies_[b].period));
  }
  return longest;
}

double FrictionCheck::limit(const ContactMemory& m) const {
  if (m.status == ContactStatus::open) return 0.0;
  const auto joint = static_cast<std::size_t>(m.joint);
  return strength(setup_->laws()[joint], setup_->laws().tan_friction(joint), m).friction_limit(m.fn);
}

void FrictionCheck::add_step(double h, double slip, double limit, ContactMemory& m) const {
  SlideMemory& s = m.slide;
  s.time += h;
  s.slip += slip;
  s.drag += h * m.ft;
  s.limit += h * limit;
}

bool FrictionCheck::goes_on(double h, double slip, ContactMemory& m) const {
  const SlideMemory& s = m.slide;
  if (slip == 0.0 && s.length == 0.0F) return true;  // it does not slide
  const double most = limit(m);
  if (!std::isfinite(most)) return true;
  if (s.length == 0.0F || s.time + h >= static_cast<double>(s.length)) return false;
  add_step(h, slip, most, m);
  return true;
}

void FrictionCheck::change_window(double h, const ContactPoint& p, double slip, ContactMemory& m) {
  SlideMemory& s = m.slide;
  if (s.length == 0.0F) s.length = static_cast<float>(std::max(period(p), h));
  add_step(h, slip, limit(m), m);
  if (s.time >= static_cast<double>(s.length))
    close_window(std::max(s.limit / (s.time * m.kt), deformation(p)), still_ ? kLongest * period(p) : 0.0, s);
}

}  // namespace scree::coupling
