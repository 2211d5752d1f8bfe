#include "coupling/linear/cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scree::coupling {
namespace {

constexpr double kDenseBlocks = 8.0;  // how much quicker an operation is in dense blocks than in single columns

/// CHOLMOD's own loops are too short for threads, and request a number of them independent of the program's setting: no
/// level of parallelism is allowed during the lifetime of an instance.
class OneThread {
 public:
  OneThread() : before_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
  ~OneThread() { omp_set_max_active_levels(before_); }

 private:
  int before_;
};

/// OpenBLAS on several threads rounds differently from one; the symbol is looked up because another BLAS has none.
void single_threaded_blas() {
  using Setter = void (*)(int);
  if (void* symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<Setter>(symbol)(1);
}

/// True if all of D of a factor L D L' are positive.
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
  SymmetricMatrix matrix;
  bool placed = false;                    // fixed_place and clique_place are of the matrix's pattern
  bool definite = false;                  // the factor is that of the matrix
  std::vector<std::int32_t> fixed_place;  // of the fixed part's numbers
  // The lists of unknowns to which the places below belong; each different list is a clique.
  std::vector<std::int32_t> placed_start, placed_dof, clique, clique_row, clique_first, clique_place;
  std::int64_t factorisations = 0, analyses = 0;

  /// The updated factor, made from the factor when it is first needed.
  cholmod_factor* to_update();
  /// Work of an update that visits so many numbers of the factor, over that of a factorisation.
  [[nodiscard]] double work(double visited) const;
  void find_cliques(const DofRows& rows);
  [[nodiscard]] bool find_places(const DofRows& rows);
  [[nodiscard]] bool find_fixed_places();
  void make_pattern(const DofRows& rows);
  void assemble(std::span<const double> values, const DofRows& rows, std::span<const double> scale);
  [[nodiscard]] bool factorise(bool analysed);
};

void Cholesky::Impl::find_cliques(const DofRows& rows) {
  placed_start.assign(rows.start().begin(), rows.start().end());
  placed_dof.assign(rows.dof().begin(), rows.dof().end());
  clique.resize(rows.size());
  clique_row.clear();
  std::unordered_map<std::string_view, std::int32_t> known;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::span<const std::int32_t> dof =
        std::span(placed_dof).subspan(static_cast<std::size_t>(placed_start[r]), rows[r].dof.size());
    const std::string_view key(reinterpret_cast<const char*>(dof.data()), dof.size_bytes());
    const auto [at, fresh] = known.try_emplace(key, static_cast<std::int32_t>(clique_row.size()));
    if (fresh) clique_row.push_back(static_cast<std::int32_t>(r));
    clique[r] = at->second;
  }
}

bool Cholesky::Impl::find_fixed_places() {
  fixed_place.resize(fixed->size());
  const SymmetricPattern& p = matrix.pattern;
  for (std::size_t c = 0; c < static_cast<std::size_t>(fixed->n); ++c) {
    auto k = static_cast<std::size_t>(p.column_start[c]);
    const auto end = static_cast<std::size_t>(p.column_start[c + 1]);
    for (auto f = static_cast<std::size_t>(fixed->column_start[c]);
         f < static_cast<std::size_t>(fixed->column_start[c + 1]); ++f) {
      while (k < end && p.row[k] < fixed->row[f]) ++k;
      if (k == end || p.row[k] != fixed->row[f]) return false;
      fixed_place[f] = static_cast<std::int32_t>(k);
    }
  }
  return true;
}

bool Cholesky::Impl::find_places(const DofRows& rows) {
  clique_first.clear();
  clique_place.clear();
  const SymmetricPattern& p = matrix.pattern;
  for (const std::int32_t row : clique_row) {
    clique_first.push_back(static_cast<std::int32_t>(clique_place.size()));
    const std::span<const std::int32_t> dof = rows[static_cast<std::size_t>(row)].dof;
    for (std::size_t b = 0; b < dof.size(); ++b) {
      auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(dof[b])]);
      const auto end = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(dof[b]) + 1]);
      for (std::size_t a = b; a < dof.size(); ++a) {
        while (k < end && p.row[k] < dof[a]) ++k;
        if (k == end || p.row[k] != dof[a]) return false;
        clique_place.push_back(static_cast<std::int32_t>(k));
      }
    }
  }
  return true;
}

