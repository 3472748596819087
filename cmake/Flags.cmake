# swarf_flags: what every translation unit must agree on. The warnings are for our own code only.
add_library(swarf_flags INTERFACE)

# No errno, no trap: lets loops with sqrt vectorise. NaN and infinity keep their meaning (no -ffast-math):
# a run that goes wrong must say so.
target_compile_options(swarf_flags INTERFACE -fno-math-errno -fno-trapping-math)

if(NOT SWARF_PORTABLE)
  target_compile_options(swarf_flags INTERFACE -march=native)
  # Kokkos' SIMD types are one lane wide unless its ARCH macro is given. Debian's package comes without.
  if(NOT Kokkos_ARCH AND Kokkos_FOUND AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
                    OUTPUT_VARIABLE native_macros)
    set(simd_macro KOKKOS_ARCH_AVX512XEON)
    foreach(set IN ITEMS F CD BW DQ VL)
      if(NOT native_macros MATCHES "__AVX512${set}__")
        set(simd_macro KOKKOS_ARCH_AVX2)
      endif()
    endforeach()
    if(native_macros MATCHES "__AVX2__")
      target_compile_definitions(swarf_flags INTERFACE ${simd_macro})
      message(STATUS "Native instruction set: ${simd_macro}")
    endif()
  endif()
endif()

if(SWARF_ONE_LANE)
  target_compile_definitions(swarf_flags INTERFACE SWARF_ONE_LANE)
endif()

if(SWARF_FLOAT)
  target_compile_definitions(swarf_flags INTERFACE SWARF_FLOAT)
  # A wave's first foot is below 1e-38 in float: subnormal, which a CPU computes many times slower. At the link
  # alone, where nothing is compiled, this flag only adds the start-up code that takes subnormals for zero.
  if(NOT Kokkos_ENABLE_CUDA)
    target_link_options(swarf_flags INTERFACE -ffast-math)
  endif()
endif()

if(SWARF_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(swarf_flags INTERFACE ${sanitizers})
  target_link_options(swarf_flags INTERFACE ${sanitizers})
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow)
# GCC 12 warns about its own AVX-512 header wherever it inlines it (GCC bug 105593), and every GCC guesses wrong
# under sanitizers.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND (CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13 OR SWARF_SANITIZE))
  add_compile_options(-Wno-uninitialized -Wno-maybe-uninitialized)
endif()
if(SWARF_WERROR)
  add_compile_options(-Werror)
endif()

# Kokkos' headers are half of what a file costs to compile. nvcc knows no precompiled headers.
function(precompile target)
  if(NOT Kokkos_ENABLE_CUDA)
    target_precompile_headers(${target} ${ARGN})
  endif()
endfunction()
