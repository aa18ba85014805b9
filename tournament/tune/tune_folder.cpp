#include "tournament/tune/tune_folder.hpp"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/system/output_file.hpp"
#include "engine/core/system/text_file.hpp"
#include "tournament/folder/plan_record.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;
constexpr std::size_t kLargestRecord = 16 << 20;  // [bytes]

std::string tuneFile(const std::string& folder) { return folder + "/tune.json"; }

bool exists(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// The settings that the plan of the matches does not have.
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

std::string nameOf(std::string path) {
  for (char& c : path) c = c == '/' ? '.' : c;
  return path.substr(1);
}

std::vector<std::string> changesOf(const Json& before, const Json& after) {
  const Json old_values = before.flatten(), new_values = after.flatten();
  std::vector<std::string> changes;
  for (const auto& [key, value] : old_values.items()) {
    const Json now = new_values.value(key, Json("none"));
    if (now != value) changes.push_back(fmt::format("{}: {} -> {}", nameOf(key), value.dump(), now.dump()));
  }
  for (const auto& [key, value] : new_values.items()) {
    if (!old_values.contains(key))
      changes.push_back(fmt::format("{}: none -> {}", nameOf(key), value.dump()));
  }
  return changes;
}

/// What was kept of the last run.
struct OldRecord {
  Json settings;
  PlanRecord matches;
};

Result<OldRecord> readRecord(const std::string& folder) {
  const std::string file = tuneFile(folder);
  const auto text = readTextFile(file, kLargestRecord);
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

/// What has changed besides the settings. Errors: kUsage if a setting has changed.
Result<std::vector<std::string>> compare(const std::string& folder, const TunePlan& plan,
                                         const MatchIdentity& identity) {
  const auto old = readRecord(folder);
  if (!old) return tl::unexpected<Error>(old.error());
  std::vector<std::string> changes = changesOf(old->settings, settingsJson(plan));
  for (std::string& change : changesOf(old->matches.plan, plan.base)) changes.push_back(std::move(change));
  if (changes.empty()) return changesOf(old->matches, PlanRecord{plan.base, identity});
  return fail(ErrorCode::kUsage,
              fmt::format("{} holds a tuning with other settings; name another folder, or go back to its "
                          "settings. What differs:\n  {}",
                          folder, fmt::join(changes, "\n  ")));
}

}  // namespace

Result<TuneFolder> TuneFolder::open(const std::string& path, const TunePlan& plan,
                                    const MatchIdentity& identity) {
  TuneFolder folder;
  if (exists(path + "/plan.json")) {
    return fail(ErrorCode::kUsage, path + " holds a tournament; name another folder");
  }
  if (exists(tuneFile(path))) {
    auto changed = compare(path, plan, identity);
    if (!changed) return tl::unexpected<Error>(changed.error());
    folder.changed = std::move(*changed);
  } else if (auto made = prepareFolder(path); !made) {
    return tl::unexpected<Error>(made.error());
  }
  auto log = MatchLog::open(path + "/matches.jsonl");
  if (!log) return tl::unexpected<Error>(log.error());
  folder.log = std::move(*log);
  // Only once the log is locked: another run may be using the folder.
  if (auto written = writeFile(tuneFile(path), recordText(plan, identity)); !written) {
    return tl::unexpected<Error>(written.error());
  }
  return folder;
}

}  // namespace fulbito
