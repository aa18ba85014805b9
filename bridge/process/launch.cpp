#include "bridge/process/launch.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "bridge/process/keeper_image.hpp"
#include "engine/core/system/shortage.hpp"
#include "engine/core/system/stop_request.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

// A keeper starts in milliseconds; the rest is a margin for machines that run hundreds of them.
constexpr int kStartMilliseconds = 30'000;
constexpr const char* kUsualPath = "/usr/local/bin:/usr/bin:/bin";

/// The error for everything that this program and the keeper do before the team begins.
tl::unexpected<Error> cannot(const std::string& what, int error) {
  return fail(ErrorCode::kMachine, fmt::format("cannot {}: {}", what, std::strerror(error)));
}

tl::unexpected<Error> cannotRun(const std::string& program, const std::string& why) {
  return fail(ErrorCode::kUsage, fmt::format("cannot run '{}': {}", program, why));
}

std::string variable(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

std::string absolute(const std::string& path) {
  std::error_code wrong;
  const fs::path whole = fs::absolute(path, wrong);
  return wrong ? path : whole.lexically_normal().string();
}

/// Calls `visit` with the parts of a search path, without relative ones, since the team runs in another
/// folder.
template <typename Visit>
void forFolders(const std::string& path, Visit visit) {
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find(':', at), path.size());
    if (end > at && path[at] == '/') visit(path.substr(at, end - at));
    at = end + 1;
  }
}

std::string absoluteFolders(const std::string& path) {
  std::string kept;
  forFolders(path, [&](const std::string& folder) { kept += (kept.empty() ? "" : ":") + folder; });
  return kept;
}

/// The type of the file with this name. Errors: kMachine if the query fails for another reason than the name.
Result<fs::file_type> kindOf(const std::string& file) {
  std::error_code wrong;
  const fs::file_type kind = fs::status(file, wrong).type();
  if (kind == fs::file_type::none && (isShortage(wrong.value()) || wrong.value() == EIO)) {
    return cannot(fmt::format("look at '{}'", file), wrong.value());
  }
  return kind;
}

bool isProgram(const std::string& file) {
  std::error_code wrong;
  return fs::is_regular_file(file, wrong) && ::access(file.c_str(), X_OK) == 0;
}

Result<std::string> findProgram(const std::string& name, const std::string& path) {
  if (name.empty()) return cannotRun(name, "the command is empty");
  if (name.find('/') == std::string::npos) {
    std::string found;
    forFolders(path, [&](const std::string& folder) {
      if (found.empty() && isProgram(folder + "/" + name)) found = folder + "/" + name;
    });
    if (found.empty()) return cannotRun(name, "no such program in PATH");
    return found;
  }
  const auto kind = kindOf(name);
  if (!kind) return tl::unexpected<Error>(kind.error());
  if (*kind == fs::file_type::none || *kind == fs::file_type::not_found) {
    return cannotRun(name, "no such file");
  }
  if (*kind != fs::file_type::regular) return cannotRun(name, "not a file");
  if (::access(name.c_str(), X_OK) != 0) {
    if (errno != EACCES) return cannot(fmt::format("look at '{}'", name), errno);
    return cannotRun(name, "it is not executable (chmod +x)");
  }
  return absolute(name);
}

Result<void> check(const ChildOptions& options) {
  if (options.command.empty()) return cannotRun("", "the command is empty");
  for (const std::string& word : options.command) {
    if (word.find('\0') != std::string::npos)
      return cannotRun(options.command[0], "a word contains a zero byte");
  }
  if (!options.own_folder.empty()) {
    const auto kind = kindOf(options.own_folder);
    if (!kind) return tl::unexpected<Error>(kind.error());
    if (*kind != fs::file_type::directory) {
      return fail(ErrorCode::kUsage, fmt::format("'{}' is not a folder", options.own_folder));
    }
  }
  const ChildLimits& limits = options.limits;
  if (limits.open_files < 8 || limits.processes < 1 || limits.cpu_seconds < 1 || limits.memory == 0 ||
      limits.folder_size == 0) {
    return fail(ErrorCode::kUsage, "limits of a child: at least 8 open files, 1 process, 1 s, 1 byte");
  }
  return {};
}

/// The word list behind the page; each word ends with a zero.
struct Words {
  std::string text;
  void add(const std::string& word) { text.append(word.c_str(), word.size() + 1); }
};

Words wordsOf(const ChildOptions& options, const std::string& program, const std::string& path) {
  Words words;
  words.add(program);
  words.add(options.own_folder.empty() ? "" : absolute(options.own_folder));
  words.add(absolute(variable("TMPDIR", "/tmp")));
  words.add(path);
  words.add(variable("LANG", "C.UTF-8"));
  words.add(variable("HOME", ""));
  for (const std::string& folder : options.readable) words.add(absolute(folder));
  for (const std::string& argument : options.command) words.add(argument);
  return words;
}

