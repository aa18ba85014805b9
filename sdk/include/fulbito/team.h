/* The C interface of teams and navigators in shared libraries, for C99 and C++.
 *
 * A library exports one symbol, `fulbito_library_entry`. Its table starts with a version and a size, and
 * grows by extensions: structures that `get_extension` returns by name. Structures of data never change
 * within a version; new data comes by new extensions.
 *
 * Rules for all members:
 * - Units are SI: m, s, kg, rad, m/s, rad/s. Each team sees its own goal at -x. Headings are
 * counter-clockwise, 0 along +x, in [-pi, pi). The origin is the field's centre.
 * - Text is UTF-8 and ends with a zero byte.
 * - Arguments belong to the caller and are valid during the call only. What a library returns belongs to the
 *   library and lives as stated.
 * - Calls of one team or navigator never overlap. Different ones may be called at the same time by different
 *   threads, so a library keeps no variable state outside of them.
 * - Functions that return int32_t return 0, or another number after a failure. A team that fails says why by
 *   `log`. No C++ exception leaves a function.
 * - The simulator sets the floating-point mode (round to nearest, subnormals kept) before every call and
 *   restores its own after it.
 * - Members named `reserved` are 0.
 */
#ifndef FULBITO_TEAM_H
#define FULBITO_TEAM_H

#include <stdint.h>

/* Names as C libraries write them. NOLINTBEGIN(readability-identifier-naming) */

