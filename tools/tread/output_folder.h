// The folder into which a command writes its results. One call holds it at a time, and a call that was killed leaves a
// mark: so the files of a folder without a mark are of one call, and whole.
#pragma once

#include <string>

#include "commands.h"

namespace tread::program {

// --wait: from now on a folder that another call holds is waited for.
void waitForFolders();

class OutputFolder {
public:
    // Makes the folder, holds it and marks it (store/result_folder.h). Throws FileError: it cannot be made or written,
    // or another call holds it.
    explicit OutputFolder(const Path& folder);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    // Removes what an earlier call has left, so that all files are of this one. Throws FileError.
    void remove(const std::string& name) const;
    // All is written: takes the mark away. Throws FileError.
    void complete() const;

private:
    Path folder_;
    int held_ = -1;  // file descriptor
};

}  // namespace tread::program
