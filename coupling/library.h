// What a shared library says to the command line: `scree run CASE --load LIBRARY`.
#pragma once

/// Declares a shared library for `--load`, once, outside every namespace. `add` is called before the case is read, to
/// register methods and laws (register_method, register_friction_law); what it throws is an error of the command line.
/// To be compiled with the headers of the very version of Scree that loads it (target scree::library of
/// find_package(scree)), which is checked.
#define SCREE_LIBRARY(add)                                                                                        \
  extern "C" [[gnu::visibility("default")]] const char* scree_library_version() { return SCREE_LIBRARY_VERSION; } \
  extern "C" [[gnu::visibility("default")]] void scree_library_add() { add(); }                                   \
  static_assert(true, "a semicolon follows")
