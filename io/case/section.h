// Typed reading of a checked document: types, units and ranges have been checked against the table of keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/case/document.h"
#include "model/geometry.h"

namespace scree::io {

/// A table of the document, and its path as the user would write it.
class Section {
 public:
  /// @pre check_document has passed; the table outlives the section
  Section(std::string_view file, Value& table, std::string path)
      : file_(file), table_(&table), path_(std::move(path)) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_->find(key) != nullptr; }

  /// @pre the key is present (required, or with a default)
  [[nodiscard]] bool boolean(std::string_view key) const;
  [[nodiscard]] int integer(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] std::optional<double> number_or_auto(std::string_view key) const;  // empty: "auto"
  [[nodiscard]] double number_or_unlimited(std::string_view key) const;            // infinite: "unlimited"
  [[nodiscard]] bool is_text(std::string_view key) const;                          // of a key with a number or a name
  [[nodiscard]] const std::string& text(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] Vec2 point(std::string_view key) const;
  [[nodiscard]] Ring ring(std::string_view key) const;
  [[nodiscard]] std::vector<Ring> rings(std::string_view key) const;

  /// Inner tables; none where the key is absent.
  [[nodiscard]] Section table(std::string_view key) const;
  [[nodiscard]] std::vector<Section> list(std::string_view key) const;
  struct Named;
  [[nodiscard]] std::vector<Named> named(std::string_view key) const;

  /// Writes a default that the reader determined into the document, for the resolved case.
  void settle(std::string_view key, double number) const;
  void settle(std::string_view key, std::int64_t whole) const;
  void settle(std::string_view key, const std::string& text) const;

  /// An error at the value of a key, at an item of the value, or at the table itself if the key is absent.
  [[nodiscard]] CaseError error(std::string_view key, std::string problem, std::string allowed, std::string hint) const;
  [[nodiscard]] CaseError error(std::string_view key, std::size_t item, std::string problem, std::string allowed,
                                std::string hint) const;
  [[nodiscard]] std::string_view file() const { return file_; }

 private:
  [[nodiscard]] Value& at(std::string_view key) const;
  void settle_value(std::string_view key, Value value) const;

  std::string_view file_;
  Value* table_;
  std::string path_;
};

struct Section::Named {
  std::string name;
  Section section;
};

}  // namespace scree::io
