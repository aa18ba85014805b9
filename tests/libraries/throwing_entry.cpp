// A library that breaks the rule that no exception leaves a function: its entry throws.
#include "fulbito/team.h"

const fulbito_library* fulbito_library_entry() { throw 1; }