void Cholesky::Impl::make_pattern(const DofRows& rows) {
  std::vector<std::int32_t> i, j;
  for (std::int32_t c = 0; c < fixed->n; ++c)
    for (auto k = static_cast<std::size_t>(fixed->column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(fixed->column_start[static_cast<std::size_t>(c) + 1]); ++k) {
      i.push_back(fixed->row[k]);
      j.push_back(c);
    }
  clique_first.clear();
  for (const std::int32_t row : clique_row) {
    clique_first.push_back(static_cast<std::int32_t>(i.size() - fixed->size()));
    const std::span<const std::int32_t> dof = rows[static_cast<std::size_t>(row)].dof;
    for (std::size_t b = 0; b < dof.size(); ++b)
      for (std::size_t a = b; a < dof.size(); ++a) {
        i.push_back(dof[a]);
        j.push_back(dof[b]);
      }
  }
  fixed_place = matrix.pattern.make(fixed->n, i, j);
  clique_place.assign(fixed_place.begin() + static_cast<std::ptrdiff_t>(fixed->size()), fixed_place.end());
  fixed_place.resize(fixed->size());
}

void Cholesky::Impl::assemble(std::span<const double> values, const DofRows& rows, std::span<const double> scale) {
  std::vector<double>& value = matrix.value;
  value.assign(matrix.pattern.size(), 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) value[static_cast<std::size_t>(fixed_place[k])] = values[k];
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (scale[r] == 0.0) continue;
    const std::span<const double> h = rows[r].h;
    auto at = static_cast<std::size_t>(clique_first[static_cast<std::size_t>(clique[r])]);
    for (std::size_t b = 0; b < h.size(); ++b) {
      const double scaled = scale[r] * h[b];
      for (std::size_t a = b; a < h.size(); ++a, ++at)
        value[static_cast<std::size_t>(clique_place[at])] += scaled * h[a];
    }
  }
}

bool Cholesky::Impl::factorise(bool analysed) {
  const OneThread alone;
  SymmetricPattern& pattern = matrix.pattern;
  if (pattern.n == 0) return definite = true;  // CHOLMOD rejects an empty matrix: every block is held, or explicit
  cholmod_sparse A{};
  A.nrow = A.ncol = static_cast<std::size_t>(pattern.n);
  A.nzmax = matrix.value.size();
  A.p = pattern.column_start.data();
  A.i = pattern.row.data();
  A.x = matrix.value.data();
  A.stype = -1;
  A.itype = CHOLMOD_INT;
  A.xtype = CHOLMOD_REAL;
  A.dtype = CHOLMOD_DOUBLE;
  A.sorted = 1;
  A.packed = 1;
  if (!analysed) {
    cholmod_free_factor(&factor, &common);
    factor = cholmod_analyze(&A, &common);
    if (factor == nullptr) throw std::runtime_error("CHOLMOD: analysis failed");
    ++analyses;
  }
  cholmod_free_factor(&updated, &common);
  cholmod_factorize(&A, factor, &common);
  ++factorisations;
  // Small systems are factorised as L D L', which does not stop at a negative number of D.
  definite = common.status == CHOLMOD_OK && factor->minor == static_cast<std::size_t>(pattern.n) &&
             (factor->is_ll != 0 || factor->is_super != 0 || positive(*factor));
  return definite;
}

