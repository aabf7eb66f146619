# Plugins: shared libraries with node types, and programs that load them (bt_core/engine/plugin.h).
# There is one engine in a process: it lies in the program, a plugin uses the program's.

# coppice_add_plugin(NAME SOURCES...)   builds NAME.so
function(coppice_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_include_directories(${name} PRIVATE
    $<TARGET_PROPERTY:coppice::bt_core,INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_features(${name} PRIVATE cxx_std_17)
  set_target_properties(${name} PROPERTIES PREFIX "")
endfunction()

# coppice_load_plugins(PROGRAM)   the program, which links coppice::bt_core, can load plugins
function(coppice_load_plugins program)
  set_target_properties(${program} PROPERTIES ENABLE_EXPORTS ON)
  target_link_libraries(${program} PRIVATE
    -Wl,--whole-archive $<TARGET_FILE:coppice::bt_core> -Wl,--no-whole-archive)
endfunction()
