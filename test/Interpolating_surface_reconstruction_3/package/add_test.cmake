# Included by the top-level CMakeLists.txt: checks of the files of the package.
if(UNIX)
  add_test(NAME isr_package COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_package.sh)

  find_program(CGAL_ISR_DOXYGEN doxygen)
  mark_as_advanced(CGAL_ISR_DOXYGEN)
  if(CGAL_ISR_DOXYGEN)
    add_test(NAME isr_documentation
      COMMAND ${PROJECT_SOURCE_DIR}/doc/Interpolating_surface_reconstruction_3/build_documentation.sh
        ${PROJECT_BINARY_DIR}/documentation)
  endif()

  find_path(CGAL_ISR_CGAL_INCLUDE_DIR CGAL/version.h HINTS ${CGAL_INCLUDE_DIRS})
  find_path(CGAL_ISR_EIGEN_INCLUDE_DIR Eigen/Core HINTS ${EIGEN3_INCLUDE_DIR} PATH_SUFFIXES eigen3)
  mark_as_advanced(CGAL_ISR_CGAL_INCLUDE_DIR CGAL_ISR_EIGEN_INCLUDE_DIR)
  # It takes two thirds of the time of g++, which compiles all programs.
  find_program(CGAL_ISR_CLANG NAMES clang++-14 clang++)
  mark_as_advanced(CGAL_ISR_CLANG)
  if(CGAL_ISR_CLANG)
    set(isr_header_compiler ${CGAL_ISR_CLANG})
  else()
    set(isr_header_compiler ${CMAKE_CXX_COMPILER})
  endif()
  add_test(NAME isr_headers
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_headers.sh ${isr_header_compiler}
      -idirafter ${CGAL_ISR_CGAL_INCLUDE_DIR} -idirafter ${CGAL_ISR_EIGEN_INCLUDE_DIR})
  add_test(NAME isr_tidy
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_tidy.sh
      -idirafter ${CGAL_ISR_CGAL_INCLUDE_DIR} -idirafter ${CGAL_ISR_EIGEN_INCLUDE_DIR})
  # seconds, see the tests
  set_tests_properties(isr_headers PROPERTIES COST 190)
  set_tests_properties(isr_tidy PROPERTIES COST 50)
endif()
