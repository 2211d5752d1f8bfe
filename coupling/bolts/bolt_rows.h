// Bolts and liners in the bodies of a stage: positions of their nodes, lengths of their segments, forces on the rock.
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

/// Rows of one bolt of the model.
[[nodiscard]] BoltRows bolt_rows(const Setup& setup, const State& state, std::size_t bolt);
/// Rows of all installed bolts that this setup applies: in a partitioned stage those with an explicit body belong to
/// the explicit side, the others to the implicit side.
[[nodiscard]] std::vector<BoltRows> acting_bolts(const Setup& setup, const State& state);

/// The generalised displacements of a bolt at a configuration, and their differentials. With x the positions of the
/// rows, for a segment between nodes a and b, and for a crossing with D the vector from where it leaves to where it
/// enters:
///   l = |x_b - x_a|,                                    dl = t.(dx_b - dx_a)
///   shear = n.D, n across the bar's direction inside the blocks, A = x_b - x_a - sum of D,
///                                                       d(shear) = n.dD - (D.A/|A|^2) n.dA
/// A liner has no crossings. Its turns take their place, and that of shears: the angles from one segment to the next,
/// between -pi and pi:
///   turn = angle(x_c - x_b) - angle(x_b - x_a),         d(turn) = n_2.(dx_c - dx_b)/l_2 - n_1.(dx_b - dx_a)/l_1
/// All are invariant under rigid motions of all blocks together, so that forces from them keep all momenta.
class BoltShape {
 public:
  void measure(const BoltRows& rows, std::span<const double> q);
  [[nodiscard]] std::span<const double> lengths() const { return length_; }
  /// Shears of a bolt [m], or turns of a liner [rad].
  [[nodiscard]] std::span<const double> shears() const { return shear_; }
  /// Directions of the segments.
  [[nodiscard]] const Vec2& direction(std::size_t segment) const { return along_[segment]; }
  /// Calls see(row, c) for every row of d(shear) = sum c.dx(row); a row may occur twice.
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
  /// Forces of the bar on the rock, per row.
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

/// f += forces of all bolts at the present instant, from their memory.
void add_bolt_forces(const Setup& setup, const State& state, std::span<double> f);

/// Installs the bolts that are due in the present stage, or were due in one before it, at their present place: they
/// have their pretension, and no other force. Books their energy and the work of the jack.
void install_bolts(const Setup& setup, State& state);

/// Releases the forces of what broke in the last explicit step: at the start of a stage. Books the energy.
void settle_broken_bolts(const Setup& setup, State& state);

/// Where bodies have been made anew: shifts the lengths without force, so that the forces of bolts stay.
/// @param before   acting_bolts() of the earlier bodies   @param q_before  their positions
void keep_bolt_forces(const std::vector<BoltRows>& before, std::span<const double> q_before, const Setup& to,
                      State& state);

}  // namespace scree::coupling
