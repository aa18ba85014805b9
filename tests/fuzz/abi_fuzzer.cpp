#include <cstdlib>
#include <cstring>

#include "bridge/abi/abi_codec.hpp"
#include "bridge/abi/team_host.hpp"
#include "navigation/library/plugin_parameters.hpp"

/// Feeds anything to what reads messages and tables of shared libraries. The first byte says to which part.
namespace fulbito {
namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

/// Replies, one after the other, as the match reads them.
void feedCodec(std::string_view bytes) {
  AbiCodec codec;
  TeamReply reply;
  for (;;) {
    const auto length = codec.firstMessage(bytes);
    if (!length || *length == 0) return;
    demand(*length <= bytes.size());
    if (codec.read(bytes.substr(0, *length), reply)) {
      demand(reply.command.drawings.size() <= kMostDrawings);
      for (const DebugDrawing& drawing : reply.command.drawings)
        demand(drawing.text.size() <= FULBITO_NAME_SIZE);
    }
    bytes.remove_prefix(*length);
  }
}

/// A message whose header is right, so that the rest is reached.
void feedBody(std::string_view bytes) {
  if (bytes.empty() || bytes.size() > kLargestFrame - sizeof(FrameHeader)) return;
  std::string message;
  beginFrame(static_cast<std::uint16_t>(kReplyOffset + bytes[0] % 10), 7, message);
  message.append(bytes.substr(1));
  endFrame(0, message);
  feedCodec(message);
}

/// Requests to the host of a team, after a proper start.
void feedHost(std::string_view bytes) {
  static const auto library = TeamLibrary::open(FULBITO_TEST_LIBRARIES "/plain_c.so");
  demand(library.has_value());
  TeamHost host(*library, {}, [](std::string_view) {});
  AbiCodec codec;
  std::string request, reply;
  codec.hello(1, {}, request);
  demand(host.answer(request, reply).has_value());
  request.clear();
  codec.begin(2, {}, request);
  demand(host.answer(request, reply).has_value());
  reply.clear();
  if (host.answer(bytes, reply) && !reply.empty()) feedCodec(reply);
}

/// A table of parameters whose numbers and texts come from the bytes, and a setting for it.
void feedParameters(std::string_view bytes) {
  struct Fixed {
    std::uint32_t type, choices;
    double by_default, minimum, maximum;
    char name[8], value[8];
  } fixed{};
  if (bytes.size() < sizeof fixed) return;
  std::memcpy(&fixed, bytes.data(), sizeof fixed);
  fixed.name[7] = fixed.value[7] = '\0';
  const char* const choices[] = {fixed.name, fixed.value, nullptr};
  const fulbito_parameter table{fixed.name, nullptr,          fixed.value,   choices,      fixed.choices % 4,
                                fixed.type, fixed.by_default, fixed.minimum, fixed.maximum};
  const auto specs = pluginParameters(&table, 1, "fuzz");
  if (!specs) return;
  const auto values = pluginValues(*specs, {{specs->front().name, fixed.value}}, "fuzz");
  if (!values) return;
  demand(values->front() >= specs->front().minimum && values->front() <= specs->front().maximum);
}

void feed(unsigned part, std::string_view bytes) {
  switch (part % 4) {
    case 0:
      return feedCodec(bytes);
    case 1:
      return feedBody(bytes);
    case 2:
      return feedHost(bytes);
    default:
      return feedParameters(bytes);
  }
}

}  // namespace
}  // namespace fulbito

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  fulbito::feed(data[0], {reinterpret_cast<const char*>(data) + 1, size - 1});
  return 0;
}
