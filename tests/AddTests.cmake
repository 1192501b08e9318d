# How tests are registered: names end in .npN, slots are counted, every test has a time limit.
set(SLIDEWAVE_MPIRUN ${MPIEXEC_EXECUTABLE} --bind-to none --oversubscribe --allow-run-as-root
    --mca mpi_yield_when_idle 1)

# add_unit_test(name LABEL coupler SOURCES a.cpp LIBRARIES x [RANKS 1 2 4] [TIMEOUT s] [MPI_MAIN])
# GoogleTest binary; with RANKS it is run under mpirun once per number and brings its own main()
# that initialises MPI (tests/mpi_main.cpp).
function(add_unit_test name)
  cmake_parse_arguments(T "" "LABEL;TIMEOUT" "SOURCES;LIBRARIES;RANKS" ${ARGN})
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 60)
  endif()
  add_executable(${name} ${T_SOURCES})
  target_link_libraries(${name} PRIVATE ${T_LIBRARIES} slidewave_warnings GTest::gtest)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(T_RANKS)
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/mpi_main.cpp)
    foreach(ranks ${T_RANKS})
      add_test(NAME ${name}.np${ranks} COMMAND ${SLIDEWAVE_MPIRUN} -np ${ranks} $<TARGET_FILE:${name}>)
      set_tests_properties(${name}.np${ranks} PROPERTIES LABELS "unit;${T_LABEL}" PROCESSORS ${ranks}
                                              TIMEOUT ${T_TIMEOUT})
    endforeach()
  else()
    target_link_libraries(${name} PRIVATE GTest::gtest_main)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "unit;${T_LABEL}" TIMEOUT ${T_TIMEOUT})
  endif()
endfunction()

# add_pair_test(name A exe ranks B exe ranks ARGS ... LABEL pair): one MPMD launch of two programs.
function(add_pair_test name)
  cmake_parse_arguments(T "" "LABEL;TIMEOUT" "A;B;ARGS" ${ARGN})
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 60)
  endif()
  list(GET T_A 0 exe_a)
  list(GET T_A 1 ranks_a)
  list(GET T_B 0 exe_b)
  list(GET T_B 1 ranks_b)
  add_test(NAME ${name}.np${ranks_a}_${ranks_b}
           COMMAND ${SLIDEWAVE_MPIRUN} -np ${ranks_a} ${exe_a} ${T_ARGS} : -np ${ranks_b} ${exe_b} ${T_ARGS})
  math(EXPR ranks "${ranks_a} + ${ranks_b}")
  set_tests_properties(${name}.np${ranks_a}_${ranks_b} PROPERTIES LABELS "pair;${T_LABEL}"
                       PROCESSORS ${ranks} TIMEOUT ${T_TIMEOUT})
endfunction()

# set_timed(test ...): tests that compare run times or act at moments measured in seconds. They have the
# machine to themselves, and do not run under the sanitizers, whose programs are too slow for them.
function(set_timed)
  set_property(TEST ${ARGN} APPEND PROPERTY LABELS timed)
  set_tests_properties(${ARGN} PROPERTIES RUN_SERIAL TRUE)
endfunction()
