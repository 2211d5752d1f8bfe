# Headers of other projects that most sources include, compiled once: this saves half of the compiler's time for a small
# source.
# Sources still include all headers they use; clang-tidy and a build with SCREE_PRECOMPILE=OFF compile without
# precompiled headers.
option(SCREE_PRECOMPILE "Compile common headers once" ON)
set(scree_common_headers
    <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional> <span> <string>
    <string_view> <utility> <vector> <Eigen/Core> <Eigen/LU> <fmt/format.h>)

# scree_precompile(target [FROM other]): other has the same compiler flags.
function(scree_precompile target)
  cmake_parse_arguments(arg "" "FROM" "" ${ARGN})
  if(NOT SCREE_PRECOMPILE OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  if(arg_FROM)
    target_precompile_headers(${target} REUSE_FROM ${arg_FROM})
  else()
    target_precompile_headers(${target} PRIVATE ${scree_common_headers} ${arg_UNPARSED_ARGUMENTS})
  endif()
endfunction()
