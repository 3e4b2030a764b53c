// Which process computes which piece of a common work: byte k of a file is locked by whoever computes piece k. The
// operating system frees it when that process dies.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tread {

// A process's hold on pieces of the work in a folder.
class Claims {
public:
    explicit Claims(const std::filesystem::path& folder);  // throws FileError
    ~Claims();
    Claims(const Claims&) = delete;
    Claims& operator=(const Claims&) = delete;

    // False when another process computes the piece. True on a file system without locks: then two may compute the same
    // piece, with the same result.
    bool take(std::uint64_t piece);
    void release(std::uint64_t piece);

private:
    int file_ = -1;
};

// Pieces that some process computes at this moment; none when nobody has begun.
std::vector<std::uint64_t> claimed(const std::filesystem::path& folder, std::uint64_t pieces);

}  // namespace tread
