# fulbito_embed(<output.cpp> <symbol> <files...>): writes a source file that defines
#   std::span<const fulbito::EmbeddedFile> <symbol>();
# with each file's text, named by its file name without the ending, its kind by its folder.
# The texts go in as bytes: quoting, semicolons and generator expressions in them cannot go wrong.
function(fulbito_embed output symbol)
  set(text "// Generated from the preset files; edit those.\n#include \"engine/core/config/embedded_files.hpp\"\n\nnamespace fulbito {\nnamespace {\n")
  set(table "")
  set(index 0)
  foreach(file IN LISTS ARGN)
    get_filename_component(absolute ${file} ABSOLUTE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${absolute})
    file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${file} bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
    get_filename_component(name ${file} NAME_WLE)
    get_filename_component(whole ${file} NAME)
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(kind "${folder}" NAME)
    # The closing zero keeps an empty file from making an empty array; it is not part of the text.
    string(APPEND text "constexpr char kText${index}[] = {${bytes}0};\n")
    string(APPEND table "    {\"${kind}\", \"${name}\", {kText${index}, sizeof(kText${index}) - 1}, \"${whole}\"},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND text "constexpr EmbeddedFile kFiles[] = {\n${table}};\n}  // namespace\n\nstd::span<const EmbeddedFile> ${symbol}() { return kFiles; }\n}  // namespace fulbito\n")
  file(GENERATE OUTPUT ${output} CONTENT "${text}")
endfunction()
