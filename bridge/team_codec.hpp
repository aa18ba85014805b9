#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Version of the conversation with a team outside the program, whatever its encoding.
inline constexpr int kTeamProtocol = 1;

/// First message of the conversation.
struct TeamHello {
  std::string simulator;          ///< name and version of the simulator
  std::vector<Setting> settings;  ///< the team's settings from its specification
};

/// A team's answer to `TeamHello`.
struct TeamWelcome {
  std::string name;     ///< the team's name
  std::string version;  ///< the team's version; may be empty
};

/// A team's answer to a request. `kind` selects the member that counts.
struct TeamReply {
  /// The requests that a reply answers.
  enum class Kind : std::uint8_t { kHello, kBegin, kDecide, kPlace, kExercise };
  Kind kind = Kind::kDecide;              ///< the kind of request that this answers
  std::uint64_t id = 0;                   ///< the request's number
  TeamWelcome welcome;                    ///< for kHello
  std::vector<std::string> navigators;    ///< for kBegin: specifications that `GoTo::navigator` indexes
  TeamCommand command;                    ///< for kDecide
  std::optional<TeamProposal> proposal;   ///< for kPlace; empty: no wishes
  std::optional<ExerciseReply> exercise;  ///< for kExercise; empty: the team lacks the skill
};

/// One encoding of the conversation with a team outside the program: JSON lines or the structures of the C
/// interface. Requests carry a number, which the reply repeats; notices get no reply. Writers append to `out`
/// and keep its capacity, so that a warm conversation allocates nothing.
class TeamCodec {
 public:
  virtual ~TeamCodec() = default;
  /// @{ Requests.
  virtual void hello(std::uint64_t id, const TeamHello& hello, std::string& out) = 0;
  virtual void begin(std::uint64_t id, const MatchInfo& info, std::string& out) = 0;
  virtual void decide(std::uint64_t id, const Observation& observation, std::string& out) = 0;
  virtual void place(std::uint64_t id, const PlacementRequest& request, std::string& out) = 0;
  virtual void exercise(std::uint64_t id, const Observation& observation, const Exercise& exercise,
                        std::string& out) = 0;
  /// @}
  /// @{ Notices.
  virtual void stopped(const PlayStop& stop, std::string& out) = 0;
  virtual void ready(const Observation& observation, std::string& out) = 0;
  virtual void ended(const MatchEnd& end, std::string& out) = 0;
  /// @}
  /// Length of the first whole message in `received`; 0: more bytes are needed. Errors: kBadInput if no
  /// continuation can become a message, such as a line beyond the limit.
  virtual Result<std::size_t> firstMessage(std::string_view received) const = 0;
  /// Reads one whole message into `reply` and reuses its memory. Errors: kBadInput with the problem and its
  /// place.
  virtual Result<void> read(std::string_view message, TeamReply& reply) = 0;
};

}  // namespace fulbito
