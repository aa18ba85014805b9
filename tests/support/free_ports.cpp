#include "tests/support/free_ports.hpp"

#include <cstdint>
#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

#include "bridge/wire/wire_settings.hpp"

namespace fulbito::test {
namespace {

constexpr int kFirst = 11'000, kStep = 20, kCount = 440;
static_assert(kFirst + kStep * kCount < wire::kDefaultPortBase + wire::kCommandOffset);
static_assert(kFirst + kStep * kCount + wire::kBlueOffset < 32'768,
              "Linux's first port for whoever names none");

/// A socket at a port of the loopback interface, or -1.
int bound(int type, int port) {
  const int number = ::socket(AF_INET, type | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(number, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return number;
  ::close(number);
  return -1;
}

bool isFree(int port) {
  const int number = bound(SOCK_DGRAM, port);
  if (number >= 0) ::close(number);
  return number >= 0;
}

bool areFree(int base) {
  for (const int offset : {wire::kVisionOffset, wire::kRefereeOffset, wire::kPlacementOffset,
                           wire::kCommandOffset, wire::kYellowOffset, wire::kBlueOffset}) {
    if (!isFree(base + offset)) return false;
  }
  return true;
}

}  // namespace

int freePortBase() {
  // A TCP socket, which nothing here needs, marks the ports as taken: the system lets go of it when the
  // process ends.
  for (int tried = 0; tried < kCount; ++tried) {
    const int base = kFirst + kStep * ((::getpid() + tried) % kCount);
    const int mark = bound(SOCK_STREAM, base);
    if (mark < 0) continue;
    if (areFree(base)) return base;
    ::close(mark);
  }
  throw std::runtime_error("no free ports for a test");
}

}  // namespace fulbito::test
