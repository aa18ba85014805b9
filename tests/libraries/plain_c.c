/* A team in C99 that uses all of the interface, and no C++. */
#include <stdlib.h>
#include <string.h>

#include "fulbito/team.h"

struct team {
  const fulbito_host* host;
  double gain;   /* parameter 0 */
  double offset; /* parameter 1 */
  double eager;  /* parameter 2 */
  double style;  /* parameter 3 */
  char navigator[64];
  uint64_t first_random;
  int64_t stops, readies, ends, rules_length;
  double dt;
  const fulbito_curve_widening* slip;
};

static const char* const kStyles[] = {"calm", "wild"};
static const fulbito_parameter kParameters[] = {
    {"gain", "1/s", "how strongly it turns", NULL, 0, FULBITO_NUMBER, 2.5, 0.0, 10.0},
    {"offset", NULL, "added to the roles", NULL, 0, FULBITO_INTEGER, 1.0, 0.0, 7.0},
    {"eager", NULL, "whether it drives", NULL, 0, FULBITO_FLAG, 1.0, 0.0, 0.0},
    {"style", NULL, "how it drives", kStyles, 2, FULBITO_CHOICE, 1.0, 0.0, 0.0},
};

static void* create(const fulbito_host* host, const double* values, const char* navigator) {
  struct team* team = NULL;
  if (values[0] == 10.0) {
    host->log(host, "a gain of 10 is too much");
    return NULL;
  }
  team = calloc(1, sizeof *team);
  if (team == NULL) return NULL;
  team->host = host;
  team->gain = values[0];
  team->offset = values[1];
  team->eager = values[2];
  team->style = values[3];
  strncpy(team->navigator, navigator, sizeof team->navigator - 1);
  return team;
}

static void destroy(void* self) { free(self); }

static int32_t begin(void* self, const fulbito_match_info* info) {
  struct team* team = self;
  const char* rules = team->host->get_extension(team->host, FULBITO_EXT_RULES_TEXT);
  team->first_random = team->host->random(team->host);
  team->rules_length = rules == NULL ? -1 : (int64_t)strlen(rules);
  team->dt = info->dt;
  team->slip = team->host->get_extension(team->host, FULBITO_EXT_CURVE_WIDENING);
  team->host->log(team->host, "ready");
  return team->host->get_extension(team->host, "fulbito.unknown/1") == NULL ? 0 : 1;
}

/* Robot 0 by wheels, 1 by a twist, 2 by a navigator; what it knows shows in the numbers. */
static int32_t decide(void* self, const fulbito_observation* seen, fulbito_team_command* command) {
  struct team* team = self;
  command->robots[0].wheels.left = team->gain;
  command->robots[0].wheels.right = team->eager + 2.0 * team->style;
  command->robots[1].kind = FULBITO_BY_TWIST;
  command->robots[1].twist.linear = seen->ball.position.x;
  command->robots[1].twist.angular = (double)(team->first_random % 1000u);
  command->robots[2].kind = FULBITO_BY_GO_TO;
  command->robots[2].go_to.position = seen->own[2].position;
  if (team->slip != NULL && team->slip->curve_widening > 0.0)
    command->robots[2].go_to.tolerance = team->slip->curve_widening + 10.0 * team->slip->curve_widening_rise;
  command->robots[0].role = (uint32_t)team->offset;
  if (command->drawing_capacity > 0) {
    fulbito_drawing* drawing = &command->drawings[command->drawing_count++];
    memset(drawing, 0, sizeof *drawing);
    drawing->kind = FULBITO_TEXT;
    strcpy(drawing->text, "here");
  }
  return 0;
}

static const char* navigatorName(void* self, uint32_t index) {
  struct team* team = self;
  return index == 0 ? team->navigator : NULL;
}
static const fulbito_navigator_names kNames = {navigatorName};

static int32_t place(void* self, const fulbito_placement_request* request, fulbito_placement* placement) {
  (void)self;
  placement->robots.present[1] = 1;
  placement->robots.pose[1].position.x = request->defaults.pose[1].position.x - 0.1;
  placement->robots.pose[1].heading = 0.5;
  placement->has_ball = request->kind == FULBITO_GOAL_KICK;
  placement->ball.y = request->delay;
  return 0;
}
static int32_t stopped(void* self, const fulbito_stop* stop) {
  ((struct team*)self)->stops += stop->cause.clause[0] != 0;
  return 0;
}
static int32_t ready(void* self, const fulbito_observation* seen) {
  ((struct team*)self)->readies += seen->team_size > 0;
  return 0;
}
static int32_t ended(void* self, const fulbito_end* end) {
  struct team* team = self;
  char line[64] = "ended after ....... stops";
  int64_t stops = team->stops;
  int i = 18;
  team->ends += end->reason == FULBITO_PLAYED;
  for (; i >= 12; --i, stops /= 10) line[i] = (char)('0' + stops % 10);
  team->host->log(team->host, line);
  return team->ends == 1 ? 0 : 7;
}
static const fulbito_restarts kRestarts = {place, stopped, ready, ended};

static int32_t exercise(void* self, const fulbito_observation* seen, const fulbito_exercise* task,
                        fulbito_team_command* command, fulbito_vec2* answer) {
  struct team* team = self;
  if (task->kind == FULBITO_TURN) return FULBITO_NO_SKILL;
  command->robots[0].wheels.left = team->dt;
  answer->x = seen->ball.position.x + seen->ball.velocity.x * task->horizon;
  answer->y = task->heading;
  return 0;
}
static const fulbito_exercises kExercises = {exercise};

static const void* extension(const char* name) {
  if (strcmp(name, FULBITO_EXT_NAVIGATOR_NAMES) == 0) return &kNames;
  if (strcmp(name, FULBITO_EXT_RESTARTS) == 0) return &kRestarts;
  if (strcmp(name, FULBITO_EXT_EXERCISES) == 0) return &kExercises;
  return NULL;
}

static const fulbito_library kLibrary = {FULBITO_ABI,
                                         sizeof(fulbito_library),
                                         "plain-c",
                                         "3.1",
                                         "a team in C",
                                         kParameters,
                                         4,
                                         0,
                                         "bezier",
                                         create,
                                         destroy,
                                         begin,
                                         decide,
                                         extension};

const fulbito_library* fulbito_library_entry(void) { return &kLibrary; }
