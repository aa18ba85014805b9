#include <algorithm>
#include <regex>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/markup.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/html/html_parts.hpp"
#include "tournament/report/report.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

const std::vector<std::string> kNoEnd = {"meta", "link"};

std::string pageOf(const TournamentState& state, const RecordingLinks& recordings = {}) {
  constexpr std::size_t kResamples = 20;  // saves time; the size of the page does not depend on it
  return tournamentHtml(state, tableOf(state, kResamples), recordings);
}

/// The page without its style sheet, which is not markup.
std::string withoutStyle(const std::string& page) {
  const std::size_t from = page.find("<style>"), to = page.find("</style>");
  return page.substr(0, from) + page.substr(to + 8);
}

/// All addresses in links, images and styles, which a browser could load.
std::vector<std::string> addressesOf(const std::string& page) {
  static const std::regex address(R"re((?:href|src|action|data|poster)="([^"]*)"|url\(([^)]*)\)|@import)re");
  std::vector<std::string> found;
  for (std::sregex_iterator at(page.begin(), page.end(), address), end; at != end; ++at) {
    found.push_back((*at)[1].matched ? (*at)[1].str() : (*at)[0].str());
  }
  return found;
}

}  // namespace

TEST_CASE("the page has the parts of a league", "[unit]") {
  StateMaker maker = madeUpRoundRobin({"alpha", "beta", "gamma"}, 4);
  maker.state().plan.book.kinds = {StartKind::kKickOff, StartKind::kPlay};
  const std::string page = pageOf(maker.state());
  for (const char* title : {"Standings", "Ratings", "Rating over time [Elo]",
                            "Cross-table: ", "Points share [%] by", "Matches to look at"}) {
    INFO(title);
    CHECK(page.find(std::string("<h2>") + title) != std::string::npos);
  }
  CHECK(page.find("<h2>Bracket") == std::string::npos);
  CHECK(flawOfMarkup(withoutStyle(page), kNoEnd).empty());
}

TEST_CASE("the page of a knock-out has its bracket, with byes and open ties", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kKnockOut, {"alpha", "beta", "gamma"}));
  maker.add({1, 2, 0, 0}, pairOf({3, 1}, {1, 1})).add({0, 1, 1, 0}, std::nullopt);
  const std::string page = pageOf(maker.state());
  CHECK(page.find("<h2>Bracket</h2>") != std::string::npos);
  CHECK(page.find("<h3>semi-final</h3>") < page.find("<h3>final</h3>"));
  CHECK(page.find("<bdi>bye</bdi>") != std::string::npos);
  CHECK(flawOfMarkup(withoutStyle(page), kNoEnd).empty());
}

TEST_CASE("the page of a test has its verdict and bar", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}, 40));
  for (std::size_t i = 0; i < 40; ++i) maker.add({0, 1, 0, i}, pairOf({3, 0}, {1, 0}));
  maker.test({-50, 0, 0.05, 0.05});
  const std::string page = pageOf(maker.state());
  CHECK(page.find("<p class=\"verdict pass\">pass</p>") != std::string::npos);
  CHECK(page.find("aria-label=\"log-likelihood ratio ") != std::string::npos);
  CHECK(flawOfMarkup(withoutStyle(page), kNoEnd).empty());
}

TEST_CASE("a page before the first match is a page", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kSwiss, {"alpha", "beta"}));
  maker.add({0, 1, 0, 0}, std::nullopt);
  const std::string page = pageOf(maker.state());
  CHECK(page.find("<h2>Standings</h2>") != std::string::npos);
  CHECK(flawOfMarkup(withoutStyle(page), kNoEnd).empty());
}

TEST_CASE("the page loads nothing, runs nothing and allows neither", "[unit]") {
  const std::string page = pageOf(madeUpRoundRobin(hostileNames()).state());
  CHECK(addressesOf(page) == std::vector<std::string>{"data:,"});
  CHECK(page.find("http") == page.find("http-equiv"));
  CHECK(page.find("http", page.find("http-equiv") + 4) == std::string::npos);
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("style=\"") == std::string::npos);  // the content security policy forbids inline styles
  CHECK(std::regex_search(page,
                          std::regex("content=\"default-src 'none'; style-src 'sha256-[A-Za-z0-9+/]{43}='; "
                                     "img-src data:; base-uri 'none'; form-action 'none'\"")));
}

TEST_CASE("hostile names stay text in the page", "[unit]") {
  const std::string page = pageOf(madeUpRoundRobin(hostileNames()).state());
  CHECK(flawOfMarkup(withoutStyle(page), kNoEnd).empty());
  CHECK(page.find("&lt;script&gt;alert(1)&lt;/script&gt;") != std::string::npos);
  CHECK(page.find("<img") == std::string::npos);
  CHECK(page.find("{{style}}") != std::string::npos);     // a placeholder in a name is not replaced
  CHECK(page.find("\xe2\x80\xae") == std::string::npos);  // right-to-left override
  CHECK(page.find(std::string(100, 'x')) == std::string::npos);
}

TEST_CASE("links to recordings stay beside the page", "[unit]") {
  CHECK(relativeAddress("match.recordings/00ff.html") == "./match.recordings/00ff.html");
  CHECK(relativeAddress("javascript:alert(1)") == "./javascript%3Aalert%281%29");
  CHECK(relativeAddress("//host/x") == ".///host/x");
  CHECK(relativeAddress("a b\"<>") == "./a%20b%22%3C%3E");
  const StateMaker maker = madeUpRoundRobin({"alpha", "beta"});
  const TournamentTable table = tableOf(maker.state());
  REQUIRE_FALSE(table.notable.empty());
  const std::string page =
      tournamentHtml(maker.state(), table, {{table.notable[0].id.text(), "games/one.html"}});
  CHECK(page.find("<a href=\"./games/one.html\" title=\"watch\">") != std::string::npos);
  CHECK(pageOf(maker.state()).find("<a ") == std::string::npos);
}

TEST_CASE("the page of 40 entrants is below 1 MiB, and that of 300 not far above it", "[unit]") {
  std::vector<std::string> names = teamNames(40);
  for (std::string& name : names) name += std::string(200, '&');
  CHECK(pageOf(madeUpRoundRobin(names).state()).size() < 1024 * 1024);
  StateMaker maker(planOf(TournamentFormat::kSwiss, teamNames(300)));
  for (std::size_t i = 0; i + 1 < 300; ++i) maker.add({i, i + 1, 0, 0}, madeUpPair({i, i + 1}, i));
  CHECK(pageOf(maker.state()).size() < 1024 * 1024);
}
