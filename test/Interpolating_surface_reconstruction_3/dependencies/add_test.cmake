# Included by the top-level CMakeLists.txt. The list of packages is that of one version of CGAL.
if(CGAL_VERSION VERSION_EQUAL 5.5.1 AND UNIX AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  find_path(CGAL_ISR_CGAL_INCLUDE_DIR CGAL/version.h HINTS ${CGAL_INCLUDE_DIRS})
  find_path(CGAL_ISR_EIGEN_INCLUDE_DIR Eigen/Core HINTS ${EIGEN3_INCLUDE_DIR} PATH_SUFFIXES eigen3)
  mark_as_advanced(CGAL_ISR_CGAL_INCLUDE_DIR CGAL_ISR_EIGEN_INCLUDE_DIR)
  add_test(NAME isr_dependencies
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_dependencies.sh ${CMAKE_CXX_COMPILER}
      ${CGAL_ISR_CGAL_INCLUDE_DIR} ${CGAL_ISR_EIGEN_INCLUDE_DIR})
endif()
