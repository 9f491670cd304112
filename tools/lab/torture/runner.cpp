#include "torture/runner.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace cairn::lab {
namespace {

using Json = nlohmann::ordered_json;

// Of a run, by the clock on the wall. A limit of CPU time would be fairer on a busy machine, but under one
// Linux counts the process's CPU time in ticks only.
constexpr unsigned kMostSeconds = 300;

Outcome examine(const Case& test, const EngineKind& kind) {
    const auto run = [&](int threads) {
        Trial trial(kind, threads);
        test.run(trial);
        return trial.finish();
    };
    Outcome outcome;
    outcome.findings = run(1);
    if (kind.name == "cairn") {
        const std::uint64_t digest = outcome.findings.digest;
        outcome.same_on_threads = run(2).digest == digest && run(8).digest == digest;
    }
    return outcome;
}

// Numbers that are none are null in JSON.
double number(const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

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

Outcome ended(std::string by) {
    Outcome outcome;
    outcome.ended_by = std::move(by);
    return outcome;
}

}  // namespace

bool Outcome::passed() const {
    return ended_by.empty() && findings.finite && findings.energy_excess <= kMostEnergyExcess &&
           same_on_threads.value_or(true) &&
           std::all_of(findings.figures.begin(), findings.figures.end(),
                       [](const Figure& figure) { return figure.holds(); });
}

std::string to_text(const Outcome& outcome) {
    Json text;
    text["figures"] = Json::array();
    for (const Figure& figure : outcome.findings.figures) {
        text["figures"].push_back({figure.name, figure.value, figure.limit, figure.at_most});
    }
    text["energy_excess"] = outcome.findings.energy_excess;
    text["finite"] = outcome.findings.finite;
    text["cpu_s"] = outcome.findings.cpu_s;
    if (outcome.same_on_threads) text["same_on_threads"] = *outcome.same_on_threads;
    return text.dump();
}

Outcome outcome_from(const std::string& text) {
    const Json read = Json::parse(text, nullptr, false);
    if (!read.is_object() || !read.contains("figures")) return ended("an answer that cannot be read");
    Outcome outcome;
    for (const Json& figure : read["figures"]) {
        outcome.findings.figures.push_back({figure.at(0).get<std::string>(), number(figure.at(1)),
                                            number(figure.at(2)), figure.at(3).get<bool>()});
    }
    outcome.findings.energy_excess = number(read["energy_excess"]);
    outcome.findings.finite = read["finite"].get<bool>();
    outcome.findings.cpu_s = number(read["cpu_s"]);
    if (read.contains("same_on_threads")) outcome.same_on_threads = read["same_on_threads"].get<bool>();
    return outcome;
}

Outcome run_case(const Case& test, const EngineKind& kind) {
    std::array<int, 2> pipe_ends{};
    std::fflush(nullptr);  // or the child writes it again
    if (pipe(pipe_ends.data()) != 0) return ended("no pipe to a process of its own");
    const pid_t child = fork();
    if (child < 0) return ended("no process of its own");
    if (child == 0) {
        close(pipe_ends[0]);
        alarm(kMostSeconds);
        write_all(pipe_ends[1], to_text(examine(test, kind)));
        std::fflush(nullptr);
        _exit(0);
    }
    close(pipe_ends[1]);
    const std::string answer = read_all(pipe_ends[0]);
    close(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGALRM) return ended("more than " + std::to_string(kMostSeconds) + " s");
        return ended(std::string("signal: ") + strsignal(signal));
    }
    if (WEXITSTATUS(status) != 0) return ended("exit status " + std::to_string(WEXITSTATUS(status)));
    return outcome_from(answer);
}

}  // namespace cairn::lab
