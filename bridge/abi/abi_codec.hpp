#pragma once

#include <vector>

#include "bridge/abi/frames.hpp"
#include "bridge/team_codec.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// The conversation with the program `fulbito-team-host`, which runs a team of a shared library: the
/// structures of `fulbito/team.h` as bytes. `read` accepts any bytes.
class AbiCodec final : public TeamCodec {
 public:
  void hello(std::uint64_t id, const TeamHello& hello, std::string& out) override;
  void begin(std::uint64_t id, const MatchInfo& info, std::string& out) override;
  void decide(std::uint64_t id, const Observation& observation, std::string& out) override;
  void place(std::uint64_t id, const PlacementRequest& request, std::string& out) override;
  void exercise(std::uint64_t id, const Observation& observation, const Exercise& exercise,
                std::string& out) override;
  void stopped(const PlayStop& stop, std::string& out) override;
  void ready(const Observation& observation, std::string& out) override;
  void ended(const MatchEnd& end, std::string& out) override;
  Result<std::size_t> firstMessage(std::string_view received) const override;
  Result<void> read(std::string_view message, TeamReply& reply) override;

 private:
  bool readCommand(FrameReader& frame, const CommandBody& body, TeamCommand& command);
  bool readBody(FrameReader& frame, TeamReply& reply);

  /// observation of the last request; kept, as little of it changes from tick to tick
  fulbito_observation seen_{};
  std::vector<fulbito_drawing> drawings_;  ///< drawings of the last reply
};

}  // namespace fulbito