#ifdef __cplusplus
extern "C" {
#define FULBITO_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), #type " has another size")
#else
/* C99 has no static assertion: an array of negative length does not compile. */
#define FULBITO_SIZE(type, bytes) typedef char type##_size_check[sizeof(type) == (bytes) ? 1 : -1]
#endif

/** Makes a function visible to the simulator, also with -fvisibility=hidden. */
#define FULBITO_EXPORT __attribute__((visibility("default")))

/** Version of this interface. The simulator loads libraries of its own version only. */
#define FULBITO_ABI 1u
/** Largest number of robots per team: the length of arrays by robot number. */
#define FULBITO_MAX_ROBOTS 11
/** Length of names and of a drawing's text, the zero byte included. Longer ones are cut. */
#define FULBITO_NAME_SIZE 64

/** Position, distance or velocity in the plane: [m] or [m/s]. */
typedef struct fulbito_vec2 {
  double x; /**< toward the opponents' goal */
  double y; /**< to the left, seen from the own goal */
} fulbito_vec2;
FULBITO_SIZE(fulbito_vec2, 16);

/** Position and heading. */
typedef struct fulbito_pose {
  fulbito_vec2 position; /**< [m] */
  double heading;        /**< [rad] */
} fulbito_pose;
FULBITO_SIZE(fulbito_pose, 24);

/** Rotation of the two wheels; positive drives forward. */
typedef struct fulbito_wheels {
  double left;  /**< [rad/s] */
  double right; /**< [rad/s] */
} fulbito_wheels;
FULBITO_SIZE(fulbito_wheels, 16);

/** Motion of a robot in its own frame. */
typedef struct fulbito_twist {
  double linear;  /**< [m/s] forward */
  double angular; /**< [rad/s] counter-clockwise */
} fulbito_twist;
FULBITO_SIZE(fulbito_twist, 16);

/* ---- What a team knows before the match ---- */

/** Colours of teams. */
enum { FULBITO_BLUE = 0, FULBITO_YELLOW = 1 };

/** The field: a rectangle with two goals and corner triangles. A size of 0 means that the field lacks it. */
typedef struct fulbito_field {
  char name[FULBITO_NAME_SIZE]; /**< name of the preset */
  double length;                /**< [m] x extent */
  double width;                 /**< [m] y extent */
  double goal_width;            /**< [m] y extent of the goal's mouth */
  double goal_depth;            /**< [m] behind the goal line */
  double corner;                /**< [m] legs of the corner triangles */
  double wall_thickness;        /**< [m] */
  double goal_area_width;       /**< [m] y extent */
  double goal_area_depth;       /**< [m] x extent */
  double goal_area_arc_width;   /**< [m] chord of the arc in front of the goal area */
  double goal_area_arc_depth;   /**< [m] depth of the arc beyond the area's front line */
  double big_area_width;        /**< [m] y extent of the larger games' penalty area */
  double big_area_depth;        /**< [m] its x extent */
  double centre_circle_radius;  /**< [m] */
  double penalty_mark;          /**< [m] distance from the centre along x */
  fulbito_vec2 free_ball_mark;  /**< [m] in the first quadrant; the other three are mirrored */
} fulbito_field;
FULBITO_SIZE(fulbito_field, 192);

/** The robots of both teams: a rectangle on two wheels. */
typedef struct fulbito_robot_model {
  char name[FULBITO_NAME_SIZE]; /**< name of the preset */
  double length;                /**< [m] body along its front */
  double width;                 /**< [m] body across */
  double mass;                  /**< [kg] */
  double wheel_radius;          /**< [m] */
  double axle_track;            /**< [m] between wheel centres */
  double max_wheel_speed;       /**< [rad/s] faster commands are clamped */
  double wheel_acceleration;    /**< [m/s^2] driving straight */
  double wheel_braking;         /**< [m/s^2] driving straight */
  double yaw_acceleration;      /**< [rad/s^2] turning in place; 0: from mass and shape */
  double rolling_drag;          /**< [m/s^2] drag that the motors overcome beyond `wheel_acceleration` */
  double longitudinal_grip;     /**< [m/s^2] limit along the wheels */
  double lateral_grip;          /**< [m/s^2] limit across the wheels */
  double spin_slow_speed;       /**< [m/s] rim speed of the first measured spin in place; 0: ideal spins */
  double spin_slow_ratio;       /**< measured over ideal yaw rate at `spin_slow_speed` and below */
  double spin_fast_speed;       /**< [m/s] rim speed of the second measured spin */
  double spin_fast_ratio;       /**< the same at `spin_fast_speed` and above; linear between */
  double friction;              /**< of the body */
  double restitution;           /**< of the body */
} fulbito_robot_model;
FULBITO_SIZE(fulbito_robot_model, 208);

/** The ball. After a kick it slides; then it rolls and slowly stops. */
typedef struct fulbito_ball_model {
  double radius;             /**< [m] */
  double mass;               /**< [kg] */
  double roll_keep;          /**< share of the speed left when sliding becomes rolling */
  double slide_deceleration; /**< [m/s^2] while sliding */
  double roll_deceleration;  /**< [m/s^2] while rolling */
  double stop_speed;         /**< [m/s] slower rolling balls stop */
  double wall_restitution;   /**< at a wall, along the normal */
  double wall_spin_keep;     /**< share of the spin along the normal that survives an impact */
  double robot_restitution;  /**< against robots */
  double friction;           /**< against everything */
} fulbito_ball_model;
FULBITO_SIZE(fulbito_ball_model, 80);

/** Time steps and accuracy of the physics. */
typedef struct fulbito_physics {
  char name[FULBITO_NAME_SIZE]; /**< name of the preset */
  int32_t control_rate;         /**< [Hz] decisions per second */
  int32_t substeps;             /**< physics steps per decision */
  int32_t velocity_iterations;  /**< of the engine */
  int32_t position_iterations;  /**< of the engine */
  uint32_t bullet_ball;         /**< 1: continuous collision of the ball against moving bodies */
  uint32_t reserved;            /**< 0 */
  double contact_depth;         /**< [m] deepest overlap before a step is split; 0: no splits */
  double max_ball_speed;        /**< [m/s] up to this speed the ball does not tunnel */
  double restitution_threshold; /**< [m/s] slower impacts do not bounce */
  double wheel_command_step;    /**< [rad/s] wheel commands are rounded to multiples of this */
} fulbito_physics;
FULBITO_SIZE(fulbito_physics, 120);

/** Tie-breaks after two halves. */
enum { FULBITO_NO_TIE_BREAK = 0, FULBITO_OVERTIME = 1, FULBITO_SHOOT_OUT = 2, FULBITO_BOTH_TIE_BREAKS = 3 };

/** The rules as values that teams need. The host's extension FULBITO_EXT_RULES_TEXT has all of them. */
typedef struct fulbito_rules {
  char name[FULBITO_NAME_SIZE]; /**< name of the preset */
  int32_t team_size;            /**< robots per team */
  int32_t mercy_goals;          /**< lead that ends the match; 0: never */
  int32_t tie_break;            /**< e.g. FULBITO_OVERTIME */
  int32_t overtime_parts;       /**< periods of overtime */
  int32_t attackers_max;        /**< robots allowed in the opponents' goal area; -1: any number */
  int32_t big_attackers_max;    /**< robots allowed in the opponents' big area; -1: any number */
  int32_t defenders_max;        /**< robots allowed in the own goal area with the ball; -1: any number */
  int32_t big_defenders_max;    /**< robots allowed in the own big area with the ball; -1: any number */
  uint8_t swap_sides;           /**< 1: teams change sides at half-time; observations stay mirrored */
  uint8_t golden_goal;          /**< 1: the first goal in overtime ends the match */
  uint8_t hold_robots;          /**< 1: robots cannot move before the signal */
  uint8_t goal_kick_ball_free;  /**< 1: the taker may place the ball anywhere in its goal area */
  uint8_t areas_have_arc;       /**< 1: the goal area includes its arc */
  uint8_t keeper_charging;      /**< 1: charging the keeper is a foul */
  uint8_t pushing;              /**< 1: pushing away from the ball is a foul */
  uint8_t pinning;              /**< 1: pinning the ball to a wall is a foul */
  double half_seconds;          /**< [s] play time of a half */
  double overtime_seconds;      /**< [s] play time of each period of overtime */
  double kick_seconds;          /**< [s] time limit of a kick in a shoot-out */
  double restart_delay;         /**< [s] from the placement to the signal */
  double goal_delay;            /**< [s] the same after a goal */
  double false_start_distance;  /**< [m] a robot this far from its place before the signal has moved */
  double free_ball_distance;    /**< [m] least distance from the ball at a free ball */
  double stuck_seconds;         /**< [s] a ball that stays this long is stuck, outside the goal areas */
  double stuck_area_seconds;    /**< [s] the same in a goal area */
  double stuck_radius;          /**< [m] leaving this circle restarts the count */
  double keeper_hold_seconds;   /**< [s] longest undisputed control by the keeper; 0: no limit */
  double pinned_seconds;        /**< [s] longest time for pinning the ball to a wall */
} fulbito_rules;
FULBITO_SIZE(fulbito_rules, 200);

/** A team's knowledge before the match. */
typedef struct fulbito_match_info {
  uint32_t colour;           /**< FULBITO_BLUE or FULBITO_YELLOW */
  uint32_t left;             /**< 1: it defends the left goal of pictures at first */
  uint64_t seed;             /**< of its random stream; the host's `random` draws from it */
  double dt;                 /**< [s] control period: one decision per period */
  double observation_age;    /**< [s] nominal age of each observation */
  double position_noise;     /**< [m] standard deviation of observed positions */
  double heading_noise;      /**< [rad] standard deviation of observed headings */
  double dropout;            /**< probability per tick that a body is not seen */
  double decision_seconds;   /**< [s] limit of each decision, in wall time; infinity: unlimited */
  double decision_bank;      /**< [s] total time beyond it per period */
  int32_t decisions_held;    /**< late decisions in a row for which the last command stays in force */
  uint32_t reserved;         /**< 0 */
  fulbito_field field;       /**< field of the match */
  fulbito_robot_model robot; /**< robots of both teams */
  fulbito_ball_model ball;   /**< ball of the match */
  fulbito_physics physics;   /**< time steps */
  fulbito_rules rules;       /**< rules of the match */
} fulbito_match_info;
FULBITO_SIZE(fulbito_match_info, 880);

/* ---- What a team sees ---- */

/** A robot as the team sees it. */
typedef struct fulbito_robot {
  uint32_t present;        /**< 0: not on the field; all other members are 0 */
  uint32_t reserved;       /**< 0 */
  fulbito_vec2 position;   /**< [m] */
  double heading;          /**< [rad] */
  fulbito_vec2 velocity;   /**< [m/s] */
  double angular_velocity; /**< [rad/s] */
  fulbito_wheels wheels;   /**< [rad/s] of own robots; 0 for opponents */
} fulbito_robot;
FULBITO_SIZE(fulbito_robot, 72);

/** The ball as the team sees it. Its spin is not observed. */
typedef struct fulbito_ball {
  fulbito_vec2 position; /**< [m] */
  fulbito_vec2 velocity; /**< [m/s] */
} fulbito_ball;
FULBITO_SIZE(fulbito_ball, 32);

/** The kinds of restarts. */
enum {
  FULBITO_KICK_OFF = 0,  /**< from the centre */
  FULBITO_FREE_BALL = 1, /**< from one of four marks, with a robot of each team next to it */
  FULBITO_FREE_KICK = 2, /**< by one team from its mark, after a foul */
  FULBITO_PENALTY = 3,   /**< by one team from its mark, against the keeper alone */
  FULBITO_GOAL_KICK = 4, /**< by one team from its own goal area */
  FULBITO_GIVEN = 5      /**< from a placement by the user or a drill */
};

/** A team's knowledge at one control tick. */
typedef struct fulbito_observation {
  int64_t tick;                          /**< tick of the match that it shows */
  double dt;                             /**< [s] control period */
  fulbito_ball ball;                     /**< the ball */
  double since_restart;                  /**< [s] of play since the signal; negative before it */
  double remaining;                      /**< [s] of play left in the period */
  int32_t team_size;                     /**< robots per team, present or not: 1 ... FULBITO_MAX_ROBOTS */
  int32_t period;                        /**< 1, 2: halves; 3: overtime; 4: shoot-out */
  int32_t own_score;                     /**< goals of the team */
  int32_t opponent_score;                /**< goals against it */
  uint32_t restart;                      /**< the restart that began the present play */
  uint8_t playing;                       /**< 0 while a restart waits for its signal */
  uint8_t restart_is_ours;               /**< 1: the team takes it (a free ball: it attacks that half) */
  uint8_t wants_drawings;                /**< 1: an observer keeps the drawings of this tick */
  uint8_t reserved;                      /**< 0 */
  fulbito_robot own[FULBITO_MAX_ROBOTS]; /**< the team's robots, by number */
  fulbito_robot opponents[FULBITO_MAX_ROBOTS]; /**< the other team's robots, by number */
  fulbito_wheels sent[FULBITO_MAX_ROBOTS];     /**< [rad/s] applied to its robots in the previous tick */
} fulbito_observation;
FULBITO_SIZE(fulbito_observation, 1848);

/* ---- What a team answers ---- */

/** A place to drive to. The simulator's navigator plans the path among the other robots. */
typedef struct fulbito_go_to {
  fulbito_vec2 position;   /**< [m] target of the robot's centre */
  double heading;          /**< [rad] on arrival, if `has_heading` */
  double speed_limit;      /**< [m/s] largest speed; preset to infinity */
  double tolerance;        /**< [m] distance that counts as arrival; preset to 0.03 */
  uint8_t has_heading;     /**< 0: any heading */
  uint8_t stop;            /**< 1: stop at the target; 0: pass it at speed */
  uint8_t avoid_ball;      /**< 1: the ball is an obstacle too */
  uint8_t avoid_mates;     /**< 1: the team's own robots are obstacles; preset to 1 */
  uint8_t avoid_opponents; /**< 1: the opponents are obstacles; preset to 1 */
  uint8_t either_front;    /**< 1: either end may lead; 0: the front leads; preset to 1 */
  uint8_t navigator;       /**< index in the names of FULBITO_EXT_NAVIGATOR_NAMES */
  uint8_t reserved;        /**< 0 */
} fulbito_go_to;
FULBITO_SIZE(fulbito_go_to, 48);

/** The forms of a command. Another number counts as a fault and stops the robot. */
enum { FULBITO_BY_WHEELS = 0, FULBITO_BY_TWIST = 1, FULBITO_BY_GO_TO = 2 };

/** One robot's command until the next decision. */
typedef struct fulbito_robot_command {
  uint32_t kind;         /**< selects one of the members below; preset to FULBITO_BY_WHEELS */
  uint32_t role;         /**< a number that the team chooses, 1 ... 255; 0: unknown. For drills and viewers */
  fulbito_wheels wheels; /**< as given; preset to 0 */
  fulbito_twist twist;   /**< limited so that the robot can always steer */
  fulbito_go_to go_to;   /**< by a navigator */
} fulbito_robot_command;
FULBITO_SIZE(fulbito_robot_command, 88);

/** The kinds of drawings. */
enum { FULBITO_LINE = 0, FULBITO_CIRCLE = 1, FULBITO_TEXT = 2 };

/** A drawing of a team's intentions for viewers. It does not affect the match. */
typedef struct fulbito_drawing {
  uint32_t kind;                /**< FULBITO_LINE, FULBITO_CIRCLE or FULBITO_TEXT; others are left out */
  uint32_t reserved;            /**< 0 */
  fulbito_vec2 from;            /**< [m] start of a line; centre of a circle or a text */
  fulbito_vec2 to;              /**< [m] end of a line */
  double radius;                /**< [m] of a circle */
  char text[FULBITO_NAME_SIZE]; /**< for FULBITO_TEXT */
} fulbito_drawing;
FULBITO_SIZE(fulbito_drawing, 112);

/** A team's decision for one tick. The caller presets all members, so a team sets only what it wants. */
typedef struct fulbito_team_command {
  fulbito_robot_command robots[FULBITO_MAX_ROBOTS]; /**< by number; those of absent robots are ignored */
  fulbito_drawing* drawings; /**< the caller's memory for drawings; NULL unless they are wanted */
  uint32_t drawing_capacity; /**< room in `drawings` */
  uint32_t drawing_count;    /**< drawings that the team has written; preset to 0 */
} fulbito_team_command;
FULBITO_SIZE(fulbito_team_command, 984);

/* ---- Restarts, notices, drills ---- */

/** A call of the referee, with its measured value. */
typedef struct fulbito_call {
  int64_t tick;                   /**< tick of the match */
  double play_time;               /**< [s] play time in the period */
  int32_t period;                 /**< 1, 2: halves; 3: overtime; 4: shoot-out */
  int32_t team;                   /**< colour that it is against; of a goal, the scorer's; -1: none */
  int32_t robot;                  /**< number of the robot at fault or of the scorer; -1: unknown */
  int32_t reserved;               /**< 0 */
  fulbito_vec2 place;             /**< [m] the ball's position */
  double value;                   /**< measured value, in the unit of the threshold */
  double threshold;               /**< limit of the rule */
  double margin;                  /**< distance of the value from the limit; positive */
  char clause[FULBITO_NAME_SIZE]; /**< name of the rule, e.g. "goal-kick.attackers"; empty: no call */
  char law[FULBITO_NAME_SIZE];    /**< section of the rule book, e.g. "8.2" */
} fulbito_call;
FULBITO_SIZE(fulbito_call, 200);

/** Poses by robot number. */
typedef struct fulbito_poses {
  uint8_t present[16];                   /**< by number: 0: no pose; those from FULBITO_MAX_ROBOTS are 0 */
  fulbito_pose pose[FULBITO_MAX_ROBOTS]; /**< by number */
} fulbito_poses;
FULBITO_SIZE(fulbito_poses, 280);

/** The request for a team's placement at a restart. */
typedef struct fulbito_placement_request {
  uint32_t kind;           /**< the kind of restart, e.g. FULBITO_KICK_OFF */
  uint8_t ours;            /**< 1: the team takes the restart */
  uint8_t has_opponents;   /**< 1: `opponents` is known, as the rule lets the other team place first */
  uint8_t reserved[2];     /**< 0 */
  fulbito_vec2 ball;       /**< [m] ball position; for the other team, after the taker's choice */
  double delay;            /**< [s] from the placement to the signal; 0: play begins at once */
  fulbito_poses defaults;  /**< placement by the rules */
  fulbito_poses opponents; /**< the other team's placement */
  fulbito_call cause;      /**< the call that stopped play; no clause at the start of the match */
  fulbito_observation now; /**< score, time and all poses when play stopped */
} fulbito_placement_request;
FULBITO_SIZE(fulbito_placement_request, 2640);

/** A team's wishes at a restart. The referee repairs poses that are not allowed. */
typedef struct fulbito_placement {
  uint32_t has_ball;    /**< 1: `ball` counts: for the own goal kick, if the rules leave it free */
  uint32_t reserved;    /**< 0 */
  fulbito_vec2 ball;    /**< [m] */
  fulbito_poses robots; /**< robots without a pose get the place by the rules */
} fulbito_placement;
FULBITO_SIZE(fulbito_placement, 304);

/** The notice that play is stopped. */
typedef struct fulbito_stop {
  fulbito_call cause;      /**< the call */
  fulbito_observation now; /**< with the score after the call */
} fulbito_stop;
FULBITO_SIZE(fulbito_stop, 2048);

/** Why a match ends. */
enum {
  FULBITO_PLAYED = 0,     /**< its regular end by the rules */
  FULBITO_ABANDONED = 1,  /**< the state of a restart was not valid */
  FULBITO_INTERRUPTED = 2 /**< the user ended it */
};

/** The notice that the match is over. */
typedef struct fulbito_end {
  uint32_t reason;        /**< FULBITO_PLAYED, FULBITO_ABANDONED or FULBITO_INTERRUPTED */
  int32_t winner;         /**< colour; -1 after a draw or an unfinished match */
  int64_t tick;           /**< last tick of the match */
  int32_t own_score;      /**< goals of the team */
  int32_t opponent_score; /**< goals against it */
  fulbito_call cause;     /**< the call that ended it; no clause if interrupted */
} fulbito_end;
FULBITO_SIZE(fulbito_end, 224);

/** The kinds of tasks in drills. */
enum {
  FULBITO_REACH_POSE = 0,  /**< stop at `target` with `heading` */
  FULBITO_TURN = 1,        /**< turn to `heading` in place */
  FULBITO_REACH_BALL = 2,  /**< be behind the resting ball at `heading`, moving on through it at `speed` */
  FULBITO_PUSH = 3,        /**< push the ball along `heading` at `speed` */
  FULBITO_PREDICT_BALL = 4 /**< predict the ball's position `horizon` seconds from now */
};

/** A task of a drill: one skill of the team's first robot instead of a whole match. */
typedef struct fulbito_exercise {
  uint32_t kind;       /**< e.g. FULBITO_TURN */
  uint32_t reserved;   /**< 0 */
  fulbito_vec2 target; /**< [m] for FULBITO_REACH_POSE */
  double heading;      /**< [rad] */
  double speed;        /**< [m/s] */
  double horizon;      /**< [s] for FULBITO_PREDICT_BALL */
} fulbito_exercise;
FULBITO_SIZE(fulbito_exercise, 48);

/* ---- Tables of functions ---- */

/** The types of parameters. */
enum { FULBITO_NUMBER = 0, FULBITO_INTEGER = 1, FULBITO_FLAG = 2, FULBITO_CHOICE = 3 };

/** A documented parameter, which specifications set: `./mine.so:aggression=0.7`. */
typedef struct fulbito_parameter {
  const char* name;           /**< as in `name=value` */
  const char* unit;           /**< e.g. "m/s"; NULL or empty: none */
  const char* doc;            /**< one line for people */
  const char* const* choices; /**< for FULBITO_CHOICE: the names of its values; otherwise NULL */
  uint32_t choice_count;      /**< length of `choices` */
  uint32_t type;              /**< e.g. FULBITO_NUMBER */
  double default_value;       /**< of a flag: 0 or 1; of a choice: its index */
  double minimum;             /**< least allowed value of a number or an integer */
  double maximum;             /**< largest allowed value of a number or an integer */
} fulbito_parameter;
FULBITO_SIZE(fulbito_parameter, 64);

/** What the simulator offers to one team or navigator, from `create` to `destroy`. Its functions may be
 * called by the thread that runs a call of this team or navigator, during that call. */
typedef struct fulbito_host {
  uint32_t abi_version;  /**< FULBITO_ABI of the simulator */
  uint32_t struct_size;  /**< sizeof(fulbito_host) of the simulator */
  void* data;            /**< the simulator's own */
  const char* simulator; /**< its name and version */
  /** Shows one line to the user. The text is copied. */
  void (*log)(const struct fulbito_host* host, const char* line);
  /** 64 random bits of the team's own stream. `begin` starts the stream anew from the match's seed. */
  uint64_t (*random)(const struct fulbito_host* host);
  /** An extension of the simulator by name; NULL: unknown. It lives as long as the host. */
  const void* (*get_extension)(const struct fulbito_host* host, const char* name);
} fulbito_host;
FULBITO_SIZE(fulbito_host, 48);

/** Extension of the host: `const char`, all rules of the match with units and meanings, as TOML. Known from
 * `begin` on; it lives until the next `begin`. */
#define FULBITO_EXT_RULES_TEXT "fulbito.rules-text/1"

/** Extension of the host: `fulbito_curve_widening`. Known to a team from `begin` on and to a navigator from
 * its first `plan` on; it lives as long as the host. */
#define FULBITO_EXT_CURVE_WIDENING "fulbito.curve-widening/1"
/** Slip in curves of the robots, in addition to `fulbito_robot_model`: at speed v they drive a curve that is
 * wider than commanded by v (curve_widening + curve_widening_rise v). */
typedef struct fulbito_curve_widening {
  double curve_widening;      /**< [s] radius that a curve gains, over the speed; 0: none */
  double curve_widening_rise; /**< [s^2/m] by which `curve_widening` rises with the speed */
} fulbito_curve_widening;
FULBITO_SIZE(fulbito_curve_widening, 16);

/** A library: its description, its team, and its extensions. The table and all that it points at live as long
 * as the library is loaded. */
typedef struct fulbito_library {
  uint32_t abi_version;                /**< FULBITO_ABI; the first member for ever */
  uint32_t struct_size;                /**< sizeof(fulbito_library); later versions append members */
  const char* name;                    /**< name of the team or of the library; not empty */
  const char* version;                 /**< NULL or empty: none */
  const char* summary;                 /**< one line; NULL or empty: none */
  const fulbito_parameter* parameters; /**< the team's parameters; NULL if there are none */
  uint32_t parameter_count;            /**< length of `parameters`, at most 256 */
  uint32_t reserved;                   /**< 0 */
  const char* default_navigator;       /**< default of the setting `navigator`; NULL: the team takes none */
  /** Creates a team. Called once per match and once to check the settings. All four functions are NULL in a
   * library without a team.
   * @param values     the values of `parameters`, in their order, checked; numbers for all types
   * @param navigator  the setting `navigator` or its default; NULL if the team takes none
   * @return the team; NULL: refused, with the reason by `log` */
  void* (*create)(const fulbito_host* host, const double* values, const char* navigator);
  /** Destroys a team. No call follows. */
  void (*destroy)(void* team);
  /** A new match begins: reset all memory. Called at least once, before all other functions of the team. */
  int32_t (*begin)(void* team, const fulbito_match_info* info);
  /** The decision for one control tick; called once per tick. It reads no clock and allocates nothing. */
  int32_t (*decide)(void* team, const fulbito_observation* seen, fulbito_team_command* command);
  /** An extension of the library by name; NULL: unknown. May itself be NULL. Called by any thread. */
  const void* (*get_extension)(const char* name);
} fulbito_library;
FULBITO_SIZE(fulbito_library, 96);

/** The one symbol of a library. Called by any thread; returns the same table each time. */
FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void);
/** Name of that symbol. */
#define FULBITO_ENTRY_NAME "fulbito_library_entry"

