/* A team that leaves other floating-point modes behind in every function, and tells in which mode it was
 * called. Also built with -ffast-math, whose start-up code sets FTZ and DAZ. */
#include <fenv.h>
#include <string.h>
#include <xmmintrin.h>

#include "fulbito/team.h"

static unsigned called_with;

static void disturb(void) {
  called_with = _mm_getcsr() & 0xffc0u;
  fesetround(FE_UPWARD);
  _mm_setcsr(_mm_getcsr() | 0x8040u);
}

static void* create(const fulbito_host* host, const double* values, const char* navigator) {
  (void)values;
  (void)navigator;
  disturb();
  return (void*)(uintptr_t)host;
}
static void destroy(void* team) {
  (void)team;
  disturb();
}
static int32_t begin(void* team, const fulbito_match_info* info) {
  (void)team;
  (void)info;
  disturb();
  return 0;
}
static int32_t decide(void* team, const fulbito_observation* seen, fulbito_team_command* command) {
  (void)team;
  (void)seen;
  disturb();
  command->robots[0].wheels.left = (double)called_with;
  return 0;
}
static int32_t place(void* team, const fulbito_placement_request* request, fulbito_placement* placement) {
  (void)team;
  (void)request;
  (void)placement;
  disturb();
  return 0;
}
static const fulbito_restarts kRestarts = {place, NULL, NULL, NULL};
static const void* extension(const char* name) {
  disturb();
  return strcmp(name, FULBITO_EXT_RESTARTS) == 0 ? &kRestarts : NULL;
}

static const fulbito_library kLibrary = {FULBITO_ABI,
                                         sizeof(fulbito_library),
                                         "float-modes",
                                         NULL,
                                         NULL,
                                         NULL,
                                         0,
                                         0,
                                         NULL,
                                         create,
                                         destroy,
                                         begin,
                                         decide,
                                         extension};

FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) {
  disturb();
  return &kLibrary;
}
