#include "referee/rules/detector_schema.hpp"

namespace fulbito {
namespace {

constexpr double kLongest = 600.0;  // [s]

const std::vector<std::string> kParts = {"any-part", "half", "centre"};

template <typename R>
std::optional<Flaw> flawIn(const R& rules, const char* table) {
  R copy = rules;
  return rangeFlaw(schemaOf(copy), table);
}

}  // namespace

Schema schemaOf(GoalRules& r) {
  return {
      {"ball", choice(r.ball, {"whole", "centre"}), 0, 0, "",
       "part of the ball that must be past the goal line; law 7.1: whole"},
      {"scorer_seconds", &r.scorer_seconds, 0, kLongest, "s",
       "a scorer is named only if it touched the ball this recently; ours"},
      {"attack_foul_voids", &r.attack_foul_voids, 0, 0, "",
       "a goal while a foul of the attackers is pending becomes a goal kick; league program"},
  };
}

Schema schemaOf(StuckRules& r) {
  return {
      {"measure", choice(r.measure, {"radius", "speed"}), 0, 0, "",
       "a ball is stuck if it stays in a circle (ours for the book's stalemate) or is slow (league program)"},
      {"seconds", &r.seconds, 0.1, kLongest, "s",
       "time limit outside the goal areas; law 14: 10, league program: 5"},
      {"area_seconds", &r.area_seconds, 0.1, kLongest, "s",
       "time limit in a goal area; law 13: 10, league program: 5"},
      {"radius", &r.radius, 0.001, 5, "m", "measure radius: leaving this circle restarts the count; ours"},
      {"speed", &r.speed, 0, 10, "m/s",
       "measure speed: a ball at most this fast starts a count; league program: 0.1"},
      {"release_speed", &r.release_speed, 0, 10, "m/s",
       "measure speed: a ball faster than this ends a count; hysteresis, ours"},
      {"release_seconds", &r.release_seconds, 0, kLongest, "s",
       "measure speed: the ball must be faster for this long; ours"},
      {"dispute_lengths", &r.dispute_lengths, 0, 20, "robot lengths",
       "a robot whose centre is this close to the ball disputes it; league program: 1.5"},
      {"undisputed", choice(r.undisputed, {"penalty", "goal-kick"}), 0, 0, "",
       "call for an undisputed stuck ball in an area; league program: penalty; ours by law 13: goal-kick"},
      {"place", choice(r.place, {"most", "now"}), 0, 0, "",
       "place of a ball that was in and out of an area: where it was most (ours), or now (league program)"},
  };
}

Schema schemaOf(AreaRules& r) {
  return {
      {"arc", &r.arc, 0, 0, "", "the goal area includes its arc; league program: false"},
      {"hysteresis", &r.hysteresis, 0, 0.1, "m",
       "a robot counts as inside until it is this far outside; ours"},
      {"part_seconds", &r.part_seconds, 0, kLongest, "s",
       "a robot takes part if it touched ball or opponent this recently; ours for laws 8.2, 8.3"},
      {"attackers", &r.attackers, 0, 0, "", "the referee calls law 8.2"},
      {"attackers_max", &r.attackers_max, 0, 11, "robots",
       "robots allowed in the opponents' goal area; law 8.2: 1"},
      {"attackers_part", choice(r.attackers_part, kParts), 0, 0, "",
       "part of a robot that must be inside; law 8.2: any-part, league program: centre"},
      {"attackers_need_ball", &r.attackers_need_ball, 0, 0, "",
       "the ball must be in the area too; league program: true"},
      {"attackers_take_part", &r.attackers_take_part, 0, 0, "",
       "a robot that entered later must take part; law 8.2: true, league program: false"},
      {"attackers_wait", &r.attackers_wait, 0, kLongest, "s",
       "wait for a goal, or for the ball to leave the area; league program: 3"},
      {"big_attackers_max", &r.big_attackers_max, 0, 11, "robots",
       "robots allowed in the opponents' big area; league program, 5v5: 3"},
      {"defenders", &r.defenders, 0, 0, "", "the referee calls law 8.3"},
      {"defenders_max", &r.defenders_max, 0, 11, "robots",
       "robots allowed in the own goal area with the ball; law 8.3: 1"},
      {"defenders_part", choice(r.defenders_part, kParts), 0, 0, "",
       "part of a robot that must be inside; law 8.3: half, league program: centre"},
      {"defenders_take_part", &r.defenders_take_part, 0, 0, "",
       "a robot that entered later must take part; law 8.3: true, league program: false"},
      {"defenders_wait", &r.defenders_wait, 0, kLongest, "s",
       "wait for a goal (8.3), or for the ball to leave the area; league program: 3"},
      {"big_defenders_max", &r.big_defenders_max, 0, 11, "robots",
       "robots allowed in the own big area with the ball; 5v5 text: 3, league program: 4"},
      {"pushed_excused", &r.pushed_excused, 0, 0, "",
       "a robot pushed in while it disputes the ball does not count; laws 8.2, 8.3"},
      {"pushed_seconds", &r.pushed_seconds, 0, kLongest, "s",
       "longest break in a push, and between push and entry; ours"},
      {"pushed_impulse", &r.pushed_impulse, 0, 10, "kg m/s",
       "least impulse of the push toward the goal; ours"},
      {"excuse_seconds", &r.excuse_seconds, 0, kLongest, "s", "time for a pushed robot to leave; ours"},
      {"cool_down", &r.cool_down, 0, kLongest, "s",
       "no such call within this time of the start of play; ours"},
      {"both", choice(r.both, {"attackers", "longer"}), 0, 0, "",
       "foul that counts if both teams commit one at a goal; law 8.2: attackers, league program: longer"},
  };
}

Schema schemaOf(KeeperRules& r) {
  return {
      {"holding", &r.holding, 0, 0, "",
       "the referee calls holding the ball too long; law 8.1; not in the league program"},
      {"hold_seconds", &r.hold_seconds, 0.1, kLongest, "s", "longest undisputed control; law 8.1: 10"},
      {"control_gap", &r.control_gap, 0, 1, "m",
       "gap between body and ball up to which the keeper controls it; ours"},
      {"release_seconds", &r.release_seconds, 0, kLongest, "s",
       "time without control that ends the count; ours"},
      {"dispute_lengths", &r.dispute_lengths, 0, 20, "robot lengths",
       "an opponent whose centre is this close to the ball restarts the count; as the league program's stuck "
       "ball"},
      {"charged", &r.charged, 0, 0, "",
       "the referee calls charging and blocking the keeper; laws 8.1, 13; not in the league program"},
      {"charge_seconds", &r.charge_seconds, 0, kLongest, "s", "least duration of the contact; ours"},
      {"charge_impulse", &r.charge_impulse, 0, 10, "kg m/s", "least total impulse of the contact; ours"},
      {"charge_release", &r.charge_release, 0, kLongest, "s", "time without contact that ends it; ours"},
      {"part_seconds", &r.part_seconds, 0, kLongest, "s",
       "a robot that touched the ball this recently disputes it; ours"},
      {"cool_down", &r.cool_down, 0, kLongest, "s",
       "no such call within this time of the start of play; ours"},
  };
}

Schema schemaOf(FoulRules& r) {
  return {
      {"push", &r.push, 0, 0, "",
       "the referee calls pushing away from the ball; law 8.1; not in the league program"},
      {"push_seconds", &r.push_seconds, 0, kLongest, "s", "least duration of the contact; ours"},
      {"push_impulse", &r.push_impulse, 0, 10, "kg m/s", "least total impulse of the contact; ours"},
      {"push_speed", &r.push_speed, 0, 10, "m/s", "least speed of the pushed robot; ours"},
      {"push_distance", &r.push_distance, 0, 5, "m", "least distance of both centres from the ball; ours"},
      {"push_release", &r.push_release, 0, kLongest, "s", "time without contact that ends it; ours"},
      {"part_seconds", &r.part_seconds, 0, kLongest, "s",
       "a robot that touched the ball this recently disputes it; ours"},
      {"holding", &r.holding, 0, 0, "",
       "the referee calls field players that pin the ball to a wall; ours; laws 2.2.3, 8.1: hiding the ball "
       "only"},
      {"pinned_seconds", &r.pinned_seconds, 0, kLongest, "s",
       "longest time for pinning an undisputed ball to a wall; ours"},
      {"pinned_speed", &r.pinned_speed, 0, 10, "m/s",
       "a ball is pinned if it and the robot are at most this fast; ours"},
      {"holding_release", &r.holding_release, 0, kLongest, "s", "time without pinning that ends it; ours"},
      {"dispute_lengths", &r.dispute_lengths, 0, 20, "robot lengths",
       "an opponent whose centre is this close to the ball disputes it; as the league program's stuck ball"},
      {"cool_down", &r.cool_down, 0, kLongest, "s",
       "no such call within this time of the start of play; ours"},
  };
}

void callOnlyGoals(Rules& rules) {
  rules.stuck.seconds = rules.stuck.area_seconds = kLongest;
  rules.areas.attackers = rules.areas.defenders = false;
  rules.keeper.holding = rules.keeper.charged = false;
  rules.fouls.push = rules.fouls.holding = false;
}

std::optional<Flaw> findFlaw(const GoalRules& rules) { return flawIn(rules, "goal"); }

std::optional<Flaw> findFlaw(const StuckRules& rules) {
  if (auto flaw = flawIn(rules, "stuck")) return flaw;
  if (rules.release_speed >= rules.speed) return std::nullopt;
  return Flaw{"stuck", -1, "release_speed", "must not be below speed"};
}

std::optional<Flaw> findFlaw(const AreaRules& rules) { return flawIn(rules, "areas"); }
std::optional<Flaw> findFlaw(const KeeperRules& rules) { return flawIn(rules, "keeper"); }
std::optional<Flaw> findFlaw(const FoulRules& rules) { return flawIn(rules, "fouls"); }

}  // namespace fulbito
