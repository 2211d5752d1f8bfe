// Role of a method: its bodies, their nodes and their boundary.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/body.h"

namespace scree {

/// A body in an invalid configuration (not finite, or inverted).
struct Fault {
  int body = -1;      // in the pool; -1: none
  std::string where;  // what is wrong and where in it, e.g. "element 12 near (0.5, 2) is turned inside out"
};

/// All bodies of one method in contiguous arrays. Spans q, v hold two numbers (x, y) per node of this pool.
class BodySet {
 public:
  BodySet() = default;
  BodySet(const BodySet&) = delete;
  BodySet& operator=(const BodySet&) = delete;
  virtual ~BodySet() = default;

  [[nodiscard]] virtual std::string_view method() const = 0;
  /// Appends a body made from the record; its nodes follow those of the bodies before it.
  virtual void add(const Model& model, const BodyRecord& record) = 0;
  /// The same for a body that an earlier set has as its body `body`, perhaps in another shape or form: what is the same
  /// for both may be copied from it.
  virtual void add_again(const Model& model, const BodyRecord& record, const BodySet& earlier, int body);
  /// Called once after the last body was added.
  virtual void finish() {}
  [[nodiscard]] virtual int bodies() const = 0;
  /// First node of a body; first_node(bodies()) is the number of nodes.
  [[nodiscard]] virtual std::int32_t first_node(int body) const = 0;
  [[nodiscard]] virtual const Boundary& boundary(int body) const = 0;
  /// Row of any material point of the body (supports, monitors).
  [[nodiscard]] virtual Row row_at(int body, const Vec2& X) const = 0;
  /// Nodes of the two halves of a divided body that are the same point of one continuum.
  struct InterfaceConstraint {
    std::int32_t explicit_node, implicit_node;  // in the pool
  };
  [[nodiscard]] virtual std::span<const InterfaceConstraint> interface_constraints(int body) const;
  /// Per node of a divided body: its number in the undivided body, counted from the body's first node; empty: the body
  /// is not divided.
  [[nodiscard]] virtual std::span<const std::int32_t> undivided(int body) const;
  /// Sets positions and velocities of nodes that follow others from the nodes that they follow.
  virtual void settle(int body, std::span<double> q, std::span<double> v) const;
  /// True for a node of the inactive half of a divided body: another time integrator moves it.
  [[nodiscard]] virtual bool idle(std::int32_t node) const;
  /// Weights t of a translation: a translation by a adds t_k a to node k of the body.
  [[nodiscard]] virtual std::span<const double> translation(int body) const = 0;
  /// The first body in an invalid configuration: not finite, or inverted.
  [[nodiscard]] virtual Fault find_fault(std::span<const double> q) const;
};

}  // namespace scree
