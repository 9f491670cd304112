#include "child.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

namespace cairn::lab {
namespace {

// Of a run, by the clock on the wall. A limit of CPU time would be fairer on a busy machine, but under one
// Linux counts the process's CPU time in ticks only.
constexpr unsigned kMostSeconds = 300;

std::string read_all(int from) {
    std::string text;
    std::array<char, 4096> block{};
    for (;;) {
        const ssize_t got = read(from, block.data(), block.size());
        if (got <= 0) return text;
        text.append(block.data(), static_cast<std::size_t>(got));
    }
}

void write_all(int to, const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t wrote = write(to, text.data() + done, text.size() - done);
        if (wrote <= 0) return;
        done += static_cast<std::size_t>(wrote);
    }
}

Answer ended(std::string by) {
    return {{}, std::move(by)};
}

}  // namespace

Answer ask_child(const std::function<std::string()>& work) {
    std::array<int, 2> pipe_ends{};
    std::fflush(nullptr);  // or the child writes it again
    if (pipe(pipe_ends.data()) != 0) return ended("no pipe to a process of its own");
    const pid_t child = fork();
    if (child < 0) return ended("no process of its own");
    if (child == 0) {
        close(pipe_ends[0]);
        alarm(kMostSeconds);
        write_all(pipe_ends[1], work());
        std::fflush(nullptr);
        _exit(0);
    }
    close(pipe_ends[1]);
    std::string text = read_all(pipe_ends[0]);
    close(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGALRM) return ended("more than " + std::to_string(kMostSeconds) + " s");
        return ended(std::string("signal: ") + strsignal(signal));
    }
    if (WEXITSTATUS(status) != 0) return ended("exit status " + std::to_string(WEXITSTATUS(status)));
    return {std::move(text), {}};
}

}  // namespace cairn::lab
