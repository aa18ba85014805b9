#include "apps/match/rules.hpp"

#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/match/match.hpp"
#include "engine/core/system/error_text.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "referee/restarts/check_places.hpp"
#include "referee/rules/check_field.hpp"

namespace fulbito::app {
namespace {

int showRules(const std::string& name_or_file) {
  const auto loaded = loadRules(name_or_file);
  if (!loaded) return report(loaded.error());
  // A preset is printed with its comments. A file is printed with all keys, including those left to defaults.
  const std::vector<std::string> presets = rulesPresetNames();
  const bool preset = std::find(presets.begin(), presets.end(), name_or_file) != presets.end();
  const std::string text = preset ? rulesPresetText(name_or_file).value_or("") : toToml(*loaded);
  writeOut(text);
  return kOk;
}

int checkRules(const std::string& file) {
  const auto loaded = loadRules(file);
  if (!loaded) return report(loaded.error());
  const auto field = loadField(loaded->field);
  if (!field) return report(field.error());
  // The default ball of a match.
  const auto robot = loadRobot(MatchSettings().robot);
  if (!robot) return report(robot.error());
  if (auto playable = checkField(*loaded, *field, robot->ball); !playable) {
    return report(inFile(file, playable.error()).value());
  }
  say("{}: valid profile: {}, {} against {} on {}\n", file, loaded->name, loaded->team_size,
      loaded->team_size, loaded->field);
  if (const auto foreign = findForeignPlaces(*loaded, *field, robot->robot)) say("note: {}\n", *foreign);
  for (const std::string& place : findBadPlaces(*loaded, *field, robot->robot)) {
    say("note: {}; the referee moves it\n", place);
  }
  return kOk;
}

}  // namespace

CLI::App* addRules(CLI::App& app, RulesOptions& options) {
  CLI::App* command = app.add_subcommand("rules", "print, check or compare rules profiles");
  command->footer(
      "Examples:\n"
      "  fulbito rules show vsss-3v3                 every value with its source\n"
      "  fulbito rules show training > mine.toml     a profile to edit\n"
      "  fulbito rules check mine.toml\n"
      "  fulbito rules compare vsss-3v3 league-program-2021 game.fbr");
  command->add_subcommand("show", "print every value of a profile with its source")
      ->add_option("name", options.show, "profile or TOML file")
      ->required();
  command->add_subcommand("check", "check a profile; errors name file, line, key and range")
      ->add_option("file", options.check, "TOML file or profile")
      ->required();
  addRulesCompare(*command, options.compare);
  return command;
}

int rules(const RulesOptions& options) {
  if (!options.show.empty()) return showRules(options.show);
  if (!options.check.empty()) return checkRules(options.check);
  if (!options.compare.files.empty()) return compareRules(options.compare);
  return report({ErrorCode::kUsage,
                 "rules: needs show NAME, check FILE or compare A B RECORDING. See fulbito rules --help."});
}

}  // namespace fulbito::app
