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
       "what must be past the goal line; law 7.1: whole"},
      {"scorer_seconds", &r.scorer_seconds, 0, kLongest, "s", "since the named scorer's last touch; ours"},
      {"attack_foul_voids", &r.attack_foul_voids, 0, 0, "",
       "a goal while a foul of the attackers waits is a goal kick; league program"},
  };
}

Schema schemaOf(StuckRules& r) {
  return {
      {"measure", choice(r.measure, {"radius", "speed"}), 0, 0, "",
       "stuck: the ball stays in a circle (ours for the book's stalemate) or is slow (league program)"},
      {"seconds", &r.seconds, 0.1, kLongest, "s", "outside the goal areas; law 14: 10, league program: 5"},
      {"area_seconds", &r.area_seconds, 0.1, kLongest, "s", "in a goal area; law 13: 10, league program: 5"},
      {"radius", &r.radius, 0.001, 5, "m", "measure radius: leaving this circle begins a new count; ours"},
      {"speed", &r.speed, 0, 10, "m/s", "measure speed: at most this begins a count; league program: 0.1"},
      {"release_speed", &r.release_speed, 0, 10, "m/s",
       "measure speed: above this a count ends; hysteresis, ours"},
      {"release_seconds", &r.release_seconds, 0, kLongest, "s",
       "measure speed: above it for this long; ours"},
      {"dispute_lengths", &r.dispute_lengths, 0, 20, "robot lengths",
       "a robot whose centre is this near to the ball disputes it; league program: 1.5"},
      {"undisputed", choice(r.undisputed, {"penalty", "goal-kick"}), 0, 0, "",
       "for a ball stuck in an area that nobody disputes; league program: penalty; ours by law 13: "
       "goal-kick"},
      {"place", choice(r.place, {"most", "now"}), 0, 0, "",
       "where a ball is stuck that was in and out of an area: where it lay most (ours), or now (league "
       "program)"},
  };
}

Schema schemaOf(AreaRules& r) {
  return {
      {"arc", &r.arc, 0, 0, "", "the goal area includes its arc; the league program ignores it"},
      {"hysteresis", &r.hysteresis, 0, 0.1, "m",
       "a robot inside counts until it left the area by this; ours"},
      {"part_seconds", &r.part_seconds, 0, kLongest, "s",
       "takes part: touched the ball or hindered an opponent this recently; ours for laws 8.2, 8.3"},
      {"attackers", &r.attackers, 0, 0, "", "law 8.2 is called"},
      {"attackers_max", &r.attackers_max, 0, 11, "robots", "in the opponents' goal area; law 8.2: 1"},
      {"attackers_part", choice(r.attackers_part, kParts), 0, 0, "",
       "of a robot inside; law 8.2: any-part, league program: centre"},
      {"attackers_need_ball", &r.attackers_need_ball, 0, 0, "",
       "the ball must be in the area too; league program: true"},
      {"attackers_take_part", &r.attackers_take_part, 0, 0, "",
       "one that came in later must take part; law 8.2: true, league program: false"},
      {"attackers_wait", &r.attackers_wait, 0, kLongest, "s",
       "the call waits for a goal or for the ball to leave the area; league program: 3"},
      {"big_attackers_max", &r.big_attackers_max, 0, 11, "robots",
       "in the opponents' big area; league program, 5v5: 3"},
      {"defenders", &r.defenders, 0, 0, "", "law 8.3 is called"},
      {"defenders_max", &r.defenders_max, 0, 11, "robots", "in the own goal area with the ball; law 8.3: 1"},
      {"defenders_part", choice(r.defenders_part, kParts), 0, 0, "",
       "of a robot inside; law 8.3: half, league program: centre"},
      {"defenders_take_part", &r.defenders_take_part, 0, 0, "",
       "one that came in later must take part; law 8.3: true, league program: false"},
      {"defenders_wait", &r.defenders_wait, 0, kLongest, "s",
       "the call waits for a goal (8.3) or for the ball to leave the area; league program: 3"},
      {"big_defenders_max", &r.big_defenders_max, 0, 11, "robots",
       "in the own big area with the ball; 5v5 text: 3, league program: 4"},
      {"pushed_excused", &r.pushed_excused, 0, 0, "",
       "a robot pushed in while disputing does not count; laws 8.2, 8.3"},
      {"pushed_seconds", &r.pushed_seconds, 0, kLongest, "s",
       "pushed in: the push had no longer break, and ended no longer before; ours"},
      {"pushed_impulse", &r.pushed_impulse, 0, 10, "kg m/s", "pushed in: by this toward the goal; ours"},
      {"excuse_seconds", &r.excuse_seconds, 0, kLongest, "s", "that a robot pushed in has for leaving; ours"},
      {"cool_down", &r.cool_down, 0, kLongest, "s",
       "no such call within this time of a play's beginning; ours"},
      {"both", choice(r.both, {"attackers", "longer"}), 0, 0, "",
       "which of two fouls at one goal counts; law 8.2: attackers, league program: longer"},
  };
}

