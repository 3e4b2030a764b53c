// The real program, started as a user starts it.
#pragma once

#include <fcntl.h>
#include <pty.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "places/places.h"
#include "shared/scratch.h"

namespace tread {

inline std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

// The program while it runs, its output going to two files.
class Running {
public:
    // `other`: another program, whose file is the first word.
    Running(std::vector<std::string> words, const std::string& out, const std::string& err, bool other = false) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (!other) words.insert(words.begin(), programFile());
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        const int fault = posix_spawn(&child_, words.front().c_str(), &actions, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (fault != 0) throw std::runtime_error("cannot start " + words.front());
    }
    ~Running() {
        if (child_ == 0) return;
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void send(int signal) const { kill(child_, signal); }

    // Exit status; -1 when a signal ended it.
    int waitForStatus() {
        int state = 0;
        waitpid(child_, &state, 0);
        child_ = 0;
        return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
    }

private:
    pid_t child_ = 0;
};

struct Result {
    int status;  // as Running::waitForStatus
    std::string out, err;
};

// `standard_output`: a file that takes the place of standard output, for example a full disk.
inline Result runProgram(const std::vector<std::string>& words, const std::string& standard_output = {}) {
    const Scratch scratch;
    const std::string out = standard_output.empty() ? scratch.path("out") : standard_output;
    const std::string err = scratch.path("err");
    const int status = Running(words, out, err).waitForStatus();
    return {status, standard_output.empty() ? contentOf(out) : "", contentOf(err)};
}

// Another program than tread.
inline Result runOther(const std::string& file, std::vector<std::string> words) {
    const Scratch scratch;
    words.insert(words.begin(), file);
    const std::string out = scratch.path("out"), err = scratch.path("err");
    const int status = Running(words, out, err, true).waitForStatus();
    return {status, contentOf(out), contentOf(err)};
}

// The same in a terminal of 80 columns, which shows both streams.
inline Result runInTerminal(std::vector<std::string> words) {
    const winsize window{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
    words.insert(words.begin(), programFile());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &window);
    if (child < 0) throw std::runtime_error("no terminal can be made");
    if (child == 0) {
        setenv("TERM", "xterm", 1);
        execv(argv[0], argv.data());
        _exit(127);
    }
    std::string out;
    char buffer[4096];
    for (ssize_t n = 0; (n = read(terminal, buffer, sizeof buffer)) > 0;) out.append(buffer, static_cast<size_t>(n));
    close(terminal);
    int state = 0;
    waitpid(child, &state, 0);
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, out, ""};
}

}  // namespace tread
