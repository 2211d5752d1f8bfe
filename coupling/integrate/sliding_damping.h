// How fast the deformation of blocks that slide is damped.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "coupling/contact/contact_energy.h"
#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {

/// Coulomb friction mu N makes the stiffness of a sliding block unsymmetric: its deformation and its contacts can
/// exchange energy with the slide, the block vibrates (flutter), hops, and loses friction on average. Rock that slides
/// steadily is what tables and tests report, so free blocks are damped while they slide, at the rate
///   a = 2 xi w_1 min(1, 3 s)^(3/2) max(1, 2 mu^3),
///   s = sum of N mu N/(c A + mu N) over sliding contacts / sum of N over closed contacts of the block,
///   mu^3 the mean of cubes over the sliding contacts, weighted as s is,
/// on v_d = v - R (R^T M R)^-1 R^T M v, with R the three rigid motions of the block and w_1 the lowest frequency of its
/// affine deformation, so that neither slide nor spin is slowed. The damping is mass-proportional and taken at the new
/// velocity: the stable explicit step stays as it is. A contact slides once it has slipped in one direction for a
/// natural period of the block by more than its elastic stretch (FrictionCheck), until the direction reverses: waves
/// that make a joint slip back and forth are not damped. The damping that stops the flutter grows with the square of
/// friction: meshes of a 10 x 5 m block need xi above 0.6, 0.75, 1.15 and 1.7 on slopes of 35, 40, 45 and 50 degrees. A
/// contact that slips against cohesion has no such stiffness, and counts by the share of friction in its strength. The
/// damping is numerical regularisation, not attenuation of rock. Blocks that are held, driven, on point supports or on
/// viscous edges are exempt.
class SlidingDamping {
 public:
  /// @param fraction  xi, of critical; 0: none
  SlidingDamping(const Setup& setup, double fraction);

  /// False where no body of the setup can ever be damped.
  [[nodiscard]] bool used() const { return used_; }
  /// Whether a body can ever be damped.
  [[nodiscard]] bool damps(std::size_t body) const { return most_[body] > 0.0; }
  /// Rates of a set of contacts: begin(), count() once per list, find().
  void begin();
  /// @param outlines  that the list refers to, of a setup with the same bodies
  void count(const Outlines& outlines, const ContactList& list);
  /// @return true if any body is damped
  bool find();
  /// Per body [1/s].
  [[nodiscard]] std::span<const double> rates() const { return rate_; }
  /// The rate of a body, at most 2 xi w_1 [1/s].
  [[nodiscard]] double moderate_rate(std::size_t body) const { return std::min(rate_[body], most_[body]); }

 private:
  /// Part of a sliding point's strength that is friction; 0 once its slip has reversed.
  [[nodiscard]] static double sliding_part(const Strength& now, const ContactMemory& m);
  /// A contact point that bears.
  struct Carrier {
    std::array<std::size_t, 2> body{};
    double force = 0.0, slides = 0.0, steep = 0.0;  // what it adds to all_, slipping_ and steep_
  };

  bool used_ = false;
  bool slid_ = false;  // contacts slid at the last count(): then the next one sums without first looking for sliding
  const JointLaws* laws_ = nullptr;
  std::vector<double> most_;            // per body: 2 xi w_1, or 0 where it is exempt [1/s]
  std::vector<double> slipping_, all_;  // per body: normal forces of its contacts [N]
  std::vector<double> steep_;           // per body: cubes of friction, weighted by slipping_ [N]
  std::vector<double> rate_;
  std::vector<Carrier> carriers_;               // scratch of count()
  std::vector<std::vector<Carrier>> by_chunk_;  // the same
};

/// Lowest frequency of affine deformation of a free body, w^2 the fourth eigenvalue of K - w^2 M on displacements
/// u = c + D X:  K from A/2 e:C:e with e = sym D,  M from m |c|^2 + tr(D S D^T).   @return w [rad/s]
[[nodiscard]] double lowest_deformation_frequency(const ReferenceShape& shape, const Elasticity& law);

/// The centre c of a body's rotation in rigid_turn(): the mean of its nodes, weighted by t.
[[nodiscard]] Vec2 centre_of_turn(const Setup& setup, const Body& body, std::span<const double> q);

/// The rotation W (q_k - t_k c) of a body about c, W the quarter turn.
/// @param turn  of the setup's node arrays, written on the body's nodes only
void rigid_turn(const Setup& setup, const Body& body, std::span<const double> q, std::span<double> turn);

/// The three rigid motions of a body on its nodes: translations t_k e_x, t_k e_y with the translation weights t, and
/// the rotation W (q_k - t_k c) about a point c near its centre, W the quarter turn.
/// @param out  3 spans of the setup's node arrays, written on the body's nodes only
void rigid_motions(const Setup& setup, const Body& body, std::span<const double> q, std::span<double> x,
                   std::span<double> y, std::span<double> turn);

}  // namespace scree::coupling
