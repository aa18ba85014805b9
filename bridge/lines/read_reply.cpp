#include "bridge/lines/read_reply.hpp"

#include <algorithm>
#include <limits>

#include "bridge/lines/protocol_names.hpp"
#include "bridge/lines/value_text.hpp"

namespace fulbito::lines {
namespace {

using json::Reader;

constexpr std::size_t kLongestName = 100;    // [bytes]
constexpr std::size_t kMostNavigators = 32;  // each robot has an instance of each

/// Members of a reply, as bits of a set.
enum Member : unsigned {
  kType = 1u << 0,
  kId = 1u << 1,
  kProtocol = 1u << 2,
  kName = 1u << 3,
  kVersion = 1u << 4,
  kNavigators = 1u << 5,
  kRobots = 1u << 6,
  kRoles = 1u << 7,
  kDrawings = 1u << 8,
  kPoses = 1u << 9,
  kBall = 1u << 10,
  kAnswer = 1u << 11,
  kError = 1u << 12
};

struct NamedMember {
  std::string_view name;
  Member member;
};

/// Sorted by frequency, since the search is linear.
constexpr NamedMember kMembers[] = {{"type", kType},
                                    {"id", kId},
                                    {"robots", kRobots},
                                    {"roles", kRoles},
                                    {"drawings", kDrawings},
                                    {"poses", kPoses},
                                    {"ball", kBall},
                                    {"answer", kAnswer},
                                    {"navigators", kNavigators},
                                    {"protocol", kProtocol},
                                    {"name", kName},
                                    {"version", kVersion},
                                    {"error", kError}};

/// Reads a point as an object. `other` gets all other members and returns whether it knows them.
template <typename Other>
void readPoint(Reader& in, Vec2& point, Other other) {
  bool x = false, y = false;
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "x") {
      x = true, read(in, point.x);
    } else if (name == "y") {
      y = true, read(in, point.y);
    } else if (!other(name)) {
      in.skip();
    }
  }
  if (!x) in.error("x is missing");
  if (!y) in.error("y is missing");
}

Vec2 pointIn(Reader& in) {
  Vec2 point;
  readPoint(in, point, [](std::string_view) { return false; });
  return point;
}

GoTo goToIn(Reader& in) {
  GoTo go_to;
  readPoint(in, go_to.position, [&](std::string_view name) { return readMember(in, name, go_to); });
  return go_to;
}

/// The members of a robot's command, as bits of a set: each form has its own.
enum Part : unsigned { kLeft = 1u, kRight = 2u, kLinear = 4u, kAngular = 8u, kGoTo = 16u };

unsigned readCommandMember(Reader& in, std::string_view name, RobotCommand& command) {
  if (name == "left") return read(in, command.wheels.left), kLeft;
  if (name == "right") return read(in, command.wheels.right), kRight;
  if (name == "linear") return read(in, command.twist.linear), kLinear;
  if (name == "angular") return read(in, command.twist.angular), kAngular;
  if (name == "go_to") return command.go_to = goToIn(in), kGoTo;
  return in.skip(), 0u;
}

void readCommand(Reader& in, RobotCommand& command) {
  command = RobotCommand{};
  if (in.takeNull() || !in.enterObject()) return;
  unsigned parts = 0;
  for (std::string_view name; in.nextMember(name);) {
    const unsigned part = readCommandMember(in, name, command);
    if ((parts & part) != 0) in.error("given twice");
    parts |= part;
  }
  if (parts == (kLeft | kRight)) {
    command.kind = RobotCommand::Kind::kWheels;
  } else if (parts == (kLinear | kAngular)) {
    command.kind = RobotCommand::Kind::kTwist;
  } else if (parts == kGoTo) {
    command.kind = RobotCommand::Kind::kGoTo;
  } else {
    in.error("must have either left and right, or linear and angular, or go_to");
  }
}

/// Calls `item(i)` for each item of an array of at most `most`.
template <typename Item>
std::size_t readItems(Reader& in, std::size_t most, Item item) {
  std::size_t count = 0;
  if (!in.enterArray()) return 0;
  for (; in.nextItem(); ++count) {
    if (count < most) {
      item(count);
    } else {
      in.error("more than " + std::to_string(most) + " items");
    }
  }
  return count;
}

