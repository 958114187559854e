# Finds the shared library and its header under one prefix: PREFIX/lib (bin on Windows), PREFIX/include, and this file in PREFIX/lib/cmake/football_physics.
get_filename_component(_football_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(NOT TARGET football_physics::football_physics)
  add_library(football_physics::football_physics SHARED IMPORTED)
  set_target_properties(football_physics::football_physics PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${_football_prefix}/include")
  if(WIN32)
    set_target_properties(football_physics::football_physics PROPERTIES
      IMPORTED_LOCATION "${_football_prefix}/bin/football_physics.dll" IMPORTED_IMPLIB "${_football_prefix}/lib/football_physics.lib")
  elseif(APPLE)
    set_target_properties(football_physics::football_physics PROPERTIES IMPORTED_LOCATION "${_football_prefix}/lib/libfootball_physics.dylib")
  else()
    set_target_properties(football_physics::football_physics PROPERTIES
      IMPORTED_LOCATION "${_football_prefix}/lib/libfootball_physics.so" IMPORTED_SONAME libfootball_physics.so)
  endif()
endif()
