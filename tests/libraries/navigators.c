/* Navigators in C: one per kind of guidance, and wrong ones. It has no team. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fulbito/team.h"

struct navigator {
  double gain; /* parameter 0 */
  fulbito_vec2 path[3];
  double speeds[3];
  fulbito_vec2 goal;
};

static const fulbito_parameter kGain[] = {
    {"gain", "m/s", "speed of the wheels' rims", NULL, 0, FULBITO_NUMBER, 0.5, 0.1, 2.0}};

static void* create(const fulbito_host* host, const double* values) {
  struct navigator* made = calloc(1, sizeof *made);
  (void)host;
  if (made != NULL) made->gain = values[0];
  return made;
}
static void* refuse(const fulbito_host* host, const double* values) {
  (void)values;
  host->log(host, "no licence");
  return NULL;
}
static void destroy(void* navigator) { free(navigator); }
static void reset(void* navigator) { ((struct navigator*)navigator)->goal.x = 0.0; }

static int32_t planField(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  struct navigator* navigator = self;
  navigator->goal = scene->goal;
  guidance->kind = FULBITO_GUIDE_FIELD;
  return 0;
}
static double heading(void* self, fulbito_vec2 point) {
  const struct navigator* navigator = self;
  return atan2(navigator->goal.y - point.y, navigator->goal.x - point.x);
}
static int32_t planPath(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  struct navigator* navigator = self;
  navigator->path[0] = scene->self.position;
  navigator->path[1].x = (scene->self.position.x + scene->goal.x) / 2;
  navigator->path[1].y = (scene->self.position.y + scene->goal.y) / 2;
  navigator->path[2] = scene->goal;
  navigator->speeds[0] = navigator->speeds[1] = navigator->speeds[2] = navigator->gain;
  guidance->kind = FULBITO_GUIDE_PATH;
  guidance->path = navigator->path;
  guidance->point_count = 3;
  guidance->revision = (uint64_t)scene->tick;
  return 0;
}
static int32_t planTimed(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  planPath(self, scene, guidance);
  guidance->kind = FULBITO_GUIDE_TIMED_PATH;
  guidance->speeds = ((struct navigator*)self)->speeds;
  return 0;
}
static int32_t planWheels(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  guidance->kind = FULBITO_GUIDE_WHEELS;
  guidance->wheels.left = ((struct navigator*)self)->gain / 0.026;
  guidance->wheels.right = (double)scene->obstacle_count + scene->robot->wheel_radius + scene->field->length;
  return 0;
}
static int32_t planNan(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  planPath(self, scene, guidance);
  ((struct navigator*)self)->path[1].y = NAN;
  return 0;
}
static int32_t planShort(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  planPath(self, scene, guidance);
  guidance->point_count = 1;
  return 0;
}
static int32_t planUnknown(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  planPath(self, scene, guidance);
  guidance->kind = 9;
  return 0;
}
static int32_t planFails(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  planPath(self, scene, guidance);
  return 1;
}

#define NAVIGATOR(name, speed, make, plan, field) \
  {name, "for tests", "none", kGain, 1, speed, make, destroy, reset, plan, field}
static const fulbito_navigator kNavigators[] = {
    NAVIGATOR("field", 0, create, planField, heading),  NAVIGATOR("path", 0, create, planPath, NULL),
    NAVIGATOR("timed", 1, create, planTimed, NULL),     NAVIGATOR("wheels", 1, create, planWheels, NULL),
    NAVIGATOR("nan", 0, create, planNan, NULL),         NAVIGATOR("short", 0, create, planShort, NULL),
    NAVIGATOR("unknown", 0, create, planUnknown, NULL), NAVIGATOR("fails", 0, create, planFails, NULL),
    NAVIGATOR("no-field", 0, create, planField, NULL),  NAVIGATOR("refused", 0, refuse, planPath, NULL),
    NAVIGATOR("no-plan", 0, create, NULL, NULL),
};
static const fulbito_navigators kAll = {kNavigators, sizeof kNavigators / sizeof *kNavigators, 0};

static const void* extension(const char* name) {
  return strcmp(name, FULBITO_EXT_NAVIGATORS) == 0 ? &kAll : NULL;
}

static const fulbito_library kLibrary = {
    FULBITO_ABI, sizeof(fulbito_library), "navigators", NULL, NULL, NULL, 0, 0, NULL, NULL, NULL, NULL, NULL,
    extension};

FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) { return &kLibrary; }
