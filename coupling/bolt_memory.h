// What a bolt remembers from step to step; part of the State.
#pragma once

#include <cstdint>
#include <vector>

namespace scree::coupling {

/// One bolt of the model, in the order of Model::bolts.
struct BoltMemory {
  std::int8_t installed = 0;  // 0: not yet; 1: it is there; 2: a block that it was in has been taken away
  // A segment: length at which it has no force while no node slips and nothing has yielded [m], plastic elongation [m],
  // force [N], 1 where it is broken.
  std::vector<double> rest, plastic, force;
  std::vector<std::int8_t> broken;
  // A node: how far the bar has moved through the rock towards the toe [m], the part of it that the bond has slipped
  // [m], force of the rock on the bar towards the head [N].
  std::vector<double> slip, slipped, bond;
  // A crossing: shear displacement at which it has no force while nothing has yielded [m], plastic part [m], force [N].
  std::vector<double> offset, sheared, shear;
  double slack = 0.0;       // of a first segment that hangs slack: its elongation, negative [m]
  double energy = 0.0;      // elastic, of steel and grout [J]
  double dissipated = 0.0;  // by yield and slip since it was installed [J]
  double breaking = 0.0;    // explicit steps: energy that the next one loses, because something has just broken [J]

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("bolt.installed", installed);
    see("bolt.rest", rest);
    see("bolt.plastic", plastic);
    see("bolt.force", force);
    see("bolt.broken", broken);
    see("bolt.slip", slip);
    see("bolt.slipped", slipped);
    see("bolt.bond", bond);
    see("bolt.offset", offset);
    see("bolt.sheared", sheared);
    see("bolt.shear", shear);
    see("bolt.slack", slack);
    see("bolt.energy", energy);
    see("bolt.dissipated", dissipated);
    see("bolt.breaking", breaking);
  }
};

}  // namespace scree::coupling
