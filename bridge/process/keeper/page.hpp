#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace fulbito::keeper {

/// @{ Descriptors that the keeper starts with, in addition to the three standard ones, which it passes to the
/// team.
inline constexpr int kPageDescriptor = 3;
/// Closes when the team's program has begun or cannot begin. Before that, the sockets of the team's own
/// network pass through it.
inline constexpr int kStartDescriptor = 4;
/// @}

/// The most sockets that pass.
inline constexpr int kMostSockets = 8;

/// The last step of a launch: a failure in it may be the program's fault.
inline constexpr const char* kRunProgram = "run the program";

/// A text of the page. It is cut where it does not fit.
template <std::size_t Size>
struct Text {
  char bytes[Size] = {};

  void set(std::string_view text) { bytes[text.copy(bytes, Size - 1)] = '\0'; }
  void add(std::string_view text) {
    const std::size_t used = view().size();
    bytes[used + text.copy(bytes + used, Size - 1 - used)] = '\0';
  }
  std::string_view view() const { return {bytes, ::strnlen(bytes, Size)}; }
};

/// The memory that the launching program and the keeper of a child share: the order, and its result. Both
/// programs are from the same build. A word list with `text_size` bytes follows the struct: the program's
/// file, the team's folder, the folder for temporary files, PATH, LANG, the user's home, then `readable`
/// folders, then the arguments. Each ends with a zero.
struct Page {
  /// @{ The order, see ChildLimits.
  std::uint64_t memory = 0;       ///< [bytes]
  std::uint64_t file_size = 0;    ///< [bytes]
  std::uint64_t folder_size = 0;  ///< [bytes]
  std::int32_t open_files = 0;
  std::int32_t processes = 0;
  std::int32_t cpu_seconds = 0;  ///< [s]
  std::int32_t launcher = 0;     ///< process that the keeper works for
  std::uint32_t readable = 0;    ///< number of folders
  std::uint32_t arguments = 0;
  std::uint32_t text_size = 0;  ///< [bytes]
  std::int32_t sockets = 0;     ///< to make in a network of the team's own; 0: it gets none of its own
  bool network = false;
  bool all_layers = false;     ///< give up if a layer is missing
  bool program_alone = false;  ///< only the program's file is readable, not the installation around it
  /// Set later, with the request to end: the team has closed its input or output, so it may be exiting by
  /// itself.
  bool pipe_closed = false;
  /// @}

  /// @{ The result of the launch, valid once the start descriptor closes.
  std::int32_t error = 0;       ///< errno; 0: it runs
  Text<128> step;               ///< the step that failed
  bool begins = false;          ///< the launch has reached its last step
  bool lacks_layer = false;     ///< the keeper gave up because a layer is missing
  Text<512> layers;             ///< each ends with a line end
  Text<2048> missing;           ///< each ends with a line end
  Text<512> private_folder;     ///< its path; the launcher removes it if the keeper dies
  Text<2048> groups;            ///< folders of control groups, each with a line end; removed likewise
  bool grouped = false;         ///< a control group counts the team's memory
  bool bounded_folder = false;  ///< the private folder has a size limit of its own
  /// @}
  /// @{ How the team ended, valid once the keeper has ended.
  bool ended = false;            ///< the team ended by itself
  std::int32_t wait_status = 0;  ///< status as of waitpid
  Text<128> reason;              ///< why the keeper ended the team; empty: it had a request
  bool machine_failed = false;   ///< `reason` is not the team's fault
  /// @}
};

}  // namespace fulbito::keeper
