#include "app/verify/expected.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "app/verify/measures.h"
#include "io/case/document.h"
#include "io/case/guard.h"
#include "io/case/suggest.h"
#include "io/case/text_file.h"

namespace scree::app {
namespace {

constexpr std::size_t kMostExpectedBytes = 1 << 20;
const std::vector<std::string> kTop{"title", "study", "minutes", "cores", "variant", "quantity"};
const std::vector<std::string> kVariantKeys{"name", "case", "set", "tier", "repeats", "needs"};
const std::vector<std::string> kQuantityKeys{"name",      "reason",    "measure",  "variant",  "over",
                                             "variants",  "sizes",     "exact",    "at_least", "at_most",
                                             "reference", "tolerance", "absolute", "tier"};

/// A table of the file whose keys are read one by one, each with the kind of its value.
class Reader {
 public:
  Reader(const std::string& file, const io::Value& table, std::string what)
      : file_(&file), table_(&table), what_(std::move(what)) {}

  [[nodiscard]] io::CaseError error(const io::Value& at, std::string problem, std::string allowed,
                                    std::string hint = {}) const {
    return {*file_, at.place, {.problem = std::move(problem), .allowed = std::move(allowed), .hint = std::move(hint)}};
  }
  void allow(std::vector<std::string> known) const {
    for (const io::Member& m : *table_->as<io::Table>())
      if (std::find(known.begin(), known.end(), m.key) == known.end())
        throw io::CaseError(*file_, m.place,
                            {.problem = fmt::format("unknown key {} in {}", io::in_quotes(m.key), what_),
                             .key = m.key,
                             .value = io::shown(m.value),
                             .allowed = io::listed(known),
                             .hint = io::did_you_mean(m.key, known, "remove it")});
  }
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const {
    const io::Value* v = table_->find(key);
    if (v == nullptr) return std::nullopt;
    if (const std::string* text = v->as<std::string>(); text != nullptr && !text->empty()) return *text;
    throw wrong(*v, key, "a text");
  }
  [[nodiscard]] std::string needed_text(const std::string& key) const {
    if (auto found = text(key)) return *found;
    throw missing(key, "a text");
  }
  [[nodiscard]] std::optional<double> number(const std::string& key) const {
    const io::Value* v = table_->find(key);
    if (v == nullptr) return std::nullopt;
    return number_of(*v, key);
  }
  /// A whole number from 1 to 100; 1 where there is none.
  [[nodiscard]] int count(const std::string& key) const {
    const double n = number(key).value_or(1.0);
    if (n < 1.0 || n > 100.0 || n != std::floor(n))
      throw wrong(*table_->find(key), key, "a whole number from 1 to 100");
    return static_cast<int>(n);
  }
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const {
    std::vector<std::string> out;
    each(key, "a list of texts", [&](const io::Value& v) {
      const std::string* text = v.as<std::string>();
      if (text == nullptr) throw wrong(v, key, "a list of texts");
      out.push_back(*text);
    });
    return out;
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const {
    std::vector<double> out;
    each(key, "a list of numbers", [&](const io::Value& v) { out.push_back(number_of(v, key)); });
    return out;
  }
  [[nodiscard]] Tier tier() const {
    const std::string tier = text("tier").value_or("quick");
    if (tier == "quick") return Tier::quick;
    if (tier == "full") return Tier::full;
    if (tier == "exhaustive") return Tier::exhaustive;
    throw wrong(*table_->find("tier"), "tier", "\"quick\", \"full\" or \"exhaustive\"");
  }
  [[nodiscard]] io::CaseError missing(const std::string& key, std::string allowed) const {
    return error(*table_, fmt::format("{} has no {}", what_, io::in_quotes(key)), std::move(allowed), "add " + key);
  }
  [[nodiscard]] io::CaseError wrong(const io::Value& v, const std::string& key, std::string allowed) const {
    return {*file_,
            v.place,
            {.problem = fmt::format("{} of {} is something else", io::in_quotes(key), what_),
             .key = key,
             .value = io::shown(v),
             .allowed = std::move(allowed)}};
  }
  [[nodiscard]] const io::Value& table() const { return *table_; }

 private:
  [[nodiscard]] double number_of(const io::Value& v, const std::string& key) const {
    if (const double* number = v.as<double>(); number != nullptr && std::isfinite(*number)) return *number;
    if (const std::int64_t* whole = v.as<std::int64_t>()) return static_cast<double>(*whole);
    throw wrong(v, key, "a finite number");
  }
  template <class Take>
  void each(const std::string& key, const char* allowed, Take&& take) const {
    const io::Value* v = table_->find(key);
    if (v == nullptr) return;
    const io::Array* list = v->as<io::Array>();
    if (list == nullptr || list->empty()) throw wrong(*v, key, allowed);
    for (const io::Value& item : *list) take(item);
  }

  const std::string* file_;
  const io::Value* table_;
  std::string what_;
};

std::vector<Reader> tables(const Reader& top, const std::string& file, const std::string& key) {
  std::vector<Reader> out;
  const io::Value* v = top.table().find(key);
  if (v == nullptr) return out;
  const io::Array* list = v->as<io::Array>();
  if (list == nullptr) throw top.wrong(*v, key, fmt::format("[[{}]]", key));
  for (const io::Value& item : *list) {
    if (item.as<io::Table>() == nullptr) throw top.wrong(item, key, fmt::format("[[{}]]", key));
    out.emplace_back(file, item, fmt::format("[[{}]]", key));
  }
  return out;
}

Variant read_variant(const Reader& r, const std::vector<Variant>& before) {
  r.allow(kVariantKeys);
  Variant v;
  v.name = r.needed_text("name");
  if (std::any_of(before.begin(), before.end(), [&](const Variant& other) { return other.name == v.name; }))
    throw r.error(*r.table().find("name"), fmt::format("there are two variants {}", io::in_quotes(v.name)),
                  "each name once");
  v.case_file = r.text("case").value_or(v.case_file);
  v.set = r.texts("set");
  v.tier = r.tier();
  v.needs = r.text("needs").value_or("");
  v.repeats = r.count("repeats");
  return v;
}

/// Takes the keys that belong to the measure.
void read_measure(const Reader& r, Quantity& q) {
  q.measure = r.needed_text("measure");
  std::vector<std::string> names, allowed = kQuantityKeys;
  for (const MeasureInfo& m : measures()) names.emplace_back(m.name);
  const auto found = std::find(names.begin(), names.end(), q.measure);
  if (found == names.end())
    throw r.error(*r.table().find("measure"), fmt::format("unknown measure {}", io::in_quotes(q.measure)),
                  io::listed(names), io::did_you_mean(q.measure, names, ""));
  const MeasureInfo& info = measures()[static_cast<std::size_t>(found - names.begin())];
  for (const MeasureKey& key : info.keys) allowed.emplace_back(key.name);
  r.allow(allowed);
  for (const MeasureKey& key : info.keys) {
    if (key.kind == MeasureKey::Kind::number) {
      if (const auto number = r.number(key.name)) q.numbers[key.name] = *number;
    } else if (const auto text = r.text(key.name)) {
      q.texts[key.name] = *text;
    } else if (!key.needed) {
      q.texts[key.name] = key.standard;
    }
    if (key.needed && q.texts.count(key.name) + q.numbers.count(key.name) == 0)
      throw r.missing(key.name, key.kind == MeasureKey::Kind::number ? "a number" : "a text");
  }
}

void read_bounds(const Reader& r, Quantity& q) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const auto least = r.number("at_least"), most = r.number("at_most");
  const auto relative = r.number("tolerance"), absolute = r.number("absolute");
  q.reference = r.number("reference");
  q.low = least.value_or(-kInf);
  q.high = most.value_or(kInf);
  if (q.reference) {
    if (relative.has_value() == absolute.has_value())
      throw r.missing("tolerance", "tolerance (relative) or absolute, one of the two, beside reference");
    if (least || most)
      throw r.error(r.table(), fmt::format("quantity {} has two kinds of bounds", io::in_quotes(q.name)),
                    "at_least and at_most, or reference with tolerance or absolute");
    q.tolerance = absolute ? *absolute : *relative * std::abs(*q.reference);
    if (!(*q.tolerance >= 0.0))
      throw r.wrong(*r.table().find(absolute ? "absolute" : "tolerance"), "tolerance", ">= 0");
    q.low = *q.reference - *q.tolerance;
    q.high = *q.reference + *q.tolerance;
  } else if (relative || absolute) {
    throw r.missing("reference", "a number that the tolerance is about");
  } else if (!least && !most) {
    throw r.error(r.table(), fmt::format("quantity {} has no bound", io::in_quotes(q.name)),
                  "at_least, at_most, or reference with tolerance or absolute");
  }
}

void read_variants(const Reader& r, const std::vector<Variant>& known, Quantity& q) {
  q.variants = r.texts("variants");
  q.sizes = r.numbers("sizes");
  q.exact = r.number("exact").value_or(0.0);
  if (q.variants.empty() != q.sizes.empty() || (!q.sizes.empty() && q.sizes.size() < 2) ||
      q.variants.size() != q.sizes.size())
    throw r.error(r.table(), "variants and sizes of an order are not as many", "at least two of each, or neither");
  if (q.sizes.empty() && r.number("exact")) throw r.missing("sizes", "variants and sizes beside exact");
  if (std::any_of(q.sizes.begin(), q.sizes.end(), [](double s) { return !(s > 0.0); }))
    throw r.wrong(*r.table().find("sizes"), "sizes", "numbers > 0");
  if (q.is_order() && (r.text("variant") || r.text("over")))
    throw r.error(r.table(), "an order has neither variant nor over", "variants and sizes");
  if (q.variants.empty()) q.variants.push_back(r.text("variant").value_or(known.front().name));
  q.over = r.text("over").value_or("");
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const Variant& v : known) names.push_back(v.name);
  for (const std::string& name : q.runs()) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end())
      throw r.error(r.table(),
                    fmt::format("quantity {} names an unknown variant {}", io::in_quotes(q.name), io::in_quotes(name)),
                    io::listed(names), io::did_you_mean(name, names, ""));
    q.tier = std::max(q.tier, known[static_cast<std::size_t>(at - names.begin())].tier);
  }
}

