// What the fuzzer and the replay of its corpus do with the bytes of a MATLAB file: as they are, and as the description
// of a version 5 file whose elements are all in place. matio and what it uses are not compiled for the fuzzer: it
// follows what they return, not their branches.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "fuzz/import_entry.h"

namespace tread::fuzz {

// A file without a disk.
class FileInMemory {
public:
    FileInMemory() { demand(file_ >= 0); }
    ~FileInMemory() { close(file_); }
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;

    std::string with(std::string_view bytes) const {
        demand(ftruncate(file_, 0) == 0);
        demand(pwrite(file_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
        return "/proc/self/fd/" + std::to_string(file_);
    }

private:
    int file_ = memfd_create("fuzz.mat", MFD_CLOEXEC);
};

// Makes variables of what the bytes say: classes, sizes, names, numbers, fields of structs, cells.
class MatWriter {
public:
    explicit MatWriter(std::string_view told) : told_(told) {}

    // Each variable as it is, or as `packed` makes it, which is then a compressed one.
    std::string file(std::string (*packed)(const std::string&) = nullptr) {
        std::string text = "MATLAB 5.0 MAT-file";
        text.resize(124, ' ');
        text += std::string_view("\0\1IM", 4);
        for (int variables = 0; !told_.empty() && variables < 8; ++variables) {
            const std::string variable = matrix(0);
            text += packed ? element(kCompressed, packed(variable)) : variable;
        }
        return text;
    }

    static constexpr std::uint32_t kInt8 = 1, kInt32 = 5, kUint32 = 6, kMatrix = 14, kCompressed = 15;
    static constexpr std::uint32_t kCell = 1, kStruct = 2;

    static std::string word(std::uint32_t value) {
        std::string text(4, '\0');
        std::memcpy(text.data(), &value, 4);
        return text;
    }

    static std::string element(std::uint32_t type, const std::string& content) {
        std::string text = word(type) + word(static_cast<std::uint32_t>(content.size())) + content;
        if (type != kCompressed) text.resize((text.size() + 7) / 8 * 8, '\0');
        return text;
    }

private:
    std::uint32_t next() {
        if (told_.empty()) return 0;
        const auto value = static_cast<unsigned char>(told_.front());
        told_.remove_prefix(1);
        return value;
    }

    std::string taken(std::size_t size) {
        std::string text(told_.substr(0, size));
        told_.remove_prefix(text.size());
        text.resize(size, '\0');
        return text;
    }

    // Numbers of a type; as many as there should be, or as the bytes say.
    std::string numbers(std::size_t count) {
        static constexpr std::array<std::size_t, 14> kBytes{1, 1, 1, 2, 2, 4, 4, 4, 1, 8, 1, 1, 8, 8};
        const auto type = static_cast<std::uint32_t>(next() % kBytes.size());
        if (next() == 255) count = next();
        return element(type, taken(count * kBytes[type]));
    }

    std::string matrix(int depth) {
        const std::uint32_t kind = next() % 20, flags = next();
        std::string text = element(kUint32, word(kind | flags << 8) + word(next()));
        std::string sizes;
        std::size_t count = 1;
        for (std::uint32_t rank = next() % 8 == 0 ? next() % 5 : 2; rank > 0; --rank) {
            const std::uint32_t size = next() % 64;
            sizes += word(size);
            count = std::min<std::size_t>(count * size, 4096);
        }
        text += element(kInt32, sizes) + element(kInt8, taken(next() % 16));
        if (kind == kStruct) {
            const std::size_t room = 1 + next() % 32, fields = next() % 6;
            text += word(kInt32 | 4u << 16) + word(static_cast<std::uint32_t>(room));
            text += element(kInt8, taken(room * fields));
            count *= fields;
        }
        if (kind == kStruct || kind == kCell) {
            for (count = std::min<std::size_t>(count, 16); count > 0 && depth < 20 && !told_.empty(); --count)
                text += matrix(depth + 1);
        } else {
            text += numbers(count);
            if ((flags & 8) != 0) text += numbers(count);
        }
        return element(kMatrix, text);
    }

    std::string_view told_;
};

inline bool importHostileMatFile(std::string_view bytes) {
    static const FileInMemory file;
    const std::string path = file.with(bytes);
    return importHostile([&] { return readMat(path); });
}

inline bool importHostileMat(std::string_view bytes) {
    const bool bare = importHostileMatFile(bytes), written = importHostileMatFile(MatWriter(bytes).file());
    return bare || written;
}

}  // namespace tread::fuzz
