#include "bridge/process/keeper/file_rules.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>

#include "bridge/process/keeper/files.hpp"
#include "engine/core/system/shortage.hpp"

namespace fulbito::keeper {
namespace {

// As in <linux/landlock.h>, whose older versions lack the newer rights. The kernel's documentation,
// userspace-api/landlock, lists the rights of each version of the interface.
struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scopes = 0;
};
struct __attribute__((packed)) PathRule {
  std::uint64_t allowed = 0;
  std::int32_t folder = -1;
};
constexpr int kPathRule = 1;
constexpr unsigned kAskVersion = 1;

constexpr std::uint64_t kExecute = 1U << 0;
constexpr std::uint64_t kWriteFile = 1U << 1;
constexpr std::uint64_t kReadFile = 1U << 2;
constexpr std::uint64_t kReadFolder = 1U << 3;
constexpr std::uint64_t kMakeCharacterDevice = 1U << 6;
constexpr std::uint64_t kMakeBlockDevice = 1U << 11;
constexpr std::uint64_t kVersion1 = (1U << 13) - 1;
constexpr std::uint64_t kRefer = 1U << 13;        // version 2
constexpr std::uint64_t kTruncate = 1U << 14;     // version 3
constexpr std::uint64_t kDeviceCalls = 1U << 15;  // version 5
constexpr std::uint64_t kTcp = 3;                 // bind and connect, version 4
constexpr std::uint64_t kScopes = 3;              // abstract sockets and signals, version 6

constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate | kDeviceCalls;
constexpr std::uint64_t kReading = kExecute | kReadFile | kReadFolder;

// Programs, libraries and the files that they read when they start. From /etc, only files without secrets.
constexpr const char* kSystem[] = {"/usr",
                                   "/bin",
                                   "/sbin",
                                   "/lib",
                                   "/lib32",
                                   "/lib64",
                                   "/libx32",
                                   "/opt",
                                   "/nix/store",
                                   "/gnu/store",
                                   "/proc",
                                   "/sys/devices/system",
                                   "/sys/fs/cgroup",
                                   "/sys/kernel/mm",
                                   "/etc/alternatives",
                                   "/etc/ca-certificates",
                                   "/etc/crypto-policies",
                                   "/etc/fonts",
                                   "/etc/gai.conf",
                                   "/etc/group",
                                   "/etc/host.conf",
                                   "/etc/hosts",
                                   "/etc/inputrc",
                                   "/etc/java",
                                   "/etc/ld.so.cache",
                                   "/etc/ld.so.conf",
                                   "/etc/ld.so.conf.d",
                                   "/etc/ld.so.preload",
                                   "/etc/locale.alias",
                                   "/etc/localtime",
                                   "/etc/mime.types",
                                   "/etc/nsswitch.conf",
                                   "/etc/os-release",
                                   "/etc/passwd",
                                   "/etc/pki/tls/certs",
                                   "/etc/profile",
                                   "/etc/protocols",
                                   "/etc/resolv.conf",
                                   "/etc/services",
                                   "/etc/ssl/certs",
                                   "/etc/ssl/openssl.cnf",
                                   "/etc/timezone",
                                   "/dev/random",
                                   "/dev/urandom"};
constexpr const char* kDevices[] = {"/dev/null", "/dev/zero", "/dev/full"};
// Java's configuration is in folders with the version in their names.
constexpr int kOldestJava = 7;
constexpr int kNewestJava = 40;

class Rules {
 public:
  explicit Rules(const Order& order) {
    version_ = static_cast<int>(::syscall(SYS_landlock_create_ruleset, nullptr, 0, kAskVersion));
    if (version_ < 1) return;
    handled_ = kVersion1;
    if (version_ >= 2) handled_ |= kRefer;
    if (version_ >= 3) handled_ |= kTruncate;
    if (version_ >= 5) handled_ |= kDeviceCalls;
    RulesetAttributes attributes;
    attributes.files = handled_;
    if (version_ >= 4 && !order.page->network) attributes.network = kTcp;
    if (version_ >= 6) attributes.scopes = kScopes;
    const std::size_t size = version_ >= 6 ? 24 : version_ >= 4 ? 16 : 8;
    set_ = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, size, 0));
  }
  Rules(const Rules&) = delete;
  Rules& operator=(const Rules&) = delete;
  ~Rules() {
    if (set_ >= 0) ::close(set_);
  }

  bool exist() const { return set_ >= 0; }
  int version() const { return version_; }

  /// Ignores files and folders that do not exist.
  void allow(const std::string& path, std::uint64_t rights) {
    PathRule rule;
    rule.folder = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    if (rule.folder < 0) return noteShortage();
    struct stat status{};
    const bool folder = ::fstat(rule.folder, &status) == 0 && S_ISDIR(status.st_mode);
    rule.allowed = rights & handled_ & (folder ? ~std::uint64_t{0} : kOfFiles);
    if (::syscall(SYS_landlock_add_rule, set_, kPathRule, &rule, 0) != 0 && error_ == 0) error_ = errno;
    ::close(rule.folder);
  }

  /// Notes that a file exists which the machine cannot open now.
  void noteShortage() {
    if (error_ == 0 && (isShortage(errno) || errno == EIO)) error_ = errno;
  }

  int restrictSelf() const {
    if (error_ != 0) return error_;
    return ::syscall(SYS_landlock_restrict_self, set_, 0) == 0 ? 0 : errno;
  }

 private:
  int version_ = 0;
  int set_ = -1;
  int error_ = 0;
  std::uint64_t handled_ = 0;
};

