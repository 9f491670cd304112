// Raw frames go through a pipe into ffmpeg. Its messages go into a file without a name: it ends with status 0
// although the disk was full for the end of the video, and only says so.
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

#include <cairn/engine/video.h>

extern char** environ;

namespace cairn::engine {
namespace {

constexpr const char* kProgram = "ffmpeg";

/// posix_spawnp would tell too late, and not why.
bool is_installed(std::string_view program) {
    const char* path = std::getenv("PATH");
    if (path == nullptr) return false;
    std::string_view rest = path;
    while (true) {
        const std::size_t end = rest.find(':');
        const std::string file = std::string(rest.substr(0, end)) + '/' + std::string(program);
        if (access(file.c_str(), X_OK) == 0) return true;
        if (end == std::string_view::npos) return false;
        rest.remove_prefix(end + 1);
    }
}

/// Writes to a pipe whose reader has gone shall be errors, not the end of the program.
void ignore_broken_pipes() {
    static const auto done = std::signal(SIGPIPE, SIG_IGN);
    static_cast<void>(done);
}

}  // namespace

Result<std::unique_ptr<VideoWriter>> VideoWriter::create(const std::string& path, Size size,
                                                         int frames_per_second) {
    if (!is_installed(kProgram))
        return Error{"the video \"" + path +
                     "\" needs the program ffmpeg, which is not installed (on Debian: apt install ffmpeg)"};
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        return Error{"the video \"" + path + "\": the folder \"" + folder.string() + "\" does not exist"};
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        return Error{"the video \"" + path + "\": no pipe: " + std::strerror(errno)};
    ignore_broken_pipes();

    const std::string dimensions = std::to_string(size.width) + 'x' + std::to_string(size.height);
    const std::string rate = std::to_string(frames_per_second);
    // Most forms want even sides, and colors at half the resolution are what players can show.
    const char* const even_sides = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
    const std::string output = "file:" + path;  // a path never is a protocol or an option
    const std::array arguments{kProgram,
                               "-y",
                               "-nostdin",
                               "-loglevel",
                               "error",
                               "-f",
                               "rawvideo",
                               "-pix_fmt",
                               "rgba",
                               "-s",
                               dimensions.c_str(),
                               "-r",
                               rate.c_str(),
                               "-i",
                               "pipe:0",
                               "-vf",
                               even_sides,
                               "-pix_fmt",
                               "yuv420p",
                               output.c_str(),
                               static_cast<const char*>(nullptr)};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    std::FILE* messages = std::tmpfile();
    if (messages != nullptr) posix_spawn_file_actions_adddup2(&actions, fileno(messages), STDERR_FILENO);
    pid_t process = -1;
    const int problem = posix_spawnp(&process, kProgram, &actions, nullptr,
                                     const_cast<char* const*>(arguments.data()), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    if (problem != 0) {
        close(ends[1]);
        if (messages != nullptr) std::fclose(messages);
        return Error{"the video \"" + path + "\": ffmpeg cannot be started: " + std::strerror(problem)};
    }
    return std::unique_ptr<VideoWriter>(new VideoWriter(path, size, ends[1], process, messages));
}

VideoWriter::VideoWriter(std::string path, Size size, int pipe, int process, std::FILE* messages)
    : path_(std::move(path)), size_(size), pipe_(pipe), process_(process), messages_(messages) {}

VideoWriter::~VideoWriter() {
    static_cast<void>(finish());
    if (messages_ != nullptr) std::fclose(messages_);
}

std::string VideoWriter::messages() const {
    if (messages_ == nullptr) return {};
    constexpr std::size_t kMost = 1000;  // of a fault in each frame, the first ones
    std::string text(kMost, '\0');
    std::rewind(messages_);
    text.resize(std::fread(text.data(), 1, text.size(), messages_));
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

Error VideoWriter::failure() const {
    const std::string said = messages();
    return {"the video \"" + path_ + "\" could not be written: ffmpeg " +
            (said.empty() ? "ended with an error and said nothing" : "says: " + said)};
}

Result<void> VideoWriter::write(const Image& frame) {
    if (pipe_ < 0) return failure();
    if (frame.size != size_)
        return Error{"the video \"" + path_ + "\": a frame of " + std::to_string(frame.size.width) + " x " +
                     std::to_string(frame.size.height) + " pixels came, but all must be " +
                     std::to_string(size_.width) + " x " + std::to_string(size_.height)};
    const std::uint8_t* next = frame.rgba.data();
    std::size_t left = frame.rgba.size();
    while (left > 0) {
        const ssize_t written = ::write(pipe_, next, left);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            // Once it has ended, it has said why.
            if (const auto finished = finish(); !finished) return finished.error();
            return failure();
        }
        next += written;
        left -= static_cast<std::size_t>(written);
    }
    return {};
}

Result<void> VideoWriter::finish() {
    if (process_ < 0) return {};
    close(pipe_);
    pipe_ = -1;
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !messages().empty()) return failure();
    return {};
}

}  // namespace cairn::engine
