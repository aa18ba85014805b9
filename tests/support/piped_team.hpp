#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bridge/team_codec.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::test {

/// A child program with pipes to its standard input and output, without any containment. Throws
/// std::runtime_error where something fails.
class PipedProgram {
 public:
  explicit PipedProgram(const std::vector<std::string>& command);
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;
  /// Closes its input and waits for it.
  ~PipedProgram();

  void send(std::string_view text) const;
  /// Waits for output and appends it. @return false at its end
  bool receive(std::string& into) const;
  /// Closes its input and waits. @return its exit code; 128 and the signal if one ended it
  int finish();

 private:
  int in_ = -1, out_ = -1;
  int child_ = -1;
};

/// A team in a child program, over any codec. Each request waits for its reply; whatever is wrong with one is
/// thrown as std::runtime_error.
class PipedTeam final : public Strategy {
 public:
  PipedTeam(TeamCodec& codec, const std::vector<std::string>& command) : codec_(&codec), program_(command) {}

  /// The handshake; the match does not know of it.
  TeamWelcome hello(const TeamHello& hello);
  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& seen) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  void stopped(const PlayStop& stop) override;
  void ready(const Observation& seen) override;
  void ended(const MatchEnd& end) override;
  std::optional<ExerciseReply> exercise(const Observation& seen, const Exercise& exercise) override;

 private:
  const TeamReply& ask(TeamReply::Kind kind);
  void tell();

  TeamCodec* codec_;
  PipedProgram program_;
  std::vector<NavigatorChoice> navigators_;
  std::string out_, received_;
  std::uint64_t id_ = 0;
  TeamReply reply_;
};

}  // namespace fulbito::test
