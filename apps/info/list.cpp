#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/config/suggest.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> kKinds = {"teams",  "navigators", "suites", "cases",
                                         "robots", "physics",    "fields", "rules"};

std::string typeName(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterSpec::Type::kNumber:
      return "number";
    case ParameterSpec::Type::kInteger:
      return "integer";
    case ParameterSpec::Type::kFlag:
      return "flag";
    case ParameterSpec::Type::kChoice:
      return "choice";
  }
  return "";
}

std::string valueText(const ParameterSpec& spec) {
  if (spec.type == ParameterSpec::Type::kChoice)
    return spec.choices[static_cast<std::size_t>(spec.default_value)];
  if (spec.type == ParameterSpec::Type::kFlag) return spec.default_value != 0.0 ? "true" : "false";
  return fmt::format("{}", spec.default_value);
}

/// The default value of a parameter, in its JSON type.
Json defaultJson(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterSpec::Type::kNumber:
      return spec.default_value;
    case ParameterSpec::Type::kInteger:
      return static_cast<std::int64_t>(spec.default_value);
    case ParameterSpec::Type::kFlag:
      return spec.default_value != 0.0;
    case ParameterSpec::Type::kChoice:
      break;
  }
  return valueText(spec);
}

Json parameterJson(const ParameterSpec& spec) {
  Json json = {{"name", spec.name}, {"type", typeName(spec)}, {"default", defaultJson(spec)}};
  if (spec.type == ParameterSpec::Type::kChoice) json["choices"] = spec.choices;
  if (spec.type == ParameterSpec::Type::kNumber || spec.type == ParameterSpec::Type::kInteger) {
    json["minimum"] = spec.minimum;
    json["maximum"] = spec.maximum;
    json["unit"] = spec.unit;
  }
  json["doc"] = spec.doc;
  return json;
}

Json navigatorJson(const NavigatorInfo& info) {
  Json json = {
      {"name", info.name},     {"default", info.name == kDefaultNavigator}, {"summary", info.summary},
      {"source", info.source}, {"plans_speed", info.plans_speed},           {"parameters", Json::array()}};
  for (const ParameterSpec& spec : info.parameters) json["parameters"].push_back(parameterJson(spec));
  for (const ParameterSpec& spec : commonParameters()) json["parameters"].push_back(parameterJson(spec));
  return json;
}

Json teamJson(const TeamInfo& info) {
  Json json = {{"name", info.name},
               {"summary", info.summary},
               {"purpose", info.purpose},
               {"takes_navigator", info.takes_navigator},
               {"default_navigator", info.default_navigator},
               {"parameters", Json::array()},
               {"skills", Json::array()}};
  for (const ParameterSpec& spec : info.parameters) json["parameters"].push_back(parameterJson(spec));
  for (const SkillInfo& skill : info.skills) {
    json["skills"].push_back({{"role", skill.role}, {"name", skill.name}, {"summary", skill.summary}});
  }
  return json;
}

void printParameter(const ParameterSpec& spec) {
  std::string range;
  if (spec.type == ParameterSpec::Type::kChoice) {
    range = fmt::format("{}", fmt::join(spec.choices, "|"));
  } else if (spec.type != ParameterSpec::Type::kFlag) {
    range = fmt::format("{} ... {}{}", spec.minimum, spec.maximum, spec.unit.empty() ? "" : " " + spec.unit);
  }
  say("    {:<16} {:<9} {}{}{}\n", spec.name, valueText(spec), spec.doc, range.empty() ? "" : "; ", range);
}

void printNavigators() {
  for (const NavigatorInfo& info : navigators()) {
    say("{}{}{}\n  {}\n  source: {}\n", info.name, info.name == kDefaultNavigator ? " (default)" : "",
        info.plans_speed ? " *" : "", info.summary, info.source);
    for (const ParameterSpec& spec : info.parameters) printParameter(spec);
  }
  say("Parameters of all methods:\n");
  for (const ParameterSpec& spec : commonParameters()) printParameter(spec);
  say("* plans its own speeds. Example with parameters: --navigator "
      "bezier:clearance=0.03,follower=classic\n");
}