Quantity read_quantity(const Reader& r, const std::string& file, const Expected& expected) {
  Quantity q;
  q.file = file;
  q.place = r.table().place;
  for (const io::Member& m : *r.table().as<io::Table>()) q.places[m.key] = m.value.place;
  q.name = r.needed_text("name");
  read_measure(r, q);
  q.reason = r.needed_text("reason");
  q.tier = r.tier();
  if ((q.measure == "study") == expected.study.empty())
    throw q.error("measure",
                  fmt::format("measure {} does not go with {}", io::in_quotes(q.measure),
                              expected.study.empty() ? "runs of a case" : "a study"),
                  expected.study.empty() ? "any measure but \"study\"" : "\"study\"");
  read_bounds(r, q);
  read_variants(r, expected.variants, q);
  return q;
}

}  // namespace

bool Variant::lacking() const {
  if (needs.empty()) return false;
  const char* value = std::getenv(needs.c_str());
  return value == nullptr || *value == '\0';
}

std::optional<double> Quantity::number(const std::string& key) const {
  const auto at = numbers.find(key);
  return at == numbers.end() ? std::nullopt : std::optional(at->second);
}

std::vector<std::string> Quantity::runs() const {
  std::vector<std::string> names = variants;
  if (!over.empty()) names.push_back(over);
  for (const char* key : {"against", "minus"})
    if (const auto at = texts.find(key); at != texts.end() && !at->second.empty()) names.push_back(at->second);
  return names;
}

