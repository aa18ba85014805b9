#pragma once

#include <memory>
#include <string>

#include "fulbito/navigation.hpp"
#include "navigation/library/plugin_library.hpp"

namespace fulbito {

/// Whether a specification names a navigator of a shared library: `./mine.so:mine:gain=2`.
bool namesLibrary(const std::string& specification);

/// The entry of the navigator `name` of a library, which stays loaded as long as the entry exists. An empty
/// name selects the only navigator. Errors: kBadInput if the library's table is wrong, kUsage for an unknown
/// name, with a suggestion.
Result<std::shared_ptr<const NavigatorInfo>> libraryNavigator(
    const std::shared_ptr<const PluginLibrary>& library, const std::string& name);

}  // namespace fulbito
