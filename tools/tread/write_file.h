// Files that appear under their name only when they are whole.
#pragma once

#include <filesystem>
#include <string_view>

namespace tread::program {

// Writes to a temporary name and renames; throws FileError with one sentence (not writable, disk full).
void writeFile(const std::filesystem::path& file, std::string_view content);

void makeFolder(const std::filesystem::path& folder);

}  // namespace tread::program
