#include "coupling/integrate/cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace scree::coupling {
namespace {

/// OpenBLAS on several threads rounds differently from one; the symbol is looked up because another BLAS has none.
void single_threaded_blas() {
  using Setter = void (*)(int);
  if (void* symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<Setter>(symbol)(1);
}

/// All of D of a factor L D L'.
bool positive(const cholmod_factor& factor) {
  const auto* start = static_cast<const std::int32_t*>(factor.p);
  const auto* x = static_cast<const double*>(factor.x);
  return std::all_of(start, start + factor.n, [&](std::int32_t k) { return x[k] > 0.0; });
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
    cholmod_free_factor(&updated, &common);
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_finish(&common);
  }
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_factor* updated = nullptr;  // a copy of the factor as L D L', with what has changed since factorise()
  std::vector<std::int32_t> inverse_permutation;
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

  /// The updated factor, made from the factor when it is first needed.
  cholmod_factor* to_update();
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
  cholmod_free_factor(&impl_->updated, &impl_->common);
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
  cholmod_free_factor(&s.updated, &s.common);
  cholmod_factorize(&A, s.factor, &s.common);
  ++s.factorisations;
  if (s.common.status != CHOLMOD_OK || s.factor->minor != static_cast<std::size_t>(s.pattern.n)) return false;
  // Small systems are factorised as L D L', which does not stop at a negative number of D.
  return s.factor->is_ll != 0 || s.factor->is_super != 0 || positive(*s.factor);
}

cholmod_factor* Cholesky::Impl::to_update() {
  if (updated != nullptr) return updated;
  updated = cholmod_copy_factor(factor, &common);
  if (updated == nullptr || cholmod_change_factor(CHOLMOD_REAL, 0, 0, 0, 0, updated, &common) == 0)
    throw std::runtime_error("CHOLMOD: no memory for a factor that can be updated");
  const auto* permutation = static_cast<const std::int32_t*>(updated->Perm);
  inverse_permutation.resize(updated->n);
  for (std::size_t k = 0; k < updated->n; ++k)
    inverse_permutation[static_cast<std::size_t>(permutation[k])] = static_cast<std::int32_t>(k);
  return updated;
}

double Cholesky::relative_work(std::span<const Change> changes) {
  Impl& s = *impl_;
  const cholmod_factor* L = s.to_update();
  const auto *start = static_cast<const std::int32_t*>(L->p), *row = static_cast<const std::int32_t*>(L->i),
             *size = static_cast<const std::int32_t*>(L->nz);
  double visited = 0.0;
  for (const Change& c : changes) {
    auto k = static_cast<std::int32_t>(L->n);
    for (const std::int32_t d : c.dof) k = std::min(k, s.inverse_permutation[static_cast<std::size_t>(d)]);
    // An update changes the columns from its first place to the root of the elimination tree.
    while (k < static_cast<std::int32_t>(L->n)) {
      visited += size[k];
      k = size[k] > 1 ? row[start[k] + 1] : static_cast<std::int32_t>(L->n);
    }
  }
  // An operation of an update against one of a factorisation: dense blocks are quicker, single columns as slow.
  const double slower = s.factor->is_super != 0 ? 8.0 : 1.0;
  return slower * 4.0 * visited / std::max(s.common.fl, 1.0);
}

bool Cholesky::update(std::span<const Change> changes) {
  Impl& s = *impl_;
  cholmod_factor* L = s.to_update();
  std::vector<std::pair<std::int32_t, double>> entries;
  for (const bool up : {true, false}) {
    std::vector<std::int32_t> start{0}, row;
    std::vector<double> value;
    for (const Change& c : changes) {
      if (c.delta == 0.0 || (c.delta > 0.0) != up) continue;
      entries.clear();
      for (std::size_t j = 0; j < c.dof.size(); ++j)
        entries.emplace_back(s.inverse_permutation[static_cast<std::size_t>(c.dof[j])],
                             std::sqrt(std::abs(c.delta)) * c.h[j]);
      std::sort(entries.begin(), entries.end());
      for (const auto& [k, x] : entries) {
        row.push_back(k);
        value.push_back(x);
      }
      start.push_back(static_cast<std::int32_t>(row.size()));
    }
    if (row.empty()) continue;
    cholmod_sparse W{};
    W.nrow = L->n;
    W.ncol = start.size() - 1;
    W.nzmax = row.size();
    W.p = start.data();
    W.i = row.data();
    W.x = value.data();
    W.stype = 0;
    W.itype = CHOLMOD_INT;
    W.xtype = CHOLMOD_REAL;
    W.dtype = CHOLMOD_DOUBLE;
    W.sorted = 1;
    W.packed = 1;
    if (cholmod_updown(up ? 1 : 0, &W, L, &s.common) == 0 || s.common.status != CHOLMOD_OK) return false;
  }
  return positive(*L);
}

void Cholesky::solve(std::span<const double> b, std::span<double> x) {
  Impl& s = *impl_;
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = rhs.nzmax = static_cast<std::size_t>(s.pattern.n);
  rhs.ncol = 1;
  rhs.x = const_cast<double*>(b.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast): CHOLMOD only reads it
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, s.updated != nullptr ? s.updated : s.factor, &rhs, nullptr, &s.solution, nullptr,
                     &s.work_y, &s.work_e, &s.common) == 0)
    throw std::runtime_error("CHOLMOD: solve failed");
  const auto* found = static_cast<const double*>(s.solution->x);
  std::copy(found, found + s.pattern.n, x.begin());
}

std::int64_t Cholesky::factorisations() const { return impl_->factorisations; }
std::int64_t Cholesky::analyses() const { return impl_->analyses; }
double Cholesky::factor_size() const { return impl_->common.lnz; }

}  // namespace scree::coupling
