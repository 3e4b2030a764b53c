// Files that are whole or not there, on disks that several processes and machines share.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace tread {

// Writes a file beside its place under a name that nobody else uses, makes sure that it is on disk, and gives it its
// name in one step. Throws FileError.
void writeDurably(const std::filesystem::path& file, std::string_view text);

// Removes what killed processes of this machine have left in a folder under temporary names.
void removeLeftovers(const std::filesystem::path& folder);

}  // namespace tread
