// Folders of results, and the mark of one into which a call writes: a call that was killed leaves it behind, and what
// is in the folder may be of several calls.
#pragma once

#include <filesystem>

namespace tread {

// Makes the folder and those above it, unless they are there. Throws FileError.
void makeFolder(const std::filesystem::path& folder);

inline constexpr const char* kIncomplete = "INCOMPLETE";

// Throw FileError.
void markIncomplete(const std::filesystem::path& folder);
void removeResult(const std::filesystem::path& file);  // that an earlier call has left, or the mark
bool isIncomplete(const std::filesystem::path& folder);

// Throws LoadError when a file that is read as a result lies in a marked folder. What is kept of a run that ended
// before its end (log.incomplete.csv) says so itself.
void expectComplete(const std::filesystem::path& file);

}  // namespace tread
