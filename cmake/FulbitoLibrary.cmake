# One set of options for all code that state can depend on: baseline x86-64, no fused multiply-add, no fast-math.
# Results must be equal bit for bit, so these options are not left to the user's CMAKE_CXX_FLAGS.
include(CheckIPOSupported)
include(FulbitoUnity)

function(fulbito_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE
    -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<BOOL:${FULBITO_WERROR}>:-Werror>
    # No function is replaced at load time, so g++ may inline them, as clang does.
    $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  if(CMAKE_UNITY_BUILD)
    fulbito_unity_groups(${target})
    # g++ warns about types in headers that use unnamed namespaces, and takes the files of a group for headers.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# fulbito_library(<name> [COMPONENT <name> | INTERNAL] SOURCES <files...> [PUBLIC <libs...>] [PRIVATE <libs...>])
# creates the static library fulbito_<name> with the alias fulbito::<name>. Targets that link it see the public
# headers (sdk/include); within the project, all other headers too.
#   COMPONENT  the name that users pass to find_package and link as fulbito::<component>; named after its header
#   INTERNAL   part of the program only: not installed
# A library with neither is installed because a component needs it.
function(fulbito_library name)
  cmake_parse_arguments(ARG "INTERNAL" "COMPONENT" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target fulbito_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(fulbito::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk/include>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:include>)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  fulbito_options(${target})
  if(ARG_COMPONENT)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${ARG_COMPONENT})
    if(NOT ARG_COMPONENT STREQUAL name)
      add_library(fulbito::${ARG_COMPONENT} ALIAS ${target})
    endif()
    set_property(GLOBAL APPEND PROPERTY FULBITO_COMPONENTS ${ARG_COMPONENT})
  endif()
  if(NOT ARG_INTERNAL)
    set_property(GLOBAL APPEND PROPERTY FULBITO_LIBRARIES ${target})
  endif()
endfunction()
