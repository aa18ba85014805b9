# fulbito_source_hashes(<list> <output.cpp>): creates a source file with a hash for each group of sources in the list,
# again whenever a source changes. A line of the list is a group and a file or folder of the project. The longest
# path that contains a file decides on its group; the group `none` has no hash. Hashes depend only on paths from the
# root and on contents, so equal sources have equal hashes on every machine.
set(FULBITO_HASH_SOURCES ${CMAKE_CURRENT_LIST_DIR}/HashSources.cmake)

function(fulbito_source_hashes list output)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} entries REGEX "^[^#]")
  set(lines "")
  set(depends "")
  foreach(entry IN LISTS entries)
    string(REGEX REPLACE " .*" "" group "${entry}")
    string(REGEX REPLACE "^[^ ]+ " "" path "${entry}")
    if(group STREQUAL "none")
      continue()
    endif()
    set(files ${path})
    if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${path})
      file(GLOB_RECURSE files RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/${path}/*.cpp ${PROJECT_SOURCE_DIR}/${path}/*.hpp
        ${PROJECT_SOURCE_DIR}/${path}/*.h ${PROJECT_SOURCE_DIR}/${path}/*.def ${PROJECT_SOURCE_DIR}/${path}/*.py)
      foreach(other IN LISTS entries)
        string(REGEX REPLACE "^[^ ]+ " "" inner "${other}")
        if(inner MATCHES "^${path}/")
          string(REPLACE "." "\\." inner "${inner}")
          list(FILTER files EXCLUDE REGEX "^${inner}(/|$)")
        endif()
      endforeach()
    endif()
    foreach(file IN LISTS files)
      string(APPEND lines "${group} ${file}\n")
      list(APPEND depends ${PROJECT_SOURCE_DIR}/${file})
    endforeach()
  endforeach()
  file(GENERATE OUTPUT ${output}.list CONTENT "${lines}")
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D "ROOT=${PROJECT_SOURCE_DIR}" -D "FILES=${output}.list" -D "OUTPUT=${output}"
      -P ${FULBITO_HASH_SOURCES}
    DEPENDS ${depends} ${output}.list ${FULBITO_HASH_SOURCES}
    COMMENT "Hashing the sources that determine matches"
    VERBATIM)
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
