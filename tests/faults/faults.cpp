// Loaded before libc (LD_PRELOAD), it makes the n-th access of a program to its files fail, as SQLite's tests do:
//
//     TREAD_FAULT=error:7        call 7 fails with EIO
//     TREAD_FAULT=full:7         from call 7 on nothing can be written or made: ENOSPC
//     TREAD_FAULT=short:7        call 7 reads or writes half of what it is asked to
//     TREAD_FAULT=interrupt:7    call 7 fails with EINTR, if it is one that a signal may interrupt
//     TREAD_FAULT=kill:7         the program is killed in place of call 7
//     TREAD_CALLS=file           each call is written there: "7 rename /folder/name"
//
// Counted are the calls on files that are not of the system, from 1.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum class Fault { none, error, full, half, interrupt, kill };

// What a call does, as far as faults differ: `settle` neither needs room nor waits.
enum class Does { look, read, write, make, settle };

struct Settings {
    Fault fault = Fault::none;
    long at = 0;
    int calls = -1;  // file descriptor

    Settings() {
        if (const char* const asked = std::getenv("TREAD_FAULT")) {
            const char* const colon = std::strchr(asked, ':');
            at = colon ? std::atol(colon + 1) : 0;
            const auto is = [&](const char* name) { return std::strncmp(asked, name, std::strlen(name)) == 0; };
            fault = is("error")       ? Fault::error
                    : is("full")      ? Fault::full
                    : is("short")     ? Fault::half
                    : is("interrupt") ? Fault::interrupt
                    : is("kill")      ? Fault::kill
                                      : Fault::none;
        }
        if (const char* const file = std::getenv("TREAD_CALLS"))
            calls = static_cast<int>(syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, 0600));
    }
};

const Settings& settings() {
    static const Settings all;
    return all;
}

std::atomic<long> count{0};
constexpr std::size_t kMostFiles = 4096;
std::array<std::atomic<bool>, kMostFiles> own_file;  // by descriptor: opened by a counted call

bool isOwn(const char* path) {
    for (const char* const system : {"/proc/", "/sys/", "/dev/", "/usr/", "/lib", "/etc/", "/bin/", "/opt/", "/run/"})
        if (std::strncmp(path, system, std::strlen(system)) == 0) return false;
    return true;
}

bool isOwn(int file) {
    return file > 2 && static_cast<std::size_t>(file) < kMostFiles && own_file[static_cast<std::size_t>(file)];
}

int keep(int file, bool own) {
    if (file >= 0 && static_cast<std::size_t>(file) < kMostFiles) own_file[static_cast<std::size_t>(file)] = own;
    return file;
}

void tell(long number, const char* call, const char* path, int file) {
    if (settings().calls < 0) return;
    char name[4096] = "", line[4200];
    if (!path) {
        char link[64];
        std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
        const ssize_t size = syscall(SYS_readlink, link, name, sizeof name - 1);
        name[size > 0 ? size : 0] = '\0';
        path = name;
    }
    const int size = std::snprintf(line, sizeof line, "%ld %s %s\n", number, call, path);
    syscall(SYS_write, settings().calls, line, static_cast<std::size_t>(size));
}

// What becomes of a call: true, with errno set, when it must fail; `half` when it shall do half of its work.
bool fails(const char* call, Does does, const char* path, int file, bool* half = nullptr) {
    if (path ? !isOwn(path) : !isOwn(file)) return false;
    const long number = ++count;
    tell(number, call, path, file);
    const Settings& asked = settings();
    if (asked.fault == Fault::full && number >= asked.at && (does == Does::write || does == Does::make)) {
        errno = ENOSPC;
        return true;
    }
    if (number != asked.at) return false;
    if (asked.fault == Fault::kill) syscall(SYS_kill, syscall(SYS_getpid), SIGKILL);
    if (asked.fault == Fault::half && half) *half = true;
    errno = asked.fault == Fault::interrupt ? EINTR : EIO;
    return asked.fault == Fault::error || (asked.fault == Fault::interrupt && does != Does::settle);
}

template <class F>
F* real(const char* name) {
    return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}
#define REAL(name) static auto* const original = real<decltype(name)>(#name)

mode_t modeOf(int flags, std::va_list words) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(words, mode_t) : 0;
}

int openedAt(int folder, const char* path, int flags, mode_t mode) {
    if (fails("open", (flags & O_CREAT) != 0 ? Does::make : Does::look, path, -1)) return -1;
    return keep(static_cast<int>(syscall(SYS_openat, folder, path, flags, mode)), isOwn(path));
}

