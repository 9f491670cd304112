// Videos of a game, frame by frame, through the program ffmpeg.
// Invariant: a file is either finished or an error was given.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include <cairn/engine/image.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

class VideoWriter {
  public:
    /// Starts ffmpeg, which replaces the file; the file's ending (.mp4, .webm, .gif ...) says in which form.
    /// The error tells when ffmpeg is not installed.
    static Result<std::unique_ptr<VideoWriter>> create(const std::string& path, Size size,
                                                       int frames_per_second);
    /// Ends ffmpeg; without `finish` before, the file may be cut short.
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// The next frame, of the size given at first. An error when ffmpeg has ended: a full disk, an unknown
    /// ending.
    Result<void> write(const Image& frame);
    /// Waits until the file is complete.
    Result<void> finish();

  private:
    VideoWriter(std::string path, Size size, int pipe, int process, std::FILE* messages);
    /// What ffmpeg has said: nothing when all went well.
    std::string messages() const;
    Error failure() const;

    std::string path_;
    Size size_;
    int pipe_;     ///< into ffmpeg; -1: closed
    int process_;  ///< -1: ended and waited for
    std::FILE* messages_;
};

}  // namespace cairn::engine