void readRobots(Reader& in, TeamCommand& command) {
  readItems(in, kMaxTeamSize, [&](std::size_t i) { readCommand(in, command.robots[i]); });
}

void readRoles(Reader& in, TeamCommand& command) {
  readItems(in, kMaxTeamSize, [&](std::size_t i) { read(in, command.roles[i]); });
}

/// Reads the numbers of a drawing and the text behind them, if it has one.
void readShape(Reader& in, std::span<double*> numbers, std::string* text) {
  std::size_t count = 0;
  if (!in.enterArray()) return;
  for (; in.nextItem(); ++count) {
    if (count < numbers.size()) {
      in.number(*numbers[count]);
    } else if (count == numbers.size() && text != nullptr) {
      in.string(*text);
    } else {
      in.error("too many values");
    }
  }
  if (count < numbers.size() + (text != nullptr ? 1 : 0)) in.error("too few values");
}

void readDrawing(Reader& in, DebugDrawing& drawing) {
  double* line[] = {&drawing.from.x, &drawing.from.y, &drawing.to.x, &drawing.to.y};
  double* circle[] = {&drawing.from.x, &drawing.from.y, &drawing.radius};
  double* text[] = {&drawing.from.x, &drawing.from.y};
  int shapes = 0;
  drawing.text.clear();
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "line") {
      ++shapes, drawing.kind = DebugDrawing::Kind::kLine, readShape(in, line, nullptr);
    } else if (name == "circle") {
      ++shapes, drawing.kind = DebugDrawing::Kind::kCircle, readShape(in, circle, nullptr);
    } else if (name == "text") {
      ++shapes, drawing.kind = DebugDrawing::Kind::kText, readShape(in, text, &drawing.text);
    } else {
      in.skip();
    }
  }
  if (shapes != 1) in.error("must have one of line, circle and text");
}

void readDrawings(Reader& in, std::vector<DebugDrawing>& drawings) {
  std::size_t count = 0;
  if (!in.enterArray()) return;
  for (; in.nextItem(); ++count) {
    if (count == drawings.size()) drawings.emplace_back();
    readDrawing(in, drawings[count]);
  }
  drawings.resize(count);
}

void readPoses(Reader& in, TeamPlacement& poses) {
  readItems(in, kMaxTeamSize, [&](std::size_t i) {
    if (in.takeNull()) return;
    Pose2 pose;
    bool heading = false;
    readPoint(in, pose.position, [&](std::string_view name) {
      if (name != "heading") return false;
      heading = true;
      read(in, pose.heading);
      return true;
    });
    if (!heading) in.error("heading is missing");
    poses[i] = pose;
  });
}

