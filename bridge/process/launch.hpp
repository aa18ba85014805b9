#pragma once

#include <sys/types.h>
#include <vector>

#include "bridge/process/child.hpp"
#include "bridge/process/keeper/page.hpp"
#include "engine/core/system/descriptor.hpp"

namespace fulbito {

/// Memory that this process shares with a keeper.
class SharedPage {
 public:
  SharedPage() = default;
  SharedPage(keeper::Page* page, std::size_t size) : page_(page), size_(size) {}
  SharedPage(SharedPage&& other) noexcept;
  SharedPage& operator=(SharedPage&& other) noexcept;
  ~SharedPage();

  keeper::Page* operator->() const { return page_; }
  const keeper::Page& operator*() const { return *page_; }

 private:
  keeper::Page* page_ = nullptr;
  std::size_t size_ = 0;
};

/// A keeper that has started a team's program.
struct Launched {
  SharedPage page;
  pid_t keeper = -1;
  Descriptor in;                    ///< to the team's standard input; does not block
  Descriptor out;                   ///< from its standard output; does not block
  Descriptor errors;                ///< from its standard error; does not block
  std::vector<Descriptor> sockets;  ///< of its own network
};

/// Starts a keeper and waits until it has started the program. Errors: as Child::launch.
Result<Launched> launchTeam(const ChildOptions& options);

/// Waits for a keeper that ends, and returns its status as waitpid gives it.
int waitForKeeper(pid_t keeper);

/// Removes what a killed keeper has left. Other keepers remove it themselves.
void removeLeftovers(const keeper::Page& page);

/// The lines of a text, which each end with a line end.
std::vector<std::string> linesOf(std::string_view text);

}  // namespace fulbito