std::FILE* opened(std::FILE* (*original)(const char*, const char*), const char* path, const char* mode) {
    if (fails("fopen", mode[0] == 'r' ? Does::look : Does::make, path, -1)) return nullptr;
    std::FILE* const file = original(path, mode);
    if (file) keep(fileno(file), isOwn(path));
    return file;
}

std::size_t halfOf(std::size_t size, bool half) {
    return half && size > 1 ? size / 2 : size;
}

}  // namespace

#define OPEN(name)                                    \
    int name(const char* path, int flags, ...) {      \
        std::va_list words;                           \
        va_start(words, flags);                       \
        const mode_t mode = modeOf(flags, words);     \
        va_end(words);                                \
        return openedAt(AT_FDCWD, path, flags, mode); \
    }
#define OPENAT(name)                                         \
    int name(int folder, const char* path, int flags, ...) { \
        std::va_list words;                                  \
        va_start(words, flags);                              \
        const mode_t mode = modeOf(flags, words);            \
        va_end(words);                                       \
        return openedAt(folder, path, flags, mode);          \
    }
#define FOPEN(name)                                       \
    std::FILE* name(const char* path, const char* mode) { \
        REAL(name);                                       \
        return opened(original, path, mode);              \
    }
// A call on a descriptor or path with nothing to halve.
#define SIMPLE(name, does, path, file, parameters, arguments)            \
    int name parameters {                                                \
        REAL(name);                                                      \
        return fails(#name, does, path, file) ? -1 : original arguments; \
    }
#define MOVE(name, does, pointer)                                \
    ssize_t name(int file, pointer bytes, std::size_t size) {    \
        REAL(name);                                              \
        bool half = false;                                       \
        if (fails(#name, does, nullptr, file, &half)) return -1; \
        return original(file, bytes, halfOf(size, half));        \
    }
#define MOVE_AT(name, does, pointer, offset)                             \
    ssize_t name(int file, pointer bytes, std::size_t size, offset at) { \
        REAL(name);                                                      \
        bool half = false;                                               \
        if (fails(#name, does, nullptr, file, &half)) return -1;         \
        return original(file, bytes, halfOf(size, half), at);            \
    }

#pragma GCC diagnostic ignored "-Wmissing-declarations"
extern "C" {

OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)
FOPEN(fopen)
FOPEN(fopen64)
MOVE(read, Does::read, void*)
MOVE(write, Does::write, const void*)
MOVE_AT(pread, Does::read, void*, off_t)
MOVE_AT(pread64, Does::read, void*, off64_t)
MOVE_AT(pwrite, Does::write, const void*, off_t)
MOVE_AT(pwrite64, Does::write, const void*, off64_t)
SIMPLE(flock, Does::look, nullptr, file, (int file, int how), (file, how))
SIMPLE(ftruncate, Does::write, nullptr, file, (int file, off_t size), (file, size))
SIMPLE(ftruncate64, Does::write, nullptr, file, (int file, off64_t size), (file, size))
SIMPLE(rename, Does::settle, to, -1, (const char* from, const char* to), (from, to))
SIMPLE(mkdir, Does::make, path, -1, (const char* path, mode_t mode), (path, mode))
SIMPLE(remove, Does::settle, path, -1, (const char* path), (path))
SIMPLE(unlink, Does::settle, path, -1, (const char* path), (path))

ssize_t writev(int file, const iovec* pieces, int number) {
    REAL(writev);
    return fails("writev", Does::write, nullptr, file) ? -1 : original(file, pieces, number);
}

std::size_t fread(void* bytes, std::size_t size, std::size_t number, std::FILE* file) {
    REAL(fread);
    bool half = false;
    if (!fails("fread", Does::read, nullptr, fileno(file), &half)) return original(bytes, size, number, file);
    file->_flags |= _IO_ERR_SEEN;
    return 0;
}

std::size_t fwrite(const void* bytes, std::size_t size, std::size_t number, std::FILE* file) {
    REAL(fwrite);
    return fails("fwrite", Does::write, nullptr, fileno(file)) ? 0 : original(bytes, size, number, file);
}

// Only a power failure would tell the difference, and a thousand of them take long.
int fsync(int file) {
    return fails("fsync", Does::look, nullptr, file) ? -1 : 0;
}
int fdatasync(int file) {
    return fails("fdatasync", Does::look, nullptr, file) ? -1 : 0;
}

// The descriptor is free even where closing fails.
int close(int file) {
    REAL(close);
    const bool failed = fails("close", Does::settle, nullptr, file);
    keep(file, false);
    const int error = errno, result = original(file);
    if (failed) errno = error;
    return failed ? -1 : result;
}

}  // extern "C"
