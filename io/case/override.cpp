#include "io/case/override.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "io/case/guard.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

struct Part {
  std::string text;
  int column;  // from 1
};

constexpr const char* kOverrideForm = "key=value, for example stage.0.duration=0.1";

/// Reads and applies one option.
class Override {
 public:
  Override(const std::string& option, int number) : option_(option), number_(number) {}

  void apply(Value& root) {
    split();
    Value value =
        parse_set_value(std::string_view(option_).substr(equals_ + 1), number_, static_cast<int>(equals_) + 1);
    Value* at = &root;
    for (std::size_t i = 0; i < parts_.size(); ++i) at = &enter(*at, i);
    *at = std::move(value);
  }

 private:
  [[noreturn]] void fail(int column, std::string problem, std::string allowed, std::string hint) const {
    throw CaseError("--set", {number_, column, true},
                    {std::move(problem), "", in_quotes(option_), std::move(allowed), std::move(hint)});
  }

  /// Finds the parts of the key and the position of the equals sign.
  void split() {
    std::size_t i = 0;
    while (true) {
      Part part{"", static_cast<int>(i) + 1};
      if (i < option_.size() && (option_[i] == '"' || option_[i] == '\'')) {
        const std::size_t end = option_.find(option_[i], i + 1);
        if (end == std::string::npos) fail(part.column, "the quotation mark is not closed", kOverrideForm, "close it");
        part.text = option_.substr(i + 1, end - i - 1);
        i = end + 1;
      } else {
        const std::size_t end = std::min(option_.find_first_of(".=", i), option_.size());
        part.text = option_.substr(i, end - i);
        i = end;
        while (!part.text.empty() && part.text.back() == ' ') part.text.pop_back();
        if (part.text.empty())
          fail(part.column, "a part of the key is empty", kOverrideForm, "write the key, an equals sign and the value");
      }
      parts_.push_back(std::move(part));
      while (i < option_.size() && option_[i] == ' ') ++i;
      if (i >= option_.size())
        fail(static_cast<int>(i) + 1, "the equals sign is missing", kOverrideForm, "write key=value without spaces");
      if (parts_.size() > static_cast<std::size_t>(kDeepest))
        fail(1, "the key has too many parts", "at most 64", "no key needs more than four");
      if (option_[i] == '=') break;
      if (option_[i] != '.')
        fail(static_cast<int>(i) + 1, "a dot or an equals sign is expected here", kOverrideForm,
             "quote names that hold dots");
      ++i;
    }
    equals_ = i;
  }

  Value& enter(Value& at, std::size_t i) {
    const Part& part = parts_[i];
    if (auto* items = at.as<Array>()) return item(*items, part, i);
    if (!at.as<Table>())
      fail(part.column, fmt::format("there is nothing within {}", in_quotes(parts_[i - 1].text)),
           "a key of the case file", "`scree schema` lists every key");
    if (Value* found = at.find(part.text)) return *found;
    const Place here{number_, part.column, true};
    at.as<Table>()->push_back({part.text, here, Value{here, Table{}}});
    return at.as<Table>()->back().value;
  }

  Value& item(Array& items, const Part& part, std::size_t i) {
    std::size_t index = 0;
    const char* end = part.text.data() + part.text.size();
    const auto read = std::from_chars(part.text.data(), end, index);
    std::vector<std::string> names;
    for (Value& v : items)
      if (const Value* name = v.find("name"); name && name->as<std::string>()) {
        names.push_back(*name->as<std::string>());
        if (names.back() == part.text) return v;
      }
    if (read.ec == std::errc{} && read.ptr == end && index < items.size()) return items[index];
    const std::string list = i == 0 ? "the list" : parts_[i - 1].text;
    const std::string numbers = items.empty() ? "nothing: the list is empty" : fmt::format("0 to {}", items.size() - 1);
    fail(part.column, fmt::format("{} has no item {}", list, in_quotes(part.text)),
         numbers + (names.empty() ? "" : "; " + listed(names)),
         did_you_mean(part.text, names, "count from 0, or give the name of an item"));
  }

  const std::string& option_;
  int number_;
  std::vector<Part> parts_;
  std::size_t equals_ = 0;
};

}  // namespace

void apply_overrides(Value& root, std::span<const std::string> overrides) {
  int number = 0;
  for (const std::string& option : overrides) Override(option, ++number).apply(root);
}

}  // namespace scree::io