Schema schemaOf(KeeperRules& r) {
  return {
      {"holding", &r.holding, 0, 0, "", "holding too long is called; law 8.1; not by the league program"},
      {"hold_seconds", &r.hold_seconds, 0.1, kLongest, "s", "of undisputed control; law 8.1: 10"},
      {"control_gap", &r.control_gap, 0, 1, "m", "between body and ball: the keeper controls it; ours"},
      {"release_seconds", &r.release_seconds, 0, kLongest, "s", "without control end the count; ours"},
      {"dispute_lengths", &r.dispute_lengths, 0, 20, "robot lengths",
       "an opponent's centre this near to the ball restarts the count; as the league program's stuck ball"},
      {"charged", &r.charged, 0, 0, "",
       "charging and blocking are called; laws 8.1, 13; not by the league program"},
      {"charge_seconds", &r.charge_seconds, 0, kLongest, "s", "that the contact must last; ours"},
      {"charge_impulse", &r.charge_impulse, 0, 10, "kg m/s", "that it must give in all; ours"},
      {"charge_release", &r.charge_release, 0, kLongest, "s", "without contact end it; ours"},
      {"part_seconds", &r.part_seconds, 0, kLongest, "s",
       "who touched the ball this recently disputes it; ours"},
      {"cool_down", &r.cool_down, 0, kLongest, "s",
       "no such call within this time of a play's beginning; ours"},
  };
}

Schema schemaOf(FoulRules& r) {
  return {
      {"push", &r.push, 0, 0, "", "pushing away from the ball is called; law 8.1; not by the league program"},
      {"push_seconds", &r.push_seconds, 0, kLongest, "s", "that the contact must last; ours"},
      {"push_impulse", &r.push_impulse, 0, 10, "kg m/s", "that it must give in all; ours"},
      {"push_speed", &r.push_speed, 0, 10, "m/s", "at which the other is moved at least; ours"},
      {"push_distance", &r.push_distance, 0, 5, "m", "from the ball to both centres at least; ours"},
      {"push_release", &r.push_release, 0, kLongest, "s", "without contact end it; ours"},
      {"part_seconds", &r.part_seconds, 0, kLongest, "s",
       "who touched the ball this recently disputes it; ours"},
      {"holding", &r.holding, 0, 0, "",
       "a non-keeper that pins the ball to a wall is called; by laws 2.2.3, 8.1 only who hides it; ours"},
      {"pinned_seconds", &r.pinned_seconds, 0, kLongest, "s",
       "that a robot may press an undisputed ball against a wall; ours"},
      {"pinned_speed", &r.pinned_speed, 0, 10, "m/s", "of ball and robot: pinned; ours"},
      {"holding_release", &r.holding_release, 0, kLongest, "s", "without pinning end it; ours"},
      {"dispute_lengths", &r.dispute_lengths, 0, 20, "robot lengths",
       "an opponent's centre this near to the ball disputes it; as the league program's stuck ball"},
      {"cool_down", &r.cool_down, 0, kLongest, "s",
       "no such call within this time of a play's beginning; ours"},
  };
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
