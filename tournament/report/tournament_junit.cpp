#include <iterator>
#include <map>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"
#include "match/report/match_json.hpp"
#include "tournament/report/counted_results.hpp"
#include "tournament/report/match_report.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

constexpr int kMessageColumns = 300;

/// The test cases of a pairing, or of the whole tournament.
struct Suite {
  std::string name;  // escaped for XML
  std::string cases;
  int tests = 0, errors = 0, failures = 0, skipped = 0;

  void add(const std::string& test, const std::string& inside) {
    ++tests;
    fmt::format_to(std::back_inserter(cases), "    <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n",
                   name, test, inside);
  }
  void appendTo(std::string& xml) const {
    xml +=
        fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
                    name, tests, failures, errors, skipped);
    xml += cases;
    xml += "  </testsuite>\n";
  }
};

class Junit {
 public:
  Junit(const TournamentState& state, const RecordingLinks& recordings)
      : state_(state), recordings_(recordings) {
    for (std::size_t i = 0; i < state.plan.entrants.size(); ++i)
      names_.push_back(escapedXml(shownName(state, i)));
  }

  std::string xml() {
    Suite whole = tournamentSuite();
    for (const std::size_t number : countedFixtures(state_)) {
      for (std::size_t leg = 0; leg < 2; ++leg) addMatch(number, leg);
    }
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += fmt::format("<testsuites name=\"{}\">\n", whole.name);
    std::size_t size = text.size() + whole.cases.size() + 4096;
    for (const Suite& suite : suites_) size += suite.cases.size() + suite.name.size() + 256;
    text.reserve(size);  // the text of a long log takes tens of megabytes
    whole.appendTo(text);
    for (const Suite& suite : suites_) suite.appendTo(text);
    text += "</testsuites>\n";
    return text;
  }

 private:
  /// A suite with two cases: the tournament is complete, and the verdict of its sequential test.
  Suite tournamentSuite() const {
    Suite suite{escapedXml(shownText(state_.plan.name, kMessageColumns)), {}};
    const auto skip = [&suite](const std::string& why) {
      ++suite.skipped;
      return fmt::format("<skipped message=\"{}\"/>", escapedXml(why));
    };
    suite.add("finished", state_.finished() ? "" : skip("matches are missing" + firstReason()));
    if (!state_.sprt) return suite;
    std::string inside;
    if (state_.sprt->verdict() == SprtVerdict::kFail) {
      ++suite.failures;
      inside = fmt::format("<failure message=\"{}\"/>", escapedXml(meaningOf(state_)));
    } else if (state_.sprt->verdict() == SprtVerdict::kInconclusive) {
      inside = skip("inconclusive: " + meaningOf(state_));
    }
    suite.add("sequential test", inside);
    return suite;
  }

  std::string firstReason() const {
    if (state_.unplayed.empty()) return {};
    const UnplayedMatch& first = state_.unplayed.front();
    return fmt::format("; not played: {}, {}", numberOf(first.fixture, first.leg),
                       shownText(first.reason, kMessageColumns));
  }

  Suite& suiteOf(const Fixture& fixture) {
    const auto key = std::minmax(fixture.a, fixture.b);
    const auto [at, is_new] = index_.try_emplace(std::pair(key.first, key.second), suites_.size());
    if (is_new) suites_.push_back({names_[fixture.a] + " against " + names_[fixture.b], {}});
    return suites_[at->second];
  }

  /// The error elements of the teams that crashed or forfeited.
  std::string errorsOf(const Fixture& fixture, std::size_t leg, const MatchResult& result) const {
    std::string inside;
    for (std::size_t seat = 0; seat < 2; ++seat) {
      const MatchOutcome outcome = outcomeOfSeat(result, seat);
      if (outcome != MatchOutcome::kCrash && outcome != MatchOutcome::kForfeit) continue;
      inside +=
          errorOf(nameOf(outcome), names_[entrantAt(fixture, leg, seat)], result.faults.teams[seat].failure);
    }
    if (result.faults.abandoned)
      inside += errorOf("abandoned", "the match", result.faults.abandoned->message);
    return inside;
  }

  static std::string errorOf(std::string_view type, const std::string& who, const std::string& reason) {
    return fmt::format("<error type=\"{}\" message=\"{}: {}\"/>", type, who,
                       escapedXml(shownText(reason.empty() ? "no reason" : reason, kMessageColumns)));
  }

  std::string outputOf(std::size_t number, std::size_t leg) const {
    const MatchResult& result = state_.results[number]->legs[leg];
    const std::string id = idOf(state_, number, leg).text();
    std::string text =
        fmt::format("score {}:{}, {}\nseed {}\nid {}\nhash {}", result.score[0], result.score[1],
                    nameOf(result.outcome), state_.results[number]->seed, id, hashText(result.hash));
    const auto recording = recordings_.find(id);
    if (recording != recordings_.end()) text += "\nrecording " + escapedXml(recording->second);
    return "<system-out>" + text + "</system-out>";
  }

  void addMatch(std::size_t number, std::size_t leg) {
    const Fixture& fixture = state_.schedule.fixtures[number];
    const std::string errors = errorsOf(fixture, leg, state_.results[number]->legs[leg]);
    Suite& suite = suiteOf(fixture);
    suite.errors += errors.empty() ? 0 : 1;
    suite.add(fmt::format("{} {} (blue {}, yellow {})", numberOf(number, leg),
                          bookEntry(state_.plan.book, fixture.start).name, names_[entrantAt(fixture, leg, 0)],
                          names_[entrantAt(fixture, leg, 1)]),
              errors + outputOf(number, leg));
  }

  const TournamentState& state_;
  const RecordingLinks& recordings_;
  std::vector<std::string> names_;  // by entrant, escaped for XML
  std::vector<Suite> suites_;       // in the order of the schedule
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> index_;
};

}  // namespace

std::string tournamentJunit(const TournamentState& state, const TournamentTable&,
                            const RecordingLinks& recordings) {
  return Junit(state, recordings).xml();
}

}  // namespace fulbito
