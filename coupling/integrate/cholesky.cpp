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
  const SymmetricPattern* fixed = nullptr;
  std::span<const double> fixed_values;
  // The h of this system, one after another, and the lists that the present analysis was made for.
  std::vector<std::int32_t> start{0}, dof, analysed_start, analysed_dof;
  std::vector<double> h, scale;
  // The whole system; while there are no h it is the fixed part.
  SymmetricPattern pattern;
  std::vector<std::int32_t> place;  // of the fixed part's numbers, then of the lower triangle of every h h^T
  std::vector<double> value;
  std::int64_t factorisations = 0, analyses = 0;

  void find_places();
  void assemble();
};

void Cholesky::Impl::find_places() {
  std::vector<std::int32_t> i, j;
  for (std::int32_t c = 0; c < fixed->n; ++c)
    for (auto k = static_cast<std::size_t>(fixed->column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(fixed->column_start[static_cast<std::size_t>(c) + 1]); ++k) {
      i.push_back(fixed->row[k]);
      j.push_back(c);
    }
  for (std::size_t s = 0; s + 1 < start.size(); ++s)
    for (std::int32_t b = start[s]; b < start[s + 1]; ++b)
      for (std::int32_t a = b; a < start[s + 1]; ++a) {
        i.push_back(dof[static_cast<std::size_t>(a)]);
        j.push_back(dof[static_cast<std::size_t>(b)]);
      }
  place = pattern.make(fixed->n, i, j);
}

void Cholesky::Impl::assemble() {
  value.assign(pattern.size(), 0.0);
  const std::size_t own = fixed_values.size();
  for (std::size_t k = 0; k < own; ++k) value[static_cast<std::size_t>(place[k])] = fixed_values[k];
  std::size_t at = own;
  for (std::size_t s = 0; s + 1 < start.size(); ++s)
    for (auto b = static_cast<std::size_t>(start[s]); b < static_cast<std::size_t>(start[s + 1]); ++b)
      for (std::size_t a = b; a < static_cast<std::size_t>(start[s + 1]); ++a, ++at)
        value[static_cast<std::size_t>(place[at])] += scale[s] * h[a] * h[b];
}

Cholesky::Cholesky() : impl_(std::make_unique<Impl>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::set_pattern(const SymmetricPattern& pattern) {
  impl_->fixed = &pattern;
  cholmod_free_factor(&impl_->factor, &impl_->common);
}

void Cholesky::begin(std::span<const double> values) {
  impl_->fixed_values = values;
  impl_->start.assign(1, 0);
  impl_->dof.clear();
  impl_->h.clear();
  impl_->scale.clear();
}

void Cholesky::add_outer(std::span<const std::int32_t> dof, std::span<const double> h, double scale) {
  Impl& s = *impl_;
  s.dof.insert(s.dof.end(), dof.begin(), dof.end());
  s.h.insert(s.h.end(), h.begin(), h.end());
  s.start.push_back(static_cast<std::int32_t>(s.dof.size()));
  s.scale.push_back(scale);
}

bool Cholesky::factorise() {
  Impl& s = *impl_;
  const bool known = s.factor != nullptr && s.start == s.analysed_start && s.dof == s.analysed_dof;
  if (!known) s.find_places();
  s.assemble();
  cholmod_sparse A{};
  A.nrow = A.ncol = static_cast<std::size_t>(s.pattern.n);
  A.nzmax = s.value.size();
  A.p = s.pattern.column_start.data();
  A.i = s.pattern.row.data();
  A.x = s.value.data();
  A.stype = -1;
  A.itype = CHOLMOD_INT;
  A.xtype = CHOLMOD_REAL;
  A.dtype = CHOLMOD_DOUBLE;
  A.sorted = 1;
  A.packed = 1;
  if (!known) {
    cholmod_free_factor(&s.factor, &s.common);
    s.factor = cholmod_analyze(&A, &s.common);
    if (s.factor == nullptr) throw std::runtime_error("CHOLMOD: analysis failed");
    s.analysed_start = s.start;
    s.analysed_dof = s.dof;
    ++s.analyses;
  }
  cholmod_factorize(&A, s.factor, &s.common);
  ++s.factorisations;
  if (s.common.status != CHOLMOD_OK || s.factor->minor != static_cast<std::size_t>(s.pattern.n)) return false;
  // Small systems are factorised as L D L', which does not stop at a negative number of D.
  if (s.factor->is_ll != 0 || s.factor->is_super != 0) return true;
  const auto* start = static_cast<const std::int32_t*>(s.factor->p);
  const auto* x = static_cast<const double*>(s.factor->x);
  return std::all_of(start, start + s.pattern.n, [&](std::int32_t k) { return x[k] > 0.0; });
}

void Cholesky::solve(std::span<const double> b, std::span<double> x) {
  Impl& s = *impl_;
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = rhs.nzmax = static_cast<std::size_t>(s.pattern.n);
  rhs.ncol = 1;
  rhs.x = const_cast<double*>(b.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast): CHOLMOD only reads it
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, s.factor, &rhs, nullptr, &s.solution, nullptr, &s.work_y, &s.work_e, &s.common) == 0)
    throw std::runtime_error("CHOLMOD: solve failed");
  const auto* found = static_cast<const double*>(s.solution->x);
  std::copy(found, found + s.pattern.n, x.begin());
}

std::int64_t Cholesky::factorisations() const { return impl_->factorisations; }
std::int64_t Cholesky::analyses() const { return impl_->analyses; }
double Cholesky::factor_size() const { return impl_->common.lnz; }

}  // namespace scree::coupling