/// Reads a text that tables show.
void readLabel(Reader& in, std::string& into, std::size_t least) {
  if (!in.string(into)) return;
  const bool control = std::any_of(into.begin(), into.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (control || into.size() < least || into.size() > kLongestName) {
    in.error("must have " + std::to_string(least) + " ... " + std::to_string(kLongestName) +
             " bytes, none of them a control character");
  }
}

void readNavigators(Reader& in, std::vector<std::string>& navigators) {
  const std::size_t count = readItems(in, kMostNavigators, [&](std::size_t i) {
    if (i == navigators.size()) navigators.emplace_back();
    in.string(navigators[i]);
  });
  navigators.resize(std::min(count, navigators.size()));
}

/// The members of a reply that `TeamReply` does not hold.
struct Envelope {
  unsigned seen = 0;  ///< set of `Member`
  std::string type, protocol, error;
};

void readType(Reader& in, Envelope& envelope, TeamReply& reply) {
  if (!in.string(envelope.type)) return;
  const auto* const found = std::find(std::begin(kRequestTypes), std::end(kRequestTypes), envelope.type);
  if (found == std::end(kRequestTypes)) {
    in.error("unknown; it must be hello, begin, decide, place or exercise");
    return;
  }
  reply.kind = static_cast<TeamReply::Kind>(found - std::begin(kRequestTypes));
}

void readId(Reader& in, TeamReply& reply) {
  std::int64_t id = 0;
  if (in.integer(id, 0, std::numeric_limits<std::int64_t>::max())) reply.id = static_cast<std::uint64_t>(id);
}

void readPart(Reader& in, Member member, Envelope& envelope, TeamReply& reply) {
  switch (member) {
    case kType:
      return readType(in, envelope, reply);
    case kId:
      return readId(in, reply);
    case kRobots:
      return readRobots(in, reply.command);
    case kRoles:
      return readRoles(in, reply.command);
    case kDrawings:
      return readDrawings(in, reply.command.drawings);
    case kPoses:
      if (!reply.proposal) reply.proposal.emplace();
      return readPoses(in, reply.proposal->robots);
    case kBall:
      if (in.takeNull()) return;
      if (!reply.proposal) reply.proposal.emplace();
      reply.proposal->ball = pointIn(in);
      return;
    case kAnswer:
      if (!reply.exercise) reply.exercise.emplace();
      reply.exercise->answer = pointIn(in);
      return;
    case kNavigators:
      return readNavigators(in, reply.navigators);
    case kProtocol:
      in.string(envelope.protocol);
      return;
    case kName:
      return readLabel(in, reply.welcome.name, 1);
    case kVersion:
      return readLabel(in, reply.welcome.version, 0);
    case kError:
      in.string(envelope.error);
      return;
  }
}

/// Clears the members of `reply` that the last reply has set and this one lacks.
void forget(TeamReply& reply, unsigned seen) {
  if ((seen & kDrawings) == 0) reply.command.drawings.clear();
  if ((seen & kNavigators) == 0) reply.navigators.clear();
  if ((seen & kVersion) == 0) reply.welcome.version.clear();
}

void readMembers(Reader& in, Envelope& envelope, TeamReply& reply) {
  reply.proposal.reset();
  reply.exercise.reset();
  reply.command.robots = {};
  reply.command.roles = {};
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    const auto* const known = std::find_if(std::begin(kMembers), std::end(kMembers),
                                           [&](const NamedMember& m) { return m.name == name; });
    if (known == std::end(kMembers)) {
      in.skip();
      continue;
    }
    if ((envelope.seen & known->member) != 0) in.error("given twice");
    envelope.seen |= known->member;
    readPart(in, known->member, envelope, reply);
  }
  in.end();
}

/// The reason why a reply is incomplete; empty: it is complete.
std::string lackOf(const Envelope& envelope, const TeamReply& reply) {
  const auto has = [&](unsigned members) { return (envelope.seen & members) != 0; };
  if (!has(kType)) return "type is missing";
  if (!has(kId)) return "id is missing";
  if (has(kError)) return "the team reports: " + envelope.error;
  switch (reply.kind) {
    case TeamReply::Kind::kHello:
      if (!has(kProtocol)) return "protocol is missing";
      if (envelope.protocol != protocolName())
        return "protocol: the team speaks '" + envelope.protocol.substr(0, kLongestName) +
               "', the simulator " + protocolName();
      return has(kName) ? "" : "name is missing";
    case TeamReply::Kind::kDecide:
      return has(kRobots) ? "" : "robots is missing";
    case TeamReply::Kind::kBegin:
    case TeamReply::Kind::kPlace:
      return "";
    case TeamReply::Kind::kExercise:
      return has(kAnswer) && !has(kRobots) ? "robots is missing" : "";
  }
  return "";
}

}  // namespace

Result<void> readReply(std::string_view line, TeamReply& reply) {
  Reader in(line);
  Envelope envelope;
  readMembers(in, envelope, reply);
  if (!in.ok()) return fail(ErrorCode::kBadInput, in.message());
  if (auto lack = lackOf(envelope, reply); !lack.empty()) return fail(ErrorCode::kBadInput, std::move(lack));
  forget(reply, envelope.seen);
  if (reply.kind == TeamReply::Kind::kExercise && (envelope.seen & kRobots) != 0) {
    if (!reply.exercise) reply.exercise.emplace();
    reply.exercise->command = reply.command;
  }
  return {};
}

}  // namespace fulbito::lines
