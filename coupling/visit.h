// Lists of fields: one list serves all code that reads an object (hash, comparison, checkpoint) and all that writes it.
#pragma once

#include <utility>
#include <vector>

namespace scree::coupling {

/// object.visit(see) is const: see(name, field) and see.size(name, list) receive constants. This visitor passes them on
/// without const, as they are in an object that is not const.
template <class Visitor>
class Writer {
 public:
  explicit Writer(Visitor& see) : see_(&see) {}
  template <class T>
  void operator()(const char* name, const T& value) {
    (*see_)(name, const_cast<T&>(value));  // NOLINT(cppcoreguidelines-pro-type-const-cast): see visit_to_write()
  }
  template <class T>
  void size(const char* name, const std::vector<T>& list) {
    see_->size(name, const_cast<std::vector<T>&>(list));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  }

 private:
  Visitor* see_;
};

/// Calls a visitor for every field of an object; the visitor may write to them, and see.size() may resize a list.
template <class T, class Visitor>
void visit_to_write(T& object, Visitor&& see) {
  std::as_const(object).visit(Writer(see));
}

}  // namespace scree::coupling
