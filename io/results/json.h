// A small writer of JSON text: indented, escaped, numbers that read back to the same bits.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace scree::io {

/// Text in quotes, with what JSON does not allow escaped; bytes that are not UTF-8 become U+FFFD.   @source [RFC8259]
[[nodiscard]] std::string json_quoted(std::string_view text);
/// Shortest digits that read back to the same double; null when it is not finite, which JSON cannot say.
[[nodiscard]] std::string json_number(double value);

/// Builds one document. Keys inside objects, none inside lists:
///   json.open('{').field("a", 1.0).open('[', "b").item("x").close(']').close('}').text()
class JsonWriter {
 public:
  JsonWriter& open(char bracket, std::string_view key = {});
  JsonWriter& close(char bracket);
  JsonWriter& field(std::string_view key, std::string_view text) { return raw(key, json_quoted(text)); }
  JsonWriter& field(std::string_view key, const char* text) { return field(key, std::string_view(text)); }
  JsonWriter& field(std::string_view key, double number);
  JsonWriter& field(std::string_view key, std::integral auto number) { return raw(key, std::to_string(number)); }
  JsonWriter& item(std::string_view text) { return raw({}, json_quoted(text)); }
  /// Key of the first number that was not finite, and stands as null; empty: all were.
  [[nodiscard]] const std::string& not_finite() const { return not_finite_; }
  /// The document with a line end.   @pre everything opened is closed
  [[nodiscard]] std::string text() const;

 private:
  JsonWriter& raw(std::string_view key, std::string_view value);
  void begin_value(std::string_view key);

  std::string out_;
  std::string not_finite_;
  std::string open_;   // brackets not closed yet
  bool first_ = true;  // nothing yet in the innermost one
};

}  // namespace scree::io
