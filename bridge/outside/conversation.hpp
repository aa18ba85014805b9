#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "bridge/outside/outside_team.hpp"

namespace fulbito {

/// The conversation with one run of a team's program. It is over as soon as `failure` is not empty.
class Conversation {
 public:
  /// Starts the program. If that fails, the conversation is over at once. `log` takes standard error.
  Conversation(const OutsideTeamSetup& setup, BoundedLog& log);

  /// Writes one message with the codec and sends it.
  /// @param write  called with the codec and the buffer to append to
  template <typename Write>
  void send(const Write& write) {
    if (!failure_.empty()) return;
    out_.clear();
    write(*codec_, out_);
    flush();
  }
  /// A new number for the next request.
  std::uint64_t next() { return ++id_; }
  /// Waits at most `seconds` for the reply to request `id` of that kind; infinite: until it comes. Replies to
  /// earlier requests are ignored and counted. Null: none has come, or the conversation is over.
  TeamReply* await(std::uint64_t id, TeamReply::Kind kind, double seconds);
  /// Passes standard error to the log, line by line.
  void showErrors();
  /// Ends the conversation: closes the program's standard input, and waits at most `seconds` for it to end.
  void waitForEnd(double seconds);
  /// Ends the conversation with a reason of the caller.
  void fail(std::string reason);

  /// Why the conversation is over; empty while it goes on.
  const std::string& failure() const { return failure_; }
  /// The kind of the failure: kMachine or kInterrupted if it is no fault of the program; otherwise the code
  /// of an error of the caller or of the program.
  ErrorCode code() const { return code_; }
  /// Ignored replies so far.
  std::int64_t stale() const { return stale_; }
  /// The containment of the program; empty if it did not start.
  const Containment& containment() const;

 private:
  enum class Read : std::uint8_t { kMore, kOther, kAwaited };
  void flush();
  void receive(double seconds);
  Read readMessage(std::uint64_t id, TeamReply::Kind kind);
  double now() const { return static_cast<double>(setup_->clock()) * 1e-9; }

  const OutsideTeamSetup* setup_;
  BoundedLog* log_;
  std::unique_ptr<TeamCodec> codec_;
  std::optional<Child> child_;
  std::string out_, in_, errors_;
  std::size_t read_ = 0;  // bytes of `in_` that were read
  TeamReply reply_;
  std::uint64_t id_ = 0;
  std::int64_t stale_ = 0;
  std::string failure_;
  ErrorCode code_ = ErrorCode::kUsage;
};

}  // namespace fulbito
