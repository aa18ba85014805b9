#include "match/drills/worth.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "strategies/interface/team_info.hpp"

namespace fulbito {
namespace {

constexpr const char* kAll = "all";

/// The names of a team's skills, each once: two roles may share one.
std::vector<std::string> skillNames(const TeamInfo& info) {
  std::vector<std::string> names;
  for (const SkillInfo& skill : info.skills) {
    if (std::find(names.begin(), names.end(), skill.name) == names.end()) names.push_back(skill.name);
  }
  return names;
}

/// The specification of the team with `skill` left out too.
std::string specificationWithout(const TeamChoice& team, const std::string& skill) {
  for (const Setting& setting : team.settings) {
    if (setting.name != kWithoutSetting) continue;
    const std::string part = fmt::format("{}={}", setting.name, setting.value);
    std::string text = team.text;
    return text.insert(text.find(part) + part.size(), "+" + skill);
  }
  return fmt::format("{}{}{}={}", team.text, team.settings.empty() ? ':' : ',', kWithoutSetting, skill);
}

/// Errors: kUsage if the team cannot do without the skill.
Result<LeftOut> leaveOut(const TeamChoice& team, const std::string& skill, const TeamCatalogue& catalogue) {
  auto choice = catalogue.parse(specificationWithout(team, skill));
  if (!choice) return tl::unexpected<Error>(choice.error());
  if (const auto made = makeTeam(*choice); !made) return tl::unexpected<Error>(made.error());
  return LeftOut{skill, std::move(*choice)};
}

std::vector<LeftOut> leaveOutAll(const TeamChoice& team, const TeamCatalogue& catalogue) {
  std::vector<LeftOut> list;
  for (const std::string& skill : skillNames(*team.info)) {
    if (auto left_out = leaveOut(team, skill, catalogue)) list.push_back(std::move(*left_out));
  }
  return list;
}

Error noSkills(const TeamChoice& team, const TeamCatalogue& catalogue) {
  std::vector<std::string> with_skills;
  for (const auto& info : catalogue.teams()) {
    if (!info->skills.empty()) with_skills.push_back(info->name);
  }
  std::string text = fmt::format("--without: {} has no list of skills", team.info->name);
  if (!with_skills.empty()) text += fmt::format("; these teams have one: {}", fmt::join(with_skills, ", "));
  return {ErrorCode::kUsage, text};
}

Error noSuchSkill(const TeamChoice& team, const std::string& skill) {
  const std::vector<std::string> names = skillNames(*team.info);
  return {ErrorCode::kUsage,
          fmt::format("--without: {} has no skill '{}'.{} It must be {} or one of {}.", team.info->name,
                      skill, suggestion(skill, names), kAll, fmt::join(names, ", "))};
}

/// The interval of the difference of two paired rates.
/// @param gained, lost  trials that only the whole team, or only the other, succeeds in
Interval pairedRates(int gained, int lost, int count) {
  constexpr double kNormal = 1.96, kMore = 0.5;  // 95 %; added to each of four outcomes
  const double n = count + 4 * kMore, b = gained + kMore, c = lost + kMore;
  const double centre = (b - c) / n;
  const double half = kNormal * std::sqrt(std::max(0.0, b + c - (b - c) * centre)) / n;
  const double value = count > 0 ? static_cast<double>(gained - lost) / count : 0.0;
  return {value, std::max(-1.0, centre - half), std::min(1.0, centre + half)};
}

}  // namespace

Result<std::vector<LeftOut>> withoutEach(const TeamChoice& team, const std::vector<std::string>& skills,
                                         const TeamCatalogue& catalogue) {
  if (team.info->skills.empty()) return tl::unexpected<Error>(noSkills(team, catalogue));
  const std::vector<std::string> names = skillNames(*team.info);
  std::vector<LeftOut> list;
  for (const std::string& skill : skills) {
    if (skill == kAll) return leaveOutAll(team, catalogue);
    if (std::find(names.begin(), names.end(), skill) == names.end()) {
      return tl::unexpected<Error>(noSuchSkill(team, skill));
    }
    auto left_out = leaveOut(team, skill, catalogue);
    if (!left_out) return tl::unexpected<Error>(left_out.error());
    list.push_back(std::move(*left_out));
  }
  return list;
}

DrillWorth worthIn(const DrillReport& with, const DrillReport& without) {
  DrillWorth worth;
  std::vector<double> differences;
  int gained = 0, lost = 0;
  for (std::size_t i = 0; i < std::min(with.values.size(), without.values.size()); ++i) {
    const double first = with.values[i], second = without.values[i];
    if (std::isnan(first) || std::isnan(second)) continue;
    ++worth.count;
    gained += first > second ? 1 : 0;
    lost += first < second ? 1 : 0;
    worth.with += first;
    worth.without += second;
    differences.push_back(first - second);
  }
  if (worth.count == 0) return worth;
  worth.changed = gained + lost;
  worth.with /= worth.count;
  worth.without /= worth.count;
  worth.worth = with.ofMatches() ? meanInterval(differences) : pairedRates(gained, lost, worth.count);
  return worth;
}

Result<WorthReport> measureWorth(const std::vector<Drill>& drills, const std::vector<int>& numbers,
                                 const DrillOptions& options, const std::vector<LeftOut>& left_out,
                                 const std::function<DrillProgress(const std::string&)>& progress) {
  WorthReport report;
  auto whole = runDrills(drills, numbers, options, progress(options.team.text));
  if (!whole) return tl::unexpected<Error>(whole.error());
  report.whole = std::move(*whole);
  for (const LeftOut& part : left_out) {
    DrillOptions other = options;
    other.team = part.team;
    other.itself = options.itself.value_or(options.team);
    const auto ran = runDrills(drills, numbers, other, progress(part.team.text));
    if (!ran) return tl::unexpected<Error>(ran.error());
    SkillWorth worth{part, {}};
    for (std::size_t i = 0; i < ran->size(); ++i) worth.drills.push_back(worthIn(report.whole[i], (*ran)[i]));
    report.skills.push_back(std::move(worth));
  }
  return report;
}

}  // namespace fulbito
