#pragma once

#include <functional>
#include <string>
#include <vector>

#include "match/drills/drill.hpp"

/// What a skill is worth in drills: a team with it and without it on the same trials.
namespace fulbito {

/// A team without one of its skills.
struct LeftOut {
  std::string skill;
  TeamChoice team;
};

/// The team without each of the named skills; "all" names every skill that the team can do without. Errors:
/// kUsage if the team has no skills, or not this one, or cannot do without it.
Result<std::vector<LeftOut>> withoutEach(const TeamChoice& team, const std::vector<std::string>& skills,
                                         const TeamCatalogue& catalogue);

/// What a skill is worth in one drill.
struct DrillWorth {
  int count = 0;         ///< trials or matches that count with the skill and without it
  int changed = 0;       ///< those among them with another result
  double with = 0.0;     ///< mean `DrillReport::values` of the whole team
  double without = 0.0;  ///< of the team without the skill
  Interval worth;        ///< `with` less `without`; positive: the skill helps
};

/// Compares two reports of a drill on the same trials. The interval of trials is that of the difference of
/// two paired rates (Agresti and Min 2005): half a trial is added to each of the four outcomes. That of
/// matches is Student's, over the differences of the matches.
DrillWorth worthIn(const DrillReport& with, const DrillReport& without);

/// What a skill is worth in all drills, in their order.
struct SkillWorth {
  LeftOut left_out;
  std::vector<DrillWorth> drills;
};

/// The worth of all skills, next to the drills of the whole team.
struct WorthReport {
  std::vector<DrillReport> whole;
  std::vector<SkillWorth> skills;
};

/// Runs the drills with the team of the options, and without each skill. The whole team stays the opponent
/// where a drill asks for the team itself. Errors: as `runDrills`.
/// @param progress  gives what follows the run of the team with this specification
Result<WorthReport> measureWorth(const std::vector<Drill>& drills, const std::vector<int>& numbers,
                                 const DrillOptions& options, const std::vector<LeftOut>& left_out,
                                 const std::function<DrillProgress(const std::string&)>& progress);

/// @{ As a table to read and as JSON (docs/results-format.md).
std::string worthTable(const WorthReport& report, const DrillOptions& options);
std::string worthJson(const WorthReport& report, const DrillOptions& options);
/// @}

}  // namespace fulbito
