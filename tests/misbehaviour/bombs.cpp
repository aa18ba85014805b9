#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <pthread.h>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

// Each bomb also bounds itself, for the day when its containment fails.
namespace fulbito::test {
namespace {

constexpr int kMostProcesses = 200;
constexpr int kMostThreads = 1000;
constexpr std::size_t kMostMemory = std::size_t{3} << 30;  // [bytes]
constexpr std::size_t kMostOnDisk = std::size_t{1} << 30;  // [bytes]
constexpr unsigned kMostSeconds = 20;                      // [s]
constexpr std::size_t kStep = std::size_t{1} << 24;        // [bytes]

std::string inPrivateFolder(const std::string& name) {
  const char* home = std::getenv("HOME");
  return std::string(home == nullptr ? "/nonexistent" : home) + "/" + name;
}

void forkBomb(const Scene&) {
  void* memory = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto* count = new (memory) std::atomic<int>(1);
  ::alarm(kMostSeconds);
  // All multiply until they are refused, or are as many as they may.
  while (count->load() < kMostProcesses) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(kMostSeconds);
      count->fetch_add(1);
    } else if (child < 0) {
      break;
    }
  }
  if (count->load() >= kMostProcesses) tell("fork bomb", true);
  waitForEver();
}

void threadBomb(const Scene&) {
  ::alarm(kMostSeconds);
  int threads = 0;
  pthread_t thread{};
  while (threads < kMostThreads &&
         ::pthread_create(&thread, nullptr, [](void*) -> void* { waitForEver(); }, nullptr) == 0) {
    ++threads;
  }
  if (threads >= kMostThreads) tell("thread bomb", true);
  waitForEver();
}

void memoryBomb(const Scene&) {
  for (std::size_t size = 0; size < kMostMemory; size += kStep) std::memset(::operator new(kStep), 1, kStep);
  tell("memory bomb", true);
}

void sharedMemoryBomb(const Scene&) {
  for (std::size_t size = 0; size < kMostMemory; size += kStep) {
    void* memory = ::mmap(nullptr, kStep, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) ::_exit(1);
    std::memset(memory, 1, kStep);
  }
  tell("shared memory bomb", true);
}

/// Files without a name, whose memory nothing maps.
void memoryFileBomb(const Scene&) {
  const std::string part(std::size_t{1} << 20, 'x');
  std::size_t size = 0;
  while (size < kMostMemory) {
    const int file = ::memfd_create("bomb", 0);
    if (file < 0) ::_exit(1);
    for (int k = 0; k < 15; ++k) {
      if (::write(file, part.data(), part.size()) != static_cast<ssize_t>(part.size())) ::_exit(1);
      size += part.size();
    }
  }
  tell("memory file bomb", true);
}

void fileBomb(const Scene&) {
  const int file = ::open(inPrivateFolder("large").c_str(), O_CREAT | O_WRONLY, 0600);
  const std::string part(kStep, 'x');
  for (std::size_t size = 0; size < kMostOnDisk; size += kStep) {
    if (::write(file, part.data(), part.size()) <= 0) ::_exit(1);
  }
  tell("file bomb", true);
}

void manyFiles(const Scene&) {
  const std::string part(std::size_t{1} << 20, 'x');
  for (std::size_t size = 0; size < kMostOnDisk; size += part.size()) {
    const std::string name = inPrivateFolder("file-" + std::to_string(size));
    const int file = ::open(name.c_str(), O_CREAT | O_WRONLY, 0600);
    if (file < 0 || ::write(file, part.data(), part.size()) != static_cast<ssize_t>(part.size())) ::_exit(1);
    ::close(file);
  }
  tell("many files", true);
}

void deepFolders(const Scene&) {
  if (::chdir(inPrivateFolder("").c_str()) != 0) ::_exit(1);
  for (int depth = 0; depth < 2000; ++depth) {
    if (::mkdir("deeper", 0700) != 0 || ::chdir("deeper") != 0) break;
  }
  static_cast<void>(::open("file", O_CREAT | O_WRONLY, 0));
  static_cast<void>(!::chmod("..", 0));
  waitForEver();
}

void descriptorFlood(const Scene&) {
  int count = 0;
  std::array<int, 2> ends{};
  while (count < 100'000 && ::pipe(ends.data()) == 0) count += 2;
  if (count >= 100'000) tell("descriptor flood", true);
  waitForEver();
}

void zombies(const Scene&) {
  for (int k = 0; k < kMostProcesses; ++k) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    if (child < 0) break;
  }
  waitForEver();
}

constexpr Kind kBombs[] = {
    {"fork-bomb", "starts processes that start processes", forkBomb},
    {"thread-bomb", "starts threads for ever", threadBomb},
    {"memory-bomb", "takes all memory", memoryBomb},
    {"shared-memory-bomb", "takes all memory, shared", sharedMemoryBomb},
    {"memory-file-bomb", "takes all memory in files without a name", memoryFileBomb},
    {"file-bomb", "writes a file that never ends", fileBomb},
    {"many-files", "writes files for ever", manyFiles},
    {"deep-folders", "nests folders too deep for a path", deepFolders},
    {"descriptor-flood", "opens pipes for ever", descriptorFlood},
    {"zombies", "never waits for its children", zombies},
};

}  // namespace

std::span<const Kind> bombs() { return kBombs; }

}  // namespace fulbito::test
