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

/// A message of the simulator that asks or tells something of the game.
struct Message {
  std::string type;             ///< kind of message
  std::int64_t id = 0;          ///< of a request
  Observation now;              ///< the game
  PlacementRequest placement;   ///< of `place`; its cause is also that of `stopped` and `ended`
  Exercise exercise;            ///< of `exercise`
  End end;                      ///< of `ended`
  Info info;                    ///< of `begin`
  std::string protocol;         ///< of `hello`
  std::string setting_problem;  ///< of `hello`
};

/// One team's side of the conversation: a line in, a line out or nothing.
class Conversation {
 public:
  /// `make` creates the team, which needs the first line's settings.
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
    // `type` is first in all messages, as the protocol says: members mean different things by it.
    message_.type.clear();
    if (!in.enterObject()) return;
    for (std::string_view name; in.nextMember(name);) {
      if (name == "type") {
        in.string(message_.type);
        if (message_.type == "begin") message_.info = Info{};
        if (message_.type == "place") message_.placement = PlacementRequest{};
      } else if (name == "id") {
        in.integer(message_.id, 0, std::numeric_limits<std::int64_t>::max());
      } else if (name == "now") {
        readObservation(in, message_.now);
      } else if (message_.type == "begin") {
        readInfoMember(in, name, message_.info);
      } else if (message_.type == "place") {
        readPlacement(in, name);
      } else {
        readOther(in, name);
      }
    }
  }
  void readPlacement(Reader& in, std::string_view name) {
    PlacementRequest& request = message_.placement;
    if (name == "kind") {
      request.kind = readRestart(in);
    } else if (name == "ours") {
      in.boolean(request.ours);
    } else if (name == "delay") {
      in.number(request.delay);
    } else if (name == "ball") {
      readTable(in, {{"x", &request.ball.x}, {"y", &request.ball.y}});
    } else if (name == "defaults") {
      readPoses(in, request.defaults);
    } else if (name == "opponents") {
      if (!in.takeNull()) readPoses(in, request.opponents.emplace());
    } else {
      readOther(in, name);
    }
  }
  void readOther(Reader& in, std::string_view name) {
    if (name == "cause") {
      readCall(in, message_.placement.cause);
    } else if (name == "exercise") {
      readExercise(in, message_.exercise);
    } else if (name == "protocol") {
      in.string(message_.protocol);
    } else if (name == "settings") {
      message_.setting_problem = readSettings(in, *team_);
    } else if (message_.type == "ended") {
      readEnd(in, name);
    } else {
      in.skip();
    }
  }
  void readEnd(Reader& in, std::string_view name) {
    End& end = message_.end;
    if (name == "reason") {
      end.reason = static_cast<End::Reason>(readWord(in, {"played", "abandoned", "interrupted"}));
    } else if (name == "tick") {
      in.integer(end.tick, 0, std::numeric_limits<std::int64_t>::max());
    } else if (name == "own_score") {
      readInt(in, end.own_score);
    } else if (name == "opponent_score") {
      readInt(in, end.opponent_score);
    } else if (name == "winner") {
      end.winner.reset();
      if (!in.takeNull()) end.winner = readColour(in);
    } else {
      in.skip();
    }
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
    if (type == "ended") return ended();
    // A notice of a later version.
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
  void ended() {
    message_.end.cause = message_.placement.cause;
    team_->ended(message_.end);
  }
  std::size_t teamSize() const { return static_cast<std::size_t>(message_.now.team_size); }

  std::unique_ptr<Team> team_;
  Message message_;
};

}  // namespace fulbito::team::program
