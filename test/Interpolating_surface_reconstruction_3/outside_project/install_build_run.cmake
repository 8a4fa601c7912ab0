# Installs the package to a scratch prefix, then configures, builds and runs the outside project.
file(REMOVE_RECURSE ${WORK_DIR})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${PACKAGE_BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D CGAL_DIR=${CGAL_DIR})

# Headers of the source tree would hide a header that is not installed.
file(GLOB_RECURSE installed RELATIVE ${WORK_DIR}/prefix ${WORK_DIR}/prefix/include/*.h)
file(GLOB_RECURSE shipped RELATIVE ${SOURCE_DIR}/../../.. ${SOURCE_DIR}/../../../include/*.h)
if(NOT installed STREQUAL shipped)
  message(FATAL_ERROR "installed headers: ${installed}\nshipped headers: ${shipped}")
endif()

run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/outside_project)
