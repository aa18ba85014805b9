#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "fulbito/detail/values.hpp"
#include "fulbito/team.h"

/// The messages between the simulator and a process that hosts a team of a shared library: a header, then a
/// structure of `fulbito/team.h`, then texts or drawings. Both run on the same machine, so structures are
/// sent as their bytes in memory.
namespace fulbito {

/// The kinds of messages. A reply has the request's kind plus `kReplyOffset`.
enum class FrameKind : std::uint16_t {
  kHello = 1,     ///< HelloBody and settings; reply: WelcomeBody
  kBegin = 2,     ///< fulbito_match_info and the rules' text; reply: NamesBody and names of navigators
  kDecide = 3,    ///< fulbito_observation; reply: CommandBody and drawings
  kPlace = 4,     ///< fulbito_placement_request; reply: fulbito_placement
  kExercise = 5,  ///< ExerciseBody; reply: ExerciseReplyBody and drawings
  kStopped = 6,   ///< fulbito_stop; no reply
  kReady = 7,     ///< fulbito_observation; no reply
  kEnded = 8,     ///< fulbito_end; no reply
  kFailed = 9     ///< from the host, before it ends: the reason, a text
};
/// difference between the kinds of a request and of its reply
inline constexpr std::uint16_t kReplyOffset = 0x80;
inline constexpr std::size_t kLargestFrame = 1u << 18;  ///< [bytes]

/// The beginning of each message.
struct FrameHeader {
  std::uint32_t size;     ///< [bytes] size of the message, this header included
  std::uint16_t kind;     ///< a FrameKind, for replies plus `kReplyOffset`
  std::uint16_t version;  ///< FULBITO_ABI
  std::uint64_t id;       ///< number of the request; 0 for notices
};
static_assert(sizeof(FrameHeader) == 16);

/// Content of the first message; `settings` pairs of texts follow, each with its zero byte: name, value.
struct HelloBody {
  char simulator[FULBITO_NAME_SIZE];  ///< name and version
  std::uint32_t settings;             ///< number of pairs
  std::uint32_t reserved;             ///< 0
};
static_assert(sizeof(HelloBody) == 72);

/// Reply to the first message.
struct WelcomeBody {
  char name[FULBITO_NAME_SIZE];     ///< name of the team
  char version[FULBITO_NAME_SIZE];  ///< version of the team
};
static_assert(sizeof(WelcomeBody) == 128);

/// Names of the team's navigators: `count` texts follow, each with its zero byte.
struct NamesBody {
  std::uint32_t count;     ///< number of texts
  std::uint32_t reserved;  ///< 0
};
static_assert(sizeof(NamesBody) == 8);

/// A decision; `drawings` drawings follow.
struct CommandBody {
  fulbito_robot_command robots[FULBITO_MAX_ROBOTS];  ///< by number
  std::uint32_t drawings;                            ///< number of drawings
  std::uint32_t reserved;                            ///< 0
};
static_assert(sizeof(CommandBody) == 976);

/// One tick of an exercise.
struct ExerciseBody {
  fulbito_observation seen;  ///< observation of the team
  fulbito_exercise task;     ///< task of the exercise
};
static_assert(sizeof(ExerciseBody) == sizeof(fulbito_observation) + sizeof(fulbito_exercise));

/// The reply to an exercise; the drawings of `command` follow.
struct ExerciseReplyBody {
  std::uint32_t has_skill;  ///< 0: the team lacks the skill
  std::uint32_t reserved;   ///< 0
  fulbito_vec2 answer;      ///< [m]
  CommandBody command;      ///< command of its robot
};
static_assert(sizeof(ExerciseReplyBody) == 1000);

/// The text of a failure from a team, made safe for a terminal and cut to about 2000 bytes.
std::string failureText(std::string_view reason);

/// Appends a structure as bytes.
template <typename T>
void appendBytes(const T& value, std::string& out) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Appends a header without its size. @return start of the message in `out`, for `endFrame`
inline std::size_t beginFrame(std::uint16_t kind, std::uint64_t id, std::string& out) {
  const std::size_t begin = out.size();
  appendBytes(FrameHeader{0, kind, FULBITO_ABI, id}, out);
  return begin;
}

/// Writes the size of the message that begins at `begin` and ends at the end of `out`.
inline void endFrame(std::size_t begin, std::string& out) {
  const auto size = static_cast<std::uint32_t>(out.size() - begin);
  std::memcpy(out.data() + begin, &size, sizeof size);
}

/// Length of the first whole message in `received`; 0: more bytes are needed. Errors: kBadInput if its header
/// is wrong.
Result<std::size_t> frameLength(std::string_view received);

/// Reads a whole message from its start. Every read checks the number of remaining bytes.
class FrameReader {
 public:
  /// Errors: kBadInput if `message` is not one whole message.
  static Result<FrameReader> open(std::string_view message);

  const FrameHeader& header() const { return header_; }
  /// Copies the next structure. @return false if the message is too short
  template <typename T>
  bool take(T& value) {
    if (rest_.size() < sizeof value) return false;
    rest_.copy(reinterpret_cast<char*>(&value), sizeof value);
    rest_.remove_prefix(sizeof value);
    return true;
  }
  /// Takes the next text with its zero byte. @return false if there is none
  bool takeText(std::string_view& text);
  /// The bytes that have not been read.
  std::string_view rest() const { return rest_; }

 private:
  FrameHeader header_{};
  std::string_view rest_;
};

}  // namespace fulbito
