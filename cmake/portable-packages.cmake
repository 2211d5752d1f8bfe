# Read by cpack: packages are for other machines.
if(CPACK_SCREE_NATIVE)
  message(FATAL_ERROR "this build is for the processor of this machine only (SCREE_NATIVE); make packages of another:\n"
                      "  cmake --preset package && cmake --build --preset package && (cd build/package && cpack)")
endif()
