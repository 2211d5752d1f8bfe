// Decompositions of small dense matrices, compiled once: each costs several seconds of compilation per source file.
#pragma once

#include <Eigen/Core>

namespace scree {

// Matrices of a fixed size are converted. Each call allocates its results, so that loops over elements or contact
// points should not call these functions with matrices of two or three rows.

/// Eigenvalues and, as columns in the same order, eigenvectors.
struct Modes {
  Eigen::VectorXd values;   // n, ascending
  Eigen::MatrixXd vectors;  // n x n
};

/// Eigenvalues of a symmetric matrix (n), ascending. Only the lower triangle is read.
[[nodiscard]] Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);
/// A X = X diag(values), X^T X = I. Only the lower triangle is read.   @pre A symmetric
[[nodiscard]] Modes symmetric_modes(const Eigen::MatrixXd& A);

/// Eigenvalues of A x = lambda B x (n), ascending. Only the lower triangles are read.
/// @pre A symmetric, B symmetric and positive definite
[[nodiscard]] Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A X = B X diag(values), X^T B X = I. Only the lower triangles are read.
/// @pre A symmetric, B symmetric and positive definite
[[nodiscard]] Modes generalized_modes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Eigenvalues of any square matrix (n), in no particular order, each as often as its multiplicity.
/// @pre finite numbers
[[nodiscard]] Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A);

/// Singular values of an m x n matrix (the smaller of m and n), descending.
[[nodiscard]] Eigen::VectorXd singular_values(const Eigen::MatrixXd& A);

/// The lower triangular L of A = L L^T. Only the lower triangle of A is read.   @pre A symmetric
/// @return not a number in every entry if A is not positive definite
[[nodiscard]] Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& A);

/// X of A X = B by A = L L^T, with as many columns as B. Only the lower triangle of A is read.
/// @pre A symmetric and positive definite
[[nodiscard]] Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// X of A X = B by A = P^T L D L^T P with pivots from the diagonal.
/// @pre A symmetric, positive or negative semi-definite
[[nodiscard]] Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// X of A X = B by A = P^T L U with partial pivoting.   @pre A square and not singular
[[nodiscard]] Eigen::MatrixXd solve_general(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A^-1 by A = P^T L U with partial pivoting.   @pre A square and not singular
[[nodiscard]] Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& A);

/// X (n columns of A x columns of B) that minimises the Euclidean norm of each column of A X - B, by A P = Q R with
/// pivoting of columns.   @pre as many rows as columns or more, independent columns
[[nodiscard]] Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace scree
