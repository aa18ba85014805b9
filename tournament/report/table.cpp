#include "tournament/report/table.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "tournament/report/counted_results.hpp"
#include "tournament/report/notable.hpp"

namespace fulbito {
namespace {

using Tallies = std::vector<std::vector<Tally>>;

Tallies tallies(std::size_t rows, std::size_t columns) { return Tallies(rows, std::vector<Tally>(columns)); }

std::vector<std::vector<MeetingSummary>> summaries(const Tallies& tallies) {
  std::vector<std::vector<MeetingSummary>> out(tallies.size());
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    for (const Tally& tally : tallies[i]) out[i].push_back(tally.summary());
  }
  return out;
}

/// Fills `cross`, `totals` and `starts` of the table.
void countMeetings(const TournamentState& state, const std::vector<std::size_t>& counted,
                   TournamentTable& table) {
  const std::size_t entrants = state.plan.entrants.size();
  Tallies cross = tallies(entrants, entrants), starts = tallies(entrants, kStartKinds);
  std::vector<Tally> totals(entrants);
  for (const std::size_t number : counted) {
    const Fixture& fixture = state.schedule.fixtures[number];
    const PairResult& pair = *state.results[number];
    const auto kind = static_cast<std::size_t>(bookEntry(state.plan.book, fixture.start).kind);
    for (const bool as_a : {true, false}) {
      const std::size_t mine = as_a ? fixture.a : fixture.b, theirs = as_a ? fixture.b : fixture.a;
      cross[mine][theirs].add(pair, as_a);
      starts[mine][kind].add(pair, as_a);
      totals[mine].add(pair, as_a);
    }
  }
  table.cross = summaries(cross);
  table.starts = summaries(starts);
  for (const Tally& tally : totals) table.totals.push_back(tally.summary());
}

/// Collects the results of each two entrants while fixtures are added, in the form that `rate` takes.
class Meetings {
 public:
  void add(const Fixture& fixture, const PairResult& pair) {
    const bool in_order = fixture.a < fixture.b;
    MeetingCounts& meeting = of(std::min(fixture.a, fixture.b), std::max(fixture.a, fixture.b));
    const auto points = [&](std::size_t leg) {
      return in_order ? pair.pointsOfLeg(leg) : 1.0 - pair.pointsOfLeg(leg);
    };
    meeting.pairs.add(points(0), points(1));
  }
  /// The meetings sorted by entrants, so that the order of play does not matter.
  std::vector<MeetingCounts> sorted() const {
    std::vector<MeetingCounts> list;
    list.reserve(meetings_.size());
    for (const auto& [teams, meeting] : meetings_) list.push_back(meeting);
    return list;
  }

 private:
  MeetingCounts& of(std::size_t a, std::size_t b) {
    MeetingCounts& meeting = meetings_[{a, b}];
    meeting.a = a;
    meeting.b = b;
    return meeting;
  }

  std::map<std::pair<std::size_t, std::size_t>, MeetingCounts> meetings_;
};

/// Adds the present ratings to `course` for each entrant that has played.
void addStep(const Ratings& ratings, const std::vector<char>& has_played,
             std::vector<std::vector<double>>& course) {
  for (std::size_t i = 0; i < course.size(); ++i) {
    course[i].push_back(has_played[i] != 0 ? ratings.elo[i].value : std::numeric_limits<double>::quiet_NaN());
  }
}

/// Fills the ratings and their course over the tournament.
void rateAll(const TournamentState& state, const std::vector<std::size_t>& counted, std::size_t resamples,
             TournamentTable& table) {
  const std::size_t entrants = state.plan.entrants.size();
  const std::size_t steps = std::min(kCourseSteps, counted.size());
  Meetings meetings;
  std::vector<char> has_played(entrants, 0);
  table.course.resize(entrants);
  std::size_t added = 0;
  for (std::size_t step = 1; step <= steps; ++step) {
    for (; added < counted.size() * step / steps; ++added) {
      const Fixture& fixture = state.schedule.fixtures[counted[added]];
      meetings.add(fixture, *state.results[counted[added]]);
      has_played[fixture.a] = has_played[fixture.b] = 1;
    }
    // The course contains estimates without intervals, so it needs no bootstrap.
    const bool last = step == steps;
    if (!last) addStep(rate(entrants, meetings.sorted(), state.plan.seed, 0), has_played, table.course);
  }
  table.ratings = rate(entrants, meetings.sorted(), state.plan.seed, resamples);
  if (steps > 0) addStep(table.ratings, has_played, table.course);
}

void countFaults(const TournamentState& state, const std::vector<std::size_t>& counted,
                 TournamentTable& table) {
  table.faults.resize(state.plan.entrants.size());
  for (const std::size_t number : counted) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const MatchResult& result = state.results[number]->legs[leg];
      for (std::size_t seat = 0; seat < 2; ++seat) {
        FaultSummary& faults = table.faults[entrantAt(state.schedule.fixtures[number], leg, seat)];
        ++faults.outcomes[static_cast<std::size_t>(outcomeOfSeat(result, seat))];
        const std::string& failure = result.faults.teams[seat].failure;
        if (!failure.empty()) faults.last_failure = failure;
      }
    }
  }
}

}  // namespace

TournamentTable tableOf(const TournamentState& state, std::size_t resamples) {
  TournamentTable table;
  const std::vector<std::size_t> counted = countedFixtures(state);
  table.standings = standingsOf(state.plan, state.schedule, state.results, state.counted);
  table.bracket = bracketOf(state.plan, state.results);
  countMeetings(state, counted, table);
  rateAll(state, counted, resamples, table);
  countFaults(state, counted, table);
  table.notable = notableMatches(state, counted, table);
  return table;
}

}  // namespace fulbito
