#include "bridge/abi/abi_codec.hpp"

#include <cstring>

#include <fmt/format.h>

#include "bridge/abi/team_values.hpp"
#include "fulbito/referee.hpp"

namespace fulbito {
namespace {

constexpr std::uint32_t kMostNavigators = 256;

template <typename T>
void appendFrame(FrameKind kind, std::uint64_t id, const T& body, std::string& out) {
  const std::size_t begin = beginFrame(static_cast<std::uint16_t>(kind), id, out);
  appendBytes(body, out);
  endFrame(begin, out);
}

void appendText(const std::string& text, std::string& out) {
  out.append(text.c_str(), std::strlen(text.c_str()) + 1);
}

std::string nameIn(const char (&name)[FULBITO_NAME_SIZE]) { return {name, strnlen(name, sizeof name)}; }

/// The kind of reply that a frame is; empty: none.
std::optional<TeamReply::Kind> replyKind(std::uint16_t kind) {
  if (kind <= kReplyOffset) return std::nullopt;
  switch (static_cast<FrameKind>(kind - kReplyOffset)) {
    case FrameKind::kHello:
      return TeamReply::Kind::kHello;
    case FrameKind::kBegin:
      return TeamReply::Kind::kBegin;
    case FrameKind::kDecide:
      return TeamReply::Kind::kDecide;
    case FrameKind::kPlace:
      return TeamReply::Kind::kPlace;
    case FrameKind::kExercise:
      return TeamReply::Kind::kExercise;
    default:
      return std::nullopt;
  }
}

bool readWelcome(FrameReader& frame, TeamWelcome& welcome) {
  WelcomeBody body{};
  if (!frame.take(body)) return false;
  welcome.name = nameIn(body.name);
  welcome.version = nameIn(body.version);
  return true;
}

bool readNames(FrameReader& frame, std::vector<std::string>& names) {
  NamesBody body{};
  if (!frame.take(body) || body.count > kMostNavigators) return false;
  names.clear();
  for (std::uint32_t i = 0; i < body.count; ++i) {
    std::string_view name;
    if (!frame.takeText(name)) return false;
    names.emplace_back(name);
  }
  return true;
}

bool readPlacement(FrameReader& frame, std::optional<TeamProposal>& proposal) {
  fulbito_placement body{};
  if (!frame.take(body)) return false;
  proposal = fromAbi(body);
  return true;
}

}  // namespace

void AbiCodec::hello(std::uint64_t id, const TeamHello& hello, std::string& out) {
  const std::size_t begin = beginFrame(static_cast<std::uint16_t>(FrameKind::kHello), id, out);
  HelloBody body{};
  toAbi(hello.simulator, body.simulator);
  body.settings = static_cast<std::uint32_t>(hello.settings.size());
  appendBytes(body, out);
  for (const Setting& setting : hello.settings) {
    appendText(setting.name, out);
    appendText(setting.value, out);
  }
  endFrame(begin, out);
}

void AbiCodec::begin(std::uint64_t id, const MatchInfo& info, std::string& out) {
  seen_ = {};
  const std::size_t begin = beginFrame(static_cast<std::uint16_t>(FrameKind::kBegin), id, out);
  appendBytes(abiOf<fulbito_match_info>(info), out);
  appendBytes(wideningToAbi(info.robot), out);
  appendText(toToml(info.rules), out);
  endFrame(begin, out);
}

void AbiCodec::decide(std::uint64_t id, const Observation& observation, std::string& out) {
  toAbi(observation, seen_);
  appendFrame(FrameKind::kDecide, id, seen_, out);
}

void AbiCodec::place(std::uint64_t id, const PlacementRequest& request, std::string& out) {
  fulbito_placement_request body{};
  toAbi(request, body);
  appendFrame(FrameKind::kPlace, id, body, out);
}

void AbiCodec::exercise(std::uint64_t id, const Observation& observation, const Exercise& exercise,
                        std::string& out) {
  toAbi(observation, seen_);
  appendFrame(FrameKind::kExercise, id, ExerciseBody{seen_, abiOf<fulbito_exercise>(exercise)}, out);
}

void AbiCodec::stopped(const PlayStop& stop, std::string& out) {
  fulbito_stop body{};
  toAbi(stop, body);
  appendFrame(FrameKind::kStopped, 0, body, out);
}

void AbiCodec::ready(const Observation& observation, std::string& out) {
  fulbito_observation body{};
  toAbi(observation, body);
  appendFrame(FrameKind::kReady, 0, body, out);
}

void AbiCodec::ended(const MatchEnd& end, std::string& out) {
  appendFrame(FrameKind::kEnded, 0, abiOf<fulbito_end>(end), out);
}

Result<std::size_t> AbiCodec::firstMessage(std::string_view received) const { return frameLength(received); }

bool AbiCodec::readCommand(FrameReader& frame, const CommandBody& body, TeamCommand& command) {
  if (body.drawings > kMostDrawings) return false;
  drawings_.resize(body.drawings);
  for (fulbito_drawing& drawing : drawings_) {
    if (!frame.take(drawing)) return false;
  }
  fulbito_team_command from{};
  std::memcpy(from.robots, body.robots, sizeof from.robots);
  from.drawings = drawings_.data();
  from.drawing_count = from.drawing_capacity = body.drawings;
  fromAbi(from, FULBITO_MAX_ROBOTS, command);
  return true;
}

bool AbiCodec::readBody(FrameReader& frame, TeamReply& reply) {
  switch (reply.kind) {
    case TeamReply::Kind::kHello:
      return readWelcome(frame, reply.welcome);
    case TeamReply::Kind::kBegin:
      return readNames(frame, reply.navigators);
    case TeamReply::Kind::kDecide: {
      CommandBody body{};
      return frame.take(body) && readCommand(frame, body, reply.command);
    }
    case TeamReply::Kind::kPlace:
      return readPlacement(frame, reply.proposal);
    case TeamReply::Kind::kExercise: {
      ExerciseReplyBody body{};
      if (!frame.take(body)) return false;
      reply.exercise.reset();
      ExerciseReply exercise;
      if (!readCommand(frame, body.command, exercise.command)) return false;
      exercise.answer = fromAbi(body.answer);
      if (body.has_skill != 0) reply.exercise = std::move(exercise);
      return true;
    }
  }
  return false;
}

Result<void> AbiCodec::read(std::string_view message, TeamReply& reply) {
  auto frame = FrameReader::open(message);
  if (!frame) return tl::unexpected<Error>(frame.error());
  if (frame->header().kind == static_cast<std::uint16_t>(FrameKind::kFailed)) {
    std::string_view reason;
    const bool told = frame->takeText(reason) && !reason.empty();
    return fail(ErrorCode::kBadInput, told ? failureText(reason) : "it fails without a reason");
  }
  const auto kind = replyKind(frame->header().kind);
  if (!kind) {
    return fail(ErrorCode::kBadInput, fmt::format("a message of the unknown kind {}", frame->header().kind));
  }
  reply.kind = *kind;
  reply.id = frame->header().id;
  if (!readBody(*frame, reply) || !frame->rest().empty()) {
    return fail(ErrorCode::kBadInput, fmt::format("a reply of kind {} has a wrong length of {} bytes",
                                                  frame->header().kind, message.size()));
  }
  return {};
}

}  // namespace fulbito