/// The play book, role by role, in the order of priority.
void printSkills(const std::vector<SkillInfo>& skills) {
  if (skills.empty()) return;
  say("    {:<16} {}\n", "without", "leaves skills out: NAME+NAME; all but the last of a role");
  std::string role;
  for (const SkillInfo& skill : skills) {
    if (skill.role != role) say("    skills of: {}\n", role = skill.role);
    say("      {:<14} {}\n", skill.name, skill.summary);
  }
}

void printTeams() {
  for (const auto& info : TeamCatalogue::builtIn().teams()) {
    say("{}{}\n  {}\n", info->name, info->purpose.empty() ? "" : " (for " + info->purpose + ")",
        info->summary);
    for (const ParameterSpec& spec : info->parameters) printParameter(spec);
    if (info->takes_navigator) {
      say("    {:<16} {}; any of fulbito list navigators\n", "navigator", info->default_navigator);
    }
    printSkills(info->skills);
  }
  say("Example with parameters: fulbito match classic:navigator=bezier:clearance=0.03+follower=classic\n");
}

/// The first sentence of the comment at the beginning of a preset file.
std::string firstSentence(const std::string& text) {
  std::string sentence;
  for (std::size_t begin = 0; text.compare(begin, 2, "# ") == 0;) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    sentence += (sentence.empty() ? "" : " ") + text.substr(begin + 2, end - begin - 2);
    const std::size_t stop = sentence.find(". ");
    if (stop != std::string::npos) return sentence.substr(0, stop);
    begin = std::min(end + 1, text.size());
  }
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

/// Names and one-line summaries of one kind, except teams and navigators.
std::vector<std::pair<std::string, std::string>> entries(const std::string& kind) {
  std::vector<std::pair<std::string, std::string>> list;
  if (kind == "suites") {
    list.emplace_back(
        kPaperSuite,
        "the comparison of Jung & Lee (2015): corner, close-range and the figures' cases (default)");
    for (const Suite& suite : suites()) list.emplace_back(suite.name, suite.summary);
  } else if (kind == "cases") {
    for (const Layout& layout : namedCases())
      list.emplace_back(layout.name, "layout for fulbito run --layout " + layout.name);
  } else if (kind == "rules") {
    for (const std::string& name : rulesPresetNames()) {
      list.emplace_back(name, firstSentence(rulesPresetText(name).value_or("")));
    }
  } else {
    for (const std::string& name : presetNames(kind)) {
      list.emplace_back(name, firstSentence(presetText(kind, name).value_or("")));
    }
  }
  return list;
}

void printJson(const std::string& kind) {
  Json json = {{"schema_version", 1}, {kind, Json::array()}};
  if (kind == "teams") {
    for (const auto& info : TeamCatalogue::builtIn().teams()) json[kind].push_back(teamJson(*info));
  } else if (kind == "navigators") {
    for (const NavigatorInfo& info : navigators()) json[kind].push_back(navigatorJson(info));
  } else {
    for (const auto& [name, summary] : entries(kind))
      json[kind].push_back({{"name", name}, {"summary", summary}});
  }
  writeOut(json.dump(2) + "\n");
}

}  // namespace

int list(const ListOptions& options) {
  if (std::find(kKinds.begin(), kKinds.end(), options.kind) == kKinds.end()) {
    return report(
        {ErrorCode::kUsage, fmt::format("list: there is no kind '{}'; it must be one of {}.{}", options.kind,
                                        fmt::join(kKinds, ", "), suggestion(options.kind, kKinds))});
  }
  if (options.json) {
    printJson(options.kind);
  } else if (options.kind == "teams") {
    printTeams();
  } else if (options.kind == "navigators") {
    printNavigators();
  } else {
    for (const auto& [name, summary] : entries(options.kind)) say("{:<30} {}\n", name, summary);
  }
  return kOk;
}

}  // namespace fulbito::app
