# Target deb: a Debian package of the program, its decks and its Python package. The private Kokkos and the runtime beside
# it go along, into /usr/lib/swarf, since Debian 12 has neither; everything else is Debian's own, by Depends. Its program
# is linked apart, because the path of the loader is part of it.
add_executable(swarf_packed EXCLUDE_FROM_ALL)
target_link_libraries(swarf_packed PRIVATE swarf_main)
set_target_properties(swarf_packed PROPERTIES OUTPUT_NAME swarf RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/packed
  SWARF_PACKED ON BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH /usr/lib/swarf INSTALL_RPATH_USE_LINK_PATH OFF)
target_link_options(swarf_packed PRIVATE -s)

set(to COMPONENT packed EXCLUDE_FROM_ALL)
install(TARGETS swarf_packed RUNTIME DESTINATION bin ${to})
install(DIRECTORY inputs/ DESTINATION share/swarf/inputs ${to})
install(DIRECTORY python/swarf DESTINATION lib/python3/dist-packages ${to} PATTERN __pycache__ EXCLUDE)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/swarf ${to})
install(FILES LICENSE DESTINATION share/doc/swarf RENAME copyright ${to})
if(SWARF_PRIVATE_RUNTIME)
  file(GLOB kokkos_libraries ${SWARF_PREFIX}/usr/lib/*/libkokkos*.so.*)
  install(DIRECTORY ${SWARF_PRIVATE_RUNTIME}/ DESTINATION lib/swarf ${to} USE_SOURCE_PERMISSIONS PATTERN "*.py" EXCLUDE)
  install(FILES ${kokkos_libraries} DESTINATION lib/swarf ${to})
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};swarf;packed;/")
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # or cpack would build the tests first
set(CPACK_PACKAGE_CONTACT "the swarf authors <swarf@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "micro end milling by particles and finite elements")
set(processors "Built with SWARF_PORTABLE: runs on every processor of its architecture.")
if(NOT SWARF_PORTABLE)
  set(processors "Built for the processor that it was built on, and for those that have its instructions.")
endif()
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Particles (SPH) tied to hexahedra (FEM), \
a rigid tool, Johnson-Cook plasticity and heat.\n${processors}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-numpy, python3-h5py, python3-matplotlib")
if(SWARF_PICTURES)
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", xvfb, libgl1-mesa-dri")
endif()
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/pack_depends.cmake)
set(CPACK_SWARF_PROGRAM ${PROJECT_BINARY_DIR}/packed/swarf)
set(CPACK_SWARF_ARCHITECTURE ${CMAKE_LIBRARY_ARCHITECTURE}) # "x86_64-linux-gnu"
include(CPack)

add_custom_target(deb COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
  DEPENDS swarf_packed WORKING_DIRECTORY ${PROJECT_BINARY_DIR} USES_TERMINAL)
