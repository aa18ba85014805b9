/* Libraries that the loader refuses; BROKEN_... says how each is wrong. */
#include <stddef.h>

#include "fulbito/team.h"

#ifndef BROKEN_SYMBOL

static void* create(const fulbito_host* host, const double* values, const char* navigator) {
  (void)values;
  (void)navigator;
#ifdef BROKEN_REFUSAL
  host->log(host, "not today");
  return NULL;
#else
  return (void*)(uintptr_t)host;
#endif
}
static void destroy(void* team) { (void)team; }
static int32_t begin(void* team, const fulbito_match_info* info) {
  (void)team;
  (void)info;
  return 0;
}
static int32_t decide(void* team, const fulbito_observation* seen, fulbito_team_command* command) {
  (void)team;
  (void)seen;
#ifdef BROKEN_DRAWINGS
  command->drawings = (fulbito_drawing*)(uintptr_t)8;
  command->drawing_capacity = 0xffffffffu;
  command->drawing_count = 0xfffffff0u;
#endif
#ifdef BROKEN_KIND
  command->robots[0].kind = 77;
  command->robots[1].role = 4000;
#endif
  (void)command;
#ifdef BROKEN_DECISION
  return 42;
#else
  return 0;
#endif
}

static const fulbito_parameter kParameters[] = {
#ifdef BROKEN_RANGE
    {"gain", NULL, NULL, NULL, 0, FULBITO_NUMBER, 1.0, 2.0, 1.0},
#elif defined(BROKEN_DEFAULT)
    {"gain", NULL, NULL, NULL, 0, FULBITO_NUMBER, 5.0, 0.0, 1.0},
#elif defined(BROKEN_TYPE)
    {"gain", NULL, NULL, NULL, 0, 9, 0.0, 0.0, 1.0},
#elif defined(BROKEN_CHOICES)
    {"gain", NULL, NULL, NULL, 2, FULBITO_CHOICE, 0.0, 0.0, 1.0},
#elif defined(BROKEN_PARAMETER_NAME)
    {"ga=in", NULL, NULL, NULL, 0, FULBITO_NUMBER, 0.0, 0.0, 1.0},
#else
    {"gain", NULL, NULL, NULL, 0, FULBITO_NUMBER, 0.0, 0.0, 1.0},
#endif
};

static const fulbito_library kLibrary = {
#ifdef BROKEN_VERSION
    77,
#else
    FULBITO_ABI,
#endif
#ifdef BROKEN_SIZE
    40,
#else
    sizeof(fulbito_library),
#endif
#ifdef BROKEN_NAME
    "",
#else
    "broken",
#endif
    NULL,   NULL,
#ifdef BROKEN_PARAMETERS
    NULL,
#else
    kParameters,
#endif
#ifdef BROKEN_COUNT
    100000,
#else
    1,
#endif
    0,      NULL, create, destroy, begin,
#ifdef BROKEN_TEAM
    NULL,
#else
    decide,
#endif
    NULL};

FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) {
#ifdef BROKEN_ENTRY
  return kLibrary.name[0] == 'b' ? NULL : &kLibrary;
#else
  return &kLibrary;
#endif
}

#else
int fulbito_some_other_symbol = 1;
#endif
