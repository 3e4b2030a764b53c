#include "store/result_folder.h"

#include <string>

#include "store/whole_file.h"
#include "tread/problem.h"

namespace tread {

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) return;
    throw FileError("cannot create the folder " + folder.string() + ": " + error.message() +
                    "; choose another with -o");
}

void markIncomplete(const std::filesystem::path& folder) {
    writeFile(folder / kIncomplete,
              "A call of tread is writing into this folder, or was killed while doing so: files may be missing or from "
              "another run.\n");
}

void removeResult(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (!error) return;
    throw FileError("cannot remove " + file.string() + ", left by an earlier call: " + error.message() +
                    "; choose another folder with -o");
}

bool isIncomplete(const std::filesystem::path& folder) {
    std::error_code error;
    return std::filesystem::exists(folder / kIncomplete, error);
}

void expectComplete(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.find(".incomplete.") != std::string::npos || !isIncomplete(file.parent_path())) return;
    throw LoadError(
        {{file.string(), 0, 0, "",
          "lies in a folder that is marked as incomplete: a call of tread is writing into it, or was killed "
          "while doing so; run it again, or remove " +
              (file.parent_path() / kIncomplete).string() + " to read what is there"}});
}

}  // namespace tread
