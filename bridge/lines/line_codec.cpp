#include "bridge/lines/line_codec.hpp"

#include "bridge/lines/match_info_text.hpp"
#include "bridge/lines/protocol_names.hpp"
#include "bridge/lines/read_reply.hpp"
#include "bridge/lines/write_values.hpp"
#include "fulbito/detail/lines/json_text.hpp"

namespace fulbito {
namespace {

using namespace lines;

void open(std::string& out, std::string_view type) {
  out += R"({"type":)";
  json::append(out, type);
}

void open(std::string& out, TeamReply::Kind kind, std::uint64_t id) {
  open(out, typeOf(kind));
  out += R"(,"id":)";
  json::append(out, id);
}

void appendNow(std::string& out, const Observation& observation) {
  out += R"(,"now":)";
  append(out, observation);
}

void appendCause(std::string& out, const GameEvent& cause) {
  out += R"(,"cause":)";
  append(out, cause);
}

void close(std::string& out) { out += "}\n"; }

const char* nameOf(MatchEnd::Reason reason) {
  constexpr const char* kNames[] = {"played", "abandoned", "interrupted"};
  return kNames[static_cast<std::size_t>(reason)];
}

}  // namespace

void LineCodec::hello(std::uint64_t id, const TeamHello& hello, std::string& out) {
  open(out, TeamReply::Kind::kHello, id);
  out += R"(,"protocol":)";
  json::append(out, std::string_view(protocolName()));
  out += R"(,"simulator":)";
  json::append(out, std::string_view(hello.simulator));
  out += R"(,"settings":{)";
  for (std::size_t i = 0; i < hello.settings.size(); ++i) {
    if (i > 0) out += ',';
    json::append(out, std::string_view(hello.settings[i].name));
    out += ':';
    json::append(out, std::string_view(hello.settings[i].value));
  }
  out += '}';
  close(out);
}

void LineCodec::begin(std::uint64_t id, const MatchInfo& info, std::string& out) {
  open(out, TeamReply::Kind::kBegin, id);
  appendMembers(out, info);
  close(out);
}

void LineCodec::decide(std::uint64_t id, const Observation& observation, std::string& out) {
  open(out, TeamReply::Kind::kDecide, id);
  appendNow(out, observation);
  close(out);
}

void LineCodec::place(std::uint64_t id, const PlacementRequest& request, std::string& out) {
  open(out, TeamReply::Kind::kPlace, id);
  out += R"(,"kind":)";
  json::append(out, fulbito::nameOf(request.kind));
  out += R"(,"ours":)";
  json::append(out, request.ours);
  out += R"(,"delay":)";
  json::append(out, request.delay);
  out += R"(,"ball":)";
  append(out, request.ball);
  out += R"(,"defaults":)";
  append(out, request.defaults, request.now.team_size);
  out += R"(,"opponents":)";
  if (request.opponents) {
    append(out, *request.opponents, request.now.team_size);
  } else {
    out += "null";
  }
  appendCause(out, request.cause);
  appendNow(out, request.now);
  close(out);
}

void LineCodec::exercise(std::uint64_t id, const Observation& observation, const Exercise& exercise,
                         std::string& out) {
  open(out, TeamReply::Kind::kExercise, id);
  out += R"(,"exercise":)";
  append(out, exercise);
  appendNow(out, observation);
  close(out);
}

void LineCodec::stopped(const PlayStop& stop, std::string& out) {
  open(out, "stopped");
  appendCause(out, stop.cause);
  appendNow(out, stop.now);
  close(out);
}

void LineCodec::ready(const Observation& observation, std::string& out) {
  open(out, "ready");
  appendNow(out, observation);
  close(out);
}

void LineCodec::ended(const MatchEnd& end, std::string& out) {
  open(out, "ended");
  out += R"(,"reason":)";
  json::append(out, nameOf(end.reason));
  out += R"(,"tick":)";
  json::append(out, end.tick);
  out += R"(,"own_score":)";
  json::append(out, end.own_score);
  out += R"(,"opponent_score":)";
  json::append(out, end.opponent_score);
  out += R"(,"winner":)";
  end.winner ? json::append(out, fulbito::nameOf(*end.winner)) : json::append(out, nullptr);
  appendCause(out, end.cause);
  close(out);
}

Result<std::size_t> LineCodec::firstMessage(std::string_view received) const {
  const std::size_t end = received.substr(0, kMaxLine).find('\n');
  if (end != std::string_view::npos) return end + 1;
  if (received.size() < kMaxLine) return 0;
  return fail(ErrorCode::kBadInput, "a line is longer than 1 MiB");
}

Result<void> LineCodec::read(std::string_view message, TeamReply& reply) { return readReply(message, reply); }

}  // namespace fulbito
