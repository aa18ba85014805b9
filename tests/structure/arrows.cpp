#include "tests/structure/arrows.hpp"

#include <algorithm>

namespace fulbito::test {
namespace {

const std::vector<Library> kLibraries = {
    {"fulbito::core",
     "engine/core",
     "values, field, mathematics, random streams, hash, configuration files",
     {"Random123", "fmt", "tl", "toml++", "xxhash.h"}},
    {"fulbito::sim", "engine/sim", "the world: bodies, motors, ball, contacts", {"box2d", "fmt"}},
    {"fulbito::navigation",
     "navigation",
     "navigators, followers, limiter, and the pilot that joins them",
     {"fmt"}},
    {"fulbito::strategies",
     "strategies",
     "teams, the skills that they are built from, a team's navigation stage",
     {"fmt"}},
    {"fulbito::referee",
     "referee",
     "the rules of a match as data, one file per call, restarts; scoring of trials",
     {"fmt"}},
    {"fulbito::replays",
     "replays",
     "recordings: the file, its writer and reader",
     {"fmt", "nlohmann", "xxhash.h", "zstd.h"}},
    {"fulbito::verify",
     "replays/verify",
     "what steps a recording again or rewrites it: verify, compare, cut, expand, repair",
     {"fmt"}},
    {"fulbito::render",
     "replays/render",
     "pictures of matches and trials, charts",
     {"SDL.h", "SDL2", "SDL2_gfxPrimitives.h", "SDL_ttf.h", "fmt", "libdeflate.h", "png.h"}},
    {"fulbito::export",
     "replays/export",
     "films, GIFs and tables of recordings; ffmpeg as a child process",
     {"cgif.h", "fmt", "nlohmann"}},
    {"fulbito::html",
     "replays/html",
     "the HTML viewer: its page, and recordings and races as its data",
     {"fmt", "libdeflate.h", "nlohmann"}},
    {"", "bridge", "the conversation with a team outside the program, whatever its encoding", {}},
    {"fulbito::abi",
     "bridge/abi",
     "teams of shared libraries: in this process, or hosted by a program of its own",
     {"fmt"}},
    {"fulbito-team-host", "apps/team_host", "the program that runs a team of a shared library", {}},
    {"fulbito::match",
     "match",
     "the tick loop, what teams see, series, drills, statistics, summaries",
     {"fmt", "nlohmann"}},
    {"fulbito::recorder", "match/record", "from a match to a recording", {"fmt"}},
    {"fulbito::process",
     "bridge/process",
     "a team's program in a contained child process",
     {"fmt", "seccomp.h"}},
    {"fulbito::lines", "bridge/lines", "that conversation as JSON lines: its writer and reader", {}},
    {"fulbito::outside",
     "bridge/outside",
     "teams of shared libraries and programs in a match: specifications, deadlines, new starts",
     {"fmt"}},
    {"fulbito::experiments", "experiments", "suites, trials, comparison, reports", {"fmt", "nlohmann"}},
    {"fulbito::view",
     "apps/view",
     "the window: player, live match, editor; SDL2 in one file",
     {"SDL.h", "fmt"}},
    {"fulbito_bench",
     "bench",
     "the engine next to a bare Box2D loop; part of the program, not installed",
     {"box2d", "fmt"}},
    {"navigation_surveys",
     "bench/surveys",
     "tables for who chooses or tunes a navigator; they assert nothing",
     {"fmt"}},
    {"fulbito", "apps", "the command line", {"CLI", "fmt", "nlohmann"}},
    {"", "tests/support", "what tests and surveys share", {"fmt", "nlohmann"}},
};

const std::vector<PublicHeader> kPublicHeaders = {
    {"fulbito/values.hpp", "engine/core/base"},
    {"fulbito/models.hpp", "engine/core/models"},
    {"fulbito/world.hpp", "engine/sim"},
    {"fulbito/navigation.hpp", "navigation/interface"},
    {"fulbito/strategy.hpp", "strategies/interface"},
    {"fulbito/team.h", "navigation/library"},
    {"fulbito/team.hpp", "bridge"},
    {"fulbito/referee.hpp", "referee/rules"},
    {"fulbito/match.hpp", "match/config"},
    {"fulbito/statistics.hpp", "match/series"},
    {"fulbito/recording.hpp", "replays/recording"},
    {"fulbito/recorder.hpp", "match/record"},
    {"fulbito/picture.hpp", "replays/render/field"},
    {"fulbito/experiment.hpp", "experiments/trials"},
    {"fulbito/team_program.hpp", "bridge/lines"},
    {"fulbito/detail/lines/json_reader.hpp", "bridge/lines"},
    {"fulbito/detail/lines/json_text.hpp", "bridge/lines"},
    {"fulbito/detail/lines/utf8.hpp", "bridge/lines"},
    {"fulbito/detail/lines/read_values.hpp", "bridge/lines"},
    {"fulbito/detail/lines/write_answers.hpp", "bridge/lines"},
    {"fulbito/detail/lines/conversation.hpp", "bridge/lines"},
    {"fulbito/detail/lines/pipes.hpp", "bridge/lines"},
    {"fulbito/outside.hpp", "bridge/outside"},
    {"fulbito/detail/child_limits.hpp", "bridge/process"},
    {"fulbito/detail/decision_time.hpp", "referee/rules"},
    {"fulbito/detail/vec2.hpp", "engine/core/base"},
    {"fulbito/detail/state_hash.hpp", "engine/core/base"},
    {"fulbito/detail/build_info.hpp", "engine/core/base"},
    {"fulbito/detail/math.hpp", "engine/core/math"},
    {"fulbito/detail/interval.hpp", "engine/core/math"},
    {"fulbito/detail/field_geometry.hpp", "engine/core/models"},
    {"fulbito/detail/layout.hpp", "engine/core/models"},
    {"fulbito/detail/detector_rules.hpp", "referee/rules"},
    {"fulbito/detail/period_rules.hpp", "referee/rules"},
    {"fulbito/detail/restart_rules.hpp", "referee/rules"},
    {"fulbito/detail/trial_score.hpp", "referee/trial"},
    {"fulbito/detail/canvas.hpp", "replays/render/canvas"},
};

const std::vector<Folder> kFolders = {
    {"engine/core/base", "values that all share: vectors, states, teams, results, hash", {}},
    {"engine/core/math",
     "elementary functions with proven bounds, random streams (RNG), statistics",
     {"engine/core/base"}},
    {"engine/core/system", "files, signals, threads, texts of errors", {"engine/core/base"}},
    {"engine/core/models",
     "what is simulated, as numbers: ball, robot, field, layout, physics profile",
     {"engine/core/base", "engine/core/math"}},
    {"engine/core/config",
     "configuration files: schema, reading, checking, presets",
     {"engine/core/base", "engine/core/math", "engine/core/system", "engine/core/models"}},
    {"engine/sim",
     "the world and its parts: `ball_motion` (friction and spin), drive, contacts, walls",
     {"engine/core/base", "engine/core/math", "engine/core/models"}},
    {"navigation/geometry",
     "circles, polylines, splines, walls",
     {"engine/core/base", "engine/core/math", "engine/core/models"}},
    {"navigation/interface",
     "what a navigator or follower implements, gets and gives",
     {"engine/core/base", "engine/core/models", "engine/core/config"}},
    {"navigation/obstacles",
     "obstacles as a method sees them: forecasts, clusters, sectors, remembered echoes",
     {"engine/core/math", "navigation/geometry", "navigation/interface"}},
    {"navigation/followers",
     "from guidance to wheel speeds: followers, limiter, speed profile",
     {"engine/core/math", "engine/core/models", "navigation/geometry", "navigation/interface",
      "navigation/obstacles"}},
    {"navigation/methods/fields",
     "heading fields: limit cycle, univector, tangent field",
     {"engine/core/math", "navigation/geometry", "navigation/interface", "navigation/obstacles"}},
    {"navigation/methods/paths",
     "tangent graph, Bezier and Hermite paths",
     {"engine/core/base", "engine/core/math", "engine/core/models", "navigation/geometry",
      "navigation/interface", "navigation/obstacles", "navigation/followers"}},
    {"navigation/methods/reactive",
     "dynamic window, nearness diagram",
     {"engine/core/math", "navigation/interface", "navigation/obstacles", "navigation/followers"}},
    {"navigation/methods/hybrid",
     "sonar navigation: occupancy boxes, avoidance table, arbitration with the nearness diagram",
     {"engine/core/base", "engine/core/math", "engine/core/models", "navigation/interface",
      "navigation/obstacles", "navigation/methods/fields", "navigation/methods/reactive"}},
    {"navigation/methods/bspline",
     "B-splines optimised for time",
     {"engine/core/math", "navigation/geometry", "navigation/interface", "navigation/obstacles",
      "navigation/followers", "navigation/methods/paths"}},
    {"navigation/library",
     "navigators of shared libraries, and what their teams share with them",
     {"engine/core/base", "engine/core/math", "engine/core/system", "engine/core/models",
      "engine/core/config", "navigation/interface"}},
    {"navigation",
     "the table of navigators, the pilot, strokes that show guidance",
     {"engine/core/math", "engine/core/config", "navigation/interface", "navigation/followers",
      "navigation/methods/fields", "navigation/methods/hybrid", "navigation/methods/paths",
      "navigation/methods/reactive", "navigation/methods/bspline", "navigation/library"}},
    {"strategies/interface",
     "what a team implements, gets and gives",
     {"engine/core/base", "engine/core/math", "engine/core/models", "navigation/interface", "referee/rules"}},
    {"strategies/prediction",
     "where the ball will be, and who reaches it when",
     {"engine/core/base", "engine/core/math", "engine/core/models", "strategies/interface"}},
    {"strategies/skills",
     "skills that teams share",
     {"engine/core/math", "engine/core/models", "strategies/interface", "strategies/prediction"}},
    {"strategies/teams", "the list of built-in teams, for the registry", {"strategies/interface"}},
    {"strategies/teams/libero/situation",
     "what libero sees of the game, and what it decides",
     {"engine/core/base", "engine/core/models", "strategies/interface", "strategies/prediction"}},
    {"strategies/teams/classic",
     "the textbook team",
     {"engine/core/math", "strategies/interface", "strategies/prediction", "strategies/skills",
      "strategies/teams"}},
    {"strategies/teams/libero/motion",
     "how its robots get somewhere without a foul",
     {"engine/core/math", "engine/core/models", "strategies/interface", "strategies/prediction",
      "strategies/skills", "strategies/teams/libero/situation"}},
    {"strategies/teams/simple",
     "idle, random and chaser",
     {"engine/core/math", "strategies/interface", "strategies/skills", "strategies/teams"}},
    {"strategies/teams/libero/attack",
     "striker and support",
     {"engine/core/math", "engine/core/models", "strategies/prediction", "strategies/skills",
      "strategies/teams/libero/situation", "strategies/teams/libero/motion"}},
    {"strategies/teams/libero/defence",
     "keeper",
     {"engine/core/math", "engine/core/models", "strategies/prediction", "strategies/skills",
      "strategies/teams/libero/situation", "strategies/teams/libero/motion",
      "strategies/teams/libero/attack"}},
    {"strategies/teams/libero",
     "the flagship: roles, restarts, exercises of drills, drawings",
     {"engine/core/math", "navigation/interface", "strategies/interface", "strategies/prediction",
      "strategies/skills", "strategies/teams", "strategies/teams/libero/situation",
      "strategies/teams/libero/motion", "strategies/teams/libero/attack", "strategies/teams/libero/defence"}},
    {"strategies",
     "the table of teams; the stage that drives a team's robots to their places",
     {"engine/core/math", "engine/core/config", "navigation/interface", "navigation/followers", "navigation",
      "strategies/interface", "strategies/prediction", "strategies/teams"}},
    {"referee/rules",
     "rules as data, their file format and checks",
     {"engine/core/base", "engine/core/system", "engine/core/models", "engine/core/config"}},
    {"referee/trial",
     "the scoring of navigation trials",
     {"engine/core/base", "engine/core/math", "engine/core/models"}},
    {"referee/state", "what the referee sees, keeps and says", {"engine/core/base"}},
    {"referee/geometry",
     "areas of the field, gaps to the ball",
     {"engine/core/base", "engine/core/math", "engine/core/models", "referee/rules", "referee/state"}},
    {"referee/calls",
     "one file per call: `goal`, `stuck_ball`, fouls",
     {"engine/core/base", "referee/rules", "referee/state", "referee/geometry"}},
    {"referee/restarts",
     "where ball and robots stand when play goes on",
     {"engine/core/base", "engine/core/math", "engine/core/models", "referee/rules", "referee/state",
      "referee/geometry"}},
    {"referee/match",
     "the match referee, false start, shoot-out",
     {"engine/core/math", "referee/rules", "referee/state", "referee/geometry", "referee/calls",
      "referee/restarts"}},
    {"replays/coding", "bytes, columns, compression, range coder", {}},
    {"replays/recording",
     "a recording as values, words for calls",
     {"engine/core/base", "engine/core/math", "referee/rules"}},
    {"replays/header",
     "the header of a recording: its JSON, and what fills it",
     {"engine/core/base", "engine/core/models", "replays/coding", "replays/recording"}},
    {"replays/chunks",
     "blocks and chunks of samples and commands",
     {"replays/coding", "replays/recording", "replays/header"}},
    {"replays",
     "reader, writer and salvage of recordings, the timeline",
     {"engine/core/math", "engine/core/system", "replays/recording", "replays/header", "replays/chunks"}},
    {"replays/verify",
     "what steps a recording again or rewrites it",
     {"engine/core/base", "engine/core/math", "engine/core/system", "engine/core/models", "engine/sim",
      "referee/rules", "referee/match", "replays/recording", "replays"}},
    {"replays/render/canvas", "pixels, text, axes, PNG files", {"engine/core/base", "engine/core/system"}},
    {"replays/render/colours",
     "colours of robots, field, series and heat; the page takes its own from `shared_colours.def`",
     {"engine/core/base", "engine/core/math", "replays/render/canvas"}},
    {"replays/render/field",
     "field pictures of trials, charts, maps",
     {"engine/core/math", "engine/core/models", "replays/recording", "replays/render/canvas",
      "replays/render/colours"}},
    {"replays/render/match",
     "pictures of matches, also as SVG",
     {"engine/core/base", "engine/core/math", "engine/core/models", "replays/recording",
      "replays/render/canvas", "replays/render/colours", "replays/render/field"}},
    {"replays/export",
     "films, GIFs, tables",
     {"engine/core/base", "engine/core/system", "replays/recording", "replays/render/canvas",
      "replays/render/field"}},
    {"replays/html",
     "the HTML viewer's page and data",
     {"engine/core/base", "engine/core/math", "engine/core/models", "engine/core/config", "replays/coding",
      "replays/recording"}},
    {"bridge",
     "requests and replies of a team outside the program, the C++ class of such a team",
     {"navigation/library", "strategies/interface"}},
    {"bridge/abi",
     "teams by the C interface: conversions, messages, the team in this process, its host",
     {"engine/core/base", "navigation/interface", "navigation/library", "strategies/interface",
      "referee/rules", "bridge"}},
    {"apps/team_host", "the program that runs a team of a shared library", {"bridge/abi"}},
    {"match/config",
     "what a match is asked for, and its checks",
     {"engine/core/base", "engine/core/system", "engine/core/models", "engine/core/config", "engine/sim",
      "strategies/interface", "referee/rules"}},
    {"match/seats",
     "a team's seat: what it sees (`--noise`), what it may command",
     {"engine/core/base", "engine/core/math", "engine/core/models", "strategies/interface", "strategies",
      "referee/rules", "referee/match", "match/config"}},
    {"match/play",
     "the tick loop, restarts, edits while it runs",
     {"engine/core/base", "engine/core/math", "engine/sim", "strategies/interface", "referee/geometry",
      "referee/restarts", "referee/match", "match/config", "match/seats"}},
    {"match/series",
     "matches in pairs and their results",
     {"engine/core/math", "engine/core/system", "referee/rules", "match/config"}},
    {"match/report",
     "statistics, summary and its JSON, event lines",
     {"engine/core/base", "match/config", "match/series"}},
    {"match/drills",
     "drills: how they start, run and are judged; `definitions` has their files",
     {"engine/core/base", "engine/core/math", "engine/core/system", "engine/core/models",
      "engine/core/config", "engine/sim", "strategies/interface", "strategies/prediction", "referee/rules",
      "referee/restarts", "match/config", "match/series"}},
    {"match/check",
     "check of a team: scripted and repeated situations, and the verdicts",
     {"engine/core/base", "engine/core/math", "strategies/interface", "referee/restarts", "match/config",
      "match/report", "match/drills"}},
    {"match/record",
     "from a match to a recording",
     {"engine/core/models", "strategies/interface", "referee/rules", "replays/recording", "replays/header",
      "match/config", "match/series", "match/report"}},
    {"bridge/process",
     "launch of a team's program, its pipes and its end",
     {"engine/core/base", "bridge/process/keeper"}},
    {"bridge/process/keeper",
     "the program between a match and a team, in the library: namespaces, limits, seccomp, Landlock",
     {}},
    {"bridge/lines",
     "requests as lines of JSON, replies from lines of JSON",
     {"engine/core/base", "engine/core/config", "strategies/interface", "referee/rules", "bridge"}},
    {"bridge/outside",
     "a team in a child process: its specification, its conversation, its deadlines and new starts",
     {"engine/core/base", "engine/core/system", "navigation/interface", "strategies/interface", "bridge",
      "bridge/abi", "bridge/lines", "bridge/process"}},
    {"experiments/trials",
     "one trial: suites of layouts, what the robot senses (`--noise`), the tick loop",
     {"engine/core/base", "engine/core/math", "engine/core/models", "engine/core/config", "engine/sim",
      "navigation/interface", "navigation/obstacles", "navigation/methods/paths", "navigation",
      "referee/trial", "replays/recording", "replays/header"}},
    {"experiments/comparison",
     "many trials: plan, summary, tuner",
     {"engine/core/math", "engine/core/system", "experiments/trials"}},
    {"experiments/map",
     "the map of a method's parameters",
     {"engine/core/base", "engine/core/config", "replays/render/field", "experiments/trials",
      "experiments/comparison"}},
    {"experiments/papers",
     "what the experiments of papers share: figures, tables, charts, scenes, their files; the list",
     {"engine/core/base", "engine/core/math", "replays/render/canvas", "replays/render/colours",
      "replays/render/field", "replays/html", "experiments/trials"}},
    {"experiments/report",
     "tables, JSON, pictures and races of a comparison",
     {"engine/core/base", "replays/render/field", "replays/html", "experiments/trials",
      "experiments/comparison"}},
    {"experiments/sonar",
     "the experiment `hybrid`: gaps and rows by sonar",
     {"engine/core/math", "engine/core/system", "engine/sim", "navigation/interface", "experiments/trials",
      "experiments/papers"}},
    {"experiments",
     "the list of the papers' experiments",
     {"engine/core/config", "experiments/papers", "experiments/sonar"}},
    {"apps/view",
     "the window of matches and replays",
     {"engine/core/math", "replays/recording", "replays/render/canvas", "replays/render/field",
      "match/config", "match/play", "match/record"}},
    {"bench",
     "benchmark, its scenes, the bare loop",
     {"engine/core/base", "engine/core/math", "engine/core/system", "engine/sim"}},
    {"bench/surveys",
     "surveys and tuners of navigators",
     {"engine/core/math", "navigation/interface", "navigation/methods/paths", "tests/support"}},
    {"apps/common",
     "what commands share: options, console, progress, names of outputs",
     {"engine/core/base", "engine/core/system", "experiments/map"}},
    {"apps/info",
     "list, show, version, bench",
     {"engine/core/base", "engine/core/models", "engine/core/config", "strategies/interface", "referee/rules",
      "experiments/trials", "experiments/comparison", "bench", "apps/common"}},
    {"apps/match",
     "match, drill, rules, view",
     {"engine/core/base", "engine/core/system", "engine/core/models", "engine/core/config", "referee/rules",
      "referee/restarts", "replays/verify", "match/config", "match/series", "match/drills", "match/record",
      "strategies/interface", "bridge/outside", "apps/view", "apps/common"}},
    {"apps/navigation",
     "run, compare and experiment",
     {"engine/core/system", "replays/export", "replays/html", "experiments/trials", "experiments/comparison",
      "experiments/papers", "experiments/report", "experiments", "apps/common"}},
    {"apps/replay",
     "replay and its sub-commands",
     {"engine/core/base", "engine/core/system", "engine/core/models", "referee/rules", "replays/recording",
      "replays/verify", "replays/render/field", "replays/export", "replays/html", "match/record",
      "apps/common"}},
    {"apps/teams",
     "what helps with a team of your own: new-team, check-team",
     {"engine/core/system", "engine/core/config", "replays/render/match", "match/config", "match/check",
      "apps/common", "apps/match"}},
    {"apps",
     "main",
     {"engine/core/base", "engine/core/config", "apps/common", "apps/match", "apps/navigation", "apps/replay",
      "apps/teams"}},
    {"tests/support",
     "what tests and surveys share",
     {"engine/core/base", "engine/core/math", "engine/core/models", "engine/sim", "navigation/interface",
      "navigation/methods/paths", "strategies/interface", "strategies", "referee/restarts",
      "replays/recording", "match/config", "match/check", "match/record", "bridge"}},
};

bool isIn(std::string_view path, std::string_view folder) {
  return path == folder || (path.starts_with(folder) && path[folder.size()] == '/');
}

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "–" : text;
}

/// A folder's name in the row of another of the same library.
std::string_view shortName(std::string_view folder, const Library& library) {
  return folder == library.folder ? folder : folder.substr(library.folder.size() + 1);
}

bool uses(const Library& library, const Library& other) {
  return std::any_of(kFolders.begin(), kFolders.end(), [&](const Folder& folder) {
    return libraryOf(folder.path) == &library &&
           std::any_of(folder.uses.begin(), folder.uses.end(),
                       [&](std::string_view used) { return libraryOf(used) == &other; });
  });
}

std::string row(const Library& library) {
  std::vector<std::string> used;
  for (const Library& other : kLibraries) {
    if (&other != &library && uses(library, other)) used.push_back(code(other.folder));
  }
  return "| " + (library.target.empty() ? "–" : code(library.target)) + " | " + code(library.folder) + " | " +
         std::string(library.what) + " | " + joined(used) + " | " +
         joined({library.others.begin(), library.others.end()}) + " |\n";
}

std::string row(const Folder& folder) {
  const Library& library = *libraryOf(folder.path);
  std::vector<std::string> own, others;
  for (std::string_view name : folder.uses) {
    const bool is_own = libraryOf(name) == &library;
    (is_own ? own : others).push_back(code(is_own ? shortName(name, library) : name));
  }
  return "| " + code(folder.path) + " | " + std::string(folder.what) + " | " + joined(own) + " | " +
         joined(others) + " |\n";
}

}  // namespace

