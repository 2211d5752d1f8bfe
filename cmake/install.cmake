# The command, the libraries with their headers (find_package(scree)), the case library and the manual.
include(CMakePackageConfigHelpers)

set(scree_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
install(TARGETS scree RUNTIME)
install(TARGETS scree_options scree_lcmtypes scree_model scree_nmm scree_dda scree_coupling scree_library scree_io EXPORT scree_targets ARCHIVE)
foreach(library options lcmtypes model nmm dda coupling library io)
  set_target_properties(scree_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
install(EXPORT scree_targets NAMESPACE scree:: DESTINATION ${scree_cmake_dir})
configure_package_config_file(cmake/scree-config.cmake.in ${PROJECT_BINARY_DIR}/scree-config.cmake
                              INSTALL_DESTINATION ${scree_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scree-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scree-config.cmake ${PROJECT_BINARY_DIR}/scree-config-version.cmake cmake/packages.cmake
        DESTINATION ${scree_cmake_dir})

# Headers are included as "model/model.h": programs that link Scree get their parent folder as an include path.
install(DIRECTORY model nmm dda coupling io DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree FILES_MATCHING PATTERN "*.h")
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/scree)
install(DIRECTORY io/lcmtypes DESTINATION ${CMAKE_INSTALL_DATADIR}/scree FILES_MATCHING PATTERN "*.lcm")
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN "*.1" EXCLUDE)
install(FILES docs/scree.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

# cpack -G DEB. One package: the command with the files it reads, and the libraries for other programs.
set(CPACK_GENERATOR DEB)
set(CPACK_SCREE_NATIVE ${SCREE_NATIVE})
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/portable-packages.cmake)
set(CPACK_PACKAGE_NAME scree)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CONTACT "The Scree authors <scree@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the libraries of the command, from what it is linked with
# Packages that a program linking Scree requires, from packages.txt.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, pkg-config, libeigen3-dev, libbullet-dev, libsuitesparse-dev, libopenblas0-pthread, libhdf5-dev, liblcm-dev, libglib2.0-dev, libgeos-dev, libtomlplusplus-dev, libfmt-dev, libspdlog-dev, libcairo2-dev, libdxflib-dev, zlib1g-dev, libisal-dev, libssl-dev")
include(CPack)
