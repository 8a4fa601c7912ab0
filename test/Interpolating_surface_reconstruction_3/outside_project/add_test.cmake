# Included by the top-level CMakeLists.txt: the install tree belongs to the whole package.
add_test(NAME isr_outside_project
  COMMAND ${CMAKE_COMMAND}
    -D PACKAGE_BUILD_DIR=${PROJECT_BINARY_DIR}
    -D SOURCE_DIR=${CMAKE_CURRENT_LIST_DIR}
    -D WORK_DIR=${PROJECT_BINARY_DIR}/outside_project
    -D GENERATOR=${CMAKE_GENERATOR}
    -D COMPILER=${CMAKE_CXX_COMPILER}
    -D LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    -D CGAL_DIR=${CGAL_DIR}
    -P ${CMAKE_CURRENT_LIST_DIR}/install_build_run.cmake)
set_tests_properties(isr_outside_project PROPERTIES COST 40) # seconds, see the tests