std::span<const PublicHeader> publicHeaders() { return kPublicHeaders; }

std::string ownerOf(std::string_view path) {
  if (path.starts_with(kPublicFolder)) path.remove_prefix(kPublicFolder.size());
  const auto header = std::find_if(kPublicHeaders.begin(), kPublicHeaders.end(),
                                   [&](const PublicHeader& h) { return h.name == path; });
  if (header != kPublicHeaders.end()) return std::string(header->folder);
  return std::string(path.substr(0, path.rfind('/') == std::string_view::npos ? 0 : path.rfind('/')));
}

std::span<const Library> libraries() { return kLibraries; }

std::span<const Folder> folders() { return kFolders; }

const Library* libraryOf(std::string_view folder) {
  const Library* innermost = nullptr;
  for (const Library& library : kLibraries) {
    if (!isIn(folder, library.folder)) continue;
    if (innermost == nullptr || library.folder.size() > innermost->folder.size()) innermost = &library;
  }
  return innermost;
}

std::string arrowTables() {
  std::string text =
      "| target | folder | what | uses | third-party headers, in sources only |\n|---|---|---|---|---|\n";
  for (const Library& library : kLibraries) text += row(library);
  text +=
      "\nAll folders with sources:\n\n"
      "| folder | what | uses of its library | uses of others |\n|---|---|---|---|\n";
  for (const Folder& folder : kFolders) text += row(folder);
  return text;
}

}  // namespace fulbito::test