/** Extension of a library: `fulbito_navigator_names`. */
#define FULBITO_EXT_NAVIGATOR_NAMES "fulbito.navigator-names/1"
/** The navigators of the simulator that the team's `fulbito_go_to` uses. */
typedef struct fulbito_navigator_names {
  /** Called after each `begin`, with 0, 1, 2 ... up to 255.
   * @return a specification such as "bezier"; NULL: no more. It lives until the next call */
  const char* (*name)(void* team, uint32_t index);
} fulbito_navigator_names;
FULBITO_SIZE(fulbito_navigator_names, 8);

/** Extension of a library: `fulbito_restarts`. */
#define FULBITO_EXT_RESTARTS "fulbito.restarts/1"
/** The team's part in restarts, and notices between decisions. Any function may be NULL. */
typedef struct fulbito_restarts {
  /** The team's placement at a restart. The caller presets `placement` to no wishes. */
  int32_t (*place)(void* team, const fulbito_placement_request* request, fulbito_placement* placement);
  /** Play is stopped. Called before the placement requests of the restart. */
  int32_t (*stopped)(void* team, const fulbito_stop* stop);
  /** The new play is placed. Called before its first decision, with exact poses. */
  int32_t (*ready)(void* team, const fulbito_observation* seen);
  /** The match is over. */
  int32_t (*ended)(void* team, const fulbito_end* end);
} fulbito_restarts;
FULBITO_SIZE(fulbito_restarts, 32);