Cholesky::Cholesky() : impl_(std::make_unique<Impl>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::set_pattern(const SymmetricPattern& pattern) {
  impl_->fixed = &pattern;
  impl_->placed = impl_->definite = false;
  cholmod_free_factor(&impl_->updated, &impl_->common);
  cholmod_free_factor(&impl_->factor, &impl_->common);
}

bool Cholesky::factorise(std::span<const double> values, const DofRows& rows, std::span<const double> scale) {
  Impl& s = *impl_;
  const bool same_rows =
      std::ranges::equal(rows.start(), s.placed_start) && std::ranges::equal(rows.dof(), s.placed_dof);
  if (!same_rows) s.find_cliques(rows);
  bool analysed = s.factor != nullptr && (s.placed || s.find_fixed_places());
  analysed = analysed && ((same_rows && s.placed) || s.find_places(rows));
  if (!analysed) s.make_pattern(rows);
  s.placed = true;
  s.assemble(values, rows, scale);
  return s.factorise(analysed);
}

bool Cholesky::factorise(const SymmetricMatrix& matrix) {
  Impl& s = *impl_;
  s.matrix = matrix;
  s.placed = false;
  return s.factorise(false);
}

const SymmetricMatrix& Cholesky::matrix() const { return impl_->matrix; }
bool Cholesky::factored() const { return impl_->definite; }
void Cholesky::drop_updates() { cholmod_free_factor(&impl_->updated, &impl_->common); }

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

double Cholesky::Impl::work(double visited) const {
  // Cost of an operation of an update over one of a factorisation: dense blocks are quicker, single columns as slow.
  const double slower = factor->is_super != 0 ? kDenseBlocks : 1.0;
  return slower * 4.0 * visited / std::max(common.fl, 1.0);
}

bool Cholesky::update_pays(const DofRows& rows, std::span<const Change> changes) {
  // Few changes pay even if each visits all columns, and need not be followed.
  const double most = impl_->work(static_cast<double>(changes.size()) * impl_->common.lnz);
  return most <= 1.0 || relative_work(rows, changes) <= 1.0;
}

double Cholesky::relative_work(const DofRows& rows, std::span<const Change> changes) {
  Impl& s = *impl_;
  const cholmod_factor* L = s.to_update();
  const auto *start = static_cast<const std::int32_t*>(L->p), *row = static_cast<const std::int32_t*>(L->i),
             *size = static_cast<const std::int32_t*>(L->nz);
  double visited = 0.0;
  for (const Change& c : changes) {
    auto k = static_cast<std::int32_t>(L->n);
    for (const std::int32_t d : rows[c.row].dof) k = std::min(k, s.inverse_permutation[static_cast<std::size_t>(d)]);
    // An update changes the columns from its first place to the root of the elimination tree.
    while (k < static_cast<std::int32_t>(L->n)) {
      visited += size[k];
      k = size[k] > 1 ? row[start[k] + 1] : static_cast<std::int32_t>(L->n);
    }
  }
  return s.work(visited);
}

bool Cholesky::update(const DofRows& rows, std::span<const Change> changes) {
  Impl& s = *impl_;
  cholmod_factor* L = s.to_update();
  std::vector<std::pair<std::int32_t, double>> entries;
  for (const bool up : {true, false}) {
    std::vector<std::int32_t> start{0}, row;
    std::vector<double> value;
    for (const Change& c : changes) {
      if (c.delta == 0.0 || (c.delta > 0.0) != up) continue;
      entries.clear();
      const DofRow of = rows[c.row];
      for (std::size_t j = 0; j < of.dof.size(); ++j)
        entries.emplace_back(s.inverse_permutation[static_cast<std::size_t>(of.dof[j])],
                             std::sqrt(std::abs(c.delta)) * of.h[j]);
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
  if (b.empty()) return;
  Impl& s = *impl_;
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = rhs.nzmax = b.size();
  rhs.ncol = 1;
  rhs.x = const_cast<double*>(b.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast): CHOLMOD only reads it
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, s.updated != nullptr ? s.updated : s.factor, &rhs, nullptr, &s.solution, nullptr,
                     &s.work_y, &s.work_e, &s.common) == 0)
    throw std::runtime_error("CHOLMOD: solve failed");
  const auto* found = static_cast<const double*>(s.solution->x);
  std::copy(found, found + b.size(), x.begin());
}

std::int64_t Cholesky::factorisations() const { return impl_->factorisations; }
std::int64_t Cholesky::analyses() const { return impl_->analyses; }
double Cholesky::factor_size() const { return impl_->common.lnz; }

}  // namespace scree::coupling
