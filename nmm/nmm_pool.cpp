#include "nmm/nmm_pool.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

#include "model/local_origin.h"
#include "model/mesh_error.h"
#include "model/planar.h"

namespace scree::nmm {
namespace {

/// Least certified step, as a fraction of the uncut mesh's 0.866 h/c_p, for which a block keeps its mesh: blocks
/// narrower than 1.5 covers can have a smaller one, and a onefold cover is then better
/// (docs/theory/kinematics-and-nmm.md, "Ties").
constexpr double kLeastStep = 0.25;

bool keeps_its_step(const CoverMesh& mesh, const ReferenceShape& shape, const Formulation& form,
                    const Elasticity& law) {
  LumpedMass mass;
  if (!mass.add(mesh, 0, shape, form.mass)) return false;
  CoverChart chart;
  chart.add(mesh, 0);
  chart.finish();
  const FrequencyBound bound = frequency_bound_of(mesh, chart, 0, mass.lumped(), 1.0, law);
  const double density = shape.mass / shape.area,
               uncut = std::sqrt(3.0) / 2.0 * form.cover_size / std::sqrt(law.p_modulus() / density),
               step = 2.0 / std::sqrt(mass.theta(0, static_cast<std::int32_t>(mesh.star.size())) * bound.lambda);
  return step >= kLeastStep * uncut;
}

}  // namespace

bool NmmPool::lumps(const Formulation& form) {
  return form.mass != MassKind::consistent ||
         (form.division.divides() && form.division.acts != Division::Acts::implicit_half);
}

bool NmmPool::has_consistent(const Formulation& form) {
  return form.mass == MassKind::consistent &&
         !(form.division.divides() && form.division.acts == Division::Acts::explicit_half);
}

CoverMesh NmmPool::make_mesh(const Model& model, const BodyRecord& record, const AffineMotion& to_origin) {
  const Formulation& form = record.form;
  std::vector<CutLine> cracks;
  if (form.cracks) {
    const Mat2 back = to_origin.F.inverse();
    for (const Crack& c : model.cracks)
      if (c.block == record.block) cracks.push_back({back * (c.from - to_origin.c), back * (c.to - to_origin.c)});
  }
  std::function<bool(const Vec2&)> explicit_at;
  const Polygon region{form.division.region, {}};
  if (form.division.divides())
    explicit_at = [&](const Vec2& X) { return contains(region, to_origin.c + to_origin.F * X); };
  CoverMesh mesh =
      make_cover_mesh(record.shape.outline, form.cover_size, {form.offset_x, form.offset_y}, cracks, explicit_at);
  if (!mesh.onefold && cracks.empty() && !keeps_its_step(mesh, record.shape, form, model.elasticity_of(record.block)))
    mesh = make_onefold(record.shape.outline);
  return mesh;
}

void NmmPool::find_whole_inverse(Body& body) {
  const CoverMesh& mesh = *body.whole;
  body.whole_chart.add(mesh, 0);
  body.whole_chart.finish();
  body.whole_inverse = row_sums(mesh, body.shape.mass / mesh.drawn_area());
  for (std::size_t k = 0; k < mesh.star.size(); ++k) {
    double& mass = body.whole_inverse[k];
    if (body.whole_chart.tied(static_cast<std::int32_t>(k))) continue;
    if (!(mass > 0.0))
      throw MeshError(fmt::format(
          "block '{}' cannot be divided by the explicit region: a cover of one half has no lumped mass; move the "
          "region's border, or choose another cover_size",
          body.name));
    mass = 1.0 / mass;
  }
}

void NmmPool::divide(Body& body) {
  CoverMesh& mesh = body.mesh;
  const auto refuse = [&](const char* why) {
    throw MeshError(fmt::format("block '{}' cannot be divided by the explicit region: {}", body.name, why));
  };
  if (mesh.onefold) refuse("it is so narrow that one cover carries it; choose a smaller cover_size");
  if (mesh.interface_constraints.empty())
    refuse("no two neighbouring elements have their centroids one in it and one outside");
  if (mesh.shapes.size() > 2)
    refuse(
        "a part of one half has no element of half a triangle; move the region's border, or choose a smaller "
        "cover_size");
  body.whole = std::make_unique<CoverMesh>(mesh);
  find_whole_inverse(body);
  const Division::Acts acts = body.form.division.acts;
  if (acts != Division::Acts::both) mesh = half_of(*body.whole, acts == Division::Acts::explicit_half);
  // Only the implicit half has a consistent mass; explicit steps use a lumped one.
  body.lumped = std::make_unique<CoverMesh>(body.form.mass == MassKind::consistent ? half_of(mesh, true) : mesh);
}

std::optional<CoverMesh> NmmPool::mesh_for(const BodyRecord& record, int body) const {
  const Body& b = of(body);
  if (b.form.onefold || !b.form.same_mesh(record.form) || b.form.mass != record.form.mass ||
      b.shape.mass != record.shape.mass || b.shape.area != record.shape.area ||
      !(b.shape.outline == record.shape.outline && b.shape.origin == record.shape.origin))
    return std::nullopt;
  if (b.whole) return *b.whole;
  CoverMesh mesh = b.mesh;
  for (Row& row : mesh.boundary.nodes)
    for (std::int32_t& n : row.node) n -= first_node(body);
  for (Boundary::Segment& s : mesh.boundary.segments) s.cell -= b.first_element;
  return mesh;
}

void NmmPool::add_again(const Model& model, const BodyRecord& record, const BodySet& earlier, int body) {
  const auto* pool = dynamic_cast<const NmmPool*>(&earlier);
  add_with(model, record, pool != nullptr ? pool->mesh_for(record, body) : std::nullopt);
}

void NmmPool::add_with(const Model& model, const BodyRecord& record, std::optional<CoverMesh> made) {
  auto body = std::make_unique<Body>();
  body->shape = record.shape;
  body->name = model.blocks[record.block.index()].name;
  model_origin_ = model.origin;
  const Formulation& form = record.form;
  const AffineMotion to_origin = affine_fit(record.shape.outline, record.shape.origin);
  const std::int32_t first = first_.back();
  body->law = model.elasticity_of(record.block);
  body->form = form;
  if (!form.onefold)
    body->mesh = made ? *std::move(made) : make_mesh(model, record, to_origin);
  else
    body->mesh = form.model_triangle ? make_onefold(record.shape.outline, model_triangle(model, to_origin))
                                     : make_onefold(record.shape.outline);
  if (!body->mesh.onefold) body->holds = edge_holds(model, record, body->mesh, to_origin, body->law);
  if (form.division.divides()) {
    if (!body->holds.empty())
      throw MeshError(
          fmt::format("block '{}' cannot be divided by the explicit region: a support holds a line of its outline; "
                      "move the region, "
                      "or hold a whole block",
                      body->name));
    divide(*body);
  }
  const CoverMesh& mesh = body->mesh;
  const MassKind lumped = body->lumped && form.mass == MassKind::consistent ? MassKind::affine_exact : form.mass;
  if (!mass_.add(body->lumped ? *body->lumped : mesh, first, record.shape, lumped))
    throw MeshError(fmt::format(
        "block '{}': its cracks leave a part on which no lumped mass is positive; choose another cover size",
        body->name));
  if (form.mass != MassKind::affine_exact && !mesh.onefold) make_implicit(*body, first);
  chart_.add(mesh, first);
  body->first_element = static_cast<std::int32_t>(elements_.size());
  // The rock keeps its area, mass over density, also if an outline fitted to a deformed body encloses slightly less.
  body->scale = record.shape.area / mesh.drawn_area();
  std::vector<std::array<double, 3>> initial;
  // The stress is constant in an element, with its value at the centroid: the mean of a linear stress, so that its
  // force is exact.
  if (const InSituStress in_situ(model, record); !in_situ.none())
    for (std::size_t e = 0; e < mesh.elements(); ++e) {
      const Mat2 s = in_situ.at(mesh.centroid(e));
      initial.push_back({s(0, 0), s(1, 1), s(0, 1)});
    }
  if (mesh.onefold) {
    const std::array<double, 3> s = initial.empty() ? std::array{0.0, 0.0, 0.0} : initial[0];
    body->onefold.emplace(mesh.stars(0), record.shape, body->law, form.kinematics,
                          (Mat2() << s[0], s[2], s[2], s[1]).finished(), first);
  }
  elements_.add(mesh, first, body->scale, {body->law, form.kinematics}, std::move(initial));
  for (Row& row : body->mesh.boundary.nodes)
    for (std::int32_t& n : row.node) n += first;
  for (Boundary::Segment& s : body->mesh.boundary.segments) s.cell += body->first_element;
  idle_.resize(static_cast<std::size_t>(first) + mesh.star.size(), 0);
  for (InterfaceConstraint& s : body->mesh.interface_constraints) {
    s.explicit_node += first;
    s.implicit_node += first;
  }
  if (form.division.divides() && form.division.acts != Division::Acts::both)
    for (std::size_t c = 0; c < mesh.star.size(); ++c)
      if ((mesh.explicit_part[static_cast<std::size_t>(mesh.component[c])] != 0) !=
          (form.division.acts == Division::Acts::explicit_half))
        idle_[static_cast<std::size_t>(first) + c] = 1;
  first_.push_back(first + static_cast<std::int32_t>(mesh.star.size()));
  bodies_.push_back(std::move(body));
}

std::array<Vec2, 3> NmmPool::model_triangle(const Model& model, const AffineMotion& to_origin) {
  if (!model_triangle_) {
    std::vector<Vec2> ends;
    for (const Block& b : model.blocks) {
      const Box box = bounds(b.polygon);
      ends.insert(ends.end(), {box.lo, box.hi});
    }
    model_triangle_ = onefold_triangle(ends);
  }
  const Mat2 back = to_origin.F.inverse();
  std::array<Vec2, 3> star;
  for (std::size_t k = 0; k < 3; ++k) star[k] = back * ((*model_triangle_)[k] - to_origin.c);
  return star;
}

void NmmPool::make_implicit(Body& body, std::int32_t first) {
  const Division& division = body.form.division;
  if (division.acts == Division::Acts::explicit_half) return;
  const bool halved = division.divides() && division.acts == Division::Acts::both;
  const CoverMesh half = halved ? half_of(*body.whole, false) : CoverMesh();
  const CoverMesh& mesh = halved ? half : body.mesh;
  std::vector<MassElement> elements;
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const Moments material = moments(mesh.material(e));
    elements.push_back({mesh.cover[e], mesh.weights(e, material.centroid), mesh.shapes[mesh.shape[e]], material});
  }
  FoldedElements folded;
  folded.make(mesh);
  // The moments stored with a body are those of the whole block; a half uses those of its elements.
  body.consistent.make(folded, elements, mesh.star, body.shape.mass / mesh.drawn_area(),
                       division.divides() ? nullptr : &body.shape.second, first);
  std::vector<Mat3> masses;
  for (std::size_t e = 0; e < elements.size(); ++e) masses.push_back(body.consistent.element(e));
  std::vector<std::size_t> held;
  for (const EdgeHold& h : body.holds) held.push_back(h.element);
  body.implicit.make(std::move(folded), std::move(masses), body.form.mass == MassKind::lumped, first, std::move(held));
}

