// What the window shows when a script failed: calm, readable, with the way out.
#pragma once

#include <string>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/renderer.h>

#include "lua/errors.h"

namespace cairn::scripting {

struct SourceLine {
    int number = 0;
    std::string text;
    bool is_faulty = false;  ///< the line that the error names
};

struct ErrorScreen {
    ScriptError error;
    std::vector<SourceLine> excerpt;
};

/// Reads the lines around the place of the error, if the game has that file.
ErrorScreen make_error_screen(const ScriptError& error, const engine::Files& files);

/// Draws it, between begin_frame and end_frame.
void draw_error_screen(const ErrorScreen& screen, engine::Renderer& renderer);

}  // namespace cairn::scripting