std::string parentOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos || slash == 0 ? "" : path.substr(0, slash);
}

std::string nameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string realPath(const std::string& path) {
  std::array<char, PATH_MAX> real{};
  return ::realpath(path.c_str(), real.data()) != nullptr ? std::string(real.data()) : std::string();
}

/// Whether a word is the absolute path of a file.
bool isFile(const std::string& word) {
  struct stat status{};
  return word.starts_with('/') && ::stat(word.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

/// The file of a program, searched in PATH unless the name has a '/'.
std::string findProgram(const std::string& name, const std::string& path) {
  if (name.find('/') != std::string::npos) return name;
  for (std::size_t at = 0; at <= path.size();) {
    std::size_t end = path.find(':', at);
    if (end == std::string::npos) end = path.size();
    const std::string file = path.substr(at, end - at) + "/" + name;
    if (::access(file.c_str(), X_OK) == 0) return file;
    at = end + 1;
  }
  return {};
}

/// The words of a script's first line, without "#!".
std::vector<std::string> interpreterOf(Rules& rules, const std::string& program) {
  std::vector<std::string> words;
  const int file = ::open(program.c_str(), O_RDONLY | O_CLOEXEC);
  std::array<char, 256> start{};
  const ssize_t size = file < 0 ? -1 : ::read(file, start.data(), start.size());
  if (size < 0) rules.noteShortage();
  if (file >= 0) ::close(file);
  if (size < 2 || start[0] != '#' || start[1] != '!') return words;
  bool in_word = false;
  for (ssize_t k = 2; k < size && start[k] != '\n'; ++k) {
    const bool blank = start[k] == ' ' || start[k] == '\t' || start[k] == '\r';
    if (!blank && !in_word) words.emplace_back();
    if (!blank) words.back() += start[k];
    in_word = !blank;
  }
  return words;
}

/// Allows the prefix of an installation, such as /opt/python. A user's home is no prefix: for programs in
/// ~/bin, only the folders beside it that belong to an installation are readable.
void allowPrefix(Rules& rules, const Order& order, const std::string& prefix) {
  if (prefix != realPath(order.home)) return rules.allow(prefix, kReading);
  for (const char* part : {"/lib", "/lib64", "/libexec", "/share"}) rules.allow(prefix + part, kReading);
}

/// Allows the folder of a program, and its prefix if the folder is one like /opt/python/bin. Follows virtual
/// environments of Python and the shims of pyenv to the installation that they use.
void allowSurroundings(Rules& rules, const Order& order, const std::string& program, int depth) {
  const std::string real = realPath(program);
  if (real.empty()) return rules.noteShortage();
  const std::string folder = parentOf(real), prefix = parentOf(folder);
  rules.allow(folder, kReading);
  if ((nameOf(folder) == "bin" || nameOf(folder) == "shims") && !prefix.empty())
    allowPrefix(rules, order, prefix);
  const std::string environment = parentOf(parentOf(program));
  if (::access((environment + "/pyvenv.cfg").c_str(), F_OK) == 0) rules.allow(environment, kReading);
  const std::vector<std::string> words = interpreterOf(rules, real);
  if (words.empty() || depth == 0) return;
  allowSurroundings(rules, order, words.front(), depth - 1);
  if (nameOf(words.front()) != "env") return;
  for (std::size_t k = 1; k < words.size(); ++k) {
    allowSurroundings(rules, order, findProgram(words[k], order.path), depth - 1);
  }
}

}  // namespace

int restrictFiles(const Order& order, std::string& why) {
  Rules rules(order);
  if (!rules.exist()) {
    why = "the kernel does not offer it";
    return errno;
  }
  for (const char* path : kSystem) rules.allow(path, kReading);
  for (int version = kOldestJava; version <= kNewestJava; ++version) {
    rules.allow("/etc/java-" + std::to_string(version) + "-openjdk", kReading);
  }
  for (const char* path : kDevices) rules.allow(path, kReadFile | kWriteFile | kTruncate | kDeviceCalls);
  for (const std::string& path : order.readable) rules.allow(path, kReading);
  if (!order.own_folder.empty()) rules.allow(order.own_folder, kReading);
  constexpr int kScriptsInterpretedByScripts = 3;
  if (order.page->program_alone) {
    rules.allow(order.program, kReading);
  } else {
    allowSurroundings(rules, order, order.program, kScriptsInterpretedByScripts);
  }
  for (const std::string& argument : order.arguments) {
    if (isFile(argument)) rules.allow(argument, kReading);
  }
  rules.allow(order.private_folder, ~(kMakeCharacterDevice | kMakeBlockDevice));
  why = "the kernel refuses";
  return rules.restrictSelf();
}

}  // namespace fulbito::keeper
