#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "bridge/lines/line_codec.hpp"
#include "fulbito/team_program.hpp"

/// Feeds anything to both ends of the line protocol: the simulator's reader of replies, and a C++ program's
/// reader of requests. The first byte says to which.
namespace fulbito {
namespace {

[[noreturn]] void flaw(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

/// By another reader, which evaluates all numbers: it refuses those that no double holds, also where nobody
/// reads them, and does not say what it thinks of the rest.
bool isJson(std::string_view text) {
  try {
    (void)nlohmann::json::parse(text);
    return true;
  } catch (const nlohmann::json::out_of_range&) {
    return true;
  } catch (const nlohmann::json::parse_error&) {
    return false;
  }
}

/// As the simulator takes bytes from a pipe: line by line.
void readReplies(std::string_view bytes) {
  LineCodec codec;
  TeamReply reply;
  for (;;) {
    const auto length = codec.firstMessage(bytes);
    if (!length || *length == 0) return;
    if (*length > bytes.size()) flaw("a message is longer than what was received");
    const std::string_view line = bytes.substr(0, *length);
    const auto read = codec.read(line, reply);
    if (read && !isJson(line)) flaw("a reply is taken that is not JSON");
    if (!read && read.error().message.empty()) flaw("a reply is refused without a reason");
    bytes.remove_prefix(*length);
  }
}

class Still final : public team::Team {
 public:
  Still() : Team("still") {}
  team::Commands decide(const team::Observation&) override { return {}; }
};

void readRequests(std::string_view bytes) {
  team::program::Conversation conversation(std::make_unique<Still>());
  std::string answer;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    answer.clear();
    try {
      conversation.take(bytes.substr(0, end), answer);
    } catch (const std::runtime_error&) {
      return;  // the program ends with a message
    }
    if (!answer.empty() && !nlohmann::json::accept(answer)) flaw("an answer is not JSON");
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
}

}  // namespace
}  // namespace fulbito

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  data[0] % 2 == 0 ? fulbito::readReplies(bytes) : fulbito::readRequests(bytes);
  return 0;
}
