# fulbito_team_values(<output.cpp> <options of sdk/values/generate.py...>): creates a source file from the description
# of team values.
find_program(FULBITO_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(FULBITO_PYTHON python3 REQUIRED)

function(fulbito_team_values output)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/sdk/values/*.py ${PROJECT_SOURCE_DIR}/sdk/values/values.toml)
  add_custom_command(OUTPUT ${output}
    COMMAND ${FULBITO_PYTHON} -B ${PROJECT_SOURCE_DIR}/sdk/values/generate.py ${ARGN} --to ${output}
    DEPENDS ${sources}
    COMMENT "Generating ${output}"
    VERBATIM)
endfunction()
