# cmake -DPROGRAM=<hash program> -DGOLDEN=<file> -P compare.cmake: fails unless the output of the program
# equals the file.
# With UPDATE_GOLDEN=1 in the environment it writes the file instead.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} failed: ${code}")
endif()
if("$ENV{UPDATE_GOLDEN}" STREQUAL "1")
  file(WRITE ${GOLDEN} "${printed}")
endif()
file(READ ${GOLDEN} golden)
if(NOT printed STREQUAL golden)
  message(FATAL_ERROR "The hashes differ from ${GOLDEN}.\nexpected:\n${golden}\nprinted:\n${printed}"
    "If the behaviour was meant to change, run again with UPDATE_GOLDEN=1.")
endif()
