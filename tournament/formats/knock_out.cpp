#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tournament/formats/format.hpp"
#include "tournament/formats/meeting.hpp"

namespace fulbito {
namespace {

/// The largest number of further pairs of a level tie. They are played one at a time.
constexpr int kMostExtraPairs = 3;

/// The state of a knock-out.
struct KnockOutCourse {
  Schedule schedule;
  std::vector<KnockOutTie> ties;  ///< see `bracketOf`
};

/// The order of `size` seeds (a power of two) in a bracket: the best two can only meet in the final, the best
/// four not before the semi-finals. For 8: 0 7 3 4 1 6 2 5.
std::vector<std::size_t> bracketOrder(std::size_t size) {
  std::vector<std::size_t> order{0};
  while (order.size() < size) {
    std::vector<std::size_t> next;
    for (const std::size_t seed : order) {
      next.push_back(seed);
      next.push_back(2 * order.size() - 1 - seed);
    }
    order = std::move(next);
  }
  return order;
}

class KnockOut {
 public:
  KnockOut(const TournamentPlan& plan, ResultsView results) : plan_(plan), results_(results) { draw(); }

  KnockOutCourse play() {
    std::size_t round = 0;
    while (round < rounds_.size() && playRound(round)) ++round;
    course_.schedule.complete = round == rounds_.size();
    return std::move(course_);
  }

 private:
  /// A tie with two entrants that is not decided.
  struct Open {
    KnockOutTie* tie;
    MeetingScore score;
  };

  KnockOutTie& tie(std::size_t round, std::size_t place) { return course_.ties[rounds_[round] + place]; }

  void draw() {
    std::size_t size = 2;
    while (size < plan_.entrants.size()) size *= 2;
    for (std::size_t ties = size / 2, round = 0; ties > 0; ties /= 2, ++round) {
      rounds_.push_back(course_.ties.size());
      course_.ties.resize(course_.ties.size() + ties);
      for (std::size_t i = 0; i < ties; ++i) tie(round, i).round = static_cast<int>(round);
    }
    if (plan_.entrants.size() >= 4) {
      KnockOutTie& third = course_.ties.emplace_back();
      third.round = static_cast<int>(rounds_.size()) - 1;
      third.third_place = true;
    }
    seed(bracketOrder(size));
  }

  void seed(const std::vector<std::size_t>& order) {
    for (std::size_t i = 0; i < order.size() / 2; ++i) {
      KnockOutTie& first = tie(0, i);
      first.a = order[2 * i];
      if (order[2 * i + 1] < plan_.entrants.size()) {
        first.b = order[2 * i + 1];
      } else {
        decide(first, 0, "bye");
      }
    }
  }

  /// Decides a tie. The winner enters its next tie at once, so that the bracket shows who waits for an
  /// opponent.
  void decide(KnockOutTie& tie, std::size_t side, std::string by) {
    tie.winner = side == 0 ? tie.a : tie.b;
    tie.decided_by = std::move(by);
    const auto round = static_cast<std::size_t>(tie.round);
    if (round + 1 >= rounds_.size()) return;
    const auto place = static_cast<std::size_t>(&tie - &this->tie(round, 0));
    seat(this->tie(round + 1, place / 2), place, tie.winner);
    const bool semi_final = round + 2 == rounds_.size();
    if (semi_final && course_.ties.back().third_place) {
      seat(course_.ties.back(), place, side == 0 ? tie.b : tie.a);
    }
  }

  static void seat(KnockOutTie& next, std::size_t place, std::optional<std::size_t> entrant) {
    (place % 2 == 0 ? next.a : next.b) = entrant;
  }

  /// Plays the ties of a round. Returns whether all of them are decided.
  bool playRound(std::size_t round) {
    std::vector<Open> open;
    for (KnockOutTie& tie : course_.ties) {
      if (tie.round == static_cast<int>(round) && !tie.winner) open.push_back({&tie, {}});
    }
    for (int extra = 0; extra <= kMostExtraPairs; ++extra) {
      if (!playPairs(open, extra)) return false;
      std::erase_if(open, [](const Open& one) { return one.tie->winner.has_value(); });
    }
    return true;
  }

