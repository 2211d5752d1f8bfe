include(GNUInstallDirs)

# How Scree is compiled. Presets in CMakePresets.json set these.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(SCREE_TESTS "Build the tests" ON)
option(SCREE_WERROR "Treat warnings as errors" OFF)
option(SCREE_NATIVE "Compile for the processor of this machine" OFF)
option(SCREE_AUDIT "Keep SCREE_ASSERT in optimised code" OFF)
option(SCREE_FUZZ "Make libFuzzer's programs of tests/fuzz (clang)" OFF)
set(SCREE_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined")

add_library(scree_options INTERFACE)
target_include_directories(scree_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                   $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/scree>)
target_compile_features(scree_options INTERFACE cxx_std_20)
# Results must not depend on how the compiler contracts a*b+c: hashes are compared between runs and thread counts.
# errno is not read after sqrt, and loops that contain a call are not vectorised; values are the same.
# Without the third option no function that another library could replace is inlined in position-independent code.
target_compile_options(scree_options INTERFACE -ffp-contract=off -fno-math-errno $<BUILD_INTERFACE:-fno-semantic-interposition>
                       "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wno-sign-conversion>"
                       # False alarms of GCC 12 in its own headers (AVX-512 intrinsics: bugs 105593, 107461; strings: 105651).
                       # Clang's warning of the same name is an error in clang-tidy's run. In a unity build
                       # (unity.cmake) a class of a source may still have a member whose type is in an unnamed
                       # namespace.
                       "$<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized;-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overread;-Wno-stringop-overflow;-Wno-subobject-linkage>>")
if(SCREE_WERROR)
  target_compile_options(scree_options INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(SCREE_NATIVE)
  # Not for programs that link the libraries. Their objects must still have the same memory layout: Eigen aligns
  # small matrices, and memory that it allocates, to the vector size of the processor it is compiled for.
  target_compile_options(scree_options INTERFACE $<BUILD_INTERFACE:-march=native>)
  include(cmake/eigen_alignment.cmake)
  target_compile_definitions(scree_options INTERFACE
    $<INSTALL_INTERFACE:EIGEN_MAX_STATIC_ALIGN_BYTES=${scree_eigen_alignment}>
    $<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=${scree_eigen_alignment}>)
endif()
if(SCREE_AUDIT)
  target_compile_definitions(scree_options INTERFACE SCREE_AUDIT=1)
endif()
if(SCREE_SANITIZE)
  target_compile_options(scree_options INTERFACE -fsanitize=${SCREE_SANITIZE} -fno-omit-frame-pointer)
  if(SCREE_SANITIZE MATCHES undefined)
    # These checks take half of the compiler's time for little gain: the address sanitizer detects null pointers, Eigen
    # asserts alignment.
    target_compile_options(scree_options INTERFACE -fno-sanitize=null,alignment)
  endif()
  target_link_options(scree_options INTERFACE -fsanitize=${SCREE_SANITIZE})
endif()

# Sources of steps: with -O3 an implicit step of a wall at rest takes 18 % fewer instructions than with -O2, a step of
# cases/slope-ei 5 %, the loops over contact points 10 %. Floating-point sums keep their order (-ffp-contract=off, no
# -ffast-math), so results have the same bits.
function(scree_optimise_steps target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
endfunction()
