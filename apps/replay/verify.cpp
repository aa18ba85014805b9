#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/progress.hpp"
#include "apps/replay/replay.hpp"
#include "engine/core/base/text_controls.hpp"
#include "replays/verify/verify_many.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

/// The number of files per verdict.
struct Counts {
  std::size_t same = 0, different = 0, cut = 0, bad = 0, heard = 0;
  double simulated = 0.0;  ///< simulated time [s]
};

Counts countsOf(const std::vector<VerifiedFile>& files) {
  Counts counts;
  for (const VerifiedFile& file : files) {
    if (!file.result) {
      ++counts.bad;
      continue;
    }
    if (file.result->heard) {
      ++(file.result->finished ? counts.heard : counts.cut);
      continue;
    }
    counts.simulated += file.result->seconds;
    if (!file.result->same()) {
      ++counts.different;
    } else {
      ++(file.result->finished ? counts.same : counts.cut);
    }
  }
  return counts;
}

const char* verdictName(const Verification& v) {
  if (v.heard) return v.finished ? "heard" : "cut";
  return !v.same() ? "different" : v.finished ? "same" : "cut";
}

std::string verdictOf(const VerifiedFile& file) {
  if (!file.result) return file.result.error().message;
  const Verification& v = *file.result;
  if (v.heard) {
    return fmt::format(
        "{}heard: {:.1f} s of another program's motion, which cannot be simulated again; its "
        "checksums are right",
        v.finished ? "" : "cut off; ", v.seconds);
  }
  if (!v.same()) {
    return v.divergence->text + (v.same_build ? "" : " (recorded by another build, see fulbito replay info)");
  }
  const std::string what =
      fmt::format("{} ticks, {} plays, {:.1f} s, hash {:016x}", v.ticks, v.plays, v.seconds, v.final_hash);
  return v.finished ? "identical, bit for bit: " + what : "cut off; identical up to there: " + what;
}

void printOne(const VerifiedFile& file) {
  // Errors already begin with the file's name.
  if (!file.result) {
    report(file.result.error());
  } else {
    say("{}: {}\n", file.file, verdictOf(file));
  }
}

void printTable(const std::vector<VerifiedFile>& files, double wall) {
  std::size_t width = 4;
  const auto name_of = [](const VerifiedFile& file) {
    return std::filesystem::path(file.file).filename().string();
  };
  for (const VerifiedFile& file : files) width = std::max(width, name_of(file).size());
  say("{:<{}}  {:>9}  {:>9}  {:>5}  {:<16}  {}\n", "file", width, "verdict", "seconds", "plays", "hash",
      "first difference or error");
  for (const VerifiedFile& file : files) {
    if (!file.result) {
      say("{:<{}}  {:>9}  {:>9}  {:>5}  {:<16}  {}\n", name_of(file), width, "bad", "", "", "",
          file.result.error().message);
      continue;
    }
    const Verification& v = *file.result;
    say("{:<{}}  {:>9}  {:>9.1f}  {:>5}  {:016x}  {}\n", name_of(file), width, verdictName(v), v.seconds,
        v.plays, v.final_hash, v.same() ? std::string() : v.divergence->text);
  }
  const Counts counts = countsOf(files);
  say("\n{} recordings: {} same, {} different, {} cut, {} bad, {} heard\n", files.size(), counts.same,
      counts.different, counts.cut, counts.bad, counts.heard);
  say("{:.1f} s simulated in {:.2f} s: {:.0f} x real time\n", counts.simulated, wall,
      counts.simulated / wall);
}

Json divergenceJson(const Divergence& d, double dt) {
  Json json{{"tick", d.tick},
            {"time_s", static_cast<double>(d.tick) * dt},
            {"play", d.play},
            {"play_tick", d.play_tick},
            {"text", d.text}};
  if (d.body) {
    json["body"] = d.body_name;
    json["body_tick"] = d.body_tick;
    json["bodies"] = d.bodies;
    json["field"] = d.field;
    if (d.recorded != d.replayed) {
      json["recorded"] = d.recorded;
      json["replayed"] = d.replayed;
    }
  }
  return json;
}

