/* @NAME@: a team for Fulbito in C99. `make` builds it, `make test` plays it against `idle`, and
 *
 *     fulbito match ./team.so classic --view
 *
 * shows it. Units are SI. Your own goal is at -x, whatever the colour. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fulbito/team.h"

typedef struct team {
  fulbito_match_info info;
} team;

static void* create(const fulbito_host* host, const double* values, const char* navigator) {
  (void)host, (void)values, (void)navigator;
  return calloc(1, sizeof(team));
}

static void destroy(void* self) { free(self); }

static int32_t begin(void* self, const fulbito_match_info* info) {
  ((team*)self)->info = *info;
  return 0;
}

static double limit(double value, double most) { return fmax(-most, fmin(most, value)); }

static double wrap(double angle) { return remainder(angle, 2.0 * 3.14159265358979323846); }

/* Drives toward a place with the nearer end in front, slower while that end does not face the place. */
static void drive(const team* self, const fulbito_robot* robot, double x, double y, double slow_within,
                  fulbito_robot_command* command) {
  const double dx = x - robot->position.x, dy = y - robot->position.y;
  const double fastest = self->info.robot.max_wheel_speed * self->info.robot.wheel_radius;
  double error = wrap(atan2(dy, dx) - robot->heading);
  double speed = fastest;
  if (slow_within > 0.0) speed *= fmin(1.0, hypot(dx, dy) / slow_within);
  if (fabs(error) > 3.14159265358979323846 / 2) {
    error = wrap(error + 3.14159265358979323846);
    speed = -speed;
  }
  command->kind = FULBITO_BY_TWIST;
  command->twist.linear = speed * fmax(0.0, cos(error));
  command->twist.angular = 8.0 * error;
}

/* The keeper stays on a line in front of the goal, level with the ball. */
static void keep(const team* self, const fulbito_observation* seen, fulbito_robot_command* command) {
  const double x = -self->info.field.length / 2 + self->info.robot.length;
  const double y = limit(seen->ball.position.y, self->info.field.goal_width / 2);
  drive(self, &seen->own[0], x, y, 0.1, command);
}

/* The attacker drives behind the ball first, round it if needed, then through it toward the goal. */
static void attack(const team* self, const fulbito_observation* seen, int i, fulbito_robot_command* command) {
  const fulbito_robot* robot = &seen->own[i];
  const fulbito_vec2 ball = seen->ball.position;
  const double gx = self->info.field.length / 2 - ball.x, gy = -ball.y, far = fmax(hypot(gx, gy), 1e-6);
  const double wx = gx / far, wy = gy / far; /* unit vector to the goal */
  const double dx = ball.x - robot->position.x, dy = ball.y - robot->position.y;
  const double behind = dx * wx + dy * wy, beside = dx * wy - dy * wx;
  const double size = self->info.robot.length;
  if (behind > 0.0 && fabs(beside) < size / 2) {
    drive(self, robot, ball.x + 0.2 * wx, ball.y + 0.2 * wy, 0.0, command);
  } else if (behind > size) {
    drive(self, robot, ball.x - 1.5 * size * wx, ball.y - 1.5 * size * wy, 0.0, command);
  } else {
    /* Past the ball, on the side where the robot is. */
    const double side = beside > 0.0 ? 1.5 * size : -1.5 * size;
    drive(self, robot, ball.x - 2.0 * size * wx - side * wy, ball.y - 2.0 * size * wy + side * wx, 0.0, command);
  }
}

/* The supporter stays behind the ball on the other side, in case the attacker loses it. */
static void support(const team* self, const fulbito_observation* seen, int i, fulbito_robot_command* command) {
  drive(self, &seen->own[i], seen->ball.position.x - 0.35, -seen->ball.position.y / 2, 0.2, command);
}

static int nearest(const fulbito_observation* seen) {
  int best = -1;
  double least = INFINITY;
  for (int i = 1; i < seen->team_size; ++i) {
    const fulbito_robot* robot = &seen->own[i];
    const double far =
        hypot(robot->position.x - seen->ball.position.x, robot->position.y - seen->ball.position.y);
    if (robot->present && far < least) best = i, least = far;
  }
  return best;
}

static int32_t decide(void* self, const fulbito_observation* seen, fulbito_team_command* command) {
  const int attacker = nearest(seen);
  for (int i = 0; i < seen->team_size; ++i) {
    if (!seen->own[i].present) continue;
    if (i == 0) {
      keep(self, seen, &command->robots[i]);
    } else if (i == attacker) {
      attack(self, seen, i, &command->robots[i]);
    } else {
      support(self, seen, i, &command->robots[i]);
    }
  }
  return 0;
}

FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) {
  static const fulbito_library library = {.abi_version = FULBITO_ABI,
                                          .struct_size = sizeof(fulbito_library),
                                          .name = "@NAME@",
                                          .version = "1.0",
                                          .summary = "a keeper, an attacker and a supporter",
                                          .create = create,
                                          .destroy = destroy,
                                          .begin = begin,
                                          .decide = decide};
  return &library;
}
