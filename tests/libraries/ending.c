/* A team that fails, or ends its process, in the call that its parameters name. */
#define _GNU_SOURCE
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fulbito/team.h"

enum { kFail, kExit, kQuickExit, kExitOfThread, kAbort, kCrash, kHardExit, kLastExit, kExitOfChild };
enum { kCreate, kDecide, kPlace, kReady, kDestroy };

static const char* const kWays[] = {"fail",  "exit",      "quick-exit", "thread", "abort",
                                    "crash", "hard-exit", "last-exit",  "child"};
static const char* const kPlaces[] = {"create", "decide", "place", "ready", "destroy"};
static const fulbito_parameter kParameters[] = {
    {"how", NULL, NULL, kWays, 9, FULBITO_CHOICE, 0.0, 0.0, 8.0},
    {"where", NULL, NULL, kPlaces, 5, FULBITO_CHOICE, 1.0, 0.0, 4.0},
    {"at", NULL, "which call of that function, from 1", NULL, 0, FULBITO_INTEGER, 1.0, 1.0, 1000.0},
};

struct team {
  int how, where, at, calls;
};

static void* exitElsewhere(void* unused) {
  exit(0);
  return unused;
}

static int32_t end(int how) {
  pthread_t thread;
  switch (how) {
    case kExit:
      exit(0);
    case kQuickExit:
      quick_exit(0);
    case kExitOfThread:
      if (pthread_create(&thread, NULL, exitElsewhere, NULL) == 0) pthread_join(thread, NULL);
      return 0;
    case kAbort:
      abort();
    case kCrash:
      *(volatile int*)0 = 1;
      return 0;
    case kHardExit:
      _exit(0);
    case kLastExit:
      _Exit(0);
    case kExitOfChild:
      if (fork() == 0) _exit(0);
      wait(NULL);
      return 0;
    default:
      return 9;
  }
}

static int32_t called(struct team* team, int where) {
  if (team->where != where || ++team->calls != team->at) return 0;
  return end(team->how);
}

static void* create(const fulbito_host* host, const double* values, const char* navigator) {
  struct team* team = calloc(1, sizeof *team);
  (void)host;
  (void)navigator;
  if (team == NULL) return NULL;
  team->how = (int)values[0];
  team->where = (int)values[1];
  team->at = (int)values[2];
  called(team, kCreate);
  return team;
}

static void destroy(void* team) {
  called(team, kDestroy);
  free(team);
}

static int32_t begin(void* team, const fulbito_match_info* info) {
  (void)team;
  (void)info;
  return 0;
}

static int32_t decide(void* team, const fulbito_observation* seen, fulbito_team_command* command) {
  (void)seen;
  command->robots[0].kind = FULBITO_BY_WHEELS;
  command->robots[0].wheels.left = 3.0;
  command->robots[0].wheels.right = 5.0;
  return called(team, kDecide);
}

static int32_t place(void* team, const fulbito_placement_request* request, fulbito_placement* placement) {
  (void)request;
  (void)placement;
  return called(team, kPlace);
}

static int32_t ready(void* team, const fulbito_observation* seen) {
  (void)seen;
  return called(team, kReady);
}

static const void* extension(const char* name) {
  static const fulbito_restarts restarts = {place, NULL, ready, NULL};
  return strcmp(name, FULBITO_EXT_RESTARTS) == 0 ? &restarts : NULL;
}

static const fulbito_library kLibrary = {FULBITO_ABI, sizeof(fulbito_library),
                                         "ending",    NULL,
                                         NULL,        kParameters,
                                         3,           0,
                                         NULL,        create,
                                         destroy,     begin,
                                         decide,      extension};

FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) { return &kLibrary; }
