# The target pantin::lua_library: Lua compiled as C++, so that an error unwinds C++ frames. Static where there is a static
# one, so that its `^` calls our pow.
find_package(PkgConfig REQUIRED)
pkg_check_modules(PANTIN_LUA REQUIRED lua5.4-c++)
pkg_get_variable(PANTIN_LUA_LIBDIR lua5.4-c++ libdir)
find_library(PANTIN_LUA_STATIC liblua5.4-c++.a HINTS ${PANTIN_LUA_LIBDIR})
mark_as_advanced(PANTIN_LUA_STATIC)
add_library(pantin::lua_library INTERFACE IMPORTED GLOBAL)
target_include_directories(pantin::lua_library INTERFACE ${PANTIN_LUA_INCLUDE_DIRS})
if(PANTIN_LUA_STATIC)
  target_link_libraries(pantin::lua_library INTERFACE ${PANTIN_LUA_STATIC} m ${CMAKE_DL_LIBS})
else()
  target_link_libraries(pantin::lua_library INTERFACE ${PANTIN_LUA_LINK_LIBRARIES})
endif()
