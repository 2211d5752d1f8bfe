// What is stored of a contact point from step to step.
#pragma once

#include <compare>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace scree::coupling {

enum class ContactStatus : std::int32_t { open, slip, stick };

/// Identity of a contact: a vertex of one block against an outline edge of another. It is independent of the methods.
struct ContactKey {
  std::int32_t block_p = -1, ring_p = 0, vertex = 0, part = 0;  // the corner; part > 0: a mesh node along edge `vertex`
  std::int32_t block_e = -1, ring_e = 0, edge = 0;              // the edge
  auto operator<=>(const ContactKey&) const = default;
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// Data of the friction check for a contact point that slides; all but `worst` are zero while it does not slide.
/// 72 bytes, since memories are copied at every step: sums over the present window are double, results are float.
/// @see coupling/contact/audit/friction_check.h
struct SlideMemory {
  /// Sum over one or more windows: net slip in elastic stretches; impulses of tangential force and Coulomb limit [N s].
  struct Sum {
    float slip = 0.0F, drag = 0.0F, limit = 0.0F;
  };
  double slip = 0.0, drag = 0.0, limit = 0.0;            // in the present window [m], [N s], [N s]
  double time = 0.0;                                     // elapsed in the present window [s]
  float length = 0.0F;                                   // of the whole present window [s]; 0: no sliding
  Sum last{};                                            // the previous window; the first one has no impulses
  Sum total{};                                           // of the windows counted below
  std::int32_t losing = 0;                               // number of successive windows that lose friction,
  std::int16_t keeping = 0;                              // and that keep it; the count is limited
  std::int16_t lost = 0;                                 // 1: a window of the stretch lost friction
  float worst = std::numeric_limits<float>::infinity();  // smallest ratio of impulses in a long stretch

  /// The stretch is over.
  void end() {
    const float kept = worst;
    *this = SlideMemory{};
    worst = kept;
  }
};

/// What is stored of a contact point between steps.
struct ContactMemory {
  ContactKey key;
  ContactStatus status = ContactStatus::open;
  std::int32_t failed = 0;       // 1 once cohesion is lost
  std::int32_t bonded = 0;       // 1: closed since t = 0 with a tensile strength that is not lost
  std::int32_t joint = -1;       // joint law, chosen when the pair was first found
  std::int32_t segment = -1;     // segment of the edge that the anchor below refers to, counted within the edge
  double gap0 = 0.0;             // gap that counts as closed without stress (closed at t = 0, changed tributary) [m]
  double gap = 0.0;              // present gap minus gap0 [m]
  double stretch = 0.0;          // elongation of the tangential spring [m]
  double anchor = 0.0;           // anchor of the tangential spring: fraction of the segment
  double fn = 0.0, ft = 0.0;     // forces on the corner, along the outward normal and the direction of the edge [N]
  double fd = 0.0, fdt = 0.0;    // parts of fn and ft that are damping [N]
  double water = 0.0;            // force of the water in the joint on the corner, along the outward normal [N]
  double slip = 0.0;             // accumulated |slip| [m]
  double slip_known = 0.0;       // part of it already used by the friction law (model/friction_law.h) [m]
  double friction_change = 0.0;  // tan phi by that law minus tan of the friction angle
  std::int32_t edge_edge = 0;    // 1: part of an edge-edge contact; 0: a corner against an edge
  double tributary = 0.0;        // length of joint that the point stands for [m]
  double kn = 0.0, kt = 0.0;     // stiffness of its springs [N/m]
  double impact = 0.0;           // remaining time with the springs it closed with [s] (explicit steps)
  SlideMemory slide{};
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

// ---------------------------------------------------------------------------------------------------------------

static_assert(sizeof(SlideMemory) == 72);

template <class Visitor>
void ContactKey::visit(Visitor&& see) const {
  see("contact.block_p", block_p);
  see("contact.ring_p", ring_p);
  see("contact.vertex", vertex);
  see("contact.part", part);
  see("contact.block_e", block_e);
  see("contact.ring_e", ring_e);
  see("contact.edge", edge);
}

template <class Visitor>
void ContactMemory::visit(Visitor&& see) const {
  key.visit(see);
  see("contact.status", status);
  see("contact.failed", failed);
  see("contact.bonded", bonded);
  see("contact.joint", joint);
  see("contact.segment", segment);
  see("contact.gap0", gap0);
  see("contact.gap", gap);
  see("contact.stretch", stretch);
  see("contact.anchor", anchor);
  see("contact.fn", fn);
  see("contact.ft", ft);
  see("contact.fd", fd);
  see("contact.fdt", fdt);
  see("contact.water", water);
  see("contact.slip", slip);
  see("contact.slip_known", slip_known);
  see("contact.friction_change", friction_change);
  see("contact.edge_edge", edge_edge);
  see("contact.tributary", tributary);
  see("contact.kn", kn);
  see("contact.kt", kt);
  see("contact.impact", impact);
  see("contact.slide_length", slide.length);
  see("contact.slide_time", slide.time);
  see("contact.slide_slip", slide.slip);
  see("contact.slide_drag", slide.drag);
  see("contact.slide_limit", slide.limit);
  for (const SlideMemory::Sum* sum : {&slide.last, &slide.total}) {
    see("contact.slide_sum_slip", sum->slip);
    see("contact.slide_sum_drag", sum->drag);
    see("contact.slide_sum_limit", sum->limit);
  }
  see("contact.slide_losing", slide.losing);
  see("contact.slide_keeping", slide.keeping);
  see("contact.slide_lost", slide.lost);
  see("contact.slide_worst", slide.worst);
}

}  // namespace scree::coupling
