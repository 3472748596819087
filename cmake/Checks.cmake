# Tests that are not GoogleTest programs. Each prints its reason and returns 77 where it cannot run.

function(add_check name label)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS ${label} SKIP_RETURN_CODE 77 TIMEOUT 1200 RUN_SERIAL ON)
endfunction()

# First of all, because it takes no time.
add_check(format format bash ${CMAKE_SOURCE_DIR}/cmake/check_format.sh ${CMAKE_SOURCE_DIR})
set_tests_properties(format PROPERTIES COST 1e6)

include(${CMAKE_SOURCE_DIR}/cmake/CudaCheck.cmake)

# The unit tests once more, in a build of their own with ASan and UBSan.
if(NOT SWARF_SANITIZE)
  add_check(sanitizers sanitizer bash ${CMAKE_SOURCE_DIR}/cmake/check_sanitizers.sh
    ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/sanitizers ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# The shipped quick deck from end to end, as a user runs it.
if(TARGET swarf AND NOT SWARF_SANITIZE)
  add_check(quick_deck demo bash ${CMAKE_SOURCE_DIR}/cmake/check_quick_deck.sh
    $<TARGET_FILE:swarf> ${CMAKE_SOURCE_DIR}/inputs/micro_milling_quick.toml)
endif()

# The Python package that the scripts and users read results with.
add_check(python python bash ${CMAKE_SOURCE_DIR}/cmake/check_python.sh ${CMAKE_SOURCE_DIR})
