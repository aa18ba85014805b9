#include "bridge/process/keeper/network.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <net/if.h>
#include <net/route.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fulbito::keeper {
namespace {

constexpr const char* kLoopback = "lo";
constexpr std::uint32_t kGroups = 0xe0000000, kGroupsMask = 0xf0000000;  // 224.0.0.0/4

int newSocket() { return ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0); }

sockaddr addressOf(std::uint32_t host) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(host);
  sockaddr result{};
  std::memcpy(&result, &address, sizeof result);
  return result;
}

/// Clients join groups without naming an interface, so there must be a route for all groups.
bool openLoopback(int socket) {
  ifreq interface{};
  std::strncpy(interface.ifr_name, kLoopback, IFNAMSIZ - 1);
  if (::ioctl(socket, SIOCGIFFLAGS, &interface) != 0) return false;
  interface.ifr_flags = static_cast<short>(interface.ifr_flags | IFF_UP | IFF_MULTICAST);
  if (::ioctl(socket, SIOCSIFFLAGS, &interface) != 0) return false;
  std::string device = kLoopback;
  rtentry route{};
  route.rt_dst = addressOf(kGroups);
  route.rt_genmask = addressOf(kGroupsMask);
  route.rt_flags = RTF_UP;
  route.rt_dev = device.data();
  return ::ioctl(socket, SIOCADDRT, &route) == 0;
}

bool sendSockets(const int* sockets, int count) {
  char byte = 's';
  iovec text{&byte, 1};
  alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int) * kMostSockets)] = {};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = room;
  const std::size_t size = sizeof(int) * static_cast<std::size_t>(count);
  message.msg_controllen = CMSG_SPACE(size);
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(size);
  std::memcpy(CMSG_DATA(header), sockets, size);
  return ::sendmsg(kStartDescriptor, &message, MSG_NOSIGNAL) == 1;
}

}  // namespace

void openNetwork(Order& order) {
  const int count = std::min(order.page->sockets, kMostSockets);
  int sockets[kMostSockets];
  for (int i = 0; i < count; ++i) {
    sockets[i] = newSocket();
    if (sockets[i] < 0) giveUp(order, "make a socket", errno);
  }
  if (!openLoopback(sockets[0])) giveUp(order, "open the loopback of its network", errno);
  if (!sendSockets(sockets, count)) giveUp(order, "pass sockets on", errno);
  for (int i = 0; i < count; ++i) ::close(sockets[i]);
  reached(order, "network-namespace");
}

}  // namespace fulbito::keeper
