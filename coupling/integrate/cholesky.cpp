#include "coupling/integrate/cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace scree::coupling {
namespace {

/// OpenBLAS on several threads rounds differently from one; the symbol is looked up because another BLAS has none.
void single_threaded_blas() {
  using Setter = void (*)(int);
  if (void* symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<Setter>(symbol)(1);
}

}  // namespace

struct Cholesky::Impl {
  Impl() {
    single_threaded_blas();
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_finish(&common);
  }
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;
  std::int32_t n = 0;
  std::vector<std::int32_t> row, column, analysed_row, analysed_column;
  std::vector<double> value;
  std::int64_t factorisations = 0, analyses = 0;

  void add(std::int32_t i, std::int32_t j, double x) {
    if (i < j) return;  // lower triangle only
    row.push_back(i);
    column.push_back(j);
    value.push_back(x);
  }
};

Cholesky::Cholesky() : impl_(std::make_unique<Impl>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::begin(std::int32_t n) {
  impl_->n = n;
  impl_->row.clear();
  impl_->column.clear();
  impl_->value.clear();
}

void Cholesky::add_outer(std::span<const std::int32_t> dof, std::span<const double> h, double scale) {
  for (std::size_t i = 0; i < dof.size(); ++i)
    for (std::size_t j = 0; j < dof.size(); ++j) impl_->add(dof[i], dof[j], scale * h[i] * h[j]);
}

void Cholesky::add_block(std::int32_t first, std::int32_t n, const double* m) {
  for (std::int32_t j = 0; j < n; ++j)
    for (std::int32_t i = j; i < n; ++i) impl_->add(first + i, first + j, m[static_cast<std::ptrdiff_t>(j) * n + i]);
}

bool Cholesky::factorise() {
  Impl& s = *impl_;
  cholmod_triplet triplet{};
  triplet.nrow = triplet.ncol = static_cast<std::size_t>(s.n);
  triplet.nnz = triplet.nzmax = s.value.size();
  triplet.i = s.row.data();
  triplet.j = s.column.data();
  triplet.x = s.value.data();
  triplet.stype = -1;
  triplet.itype = CHOLMOD_INT;
  triplet.xtype = CHOLMOD_REAL;
  triplet.dtype = CHOLMOD_DOUBLE;
  cholmod_sparse* A = cholmod_triplet_to_sparse(&triplet, 0, &s.common);
  if (A == nullptr) throw std::runtime_error("CHOLMOD: out of memory while assembling");
  if (s.factor == nullptr || s.row != s.analysed_row || s.column != s.analysed_column) {
    cholmod_free_factor(&s.factor, &s.common);
    s.factor = cholmod_analyze(A, &s.common);
    if (s.factor == nullptr) throw std::runtime_error("CHOLMOD: analysis failed");
    s.analysed_row = s.row;
    s.analysed_column = s.column;
    ++s.analyses;
  }
  cholmod_factorize(A, s.factor, &s.common);
  cholmod_free_sparse(&A, &s.common);
  ++s.factorisations;
  return s.common.status == CHOLMOD_OK && s.factor->minor == static_cast<std::size_t>(s.n);
}

void Cholesky::solve(std::span<const double> b, std::span<double> x) {
  Impl& s = *impl_;
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = rhs.nzmax = static_cast<std::size_t>(s.n);
  rhs.ncol = 1;
  rhs.x = const_cast<double*>(b.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast): CHOLMOD only reads it
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, s.factor, &rhs, nullptr, &s.solution, nullptr, &s.work_y, &s.work_e, &s.common) == 0)
    throw std::runtime_error("CHOLMOD: solve failed");
  const auto* found = static_cast<const double*>(s.solution->x);
  std::copy(found, found + s.n, x.begin());
}

std::int64_t Cholesky::factorisations() const { return impl_->factorisations; }
std::int64_t Cholesky::analyses() const { return impl_->analyses; }

}  // namespace scree::coupling
