# fulbito_embed(<output.cpp> <symbol> [HEADER <header> TYPE <type>] <files...>): writes a source file that defines
#   std::span<const fulbito::EmbeddedFile> <symbol>();
# or of another struct <type> of four texts, which <header> declares,
# with each file's text, named by its file name without the ending, its kind by its folder.
# The texts are written as bytes, so that quotes, semicolons and generator expressions in them need no escaping.
function(fulbito_embed output symbol)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "HEADER;TYPE" "")
  if(NOT ARG_HEADER)
    set(ARG_HEADER "engine/core/config/embedded_files.hpp")
    set(ARG_TYPE EmbeddedFile)
  endif()
  set(text "// Generated from the preset files; edit those.\n#include \"${ARG_HEADER}\"\n\nnamespace fulbito {\nnamespace {\n")
  set(table "")
  set(index 0)
  foreach(file IN LISTS ARG_UNPARSED_ARGUMENTS)
    get_filename_component(absolute ${file} ABSOLUTE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${absolute})
    file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${file} bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
    get_filename_component(name ${file} NAME_WLE)
    get_filename_component(whole ${file} NAME)
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(kind "${folder}" NAME)
    # The closing zero avoids an empty array for an empty file; it is not part of the text.
    string(APPEND text "constexpr char kText${index}[] = {${bytes}0};\n")
    string(APPEND table "    {\"${kind}\", \"${name}\", {kText${index}, sizeof(kText${index}) - 1}, \"${whole}\"},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND text "constexpr ${ARG_TYPE} kFiles[] = {\n${table}};\n}  // namespace\n\nstd::span<const ${ARG_TYPE}> ${symbol}() { return kFiles; }\n}  // namespace fulbito\n")
  file(GENERATE OUTPUT ${output} CONTENT "${text}")
endfunction()
