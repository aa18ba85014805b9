#include "referee/rules/rules_schema.hpp"

#include <fmt/format.h>

#include "fulbito/detail/values.hpp"
#include "referee/rules/detector_schema.hpp"

namespace fulbito {
namespace {

constexpr double kLongestPeriod = 7200.0;  // [s]
constexpr double kLongestWait = 600.0;     // [s]
constexpr double kFarthest = 20.0;         // [m]
constexpr double kLongestLabel = 100.0;    // characters

Schema rulesSchema(Rules& r) {
  return {
      {"name", Label{&r.name}, 1, kLongestLabel, "", "shown in tables and results"},
      {"field", &r.field, 1, 4096, "", "preset of the field, or a file"},
      {"team_size", &r.team_size, 1, kMaxTeamSize, "robots", "robots per team"},
  };
}

Schema periodSchema(Rules& r) {
  PeriodRules& p = r.periods;
  return {
      {"half_seconds", &r.half_seconds, 0.1, kLongestPeriod, "s", "play time of a half; law 5: 300"},
      {"first_kick_off", choice(p.first_kick_off, {"toss", "blue", "yellow"}), 0, 0, "",
       "team with the first kick-off; the toss uses the match's random stream; law 6"},
      {"swap_kick_off", &p.swap_kick_off, 0, 0, "",
       "the other team kicks off in the second half; FIRA's program: false"},
      {"swap_sides", &p.swap_sides, 0, 0, "",
       "teams change sides at half-time; law 6: true, league program: false"},
      {"mercy_goals", &p.mercy_goals, 0, 1000, "goals", "lead that ends the match, 0 = never; league option"},
      {"tie_break", choice(p.tie_break, {"none", "overtime", "shoot-out", "overtime+shoot-out"}), 0, 0, "",
       "what follows a draw; law 7.2 for ties that must be broken: overtime+shoot-out"},
      {"overtime_parts", &p.overtime_parts, 1, 10, "", "periods of overtime; law 7.2: 1, league program: 2"},
      {"overtime_seconds", &p.overtime_seconds, 0.1, kLongestPeriod, "s",
       "play time of each overtime period; law 7.2 and league program: 180"},
      {"golden_goal", &p.golden_goal, 0, 0, "",
       "the first goal in overtime ends the match; law 7.2: true, league program: false"},
  };
}

Schema schemaOf(ShootOutRules& s) {
  return {
      {"kicks", &s.kicks, 1, 100, "", "regular kicks per team, then sudden death in pairs; law 7.2: 3"},
      {"order", choice(s.order, {"alternating", "series"}), 0, 0, "",
       "order of the regular kicks: alternating, or one team's kicks first; law 7.2 leaves it open"},
      {"max_kicks", &s.max_kicks, 1, 1000, "",
       "most kicks per team, then a toss decides; ours, so that matches end"},
      {"kick_seconds", &s.kick_seconds, 0.1, kLongestWait, "s", "time limit of a kick; law 7.2: 30"},
      {"ends_at_rest", &s.ends_at_rest, 0, 0, "", "a kick ends when the ball is at rest; league program"},
      {"rest_speed", &s.rest_speed, 0, 1, "m/s", "a ball at most this fast is at rest; ours"},
      {"rest_seconds", &s.rest_seconds, 0, kLongestWait, "s",
       "time at rest that ends a kick, once the ball has moved; ours"},
      {"held_seconds", &s.held_seconds, 0, kLongestWait, "s",
       "undisputed control by the keeper in its area that ends a kick, 0 = never; law 7.2, time ours"},
      {"ends_leaving_area", &s.ends_leaving_area, 0, 0, "",
       "a kick ends when the ball leaves the goal area backward; law 7.2"},
      {"ends_past_midfield", &s.ends_past_midfield, 0, 0, "",
       "a kick ends when the ball crosses the half-way line; league program"},
  };
}

Schema schemaOf(WalkOverRules& w) {
  return {
      {"mode", choice(w.mode, {"play", "forfeit"}), 0, 0, "",
       "if a team is absent: the other plays on the empty field (law 7.3), or the match ends"},
      {"seconds", &w.seconds, 0.1, kLongestPeriod, "s", "play time on the empty field; law 7.3: 180"},
      {"absent_score", &w.absent_score, -100, 0, "goals",
       "score of the absent team, minus the goals of the other; law 7.3: -1"},
      {"both_absent_score", &w.both_absent_score, -100, 0, "goals",
       "score of both teams if both are absent; law 7.3: -3"},
  };
}

Schema schemaOf(DecisionTime& d) {
  return {
      {"decision", &d.decision, 0, 60, "s", "wall time of each decision and placement"},
      {"bank", &d.bank, 0, 3600, "s", "wall time beyond that per period"},
      {"held", &d.held, 0, 3600, "decisions",
       "late decisions in a row for which the last command stays; after more, the robots stop"},
      {"start", &d.start, 0, 600, "s", "wall time of the team's start, and of each new start"},
      {"failures", &d.failures, 1, 1000, "", "failures after which the team forfeits the match"},
  };
}

Schema schemaOf(RestartRules& r) {
  return {
      {"delay", &r.delay, 0, kLongestWait, "s",
       "time from placement to signal, with the clock stopped; league program: 4, headless: 0"},
      {"goal_delay", &r.goal_delay, 0, kLongestWait, "s", "the same after a goal; league program: 8"},
      {"hold_robots", &r.hold_robots, 0, 0, "", "robots cannot move before the signal; league program"},
      {"robot_gap", &r.robot_gap, 0, 0.1, "m",
       "least gap between bodies when a placement is repaired; league program: a tenth of a robot"},
      {"false_start_distance", &r.false_start_distance, 0.001, 1, "m",
       "a robot this far from its place has moved; law 9 gives no number, ours"},
      {"false_start_release", &r.false_start_release, 0, 1, "m",
       "a robot nearer than this is back; hysteresis, ours"},
      {"false_start_seconds", &r.false_start_seconds, 0, kLongestWait, "s",
       "a robot must be away for this long; ours"},
      {"escalation", &r.escalation, 0, 0, "",
       "after the warnings, law 9 escalates; otherwise repeat; law 9: true"},
      {"warnings", &r.warnings, 0, 100, "", "repeats without a penalty; law 9: 1"},
      {"max_repeats", &r.max_repeats, 0, 1000, "",
       "after this many repeats the signal comes at once; ours, so that the match goes on"},
      {"card_seconds", &r.card_seconds, 0, kLongestPeriod, "s",
       "play time for which a robot is sent off; law 9: 30"},
      {"card_until_goal", &r.card_until_goal, 0, 0, "", "a goal brings the robot back earlier; law 9: true"},
  };
}

void append(Schema& schema, PlaceTable& places, const std::string& source) {
  schema.push_back({"taker", &places.taker, -kFarthest, kFarthest, "m",
                    "places of robots 0, 1 ... of the taking team, which defends +x; " + source});
  schema.push_back({"other", &places.other, -kFarthest, kFarthest, "m", "the same for the other team"});
}

Schema schemaOf(KickOffRules& k) {
  Schema schema{{"circle_margin", &k.circle_margin, 0, 1, "m",
                 "distance of the other team's robot centres from the circle; law 6: outside"}};
  append(schema, k.places, "league program");
  return schema;
}

Schema schemaOf(FreeBallRules& f) {
  Schema schema{
      {"others", choice(f.others, {"stay", "table"}), 0, 0, "",
       "robots far from the mark; law 14: stay, league program: table"},
      {"distance", &f.distance, 0, 2, "m",
       "distance of all robot centres from the ball; law 14: 0.20, 5v5 0.25"},
      {"take_marks", &f.take_marks, 0, 0, "", "one robot per team takes its mark next to the ball; law 14"},
  };
  append(schema, f.places, "league program, for y > 0; y is flipped below");
  return schema;
}

Schema schemaOf(FreeKickRules& f) {
  Schema schema{
      {"mark", &f.mark, 0, kFarthest, "m",
       "x of the ball in the attacked half; law 11 gives no number: the penalty mark, ours"},
      {"touch", &f.touch, 0, 0.2, "m", "a defender this close touches the line of its area; law 11, ours"},
  };
  append(schema, f.places, "law 11, ours");
  return schema;
}

Schema schemaOf(PenaltyRules& p) {
  Schema schema{{"keeper_line", &p.keeper_line, 0, 0.1, "m",
                 "largest distance of the keeper's side from the goal line; law 12: on it"}};
  append(schema, p.places, "league program");
  return schema;
}

Schema schemaOf(GoalKickRules& g) {
  Schema schema{
      {"ball", &g.ball, 0, kFarthest, "m",
       "ball in the taker's half, unless the team chooses; league program; law 13: anywhere in the area"},
      {"side", choice(g.side, {"open", "keeper"}), 0, 0, "",
       "sign of y: farther from the nearest opponent (ours), or the keeper's side; league program: keeper"},
      {"ball_free", &g.ball_free, 0, 0, "",
       "the team may place the ball anywhere in its area; law 13: true, league program: false"},
      {"opponents", choice(g.opponents, {"own-half", "outside-area"}), 0, 0, "",
       "where the opponents stand; FIRA's law: own-half, league program: outside-area"},
  };
  append(schema, g.places, "league program; the keeper's y follows the ball's side");
  return schema;
}

std::optional<Flaw> tableFlaw(const PlaceTable& places, const char* table) {
  const auto too_many = [&](const std::vector<Vec2>& list, const char* key) -> std::optional<Flaw> {
    if (list.size() <= kMaxTeamSize) return std::nullopt;
    return Flaw{table, -1, key,
                fmt::format("has {} places; at most {} are allowed", list.size(), kMaxTeamSize)};
  };
  if (auto flaw = too_many(places.taker, "taker")) return flaw;
  return too_many(places.other, "other");
}

std::optional<Flaw> placesFlaw(const Rules& rules) {
  if (auto flaw = tableFlaw(rules.kick_off.places, "kick_off")) return flaw;
  if (auto flaw = tableFlaw(rules.free_ball.places, "free_ball")) return flaw;
  if (auto flaw = tableFlaw(rules.free_kick.places, "free_kick")) return flaw;
  if (auto flaw = tableFlaw(rules.penalty.places, "penalty")) return flaw;
  return tableFlaw(rules.goal_kick.places, "goal_kick");
}

std::optional<Flaw> detectorFlaw(const Rules& rules) {
  if (auto flaw = findFlaw(rules.goal)) return flaw;
  if (auto flaw = findFlaw(rules.stuck)) return flaw;
  if (auto flaw = findFlaw(rules.areas)) return flaw;
  if (auto flaw = findFlaw(rules.keeper)) return flaw;
  return findFlaw(rules.fouls);
}

}  // namespace

std::vector<RulesTable> tablesOf(Rules& r) {
  return {
      {"rules", "The game.", rulesSchema(r)},
      {"periods", "Laws 5 to 7: time and ties.", periodSchema(r)},
      {"shoot_out", "Law 7.2: kicks from the penalty mark.", schemaOf(r.shoot_out)},
      {"walk_over", "Law 7.3: an absent team.", schemaOf(r.walk_over)},
      {"decision_time", "Limits of teams that run outside the program.", schemaOf(r.decision_time)},
      {"restart", "All restarts, and law 9: the false start.", schemaOf(r.restart)},
      {"kick_off", "Law 6.", schemaOf(r.kick_off)},
      {"free_ball", "Law 14. The marks are the field's.", schemaOf(r.free_ball)},
      {"free_kick", "Law 11.", schemaOf(r.free_kick)},
      {"penalty", "Law 12. The mark is the field's.", schemaOf(r.penalty)},
      {"goal_kick", "Law 13.", schemaOf(r.goal_kick)},
      {"goal", "Law 7.1.", schemaOf(r.goal)},
      {"stuck", "Laws 13 and 14: the stuck ball.", schemaOf(r.stuck)},
      {"areas", "Laws 8.2 and 8.3: too many robots in a goal area.", schemaOf(r.areas)},
      {"keeper", "Laws 2.2.3, 8.1 and 13: the keeper.", schemaOf(r.keeper)},
      {"fouls", "Law 8.1: pushing and holding.", schemaOf(r.fouls)},
  };
}

std::optional<Flaw> findFlaw(const Rules& rules) {
  Rules copy = rules;
  for (const RulesTable& table : tablesOf(copy)) {
    if (auto flaw = rangeFlaw(table.schema, table.name)) return flaw;
  }
  if (auto flaw = placesFlaw(rules)) return flaw;
  if (auto flaw = detectorFlaw(rules)) return flaw;
  const RestartRules& restart = rules.restart;
  if (restart.false_start_release > restart.false_start_distance) {
    return Flaw{"restart", -1, "false_start_release",
                fmt::format("= {} must be at most false_start_distance = {}", restart.false_start_release,
                            restart.false_start_distance)};
  }
  if (rules.shoot_out.max_kicks < rules.shoot_out.kicks) {
    return Flaw{
        "shoot_out", -1, "max_kicks",
        fmt::format("= {} must be at least kicks = {}", rules.shoot_out.max_kicks, rules.shoot_out.kicks)};
  }
  return std::nullopt;
}

}  // namespace fulbito
