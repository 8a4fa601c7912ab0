# Included by the top-level CMakeLists.txt: the test needs the example isr_reconstruct.
if(TARGET isr_reconstruct)
  add_executable(isr_dump_ply ${CMAKE_CURRENT_LIST_DIR}/isr_dump_ply.cpp)
  target_compile_features(isr_dump_ply PRIVATE cxx_std_17)
  add_test(NAME isr_reconstruct_command_line
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_isr_reconstruct.sh
      $<TARGET_FILE:isr_reconstruct> $<TARGET_FILE:isr_dump_ply>
      ${PROJECT_SOURCE_DIR}/examples/Interpolating_surface_reconstruction_3/data
      ${PROJECT_BINARY_DIR}/command_line_test)
endif()
