// A team's side of the line protocol, without the pipes.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fulbito/detail/lines/read_values.hpp"
#include "fulbito/detail/lines/write_answers.hpp"
#include "fulbito/team.hpp"

namespace fulbito::team::program {

/// Version of the protocol, as in the handshake.
inline constexpr std::string_view kProtocol = "fulbito-team/1";

/// A message of the simulator. Its type decides which members are set.
struct Message {
  std::string type;             ///< kind of message
  std::int64_t id = 0;          ///< number of a request
  Observation now;              ///< observation; most types have one
  PlacementRequest placement;   ///< content of `place`; its cause is also that of `stopped`
  Exercise exercise;            ///< content of `exercise`
  End end;                      ///< content of `ended`
  Info info;                    ///< content of `begin`
  std::string protocol;         ///< content of `hello`: version of the protocol
  std::string setting_problem;  ///< content of `hello`: a setting that the team does not take
};

/// One team's side of the conversation: for each line in, one line out or none.
class Conversation {
 public:
  /// `team` receives all messages, and first the settings in `hello`.
  explicit Conversation(std::unique_ptr<Team> team) : team_(std::move(team)) {}

  /// Takes a line of the simulator and appends the answer with its line end, if it gets one.
  /// Throws std::runtime_error if the line is not a message, and whatever the team throws.
  void take(std::string_view line, std::string& out) {
    Reader in(line);
    read(in);
    in.end();
    if (!in.ok()) throw std::runtime_error("the simulator's message is not understood: " + in.message());
    answer(out);
  }

 private:
  void read(Reader& in) {
    // The protocol has `type` first in all messages, because it decides what the other members mean.
    message_.type.clear();
    readObject(in, [&](std::string_view name) {
      if (name != "type") return readMember(in, name);
      in.string(message_.type);
      if (message_.type == "begin") message_.info = Info{};
      if (message_.type == "place") message_.placement = PlacementRequest{};
      if (message_.type == "ended") message_.end = End{};
      return true;
    });
  }
  bool readMember(Reader& in, std::string_view name) {
    if (name == "id") return in.integer(message_.id, 0, std::numeric_limits<std::int64_t>::max()), true;
    if (name == "now") return program::read(in, message_.now), true;
    if (name == "exercise") return program::read(in, message_.exercise), true;
    if (name == "protocol") return in.string(message_.protocol), true;
    if (name == "settings") return message_.setting_problem = readSettings(in, *team_), true;
    if (message_.type == "begin") return readInfoMember(in, name, message_.info);
    if (message_.type == "ended") return program::readMember(in, name, message_.end);
    return program::readMember(in, name, message_.placement);  // its cause is also that of `stopped`
  }

  void answer(std::string& out) {
    const std::string& type = message_.type;
    message_.now.dt = message_.info.dt;
    if (type == "decide") return decide(out);
    if (type == "hello") return hello(out);
    if (type == "begin") return begin(out);
    if (type == "place") return place(out);
    if (type == "exercise") return exercise(out);
    if (type == "stopped") return team_->stopped({message_.placement.cause, message_.now});
    if (type == "ready") return team_->ready(message_.now);
    if (type == "ended") return team_->ended(message_.end);
    // A later version of the protocol may have more notices: they get no answer.
  }
  void open(std::string& out) const {
    add(out, R"({"type":)", std::string_view(message_.type));
    add(out, R"(,"id":)", message_.id);
  }
  void decide(std::string& out) {
    const Commands commands = team_->decide(message_.now);
    open(out);
    append(out, commands, teamSize());
    out += "}\n";
  }
  void hello(std::string& out) {
    open(out);
    if (message_.protocol != kProtocol) {
      message_.setting_problem = "this team speaks " + std::string(kProtocol);
    }
    if (!message_.setting_problem.empty()) {
      add(out, R"(,"error":)", std::string_view(message_.setting_problem));
    } else {
      add(out, R"(,"protocol":)", kProtocol);
      add(out, R"(,"name":)", std::string_view(team_->name()));
      add(out, R"(,"version":)", std::string_view(team_->version()));
    }
    out += "}\n";
  }
  void begin(std::string& out) {
    team_->start(message_.info);
    open(out);
    out += R"(,"navigators":[)";
    bool first = true;
    for (const std::string& navigator : team_->navigators()) {
      add(out, first ? "" : ",", std::string_view(navigator));
      first = false;
    }
    out += "]}\n";
  }
  void place(std::string& out) {
    message_.placement.now = message_.now;
    const std::optional<Placement> wishes = team_->place(message_.placement);
    open(out);
    if (wishes) {
      append(out, wishes->robots, teamSize());
      if (wishes->ball) append(out, R"(,"ball":)", *wishes->ball);
    }
    out += "}\n";
  }
  void exercise(std::string& out) {
    const std::optional<ExerciseReply> reply = team_->exercise(message_.now, message_.exercise);
    open(out);
    if (reply) {
      append(out, reply->commands, teamSize());
      append(out, R"(,"answer":)", reply->answer);
    }
    out += "}\n";
  }
  std::size_t teamSize() const { return static_cast<std::size_t>(message_.now.team_size); }

  std::unique_ptr<Team> team_;
  Message message_;
};

}  // namespace fulbito::team::program
