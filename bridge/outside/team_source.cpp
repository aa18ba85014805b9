#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "bridge/abi/abi_codec.hpp"
#include "bridge/abi/library_team.hpp"
#include "bridge/lines/line_codec.hpp"
#include "bridge/outside/conversation.hpp"
#include "bridge/outside/outside_team.hpp"
#include "bridge/outside/team_command.hpp"
#include "engine/core/system/machine_room.hpp"
#include "engine/core/system/stop_request.hpp"
#include "fulbito/outside.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHost = "fulbito-team-host";

// The folder that has `file`. `built` and `installed` are relative to the running program: its place in a
// build, and after an installation.
std::optional<fs::path> folderOf(const char* file, const char* built, const char* installed) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& place : {folder / built, folder / installed}) {
    if (fs::is_regular_file(place / file, error)) return place.lexically_normal();
  }
  return std::nullopt;
}

// The path of the program that hosts a library.
Result<std::string> hostOf(const OutsideOptions& options) {
  if (!options.host.empty()) return options.host;
  const auto folder = folderOf(kHost, ".", "../libexec/fulbito");
  if (folder) return (*folder / kHost).string();
  return fail(ErrorCode::kUsage,
              fmt::format("there is no {} beside the program or in ../libexec/fulbito", kHost));
}

// The libraries that auditwheel puts beside the Python package, whose `bin` has the host.
std::vector<std::string> librariesOf(const std::string& host) {
  std::error_code error;
  const fs::path folder = fs::path(host).parent_path() / "../../fulbito.libs";
  return fs::is_directory(folder, error) ? std::vector{folder.lexically_normal().string()}
                                         : std::vector<std::string>{};
}

// The folder of the module that Python programs import.
std::vector<std::string> modules(const OutsideOptions& options) {
  if (!options.python_folder.empty()) return {options.python_folder};
  const auto folder = folderOf("fulbito_team.py", "python", "../share/fulbito/python");
  return folder ? std::vector{folder->string()} : std::vector<std::string>{};
}

Result<OutsideTeamSetup> setupOf(const std::string& specification, const TeamCommandLine& line,
                                 const OutsideOptions& options) {
  OutsideTeamSetup setup;
  setup.child.command = line.command;
  if (line.library) {
    auto host = hostOf(options);
    if (!host) return tl::unexpected<Error>(host.error());
    setup.child.readable = librariesOf(*host);
    setup.child.command.insert(setup.child.command.begin(), std::move(*host));
  } else {
    setup.child.readable = modules(options);
  }
  setup.child.own_folder = line.folder;
  setup.child.program_alone = line.library;
  setup.child.limits = options.limits;
  setup.child.sandbox_required = options.sandbox_required;
  if (line.library) {
    setup.codec = [] { return std::make_unique<AbiCodec>(); };
  } else {
    setup.codec = [] { return std::make_unique<LineCodec>(); };
  }
  setup.settings = line.settings;
  setup.clock = options.clock;
  if (options.log) {
    setup.log = [show = options.log, specification](std::string_view text) { show(specification, text); };
  }
  return setup;
}

// A word of the command that looks like a file which does not exist, such as the script of an interpreter.
std::string missingFile(const TeamCommandLine& line) {
  for (std::size_t i = 1; i < line.command.size(); ++i) {
    const std::string& word = line.command[i];
    const bool named = word.find_first_of("./") != std::string::npos &&
                       word.find_first_of(" \t\n=") == std::string::npos && !word.starts_with('-');
    std::error_code error;
    if (named && !fs::exists(word, error)) return word;
  }
  return {};
}

// Starts the team once, so that a failing start is reported before a match begins.
Result<TeamWelcome> tryStart(const OutsideTeamSetup& setup) {
  BoundedLog errors(setup.log);
  Conversation talk(setup, errors);
  const std::uint64_t id = talk.next();
  const TeamHello hello{"fulbito", setup.settings};
  talk.send([&](TeamCodec& codec, std::string& out) { codec.hello(id, hello, out); });
  const double limit = DecisionTime{}.start;
  TeamReply* reply = talk.await(id, TeamReply::Kind::kHello, limit);
  if (reply != nullptr) return std::move(reply->welcome);
  if (stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
  talk.fail(fmt::format("no start within {} s", limit));
  return fail(talk.code(), talk.failure());
}

Error explained(Error error, const TeamCommandLine& line) {
  const std::string missing = line.library ? "" : missingFile(line);
  if (missing.empty()) return error;
  std::error_code unknown;
  error.message += fmt::format("; there is no file '{}'", missing);
  if (!missing.starts_with('/')) error.message += fmt::format(" in {}", fs::current_path(unknown).string());
  return error;
}

Result<TeamInfo> processInfo(const std::string& specification, const TeamCommandLine& line,
                             const OutsideOptions& options) {
  auto setup = setupOf(specification, line, options);
  if (!setup) return tl::unexpected<Error>(setup.error());
  const auto welcome = MachineRoom().run([&] { return tryStart(*setup); });
  if (!welcome) return tl::unexpected<Error>(explained(welcome.error(), line));
  TeamInfo info;
  info.name = specification;
  info.summary = fmt::format("{} {}", welcome->name, welcome->version);
  info.outside = true;
  info.make = [setup = std::move(*setup)](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
    return std::make_unique<OutsideTeam>(setup);
  };
  return info;
}

Result<TeamChoice> choiceOf(const std::string& specification, const OutsideOptions& options) {
  const auto line = parseTeamCommand(specification);
  if (!line) return tl::unexpected<Error>(line.error());
  const bool in_process = line->library && options.isolation == OutsideOptions::Isolation::kNone;
  auto info =
      in_process ? loadTeamLibrary(line->command.front()) : processInfo(specification, *line, options);
  if (!info)
    return fail(info.error().code, fmt::format("team '{}': {}", specification, info.error().message));
  TeamChoice choice{std::make_shared<const TeamInfo>(std::move(*info)),
                    specification,
                    line->settings,
                    {{"hash", line->hash}}};
  if (const auto trial = makeTeam(choice); !trial) return tl::unexpected<Error>(trial.error());
  return choice;
}

}  // namespace

TeamCatalogue::Source outsideTeams(OutsideOptions options) {
  return
      [options = std::move(options)](const std::string& specification) -> std::optional<Result<TeamChoice>> {
        if (!isOutside(specification)) return std::nullopt;
        return choiceOf(specification, options);
      };
}

}  // namespace fulbito
