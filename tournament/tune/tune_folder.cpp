#include "tournament/tune/tune_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tournament/folder/json_changes.hpp"
#include "tournament/folder/plan_record.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;

/// The settings of a tuning that are not part of the plan of its matches.
Json settingsJson(const TunePlan& plan) {
  Json parameters = Json::object();
  for (const TunedParameter& p : plan.spsa.parameters) {
    parameters[p.name] = {{"start", p.start},        {"low", p.low},   {"high", p.high}, {"whole", p.whole},
                          {"c_end", p.perturbation}, {"r_end", p.step}};
  }
  return {{"against", plan.opponent ? "opponent" : "itself"},
          {"iterations", plan.spsa.iterations},
          {"final_pairs", plan.final_pairs},
          {"parameters", parameters}};
}

std::string recordText(const TunePlan& plan, const MatchIdentity& identity) {
  const Json json{{"schema_version", kSchemaVersion},
                  {"tune", settingsJson(plan)},
                  {"matches", Json::parse(toJson(PlanRecord{plan.base, identity}))}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// The record that the last run stored.
struct OldRecord {
  Json settings;
  PlanRecord matches;
};

Result<OldRecord> readRecord(const std::string& folder) {
  const std::string file = recordFile(folder, FolderWork::kTuning);
  const auto text = readRecordText(folder, FolderWork::kTuning);
  if (!text) return tl::unexpected<Error>(text.error());
  try {
    const Json json = Json::parse(*text);
    if (json.at("schema_version") != kSchemaVersion) {
      return fail(ErrorCode::kBadInput, file + ": written by another version of this program");
    }
    auto matches = parsePlanRecord(json.at("matches").dump(), file);
    if (!matches) return tl::unexpected<Error>(matches.error());
    return OldRecord{json.at("tune"), std::move(*matches)};
  } catch (const Json::exception& error) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: not the settings of a tuning: {}", file, error.what()));
  }
}

/// The changes besides the settings since the last run. Errors: kUsage if a setting has changed.
Result<std::vector<std::string>> compare(const std::string& folder, const TunePlan& plan,
                                         const MatchIdentity& identity) {
  const auto old = readRecord(folder);
  if (!old) return tl::unexpected<Error>(old.error());
  std::vector<std::string> changes = changesOf(old->settings, settingsJson(plan));
  for (std::string& change : changesOf(old->matches.plan, plan.base)) changes.push_back(std::move(change));
  if (changes.empty()) return changesOf(old->matches, PlanRecord{plan.base, identity});
  return fail(ErrorCode::kUsage,
              withChanges(folder + " holds a tuning with other settings; name another folder, or go back "
                                   "to its settings.",
                          changes));
}

}  // namespace

Result<LogFolder> openTuneFolder(const std::string& folder, const TunePlan& plan,
                                 const MatchIdentity& identity) {
  return openLogFolder(folder, FolderWork::kTuning, recordText(plan, identity),
                       [&] { return compare(folder, plan, identity); });
}

}  // namespace fulbito
