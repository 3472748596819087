# Tests that are not GoogleTest programs. Each prints its reason and returns 77 where it cannot run. Some build, and two
# builds in one folder disturb each other.

function(add_check name label)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS ${label} SKIP_RETURN_CODE 77 TIMEOUT 2400 PROCESSORS 2 RESOURCE_LOCK build COST 1000)
endfunction()

# First of all, because it takes no time.
add_check(format format bash ${PROJECT_SOURCE_DIR}/cmake/check_format.sh ${PROJECT_SOURCE_DIR})
set_tests_properties(format PROPERTIES COST 1e6)

include(${PROJECT_SOURCE_DIR}/cmake/CudaCheck.cmake)

# The unit tests once more, in builds of their own: with ASan and UBSan, and in the form of the pair sums that a GPU
# compiles.
if(NOT SWARF_SANITIZE AND NOT SWARF_ONE_LANE)
  add_check(sanitizers sanitizer bash ${PROJECT_SOURCE_DIR}/cmake/check_kernels.sh
    dev ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/sanitizers)
  add_check(one_lane one_lane bash ${PROJECT_SOURCE_DIR}/cmake/check_kernels.sh
    one_lane ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/one_lane)
endif()

# The shipped quick deck from end to end, as a user runs it.
if(NOT SWARF_SANITIZE)
  add_check(quick_deck demo bash ${PROJECT_SOURCE_DIR}/cmake/check_quick_deck.sh
    $<TARGET_FILE:swarf> ${PROJECT_SOURCE_DIR}/inputs/micro_milling_quick.toml)
endif()

# The Python package that the scripts and users read results with.
add_check(python python bash ${PROJECT_SOURCE_DIR}/cmake/check_python.sh ${PROJECT_SOURCE_DIR})

# The installed package, used by a program of its own; the Debian package; the program without VTK.
if(NOT SWARF_SANITIZE AND PROJECT_IS_TOP_LEVEL)
  add_check(package package bash ${PROJECT_SOURCE_DIR}/cmake/check_package.sh ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
  add_check(deb package bash ${PROJECT_SOURCE_DIR}/cmake/check_deb.sh ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
endif()
if(SWARF_PICTURES AND NOT SWARF_SANITIZE) # what stands in for VTK comes first, so nothing of what draws is linked
  add_executable(swarf_without_vtk
    ${PROJECT_SOURCE_DIR}/src/output/without_vtk.cpp ${PROJECT_SOURCE_DIR}/src/plots/without_vtk.cpp
    ${PROJECT_SOURCE_DIR}/src/pictures/without_vtk.cpp)
  target_link_libraries(swarf_without_vtk PRIVATE swarf_main)
  precompile(swarf_without_vtk REUSE_FROM swarf_kernels)
  add_check(without_vtk package bash ${PROJECT_SOURCE_DIR}/cmake/check_without_vtk.sh
    $<TARGET_FILE:swarf_without_vtk> ${PROJECT_SOURCE_DIR}/examples/embed/method.toml)
endif()
