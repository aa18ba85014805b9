#pragma once

#include "bridge/team_codec.hpp"

namespace fulbito {

/// The conversation as JSON lines (docs/team-protocol.md): one object per line, UTF-8, ended by "\n".
class LineCodec final : public TeamCodec {
 public:
  /// Longest line of a team [bytes], its end included.
  static constexpr std::size_t kMaxLine = std::size_t{1} << 20;

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
};

}  // namespace fulbito
