#include "io/results/provenance.h"

#include <cairo.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <limits>

#include "coupling/sink.h"
#include "io/results/h5_series.h"
#include "io/results/sha256.h"

namespace scree::io {

std::string case_hash(const Provenance& provenance) {
  return provenance.case_sha256.empty() ? sha256(provenance.case_text) : provenance.case_sha256;
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

std::string instruction_set() {
  std::string set = "x86-64";
#if !defined(__x86_64__)
  set = "other than x86-64";
#endif
#if defined(__AVX2__)
  set += " avx2";
#endif
#if defined(__FMA__)
  set += " fma";
#endif
#if defined(__AVX512F__)
  set += " avx512f";
#endif
  return set;
}

std::vector<std::pair<std::string, std::string>> known_libraries() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {{"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"hdf5", fmt::format("{}.{}.{}", major, minor, release)},
          {"cairo", cairo_version_string()},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)}};
}

void write_provenance(const h5::File& file, const Provenance& provenance) {
  const std::string group = "/provenance";
  file.group(group);
  file.attribute(group, "version", provenance.version);
  file.attribute(group, "commit", provenance.commit);
  file.attribute(group, "case_sha256", case_hash(provenance));
  file.attribute(group, "command_line", provenance.command_line);
  file.attribute(group, "compiler", compiler());
  file.attribute(group, "instruction_set", instruction_set());
  file.attribute(group, "threads", std::int64_t{provenance.threads});
  const std::vector<std::string> text{provenance.case_text};
  h5::write(file, group + "/case", text, {"none", "the case file as the user wrote it"});
  if (!provenance.overrides.empty())
    h5::write(file, group + "/set", provenance.overrides, {"none", "keys of the case that the command line changed"});
  std::vector<std::string> names, versions;
  for (const auto& list : {known_libraries(), provenance.libraries})
    for (const auto& [name, version] : list) names.push_back(name), versions.push_back(version);
  h5::write(file, group + "/library", names, {"none", "libraries"});
  h5::write(file, group + "/library_version", versions, {"none", "their versions"});
}

/// Rock strength of every material; a row of NaN for a material without one.
void write_rock_strengths(const h5::File& file, const std::vector<Material>& materials) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> mohr, hoek;
  bool any = false;
  for (const Material& m : materials) {
    const auto* c = m.rock_strength ? std::get_if<MohrCoulombStrength>(&*m.rock_strength) : nullptr;
    const auto* h = m.rock_strength ? std::get_if<HoekBrownStrength>(&*m.rock_strength) : nullptr;
    any = any || m.rock_strength;
    for (const double x : {c ? c->cohesion : kNone, c ? c->friction : kNone, c ? c->tension : kNone}) mohr.push_back(x);
    for (const double x : {h ? h->ucs : kNone, h ? h->mb : kNone, h ? h->s : kNone, h ? h->a : kNone})
      hoek.push_back(x);
  }
  if (!any) return;
  h5::write<double>(file, "/materials/mohr_coulomb", 3, mohr,
                    {"Pa, rad, Pa", "rock strength: cohesion, friction angle, tension"});
  h5::write<double>(file, "/materials/hoek_brown", 4, hoek, {"Pa, 1, 1, 1", "rock strength: ucs, m_b, s, a"});
}

void write_model(const h5::File& file, const Model& model) {
  file.attribute("/", "title", model.title);
  file.attribute("/", "origin", std::array{model.origin.x(), model.origin.y()});
  std::vector<std::string> names;
  std::vector<std::int32_t> material, held, ring_block;
  std::vector<std::int64_t> ring_offset{0};
  std::vector<double> point;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const Block& block = model.blocks[b];
    names.push_back(block.name);
    material.push_back(block.material.value);
    held.push_back(model.support_of(BlockId(static_cast<std::int32_t>(b))) != nullptr ? 1 : 0);
    for (std::size_t r = 0; r < block.polygon.rings(); ++r) {
      for (const Vec2& p : block.polygon.ring(r)) point.insert(point.end(), {p.x(), p.y()});
      ring_block.push_back(static_cast<std::int32_t>(b));
      ring_offset.push_back(static_cast<std::int64_t>(point.size() / 2));
    }
  }
  h5::write(file, "/blocks/name", names, {"none", "names of the blocks"});
  h5::write<std::int32_t>(file, "/blocks/material", 1, material, {"1", "material, counted from 0 in /materials"});
  h5::write<std::int32_t>(file, "/blocks/held", 1, held, {"1", "1 where the block is held whole: fixed or driven"});
  h5::write<std::int32_t>(file, "/blocks/ring_block", 1, ring_block, {"1", "block of each ring, the outer ring first"});
  h5::write<std::int64_t>(file, "/blocks/ring_offset", 1, ring_offset, {"1", "first point of each ring, and the end"});
  h5::write<double>(file, "/blocks/point", 2, point, {"m", "vertices x, y in the model"});

  std::vector<std::string> material_names;
  std::vector<double> density, young, poisson;
  for (const Material& m : model.materials) {
    material_names.push_back(m.name);
    density.push_back(m.density), young.push_back(m.young), poisson.push_back(m.poisson);
  }
  h5::write(file, "/materials/name", material_names, {"none", "names of the materials"});
  h5::write<double>(file, "/materials/density", 1, density, {"kg/m3", "density"});
  h5::write<double>(file, "/materials/young", 1, young, {"Pa", "Young's modulus"});
  h5::write<double>(file, "/materials/poisson", 1, poisson, {"1", "Poisson's ratio"});
  write_rock_strengths(file, model.materials);
}

void write_stages(const h5::File& file, const coupling::Plan& plan) {
  std::vector<std::string> names, integrators;
  std::vector<double> duration;
  for (const coupling::Stage& stage : plan.stages) {
    names.push_back(stage.name);
    integrators.emplace_back(coupling::name(stage.integrator));
    duration.push_back(seconds(stage.duration));
  }
  h5::write(file, "/stages/name", names, {"none", "names of the stages"});
  h5::write(file, "/stages/integrator", integrators, {"none", "their time schemes"});
  h5::write<double>(file, "/stages/duration", 1, duration, {"s", "their durations"});
}

}  // namespace scree::io