/** Extension of a library: `fulbito_exercises`. */
#define FULBITO_EXT_EXERCISES "fulbito.exercises/1"
/** What `fulbito_exercises::exercise` returns if the team lacks the skill. */
#define FULBITO_NO_SKILL (-1000)
/** The team's part in drills of one skill. */
typedef struct fulbito_exercises {
  /** One tick of an exercise. `command` is preset as for `decide`; `answer` is the predicted position of the
   * ball [m], for FULBITO_PREDICT_BALL, preset to 0.
   * @return 0, FULBITO_NO_SKILL, or another number after a failure */
  int32_t (*exercise)(void* team, const fulbito_observation* seen, const fulbito_exercise* task,
                      fulbito_team_command* command, fulbito_vec2* answer);
} fulbito_exercises;
FULBITO_SIZE(fulbito_exercises, 8);

/* ---- Navigators ---- */

/** The forms of guidance. */
enum {
  FULBITO_GUIDE_FIELD = 0,      /**< by `fulbito_navigator::heading` */
  FULBITO_GUIDE_PATH = 1,       /**< `path`; the follower chooses the speed */
  FULBITO_GUIDE_TIMED_PATH = 2, /**< `path` and `speeds`: the method planned its own speed profile */
  FULBITO_GUIDE_WHEELS = 3      /**< `wheels`: the method controls the wheels itself */
};