Json toJson(const VerifiedFile& file) {
  Json json{{"file", file.file}};
  if (!file.result) {
    json["verdict"] = "bad";
    json["error"] = file.result.error().message;
    return json;
  }
  const Verification& v = *file.result;
  json["verdict"] = verdictName(v);
  json["ticks"] = v.ticks;
  json["plays"] = v.plays;
  json["simulated_s"] = v.seconds;
  json["same_build"] = v.same_build;
  json["final_hash"] = fmt::format("{:016x}", v.final_hash);
  json["divergence"] = v.same()
                           ? Json(nullptr)
                           : divergenceJson(*v.divergence, v.seconds / double(std::max<Tick>(v.ticks, 1)));
  return json;
}

Json toJson(const std::vector<VerifiedFile>& files, double wall) {
  const Counts counts = countsOf(files);
  Json json{{"schema_version", 1}, {"files", Json::array()}};
  for (const VerifiedFile& file : files) json["files"].push_back(toJson(file));
  json["same"] = counts.same;
  json["different"] = counts.different;
  json["cut"] = counts.cut;
  json["bad"] = counts.bad;
  json["heard"] = counts.heard;
  json["simulated_s"] = counts.simulated;
  json["wall_s"] = wall;
  json["x_realtime"] = counts.simulated / wall;
  return json;
}

/// The exit code for several files. A difference takes precedence over damage, and damage over no verdict.
/// Files that cannot be opened give kIo, or kInconclusive if all failures are the machine's; damaged files
/// give kBadInput.
int exitCodeOf(const std::vector<VerifiedFile>& files) {
  const Counts counts = countsOf(files);
  if (counts.different > 0) return kDifferent;
  if (counts.cut > 0) return kBadInput;
  if (counts.bad == 0) return counts.heard > 0 ? kInconclusive : kOk;
  const auto all_fail_by = [&](std::initializer_list<ErrorCode> codes) {
    return std::all_of(files.begin(), files.end(), [&](const VerifiedFile& file) {
      return file.result || std::count(codes.begin(), codes.end(), file.result.error().code) > 0;
    });
  };
  if (all_fail_by({ErrorCode::kMachine})) return kInconclusive;
  return all_fail_by({ErrorCode::kIo, ErrorCode::kMachine}) ? kIo : kBadInput;
}

}  // namespace

CLI::App* addReplayVerify(CLI::App& replay, ReplayVerifyCommand& options) {
  CLI::App* command =
      replay.add_subcommand("verify", "simulate recordings again and compare every tick, bit for bit");
  command->footer(
      "Examples:\n"
      "  fulbito replay verify game.fbr\n"
      "  fulbito replay verify recordings/ --jobs 2 --json > verified.json\n"
      "Exit codes: 0 all identical, 7 one differs (its first differing tick, body and coordinate are "
      "printed),\n"
      "3 one is damaged or cut off, 6 one is of fulbito record and cannot be simulated again.");
  command->add_option("files", options.files, "recordings (.fbr) or folders that contain them")->required();
  addJobs(*command, options.jobs, "worker threads");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int replayVerify(const ReplayVerifyCommand& options) {
  const auto names = recordingFiles(options.files);
  if (!names) return report(names.error());
  if (names->empty()) return report({ErrorCode::kUsage, "no recordings (.fbr) in these folders"});
  const std::int64_t begin = now();
  Result<std::vector<VerifiedFile>> files;
  {
    ProgressBar bar("verify", names->size() == 1);
    files = verifyRecordings(*names, options.jobs,
                             [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
  }
  if (!files) return report(files.error());
  const double wall = static_cast<double>(now() - begin) * 1e-9;
  if (options.json) {
    writeOut(escapedJson(toJson(*files, wall).dump(2, ' ', false, Json::error_handler_t::replace)) + "\n");
  } else if (files->size() == 1) {
    printOne(files->front());
  } else {
    printTable(*files, wall);
  }
  return exitCodeOf(*files);
}

}  // namespace fulbito::app
