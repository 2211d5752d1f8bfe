// Bolts and liners in the bodies of a stage: where their nodes are, how long their segments, what they push.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "coupling/bodies/setup.h"
#include "model/bolt.h"

namespace scree::coupling {

/// A bolt as the bodies of a stage carry it. Rows count in the state's nodes.
struct BoltRows {
  std::int32_t bolt = -1;  // into Model::bolts
  bool liner = false;
  std::vector<Row> row;         // its nodes, then for each crossing where it leaves one block and enters the next
  std::vector<BodyIndex> body;  // of each row
  std::size_t nodes = 0, segments = 0;
  std::vector<std::int32_t> segment;  // of each crossing of a bolt
  struct Turn {
    std::array<std::size_t, 2> segment;
    std::array<std::size_t, 3> row;
  };
  std::vector<Turn> turn;  // of a liner, in the place of crossings
  [[nodiscard]] std::size_t crossings() const { return segment.size() + turn.size(); }
  [[nodiscard]] std::size_t leaves(std::size_t crossing) const { return nodes + 2 * crossing; }
};

/// Of one bolt of the model.
[[nodiscard]] BoltRows bolt_rows(const Setup& setup, const State& state, std::size_t bolt);
/// Of all bolts that are installed and that this setup is to apply: of a partitioned stage, the explicit side's where
/// one of its bodies is explicit, else the implicit side's.
[[nodiscard]] std::vector<BoltRows> acting_bolts(const Setup& setup, const State& state);

/// The generalised displacements of a bolt at a configuration, and how they depend on it. With x the positions of the
/// rows, of a segment between nodes a and b, and of a crossing with D the way from where it leaves to where it enters:
///   l = |x_b - x_a|,                                    dl = t.(dx_b - dx_a)
///   shear = n.D, n across the bar's direction inside the blocks, A = x_b - x_a - sum of D,
///                                                       d(shear) = n.dD - (D.A/|A|^2) n.dA
/// A liner has no crossings. Their place, and that of shears, is taken by its turns, the angles from one segment to the
/// next, between -pi and pi:
///   turn = angle(x_c - x_b) - angle(x_b - x_a),         d(turn) = n_2.(dx_c - dx_b)/l_2 - n_1.(dx_b - dx_a)/l_1
/// All are the same for whoever turns or moves with the blocks, so that forces from them keep all momenta.
class BoltShape {
 public:
  void measure(const BoltRows& rows, std::span<const double> q);
  [[nodiscard]] std::span<const double> lengths() const { return length_; }
  /// Of a bolt [m], or the turns of a liner [rad].
  [[nodiscard]] std::span<const double> shears() const { return shear_; }
  /// Directions of the segments.
  [[nodiscard]] const Vec2& direction(std::size_t segment) const { return along_[segment]; }
  /// Calls see(row, c) for every row of d(shear) = sum c.dx(row); a row may come twice.
  template <class See>
  void shear_form(const BoltRows& rows, std::size_t crossing, See&& see) const {
    if (rows.liner) return turn_form(rows.turn[crossing], std::forward<See>(see));
    const auto s = static_cast<std::size_t>(rows.segment[crossing]);
    const Vec2 &n = across_[crossing], w = turn_[crossing] * n;
    see(rows.leaves(crossing), -n);
    see(rows.leaves(crossing) + 1, n);
    see(s, -w);
    see(s + 1, w);
    for (std::size_t c = 0; c < rows.crossings(); ++c) {
      if (rows.segment[c] != rows.segment[crossing]) continue;
      see(rows.leaves(c), w);
      see(rows.leaves(c) + 1, -w);
    }
  }
  /// Forces on the rows: what the bar does to the rock.
  void push(const BoltRows& rows, const BoltMemory& memory, std::span<Vec2> force) const;

 private:
  template <class See>
  void turn_form(const BoltRows::Turn& turn, See&& see) const {
    const Vec2 a = quarter_turn() * along_[turn.segment[0]] / length_[turn.segment[0]],
               b = quarter_turn() * along_[turn.segment[1]] / length_[turn.segment[1]];
    see(turn.row[0], a);
    see(turn.row[1], Vec2(-a - b));
    see(turn.row[2], b);
  }
  std::vector<double> length_, shear_, turn_;
  std::vector<Vec2> along_, across_;
};

/// f += forces of all bolts at the present instant, as they are remembered.
void add_bolt_forces(const Setup& setup, const State& state, std::span<double> f);

/// Installs the bolts that begin with the present stage, or were to begin with one before it, where they are now: they
/// have their pretension, and no other force. Books their energy and the work that the jack has done for it.
void install_bolts(const Setup& setup, State& state);

/// Lets go of what broke in the last explicit step: for a stage that begins. Books the energy.
void settle_broken_bolts(const Setup& setup, State& state);

/// Bodies have been made anew: shifts the lengths without force, so that bolts pull as before.
/// @param before   acting_bolts() of the bodies that were   @param q_before  their positions
void keep_bolt_forces(const std::vector<BoltRows>& before, std::span<const double> q_before, const Setup& to,
                      State& state);

}  // namespace scree::coupling
