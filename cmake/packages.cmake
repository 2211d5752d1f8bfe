# Every library that Scree uses, as an imported target. Debian packages: packages.txt. Installed beside scree-config.cmake,
# which sets SCREE_INSTALLED: programs that link Scree require the dependencies of its libraries, not those needed only
# to build them.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(PkgConfig REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(spdlog 1.10 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
# Linked statically where that is possible: the shared library loads libcurl for a remote file system, and with it 25
# others, at every start of a command (a quarter of its 10 ms). Leak suppressions name the shared library.
if(NOT SCREE_INSTALLED AND NOT SCREE_SANITIZE)
  set(HDF5_USE_STATIC_LIBRARIES ON)
  find_package(HDF5 1.10 QUIET COMPONENTS C HL)
  if(NOT HDF5_FOUND)
    set(HDF5_USE_STATIC_LIBRARIES OFF)
  endif()
endif()
find_package(HDF5 1.10 REQUIRED COMPONENTS C HL)
find_package(Threads REQUIRED)
find_package(ZLIB 1.2.9 REQUIRED)                     # crc32_z
find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto)  # SHA-256
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(lcm REQUIRED IMPORTED_TARGET lcm)
pkg_check_modules(geos REQUIRED IMPORTED_TARGET geos)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(libisal REQUIRED IMPORTED_TARGET libisal)
pkg_check_modules(dxflib REQUIRED IMPORTED_TARGET dxflib)

if(NOT SCREE_INSTALLED)
  find_package(CLI11 2.1 REQUIRED)
  find_package(nlohmann_json 3.11 REQUIRED)
  find_package(Boost 1.74 REQUIRED)  # headers: Asio, Beast
  find_program(LCM_GEN lcm-gen REQUIRED)
endif()

find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(scree_cholmod INTERFACE IMPORTED)
target_include_directories(scree_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE})
target_link_libraries(scree_cholmod INTERFACE ${CHOLMOD_LIBRARY})
find_library(OPENBLAS_LIBRARY NAMES libopenblas.so.0)  # of CHOLMOD; may be missing: another BLAS takes its place
