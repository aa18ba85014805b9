/* A team that logs which of the files in "paths.txt", in its working directory, it can read, and then
 * refuses. */
#include <stdio.h>
#include <string.h>

#include "fulbito/team.h"

static void tell(const fulbito_host* host, const char* path) {
  char line[1100];
  FILE* file = fopen(path, "r");
  snprintf(line, sizeof line, "%s %s", file != NULL ? "reads" : "lacks", path);
  host->log(host, line);
  if (file != NULL) fclose(file);
}

static void* create(const fulbito_host* host, const double* values, const char* navigator) {
  char path[1024];
  FILE* paths = fopen("paths.txt", "r");
  (void)values;
  (void)navigator;
  if (paths == NULL) return NULL;
  while (fgets(path, sizeof path, paths) != NULL) {
    path[strcspn(path, "\n")] = '\0';
    tell(host, path);
  }
  fclose(paths);
  return NULL;
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
  (void)command;
  return 0;
}

static const fulbito_library kLibrary = {FULBITO_ABI, sizeof(fulbito_library),
                                         "reading",   NULL,
                                         NULL,        NULL,
                                         0,           0,
                                         NULL,        create,
                                         destroy,     begin,
                                         decide,      NULL};

FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) { return &kLibrary; }
