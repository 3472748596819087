# Kokkos 5, from the first of: an installed one, the private prefix of scripts/setup, the upstream release.
# Link swarf_kokkos; it carries what the private prefix needs beyond Kokkos itself.
set(SWARF_PREFIX "$ENV{SWARF_PREFIX}" CACHE PATH "Private Kokkos made by scripts/setup")
if(NOT SWARF_PREFIX)
  set(SWARF_PREFIX "$ENV{HOME}/.cache/swarf/kokkos")
endif()
option(SWARF_FETCH_KOKKOS "Build the upstream Kokkos release even if another Kokkos is there" OFF)

add_library(swarf_kokkos INTERFACE)

if(NOT SWARF_FETCH_KOKKOS)
  find_package(Kokkos 5 QUIET CONFIG)
  if(NOT Kokkos_FOUND)
    file(GLOB private_kokkos "${SWARF_PREFIX}/usr/lib/*/cmake/Kokkos")
    if(private_kokkos)
      find_package(Kokkos 5 QUIET CONFIG REQUIRED PATHS ${private_kokkos} NO_DEFAULT_PATH)
    endif()
  endif()
endif()

if(Kokkos_FOUND)
  message(STATUS "Kokkos ${Kokkos_VERSION}: ${Kokkos_DIR}")
else()
  set(SWARF_KOKKOS_VERSION 5.1.1)
  set(SWARF_KOKKOS_SHA256 8bdbee0f0ac383436743ad8a9e3e928705b34b31a25a92dc5179c52a3aa98519)
  message(STATUS "Kokkos ${SWARF_KOKKOS_VERSION}: upstream release, built here "
                 "(without network: -DFETCHCONTENT_SOURCE_DIR_KOKKOS=<an unpacked release>)")
  include(FetchContent)
  # A GPU backend is chosen by the user (preset cuda); the host side is always OpenMP.
  set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "")
  if(NOT SWARF_PORTABLE)
    set(Kokkos_ARCH_NATIVE ON CACHE BOOL "")
  endif()
  FetchContent_Declare(Kokkos SYSTEM # at this place only: CMake 3.25 hands it on to the keyword before it
    URL https://github.com/kokkos/kokkos/releases/download/${SWARF_KOKKOS_VERSION}/kokkos-${SWARF_KOKKOS_VERSION}.tar.gz
    URL_HASH SHA256=${SWARF_KOKKOS_SHA256}
    DOWNLOAD_EXTRACT_TIMESTAMP OFF)
  FetchContent_MakeAvailable(Kokkos)
endif()
target_link_libraries(swarf_kokkos INTERFACE Kokkos::kokkos)

# The runtime beside a private Kokkos is newer than the system's: programs are bound to it by rpath and loader,
# and the linker, which sees the older one, must not insist on every symbol.
set(runtime "${SWARF_PREFIX}/runtime")
cmake_path(IS_PREFIX SWARF_PREFIX "${Kokkos_DIR}" NORMALIZE kokkos_is_private)
if(kokkos_is_private AND EXISTS "${runtime}/loader")
  set(SWARF_PRIVATE_RUNTIME ${runtime})
  # A target with the property SWARF_PACKED looks for them where the Debian package puts them (Pack.cmake).
  set(home $<IF:$<BOOL:$<TARGET_PROPERTY:SWARF_PACKED>>,/usr/lib/swarf,${runtime}>)
  target_link_options(swarf_kokkos INTERFACE
    LINKER:--disable-new-dtags,-rpath,${home}
    LINKER:--allow-shlib-undefined
    LINKER:--dynamic-linker,${home}/loader)
  install(CODE "message(STATUS \"The installed swarf stays bound to the private Kokkos in ${SWARF_PREFIX}: keep it\")")
endif()
