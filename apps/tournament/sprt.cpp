#include "apps/tournament/sprt.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/option_values.hpp"
#include "apps/tournament/two_teams.hpp"

namespace fulbito::app {
namespace {

constexpr int kUsualPairs = 1000;

}  // namespace

void addSprt(CLI::App& app, SprtCommand& options) {
  CLI::App* command = app.add_subcommand("sprt", "test whether a new team is as strong as its base");
  command->footer(
      "Plays swapped pairs until a sequential test (GSPRT on pairs, normalized Elo) has a verdict. The "
      "verdict\n"
      "does not depend on --jobs. Exit codes: 0 pass, 1 fail, 6 inconclusive after --pairs.\n"
      "Examples:\n"
      "  fulbito sprt ./new.so ./old.so                          is the new version no weaker?\n"
      "  fulbito sprt libero classic --half-seconds 30\n"
      "  fulbito sprt ./new.so ./old.so --bounds 0,25 --pairs 5000   is it stronger?\n"
      "  fulbito sprt ./new.so ./old.so --out test --html test.html  keeps results; continues after a stop\n"
      "More: docs/statistics.md, docs/tournaments.md.");
  command->add_option("new", options.fresh, "the new team")->required();
  command->add_option("base", options.base, "the team that it must not be weaker than")->required();
  PlanSettings& settings = options.settings;
  settings.bounds = {-50.0, 0.0};
  settings.pairs = kUsualPairs;
  addBounds(*command, settings);
  wholeNumber(command->add_option("-n,--pairs", settings.pairs, "most pairs to play"), 1, kMostPairs)
      ->capture_default_str();
  addStarts(*command, settings);
  addMatchSettings(*command, settings.match, "NEW,BASE");
  addRunFlags(*command, options.flags);
  addRecordings(*command, options.flags);
  addReportFiles(*command, options.files);
}

int sprt(const SprtCommand& options) {
  return playTwoTeams(options.fresh, options.base, options.settings, options.flags, options.files);
}

}  // namespace fulbito::app
