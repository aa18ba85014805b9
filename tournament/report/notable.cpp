#include "tournament/report/notable.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "tournament/report/counted_results.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostFaults = 8;
constexpr std::size_t kMostUpsets = 6;
constexpr int kMostOfOne = 2;  // limit for faults of one kind and team, and for upsets of one pairing
constexpr int kNameColumns = 24;
constexpr int kReasonColumns = 80;

/// A match that may be notable. Candidates are sorted by decreasing `worse`, then by the schedule.
struct Candidate {
  double worse = 0.0;
  std::size_t fixture = 0, leg = 0;
  std::size_t team = 0, opponent = 0;  // team: the one at fault, the winner of an upset, or the loser
  std::string why;
};

void sortWorstFirst(std::vector<Candidate>& list) {
  std::sort(list.begin(), list.end(), [](const Candidate& x, const Candidate& y) {
    return std::tuple(-x.worse, x.fixture, x.leg, x.team) < std::tuple(-y.worse, y.fixture, y.leg, y.team);
  });
}

class Search {
 public:
  Search(const TournamentState& state, const TournamentTable& table) : state_(state), table_(table) {}

  void look(std::size_t fixture, std::size_t leg) {
    const MatchResult& result = state_.results[fixture]->legs[leg];
    for (std::size_t seat = 0; seat < 2; ++seat) lookAtFaults(fixture, leg, seat, result);
    if (result.faults.abandoned && ++abandoned_ <= kMostOfOne) {
      faults_.push_back(
          candidate(1.0, fixture, leg, 0, "abandoned: " + reason(result.faults.abandoned->message)));
    }
    if (!result.winner) return;
    const std::size_t winner = indexOf(*result.winner);
    lookForUpset(fixture, leg, winner);
    lookAtLoss(fixture, leg, 1 - winner, result);
  }

  std::vector<NotableMatch> found() {
    sortWorstFirst(faults_);
    sortWorstFirst(upsets_);
    std::vector<Candidate> losses;
    losses.reserve(worst_loss_.size());
    for (const auto& [team, loss] : worst_loss_) losses.push_back(loss);
    sortWorstFirst(losses);
    take(faults_, kMostFaults);
    take(upsets_, kMostFaults + kMostUpsets);
    take(losses, kMostNotable);
    return std::move(list_);
  }

 private:
  std::string name(std::size_t entrant) const {
    return shownText(state_.plan.entrants[entrant].name, kNameColumns);
  }
  static std::string reason(const std::string& text) { return shownText(text, kReasonColumns); }

  Candidate candidate(double worse, std::size_t fixture, std::size_t leg, std::size_t seat,
                      std::string why) const {
    const Fixture& f = state_.schedule.fixtures[fixture];
    return {worse, fixture, leg, entrantAt(f, leg, seat), entrantAt(f, leg, 1 - seat), std::move(why)};
  }

  void lookAtFaults(std::size_t fixture, std::size_t leg, std::size_t seat, const MatchResult& result) {
    const MatchOutcome outcome = outcomeOfSeat(result, seat);
    if (outcome != MatchOutcome::kForfeit && outcome != MatchOutcome::kCrash) return;
    const bool forfeit = outcome == MatchOutcome::kForfeit;
    Candidate found = candidate(forfeit ? 3.0 : 2.0, fixture, leg, seat, {});
    if (++faults_of_[{found.team, forfeit}] > kMostOfOne) return;
    const std::string& failure = result.faults.teams[seat].failure;
    found.why = fmt::format("{} {}{}{}", name(found.team), forfeit ? "forfeited" : "crashed",
                            failure.empty() ? "" : ": ", reason(failure));
    faults_.push_back(std::move(found));
  }

  void lookForUpset(std::size_t fixture, std::size_t leg, std::size_t winner) {
    Candidate found = candidate(0.0, fixture, leg, winner, {});
    const Ratings& ratings = table_.ratings;
    const Interval &low = ratings.elo[found.team], &high = ratings.elo[found.opponent];
    found.worse = high.value - low.value;
    const bool same_group = ratings.component[found.team] == ratings.component[found.opponent];
    if (!same_group || !(found.worse >= kUpsetElo && low.high < high.low)) return;
    if (++upsets_of_[{found.team, found.opponent}] > kMostOfOne) return;
    found.why = fmt::format("upset: {} ({:+.0f}) beat {} ({:+.0f})", name(found.team), low.value,
                            name(found.opponent), high.value);
    upsets_.push_back(std::move(found));
  }

  void lookAtLoss(std::size_t fixture, std::size_t leg, std::size_t loser, const MatchResult& result) {
    const double deficit = result.score[1 - loser] - result.score[loser];
    const std::size_t team = entrantAt(state_.schedule.fixtures[fixture], leg, loser);
    const auto before = worst_loss_.find(team);
    if (before != worst_loss_.end() && before->second.worse >= deficit) return;
    Candidate found = candidate(deficit, fixture, leg, loser, {});
    found.why = fmt::format("{} lost {}:{} to {} from {}", name(team), result.score[loser],
                            result.score[1 - loser], name(found.opponent),
                            bookEntry(state_.plan.book, state_.schedule.fixtures[fixture].start).name);
    worst_loss_.insert_or_assign(team, std::move(found));
  }

  /// Appends candidates until the list has `most`; no match twice.
  void take(const std::vector<Candidate>& list, std::size_t most) {
    for (const Candidate& c : list) {
      if (list_.size() >= most) return;
      if (!listed_.insert({c.fixture, c.leg}).second) continue;
      list_.push_back({c.fixture, c.leg, idOf(state_, c.fixture, c.leg), c.why});
    }
  }

  const TournamentState& state_;
  const TournamentTable& table_;
  // Numbers of faults and upsets found so far: a long log may be full of them.
  std::map<std::pair<std::size_t, bool>, int> faults_of_;
  std::map<std::pair<std::size_t, std::size_t>, int> upsets_of_;
  int abandoned_ = 0;
  std::vector<Candidate> faults_, upsets_;
  std::map<std::size_t, Candidate> worst_loss_;
  std::vector<NotableMatch> list_;
  std::set<std::pair<std::size_t, std::size_t>> listed_;
};

}  // namespace

std::vector<NotableMatch> notableMatches(const TournamentState& state,
                                         const std::vector<std::size_t>& counted,
                                         const TournamentTable& table) {
  Search search(state, table);
  for (const std::size_t fixture : counted) {
    for (std::size_t leg = 0; leg < 2; ++leg) search.look(fixture, leg);
  }
  return search.found();
}

}  // namespace fulbito
