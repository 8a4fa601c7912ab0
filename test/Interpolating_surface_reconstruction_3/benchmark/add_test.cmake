# Included by the top-level CMakeLists.txt: the tests need the benchmarks.
if(TARGET isr_tables)
  add_executable(test_isr_benchmark_surfaces ${CMAKE_CURRENT_LIST_DIR}/test_isr_benchmark_surfaces.cpp)
  target_include_directories(test_isr_benchmark_surfaces PRIVATE
    ${PROJECT_SOURCE_DIR}/benchmark/Interpolating_surface_reconstruction_3)
  target_link_libraries(test_isr_benchmark_surfaces PRIVATE
    CGAL::Interpolating_surface_reconstruction_3 CGAL::CGAL)
  add_test(NAME test_isr_benchmark_surfaces COMMAND test_isr_benchmark_surfaces)

  find_program(CGAL_ISR_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
  mark_as_advanced(CGAL_ISR_PYTHON)
  if(CGAL_ISR_PYTHON)
    add_test(NAME isr_quality
      COMMAND ${CGAL_ISR_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/test_isr_quality.py $<TARGET_FILE:isr_derived_meshes>
        $<TARGET_FILE:isr_compare> ${PROJECT_BINARY_DIR}/quality_test)
  endif()
  set(isr_has_matplotlib 1)
  if(CGAL_ISR_PYTHON)
    execute_process(COMMAND ${CGAL_ISR_PYTHON} -c "import matplotlib, numpy, PIL"
      RESULT_VARIABLE isr_has_matplotlib OUTPUT_QUIET ERROR_QUIET)
  endif()
  if(isr_has_matplotlib EQUAL 0)
    add_test(NAME isr_tables_quick
      COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_isr_tables.sh ${CGAL_ISR_PYTHON} $<TARGET_FILE:isr_tables>
        ${PROJECT_BINARY_DIR}/tables_test)
    set_tests_properties(isr_tables_quick PROPERTIES COST 150) # seconds, see the tests
  else()
    message(STATUS "NOTICE: /usr/bin/python3 with matplotlib was not found. The benchmark is not run as a test.")
  endif()
endif()