  /// Schedules the plan's pairs (`extra` 0) or one further pair for each tie. Returns whether all have
  /// results.
  bool playPairs(std::vector<Open>& open, int extra) {
    bool all = true;
    for (auto& [tie, score] : open) {
      const auto start = static_cast<std::size_t>(extra == 0 ? 0 : plan_.pairs + extra - 1);
      const auto fixtures = addMeeting(course_.schedule.fixtures, {*tie->a, *tie->b, tie->round, start},
                                       extra == 0 ? plan_.pairs : 1);
      const bool known = addResults(results_, fixtures, score);
      show(score, *tie);
      if (known) judge(*tie, score, extra);
      all = all && known;
    }
    return all;
  }

  static void show(const MeetingScore& score, KnockOutTie& tie) {
    tie.points_a = score.points[0], tie.points_b = score.points[1];
    tie.goals_a = score.goals[0], tie.goals_b = score.goals[1];
  }

  void judge(KnockOutTie& tie, const MeetingScore& score, int extra) {
    const auto winner = score.winner();
    if (winner && extra > 0) {
      decide(tie, *winner, fmt::format("extra pair {}", extra));
    } else if (winner) {
      decide(tie, *winner, score.points[0] != score.points[1] ? "points" : "goal difference");
    } else if (extra == kMostExtraPairs) {
      decide(tie, *tie.a < *tie.b ? 0 : 1, "seeding");
    }
  }

  const TournamentPlan& plan_;
  ResultsView results_;
  KnockOutCourse course_;
  std::vector<std::size_t> rounds_;  // index of the first tie of each round
};

/// Plays all rounds. Each tie has the plan's pairs and is decided by points of matches, then goal difference,
/// then further pairs, then the better seeding. All ties of a round have the same number of pairs before
/// further pairs are scheduled.
KnockOutCourse knockOutCourse(const TournamentPlan& plan, ResultsView results) {
  return KnockOut(plan, results).play();
}

Schedule knockOutSchedule(const TournamentPlan& plan, ResultsView results) {
  return knockOutCourse(plan, results).schedule;
}

/// The loser of each tie leaves, so n entrants need n - 1 ties. From four entrants on, the match for the
/// third place is added.
std::int64_t mostMeetings(const TournamentPlan& plan) {
  const auto entrants = static_cast<std::int64_t>(plan.entrants.size());
  return (entrants - (entrants >= 4 ? 0 : 1)) * (plan.pairs + kMostExtraPairs);
}

/// How far each entrant came in a knock-out.
struct Progress {
  explicit Progress(std::size_t entrants)
      : rounds{"round reached", std::vector<double>(entrants)},
        still_in{"still in", std::vector<double>(entrants, 1.0)},
        third{"match for the third place", std::vector<double>(entrants)} {}

  void add(const KnockOutTie& tie) {
    if (!tie.winner) return;
    const auto& loser = tie.winner == tie.a ? tie.b : tie.a;
    if (tie.third_place) {
      third.values[*tie.winner] = 1.0;
      return;
    }
    rounds.values[*tie.winner] += 1.0;
    if (loser) still_in.values[*loser] = 0.0;
  }

  Criterion rounds, still_in, third;
};

/// Ranks by the round reached, then who is still in, then the match for the third place. Others share a rank.
std::vector<Standing> knockOutTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  Progress progress(table.size());
  for (const KnockOutTie& tie : knockOutCourse(counted.plan, counted.results).ties) {
    progress.add(tie);
    if (tie.decided_by == "bye") ++table[*tie.winner].byes;
  }
  return ranked(std::move(table), std::array{progress.rounds, progress.still_in, progress.third}, "");
}

}  // namespace

std::vector<KnockOutTie> bracketOf(const TournamentPlan& plan, const FixtureResults& results) {
  if (plan.format != TournamentFormat::kKnockOut) return {};
  return knockOutCourse(plan, results).ties;
}

extern const Format kKnockOutFormat{
    .schedule = knockOutSchedule, .table = knockOutTable, .most_fixtures = mostMeetings};

}  // namespace fulbito
