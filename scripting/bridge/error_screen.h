// What the window shows when a script failed: calm, readable, with the way out.
#pragma once

#include <string>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/input.h>
#include <cairn/engine/renderer.h>

#include "lua/errors.h"

namespace cairn::scripting {

struct SourceLine {
    int number = 0;
    std::string text;
    bool is_faulty = false;  ///< the line that the error names
    std::size_t focus = 0;   ///< where in the text the fault is, as far as the error says; else its beginning
};

struct ErrorScreen {
    ScriptError error;
    std::vector<SourceLine> excerpt;
    bool was_copied = false;  ///< the button says so
};

enum class ErrorChoice { None, TryAgain, Copy, Quit };

/// What an event at the screen asks for: R or F5, C, Escape; A or start, X, B of a gamepad; the buttons by
/// mouse or finger; closing the window.
ErrorChoice choice_of(const engine::InputEvent& event, engine::Size screen);

/// With the lines around the place of the error, out of the text that the error knows, else of the file of
/// that name, if the game has one.
ErrorScreen make_error_screen(const ScriptError& error, const engine::Files& files);

/// Draws it, between begin_frame and end_frame.
void draw_error_screen(const ErrorScreen& screen, engine::Renderer& renderer);

}  // namespace cairn::scripting