/** A round obstacle. Discs also cover the boxes. */
typedef struct fulbito_disc {
  fulbito_vec2 position; /**< [m] its centre now */
  fulbito_vec2 velocity; /**< [m/s] */
  double radius;         /**< [m] the obstacle's own radius, not inflated by the robot */
} fulbito_disc;
FULBITO_SIZE(fulbito_disc, 40);

/** A navigator's knowledge at one control tick. */
typedef struct fulbito_scene {
  int64_t tick;                     /**< counts control ticks; never goes back within a trial */
  double dt;                        /**< [s] control period */
  fulbito_robot self;               /**< the robot */
  fulbito_vec2 goal;                /**< [m] target of the robot's centre */
  double goal_heading;              /**< [rad] on arrival, if `has_heading` */
  double tolerance;                 /**< [m] distance that counts as arrival */
  double heading_tolerance;         /**< [rad] difference that counts as the wanted heading */
  uint32_t has_heading;             /**< 0: any heading */
  uint32_t stop;                    /**< 1: stop at the goal; 0: the robot may pass it at speed */
  const fulbito_disc* obstacles;    /**< the other bodies, in any order */
  uint64_t obstacle_count;          /**< length of `obstacles` */
  const fulbito_field* field;       /**< never NULL */
  const fulbito_robot_model* robot; /**< never NULL; its max_wheel_speed is the speed limit of this trial */
} fulbito_scene;
FULBITO_SIZE(fulbito_scene, 168);

