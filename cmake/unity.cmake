# Sources of one folder are compiled together in groups: their headers are read once per group. Names in unnamed
# namespaces must then be unique within a folder. A build with SCREE_UNITY=OFF compiles every source by itself, as
# clang-tidy does.
option(SCREE_UNITY "Compile the sources of a folder together" ON)
set(scree_unity_group 8)

# scree_unity(target): groups of the target's sources, in the order of their names.
function(scree_unity target)
  if(NOT SCREE_UNITY OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(SORT sources)
  set(folder "")
  foreach(source IN LISTS sources)
    cmake_path(IS_PREFIX PROJECT_SOURCE_DIR ${source} NORMALIZE ours)
    if(NOT ours)  # made by the build
      continue()
    endif()
    cmake_path(GET source PARENT_PATH parent)
    if(NOT parent STREQUAL folder)
      set(folder "${parent}")
      set(count 0)
    endif()
    math(EXPR group "${count} / ${scree_unity_group}")
    cmake_path(RELATIVE_PATH parent BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    string(MAKE_C_IDENTIFIER "${name}_${group}" name)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name})
    math(EXPR count "${count} + 1")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