void fill(keeper::Page& page, const ChildOptions& options, const Words& words) {
  const ChildLimits& limits = options.limits;
  page.memory = limits.memory;
  page.file_size = limits.file_size;
  page.folder_size = limits.folder_size;
  page.open_files = limits.open_files;
  page.processes = limits.processes;
  page.cpu_seconds = limits.cpu_seconds;
  page.launcher = ::getpid();
  page.readable = static_cast<std::uint32_t>(options.readable.size());
  page.arguments = static_cast<std::uint32_t>(options.command.size());
  page.text_size = static_cast<std::uint32_t>(words.text.size());
  page.sockets = options.sockets;
  page.network = limits.network;
  page.program_alone = options.program_alone;
  page.all_layers = options.sandbox_required;
  std::memcpy(&page + 1, words.text.data(), words.text.size());
}

/// Creates a file in memory. Like all descriptors here, its number is above those that the keeper begins
/// with.
Descriptor memoryFile(const char* name) {
  const Descriptor low(::memfd_create(name, MFD_CLOEXEC));
  return Descriptor(low.isOpen() ? ::fcntl(low.number(), F_DUPFD_CLOEXEC, keeper::kStartDescriptor + 1) : -1);
}

bool writeAll(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t wrote = ::write(file.number(), bytes.data(), bytes.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return true;
}

struct Pipe {
  Descriptor read;
  Descriptor write;

  /// @param sockets  of this kind, which also carry descriptors
  bool open(bool sockets = false) {
    std::array<int, 2> ends{-1, -1};
    const int wrong = sockets ? ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data())
                              : ::pipe2(ends.data(), O_CLOEXEC);
    if (wrong != 0) return false;
    const Descriptor low_read(ends[0]), low_write(ends[1]);
    read = Descriptor(::fcntl(ends[0], F_DUPFD_CLOEXEC, keeper::kStartDescriptor + 1));
    write = Descriptor(::fcntl(ends[1], F_DUPFD_CLOEXEC, keeper::kStartDescriptor + 1));
    return read.isOpen() && write.isOpen();
  }
};

bool neverBlock(const Descriptor& end) { return ::fcntl(end.number(), F_SETFL, O_NONBLOCK) == 0; }

/// The descriptors that the keeper begins with, in its order.
using KeeperDescriptors = std::array<int, 5>;

/// Starts the keeper by posix_spawn, which copies no memory of this process and is safe with other threads.
/// The keeper closes all other descriptors of this process. @return 0, or an errno
int spawnKeeper(const Descriptor& image, const KeeperDescriptors& descriptors, pid_t& keeper) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  for (std::size_t k = 0; k < descriptors.size(); ++k) {
    posix_spawn_file_actions_adddup2(&actions, descriptors[k], static_cast<int>(k));
  }
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
  std::string name = "fulbito-keeper";
  const std::string file = fmt::format("/proc/self/fd/{}", image.number());
  std::array<char*, 2> argv{name.data(), nullptr};
  std::array<char*, 1> environment{nullptr};
  const int wrong =
      ::posix_spawn(&keeper, file.c_str(), &actions, &attributes, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return wrong;
}

/// Reads a message of the keeper with the sockets in it. @return 1; 0 if the other end is closed; -1 with
/// errno
ssize_t receiveSockets(const Descriptor& end, std::vector<Descriptor>& sockets) {
  char byte = 0;
  iovec text{&byte, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * keeper::kMostSockets)> room{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = room.data();
  message.msg_controllen = room.size();
  const ssize_t got = ::recvmsg(end.number(), &message, MSG_CMSG_CLOEXEC);
  if (got <= 0) return got;
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    for (std::size_t at = CMSG_LEN(0); at + sizeof(int) <= header->cmsg_len; at += sizeof(int)) {
      int socket = -1;
      std::memcpy(&socket, reinterpret_cast<const char*>(header) + at, sizeof socket);
      sockets.emplace_back(socket);
    }
  }
  return got;
}

/// Waits until the other end is closed, and takes the sockets that come before. @return 0, or an errno:
/// ETIMEDOUT; EINTR if the program is to stop
int waitForClose(const Descriptor& end, std::vector<Descriptor>& sockets) {
  pollfd wait{end.number(), POLLIN, 0};
  for (;;) {
    const int ready = ::poll(&wait, 1, kStartMilliseconds);
    if (ready == 0) return ETIMEDOUT;
    const ssize_t got = ready < 0 ? -1 : receiveSockets(end, sockets);
    // A keeper that ends early can leave a reset connection.
    if (got == 0 || (got < 0 && errno == ECONNRESET)) return 0;
    if (got < 0 && (errno != EINTR || stopRequested())) return errno;
  }
}

