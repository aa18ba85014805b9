#include "bridge/outside/conversation.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/core/system/stop_request.hpp"

namespace fulbito {
namespace {

// Waits are cut into slices, so that they end soon after a user's signal.
constexpr double kSlice = 0.1;  // [s]

}  // namespace

Conversation::Conversation(const OutsideTeamSetup& setup, BoundedLog& log)
    : setup_(&setup), log_(&log), codec_(setup.codec()) {
  auto child = Child::launch(setup.child);
  if (child) {
    child_.emplace(std::move(*child));
  } else {
    failure_ = child.error().message;
    code_ = child.error().code;
  }
}

const Containment& Conversation::containment() const {
  static const Containment none;
  return child_ ? child_->containment() : none;
}

void Conversation::fail(std::string reason) {
  if (!failure_.empty()) return;
  // The way in which the program ended explains more than a missing answer.
  if (child_) {
    showErrors();
    const ChildEnd end = child_->end();
    if (end.machine) code_ = ErrorCode::kMachine;
    if (end.machine || reason.empty()) {
      reason = end.reason == kKilled ? "it no longer reads and writes" : end.reason;
    }
  }
  failure_ = std::move(reason);
  showErrors();
}

void Conversation::flush() {
  if (child_->send(out_)) return;
  // The messages that it sent before it ended may tell why.
  do {
    receive(0.0);
  } while (failure_.empty() && readMessage(0, TeamReply::Kind::kHello) == Read::kOther);
  fail("");
}

void Conversation::receive(double seconds) {
  // This keeps the capacity: messages are read from the front, and the rest moves there.
  in_.erase(0, std::exchange(read_, 0));
  if (child_->receive(in_, seconds) == Child::Received::kClosed && in_.empty()) fail("");
}

Conversation::Read Conversation::readMessage(std::uint64_t id, TeamReply::Kind kind) {
  const std::string_view waiting = std::string_view(in_).substr(read_);
  const auto length = codec_->firstMessage(waiting);
  if (!length) {
    fail(length.error().message);
    return Read::kMore;
  }
  if (*length == 0) return Read::kMore;
  read_ += *length;
  if (const auto read = codec_->read(waiting.substr(0, *length), reply_); !read) {
    fail(read.error().message);
    return Read::kMore;
  }
  if (reply_.id > id_ || reply_.id == 0) {
    fail(fmt::format("a reply to request {}, which was not sent", reply_.id));
    return Read::kMore;
  }
  if (reply_.id == id && reply_.kind == kind) return Read::kAwaited;
  if (reply_.id == id) {
    fail(fmt::format("a reply of another kind than request {}", id));
    return Read::kMore;
  }
  ++stale_;
  return Read::kOther;
}

TeamReply* Conversation::await(std::uint64_t id, TeamReply::Kind kind, double seconds) {
  const double end = now() + seconds;
  while (failure_.empty()) {
    const Read read = readMessage(id, kind);
    if (read == Read::kAwaited) return &reply_;
    if (read == Read::kOther && now() < end) continue;
    if (!failure_.empty()) break;
    const double left = end - now();
    if (left <= 0.0 && read == Read::kOther) break;
    const std::size_t before = in_.size() - read_;
    receive(std::clamp(left, 0.0, kSlice));
    const bool news = in_.size() > before;
    if (!news && (left <= 0.0 || stopRequested())) break;
  }
  return nullptr;
}

void Conversation::showErrors() {
  if (!child_) return;
  errors_ += child_->takeErrors();
  log_->addLines(errors_, !failure_.empty());
}

void Conversation::waitForEnd(double seconds) {
  if (!failure_.empty()) return;
  child_->closeInput();
  const double end = now() + seconds;
  while (failure_.empty() && now() < end) {
    read_ = in_.size();  // drops whatever the program still sends
    receive(std::clamp(end - now(), 0.0, kSlice));
  }
  showErrors();
}

}  // namespace fulbito
