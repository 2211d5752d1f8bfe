// What is stored of a bolt from step to step; part of the State.
#pragma once

#include <cstdint>
#include <vector>

namespace scree::coupling {

/// One bolt of the model, in the order of Model::bolts.
struct BoltMemory {
  std::int8_t installed = 0;  // 0: not yet installed; 1: installed; 2: a block that it crossed has been removed
  // Per segment: length at zero force while no node slips and nothing has yielded [m], plastic elongation [m], force
  // [N], 1 where it is broken.
  std::vector<double> rest, plastic, force;
  std::vector<std::int8_t> broken;
  // Per node: displacement of the bar relative to the rock towards the toe [m], the part of this displacement that is
  // slip of the bond [m], force of the rock on the bar towards the head [N].
  std::vector<double> slip, slipped, bond;
  // Per crossing: shear displacement at zero force while nothing has yielded [m], plastic part [m], force [N].
  std::vector<double> offset, sheared, shear;
  double slack = 0.0;       // elongation of the first segment while it is slack, negative [m]
  double energy = 0.0;      // elastic energy of steel and grout [J]
  double dissipated = 0.0;  // by yield and slip since the installation [J]
  double breaking = 0.0;    // explicit: energy lost in the next step, by what has just broken [J]

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
