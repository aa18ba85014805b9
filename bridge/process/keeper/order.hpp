#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

#include "bridge/process/keeper/page.hpp"

namespace fulbito::keeper {

/// [bytes] stack of a team's first thread, and of other threads unless they choose a size
inline constexpr std::uint64_t kStackSize = std::uint64_t{1} << 23;

/// The keeper's order, as read from the page, and facts that it finds out.
struct Order {
  Page* page = nullptr;
  std::string program;      ///< path of the program's file
  std::string own_folder;   ///< folder of the team's files; empty: none beyond the program's
  std::string base_folder;  ///< where the private folder is made
  std::string path;         ///< PATH
  std::string language;     ///< LANG
  std::string home;         ///< HOME of the user who plays the match; the team gets another
  std::vector<std::string> readable;
  std::vector<std::string> arguments;  ///< the first is the program's name

  std::string private_folder;
  uid_t user = 0;           ///< user that the team runs as
  gid_t group = 0;          ///< group that the team runs as
  bool own_pids = false;    ///< the team is in a PID namespace
  bool own_users = false;   ///< the team is in a user namespace
  bool unwritable = false;  ///< all mounts of the team are read-only, except the private folder
};

/// Maps the page and reads the order. Ends the process if the page is invalid.
Order readOrder();

/// Notes a layer that the child has.
void reached(Order& order, const char* layer);

/// Notes that the child lacks a layer, with the text of `error`. If the error is a temporary shortage, the
/// launch gives up instead.
void lacks(Order& order, const char* layer, const std::string& why, int error);

/// Notes the reason why the launch fails.
void failed(Order& order, const char* step, int error);

/// Notes the reason why the launch fails, and ends this process.
[[noreturn]] void giveUp(Order& order, const char* step, int error);

}  // namespace fulbito::keeper