void NmmPool::finish() {
  chart_.finish();
  mass_.finish(chart_);
  elements_.finish(first_.back());
  for (int b = 0; b < bodies(); ++b) {
    Body& body = *bodies_[static_cast<std::size_t>(b)];
    body.frequency = body.onefold ? FrequencyBound{affine_frequency(body.shape, body.law), 0}
                                  : frequency_bound_of(body.lumped ? *body.lumped : body.mesh, chart_, first_node(b),
                                                       mass_.lumped(), body.scale, body.law);
    if (!body.holds.empty())
      body.frequency.lambda += hold_frequency(body.holds, body.mesh, chart_, first_node(b), mass_.lumped(), body.law);
  }
  ones_.assign(static_cast<std::size_t>(first_.back()), 1.0);
}

Row NmmPool::row_at(int body, const Vec2& X) const {
  const Body& b = of(body);
  const CoverMesh& mesh = b.whole ? *b.whole : b.mesh;
  Row row = mesh.row(mesh.locate(X), X);
  for (std::int32_t& n : row.node) n += first_node(body);
  return row;
}

std::span<const double> NmmPool::translation(int body) const {
  const auto first = static_cast<std::size_t>(first_node(body)), last = static_cast<std::size_t>(first_node(body + 1));
  return std::span(ones_).subspan(first, last - first);
}

StiffElement NmmPool::element_of(const Body& body, std::size_t e) const {
  const std::size_t i = static_cast<std::size_t>(body.first_element) + e;
  return {elements_.gradients(i), elements_.area(i), body.law, body.form.kinematics, elements_.initial_stress(i)};
}

std::array<Vec2, 3> NmmPool::covers_of(const Body& body, std::size_t e, std::span<const double> q) const {
  const auto& cover = elements_.cover(static_cast<std::size_t>(body.first_element) + e);
  return {node(q, cover[0]), node(q, cover[1]), node(q, cover[2])};
}

std::string NmmPool::place_of(int body, std::size_t element) const {
  const AffineMotion origin = affine_fit(of(body).shape.outline, of(body).shape.origin);
  const Vec2 x = origin.c + origin.F * of(body).mesh.centroid(element);
  return fmt::format("element {} near {}", element, place_text(x, model_origin_));
}

std::string NmmPool::binding(int body) const {
  return place_of(body, static_cast<std::size_t>(of(body).frequency.element));
}

}  // namespace scree::nmm
