# The package: the program, its decks, and for other programs in C++ swarf::kernels and swarf::simulation. Headers of
# include/swarf keep their path; those of the rooms, "src/ROOM/NAME.hpp", lie below include/swarf/rooms.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/swarf)
set(exported_rooms files units deck geometry tool scene output simulation)
list(TRANSFORM exported_rooms PREPEND swarf_ OUTPUT_VARIABLE exported)

install(TARGETS swarf RUNTIME COMPONENT program)
install(DIRECTORY inputs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/swarf/inputs COMPONENT program)

foreach(target IN ITEMS swarf_flags swarf_kokkos swarf_kernels LISTS exported)
  string(REPLACE swarf_ "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  add_library(swarf::${name} ALIAS ${target})
endforeach()
install(TARGETS swarf_flags swarf_kokkos swarf_kernels ${exported} EXPORT swarfTargets ARCHIVE COMPONENT development)
install(EXPORT swarfTargets NAMESPACE swarf:: DESTINATION ${package} COMPONENT development)

set(SWARF_REAL_BITS 64)
if(SWARF_FLOAT)
  set(SWARF_REAL_BITS 32)
endif()
set(SWARF_CONFIG_ONE_LANE ${SWARF_ONE_LANE})
set(SWARF_CONFIG_PICTURES ${SWARF_PICTURES})
configure_file(cmake/config.hpp.in ${PROJECT_BINARY_DIR}/package/config.hpp @ONLY)
configure_package_config_file(cmake/swarfConfig.cmake.in ${PROJECT_BINARY_DIR}/package/swarfConfig.cmake
  INSTALL_DESTINATION ${package})
# Before 1.0 a new minor version may change anything.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/swarfConfigVersion.cmake COMPATIBILITY SameMinorVersion)

install(DIRECTORY include/swarf DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/package/config.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swarf
  COMPONENT development)
foreach(room IN LISTS exported_rooms)
  install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swarf/rooms/src COMPONENT development
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/package/swarfConfig.cmake ${PROJECT_BINARY_DIR}/package/swarfConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)
