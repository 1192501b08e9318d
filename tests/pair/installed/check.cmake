# Installs the coupler alone, builds the fakes against it in another tree, and runs them.
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DPYTHON=... -DMPIRUN=... -DCXX=... -P check.cmake
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
step(${CMAKE_COMMAND} --install ${BUILD} --component coupler --prefix ${WORK}/package)
step(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/installed -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/package
     -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Release)
step(${CMAKE_COMMAND} --build ${WORK}/build)
step(${PYTHON} ${SOURCE}/pair.py budgets --bin ${WORK}/build --work ${WORK}/runs --mpirun ${MPIRUN})
# The line of docs/add_an_engine.md.
file(COPY ${SOURCE}/installed/case.toml DESTINATION ${WORK}/first)
separate_arguments(mpirun UNIX_COMMAND "${MPIRUN}")
step(${mpirun} -np 2 ${WORK}/build/fake_fluid ${WORK}/first : -np 3 ${WORK}/build/fake_dem ${WORK}/first)
file(READ ${WORK}/first/summary.json summary)
string(JSON status GET "${summary}" status)
if(NOT status STREQUAL completed)
  message(FATAL_ERROR "the run is ${status}")
endif()
