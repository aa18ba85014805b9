#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "fulbito/recording.hpp"

namespace fulbito::app {

/// A command of the referee in a recording.
struct ToldCommand {
  Tick frame = 0;  ///< tick of the frame that it precedes; after the last one: it follows all
  wire::RefereeCommand command;
};

/// A recorded match as a server of the league's protocol tells it: a frame per tick, and the referee's
/// commands.
class ToldRecording {
 public:
  /// Unpacks a recording. States are exact where the match can be simulated again, and otherwise those of
  /// samples. Errors: kBadInput for what is not a match with one ball, or cannot be shown; kInterrupted.
  static Result<ToldRecording> read(const RecordingReader& recording);

  int controlRate() const { return header_.control_rate; }
  /// Frames have the ticks 1 ... ticks().
  Tick ticks() const { return static_cast<Tick>(moments_.size()); }
  /// The frame of a tick, without a step. Empty: the recording lacks it.
  std::optional<wire::Vision> frame(Tick tick) const;
  /// Whether all frames have exact states.
  bool exact() const { return exact_; }
  /// In the order of their frames.
  const std::vector<ToldCommand>& commands() const { return commands_; }

 private:
  struct Body {
    bool present = false;
    RobotState state;  ///< of the ball: position and velocity
  };
  struct Moment {
    bool lost = false;
    bool playing = false;
    PerTeam<std::uint32_t> goals{};
  };
  class Collector;

  ToldRecording() = default;
  void addRest(const ReplayTimeline& timeline);
  void addScore(const ReplayTimeline& timeline);
  void addHeard(const ReplayTimeline& timeline);
  void addCalled(const ReplayTimeline& timeline);
  void addMoment(bool playing) {
    moments_.push_back({false, playing, {}});
    bodies_.resize(bodies_.size() + header_.bodies.size());
  }
  Body& body(Tick tick, std::size_t number) {
    return bodies_[static_cast<std::size_t>(tick - 1) * header_.bodies.size() + number];
  }
  void moveFromBefore(Tick tick);

  RecordingHeader header_;
  bool exact_ = true;
  FieldGeometry field_;
  double ball_radius_ = 0.0;
  std::vector<Moment> moments_;  ///< per tick
  std::vector<Body> bodies_;     ///< per tick and body of the header, in the wire's frame
  std::vector<ToldCommand> commands_;
};

}  // namespace fulbito::app
