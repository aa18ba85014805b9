# cmake -D ROOT=folder -D FILES=list -D OUTPUT=file.cpp -P HashSources.cmake: the script behind fulbito_source_hashes.
# A line of the list is a group and a path from the root. The hash of a group is the first half of the SHA-256 of its
# lines "path SHA-256", sorted by their bytes.
cmake_minimum_required(VERSION 3.22)

file(STRINGS "${FILES}" entries)
list(SORT entries COMPARE STRING)
set(groups "")
foreach(entry IN LISTS entries)
  string(REGEX REPLACE " .*" "" group "${entry}")
  string(REGEX REPLACE "^[^ ]+ " "" path "${entry}")
  file(SHA256 "${ROOT}/${path}" digest)
  string(APPEND text_${group} "${path} ${digest}\n")
  list(APPEND groups ${group})
endforeach()
list(REMOVE_DUPLICATES groups)

set(table "")
foreach(group IN LISTS groups)
  string(SHA256 digest "${text_${group}}")
  string(SUBSTRING "${digest}" 0 32 digest)
  string(APPEND table "    {\"${group}\", \"${digest}\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from the sources that it stands for.
#include \"tournament/identity/built_sources.hpp\"

namespace fulbito {
namespace {
constexpr SourceHash kSources[] = {
${table}};
}  // namespace

std::span<const SourceHash> builtSources() { return kSources; }
}  // namespace fulbito
")
