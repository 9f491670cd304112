// What a game runs on: files, platform, renderer, audio. Invariant: members are destroyed in an order that
// each of them allows (renderer and audio before the platform and the files that they use).
#pragma once

#include <memory>

#include <cairn/engine/audio.h>
#include <cairn/engine/files.h>
#include <cairn/engine/platform.h>
#include <cairn/engine/renderer.h>
#include <cairn/engine/result.h>
#include <cairn/scripting/play.h>

#include "bind/context.h"
#include "bridge/conf.h"

namespace cairn::scripting {

struct Machine {
    Conf conf;
    std::string main_path;  ///< of the script, inside the files
    std::unique_ptr<engine::Files> files;
    std::unique_ptr<engine::Platform> platform;
    std::unique_ptr<engine::Renderer> renderer;
    std::unique_ptr<engine::Audio> audio;

    /// What a game may have changed of its picture is as conf.lua says again.
    void reset_window() { platform->window().set_logical_size(conf.size); }
    [[nodiscard]] Services services() {
        return {*files, *renderer, *audio, platform->window(), *platform, conf.updates_per_second};
    }
};

enum class MachineKind {
    Window,
    Headless,         ///< draws nothing and loads no image
    HeadlessDrawing,  ///< draws into memory
};

/// Whether a faulty conf.lua is an error, or the machine is made as if there were none.
enum class ConfSlips { Refused, Passed };

/// Errors say what is wrong with the game's folder, its conf.lua or the display.
engine::Result<std::unique_ptr<Machine>> make_machine(const GameSource& source, MachineKind kind,
                                                      ConfSlips slips = ConfSlips::Refused);

}  // namespace cairn::scripting