/** A navigator's output. All numbers must be finite, except `speed_cap`. */
typedef struct fulbito_guidance {
  uint32_t kind;            /**< e.g. FULBITO_GUIDE_PATH */
  uint32_t point_count;     /**< length of `path`, at least 2 for the two kinds of paths */
  const fulbito_vec2* path; /**< [m] from robot to goal, any spacing; the navigator's, until its next call */
  const double* speeds;     /**< [m/s] speed at each point, for FULBITO_GUIDE_TIMED_PATH; as `path` */
  uint64_t revision;        /**< changes whenever `path` or `speeds` do */
  fulbito_wheels wheels;    /**< for FULBITO_GUIDE_WHEELS */
  double speed_cap;         /**< [m/s] present speed limit; preset to infinity */
} fulbito_guidance;
FULBITO_SIZE(fulbito_guidance, 56);

/** One navigation method. An instance belongs to one robot and keeps its memory between ticks. */
typedef struct fulbito_navigator {
  const char* name;                    /**< as in `./mine.so:name` */
  const char* summary;                 /**< one line; NULL or empty: none */
  const char* source;                  /**< paper, section; NULL or empty: none */
  const fulbito_parameter* parameters; /**< NULL if there are none */
  uint32_t parameter_count;            /**< length of `parameters`, at most 256 */
  uint32_t plans_speed;                /**< 1: gives its own speed profile or wheel speeds; tables mark it */
  /** Creates a navigator; `values` as for a team. @return NULL: refused, with the reason by `log` */
  void* (*create)(const fulbito_host* host, const double* values);
  /** Destroys a navigator. */
  void (*destroy)(void* navigator);
  /** Resets all memory: the next call starts a new trial. */
  void (*reset)(void* navigator);
  /** Plans the motion in the present scene; called once per control tick. It reads no clock and allocates
   * nothing once warm. The caller presets `guidance`. After a failure the robot stops. */
  int32_t (*plan)(void* navigator, const fulbito_scene* scene, fulbito_guidance* guidance);
  /** Direction of travel [rad] at a point, after `plan` gave FULBITO_GUIDE_FIELD; otherwise it may be NULL.
   * Called many times per tick. */
  double (*heading)(void* navigator, fulbito_vec2 point);
} fulbito_navigator;
FULBITO_SIZE(fulbito_navigator, 80);

/** Extension of a library: `fulbito_navigators`. */
#define FULBITO_EXT_NAVIGATORS "fulbito.navigators/1"
/** The navigators that a library adds. */
typedef struct fulbito_navigators {
  const fulbito_navigator* navigators; /**< as long as the library is loaded */
  uint32_t count;                      /**< length of `navigators`, at most 256 */
  uint32_t reserved;                   /**< 0 */
} fulbito_navigators;
FULBITO_SIZE(fulbito_navigators, 16);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif

#endif