std::string Quantity::wanted() const {
  if (reference) return fmt::format("{:.6g} +- {:.3g}", *reference, *tolerance);
  std::string text;
  if (std::isfinite(low)) text = fmt::format(">= {:.6g}", low);
  if (std::isfinite(high)) text += fmt::format("{}<= {:.6g}", text.empty() ? "" : ", ", high);
  return text;
}

io::CaseError Quantity::error(const std::string& key, std::string problem, std::string allowed,
                              std::string hint) const {
  const auto at = places.find(key);
  return {file,
          at == places.end() ? place : at->second,
          {.problem = std::move(problem), .key = key, .allowed = std::move(allowed), .hint = std::move(hint)}};
}

const Variant& Expected::variant(const std::string& name) const {
  return *std::find_if(variants.begin(), variants.end(), [&](const Variant& v) { return v.name == name; });
}

Expected read_expected_text(const std::string& text, const std::filesystem::path& file) {
  const std::string name = file.string();
  io::guard(text, name);
  const io::Value root = io::parse_document(text, name);
  const Reader top(name, root, "the file");
  top.allow(kTop);
  Expected expected;
  expected.title = top.text("title").value_or("");
  expected.study = top.text("study").value_or("");
  expected.minutes = top.number("minutes").value_or(0.0);
  if (expected.minutes < 0.0) throw top.wrong(*root.find("minutes"), "minutes", "0 or more");
  expected.cores = top.count("cores");
  for (const Reader& r : tables(top, name, "variant")) {
    if (!expected.study.empty()) throw r.error(r.table(), "a study has no variants", "[[quantity]]");
    expected.variants.push_back(read_variant(r, expected.variants));
  }
  if (expected.variants.empty()) expected.variants.emplace_back().name = expected.study.empty() ? "case" : "study";
  for (const Reader& r : tables(top, name, "quantity")) expected.quantities.push_back(read_quantity(r, name, expected));
  if (expected.quantities.empty()) throw top.error(root, "no [[quantity]]", "at least one [[quantity]]");
  return expected;
}

Expected read_expected(const std::filesystem::path& file) {
  return read_expected_text(io::read_text_file(file, "list of expected quantities", kMostExpectedBytes), file);
}

}  // namespace scree::app
