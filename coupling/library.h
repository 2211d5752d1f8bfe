// Interface of a shared library to the command line: `scree run CASE --load LIBRARY`.
#pragma once

/// Declares a shared library for `--load`, once, outside every namespace. `add` is called before the case is read, to
/// register methods and laws (register_method, register_friction_law); an exception in it is an error of the command
/// line.
/// The library must be compiled with the headers of the same version of Scree that loads it (target scree::library of
/// find_package(scree)); this is checked.
#define SCREE_LIBRARY(add)                                                                                        \
  extern "C" [[gnu::visibility("default")]] const char* scree_library_version() { return SCREE_LIBRARY_VERSION; } \
  extern "C" [[gnu::visibility("default")]] void scree_library_add() { add(); }                                   \
  static_assert(true, "a semicolon follows")
