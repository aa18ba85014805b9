#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

#include "bridge/process/keeper/page.hpp"

namespace fulbito::keeper {

/// [bytes] stack of a team's first thread, and of others where they choose none
inline constexpr std::uint64_t kStackSize = std::uint64_t{1} << 23;

/// What the keeper is to run, read from the page, and what it learns on the way.
struct Order {
  Page* page = nullptr;
  std::string program;      ///< file
  std::string own_folder;   ///< the team's files; empty: none beyond the program's
  std::string base_folder;  ///< where the private folder is made
  std::string path;         ///< PATH
  std::string language;     ///< LANG
  std::string home;         ///< HOME of whoever plays the match; the team has another
  std::vector<std::string> readable;
  std::vector<std::string> arguments;  ///< the first is the program's name

  std::string private_folder;
  uid_t user = 0;           ///< that the team runs as
  gid_t group = 0;          ///< that the team runs as
  bool own_pids = false;    ///< the team is in a PID namespace
  bool own_users = false;   ///< the team is in a user namespace
  bool unwritable = false;  ///< the team's mounts are, but for the private folder
};

/// Maps the page and reads the order. Ends the process if the page makes no sense.
Order readOrder();

/// Notes a layer that the child has.
void reached(Order& order, const char* layer);

/// Notes that the child lacks a layer, with the text of `error`. Where that is a shortage of the machine,
/// which passes, it gives up instead.
void lacks(Order& order, const char* layer, const std::string& why, int error);

/// Notes why the launch fails.
void failed(Order& order, const char* step, int error);

/// Notes why the launch fails, and ends this process.
[[noreturn]] void giveUp(Order& order, const char* step, int error);

}  // namespace fulbito::keeper
