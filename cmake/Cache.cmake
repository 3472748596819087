# ccache, where it is installed and nobody has chosen otherwise: a second build of the same sources takes seconds. It needs
# to be told that a precompiled header may be looked into, and that a time in one does not matter.
find_program(SWARF_CCACHE ccache)
if(PROJECT_IS_TOP_LEVEL AND SWARF_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT DEFINED ENV{CMAKE_CXX_COMPILER_LAUNCHER})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${SWARF_CCACHE})
endif()
