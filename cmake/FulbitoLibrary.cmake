# One option set for everything that state can depend on: baseline x86-64, no fused multiply-add, no fast-math.
# Results are promised bit for bit, so these are not left to the user's CMAKE_CXX_FLAGS.
include(CheckIPOSupported)
include(FulbitoUnity)

function(fulbito_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE
    -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<BOOL:${FULBITO_WERROR}>:-Werror>)
  if(CMAKE_UNITY_BUILD)
    fulbito_unity_groups(${target})
    # Of types in a header that use unnamed namespaces; g++ takes the files of a group for headers.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# fulbito_library(<name> SOURCES <files...> [PUBLIC <libs...>] [PRIVATE <libs...>])
# makes the static library fulbito_<name> with the alias fulbito::<name>.
function(fulbito_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target fulbito_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(fulbito::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:include>
    $<INSTALL_INTERFACE:include/fulbito>)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  fulbito_options(${target})
  set_property(GLOBAL APPEND PROPERTY FULBITO_LIBRARIES ${target})
endfunction()
