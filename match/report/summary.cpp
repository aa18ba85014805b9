#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/match_clock.hpp"
#include "fulbito/statistics.hpp"
#include "match/report/speed_line.hpp"

namespace fulbito {
namespace {

constexpr int kLabelWidth = 36;
constexpr int kColumnWidth = 14;

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

const std::string& nameOf(const MatchReport& report, TeamId team) {
  return report.config.teams[indexOf(team)].text;
}

std::string goalLine(const MatchReport& report, const GoalRecord& goal) {
  std::string who = "no robot touched the ball";
  if (goal.scorer) {
    who = fmt::format("{} robot {}{}", fulbito::nameOf(goal.scorer->team), goal.scorer->number,
                      goal.own_goal ? ", own goal" : "");
  }
  return fmt::format("  {:>7}  {} {:>7}   {} : {}   {} ({})\n", clockText(goal.seconds),
                     periodName(goal.period), clockText(goal.play_time), goal.score[0], goal.score[1],
                     nameOf(report, goal.team), who);
}

/// Heading of a team's column: its name, or its colour if the names are equal or too long.
std::string columnText(const MatchReport& report, TeamId team) {
  const std::string& name = report.config.teams[indexOf(team)].info->name;
  const bool same = name == report.config.teams[indexOf(other(team))].info->name;
  return same || name.size() > kColumnWidth - 2 ? fulbito::nameOf(team) : name;
}

/// Whether a call belongs in the table of fouls: it is against a team and not listed elsewhere.
bool isFault(std::string_view clause) {
  return clause != "goal" && clause != "kick-off" && clause != "full-time" && clause != "half";
}

std::string pluralOf(RestartKind kind) {
  if (kind == RestartKind::kPenalty) return "penalties";
  return kind == RestartKind::kGiven ? "given starts" : std::string(fulbito::nameOf(kind)) + "s";
}

/// A row of the table with one text per team.
std::string row(const std::string& label, const std::string& blue, const std::string& yellow) {
  return fmt::format("  {:<{}}{:>{}}{:>{}}\n", label, kLabelWidth, blue, kColumnWidth, yellow, kColumnWidth);
}

template <typename Text>
std::string row(const std::string& label, Text text) {
  return row(label, text(TeamId::kBlue), text(TeamId::kYellow));
}

std::string ballRows(const MatchStatistics& s) {
  const auto of = [&](TeamId team) -> const TeamStatistics& { return s.teams[indexOf(team)]; };
  std::string text = row("possession", [&](TeamId t) { return percent(s.possession(t)); });
  text += row("shots (on goal)",
              [&](TeamId t) { return fmt::format("{} ({})", of(t).shots, of(t).shots_on_goal); });
  text += row("ball in own third", [&](TeamId t) { return percent(s.third(t, 0)); });
  text += row("ball in opponents' third", [&](TeamId t) { return percent(s.third(t, 2)); });
  text += row("mean ball x [cm]", [&](TeamId t) { return fmt::format("{:+.1f}", 100.0 * s.meanBallX(t)); });
  // The ball's places are the same for both teams.
  text += row("ball at a wall (in a corner)",
              [&](TeamId) { return fmt::format("{} ({})", percent(s.atWall()), percent(s.inCorner())); });
  text += row("ball touches", [&](TeamId t) { return fmt::format("{}", of(t).touches()); });
  return text;
}

std::string playRows(const MatchStatistics& s) {
  const auto of = [&](TeamId team) -> const TeamPlay& { return s.teams[indexOf(team)].play; };
  const auto both = [](double all, double field) {
    return fmt::format("{} ({})", percent(all), percent(field));
  };
  std::string text = row(fmt::format("slower than {:g} m/s (field robots)", kSlowSpeed),
                         [&](TeamId t) { return both(of(t).slow(), of(t).fieldSlow()); });
  text += row("nobody behind ball (field robots)",
              [&](TeamId t) { return both(s.uncovered(t), s.fieldUncovered(t)); });
  text += row("keeper away", [&](TeamId t) { return percent(of(t).keeperAway()); });
  text += row("locks (longest contact [s])", [&](TeamId t) {
    return fmt::format("{} ({:.1f})", of(t).locks, static_cast<double>(of(t).longest_contact) * s.dt);
  });
  return text;
}

std::string robotRows(const MatchReport& report) {
  const MatchStatistics& s = report.statistics;
  const auto of = [&](TeamId team) -> const TeamStatistics& { return s.teams[indexOf(team)]; };
  std::string text =
      row("distance driven [m]", [&](TeamId t) { return fmt::format("{:.1f}", of(t).distance()); });
  for (std::size_t i = 0; i < static_cast<std::size_t>(s.team_size); ++i) {
    text += row(fmt::format("  robot {}", i),
                [&](TeamId t) { return fmt::format("{:.1f}", of(t).robots[i].distance); });
  }
  text += row("wall contacts", [&](TeamId t) { return fmt::format("{}", of(t).wall_contacts); });
  text += row("contacts with teammates", [&](TeamId t) { return fmt::format("{}", of(t).mate_contacts); });
  // One number, since each such contact involves both teams.
  text += row("contacts with opponents", [&](TeamId) { return fmt::format("{}", s.opponent_contacts); });
  text += row("commands rejected",
              [&](TeamId t) { return fmt::format("{}", report.faults.teams[indexOf(t)].rejected()); });
  return text;
}

std::string restartRows(const MatchStatistics& s) {
  std::string text;
  for (std::size_t kind = 0; kind < s.restarts.size(); ++kind) {
    if (s.restartCount(static_cast<RestartKind>(kind)) == 0) continue;
    text += row(pluralOf(static_cast<RestartKind>(kind)),
                [&](TeamId t) { return fmt::format("{}", s.restarts[kind][indexOf(t)]); });
  }
  for (const CallCount& call : s.calls) {
    if (call.against[0] + call.against[1] == 0 || !isFault(call.clause)) continue;
    text += row(fmt::format("against: {}", call.clause), [&](TeamId t) {
      const int paid = call.paid[indexOf(t)];
      return fmt::format("{}{}", call.against[indexOf(t)], paid > 0 ? fmt::format(" ({} paid)", paid) : "");
    });
  }
  text += row(fmt::format("goals within {:g} s of own foul", kFoulPaysWithin),
              [&](TeamId t) { return fmt::format("{}", s.teams[indexOf(t)].goals_after_foul); });
  return text;
}

std::string headline(const MatchReport& report) {
  const MatchConfig& c = report.config;
  std::string text =
      fmt::format("{} (blue) {} : {} {} (yellow)", nameOf(report, TeamId::kBlue), report.referee.score[0],
                  report.referee.score[1], nameOf(report, TeamId::kYellow));
  if (!report.complete) text += ", stopped early";
  if (report.edits > 0) text += ", edited";
  if (report.referee.period == kShootOutPeriod) {
    text += fmt::format(", shoot-out {} : {}", report.referee.shoot_out.goals[0],
                        report.referee.shoot_out.goals[1]);
  }
  return text + fmt::format("\n{}, halves of {:g} s, {} physics, seed {}\n", c.rules.name,
                            c.rules.half_seconds, c.physics.name, c.seed);
}

/// A number with its noun in singular or plural.
std::string counted(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string faultLines(const MatchReport& report) {
  std::string text;
  if (report.faults.abandoned) text += "the match was abandoned: " + report.faults.abandoned->message + "\n";
  for (const TeamId team : kTeams) {
    const TeamFaults& faults = report.faults.teams[indexOf(team)];
    if (faults.failures == 0) continue;
    text += fmt::format("{} ({}) failed {}, last: {}{}\n", nameOf(report, team), nameOf(team),
                        counted(static_cast<int>(faults.failures), "time", "times"), faults.failure,
                        faults.forfeited ? "; it forfeits the match" : "");
  }
  return text;
}

}  // namespace

MatchReport reportOf(const Match& match, const StatisticsObserver& statistics, const EventLog& events) {
  MatchReport report;
  report.config = match.config();
  report.referee = match.referee();
  report.faults = match.faults();
  report.complete = match.referee().ended && !report.faults.abandoned;
  report.edits = match.edits();
  report.statistics = statistics.statistics();
  report.events = events.events();
  report.events_left_out = events.leftOut();
  report.final_hash = match.hash();
  report.simulated = match.seconds();
  return report;
}

std::string matchText(const MatchReport& report) {
  const MatchStatistics& s = report.statistics;
  std::string text = headline(report) + faultLines(report);
  if (!s.goals.empty()) text += "\n";
  for (const GoalRecord& goal : s.goals) text += goalLine(report, goal);
  text += "\n" + row("", [&](TeamId t) { return columnText(report, t); });
  text += ballRows(s) + playRows(s) + robotRows(report) + restartRows(s);
  text += "\n" + speedLine(report.simulated, report.wall);
  text += fmt::format("  final hash {:016x}\n", report.final_hash);
  if (report.profile) text += "\n" + profileText(*report.profile);
  return text;
}

std::string speedLine(double simulated, double wall) {
  if (!(wall > 0.0)) return fmt::format("  {:.1f} s simulated\n", simulated);
  return fmt::format("  {:.1f} s simulated in {:.2f} s: {}\n", simulated, wall, paceText(simulated, wall));
}

std::string paceText(double simulated, double wall) {
  if (!(wall > 0.0)) return {};
  const double times = simulated / wall;
  return times < 10.0 ? fmt::format("{:.2g} x real time", times) : fmt::format("{:.0f} x real time", times);
}

std::string profileText(const MatchProfile& profile) {
  const std::pair<const char*, std::int64_t> stages[] = {
      {"sense", profile.sense},     {"strategies", profile.decide}, {"navigation", profile.navigate},
      {"physics", profile.step},    {"referee", profile.referee},   {"restarts", profile.restart},
      {"recording", profile.record}};
  const double ticks = profile.ticks > 0 ? static_cast<double>(profile.ticks) : 1.0;
  const double total = profile.total() > 0 ? static_cast<double>(profile.total()) : 1.0;
  std::string text = fmt::format("  {:<12}{:>8}{:>14}\n", "stage", "share", "us per tick");
  for (const auto& [name, time] : stages) {
    text += fmt::format("  {:<12}{:>6.1f} %{:>14.2f}\n", name, 100.0 * static_cast<double>(time) / total,
                        1e-3 * static_cast<double>(time) / ticks);
  }
  return text + fmt::format("  {:<12}{:>6.1f} %{:>14.2f}\n", "all", 100.0, 1e-3 * total / ticks);
}

}  // namespace fulbito
