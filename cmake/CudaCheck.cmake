# Test cuda_compile_check: nvcc compiles every kernel for sm_90; nothing is linked or run. It shows that each
# kernel is device-clean on a machine without a GPU, against a copy of the Kokkos headers with CUDA switched on.
find_program(NVCC nvcc PATHS /usr/local/cuda/bin)

set(reason "")
if(NOT NVCC)
  set(reason "no nvcc on this machine")
elseif(NOT Kokkos_FOUND)
  set(reason "Kokkos is built from source here: preset cuda compiles for the GPU itself")
elseif(Kokkos_ENABLE_CUDA)
  set(reason "this Kokkos has CUDA: the build itself compiles for the GPU")
endif()
if(reason)
  add_check(cuda_compile_check cuda bash -c "echo 'skipped: ${reason}' && exit 77")
  return()
endif()

# Replaces a line of a copied header; a header that no longer has it must not pass as switched on.
function(switch_on file from to)
  file(READ ${headers}/${file} text)
  string(FIND "${text}" "${from}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "CUDA check: ${file} of Kokkos ${Kokkos_VERSION} has no line '${from}'")
  endif()
  string(REPLACE "${from}" "${to}" text "${text}")
  file(WRITE ${headers}/${file} "${text}")
endfunction()

get_target_property(kokkos_include Kokkos::kokkos INTERFACE_INCLUDE_DIRECTORIES)
set(headers ${PROJECT_BINARY_DIR}/cuda_check/kokkos)
if(NOT EXISTS ${headers}/.switched-${Kokkos_VERSION})
  file(REMOVE_RECURSE ${headers})
  file(COPY ${kokkos_include}/ DESTINATION ${headers})
  foreach(macro IN ITEMS ENABLE_CUDA ENABLE_CUDA_CONSTEXPR ARCH_HOPPER ARCH_HOPPER90)
    switch_on(KokkosCore_config.h "/* #undef KOKKOS_${macro} */" "#define KOKKOS_${macro}")
  endforeach()
  switch_on(desul/atomics/Config.hpp "/* #undef DESUL_ATOMICS_ENABLE_CUDA */" "#define DESUL_ATOMICS_ENABLE_CUDA")
  set(openmp "#include <fwd/Kokkos_Fwd_OPENMP.hpp>")
  switch_on(KokkosCore_Config_FwdBackend.hpp "${openmp}" "#include <fwd/Kokkos_Fwd_CUDA.hpp>\n${openmp}")
  set(openmp "#include <decl/Kokkos_Declare_OPENMP.hpp>")
  switch_on(KokkosCore_Config_DeclareBackend.hpp "${openmp}" "${openmp}\n#include <decl/Kokkos_Declare_CUDA.hpp>")
  set(guard "#define KOKKOS_SETUP_HPP_")
  switch_on(KokkosCore_Config_SetupBackend.hpp "${guard}" "${guard}\n#include <setup/Kokkos_Setup_Cuda.hpp>")
  file(TOUCH ${headers}/.switched-${Kokkos_VERSION})
endif()

# Build rules with dependencies, so that a second run compiles only what changed. Kokkos' headers cost nvcc far more than
# a kernel does, so kernels are compiled in groups.
group_files(group 12 ${kernel_sources})
set(objects "")
foreach(number IN LISTS group)
  set(source ${PROJECT_BINARY_DIR}/cuda_check/group_${number}.cpp)
  list(TRANSFORM group_${number} REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE text)
  string(JOIN "" text ${text})
  file(CONFIGURE OUTPUT ${source} CONTENT "${text}" @ONLY) # writes it only if it changes
  set(object ${PROJECT_BINARY_DIR}/cuda_check/group_${number}.o)
  add_custom_command(OUTPUT ${object}
    COMMAND ${NVCC} -std=c++20 -arch=sm_90 -ccbin ${CMAKE_CXX_COMPILER} -O1 -x cu --extended-lambda
            --expt-relaxed-constexpr -Xcompiler -fopenmp -Xcudafe --diag_suppress=20208
            -isystem ${headers} -I${PROJECT_SOURCE_DIR}/include -MD -MF ${object}.d -c ${source} -o ${object}
    DEPENDS ${source} DEPFILE ${object}.d
    COMMENT "nvcc sm_90: kernels, group ${number}" VERBATIM)
  list(APPEND objects ${object})
endforeach()
add_custom_target(cuda_objects DEPENDS ${objects})
add_check(cuda_compile_check cuda ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target cuda_objects --parallel 2)
