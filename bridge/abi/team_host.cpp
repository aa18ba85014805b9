#include "bridge/abi/team_host.hpp"

#include <cstring>

#include <fmt/format.h>

#include "navigation/library/plugin_values.hpp"

namespace fulbito {
namespace {

std::size_t beginReply(const FrameHeader& request, std::string& out) {
  return beginFrame(static_cast<std::uint16_t>(request.kind + kReplyOffset), request.id, out);
}

/// Takes the settings of the first message. @return false if the message is wrong
bool takeSettings(FrameReader& frame, std::vector<Setting>& settings) {
  HelloBody body{};
  if (!frame.take(body)) return false;
  for (std::uint32_t i = 0; i < body.settings; ++i) {
    std::string_view name, value;
    if (!frame.takeText(name) || !frame.takeText(value)) return false;
    settings.push_back({std::string(name), std::string(value)});
  }
  return frame.rest().empty();
}

CommandBody bodyOf(const fulbito_team_command& command) {
  CommandBody body{};
  std::memcpy(body.robots, command.robots, sizeof body.robots);
  body.drawings = command.drawing_count;
  return body;
}

void appendDrawings(const fulbito_team_command& command, std::string& out) {
  for (std::uint32_t i = 0; i < command.drawing_count; ++i) appendBytes(command.drawings[i], out);
}

tl::unexpected<Error> wrong(const FrameHeader& header) {
  return fail(ErrorCode::kBadInput,
              fmt::format("a message of kind {} with {} bytes is no request", header.kind, header.size));
}

}  // namespace

TeamHost::TeamHost(std::shared_ptr<const TeamLibrary> library, std::vector<Setting> settings, PluginLog log)
    : library_(std::move(library)), settings_(std::move(settings)), log_(std::move(log)) {}

Result<void> TeamHost::answer(std::string_view message, std::string& out) {
  auto frame = FrameReader::open(message);
  if (!frame) return tl::unexpected<Error>(frame.error());
  if (frame->header().kind == static_cast<std::uint16_t>(FrameKind::kHello)) return hello(*frame, out);
  if (team_ == nullptr) return fail(ErrorCode::kBadInput, "a request before the first message");
  if (!handle(*frame, out) || !frame->rest().empty()) return wrong(frame->header());
  if (team_->failure().empty()) return {};
  return fail(ErrorCode::kBadInput, team_->failure());
}

Result<void> TeamHost::hello(FrameReader& frame, std::string& out) {
  std::vector<Setting> settings = settings_;
  if (!takeSettings(frame, settings)) return wrong(frame.header());
  auto team = PluginTeam::create(library_, settings, log_);
  if (!team) return tl::unexpected<Error>(team.error());
  team_ = std::move(*team);
  const char* version = team_->table().version;
  WelcomeBody body{};
  toAbi(std::string_view(team_->table().name), body.name);
  toAbi(std::string_view(version == nullptr ? "" : version), body.version);
  const std::size_t start = beginReply(frame.header(), out);
  appendBytes(body, out);
  endFrame(start, out);
  return {};
}

bool TeamHost::handle(FrameReader& frame, std::string& out) {
  switch (static_cast<FrameKind>(frame.header().kind)) {
    case FrameKind::kBegin:
      return begin(frame, out);
    case FrameKind::kDecide:
      return decide(frame, out);
    case FrameKind::kPlace:
      return place(frame, out);
    case FrameKind::kExercise:
      return exercise(frame, out);
    default:
      return notice(frame);
  }
}

bool TeamHost::begin(FrameReader& frame, std::string& out) {
  fulbito_match_info info{};
  fulbito_curve_widening widening{};
  std::string_view rules;
  if (!frame.take(info) || !frame.take(widening) || !frame.takeText(rules)) return false;
  team_->begin(info, widening, std::string(rules));
  const std::vector<std::string> names = team_->navigatorNames();
  const std::size_t start = beginReply(frame.header(), out);
  appendBytes(NamesBody{static_cast<std::uint32_t>(names.size()), 0}, out);
  for (const std::string& name : names) out.append(name.c_str(), name.size() + 1);
  endFrame(start, out);
  return true;
}

bool TeamHost::decide(FrameReader& frame, std::string& out) {
  if (!frame.take(seen_)) return false;
  fulbito_team_command command = room_.open(seen_.wants_drawings != 0);
  team_->decide(seen_, command);
  room_.close(command);
  const std::size_t start = beginReply(frame.header(), out);
  appendBytes(bodyOf(command), out);
  appendDrawings(command, out);
  endFrame(start, out);
  return true;
}

bool TeamHost::place(FrameReader& frame, std::string& out) {
  fulbito_placement_request request{};
  if (!frame.take(request)) return false;
  fulbito_placement placement{};
  team_->place(request, placement);
  const std::size_t start = beginReply(frame.header(), out);
  appendBytes(placement, out);
  endFrame(start, out);
  return true;
}

bool TeamHost::exercise(FrameReader& frame, std::string& out) {
  ExerciseBody body{};
  if (!frame.take(body)) return false;
  fulbito_team_command command = room_.open(body.seen.wants_drawings != 0);
  fulbito_vec2 answer{};
  bool has_skill = false;
  team_->exercise(body.seen, body.task, command, answer, has_skill);
  room_.close(command);
  const std::size_t start = beginReply(frame.header(), out);
  appendBytes(ExerciseReplyBody{has_skill, 0, answer, bodyOf(command)}, out);
  appendDrawings(command, out);
  endFrame(start, out);
  return true;
}

bool TeamHost::notice(FrameReader& frame) {
  switch (static_cast<FrameKind>(frame.header().kind)) {
    case FrameKind::kStopped: {
      fulbito_stop stop{};
      return frame.take(stop) && (team_->stopped(stop), true);
    }
    case FrameKind::kReady: {
      fulbito_observation seen{};
      return frame.take(seen) && (team_->ready(seen), true);
    }
    case FrameKind::kEnded: {
      fulbito_end end{};
      return frame.take(end) && (team_->ended(end), true);
    }
    default:
      return false;
  }
}

}  // namespace fulbito