std::string lines(std::string_view text, std::string_view between) {
  std::string joined;
  for (const char c : text.substr(0, text.empty() ? 0 : text.size() - 1)) {
    if (c == '\n') {
      joined += between;
    } else {
      joined += c;
    }
  }
  return joined;
}

Error whyNot(const keeper::Page& page, const std::string& program) {
  if (page.lacks_layer) {
    return {ErrorCode::kUsage,
            fmt::format("the sandbox lacks what is required: {}", lines(page.missing.view(), "; "))};
  }
  if (page.error == 0) {
    return {ErrorCode::kMachine, fmt::format("cannot run '{}': its keeper ended", program)};
  }
  const std::string step(page.step.view());
  if (step != keeper::kRunProgram) {
    return cannot(fmt::format("run '{}': cannot {}", program, step), page.error).value();
  }
  if (isShortage(page.error) || page.error == EIO) {
    return cannot(fmt::format("run '{}'", program), page.error).value();
  }
  switch (page.error) {
    case ENOEXEC:
      return cannotRun(program, "it is neither a program nor a script that begins with #!").value();
    case ENOENT:
      return cannotRun(program, "it needs an interpreter that does not exist").value();
    case EACCES:
      return cannotRun(program,
                       "it, or its interpreter, is not executable for other users, or lies in a folder that "
                       "teams may not read")
          .value();
    default:
      return cannotRun(program, std::strerror(page.error)).value();
  }
}

}  // namespace

SharedPage::SharedPage(SharedPage&& other) noexcept : page_(other.page_), size_(other.size_) {
  other.page_ = nullptr;
}

SharedPage& SharedPage::operator=(SharedPage&& other) noexcept {
  std::swap(page_, other.page_);
  std::swap(size_, other.size_);
  return *this;
}

SharedPage::~SharedPage() {
  if (page_ != nullptr) ::munmap(page_, size_);
}

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

void removeLeftovers(const keeper::Page& page) {
  std::error_code ignored;
  fs::remove_all(std::string(page.private_folder.view()), ignored);
  for (const std::string& folder : linesOf(page.groups.view())) {
    // The members have been killed and end at any moment.
    for (int attempt = 0; ::rmdir(folder.c_str()) != 0 && errno == EBUSY && attempt < 1000; ++attempt)
      ::usleep(1000);
  }
}

int waitForKeeper(pid_t keeper) {
  int status = 0;
  while (::waitpid(keeper, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

Result<Launched> launchTeam(const ChildOptions& options) {
  if (Result<void> good = check(options); !good) return tl::unexpected<Error>(good.error());
  const std::string path = absoluteFolders(variable("PATH", kUsualPath));
  const Result<std::string> program = findProgram(options.command[0], path);
  if (!program) return tl::unexpected<Error>(program.error());

  const Words words = wordsOf(options, *program, path);
  const std::size_t size = sizeof(keeper::Page) + words.text.size();
  const Descriptor page_file = memoryFile("fulbito-page");
  const Descriptor image = memoryFile("fulbito-keeper");
  if (!page_file.isOpen() || !image.isOpen() ||
      ::ftruncate(page_file.number(), static_cast<off_t>(size)) != 0 || !writeAll(image, keeperImage())) {
    return cannot("make a file in memory", errno);
  }
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, page_file.number(), 0);
  if (memory == MAP_FAILED) return cannot("share memory", errno);
  Launched launched{SharedPage(new (memory) keeper::Page, size), -1, {}, {}, {}, {}};
  fill(*static_cast<keeper::Page*>(memory), options, words);

  Pipe in, out, errors, start;
  if (!in.open() || !out.open() || !errors.open() || !start.open(true) || !neverBlock(in.write) ||
      !neverBlock(out.read) || !neverBlock(errors.read)) {
    return cannot("open a pipe", errno);
  }
  const int wrong = spawnKeeper(
      image,
      {in.read.number(), out.write.number(), errors.write.number(), page_file.number(), start.write.number()},
      launched.keeper);
  if (wrong != 0) return cannot("start the keeper of a team", wrong);
  for (Descriptor* end : {&in.read, &out.write, &errors.write, &start.write}) end->close();
  const int late = waitForClose(start.read, launched.sockets);
  if (late != 0 || launched.page->error != 0 || !launched.page->begins) {
    ::kill(launched.keeper, late == ETIMEDOUT ? SIGKILL : SIGTERM);
    waitForKeeper(launched.keeper);
    removeLeftovers(*launched.page);
    if (late == EINTR) return fail(ErrorCode::kInterrupted, "interrupted");
    if (late != 0) return cannot("start the keeper of a team", late);
    return tl::unexpected<Error>(whyNot(*static_cast<keeper::Page*>(memory), *program));
  }
  launched.in = std::move(in.write);
  launched.out = std::move(out.read);
  launched.errors = std::move(errors.read);
  return launched;
}

}  // namespace fulbito
