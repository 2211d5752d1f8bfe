# scree_eigen_alignment: the alignment that Eigen uses when compiled for the processor of this machine [bytes].
set(scree_ask ${PROJECT_BINARY_DIR}/eigen_alignment.cpp)
file(WRITE ${scree_ask} "#if defined(__AVX512F__)\nalign=64\n#elif defined(__AVX__)\nalign=32\n#else\nalign=16\n#endif\n")
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -E -P ${scree_ask} OUTPUT_VARIABLE scree_answer)
string(REGEX MATCH "[0-9]+" scree_eigen_alignment "${scree_answer}")
