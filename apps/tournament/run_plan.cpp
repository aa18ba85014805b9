#include "apps/tournament/run_plan.hpp"

#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/tournament/progress_line.hpp"
#include "apps/tournament/recordings.hpp"
#include "apps/tournament/shard.hpp"
#include "engine/core/system/output_file.hpp"
#include "referee/restarts/check_places.hpp"
#include "tournament/identity/repeatable.hpp"
#include "tournament/store/match_cache.hpp"

namespace fulbito::app {
namespace {

/// Parses a share such as "1%"; 0 for an empty text.
Result<double> shareOf(const std::string& text) {
  if (text.empty()) return 0.0;
  double percent = 0.0;
  const char* const end = text.data() + text.size() - (text.ends_with('%') ? 1 : 0);
  const auto read = std::from_chars(text.data(), end, percent);
  if (read.ec != std::errc() || read.ptr != end || !(percent >= 0.0 && percent <= 100.0)) {
    return fail(ErrorCode::kUsage, fmt::format("--verify: '{}' is not a percentage in 0% ... 100%", text));
  }
  return percent / 100.0;
}

/// Tests whether teams from files repeat themselves, whatever they declare. If not, a cache would mix up
/// their matches.
Result<void> checkRepeats(const TournamentPlan& plan, MatchIdentity& identity) {
  for (std::size_t i = 0; i < plan.entrants.size(); ++i) {
    if (!identity.teams()[i].outside || !identity.teams()[i].deterministic) continue;
    const auto repeats = repeatsItself(plan.entrants[i].team);
    if (!repeats) return tl::unexpected<Error>(repeats.error());
    if (*repeats) continue;
    identity.markVarying(i);
    note("note: {} does not repeat its decisions; its matches are never taken from the cache\n",
         plan.entrants[i].name);
  }
  return {};
}

/// Objects that a run needs besides the plan.
struct Tools {
  MatchMemory memory;
  LogFolder folder;
  std::optional<MatchCache> cache;
  MatchStore& log() { return folder.log ? static_cast<MatchStore&>(*folder.log) : memory; }
};

Result<void> openTools(const RunFlags& flags, PlanRecord& record, Tools& tools) {
  if (!flags.cache.empty()) {
    auto cache = MatchCache::open(flags.cache);
    if (!cache) return tl::unexpected<Error>(cache.error());
    tools.cache = std::move(*cache);
    if (auto checked = checkRepeats(record.plan, record.identity); !checked) return checked;
  }
  if (flags.out.empty()) return {};
  auto folder = openResultsFolder(flags.out, record);
  if (!folder) return tl::unexpected<Error>(folder.error());
  tools.folder = std::move(*folder);
  for (const std::string& change : tools.folder.changed)
    note("note: {}: what it played is played again\n", change);
  return {};
}

/// The parsed values of the flags.
struct Choices {
  Shard shard;
  double verify = 0.0;
  KeptRecordings kept = KeptRecordings::kNone;
};

/// Parses the flags. Errors: kUsage naming the flag.
Result<Choices> choicesOf(const RunFlags& flags) {
  const auto shard = shardOf(flags.shard);
  if (!shard) return tl::unexpected<Error>(shard.error());
  const auto verify = shareOf(flags.verify);
  if (!verify) return tl::unexpected<Error>(verify.error());
  const auto kept = keptOf(flags.recordings);
  if (!kept) return tl::unexpected<Error>(kept.error());
  if (*kept != KeptRecordings::kNone && flags.out.empty()) {
    return fail(ErrorCode::kUsage, "--recordings: recordings need a folder: --out");
  }
  return Choices{*shard, *verify, *kept};
}

RunnerOptions optionsOf(const RunFlags& flags, const Choices& choices, Tools& tools) {
  RunnerOptions options;
  options.jobs = flags.jobs;
  options.shard = choices.shard;
  options.clock = now;
  options.log = &tools.log();
  options.cache = tools.cache ? &*tools.cache : nullptr;
  options.verify = choices.verify;
  if (choices.kept == KeptRecordings::kAll) {
    options.watch = [folder = recordingsOf(flags.out)](const MatchConfig& match, const MatchId& id) {
      return recordingWatch(folder, match, id);
    };
  }
  return options;
}

/// Records upsets when all results are known.
Result<void> recordUpsets(const RunOutcome& outcome, const std::string& folder) {
  if (outcome.interrupted || !outcome.state.finished()) return {};
  return recordNotable(outcome.state, tableOf(outcome.state).notable, folder);
}

}  // namespace

void addRunFlags(CLI::App& command, RunFlags& flags) {
  CLI::Option* out =
      command
          .add_option("--out", flags.out,
                      "folder that keeps the results; the same command continues what it holds")
          ->type_name("FOLDER")
          ->capture_default_str();
  markFolder(out, flags.out, FolderUse::kResults);
  addJobs(command, flags.jobs, "matches at once");
  command
      .add_option("--shard", flags.shard, "play only a part: i/N, or auto[/N] in a Slurm or Kubernetes job")
      ->type_name("i/N");
  markFolder(command.add_option("--cache", flags.cache, "folder of matches that tournaments share")
                 ->type_name("FOLDER"),
             flags.cache, FolderUse::kCache);
  command.add_option("--verify", flags.verify, "play this share of the matches twice and compare: 1%")
      ->type_name("PERCENT");
  command.add_flag("--strict", flags.strict, "exit code 4 if a team crashed or forfeited");
}

void addRecordings(CLI::App& command, RunFlags& flags) {
  command.add_option("--recordings", flags.recordings, "matches to record: none, upsets or all; needs --out")
      ->capture_default_str();
}

Result<PlayedPlan> runPlan(const TournamentPlan& plan, const RunFlags& flags) {
  if (auto checked = checkPlan(plan); !checked) return tl::unexpected<Error>(checked.error());
  if (const auto foreign = findForeignPlaces(plan.match.rules, plan.match.field, plan.match.robot.robot)) {
    note("note: {}\n", *foreign);
  }
  const auto choices = choicesOf(flags);
  if (!choices) return tl::unexpected<Error>(choices.error());
  auto identity = MatchIdentity::create(plan);
  if (!identity) return tl::unexpected<Error>(identity.error());
  PlayedPlan played{{plan, std::move(*identity)}, {}, choices->shard};
  Tools tools;
  if (auto opened = openTools(flags, played.record, tools); !opened) {
    return tl::unexpected<Error>(opened.error());
  }
  const std::string recordings = recordingsOf(flags.out);
  if (choices->kept != KeptRecordings::kNone) {
    if (auto made = prepareFolder(recordings); !made) return tl::unexpected<Error>(made.error());
  }
  RunnerOptions options = optionsOf(flags, *choices, tools);
  ProgressLine line(plan.name);
  options.progress = [&line](const RunProgress& progress) { return line.update(progress); };
  auto outcome = runTournament(plan, played.record.identity, options);
  if (!outcome) return tl::unexpected<Error>(outcome.error());
  played.outcome = std::move(*outcome);
  if (choices->kept == KeptRecordings::kUpsets) {
    if (auto done = recordUpsets(played.outcome, recordings); !done) {
      return tl::unexpected<Error>(done.error());
    }
  }
  return played;
}

void noteOutcome(const PlayedPlan& played, const RunFlags& flags) {
  const RunOutcome& outcome = played.outcome;
  note("{} matches played, {} were there already\n", outcome.played, outcome.taken);
  if (outcome.retried > 0) note("{} attempts failed and were repeated\n", outcome.retried);
  if (outcome.verified > 0) {
    note("{} matches played twice, {} of them differ\n", outcome.verified, outcome.mismatches.size());
  }
  for (const Mismatch& mismatch : outcome.mismatches) {
    const auto& entrants = played.record.plan.entrants;
    note("differs: {} against {}, start {}, match {}: {}:{} then {}:{}\n", entrants[mismatch.fixture.a].name,
         entrants[mismatch.fixture.b].name, bookEntry(played.record.plan.book, mismatch.fixture.start).name,
         mismatch.leg + 1, mismatch.first.score[0], mismatch.first.score[1], mismatch.second.score[0],
         mismatch.second.score[1]);
  }
  if (!outcome.state.unplayed.empty()) {
    note("{} matches not played, as the machine failed; the same command plays them\n",
         outcome.state.unplayed.size());
  }
  if (outcome.interrupted && !flags.out.empty()) note("stopped; the same command continues\n");
  if (played.shard.count > 1) {
    note("this is shard {} of {}; unite them with: fulbito tournament merge FOLDER... --out FOLDER\n",
         played.shard.index + 1, played.shard.count);
  }
}

int exitCodeOf(const TournamentState& state) {
  if (!state.sprt) return kOk;
  switch (state.sprt->verdict()) {
    case SprtVerdict::kPass:
      return kOk;
    case SprtVerdict::kFail:
      return kTestFailed;
    case SprtVerdict::kInconclusive:
      break;
  }
  return kInconclusive;
}

int exitCodeOf(const PlayedPlan& played, const RunFlags& flags) {
  if (!played.outcome.mismatches.empty()) return kDifferent;
  if (flags.strict && failedMatches(played.outcome.state) > 0) return kTeamFailed;
  if (played.outcome.interrupted) return interruptedCode();
  if (!played.outcome.state.unplayed.empty()) return kInconclusive;
  return played.shard.count > 1 ? kOk : exitCodeOf(played.outcome.state);
}

}  // namespace fulbito::app
