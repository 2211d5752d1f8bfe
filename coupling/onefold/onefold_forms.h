// Matrices of an implicit step of blocks on onefold covers, in their stars and in centroidal form: for studies of the
// two; steps themselves use the centroidal form only.
#pragma once

#include <Eigen/Core>

#include "coupling/contact/table/known_contacts.h"

namespace scree::coupling {

/// Matrices over the unknowns of the free blocks, six per block [kg], [N/m].
struct OnefoldMatrices {
  Eigen::MatrixXd mass, stiffness;
  Eigen::MatrixXd rows;     // of gap and stretch of every contact
  Eigen::VectorXd springs;  // of each row [N/m]
  [[nodiscard]] Eigen::MatrixXd contact() const { return rows.transpose() * springs.asDiagonal() * rows; }
  /// Matrix of a step h by Newmark (1/2, 1), all contacts closed and sticking.
  [[nodiscard]] Eigen::MatrixXd of_step(double h) const { return 2.0 / (h * h) * mass + stiffness + contact(); }
};

/// Each form is computed by its own formulas, neither from the other:
///   in the stars       M_ij = int rho w_i w_j,  K of the element,  contact J^T (kn g g^T + kt s s^T) J with g, s the
///                      gradients of gap and stretch, J the weights of points in the triangle ([Qu2013] eq. 7.20-7.55)
///   centroidal         diag(m, S/r^2),  A/r^2 dP/dF,  the same g and s with J of x = c + F X
/// and A_centroidal = B^T A_stars B with the map d_stars = B d_centroidal.
struct OnefoldForms {
  OnefoldMatrices stars, centroidal;
  Eigen::MatrixXd map;  // B
};

/// @param q  positions of the state   @param contacts  all points of the list are taken as closed, with the springs
///           of their memory
/// @pre every free block has a onefold cover
[[nodiscard]] OnefoldForms onefold_forms(const Setup& setup, std::span<const double> q, const ContactList& contacts);

/// Largest over smallest singular value.
[[nodiscard]] double condition_number(const Eigen::MatrixXd& A);

}  // namespace scree::coupling
