#include "bridge/lines/line_codec.hpp"

#include "bridge/lines/protocol_names.hpp"
#include "bridge/lines/read_reply.hpp"
#include "bridge/lines/value_text.hpp"

namespace fulbito {
namespace {

using namespace lines;

void open(std::string& out, std::string_view type) { add(out, R"({"type":)", type); }

void open(std::string& out, TeamReply::Kind kind, std::uint64_t id) {
  open(out, typeOf(kind));
  add(out, R"(,"id":)", id);
}

void close(std::string& out) { out += "}\n"; }

}  // namespace

void LineCodec::hello(std::uint64_t id, const TeamHello& hello, std::string& out) {
  open(out, TeamReply::Kind::kHello, id);
  add(out, R"(,"protocol":)", std::string_view(protocolName()));
  add(out, R"(,"simulator":)", std::string_view(hello.simulator));
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
  out += ',';
  appendInfo(out, info);
  close(out);
}

void LineCodec::decide(std::uint64_t id, const Observation& observation, std::string& out) {
  open(out, TeamReply::Kind::kDecide, id);
  add(out, R"(,"now":)", observation);
  close(out);
}

void LineCodec::place(std::uint64_t id, const PlacementRequest& request, std::string& out) {
  open(out, TeamReply::Kind::kPlace, id);
  out += ',';
  appendPlacementRequest(out, request);
  close(out);
}

void LineCodec::exercise(std::uint64_t id, const Observation& observation, const Exercise& exercise,
                         std::string& out) {
  open(out, TeamReply::Kind::kExercise, id);
  add(out, R"(,"exercise":)", exercise);
  add(out, R"(,"now":)", observation);
  close(out);
}

void LineCodec::stopped(const PlayStop& stop, std::string& out) {
  open(out, "stopped");
  add(out, R"(,"cause":)", stop.cause);
  add(out, R"(,"now":)", stop.now);
  close(out);
}

void LineCodec::ready(const Observation& observation, std::string& out) {
  open(out, "ready");
  add(out, R"(,"now":)", observation);
  close(out);
}

void LineCodec::ended(const MatchEnd& end, std::string& out) {
  open(out, "ended");
  out += ',';
  appendEnd(out, end);
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
