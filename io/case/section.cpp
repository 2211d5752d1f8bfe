#include "io/case/section.h"

#include <limits>

#include "model/check.h"

namespace scree::io {
namespace {

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + '.' + std::string(key);
}

double number_of(const Value& value) {
  SCREE_ASSERT(value.as<double>());
  return *value.as<double>();
}
Vec2 point_of(const Value& value) {
  const Array& items = *value.as<Array>();
  return {number_of(items[0]), number_of(items[1])};
}
Ring ring_of(const Value& value) {
  Ring ring;
  for (const Value& item : *value.as<Array>()) ring.push_back(point_of(item));
  return ring;
}

}  // namespace

Value& Section::at(std::string_view key) const {
  Value* value = table_->find(key);
  SCREE_ASSERT(value);
  return *value;
}

bool Section::boolean(std::string_view key) const { return *at(key).as<bool>(); }
int Section::integer(std::string_view key) const { return static_cast<int>(*at(key).as<std::int64_t>()); }
double Section::number(std::string_view key) const { return number_of(at(key)); }
std::optional<double> Section::number_or_auto(std::string_view key) const {
  if (at(key).as<std::string>()) return std::nullopt;
  return number(key);
}
double Section::number_or_unlimited(std::string_view key) const {
  return at(key).as<std::string>() ? std::numeric_limits<double>::infinity() : number(key);
}
bool Section::is_text(std::string_view key) const { return at(key).as<std::string>() != nullptr; }
const std::string& Section::text(std::string_view key) const { return *at(key).as<std::string>(); }
std::vector<std::string> Section::texts(std::string_view key) const {
  std::vector<std::string> out;
  for (const Value& item : *at(key).as<Array>()) out.push_back(*item.as<std::string>());
  return out;
}
Vec2 Section::point(std::string_view key) const { return point_of(at(key)); }
Ring Section::ring(std::string_view key) const { return ring_of(at(key)); }
std::vector<Ring> Section::rings(std::string_view key) const {
  std::vector<Ring> out;
  for (const Value& item : *at(key).as<Array>()) out.push_back(ring_of(item));
  return out;
}

Section Section::table(std::string_view key) const { return {file_, at(key), joined(path_, key)}; }

std::vector<Section> Section::list(std::string_view key) const {
  std::vector<Section> out;
  if (!has(key)) return out;
  Array& items = *at(key).as<Array>();
  for (std::size_t i = 0; i < items.size(); ++i)
    out.emplace_back(file_, items[i], joined(path_, key) + '.' + std::to_string(i));
  return out;
}

std::vector<Section::Named> Section::named(std::string_view key) const {
  std::vector<Named> out;
  if (!has(key)) return out;
  for (Member& m : *at(key).as<Table>())
    out.push_back({m.key, Section(file_, m.value, joined(joined(path_, key), m.key))});
  return out;
}

void Section::settle_value(std::string_view key, Value value) const {
  table_->as<Table>()->push_back({std::string(key), table_->place, std::move(value)});
}
void Section::settle(std::string_view key, double number) const { settle_value(key, {table_->place, number}); }
void Section::settle(std::string_view key, std::int64_t whole) const { settle_value(key, {table_->place, whole}); }
void Section::settle(std::string_view key, const std::string& text) const { settle_value(key, {table_->place, text}); }

CaseError Section::error(std::string_view key, std::string problem, std::string allowed, std::string hint) const {
  const Value* value = table_->find(key);
  return {file_,
          value ? value->place : table_->place,
          {std::move(problem), joined(path_, key), value ? shown(*value) : "", std::move(allowed), std::move(hint)}};
}
CaseError Section::error(std::string_view key, std::size_t item, std::string problem, std::string allowed,
                         std::string hint) const {
  const Value& value = (*at(key).as<Array>())[item];
  return {file_,
          value.place,
          {std::move(problem), joined(path_, key) + '.' + std::to_string(item), shown(value), std::move(allowed),
           std::move(hint)}};
}

}  // namespace scree::io
